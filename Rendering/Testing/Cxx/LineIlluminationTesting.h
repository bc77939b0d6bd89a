// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the light of a line by quadrature, from the definition of the model alone
 *
 * The facets of a cylinder whose normals are perpendicular to the line are visited one by one. One
 * that faces viewer and light counts by its projected width. Nothing of what the library does to
 * get there (frames, closed forms, tables) is used.
 */

#ifndef LineIlluminationTesting_h
#define LineIlluminationTesting_h

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace LineIlluminationTesting
{
using Vector = glm::dvec3;

/// What a facet's highlight depends on.
enum Highlight
{
  Mirror,  ///< viewer and mirrored light (Phong)
  Halfway, ///< normal and half-way vector (Blinn)
  Facing   ///< normal and light (a lone headlight)
};

struct Terms
{
  double Diffuse = 0.0;
  double Specular = 0.0;
};

inline Terms ReflectFacet(const Vector& normal, const Vector& viewer, const Vector& light,
  double power, Highlight highlight)
{
  const double facing = glm::dot(normal, light);
  double cosine = facing;
  if (highlight == Mirror)
  {
    cosine = glm::dot(viewer, 2.0 * facing * normal - light);
  }
  else if (highlight == Halfway)
  {
    cosine = glm::dot(normal, glm::normalize(viewer + light));
  }
  return { std::max(0.0, facing), power > 0.0 ? std::pow(std::max(0.0, cosine), power) : 1.0 };
}

/// Mean over the visible facets by Simpson's rule on the part that is lit.
inline Terms Average(const Vector& tangent, const Vector& viewer, const Vector& light, double power,
  Highlight highlight)
{
  const double pi = std::acos(-1.0);
  const Vector side = glm::normalize(glm::cross(tangent, viewer));
  const Vector front = glm::normalize(glm::cross(side, tangent));
  // The facets that are lit are half of the girth, about the light's direction around the line.
  const double middle = std::atan2(glm::dot(light, side), glm::dot(light, front));
  const double begin = std::max(-0.5 * pi, middle - 0.5 * pi);
  const double end = std::min(0.5 * pi, middle + 0.5 * pi);
  Terms sum;
  const int steps = 2000;
  for (int i = 0; i <= steps && end > begin; ++i)
  {
    const double theta = begin + (end - begin) * i / steps;
    const double simpson = (i == 0 || i == steps ? 1.0 : (i % 2 ? 4.0 : 2.0)) / 3.0;
    const double weight = simpson * (end - begin) / steps * 0.5 * std::cos(theta);
    const Terms facet = ReflectFacet(
      front * std::cos(theta) + side * std::sin(theta), viewer, light, power, highlight);
    sum.Diffuse += weight * facet.Diffuse;
    sum.Specular += weight * facet.Specular;
  }
  return sum;
}

/// Largest terms of all facets, whether they are visible or not (Banks's principle).
inline Terms Maximum(const Vector& tangent, const Vector& viewer, const Vector& light, double power,
  Highlight highlight)
{
  const double pi = std::acos(-1.0);
  const Vector side = glm::normalize(
    glm::cross(tangent, std::abs(tangent.x) < 0.6 ? Vector(1.0, 0.0, 0.0) : Vector(0.0, 1.0, 0.0)));
  const Vector front = glm::cross(side, tangent);
  Terms best;
  for (int i = 0; i < 20000; ++i)
  {
    const double theta = 2.0 * pi * i / 20000;
    const Terms facet = ReflectFacet(
      front * std::cos(theta) + side * std::sin(theta), viewer, light, power, highlight);
    best.Diffuse = std::max(best.Diffuse, facet.Diffuse);
    best.Specular = std::max(best.Specular, facet.Specular);
  }
  return best;
}

/// Directions without a pattern, all over the sphere (Fibonacci's spiral with a turn).
inline Vector GetDirection(int i, int count, double turn)
{
  const double z = 1.0 - (2.0 * i + 1.0) / count;
  const double angle = i * 2.399963229728653 + turn;
  const double radius = std::sqrt(1.0 - z * z);
  return Vector(radius * std::cos(angle), radius * std::sin(angle), z);
}

/// Sine of the angle between two unit vectors.
inline double GetSine(const Vector& a, const Vector& b)
{
  return glm::length(glm::cross(a, b));
}
}

#endif
