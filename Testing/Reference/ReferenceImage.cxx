// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceImage.h"

#include "vtkImageData.h"

#include <algorithm>

namespace linesets
{
//------------------------------------------------------------------------------
void ReferenceImage::Allocate(int width, int height)
{
  this->Width = std::max(0, width);
  this->Height = std::max(0, height);
  const std::size_t pixels = static_cast<std::size_t>(this->Width) * this->Height;
  this->Color.assign(3 * pixels, 0.0);
  this->Opacity.assign(pixels, 0.0);
  this->Depth.assign(pixels, 1.0);
  this->Curve.assign(pixels, -1);
  this->Layers.assign(pixels, 0);
}

//------------------------------------------------------------------------------
void ReferenceImage::ToImageData(vtkImageData* image) const
{
  image->SetDimensions(this->Width, this->Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  std::transform(this->Color.begin(), this->Color.end(), bytes,
    [](double value)
    { return static_cast<unsigned char>(255.0 * std::min(std::max(value, 0.0), 1.0) + 0.5); });
}
}
