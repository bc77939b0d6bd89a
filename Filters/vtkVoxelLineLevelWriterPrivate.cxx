// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Writes representatives as a vtkVoxelLineModel. With one segment for each occupied voxel, every
 * brick has its place from its number of voxels, and has few enough curves for short ids.
 */

#include "vtkVoxelLineRepresentativesPrivate.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeUInt16Array.h"
#include "vtkTypeUInt32Array.h"
#include "vtkTypeUInt8Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineDistancePrivate.h"
#include "vtkVoxelLineEncodingPrivate.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vtkVoxelLineRepresentatives
{

namespace
{

constexpr int WordsPerRow = 5;
constexpr vtkIdType BricksPerTask = 64;

template <typename ArrayT>
vtkSmartPointer<ArrayT> MakeArray(int components, std::size_t tuples)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

/// Writes one array of the model after the other.
class LevelWriter
{
public:
  LevelWriter(vtkVoxelLineModel* source, const AveragingRules& rules, const LevelTable& table,
    vtkVoxelLineModel* output)
    : Source(source)
    , Rules(rules)
    , Table(table)
    , Output(output)
  {
  }

  void Write();

private:
  void WriteBricks();
  void WriteSegments();
  void WriteBrickGrid();
  void WriteBounds();

  vtkVoxelLineModel* Source;
  const AveragingRules& Rules;
  const LevelTable& Table;
  vtkVoxelLineModel* Output;
  /// The different curves of each brick, one brick after the other, and where each begins.
  std::vector<std::uint32_t> BrickCurves;
  std::vector<std::uint32_t> FirstCurves;
};

//------------------------------------------------------------------------------
void LevelWriter::WriteBricks()
{
  const std::size_t numberOfBricks = this->Table.Bricks.size() - 1;
  auto rows = MakeArray<vtkTypeUInt32Array>(WordsPerRow, numberOfBricks + 1);
  auto starts = MakeArray<vtkTypeUInt16Array>(1, this->Table.Lines.size() + numberOfBricks);
  std::uint16_t* start = starts->GetPointer(0);
  std::vector<std::uint32_t> curves;
  for (std::size_t brick = 0; brick <= numberOfBricks; ++brick)
  {
    const LevelTable::Brick& here = this->Table.Bricks[brick];
    std::uint32_t* row = rows->GetPointer(static_cast<vtkIdType>(WordsPerRow * brick));
    row[0] = static_cast<std::uint32_t>(here.Mask);
    row[1] = static_cast<std::uint32_t>(here.Mask >> 32);
    row[2] = here.First;
    row[3] = here.First + static_cast<std::uint32_t>(brick);
    row[4] = static_cast<std::uint32_t>(this->BrickCurves.size());
    this->FirstCurves.push_back(row[4]);
    if (brick == numberOfBricks)
    {
      break;
    }
    // One line per voxel, and the closing entry.
    const std::uint32_t size = this->Table.Bricks[brick + 1].First - here.First;
    curves.clear();
    for (std::uint32_t i = 0; i <= size; ++i)
    {
      *start++ = static_cast<std::uint16_t>(i);
      if (i < size)
      {
        curves.push_back(this->Table.Lines[here.First + i].Curve);
      }
    }
    std::sort(curves.begin(), curves.end());
    this->BrickCurves.insert(
      this->BrickCurves.end(), curves.begin(), std::unique(curves.begin(), curves.end()));
  }
  this->Output->SetBricks(rows);
  this->Output->SetVoxelStarts(starts);
  auto brickCurves = MakeArray<vtkTypeUInt32Array>(1, this->BrickCurves.size());
  std::copy(this->BrickCurves.begin(), this->BrickCurves.end(), brickCurves->GetPointer(0));
  this->Output->SetBrickCurves(brickCurves);
}

//------------------------------------------------------------------------------
void LevelWriter::WriteSegments()
{
  const vtkVoxelLineEncoding::Codec codec(this->Rules.FaceBins);
  const std::size_t size = this->Table.Lines.size();
  const std::size_t attributeSize = this->Rules.AttributeSize;
  vtkSmartPointer<vtkDataArray> segments;
  if (codec.FaceBins == 0)
  {
    segments = MakeArray<vtkFloatArray>(codec.Words, size);
  }
  else
  {
    segments = MakeArray<vtkTypeUInt32Array>(codec.Words, size);
  }
  this->Output->SetSegments(segments);
  void* words = segments->GetVoidPointer(0);
  std::uint8_t* attributes = nullptr;
  if (attributeSize > 0)
  {
    auto array = MakeArray<vtkUnsignedCharArray>(2 * static_cast<int>(attributeSize), size);
    attributes = array->GetPointer(0);
    this->Output->SetAttributes(array);
  }
  std::uint8_t* radii = nullptr;
  if (this->Source->GetRadii())
  {
    auto array = MakeArray<vtkUnsignedCharArray>(2, size);
    radii = array->GetPointer(0);
    this->Output->SetRadii(array);
  }
  // A brick has 64 curves at most, which the words of quantized ends tell apart.
  std::uint8_t* extension = nullptr;
  if (codec.CurveBits == 0)
  {
    auto array = MakeArray<vtkTypeUInt8Array>(1, size);
    extension = array->GetPointer(0);
    this->Output->SetCurveIdExtension(array);
  }

  const auto codeOf = [&codec](const RepresentativeEnd& end)
  {
    const double point[3] = { end.Local[0], end.Local[1], end.Local[2] };
    if (end.Face == NoFace)
    {
      return codec.InteriorCode(point);
    }
    const int axis = end.Face / 2;
    return codec.FaceCode(static_cast<std::uint32_t>(end.Face),
      codec.Bin(point[(axis + 1) % 3], codec.FaceBins),
      codec.Bin(point[(axis + 2) % 3], codec.FaceBins));
  };
  const auto write = [&](std::size_t i, std::uint32_t curve)
  {
    const Representative& line = this->Table.Lines[i];
    if (codec.FaceBins == 0)
    {
      float* target = static_cast<float*>(words) + 6 * i;
      std::copy_n(line.Ends[0].Local.begin(), 3, target);
      std::copy_n(line.Ends[1].Local.begin(), 3, target + 3);
      extension[i] = static_cast<std::uint8_t>(curve);
    }
    else
    {
      std::uint32_t* target =
        static_cast<std::uint32_t*>(words) + static_cast<std::size_t>(codec.Words) * i;
      codec.Pack(codeOf(line.Ends[0]), codeOf(line.Ends[1]), target);
      codec.PackCurve(curve, target);
    }
    for (std::size_t end = 0; end < 2; ++end)
    {
      std::copy_n(line.Ends[end].Attribute.begin(), attributeSize,
        attributes + attributeSize * (2 * i + end));
      if (radii)
      {
        radii[2 * i + end] = line.Ends[end].Radius;
      }
    }
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Table.Bricks.size()) - 1, BricksPerTask,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t brick = static_cast<std::size_t>(begin);
           brick < static_cast<std::size_t>(end); ++brick)
      {
        const auto first = this->BrickCurves.begin() + this->FirstCurves[brick];
        const auto last = this->BrickCurves.begin() + this->FirstCurves[brick + 1];
        for (std::size_t i = this->Table.Bricks[brick].First;
             i < this->Table.Bricks[brick + 1].First; ++i)
        {
          const auto curve = std::lower_bound(first, last, this->Table.Lines[i].Curve);
          write(i, static_cast<std::uint32_t>(curve - first));
        }
      }
    });
}

//------------------------------------------------------------------------------
void LevelWriter::WriteBrickGrid()
{
  std::vector<std::uint8_t> distances(this->Table.BrickOfCell.size());
  std::transform(this->Table.BrickOfCell.begin(), this->Table.BrickOfCell.end(), distances.begin(),
    [](std::int32_t brick) { return static_cast<std::uint8_t>(brick >= 0 ? 0 : 255); });
  vtkVoxelLineDistance::Transform(
    distances, this->Table.BrickDimensions, vtkVoxelLineModel::LargestBrickDistance);
  auto grid = MakeArray<vtkTypeInt32Array>(1, this->Table.BrickOfCell.size());
  std::transform(this->Table.BrickOfCell.begin(), this->Table.BrickOfCell.end(), distances.begin(),
    grid->GetPointer(0),
    [](std::int32_t brick, std::uint8_t distance)
    { return brick >= 0 ? brick : -static_cast<std::int32_t>(distance); });
  this->Output->SetBrickGrid(grid);
}

//------------------------------------------------------------------------------
void LevelWriter::WriteBounds()
{
  double low[3];
  double high[3];
  std::fill_n(low, 3, VTK_DOUBLE_MAX);
  std::fill_n(high, 3, -VTK_DOUBLE_MAX);
  for (const Representative& line : this->Table.Lines)
  {
    for (const RepresentativeEnd& end : line.Ends)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double coordinate = line.Voxel[axis] + static_cast<double>(end.Local[axis]);
        low[axis] = std::min(low[axis], coordinate);
        high[axis] = std::max(high[axis], coordinate);
      }
    }
  }
  double bounds[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = this->Output->GetOrigin()[axis] + this->Output->GetVoxelSize() * low[axis];
    bounds[2 * axis + 1] =
      this->Output->GetOrigin()[axis] + this->Output->GetVoxelSize() * high[axis];
  }
  this->Output->SetBounds(bounds);
}

//------------------------------------------------------------------------------
void LevelWriter::Write()
{
  this->Output->SetDimensions(this->Table.Dimensions);
  this->Output->SetOrigin(this->Source->GetOrigin());
  this->Output->SetVoxelSize(std::ldexp(this->Source->GetVoxelSize(), this->Rules.Level));
  this->Output->SetFaceBins(this->Rules.FaceBins);
  this->Output->SetAttributeKind(this->Source->GetAttributeKind());
  this->Output->SetAttributeRange(this->Source->GetAttributeRange());
  this->Output->SetHasNaNAttribute(this->Source->GetHasNaNAttribute());
  this->Output->SetMaximumRadius(this->Source->GetMaximumRadius());
  this->Output->SetNumberOfDroppedPoints(this->Source->GetNumberOfDroppedPoints());
  for (int reason = 0; reason < vtkVoxelLineModel::NumberOfDropReasons; ++reason)
  {
    this->Output->SetNumberOfDroppedCurves(reason, this->Source->GetNumberOfDroppedCurves(reason));
  }
  this->Output->SetLargestDeviation(std::numeric_limits<double>::quiet_NaN());
  this->Output->SetCurveCells(this->Source->GetCurveCells());
  this->WriteBricks();
  this->WriteSegments();
  this->WriteBrickGrid();
  this->WriteBounds();
}

}

//------------------------------------------------------------------------------
void WriteModel(vtkVoxelLineModel* source, const AveragingRules& rules, const LevelTable& table,
  vtkVoxelLineModel* output)
{
  LevelWriter writer(source, rules, table, output);
  writer.Write();
}

}
