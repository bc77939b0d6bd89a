// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the shader functions of the light model, compiled as C++ in single and double precision,
 * with and without the table: errors below 1/1024 against quadrature for exponents from 0 to 1000,
 * the size of the table, steady values where directions coincide, and the sum over lights.
 */

#include "LineIlluminationTesting.h"
#include "ShaderFunctions.h"
#include "VoxelLineMapperTesting.h"
#include "vtkLineIllumination.h"

#include <cmath>
#include <iomanip>

namespace
{
using namespace LineIlluminationTesting;
using VoxelLineMapperTesting::Checks;
using Light = vtkLineIllumination;

const double Powers[] = { 0.0, 0.3, 1.0, 2.0, 5.0, 20.0, 100.0, 500.0, 1000.0 };

struct Sample
{
  Vector Tangent;
  Vector Viewer;
  Vector Light;
  double Power;
  Highlight Kind;
  Terms Expected;
};

/// Lines, viewers and lights, and what quadrature makes of them.
std::vector<Sample> MakeSamples()
{
  std::vector<Sample> samples;
  const int count = 60;
  for (int i = 0; i < count; ++i)
  {
    Sample sample;
    sample.Tangent = GetDirection(i, count, 0.0);
    sample.Viewer = GetDirection((i * 7 + 3) % count, count, 1.0);
    sample.Light = GetDirection((i * 11 + 5) % count, count, 2.0);
    if (i % 3 == 0)
    {
      // Where the highlight is: the mirrored light meets the viewer.
      const Vector normal = glm::normalize(glm::cross(sample.Tangent, sample.Viewer));
      const Vector n =
        glm::normalize(glm::cross(normal, sample.Tangent) + 0.05 * i / count * normal);
      sample.Light = glm::normalize(
        2.0 * glm::dot(n, sample.Viewer) * n - sample.Viewer + 0.002 * (i % 7) * normal);
    }
    if (GetSine(sample.Tangent, sample.Viewer) < 0.11 ||
      GetSine(sample.Tangent, sample.Light) < 0.11)
    {
      continue; // blended there
    }
    for (double power : Powers)
    {
      for (Highlight kind : { Mirror, Halfway, Facing })
      {
        sample.Power = power;
        sample.Kind = kind;
        sample.Expected = Average(sample.Tangent, sample.Viewer, sample.Light, power, kind);
        samples.push_back(sample);
      }
    }
  }
  return samples;
}

template <typename R>
void CheckAverages(Checks& check, const std::vector<Sample>& samples, bool table, const char* what)
{
  using V = glm::vec<3, R>;
  ShaderTesting::Functions<R> f;
  f.TabulatedMeans = table;
  f.Table = vtkLineIlluminationTable::Get(1.0 / 4096.0);
  std::map<double, double> worst;
  double worstDiffuse = 0.0;
  double worstStretched = 0.0;
  for (const Sample& s : samples)
  {
    f.HalfwayReflection = s.Kind == Halfway;
    f.StretchRange = false;
    const auto response = f.lineResponse(
      V(s.Tangent), V(s.Viewer), V(s.Light), s.Kind == Facing, true, static_cast<R>(s.Power));
    const double diffuse = std::abs(response.x - s.Expected.Diffuse);
    const double specular = std::abs(response.y - s.Expected.Specular);
    worstDiffuse = std::max(worstDiffuse, diffuse);
    worst[s.Power] = std::max(worst[s.Power], specular);
    check(diffuse < 1e-5 && specular < 1.0 / 1024.0,
      std::string(what) + ", exponent " + std::to_string(s.Power) + ", highlight " +
        std::to_string(s.Kind) + ": error " + std::to_string(specular));

    f.StretchRange = true;
    const auto stretched = f.lineResponse(
      V(s.Tangent), V(s.Viewer), V(s.Light), s.Kind == Facing, true, static_cast<R>(s.Power));
    const double peak = Light::GetSpecularPeak(
      s.Power, Light::CylinderAveraging, s.Kind == Mirror ? Light::Phong : Light::Blinn);
    const double off = std::max(
      std::abs(stretched.x - s.Expected.Diffuse / Light::GetDiffusePeak(Light::CylinderAveraging)),
      std::abs(stretched.y - s.Expected.Specular / peak));
    worstStretched = std::max(worstStretched, off);
    check(off < 1.0 / 1024.0,
      std::string(what) + ", stretched, exponent " + std::to_string(s.Power) + ": error " +
        std::to_string(off));
  }
  std::cout << what << ": diffuse " << worstDiffuse << ", stretched " << worstStretched
            << ", specular by exponent:";
  for (const auto& entry : worst)
  {
    std::cout << " " << entry.first << ": " << std::setprecision(2) << entry.second << ",";
  }
  std::cout << "\n";
}

/// The shader functions do what the functions in double precision do, in all directions.
template <typename R>
void CheckSingularCases(Checks& check, bool table)
{
  using V = glm::vec<3, R>;
  ShaderTesting::Functions<R> f;
  f.TabulatedMeans = table;
  f.Table = vtkLineIlluminationTable::Get(1.0 / 4096.0);
  const Vector x(1.0, 0.0, 0.0);
  const Vector y(0.0, 1.0, 0.0);
  const std::vector<Vector> directions = { x, -x, y, glm::normalize(x + 1e-6 * y),
    glm::normalize(x + 0.05 * y), glm::normalize(0.7 * x - y), Vector(0.0, 0.6, 0.8) };
  std::vector<Vector> tangents = directions;
  tangents.emplace_back(0.0);
  double worst = 0.0;
  for (const Vector& t : tangents)
  {
    for (const Vector& v : directions)
    {
      for (const Vector& l : directions)
      {
        for (int model : { Light::CylinderAveraging, Light::MaximumReflection })
        {
          for (Highlight kind : { Mirror, Halfway, Facing })
          {
            f.MaximumReflection = model == Light::MaximumReflection;
            f.HalfwayReflection = kind == Halfway;
            const double power = 20.0;
            const auto response =
              f.lineResponse(V(t), V(v), V(l), kind == Facing, true, static_cast<R>(power));
            const double diffuse = Light::GetDiffuseTerm(&t[0], &v[0], &l[0], model);
            const double specular = kind == Facing
              ? Light::GetHeadlightSpecularTerm(&t[0], &v[0], &l[0], power, model)
              : Light::GetSpecularTerm(
                  &t[0], &v[0], &l[0], power, model, kind == Halfway ? Light::Blinn : Light::Phong);
            const double error =
              std::max(std::abs(response.x - diffuse), std::abs(response.y - specular));
            worst = std::max(worst, error);
            check(error < 2e-3,
              "singular case, model " + std::to_string(model) + ", highlight " +
                std::to_string(kind) + ": error " + std::to_string(error));
          }
        }
      }
    }
  }
  std::cout << "Largest error in singular cases: " << worst << "\n";
}

void CheckTable(Checks& check)
{
  int columns = 0;
  for (double tolerance : { 0.01, 1.0 / 1024.0, 1.0 / 4096.0 })
  {
    const auto table = vtkLineIlluminationTable::Get(tolerance);
    double worst = 0.0;
    for (int i = 0; i <= 300; ++i)
    {
      for (int j = 0; j <= 300; ++j)
      {
        const double x = i / 300.0;
        const double row = j / 300.0;
        worst = std::max(
          worst, std::abs(table->Interpolate(x, row) - vtkLineIlluminationTable::Evaluate(x, row)));
      }
    }
    std::cout << "Table of tolerance " << tolerance << ": " << table->GetColumns() << " x "
              << table->GetRows() << ", error " << worst << "\n";
    check(table->GetLargestError() <= tolerance && worst < 1.05 * tolerance,
      "error of the table of tolerance " + std::to_string(tolerance));
    check(table->GetColumns() > columns && table->GetColumns() * table->GetRows() < 10000,
      "size of the table of tolerance " + std::to_string(tolerance));
    columns = table->GetColumns();
    check(vtkLineIlluminationTable::Get(tolerance) == table, "tables are shared");
  }
  check(vtkLineIlluminationTable::Get(0.01)->Interpolate(std::nan(""), 0.5) > 0.0,
    "the table at NaN is finite");
}

/// lightLine() sums coloured, attenuated lights as lightSurface() does.
void CheckSum(Checks& check)
{
  using V = Vector;
  ShaderTesting::Functions<double> f;
  f.LightKind = { 0, 1, 2 };
  f.LightDirection = { glm::normalize(V(1.0, -2.0, -2.0)), V(0.0), V(0.0, 0.0, -1.0) };
  f.LightPosition = { V(0.0), V(3.0, 1.0, 0.0), V(0.2, 0.1, 0.0) };
  f.LightColor = { V(0.5, 0.4, 0.3), V(1.0, 0.0, 0.0), V(0.0, 0.0, 2.0) };
  f.LightAttenuation = { V(1.0, 0.0, 0.0), V(1.0, 0.2, 0.1), V(0.5, 0.0, 0.0) };
  f.LightSpot = { glm::dvec2(0.0), glm::dvec2(0.0), glm::dvec2(0.9, 3.0) };
  f.LightCount = 3;
  const V position(0.3, -0.2, -4.0);
  const V tangent = glm::normalize(V(1.0, 0.4, 0.3));
  const V ambient(0.01, 0.02, 0.03);
  const V diffuse(0.5, 0.6, 0.7);
  const V specular(0.3, 0.2, 0.1);
  for (bool parallel : { false, true })
  {
    f.ParallelView = parallel;
    const V viewer = parallel ? V(0.0, 0.0, 1.0) : glm::normalize(-position);
    V expected = ambient;
    for (int i = 0; i < 3; ++i)
    {
      V light = -f.LightDirection[i];
      double arrival = 1.0;
      if (i > 0)
      {
        const V way = f.LightPosition[i] - position;
        const double d = glm::length(way);
        light = way / d;
        const V a = f.LightAttenuation[i];
        arrival = 1.0 / (a.x + a.y * d + a.z * d * d);
      }
      if (i == 2)
      {
        arrival *= std::pow(glm::dot(-light, f.LightDirection[i]), 3.0);
      }
      const Terms terms = Average(tangent, viewer, light, 12.0, Mirror);
      expected += f.LightColor[i] * arrival * (diffuse * terms.Diffuse + specular * terms.Specular);
    }
    const V color = f.lightLine(position, tangent, ambient, diffuse, specular, 12.0);
    const double error = glm::length(color - expected);
    check(error < 1e-4, "sum over lights: error " + std::to_string(error));
  }
  // Outside the cone the spot light gives nothing.
  f.LightSpot[2].x = 0.9999;
  const V less = f.lightLine(position, tangent, ambient, diffuse, specular, 12.0);
  check(less.z < 0.25, "a spot light outside its cone");
}
}

int TestLineReflection(int, char*[])
{
  Checks check;
  const std::vector<Sample> samples = MakeSamples();
  CheckAverages<float>(check, samples, true, "Table, single precision");
  CheckAverages<double>(check, samples, true, "Table, double precision");
  CheckAverages<float>(check, samples, false, "Direct, single precision");
  CheckAverages<double>(check, samples, false, "Direct, double precision");
  for (bool table : { false, true })
  {
    CheckSingularCases<float>(check, table);
    CheckSingularCases<double>(check, table);
  }
  CheckTable(check);
  CheckSum(check);
  return check.GetResult();
}
