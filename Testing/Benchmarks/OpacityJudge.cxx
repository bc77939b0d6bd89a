// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpacityJudge.h"

#include "ErrorRecorder.h"
#include "ImageMeasures.h"
#include "OpacityMethod.h"

#include "vtkImageData.h"

#include <iostream>
#include <stdexcept>
#include <utility>

namespace linesets
{
//------------------------------------------------------------------------------
OpacityJudge::OpacityJudge(BenchmarkInput& input, DrawFunction draw)
  : Input(input)
  , Draw(std::move(draw))
{
}

//------------------------------------------------------------------------------
void OpacityJudge::DrawExact(Exact& exact, int reduction, const std::string& name)
{
  std::cerr << name << "\n";
  const auto method = OpacityMethod::MakeExact(reduction);
  ErrorRecorder recorder;
  method->Prepare(this->Input);
  if (this->Input.Options.Animate)
  {
    method->Update(this->Input); // to the lines of the last frame
  }
  this->Draw(*method, exact.Picture, name);
  exact.DepthComplexity = method->GetMeanDepthComplexity();
  const long long dropped = method->GetNumberOfDroppedFragments();
  exact.Error = recorder.GetFirstError();
  if (exact.Error.empty() && dropped > 0)
  {
    exact.Error = std::to_string(dropped) +
      " fragments of the exact picture did not fit into memory: a smaller --size needs less";
  }
}

//------------------------------------------------------------------------------
const OpacityJudge::Exact& OpacityJudge::GetExact(
  Exact& exact, int reduction, const std::string& name)
{
  if (!exact.Drawn)
  {
    exact.Drawn = true;
    try
    {
      this->DrawExact(exact, reduction, name);
    }
    catch (const std::runtime_error& error)
    {
      exact.Error = error.what();
    }
  }
  // Told for every method that it was to judge.
  if (!exact.Error.empty())
  {
    throw std::runtime_error(exact.Error);
  }
  return exact;
}

//------------------------------------------------------------------------------
void OpacityJudge::Judge(BenchmarkEntry& entry)
{
  if (!entry.Method->Error.empty() || !this->Input.Options.Reference)
  {
    return;
  }
  const int reduction = this->Input.Options.Opacities.ImportanceReduction;
  const Exact& reduced = this->GetExact(this->Reduced, reduction, "opacity-reference");
  const Exact& full =
    reduction == 1 ? reduced : this->GetExact(this->Full, 1, "opacity-reference-full");
  entry.Method->DepthComplexity = reduced.DepthComplexity;
  entry.Rmse = CompareImages(entry.Picture, reduced.Picture).Rmse;
  entry.Ssim = GetStructuralSimilarity(entry.Picture, reduced.Picture);
  entry.FullRmse = CompareImages(entry.Picture, full.Picture).Rmse;
  entry.FullSsim = GetStructuralSimilarity(entry.Picture, full.Picture);
}
}
