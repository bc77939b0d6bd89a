// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineIllumination
 * @brief   how lines reflect light, for all mappers that draw lines
 *
 * A line has no normal. It is lit as a cylinder that is too thin to be seen as one: what its facets
 * reflect towards the viewer is averaged over the visible part of its girth (Mallo, Peikert, Sigg
 * and Sadlo, "Illuminated Lines Revisited", IEEE Visualization 2005, Sec. 2.2), so that a line has
 * the very brightness that a tube has from afar. The older model takes, for the diffuse and for the
 * specular term, the facet that reflects most (Banks 1994; Stalling, Zoeckler and Hege 1997; Mallo
 * et al., Sec. 2.1). It is brighter, and light from behind looks like light from the front.
 *
 * An object of this class holds the parameters; one may be shared by several mappers. Colours, the
 * coefficients of ambient, diffuse and specular reflection, and the exponent come from vtkProperty;
 * direction, colour, attenuation and cone come from every vtkLight of the renderer that is switched
 * on, as for VTK's surfaces. Static functions evaluate the model in double precision.
 *
 * <b>Notation</b> follows the paper. Unit vectors T along the line, V to the viewer and L to the
 * light; N is the normal of the line that faces the viewer; alpha, from 0 to pi, is the angle
 * between N and L, both seen along T; a subscript T means the component along T.
 *
 * <b>Diffuse term</b> (Eq. 11): sqrt(1 - L_T^2) (sin alpha + (pi - alpha) cos alpha) / 4.
 * Eq. 18 of the paper repeats it with a wrong sign.
 *
 * <b>Specular term, Phong.</b> The average of max(0, V.R)^n over the facets that are lit and
 * visible, where R is L mirrored at the facet: the reflection of VTK's surfaces. The paper leaves
 * it out, since it seems to ask for a table of three dimensions. It does not: about the facet
 * half-way between viewer and light, limits and highlight are symmetric, the odd part of the weight
 * cancels, and with the brightest reflection M = sqrt(1 - V_T^2) sqrt(1 - L_T^2) - V_T L_T (Eq. 9)
 * what remains is c^2 M^n E_n(sqrt((M + V.L) / M)), where c = cos(alpha / 2) and
 * E_m(w) = 1/w integral_0^w max(0, 1 - x^2)^m dx.
 *
 * <b>Specular term, Blinn.</b> The average of (H.N)^n with H half-way between V and L (Eq. 15). Its
 * S_(n+1) is the same function: S_(n+1)(x) = Q_(n/2)(1) - Q_(n/2)(cos x), Q_m(w) = w E_m(w). The
 * same exponent gives a highlight about twice as wide as Phong's (Sec. 2: n / 4).
 *
 * <b>Singular cases.</b> Where T and V, or T and L, are parallel, alpha is undefined, and turning
 * the line a little would switch its light on and off. Within SmallestSine (5.7 degrees) of these
 * directions cos alpha is therefore drawn towards 0 in proportion to the sine. Where V and L oppose
 * each other there is no H: Blinn's term fades out as |V + L| falls below SmallestSine. A line
 * without a tangent (length 0) is lit as if it lay across V and L.
 *
 * @sa vtkIlluminatedLineMapper vtkVoxelLineMapper
 */

#ifndef vtkLineIllumination_h
#define vtkLineIllumination_h

#include "vtkObject.h"
#include "vtkRenderingLineSetsModule.h" // For export macro

class VTKRENDERINGLINESETS_EXPORT vtkLineIllumination : public vtkObject
{
public:
  static vtkLineIllumination* New();
  vtkTypeMacro(vtkLineIllumination, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Which facets of the cylinder count.
  enum ModelType
  {
    CylinderAveraging = 0, ///< all that are visible, by their projected area
    MaximumReflection = 1  ///< the one that reflects most
  };

  /// How a facet shines.
  enum ReflectionType
  {
    Phong = 0, ///< (V.R)^n, as VTK's surfaces
    Blinn = 1  ///< (H.N)^n, as in the paper
  };

  /// How E_m is evaluated when drawing.
  enum EvaluationType
  {
    Tables = 0, ///< looked up in one table of two dimensions, w and m
    Direct = 1  ///< integrated anew by eight points of Gauss's quadrature
  };

  ///@{
  /**
   * Which facets of the thin cylinder that stands for a line count (ModelType). Default
   * CylinderAveraging, as bright as a tube from afar; MaximumReflection is brighter, and light from
   * behind looks like light from the front. Another value is an error.
   */
  virtual void SetModel(int model);
  vtkGetMacro(Model, int);
  void SetModelToCylinderAveraging() { this->SetModel(CylinderAveraging); }
  void SetModelToMaximumReflection() { this->SetModel(MaximumReflection); }
  ///@}

  ///@{
  /**
   * How a facet shines (ReflectionType). Default Phong. The same exponent gives a highlight about
   * twice as wide with Blinn.
   *
   * A headlight that is the only light shines as VTK lets it, by (L.N)^n, with Phong. Another value
   * is an error.
   */
  virtual void SetReflection(int reflection);
  vtkGetMacro(Reflection, int);
  void SetReflectionToPhong() { this->SetReflection(Phong); }
  void SetReflectionToBlinn() { this->SetReflection(Blinn); }
  ///@}

  ///@{
  /**
   * How the specular average is evaluated when drawing (EvaluationType). Default Tables. Another
   * value is an error.
   */
  virtual void SetEvaluation(int evaluation);
  vtkGetMacro(Evaluation, int);
  void SetEvaluationToTables() { this->SetEvaluation(Tables); }
  void SetEvaluationToDirect() { this->SetEvaluation(Direct); }
  ///@}

  ///@{
  /**
   * Largest error of the table of the specular average, 1e-4 to 0.1, from which its size follows.
   * Default 1/4096: the specular term is then right to less than 1/1024.
   *
   * It is measured in the middle of the table's edges and cells. The table is made in about 25 ms,
   * at 1e-4 in about 100 ms, and shared by all who use the same value. A value out of range is an
   * error.
   */
  virtual void SetTableTolerance(double tolerance);
  vtkGetMacro(TableTolerance, double);
  ///@}

  ///@{
  /**
   * Whether diffuse and specular terms are scaled so that a line across the view, lit from the
   * viewer, reaches 1, as a surface does (Mallo et al., Sec. 2.3.2): as if lights were brighter.
   * Default off: a line is as bright as a tube from afar, whose diffuse average never exceeds
   * pi/4 and whose highlight fades with the exponent. Without effect on MaximumReflection.
   */
  vtkSetMacro(StretchDynamicRange, bool);
  vtkGetMacro(StretchDynamicRange, bool);
  vtkBooleanMacro(StretchDynamicRange, bool);
  ///@}

  ///@{
  /**
   * Exponent n of the specular term, 0 to 1000, or below 0 for vtkProperty's SpecularPower, which
   * ends at 128. Default -1. NaN and values above 1000 are errors. A NaN of vtkProperty is
   * taken for 1, and mappers warn.
   */
  virtual void SetSpecularPower(double power);
  vtkGetMacro(SpecularPower, double);
  ///@}

  /// Largest exponent of the specular term.
  static constexpr double LargestSpecularPower = 1000.0;

  /// Sine of the angle between line and view, or line and light, below which the light is blended
  /// to that of a line across.
  static constexpr double SmallestSine = 0.1;

  ///@{
  /**
   * The diffuse and the specular term of a line for white light of intensity 1 and coefficients 1,
   * not stretched, in double precision: by ModelType (Eqs. 5 and 9; 11 and 15) and ReflectionType.
   * The vectors point along the line, to the viewer and to the light; they need not be unit
   * vectors, and those of length 0 are undefined directions as the class description tells. power
   * is 0 or above. NaN, infinite values and a negative power give NaN.
   */
  static double GetDiffuseTerm(
    const double tangent[3], const double viewer[3], const double light[3], int model);
  static double GetSpecularTerm(const double tangent[3], const double viewer[3],
    const double light[3], double power, int model, int reflection);
  ///@}

  /**
   * The specular term of VTK's lone headlight: average (or maximum) of (L.N)^power.
   */
  static double GetHeadlightSpecularTerm(const double tangent[3], const double viewer[3],
    const double light[3], double power, int model);

  ///@{
  /**
   * The terms of a line across the view that is lit from the viewer: pi/4 for the diffuse one; for
   * the specular one Eq. 17 with the numerator Gamma((n+2)/2), which the paper misprints, for
   * Blinn, and Q_n(1) / sqrt(2) for Phong. 1 for MaximumReflection. Their inverses are the factors
   * of StretchDynamicRange, of which those of Blinn serve a lone headlight too. With Phong, lines
   * that run towards the viewer may exceed 1 before they are clamped, by up to the factor.
   */
  static double GetDiffusePeak(int model);
  static double GetSpecularPeak(double power, int model, int reflection);
  ///@}

  /**
   * Q_m(w), the integral of (1 - x^2)^m from 0 to w, for m >= 0 and w from -1 to 1; NaN else. Right
   * to 1e-12.
   */
  static double GetPowerIntegral(double m, double w);

protected:
  vtkLineIllumination() = default;
  ~vtkLineIllumination() override = default;

  int Model = CylinderAveraging;
  int Reflection = Phong;
  int Evaluation = Tables;
  double TableTolerance = 1.0 / 4096.0;
  bool StretchDynamicRange = false;
  double SpecularPower = -1.0;

private:
  vtkLineIllumination(const vtkLineIllumination&) = delete;
  void operator=(const vtkLineIllumination&) = delete;
};

#endif
