// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpacityMethod.h"

#include "JsonObject.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkFourierOpacityMapper.h"
#include "vtkLookupTable.h"
#include "vtkOpacitySegments.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <sstream>

namespace linesets
{
namespace
{
using O = vtkOpacityOptimization;

// Of the exact picture in MiB; no more is taken than its fragments need.
constexpr int ExactListMemory = 8192;

const OpacityMethod::SceneDefaults& FindDefaults(const std::string& scene)
{
  const auto& all = OpacityMethod::GetSceneDefaults();
  const auto found = std::find_if(all.begin(), all.end(),
    [&scene](const OpacityMethod::SceneDefaults& defaults) { return scene == defaults.Scene; });
  return found == all.end() ? all.back() : *found;
}
}

//------------------------------------------------------------------------------
const std::vector<OpacityMethod::Variant>& OpacityMethod::GetVariants()
{
  static const std::vector<Variant> variants = {
    { "fourier", O::Fourier },
    { "fourier-paper", O::PaperFourier },
    { "bins", O::Bins },
    { "weighted-average", O::WeightedAverage },
    { "weighted-blended", O::WeightedBlended },
    { "fragment-list", O::FragmentLists },
  };
  return variants;
}

//------------------------------------------------------------------------------
const OpacityMethod::Variant* OpacityMethod::FindVariant(const std::string& name)
{
  const std::vector<Variant>& variants = GetVariants();
  const auto found = std::find_if(variants.begin(), variants.end(),
    [&name](const Variant& variant) { return name == variant.Name; });
  return found == variants.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
const std::vector<OpacityMethod::SceneDefaults>& OpacityMethod::GetSceneDefaults()
{
  // Weights of the tornado and of points are those of the paper's TORNADO and DARK SKY. Where lines
  // wind about what is important, or many layers hide it, the little opacity that smoothing brings
  // to what has faded is enough to hide it again.
  static const std::vector<SceneDefaults> defaults = {
    { "tornado", { { 1.0, 60.0, 500.0, 2.0 } }, 1 },
    { "carotid", { { 1.0, 400.0, 200.0, 1.3 } }, 2 },
    { "turbulence", { { 1.0, 1000.0, 1000.0, 2.0 } }, 15 },
    { "forecast", { { 1.0, 400.0, 200.0, 1.3 } }, 15 },
    { "lorenz", { { 1.0, 200.0, 200.0, 1.3 } }, 1 },
    { "points", { { 1.0, 100.0, 20.0, 1.3 } }, 15 },
    { "surfaces", { { 1.0, 10.0, 500.0, 2.0 } }, 0 },
    { "", { { 1.0, 50.0, 50.0, 2.0 } }, 15 },
  };
  return defaults;
}

//------------------------------------------------------------------------------
OpacityMethod::OpacityMethod(const std::string& name)
  : Blending(FindVariant(name)->Blending)
{
}

//------------------------------------------------------------------------------
OpacityMethod::~OpacityMethod() = default;

//------------------------------------------------------------------------------
std::unique_ptr<OpacityMethod> OpacityMethod::MakeExact(int importanceReduction)
{
  auto method = std::make_unique<OpacityMethod>("fragment-list");
  method->Name = "fragment-list";
  method->ExactReduction = importanceReduction;
  return method;
}

//------------------------------------------------------------------------------
void OpacityMethod::SetOptimization(const BenchmarkOptions& options)
{
  const OpacityOptions& from = options.Opacities;
  const SceneDefaults& defaults = FindDefaults(options.Scene);
  const std::array<double, 4> weights = from.Weights.value_or(defaults.Weights);
  const bool exact = this->Blending == O::FragmentLists;
  vtkOpacityOptimization* optimization = this->Mapper->GetOptimization();
  optimization->SetRegularizationWeight(weights[0]);
  optimization->SetForegroundWeight(weights[1]);
  optimization->SetBackgroundWeight(weights[2]);
  optimization->SetEmphasis(weights[3]);
  optimization->SetBlending(this->Blending);
  optimization->SetImportance(
    exact || from.ImportanceSums == "exact" ? O::ExactImportance : O::SeriesImportance);
  optimization->SetSmoothingIterations(from.Smoothing.value_or(defaults.Smoothing));
  optimization->SetNumberOfBands(from.Bands);
  optimization->SetSubset(exact ? 1 : from.Subset);
  optimization->SetDepthScale(
    from.DepthScale == "logarithmic" ? O::LogarithmicDepth : O::LinearDepth);
  optimization->SetTightDepth(from.TightDepth);
  optimization->SetOpaqueThreshold(from.OpaqueThreshold);
  optimization->SetDepthReduction(from.DepthReduction);
  optimization->SetHalfFloats(from.HalfFloats);
  optimization->SetImportanceReduction(
    this->ExactReduction > 0 ? this->ExactReduction : from.ImportanceReduction);
  optimization->SetMaximumListMemory(
    this->ExactReduction > 0 ? std::max(ExactListMemory, from.ListMemory) : from.ListMemory);
}

//------------------------------------------------------------------------------
double OpacityMethod::RunFilter(BenchmarkInput& input)
{
  vtkFloatArray* importance = GetImportance(input);
  vtkNew<vtkPolyData> geometry;
  geometry->ShallowCopy(input.Geometry);
  geometry->GetPointData()->AddArray(importance);
  if (input.Options.Color != "scalars")
  {
    geometry->GetPointData()->SetScalars(importance);
  }
  const auto start = std::chrono::steady_clock::now();
  this->Filter->SetInputData(geometry);
  this->Filter->SetNumberOfLineSegments(input.Options.Opacities.LineSegments);
  this->Filter->SetNumberOfPatches(input.Options.Opacities.Patches);
  this->Filter->Update();
  return GetMilliseconds(start);
}

//------------------------------------------------------------------------------
void OpacityMethod::Prepare(BenchmarkInput& input)
{
  if (!input.Segments)
  {
    input.SegmentMilliseconds = this->RunFilter(input);
    // Apart from the filter's output, which changes where lines move.
    input.Segments = vtkSmartPointer<vtkPolyData>::New();
    input.Segments->ShallowCopy(this->Filter->GetOutput());
  }
  this->BuildMilliseconds = input.SegmentMilliseconds;
  this->Mapper->SetInputData(input.Segments);
  this->Mapper->SetImportanceArrayName("importance");
  this->Mapper->SetImportanceRange(0.0, 1.0);
  this->SetOptimization(input.Options);
  this->SetMapper(this->Mapper, input);
  if (input.Options.Color != "scalars")
  {
    this->Mapper->SetLookupTable(input.ImportanceTable);
    this->Mapper->UseLookupTableScalarRangeOn();
  }
  this->Actor->GetProperty()->SetLineWidth(static_cast<float>(input.Options.LineWidth));
  this->Actor->GetProperty()->SetPointSize(static_cast<float>(input.Options.LineWidth));
}

//------------------------------------------------------------------------------
double OpacityMethod::Update(BenchmarkInput& input)
{
  const double milliseconds = this->RunFilter(input);
  this->Mapper->SetInputData(this->Filter->GetOutput());
  return milliseconds;
}

//------------------------------------------------------------------------------
void OpacityMethod::PrepareForPicture()
{
  // It must not depend on the frames before.
  this->Mapper->ForgetOpacities();
}

//------------------------------------------------------------------------------
bool OpacityMethod::UsesLists() const
{
  return this->Blending == O::FragmentLists ||
    this->Mapper->GetOptimization()->GetImportance() == O::ExactImportance;
}

//------------------------------------------------------------------------------
void OpacityMethod::Describe(JsonObject& object)
{
  // What the mapper has, in place of what was asked for.
  vtkOpacityOptimization* optimization = this->Mapper->GetOptimization();
  const bool exact = optimization->GetImportance() == O::ExactImportance;
  const bool lists = this->Blending == O::FragmentLists;
  object.Add("importance", std::string(exact ? "exact" : "fourier"));
  object.Add("importance_reduction", optimization->GetImportanceReduction());
  if (!lists)
  {
    object.Add("bands", optimization->GetNumberOfBands());
    object.Add("subset", optimization->GetSubset());
    object.Add("depth_reduction", optimization->GetDepthReduction());
    object.Add("half_floats", optimization->GetHalfFloats() ? 1 : 0);
  }
  std::ostringstream weights;
  weights << optimization->GetRegularizationWeight() << "," << optimization->GetForegroundWeight()
          << "," << optimization->GetBackgroundWeight() << "," << optimization->GetEmphasis();
  object.Add("weights", weights.str());
  object.Add("smoothing", optimization->GetSmoothingIterations());
  object.Add("gpu_bytes", static_cast<long long>(this->Mapper->GetNumberOfBytes()));
  object.Add("sum_bytes", static_cast<long long>(this->Mapper->GetNumberOfSumBytes()));
  if (this->UsesLists())
  {
    object.Add("fragments", static_cast<long long>(this->Mapper->GetNumberOfFragments()));
    object.Add("dropped", this->GetNumberOfDroppedFragments());
  }
  if (lists)
  {
    this->DepthComplexity = this->Mapper->GetMeanDepthComplexity();
  }
}

//------------------------------------------------------------------------------
long long OpacityMethod::GetNumberOfDroppedFragments()
{
  return this->Mapper->GetNumberOfDroppedFragments();
}

//------------------------------------------------------------------------------
double OpacityMethod::GetMeanDepthComplexity()
{
  return this->Mapper->GetMeanDepthComplexity();
}
}
