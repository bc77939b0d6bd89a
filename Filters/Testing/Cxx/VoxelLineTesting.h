// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of the voxel line filters share: curves to work on, a decoder of
 * vtkVoxelLineModel that is written from its documentation alone, and checks that say what failed.
 */

#ifndef VoxelLineTesting_h
#define VoxelLineTesting_h

#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkLineVoxelizer.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace VoxelLineTesting
{

using Point = std::array<double, 3>;
using Curve = std::vector<Point>;

/// Counts failed checks; the test returns EXIT_FAILURE if there is one.
class Checks
{
public:
  bool operator()(bool isRight, const std::string& what)
  {
    if (!isRight)
    {
      std::cerr << "FAILED: " << what << std::endl;
      ++this->Failures;
    }
    return isRight;
  }
  int GetResult() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  int Failures = 0;
};

/// Catches and counts the errors and warnings of what it observes.
class MessageObserver : public vtkCommand
{
public:
  static MessageObserver* New() { return new MessageObserver; }

  void Execute(vtkObject*, unsigned long event, void* text) override
  {
    const bool isError = event == vtkCommand::ErrorEvent;
    ++(isError ? this->NumberOfErrors : this->NumberOfWarnings);
    (isError ? this->ErrorMessage : this->WarningMessage) += static_cast<const char*>(text);
  }

  void Clear()
  {
    this->NumberOfErrors = this->NumberOfWarnings = 0;
    this->ErrorMessage.clear();
    this->WarningMessage.clear();
  }

  bool GetError() const { return this->NumberOfErrors > 0; }
  bool GetWarning() const { return this->NumberOfWarnings > 0; }

  int NumberOfErrors = 0;
  int NumberOfWarnings = 0;
  std::string ErrorMessage;
  std::string WarningMessage;
};

inline Point operator+(const Point& a, const Point& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}
inline Point operator-(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}
inline Point operator*(double s, const Point& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}
inline double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double Length(const Point& a)
{
  return std::sqrt(Dot(a, a));
}

/// Distance between a point and the segment from a to b.
inline double Distance(const Point& p, const Point& a, const Point& b)
{
  const Point d = b - a;
  const double length2 = Dot(d, d);
  double t = length2 > 0.0 ? Dot(p - a, d) / length2 : 0.0;
  t = t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
  return Length(p - (a + t * d));
}

/// Polylines of the given curves; points in double precision unless told otherwise.
inline vtkSmartPointer<vtkPolyData> MakeLines(
  const std::vector<Curve>& curves, int pointType = VTK_DOUBLE)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  vtkNew<vtkCellArray> lines;
  for (const Curve& curve : curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.size()));
    for (const Point& point : curve)
    {
      lines->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

/// Smooth curves through the unit cube, each of the given number of points: sums of three waves.
inline std::vector<Curve> MakeSmoothCurves(
  int numberOfCurves, int numberOfPoints, unsigned seed = 1)
{
  std::mt19937 generator(seed);
  const auto uniform = [&generator]() { return generator() / 4294967296.0; };
  std::vector<Curve> curves(static_cast<std::size_t>(numberOfCurves));
  for (Curve& curve : curves)
  {
    double amplitude[3][3];
    double frequency[3][3];
    double phase[3][3];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int wave = 0; wave < 3; ++wave)
      {
        amplitude[axis][wave] = 0.16 * uniform();
        frequency[axis][wave] = 12.0 * uniform();
        phase[axis][wave] = 6.3 * uniform();
      }
    }
    for (int i = 0; i < numberOfPoints; ++i)
    {
      const double t = static_cast<double>(i) / (numberOfPoints - 1);
      Point point = { 0.5, 0.5, 0.5 };
      for (int axis = 0; axis < 3; ++axis)
      {
        for (int wave = 0; wave < 3; ++wave)
        {
          point[axis] +=
            amplitude[axis][wave] * std::sin(frequency[axis][wave] * t + phase[axis][wave]);
        }
      }
      curve.push_back(point);
    }
  }
  return curves;
}

/// A segment as the model's documentation tells it.
struct Segment
{
  vtkIdType Index;
  vtkIdType Brick;
  std::array<int, 3> Voxel;
  vtkIdType Curve;
  std::uint32_t StartCode;
  std::uint32_t EndCode;
  /// In grid-local coordinates.
  Point Start;
  Point End;
};

inline Point DecodeCode(std::uint32_t code, int faceBins, int interiorBins)
{
  const int n = faceBins;
  const int u = static_cast<int>(code) % n;
  const int v = static_cast<int>(code) / n % n;
  const int face = static_cast<int>(code) / (n * n);
  Point point = { 0.0, 0.0, 0.0 };
  switch (face)
  {
    case 0:
    case 1: // x: u along y, v along z
      point = { face == 1 ? 1.0 : 0.0, (u + 0.5) / n, (v + 0.5) / n };
      break;
    case 2:
    case 3: // y: u along z, v along x
      point = { (v + 0.5) / n, face == 3 ? 1.0 : 0.0, (u + 0.5) / n };
      break;
    case 4:
    case 5: // z: u along x, v along y
      point = { (u + 0.5) / n, (v + 0.5) / n, face == 5 ? 1.0 : 0.0 };
      break;
    default:
    {
      const int m = interiorBins;
      const int q = (face - 6) * n * n + v * n + u;
      point = { (q % m + 0.5) / m, (q / m % m + 0.5) / m, (q / (m * m) + 0.5) / m };
      break;
    }
  }
  return point;
}

/// All segments of a model, in its order.
inline std::vector<Segment> DecodeModel(vtkVoxelLineModel* model)
{
  std::vector<Segment> segments;
  const vtkIdType numberOfBricks = model->GetNumberOfBricks();
  int bricks[3];
  model->GetBrickDimensions(bricks);
  const int n = model->GetFaceBins();
  const int bits = n > 0 ? static_cast<int>(std::lround(std::log2(n))) : 0;
  const int m = n > 0 ? static_cast<int>(std::cbrt(2.0 * n * n) + 1e-9) : 0;
  const std::uint32_t codeMask = n > 0 ? (1u << (2 * bits + 3)) - 1u : 0u;
  const auto number = [](vtkDataArray* array, vtkIdType tuple, int component)
  { return static_cast<std::uint32_t>(array->GetComponent(tuple, component)); };
  std::vector<vtkIdType> cellOf(static_cast<std::size_t>(numberOfBricks), -1);
  vtkDataArray* grid = model->GetBrickGrid();
  for (vtkIdType cell = 0; grid && cell < grid->GetNumberOfTuples(); ++cell)
  {
    const vtkIdType brick = static_cast<vtkIdType>(grid->GetComponent(cell, 0));
    if (brick >= 0)
    {
      cellOf[static_cast<std::size_t>(brick)] = cell;
    }
  }
  for (vtkIdType brick = 0; brick < numberOfBricks; ++brick)
  {
    const vtkIdType cell = cellOf[static_cast<std::size_t>(brick)];
    const int corner[3] = { static_cast<int>(cell % bricks[0]) * 4,
      static_cast<int>(cell / bricks[0] % bricks[1]) * 4,
      static_cast<int>(cell / bricks[0] / bricks[1]) * 4 };
    std::uint64_t mask = number(model->GetBricks(), brick, 1);
    mask = mask << 32 | number(model->GetBricks(), brick, 0);
    const vtkIdType first = number(model->GetBricks(), brick, 2);
    vtkIdType start = number(model->GetBricks(), brick, 3);
    const vtkIdType curves = number(model->GetBricks(), brick, 4);
    for (int bit = 0; bit < 64; ++bit)
    {
      if ((mask >> bit & 1) == 0)
      {
        continue;
      }
      const vtkIdType begin = first + number(model->GetVoxelStarts(), start, 0);
      const vtkIdType end = first + number(model->GetVoxelStarts(), start + 1, 0);
      ++start;
      for (vtkIdType i = begin; i < end; ++i)
      {
        Segment segment;
        segment.Index = i;
        segment.Brick = brick;
        segment.Voxel = { corner[0] + bit % 4, corner[1] + bit / 4 % 4, corner[2] + bit / 16 };
        segment.StartCode = 0;
        segment.EndCode = 0;
        vtkDataArray* words = model->GetSegments();
        std::uint32_t local = 0;
        int localBits = 0;
        if (n == 0)
        {
          for (int axis = 0; axis < 3; ++axis)
          {
            segment.Start[axis] = words->GetComponent(i, axis);
            segment.End[axis] = words->GetComponent(i, 3 + axis);
          }
        }
        else
        {
          const std::uint32_t word0 = number(words, i, 0);
          const std::uint32_t word1 = n > 32 ? number(words, i, 1) : 0;
          segment.StartCode = word0 & codeMask;
          segment.EndCode = n > 32 ? word1 & codeMask : word0 >> (2 * bits + 3) & codeMask;
          local = n > 32 ? (word0 >> 26) + 64 * (word1 >> 26) : word0 >> 26;
          localBits = n > 32 ? 12 : 6;
          segment.Start = DecodeCode(segment.StartCode, n, m);
          segment.End = DecodeCode(segment.EndCode, n, m);
        }
        if (model->GetCurveIdExtension())
        {
          local += number(model->GetCurveIdExtension(), i, 0) << localBits;
        }
        segment.Curve = number(model->GetBrickCurves(), curves + local, 0);
        for (int axis = 0; axis < 3; ++axis)
        {
          segment.Start[axis] += segment.Voxel[axis];
          segment.End[axis] += segment.Voxel[axis];
        }
        segments.push_back(segment);
      }
    }
  }
  return segments;
}

/// A world point in the model's grid-local coordinates.
inline Point ToLocal(vtkVoxelLineModel* model, const Point& world)
{
  const double* origin = model->GetOrigin();
  return { (world[0] - origin[0]) / model->GetVoxelSize(),
    (world[1] - origin[1]) / model->GetVoxelSize(),
    (world[2] - origin[2]) / model->GetVoxelSize() };
}

/// Update a voxelizer; its errors and warnings go into the observer.
inline vtkVoxelLineModel* Update(vtkLineVoxelizer* voxelizer, MessageObserver* observer)
{
  observer->Clear();
  voxelizer->AddObserver(vtkCommand::ErrorEvent, observer);
  voxelizer->AddObserver(vtkCommand::WarningEvent, observer);
  voxelizer->Update();
  voxelizer->RemoveObserver(observer);
  return voxelizer->GetOutput();
}

/// Model of one line set; any error or warning is a failure.
inline vtkSmartPointer<vtkVoxelLineModel> MakeModel(
  Checks& check, vtkPolyData* lines, int resolution, int faceBins, double interiorTolerance = 0.1)
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetResolution(resolution);
  voxelizer->SetFaceBins(faceBins);
  voxelizer->SetInteriorTolerance(interiorTolerance);
  vtkNew<MessageObserver> observer;
  vtkSmartPointer<vtkVoxelLineModel> model = Update(voxelizer, observer);
  check(!observer->GetError() && !observer->GetWarning(),
    "no error or warning: " + observer->ErrorMessage + observer->WarningMessage);
  return model;
}

/**
 * The segments of a curve in the order in which they hang together, found by their end points
 * alone. Empty where they are not one chain. A curve may pass a point several times, so that this
 * takes the trail that uses every segment once (Hierholzer). A closed chain begins in the point
 * nearest to the given grid-local one.
 */
inline std::vector<Segment> Chain(
  const std::vector<Segment>& all, vtkIdType curve, const Point& begin = { 0.0, 0.0, 0.0 })
{
  std::map<Point, std::vector<Segment>> leaving;
  std::map<Point, int> balance;
  std::size_t size = 0;
  Point start = { 1e30, 1e30, 1e30 };
  for (const Segment& segment : all)
  {
    if (segment.Curve == curve)
    {
      start = Length(segment.Start - begin) < Length(start - begin) ? segment.Start : start;
      leaving[segment.Start].push_back(segment);
      ++balance[segment.Start];
      --balance[segment.End];
      ++size;
    }
  }
  for (const auto& entry : balance)
  {
    start = entry.second > 0 ? entry.first : start;
  }
  std::vector<Segment> chain;
  std::vector<Segment> path;
  Point here = start;
  do
  {
    std::vector<Segment>& next = leaving[here];
    if (!next.empty())
    {
      path.push_back(next.back());
      next.pop_back();
      here = path.back().End;
      continue;
    }
    if (path.empty())
    {
      break;
    }
    chain.push_back(path.back());
    here = path.back().Start;
    path.pop_back();
  } while (true);
  std::reverse(chain.begin(), chain.end());
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    if (chain[i - 1].End != chain[i].Start)
    {
      return std::vector<Segment>();
    }
  }
  return chain.size() == size ? chain : std::vector<Segment>();
}

}

#endif
