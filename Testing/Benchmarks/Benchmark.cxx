// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmark.h"

#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "ErrorRecorder.h"
#include "OpacityJudge.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <stdexcept>

namespace linesets
{
namespace
{
// Lines and their colours alone, so that all methods draw the same; vertex cells and polygons,
// with normals, where there are no lines.
vtkSmartPointer<vtkPolyData> KeepGeometry(vtkPolyData* input, vtkDataArray* scalars)
{
  auto geometry = vtkSmartPointer<vtkPolyData>::New();
  geometry->SetPoints(input->GetPoints());
  if (input->GetNumberOfLines() > 0)
  {
    geometry->SetLines(input->GetLines());
  }
  else
  {
    geometry->SetVerts(input->GetVerts());
    geometry->SetPolys(input->GetPolys());
    geometry->GetPointData()->SetNormals(input->GetPointData()->GetNormals());
  }
  const bool color = scalars && scalars->GetDataType() == VTK_UNSIGNED_CHAR &&
    (scalars->GetNumberOfComponents() == 3 || scalars->GetNumberOfComponents() == 4);
  if (scalars && (scalars->GetNumberOfComponents() == 1 || color))
  {
    geometry->GetPointData()->SetScalars(scalars);
  }
  return geometry;
}

// Told before hours of measuring.
void CheckOptionsOfLines(const BenchmarkOptions& options, vtkPolyData* geometry)
{
  if (geometry->GetNumberOfLines() > 0)
  {
    return;
  }
  if (options.Animate)
  {
    throw std::runtime_error("--animate moves lines, and " + options.Scene + " has none");
  }
  if (options.Reference &&
    std::none_of(options.Methods.begin(), options.Methods.end(), IsOpacityMethod))
  {
    throw std::runtime_error("--reference: exact pictures but those of opacity optimization are of "
                             "lines, and " +
      options.Scene + " has none");
  }
}

// From blue to red, with white-grey between.
vtkSmartPointer<vtkLookupTable> MakeImportanceTable()
{
  constexpr int colors = 256;
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToDiverging();
  function->AddRGBPoint(0.0, 59.0 / 255.0, 76.0 / 255.0, 192.0 / 255.0);
  function->AddRGBPoint(1.0, 180.0 / 255.0, 4.0 / 255.0, 38.0 / 255.0);
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(colors);
  table->SetRange(0.0, 1.0);
  for (int i = 0; i < colors; ++i)
  {
    double color[3];
    function->GetColor(i / (colors - 1.0), color);
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
  return table;
}

std::string GetRendererName(vtkRenderWindow* window)
{
  const std::string capabilities = window->ReportCapabilities();
  const std::string label = "OpenGL renderer string:";
  const std::size_t start = capabilities.find(label);
  if (start == std::string::npos)
  {
    return "unknown";
  }
  const std::size_t first = capabilities.find_first_not_of(' ', start + label.size());
  return capabilities.substr(first, capabilities.find('\n', first) - first);
}
}

//------------------------------------------------------------------------------
Benchmark::Benchmark(const BenchmarkOptions& options)
{
  this->Input.Options = options;
}

//------------------------------------------------------------------------------
Benchmark::~Benchmark()
{
  // Renderers release what they hold in the window while it exists.
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
void Benchmark::MakeInput()
{
  const BenchmarkOptions& options = this->Input.Options;
  const std::vector<std::string> names = GetSceneNames();
  const bool named = std::find(names.begin(), names.end(), options.Scene) != names.end();
  SceneOptions sceneOptions;
  sceneOptions.Lines = options.Lines;
  sceneOptions.Vertices = options.Vertices;
  sceneOptions.DataFolder = options.DataFolder;
  this->Input.Scene = named ? MakeScene(options.Scene, sceneOptions) : ReadScene(options.Scene);
  const bool colored = options.Color == "importance";
  this->Input.Geometry = KeepGeometry(this->Input.Scene,
    colored ? GetImportance(this->Input) : this->Input.Scene->GetPointData()->GetScalars());
  this->Input.ImportanceTable = MakeImportanceTable();
  if (!options.Opacities.ImportanceArray.empty())
  {
    GetImportance(this->Input); // a wrong name is told at once
  }
  CheckOptionsOfLines(options, this->Input.Geometry);
  if (options.Animate)
  {
    this->Moving = std::make_unique<MovingLines>(this->Input.Geometry);
  }
  double* bounds = this->Input.Bounds;
  this->Input.Geometry->GetBounds(bounds);
  const double longest =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  if (options.Scene == "surfaces")
  {
    this->Input.Closeness = 0.73; // a funnel leaves more of its bounds empty
  }
  this->Input.Radius = options.Radius > 0.0 ? options.Radius : longest / 512.0;
  vtkDataArray* scalars = this->Input.Geometry->GetPointData()->GetScalars();
  if (colored)
  {
    this->Input.Table = this->Input.ImportanceTable;
  }
  else if (scalars && scalars->GetNumberOfComponents() == 1)
  {
    this->Input.Table = vtkSmartPointer<vtkLookupTable>::New();
    this->Input.Table->SetHueRange(0.667, 0.0);
    this->Input.Table->SetRange(scalars->GetRange());
    this->Input.Table->Build();
  }
}

//------------------------------------------------------------------------------
void Benchmark::MakeWindow()
{
  this->Window = vtkSmartPointer<vtkRenderWindow>::New();
  if (this->Window->IsA("vtkXRenderWindow") || this->Window->IsA("vtkXOpenGLRenderWindow"))
  {
    if (!std::getenv("DISPLAY"))
    {
      throw std::runtime_error("no X display: set DISPLAY, or run under xvfb-run -a");
    }
  }
  this->Window->SetOffScreenRendering(true);
  const BenchmarkOptions& options = this->Input.Options;
  this->Window->SetMultiSamples(options.Samples);
  this->Window->SetAlphaBitPlanes(true);
  this->Window->SetSize(options.Width, options.Height);
  this->Input.Camera = vtkSmartPointer<vtkCamera>::New();
  PlaceCamera(this->Input, 0);
  this->Input.PixelRadius = GetPixelRadius(this->Input);
  this->Input.Lights = MakeLights(options.Light, this->Input.Camera);
}

//------------------------------------------------------------------------------
double Benchmark::DrawFrame(BenchmarkMethod& method)
{
  vtkRendererCollection* renderers = this->Window->GetRenderers();
  vtkCollectionSimpleIterator iterator;
  renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(iterator))
  {
    renderer->SetDraw(renderer == method.GetRenderer());
  }
  const auto start = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  return GetMilliseconds(start);
}

//------------------------------------------------------------------------------
void Benchmark::Attempt(
  BenchmarkMethod& method, const std::string& stage, const std::function<void()>& step)
{
  if (!method.Error.empty())
  {
    return;
  }
  ErrorRecorder recorder;
  try
  {
    step();
  }
  catch (const std::exception& exception)
  {
    method.Error = stage + ": " + exception.what();
  }
  if (method.Error.empty() && !recorder.GetFirstError().empty())
  {
    method.Error = stage + ": " + recorder.GetFirstError();
  }
  if (!method.Error.empty())
  {
    std::cerr << method.FileName << ": " << method.Error << "\n";
  }
}

//------------------------------------------------------------------------------
void Benchmark::PrepareMethod(BenchmarkMethod& method)
{
  if (DrawsLinesOnly(method.Name) && this->Input.Geometry->GetNumberOfLines() == 0)
  {
    throw std::runtime_error(method.Name + " draws lines only, and there are none");
  }
  method.Prepare(this->Input);
  this->Window->AddRenderer(method.GetRenderer());
}

//------------------------------------------------------------------------------
void Benchmark::DrawFirstFrame(BenchmarkMethod& method)
{
  method.FirstFrameMilliseconds = this->DrawFrame(method);
  if (this->RendererName.empty())
  {
    this->RendererName = GetRendererName(this->Window);
  }
}

//------------------------------------------------------------------------------
void Benchmark::DrawTimedFrame(BenchmarkMethod& method)
{
  // Processor time of all threads; std::clock() counts nothing else.
  const std::clock_t processorStart = std::clock();
  const auto start = std::chrono::steady_clock::now();
  double update = 0.0;
  if (this->Moving)
  {
    const double rebuild = method.Update(this->Input);
    update = GetMilliseconds(start);
    if (std::isfinite(rebuild))
    {
      method.RebuildMilliseconds.push_back(rebuild);
    }
  }
  const double frame = update + this->DrawFrame(method);
  method.FrameMilliseconds.push_back(frame);
  method.ProcessorMilliseconds.push_back(
    1000.0 * static_cast<double>(std::clock() - processorStart) / CLOCKS_PER_SEC);
  if (method.RebuildMilliseconds.size() == method.FrameMilliseconds.size())
  {
    method.DrawMilliseconds.push_back(frame - method.RebuildMilliseconds.back());
  }
}

//------------------------------------------------------------------------------
void Benchmark::TakePicture(BenchmarkMethod& method, vtkImageData* picture, const std::string& name)
{
  method.PrepareForPicture();
  this->DrawFrame(method);
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(this->Window);
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOff();
  grabber->Update();
  picture->DeepCopy(grabber->GetOutput());
  const std::string& prefix = this->Input.Options.ImagePrefix;
  if (!prefix.empty() && !WriteImage(picture, prefix + "-" + name + ".png"))
  {
    throw std::runtime_error("cannot write the picture");
  }
}

//------------------------------------------------------------------------------
void Benchmark::DrawReference(
  BenchmarkMethod& method, vtkImageData* picture, const std::string& name)
{
  this->Window->AddRenderer(method.GetRenderer());
  this->TakePicture(method, picture, name);
  this->Window->RemoveRenderer(method.GetRenderer());
}

//------------------------------------------------------------------------------
void Benchmark::MakeEntries()
{
  const BenchmarkOptions& options = this->Input.Options;
  for (const std::string& name : options.Methods)
  {
    const std::size_t engines = IsVoxelMethod(name) ? options.Engines.size() : 1;
    for (std::size_t i = 0; i < engines; ++i)
    {
      this->Entries.emplace_back();
      this->Entries.back().Method = MakeMethod(name, options.Engines[i]);
    }
  }
}

//------------------------------------------------------------------------------
void Benchmark::DrawTimedFrames()
{
  for (int frame = 1; frame <= this->Input.Options.Frames; ++frame)
  {
    PlaceCamera(this->Input, frame);
    if (this->Moving)
    {
      this->Input.Geometry = this->Moving->GetLines(frame);
    }
    for (BenchmarkEntry& entry : this->Entries)
    {
      BenchmarkMethod& method = *entry.Method;
      this->Attempt(method, "drawing", [&] { this->DrawTimedFrame(method); });
    }
  }
}

//------------------------------------------------------------------------------
void Benchmark::TakePictures()
{
  const BenchmarkOptions& options = this->Input.Options;
  const bool judged = options.Reference || options.DecodedReference;
  if (!judged && options.ImagePrefix.empty())
  {
    return;
  }
  // Lines that move are where the last frame left them, so that who missed them is found out.
  PlaceCamera(this->Input, 0);
  PictureJudge judge(this->Input);
  OpacityJudge opacityJudge(this->Input,
    [this](BenchmarkMethod& method, vtkImageData* picture, const std::string& name)
    { this->DrawReference(method, picture, name); });
  for (BenchmarkEntry& entry : this->Entries)
  {
    this->Attempt(*entry.Method, "picture",
      [&] { this->TakePicture(*entry.Method, entry.Picture, entry.Method->FileName); });
  }
  for (BenchmarkEntry& entry : this->Entries)
  {
    this->Attempt(*entry.Method, "reference",
      [&]
      {
        if (IsOpacityMethod(entry.Method->Name))
        {
          opacityJudge.Judge(entry);
        }
        else
        {
          judge.Judge(entry);
        }
      });
  }
}

//------------------------------------------------------------------------------
void Benchmark::JudgeOcclusions()
{
  if (!this->Input.Options.OcclusionReference)
  {
    return;
  }
  PlaceCamera(this->Input, 0);
  for (BenchmarkEntry& entry : this->Entries)
  {
    if (HasSphericalOcclusion(entry.Method->Name))
    {
      this->Attempt(*entry.Method, "occlusion reference",
        [&] { entry.Occlusion = JudgeOcclusion(this->Input, *entry.Method); });
    }
  }
}

//------------------------------------------------------------------------------
bool Benchmark::Run()
{
  this->MakeInput();
  this->MakeWindow();
  this->MakeEntries();
  for (BenchmarkEntry& entry : this->Entries)
  {
    BenchmarkMethod& method = *entry.Method;
    std::cerr << method.FileName << "\n";
    this->Attempt(method, "preparing", [&] { this->PrepareMethod(method); });
    this->Attempt(method, "first frame", [&] { this->DrawFirstFrame(method); });
  }
  this->DrawTimedFrames();
  this->TakePictures();
  this->JudgeOcclusions();
  bool good = true;
  for (BenchmarkEntry& entry : this->Entries)
  {
    this->Results.push_back(DescribeEntry(entry, this->Entries, this->Input, this->RendererName));
    good = good && entry.Method->Error.empty();
  }
  return good;
}

//------------------------------------------------------------------------------
std::vector<std::string> Benchmark::GetResults() const
{
  return this->Results;
}
}
