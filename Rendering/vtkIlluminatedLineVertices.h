// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIlluminatedLineVertices
 * @brief   what vtkIlluminatedLineMapper knows of the points of its input
 *
 * Holds tangents and exponents, one per point that is drawn, and the data set that is drawn: the
 * input itself, or a copy in which points that lines share are repeated, and infinite points are
 * NaN. All is made anew where the input or the names of its arrays changed, and only then.
 */

#ifndef vtkIlluminatedLineVertices_h
#define vtkIlluminatedLineVertices_h

#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkRenderingLineSetsModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
struct vtkLineTangents;

class VTKRENDERINGLINESETS_EXPORT vtkIlluminatedLineVertices
{
public:
  /// Name of the point array in a copied data set that holds the id of the input's point.
  static const char* GetPointIdName();

  vtkIlluminatedLineVertices();
  ~vtkIlluminatedLineVertices();

  /**
   * Bring all up to date. The names may be empty. Returns whether anything was made anew.
   */
  bool Update(
    vtkPolyData* input, const std::string& tangentArrayName, const std::string& powerArrayName);

  /// What is to be drawn in place of the input: the input itself or a copy.
  vtkPolyData* GetData() const { return this->Copy ? this->Copy.Get() : this->Input.Get(); }
  /// Whether GetData() is a copy of the input.
  bool IsCopied() const { return this->Copy != nullptr; }

  /// Unit or null vectors in data coordinates; nullptr where there are no lines.
  vtkFloatArray* GetTangents() const { return this->Tangents; }
  /// Exponents, -1 where that of the light model counts; nullptr where it counts everywhere.
  vtkFloatArray* GetPowers() const { return this->Powers; }

  /// What was wrong with the input, a sentence each.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

private:
  vtkIlluminatedLineVertices(const vtkIlluminatedLineVertices&) = delete;
  void operator=(const vtkIlluminatedLineVertices&) = delete;

  vtkDataArray* FindArray(const std::string& name, int components, const char* instead);
  void CopyData(const vtkLineTangents& lines);
  void UseTangents(vtkDataArray* array, const vtkLineTangents& lines);
  void UsePowers(vtkDataArray* array, const vtkLineTangents& lines);

  // Not held: the pipeline decides how long it lives.
  vtkWeakPointer<vtkPolyData> Input;
  vtkMTimeType InputTime = 0;
  std::string TangentArrayName;
  std::string PowerArrayName;

  vtkSmartPointer<vtkPolyData> Copy;
  vtkSmartPointer<vtkFloatArray> Tangents;
  vtkSmartPointer<vtkFloatArray> Powers;
  std::vector<std::string> Warnings;
};

#endif

// VTK-HeaderTest-Exclude: vtkIlluminatedLineVertices.h
