// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CapsulesFromModel.h"

#include "vtkDataArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace linesets
{
namespace
{
double DecodeScalar(vtkVoxelLineModel* model, unsigned char byte)
{
  if (model->GetHasNaNAttribute() && byte == 255)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double* range = model->GetAttributeRange();
  const double steps = model->GetHasNaNAttribute() ? 254.0 : 255.0;
  return range[0] + byte / steps * (range[1] - range[0]);
}

void DecodeAttributes(vtkVoxelLineModel* model, vtkIdType segment, Capsule& capsule)
{
  vtkUnsignedCharArray* attributes = model->GetAttributes();
  if (attributes && model->GetAttributeKind() == vtkVoxelLineModel::Scalar)
  {
    capsule.StartValue = DecodeScalar(model, attributes->GetTypedComponent(segment, 0));
    capsule.EndValue = DecodeScalar(model, attributes->GetTypedComponent(segment, 1));
  }
  else if (attributes && model->GetAttributeKind() == vtkVoxelLineModel::Color)
  {
    for (int i = 0; i < 4; ++i)
    {
      capsule.StartColor[i] = attributes->GetTypedComponent(segment, i);
      capsule.EndColor[i] = attributes->GetTypedComponent(segment, 4 + i);
    }
  }
  if (vtkUnsignedCharArray* radii = model->GetRadii())
  {
    const double step = model->GetMaximumRadius() / 255.0;
    capsule.StartRadius = step * radii->GetTypedComponent(segment, 0);
    capsule.EndRadius = step * radii->GetTypedComponent(segment, 1);
  }
}

// The segments of one voxel.
struct Voxel
{
  int Index[3];
  vtkIdType Brick;
  vtkIdType First;
  vtkIdType Last;
};

void DecodeVoxel(vtkVoxelLineModel* model, const Voxel& voxel, double radius, CapsuleScene& scene)
{
  const double size = model->GetVoxelSize();
  for (vtkIdType segment = voxel.First; segment < voxel.Last; ++segment)
  {
    Capsule& capsule = scene.Capsules[segment];
    model->GetSegmentPoints(segment, capsule.Start, capsule.End);
    for (int i = 0; i < 3; ++i)
    {
      capsule.Start[i] = size * (voxel.Index[i] + capsule.Start[i]);
      capsule.End[i] = size * (voxel.Index[i] + capsule.End[i]);
    }
    capsule.StartRadius = radius;
    capsule.EndRadius = radius;
    DecodeAttributes(model, segment, capsule);
    capsule.Curve = model->GetSegmentCurve(voxel.Brick, segment);
  }
}

void DecodeBrick(vtkVoxelLineModel* model, const int corner[3], vtkIdType brick, double radius,
  CapsuleScene& scene)
{
  vtkDataArray* bricks = model->GetBricks();
  vtkDataArray* starts = model->GetVoxelStarts();
  const auto low = static_cast<std::uint64_t>(bricks->GetComponent(brick, 0));
  const auto high = static_cast<std::uint64_t>(bricks->GetComponent(brick, 1));
  const std::uint64_t mask = low | (high << 32);
  const auto firstSegment = static_cast<vtkIdType>(bricks->GetComponent(brick, 2));
  auto start = static_cast<vtkIdType>(bricks->GetComponent(brick, 3));
  for (int bit = 0; bit < 64; ++bit)
  {
    if (!((mask >> bit) & 1u))
    {
      continue;
    }
    Voxel voxel;
    voxel.Index[0] = corner[0] + bit % 4;
    voxel.Index[1] = corner[1] + bit / 4 % 4;
    voxel.Index[2] = corner[2] + bit / 16;
    voxel.Brick = brick;
    voxel.First = firstSegment + static_cast<vtkIdType>(starts->GetComponent(start, 0));
    voxel.Last = firstSegment + static_cast<vtkIdType>(starts->GetComponent(start + 1, 0));
    DecodeVoxel(model, voxel, radius, scene);
    ++start;
  }
}
}

//------------------------------------------------------------------------------
CapsuleScene MakeCapsulesFromModel(vtkVoxelLineModel* model, double radius)
{
  CapsuleScene scene;
  std::copy_n(model->GetOrigin(), 3, scene.Origin);
  if (model->GetAttributes())
  {
    scene.Colors = model->GetAttributeKind() == vtkVoxelLineModel::Color ? ColorSource::Direct
      : model->GetAttributeKind() == vtkVoxelLineModel::Scalar           ? ColorSource::Scalars
                                                                         : ColorSource::Material;
  }
  scene.Capsules.resize(model->GetNumberOfSegments());
  int dimensions[3];
  model->GetBrickDimensions(dimensions);
  vtkDataArray* grid = model->GetBrickGrid();
  vtkIdType cell = 0;
  for (int z = 0; z < dimensions[2]; ++z)
  {
    for (int y = 0; y < dimensions[1]; ++y)
    {
      for (int x = 0; x < dimensions[0]; ++x, ++cell)
      {
        const double brick = grid->GetComponent(cell, 0);
        if (brick >= 0.0)
        {
          const int corner[3] = { 4 * x, 4 * y, 4 * z };
          DecodeBrick(model, corner, static_cast<vtkIdType>(brick), radius, scene);
        }
      }
    }
  }
  return scene;
}
}
