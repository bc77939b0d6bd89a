// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMethod.h"

#include "JsonObject.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkLight.h"
#include "vtkLineIllumination.h"
#include "vtkLineSetsCompatibilityPrivate.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"
#include "vtkVoxelLineMapper.h"
#include "vtkVoxelLineModel.h"

#include <chrono>
#include <stdexcept>

namespace linesets
{
namespace
{
double GetMilliseconds(std::chrono::steady_clock::time_point since)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since)
    .count();
}

long long CountLineSegments(vtkPolyData* lines)
{
  vtkCellArray* cells = lines->GetLines();
  return cells->GetNumberOfConnectivityIds() - cells->GetNumberOfCells();
}

//------------------------------------------------------------------------------
class VoxelMethod : public BenchmarkMethod
{
public:
  explicit VoxelMethod(const std::string& engine)
  {
    this->Mapper->SetEngine(engine == "native" ? vtkVoxelLineMapper::Native
        : engine == "shader"                   ? vtkVoxelLineMapper::Shader
                                               : vtkVoxelLineMapper::Automatic);
  }

  void Prepare(BenchmarkInput& input) override
  {
    this->Mapper->SetInputData(input.Lines);
    this->Mapper->SetRadius(input.Radius);
    this->Mapper->SetResolution(input.Resolution);
    this->Mapper->SetFaceBins(input.FaceBins);
    this->SetMapper(this->Mapper, input);
    const auto start = std::chrono::steady_clock::now();
    if (!this->Mapper->GetModel())
    {
      throw std::runtime_error("no model was built");
    }
    this->BuildMilliseconds = GetMilliseconds(start);
  }

  void Describe(JsonObject& object) override
  {
    const int engine = this->Mapper->GetEngineInUse();
    object.Add("engine",
      std::string(engine == vtkVoxelLineMapper::Native ? "native"
          : engine == vtkVoxelLineMapper::Shader       ? "shader"
                                                       : "none"));
    vtkVoxelLineModel* model = this->Mapper->GetModel();
    object.Add("model_bytes", static_cast<long long>(model->GetNumberOfBytes()));
    object.Add("gpu_bytes", static_cast<long long>(this->Mapper->GetGraphicsMemory()));
    object.Add("segments", static_cast<long long>(model->GetNumberOfSegments()));
  }

  vtkVoxelLineModel* GetModel() override { return this->Mapper->GetModel(); }

private:
  vtkNew<vtkVoxelLineMapper> Mapper;
};

//------------------------------------------------------------------------------
class TubeMethod : public BenchmarkMethod
{
public:
  explicit TubeMethod(const std::string& name)
    : Translucent(name != "tubes")
  {
    vtkLineSetsCompatibility::SetUseOIT(this->Renderer.Get(), name == "oit");
    if (name == "peeling")
    {
      this->Renderer->SetUseDepthPeeling(true);
      this->Renderer->SetOcclusionRatio(0.0);
    }
  }

  void Prepare(BenchmarkInput& input) override
  {
    if (this->Translucent && input.Opacity >= 1.0)
    {
      throw std::runtime_error("needs an opacity below 1");
    }
    if (this->Name == "peeling")
    {
      // vtkRenderer documents 0 as no limit, but vtkDualDepthPeelingPass then peels nothing and
      // blends all tubes in the order of the cells.
      this->Peels = input.Peels;
      this->Renderer->SetMaximumNumberOfPeels(input.Peels > 0 ? input.Peels : VTK_INT_MAX);
    }
    this->Segments = CountLineSegments(input.Lines);
    if (!input.Tubes)
    {
      const auto start = std::chrono::steady_clock::now();
      vtkNew<vtkTubeFilter> filter;
      filter->SetInputData(input.Lines);
      filter->SetRadius(input.Radius);
      filter->SetNumberOfSides(8);
      filter->CappingOff();
      filter->SetVaryRadiusToVaryRadiusOff();
      filter->Update();
      input.Tubes = filter->GetOutput();
      input.TubeMilliseconds = GetMilliseconds(start);
    }
    this->BuildMilliseconds = input.TubeMilliseconds;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(input.Tubes);
    this->SetMapper(mapper, input);
    this->Actor->GetProperty()->BackfaceCullingOn();
    this->Geometry = input.Tubes;
    this->HasColors = input.Tubes->GetPointData()->GetScalars() != nullptr;
  }

  void Describe(JsonObject& object) override
  {
    if (!this->Geometry)
    {
      return;
    }
    // Positions and normals as floats, colours as bytes, strips as three indices per triangle.
    const long long points = this->Geometry->GetNumberOfPoints();
    vtkCellArray* strips = this->Geometry->GetStrips();
    const long long triangles =
      strips->GetNumberOfConnectivityIds() - 2 * strips->GetNumberOfCells();
    if (this->Peels > 0)
    {
      object.Add("peels", this->Peels);
    }
    object.Add("gpu_bytes", points * (24 + (this->HasColors ? 4 : 0)) + triangles * 12);
    object.Add("segments", this->Segments);
  }

private:
  bool Translucent;
  bool HasColors = false;
  int Peels = 0;
  long long Segments = 0;
  vtkSmartPointer<vtkPolyData> Geometry;
};

//------------------------------------------------------------------------------
class LineTubeMethod : public BenchmarkMethod
{
public:
  void Prepare(BenchmarkInput& input) override
  {
    this->Segments = CountLineSegments(input.Lines);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(input.Lines);
    this->SetMapper(mapper, input);
    this->Actor->GetProperty()->RenderLinesAsTubesOn();
    this->Actor->GetProperty()->SetLineWidth(static_cast<float>(2.0 * input.PixelRadius));
  }

  void Describe(JsonObject& object) override { object.Add("segments", this->Segments); }

private:
  long long Segments = 0;
};

//------------------------------------------------------------------------------
/// Lines one pixel wide (or as wide as was asked for), without and with light.
class LineMethod : public BenchmarkMethod
{
public:
  explicit LineMethod(const std::string& name)
    : Illuminated(name != "lines")
  {
    vtkLineIllumination* illumination = this->Mapper->GetIllumination();
    if (name == "illuminated-max")
    {
      illumination->SetModelToMaximumReflection();
    }
    else if (name == "illuminated-blinn")
    {
      illumination->SetReflectionToBlinn();
    }
    else if (name == "illuminated-direct")
    {
      illumination->SetEvaluationToDirect();
    }
  }

  void Prepare(BenchmarkInput& input) override
  {
    this->Segments = CountLineSegments(input.Lines);
    this->Mapper->GetIllumination()->SetStretchDynamicRange(input.Stretch);
    vtkNew<vtkPolyDataMapper> plain;
    vtkPolyDataMapper* mapper = this->Illuminated ? this->Mapper.Get() : plain.Get();
    mapper->SetInputData(input.Lines);
    this->SetMapper(mapper, input);
    this->Actor->GetProperty()->SetLineWidth(static_cast<float>(input.LineWidth));
  }

  void Describe(JsonObject& object) override
  {
    object.Add("segments", this->Segments);
    if (this->Illuminated)
    {
      object.Add("drawn", static_cast<long long>(this->Mapper->GetNumberOfDrawnSegments()));
    }
  }

private:
  bool Illuminated;
  long long Segments = 0;
  vtkNew<vtkIlluminatedLineMapper> Mapper;
};
}

//------------------------------------------------------------------------------
BenchmarkMethod::BenchmarkMethod() = default;

//------------------------------------------------------------------------------
BenchmarkMethod::~BenchmarkMethod() = default;

//------------------------------------------------------------------------------
void BenchmarkMethod::SetMapper(vtkPolyDataMapper* mapper, const BenchmarkInput& input)
{
  mapper->SetScalarVisibility(!input.Plain);
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
  property->SetOpacity(input.Opacity);
  this->Renderer->AddActor(this->Actor);
  this->Renderer->SetActiveCamera(input.Camera);
  const double background = input.Plain ? 0.08 : 1.0;
  this->Renderer->SetBackground(background, background, background);
  if (input.LightFromRight)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(1.0, 0.4, 0.7);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->AddLight(light);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> GetMethodNames()
{
  return { "voxel", "tubes", "peeling", "oit", "line-tubes", "lines", "illuminated",
    "illuminated-max", "illuminated-blinn", "illuminated-direct" };
}

//------------------------------------------------------------------------------
std::unique_ptr<BenchmarkMethod> MakeMethod(const std::string& name, const std::string& engine)
{
  std::unique_ptr<BenchmarkMethod> method;
  std::string fileName = name;
  if (name == "voxel")
  {
    method = std::make_unique<VoxelMethod>(engine);
    fileName += engine == "automatic" ? "" : "-" + engine;
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
  method->FileName = fileName;
  return method;
}
}
