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

class VTKPARAVIEWLINESETS_EXPORT vtkIlluminatedLinesRepresentation
  : public vtkLineSetsRepresentation
{
public:
  static vtkIlluminatedLinesRepresentation* New();
  vtkTypeMacro(vtkIlluminatedLinesRepresentation, vtkLineSetsRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkIlluminatedLinesRepresentation();
  ~vtkIlluminatedLinesRepresentation() override;

  double SetSharedMeasures(const Measures* measures) override;

private:
  vtkIlluminatedLinesRepresentation(const vtkIlluminatedLinesRepresentation&) = delete;
  void operator=(const vtkIlluminatedLinesRepresentation&) = delete;
};

#endif
