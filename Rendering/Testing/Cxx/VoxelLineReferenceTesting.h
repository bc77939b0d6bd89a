// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of vtkVoxelLineMapper against the reference renderer share: a window in which one
 * case after the other is drawn, by the mapper and by the reference, and the bounds of their
 * difference.
 */

#ifndef VoxelLineReferenceTesting_h
#define VoxelLineReferenceTesting_h

#include "CapsulesFromModel.h"
#include "ImageMeasures.h"
#include "Random.h"
#include "ReferenceRenderer.h"
#include "VoxelLineMapperTesting.h"

#include "vtkImageData.h"
#include "vtkPNGWriter.h"
#include "vtkTestUtilities.h"
#include "vtkWindowToImageFilter.h"

#include <functional>

namespace VoxelLineMapperTesting
{
constexpr double Pi = 3.14159265358979323846;

/// A line set, how it is voxelized and drawn, and from where it is seen.
struct ReferenceCase
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Lines;
  /// In voxels.
  double Radius = 0.5;
  double Opacity = 1.0;
  int Resolution = 16;
  int FaceBins = 32;
  std::string RadiusArray;
  int Width = 200;
  int Height = 150;
  /// Changes to the mapper and actor, before the model is made.
  std::function<void(vtkVoxelLineMapper*, vtkActor*)> Place;
  /// Changes to the camera, which sees all of the lines from the side; it can ask for the model.
  std::function<void(vtkCamera*, vtkVoxelLineModel*)> View;
  /// Changes to the reference's scene.
  std::function<void(linesets::CapsuleScene&)> Adapt;
  /**
   * Single pixels that may differ by more than the bound. A ray that touches a tube at its edge, or
   * passes the seam between two segments, may hit in double precision and miss in single precision,
   * or the other way round. This is so for rays closer than about 1e-5 voxels to it, of which an
   * image has hardly ever more than one or two, as pixels are about a tenth of a voxel wide.
   */
  int EdgePixels = 3;
  /**
   * Leave out pixels that the reference itself shows otherwise where radii differ by up to 0.0001
   * voxels, and how large a part of the picture these may be; 0: none are left out. A ray that
   * starts inside a tube sees the far wall of the segment that it entered first. Segments share a
   * sphere at their joint: where the ray came in through that sphere, behind its start, both are
   * entered at once, and rounding decides between them, in double precision as well. In a straight
   * tube this is so near the circle in which the sphere touches the wall.
   */
  double PartOfTies = 0.0;
  /// Whether the bounds hold; false where the reference shows something else than the model.
  bool IsExact = true;
};

/// What the reference saw, for checks that a case is what its name says.
struct ReferenceResult
{
  linesets::CapsuleScene Scene;
  linesets::ReferenceImage Image;
  int MostLayers = 0;
  vtkNew<vtkImageData> Ours;
  vtkNew<vtkImageData> Theirs;

  int LayersAt(int x, int y) const { return this->Image.Layers[this->Image.Width * y + x]; }
};

/// One window for all cases of a test.
class ReferenceStage
{
public:
  ReferenceStage(Checks& check, int argc, char* argv[])
    : Check(check)
  {
    char* directory =
      vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
    this->Directory = directory;
    delete[] directory;
  }

  /// Draws a case in both ways and checks that the pictures agree.
  void Run(const ReferenceCase& what, ReferenceResult& result)
  {
    vtkNew<vtkVoxelLineMapper> mapper;
    mapper->SetEngineToNative();
    mapper->SetEarlyTermination(1.0);
    // The reference, too, shows what lies at a pixel's centre, with the light of a surface, however
    // thin the tubes are. TestVoxelLineMapperZoom compares what is averaged over pixels.
    mapper->SubPixelCoverageOff();
    mapper->SetInputData(what.Lines);
    mapper->SetResolution(what.Resolution);
    mapper->SetFaceBins(what.FaceBins);
    mapper->SetRadiusArrayName(what.RadiusArray);
    auto actor = this->Scene.Add(mapper, what.Opacity);
    vtkProperty* property = actor->GetProperty();
    property->SetColor(1.0, 0.6, 0.2);
    property->SetAmbient(0.15);
    property->SetDiffuse(0.8);
    property->SetSpecular(0.3);
    property->SetSpecularPower(12.0);
    if (what.Place)
    {
      what.Place(mapper, actor);
    }
    vtkVoxelLineModel* model = mapper->GetModel();
    mapper->SetRadius(what.Radius * model->GetVoxelSize());
    this->Look(what, model);

    this->Scene.Window->Render();
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(this->Scene.Window);
    grab->SetInputBufferTypeToRGB();
    grab->ShouldRerenderOff();
    grab->Update();
    result.Ours->DeepCopy(grab->GetOutput());

    result.Scene = linesets::MakeCapsulesFromModel(model, mapper->GetRadius());
    if (what.Adapt)
    {
      what.Adapt(result.Scene);
    }
    linesets::ReferenceRenderer reference(result.Scene);
    reference.SetView(this->Scene.Renderer, actor);
    reference.Render(result.Image);
    result.Image.ToImageData(result.Theirs);
    result.MostLayers = *std::max_element(result.Image.Layers.begin(), result.Image.Layers.end());
    if (what.PartOfTies > 0.0)
    {
      this->LeaveOutTies(what, actor, 1e-4 * model->GetVoxelSize(), result);
    }
    this->Judge(what, result);
    this->Scene.Renderer->RemoveActor(actor);
    mapper->ReleaseGraphicsResources(this->Scene.Window);
  }

  void Run(const ReferenceCase& what)
  {
    ReferenceResult result;
    this->Run(what, result);
  }

private:
  void Look(const ReferenceCase& what, vtkVoxelLineModel* model)
  {
    this->Scene.Window->SetSize(what.Width, what.Height);
    vtkNew<vtkCamera> camera;
    this->Scene.Renderer->SetActiveCamera(camera);
    camera->SetPosition(0.5, 0.3, 1.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    this->Scene.Renderer->ResetCamera();
    camera->Zoom(1.4);
    this->Scene.Renderer->ResetCameraClippingRange();
    if (what.View)
    {
      what.View(camera, model);
    }
  }

  // Makes pixels equal that the reference cannot decide.
  void LeaveOutTies(
    const ReferenceCase& what, vtkActor* actor, double change, ReferenceResult& result)
  {
    vtkIdType ties = 0;
    const vtkIdType pixels = result.Theirs->GetNumberOfPoints();
    std::vector<char> isTie(static_cast<std::size_t>(pixels), 0);
    auto* theirs = static_cast<unsigned char*>(result.Theirs->GetScalarPointer());
    auto* ours = static_cast<unsigned char*>(result.Ours->GetScalarPointer());
    for (int round = 0; round < 6; ++round)
    {
      linesets::CapsuleScene scene = result.Scene;
      linesets::Random random(7, static_cast<std::uint64_t>(round));
      for (linesets::Capsule& capsule : scene.Capsules)
      {
        const double grown = random.Uniform(-change, change);
        capsule.StartRadius += grown;
        capsule.EndRadius += grown;
      }
      linesets::ReferenceRenderer reference(scene);
      reference.SetView(this->Scene.Renderer, actor);
      linesets::ReferenceImage image;
      reference.Render(image);
      vtkNew<vtkImageData> changed;
      image.ToImageData(changed);
      const auto* bytes = static_cast<unsigned char*>(changed->GetScalarPointer());
      for (vtkIdType i = 0; i < 3 * pixels; ++i)
      {
        isTie[i / 3] |= std::abs(int(bytes[i]) - int(theirs[i])) > 1 ? 1 : 0;
      }
    }
    for (vtkIdType i = 0; i < pixels; ++i)
    {
      if (isTie[i])
      {
        ++ties;
        std::copy_n(theirs + 3 * i, 3, ours + 3 * i);
      }
    }
    const double part = static_cast<double>(ties) / static_cast<double>(pixels);
    std::cout << what.Name << ": part of ties " << part << std::endl;
    this->Check(part <= what.PartOfTies, what.Name + ": part of ties " + std::to_string(part));
  }

  void Judge(const ReferenceCase& what, const ReferenceResult& result)
  {
    const linesets::ImageDifference difference =
      linesets::CompareImages(result.Ours, result.Theirs);
    const auto covered = std::count_if(result.Image.Layers.begin(), result.Image.Layers.end(),
      [](int layers) { return layers > 0; });
    std::ostringstream text;
    text << what.Name << ": rms " << 255.0 * difference.Rmse << ", largest " << difference.Largest
         << " at " << difference.LargestPixel[0] << " " << difference.LargestPixel[1] << ", "
         << difference.DifferentPixels << " pixels above 2, covered " << covered << ", layers "
         << result.MostLayers;
    std::cout << text.str() << std::endl;
    bool good =
      this->Check(!what.IsExact || 255.0 * difference.Rmse <= 2.0, "rms at most 2: " + text.str());
    good &= this->Check(!what.IsExact || difference.DifferentPixels <= what.EdgePixels,
      "differences of at most 2, but for single pixels at edges: " + text.str());
    good &= this->Check(covered >= what.Width * what.Height / 200, "is seen: " + text.str());
    if (!good || std::getenv("LINESETS_KEEP_PICTURES"))
    {
      std::string name = what.Name;
      std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ' ' || c == ',' || c == '/'; }, '_');
      name = this->Directory + "/Reference_" + name;
      Write(result.Ours, name + ".png");
      Write(result.Theirs, name + "_reference.png");
      linesets::WriteDifferenceImage(result.Ours, result.Theirs, 20.0, name + "_difference.png");
    }
  }

  static void Write(vtkImageData* image, const std::string& name)
  {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(name.c_str());
    writer->Write();
  }

  Checks& Check;
  std::string Directory;
  Stage Scene;
};

/// Smooth random curves in a cube of side 2 around the origin: sums of two waves per coordinate.
inline std::vector<Curve> MakeBundle(int curves, int points, std::uint64_t seed)
{
  std::vector<Curve> bundle(static_cast<std::size_t>(curves));
  for (int i = 0; i < curves; ++i)
  {
    linesets::Random random(seed, static_cast<std::uint64_t>(i));
    double phase[3];
    double frequency[3];
    for (int k = 0; k < 3; ++k)
    {
      phase[k] = random.Uniform(0.0, 2.0 * Pi);
      frequency[k] = random.Uniform(2.0, 6.0);
    }
    for (int j = 0; j < points; ++j)
    {
      const double s = static_cast<double>(j) / (points - 1);
      Point x;
      for (int k = 0; k < 3; ++k)
      {
        x[k] = 0.7 * std::sin(phase[k] + frequency[k] * s) +
          0.3 * std::sin(2.0 * phase[k] + 2.3 * frequency[k] * s);
      }
      bundle[i].push_back(x);
    }
  }
  return bundle;
}

/// Random straight lines in a cube of side 2 around the origin.
inline std::vector<Curve> MakeStraightLines(int curves, std::uint64_t seed)
{
  std::vector<Curve> lines(static_cast<std::size_t>(curves));
  for (int i = 0; i < curves; ++i)
  {
    linesets::Random random(seed, static_cast<std::uint64_t>(i));
    for (int end = 0; end < 2; ++end)
    {
      Point x;
      for (double& coordinate : x)
      {
        coordinate = random.Uniform(-1.0, 1.0);
      }
      lines[i].push_back(x);
    }
  }
  return lines;
}

/// A helix about the y axis with its radius and height, or a circle with height 0.
inline Curve MakeHelix(double radius, double height, double turns, int points)
{
  Curve curve;
  for (int i = 0; i < points; ++i)
  {
    const double s = static_cast<double>(i) / (points - 1);
    const double angle = 2.0 * Pi * turns * s;
    curve.push_back({ radius * std::cos(angle), height * (s - 0.5), radius * std::sin(angle) });
  }
  return curve;
}
}

#endif
