// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineModelSource
 * @brief   the model that a vtkVoxelLineMapper draws: its input, or what it built of it
 *
 * Lines are voxelized with what colours them by the rules of vtkMapper, and again only when one of
 * these or a parameter of the voxelizer changed. It also keeps what is looked up in a whole model
 * once: whether its colours let something through, and its smallest radius.
 */

#ifndef vtkVoxelLineModelSource_h
#define vtkVoxelLineModelSource_h

#include "vtkLineVoxelizer.h"
#include "vtkSmartPointer.h"
#include "vtkVoxelLineColoring.h"

#include <string>

class vtkMapper;
class vtkPolyData;
class vtkVoxelLineModel;

class vtkVoxelLineModelSource
{
public:
  vtkVoxelLineModelSource();
  ~vtkVoxelLineModelSource();

  /// Of the voxelizer; see vtkVoxelLineMapper.
  struct Parameters
  {
    int Resolution = 256;
    int FaceBins = 32;
    double InteriorTolerance = 0.0;
    std::string RadiusArrayName;
    bool UseCustomBounds = false;
    bool UseCustomRanges = false;
    vtkLineVoxelizer::Measures Custom;
  };

  /// What is measured of lines with what the mapper colours them by.
  static vtkLineVoxelizer::Measures Measure(
    vtkMapper* mapper, vtkPolyData* lines, const Parameters& parameters);

  /**
   * Voxelize lines, where they or a parameter changed, with what the mapper colours them by.
   * Returns the seconds that it took, or a negative number where nothing changed; warning says why
   * the lines do not get the colours that were asked for, or is left alone where that was not
   * looked at.
   */
  double Build(
    vtkMapper* mapper, vtkPolyData* lines, const Parameters& parameters, std::string& warning);

  /// Take a model (or nullptr) as it is. What was made of lines is let go.
  void SetModel(vtkVoxelLineModel* model);

  vtkVoxelLineModel* GetModel() const { return this->Model; }

  /// The lines that the model was made of; nullptr where they are not known.
  vtkPolyData* GetLines() const { return this->Input; }

  /// Whether the model has direct colours that let something through.
  bool HasTranslucentColors();

  /// Smallest radius above 0 of a model that has radii, in units of the data.
  double GetSmallestRadius();

private:
  vtkVoxelLineModelSource(const vtkVoxelLineModelSource&) = delete;
  void operator=(const vtkVoxelLineModelSource&) = delete;

  void SetInput(vtkMapper* mapper, vtkPolyData* lines, const vtkVoxelLineColoring::Source& source);
  void SetParameters(const Parameters& parameters);

  vtkSmartPointer<vtkLineVoxelizer> Voxelizer;
  vtkSmartPointer<vtkVoxelLineModel> Model;

  // What the voxelizer's input was made of.
  vtkSmartPointer<vtkPolyData> Input;
  vtkMTimeType InputTime = 0;
  vtkVoxelLineColoring::Source Source;

  // Answers of the last two functions, for a model at a time.
  vtkVoxelLineModel* TranslucencyModel = nullptr;
  vtkMTimeType TranslucencyTime = 0;
  bool TranslucentColors = false;
  vtkVoxelLineModel* RadiusModel = nullptr;
  vtkMTimeType RadiusTime = 0;
  double SmallestRadius = 0.0;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineModelSource.h
