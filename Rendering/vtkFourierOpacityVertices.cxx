// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityVertices.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkOpacitySegments.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

bool HasOnlyVertices(vtkPolyData* data)
{
  return data->GetNumberOfLines() == 0 && data->GetNumberOfPolys() == 0 &&
    data->GetNumberOfStrips() == 0;
}

// One value per tuple: the only component, or the length of a vector.
double GetValue(vtkDataArray* array, vtkIdType tuple)
{
  const int components = array->GetNumberOfComponents();
  if (components == 1)
  {
    return array->GetComponent(tuple, 0);
  }
  double sum = 0.0;
  for (int i = 0; i < components; ++i)
  {
    const double value = array->GetComponent(tuple, i);
    sum += value * value;
  }
  return std::sqrt(sum);
}
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityVertices::Settings::operator==(const Settings& other) const
{
  return this->ArrayName == other.ArrayName && this->Association == other.Association &&
    this->Range[0] == other.Range[0] && this->Range[1] == other.Range[1] &&
    this->NumberOfLineSegments == other.NumberOfLineSegments &&
    this->NumberOfPatches == other.NumberOfPatches;
}

//------------------------------------------------------------------------------
vtkFourierOpacityVertices::vtkFourierOpacityVertices() = default;

//------------------------------------------------------------------------------
vtkFourierOpacityVertices::~vtkFourierOpacityVertices() = default;

//------------------------------------------------------------------------------
bool vtkFourierOpacityVertices::Update(vtkPolyData* input, const Settings& settings)
{
  if (this->Input == input && this->InputTime == input->GetMTime() && this->Last == settings)
  {
    return false;
  }
  this->Input = input;
  this->InputTime = input->GetMTime();
  this->Last = settings;
  this->Warnings.clear();
  this->MakeImportance(input);
  const ElementsKey key = this->GetElementsKey(input);
  if (key != this->LastElements)
  {
    this->LastElements = key;
    this->ElementWarnings.clear();
    this->MakeElements(input);
    vtkTimeStamp time;
    time.Modified();
    this->BuildTime = time.GetMTime();
  }
  this->Warnings.insert(
    this->Warnings.end(), this->ElementWarnings.begin(), this->ElementWarnings.end());
  return true;
}

//------------------------------------------------------------------------------
vtkFourierOpacityVertices::ElementsKey vtkFourierOpacityVertices::GetElementsKey(
  vtkPolyData* input) const
{
  vtkObject* parts[] = { input->GetPoints(), input->GetVerts(), input->GetLines(),
    input->GetPolys(), input->GetStrips(),
    input->GetPointData()->GetAbstractArray(vtkOpacitySegments::GetIdsName()),
    input->GetPointData()->GetAbstractArray(vtkOpacitySegments::GetDistancesName()),
    input->GetFieldData()->GetAbstractArray(vtkOpacitySegments::GetNeighborsName()) };
  ElementsKey key;
  for (vtkObject* part : parts)
  {
    key.push_back(part ? part->GetMTime() : 0);
  }
  key.push_back(static_cast<vtkMTimeType>(this->Last.NumberOfLineSegments));
  key.push_back(static_cast<vtkMTimeType>(this->Last.NumberOfPatches));
  return key;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkFourierOpacityVertices::FindArray(vtkPolyData* input, bool& isCellArray)
{
  const std::string& name = this->Last.ArrayName;
  vtkDataArray* onPoints = name.empty() ? input->GetPointData()->GetScalars()
                                        : input->GetPointData()->GetArray(name.c_str());
  vtkDataArray* onCells = name.empty() ? input->GetCellData()->GetScalars()
                                       : input->GetCellData()->GetArray(name.c_str());
  const int association = this->Last.Association;
  onPoints = association == vtkDataObject::FIELD_ASSOCIATION_CELLS ? nullptr : onPoints;
  onCells = association == vtkDataObject::FIELD_ASSOCIATION_POINTS ? nullptr : onCells;
  isCellArray = !onPoints && onCells;
  vtkDataArray* array = isCellArray ? onCells : onPoints;
  const std::string quoted = name.empty() ? "active scalars" : "array \"" + name + "\"";
  if (!array)
  {
    const char* owners = association == vtkDataObject::FIELD_ASSOCIATION_POINTS
      ? " for points"
      : (association == vtkDataObject::FIELD_ASSOCIATION_CELLS ? " for cells"
                                                               : " for points or cells");
    this->Warnings.push_back("The input has no " + quoted + owners +
      " that could tell importance: nothing is important, and everything is opaque.");
    return nullptr;
  }
  const vtkIdType wanted = isCellArray ? input->GetNumberOfCells() : input->GetNumberOfPoints();
  if (array->GetNumberOfTuples() < wanted || array->GetNumberOfComponents() < 1)
  {
    this->Warnings.push_back("The " + quoted + " that tells importance has " +
      std::to_string(array->GetNumberOfTuples()) + " tuples and should have " +
      std::to_string(wanted) + ", one for each " + (isCellArray ? "cell" : "point") +
      ": nothing is important, and everything is opaque.");
    return nullptr;
  }
  return array;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityVertices::MakeImportance(vtkPolyData* input)
{
  const vtkIdType points = input->GetNumberOfPoints();
  this->Importance = vtkSmartPointer<vtkFloatArray>::New();
  this->Importance->SetNumberOfTuples(points);
  this->Importance->FillValue(0.0f);
  bool isCellArray = false;
  vtkDataArray* array = this->FindArray(input, isCellArray);
  if (!array || points == 0)
  {
    return;
  }
  std::vector<double> values(static_cast<std::size_t>(points), NotANumber);
  if (isCellArray)
  {
    this->SpreadToPoints(input, array, values);
  }
  else
  {
    for (vtkIdType i = 0; i < points; ++i)
    {
      values[i] = GetValue(array, i);
      if (std::isnan(values[i]))
      {
        // Told apart from points that no cell gave a value.
        values[i] = std::numeric_limits<double>::infinity();
      }
    }
  }
  this->MapToUnitRange(values);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityVertices::SpreadToPoints(
  vtkPolyData* input, vtkDataArray* cellArray, std::vector<double>& values)
{
  // A point that several cells use is as important as the most important of them.
  vtkCellArray* kinds[4] = { input->GetVerts(), input->GetLines(), input->GetPolys(),
    input->GetStrips() };
  const vtkIdType points = static_cast<vtkIdType>(values.size());
  vtkIdType cell = 0;
  for (vtkCellArray* cells : kinds)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      iterator->GetCurrentCell(size, ids);
      double value = GetValue(cellArray, cell++);
      value = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
      for (vtkIdType i = 0; i < size; ++i)
      {
        if (ids[i] >= 0 && ids[i] < points)
        {
          double& old = values[ids[i]];
          const bool better = std::isnan(old) || std::isinf(old) || value > old;
          old = better && (std::isnan(old) || std::isfinite(value)) ? value : old;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityVertices::MapToUnitRange(const std::vector<double>& values)
{
  double low = this->Last.Range[0];
  double high = this->Last.Range[1];
  if (!(low <= high))
  {
    low = std::numeric_limits<double>::max();
    high = std::numeric_limits<double>::lowest();
    for (double value : values)
    {
      if (std::isfinite(value))
      {
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
  }
  vtkIdType bad = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    bad += std::isinf(values[i]) ? 1 : 0;
    if (std::isfinite(values[i]) && high > low)
    {
      this->Importance->SetValue(static_cast<vtkIdType>(i),
        static_cast<float>(std::min(std::max((values[i] - low) / (high - low), 0.0), 1.0)));
    }
  }
  if (bad > 0)
  {
    this->Warnings.push_back("The importance of " + std::to_string(bad) +
      " points is not a finite number: they count as unimportant.");
  }
  if (!(high > low))
  {
    this->Warnings.push_back(
      "The importance is the same everywhere, or the range it is mapped "
      "from is empty: nothing is important, and everything is opaque. Give a "
      "range (SetImportanceRange) or another array.");
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityVertices::MakeElements(vtkPolyData* input)
{
  this->Elements = nullptr;
  this->Weights = nullptr;
  this->Neighbors = nullptr;
  this->NumberOfElements = input->GetNumberOfPoints();
  if (HasOnlyVertices(input))
  {
    return;
  }
  vtkPolyData* segmented = input;
  if (!input->GetPointData()->GetArray(vtkOpacitySegments::GetIdsName()))
  {
    this->Filter->SetInputData(input);
    this->Filter->SetNumberOfLineSegments(this->Last.NumberOfLineSegments);
    this->Filter->SetNumberOfPatches(this->Last.NumberOfPatches);
    this->Filter->Update();
    segmented = this->Filter->GetOutput();
  }
  auto* ids = vtkIntArray::SafeDownCast(
    segmented->GetPointData()->GetArray(vtkOpacitySegments::GetIdsName()));
  auto* distances = vtkFloatArray::SafeDownCast(
    segmented->GetPointData()->GetArray(vtkOpacitySegments::GetDistancesName()));
  const vtkIdType points = input->GetNumberOfPoints();
  if (!ids || !distances || ids->GetNumberOfComponents() != 3 ||
    distances->GetNumberOfComponents() != 4 || ids->GetNumberOfTuples() < points ||
    distances->GetNumberOfTuples() < points)
  {
    this->ElementWarnings.push_back(
      "The input's arrays of segments are not those of vtkOpacitySegments, with 3 and 4 components "
      "and one tuple per point: each point has an opacity of its own.");
    return;
  }
  const int largest =
    points > 0 ? *std::max_element(ids->GetPointer(0), ids->GetPointer(0) + 3 * points) : -1;
  if (largest >= vtkOpacitySegments::LargestNumberOfSegments)
  {
    this->ElementWarnings.push_back("The input's array of segments has the id " +
      std::to_string(largest) + "; ids must be below " +
      std::to_string(int{ vtkOpacitySegments::LargestNumberOfSegments }) +
      ": each point has an opacity of its own.");
    return;
  }
  this->Neighbors = vtkIntArray::SafeDownCast(
    segmented->GetFieldData()->GetArray(vtkOpacitySegments::GetNeighborsName()));
  this->Elements = vtkSmartPointer<vtkFloatArray>::New();
  this->Elements->SetNumberOfComponents(3);
  this->Elements->SetNumberOfTuples(points);
  this->Weights = vtkSmartPointer<vtkFloatArray>::New();
  this->Weights->SetNumberOfComponents(2);
  this->Weights->SetNumberOfTuples(points);
  for (vtkIdType i = 0; i < points; ++i)
  {
    const int* elements = ids->GetPointer(3 * i);
    double weights[3];
    vtkOpacitySegments::GetWeights(elements, distances->GetPointer(4 * i), weights);
    for (int j = 0; j < 3; ++j)
    {
      this->Elements->SetTypedComponent(i, j, static_cast<float>(std::max(elements[j], -1)));
    }
    // A point of no element is opaque by its first one, -1.
    this->Weights->SetTypedComponent(i, 0, elements[0] < 0 ? 1.0f : static_cast<float>(weights[0]));
    this->Weights->SetTypedComponent(i, 1, static_cast<float>(weights[1]));
  }
  this->NumberOfElements = largest + 1;
  // What the filter kept is not needed any more.
  this->Filter->SetInputData(nullptr);
  this->Filter->GetOutput()->Initialize();
}
