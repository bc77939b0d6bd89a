// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sums along a ray, of importance or of optical depth, as a series of few terms, and what follows
// from them (Baeza Rojo, Gross and Guenther, "Fourier Opacity Optimization for Scalable
// Exploration", 2019). Common subset of GLSL and C++ with GLM.
//
// A fragment at depth d in [0,1] with value f adds f times fourierTerm(i, d) to sum i, in any
// order; fourierSum() then gives the sum of the values up to a depth. Three kinds of series:
//
// 0 cosines: cos(pi i d). The function is continued as if mirrored at both ends of the ray, so
//   that these do not meet; half a cosine more fits in than with kind 1 and as many sums.
// 1 sines and cosines of the whole period (Eqs. 5, 8, 11, 16 and 17), whose ends meet.
// 2 bins: values are counted in equal intervals, between whose ends the sum is linear.
//
// Where a fragment lies, a series rises by what the fragment itself added, and gives about half of
// that rise (Dirichlet and Jordan), whereas Eqs. 10 and 15 assume all of it. fourierOwnShare() tells
// the part exactly, so that it can be taken out: what remains is the sum of the others.
//
// The engine supplies: Real; LS_OUT; FourierSeries and FourierCount, constants: the kind and the
// number of sums; fourierCoefficient(int i), Real: sum i.

const Real FourierPi = Real(3.14159265358979323846);

struct FourierTerms
{
  Real value[FourierCount];
};

// What a fragment of value 1 at depth d adds to each sum.
FourierTerms fourierTerms(Real d)
{
  FourierTerms terms;
  if (FourierSeries == 2)
  {
    int bin = int(d * Real(FourierCount));
    bin = bin < FourierCount ? bin : FourierCount - 1;
    for (int i = 0; i < FourierCount; ++i)
    {
      terms.value[i] = i == bin ? Real(1) : Real(0);
    }
    return terms;
  }
  terms.value[0] = Real(1);
  // Chebyshev's recurrence: cosine and sine of multiples of one angle.
  Real angle = FourierSeries == 0 ? FourierPi * d : Real(2) * FourierPi * d;
  Real c1 = cos(angle);
  Real s1 = sin(angle);
  Real c = Real(1);
  Real s = Real(0);
  int step = FourierSeries == 0 ? 1 : 2;
  for (int i = 1; i < FourierCount; i += step)
  {
    Real next = c * c1 - s * s1;
    s = s * c1 + c * s1;
    c = next;
    terms.value[i] = c;
    if (FourierSeries == 1)
    {
      terms.value[i + 1] = s;
    }
  }
  return terms;
}

// Sum of all values.
Real fourierTotal()
{
  if (FourierSeries == 2)
  {
    Real total = Real(0);
    for (int i = 0; i < FourierCount; ++i)
    {
      total += fourierCoefficient(i);
    }
    return total;
  }
  return fourierCoefficient(0);
}

// Sum of the values up to depth d, not clamped; and the part of its own value that a fragment at
// that depth finds in it.
Real fourierSum(Real d, LS_OUT(Real) ownShare)
{
  Real sum = Real(0);
  ownShare = Real(0);
  if (FourierSeries == 2)
  {
    for (int i = 0; i < FourierCount; ++i)
    {
      Real part = clamp(d * Real(FourierCount) - Real(i), Real(0), Real(1));
      sum += part * fourierCoefficient(i);
      // A fragment is found in its own bin.
      bool own = part > Real(0) && (part < Real(1) || i == FourierCount - 1);
      ownShare = own ? part : ownShare;
    }
    return sum;
  }
  Real angle = FourierSeries == 0 ? FourierPi * d : Real(2) * FourierPi * d;
  Real c1 = cos(angle);
  Real s1 = sin(angle);
  Real c = Real(1);
  Real s = Real(0);
  sum = d * fourierCoefficient(0);
  ownShare = d;
  int step = FourierSeries == 0 ? 1 : 2;
  for (int i = 1; i < FourierCount; i += step)
  {
    Real next = c * c1 - s * s1;
    s = s * c1 + c * s1;
    c = next;
    Real band = Real(1) / (FourierPi * Real((i + step - 1) / step));
    if (FourierSeries == 0)
    {
      sum += Real(2) * band * s * fourierCoefficient(i);
      ownShare += Real(2) * band * s * c;
    }
    else
    {
      sum += band * (s * fourierCoefficient(i) + (Real(1) - c) * fourierCoefficient(i + 1));
      ownShare += band * s;
    }
  }
  return sum;
}

// Sum of the values of the other fragments in front of a fragment of a value, from fourierSum() at
// its depth: never below 0 or above what the others have in all. Sums too large for half floats are
// infinite, and a series of them may be no number: then nothing counts as in front.
Real fourierFront(Real sum, Real ownShare, Real value, Real total)
{
  Real front = sum - ownShare * value;
  return front > Real(0) ? min(front, max(total - value, Real(0))) : Real(0);
}

// Optimal opacity of a fragment of importance g, from the sums of the squared importance of the
// others in front of it and behind it (Eq. 2); the weights are p, q, r and lambda.
Real optimalOpacity(Real g, Real front, Real behind, vec4 weights)
{
  Real fade = pow(max(Real(1) - g, Real(0)), Real(2) * weights.w);
  return weights.x / (weights.x + fade * (weights.z * front + weights.y * behind));
}

// Optical depth of an opacity (Eq. 14), which is clamped to 0.9999 where it would be infinite.
Real opticalDepth(Real opacity)
{
  return -log(Real(1) - min(opacity, Real(0.9999)));
}

// Weight of a fragment's colour: its opacity times what passes the others in front of it. A
// fragment behind an optical depth of 40 would not be seen; its weight is kept from vanishing so
// that a pixel without any weight has none.
Real colorWeight(Real opacity, Real front)
{
  return opacity * exp(-min(front, Real(40)));
}
