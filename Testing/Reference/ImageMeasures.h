// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How far two images are apart. Both images are vtkImageData of unsigned char with at least three
 * components, of the same size; further components are not looked at.
 */

#ifndef ImageMeasures_h
#define ImageMeasures_h

#include <string> // For the file name

class vtkImageData;

namespace linesets
{
struct ImageDifference
{
  /// Root of the mean squared difference over all pixels and red, green, blue; 0 to 1.
  double Rmse = 0.0;
  /// Largest difference of a channel, 0 to 255, and where it is.
  int Largest = 0;
  int LargestPixel[2] = { 0, 0 };
  /// Number of pixels in which some channel differs by more than 2.
  long long DifferentPixels = 0;
};

/// Throws std::invalid_argument where the images do not fit together.
ImageDifference CompareImages(vtkImageData* a, vtkImageData* b);

/**
 * Structural similarity of the luma (0.299 R + 0.587 G + 0.114 B), -1 to 1, where 1 means equal.
 * Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error visibility to structural
 * similarity", 2004, Eq. 13: Gaussian window of 11 x 11 pixels with a standard deviation of 1.5,
 * K1 = 0.01, K2 = 0.03, mean over all pixels. Near the border the window is cut off at the border
 * and its weights are normalized again.
 */
double GetStructuralSimilarity(vtkImageData* a, vtkImageData* b);

/**
 * Write the absolute difference of two images, times `gain` and clamped, as a PNG file. Returns
 * false where the file could not be written.
 */
bool WriteDifferenceImage(
  vtkImageData* a, vtkImageData* b, double gain, const std::string& fileName);
}

#endif
