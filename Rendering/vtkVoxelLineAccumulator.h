// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineAccumulator
 * @brief   the mean of pictures whose rays pass through different points of the pixels
 *
 * A picture that is cast again and again while nothing changes has its rays shifted each time, by
 * less than half a pixel (Shift()); the mean of all is the picture with as many samples per pixel.
 *
 * Colours are summed multiplied by their opacity. The depth of a pixel is that of the first picture
 * in which it has a line. A line behind the opaque scene counts as none, so that it
 * neither shines through at the edge of a line before the scene nor lends that its depth.
 */

#ifndef vtkVoxelLineAccumulator_h
#define vtkVoxelLineAccumulator_h

#include "vtkRenderingLineSetsModule.h" // For export macro
#include "vtkVoxelLineFrame.h"
#include "vtkVoxelLineNativeEngine.h"

#include <glm/glm.hpp>

#include <vector>

class VTKRENDERINGLINESETS_EXPORT vtkVoxelLineAccumulator
{
public:
  vtkVoxelLineAccumulator() = default;

  /// Largest number of pictures that may be asked for: the sums stay exact to 16 bits.
  static constexpr int LargestNumber = 4096;

  /**
   * Where the rays of picture i, from 0, pass through a pixel, seen from its centre, in pixels:
   * from -1/2 to 1/2, and the centre for i = 0. The points are those of the Halton sequence with
   * the bases 2 and 3, moved by half a pixel. Of the sequences that were tried (R2, Sobol's) it
   * covers the area beside an edge best for small numbers of pictures.
   */
  static glm::dvec2 GetOffset(int i);

  /// Shift the rays of a frame to those of picture i.
  static void Shift(vtkVoxelLineFrame& frame, int i);

  /// Forget all pictures and the depth of the scene.
  void Clear();

  /// Take the depth of the opaque scene, one value per pixel, or none where it is not known.
  void TakeScene(std::vector<float> depth);

  /// Whether the depth of the scene is the one that was taken; it is taken where none was.
  bool IsSameScene(const std::vector<float>& depth);

  /// Add a picture. All have as many pixels.
  void Add(const vtkVoxelLinePicture& picture);

  int GetNumberOfPictures() const { return this->NumberOfPictures; }

  /// The mean of all pictures, as an engine would have given it; Curve is left alone.
  void GetMean(vtkVoxelLinePicture& mean) const;

private:
  vtkVoxelLineAccumulator(const vtkVoxelLineAccumulator&) = delete;
  void operator=(const vtkVoxelLineAccumulator&) = delete;

  int NumberOfPictures = 0;
  // Red, green and blue times opacity, and opacity, in units of a byte.
  std::vector<glm::vec4> Sums;
  std::vector<float> Depth;
  bool HasScene = false;
  std::vector<float> Scene;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineAccumulator.h
