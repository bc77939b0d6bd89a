// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsShare.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMPIMoveData.h"
#include "vtkMultiProcessController.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"

#include <algorithm>
#include <limits>

namespace
{
/// What a rank does not have, in a reduction to the largest value.
constexpr double Nothing = std::numeric_limits<double>::lowest();

//------------------------------------------------------------------------------
/// Bounds of which all sides are those of a union where they are largest.
void TurnBounds(const double bounds[6], double turned[6])
{
  for (int side = 0; side < 6; ++side)
  {
    const double value = side % 2 == 0 ? -bounds[side] : bounds[side];
    turned[side] = bounds[0] <= bounds[1] ? value : Nothing;
  }
}
}

//------------------------------------------------------------------------------
void vtkLineSetsShare::SetView(vtkPVRenderView* view, bool isDetail)
{
  this->Controller = nullptr;
  this->Boxes.clear();
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  // In other modes of delivery a process that draws has all lines.
  if (!view || !controller || controller->GetNumberOfProcesses() < 2 ||
    view->GetDataDistributionMode(isDetail) != vtkMPIMoveData::PASS_THROUGH)
  {
    return;
  }
  this->Controller = controller;
  auto* manager = vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  // There are no boxes where there is no data at all.
  if (view->GetUseOrderedCompositing() && manager &&
    static_cast<int>(manager->GetCuts().size()) == controller->GetNumberOfProcesses())
  {
    this->Boxes = vtkLineSetsDistribution::OpenBoxes(manager->GetCuts());
  }
}

//------------------------------------------------------------------------------
bool vtkLineSetsShare::HasExtent(vtkDataObject* data)
{
  double bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    composite->GetBounds(bounds);
  }
  double mine[6];
  TurnBounds(bounds, mine);
  double all[6];
  std::copy(mine, mine + 6, all);
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    controller->AllReduce(mine, all, 6, vtkCommunicator::MAX_OP);
  }
  return all[0] > Nothing && (-all[0] < all[1] || -all[2] < all[3] || -all[4] < all[5]);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkLineSetsShare::Complete(vtkPolyData* lines, const std::vector<std::string>& names,
  const std::set<vtkLineSetsSpread::Identity>& leftOut)
{
  return this->IsParted() ? this->Completion.Complete(lines, names, leftOut, this->Controller)
                          : lines;
}

//------------------------------------------------------------------------------
vtkLineSetsShare::Measures vtkLineSetsShare::Reduce(const Measures& measures, vtkPolyData* lines)
{
  double mine[10];
  TurnBounds(measures.Bounds, mine);
  const bool hasRange = measures.AttributeRange[0] <= measures.AttributeRange[1];
  mine[6] = hasRange ? -measures.AttributeRange[0] : Nothing;
  mine[7] = hasRange ? measures.AttributeRange[1] : Nothing;
  mine[8] = measures.MaximumRadius;
  mine[9] = this->Distribution.IsChanged(lines) ? 1.0 : 0.0;

  double all[10];
  this->Controller->AllReduce(mine, all, 10, vtkCommunicator::MAX_OP);

  Measures shared;
  if (all[1] > Nothing)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      shared.Bounds[2 * axis] = -all[2 * axis];
      shared.Bounds[2 * axis + 1] = all[2 * axis + 1];
    }
  }
  if (all[7] > Nothing)
  {
    shared.AttributeRange[0] = -all[6];
    shared.AttributeRange[1] = all[7];
  }
  shared.MaximumRadius = all[8];
  this->IsChanged = all[9] > 0.0;
  return shared;
}

//------------------------------------------------------------------------------
vtkPolyData* vtkLineSetsShare::Distribute(vtkPolyData* lines, vtkMatrix4x4* matrix, double margin)
{
  return this->Distribution.Distribute(
    lines, this->IsChanged, this->Boxes, matrix, margin, this->Controller);
}

//------------------------------------------------------------------------------
void vtkLineSetsShare::Release()
{
  this->Completion.Release();
  this->Distribution.Release();
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkLineSetsShare::GetWarnings() const
{
  std::vector<std::string> warnings = this->Completion.GetWarnings();
  if (this->Distribution.GetNumberOfInvalidCells() > 0)
  {
    warnings.push_back(std::to_string(this->Distribution.GetNumberOfInvalidCells()) +
      " cells name points that do not exist: they are not drawn, but for the other points of "
      "poly-vertices.");
  }
  return warnings;
}

//------------------------------------------------------------------------------
vtkLineSetsDistribution::Box vtkLineSetsShare::GetRegion() const
{
  return this->IsOrdered()
    ? this->Boxes[static_cast<std::size_t>(this->Controller->GetLocalProcessId())]
    : vtkLineSetsDistribution::GetOpenBox();
}
