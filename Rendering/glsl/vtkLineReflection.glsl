// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a line reflects of one light; vtkLineIllumination tells the model, its notation and its
// sources. Common subset of GLSL and C++ with GLM.
//
// The engine supplies: MaximumReflection, HalfwayReflection (Blinn's) and TabulatedMeans, all bool;
// fetchPowerMean(x, row), the table of E_m, with linear interpolation in between, x and row from 0
// to 1; StretchRange, bool.

const Real SmallestSine = Real(0.1); // vtkLineIllumination::SmallestSine

// base is raised to a power as GLSL and C++ both define it: 0^0 is 1.
Real reflectedPower(Real base, Real exponent)
{
  return exponent <= Real(0) ? Real(1) : (base <= Real(0) ? Real(0) : pow(base, exponent));
}

Real sineOf(Real cosine)
{
  return sqrt(max(Real(1) - cosine * cosine, Real(0)));
}

// One pair of points of Gauss's quadrature of order 8 over [0, width].
Real quadraturePair(Real m, Real width, Real node, Real weight)
{
  Real low = width * (Real(0.5) - node);
  Real high = width * (Real(0.5) + node);
  return weight *
    (reflectedPower(Real(1) - low * low, m) + reflectedPower(Real(1) - high * high, m));
}

// E_m(w) = 1/w times the integral from 0 to min(w, 1) of (1 - x^2)^m, for w >= 0. Beyond
// 1 / sqrt(stretch2) the integrand is below 1e-6 or the rest of the way too short to count.
Real meanOfPower(Real m, Real w)
{
  Real stretch2 = Real(1) + m * m / (Real(10) * m + Real(100));
  Real x = w * sqrt(stretch2);
  Real inside = min(x, Real(1));
  Real mean;
  if (TabulatedMeans)
  {
    mean = fetchPowerMean(inside, (Real(2) / (Real(2) + m) - Real(2.0 / 1002.0)) * Real(1.002));
  }
  else
  {
    Real width = inside / sqrt(stretch2);
    mean = quadraturePair(m, width, Real(0.0917173212478249), Real(0.1813418916891810)) +
      quadraturePair(m, width, Real(0.2627662049581645), Real(0.1568533229389436)) +
      quadraturePair(m, width, Real(0.3983332387068134), Real(0.1111905172266872)) +
      quadraturePair(m, width, Real(0.4801449282487681), Real(0.0506142681451881));
  }
  return mean / max(x, Real(1));
}

// E_m(1), half the ratio of the gamma functions of m + 1 and m + 3/2 times sqrt(pi): relative error
// below 6e-5.
Real meanOfWholePower(Real m)
{
  Real rest = Real(1) / (Real(32) * m + Real(28.25) - Real(3) * m / (Real(1) + m));
  return Real(0.886226925452758) / sqrt(m + Real(0.75) + rest);
}

// Average of (X.N)^power over the facets that are lit and visible, for a direction X that lies beta
// from N, seen along the line, and has the given sine to the line (Mallo et al. 2005, Eq. 15).
Real averageOfPower(Real sine, Real cosAlpha, Real cosBeta, Real power)
{
  Real cb = clamp(cosBeta, cosAlpha, Real(1));
  Real sinAlpha = sineOf(cosAlpha);
  Real sinBeta = sineOf(cb);
  Real cosRest = cosAlpha * cb + sinAlpha * sinBeta;
  Real sinRest = max(sinAlpha * cb - cosAlpha * sinBeta, Real(0));
  Real edges = sinBeta / (Real(2) * (power + Real(1))) *
    (reflectedPower(sinBeta, power + Real(1)) - reflectedPower(sinRest, power + Real(1)));
  Real m = Real(0.5) * power;
  Real inside = Real(0.5) * cb *
    (cb * meanOfPower(m, abs(cb)) + cosRest * meanOfPower(m, min(abs(cosRest), Real(1))));
  return reflectedPower(sine, power) * max(edges + inside, Real(0));
}

// The same for the direction of the light itself, beta = alpha.
Real averageOfFacing(Real sine, Real cosAlpha, Real power)
{
  Real sin2 = Real(1) - cosAlpha * cosAlpha;
  Real m = Real(0.5) * power;
  Real edges = sin2 <= Real(0) ? Real(0) : sin2 * pow(sin2, m) / (Real(2) * (power + Real(1)));
  Real inside = Real(0.5) * cosAlpha *
    (cosAlpha * meanOfPower(m, abs(cosAlpha)) + meanOfWholePower(m));
  return reflectedPower(sine, power) * max(edges + inside, Real(0));
}

// Factors of the diffuse and the specular colour of a line for light from the unit direction light.
// byNormal: the highlight of VTK's lone headlight, (L.N)^power. tangent and viewer are unit vectors.
vec2 lineResponse(vec3 tangent, vec3 viewer, vec3 light, bool byNormal, bool shines, Real power)
{
  Real viewerT = dot(viewer, tangent);
  Real lightT = dot(light, tangent);
  Real viewerSine = sineOf(viewerT);
  Real lightSine = sineOf(lightT);
  Real viewerLight = dot(viewer, light);
  Real brightest = viewerSine * lightSine - viewerT * lightT; // Eq. 9
  // There is no half-way vector where viewer and light oppose each other: it fades out before.
  Real halfwayLength = length(viewer + light);
  Real halfwayT = (viewerT + lightT) / max(halfwayLength, Real(1e-6));
  Real halfwaySine = sineOf(halfwayT);
  Real halfwayFade = min(halfwayLength / SmallestSine, Real(1));
  if (MaximumReflection)
  {
    Real best = byNormal ? lightSine : (HalfwayReflection ? halfwaySine : brightest);
    Real fade = HalfwayReflection && !byNormal ? halfwayFade : Real(1);
    return vec2(
      lightSine, shines ? fade * reflectedPower(best, power) : Real(0)); // Eqs. 5 and 9
  }

  Real cosAlpha = clamp((viewerLight - viewerT * lightT) /
      (max(viewerSine, SmallestSine) * max(lightSine, SmallestSine)),
    Real(-1), Real(1));
  Real diffuse = Real(0.25) * lightSine *
    (sineOf(cosAlpha) + (Real(3.14159265358979) - acos(cosAlpha)) * cosAlpha); // Eq. 11
  Real specular = Real(0);
  if (shines)
  {
    if (byNormal)
    {
      specular = averageOfFacing(lightSine, cosAlpha, power);
    }
    else if (HalfwayReflection)
    {
      Real cosBeta = (Real(0.5) * halfwayLength - halfwayT * viewerT) /
        (max(viewerSine, SmallestSine) * max(halfwaySine, Real(1e-6)));
      specular = halfwayFade * averageOfPower(halfwaySine, cosAlpha, cosBeta, power);
    }
    else
    {
      Real lit = Real(0.5) + Real(0.5) * cosAlpha;
      Real w = sqrt(max(Real(1) + viewerLight / max(brightest, Real(1e-6)), Real(0)));
      specular = lit *
        (power > Real(0) ? reflectedPower(brightest, power) * meanOfPower(power, w) : Real(1));
    }
  }
  if (StretchRange)
  {
    // The terms of a line across the view that is lit from the viewer.
    Real halves = Real(byNormal || HalfwayReflection ? 0.5 : 1.0);
    Real peak = meanOfPower(halves * power, Real(1)) *
      (halves < Real(1) || power <= Real(0) ? Real(1) : Real(0.70710678118655));
    diffuse = diffuse * Real(1.27323954473516);
    specular = specular / peak;
  }
  return vec2(diffuse, specular);
}
