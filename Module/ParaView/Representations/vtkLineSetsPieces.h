// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsPieces
 * @brief   finds the pieces of lines that come near boxes
 *
 * The bounds of all blocks of segments and of all other cells are computed once, in world
 * coordinates; then pieces for any number of boxes are found. vtkLineSetsDistribution tells the
 * rules.
 */

#ifndef vtkLineSetsPieces_h
#define vtkLineSetsPieces_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkIdList;
class vtkMatrix4x4;
class vtkPolyData;

class vtkLineSetsPieces
{
public:
  using Box = std::array<double, 6>;

  vtkLineSetsPieces(vtkPolyData* data, vtkMatrix4x4* worldFromData, int blockSize);
  ~vtkLineSetsPieces();

  /// Cells that name points which do not exist: these are in no piece, but for the other points of
  /// poly-vertices.
  vtkIdType GetNumberOfInvalidCells() const { return this->NumberOfInvalidCells; }

  /// What comes within a box, sides included; never null.
  vtkSmartPointer<vtkPolyData> Select(const Box& box) const;

private:
  struct Output;

  /// Finds out how many blocks there are, and their bounds.
  void PartLines();
  /// Whether there are points of these ids.
  bool AreValid(const vtkIdType* ids, vtkIdType size) const;
  Box GetBounds(const vtkIdType* ids, vtkIdType size) const;
  void SelectVertices(const Box& box, Output& output) const;
  void SelectLines(const Box& box, Output& output) const;
  void SelectCells(const Box& box, Output& output) const;
  bool IsClosed(const vtkIdType* ids, vtkIdType size) const;

  vtkSmartPointer<vtkPolyData> Data;
  vtkIdType BlockSize;
  vtkIdType NumberOfInvalidCells = 0;
  /// World coordinates of all points.
  std::vector<std::array<double, 3>> Points;
  /// Bounds of the blocks of all lines, and where those of a line begin.
  std::vector<Box> Blocks;
  std::vector<std::size_t> FirstBlocks;
};

#endif
// VTK-HeaderTest-Exclude: vtkLineSetsPieces.h
