// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that tubes thinner than a pixel keep the brightness of the picture: along a zoom, in which
// tubes go from 4 pixels of width to 0.2, by both engines, opaque and transparent; and against the
// reference, in double precision and averaged over 64 rays per pixel. Without coverage the same
// measures are far worse.

#include "VoxelLineReferenceTesting.h"

#include "vtkLight.h"
#include "vtkLineIllumination.h"

#include <limits>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr double TubeRadius = 0.005;

// Straight and curved lines in all directions, within about 1 of the origin.
vtkSmartPointer<vtkPolyData> MakeSparseBundle()
{
  std::vector<Curve> curves;
  for (int i = 0; i < 100; ++i)
  {
    linesets::Random random(11, static_cast<std::uint64_t>(i));
    Point center;
    Point along;
    Point aside;
    for (int k = 0; k < 3; ++k)
    {
      center[k] = random.Uniform(-0.4, 0.4);
      along[k] = random.Uniform(-1.0, 1.0);
      aside[k] = random.Uniform(-1.0, 1.0);
    }
    vtkMath::Normalize(along.data());
    vtkMath::Normalize(aside.data());
    const double bend = i % 2 == 0 ? 0.0 : 0.15;
    Curve curve;
    for (int j = 0; j <= 40; ++j)
    {
      const double s = j / 20.0 - 1.0;
      Point x;
      for (int k = 0; k < 3; ++k)
      {
        x[k] = center[k] + 0.65 * s * along[k] + bend * std::sin(4.0 * s) * aside[k];
      }
      curve.push_back(x);
    }
    curves.push_back(curve);
  }
  auto lines = MakeLines(curves);
  vtkNew<vtkDoubleArray> t;
  t->SetName("t");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    t->InsertNextValue(static_cast<double>(i % 41) / 40.0);
  }
  lines->GetPointData()->SetScalars(t);
  return lines;
}

// A light of the scene that is the same wherever the camera stands.
void AddLight(vtkRenderer* renderer, const Point& position, const Point& color, bool positional)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(position.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetDiffuseColor(color.data());
  light->SetPositional(positional);
  light->SetConeAngle(180.0);
  renderer->AddLight(light);
}

// The bundle on black, by three lights, none of which makes a colour reach its end.
class Bundle
{
public:
  explicit Bundle(int size)
    : Scene(size, size)
  {
    this->Mapper->SetInputData(MakeSparseBundle());
    this->Mapper->SetRadius(TubeRadius);
    this->Mapper->SetEarlyTermination(1.0);
    this->Actor = this->Scene.Add(this->Mapper);
    vtkProperty* property = this->Actor->GetProperty();
    property->SetAmbient(0.1);
    property->SetDiffuse(0.6);
    property->SetSpecular(0.25);
    property->SetSpecularPower(15.0);
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->SetBackground(0.0, 0.0, 0.0);
    renderer->AutomaticLightCreationOff();
    AddLight(renderer, { 3.0, 4.0, 5.0 }, { 0.7, 0.6, 0.5 }, false);
    AddLight(renderer, { -4.0, 0.0, 2.0 }, { 0.3, 0.4, 0.5 }, false);
    AddLight(renderer, { 0.0, -3.0, 3.0 }, { 0.3, 0.3, 0.3 }, true);
  }

  // Tubes become this many pixels wide, by the scale of a parallel view or by the distance.
  void SetWidth(double pixels, bool parallel)
  {
    const double worldPerPixel = 2.0 * TubeRadius / pixels;
    const double height = worldPerPixel * this->Scene.Window->GetSize()[1];
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(0.5 * height);
    camera->SetViewAngle(4.0);
    const double distance =
      parallel ? 10.0 : 0.5 * height / std::tan(0.5 * vtkMath::RadiansFromDegrees(4.0));
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.36 * distance, 0.48 * distance, 0.8 * distance);
    camera->SetViewUp(0.0, 1.0, 0.0);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  Stage Scene;
  vtkNew<vtkVoxelLineMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
};

// Light of the picture; the background is black.
double GetLight(const Picture& picture)
{
  double sum = 0.0;
  for (const unsigned char byte : picture.Bytes)
  {
    sum += byte;
  }
  return sum;
}

// Widths from 4 pixels to 0.2, the largest first.
std::vector<double> GetWidths(int steps)
{
  std::vector<double> widths;
  for (int i = 0; i <= steps; ++i)
  {
    widths.push_back(4.0 * std::pow(0.05, static_cast<double>(i) / steps));
  }
  return widths;
}

struct Steadiness
{
  /// Largest change of light per area of the bundle between neighbouring steps, and over all.
  double Step = 0.0;
  double Range = 0.0;
};

Steadiness Zoom(Bundle& bundle, const std::vector<double>& widths, bool parallel)
{
  Steadiness result;
  double last = 0.0;
  double lowest = std::numeric_limits<double>::max();
  double highest = 0.0;
  for (const double width : widths)
  {
    bundle.SetWidth(width, parallel);
    const double light = GetLight(bundle.Scene.Render()) / (width * width);
    std::cout << " " << width << ": " << light;
    result.Step = last > 0.0 ? std::max(result.Step, std::abs(light / last - 1.0)) : 0.0;
    last = light;
    lowest = std::min(lowest, light);
    highest = std::max(highest, light);
  }
  result.Range = highest / lowest - 1.0;
  std::cout << std::endl;
  return result;
}

void CheckZooms(Checks& check)
{
  Bundle bundle(900);
  bundle.Mapper->SetEngineToNative();
  for (const bool parallel : { true, false })
  {
    for (const double opacity : { 1.0, 0.25 })
    {
      const std::string name = std::string(parallel ? "parallel" : "perspective") +
        (opacity < 1.0 ? ", transparent" : ", opaque");
      bundle.Actor->GetProperty()->SetOpacity(opacity);
      bundle.Mapper->SubPixelCoverageOn();
      // One sweep is fine and held against the other way; the others are coarser, for time.
      const bool isFine = parallel && opacity == 1.0;
      const Steadiness on = Zoom(bundle, GetWidths(isFine ? 15 : 7), parallel);
      std::cout << name << ": with coverage " << on.Step << " per step, " << on.Range << " over all"
                << std::endl;
      check(on.Step <= 0.02, name + ": light from step to step");
      // Over all steps the noise of few pixels adds up: 2.3 % at most was seen.
      check(on.Range <= 0.03, name + ": light over all");
      if (isFine)
      {
        bundle.Mapper->SubPixelCoverageOff();
        std::vector<double> thin = GetWidths(15);
        thin.erase(thin.begin(), thin.begin() + 8);
        const Steadiness off = Zoom(bundle, thin, parallel);
        std::cout << name << ": without coverage " << off.Step << ", " << off.Range << std::endl;
        // The measure tells: tubes that are lost between pixels, and found on them, do not pass it.
        check(off.Step > 0.03, name + ": light without coverage");
      }
    }
  }
}

// A light model that is for lines alone lights wide tubes in the same way, so that there is no
// seam.
void CheckLineModels(Checks& check)
{
  const std::vector<double> widths = { 2.6, 2.1, 1.6, 1.2, 0.9, 0.6 };
  Bundle bundle(560);
  bundle.Mapper->SetEngineToNative();
  bundle.Mapper->GetIllumination()->SetModelToMaximumReflection();
  const Steadiness maximum = Zoom(bundle, widths, true);
  check(maximum.Range <= 0.02, "maximum reflection: light over all");
  bundle.Mapper->GetIllumination()->SetModelToCylinderAveraging();
  bundle.Mapper->GetIllumination()->StretchDynamicRangeOn();
  // Darker, since stretched light would reach the end of what a picture can show.
  bundle.Actor->GetProperty()->SetDiffuse(0.4);
  bundle.Actor->GetProperty()->SetSpecular(0.1);
  const Steadiness stretched = Zoom(bundle, widths, true);
  check(stretched.Range <= 0.02, "stretched light: light over all");
}

// Both engines draw the same, from tubes with a surface to thin ones.
void CheckShader(Checks& check)
{
  Bundle bundle(60);
  for (const double width : { 2.5, 1.5, 0.6 })
  {
    for (const double opacity : { 1.0, 0.25 })
    {
      bundle.Actor->GetProperty()->SetOpacity(opacity);
      bundle.SetWidth(width, opacity < 1.0);
      bundle.Mapper->SetEngineToNative();
      const Picture native = bundle.Scene.Render();
      bundle.Mapper->SetEngineToShader();
      const Picture shader = bundle.Scene.Render();
      const Difference difference = Compare(native, shader);
      const std::string name = "width " + std::to_string(width) + ", opacity " +
        std::to_string(opacity) + ": engines" + Describe(difference);
      std::cout << name << std::endl;
      // Rounding decides whether the ray hits, for single pixels at the edges of tubes.
      check(difference.Rms < 1.0 && difference.Part < 0.002, name);
      check(GetCoverage(native, { 0, 0, 0 }) > 0.05, name + ": something is seen");
    }
  }
}

// Red, green and blue of a reference picture, averaged over squares of pixels.
std::vector<double> Average(const linesets::ReferenceImage& image, int factor)
{
  const int width = image.Width / factor;
  const int height = image.Height / factor;
  std::vector<double> result(static_cast<std::size_t>(3) * width * height, 0.0);
  for (int y = 0; y < height * factor; ++y)
  {
    for (int x = 0; x < width * factor; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        result[3 * (static_cast<std::size_t>(y / factor) * width + x / factor) + c] += 255.0 *
          image.Color[3 * (static_cast<std::size_t>(y) * image.Width + x) + c] / (factor * factor);
      }
    }
  }
  return result;
}

struct Deviation
{
  double Light = 0.0;
  double Rms = 0.0;
};

Deviation Compare(const Picture& picture, const std::vector<double>& expected)
{
  Deviation result;
  double sum = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const double difference = picture.Bytes[i] - expected[i];
    sum += expected[i];
    result.Light += difference;
    result.Rms += difference * difference;
  }
  result.Light /= sum;
  result.Rms = std::sqrt(result.Rms / static_cast<double>(expected.size()));
  return result;
}

void WritePicture(const Picture& picture, const std::string& name)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.Width, picture.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(picture.Bytes.begin(), picture.Bytes.end(),
    static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(name.c_str());
  writer->Write();
}

// The truth: 64 rays per pixel. In the wide view tubes are 1.6 pixels wide in front, 0.3 behind.
void CheckAgainstReference(Checks& check, int argc, char* argv[])
{
  constexpr int Factor = 8;
  char* directory =
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  Bundle bundle(80);
  bundle.Mapper->SetEngineToNative();
  vtkVoxelLineModel* model = bundle.Mapper->GetModel();
  const linesets::CapsuleScene capsules = linesets::MakeCapsulesFromModel(model, TubeRadius);
  const std::vector<std::pair<std::string, double>> views = { { "wide view", 0.0 },
    { "width 1", 1.0 }, { "width 0.5", 0.5 } };
  for (const auto& [view, width] : views)
  {
    bundle.SetWidth(width > 0.0 ? width : 1.0, true);
    if (width == 0.0)
    {
      vtkCamera* camera = bundle.Scene.Renderer->GetActiveCamera();
      camera->ParallelProjectionOff();
      camera->SetViewAngle(60.0);
      camera->SetPosition(0.6, 0.8, 1.25);
      bundle.Scene.Renderer->ResetCameraClippingRange();
    }
    for (const double opacity : { 1.0, 0.25 })
    {
      if (opacity < 1.0 && width >= 1.0)
      {
        continue; // it takes long, and tells nothing more
      }
      const std::string name = view + (opacity < 1.0 ? ", transparent" : ", opaque");
      bundle.Actor->GetProperty()->SetOpacity(opacity);
      bundle.Mapper->SubPixelCoverageOn();
      const Picture on = bundle.Scene.Render();
      bundle.Mapper->SubPixelCoverageOff();
      const Picture off = bundle.Scene.Render();
      linesets::ReferenceRenderer reference(capsules);
      reference.SetView(bundle.Scene.Renderer, bundle.Actor);
      reference.Width *= Factor;
      reference.Height *= Factor;
      linesets::ReferenceImage image;
      reference.Render(image);
      const std::vector<double> expected = Average(image, Factor);
      const Deviation with = Compare(on, expected);
      const Deviation without = Compare(off, expected);
      std::cout << name << ": with coverage light " << with.Light << ", rms " << with.Rms
                << "; without " << without.Light << ", " << without.Rms << std::endl;
      check(std::abs(with.Light) <= 0.02, name + ": light of the reference");
      // As near at two pixels or one, where each pixel shows one place of a tube in both cases.
      const double part = width >= 1.0 ? 1.03 : (width > 0.0 ? 0.5 : 0.9);
      check(with.Rms < part * without.Rms, name + ": nearer to the truth");
      if (std::getenv("LINESETS_KEEP_PICTURES"))
      {
        WritePicture(on, std::string(directory) + "/Zoom " + name + ".png");
        WritePicture(off, std::string(directory) + "/Zoom " + name + ", point.png");
      }
    }
  }
  delete[] directory;
}
}

int TestVoxelLineMapperZoom(int argc, char* argv[])
{
  Checks check;
  const KeptDisplay display;
  CheckZooms(check);
  CheckLineModels(check);
  CheckShader(check);
  CheckAgainstReference(check, argc, argv);
  return check.GetResult();
}
