// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards that cells which name points that do not exist are counted and left out of the pieces of
 * lines, and cost neither the process nor the other cells, whose arrays come along.
 */

#include "vtkLineSetsPieces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstdlib>
#include <initializer_list>
#include <iostream>

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
  return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
