// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIlluminatedLinesRepresentation
 * @brief   lines in ParaView, lit as infinitely thin cylinders (vtkIlluminatedLineMapper)
 */

#ifndef vtkIlluminatedLinesRepresentation_h
#define vtkIlluminatedLinesRepresentation_h

#include "vtkLineSetsRepresentation.h"
#include "vtkParaViewLineSetsModule.h" // For export macro

class vtkIlluminatedLineMapper;

class VTKPARAVIEWLINESETS_EXPORT vtkIlluminatedLinesRepresentation
  : public vtkLineSetsRepresentation
{
public:
  static vtkIlluminatedLinesRepresentation* New();
  vtkTypeMacro(vtkIlluminatedLinesRepresentation, vtkLineSetsRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Point array of three components with the tangents of the lines, of any length and either sense.
   * Default "None": tangents are computed.
   *
   * See vtkIlluminatedLineMapper::SetTangentArrayName(). An empty name and nullptr mean "None" as
   * well.
   */
  void SetTangentArrayName(const char* name);

  /**
   * Point array of one component with the exponent of the specular term, 0 to 1000, interpolated
   * along the line. Default "None": the specular power, which is the same everywhere.
   *
   * See vtkIlluminatedLineMapper::SetSpecularPowerArrayName(). An empty name and nullptr mean
   * "None" as well.
   */
  void SetSpecularPowerArrayName(const char* name);

protected:
  vtkIlluminatedLinesRepresentation();
  ~vtkIlluminatedLinesRepresentation() override;

  const char* GetLineMapperType() override { return "vtkIlluminatedLineMapper"; }
  std::vector<std::string> GetArraysInUse() override;
  void CheckLines(vtkPolyData* lines) override;
  double SetSharedMeasures(const Measures* measures) override;

private:
  vtkIlluminatedLinesRepresentation(const vtkIlluminatedLinesRepresentation&) = delete;
  void operator=(const vtkIlluminatedLinesRepresentation&) = delete;

  vtkIlluminatedLineMapper* GetIlluminatedLineMapper();
};

#endif
