// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineSelection.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkVoxelLineMapper.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
void SetColor(std::uint8_t* color, vtkIdType value)
{
  color[0] = static_cast<std::uint8_t>(value & 0xff);
  color[1] = static_cast<std::uint8_t>((value >> 8) & 0xff);
  color[2] = static_cast<std::uint8_t>((value >> 16) & 0xff);
  color[3] = 255;
}

// The number whose colour the selector has set for the whole prop.
vtkIdType GetPropValue(vtkHardwareSelector* selector)
{
  const float* color = selector->GetPropColorValue();
  vtkIdType value = 0;
  for (int i = 2; i >= 0; --i)
  {
    value = (value << 8) | static_cast<vtkIdType>(std::lround(color[i] * 255.0f));
  }
  return value;
}

// The array of that name, where there is one of that type with a value for each tuple.
vtkDataArray* FindArray(vtkFieldData* data, const char* name, int type)
{
  vtkDataArray* array = name && name[0] ? data->GetArray(name) : nullptr;
  return array && array->GetDataType() == type && array->GetNumberOfComponents() == 1 ? array
                                                                                      : nullptr;
}

vtkIdType GetLargest(vtkIdTypeArray* ids)
{
  vtkIdType largest = -1;
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    largest = std::max(largest, ids->GetValue(i));
  }
  return largest;
}

vtkIdType GetId(vtkIdTypeArray* ids, vtkIdType index)
{
  return ids ? ids->GetValue(index) : index;
}

// Of the first point of a line; no line passes from one process to another.
vtkIdType GetProcess(vtkPolyData* input, vtkDataArray* processes, vtkIdType cell)
{
  vtkNew<vtkIdList> points;
  input->GetLines()->GetCellAtId(cell - input->GetNumberOfVerts(), points);
  const vtkIdType point = points->GetNumberOfIds() > 0 ? points->GetId(0) : -1;
  return point >= 0 && point < processes->GetNumberOfTuples()
    ? static_cast<vtkIdType>(processes->GetComponent(point, 0))
    : 0;
}
}

//------------------------------------------------------------------------------
vtkVoxelLineSelection::Arrays vtkVoxelLineSelection::GetArrays(
  vtkVoxelLineMapper* mapper, vtkPolyData* input)
{
  Arrays arrays;
  if (!input)
  {
    return arrays;
  }
  vtkPointData* points = input->GetPointData();
  vtkCellData* cells = input->GetCellData();
  arrays.PointIds =
    vtkIdTypeArray::SafeDownCast(FindArray(points, mapper->GetPointIdArrayName(), VTK_ID_TYPE));
  arrays.CellIds =
    vtkIdTypeArray::SafeDownCast(FindArray(cells, mapper->GetCellIdArrayName(), VTK_ID_TYPE));
  arrays.CompositeIds = FindArray(cells, mapper->GetCompositeIdArrayName(), VTK_UNSIGNED_INT);
  arrays.ProcessIds = FindArray(points, mapper->GetProcessIdArrayName(), VTK_UNSIGNED_INT);
  return arrays;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineSelection::GetLargestCell(vtkVoxelLineModel* model, const Arrays& arrays)
{
  if (arrays.CellIds)
  {
    return GetLargest(arrays.CellIds);
  }
  vtkIdType largest = -1;
  vtkIdTypeArray* cells = model->GetCurveCells();
  for (vtkIdType i = 0; cells && i < cells->GetNumberOfTuples(); ++i)
  {
    largest = std::max(largest, cells->GetTypedComponent(i, 1));
  }
  return largest;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineSelection::GetLargestPoint(vtkPolyData* input, const Arrays& arrays)
{
  return arrays.PointIds ? GetLargest(arrays.PointIds) : input->GetNumberOfPoints() - 1;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> vtkVoxelLineSelection::GetPoints(vtkVoxelLineModel* model,
  vtkPolyData* input, const vtkVoxelLineFrame& frame, const vtkVoxelLineFrameBuilder::Grid& grid,
  const vtkVoxelLinePicture& picture)
{
  std::vector<vtkIdType> points(picture.Curve.size(), 0);
  vtkIdTypeArray* cells = model->GetCurveCells();
  vtkCellArray* lines = input->GetLines();
  const vtkIdType firstLine = input->GetNumberOfVerts();
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkSMPTools::For(0, static_cast<vtkIdType>(points.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdList* list = lists.Local();
      for (vtkIdType pixel = begin; pixel < end; ++pixel)
      {
        if (picture.Curve[pixel] < 0)
        {
          continue;
        }
        double seen[3];
        vtkVoxelLineFrameBuilder::GetDataPosition(frame, grid,
          static_cast<int>(pixel % frame.Width), static_cast<int>(pixel / frame.Width),
          picture.Depth[pixel], seen);
        lines->GetCellAtId(cells->GetTypedComponent(picture.Curve[pixel], 1) - firstLine, list);
        double smallest = std::numeric_limits<double>::max();
        for (vtkIdType i = 0; i < list->GetNumberOfIds(); ++i)
        {
          double point[3];
          const vtkIdType id = list->GetId(i);
          if (id < 0 || id >= input->GetNumberOfPoints())
          {
            continue;
          }
          input->GetPoint(id, point);
          // Not true for points that are not finite.
          const double distance = vtkMath::Distance2BetweenPoints(point, seen);
          if (distance < smallest)
          {
            smallest = distance;
            points[pixel] = id;
          }
        }
      }
    });
  return points;
}

//------------------------------------------------------------------------------
void vtkVoxelLineSelection::GetColors(vtkHardwareSelector* selector, vtkVoxelLineModel* model,
  vtkPolyData* input, const Arrays& arrays, const vtkVoxelLinePicture& picture,
  const std::vector<vtkIdType>& points, std::vector<std::uint8_t>& colors)
{
  const int pass = selector->GetCurrentPass();
  const vtkIdType propValue = GetPropValue(selector);
  const bool areProcessesKnown = selector->GetUseProcessIdFromData() && arrays.ProcessIds;
  vtkIdTypeArray* cells = model->GetCurveCells();
  colors.assign(4 * picture.Curve.size(), 0);
  for (std::size_t pixel = 0; pixel < picture.Curve.size(); ++pixel)
  {
    const vtkIdType curve = picture.Curve[pixel];
    if (curve < 0)
    {
      continue;
    }
    const vtkIdType cell = cells->GetTypedComponent(curve, 1);
    const vtkIdType point = points.empty() ? 0 : points[pixel];
    vtkIdType value = propValue;
    switch (pass)
    {
      case vtkHardwareSelector::PROCESS_PASS:
        if (areProcessesKnown)
        {
          value = 1 + GetProcess(input, arrays.ProcessIds, cell);
        }
        break;
      case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
        value = arrays.CompositeIds
          ? static_cast<vtkIdType>(arrays.CompositeIds->GetComponent(cell, 0))
          : 1 + cells->GetTypedComponent(curve, 0);
        break;
      case vtkHardwareSelector::POINT_ID_LOW24:
        value = GetId(arrays.PointIds, point) & 0xffffff;
        break;
      case vtkHardwareSelector::POINT_ID_HIGH24:
        value = GetId(arrays.PointIds, point) >> 24;
        break;
      case vtkHardwareSelector::CELL_ID_LOW24:
        value = GetId(arrays.CellIds, cell) & 0xffffff;
        break;
      case vtkHardwareSelector::CELL_ID_HIGH24:
        value = GetId(arrays.CellIds, cell) >> 24;
        break;
      default: // the prop's number
        break;
    }
    SetColor(colors.data() + 4 * pixel, value);
  }
}
