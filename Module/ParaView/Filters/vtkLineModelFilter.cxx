// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineModelFilter.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkLineSetsCheckedValuePrivate.h"
#include "vtkLineSetsCompatibilityPrivate.h"
#include "vtkLineSetsLeavesPrivate.h"
#include "vtkLineVoxelizer.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
constexpr int LargestLevel = 12;

//------------------------------------------------------------------------------
/// The part of this filter's progress that a filter inside has.
struct Share
{
  vtkAlgorithm* Filter;
  double First;
  double Last;
};

void OnProgress(vtkObject* caller, unsigned long, void* data, void* progress)
{
  const Share& share = *static_cast<Share*>(data);
  const double part = *static_cast<double*>(progress);
  share.Filter->UpdateProgress(share.First + part * (share.Last - share.First));
  if (vtkLineSetsCompatibility::CheckAbort(share.Filter))
  {
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  }
}

//------------------------------------------------------------------------------
/// Grow lows and highs by the finite points that lines of two points or more use.
void AddLines(vtkPolyData* data, double lows[3], double highs[3])
{
  if (!data->GetPoints() || !data->GetLines())
  {
    return;
  }
  const vtkIdType numberOfPoints = data->GetNumberOfPoints();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  auto lines = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
  {
    lines->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; size > 1 && i < size; ++i)
    {
      if (ids[i] < 0 || ids[i] >= numberOfPoints)
      {
        continue;
      }
      double point[3];
      data->GetPoint(ids[i], point);
      if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          lows[axis] = std::min(lows[axis], point[axis]);
          highs[axis] = std::max(highs[axis], point[axis]);
        }
      }
    }
  }
}
}

//------------------------------------------------------------------------------
vtkLineModelFilter::vtkLineModelFilter()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkLineModelFilter::~vtkLineModelFilter() = default;

//------------------------------------------------------------------------------
void vtkLineModelFilter::SetResolution(int resolution)
{
  vtkLineSetsSetInRange<int>(
    this, "Resolution", this->Resolution, resolution, 1, vtkLineVoxelizer::LargestResolution);
}

//------------------------------------------------------------------------------
void vtkLineModelFilter::SetLevel(int level)
{
  vtkLineSetsSetInRange<int>(this, "Level", this->Level, level, 0, LargestLevel);
}

//------------------------------------------------------------------------------
void vtkLineModelFilter::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkLineModelFilter::GetController() const
{
  return this->Controller;
}

//------------------------------------------------------------------------------
int vtkLineModelFilter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  return 1;
}

//------------------------------------------------------------------------------
std::vector<vtkLineModelFilter::Block> vtkLineModelFilter::FindBlocks(
  vtkDataObject* input, int& numberOfOthers)
{
  numberOfOthers = 0;
  std::vector<Block> blocks;
  vtkLineSetsLeaves::Visit(input,
    [&](vtkDataObject* leaf, unsigned int flatIndex)
    {
      if (auto* lines = vtkPolyData::SafeDownCast(leaf))
      {
        blocks.push_back({ lines, flatIndex });
      }
      else
      {
        ++numberOfOthers;
      }
    });
  return blocks;
}

//------------------------------------------------------------------------------
void vtkLineModelFilter::TellOthers(int numberOfOthers)
{
  if (numberOfOthers > 0)
  {
    vtkWarningMacro("The input has " << numberOfOthers
                                     << " blocks that are no vtkPolyData and so hold no lines; "
                                        "they are not used.");
  }
}

//------------------------------------------------------------------------------
bool vtkLineModelFilter::FindBounds(const std::vector<Block>& blocks, double bounds[6])
{
  // Highs with their sign turned, so that one reduction serves all.
  double mine[6];
  double all[6];
  std::fill_n(mine, 6, std::numeric_limits<double>::max());
  double highs[3];
  std::fill_n(highs, 3, std::numeric_limits<double>::lowest());
  for (const Block& block : blocks)
  {
    AddLines(block.Lines, mine, highs);
  }
  std::transform(highs, highs + 3, mine + 3, [](double high) { return -high; });
  std::copy_n(mine, 6, all);
  if (this->Controller && this->Controller->GetNumberOfProcesses() > 1)
  {
    this->Controller->AllReduce(mine, all, 6, vtkCommunicator::MIN_OP);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = all[axis];
    bounds[2 * axis + 1] = -all[3 + axis];
  }
  return bounds[0] <= bounds[1];
}

//------------------------------------------------------------------------------
const char* vtkLineModelFilter::GetChosenArrayName()
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name =
    info->Has(vtkDataObject::FIELD_NAME()) ? info->Get(vtkDataObject::FIELD_NAME()) : "";
  // What ParaView's list offers for no array.
  return name && std::strcmp(name, "None") != 0 ? name : "";
}

//------------------------------------------------------------------------------
void vtkLineModelFilter::SetUpVoxelizer(vtkLineVoxelizer* voxelizer, const double bounds[6])
{
  voxelizer->SetResolution(this->Resolution);
  voxelizer->SetFaceBins(this->FaceBins);
  voxelizer->SetInteriorTolerance(this->InteriorTolerance);
  voxelizer->SetUseCustomBounds(true);
  voxelizer->SetCustomBounds(bounds);
  const char* array = this->GetChosenArrayName();
  voxelizer->SetGenerateAttributes(array[0] != '\0');
  if (array[0] != '\0')
  {
    voxelizer->SetInputArrayToProcess(0, this->GetInputArrayInformation(0));
    voxelizer->SetAttributeComponent(-1);
  }
}

//------------------------------------------------------------------------------
bool vtkLineModelFilter::RunInside(vtkAlgorithm* inside, double first, double last)
{
  Share share{ this, first, last };
  vtkNew<vtkCallbackCommand> onProgress;
  onProgress->SetCallback(OnProgress);
  onProgress->SetClientData(&share);
  const unsigned long tag = inside->AddObserver(vtkCommand::ProgressEvent, onProgress);
  inside->Update();
  inside->RemoveObserver(tag);
  if (inside->GetErrorCode() != vtkErrorCode::NoError)
  {
    // It has told why.
    this->SetErrorCode(inside->GetErrorCode());
    return false;
  }
  return !vtkLineSetsCompatibility::CheckAbort(this);
}

//------------------------------------------------------------------------------
void vtkLineModelFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "FaceBins: " << this->FaceBins << "\n";
  os << indent << "InteriorTolerance: " << this->InteriorTolerance << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
