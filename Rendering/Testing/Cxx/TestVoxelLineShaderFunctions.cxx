// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
// Guards the shader functions that need no model, compiled as C++ in single and double precision:
// - decodePoint against the text of vtkVoxelLineModel.h,
// - intersectTube and tubeNormal against a distance function that shares nothing with them,
// - lightSurface against numbers worked out by hand.
#include "ShaderFunctions.h"

#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
template <typename R>
using Vector = glm::vec<3, R>;

int Failures = 0;

void Check(bool good, const char* what, double value, double bound)
{
  if (!good)
  {
    std::cerr << "Failed: " << what << " is " << value << ", allowed is " << bound << "\n";
    ++Failures;
  }
}

/// Signed distance from the convex hull of two spheres, by ternary search along the axis: the hull
/// is the union of the spheres whose centre and radius are interpolated between both ends.
double TubeDistance(
  const Vector<double>& x, const Vector<double>& a, const Vector<double>& b, double ra, double rb)
{
  const auto at = [&](double s)
  { return glm::length(x - (a + (b - a) * s)) - (ra + (rb - ra) * s); };
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 80; ++i)
  {
    const double m0 = low + (high - low) / 3.0;
    const double m1 = high - (high - low) / 3.0;
    (at(m0) < at(m1) ? high : low) = at(m0) < at(m1) ? m1 : m0;
  }
  return at(0.5 * (low + high));
}

/// The model's class documentation, written again with integer arithmetic.
void TestDecode()
{
  for (int bits = 1; bits <= 11; ++bits)
  {
    const int bins = 1 << bits;
    int interior = 1;
    while ((interior + 1) * (interior + 1) * (interior + 1) <= 2 * bins * bins)
    {
      ++interior;
    }
    ShaderTesting::Functions<double> f;
    ShaderTesting::Functions<float> g;
    const int step = std::max(1, bins / 7);
    for (int face = 0; face < 6; ++face)
    {
      for (int u = 0; u < bins; u += step)
      {
        for (int v = 0; v < bins; v += step)
        {
          const std::uint32_t code = static_cast<std::uint32_t>(face * bins * bins + v * bins + u);
          Vector<double> expected;
          expected[face / 2] = face % 2;
          expected[(face / 2 + 1) % 3] = (u + 0.5) / bins;
          expected[(face / 2 + 2) % 3] = (v + 0.5) / bins;
          double error = glm::length(f.decodePoint(code, bits, interior) - expected);
          Check(error < 1e-12, "position of a face point (double)", error, 1e-12);
          error = glm::length(Vector<double>(g.decodePoint(code, bits, interior)) - expected);
          Check(error < 1e-6, "position of a face point (float)", error, 1e-6);
        }
      }
    }
    for (int i = 0; i < interior; i += std::max(1, interior / 5))
    {
      const int j = (i * 7 + 3) % interior;
      const int k = interior - 1 - i;
      const std::uint32_t code =
        static_cast<std::uint32_t>(6 * bins * bins + i + interior * (j + interior * k));
      const Vector<double> expected(
        (i + 0.5) / interior, (j + 0.5) / interior, (k + 0.5) / interior);
      const double error = glm::length(f.decodePoint(code, bits, interior) - expected);
      Check(error < 1e-12, "position of an interior point", error, 1e-12);
      Check(code < 8u * bins * bins, "an interior code", code, 8.0 * bins * bins);
    }
  }
}

/// Random tubes and lines: the ends of the interval lie on the surface, the middle inside, and
/// a line that misses keeps its distance.
template <typename R>
void TestIntersection(double tolerance)
{
  ShaderTesting::Functions<R> f;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  const auto next = [&random](double low, double high)
  {
    random->Next();
    return low + (high - low) * random->GetValue();
  };
  int hits = 0;
  int misses = 0;
  double worst = 0.0;
  for (int n = 0; n < 20000; ++n)
  {
    const Vector<double> a(next(0, 1), next(0, 1), next(0, 1));
    Vector<double> b(next(0, 1), next(0, 1), next(0, 1));
    const int kind = n % 5;
    const double ra = next(0.05, 0.6);
    const double rb = kind == 0 ? next(0.05, 0.6) : ra;
    if (kind == 1)
    {
      b = a; // no length: a sphere
    }
    Vector<double> d = glm::normalize(Vector<double>(next(-1, 1), next(-1, 1), next(-1, 1)));
    if (kind == 2)
    {
      d = glm::normalize(b - a); // along the axis
    }
    if (kind == 3)
    {
      d = Vector<double>(0.0);
      d[n % 3] = (n / 3) % 2 ? 1.0 : -1.0; // along a grid axis
    }
    const Vector<double> target(next(-0.5, 1.5), next(-0.5, 1.5), next(-0.5, 1.5));
    const Vector<double> o = target - d * next(0.0, 3.0);
    R entry;
    R leave;
    const bool hit = f.intersectTube(Vector<R>(o), Vector<R>(d), Vector<R>(a), Vector<R>(b),
      static_cast<R>(ra), static_cast<R>(rb), entry, leave);
    if (hit)
    {
      ++hits;
      // A grazing line crosses the surface at so flat an angle that rounding moves it far along.
      const double grazing = static_cast<double>(leave - entry) < 0.02 ? 20.0 : 1.0;
      for (double t : { static_cast<double>(entry), static_cast<double>(leave) })
      {
        const Vector<double> x = o + d * t;
        const double error = std::abs(TubeDistance(x, a, b, ra, rb));
        worst = std::max(worst, error / grazing);
        Check(error <= tolerance * grazing, "distance of a hit from the surface", error, tolerance);
        const Vector<double> normal(f.tubeNormal(
          Vector<R>(x), Vector<R>(a), Vector<R>(b), static_cast<R>(ra), static_cast<R>(rb)));
        const double step = 1e-3;
        const double outside = TubeDistance(x + normal * step, a, b, ra, rb);
        Check(std::abs(outside - step) < 0.02 * step + 2.0 * error,
          "distance one step along the normal", outside, step);
      }
      const double inside =
        TubeDistance(o + d * (0.5 * (static_cast<double>(entry) + leave)), a, b, ra, rb);
      Check(inside <= tolerance, "distance of an interval's middle", inside, tolerance);
    }
    else
    {
      ++misses;
      double nearest = 1e30;
      for (int i = 0; i <= 100; ++i)
      {
        nearest = std::min(nearest, TubeDistance(o + d * (-1.0 + 0.06 * i), a, b, ra, rb));
      }
      Check(nearest > -tolerance, "distance of a line that misses", nearest, -tolerance);
      n += 3; // misses are dear to verify
    }
  }
  std::cout << "Tubes: " << hits << " hits, " << misses << " misses, largest error " << worst
            << "\n";
  Check(hits > 900, "number of hits", hits, 900);
  Check(misses > 900, "number of misses", misses, 900);
}

void TestLight()
{
  using V = Vector<double>;
  ShaderTesting::Functions<double> f;
  const auto add = [&f](int kind, const V& direction, const V& position, const V& attenuation,
                     double cone, double exponent)
  {
    f.LightKind.push_back(kind);
    f.LightDirection.push_back(direction);
    f.LightPosition.push_back(position);
    f.LightColor.push_back(V(1.0, 0.5, 0.25));
    f.LightAttenuation.push_back(attenuation);
    f.LightSpot.emplace_back(cone, exponent);
    f.LightCount = static_cast<int>(f.LightKind.size());
  };
  const auto clear = [&f]()
  {
    f.LightKind.clear();
    f.LightDirection.clear();
    f.LightPosition.clear();
    f.LightColor.clear();
    f.LightAttenuation.clear();
    f.LightSpot.clear();
    f.LightCount = 0;
  };
  V specular(0.0);
  double power = 1.0;
  const V slanted = glm::normalize(V(0.0, 3.0, 4.0)); // N.z = 0.8
  const auto expect = [&](const V& normal, const V& expected, const char* what)
  {
    const V color = f.lightSurface(V(0.0, 0.0, -5.0), normal, V(0.1), V(0.5), specular, power);
    const double error = glm::length(color - expected);
    Check(error < 1e-9, what, error, 1e-9);
  };

  expect(slanted, V(0.1), "error without lights");

  // A directional light along the view: diffuse 0.8; mirrored direction has z = 2 0.64 - 1 = 0.28.
  specular = V(0.3);
  power = 2.0;
  add(0, V(0.0, 0.0, -1.0), V(0.0), V(1.0, 0.0, 0.0), 0.0, 0.0);
  expect(slanted, V(0.1) + V(1.0, 0.5, 0.25) * (0.4 + 0.3 * 0.28 * 0.28), "error of a light");
  // From behind it gives nothing.
  expect(-slanted, V(0.1), "error of a light from behind");
  clear();

  // VTK's lone headlight takes its highlight from the normal: 0.8^2.
  add(3, V(0.0, 0.0, -1.0), V(0.0), V(1.0, 0.0, 0.0), 0.0, 0.0);
  expect(slanted, V(0.1) + V(1.0, 0.5, 0.25) * (0.4 + 0.3 * 0.64), "error of a headlight");
  // The exponent 0 makes every lit point shine.
  power = 0.0;
  expect(slanted, V(0.1) + V(1.0, 0.5, 0.25) * (0.4 + 0.3), "error of the exponent 0");
  power = 2.0;
  clear();

  // A positional light at distance 5 with attenuation 1 / (1 + 2 5 + 3 25) = 1 / 86.
  add(1, V(0.0), V(0.0), V(1.0, 2.0, 3.0), 0.0, 0.0);
  expect(slanted, V(0.1) + V(1.0, 0.5, 0.25) * ((0.4 + 0.3 * 0.28 * 0.28) / 86.0),
    "error of a positional light");
  clear();

  // A spot light on its axis, and with the point outside its cone.
  add(2, V(0.0, 0.0, -1.0), V(0.0), V(1.0, 0.0, 0.0), 0.9, 4.0);
  expect(slanted, V(0.1) + V(1.0, 0.5, 0.25) * (0.4 + 0.3 * 0.28 * 0.28), "error of a spot light");
  clear();
  add(2, V(0.0, 1.0, 0.0), V(0.0), V(1.0, 0.0, 0.0), 0.9, 4.0);
  expect(slanted, V(0.1), "error outside a spot light");
}
}

int TestVoxelLineShaderFunctions(int, char*[])
{
  TestDecode();
  TestIntersection<double>(1e-9);
  TestIntersection<float>(5e-6);
  TestLight();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
