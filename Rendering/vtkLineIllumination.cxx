// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineIllumination.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

/// Line, viewer and light as the terms need them.
struct Directions
{
  double ViewerT;       ///< V_T
  double LightT;        ///< L_T
  double ViewerSine;    ///< sqrt(1 - V_T^2)
  double LightSine;     ///< sqrt(1 - L_T^2)
  double ViewerLight;   ///< V.L
  double HalfwayLength; ///< |V + L|
  double CosAlpha;      ///< blended to 0 near the singular directions
  bool Valid;
};

/// Unit vector, or the null vector where there is no direction. Returns false if not finite.
bool Normalize(const double v[3], double unit[3])
{
  const double largest = std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
  if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
  {
    return false;
  }
  std::transform(v, v + 3, unit, [largest](double x) { return largest > 0.0 ? x / largest : 0.0; });
  vtkMath::Normalize(unit);
  return true;
}

double GetSine(double cosine)
{
  return std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

double Bound(double sine)
{
  return std::max(sine, vtkLineIllumination::SmallestSine);
}

Directions Compare(const double tangent[3], const double viewer[3], const double light[3])
{
  Directions d{};
  double t[3];
  double v[3];
  double l[3];
  d.Valid = Normalize(tangent, t) && Normalize(viewer, v) && Normalize(light, l);
  if (d.Valid)
  {
    d.ViewerT = vtkMath::Dot(v, t);
    d.LightT = vtkMath::Dot(l, t);
    d.ViewerSine = GetSine(d.ViewerT);
    d.LightSine = GetSine(d.LightT);
    d.ViewerLight = vtkMath::Dot(v, l);
    const double sum[3] = { v[0] + l[0], v[1] + l[1], v[2] + l[2] };
    d.HalfwayLength = vtkMath::Norm(sum);
    d.CosAlpha =
      (d.ViewerLight - d.ViewerT * d.LightT) / (Bound(d.ViewerSine) * Bound(d.LightSine));
    d.CosAlpha = std::clamp(d.CosAlpha, -1.0, 1.0);
  }
  return d;
}

/// Continued fraction of the incomplete beta integral from 0 to x of t^(a-1) (1-t)^(b-1), without
/// its factor x^a (1-x)^b / a, by Lentz's method; converges fast for x < (a + 1) / (a + b + 2).
double BetaFraction(double a, double b, double x)
{
  const auto guard = [](double value) { return std::abs(value) < 1e-300 ? 1e-300 : value; };
  double c = 1.0;
  double d = 1.0 / guard(1.0 - (a + b) * x / (a + 1.0));
  double fraction = d;
  for (int k = 1; k < 1000; ++k)
  {
    const double even = k * (b - k) * x / ((a + 2.0 * k - 1.0) * (a + 2.0 * k));
    const double odd = -(a + k) * (a + b + k) * x / ((a + 2.0 * k) * (a + 2.0 * k + 1.0));
    double change = 1.0;
    for (double term : { even, odd })
    {
      d = 1.0 / guard(1.0 + term * d);
      c = guard(1.0 + term / c);
      change = c * d;
      fraction *= change;
    }
    if (std::abs(change - 1.0) < 1e-15)
    {
      break;
    }
  }
  return fraction;
}

/// Q_m(1).
double GetWholeIntegral(double m)
{
  return 0.5 * std::sqrt(vtkMath::Pi()) * std::exp(std::lgamma(m + 1.0) - std::lgamma(m + 1.5));
}

/// Average of (X.N)^power over the facets that are lit and visible, Eq. 15, for a direction X that
/// lies beta from N, seen along T, and has the given sine to T.
double AveragePower(double sine, double cosAlpha, double cosBeta, double power)
{
  const double alpha = std::acos(cosAlpha);
  const double beta = std::min(std::acos(std::clamp(cosBeta, -1.0, 1.0)), alpha);
  const double edges = std::sin(beta) / (2.0 * (power + 1.0)) *
    (std::pow(std::sin(beta), power + 1.0) - std::pow(std::sin(alpha - beta), power + 1.0));
  const double inside = 0.5 * std::cos(beta) *
    (vtkLineIllumination::GetPowerIntegral(0.5 * power, std::cos(beta)) +
      vtkLineIllumination::GetPowerIntegral(0.5 * power, std::cos(alpha - beta)));
  return std::pow(sine, power) * std::max(0.0, edges + inside);
}
}

vtkStandardNewMacro(vtkLineIllumination);

//------------------------------------------------------------------------------
void vtkLineIllumination::SetModel(int model)
{
  if (model != CylinderAveraging && model != MaximumReflection)
  {
    vtkErrorMacro("Model " << model << " is not valid: it must be " << CylinderAveraging
                           << " (CylinderAveraging) or " << MaximumReflection
                           << " (MaximumReflection). It stays " << this->Model << ".");
    return;
  }
  if (this->Model != model)
  {
    this->Model = model;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkLineIllumination::SetReflection(int reflection)
{
  if (reflection != Phong && reflection != Blinn)
  {
    vtkErrorMacro("Reflection " << reflection << " is not valid: it must be " << Phong
                                << " (Phong) or " << Blinn << " (Blinn). It stays "
                                << this->Reflection << ".");
    return;
  }
  if (this->Reflection != reflection)
  {
    this->Reflection = reflection;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkLineIllumination::SetEvaluation(int evaluation)
{
  if (evaluation != Tables && evaluation != Direct)
  {
    vtkErrorMacro("Evaluation " << evaluation << " is not valid: it must be " << Tables
                                << " (Tables) or " << Direct << " (Direct). It stays "
                                << this->Evaluation << ".");
    return;
  }
  if (this->Evaluation != evaluation)
  {
    this->Evaluation = evaluation;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkLineIllumination::SetTableTolerance(double tolerance)
{
  if (!(tolerance >= 1e-4 && tolerance <= 0.1))
  {
    vtkErrorMacro("TableTolerance " << tolerance << " is not valid: it must be from 0.0001 to 0.1."
                                    << " It stays " << this->TableTolerance << ".");
    return;
  }
  if (this->TableTolerance != tolerance)
  {
    this->TableTolerance = tolerance;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkLineIllumination::SetSpecularPower(double power)
{
  if (!(power <= LargestSpecularPower))
  {
    vtkErrorMacro("SpecularPower " << power << " is not valid: it must be from 0 to "
                                   << LargestSpecularPower
                                   << ", or below 0 for that of vtkProperty."
                                   << " It stays " << this->SpecularPower << ".");
    return;
  }
  if (this->SpecularPower != power)
  {
    this->SpecularPower = power;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkLineIllumination::GetDiffuseTerm(
  const double tangent[3], const double viewer[3], const double light[3], int model)
{
  const Directions d = Compare(tangent, viewer, light);
  if (!d.Valid)
  {
    return NotANumber;
  }
  if (model == MaximumReflection)
  {
    return d.LightSine; // Eq. 5
  }
  const double alpha = std::acos(d.CosAlpha);
  return 0.25 * d.LightSine * (std::sin(alpha) + (vtkMath::Pi() - alpha) * d.CosAlpha); // Eq. 11
}

//------------------------------------------------------------------------------
double vtkLineIllumination::GetSpecularTerm(const double tangent[3], const double viewer[3],
  const double light[3], double power, int model, int reflection)
{
  const Directions d = Compare(tangent, viewer, light);
  if (!d.Valid || !(power >= 0.0) || !std::isfinite(power))
  {
    return NotANumber;
  }
  if (reflection == Blinn)
  {
    // H_T and H.V follow from V + L, whose length is that of H before it is normalized.
    const double fade = std::min(1.0, d.HalfwayLength / SmallestSine);
    const double halfwayT = (d.ViewerT + d.LightT) / std::max(d.HalfwayLength, 1e-12);
    const double sine = GetSine(halfwayT);
    if (model == MaximumReflection)
    {
      return fade * std::pow(sine, power);
    }
    const double cosBeta = (0.5 * d.HalfwayLength - halfwayT * d.ViewerT) /
      (Bound(d.ViewerSine) * std::max(sine, 1e-30));
    return fade * AveragePower(sine, d.CosAlpha, cosBeta, power);
  }

  const double brightest = d.ViewerSine * d.LightSine - d.ViewerT * d.LightT; // Eq. 9
  if (model == MaximumReflection)
  {
    return std::pow(std::max(0.0, brightest), power);
  }
  const double lit = 0.5 + 0.5 * d.CosAlpha;
  if (power == 0.0)
  {
    return lit;
  }
  if (brightest <= 0.0)
  {
    return 0.0;
  }
  const double w = std::sqrt(std::max(0.0, (brightest + d.ViewerLight) / brightest));
  const double mean = w > 1e-9 ? GetPowerIntegral(power, std::min(w, 1.0)) / w : 1.0;
  return lit * std::pow(brightest, power) * mean;
}

//------------------------------------------------------------------------------
double vtkLineIllumination::GetHeadlightSpecularTerm(
  const double tangent[3], const double viewer[3], const double light[3], double power, int model)
{
  const Directions d = Compare(tangent, viewer, light);
  if (!d.Valid || !(power >= 0.0) || !std::isfinite(power))
  {
    return NotANumber;
  }
  return model == MaximumReflection ? std::pow(d.LightSine, power)
                                    : AveragePower(d.LightSine, d.CosAlpha, d.CosAlpha, power);
}

//------------------------------------------------------------------------------
double vtkLineIllumination::GetDiffusePeak(int model)
{
  return model == MaximumReflection ? 1.0 : 0.25 * vtkMath::Pi();
}

//------------------------------------------------------------------------------
double vtkLineIllumination::GetSpecularPeak(double power, int model, int reflection)
{
  if (!(power >= 0.0) || !std::isfinite(power))
  {
    return NotANumber;
  }
  if (model == MaximumReflection || power == 0.0)
  {
    return 1.0;
  }
  return reflection == Blinn ? GetWholeIntegral(0.5 * power)
                             : GetWholeIntegral(power) / std::sqrt(2.0);
}

//------------------------------------------------------------------------------
double vtkLineIllumination::GetPowerIntegral(double m, double w)
{
  if (!(m >= 0.0) || !std::isfinite(m) || !(std::abs(w) <= 1.0))
  {
    return NotANumber;
  }
  // With t = x^2 it is half the incomplete beta integral of 1/2 and m + 1.
  const double x = w * w;
  const double b = m + 1.0;
  double integral;
  if (x < 1.5 / (b + 2.5))
  {
    integral = std::abs(w) * std::pow(1.0 - x, b) * BetaFraction(0.5, b, x);
  }
  else
  {
    const double rest =
      0.5 * std::pow(1.0 - x, b) * std::abs(w) / b * BetaFraction(b, 0.5, 1.0 - x);
    integral = GetWholeIntegral(m) - rest;
  }
  return w < 0.0 ? -integral : integral;
}

//------------------------------------------------------------------------------
void vtkLineIllumination::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "Model: " << (this->Model == MaximumReflection ? "MaximumReflection" : "CylinderAveraging")
     << "\n";
  os << indent << "Reflection: " << (this->Reflection == Blinn ? "Blinn" : "Phong") << "\n";
  os << indent << "Evaluation: " << (this->Evaluation == Direct ? "Direct" : "Tables") << "\n";
  os << indent << "TableTolerance: " << this->TableTolerance << "\n";
  os << indent << "StretchDynamicRange: " << (this->StretchDynamicRange ? "true" : "false") << "\n";
  os << indent << "SpecularPower: " << this->SpecularPower << "\n";
}
