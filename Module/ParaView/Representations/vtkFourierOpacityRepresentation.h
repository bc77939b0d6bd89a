// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityRepresentation
 * @brief   geometry in ParaView that fades where it hides important parts (vtkFourierOpacityMapper)
 */

#ifndef vtkFourierOpacityRepresentation_h
#define vtkFourierOpacityRepresentation_h

#include "vtkIlluminatedLinesRepresentation.h"
#include "vtkParaViewLineSetsModule.h" // For export macro

class vtkFourierOpacityMapper;

class VTKPARAVIEWLINESETS_EXPORT vtkFourierOpacityRepresentation
  : public vtkIlluminatedLinesRepresentation
{
public:
  static vtkFourierOpacityRepresentation* New();
  vtkTypeMacro(vtkFourierOpacityRepresentation, vtkIlluminatedLinesRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Array of points or cells that tells how important each part is; of several components the
   * length counts. A point of several cells is as important as the most important one.
   *
   * The first three arguments, by which ParaView names inputs, have no meaning here. See
   * vtkFourierOpacityMapper::SetImportanceArrayName() and SetImportanceArrayAssociation(). Without
   * a name, the active scalars count.
   */
  void SetImportanceArray(int index, int port, int connection, int association, const char* name);

  ///@{
  /**
   * Whether the values that count as unimportant and as most important are chosen by hand, so that
   * they stay as data and time change. Default off: the range of the array counts.
   */
  void SetUseImportanceRange(bool use);
  vtkGetMacro(UseImportanceRange, bool);
  ///@}

  ///@{
  /**
   * Values of the array that count as unimportant and as most important; others lie between or are
   * clamped. Default (0, 1).
   *
   * The first must not be above the second.
   */
  void SetImportanceRange(double low, double high);
  vtkGetVector2Macro(ImportanceRange, double);
  ///@}

protected:
  vtkFourierOpacityRepresentation();
  ~vtkFourierOpacityRepresentation() override;

  const char* GetLineMapperType() override { return "vtkFourierOpacityMapper"; }
  std::vector<std::string> GetArraysInUse() override;
  void CheckLines(vtkPolyData* lines) override;
  /// Always: whatever is not important lets something through.
  bool NeedsOrderedCompositing() override { return true; }
  /// Opacity depends on all that is drawn: every rank gets all of it.
  double SetSharedMeasures(const Measures* measures) override;
  void SetRegion(const double region[6]) override;

  bool UseImportanceRange = false;
  double ImportanceRange[2] = { 0.0, 1.0 };

private:
  vtkFourierOpacityRepresentation(const vtkFourierOpacityRepresentation&) = delete;
  void operator=(const vtkFourierOpacityRepresentation&) = delete;

  vtkFourierOpacityMapper* GetFourierOpacityMapper();
  void UpdateImportanceRange();
};

#endif
