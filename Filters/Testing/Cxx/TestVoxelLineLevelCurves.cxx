// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the representative lines of vtkVoxelLineLevel on whole sets of curves: every level is what
 * the definition gives, worked out here from the decoded segments by other means; neither the
 * direction nor the order of the curves matters, nor the number of threads; ends on a common face
 * meet; and the levels stay as close to the curves of a smooth flow as their voxels are small.
 */

#include "VoxelLineTesting.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkVoxelLineLevel.h"

#include <set>

using namespace VoxelLineTesting;

namespace
{

using Voxel = std::array<int, 3>;

vtkSmartPointer<vtkVoxelLineModel> MakeLevel(Checks& check, vtkVoxelLineModel* model, int level)
{
  vtkNew<vtkVoxelLineLevel> filter;
  filter->SetInputData(model);
  filter->SetLevel(level);
  filter->Update();
  check(filter->GetOutput()->FindDefect().empty(), "no defect");
  return filter->GetOutput();
}

/// The passage of a curve through a voxel of a level, in coordinates of that voxel.
struct Passage
{
  Point Start;
  Point End;
  vtkIdType Curve;
};

/// The passages of each voxel, found by walking along each curve. A curve that only touches a face
/// from inside, so that it leaves and comes back by the same point, is still in its passage. What
/// ends where it begins is left out where the curve has other passages.
std::map<Voxel, std::vector<Passage>> FindPassages(
  Checks& check, vtkVoxelLineModel* model, int level)
{
  std::map<Voxel, std::vector<Passage>> passages;
  const std::vector<Segment> segments = DecodeModel(model);
  for (vtkIdType curve = 0; curve < model->GetNumberOfCurves(); ++curve)
  {
    const std::vector<Segment> chain = Chain(segments, curve);
    check(!chain.empty(), "a chain for each curve");
    Voxel last = { -1, -1, -1 };
    for (const Segment& segment : chain)
    {
      Voxel voxel;
      Point corner;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        voxel[axis] = segment.Voxel[axis] / (1 << level);
        corner[axis] = voxel[axis];
      }
      const double scale = std::pow(0.5, level);
      const Point start = scale * segment.Start - corner;
      std::vector<Passage>& here = passages[voxel];
      if (voxel != last && (here.empty() || here.back().Curve != curve || here.back().End != start))
      {
        here.push_back({ start, {}, curve });
      }
      here.back().End = scale * segment.End - corner;
      last = voxel;
    }
  }
  for (auto& entry : passages)
  {
    const std::vector<Passage> all = entry.second;
    const auto isClosed = [](const Passage& passage) { return passage.Start == passage.End; };
    entry.second.clear();
    for (const Passage& passage : all)
    {
      const bool hasOther = std::any_of(all.begin(), all.end(),
        [&](const Passage& other) { return other.Curve == passage.Curve && !isClosed(other); });
      if (!isClosed(passage) || !hasOther)
      {
        entry.second.push_back(passage);
      }
    }
  }
  return passages;
}

struct MeanLine
{
  std::array<Point, 2> Ends;
  /// 2 axis + side, or -1.
  std::array<int, 2> Faces;
};

double SnapTo(double coordinate, int bins)
{
  return bins == 0 ? coordinate
                   : (std::min(std::floor(coordinate * bins), bins - 1.0) + 0.5) / bins;
}

/// Put a mean on the boundary, or into the bin inside, as the documentation says.
void Snap(vtkVoxelLineModel* model, bool isInside, Point& point, int& face)
{
  const int bins = isInside ? model->GetInteriorBins() : model->GetFaceBins();
  face = -1;
  double nearest = 10.0;
  for (std::size_t axis = 0; axis < 3 && !isInside; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      if (std::abs(point[axis] - side) < nearest)
      {
        nearest = std::abs(point[axis] - side);
        face = static_cast<int>(2 * axis) + side;
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    double& coordinate = point[static_cast<std::size_t>(axis)];
    coordinate = !isInside && axis == face / 2 ? face % 2 : SnapTo(coordinate, bins);
  }
}

/// The mean of passages. Returns false where it is no line.
bool FindMean(vtkVoxelLineModel* model, const std::vector<Passage>& passages, MeanLine& mean)
{
  const auto chordOf = [](const Passage& passage) { return passage.End - passage.Start; };
  Point axis = { 0.0, 0.0, 0.0 };
  for (const Passage& passage : passages)
  {
    axis = Length(chordOf(passage)) > Length(axis) ? chordOf(passage) : axis;
  }
  for (int turn = 0; turn < 2; ++turn)
  {
    Point sum = { 0.0, 0.0, 0.0 };
    for (const Passage& passage : passages)
    {
      sum = sum + (Dot(chordOf(passage), axis) < 0.0 ? -1.0 : 1.0) * chordOf(passage);
    }
    axis = sum;
  }
  mean = { { Point{ 0.0, 0.0, 0.0 }, Point{ 0.0, 0.0, 0.0 } }, { -1, -1 } };
  bool isInside[2] = { true, true };
  for (const Passage& passage : passages)
  {
    const bool isFlipped = Dot(chordOf(passage), axis) < 0.0;
    for (std::size_t end = 0; end < 2; ++end)
    {
      const Point& point = (end == 0) != isFlipped ? passage.Start : passage.End;
      mean.Ends[end] = mean.Ends[end] + point;
      for (double coordinate : point)
      {
        isInside[end] = isInside[end] && coordinate > 0.0 && coordinate < 1.0;
      }
    }
  }
  for (std::size_t end = 0; end < 2; ++end)
  {
    for (double& coordinate : mean.Ends[end])
    {
      coordinate /= static_cast<double>(passages.size());
    }
    Snap(model, isInside[end], mean.Ends[end], mean.Faces[end]);
  }
  return mean.Ends[0] != mean.Ends[1];
}

/// Move the nearest ends on each common face to their mean.
void JoinMeans(std::map<Voxel, MeanLine>& means, int bins)
{
  for (auto& lower : means)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      Voxel above = lower.first;
      ++above[axis];
      const auto upper = means.find(above);
      Point* ends[2] = { nullptr, nullptr };
      double nearest = 10.0;
      for (std::size_t i = 0; i < 4 && upper != means.end(); ++i)
      {
        Point a = lower.second.Ends[i / 2];
        const Point b = upper->second.Ends[i % 2];
        a[axis] -= 1.0;
        if (lower.second.Faces[i / 2] == static_cast<int>(2 * axis) + 1 &&
          upper->second.Faces[i % 2] == static_cast<int>(2 * axis) && Length(a - b) < nearest)
        {
          nearest = Length(a - b);
          ends[0] = &lower.second.Ends[i / 2];
          ends[1] = &upper->second.Ends[i % 2];
        }
      }
      if (!ends[0])
      {
        continue;
      }
      const Point old[2] = { *ends[0], *ends[1] };
      for (std::size_t other = 0; other < 3; ++other)
      {
        if (other != axis)
        {
          const double coordinate = SnapTo(0.5 * (old[0][other] + old[1][other]), bins);
          (*ends[0])[other] = (*ends[1])[other] = coordinate;
        }
      }
      const auto isPoint = [](const MeanLine& line) { return line.Ends[0] == line.Ends[1]; };
      if (isPoint(lower.second) || isPoint(upper->second))
      {
        *ends[0] = old[0];
        *ends[1] = old[1];
      }
    }
  }
}

/// The grid of bricks with its distances, and the bounds, from the segments.
void CheckFrame(Checks& check, const std::string& name, vtkVoxelLineModel* model)
{
  double bounds[6] = { 1e30, -1e30, 1e30, -1e30, 1e30, -1e30 };
  std::map<Voxel, vtkIdType> bricks;
  for (const Segment& segment : DecodeModel(model))
  {
    bricks[{ segment.Voxel[0] / 4, segment.Voxel[1] / 4, segment.Voxel[2] / 4 }] = segment.Brick;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double low = std::min(segment.Start[axis], segment.End[axis]);
      const double high = std::max(segment.Start[axis], segment.End[axis]);
      bounds[2 * axis] = std::min(bounds[2 * axis], low);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], high);
    }
  }
  double error = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    error = std::max(error,
      std::abs(
        model->GetOrigin()[i / 2] + model->GetVoxelSize() * bounds[i] - model->GetBounds()[i]));
  }
  check(error < 1e-6, name + ": bounds");
  int cells[3];
  model->GetBrickDimensions(cells);
  bool isRight = true;
  for (vtkIdType i = 0; i < model->GetBrickGrid()->GetNumberOfTuples(); ++i)
  {
    const Voxel cell = { static_cast<int>(i % cells[0]), static_cast<int>(i / cells[0] % cells[1]),
      static_cast<int>(i / cells[0] / cells[1]) };
    const auto here = bricks.find(cell);
    int nearest = 127;
    for (const auto& brick : bricks)
    {
      nearest = std::min(nearest,
        std::max({ std::abs(brick.first[0] - cell[0]), std::abs(brick.first[1] - cell[1]),
          std::abs(brick.first[2] - cell[2]) }));
    }
    const double expected =
      here != bricks.end() ? static_cast<double>(here->second) : -static_cast<double>(nearest);
    isRight = isRight && model->GetBrickGrid()->GetComponent(i, 0) == expected;
  }
  check(isRight, name + ": grid of bricks");
}

/// Every level against the definition.
void TestDefinition(Checks& check, int bins)
{
  vtkSmartPointer<vtkVoxelLineModel> model =
    MakeModel(check, MakeLines(MakeSmoothCurves(60, 80)), 27, bins);
  for (int level = 0; level <= 5; ++level)
  {
    const std::string name = std::to_string(bins) + " bins, level " + std::to_string(level);
    std::map<Voxel, MeanLine> means;
    std::set<Voxel> others;
    for (const auto& entry : FindPassages(check, model, level))
    {
      MeanLine mean;
      FindMean(model, entry.second, mean) ? static_cast<void>(means[entry.first] = mean)
                                          : static_cast<void>(others.insert(entry.first));
    }
    JoinMeans(means, bins);
    vtkSmartPointer<vtkVoxelLineModel> output = MakeLevel(check, model, level);
    CheckFrame(check, name, output);
    const std::vector<Segment> segments = DecodeModel(output);
    check(segments.size() == means.size() + others.size(), name + ": occupied voxels");
    std::size_t right = 0;
    for (const Segment& segment : segments)
    {
      const auto mean = means.find(segment.Voxel);
      if (mean == means.end())
      {
        check(others.count(segment.Voxel) == 1, name + ": voxel");
        continue;
      }
      const Point corner = { static_cast<double>(segment.Voxel[0]),
        static_cast<double>(segment.Voxel[1]), static_cast<double>(segment.Voxel[2]) };
      const std::array<Point, 2>& ends = mean->second.Ends;
      // In either direction: which of two lines is longer may be a matter of rounding.
      const Point start = segment.Start - corner;
      const Point end = segment.End - corner;
      const double difference = std::min(Length(start - ends[0]) + Length(end - ends[1]),
        Length(start - ends[1]) + Length(end - ends[0]));
      right += difference < 1e-5;
    }
    std::cout << name << ": " << right << " of " << segments.size() << " as defined, "
              << others.size() << " averages are points\n";
    // An average that is a point is not compared, which its neighbours' ends may miss. Where the
    // representative of a bow has both ends on a face, and the other side's end is in the middle
    // between them, rounding of exact points decides which of them it meets: two lines change.
    check(right + std::max<std::size_t>(2, means.size() / 1000) >= means.size(),
      name + ": lines as defined");
  }
}

/// The same edges, whichever way they go.
std::vector<std::array<Point, 2>> EdgesOf(vtkVoxelLineModel* model)
{
  std::vector<std::array<Point, 2>> edges;
  for (const Segment& segment : DecodeModel(model))
  {
    edges.push_back({ std::min(segment.Start, segment.End), std::max(segment.Start, segment.End) });
  }
  return edges;
}

/// The direction and the order of the curves do not matter.
void TestOrder(Checks& check)
{
  std::vector<Curve> curves = MakeSmoothCurves(80, 60);
  vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, MakeLines(curves), 30, 32);
  std::mt19937 generator(3);
  for (std::size_t i = curves.size(); i > 1; --i)
  {
    std::swap(curves[i - 1], curves[generator() % i]);
    if (generator() % 2 == 1)
    {
      std::reverse(curves[i - 1].begin(), curves[i - 1].end());
    }
  }
  vtkSmartPointer<vtkVoxelLineModel> shuffled = MakeModel(check, MakeLines(curves), 30, 32);
  for (int level = 0; level <= 5; ++level)
  {
    const std::vector<std::array<Point, 2>> expected = EdgesOf(MakeLevel(check, model, level));
    const std::vector<std::array<Point, 2>> edges = EdgesOf(MakeLevel(check, shuffled, level));
    std::size_t same = 0;
    for (std::size_t i = 0; i < std::min(edges.size(), expected.size()); ++i)
    {
      same += edges[i] == expected[i];
    }
    std::cout << "shuffled, level " << level << ": " << same << " of " << edges.size()
              << " the same\n";
    // Sums in another order round otherwise, which may move an average to the next bin.
    check(edges.size() == expected.size() && same * 50 >= edges.size() * 49,
      "shuffled curves, level " + std::to_string(level));
  }
}

/// Where each of two neighbours has one end on their face, it is the same point.
void TestConnectivity(Checks& check, int bins)
{
  vtkSmartPointer<vtkVoxelLineModel> model =
    MakeModel(check, MakeLines(MakeSmoothCurves(100, 60)), 40, bins);
  for (int level = 0; level <= 3; ++level)
  {
    std::map<Voxel, Segment> segments;
    for (const Segment& segment : DecodeModel(MakeLevel(check, model, level)))
    {
      segments[segment.Voxel] = segment;
    }
    int pairs = 0;
    int apart = 0;
    for (const auto& entry : segments)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        Voxel above = entry.first;
        ++above[axis];
        const auto upper = segments.find(above);
        if (upper == segments.end())
        {
          continue;
        }
        std::vector<Point> points[2];
        for (const Point& point : { entry.second.Start, entry.second.End })
        {
          points[0].insert(points[0].end(), point[axis] == above[axis] ? 1 : 0, point);
        }
        for (const Point& point : { upper->second.Start, upper->second.End })
        {
          points[1].insert(points[1].end(), point[axis] == above[axis] ? 1 : 0, point);
        }
        if (points[0].size() == 1 && points[1].size() == 1)
        {
          ++pairs;
          apart += points[0] != points[1];
        }
      }
    }
    std::cout << bins << " bins, level " << level << ": " << pairs << " pairs meet on a face, of "
              << segments.size() << " voxels\n";
    check(pairs > static_cast<int>(segments.size()) / 5 && apart == 0,
      "ends on a common face meet, level " + std::to_string(level));
  }
}

/// All arrays of a model, as bytes.
std::string BytesOf(vtkVoxelLineModel* model)
{
  std::string bytes;
  for (vtkDataArray* array : { model->GetBrickGrid(), model->GetBricks(), model->GetVoxelStarts(),
         model->GetSegments(), model->GetCurveIdExtension(), model->GetBrickCurves(),
         static_cast<vtkDataArray*>(model->GetCurveCells()),
         static_cast<vtkDataArray*>(model->GetAttributes()),
         static_cast<vtkDataArray*>(model->GetRadii()) })
  {
    if (array)
    {
      bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
    }
    bytes += '|';
  }
  return bytes;
}

void TestThreads(Checks& check)
{
  vtkSmartPointer<vtkPolyData> lines = MakeLines(MakeSmoothCurves(800, 40));
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(i % 977));
  }
  lines->GetPointData()->SetScalars(values);
  for (const int bins : { 32, 0 })
  {
    vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, lines, 40, bins);
    for (const int level : { 0, 1, 2, 6 })
    {
      vtkSMPTools::SetBackend("Sequential");
      const std::string expected = BytesOf(MakeLevel(check, model, level));
      for (int threads : { 2, 7 })
      {
        vtkSMPTools::SetBackend("STDThread");
        vtkSMPTools::Initialize(threads);
        check(BytesOf(MakeLevel(check, model, level)) == expected,
          std::to_string(threads) + " threads, level " + std::to_string(level));
      }
    }
  }
}

/// Helices about one axis, side by side.
std::vector<Curve> MakeFlow()
{
  std::mt19937 generator(5);
  std::vector<Curve> curves(100);
  for (Curve& curve : curves)
  {
    const double radius = 0.5 * std::sqrt(generator() / 4294967296.0);
    const double phase = 6.2831853 * (generator() / 4294967296.0);
    for (int i = 0; i <= 160; ++i)
    {
      const double t = i / 160.0;
      const double angle = phase + 4.0 * t;
      curve.push_back({ radius * std::cos(angle), radius * std::sin(angle), t });
    }
  }
  return curves;
}

/// Distance between a point and the nearest piece of the curves, and the direction of that piece.
/// The flow goes up: at its height, or a little way from there, each curve is nearest.
double FindNearest(const std::vector<Curve>& curves, const Point& point, Point& tangent)
{
  double nearest = 1e30;
  const int height = static_cast<int>(std::lround(160.0 * point[2]));
  for (const Curve& curve : curves)
  {
    for (int i = std::max(height - 24, 1); i <= std::min(height + 24, 160); ++i)
    {
      const std::size_t j = static_cast<std::size_t>(i);
      const double distance = Distance(point, curve[j - 1], curve[j]);
      if (distance < nearest)
      {
        nearest = distance;
        tangent = curve[j] - curve[j - 1];
      }
    }
  }
  return nearest;
}

/// Largest distance between the curves and the lines of a level around them, in its voxels.
double MeasureCurves(vtkVoxelLineModel* model, const std::vector<Curve>& curves)
{
  std::map<Voxel, Segment> segments;
  for (const Segment& segment : DecodeModel(model))
  {
    segments[segment.Voxel] = segment;
  }
  double largest = 0.0;
  for (const Curve& curve : curves)
  {
    for (const Point& world : curve)
    {
      const Point point = ToLocal(model, world);
      double nearest = 1e30;
      for (int i = 0; i < 27; ++i)
      {
        const auto segment = segments.find({ static_cast<int>(std::floor(point[0])) + i % 3 - 1,
          static_cast<int>(std::floor(point[1])) + i / 3 % 3 - 1,
          static_cast<int>(std::floor(point[2])) + i / 9 - 1 });
        nearest = segment == segments.end()
          ? nearest
          : std::min(nearest, Distance(point, segment->second.Start, segment->second.End));
      }
      largest = std::max(largest, nearest);
    }
  }
  return largest;
}

/// The Hausdorff distance between a level and the curves grows no more than its voxels do.
void TestDistance(Checks& check)
{
  const std::vector<Curve> curves = MakeFlow();
  vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, MakeLines(curves), 64, 32);
  for (int level = 0; level <= 4; ++level)
  {
    vtkSmartPointer<vtkVoxelLineModel> output = MakeLevel(check, model, level);
    const double voxel = output->GetVoxelSize();
    const Point origin = { output->GetOrigin()[0], output->GetOrigin()[1], output->GetOrigin()[2] };
    double largest = 0.0;
    double mean = 0.0;
    double angle = 0.0;
    const std::vector<Segment> segments = DecodeModel(output);
    const double weight = 1.0 / static_cast<double>(segments.size());
    for (const Segment& segment : segments)
    {
      Point tangent = { 0.0, 0.0, 1.0 };
      for (const Point& end : { segment.Start, segment.End })
      {
        largest = std::max(largest, FindNearest(curves, origin + voxel * end, tangent) / voxel);
      }
      const Point middle = origin + (0.5 * voxel) * (segment.Start + segment.End);
      mean += weight * FindNearest(curves, middle, tangent) / voxel;
      const Point chord = segment.End - segment.Start;
      const double cosine = std::abs(Dot(chord, tangent)) / Length(chord) / Length(tangent);
      angle += weight * 57.29578 * std::acos(std::min(1.0, cosine));
    }
    const double back = MeasureCurves(output, curves);
    std::cout << "level " << level << ": " << segments.size()
              << " lines; in voxels of the level, middles are " << mean
              << " from the curves in the mean, ends up to " << largest
              << ", curves from the lines up to " << back << "; mean angle " << angle
              << " degrees\n";
    // Half a voxel's diagonal: about what a line in the same voxel can be off by.
    check(mean < 0.2 && largest < 0.87 && back < 1.1,
      "distance in proportion to the voxels, level " + std::to_string(level));
    // The voxels of level 3 are an eighth of the whole: what is in them goes several ways.
    check(level > 2 || angle < 18.0, "along the curves, level " + std::to_string(level));
  }
}

}

int TestVoxelLineLevelCurves(int, char*[])
{
  Checks check;
  for (const int bins : { 32, 128, 0 })
  {
    TestDefinition(check, bins);
    TestConnectivity(check, bins);
  }
  TestOrder(check);
  TestThreads(check);
  TestDistance(check);
  return check.GetResult();
}
