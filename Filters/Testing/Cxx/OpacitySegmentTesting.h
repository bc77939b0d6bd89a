// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of vtkOpacitySegments share: its output as plain numbers, and meshes.
 */

#ifndef OpacitySegmentTesting_h
#define OpacitySegmentTesting_h

#include "VoxelLineTesting.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkOpacitySegments.h"
#include "vtkPointData.h"

#include <set>
#include <utility>

namespace OpacitySegmentTesting
{

using namespace VoxelLineTesting;

/// A filter, what it says, and what it makes of an input.
class Segments
{
public:
  Segments()
  {
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Filter->AddObserver(vtkCommand::WarningEvent, this->Observer);
  }

  void Update(vtkPolyData* input)
  {
    this->Observer->Clear();
    this->Filter->SetInputData(input);
    this->Filter->Update();
    this->Output = this->Filter->GetOutput();
    this->Ids = vtkIntArray::SafeDownCast(
      this->Output->GetPointData()->GetArray(vtkOpacitySegments::GetIdsName()));
    this->Distances = vtkFloatArray::SafeDownCast(
      this->Output->GetPointData()->GetArray(vtkOpacitySegments::GetDistancesName()));
    this->Neighbors = vtkIntArray::SafeDownCast(
      this->Output->GetFieldData()->GetArray(vtkOpacitySegments::GetNeighborsName()));
  }

  int GetId(vtkIdType point, int i = 0) const { return this->Ids->GetTypedComponent(point, i); }
  double GetDistance(vtkIdType point, int i) const
  {
    return this->Distances->GetTypedComponent(point, i);
  }

  std::array<double, 3> GetWeights(vtkIdType point) const
  {
    std::array<double, 3> weights;
    vtkOpacitySegments::GetWeights(
      this->Ids->GetPointer(3 * point), this->Distances->GetPointer(4 * point), weights.data());
    return weights;
  }

  std::vector<std::pair<int, int>> GetPairs() const
  {
    std::vector<std::pair<int, int>> pairs;
    for (vtkIdType i = 0; i < this->Neighbors->GetNumberOfTuples(); ++i)
    {
      pairs.emplace_back(
        this->Neighbors->GetTypedComponent(i, 0), this->Neighbors->GetTypedComponent(i, 1));
    }
    return pairs;
  }

  /// The arrays have the types and sizes that are documented, and hold together.
  void CheckArrays(Checks& check, const std::string& name) const
  {
    const vtkIdType size = this->Output->GetNumberOfPoints();
    vtkIntArray* count = vtkIntArray::SafeDownCast(
      this->Output->GetFieldData()->GetArray(vtkOpacitySegments::GetCountName()));
    if (!check(this->Ids && this->Ids->GetNumberOfComponents() == 3 &&
            this->Ids->GetNumberOfTuples() == size && this->Distances &&
            this->Distances->GetNumberOfComponents() == 4 &&
            this->Distances->GetNumberOfTuples() == size && this->Neighbors &&
            this->Neighbors->GetNumberOfComponents() == 2 && count &&
            count->GetNumberOfTuples() == 1 &&
            count->GetValue(0) == this->Filter->GetNumberOfSegments(),
          name + ": the arrays are there"))
    {
      return;
    }
    const int number = count->GetValue(0);
    for (vtkIdType point = 0; point < size; ++point)
    {
      const auto w = this->GetWeights(point);
      const double sum = w[0] + w[1] + w[2];
      const bool isRight = std::abs(sum - (this->GetId(point) < 0 ? 0.0 : 1.0)) < 1e-12 &&
        w[0] >= w[1] && w[1] >= w[2] && w[2] >= 0.0;
      bool isOrdered = this->GetDistance(point, 0) >= 0.0;
      for (int i = 0; i < 3; ++i)
      {
        isOrdered = isOrdered && this->GetDistance(point, i) <= this->GetDistance(point, i + 1) &&
          this->GetDistance(point, i + 1) < 1e30 && this->GetId(point, i) < number &&
          this->GetId(point, i) >= -1;
      }
      if (!check(
            isRight && isOrdered, name + ": weights and order at point " + std::to_string(point)))
      {
        return;
      }
    }
    const auto pairs = this->GetPairs();
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      if (!check(pairs[i].first >= 0 && pairs[i].first < pairs[i].second &&
              pairs[i].second < number && (i == 0 || pairs[i - 1] < pairs[i]),
            name + ": pairs are in order"))
      {
        return;
      }
    }
  }

  vtkNew<vtkOpacitySegments> Filter;
  vtkNew<MessageObserver> Observer;
  vtkPolyData* Output = nullptr;
  vtkIntArray* Ids = nullptr;
  vtkFloatArray* Distances = nullptr;
  vtkIntArray* Neighbors = nullptr;
};

using Cell = std::vector<vtkIdType>;

/// A cell array of the given cells.
inline vtkSmartPointer<vtkCellArray> MakeCells(const std::vector<Cell>& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const Cell& cell : cells)
  {
    array->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  return array;
}

inline vtkSmartPointer<vtkPolyData> MakeData(const std::vector<Point>& points)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> array;
  array->SetDataTypeToDouble();
  for (const Point& point : points)
  {
    array->InsertNextPoint(point.data());
  }
  data->SetPoints(array);
  return data;
}

inline std::vector<Point> GetPoints(vtkPolyData* data)
{
  std::vector<Point> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

/// Corners of n x n squares in the unit square, those inside moved at random by up to jitter / 2
/// sides of them.
inline std::vector<Point> MakeGridPoints(int n, double jitter, unsigned seed = 1)
{
  std::mt19937 generator(seed);
  const auto uniform = [&generator]() { return generator() / 4294967296.0 - 0.5; };
  std::vector<Point> points;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const bool isInside = i > 0 && j > 0 && i < n && j < n;
      const double x = jitter * uniform();
      const double y = jitter * uniform();
      points.push_back({ (j + (isInside ? x : 0.0)) / n, (i + (isInside ? y : 0.0)) / n, 0.0 });
    }
  }
  return points;
}

/// Two triangles for each square, with diagonals in turn.
inline std::vector<Cell> MakeGridTriangles(int n)
{
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < n; ++i)
  {
    for (vtkIdType j = 0; j < n; ++j)
    {
      const vtkIdType a = i * (n + 1) + j;
      const vtkIdType b = a + 1;
      const vtkIdType c = a + n + 2;
      const vtkIdType d = a + n + 1;
      if ((i + j) % 2 == 0)
      {
        cells.push_back({ a, b, c });
        cells.push_back({ a, c, d });
      }
      else
      {
        cells.push_back({ a, b, d });
        cells.push_back({ b, c, d });
      }
    }
  }
  return cells;
}

inline vtkSmartPointer<vtkPolyData> MakeGrid(int n, double jitter, unsigned seed = 1)
{
  vtkSmartPointer<vtkPolyData> data = MakeData(MakeGridPoints(n, jitter, seed));
  data->SetPolys(MakeCells(MakeGridTriangles(n)));
  return data;
}

}

#endif
