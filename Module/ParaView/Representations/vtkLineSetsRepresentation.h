// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsRepresentation
 * @brief   what the representations of line sets in ParaView share
 *
 * ParaView's geometry representation with one of this project's mappers in place of its own. The
 * superclass extracts the geometry of any data set or composite data set, delivers it to where it is
 * drawn, and keeps the colour map, the property and the placement. This class joins the blocks that
 * are visible into one vtkPolyData there, since a line mapper draws all lines of a set together (one
 * voxel model, one order of blending), and gives it to the mapper.
 *
 * What ParaView stores per block besides visibility (colours, opacities, colour arrays of single
 * blocks) has no counterpart in such a mapper: it is told once that it is ignored.
 */

#ifndef vtkLineSetsRepresentation_h
#define vtkLineSetsRepresentation_h

#include "vtkGeometryRepresentation.h"
#include "vtkParaViewLineSetsModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkLineSetsBlocks;
class vtkPolyDataMapper;

class VTKPARAVIEWLINESETS_EXPORT vtkLineSetsRepresentation : public vtkGeometryRepresentation
{
public:
  vtkAbstractTypeMacro(vtkLineSetsRepresentation, vtkGeometryRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* inInfo,
    vtkInformation* outInfo) override;

  /**
   * The mapper that draws, whose settings are those of the representation. The proxies make it and
   * hand it over before they set anything else. Each subclass begins with one of its own kind.
   */
  virtual void SetLineMapper(vtkPolyDataMapper* mapper);

protected:
  vtkLineSetsRepresentation();
  ~vtkLineSetsRepresentation() override;

  vtkPolyDataMapper* GetLineMapper();

  /// Name of an array as the mappers take it: empty where a list offers "None".
  static std::string GetArrayName(const char* name);

private:
  vtkLineSetsRepresentation(const vtkLineSetsRepresentation&) = delete;
  void operator=(const vtkLineSetsRepresentation&) = delete;

  std::unique_ptr<vtkLineSetsBlocks> Blocks;
};

#endif
