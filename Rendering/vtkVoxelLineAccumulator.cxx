// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineAccumulator.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace
{
// Pixels that a thread takes at a time.
constexpr vtkIdType Grain = 1 << 14;

// The digits of i behind the point, the lowest one first.
double GetRadicalInverse(int i, int base)
{
  double inverse = 0.0;
  for (double digit = 1.0 / base; i > 0; i /= base, digit /= base)
  {
    inverse += digit * (i % base);
  }
  return inverse;
}

// From a number in [0, 1) to one in [-1/2, 1/2), 0 staying 0.
double Center(double x)
{
  return x < 0.5 ? x : x - 1.0;
}

// From 0 to 255.
std::uint8_t ToByte(float value)
{
  return static_cast<std::uint8_t>(std::min(value, 255.0f) + 0.5f);
}
}

//------------------------------------------------------------------------------
glm::dvec2 vtkVoxelLineAccumulator::GetOffset(int i)
{
  return glm::dvec2(Center(GetRadicalInverse(i, 2)), Center(GetRadicalInverse(i, 3)));
}

//------------------------------------------------------------------------------
void vtkVoxelLineAccumulator::Shift(vtkVoxelLineFrame& frame, int i)
{
  const glm::vec2 offset(GetOffset(i));
  frame.Origin[0] += offset.x * frame.Origin[1] + offset.y * frame.Origin[2];
  frame.Direction[0] += offset.x * frame.Direction[1] + offset.y * frame.Direction[2];
}

//------------------------------------------------------------------------------
void vtkVoxelLineAccumulator::Clear()
{
  this->NumberOfPictures = 0;
  this->HasScene = false;
  // They are large, and not needed while the camera moves.
  this->Sums = std::vector<glm::vec4>();
  this->Depth = std::vector<float>();
  this->Scene = std::vector<float>();
}

//------------------------------------------------------------------------------
void vtkVoxelLineAccumulator::TakeScene(std::vector<float> depth)
{
  this->HasScene = true;
  this->Scene = std::move(depth);
}

//------------------------------------------------------------------------------
bool vtkVoxelLineAccumulator::IsSameScene(const std::vector<float>& depth)
{
  if (!this->HasScene)
  {
    this->TakeScene(depth);
  }
  return this->Scene == depth;
}

//------------------------------------------------------------------------------
void vtkVoxelLineAccumulator::Add(const vtkVoxelLinePicture& picture)
{
  const std::size_t pixels = picture.Depth.size();
  if (this->NumberOfPictures == 0)
  {
    this->Sums.assign(pixels, glm::vec4(0.0f));
    this->Depth.assign(pixels, 1.0f);
  }
  ++this->NumberOfPictures;
  const bool hasScene = this->Scene.size() == pixels;
  vtkSMPTools::For(0, static_cast<vtkIdType>(pixels), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const std::uint8_t* color = picture.Color.data() + 4 * i;
        const float depth = picture.Depth[i];
        if (color[3] == 0 || (hasScene && depth > this->Scene[i]))
        {
          continue;
        }
        const auto opacity = static_cast<float>(color[3]);
        glm::vec4& sum = this->Sums[i];
        this->Depth[i] = sum.w > 0.0f ? this->Depth[i] : depth;
        sum += glm::vec4(glm::vec3(color[0], color[1], color[2]) * (opacity / 255.0f), opacity);
      }
    });
}

//------------------------------------------------------------------------------
void vtkVoxelLineAccumulator::GetMean(vtkVoxelLinePicture& mean) const
{
  const std::size_t pixels = this->Depth.size();
  mean.Color.resize(4 * pixels);
  mean.Depth = this->Depth;
  const float weight = 1.0f / static_cast<float>(std::max(this->NumberOfPictures, 1));
  vtkSMPTools::For(0, static_cast<vtkIdType>(pixels), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const glm::vec4& sum = this->Sums[i];
        const float scale = sum.w > 0.0f ? 255.0f / sum.w : 0.0f;
        for (int c = 0; c < 3; ++c)
        {
          mean.Color[4 * i + c] = ToByte(sum[c] * scale);
        }
        mean.Color[4 * i + 3] = ToByte(sum.w * weight);
      }
    });
}
