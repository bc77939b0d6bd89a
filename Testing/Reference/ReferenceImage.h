// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the reference renderer makes. Rows run from the bottom up, as in VTK.
 */

#ifndef ReferenceImage_h
#define ReferenceImage_h

#include "vtkType.h" // For vtkIdType

#include <vector> // For the channels

class vtkImageData;

namespace linesets
{
struct ReferenceImage
{
  int Width = 0;
  int Height = 0;
  /// Red, green and blue per pixel, 0 to 1, composited over the background.
  std::vector<double> Color;
  /// Opacity of all layers together per pixel, without the background.
  std::vector<double> Opacity;
  /// Depth buffer value of the nearest layer, 1 where there is none.
  std::vector<double> Depth;
  /// Curve of the nearest layer, -1 where there is none.
  std::vector<vtkIdType> Curve;
  /// Number of layers; complete only where ReferenceRenderer::CountAllLayers is set.
  std::vector<int> Layers;

  void Allocate(int width, int height);

  /// Red, green and blue as unsigned char, rounded to nearest.
  void ToImageData(vtkImageData* image) const;
};
}

#endif
