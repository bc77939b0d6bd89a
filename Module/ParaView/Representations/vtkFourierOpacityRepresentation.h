// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityRepresentation
 * @brief   geometry in ParaView that fades where it hides important parts (vtkFourierOpacityMapper)
 */

#ifndef vtkFourierOpacityRepresentation_h
#define vtkFourierOpacityRepresentation_h

#include "vtkLineSetsRepresentation.h"
#include "vtkParaViewLineSetsModule.h" // For export macro

class VTKPARAVIEWLINESETS_EXPORT vtkFourierOpacityRepresentation : public vtkLineSetsRepresentation
{
public:
  static vtkFourierOpacityRepresentation* New();
  vtkTypeMacro(vtkFourierOpacityRepresentation, vtkLineSetsRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkFourierOpacityRepresentation();
  ~vtkFourierOpacityRepresentation() override;

  std::vector<std::string> GetArraysInUse() override;
  void CheckLines(vtkPolyData* lines) override;

private:
  vtkFourierOpacityRepresentation(const vtkFourierOpacityRepresentation&) = delete;
  void operator=(const vtkFourierOpacityRepresentation&) = delete;
};

#endif
