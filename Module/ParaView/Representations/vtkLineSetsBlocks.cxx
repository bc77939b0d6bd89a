// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsBlocks.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>

namespace
{
//------------------------------------------------------------------------------
/// The leaves of the tree that are visible, in the order of their flat indices.
void FindParts(vtkDataObjectTree* tree, vtkCompositeDataDisplayAttributes* attributes,
  std::vector<vtkSmartPointer<vtkPolyData>>& parts, std::vector<unsigned int>& indices)
{
  using Options = vtk::DataObjectTreeOptions;
  // A block without a visibility of its own has its parent's.
  std::vector<std::pair<unsigned int, bool>> visible;
  for (const auto& node :
    vtk::Range(tree, Options::TraverseSubTree | Options::VisitOnlyLeaves | Options::SkipEmptyNodes))
  {
    auto* part = vtkPolyData::SafeDownCast(node.GetDataObject());
    if (part && part->GetNumberOfPoints() > 0 &&
      (!attributes || !attributes->HasBlockVisibility(part) ||
        attributes->GetBlockVisibility(part)))
    {
      parts.emplace_back(part);
      indices.push_back(node.GetFlatIndex());
    }
  }
}

//------------------------------------------------------------------------------
/// The part with the array that tells its block; the part itself is left as it is.
vtkSmartPointer<vtkPolyData> NameBlock(vtkPolyData* part, unsigned int index)
{
  auto named = vtkSmartPointer<vtkPolyData>::New();
  named->ShallowCopy(part);
  vtkNew<vtkUnsignedIntArray> indices;
  indices->SetName("vtkCompositeIndex");
  indices->SetNumberOfTuples(part->GetNumberOfCells());
  std::fill_n(indices->GetPointer(0), part->GetNumberOfCells(), index);
  named->GetCellData()->AddArray(indices);
  return named;
}
}

//------------------------------------------------------------------------------
vtkPolyData* vtkLineSetsBlocks::Join(
  vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes)
{
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  std::vector<unsigned int> indices;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    FindParts(tree, attributes, parts, indices);
  }
  else if (auto* single = vtkPolyData::SafeDownCast(data))
  {
    parts.emplace_back(single);
    indices.push_back(0);
  }

  const bool same = this->Joined && parts == this->Parts && indices == this->Indices &&
    std::all_of(parts.begin(), parts.end(),
      [this](vtkPolyData* part) { return part->GetMTime() < this->JoinTime; });
  if (same)
  {
    return this->Joined;
  }

  if (parts.size() == 1)
  {
    this->Joined = NameBlock(parts[0], indices[0]);
  }
  else
  {
    vtkNew<vtkAppendPolyData> append;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      append->AddInputData(NameBlock(parts[i], indices[i]));
    }
    this->Joined = vtkSmartPointer<vtkPolyData>::New();
    if (!parts.empty())
    {
      append->Update();
      this->Joined->ShallowCopy(append->GetOutput());
    }
  }
  this->Parts = std::move(parts);
  this->Indices = std::move(indices);
  this->JoinTime.Modified();
  return this->Joined;
}
