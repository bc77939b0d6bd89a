// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsPieces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkLineSetsTuplesPrivate.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace
{
using Box = vtkLineSetsPieces::Box;

constexpr double Infinity = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
Box GetEmptyBox()
{
  return { Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity };
}

//------------------------------------------------------------------------------
void AddPoint(Box& box, const std::array<double, 3>& point)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // What is not a number changes nothing.
    box[2 * axis] = point[axis] < box[2 * axis] ? point[axis] : box[2 * axis];
    box[2 * axis + 1] = point[axis] > box[2 * axis + 1] ? point[axis] : box[2 * axis + 1];
  }
}

//------------------------------------------------------------------------------
bool Meet(const Box& a, const Box& b)
{
  bool meet = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    meet = meet && a[2 * axis] <= b[2 * axis + 1] && b[2 * axis] <= a[2 * axis + 1];
  }
  return meet;
}
}

//------------------------------------------------------------------------------
/// What was selected, with ids of the points of the result.
struct vtkLineSetsPieces::Output
{
  vtkNew<vtkIdList> Points;
  vtkNew<vtkIdList> Cells;
  vtkNew<vtkCellArray> Verts;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Polys;
  vtkNew<vtkCellArray> Strips;
  /// Places of the points of the data among those of the result, or -1.
  std::vector<vtkIdType> Ids;

  void AddCell(vtkCellArray* cells, const vtkIdType* ids, vtkIdType size, vtkIdType cell)
  {
    cells->InsertNextCell(static_cast<int>(size));
    for (vtkIdType i = 0; i < size; ++i)
    {
      vtkIdType& place = this->Ids[static_cast<std::size_t>(ids[i])];
      if (place < 0)
      {
        place = this->Points->InsertNextId(ids[i]);
      }
      cells->InsertCellPoint(place);
    }
    this->Cells->InsertNextId(cell);
  }
};

//------------------------------------------------------------------------------
vtkLineSetsPieces::vtkLineSetsPieces(vtkPolyData* data, vtkMatrix4x4* worldFromData, int blockSize)
  : Data(data)
  , BlockSize(blockSize)
{
  vtkPoints* points = data->GetPoints();
  this->Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  vtkSMPTools::For(0, data->GetNumberOfPoints(), 16384,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double point[4] = { 0.0, 0.0, 0.0, 1.0 };
        points->GetPoint(i, point);
        worldFromData->MultiplyPoint(point, point);
        std::copy_n(point, 3, this->Points[static_cast<std::size_t>(i)].begin());
      }
    });

  this->PartLines();
  const auto count = [this](vtkCellArray* cells)
  {
    vtkNew<vtkIdList> cell;
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      cells->GetCellAtId(i, cell);
      this->NumberOfInvalidCells +=
        this->AreValid(cell->GetPointer(0), cell->GetNumberOfIds()) ? 0 : 1;
    }
  };
  count(data->GetVerts());
  count(data->GetPolys());
  count(data->GetStrips());
}

//------------------------------------------------------------------------------
bool vtkLineSetsPieces::AreValid(const vtkIdType* ids, vtkIdType size) const
{
  const auto count = static_cast<vtkIdType>(this->Points.size());
  return std::all_of(ids, ids + size, [count](vtkIdType id) { return id >= 0 && id < count; });
}

//------------------------------------------------------------------------------
void vtkLineSetsPieces::PartLines()
{
  vtkCellArray* lines = this->Data->GetLines();
  const vtkIdType numberOfLines = lines->GetNumberOfCells();
  this->FirstBlocks.resize(static_cast<std::size_t>(numberOfLines) + 1, 0);
  vtkNew<vtkIdList> space;
  for (vtkIdType line = 0; line < numberOfLines; ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCellAtId(line, size, ids, space);
    const bool isValid = this->AreValid(ids, size);
    this->NumberOfInvalidCells += isValid ? 0 : 1;
    // Without blocks the line is in no box.
    const vtkIdType segments = isValid ? std::max<vtkIdType>(size - 1, 0) : 0;
    const auto i = static_cast<std::size_t>(line);
    this->FirstBlocks[i + 1] = this->FirstBlocks[i] +
      static_cast<std::size_t>((segments + this->BlockSize - 1) / this->BlockSize);
  }
  this->Blocks.resize(this->FirstBlocks.back());
  vtkSMPThreadLocalObject<vtkIdList> idLists;
  vtkSMPTools::For(0, numberOfLines, 256,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType line = begin; line < end; ++line)
      {
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        lines->GetCellAtId(line, size, ids, idLists.Local());
        const std::size_t first = this->FirstBlocks[static_cast<std::size_t>(line)];
        const std::size_t last = this->FirstBlocks[static_cast<std::size_t>(line) + 1];
        for (std::size_t block = first; block < last; ++block)
        {
          const vtkIdType from = static_cast<vtkIdType>(block - first) * this->BlockSize;
          this->Blocks[block] =
            this->GetBounds(ids + from, std::min(this->BlockSize + 1, size - from));
        }
      }
    });
}

//------------------------------------------------------------------------------
vtkLineSetsPieces::~vtkLineSetsPieces() = default;

//------------------------------------------------------------------------------
vtkLineSetsPieces::Box vtkLineSetsPieces::GetBounds(const vtkIdType* ids, vtkIdType size) const
{
  Box box = GetEmptyBox();
  for (vtkIdType i = 0; i < size; ++i)
  {
    AddPoint(box, this->Points[static_cast<std::size_t>(ids[i])]);
  }
  return box;
}

//------------------------------------------------------------------------------
bool vtkLineSetsPieces::IsClosed(const vtkIdType* ids, vtkIdType size) const
{
  return ids[0] == ids[size - 1] ||
    this->Points[static_cast<std::size_t>(ids[0])] ==
    this->Points[static_cast<std::size_t>(ids[size - 1])];
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkLineSetsPieces::Select(const Box& box) const
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  Output output;
  output.Ids.assign(this->Points.size(), -1);
  this->SelectVertices(box, output);
  this->SelectLines(box, output);
  this->SelectCells(box, output);
  if (output.Cells->GetNumberOfIds() == 0)
  {
    return result;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(this->Data->GetPoints()->GetDataType());
  points->SetNumberOfPoints(output.Points->GetNumberOfIds());
  this->Data->GetPoints()->GetData()->GetTuples(output.Points, points->GetData());
  result->SetPoints(points);
  result->SetVerts(output.Verts);
  result->SetLines(output.Lines);
  result->SetPolys(output.Polys);
  result->SetStrips(output.Strips);
  vtkLineSetsCopyTuples(this->Data->GetPointData(), output.Points, result->GetPointData());
  vtkLineSetsCopyTuples(this->Data->GetCellData(), output.Cells, result->GetCellData());
  result->GetFieldData()->ShallowCopy(this->Data->GetFieldData());
  return result;
}

//------------------------------------------------------------------------------
void vtkLineSetsPieces::SelectVertices(const Box& box, Output& output) const
{
  vtkCellArray* verts = this->Data->GetVerts();
  vtkNew<vtkIdList> space;
  std::vector<vtkIdType> inside;
  for (vtkIdType cell = 0; cell < verts->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    verts->GetCellAtId(cell, size, ids, space);
    inside.clear();
    std::copy_if(ids, ids + size, std::back_inserter(inside),
      [&](vtkIdType id) { return this->AreValid(&id, 1) && Meet(this->GetBounds(&id, 1), box); });
    if (!inside.empty())
    {
      output.AddCell(output.Verts, inside.data(), static_cast<vtkIdType>(inside.size()), cell);
    }
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsPieces::SelectLines(const Box& box, Output& output) const
{
  vtkCellArray* lines = this->Data->GetLines();
  const vtkIdType firstCell = this->Data->GetNumberOfVerts();
  vtkNew<vtkIdList> space;
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    const auto first = this->Blocks.begin() +
      static_cast<std::ptrdiff_t>(this->FirstBlocks[static_cast<std::size_t>(line)]);
    const auto last = this->Blocks.begin() +
      static_cast<std::ptrdiff_t>(this->FirstBlocks[static_cast<std::size_t>(line) + 1]);
    const auto isNear = [&box](const Box& block) { return Meet(block, box); };
    auto near = std::find_if(first, last, isNear);
    if (near == last)
    {
      continue;
    }
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCellAtId(line, size, ids, space);
    const vtkIdType cell = firstCell + line;
    if (this->IsClosed(ids, size))
    {
      output.AddCell(output.Lines, ids, size, cell);
      continue;
    }
    while (near != last)
    {
      // A block more to either side, and gaps of two blocks or less are filled by that.
      const auto begin = near == first ? near : near - 1;
      auto end = near + 1;
      for (auto block = end; block != last && block - end < 3; ++block)
      {
        end = isNear(*block) ? block + 1 : end;
      }
      near = std::find_if(end, last, isNear);
      end = end == last ? end : end + 1;
      const vtkIdType from = (begin - first) * this->BlockSize;
      const vtkIdType to = std::min((end - first) * this->BlockSize, size - 1);
      output.AddCell(output.Lines, ids + from, to - from + 1, cell);
    }
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsPieces::SelectCells(const Box& box, Output& output) const
{
  vtkNew<vtkIdList> space;
  vtkIdType cell = this->Data->GetNumberOfVerts() + this->Data->GetNumberOfLines();
  const auto select = [&](vtkCellArray* from, vtkCellArray* to)
  {
    for (vtkIdType i = 0; i < from->GetNumberOfCells(); ++i, ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      from->GetCellAtId(i, size, ids, space);
      if (this->AreValid(ids, size) && Meet(this->GetBounds(ids, size), box))
      {
        output.AddCell(to, ids, size, cell);
      }
    }
  };
  select(this->Data->GetPolys(), output.Polys);
  select(this->Data->GetStrips(), output.Strips);
}
