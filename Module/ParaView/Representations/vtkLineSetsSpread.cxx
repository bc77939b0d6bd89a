// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsSpread.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>

namespace
{
vtkDataArray* FindArray(vtkPolyData* part, const std::string& name, int association)
{
  return part->GetAttributes(association)->GetArray(name.c_str());
}
}

//------------------------------------------------------------------------------
std::set<vtkLineSetsSpread::Identity> vtkLineSetsSpread::FindArrays(vtkPolyData* part)
{
  std::set<Identity> arrays;
  for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* attributes = part->GetAttributes(association);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      const char* name = attributes->GetAbstractArray(i)->GetName();
      arrays.insert({ name ? name : "", association });
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
vtkLineSetsSpread::vtkLineSetsSpread(const std::string& name, int association)
  : Name(name)
  , Association(association)
{
}

//------------------------------------------------------------------------------
void vtkLineSetsSpread::Describe(
  vtkPolyData* part, const std::string& name, int association, int& components, int& type)
{
  vtkDataArray* array = FindArray(part, name, association);
  components = array ? array->GetNumberOfComponents() : 0;
  type = array ? array->GetDataType() : VTK_VOID;
}

//------------------------------------------------------------------------------
void vtkLineSetsSpread::Add(vtkPolyData* part)
{
  int components = 0;
  int type = VTK_VOID;
  Describe(part, this->Name, this->Association, components, type);
  this->Add(components, type);
}

//------------------------------------------------------------------------------
void vtkLineSetsSpread::Add(int components, int type)
{
  if (this->Components == 0 && components > 0)
  {
    this->Components = components;
    this->Type = type;
  }
  ++this->Parts;
  this->Missing += components == 0 || components != this->Components ? 1 : 0;
  this->IsMixed = this->IsMixed || (components > 0 && type != this->Type);
}

//------------------------------------------------------------------------------
std::string vtkLineSetsSpread::GetKey() const
{
  return std::to_string(this->Association) + " " + std::to_string(this->Components) + " " +
    this->Name;
}

//------------------------------------------------------------------------------
std::string vtkLineSetsSpread::GetWarning(const std::string& parts) const
{
  return std::to_string(this->Missing) + " of " + std::to_string(this->Parts) + " " + parts +
    " have no array \"" + this->Name + "\" of " +
    (this->Association == vtkDataObject::POINT ? "points" : "cells") + " with " +
    std::to_string(this->Components) + (this->Components == 1 ? " component" : " components") +
    ". Its values are NaN there: such lines have the colour map's NaN colour, and no importance, "
    "radius or tangent of their own.";
}

//------------------------------------------------------------------------------
void vtkLineSetsSpread::Apply(vtkPolyData* part) const
{
  vtkDataArray* array = FindArray(part, this->Name, this->Association);
  const bool fits = array && array->GetNumberOfComponents() == this->Components;
  if (fits && vtkDoubleArray::SafeDownCast(array))
  {
    return;
  }
  auto filled = vtkSmartPointer<vtkDoubleArray>::New();
  if (fits)
  {
    filled->DeepCopy(array);
  }
  else
  {
    filled->SetNumberOfComponents(this->Components);
    filled->SetNumberOfTuples(part->GetNumberOfElements(this->Association));
    std::fill_n(
      filled->GetPointer(0), filled->GetNumberOfValues(), std::numeric_limits<double>::quiet_NaN());
  }
  filled->SetName(this->Name.c_str());
  part->GetAttributes(this->Association)->AddArray(filled);
}
