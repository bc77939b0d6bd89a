// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityVertices
 * @brief   importance and elements of the points of vtkFourierOpacityMapper's input
 *
 * Elements are what has an opacity of its own: segments, patches and single points
 * (vtkOpacitySegments). Where the input has nothing but vertices, each point is an element, and
 * there are no arrays for that. Importance is made anew where the input, the array or the range
 * changed, elements only where points or cells did.
 */

#ifndef vtkFourierOpacityVertices_h
#define vtkFourierOpacityVertices_h

#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkRenderingLineSetsModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkOpacitySegments;
class vtkPolyData;

class VTKRENDERINGLINESETS_EXPORT vtkFourierOpacityVertices
{
public:
  struct Settings
  {
    /// Name of a point or cell array, or empty for the active scalars, and what it belongs to.
    std::string ArrayName;
    int Association = vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS;
    /// Values that are mapped to 0 and 1; the array's own range where the first is above the
    /// second.
    double Range[2] = { 1.0, 0.0 };
    int NumberOfLineSegments = 0;
    int NumberOfPatches = 500;

    bool operator==(const Settings& other) const;
  };

  vtkFourierOpacityVertices();
  ~vtkFourierOpacityVertices();

  /// Bring all up to date. Returns whether anything was made anew.
  bool Update(vtkPolyData* input, const Settings& settings);

  /// One value in [0,1] per point of the input.
  vtkFloatArray* GetImportance() const { return this->Importance; }
  /// Three elements per point, and the weights of the first two; null where each point is one.
  vtkFloatArray* GetElements() const { return this->Elements; }
  vtkFloatArray* GetWeights() const { return this->Weights; }
  vtkIdType GetNumberOfElements() const { return this->NumberOfElements; }
  /// Pairs of neighbouring elements; may be null.
  vtkIntArray* GetNeighbors() const { return this->Neighbors; }
  /// Different where elements are others.
  vtkMTimeType GetBuildTime() const { return this->BuildTime; }

  /// What was wrong with the input, a sentence each.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

private:
  vtkFourierOpacityVertices(const vtkFourierOpacityVertices&) = delete;
  void operator=(const vtkFourierOpacityVertices&) = delete;

  vtkDataArray* FindArray(vtkPolyData* input, bool& isCellArray);
  void MakeImportance(vtkPolyData* input);
  void SpreadToPoints(vtkPolyData* input, vtkDataArray* cellArray, std::vector<double>& values);
  void MapToUnitRange(const std::vector<double>& values);
  void MakeElements(vtkPolyData* input);

  // Points, cells, segments and settings from which elements follow.
  using ElementsKey = std::vector<vtkMTimeType>;
  ElementsKey GetElementsKey(vtkPolyData* input) const;

  // Not held: the pipeline decides how long it lives.
  vtkWeakPointer<vtkPolyData> Input;
  vtkMTimeType InputTime = 0;
  Settings Last;
  ElementsKey LastElements;

  vtkNew<vtkOpacitySegments> Filter;
  vtkSmartPointer<vtkFloatArray> Importance;
  vtkSmartPointer<vtkFloatArray> Elements;
  vtkSmartPointer<vtkFloatArray> Weights;
  vtkSmartPointer<vtkIntArray> Neighbors;
  vtkIdType NumberOfElements = 0;
  vtkMTimeType BuildTime = 0;
  std::vector<std::string> Warnings;
  std::vector<std::string> ElementWarnings;
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityVertices.h
