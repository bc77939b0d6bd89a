// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityStages.h"

#include "vtkFourierOpacityTargets.h"
#include "vtkFragmentLists.h"
#include "vtkOpacityOptimization.h"

#include "vtkFourierOpacity.h"
#include "vtkFourierOpacityDepth.h"

#include <iomanip>
#include <locale>
#include <sstream>
#include <vector>

namespace
{
// What part of a pixel of a reduced picture a fragment stands for: lines and points that should be
// smaller than a pixel are drawn as large as one.
constexpr const char* Coverage = "uniform float fourierCoverage;\n";

// Hidden fragments of reduced pictures, which have no depth buffer of their own.
constexpr const char* DiscardHidden =
  "  ivec2 fourierPixel = ivec2(gl_FragCoord.xy);\n"
  "  if (gl_FragCoord.z > texelFetch(fourierScene,\n"
  "    fourierFullPixel(fourierPixel, FourierReduction), 0).r)\n"
  "  {\n"
  "    discard;\n"
  "  }\n"
  "  float fourierD = fourierSceneDepth(gl_FragCoord.z);\n";

// The same in every locale.
std::string Number(float value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  // GLSL takes no integer for a float everywhere.
  text << "float(" << std::setprecision(9) << value << ")";
  return text.str();
}

std::string Component(int sum)
{
  return std::string(1, "xyzw"[sum]);
}
}

//------------------------------------------------------------------------------
vtkFourierOpacityStages::vtkFourierOpacityStages(
  vtkOpacityOptimization* optimization, bool isParallel)
  : Blending(optimization->GetBlending())
  , Sums(2 * optimization->GetNumberOfBands() + 1)
  , Subset(optimization->GetSubset())
  , ImportanceReduction(optimization->GetImportanceReduction())
  , Exact(optimization->GetImportance() == vtkOpacityOptimization::ExactImportance)
  , HaloWidth(optimization->GetHaloWidth())
  , HaloDepth(optimization->GetHaloDepth())
  , IsLogarithmic(
      !isParallel && optimization->GetDepthScale() == vtkOpacityOptimization::LogarithmicDepth)
{
  switch (this->Blending)
  {
    case vtkOpacityOptimization::Fourier:
      this->HasBounds = optimization->GetTightDepth();
      this->DepthReduction = optimization->GetDepthReduction();
      this->HasTotals = this->DepthReduction > 1;
      this->HasHalfFloats = optimization->GetHalfFloats();
      this->HasOpaqueLayer = optimization->GetOpaqueThreshold() <= 0.9999;
      // Without that layer nothing is left to it.
      if (this->HasOpaqueLayer)
      {
        this->OpaqueThreshold = static_cast<float>(optimization->GetOpaqueThreshold());
      }
      break;
    case vtkOpacityOptimization::PaperFourier:
      this->Series = 1;
      break;
    case vtkOpacityOptimization::Bins:
      this->Series = 2;
      break;
    default:
      this->HasSums = false;
      this->HasLists = this->Blending == vtkOpacityOptimization::FragmentLists;
      break;
  }
  // One range of depths holds for all that shares a sum.
  this->WidenedReduction =
    this->DepthReduction > 1 ? this->DepthReduction : this->ImportanceReduction;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityStages::GetDeclarations(bool readsSums) const
{
  std::string text = "#define Real float\n"
                     "#define LS_OUT(T) out T\n"
                     "const int FourierSeries = " +
    std::to_string(this->Series) + ";\nconst int FourierCount = " + std::to_string(this->Sums) +
    ";\nconst bool FourierLogarithmic = " + (this->IsLogarithmic ? "true" : "false") +
    ";\nconst int FourierReduction = " + std::to_string(this->ImportanceReduction) +
    ";\nconst int FourierDepthReduction = " + std::to_string(this->DepthReduction) +
    ";\nconst int FourierWidenedReduction = " + std::to_string(this->WidenedReduction) + ";\n";
  if (readsSums)
  {
    text += "float fourierFetched[FourierCount];\n"
            "float fourierCoefficient(int i) { return fourierFetched[i]; }\n";
    std::string fetch = "void fourierFetch(ivec2 pixel)\n{\n  vec4 texel;\n";
    int sum = 0;
    int texture = 0;
    for (int components : vtkFourierOpacityTargets::GetComponents(this->Sums, this->HasHalfFloats))
    {
      const std::string name = "fourierSums" + std::to_string(texture++);
      text += "uniform sampler2D " + name + ";\n";
      fetch += "  texel = texelFetch(" + name + ", pixel, 0);\n";
      for (int i = 0; i < components; ++i)
      {
        fetch += "  fourierFetched[" + std::to_string(sum++) + "] = texel." + Component(i) + ";\n";
      }
    }
    text += fetch + "}\n";
  }
  else
  {
    text += "float fourierCoefficient(int i) { return 0.0; }\n";
  }
  return text + vtkFourierOpacity + vtkFourierOpacityDepth +
    // Whether an element is of the subset; what belongs to none is not.
    "bool fourierIsInSubset(int element) { return element >= 0 && element % " +
    std::to_string(this->Subset) +
    " == 0; }\n"
    "uniform sampler2D fourierScene;\n"
    "uniform sampler2D fourierBounds;\n"
    "uniform vec4 fourierWeights;\n"
    // Depth among what the pixel of the bounds shows.
    "float fourierPixelDepth(float d, vec2 bounds)\n"
    "{\n"
    "  float low = 1.0 - bounds.r;\n"
    "  return bounds.g > low ? clamp((d - low) / (bounds.g - low), 0.0, 1.0) : 0.5;\n"
    "}\n";
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityStages::WriteSums(const Outputs& outputs) const
{
  const std::vector<int> components =
    vtkFourierOpacityTargets::GetComponents(this->Sums, this->HasHalfFloats);
  std::string text;
  int target = 0;
  int sum = 0;
  for (int i = 0; i < outputs.First + outputs.Count; ++i)
  {
    if (i >= outputs.First)
    {
      text += "  gl_FragData[" + std::to_string(target++) + "] = fourierValue * vec4(";
      for (int j = 0; j < 4; ++j)
      {
        text += j == 0 ? "" : ", ";
        text += j < components[i] ? "terms.value[" + std::to_string(sum + j) + "]" : "0.0";
      }
      text += ");\n";
    }
    sum += components[i];
  }
  return text;
}

//------------------------------------------------------------------------------
vtkFourierOpacityStage vtkFourierOpacityStages::SumImportance(const Outputs& outputs) const
{
  vtkFourierOpacityStage stage;
  stage.Kind = vtkFourierOpacityStage::ImportanceSums;
  stage.NeedsImportance = true;
  stage.NeedsElement = this->Subset > 1;
  stage.Declarations = this->GetDeclarations(false) + Coverage;
  stage.Reduction = this->ImportanceReduction;
  stage.SumReduction = this->ImportanceReduction;
  stage.Code = DiscardHidden;
  if (this->Subset > 1)
  {
    stage.Code += "  if (!fourierIsInSubset(fourierElementVSOutput))\n  {\n    discard;\n  }\n";
  }
  if (outputs.Count > 0)
  {
    stage.Code += "  FourierTerms terms = fourierTerms(fourierD);\n"
                  "  float fourierValue = " +
      Number(static_cast<float>(this->Subset)) +
      " * fourierCoverage * fourierImportanceVSOutput * fourierImportanceVSOutput;\n" +
      this->WriteSums(outputs);
  }
  if (outputs.Bounds)
  {
    stage.Code += "  gl_FragData[" + std::to_string(outputs.Count) +
      "] = vec4(1.0 - fourierD, fourierD, 0.0, 0.0);\n";
  }
  stage.Code += "  return;\n";
  return stage;
}

//------------------------------------------------------------------------------
vtkFourierOpacityStage vtkFourierOpacityStages::FindOpacities() const
{
  vtkFourierOpacityStage stage;
  stage.Kind = vtkFourierOpacityStage::Opacities;
  stage.NeedsImportance = true;
  stage.NeedsElement = true;
  stage.Extensions = vtkFragmentLists::GetExtensionSource();
  stage.Reduction = this->ImportanceReduction;
  stage.SumReduction = this->ImportanceReduction;
  stage.Declarations = this->GetDeclarations(true) + Coverage +
    "layout(r32ui) uniform uimageBuffer fourierSmallest;\n";
  const bool paper = this->Blending == vtkOpacityOptimization::PaperFourier;
  // In a subset, those that count stand for several.
  const std::string own = this->Subset > 1
    ? "  float fourierOwn = fourierIsInSubset(fourierElementVSOutput) ? float(" +
      std::to_string(this->Subset) + ") * fourierCoverage * fourierG * fourierG : 0.0;\n"
    : "  float fourierOwn = fourierCoverage * fourierG * fourierG;\n";
  stage.Code = std::string(DiscardHidden) +
    "  float fourierG = clamp(fourierImportanceVSOutput, 0.0, 1.0);\n" + own +
    "  fourierFetch(fourierPixel);\n"
    "  float fourierShare;\n"
    "  float fourierSumHere = fourierSum(fourierD, fourierShare);\n"
    "  float fourierAll = fourierTotal();\n" +
    (paper ? "  float fourierFore = fourierFront(fourierSumHere, 1.0, fourierOwn, fourierAll);\n"
             "  float fourierRear = max(fourierAll - max(fourierSumHere, 0.0), 0.0);\n"
           : "  float fourierFore = fourierFront(fourierSumHere, fourierShare, fourierOwn,\n"
             "    fourierAll);\n"
             "  float fourierRear = max(fourierAll - fourierOwn - fourierFore, 0.0);\n") +
    "  float fourierBest = optimalOpacity(fourierG, fourierFore, fourierRear, fourierWeights);\n"
    "  if (fourierElementVSOutput >= 0)\n"
    "  {\n"
    "    imageAtomicMin(fourierSmallest, fourierElementVSOutput, floatBitsToUint(fourierBest));\n"
    "  }\n"
    "  gl_FragData[0] = vec4(0.0);\n"
    "  return;\n";
  return stage;
}

//------------------------------------------------------------------------------
vtkFourierOpacityStage vtkFourierOpacityStages::BeginStage(
  vtkFourierOpacityStage::KindType kind) const
{
  vtkFourierOpacityStage stage;
  stage.Kind = kind;
  stage.HaloWidth = this->HaloWidth;
  stage.HaloDepth = this->HaloDepth;
  stage.NeedsOpacity = true;
  return stage;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityStages::DiscardOpaque() const
{
  return "  if (fourierAlpha <= 0.0 || fourierAlpha >= " + Number(this->OpaqueThreshold) +
    ")\n  {\n    discard;\n  }\n";
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityStages::FindDepth() const
{
  return this->HasBounds
    ? "  float fourierD = fourierPixelDepth(fourierSceneDepth(%Z), texelFetch(fourierBounds,\n"
      "    ivec2(gl_FragCoord.xy) / FourierWidenedReduction, 0).rg);\n"
    : "  float fourierD = fourierSceneDepth(%Z);\n";
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityStages::FindReducedDepth() const
{
  // What none of the pixels that share a sum shows does not count. Half floats are exact to 2^-11.
  return this->HasBounds
    ? "  float fourierD = fourierSceneDepth(%Z);\n"
      "  vec2 fourierLimits = texelFetch(fourierBounds, ivec2(gl_FragCoord.xy), 0).rg;\n"
      "  if (fourierD > fourierLimits.g * 1.001)\n"
      "  {\n"
      "    discard;\n"
      "  }\n"
      "  fourierD = fourierPixelDepth(fourierD, fourierLimits);\n"
    : "  if (%Z > fourierFarthest(fourierScene, ivec2(gl_FragCoord.xy), FourierDepthReduction))\n"
      "  {\n"
      "    discard;\n"
      "  }\n"
      "  float fourierD = fourierSceneDepth(%Z);\n";
}

//------------------------------------------------------------------------------
vtkFourierOpacityStage vtkFourierOpacityStages::DrawOpaqueLayer() const
{
  vtkFourierOpacityStage stage = this->BeginStage(vtkFourierOpacityStage::OpaqueLayer);
  stage.WritesDepth = true;
  stage.LeastOpacity = Number(this->OpaqueThreshold);
  stage.Declarations = this->HaloWidth > 0.0 ? this->GetDeclarations(false) : std::string();
  stage.Code = "  if (fourierOpacityVSOutput * %OPACITY < " + stage.LeastOpacity +
    ")\n  {\n    discard;\n  }\n"
    "  gl_FragData[0] = vec4(%COLOR, 1.0);\n";
  return stage;
}

//------------------------------------------------------------------------------
vtkFourierOpacityStage vtkFourierOpacityStages::SumOpticalDepth(const Outputs& outputs) const
{
  vtkFourierOpacityStage stage = this->BeginStage(vtkFourierOpacityStage::OpticalDepth);
  stage.NeedsElement = this->Subset > 1;
  stage.Declarations = this->GetDeclarations(false) + Coverage;
  stage.Reduction = this->DepthReduction;
  stage.SumReduction = this->DepthReduction;
  stage.Code =
    "  float fourierAlpha = fourierOpacityVSOutput * %OPACITY;\n" + this->DiscardOpaque();
  if (this->Subset > 1)
  {
    stage.Code += "  if (!fourierIsInSubset(fourierElementVSOutput))\n  {\n    discard;\n  }\n";
  }
  stage.Code += (this->DepthReduction > 1 ? this->FindReducedDepth() : this->FindDepth()) +
    "  FourierTerms terms = fourierTerms(fourierD);\n"
    "  float fourierValue = " +
    Number(static_cast<float>(this->Subset)) +
    (this->DepthReduction > 1 ? " * fourierCoverage" : "") + " * opticalDepth(fourierAlpha);\n" +
    this->WriteSums(outputs) + "  return;\n";
  return stage;
}

//------------------------------------------------------------------------------
vtkFourierOpacityStage vtkFourierOpacityStages::AddColors() const
{
  vtkFourierOpacityStage stage = this->BeginStage(vtkFourierOpacityStage::Colors);
  stage.NeedsElement = this->HasSums && this->Subset > 1;
  stage.Declarations = this->GetDeclarations(this->HasSums) + Coverage;
  stage.SumReduction = this->DepthReduction;
  stage.Code = "  float fourierAlpha = min(fourierOpacityVSOutput * %OPACITY, 0.9999);\n" +
    this->DiscardOpaque();
  if (this->HasSums)
  {
    const bool paper = this->Blending == vtkOpacityOptimization::PaperFourier;
    const std::string covered =
      this->DepthReduction > 1 ? "fourierCoverage * fourierTau" : "fourierTau";
    const std::string own = this->Subset > 1
      ? "(fourierIsInSubset(fourierElementVSOutput) ? float(" + std::to_string(this->Subset) +
        ") * " + covered + " : 0.0)"
      : covered;
    stage.Code += this->FindDepth() +
      "  fourierFetch(ivec2(gl_FragCoord.xy) / FourierDepthReduction);\n"
      "  float fourierShare;\n"
      "  float fourierHere = fourierSum(fourierD, fourierShare);\n"
      "  float fourierTau = opticalDepth(fourierAlpha);\n"
      "  float fourierAll = fourierTotal();\n" +
      (paper ? "  float fourierWeight = fourierAlpha * exp(fourierTau -\n"
               "    clamp(fourierHere, 0.0, min(fourierAll, 40.0)));\n"
             : "  float fourierWeight = colorWeight(fourierAlpha,\n"
               "    fourierFront(fourierHere, fourierShare, " +
            own + ", fourierAll));\n");
  }
  else if (this->Blending == vtkOpacityOptimization::WeightedBlended)
  {
    // McGuire and Bavoil, 2013, Eq. 10: the weight has the opacity, and so have the colours
    // already.
    stage.Code += this->FindDepth() +
      "  float fourierWeight = fourierAlpha * fourierAlpha *\n"
      "    max(1e-2, 3e3 * (1.0 - fourierD) * (1.0 - fourierD) * (1.0 - fourierD));\n";
  }
  else
  {
    stage.Code += "  float fourierWeight = fourierAlpha;\n";
  }
  stage.Code += "  gl_FragData[0] = vec4(%COLOR * fourierWeight, fourierWeight);\n";
  if (this->HasTotals)
  {
    stage.Code += "  gl_FragData[1] = vec4(fourierTau, 0.0, 0.0, 0.0);\n";
  }
  else if (!this->HasSums)
  {
    stage.Code += "  gl_FragData[1] = vec4(1.0, opticalDepth(fourierAlpha), 0.0, 0.0);\n";
  }
  return stage;
}

//------------------------------------------------------------------------------
vtkFourierOpacityStage vtkFourierOpacityStages::Select()
{
  vtkFourierOpacityStage stage;
  stage.Kind = vtkFourierOpacityStage::Selection;
  stage.NeedsOpacity = true;
  stage.WritesDepth = true;
  // Fainter than this, a fragment is taken for not seen.
  stage.Code = "  if (fourierOpacityVSOutput < 0.1)\n  {\n    discard;\n  }\n";
  return stage;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityStages::Widen() const
{
  return "//VTK::System::Dec\n"
         "//VTK::Output::Dec\n" +
    this->GetDeclarations(false) +
    "void main()\n"
    "{\n"
    "  ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "  ivec2 last = (fourierSize + FourierReduction - 1) / FourierReduction - 1;\n"
    "  ivec2 from = pixel * FourierWidenedReduction / FourierReduction - 1;\n"
    "  ivec2 to = ((pixel + 1) * FourierWidenedReduction - 1) / FourierReduction + 1;\n"
    "  from = clamp(from, ivec2(0), last);\n"
    "  to = clamp(to, ivec2(0), last);\n"
    "  vec2 bounds = vec2(0.0);\n"
    "  for (int y = from.y; y <= to.y; ++y)\n"
    "  {\n"
    "    for (int x = from.x; x <= to.x; ++x)\n"
    "    {\n"
    "      bounds = max(bounds, texelFetch(fourierBounds, ivec2(x, y), 0).rg);\n"
    "    }\n"
    "  }\n"
    // Nothing is seen behind the farthest opaque depth.
    "  bounds.g = min(bounds.g, fourierSceneDepth(\n"
    "    fourierFarthest(fourierScene, pixel, FourierWidenedReduction)));\n"
    "  gl_FragData[0] = vec4(bounds, 0.0, 0.0);\n"
    "}\n";
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityStages::Finish(bool multiplied) const
{
  std::string through;
  if (this->HasTotals)
  {
    through = "  float through = exp(-texelFetch(fourierTotals, pixel, 0).r);\n";
  }
  else if (this->HasSums)
  {
    through = "  fourierFetch(pixel);\n  float through = exp(-fourierTotal());\n";
  }
  else if (this->Blending == vtkOpacityOptimization::WeightedAverage)
  {
    through = "  vec2 counts = texelFetch(fourierCounts, pixel, 0).rg;\n"
              "  float mean = counts.r > 0.0 ? min(sum.a / counts.r, 1.0) : 0.0;\n"
              "  float through = pow(1.0 - mean, counts.r);\n";
  }
  else if (this->Blending == vtkOpacityOptimization::WeightedBlended)
  {
    through = "  float through = exp(-texelFetch(fourierCounts, pixel, 0).g);\n";
  }
  else
  {
    // Lists are blended already: the sum is premultiplied by its opacity.
    through = "  float through = 1.0 - sum.a;\n";
  }
  return "//VTK::System::Dec\n"
         "//VTK::Output::Dec\n" +
    this->GetDeclarations(this->HasSums && !this->HasTotals) +
    "uniform sampler2D fourierColors;\n"
    "uniform sampler2D fourierTotals;\n"
    "uniform sampler2D fourierCounts;\n"
    "uniform sampler2D fourierOpaque;\n"
    "uniform ivec2 fourierOrigin;\n"
    "void main()\n"
    "{\n"
    "  ivec2 pixel = ivec2(gl_FragCoord.xy)" +
    (multiplied ? "" : " - fourierOrigin") +
    ";\n"
    "  vec4 sum = texelFetch(fourierColors, pixel, 0);\n" +
    through +
    "  float alpha = sum.a > 0.0 ? 1.0 - through : 0.0;\n"
    "  vec3 color = sum.a > 0.0 ? sum.rgb / sum.a * alpha : vec3(0.0);\n" +
    (this->HasOpaqueLayer ? "  vec4 behind = texelFetch(fourierOpaque, pixel, 0);\n"
                            "  color += (1.0 - alpha) * behind.a * behind.rgb;\n"
                            "  alpha += (1.0 - alpha) * behind.a;\n"
                          : "") +
    (multiplied ? "  gl_FragData[0] = vec4(color, alpha);\n"
                : "  gl_FragData[0] = alpha > 0.0 ? vec4(color / alpha, alpha) : vec4(0.0);\n") +
    (this->HasBounds ? // Half floats are exact to 2^-10 of the value: what is just in front of
                       // something opaque must not come to lie behind it.
        "  float near = texelFetch(fourierBounds, pixel / FourierWidenedReduction, 0).r * 1.001;\n"
        "  gl_FragDepth = fourierBufferDepth(max(1.0 - near, 0.0));\n"
                     : "  gl_FragDepth = fourierBufferDepth(0.0);\n") +
    "}\n";
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityStages::ShowMean() const
{
  return "//VTK::System::Dec\n"
         "//VTK::Output::Dec\n" +
    this->GetDeclarations(false) +
    "uniform sampler2D fourierColors;\n"
    "uniform ivec2 fourierOrigin;\n"
    "uniform float fourierMeanFactor;\n"
    "void main()\n"
    "{\n"
    "  ivec2 pixel = ivec2(gl_FragCoord.xy) - fourierOrigin;\n"
    "  vec4 mean = fourierMeanFactor * texelFetch(fourierColors, pixel, 0);\n"
    "  gl_FragData[0] = mean.a > 0.0 ? vec4(mean.rgb / mean.a, mean.a) : vec4(0.0);\n"
    // Bounds of the depth are those of one picture only: all is at the nearest depth.
    "  gl_FragDepth = fourierBufferDepth(0.0);\n"
    "}\n";
}

//------------------------------------------------------------------------------
vtkFourierOpacityStage vtkFourierOpacityStages::ListImportance() const
{
  vtkFourierOpacityStage stage;
  stage.Kind = vtkFourierOpacityStage::ImportanceList;
  stage.NeedsImportance = true;
  stage.NeedsElement = true;
  stage.Extensions = vtkFragmentLists::GetExtensionSource();
  stage.Reduction = this->ImportanceReduction;
  stage.SumReduction = this->ImportanceReduction;
  stage.Declarations = this->GetDeclarations(false) + Coverage + vtkFragmentLists::GetStoreSource();
  stage.Code = std::string(DiscardHidden) +
    "  storeFragment(fourierPixel, gl_FragCoord.z,\n"
    "    uvec3(floatBitsToUint(clamp(fourierImportanceVSOutput, 0.0, 1.0)),\n"
    "    uint(fourierElementVSOutput), floatBitsToUint(fourierCoverage)));\n"
    "  gl_FragData[0] = vec4(fourierD);\n"
    "  return;\n";
  return stage;
}

//------------------------------------------------------------------------------
vtkFourierOpacityStage vtkFourierOpacityStages::ListColors() const
{
  vtkFourierOpacityStage stage = this->BeginStage(vtkFourierOpacityStage::ColorList);
  stage.Extensions = vtkFragmentLists::GetExtensionSource();
  stage.Declarations = (this->HaloWidth > 0.0 ? this->GetDeclarations(false) : std::string()) +
    vtkFragmentLists::GetColorStoreSource();
  stage.Code = "  storeFragmentColor(ivec2(gl_FragCoord.xy), %Z,\n"
               "    vec4(%COLOR, fourierOpacityVSOutput * %OPACITY));\n";
  return stage;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityStages::ResolveImportance() const
{
  std::string source = "//VTK::System::Dec\n"
                       "//VTK::Output::Dec\n" +
    this->GetDeclarations(false) + vtkFragmentLists::GetReadSource() +
    "layout(r32ui) uniform uimageBuffer fourierSmallest;\n"
    "void main()\n"
    "{\n"
    "  int count = findFragments(ivec2(gl_FragCoord.xy));\n"
    "  float total = 0.0;\n"
    "  int i = 0;\n"
    "  for (; i < count; ++i)\n"
    "  {\n"
    "    uvec4 fragment = getFragment(i);\n"
    "    float g = uintBitsToFloat(fragment.y);\n"
    "    total += g * g * uintBitsToFloat(fragment.w);\n"
    "  }\n"
    "  float front = 0.0;\n"
    "  int j = 0;\n"
    "  for (; j < count; ++j)\n"
    "  {\n"
    "    uvec4 fragment = getFragment(j);\n"
    "    float g = uintBitsToFloat(fragment.y);\n"
    "    float own = g * g * uintBitsToFloat(fragment.w);\n"
    "    float opacity = optimalOpacity(g, front, max(total - front - own, 0.0),\n"
    "      fourierWeights);\n"
    "    front += own;\n"
    "    if (int(fragment.z) >= 0)\n"
    "    {\n"
    "      imageAtomicMin(fourierSmallest, int(fragment.z), floatBitsToUint(opacity));\n"
    "    }\n"
    "  }\n"
    "  if (count - min(i, j) > 0)\n"
    "  {\n"
    "    dropFragments(count - min(i, j));\n"
    "  }\n"
    "  gl_FragData[0] = vec4(0.0);\n"
    "}\n";
  vtkFragmentLists::InsertExtensions(source);
  return source;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityStages::ResolveColors()
{
  return vtkFragmentLists::GetBlendSource();
}
