// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneFields.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace linesets
{
namespace
{
bool IsInUnitCube(const double point[3])
{
  return std::all_of(point, point + 3, [](double x) { return x >= 0.0 && x <= 1.0; });
}

// Oxygen and both hydrogen atoms: bond length 0.9572 angstrom, bond angle 104.5 degrees.
constexpr double Across = 0.75695;
constexpr double Along = 0.58588;
constexpr double Atoms[3][3] = { { 0.0, 0.0, 0.0 }, { Across, Along, 0.0 },
  { -Across, Along, 0.0 } };

// Where the tornado's funnel is at a height.
struct Funnel
{
  explicit Funnel(double z)
    : Center{ 0.5 + 0.1 * std::sin(10.0 * z), 0.5 + 0.1 * std::cos(3.0 * z) }
    , Radius(0.1 + 0.4 * z * z + 0.1 * z * std::sin(8.0 * z))
    , Wall(0.2 + 0.1 * z)
  {
  }

  double Center[2];
  double Radius;
  double Wall; // thickness
};
}

//------------------------------------------------------------------------------
bool TornadoField::Evaluate(const double point[3], double, double vector[3]) const
{
  if (!IsInUnitCube(point))
  {
    return false;
  }
  const double z = point[2];
  const Funnel funnel(z);
  const double x = point[0] - funnel.Center[0];
  const double y = point[1] - funnel.Center[1];
  const double distance = std::hypot(x, y);
  const double rise = std::max(0.0, 0.1 * (0.1 - distance * z));
  const double fromWall = std::fabs(funnel.Radius - distance);
  const double damping = fromWall > funnel.Wall ? 0.8 - fromWall : 1.0;
  const double speed = std::hypot(distance, rise);
  const double spin =
    (funnel.Radius + funnel.Wall - speed) * damping / ((speed + 1e-10) * (1.0 + z));
  vector[0] = spin * y + 0.1 * x;
  vector[1] = -spin * x + 0.1 * y;
  vector[2] = spin * rise;
  return true;
}

//------------------------------------------------------------------------------
void TornadoField::GetCore(double z, double center[2], double& radius)
{
  const Funnel funnel(z);
  std::copy_n(funnel.Center, 2, center);
  radius = funnel.Radius + funnel.Wall;
}

//------------------------------------------------------------------------------
double TornadoField::GetCoreDistance(const double point[3])
{
  const Funnel funnel(point[2]);
  return std::hypot(point[0] - funnel.Center[0], point[1] - funnel.Center[1]) /
    (funnel.Radius + funnel.Wall);
}

//------------------------------------------------------------------------------
double WaterField::GetAtomDistance(const double point[3])
{
  double least = std::numeric_limits<double>::infinity();
  for (const double* atom : Atoms)
  {
    least = std::min(least, vtkMath::Distance2BetweenPoints(point, atom));
  }
  return std::sqrt(least);
}

//------------------------------------------------------------------------------
bool LorenzField::Evaluate(const double point[3], double, double vector[3]) const
{
  vector[0] = 10.0 * (point[1] - point[0]);
  vector[1] = point[0] * (28.0 - point[2]) - point[1];
  vector[2] = point[0] * point[1] - 8.0 / 3.0 * point[2];
  return true;
}

//------------------------------------------------------------------------------
bool WaterField::Evaluate(const double point[3], double, double vector[3]) const
{
  const double charges[3] = { -2.0, 1.0, 1.0 };
  std::fill_n(vector, 3, 0.0);
  for (int atom = 0; atom < 3; ++atom)
  {
    double r[3];
    vtkMath::Subtract(point, Atoms[atom], r);
    const double distance = vtkMath::Norm(r);
    if (distance < 0.5 * OxygenRadius)
    {
      return false;
    }
    const double factor = charges[atom] / (distance * distance * distance);
    for (int i = 0; i < 3; ++i)
    {
      vector[i] += factor * r[i];
    }
  }
  return std::all_of(point, point + 3, [](double x) { return std::fabs(x) <= 6.0; });
}

//------------------------------------------------------------------------------
WindField::WindField(std::uint64_t seed)
{
  Random random(seed);
  const int count = 9;
  for (int i = 0; i < count; ++i)
  {
    Wave wave;
    const double length = 1.2 * std::pow(0.75, i);
    const double number = vtkMath::Pi() * 2.0 / length;
    const double angle = random.Uniform(0.0, 2.0 * vtkMath::Pi());
    wave.Number[0] = number * std::cos(angle);
    wave.Number[1] = number * std::sin(angle);
    wave.Number[2] = random.Uniform(-4.0, 4.0);
    wave.Frequency = random.Uniform(-0.5, 1.0) * number * 0.4;
    wave.Phase = random.Uniform(0.0, 2.0 * vtkMath::Pi());
    // Speed of about 0.25 for the longest wave, falling with its length.
    wave.Amplitude = 0.25 * std::pow(length / 1.2, 1.0 / 3.0) / number;
    this->Waves.push_back(wave);
  }
}

//------------------------------------------------------------------------------
bool WindField::Evaluate(const double point[3], double time, double vector[3]) const
{
  if (point[0] < 0.0 || point[0] > 2.0 || point[1] < 0.0 || point[1] > 1.0 || point[2] < 0.0 ||
    point[2] > 0.25)
  {
    return false;
  }
  const double height = point[2] / 0.25;
  const double jet = std::sin(vtkMath::Pi() * point[1]);
  vector[0] = (0.3 + 0.6 * height) * jet * jet;
  vector[1] = 0.0;
  vector[2] = 0.0;
  double lift = 0.0;
  for (const Wave& wave : this->Waves)
  {
    const double phase = vtkMath::Dot(wave.Number, point) - wave.Frequency * time + wave.Phase;
    const double slope = wave.Amplitude * std::cos(phase);
    vector[0] -= slope * wave.Number[1];
    vector[1] += slope * wave.Number[0];
    lift += slope;
  }
  vector[2] = 4.0 * lift * height * (1.0 - height);
  // No wind through the walls at the sides.
  vector[1] *= std::min(1.0, 10.0 * std::min(point[1], 1.0 - point[1]));
  return true;
}

//------------------------------------------------------------------------------
ImageField::ImageField(vtkImageData* image, double slowest)
  : Slowest(slowest)
{
  vtkDataArray* vectors = image->GetPointData()->GetVectors();
  if (!vectors)
  {
    throw std::runtime_error("the image has no point vectors");
  }
  image->GetOrigin(this->Origin);
  image->GetSpacing(this->Spacing);
  image->GetDimensions(this->Dimensions);
  int extent[6];
  image->GetExtent(extent);
  for (int i = 0; i < 3; ++i)
  {
    this->Origin[i] += extent[2 * i] * this->Spacing[i];
  }
  this->Vectors.resize(vectors->GetNumberOfTuples());
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    double vector[3];
    vectors->GetTuple(i, vector);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Vectors[i][axis] = static_cast<float>(vector[axis]);
    }
  }
}

//------------------------------------------------------------------------------
bool ImageField::Evaluate(const double point[3], double, double vector[3]) const
{
  std::size_t corners[3][2];
  double weights[3];
  std::size_t stride = 1;
  for (int i = 0; i < 3; ++i)
  {
    const double position = (point[i] - this->Origin[i]) / this->Spacing[i];
    const int last = this->Dimensions[i] - 1;
    if (!(position >= 0.0 && position <= last))
    {
      return false;
    }
    const int cell = std::min(static_cast<int>(position), std::max(0, last - 1));
    weights[i] = position - cell;
    corners[i][0] = cell * stride;
    corners[i][1] = std::min(cell + 1, last) * stride;
    stride *= this->Dimensions[i];
  }
  Interpolate(this->Vectors, corners, weights, vector);
  return vtkMath::Norm(vector) >= this->Slowest;
}

//------------------------------------------------------------------------------
bool TurbulenceField::Evaluate(const double point[3], double, double vector[3]) const
{
  if (!IsInUnitCube(point))
  {
    return false;
  }
  this->Grid.Evaluate(point, vector);
  return true;
}
}
