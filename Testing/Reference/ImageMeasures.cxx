// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageMeasures.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace linesets
{
namespace
{
constexpr int WindowRadius = 5;

// The bytes of an image.
struct Pixels
{
  explicit Pixels(vtkImageData* image)
  {
    if (image->GetScalarType() != VTK_UNSIGNED_CHAR || image->GetNumberOfScalarComponents() < 3)
    {
      throw std::invalid_argument("images to compare need three components of unsigned char");
    }
    this->Components = image->GetNumberOfScalarComponents();
    this->Width = image->GetDimensions()[0];
    this->Height = image->GetDimensions()[1];
    this->Data = static_cast<const unsigned char*>(image->GetScalarPointer());
  }

  int Get(int x, int y, int channel) const
  {
    return this->Data[(static_cast<std::size_t>(y) * this->Width + x) * this->Components + channel];
  }

  const unsigned char* Data;
  int Components;
  int Width;
  int Height;
};

void CheckSizes(const Pixels& a, const Pixels& b)
{
  if (a.Width != b.Width || a.Height != b.Height)
  {
    throw std::invalid_argument("images to compare differ in size");
  }
}

using Plane = std::vector<double>;

Plane GetLuma(const Pixels& pixels)
{
  Plane luma;
  luma.reserve(static_cast<std::size_t>(pixels.Width) * pixels.Height);
  for (int y = 0; y < pixels.Height; ++y)
  {
    for (int x = 0; x < pixels.Width; ++x)
    {
      luma.push_back(
        0.299 * pixels.Get(x, y, 0) + 0.587 * pixels.Get(x, y, 1) + 0.114 * pixels.Get(x, y, 2));
    }
  }
  return luma;
}

Plane Multiply(const Plane& a, const Plane& b)
{
  Plane product(a.size());
  std::transform(
    a.begin(), a.end(), b.begin(), product.begin(), [](double x, double y) { return x * y; });
  return product;
}

// Weighted means along one axis: `stride` apart, `length` values, with lines `lineStride` apart.
void BlurLines(
  const Plane& in, Plane& out, int length, std::size_t stride, int lines, std::size_t lineStride)
{
  std::array<double, 2 * WindowRadius + 1> weights;
  for (int i = -WindowRadius; i <= WindowRadius; ++i)
  {
    weights[i + WindowRadius] = std::exp(-0.5 * i * i / (1.5 * 1.5));
  }
  for (int line = 0; line < lines; ++line)
  {
    for (int i = 0; i < length; ++i)
    {
      double sum = 0.0;
      double weight = 0.0;
      for (int j = std::max(0, i - WindowRadius); j <= std::min(length - 1, i + WindowRadius); ++j)
      {
        sum += weights[j - i + WindowRadius] * in[line * lineStride + j * stride];
        weight += weights[j - i + WindowRadius];
      }
      out[line * lineStride + i * stride] = sum / weight;
    }
  }
}

Plane Blur(const Plane& in, int width, int height)
{
  Plane rows(in.size());
  Plane result(in.size());
  BlurLines(in, rows, width, 1, height, width);
  BlurLines(rows, result, height, width, width, 1);
  return result;
}
}

//------------------------------------------------------------------------------
ImageDifference CompareImages(vtkImageData* a, vtkImageData* b)
{
  const Pixels first(a);
  const Pixels second(b);
  CheckSizes(first, second);
  ImageDifference result;
  double sum = 0.0;
  for (int y = 0; y < first.Height; ++y)
  {
    for (int x = 0; x < first.Width; ++x)
    {
      int largest = 0;
      for (int channel = 0; channel < 3; ++channel)
      {
        const int difference = std::abs(first.Get(x, y, channel) - second.Get(x, y, channel));
        sum += static_cast<double>(difference) * difference;
        largest = std::max(largest, difference);
      }
      result.DifferentPixels += largest > 2 ? 1 : 0;
      if (largest > result.Largest)
      {
        result.Largest = largest;
        result.LargestPixel[0] = x;
        result.LargestPixel[1] = y;
      }
    }
  }
  const double count = 3.0 * first.Width * first.Height;
  result.Rmse = count > 0.0 ? std::sqrt(sum / count) / 255.0 : 0.0;
  return result;
}

//------------------------------------------------------------------------------
double GetStructuralSimilarity(vtkImageData* a, vtkImageData* b)
{
  const Pixels first(a);
  const Pixels second(b);
  CheckSizes(first, second);
  const int width = first.Width;
  const int height = first.Height;
  const Plane x = GetLuma(first);
  const Plane y = GetLuma(second);
  const Plane meanX = Blur(x, width, height);
  const Plane meanY = Blur(y, width, height);
  const Plane meanXX = Blur(Multiply(x, x), width, height);
  const Plane meanYY = Blur(Multiply(y, y), width, height);
  const Plane meanXY = Blur(Multiply(x, y), width, height);
  const double c1 = (0.01 * 255.0) * (0.01 * 255.0);
  const double c2 = (0.03 * 255.0) * (0.03 * 255.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double product = meanX[i] * meanY[i];
    const double squares = meanX[i] * meanX[i] + meanY[i] * meanY[i];
    const double covariance = meanXY[i] - product;
    const double variances = meanXX[i] + meanYY[i] - squares;
    sum += (2.0 * product + c1) * (2.0 * covariance + c2) / ((squares + c1) * (variances + c2));
  }
  return x.empty() ? 1.0 : sum / x.size();
}

//------------------------------------------------------------------------------
bool WriteDifferenceImage(
  vtkImageData* a, vtkImageData* b, double gain, const std::string& fileName)
{
  const Pixels first(a);
  const Pixels second(b);
  CheckSizes(first, second);
  vtkNew<vtkImageData> difference;
  difference->SetDimensions(first.Width, first.Height, 1);
  difference->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(difference->GetScalarPointer());
  for (int y = 0; y < first.Height; ++y)
  {
    for (int x = 0; x < first.Width; ++x)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        const int distance = std::abs(first.Get(x, y, channel) - second.Get(x, y, channel));
        *bytes++ = static_cast<unsigned char>(std::min(255.0, gain * distance));
      }
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(difference);
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}
