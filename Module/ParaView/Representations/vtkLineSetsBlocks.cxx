// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsBlocks.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace
{
using Parts = std::vector<vtkSmartPointer<vtkPolyData>>;

constexpr const char* CompositeIndexName = "vtkCompositeIndex";

//------------------------------------------------------------------------------
/// Collects the leaves that are visible, in the order of their flat indices.
class PartFinder
{
public:
  Parts Found;
  std::vector<unsigned int> Indices;

  explicit PartFinder(vtkCompositeDataDisplayAttributes* attributes)
    : Attributes(attributes)
  {
  }

  /// Go through a node whose parent is visible or not.
  void Visit(vtkDataObject* node, bool isVisible)
  {
    const unsigned int index = this->NextIndex++;
    if (node && this->Attributes && this->Attributes->HasBlockVisibility(node))
    {
      isVisible = this->Attributes->GetBlockVisibility(node);
    }
    if (auto* tree = vtkDataObjectTree::SafeDownCast(node))
    {
      for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
      {
        this->Visit(child, isVisible);
      }
      return;
    }
    auto* part = vtkPolyData::SafeDownCast(node);
    if (part && isVisible && part->GetNumberOfPoints() > 0)
    {
      this->Found.emplace_back(part);
      this->Indices.push_back(index);
    }
  }

private:
  vtkCompositeDataDisplayAttributes* Attributes;
  unsigned int NextIndex = 0;
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
/// Doubles with NaN where there is no array of that many components.
vtkSmartPointer<vtkDoubleArray> Fill(
  vtkDataArray* array, const std::string& name, int components, vtkIdType tuples)
{
  auto filled = vtkSmartPointer<vtkDoubleArray>::New();
  if (array && array->GetNumberOfComponents() == components)
  {
    filled->DeepCopy(array);
  }
  else
  {
    filled->SetNumberOfComponents(components);
    filled->SetNumberOfTuples(tuples);
    std::fill_n(
      filled->GetPointer(0), filled->GetNumberOfValues(), std::numeric_limits<double>::quiet_NaN());
  }
  filled->SetName(name.c_str());
  return filled;
}

//------------------------------------------------------------------------------
/// How an array is spread over the points or the cells of the parts.
struct Spread
{
  std::string Name;
  int Association;
  int Components = 0;
  std::size_t Missing = 0;
  bool IsUniform = true;

  Spread(const Parts& parts, const std::string& name, int association)
    : Name(name)
    , Association(association)
  {
    int type = VTK_VOID;
    for (vtkPolyData* part : parts)
    {
      vtkDataArray* array = part->GetAttributes(association)->GetArray(name.c_str());
      if (array && this->Components == 0)
      {
        this->Components = array->GetNumberOfComponents();
        type = array->GetDataType();
      }
    }
    for (vtkPolyData* part : parts)
    {
      vtkDataArray* array = part->GetAttributes(association)->GetArray(name.c_str());
      this->Missing += !array || array->GetNumberOfComponents() != this->Components ? 1 : 0;
      this->IsUniform = this->IsUniform && array && array->GetDataType() == type &&
        array->GetNumberOfComponents() == this->Components;
    }
  }

  /// Whether some parts need to be changed.
  bool IsPartial() const { return this->Components > 0 && !this->IsUniform; }

  void Apply(const Parts& parts) const
  {
    for (vtkPolyData* part : parts)
    {
      vtkDataSetAttributes* data = part->GetAttributes(this->Association);
      data->AddArray(Fill(data->GetArray(this->Name.c_str()), this->Name, this->Components,
        part->GetNumberOfElements(this->Association)));
    }
  }
};

//------------------------------------------------------------------------------
/// Those of the arrays that not all parts have alike.
std::vector<Spread> FindPartial(const Parts& parts, const std::vector<std::string>& names)
{
  std::vector<Spread> partial;
  for (const std::string& name : names)
  {
    for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      const Spread spread(parts, name, association);
      if (spread.IsPartial())
      {
        partial.push_back(spread);
      }
    }
  }
  return partial;
}

//------------------------------------------------------------------------------
std::string Describe(const Spread& spread, std::size_t parts)
{
  return std::to_string(spread.Missing) + " of " + std::to_string(parts) +
    " visible blocks have no array \"" + spread.Name + "\" of " +
    (spread.Association == vtkDataObject::POINT ? "points" : "cells") + " with " +
    std::to_string(spread.Components) + (spread.Components == 1 ? " component" : " components") +
    ". Its values are NaN there: such lines have the colour map's NaN colour, and no importance, "
    "radius or tangent of their own.";
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
}

//------------------------------------------------------------------------------
vtkPolyData* vtkLineSetsBlocks::Join(
  vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes, const Request& request)
{
  PartFinder finder(attributes);
  finder.Visit(data, true);

  const std::vector<Spread> partial = FindPartial(finder.Found, request.Arrays);
  std::vector<std::string> changes = { request.FieldArray };
  this->Warnings.clear();
  for (const Spread& spread : partial)
  {
    const std::string key = std::to_string(spread.Association) + spread.Name;
    changes.push_back(key);
    if (spread.Missing > 0)
    {
      this->Warnings.push_back({ key, Describe(spread, finder.Found.size()) });
    }
  }

  const bool isSame = this->Joined && finder.Found == this->Sources &&
    finder.Indices == this->Indices && changes == this->Changes &&
    std::all_of(finder.Found.begin(), finder.Found.end(),
      [this](vtkPolyData* part) { return part->GetMTime() < this->JoinTime; });
  if (isSame)
  {
    return this->Joined;
  }

  Parts named;
  for (std::size_t i = 0; i < finder.Found.size(); ++i)
  {
    named.push_back(NameBlock(finder.Found[i], finder.Indices[i]));
    if (!request.FieldArray.empty())
    {
      SpreadFieldArray(named.back(), request.FieldArray);
    }
  }
  for (const Spread& spread : partial)
  {
    spread.Apply(named);
  }
  this->Joined = Append(named);
  this->Sources = std::move(finder.Found);
  this->Indices = std::move(finder.Indices);
  this->Changes = std::move(changes);
  this->JoinTime.Modified();
  return this->Joined;
}
