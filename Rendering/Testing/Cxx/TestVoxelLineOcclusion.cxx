// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the spherical ambient occlusion of voxels:
// - against 2500 rays through all tubes in double precision, from points on the segments of each
//   voxel, within 15 voxels: straight lines, bent ones, and sparse ones, on grids whose sides are
//   no multiples of a brick's,
// - a single line is hardly occluded, the middle of a dense block wholly; a larger radius takes
//   more; without extinction there is none,
// - voxels without lines, and those that are left out where there are few, lie between their
//   neighbours,
// - the same for any number of threads and all backends; built again when something changed and not
//   otherwise; stopped through the progress function; models that are empty or of a single voxel,
//   with the largest radius.
#include "BruteForceLight.h"
#include "Random.h"
#include "VoxelLineReferenceTesting.h"

#include "vtkDataArray.h"
#include "vtkLineVoxelizer.h"
#include "vtkSMPTools.h"
#include "vtkVoxelLineDensities.h"
#include "vtkVoxelLineOcclusion.h"

using namespace VoxelLineMapperTesting;
using BruteForceLight::Errors;

namespace
{
constexpr double TubeRadius = 0.5;
// Twice the radius, times the mean sine of the angle between a ray and a line.
constexpr double Extinction = 2.0 * TubeRadius * 0.25 * Pi;

/// A model with its densities.
struct Lines
{
  vtkSmartPointer<vtkVoxelLineModel> Model;
  vtkNew<vtkVoxelLineDensities> Densities;

  Lines(vtkPolyData* data, int resolution)
  {
    vtkNew<vtkLineVoxelizer> voxelizer;
    voxelizer->SetInputData(data);
    voxelizer->SetResolution(resolution);
    voxelizer->Update();
    this->Model = voxelizer->GetOutput();
    this->Densities->Build(this->Model);
  }

  std::vector<std::uint8_t> Build(double radius, double extinction = Extinction)
  {
    vtkVoxelLineOcclusion occlusion;
    occlusion.Build(this->Model, this->Densities, radius, extinction);
    return occlusion.GetValues();
  }

  /// The brick of a voxel; -1: there is none.
  int GetBrick(const glm::ivec3& voxel) const
  {
    int bricks[3];
    this->Model->GetBrickDimensions(bricks);
    const glm::ivec3 cell = voxel / 4;
    return static_cast<int>(this->Model->GetBrickGrid()->GetComponent(
      cell.x + bricks[0] * (cell.y + bricks[1] * cell.z), 0));
  }

  bool IsOccupied(const glm::ivec3& voxel) const
  {
    return this->Densities->GetVoxel(0, voxel.x, voxel.y, voxel.z) > 0.0f;
  }

  std::vector<glm::ivec3> FindOccupied() const
  {
    std::vector<glm::ivec3> voxels;
    const int* size = this->Model->GetDimensions();
    for (int i = 0; i < size[0] * size[1] * size[2]; ++i)
    {
      const glm::ivec3 voxel(i % size[0], i / size[0] % size[1], i / size[0] / size[1]);
      if (this->IsOccupied(voxel))
      {
        voxels.push_back(voxel);
      }
    }
    return voxels;
  }

  double At(const std::vector<std::uint8_t>& values, const glm::ivec3& voxel) const
  {
    const int brick = this->GetBrick(voxel);
    return brick < 0
      ? 0.0
      : values[64 * brick + voxel.x % 4 + 4 * (voxel.y % 4) + 16 * (voxel.z % 4)] / 255.0;
  }
};

/// Squeezes a cube, so that the sides of its grid are unequal.
vtkSmartPointer<vtkPolyData> Squeeze(std::vector<Curve> curves)
{
  for (Curve& curve : curves)
  {
    for (Point& point : curve)
    {
      point[1] *= 0.73;
      point[2] *= 0.61;
    }
  }
  return MakeLines(curves);
}

/// The mean over points on the segments of some voxels of what a ray each way meets.
Errors CompareWithRays(const Lines& lines, const std::vector<std::uint8_t>& values, double radius)
{
  constexpr std::size_t voxelsToTry = 50;
  constexpr int pointsPerVoxel = 3;
  const BruteForceLight::Tubes tubes(lines.Model, TubeRadius);
  const BruteForceLight::Directions sphere = BruteForceLight::MakeSphere(2500);
  const std::vector<linesets::Capsule>& capsules = tubes.GetCapsules();
  std::vector<double> truth(voxelsToTry, 0.0);
  std::vector<glm::ivec3> voxels(voxelsToTry);
  vtkSMPTools::For(0, voxelsToTry, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        linesets::Random random(3, i);
        const auto middleOf = [](const linesets::Capsule& capsule)
        {
          return 0.5 *
            (glm::dvec3(capsule.Start[0], capsule.Start[1], capsule.Start[2]) +
              glm::dvec3(capsule.End[0], capsule.End[1], capsule.End[2]));
        };
        voxels[i] = glm::ivec3(glm::floor(middleOf(capsules[random.Next() % capsules.size()])));
        std::vector<const linesets::Capsule*> inside;
        for (const linesets::Capsule& capsule : capsules)
        {
          if (glm::ivec3(glm::floor(middleOf(capsule))) == voxels[i])
          {
            inside.push_back(&capsule);
          }
        }
        for (int k = 0; k < pointsPerVoxel; ++k)
        {
          const linesets::Capsule& capsule = *inside[random.Next() % inside.size()];
          const double s = random.Uniform();
          glm::dvec3 point;
          for (int axis = 0; axis < 3; ++axis)
          {
            point[axis] = capsule.Start[axis] + s * (capsule.End[axis] - capsule.Start[axis]);
          }
          truth[i] += tubes.GetBlockedPart(point, sphere, radius) / pointsPerVoxel;
        }
      }
    });
  Errors errors;
  for (std::size_t i = 0; i < voxelsToTry; ++i)
  {
    errors.Add(lines.At(values, voxels[i]), truth[i]);
  }
  return errors;
}

void TestAgainstRays(Checks& check)
{
  struct Scene
  {
    std::string Name;
    std::vector<Curve> Curves;
    double LargestRmse;
    double LargestBias;
  };
  const std::vector<Scene> scenes = { { "random straight lines", MakeStraightLines(500, 5), 0.085,
                                        0.06 },
    { "bundle", MakeBundle(60, 80, 6), 0.085, 0.06 },
    { "sparse lines", MakeStraightLines(40, 7), 0.085, 0.06 } };
  bool isCut = false;
  for (const Scene& scene : scenes)
  {
    Lines lines(Squeeze(scene.Curves), 61);
    const int* size = lines.Model->GetDimensions();
    isCut = isCut || (size[0] % 4 != 0 && size[1] % 4 != 0 && size[2] % 4 != 0);
    const Errors errors = CompareWithRays(lines, lines.Build(15.0), 15.0);
    std::cout << scene.Name << ": occlusion " << errors.GetMeanTruth() << ", bias "
              << errors.GetBias() << ", RMSE " << errors.GetRmse() << "\n";
    check(errors.GetRmse() < scene.LargestRmse && std::abs(errors.GetBias()) < scene.LargestBias,
      scene.Name + ": occlusion is that of rays");
  }
  check(isCut, "bricks at all borders are cut");
}

/// Parallel lines next to each other in a block.
std::vector<Curve> MakeBlock(int linesPerSide)
{
  std::vector<Curve> block;
  for (int i = 0; i < linesPerSide * linesPerSide; ++i)
  {
    const double y = 2.0 * (i % linesPerSide) / (linesPerSide - 1) - 1.0;
    const double z = 2.0 * (i / linesPerSide) / (linesPerSide - 1) - 1.0;
    block.push_back({ { -1.0, y, z }, { 1.0, y, z } });
  }
  return block;
}

void TestExtremes(Checks& check)
{
  for (const Point& end : { Point{ 1.0, 0.0, 0.0 }, Point{ 1.0, 0.7, 0.4 } })
  {
    Lines single(MakeLines({ { { -1.0, -0.3, -0.2 }, end } }), 50);
    const std::vector<std::uint8_t> values = single.Build(15.0);
    const double largest = *std::max_element(values.begin(), values.end()) / 255.0;
    std::cout << "single line: largest occlusion " << largest << "\n";
    check(!values.empty() && largest < 0.2, "a single line is hardly occluded");
  }

  Lines block(MakeLines(MakeBlock(41)), 40);
  const std::vector<std::uint8_t> values = block.Build(15.0);
  const double centre = block.At(values, glm::ivec3(20, 20, 20));
  const double corner = block.At(values, glm::ivec3(0, 0, 0));
  std::cout << "block: centre " << centre << ", corner " << corner << "\n";
  check(centre > 0.98, "the centre of a dense block gets no light");
  check(corner < 0.5, "its corner gets some");

  Lines medium(Squeeze(MakeStraightLines(200, 8)), 61);
  const std::vector<glm::ivec3> voxels = medium.FindOccupied();
  double last = 0.0;
  for (const double radius : { 1.0, 5.0, 15.0, 40.0 })
  {
    const std::vector<std::uint8_t> occlusion = medium.Build(radius);
    double mean = 0.0;
    for (const glm::ivec3& voxel : voxels)
    {
      mean += medium.At(occlusion, voxel) / static_cast<double>(voxels.size());
    }
    std::cout << "radius " << radius << ": mean occlusion " << mean << "\n";
    check(mean > last + 0.005, "a larger radius takes more light");
    last = mean;
  }
  const std::vector<std::uint8_t> none = medium.Build(15.0, 0.0);
  check(!none.empty() && *std::max_element(none.begin(), none.end()) == 0,
    "without extinction there is no occlusion");
}

/// Smallest and largest value of the voxels with lines around one in its brick. Returns whether one
/// of them is of those that are always computed.
bool GetRange(const Lines& lines, const std::vector<std::uint8_t>& values, const glm::ivec3& voxel,
  double range[2])
{
  range[0] = 2.0;
  range[1] = -1.0;
  bool isComputed = false;
  for (int i = 0; i < 27; ++i)
  {
    const glm::ivec3 other = voxel + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
    if (glm::all(glm::greaterThanEqual(other, glm::ivec3(0))) && other / 4 == voxel / 4 &&
      lines.IsOccupied(other))
    {
      range[0] = std::min(range[0], lines.At(values, other));
      range[1] = std::max(range[1], lines.At(values, other));
      isComputed = isComputed || (other.x + other.y + other.z) % 2 == 0;
    }
  }
  return isComputed;
}

void TestGaps(Checks& check)
{
  Lines lines(Squeeze(MakeStraightLines(300, 9)), 61);
  const std::vector<std::uint8_t> values = lines.Build(15.0);
  const int* size = lines.Model->GetDimensions();
  const double byte = 1.01 / 255.0;
  int gaps = 0;
  int wrong = 0;
  int dark = 0;
  for (int i = 0; i < size[0] * size[1] * size[2]; ++i)
  {
    const glm::ivec3 voxel(i % size[0], i / size[0] % size[1], i / size[0] / size[1]);
    if (lines.GetBrick(voxel) < 0 || lines.IsOccupied(voxel))
    {
      continue;
    }
    const double value = lines.At(values, voxel);
    // Nothing of a medium like this is without any occlusion.
    dark += value < 0.05 ? 1 : 0;
    double range[2];
    if (GetRange(lines, values, voxel, range))
    {
      ++gaps;
      wrong += value < range[0] - byte || value > range[1] + byte ? 1 : 0;
    }
  }
  check(gaps > 10000 && wrong == 0, "gaps lie between their neighbours");
  check(dark < gaps / 100, "gaps have values");
}

void TestThreads(Checks& check)
{
  Lines lines(Squeeze(MakeStraightLines(300, 9)), 61);
  const std::string backend = vtkSMPTools::GetBackend();
  check(vtkSMPTools::SetBackend("Sequential"), "the sequential backend");
  const std::vector<std::uint8_t> expected = lines.Build(15.0);
  check(expected.size() > 50000, "enough for many tasks");
  for (const char* name : { "STDThread", "TBB", "OpenMP" })
  {
    if (!vtkSMPTools::SetBackend(name))
    {
      continue;
    }
    for (const int threads : { 1, 2, 5 })
    {
      vtkSMPTools::Initialize(threads);
      check(lines.Build(15.0) == expected,
        "the same with " + std::string(name) + ", " + std::to_string(threads) + " threads");
    }
    vtkSMPTools::Initialize(0);
  }
  vtkSMPTools::SetBackend(backend.c_str());
}

void TestChanges(Checks& check)
{
  Lines lines(Squeeze(MakeStraightLines(100, 10)), 40);
  vtkVoxelLineOcclusion occlusion;
  check(occlusion.GetBuildTime() == 0 && occlusion.GetValues().empty(), "nothing at first");
  vtkMTimeType time = 0;
  std::vector<std::uint8_t> values;
  const auto build = [&](double radius, double extinction, bool changes, const std::string& name)
  {
    check(
      occlusion.Build(lines.Model, lines.Densities, radius, extinction), name + ": it is built");
    check((occlusion.GetBuildTime() != time) == changes, name + ": whether it is built again");
    check((occlusion.GetValues() != values) == changes, name + ": whether the values change");
    time = occlusion.GetBuildTime();
    values = occlusion.GetValues();
  };
  build(15.0, Extinction, true, "the first time");
  build(15.0, Extinction, false, "no change");
  build(8.0, Extinction, true, "another radius");
  build(8.0, 0.5 * Extinction, true, "another extinction");
  lines.Densities->Build(lines.Model);
  build(8.0, 0.5 * Extinction, false, "densities that did not change");
  lines.Densities->SetOpacity(0.4);
  lines.Densities->Build(lines.Model);
  build(8.0, 0.5 * Extinction, true, "another opacity");
  const Lines other(MakeLines(MakeBundle(10, 50, 3)), 30);
  lines.Model->ShallowCopy(other.Model);
  lines.Densities->Build(lines.Model);
  build(8.0, 0.5 * Extinction, true, "another content of the model");

  // Stopped half-way.
  double told = 0.0;
  const auto stop = [&told](double done)
  {
    told = done;
    return done < 0.5;
  };
  check(!occlusion.Build(lines.Model, lines.Densities, 9.0, Extinction, stop) && told >= 0.5 &&
      told < 0.7,
    "a build that is stopped tells so");
  check(occlusion.GetValues().empty() && occlusion.GetBuildTime() == 0, "and leaves nothing");
  std::vector<double> steps;
  check(occlusion.Build(lines.Model, lines.Densities, 8.0, 0.5 * Extinction,
          [&steps](double done)
          {
            steps.push_back(done);
            return true;
          }) &&
      occlusion.GetValues() == values,
    "the next build is whole");
  check(steps.size() > 4 && std::is_sorted(steps.begin(), steps.end()) && steps.back() == 1.0,
    "progress goes up to 1");
  occlusion.Initialize();
  check(occlusion.GetValues().empty() && occlusion.GetBuildTime() == 0, "values are forgotten");
}

/// Models too small for coarser levels, and radii far beyond them.
void TestSmallModels(Checks& check)
{
  vtkVoxelLineOcclusion occlusion;
  vtkNew<vtkVoxelLineModel> empty;
  vtkNew<vtkVoxelLineDensities> none;
  none->Build(empty);
  check(occlusion.Build(empty, none, 15.0, Extinction) && occlusion.GetValues().empty(),
    "an empty model");
  for (const int resolution : { 1, 2, 3, 4, 5, 9 })
  {
    Lines lines(MakeLines(MakeBundle(6, 40, 4)), resolution);
    const std::string name = "resolution " + std::to_string(resolution);
    const std::vector<std::uint8_t> values = lines.Build(15.0);
    check(values.size() == 64 * static_cast<std::size_t>(lines.Model->GetNumberOfBricks()) &&
        !values.empty(),
      name + ": a value for each voxel");
    // All there is lies within 20 voxels, so that no radius adds to it.
    check(lines.Build(60.0) == lines.Build(20.0), name + ": nothing comes from beyond the grid");
    check(lines.Build(4096.0) == lines.Build(20.0), name + ": the largest radius");
  }
  // A line of one voxel's length has nothing around it.
  Lines shortLine(MakeLines({ { { 0.0, 0.0, 0.0 }, { 0.1, 0.05, 0.02 } } }), 1);
  const std::vector<std::uint8_t> values = shortLine.Build(15.0);
  check(values.size() == 64 && *std::max_element(values.begin(), values.end()) == 0,
    "a line in one voxel");
}
}

int TestVoxelLineOcclusion(int, char*[])
{
  Checks check;
  auto messages = Listen();
  TestAgainstRays(check);
  TestExtremes(check);
  TestGaps(check);
  TestThreads(check);
  TestChanges(check);
  TestSmallModels(check);
  check(messages->IsQuiet(), "nothing is said");
  return check.GetResult();
}
