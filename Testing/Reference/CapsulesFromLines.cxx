// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CapsulesFromLines.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <stdexcept>

namespace linesets
{
namespace
{
vtkDataArray* FindArray(vtkPolyData* lines, const std::string& name)
{
  if (name.empty())
  {
    return nullptr;
  }
  vtkDataArray* array = lines->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfTuples() < lines->GetNumberOfPoints())
  {
    throw std::invalid_argument("no point array of the right length named " + name);
  }
  return array;
}

// Writes the capsules between successive points.
class CapsuleWriter
{
public:
  CapsuleWriter(vtkPolyData* lines, const LineOptions& options, CapsuleScene& scene)
    : Points(lines->GetPoints())
    , Radii(FindArray(lines, options.RadiusArray))
    , Radius(options.Radius)
    , Scene(scene)
  {
    vtkDataArray* colors = FindArray(lines, options.ColorArray);
    if (!colors)
    {
      return;
    }
    if (colors->GetNumberOfComponents() == 1)
    {
      this->Scalars = colors;
      scene.Colors = ColorSource::Scalars;
      return;
    }
    this->Colors = vtkUnsignedCharArray::SafeDownCast(colors);
    if (!this->Colors || this->Colors->GetNumberOfComponents() > 4 ||
      this->Colors->GetNumberOfComponents() < 3)
    {
      throw std::invalid_argument(options.ColorArray + " is neither scalars nor colours");
    }
    scene.Colors = ColorSource::Direct;
  }

  bool IsUsable(vtkIdType point) const
  {
    double p[3];
    if (point < 0 || point >= this->Points->GetNumberOfPoints())
    {
      return false;
    }
    this->Points->GetPoint(point, p);
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  }

  void Write(vtkIdType from, vtkIdType to, vtkIdType curve)
  {
    Capsule capsule;
    this->Points->GetPoint(from, capsule.Start);
    this->Points->GetPoint(to, capsule.End);
    vtkMath::Subtract(capsule.Start, this->Scene.Origin, capsule.Start);
    vtkMath::Subtract(capsule.End, this->Scene.Origin, capsule.End);
    capsule.StartRadius = this->Radii ? this->Radii->GetTuple1(from) : this->Radius;
    capsule.EndRadius = this->Radii ? this->Radii->GetTuple1(to) : this->Radius;
    if (this->Scalars)
    {
      capsule.StartValue = this->Scalars->GetTuple1(from);
      capsule.EndValue = this->Scalars->GetTuple1(to);
    }
    for (int i = 0; this->Colors && i < this->Colors->GetNumberOfComponents(); ++i)
    {
      capsule.StartColor[i] = this->Colors->GetTypedComponent(from, i);
      capsule.EndColor[i] = this->Colors->GetTypedComponent(to, i);
    }
    capsule.Curve = curve;
    this->Scene.Capsules.push_back(capsule);
  }

private:
  vtkPoints* Points;
  vtkDataArray* Radii;
  double Radius;
  CapsuleScene& Scene;
  vtkDataArray* Scalars = nullptr;
  vtkUnsignedCharArray* Colors = nullptr;
};

void SetOrigin(vtkPolyData* lines, CapsuleScene& scene)
{
  double bounds[6];
  lines->GetBounds(bounds);
  for (int i = 0; i < 3; ++i)
  {
    const double middle = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    scene.Origin[i] = std::isfinite(middle) ? middle : 0.0;
  }
}
}

//------------------------------------------------------------------------------
CapsuleScene MakeCapsulesFromLines(vtkPolyData* lines, const LineOptions& options)
{
  CapsuleScene scene;
  if (!lines->GetPoints() || lines->GetNumberOfLines() == 0)
  {
    return scene;
  }
  SetOrigin(lines, scene);
  CapsuleWriter writer(lines, options, scene);
  vtkIdType extraCurve = lines->GetNumberOfCells();
  const vtkIdType firstCell = lines->GetNumberOfVerts();
  auto cells = vtk::TakeSmartPointer(lines->GetLines()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* ids;
    cells->GetCurrentCell(count, ids);
    vtkIdType curve = firstCell + cells->GetCurrentCellId();
    bool parted = false;
    vtkIdType previous = -1;
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (!writer.IsUsable(ids[i]))
      {
        parted = parted || previous >= 0;
        previous = -1;
        continue;
      }
      if (previous < 0 && parted)
      {
        curve = extraCurve++;
      }
      if (previous >= 0)
      {
        writer.Write(previous, ids[i], curve);
      }
      previous = ids[i];
    }
  }
  return scene;
}
}
