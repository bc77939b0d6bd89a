// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What tests of vtkIlluminatedLineMapper share: two lines under one light, in a window, and the
 * colours that they must have.
 */

#ifndef IlluminatedLineTesting_h
#define IlluminatedLineTesting_h

#include "VoxelLineMapperTesting.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkLight.h"
#include "vtkLineIllumination.h"

namespace IlluminatedLineTesting
{
using namespace VoxelLineMapperTesting;

/// A line along x through the middle of the picture, with a point in the middle, and one upwards,
/// under light from the viewer and from above: two colours.
inline vtkSmartPointer<vtkPolyData> MakeCross(double z = 0.0)
{
  return MakeLines({ { { -0.9, 0.0, z }, { 0.0, 0.0, z }, { 0.9, 0.0, z } },
    { { 0.5, -0.9, z }, { 0.5, -0.3, z } } });
}

constexpr double LightDirection[3] = { 0.0, 0.6, 0.8 };

struct Scene : Stage
{
  vtkNew<vtkIlluminatedLineMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;

  explicit Scene(vtkPolyData* lines = MakeCross(), double opacity = 1.0)
    : Stage(200, 200)
  {
    this->Mapper->SetInputData(lines);
    this->Actor = this->Add(this->Mapper, opacity);
    this->Actor->GetProperty()->SetLineWidth(7.0);
    this->Actor->GetProperty()->SetColor(1.0, 0.5, 0.25);
    this->Actor->GetProperty()->SetAmbient(0.125);
    LookAlongZ(*this);
    vtkNew<vtkLight> light;
    light->SetPosition(LightDirection);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->AddLight(light);
  }
};

inline std::array<int, 3> GetLit(
  const double tangent[3], const Point& color, double ambient = 0.125)
{
  const double viewer[3] = { 0.0, 0.0, 1.0 };
  const double diffuse = vtkLineIllumination::GetDiffuseTerm(
    tangent, viewer, LightDirection, vtkLineIllumination::CylinderAveraging);
  std::array<int, 3> lit;
  for (int i = 0; i < 3; ++i)
  {
    lit[i] = static_cast<int>(std::lround(255.0 * color[i] * (ambient + diffuse)));
  }
  return lit;
}

constexpr double AlongX[3] = { 1.0, 0.0, 0.0 };
constexpr double AlongY[3] = { 0.0, 1.0, 0.0 };
constexpr Point Orange{ 1.0, 0.5, 0.25 };

/// Where the lines of MakeCross() are: beside the middle and on the one upwards.
constexpr int Flat[2] = { 70, 100 };
constexpr int Upright[2] = { 150, 40 };

inline void CheckPixel(Checks& check, const std::string& name, const Picture& picture,
  const int place[2], const std::array<int, 3>& expected, int tolerance = 1)
{
  const auto color = picture.At(place[0], place[1]);
  check(IsNear(color, expected, tolerance),
    name + ":" + Describe(color) + ", expected" + Describe(expected));
}

inline void CheckCross(
  Checks& check, const std::string& name, const Picture& picture, const Point& color = Orange)
{
  CheckPixel(check, name + ", flat", picture, Flat, GetLit(AlongX, color));
  CheckPixel(check, name + ", upright", picture, Upright, GetLit(AlongY, color));
}
}

#endif
