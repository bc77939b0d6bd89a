// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMethod.h"

#include "LineMethods.h"
#include "OpacityMethod.h"
#include "SceneImportance.h"
#include "TubeMethod.h"
#include "VoxelMethod.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace linesets
{
//------------------------------------------------------------------------------
BenchmarkMethod::BenchmarkMethod() = default;

//------------------------------------------------------------------------------
BenchmarkMethod::~BenchmarkMethod() = default;

//------------------------------------------------------------------------------
void BenchmarkMethod::SetMapper(vtkPolyDataMapper* mapper, const BenchmarkInput& input)
{
  const bool plain = input.Options.Plain;
  mapper->SetScalarVisibility(!plain);
  if (input.Table)
  {
    mapper->SetLookupTable(input.Table);
    mapper->UseLookupTableScalarRangeOn();
  }
  this->Actor->SetMapper(mapper);
  vtkProperty* property = this->Actor->GetProperty();
  property->SetColor(0.85, 0.8, 0.7);
  property->SetAmbient(0.1);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.3);
  property->SetSpecularPower(30.0);
  property->SetOpacity(input.Options.Opacity);
  this->Renderer->AddActor(this->Actor);
  this->Renderer->SetActiveCamera(input.Camera);
  const double background = plain ? 0.08 : 1.0;
  this->Renderer->SetBackground(background, background, background);
  for (const vtkSmartPointer<vtkLight>& light : input.Lights)
  {
    this->Renderer->AddLight(light);
  }
}

//------------------------------------------------------------------------------
vtkFloatArray* GetImportance(BenchmarkInput& input)
{
  if (!input.Importance)
  {
    input.Importance = MakeImportance(input.Scene, input.Options.Opacities.ImportanceArray);
  }
  if (!input.Importance)
  {
    throw std::runtime_error("the points have neither an array importance nor scalars of one "
                             "component; --importance names another array");
  }
  return input.Importance;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetMethodNames()
{
  std::vector<std::string> names = { "voxel" };
  for (const VoxelMethod::Variant& variant : VoxelMethod::GetVariants())
  {
    names.push_back(variant.Name);
  }
  for (const char* name : { "tubes", "peeling", "oit", "line-tubes", "lines", "illuminated",
         "illuminated-max", "illuminated-blinn", "illuminated-direct" })
  {
    names.push_back(name);
  }
  for (const OpacityMethod::Variant& variant : OpacityMethod::GetVariants())
  {
    names.push_back(variant.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
bool IsVoxelMethod(const std::string& name)
{
  return name == "voxel" || VoxelMethod::FindVariant(name);
}

//------------------------------------------------------------------------------
bool IsOpacityMethod(const std::string& name)
{
  return OpacityMethod::FindVariant(name) != nullptr;
}

//------------------------------------------------------------------------------
bool DrawsLinesOnly(const std::string& name)
{
  return name != "lines" && !IsOpacityMethod(name);
}

//------------------------------------------------------------------------------
bool HasShadows(const std::string& name)
{
  const VoxelMethod::Variant* variant = VoxelMethod::FindVariant(name);
  return variant && variant->Shadows != vtkLineGlobalIllumination::NoShadows;
}

//------------------------------------------------------------------------------
bool HasSphericalOcclusion(const std::string& name)
{
  const VoxelMethod::Variant* variant = VoxelMethod::FindVariant(name);
  return variant && variant->Occlusion == vtkLineGlobalIllumination::SphericalOcclusion;
}

//------------------------------------------------------------------------------
bool HasGlobalIllumination(const std::string& name)
{
  return VoxelMethod::FindVariant(name) != nullptr;
}

//------------------------------------------------------------------------------
std::unique_ptr<BenchmarkMethod> MakeMethod(const std::string& name, const std::string& engine)
{
  std::unique_ptr<BenchmarkMethod> method;
  if (IsVoxelMethod(name))
  {
    method = std::make_unique<VoxelMethod>(name, engine);
    method->Engine = engine;
  }
  else if (IsOpacityMethod(name))
  {
    method = std::make_unique<OpacityMethod>(name);
  }
  else if (name == "line-tubes")
  {
    method = std::make_unique<LineTubeMethod>();
  }
  else if (name == "lines" || name.compare(0, 11, "illuminated") == 0)
  {
    method = std::make_unique<LineMethod>(name);
  }
  else
  {
    method = std::make_unique<TubeMethod>(name);
  }
  method->Name = name;
  const bool plain = method->Engine.empty() || method->Engine == "automatic";
  method->FileName = plain ? name : name + "-" + engine;
  return method;
}

//------------------------------------------------------------------------------
double GetMilliseconds(std::chrono::steady_clock::time_point since)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since)
    .count();
}

//------------------------------------------------------------------------------
double GetMedian(std::vector<double> values)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

//------------------------------------------------------------------------------
long long CountLineSegments(vtkPolyData* lines)
{
  vtkCellArray* cells = lines->GetLines();
  return cells->GetNumberOfConnectivityIds() - cells->GetNumberOfCells();
}
}
