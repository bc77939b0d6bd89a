// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminatedLineVertices.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkLineIllumination.h"
#include "vtkLineTangents.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// An array with the copies appended. One of another length than the points stays as it is.
vtkSmartPointer<vtkAbstractArray> CopyArray(
  vtkAbstractArray* array, vtkIdType numberOfPoints, const std::vector<vtkIdType>& copies)
{
  if (array->GetNumberOfTuples() != numberOfPoints)
  {
    return array;
  }
  // Of the type's usual class: one that computes its values would not take others.
  auto result =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(array->GetDataType()));
  result->DeepCopy(array);
  result->SetName(array->GetName());
  result->Resize(numberOfPoints + static_cast<vtkIdType>(copies.size()));
  for (vtkIdType id : copies)
  {
    result->InsertNextTuple(id, array);
  }
  // The mapper takes the array's own lookup table for its own: it must stay the same object.
  auto* data = vtkDataArray::FastDownCast(array);
  if (data && data->GetLookupTable())
  {
    vtkDataArray::FastDownCast(result)->SetLookupTable(data->GetLookupTable());
  }
  return result;
}

vtkSmartPointer<vtkPoints> CopyPoints(vtkPoints* points, const std::vector<vtkIdType>& copies)
{
  const vtkIdType number = points->GetNumberOfPoints();
  vtkSmartPointer<vtkAbstractArray> data = CopyArray(points->GetData(), number, copies);
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetData(vtkDataArray::FastDownCast(data));
  return result;
}

bool IsInfinite(const double point[3])
{
  return std::isinf(point[0]) || std::isinf(point[1]) || std::isinf(point[2]);
}

bool HasInfinitePoints(vtkPoints* points)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    if (IsInfinite(points->GetPoint(i)))
    {
      return true;
    }
  }
  return false;
}

// Put NaN in the place of infinite points. Either of both costs the lines' ends there, but ranges
// of the whole, by which VTK scales what it draws, leave out NaN only.
void ReplaceInfinitePoints(vtkPoints* points)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    if (IsInfinite(points->GetPoint(i)))
    {
      points->SetPoint(i, nan, nan, nan);
    }
  }
}

// The point of the input that a point of the output is.
vtkIdType GetInputPoint(vtkIdType id, vtkIdType numberOfPoints, const vtkLineTangents& lines)
{
  return id < numberOfPoints ? id : lines.Copies[id - numberOfPoints];
}

// Whether points are used by a line.
std::vector<bool> FindUsedPoints(vtkPolyData* data)
{
  std::vector<bool> used(static_cast<std::size_t>(data->GetNumberOfPoints()), false);
  vtkCellArray* lines = data->GetLines();
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    lines->GetCellAtId(line, ids);
    for (vtkIdType id : *ids)
    {
      if (id >= 0 && id < data->GetNumberOfPoints())
      {
        used[id] = true;
      }
    }
  }
  return used;
}
}

//------------------------------------------------------------------------------
vtkIlluminatedLineVertices::vtkIlluminatedLineVertices() = default;

//------------------------------------------------------------------------------
vtkIlluminatedLineVertices::~vtkIlluminatedLineVertices() = default;

//------------------------------------------------------------------------------
const char* vtkIlluminatedLineVertices::GetPointIdName()
{
  return "vtkIlluminatedLineMapperPointIds";
}

//------------------------------------------------------------------------------
bool vtkIlluminatedLineVertices::Update(
  vtkPolyData* input, const std::string& tangentArrayName, const std::string& powerArrayName)
{
  if (this->Input == input && this->InputTime == input->GetMTime() &&
    this->TangentArrayName == tangentArrayName && this->PowerArrayName == powerArrayName)
  {
    return false;
  }
  this->Input = input;
  this->InputTime = input->GetMTime();
  this->TangentArrayName = tangentArrayName;
  this->PowerArrayName = powerArrayName;
  this->Copy = nullptr;
  this->Tangents = nullptr;
  this->Powers = nullptr;
  this->Warnings.clear();

  const vtkLineTangents lines = vtkLineTangents::Compute(input);
  if (!lines.Tangents)
  {
    return true;
  }
  this->Tangents = lines.Tangents;
  if (lines.PointsNotFinite > 0)
  {
    this->Warnings.push_back(std::to_string(lines.PointsNotFinite) +
      " points of lines have coordinates that are not finite: they have no tangent, and lines are "
      "parted there.");
  }
  if (lines.LinesWithoutExtent > 0)
  {
    this->Warnings.push_back(std::to_string(lines.LinesWithoutExtent) +
      " lines have no extent, thus no tangent: they are lit as if they lay across view and light.");
  }
  if (lines.InvalidIds > 0)
  {
    this->Warnings.push_back(std::to_string(lines.InvalidIds) +
      " ids of points in lines do not exist: they must be from 0 to " +
      std::to_string(input->GetNumberOfPoints() - 1) + ".");
  }
  // Arrays are those of the input, also where points were copied.
  vtkDataArray* tangents = this->FindArray(tangentArrayName, 3, "tangents are computed");
  vtkDataArray* powers = this->FindArray(powerArrayName, 1, "all lines have the same exponent");
  const bool hasInfinite = lines.PointsNotFinite > 0 && HasInfinitePoints(input->GetPoints());
  if (!lines.Copies.empty() || hasInfinite)
  {
    this->CopyData(lines);
  }
  if (hasInfinite)
  {
    ReplaceInfinitePoints(this->Copy->GetPoints());
  }
  if (tangents)
  {
    this->UseTangents(tangents, lines);
  }
  if (powers)
  {
    this->UsePowers(powers, lines);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkIlluminatedLineVertices::FindArray(
  const std::string& name, int components, const char* instead)
{
  if (name.empty())
  {
    return nullptr;
  }
  const std::string rest = std::string("; ") + instead + " instead.";
  const vtkIdType points = this->Input->GetNumberOfPoints();
  vtkAbstractArray* any = this->Input->GetPointData()->GetAbstractArray(name.c_str());
  vtkDataArray* array = vtkArrayDownCast<vtkDataArray>(any);
  if (!array)
  {
    this->Warnings.push_back(any ? "The point array \"" + name + "\" holds no numbers" + rest
                                 : "There is no point array \"" + name + "\"" + rest);
    return nullptr;
  }
  if (array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != points)
  {
    this->Warnings.push_back("The point array \"" + name + "\" has " +
      std::to_string(array->GetNumberOfTuples()) + " tuples of " +
      std::to_string(array->GetNumberOfComponents()) + " components; it must have " +
      std::to_string(points) + " tuples of " + std::to_string(components) + rest);
    return nullptr;
  }
  return array;
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineVertices::CopyData(const vtkLineTangents& lines)
{
  vtkPolyData* input = this->Input;
  const vtkIdType number = input->GetNumberOfPoints();
  this->Copy = vtkSmartPointer<vtkPolyData>::New();
  this->Copy->ShallowCopy(input);
  this->Copy->SetPoints(CopyPoints(input->GetPoints(), lines.Copies));
  if (lines.Lines)
  {
    this->Copy->SetLines(lines.Lines);
  }

  vtkPointData* from = input->GetPointData();
  vtkPointData* to = this->Copy->GetPointData();
  to->Initialize();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    // Arrays keep their order: mappers may select them by index.
    to->AddArray(CopyArray(from->GetAbstractArray(i), number, lines.Copies));
    const int attribute = from->IsArrayAnAttribute(i);
    if (attribute >= 0)
    {
      to->SetActiveAttribute(i, attribute);
    }
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(GetPointIdName());
  ids->SetNumberOfValues(number + static_cast<vtkIdType>(lines.Copies.size()));
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
  {
    ids->SetValue(i, GetInputPoint(i, number, lines));
  }
  to->AddArray(ids);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineVertices::UseTangents(vtkDataArray* array, const vtkLineTangents& lines)
{
  const vtkIdType number = this->Input->GetNumberOfPoints();
  const std::vector<bool> used = FindUsedPoints(this->GetData());
  vtkSMPThreadLocal<vtkIdType> replaced(0);
  vtkSMPTools::For(0, this->Tangents->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType& localReplaced = replaced.Local();
      for (vtkIdType i = begin; i < end; ++i)
      {
        double given[3];
        array->GetTuple(GetInputPoint(i, number, lines), given);
        const double largest =
          std::max({ std::abs(given[0]), std::abs(given[1]), std::abs(given[2]) });
        const bool isFinite =
          std::isfinite(given[0]) && std::isfinite(given[1]) && std::isfinite(given[2]);
        if (!isFinite || largest == 0.0)
        {
          localReplaced += used[i] ? 1 : 0;
          continue;
        }
        // Tangents are interpolated along the line: they must point the same way.
        float computed[3];
        this->Tangents->GetTypedTuple(i, computed);
        double along = 0.0;
        double square = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          given[k] /= largest;
          along += given[k] * computed[k];
          square += given[k] * given[k];
        }
        const double factor = (along < 0.0 ? -1.0 : 1.0) / std::sqrt(square);
        for (int k = 0; k < 3; ++k)
        {
          computed[k] = static_cast<float>(factor * given[k]);
        }
        this->Tangents->SetTypedTuple(i, computed);
      }
    });
  vtkIdType count = 0;
  for (vtkIdType local : replaced)
  {
    count += local;
  }
  if (count > 0)
  {
    this->Warnings.push_back(std::to_string(count) + " tangents in the point array \"" +
      this->TangentArrayName +
      "\" are null or not finite; they are replaced by computed ones. Tangents must be finite "
      "vectors of any length but 0.");
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineVertices::UsePowers(vtkDataArray* array, const vtkLineTangents& lines)
{
  const vtkIdType number = this->Input->GetNumberOfPoints();
  const std::vector<bool> used = FindUsedPoints(this->GetData());
  this->Powers = vtkSmartPointer<vtkFloatArray>::New();
  this->Powers->SetNumberOfValues(this->Tangents->GetNumberOfTuples());
  vtkIdType invalid = 0;
  vtkIdType clamped = 0;
  for (vtkIdType i = 0; i < this->Powers->GetNumberOfValues(); ++i)
  {
    double power = array->GetComponent(GetInputPoint(i, number, lines), 0);
    if (!(power >= 0.0))
    {
      invalid += used[i] ? 1 : 0;
      power = -1.0;
    }
    else if (power > vtkLineIllumination::LargestSpecularPower)
    {
      clamped += used[i] ? 1 : 0;
      power = vtkLineIllumination::LargestSpecularPower;
    }
    this->Powers->SetValue(i, static_cast<float>(power));
  }
  if (invalid + clamped > 0)
  {
    this->Warnings.push_back("The point array \"" + this->PowerArrayName + "\" holds " +
      std::to_string(invalid) +
      " exponents that are negative or NaN, which the exponent of the "
      "light model replaces, and " +
      std::to_string(clamped) +
      " above 1000, which are taken for 1000. Exponents must be from 0 to 1000.");
  }
}
