// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineColoring
 * @brief   what colours the lines: from vtkMapper's settings to a model's attributes and a frame
 *
 * A voxel line model carries one byte per end point (or four of direct colour). Which array they
 * are taken from is decided here by vtkMapper's own rules, and so is the table of colours that the
 * bytes stand for.
 */

#ifndef vtkVoxelLineColoring_h
#define vtkVoxelLineColoring_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkVoxelLineFrame.h"

#include <array>
#include <string>

class vtkMapper;
class vtkPolyData;
class vtkScalarsToColors;
class vtkVoxelLineModel;

class vtkVoxelLineColoring
{
public:
  /// What the attributes of a model are to be made of.
  struct Source
  {
    /// Null: nothing, the lines have the property's colour.
    vtkSmartPointer<vtkDataArray> Array;
    /// Whether it has one value per cell, and not per point.
    bool PerCell = false;
    /// Component to take; -1: the magnitude. Without meaning for direct colours.
    int Component = 0;
    /// First component and number of components whose magnitude is taken.
    int FirstComponent = 0;
    int NumberOfComponents = 1;
    /// Whether the values are colours.
    bool Direct = false;
    /// What of the lookup table makes the colours where its vector mode is RGBCOLORS: range, vector
    /// component and vector size; else zeros.
    std::array<double, 4> ColorMapping{};
    /// Why there is no array, where one was asked for.
    std::string Warning;

    bool operator==(const Source& other) const
    {
      return this->Array == other.Array && this->PerCell == other.PerCell &&
        this->Component == other.Component && this->FirstComponent == other.FirstComponent &&
        this->NumberOfComponents == other.NumberOfComponents && this->Direct == other.Direct &&
        this->ColorMapping == other.ColorMapping;
    }
  };

  /**
   * The array that the mapper's ScalarMode, array access, ColorMode and lookup table select in the
   * input, ScalarVisibility aside. As VTK's mappers do, an array's own lookup table becomes the
   * mapper's.
   */
  static Source Select(vtkMapper* mapper, vtkPolyData* input);

  /**
   * The array in the form that the voxelizer takes: the array itself; or RGBA of 8 bits where it
   * holds direct colours; or lengths where the lookup table wants those of a part of a vector.
   */
  static vtkSmartPointer<vtkDataArray> Convert(vtkMapper* mapper, const Source& source);

  /// Fill colouring and table of a frame from the mapper's lookup table and the model's attributes.
  static void SetColors(vtkVoxelLineFrame& frame, vtkMapper* mapper, vtkVoxelLineModel* model);

  /**
   * That the 8 bits of a model's scalars show as steps of colour, where the lookup table spreads a
   * small part of their range; empty where it does not.
   */
  static std::string DescribeSteps(vtkMapper* mapper, vtkVoxelLineModel* model);

  /// Whether the model has direct colours that let something through.
  static bool HasTranslucentColors(vtkVoxelLineModel* model);
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineColoring.h
