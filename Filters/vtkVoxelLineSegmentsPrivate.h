// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads the segments of a vtkVoxelLineModel brick by brick, for filters that go through all of
 * them.
 */

#ifndef vtkVoxelLineSegmentsPrivate_h
#define vtkVoxelLineSegmentsPrivate_h

#include "vtkDataArray.h"
#include "vtkType.h"
#include "vtkVoxelLineEncodingPrivate.h"
#include "vtkVoxelLineModel.h"

#include <cstdint>
#include <vector>

namespace vtkVoxelLineSegments
{

class Reader
{
public:
  /// The model must live, and its arrays stay as they are, as long as the reader.
  explicit Reader(vtkVoxelLineModel* model)
    : Codec(model->GetFaceBins())
  {
    model->GetBrickDimensions(this->BrickDimensions);
    this->Rows = Get<std::uint32_t>(model->GetBricks());
    this->Starts = model->GetVoxelStarts();
    this->Words = Get<std::uint32_t>(model->GetSegments());
    this->Extension = model->GetCurveIdExtension();
    this->Curves = Get<std::uint32_t>(model->GetBrickCurves());
    this->BrickCells.resize(static_cast<std::size_t>(model->GetNumberOfBricks()));
    const std::int32_t* grid = Get<std::int32_t>(model->GetBrickGrid());
    const vtkIdType numberOfCells =
      model->GetBrickGrid() ? model->GetBrickGrid()->GetNumberOfTuples() : 0;
    for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
    {
      if (grid[cell] >= 0)
      {
        this->BrickCells[static_cast<std::size_t>(grid[cell])] = cell;
      }
    }
  }

  vtkIdType GetNumberOfBricks() const { return static_cast<vtkIdType>(this->BrickCells.size()); }

  /// Call visit(voxel, first, last) for each occupied voxel of a brick, with its three indices and
  /// its range of segments.
  template <typename VisitorT>
  void VisitVoxels(vtkIdType brick, VisitorT&& visit) const
  {
    constexpr int size = vtkVoxelLineModel::BrickSize;
    const std::uint32_t* row = this->Rows + 5 * brick;
    const std::uint64_t mask = row[0] | static_cast<std::uint64_t>(row[1]) << 32;
    const vtkIdType cell = this->BrickCells[static_cast<std::size_t>(brick)];
    const vtkIdType corner[3] = { size * (cell % this->BrickDimensions[0]),
      size * (cell / this->BrickDimensions[0] % this->BrickDimensions[1]),
      size * (cell / this->BrickDimensions[0] / this->BrickDimensions[1]) };
    vtkIdType start = row[3];
    for (int bit = 0; bit < size * size * size; ++bit)
    {
      if ((mask >> bit & 1u) == 0)
      {
        continue;
      }
      const int voxel[3] = { static_cast<int>(corner[0]) + bit % size,
        static_cast<int>(corner[1]) + bit / size % size,
        static_cast<int>(corner[2]) + bit / (size * size) };
      visit(voxel, row[2] + this->GetStart(start), row[2] + this->GetStart(start + 1));
      ++start;
    }
  }

  /// End points of a segment in voxel-local coordinates.
  void GetPoints(vtkIdType segment, double start[3], double end[3]) const
  {
    const std::uint32_t* words = this->Words + this->Codec.Words * segment;
    if (this->Codec.FaceBins == 0)
    {
      const float* floats = reinterpret_cast<const float*>(words);
      for (int axis = 0; axis < 3; ++axis)
      {
        start[axis] = floats[axis];
        end[axis] = floats[3 + axis];
      }
      return;
    }
    this->Codec.Decode(this->Codec.StartCode(words), start);
    this->Codec.Decode(this->Codec.EndCode(words), end);
  }

  /// The curve of a segment of a brick.
  std::uint32_t GetCurve(vtkIdType brick, vtkIdType segment) const
  {
    std::uint32_t local = this->Codec.Curve(this->Words + this->Codec.Words * segment);
    if (this->Extension)
    {
      local |= this->GetNumber(this->Extension, segment) << this->Codec.CurveBits;
    }
    return this->Curves[this->Rows[5 * brick + 4] + local];
  }

private:
  template <typename T>
  static const T* Get(vtkDataArray* array)
  {
    return array ? static_cast<const T*>(array->GetVoidPointer(0)) : nullptr;
  }

  /// An unsigned number of 8, 16 or 32 bits.
  static std::uint32_t GetNumber(vtkDataArray* array, vtkIdType i)
  {
    switch (array->GetDataTypeSize())
    {
      case 1:
        return Get<std::uint8_t>(array)[i];
      case 2:
        return Get<std::uint16_t>(array)[i];
      default:
        return Get<std::uint32_t>(array)[i];
    }
  }

  vtkIdType GetStart(vtkIdType i) const { return GetNumber(this->Starts, i); }

  vtkVoxelLineEncoding::Codec Codec;
  int BrickDimensions[3];
  const std::uint32_t* Rows;
  vtkDataArray* Starts;
  const std::uint32_t* Words;
  vtkDataArray* Extension;
  const std::uint32_t* Curves;
  std::vector<vtkIdType> BrickCells;
};

}

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineSegmentsPrivate.h
