// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards vtkLineIllumination: the terms in double precision against quadrature over the facets,
 * the peaks of the paper, symmetry of the direction along the line, finite and steady values where
 * directions coincide, and what setters do with values out of range.
 */

#include "LineIlluminationTesting.h"
#include "VoxelLineMapperTesting.h"
#include "vtkLineIllumination.h"

#include <cmath>
#include <limits>

namespace
{
using namespace LineIlluminationTesting;
using VoxelLineMapperTesting::Checks;
using Light = vtkLineIllumination;

const double Powers[] = { 0.0, 0.5, 1.0, 2.0, 5.0, 20.0, 100.0, 500.0, 1000.0 };

double GetSpecular(
  const Vector& t, const Vector& v, const Vector& l, double power, int model, Highlight highlight)
{
  return highlight == Facing ? Light::GetHeadlightSpecularTerm(&t[0], &v[0], &l[0], power, model)
                             : Light::GetSpecularTerm(&t[0], &v[0], &l[0], power, model,
                                 highlight == Halfway ? Light::Blinn : Light::Phong);
}

void CheckAgainstQuadrature(Checks& check)
{
  double worst = 0.0;
  double worstMaximum = 0.0;
  for (int i = 0; i < 60; ++i)
  {
    const Vector t = GetDirection(i, 60, 0.0);
    const Vector v = GetDirection((i * 7 + 3) % 60, 60, 1.0);
    const Vector l = GetDirection((i * 11 + 5) % 60, 60, 2.0);
    if (GetSine(t, v) < 0.11 || GetSine(t, l) < 0.11)
    {
      continue; // blended there
    }
    for (double power : Powers)
    {
      for (Highlight highlight : { Mirror, Halfway, Facing })
      {
        const Terms mean = Average(t, v, l, power, highlight);
        // Halving the exponents below 1 costs Simpson's rule its order at the edges.
        const double allowed = power < 1.0 && power > 0.0 ? 2e-4 : 1e-6;
        const double error =
          std::max(std::abs(mean.Diffuse -
                     Light::GetDiffuseTerm(&t[0], &v[0], &l[0], Light::CylinderAveraging)),
            std::abs(
              mean.Specular - GetSpecular(t, v, l, power, Light::CylinderAveraging, highlight)));
        worst = std::max(worst, error / allowed);
        check(error < allowed,
          "average for exponent " + std::to_string(power) + ", highlight " +
            std::to_string(highlight) + ": error " + std::to_string(error));
        if (i < 6 && power > 0.0)
        {
          const Terms best = Maximum(t, v, l, power, highlight);
          const double difference =
            std::max(std::abs(best.Diffuse -
                       Light::GetDiffuseTerm(&t[0], &v[0], &l[0], Light::MaximumReflection)),
              std::abs(
                best.Specular - GetSpecular(t, v, l, power, Light::MaximumReflection, highlight)));
          worstMaximum = std::max(worstMaximum, difference);
          check(difference < 1e-4,
            "maximum for exponent " + std::to_string(power) + ": error " +
              std::to_string(difference));
        }
      }
    }
  }
  std::cout << "Largest error of averages, of what is allowed: " << worst
            << "; of maxima: " << worstMaximum << "\n";
}

void CheckPeaks(Checks& check)
{
  const Vector t(1.0, 0.0, 0.0);
  const Vector v(0.0, 0.0, 1.0);
  const double pi = std::acos(-1.0);
  // The products of Mallo et al., Sec. 2.3.2, for even and odd exponents.
  double even = 1.0;
  double odd = pi / 4.0;
  for (int n = 2; n <= 60; n += 2)
  {
    even *= n / (n + 1.0);
    check(
      std::abs(Light::GetSpecularPeak(n, Light::CylinderAveraging, Light::Blinn) - even) < 1e-12,
      "peak of even exponent " + std::to_string(n));
    odd *= n > 2 ? (n - 1.0) / n : 1.0;
    check(
      std::abs(Light::GetSpecularPeak(n - 1, Light::CylinderAveraging, Light::Blinn) - odd) < 1e-12,
      "peak of odd exponent " + std::to_string(n - 1));
  }
  check(std::abs(Light::GetDiffusePeak(Light::CylinderAveraging) - pi / 4.0) < 1e-15 &&
      std::abs(Light::GetDiffuseTerm(&t[0], &v[0], &v[0], Light::CylinderAveraging) - pi / 4.0) <
        1e-12,
    "diffuse peak");
  for (double power : Powers)
  {
    for (int reflection : { Light::Phong, Light::Blinn })
    {
      for (int model : { Light::CylinderAveraging, Light::MaximumReflection })
      {
        const double peak = Light::GetSpecularPeak(power, model, reflection);
        const double term = Light::GetSpecularTerm(&t[0], &v[0], &v[0], power, model, reflection);
        check(std::abs(peak - term) < 1e-12, "peak of exponent " + std::to_string(power));
      }
    }
  }
}

void CheckSymmetry(Checks& check)
{
  for (int i = 0; i < 40; ++i)
  {
    const Vector t = GetDirection(i, 40, 0.3);
    const Vector back = -t;
    const Vector longer = 7.0 * t;
    const Vector v = GetDirection((i * 7 + 3) % 40, 40, 1.0);
    const Vector l = GetDirection((i * 11 + 5) % 40, 40, 2.0);
    for (int model : { Light::CylinderAveraging, Light::MaximumReflection })
    {
      for (Highlight highlight : { Mirror, Halfway, Facing })
      {
        const double there = GetSpecular(t, v, l, 20.0, model, highlight);
        check(std::abs(there - GetSpecular(back, v, l, 20.0, model, highlight)) < 1e-12 &&
            std::abs(there - GetSpecular(longer, v, l, 20.0, model, highlight)) < 1e-12,
          "specular term along either direction, of any length");
      }
      check(std::abs(Light::GetDiffuseTerm(&t[0], &v[0], &l[0], model) -
              Light::GetDiffuseTerm(&back[0], &v[0], &l[0], model)) < 1e-12,
        "diffuse term along either direction");
    }
  }
}

/// Turns a line through the direction to the viewer, or to the light, by 0.1 degree a step.
void CheckSteps(Checks& check)
{
  const double step = std::acos(-1.0) / 1800.0;
  double worst[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < 60; ++i)
  {
    const Vector v = GetDirection(i, 60, 0.5);
    const Vector l = GetDirection((i * 11 + 5) % 60, 60, 2.0);
    const Vector other = GetDirection((i * 13 + 7) % 60, 60, 1.7);
    const Vector pole = i % 2 ? v : l;
    const Vector across = glm::normalize(glm::cross(pole, other));
    for (double power : { 1.0, 20.0, 100.0, 1000.0 })
    {
      double last[3] = { 0.0, 0.0, 0.0 };
      for (int k = -300; k <= 300; ++k)
      {
        const Vector t = pole * std::cos(k * step) + across * std::sin(k * step);
        const double terms[3] = { Light::GetDiffuseTerm(
                                    &t[0], &v[0], &l[0], Light::CylinderAveraging),
          GetSpecular(t, v, l, power, Light::CylinderAveraging, Mirror),
          GetSpecular(t, v, l, power, Light::CylinderAveraging, Halfway) };
        for (int j = 0; j < 3 && k > -300; ++j)
        {
          const double change = std::abs(terms[j] - last[j]);
          // The highlight itself is 1 / sqrt(n) wide, so that its flanks are as steep as that.
          const double allowed = j == 0 ? 0.015 : 0.015 + 0.0025 * std::sqrt(power);
          worst[j] = std::max(worst[j], change / allowed);
          check(change <= allowed,
            "term " + std::to_string(j) + " of exponent " + std::to_string(power) + " changes by " +
              std::to_string(change) + " in a step of 0.1 degrees");
        }
        std::copy(terms, terms + 3, last);
      }
    }
  }
  // A light that passes right behind the line, where there is no half-way vector.
  for (int i = 0; i < 20; ++i)
  {
    const Vector v = GetDirection(i, 20, 0.5);
    const Vector t = GetDirection((i * 7 + 3) % 20, 20, 2.0);
    const Vector across = glm::normalize(glm::cross(v, GetDirection((i * 3) % 20, 20, 1.1)));
    double last = 0.0;
    for (int k = -300; k <= 300; ++k)
    {
      const Vector l = -v * std::cos(k * step) + across * std::sin(k * step);
      const double term = GetSpecular(t, v, l, 20.0, Light::MaximumReflection, Halfway);
      check(k == -300 || std::abs(term - last) < 0.03,
        "light from behind changes by " + std::to_string(std::abs(term - last)) + " in a step");
      last = term;
    }
  }
  std::cout << "Largest change per step, of what is allowed: diffuse " << worst[0] << ", Phong "
            << worst[1] << ", Blinn " << worst[2] << "\n";
}

/// Every combination of directions that coincide, oppose each other or do not exist.
void CheckSingularCases(Checks& check)
{
  const Vector none(0.0);
  const Vector x(1.0, 0.0, 0.0);
  const Vector y(0.0, 1.0, 0.0);
  const Vector tilted = glm::normalize(Vector(1.0, 1e-9, 0.0));
  for (const Vector& t : { none, x, -x, y, tilted })
  {
    for (const Vector& v : { none, x, -x, y, tilted })
    {
      for (const Vector& l : { none, x, -x, y, tilted })
      {
        for (int model : { Light::CylinderAveraging, Light::MaximumReflection })
        {
          const double diffuse = Light::GetDiffuseTerm(&t[0], &v[0], &l[0], model);
          check(diffuse >= 0.0 && diffuse <= 1.0, "diffuse term in a singular case");
          for (double power : Powers)
          {
            for (Highlight highlight : { Mirror, Halfway, Facing })
            {
              const double term = GetSpecular(t, v, l, power, model, highlight);
              check(term >= 0.0 && term <= 1.0 + 1e-12,
                "specular term in a singular case: " + std::to_string(term));
            }
          }
        }
      }
    }
  }
  // Light along the line has no facet to shine on.
  check(Light::GetDiffuseTerm(&x[0], &y[0], &x[0], Light::CylinderAveraging) < 1e-12,
    "light along the line gives no diffuse light");
}

void CheckBadInput(Checks& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Vector x(1.0, 0.0, 0.0);
  const Vector y(0.0, 1.0, 0.0);
  const Vector bad(nan, 0.0, 0.0);
  const Vector endless(0.0, infinity, 0.0);
  for (double power : { -1.0, nan, infinity })
  {
    check(std::isnan(GetSpecular(x, y, y, power, 0, Mirror)) &&
        std::isnan(GetSpecular(x, y, y, power, 0, Facing)) &&
        std::isnan(Light::GetSpecularPeak(power, 0, 0)),
      "a bad exponent gives NaN");
  }
  for (const Vector& v : { bad, endless })
  {
    check(std::isnan(Light::GetDiffuseTerm(&v[0], &y[0], &y[0], 0)) &&
        std::isnan(GetSpecular(x, v, y, 1.0, 0, Mirror)) &&
        std::isnan(GetSpecular(x, y, v, 1.0, 0, Halfway)),
      "a direction that is not finite gives NaN");
  }
  check(std::isnan(Light::GetPowerIntegral(-0.1, 0.5)) &&
      std::isnan(Light::GetPowerIntegral(nan, 0.5)) &&
      std::isnan(Light::GetPowerIntegral(1.0, 1.1)) &&
      std::isnan(Light::GetPowerIntegral(1.0, nan)),
    "an integral that is not defined gives NaN");
  check(std::abs(Light::GetPowerIntegral(1.0, -0.5) + (0.5 - 0.125 / 3.0)) < 1e-14 &&
      Light::GetPowerIntegral(3.0, 0.0) == 0.0 &&
      std::abs(Light::GetPowerIntegral(0.0, 0.3) - 0.3) < 1e-14,
    "integrals of simple polynomials");

  const auto messages = VoxelLineMapperTesting::Listen();
  vtkNew<vtkLineIllumination> light;
  const vtkMTimeType time = light->GetMTime();
  light->SetModel(2);
  light->SetReflection(-1);
  light->SetEvaluation(7);
  light->SetTableTolerance(0.0);
  light->SetTableTolerance(nan);
  light->SetSpecularPower(nan);
  light->SetSpecularPower(1000.5);
  check(messages->TakeErrors("is not valid") == 7, "values out of range are errors");
  check(light->GetMTime() == time && light->GetModel() == Light::CylinderAveraging &&
      light->GetReflection() == Light::Phong && light->GetEvaluation() == Light::Tables &&
      light->GetTableTolerance() == 1.0 / 4096.0 && light->GetSpecularPower() == -1.0,
    "values stay");
  light->SetSpecularPower(1000.0);
  light->SetSpecularPower(-3.0);
  light->SetModelToMaximumReflection();
  light->SetReflectionToBlinn();
  light->SetEvaluationToDirect();
  light->StretchDynamicRangeOn();
  check(messages->IsQuiet() && light->GetMTime() > time, "valid values are taken");
  std::ostringstream os;
  light->Print(os);
  for (const char* word : { "Model: MaximumReflection", "Reflection: Blinn", "Evaluation: Direct",
         "TableTolerance", "StretchDynamicRange: true", "SpecularPower: -3" })
  {
    check(os.str().find(word) != std::string::npos, std::string("Print tells ") + word);
  }
}
}

int TestLineIllumination(int, char*[])
{
  Checks check;
  CheckAgainstQuadrature(check);
  CheckPeaks(check);
  CheckSymmetry(check);
  CheckSteps(check);
  CheckSingularCases(check);
  CheckBadInput(check);
  return check.GetResult();
}
