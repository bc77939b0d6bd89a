// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the root mean square, the largest difference and the structural similarity: on images
// whose answer can be written down, and against the definition evaluated window by window.

#include "ImageMeasures.h"
#include "ReferenceTesting.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <stdexcept>

using namespace linesets;

namespace
{
template <typename Function>
void MakeImage(vtkImageData* image, int width, int height, int components, Function&& value)
{
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int c = 0; c < components; ++c)
      {
        *bytes++ = static_cast<unsigned char>(value(x, y, c));
      }
    }
  }
}

double GetLuma(vtkImageData* image, int x, int y)
{
  const auto* p = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
  return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
}

// The definition at one pixel, with central moments in place of differences of means.
double GetSimilarityAt(vtkImageData* a, vtkImageData* b, int cx, int cy)
{
  const int* size = a->GetDimensions();
  double moments[6] = {};
  for (int pass = 0; pass < 2; ++pass)
  {
    for (int y = std::max(0, cy - 5); y <= std::min(size[1] - 1, cy + 5); ++y)
    {
      for (int x = std::max(0, cx - 5); x <= std::min(size[0] - 1, cx + 5); ++x)
      {
        const double distance2 = (x - cx) * (x - cx) + (y - cy) * (y - cy);
        const double weight = std::exp(-distance2 / 4.5);
        const double p = GetLuma(a, x, y);
        const double q = GetLuma(b, x, y);
        if (pass == 0)
        {
          moments[0] += weight;
          moments[1] += weight * p;
          moments[2] += weight * q;
          continue;
        }
        moments[3] += weight * (p - moments[1]) * (p - moments[1]);
        moments[4] += weight * (q - moments[2]) * (q - moments[2]);
        moments[5] += weight * (p - moments[1]) * (q - moments[2]);
      }
    }
    const int first = pass == 0 ? 1 : 3;
    for (int i = first; i < (pass == 0 ? 3 : 6); ++i)
    {
      moments[i] /= moments[0];
    }
  }
  const double c1 = 6.5025;
  const double c2 = 58.5225;
  return (2 * moments[1] * moments[2] + c1) * (2 * moments[5] + c2) /
    ((moments[1] * moments[1] + moments[2] * moments[2] + c1) * (moments[3] + moments[4] + c2));
}

void CheckDifferences(Checker& checker)
{
  vtkNew<vtkImageData> black;
  vtkNew<vtkImageData> other;
  MakeImage(black, 10, 8, 3, [](int, int, int) { return 0; });
  // Four components, the last of which does not count.
  MakeImage(other, 10, 8, 4,
    [](int x, int y, int c)
    { return c == 3 ? 200 : (x == 7 && y == 2 && c == 1 ? 90 : (x == 1 && c == 0 ? 2 : 0)); });
  const ImageDifference difference = CompareImages(black, other);
  checker.CheckNear(
    difference.Rmse, std::sqrt((8100.0 + 8 * 4.0) / 240.0) / 255.0, 1e-15, "root mean square");
  checker.Check(difference.Largest == 90, "largest difference");
  checker.Check(difference.LargestPixel[0] == 7 && difference.LargestPixel[1] == 2, "where it is");
  checker.Check(difference.DifferentPixels == 1, "pixels that differ");
  checker.Check(CompareImages(other, other).Rmse == 0.0, "equal images");
  MakeImage(other, 9, 8, 3, [](int, int, int) { return 0; });
  bool thrown = false;
  try
  {
    CompareImages(black, other);
  }
  catch (const std::invalid_argument&)
  {
    thrown = true;
  }
  checker.Check(thrown, "sizes that differ are an error");
}

void CheckSimilarity(Checker& checker)
{
  vtkNew<vtkImageData> a;
  vtkNew<vtkImageData> b;
  MakeImage(a, 20, 16, 3, [](int, int, int) { return 50; });
  MakeImage(b, 20, 16, 3, [](int, int, int) { return 100; });
  // Flat images: the first factor alone.
  checker.CheckNear(
    GetStructuralSimilarity(a, b), (10000.0 + 6.5025) / (12500.0 + 6.5025), 1e-9, "flat images");
  Random random(5);
  MakeImage(a, 33, 27, 3, [&](int, int, int) { return random.Uniform(0, 256); });
  MakeImage(b, 33, 27, 3,
    [&](int x, int y, int c)
    {
      const auto* p = static_cast<const unsigned char*>(a->GetScalarPointer(x, y, 0));
      return x < 16 ? p[c] : 0.5 * p[c] + random.Uniform(0, 100);
    });
  checker.CheckNear(GetStructuralSimilarity(a, a), 1.0, 1e-9, "equal images");
  double sum = 0.0;
  for (int y = 0; y < 27; ++y)
  {
    for (int x = 0; x < 33; ++x)
    {
      sum += GetSimilarityAt(a, b, x, y);
    }
  }
  checker.Check(sum / (33 * 27) < 0.95, "the test images differ");
  checker.CheckNear(GetStructuralSimilarity(a, b), sum / (33 * 27), 1e-9, "noise");
  // An image and its negative are anticorrelated.
  MakeImage(b, 33, 27, 3,
    [&](int x, int y, int c)
    { return 255 - static_cast<const unsigned char*>(a->GetScalarPointer(x, y, 0))[c]; });
  checker.Check(GetStructuralSimilarity(a, b) < -0.5, "negative");
}
}

int TestImageMeasures(int, char*[])
{
  Checker checker;
  CheckDifferences(checker);
  CheckSimilarity(checker);
  return checker.GetExitCode();
}
