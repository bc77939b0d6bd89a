// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityAccumulator
 * @brief   tells whether a view shows the same as in its last picture, and how many it had
 *
 * While nothing changes, each picture is shifted by less than a pixel and added to the others.
 */

#ifndef vtkFourierOpacityAccumulator_h
#define vtkFourierOpacityAccumulator_h

#include "vtkType.h"

#include <vector>

class vtkObject;
class vtkRenderer;

class vtkFourierOpacityAccumulator
{
public:
  /**
   * Begin a picture of a renderer with some settings. Unless all is as it was in the last one, it
   * is the first one. Returns its number, from 0; largest where there were enough pictures already.
   */
  int Begin(vtkRenderer* renderer, vtkObject* settings, int largest);

  /// Make the picture that was begun the first one.
  void Restart() { this->Number = 0; }

  /// The picture was added, or there was no picture.
  void Add() { ++this->Number; }
  void Forget() { this->Key.clear(); }

  /// Number of pictures that were added.
  int GetNumber() const { return this->Number; }

private:
  int Number = 0;
  std::vector<double> Key;
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityAccumulator.h
