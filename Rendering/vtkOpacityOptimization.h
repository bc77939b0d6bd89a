// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpacityOptimization
 * @brief   how opacity is optimized and blended by vtkFourierOpacityMapper and
 * vtkFourierOpacityPass
 *
 * What hides important geometry is faded, and so is what clutters the view behind it (Baeza Rojo,
 * Gross and Guenther, "Fourier Opacity Optimization for Scalable Exploration", IEEE TVCG 26(11),
 * 2020). A fragment of importance g in [0,1] gets the opacity (Eq. 2)
 *
 *   p / (p + (1 - g)^(2 lambda) (r * front + q * behind)),
 *
 * where front and behind are the sums of the squared importance of all other fragments in front of
 * it and behind it. The smallest opacity of a segment's fragments is that of the segment; opacities
 * are then smoothed over neighbouring segments and interpolated between their centres.
 *
 * <b>Where to begin.</b> Raise ForegroundWeight until important things are free, then
 * BackgroundWeight until nothing behind them distracts; a higher Emphasis keeps more of the context
 * that is nearly important. With both weights 0 everything is opaque.
 *
 * <b>Series.</b> Sums along the ray are not taken over sorted fragments but as a series of few
 * terms, in fixed memory and in any order. Blending and Importance offer other ways for
 * comparison, up to the exact one, which keeps every fragment (vtkFragmentListPass).
 *
 * May be shared by several mappers and passes.
 *
 * @sa vtkFourierOpacityMapper vtkFourierOpacityPass vtkOpacitySegments
 */

#ifndef vtkOpacityOptimization_h
#define vtkOpacityOptimization_h

#include "vtkObject.h"
#include "vtkRenderingLineSetsModule.h" // For export macro

class VTKRENDERINGLINESETS_EXPORT vtkOpacityOptimization : public vtkObject
{
public:
  static vtkOpacityOptimization* New();
  vtkTypeMacro(vtkOpacityOptimization, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How fragments are blended.
  enum BlendingType
  {
    /// A cosine series of the optical depth, from which each fragment takes out what it added
    /// itself.
    Fourier = 0,
    /// The series and weights of the paper (Eqs. 16, 17 and 19), which take the series at a
    /// fragment for the sum with the fragment, though it holds about half of it.
    PaperFourier = 1,
    /// The optical depth counted in as many bins as there are terms, linear between their ends.
    Bins = 2,
    /// Mean colour, weighted by opacity, with the mean opacity (Bavoil and Myers, 2008).
    WeightedAverage = 3,
    /// Mean colour, weighted by opacity and a function of depth, with the exact opacity of all
    /// fragments (McGuire and Bavoil, 2013, Eq. 10).
    WeightedBlended = 4,
    /// All fragments, sorted.
    FragmentLists = 5
  };

  /// How importance is summed along a ray.
  enum ImportanceType
  {
    SeriesImportance = 0, ///< by the series of the blending; the cosine series if that has none
    ExactImportance = 1   ///< all fragments, sorted
  };

  /// How the depth is divided among the terms of the series.
  enum DepthScaleType
  {
    LinearDepth = 0,
    LogarithmicDepth = 1
  };

  ///@{
  /**
   * Weight p of being opaque, above 0 to 1e6. Default 1. Only its ratios to the other weights
   * count.
   */
  virtual void SetRegularizationWeight(double weight);
  vtkGetMacro(RegularizationWeight, double);
  ///@}

  ///@{
  /**
   * Weight q: how much fades what hides important things, 0 to 1e6. Default 50. The paper has 10 to
   * 400.
   */
  virtual void SetForegroundWeight(double weight);
  vtkGetMacro(ForegroundWeight, double);
  ///@}

  ///@{
  /**
   * Weight r: how much fades what lies behind important things, 0 to 1e6. Default 50. The paper has
   * 10 to 500.
   */
  virtual void SetBackgroundWeight(double weight);
  vtkGetMacro(BackgroundWeight, double);
  ///@}

  ///@{
  /**
   * Exponent lambda, 0.01 to 100: how sharply the important is told from the less important.
   * Default 2. The paper has 1.3 to 10.
   */
  virtual void SetEmphasis(double emphasis);
  vtkGetMacro(Emphasis, double);
  ///@}

  ///@{
  /**
   * How often opacities are averaged with those of neighbouring segments, 0 to 1000. Default 15.
   * Points have no neighbours.
   */
  virtual void SetSmoothingIterations(int iterations);
  vtkGetMacro(SmoothingIterations, int);
  ///@}

  ///@{
  /**
   * Time in seconds in which opacities follow the view while it moves, 0 to 60: after it, a
   * twentieth of a change is left. Default 0, at once. They also follow at once where the picture
   * has another size or kind of projection, or the view jumps: a turn by more than 20 degrees, a
   * zoom by more than a half, or a step of more than half the range of depths and a third of the
   * nearest distance.
   *
   * Pictures are only drawn when asked for: an application renders on until the
   * time is over.
   */
  virtual void SetTransitionTime(double seconds);
  vtkGetMacro(TransitionTime, double);
  ///@}

  ///@{
  /**
   * Number m of frequency bands of the series, 1 to 16: there are 2 m + 1 sums per pixel, the first
   * of 4 bytes and the others of 2 (but see HalfFloats and DepthReduction). Default 5. More bands
   * tell near layers apart.
   */
  virtual void SetNumberOfBands(int bands);
  vtkGetMacro(NumberOfBands, int);
  ///@}

  ///@{
  /**
   * Sums are taken over every n-th segment or point only, 1 to 10000, and n times as much is taken
   * for each; all are drawn (paper, Sec. 5.5.3). Default 1. For scenes so dense that a part stands
   * for all. Counts for series and bins only; what belongs to no segment does not count then.
   */
  virtual void SetSubset(int n);
  vtkGetMacro(Subset, int);
  ///@}

  ///@{
  /**
   * Importance is summed for one of so many pixels of a row and of a column, 1 to 8. Default 2.
   */
  virtual void SetImportanceReduction(int reduction);
  vtkGetMacro(ImportanceReduction, int);
  ///@}

  ///@{
  /**
   * Optical depth is summed for one of so many pixels of a row and of a column, 1 to 8. Default 1.
   * Each pixel has its exact opacity all the same, for 4 bytes more; what lies in front of what is
   * told by the neighbourhood. With 2 and the default ImportanceReduction, sums take a third of the
   * memory, and software OpenGL a fifth less time in dense scenes; the sums of importance have the
   * same place, so that a smaller ImportanceReduction saves no memory. Counts for Fourier alone.
   */
  virtual void SetDepthReduction(int reduction);
  vtkGetMacro(DepthReduction, int);
  ///@}

  ///@{
  /**
   * Whether sums but the first one, which tells the opacity, and colours are kept in half floats,
   * of 2 bytes, rather than in floats of 4. Default true, which takes less memory, and less time on
   * graphics devices. A half float does not grow by less than 1/4096 of what it holds: where
   * thousands of fragments of an opacity below 0.001 make up a pixel, colours get lost; set false
   * there. Counts for Fourier alone.
   */
  vtkSetMacro(HalfFloats, bool);
  vtkGetMacro(HalfFloats, bool);
  vtkBooleanMacro(HalfFloats, bool);
  ///@}

  ///@{
  /**
   * How fragments are blended (BlendingType). Default Fourier. Another value is an error.
   */
  virtual void SetBlending(int blending);
  vtkGetMacro(Blending, int);
  void SetBlendingToFourier() { this->SetBlending(Fourier); }
  void SetBlendingToPaperFourier() { this->SetBlending(PaperFourier); }
  void SetBlendingToBins() { this->SetBlending(Bins); }
  void SetBlendingToWeightedAverage() { this->SetBlending(WeightedAverage); }
  void SetBlendingToWeightedBlended() { this->SetBlending(WeightedBlended); }
  void SetBlendingToFragmentLists() { this->SetBlending(FragmentLists); }
  ///@}

  ///@{
  /**
   * How importance is summed (ImportanceType). Default SeriesImportance. Another value is an error.
   */
  virtual void SetImportance(int importance);
  vtkGetMacro(Importance, int);
  void SetImportanceToSeries() { this->SetImportance(SeriesImportance); }
  void SetImportanceToExact() { this->SetImportance(ExactImportance); }
  ///@}

  ///@{
  /**
   * How the depth is divided (DepthScaleType). Default LinearDepth. Without effect in parallel
   * views and on exact ways. Another value is an error.
   */
  virtual void SetDepthScale(int scale);
  vtkGetMacro(DepthScale, int);
  ///@}

  ///@{
  /**
   * Whether the series of a pixel's optical depth spans only the depths of what that pixel shows,
   * in place of those of the whole scene. Default on. Counts for Fourier alone.
   */
  vtkSetMacro(TightDepth, bool);
  vtkGetMacro(TightDepth, bool);
  vtkBooleanMacro(TightDepth, bool);
  ///@}

  ///@{
  /**
   * Opacity from which on a fragment counts as opaque, 0.5 to 1: it is drawn as opaque geometry is,
   * and what is behind it is not drawn. Default 0.98. Above 0.9999 fragments are never taken
   * for opaque. Counts for Fourier alone.
   */
  virtual void SetOpaqueThreshold(double opacity);
  vtkGetMacro(OpaqueThreshold, double);
  ///@}

  ///@{
  /**
   * Width in pixels of the halo on either side of a line, 0 to 100: a margin in the colour of the
   * background, which parts the line from those that it crosses (Everts, Bekker, Roerdink and
   * Isenberg, "Depth-Dependent Halos", 2009; paper, Sec. 5.7.3). Default 0, none. Lines alone have
   * halos.
   */
  virtual void SetHaloWidth(double pixels);
  vtkGetMacro(HaloWidth, double);
  ///@}

  ///@{
  /**
   * How far a halo leans back at its outer edge, as a part of the range of depths of all that is
   * drawn, 0 to 1: lines that lie nearer behind a line are not hidden by its halo, so that bundles
   * stay together. Default 0.05.
   */
  virtual void SetHaloDepth(double part);
  vtkGetMacro(HaloDepth, double);
  ///@}

  ///@{
  /**
   * Most pictures whose mean is drawn while neither view nor scene changes, 1 to 4096, each shifted
   * by less than a pixel (paper, Sec. 4.2, step 5): one picture is added each time the scene is
   * drawn. Default 1.
   */
  virtual void SetAccumulationFrames(int frames);
  vtkGetMacro(AccumulationFrames, int);
  ///@}

  ///@{
  /**
   * Most memory for fragment lists on the graphics device in MiB, 1 to 1048576. Default 1024. What
   * does not fit at once is drawn strip by strip of the picture.
   */
  virtual void SetMaximumListMemory(int mebibytes);
  vtkGetMacro(MaximumListMemory, int);
  ///@}

protected:
  vtkOpacityOptimization() = default;
  ~vtkOpacityOptimization() override = default;

  double RegularizationWeight = 1.0;
  double ForegroundWeight = 50.0;
  double BackgroundWeight = 50.0;
  double Emphasis = 2.0;
  int SmoothingIterations = 15;
  double TransitionTime = 0.0;
  int NumberOfBands = 5;
  int Subset = 1;
  int ImportanceReduction = 2;
  int DepthReduction = 1;
  bool HalfFloats = true;
  int Blending = Fourier;
  int Importance = SeriesImportance;
  int DepthScale = LinearDepth;
  bool TightDepth = true;
  double OpaqueThreshold = 0.98;
  double HaloWidth = 0.0;
  double HaloDepth = 0.05;
  int AccumulationFrames = 1;
  int MaximumListMemory = 1024;

private:
  vtkOpacityOptimization(const vtkOpacityOptimization&) = delete;
  void operator=(const vtkOpacityOptimization&) = delete;
};

#endif
