// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards what comes through the tubes along secondary rays, against all decoded segments one by one
// in double precision:
// - opaque lines: each ray is stopped, or not, as in the reference, wherever it starts: in the
// open,
//   in a tube, and on a tube's surface, inwards and outwards; the start's own stretch does not
//   count,
// - transparent lines: the product over the tubes that are entered, but for single rays at ends of
//   lines and at bends, and with the right mean,
// - lengths of rays, radii along a line, and opacities by table,
// - the same through the representative lines of a level, as wide as the level's voxels are.
#include "CapsulesFromModel.h"
#include "RayLayers.h"
#include "VoxelLineReferenceTesting.h"

#include "vtkLineVoxelizer.h"
#include "vtkVoxelLineLevel.h"
#include "vtkVoxelLineNativeEngine.h"

#include <map>

using namespace VoxelLineMapperTesting;

namespace
{
using Ray = vtkVoxelLineSecondaryRay;
using linesets::Capsule;
using linesets::CapsuleHit;

constexpr double Infinite = 1e30;
// As the traversal has them.
constexpr double SurfaceTolerance = 2e-3;
constexpr double LevelBias = 1.5;

/// Lines of a model, its segments in voxels, and its tubes' radius in voxels.
struct Tubes
{
  vtkSmartPointer<vtkVoxelLineModel> Model;
  std::vector<Capsule> Capsules;
  double Radius;
};

/// Segments of a model in units of its own voxels.
std::vector<Capsule> GetCapsules(vtkVoxelLineModel* model, double radius)
{
  const double size = model->GetVoxelSize();
  std::vector<Capsule> capsules = linesets::MakeCapsulesFromModel(model, radius * size).Capsules;
  for (Capsule& capsule : capsules)
  {
    for (int i = 0; i < 3; ++i)
    {
      capsule.Start[i] /= size;
      capsule.End[i] /= size;
    }
    capsule.StartRadius /= size;
    capsule.EndRadius /= size;
  }
  return capsules;
}

Tubes MakeTubes(vtkPolyData* lines, int resolution, int bins, double radius,
  const std::string& radiusArray = std::string())
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetResolution(resolution);
  voxelizer->SetFaceBins(bins);
  voxelizer->SetRadiusArrayName(radiusArray);
  voxelizer->Update();
  Tubes tubes;
  tubes.Model = voxelizer->GetOutput();
  tubes.Radius = tubes.Model->GetRadii()
    ? tubes.Model->GetMaximumRadius() / tubes.Model->GetVoxelSize()
    : radius;
  tubes.Capsules = GetCapsules(tubes.Model, radius);
  return tubes;
}

vtkVoxelLineFrame MakeFrame(const Tubes& tubes, double opacity)
{
  vtkVoxelLineFrame frame;
  frame.SecondaryRays = true;
  frame.Radius = static_cast<float>(tubes.Radius);
  frame.Opacity = static_cast<float>(opacity);
  frame.EarlyTermination = 2.0f;
  return frame;
}

glm::dvec3 RandomDirection(linesets::Random& random)
{
  while (true)
  {
    const glm::dvec3 d(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
    if (glm::length(d) > 0.1 && glm::length(d) < 1.0)
    {
      return glm::normalize(d);
    }
  }
}

/// Rays from anywhere within and around the grid, or from the surfaces of tubes, some of them
/// short.
std::vector<Ray> MakeRays(const Tubes& tubes, int count, bool onSurface, std::uint64_t seed)
{
  linesets::Random random(seed);
  std::vector<Ray> rays;
  const int* size = tubes.Model->GetDimensions();
  for (int i = 0; i < count; ++i)
  {
    glm::dvec3 origin;
    for (int k = 0; k < 3; ++k)
    {
      origin[k] = random.Uniform(-0.1, 1.1) * size[k];
    }
    if (onSurface)
    {
      const Capsule& capsule = tubes.Capsules[random.Next() % tubes.Capsules.size()];
      const double s = random.Uniform();
      glm::dvec3 at;
      for (int k = 0; k < 3; ++k)
      {
        at[k] = capsule.Start[k] + s * (capsule.End[k] - capsule.Start[k]);
      }
      // From far away towards the axis: the ray enters at the surface of the tube.
      const glm::dvec3 d = RandomDirection(random);
      const glm::dvec3 away = at - 100.0 * d;
      double entry;
      double exit;
      linesets::IntersectCapsule(capsule, &away[0], &d[0], entry, exit);
      origin = away + entry * d;
    }
    glm::dvec3 direction = RandomDirection(random);
    if (i % 7 == 0)
    {
      direction = glm::dvec3(0.0);
      direction[i % 3] = i % 2 ? 1.0 : -1.0;
    }
    const double end = i % 3 == 0 ? random.Uniform(0.5, 12.0) : Infinite;
    rays.push_back({ glm::vec3(origin), glm::vec3(direction), static_cast<float>(end) });
  }
  return rays;
}

/// All tubes, grown by some length, that a ray crosses ahead of its start.
std::vector<CapsuleHit> FindHits(const std::vector<Capsule>& capsules, const Ray& ray, double grown)
{
  const glm::dvec3 origin(ray.Origin);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(ray.Direction));
  std::vector<CapsuleHit> hits;
  for (std::size_t i = 0; i < capsules.size(); ++i)
  {
    Capsule capsule = capsules[i];
    capsule.StartRadius += grown;
    capsule.EndRadius += grown;
    CapsuleHit hit;
    if (linesets::IntersectCapsule(capsule, &origin[0], &direction[0], hit.Entry, hit.Exit) &&
      hit.Exit > 0.0)
    {
      hit.Curve = capsule.Curve;
      hit.Capsule = static_cast<vtkIdType>(i);
      hits.push_back(hit);
    }
  }
  return hits;
}

/// What the reference sees along a ray.
struct Truth
{
  int Own = 0;       // curves that hold the start
  int Stretches = 0; // stretches within curves that begin ahead of it
};

Truth FindTruth(const std::vector<Capsule>& capsules, const Ray& ray, double grown)
{
  std::vector<CapsuleHit> hits = FindHits(capsules, ray, grown);
  std::sort(hits.begin(), hits.end(),
    [](const CapsuleHit& a, const CapsuleHit& b) { return a.Entry < b.Entry; });
  std::map<vtkIdType, double> exits;
  Truth truth;
  for (const CapsuleHit& hit : hits)
  {
    const auto found = exits.find(hit.Curve);
    const bool prolongs = found != exits.end() && hit.Entry <= found->second;
    double& exit = exits[hit.Curve];
    exit = prolongs ? std::max(exit, hit.Exit) : hit.Exit;
    if (!prolongs)
    {
      truth.Own += hit.Entry <= SurfaceTolerance ? 1 : 0;
      truth.Stretches += hit.Entry > SurfaceTolerance && hit.Entry < ray.End ? 1 : 0;
    }
  }
  return truth;
}

void TestOpaque(Checks& check, const Tubes& tubes, bool onSurface, const std::string& name)
{
  const std::vector<Ray> rays = MakeRays(tubes, 4000, onSurface, 11);
  const std::vector<float> through =
    vtkVoxelLineNativeEngine::CastSecondaryRays(tubes.Model, MakeFrame(tubes, 1.0), rays);
  int stopped = 0;
  int wrong = 0;
  int ties = 0;
  int several = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const Truth truth = FindTruth(tubes.Capsules, rays[i], 0.0);
    const bool isStopped = truth.Stretches > 0;
    stopped += isStopped ? 1 : 0;
    if ((through[i] == 0.0f) == isStopped)
    {
      continue;
    }
    if (truth.Own > 1)
    {
      ++several;
      continue;
    }
    const double change = 2e-4;
    const bool isTie = (FindTruth(tubes.Capsules, rays[i], change).Stretches > 0) != isStopped ||
      (FindTruth(tubes.Capsules, rays[i], -change).Stretches > 0) != isStopped;
    ++(isTie ? ties : wrong);
  }
  std::cout << name << ": " << stopped << " of " << rays.size() << " stopped, " << wrong
            << " wrong, " << ties << " ties, " << several << " from within several curves\n";
  check(wrong == 0, name + ": rays are stopped as in the reference");
  check(ties <= 12 && several <= 80, name + ": few are left out");
  check(stopped > 400 && stopped < 3800, name + ": some are stopped");
}

void TestTransparent(Checks& check, const Tubes& tubes, bool onSurface, double largestPart,
  double largestMean, const std::string& name)
{
  const std::vector<Ray> rays = MakeRays(tubes, 4000, onSurface, 13);
  const double opacity = 0.2;
  const std::vector<float> through =
    vtkVoxelLineNativeEngine::CastSecondaryRays(tubes.Model, MakeFrame(tubes, opacity), rays);
  int differ = 0;
  double sum = 0.0;
  double squares = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const double expected =
      std::pow(1.0 - opacity, FindTruth(tubes.Capsules, rays[i], 0.0).Stretches);
    const double error = through[i] - expected;
    differ += std::abs(error) > 1e-4 ? 1 : 0;
    sum += error;
    squares += error * error;
    mean += expected;
  }
  const double count = static_cast<double>(rays.size());
  std::cout << name << ": mean " << mean / count << ", differing " << 100.0 * differ / count
            << " %, bias " << sum / count << ", RMS " << std::sqrt(squares / count) << "\n";
  check(differ <= largestPart * count, name + ": few rays differ");
  check(std::abs(sum / count) <= largestMean, name + ": the mean is right");
  check(mean / count < 0.95, name + ": some light is stopped");
}
/// Tubes that get wider and narrower along the line, and opacities by table.
void TestRadiiAndTable(Checks& check)
{
  const std::vector<Curve> curves = MakeStraightLines(60, 7);
  auto lines = MakeLines(curves);
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radii");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    radii->InsertNextValue(i % 2 ? 0.1 : 0.02);
  }
  lines->GetPointData()->AddArray(radii);
  const Tubes tubes = MakeTubes(lines, 24, 0, 0.0, "radii");
  check(tubes.Model->GetRadii() != nullptr, "there are radii");
  TestOpaque(check, tubes, false, "opaque, with radii");
  TestOpaque(check, tubes, true, "opaque, with radii, from surfaces");
  // Wide ends, which are round, do not count.
  TestTransparent(check, tubes, false, 0.08, 0.012, "transparent, with radii");

  // Bytes of the model are all 0 without an attribute; a table makes them half as opaque.
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetNumberOfComponents(2);
  bytes->SetNumberOfTuples(tubes.Model->GetNumberOfSegments());
  bytes->FillValue(7);
  tubes.Model->SetAttributes(bytes);
  tubes.Model->SetAttributeKind(vtkVoxelLineModel::Scalar);
  vtkVoxelLineFrame frame = MakeFrame(tubes, 0.4);
  const std::vector<Ray> rays = MakeRays(tubes, 1000, false, 17);
  const auto plain = vtkVoxelLineNativeEngine::CastSecondaryRays(tubes.Model, frame, rays);
  frame.Coloring = vtkVoxelLineFrame::Table;
  frame.ColorTable.fill(glm::vec4(1.0f));
  frame.ColorTable[7] = glm::vec4(1.0f, 1.0f, 1.0f, 0.5f);
  frame.Opacity = 0.8f;
  const auto byTable = vtkVoxelLineNativeEngine::CastSecondaryRays(tubes.Model, frame, rays);
  double worst = 0.0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    worst = std::max(worst, std::abs(static_cast<double>(plain[i]) - byTable[i]));
  }
  check(worst < 1e-5, "opacity by table is that of the property");
}

/// Whether the line enters a tube of one radius elsewhere than through the spheres at its ends.
bool EntersWall(const Capsule& capsule, const Ray& ray, double entry)
{
  double along = 0.0;
  double length2 = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double axis = capsule.End[k] - capsule.Start[k];
    along += axis * (ray.Origin[k] + entry * ray.Direction[k] - capsule.Start[k]);
    length2 += axis * axis;
  }
  return along >= 0.0 && along < length2;
}

void TestLevel(
  Checks& check, const Tubes& tubes, int level, double opacity, const std::string& name)
{
  vtkNew<vtkVoxelLineLevel> filter;
  filter->SetInputDataObject(tubes.Model);
  filter->SetLevel(level);
  filter->Update();
  vtkVoxelLineModel* levelModel = filter->GetOutput();
  // In voxels of the level, tubes have the radius that they have in those of the model.
  const std::vector<Capsule> capsules = GetCapsules(levelModel, tubes.Radius);
  const double width = std::ldexp(1.0, level);

  vtkVoxelLineFrame frame = MakeFrame(tubes, opacity);
  frame.LevelRays = true;
  frame.ShadowLevel = level;
  const std::vector<Ray> rays = MakeRays(tubes, 3000, true, 19);
  const auto through =
    vtkVoxelLineNativeEngine::CastSecondaryRays(tubes.Model, frame, rays, levelModel);
  int wrong = 0;
  int stopped = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    Ray ray = rays[i];
    ray.Origin /= static_cast<float>(width);
    ray.End /= static_cast<float>(width);
    double expected = 1.0;
    double nearest = 1.0;
    for (const CapsuleHit& hit : FindHits(capsules, ray, 0.0))
    {
      const bool counts = hit.Entry > LevelBias && hit.Entry < ray.End &&
        (opacity >= 1.0 || EntersWall(capsules[hit.Capsule], ray, hit.Entry));
      expected *= counts ? 1.0 - opacity : 1.0;
      nearest = std::min(nearest, std::abs(hit.Entry - LevelBias));
    }
    stopped += expected < 1.0 ? 1 : 0;
    wrong += std::abs(expected - through[i]) > 1e-4 && nearest > 1e-3 ? 1 : 0;
  }
  std::cout << name << ": " << stopped << " of " << rays.size() << " dimmed, " << wrong
            << " wrong\n";
  // Single rays graze a tube or pass its seam.
  check(wrong <= 3, name + ": rays are dimmed as in the reference");
  check(stopped > 500, name + ": some are dimmed");

  const auto without = vtkVoxelLineNativeEngine::CastSecondaryRays(tubes.Model, frame, rays);
  check(*std::min_element(without.begin(), without.end()) == 1.0f, name + ": nothing without it");
}

void TestSwitches(Checks& check, const Tubes& tubes)
{
  vtkVoxelLineFrame frame = MakeFrame(tubes, 1.0);
  frame.SecondaryRays = false;
  const std::vector<Ray> rays = MakeRays(tubes, 100, true, 23);
  const auto off = vtkVoxelLineNativeEngine::CastSecondaryRays(tubes.Model, frame, rays);
  check(*std::min_element(off.begin(), off.end()) == 1.0f, "nothing is stopped where it is off");
}
}

int TestVoxelLineOcclusionRays(int, char*[])
{
  Checks check;
  auto messages = Listen();
  const Tubes straight = MakeTubes(MakeLines(MakeStraightLines(60, 5)), 24, 0, 0.6);
  const Tubes bent = MakeTubes(MakeLines(MakeBundle(20, 80, 6)), 24, 32, 0.6);
  TestOpaque(check, straight, false, "opaque, straight");
  TestOpaque(check, straight, true, "opaque, straight, from surfaces");
  TestOpaque(check, bent, false, "opaque, bent");
  TestOpaque(check, bent, true, "opaque, bent, from surfaces");
  TestTransparent(check, straight, false, 0.03, 0.005, "transparent, straight");
  TestTransparent(check, straight, true, 0.03, 0.005, "transparent, straight, from surfaces");
  TestTransparent(check, bent, false, 0.08, 0.003, "transparent, bent");
  TestTransparent(check, bent, true, 0.08, 0.003, "transparent, bent, from surfaces");
  TestRadiiAndTable(check);
  for (int level = 1; level <= 2; ++level)
  {
    TestLevel(check, bent, level, 1.0, "level " + std::to_string(level) + ", opaque");
    TestLevel(check, bent, level, 0.3, "level " + std::to_string(level) + ", transparent");
  }
  TestSwitches(check, bent);
  check(messages->IsQuiet(), "nothing is said");
  return check.GetResult();
}
