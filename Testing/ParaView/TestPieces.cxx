// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards that cells which name points that do not exist are counted and left out of the pieces of
 * lines, and cost neither the process nor the other cells, whose arrays come along. Also which
 * pieces of lines a box gets: the blocks in it and one more to either side, from multiples of the
 * block's size on, closed lines whole, and of the other cells those in it, all in world
 * coordinates.
 */

#include "vtkLineSetsPieces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <vector>

namespace
{
constexpr vtkIdType Far = 1000000000000;

void AddCell(vtkCellArray* cells, std::initializer_list<vtkIdType> ids)
{
  cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.begin());
}

/// Points along x at 0 to 9; each kind of cell with a valid one behind or before others.
vtkSmartPointer<vtkPolyData> MakeCells()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> x;
  x->SetName("x");
  for (int i = 0; i < 10; ++i)
  {
    points->InsertNextPoint(i, 0.0, 0.0);
    x->InsertNextValue(i);
  }
  vtkNew<vtkCellArray> cells[4];
  AddCell(cells[0], { 0, Far, 1, -1, 2 });
  AddCell(cells[0], { 3 });
  AddCell(cells[1], { 0, 1, Far });
  AddCell(cells[1], { 1, 2, 3, 4 });
  AddCell(cells[1], { -7, 2, 3, 4 });
  AddCell(cells[1], { 10, 9, 10 });
  AddCell(cells[1], { 5, 6 });
  AddCell(cells[2], { 0, 1, Far });
  AddCell(cells[2], { 7, 8, 9 });
  AddCell(cells[3], { 0, 1, 2, -1 });
  AddCell(cells[3], { 6, 7, 8, 9 });
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cells[0]);
  data->SetLines(cells[1]);
  data->SetPolys(cells[2]);
  data->SetStrips(cells[3]);
  data->GetPointData()->AddArray(x);
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("number");
  for (int i = 0; i < 11; ++i)
  {
    numbers->InsertNextValue(i);
  }
  data->GetCellData()->AddArray(numbers);
  return data;
}

bool Check(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
  }
  return condition;
}

/// Each cell as the places along x that its points have in the data.
using Pieces = std::vector<std::vector<int>>;

Pieces GetPieces(vtkPolyData* data, vtkCellArray* cells)
{
  Pieces pieces;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, ids);
    pieces.emplace_back();
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      pieces.back().push_back(static_cast<int>(std::lround(data->GetPoint(ids->GetId(k))[0])));
    }
  }
  return pieces;
}

std::vector<int> Range(int first, int last)
{
  std::vector<int> range;
  for (int i = first; i <= last; ++i)
  {
    range.push_back(i);
  }
  return range;
}

/// A line along x from 0 to 20, whose points are at y = 1 but for those given, at y = 0.
vtkSmartPointer<vtkPolyData> MakeLine(std::initializer_list<int> near)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(21);
  for (int i = 0; i <= 20; ++i)
  {
    points->InsertNextPoint(i, std::count(near.begin(), near.end(), i) > 0 ? 0.0 : 1.0, 0.0);
    lines->InsertCellPoint(i);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

/// Blocks of two segments: block i has the points 2 i to 2 i + 2.
bool CheckLine(const char* what, std::initializer_list<int> near, const Pieces& expected)
{
  vtkSmartPointer<vtkPolyData> line = MakeLine(near);
  vtkNew<vtkMatrix4x4> identity;
  const vtkLineSetsPieces pieces(line, identity, 2);
  vtkSmartPointer<vtkPolyData> found = pieces.Select({ -1.0, 30.0, -0.5, 0.5, -1.0, 1.0 });
  return Check(GetPieces(found, found->GetLines()) == expected, what);
}

bool CheckBlocks()
{
  bool isGood = CheckLine("one block and its neighbours", { 9 }, { Range(6, 12) });
  isGood &= CheckLine("two blocks share a point", { 8 }, { Range(4, 12) });
  isGood &= CheckLine("the first block", { 0 }, { Range(0, 4) });
  isGood &= CheckLine("the last block", { 20 }, { Range(16, 20) });
  isGood &= CheckLine("a gap of two blocks", { 5, 11 }, { Range(2, 14) });
  isGood &= CheckLine("a gap of three blocks", { 5, 13 }, { Range(2, 8), Range(10, 16) });
  isGood &= CheckLine("no block", {}, {});

  // In the world, the line lies elsewhere, and one point nowhere.
  vtkSmartPointer<vtkPolyData> line = MakeLine({});
  line->GetPoints()->SetPoint(5, std::numeric_limits<double>::quiet_NaN(), 1.0, 0.0);
  vtkNew<vtkMatrix4x4> moved;
  moved->SetElement(0, 3, 100.0);
  const vtkLineSetsPieces pieces(line, moved, 2);
  vtkSmartPointer<vtkPolyData> found = pieces.Select({ 112.5, 113.5, 0.0, 1.0, -1.0, 1.0 });
  isGood &= Check(GetPieces(found, found->GetLines()) == Pieces{ Range(10, 16) },
    "the box is in world coordinates");
  found = pieces.Select({ 103.9, 104.0, 0.0, 1.0, -1.0, 1.0 });
  isGood &= Check(found->GetNumberOfLines() == 1 && found->GetNumberOfPoints() == 9,
    "the rest of a block with a point that is not a number");
  return isGood;
}

bool CheckClosedLines()
{
  bool isGood = true;
  for (const bool isSameId : { true, false })
  {
    vtkSmartPointer<vtkPolyData> line = MakeLine({ 9 });
    if (isSameId)
    {
      line->GetLines()->ReplaceCellPointAtId(0, 20, 0);
    }
    else
    {
      line->GetPoints()->SetPoint(20, line->GetPoint(0));
    }
    vtkNew<vtkMatrix4x4> identity;
    const vtkLineSetsPieces pieces(line, identity, 2);
    vtkSmartPointer<vtkPolyData> found = pieces.Select({ -1.0, 30.0, -0.5, 0.5, -1.0, 1.0 });
    std::vector<int> whole = Range(0, 19);
    whole.push_back(0);
    isGood &=
      Check(GetPieces(found, found->GetLines()) == Pieces{ whole }, "closed lines stay whole");
  }
  return isGood;
}

/// Of poly-vertices the points in the box, of polygons and strips those that it meets.
bool CheckOtherCells(const vtkLineSetsPieces& pieces)
{
  vtkSmartPointer<vtkPolyData> found = pieces.Select({ 1.5, 6.5, -1.0, 1.0, -1.0, 1.0 });
  bool isGood = Check(GetPieces(found, found->GetVerts()) == Pieces{ { 2 }, { 3 } },
    "points of poly-vertices in the box");
  isGood &= Check(found->GetNumberOfPolys() == 0, "polygons beside the box");
  isGood &= Check(
    GetPieces(found, found->GetStrips()) == Pieces{ { 6, 7, 8, 9 } }, "strips that meet the box");
  return isGood;
}
}

int main()
{
  vtkSmartPointer<vtkPolyData> cells = MakeCells();
  vtkNew<vtkMatrix4x4> identity;
  const vtkLineSetsPieces pieces(cells, identity, 2);
  vtkSmartPointer<vtkPolyData> all = pieces.Select({ -1.0, 10.0, -1.0, 1.0, -1.0, 1.0 });

  bool isGood = Check(pieces.GetNumberOfInvalidCells() == 6, "six cells are told");
  isGood &= Check(all->GetNumberOfVerts() == 2 && all->GetNumberOfLines() == 2 &&
      all->GetNumberOfPolys() == 1 && all->GetNumberOfStrips() == 1,
    "the valid cells are there");
  const double expected[] = { 0.0, 1.0, 3.0, 6.0, 8.0, 10.0 };
  vtkDataArray* numbers = all->GetCellData()->GetArray("number");
  for (vtkIdType i = 0; numbers && i < 6; ++i)
  {
    isGood &= Check(numbers->GetTuple1(i) == expected[i], "cells keep their arrays");
  }
  vtkDataArray* x = all->GetPointData()->GetArray("x");
  isGood &= Check(numbers && x && all->GetNumberOfPoints() == 10, "all valid points are there");
  for (vtkIdType i = 0; x && i < all->GetNumberOfPoints(); ++i)
  {
    isGood &= Check(x->GetTuple1(i) == all->GetPoint(i)[0], "points keep their arrays");
  }
  // Vertices of a cell are points by themselves.
  isGood &= Check(all->GetVerts()->GetCellSize(0) == 3, "vertices keep the points that exist");

  vtkSmartPointer<vtkPolyData> none = pieces.Select({ 20.0, 30.0, -1.0, 1.0, -1.0, 1.0 });
  isGood &= Check(none->GetNumberOfCells() == 0, "nothing is far away");
  isGood &= CheckOtherCells(pieces);
  isGood &= CheckBlocks();
  isGood &= CheckClosedLines();
  return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
