// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsThinning.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkIdList.h"
#include "vtkLineSetsLeavesPrivate.h"
#include "vtkLineSetsTuplesPrivate.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
/// Calls visit(vtkPolyData*) for each leaf that is one.
template <typename Visitor>
void VisitParts(vtkDataObject* data, Visitor&& visit)
{
  vtkLineSetsLeaves::Visit(data,
    [&visit](vtkDataObject* leaf, unsigned int)
    {
      if (auto* part = vtkPolyData::SafeDownCast(leaf))
      {
        visit(part);
      }
    });
}

//------------------------------------------------------------------------------
/// Numbers of the points of the source, and of the result where they are used there.
class PointNumbers
{
public:
  explicit PointNumbers(vtkIdType count)
    : News(count, -1)
  {
  }

  /// The new number of each point of a cell; false where a point does not exist.
  bool Renumber(vtkIdList* cell)
  {
    const auto count = static_cast<vtkIdType>(this->News.size());
    const vtkIdType* ids = cell->GetPointer(0);
    if (std::any_of(ids, ids + cell->GetNumberOfIds(),
          [count](vtkIdType id) { return id < 0 || id >= count; }))
    {
      return false;
    }
    for (vtkIdType i = 0; i < cell->GetNumberOfIds(); ++i)
    {
      vtkIdType& number = this->News[cell->GetId(i)];
      if (number < 0)
      {
        number = this->Olds->InsertNextId(cell->GetId(i));
      }
      cell->SetId(i, number);
    }
    return true;
  }

  vtkIdList* GetOlds() { return this->Olds; }

private:
  std::vector<vtkIdType> News;
  vtkNew<vtkIdList> Olds;
};

//------------------------------------------------------------------------------
/// Every step-th cell, numbered anew; kept gets the numbers of the cells, counted from first.
vtkSmartPointer<vtkCellArray> ThinCells(
  vtkCellArray* cells, vtkIdType step, vtkIdType first, PointNumbers& points, vtkIdList* kept)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); i += step)
  {
    cells->GetCellAtId(i, cell);
    if (points.Renumber(cell))
    {
      result->InsertNextCell(cell);
      kept->InsertNextId(first + i);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ThinPart(vtkPolyData* part, vtkIdType step)
{
  auto thinned = vtkSmartPointer<vtkPolyData>::New();
  PointNumbers points(part->GetNumberOfPoints());
  vtkNew<vtkIdList> cells;
  thinned->SetVerts(ThinCells(part->GetVerts(), step, 0, points, cells));
  thinned->SetLines(ThinCells(part->GetLines(), step, part->GetNumberOfVerts(), points, cells));
  vtkNew<vtkPoints> positions;
  if (part->GetPoints())
  {
    positions->SetDataType(part->GetPoints()->GetDataType());
    positions->SetNumberOfPoints(points.GetOlds()->GetNumberOfIds());
    part->GetPoints()->GetPoints(points.GetOlds(), positions);
  }
  thinned->SetPoints(positions);
  vtkLineSetsCopyTuples(part->GetPointData(), points.GetOlds(), thinned->GetPointData());
  vtkLineSetsCopyTuples(part->GetCellData(), cells, thinned->GetCellData());
  thinned->GetFieldData()->ShallowCopy(part->GetFieldData());
  return thinned;
}

//------------------------------------------------------------------------------
vtkIdType GetStep(vtkDataObject* data, double resolution)
{
  double count = 0.0;
  VisitParts(data, [&](vtkPolyData* part) { count += part->GetNumberOfPoints(); });
  const double divisions = 10.0 + 150.0 * std::min(std::max(resolution, 0.0), 1.0);
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int ranks = controller ? controller->GetNumberOfProcesses() : 1;
  const double most = 100.0 * divisions * divisions / ranks;
  return std::max<vtkIdType>(2, static_cast<vtkIdType>(std::ceil(count / most)));
}
}

//------------------------------------------------------------------------------
bool vtkLineSetsThinning::IsPossible(vtkDataObject* data)
{
  vtkIdType lines = 0;
  vtkIdType faces = 0;
  VisitParts(data,
    [&](vtkPolyData* part)
    {
      lines += part->GetNumberOfLines();
      faces += part->GetNumberOfPolys() + part->GetNumberOfStrips();
    });
  return lines > 0 && faces == 0;
}

//------------------------------------------------------------------------------
vtkDataObject* vtkLineSetsThinning::Thin(vtkDataObject* data, double resolution)
{
  if (this->Data == data && this->Resolution == resolution &&
    data->GetMTime() < this->ThinTime.GetMTime())
  {
    return this->Thinned;
  }
  const vtkIdType step = GetStep(data, resolution);
  if (auto* single = vtkPolyData::SafeDownCast(data))
  {
    this->Thinned = ThinPart(single, step);
  }
  else if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    using Options = vtk::DataObjectTreeOptions;
    auto thinned = vtk::TakeSmartPointer(tree->NewInstance());
    thinned->CompositeShallowCopy(tree);
    for (auto leaf : vtk::Range(thinned.Get(),
           Options::TraverseSubTree | Options::VisitOnlyLeaves | Options::SkipEmptyNodes))
    {
      if (auto* part = vtkPolyData::SafeDownCast(leaf.GetDataObject()))
      {
        leaf.SetDataObject(ThinPart(part, step));
      }
    }
    this->Thinned = thinned;
  }
  this->Data = data;
  this->Resolution = resolution;
  this->ThinTime.Modified();
  return this->Thinned;
}
