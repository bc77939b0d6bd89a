// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsBlocks.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkLineSetsLeavesPrivate.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <utility>

namespace
{
using Parts = std::vector<vtkSmartPointer<vtkPolyData>>;

constexpr const char* CompositeIndexName = "vtkCompositeIndex";

//------------------------------------------------------------------------------
/// The leaves that are visible, in the order of their flat indices.
struct VisibleParts
{
  Parts Found;
  std::vector<unsigned int> Indices;

  VisibleParts(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes)
  {
    const auto isVisible = [attributes](vtkDataObject* node, bool isParentVisible)
    {
      return attributes && attributes->HasBlockVisibility(node)
        ? attributes->GetBlockVisibility(node)
        : isParentVisible;
    };
    unsigned int nextIndex = 0;
    vtkLineSetsLeaves::VisitBelow(data, nextIndex, true, isVisible,
      [this](vtkDataObject* leaf, unsigned int index, bool isShown)
      {
        auto* part = vtkPolyData::SafeDownCast(leaf);
        if (part && isShown && part->GetNumberOfPoints() > 0)
        {
          this->Found.emplace_back(part);
          this->Indices.push_back(index);
        }
      });
  }
};

//------------------------------------------------------------------------------
/// The part with the array that tells its block; the part itself is left as it is.
vtkSmartPointer<vtkPolyData> NameBlock(vtkPolyData* part, unsigned int index)
{
  auto named = vtkSmartPointer<vtkPolyData>::New();
  named->ShallowCopy(part);
  if (!vtkUnsignedIntArray::SafeDownCast(part->GetCellData()->GetArray(CompositeIndexName)))
  {
    vtkNew<vtkUnsignedIntArray> indices;
    indices->SetName(CompositeIndexName);
    indices->SetNumberOfTuples(part->GetNumberOfCells());
    std::fill_n(indices->GetPointer(0), part->GetNumberOfCells(), index);
    named->GetCellData()->AddArray(indices);
  }
  return named;
}

//------------------------------------------------------------------------------
vtkLineSetsSpread FindSpread(const Parts& parts, const std::string& name, int association)
{
  vtkLineSetsSpread spread(name, association);
  for (vtkPolyData* part : parts)
  {
    spread.Add(part);
  }
  return spread;
}

//------------------------------------------------------------------------------
/// Those of the arrays that not all parts have alike.
std::vector<vtkLineSetsSpread> FindPartial(
  const Parts& parts, const std::vector<std::string>& names)
{
  std::vector<vtkLineSetsSpread> partial;
  for (const std::string& name : names)
  {
    for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      const vtkLineSetsSpread spread = FindSpread(parts, name, association);
      if (spread.IsPartial())
      {
        partial.push_back(spread);
      }
    }
  }
  return partial;
}

//------------------------------------------------------------------------------
/// Gives the first tuple of the part's field data to all cells.
void SpreadFieldArray(vtkPolyData* part, const std::string& name)
{
  vtkDataArray* field = part->GetFieldData()->GetArray(name.c_str());
  if (!field || field->GetNumberOfTuples() == 0)
  {
    return;
  }
  auto array = vtkSmartPointer<vtkDataArray>::Take(field->NewInstance());
  array->SetName(name.c_str());
  array->SetNumberOfComponents(field->GetNumberOfComponents());
  array->SetNumberOfTuples(part->GetNumberOfCells());
  for (vtkIdType i = 0; i < part->GetNumberOfCells(); ++i)
  {
    array->SetTuple(i, 0, field);
  }
  part->GetCellData()->AddArray(array);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Append(const Parts& parts)
{
  if (parts.size() == 1)
  {
    return parts[0];
  }
  auto joined = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkAppendPolyData> append;
  for (vtkPolyData* part : parts)
  {
    append->AddInputData(part);
  }
  if (!parts.empty())
  {
    append->Update();
    joined->ShallowCopy(append->GetOutput());
  }
  return joined;
}

//------------------------------------------------------------------------------
std::set<vtkLineSetsSpread::Identity> FindLeftOut(const Parts& parts, vtkPolyData* joined)
{
  std::set<vtkLineSetsSpread::Identity> leftOut;
  for (vtkPolyData* part : parts)
  {
    leftOut.merge(vtkLineSetsSpread::FindArrays(part));
  }
  for (const vtkLineSetsSpread::Identity& array : vtkLineSetsSpread::FindArrays(joined))
  {
    leftOut.erase(array);
  }
  return leftOut;
}
}

//------------------------------------------------------------------------------
vtkPolyData* vtkLineSetsBlocks::Join(
  vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes, const Request& request)
{
  VisibleParts visible(data, attributes);
  std::vector<vtkLineSetsSpread> partial = FindPartial(visible.Found, request.Arrays);
  std::vector<std::string> changes = { request.FieldArray };
  for (const vtkLineSetsSpread& spread : partial)
  {
    changes.push_back(spread.GetKey());
  }
  const bool isSame = this->Joined && visible.Found == this->Sources &&
    visible.Indices == this->Indices && changes == this->Changes &&
    std::all_of(visible.Found.begin(), visible.Found.end(),
      [this](vtkPolyData* part) { return part->GetMTime() < this->JoinTime; });
  if (isSame)
  {
    return this->Joined;
  }

  Parts named;
  for (std::size_t i = 0; i < visible.Found.size(); ++i)
  {
    named.push_back(NameBlock(visible.Found[i], visible.Indices[i]));
    if (!request.FieldArray.empty())
    {
      SpreadFieldArray(named.back(), request.FieldArray);
    }
  }
  if (!request.FieldArray.empty())
  {
    partial.push_back(FindSpread(named, request.FieldArray, vtkDataObject::CELL));
  }
  this->Warnings.clear();
  for (const vtkLineSetsSpread& spread : partial)
  {
    if (!spread.IsPartial())
    {
      continue;
    }
    std::for_each(named.begin(), named.end(), [&spread](vtkPolyData* part) { spread.Apply(part); });
    if (spread.GetMissing() > 0)
    {
      this->Warnings.push_back({ spread.GetKey(), spread.GetWarning("visible blocks") });
    }
  }
  this->Joined = Append(named);
  this->LeftOut = FindLeftOut(named, this->Joined);
  this->Sources = std::move(visible.Found);
  this->Indices = std::move(visible.Indices);
  this->Changes = std::move(changes);
  this->JoinTime.Modified();
  return this->Joined;
}
