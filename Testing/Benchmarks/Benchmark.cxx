// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmark.h"

#include "CapsulesFromLines.h"
#include "CapsulesFromModel.h"
#include "ErrorRecorder.h"
#include "ImageMeasures.h"
#include "JsonObject.h"
#include "ReferenceRenderer.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkVersion.h"
#include "vtkVoxelLineModel.h"
#include "vtkWindowToImageFilter.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <limits>
#include <stdexcept>

namespace linesets
{
namespace
{
constexpr double DegreesPerFrame = 2.0;

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

// Lines and their colours alone, so that all methods draw the same.
vtkSmartPointer<vtkPolyData> KeepLines(vtkPolyData* input)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  lines->SetPoints(input->GetPoints());
  lines->SetLines(input->GetLines());
  vtkDataArray* scalars = input->GetPointData()->GetScalars();
  const bool color = scalars && scalars->GetDataType() == VTK_UNSIGNED_CHAR &&
    (scalars->GetNumberOfComponents() == 3 || scalars->GetNumberOfComponents() == 4);
  if (scalars && (scalars->GetNumberOfComponents() == 1 || color))
  {
    lines->GetPointData()->SetScalars(scalars);
  }
  return lines;
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

bool WriteImage(vtkImageData* image, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(image);
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}

// A method and how its picture compares.
struct Benchmark::Entry
{
  std::unique_ptr<BenchmarkMethod> Method;
  vtkNew<vtkImageData> Picture;
  double Rmse = std::numeric_limits<double>::quiet_NaN();
  double Ssim = std::numeric_limits<double>::quiet_NaN();
  double DecodedRmse = std::numeric_limits<double>::quiet_NaN();
};

//------------------------------------------------------------------------------
Benchmark::Benchmark(const BenchmarkOptions& options)
  : Options(options)
{
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
  const std::vector<std::string> names = GetSceneNames();
  const bool named = std::find(names.begin(), names.end(), this->Options.Scene) != names.end();
  SceneOptions sceneOptions;
  sceneOptions.Lines = this->Options.Lines;
  sceneOptions.Vertices = this->Options.Vertices;
  sceneOptions.DataFolder = this->Options.DataFolder;
  this->Input.Lines = KeepLines(
    named ? MakeScene(this->Options.Scene, sceneOptions) : ReadScene(this->Options.Scene));
  double bounds[6];
  this->Input.Lines->GetBounds(bounds);
  const double longest =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  this->Input.Radius = this->Options.Radius > 0.0 ? this->Options.Radius : longest / 512.0;
  this->Input.Opacity = this->Options.Opacity;
  this->Input.Resolution = this->Options.Resolution;
  this->Input.FaceBins = this->Options.FaceBins;
  this->Input.Peels = this->Options.Peels;
  this->Input.LineWidth = this->Options.LineWidth;
  this->Input.Plain = this->Options.Plain;
  this->Input.Stretch = this->Options.Stretch;
  this->Input.LightFromRight = this->Options.Light == "right";
  vtkDataArray* scalars = this->Input.Lines->GetPointData()->GetScalars();
  if (scalars && scalars->GetNumberOfComponents() == 1)
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
  this->Window->SetMultiSamples(this->Options.Samples);
  this->Window->SetAlphaBitPlanes(true);
  this->Window->SetSize(this->Options.Width, this->Options.Height);
  this->Input.Camera = vtkSmartPointer<vtkCamera>::New();
  this->SetView(0);
  double toFocus[3];
  vtkMath::Subtract(
    this->Input.Camera->GetFocalPoint(), this->Input.Camera->GetPosition(), toFocus);
  const double height = 2.0 * vtkMath::Norm(toFocus) *
    std::tan(vtkMath::RadiansFromDegrees(0.5 * this->Input.Camera->GetViewAngle()));
  this->Input.PixelRadius = this->Input.Radius / height * this->Options.Height;
}

//------------------------------------------------------------------------------
void Benchmark::SetView(int frame)
{
  double bounds[6];
  this->Input.Lines->GetBounds(bounds);
  double center[3];
  double diagonal = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    center[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    const double side = bounds[2 * i + 1] - bounds[2 * i] + 2.0 * this->Input.Radius;
    diagonal += side * side;
  }
  const double reach = 0.5 * std::sqrt(diagonal);
  vtkCamera* camera = this->Input.Camera;
  camera->SetViewAngle(30.0);
  // The sphere about the bounds touches the border of the shorter side of the image at 1; corners
  // are mostly empty, so go a little closer.
  const double aspect = static_cast<double>(this->Options.Width) / this->Options.Height;
  const double halfAngle = vtkMath::RadiansFromDegrees(15.0);
  const double distance =
    0.85 * reach / std::sin(aspect < 1.0 ? std::atan(aspect * std::tan(halfAngle)) : halfAngle);
  double direction[3] = { 0.55, -0.75, 0.36 };
  vtkMath::Normalize(direction);
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + distance * direction[0], center[1] + distance * direction[1],
    center[2] + distance * direction[2]);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->Azimuth(DegreesPerFrame * frame);
  camera->OrthogonalizeViewUp();
  camera->SetClippingRange(
    std::max(0.01 * distance, distance - 1.01 * reach), distance + 1.01 * reach);
}

//------------------------------------------------------------------------------
double Benchmark::DrawFrame(BenchmarkMethod& method)
{
  for (Entry& entry : this->Entries)
  {
    entry.Method->GetRenderer()->SetDraw(entry.Method.get() == &method);
  }
  const auto start = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}

//------------------------------------------------------------------------------
void Benchmark::Attempt(
  BenchmarkMethod& method, const std::string& stage, void (Benchmark::*step)(BenchmarkMethod&))
{
  if (!method.Error.empty())
  {
    return;
  }
  ErrorRecorder recorder;
  try
  {
    (this->*step)(method);
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
  const std::clock_t start = std::clock();
  method.FrameMilliseconds.push_back(this->DrawFrame(method));
  method.ProcessorMilliseconds.push_back(
    1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
}

//------------------------------------------------------------------------------
void Benchmark::TakePicture(BenchmarkMethod& method)
{
  this->DrawFrame(method);
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(this->Window);
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOff();
  grabber->Update();
  for (Entry& entry : this->Entries)
  {
    if (entry.Method.get() == &method)
    {
      entry.Picture->DeepCopy(grabber->GetOutput());
    }
  }
  if (!this->Options.ImagePrefix.empty() &&
    !WriteImage(grabber->GetOutput(), this->Options.ImagePrefix + "-" + method.FileName + ".png"))
  {
    throw std::runtime_error("cannot write the picture");
  }
}

//------------------------------------------------------------------------------
void Benchmark::DrawReference(
  const CapsuleScene& scene, BenchmarkMethod& method, vtkImageData* picture) const
{
  ReferenceRenderer reference(scene);
  reference.SetView(method.GetRenderer(), method.GetActor());
  ReferenceImage image;
  reference.Render(image);
  image.ToImageData(picture);
}

//------------------------------------------------------------------------------
void Benchmark::Judge()
{
  vtkNew<vtkImageData> exact;
  bool drawn = false;
  LineOptions lineOptions;
  lineOptions.Radius = this->Input.Radius;
  if (vtkDataArray* scalars = this->Input.Lines->GetPointData()->GetScalars())
  {
    if (!scalars->GetName())
    {
      scalars->SetName("scalars");
    }
    lineOptions.ColorArray = scalars->GetName();
  }
  for (Entry& entry : this->Entries)
  {
    BenchmarkMethod& method = *entry.Method;
    if (!method.Error.empty())
    {
      continue;
    }
    if (this->Options.Reference)
    {
      if (!drawn)
      {
        // Camera, lights and material are the same for all methods.
        std::cerr << "reference\n";
        this->DrawReference(MakeCapsulesFromLines(this->Input.Lines, lineOptions), method, exact);
        drawn = true;
        if (!this->Options.ImagePrefix.empty())
        {
          WriteImage(exact, this->Options.ImagePrefix + "-reference.png");
        }
      }
      entry.Rmse = CompareImages(entry.Picture, exact).Rmse;
      entry.Ssim = GetStructuralSimilarity(entry.Picture, exact);
    }
    if (this->Options.DecodedReference && method.GetModel())
    {
      std::cerr << "reference of the model of " << method.FileName << "\n";
      vtkNew<vtkImageData> decoded;
      this->DrawReference(
        MakeCapsulesFromModel(method.GetModel(), this->Input.Radius), method, decoded);
      entry.DecodedRmse = CompareImages(entry.Picture, decoded).Rmse;
    }
  }
}

//------------------------------------------------------------------------------
bool Benchmark::Run()
{
  this->MakeInput();
  this->MakeWindow();
  for (const std::string& name : this->Options.Methods)
  {
    const std::size_t engines = name == "voxel" ? this->Options.Engines.size() : 1;
    for (std::size_t i = 0; i < engines; ++i)
    {
      this->Entries.emplace_back();
      this->Entries.back().Method = MakeMethod(name, this->Options.Engines[i]);
    }
  }
  for (Entry& entry : this->Entries)
  {
    std::cerr << entry.Method->FileName << "\n";
    this->Attempt(*entry.Method, "preparing", &Benchmark::PrepareMethod);
    this->Attempt(*entry.Method, "first frame", &Benchmark::DrawFirstFrame);
  }
  for (int frame = 1; frame <= this->Options.Frames; ++frame)
  {
    this->SetView(frame);
    for (Entry& entry : this->Entries)
    {
      this->Attempt(*entry.Method, "drawing", &Benchmark::DrawTimedFrame);
    }
  }
  const bool judge = this->Options.Reference || this->Options.DecodedReference;
  if (judge || !this->Options.ImagePrefix.empty())
  {
    this->SetView(0);
    for (Entry& entry : this->Entries)
    {
      this->Attempt(*entry.Method, "picture", &Benchmark::TakePicture);
    }
  }
  if (judge)
  {
    this->Judge();
  }
  bool good = true;
  for (Entry& entry : this->Entries)
  {
    this->Results.push_back(this->Describe(entry));
    good = good && entry.Method->Error.empty();
  }
  return good;
}

//------------------------------------------------------------------------------
double Benchmark::GetPeerMedian(const std::string& name) const
{
  for (const Entry& entry : this->Entries)
  {
    if (entry.Method->Name == name && entry.Method->Error.empty())
    {
      return GetMedian(entry.Method->FrameMilliseconds);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
std::string Benchmark::Describe(Entry& entry)
{
  BenchmarkMethod& method = *entry.Method;
  JsonObject object;
  const auto addNumber = [&object](const std::string& key, double value)
  {
    if (std::isfinite(value))
    {
      object.Add(key, value);
    }
  };
  object.Add("scene", vtksys::SystemTools::GetFilenameName(this->Options.Scene));
  object.Add("lines", static_cast<long long>(this->Input.Lines->GetNumberOfLines()));
  object.Add("vertices", static_cast<long long>(this->Input.Lines->GetNumberOfPoints()));
  object.Add("method", method.Name);
  object.Add("width", this->Options.Width);
  object.Add("height", this->Options.Height);
  object.Add("opacity", this->Options.Opacity);
  object.Add("radius", this->Input.Radius);
  if (method.Error.empty())
  {
    const auto range =
      std::minmax_element(method.FrameMilliseconds.begin(), method.FrameMilliseconds.end());
    const double median = GetMedian(method.FrameMilliseconds);
    object.Add("frames", static_cast<long long>(method.FrameMilliseconds.size()));
    object.Add("median_ms", median);
    object.Add("min_ms", *range.first);
    object.Add("max_ms", *range.second);
    object.Add("cpu_ms", GetMedian(method.ProcessorMilliseconds));
    object.Add("build_ms", method.BuildMilliseconds);
    object.Add("first_frame_ms", method.FirstFrameMilliseconds);
    method.Describe(object);
    addNumber("rmse", entry.Rmse);
    addNumber("ssim", entry.Ssim);
    addNumber("rmse_decoded", entry.DecodedRmse);
    addNumber("ratio_tubes", this->GetPeerMedian("tubes") / median);
    addNumber("ratio_peeling", this->GetPeerMedian("peeling") / median);
    addNumber("ratio_lines", this->GetPeerMedian("lines") / median);
  }
  if (!this->RendererName.empty())
  {
    object.Add("renderer", this->RendererName);
  }
  object.Add("vtk", std::string(vtkVersion::GetVTKVersion()));
  object.Add("threads", vtkSMPTools::GetEstimatedNumberOfThreads());
  if (!method.Error.empty())
  {
    object.Add("error", method.Error);
  }
  return object.GetText();
}

//------------------------------------------------------------------------------
std::vector<std::string> Benchmark::GetResults() const
{
  return this->Results;
}
}
