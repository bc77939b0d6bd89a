// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the structure of a model that others rely on: brick grid with exact distances, bricks,
 * voxel starts, curve lists and the order of segments; its accounts of memory; its life as
 * pipeline data: copies, initialization, printing; and that arrays that are missing or do not fit
 * are found, and told by the filters instead of being read.
 */

#include "VoxelLineTesting.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkTrivialProducer.h"
#include "vtkTypeUInt32Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineDensity.h"
#include "vtkVoxelLineDistancePrivate.h"
#include "vtkVoxelLineGeometry.h"

#include <functional>
#include <sstream>

using namespace VoxelLineTesting;

namespace
{

/// Distances of all cells to the nearest occupied one, the slow way.
std::vector<int> FindDistances(const std::vector<bool>& isOccupied, const int dims[3], int largest)
{
  std::vector<int> distances(isOccupied.size(), largest);
  std::vector<std::array<int, 3>> occupied;
  const auto placeOf = [dims](std::size_t cell)
  {
    const int i = static_cast<int>(cell);
    return std::array<int, 3>{ i % dims[0], i / dims[0] % dims[1], i / dims[0] / dims[1] };
  };
  for (std::size_t cell = 0; cell < isOccupied.size(); ++cell)
  {
    if (isOccupied[cell])
    {
      occupied.push_back(placeOf(cell));
    }
  }
  for (std::size_t cell = 0; cell < isOccupied.size(); ++cell)
  {
    const std::array<int, 3> here = placeOf(cell);
    for (const std::array<int, 3>& there : occupied)
    {
      const int distance = std::max({ std::abs(here[0] - there[0]), std::abs(here[1] - there[1]),
        std::abs(here[2] - there[2]) });
      distances[cell] = std::min(distances[cell], distance);
    }
  }
  return distances;
}

void TestDistances(Checks& check)
{
  std::mt19937 generator(11);
  const int sizes[][3] = { { 1, 1, 1 }, { 13, 9, 7 }, { 1, 20, 3 }, { 300, 2, 1 }, { 2, 1, 300 },
    { 1, 300, 1 }, { 24, 24, 24 } };
  for (const auto& dims : sizes)
  {
    for (int numberOfOccupied : { 0, 1, 2, 12 })
    {
      const std::size_t size = static_cast<std::size_t>(dims[0]) * dims[1] * dims[2];
      std::vector<bool> isOccupied(size, false);
      for (int i = 0; i < numberOfOccupied; ++i)
      {
        isOccupied[generator() % size] = true;
      }
      for (int largest : { 127, 5 })
      {
        std::vector<std::uint8_t> cells(size);
        std::transform(isOccupied.begin(), isOccupied.end(), cells.begin(),
          [](bool is) { return static_cast<std::uint8_t>(is ? 0 : 255); });
        vtkVoxelLineDistance::Transform(cells, dims, largest);
        const std::vector<int> expected = FindDistances(isOccupied, dims, largest);
        check(std::equal(cells.begin(), cells.end(), expected.begin()),
          "distances in a grid of " + std::to_string(dims[0]) + " x " + std::to_string(dims[1]) +
            " x " + std::to_string(dims[2]) + " with " + std::to_string(numberOfOccupied) +
            " occupied cells, clamped at " + std::to_string(largest));
      }
    }
  }
}

void TestStructure(Checks& check, vtkVoxelLineModel* model)
{
  int bricks[3];
  model->GetBrickDimensions(bricks);
  const vtkIdType cells = static_cast<vtkIdType>(bricks[0]) * bricks[1] * bricks[2];
  for (int axis = 0; axis < 3; ++axis)
  {
    check(bricks[axis] == (model->GetDimensions()[axis] + 3) / 4, "brick dimensions");
  }
  if (!check(model->GetBrickGrid()->GetNumberOfTuples() == cells, "one number per brick cell"))
  {
    return;
  }
  std::vector<bool> isOccupied(static_cast<std::size_t>(cells));
  vtkIdType next = 0;
  bool isAscending = true;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const double value = model->GetBrickGrid()->GetComponent(cell, 0);
    isOccupied[static_cast<std::size_t>(cell)] = value >= 0.0;
    isAscending = isAscending && (value < 0.0 || value == next);
    next += value >= 0.0;
  }
  check(isAscending && next == model->GetNumberOfBricks(), "bricks are numbered along the grid");
  const std::vector<int> distances = FindDistances(isOccupied, bricks, 127);
  bool isExact = true;
  for (std::size_t cell = 0; cell < distances.size(); ++cell)
  {
    isExact = isExact &&
      (isOccupied[cell] ||
        model->GetBrickGrid()->GetComponent(static_cast<vtkIdType>(cell), 0) == -distances[cell]);
  }
  check(isExact, "empty cells tell their distance");

  const std::vector<Segment> segments = DecodeModel(model);
  check(static_cast<vtkIdType>(segments.size()) == model->GetNumberOfSegments(), "all segments");
  vtkIdType voxels = 0;
  bool isOrdered = true;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    isOrdered = isOrdered && segments[i].Index == static_cast<vtkIdType>(i);
    const bool isSameVoxel = i > 0 && segments[i].Voxel == segments[i - 1].Voxel;
    voxels += !isSameVoxel;
    isOrdered = isOrdered && (!isSameVoxel || segments[i - 1].Curve <= segments[i].Curve);
    // Within a voxel and a curve, the order is that along the curve.
    if (isSameVoxel && segments[i].Curve == segments[i - 1].Curve)
    {
      isOrdered = isOrdered && segments[i].Start != segments[i - 1].Start;
    }
  }
  check(isOrdered, "segments are ordered by brick, voxel and curve");
  check(voxels == model->GetNumberOfOccupiedVoxels(), "number of occupied voxels");

  // The lists of curves ascend and name the curves of the brick and no other.
  vtkIdType first = 0;
  for (vtkIdType brick = 0; brick < model->GetNumberOfBricks(); ++brick)
  {
    std::vector<vtkIdType> used;
    while (first < static_cast<vtkIdType>(segments.size()) &&
      segments[static_cast<std::size_t>(first)].Brick == brick)
    {
      used.push_back(segments[static_cast<std::size_t>(first++)].Curve);
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<vtkIdType> listed;
    for (vtkIdType i = static_cast<vtkIdType>(model->GetBricks()->GetComponent(brick, 4));
         i < model->GetBricks()->GetComponent(brick + 1, 4); ++i)
    {
      listed.push_back(static_cast<vtkIdType>(model->GetBrickCurves()->GetComponent(i, 0)));
    }
    if (!check(listed == used, "curves of brick " + std::to_string(brick)))
    {
      break;
    }
  }
}

void TestMemory(Checks& check, vtkVoxelLineModel* model)
{
  const vtkIdType segments = model->GetNumberOfSegments();
  vtkIdType extension =
    model->GetCurveIdExtension() ? segments * model->GetCurveIdExtension()->GetDataTypeSize() : 0;
  check(model->GetNumberOfBytes(vtkVoxelLineModel::SegmentPart) ==
      4 * segments * model->GetSegmentWords() + extension,
    "bytes of segments");
  check(model->GetNumberOfBytes(vtkVoxelLineModel::AttributePart) == 2 * segments,
    "bytes of attributes");
  check(model->GetNumberOfBytes(vtkVoxelLineModel::RadiusPart) == 2 * segments, "bytes of radii");
  check(model->GetNumberOfBytes(vtkVoxelLineModel::GridPart) ==
      4 * model->GetBrickGrid()->GetNumberOfTuples() + 20 * (model->GetNumberOfBricks() + 1) +
        2 * (model->GetNumberOfOccupiedVoxels() + model->GetNumberOfBricks()),
    "bytes of the grid");
  check(model->GetNumberOfBytes(vtkVoxelLineModel::CurvePart) ==
      4 * model->GetBrickCurves()->GetNumberOfTuples() + 16 * model->GetNumberOfCurves(),
    "bytes of the curves");
  vtkIdType sum = 0;
  for (int part = 0; part < vtkVoxelLineModel::NumberOfParts; ++part)
  {
    sum += model->GetNumberOfBytes(part);
  }
  check(sum == model->GetNumberOfBytes(), "the parts make the whole");
  check(model->GetActualMemorySize() * 1024.0 >= sum, "memory size");
}

void TestCopies(Checks& check, vtkVoxelLineModel* model)
{
  std::ostringstream text;
  model->Print(text);
  vtkNew<vtkVoxelLineModel> shallow;
  shallow->ShallowCopy(model);
  vtkNew<vtkVoxelLineModel> deep;
  deep->DeepCopy(model);
  const auto arraysOf = [](vtkVoxelLineModel* m)
  {
    return std::vector<vtkDataArray*>{ m->GetBrickGrid(), m->GetBricks(), m->GetVoxelStarts(),
      m->GetSegments(), m->GetCurveIdExtension(), m->GetBrickCurves(), m->GetCurveCells(),
      m->GetAttributes(), m->GetRadii() };
  };
  const std::vector<vtkDataArray*> arrays = arraysOf(model);
  check(arraysOf(shallow) == arrays, "a shallow copy shares the arrays");
  const std::vector<vtkDataArray*> copies = arraysOf(deep);
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    check(arrays[i] && copies[i] && arrays[i] != copies[i] &&
        arrays[i]->GetNumberOfValues() == copies[i]->GetNumberOfValues() &&
        arrays[i]->GetDataType() == copies[i]->GetDataType() &&
        std::memcmp(arrays[i]->GetVoidPointer(0), copies[i]->GetVoidPointer(0),
          static_cast<std::size_t>(
            arrays[i]->GetNumberOfValues() * arrays[i]->GetDataTypeSize())) == 0,
      "a deep copy has equal arrays of its own");
  }
  for (vtkVoxelLineModel* copy : { shallow.Get(), deep.Get() })
  {
    // Everything that is not an array is printed: the same text, but for what all objects print.
    std::ostringstream copyText;
    copy->Print(copyText);
    const auto members = [](const std::string& all) { return all.substr(all.find("Dimensions")); };
    check(members(copyText.str()) == members(text.str()), "a copy has all members");
  }
  shallow->Initialize();
  check(shallow->GetNumberOfSegments() == 0 && shallow->GetNumberOfBytes() == 0 &&
      shallow->GetNumberOfCurves() == 0 && shallow->GetDimensions()[0] == 0 &&
      shallow->GetLargestDeviation() == 0.0 && shallow->GetNumberOfDroppedPoints() == 0,
    "an initialized model is empty");
  check(model->GetNumberOfSegments() > 0, "and the other one is not");

  // Segments and bricks that do not exist.
  vtkNew<MessageObserver> observer;
  model->AddObserver(vtkCommand::ErrorEvent, observer);
  const vtkIdType size = model->GetNumberOfSegments();
  double start[3] = { 1.0, 1.0, 1.0 };
  double end[3] = { 1.0, 1.0, 1.0 };
  for (vtkIdType segment : { vtkIdType(-1), size })
  {
    model->GetSegmentPoints(segment, start, end);
    check(start[0] == 0.0 && end[2] == 0.0, "no points for a segment that does not exist");
    check(model->GetSegmentCurve(0, segment) == -1 &&
        model->GetSegmentCurve(model->GetNumberOfBricks() - 1, segment) == -1,
      "no curve for a segment that does not exist");
  }
  check(model->GetSegmentCurve(-1, 0) == -1 &&
      model->GetSegmentCurve(model->GetNumberOfBricks(), size - 1) == -1,
    "no curve for a brick that does not exist");
  check(observer->NumberOfErrors == 8, "each is told");
  model->RemoveObserver(observer);

  vtkMTimeType time = model->GetMTime();
  model->SetSegments(model->GetSegments());
  check(model->GetMTime() == time, "the same array changes nothing");
  vtkNew<vtkTypeUInt32Array> other;
  deep->SetSegments(other);
  check(deep->GetMTime() > time && deep->GetSegments() == other.Get(), "another array does");

  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(model);
  producer->Update();
  check(vtkVoxelLineModel::GetData(producer->GetOutputInformation(0)) == model,
    "a model is pipeline data");
  check(!vtkVoxelLineModel::GetData(static_cast<vtkInformation*>(nullptr)), "no data, no model");
}

/// What the filters say about a model; empty where they make something of it.
std::string TellByFilters(vtkVoxelLineModel* model)
{
  vtkNew<MessageObserver> observer;
  vtkNew<vtkVoxelLineGeometry> geometry;
  geometry->SetInputDataObject(model);
  geometry->AddObserver(vtkCommand::ErrorEvent, observer);
  geometry->Update();
  vtkNew<vtkVoxelLineDensity> density;
  density->SetInputDataObject(model);
  density->AddObserver(vtkCommand::ErrorEvent, observer);
  density->Update();
  return observer->NumberOfErrors == 1 ? "one filter only" : observer->ErrorMessage;
}

void TestDefects(Checks& check, vtkVoxelLineModel* good)
{
  check(good->FindDefect().empty() && TellByFilters(good).empty(), "a good model has no defect");
  using Change = std::function<void(vtkVoxelLineModel*)>;
  using Model = vtkVoxelLineModel;
  const std::pair<const char*, Change> cases[] = { { "BrickGrid is missing",
                                                     [](Model* m) { m->SetBrickGrid(nullptr); } },
    { "BrickGrid holds float", [](Model* m) { m->SetBrickGrid(vtkNew<vtkFloatArray>()); } },
    { "BrickGrid has", [](Model* m) { m->SetDimensions(40, 40, 40); } },
    { "Bricks is missing", [](Model* m) { m->SetBricks(nullptr); } },
    { "Bricks has 1 components", [](Model* m) { m->SetBricks(vtkNew<vtkTypeUInt32Array>()); } },
    { "VoxelStarts is missing", [](Model* m) { m->SetVoxelStarts(nullptr); } },
    { "VoxelStarts has 0 rows", [](Model* m) { m->SetVoxelStarts(vtkNew<vtkTypeUInt32Array>()); } },
    { "Segments is missing", [](Model* m) { m->SetSegments(nullptr); } },
    { "Segments has 1 components", [](Model* m) { m->SetFaceBins(64); } },
    { "Segments holds unsigned int", [](Model* m) { m->SetFaceBins(0); } },
    { "Segments has", [](Model* m) { m->GetSegments()->RemoveLastTuple(); } },
    { "CurveIdExtension has 0 rows",
      [](Model* m) { m->SetCurveIdExtension(vtkNew<vtkUnsignedCharArray>()); } },
    { "BrickCurves is missing", [](Model* m) { m->SetBrickCurves(nullptr); } },
    { "CurveCells is missing", [](Model* m) { m->SetCurveCells(nullptr); } },
    { "Attributes is missing", [](Model* m) { m->SetAttributes(nullptr); } },
    { "Attributes has 2 components", [](Model* m) { m->SetAttributeKind(Model::Color); } },
    { "Radii has 1 components", [](Model* m) { m->SetRadii(vtkNew<vtkUnsignedCharArray>()); } },
    { "MaximumRadius", [](Model* m) { m->SetMaximumRadius(0.0); } },
    { "FaceBins is 33", [](Model* m) { m->SetFaceBins(33); } },
    { "VoxelSize", [](Model* m) { m->SetVoxelSize(0.0); } },
    { "Dimensions", [](Model* m) { m->SetDimensions(0, 1, 1); } } };
  for (const auto& [text, change] : cases)
  {
    vtkNew<vtkVoxelLineModel> model;
    model->DeepCopy(good);
    change(model);
    const std::string name = text;
    check(model->FindDefect().find(name) != std::string::npos, name + ": found");
    check(TellByFilters(model).find(name) != std::string::npos, name + ": the filters tell it");
  }
}

}

int TestVoxelLineModel(int, char*[])
{
  Checks check;
  TestDistances(check);

  vtkSmartPointer<vtkPolyData> lines = MakeLines(MakeSmoothCurves(400, 60));
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("Scalars");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(1.0f + i % 10);
  }
  lines->GetPointData()->SetScalars(scalars);
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetRadiusArrayName("Scalars");
  for (int bins : { 32, 512, 0 })
  {
    for (int resolution : { 9, 30 })
    {
      voxelizer->SetResolution(resolution);
      voxelizer->SetFaceBins(bins);
      voxelizer->Update();
      TestStructure(check, voxelizer->GetOutput());
      TestMemory(check, voxelizer->GetOutput());
    }
  }
  // Far apart along one axis: distances up to the clamp.
  vtkSmartPointer<vtkVoxelLineModel> sparse = MakeModel(check,
    MakeLines({ { { 0.0, 0.0, 0.0 }, { 0.001, 0.01, 0.01 } },
      { { 1.0, 0.005, 0.0 }, { 0.999, 0.01, 0.01 } } }),
    2000, 32);
  TestStructure(check, sparse);
  check(sparse->GetBrickGrid()->GetRange()[0] == -127.0, "distances are clamped at 127");

  voxelizer->SetFaceBins(32);
  voxelizer->SetResolution(9);
  voxelizer->Update();
  TestCopies(check, voxelizer->GetOutput());
  TestDefects(check, voxelizer->GetOutput());

  vtkNew<vtkVoxelLineModel> model;
  check(model->GetNumberOfOccupiedVoxels() == 0 && model->GetNumberOfBytes() == 0 &&
      model->GetDataObjectType() == VTK_DATA_OBJECT,
    "a new model is empty");
  return check.GetResult();
}
