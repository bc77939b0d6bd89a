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

  /// Always: whatever is not important lets something through.
  bool NeedsOrderedCompositing() override { return true; }
  /// Opacity depends on all that is drawn: every rank gets all of it.
  double SetSharedMeasures(const Measures* measures) override;
  void SetRegion(const double region[6]) override;

private:
  vtkFourierOpacityRepresentation(const vtkFourierOpacityRepresentation&) = delete;
  void operator=(const vtkFourierOpacityRepresentation&) = delete;
};

#endif
