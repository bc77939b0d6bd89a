// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Pseudo-random numbers that are the same with every compiler and library, unlike the
 * distributions of the standard library. SplitMix64: Steele, Lea, Flood, "Fast splittable
 * pseudorandom number generators", 2014.
 */

#ifndef Random_h
#define Random_h

#include <cstdint> // For the state

namespace linesets
{
class Random
{
public:
  /// Streams with different numbers are independent, so that each line can have its own.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
    : State(seed)
  {
    this->State = this->Next() + stream * 0xd1342543de82ef95u;
    this->Next();
  }

  std::uint64_t Next()
  {
    this->State += 0x9e3779b97f4a7c15u;
    std::uint64_t z = this->State;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// Uniform in [low, high).
  double Uniform(double low = 0.0, double high = 1.0)
  {
    return low + (high - low) * (static_cast<double>(this->Next() >> 11) * 0x1.0p-53);
  }

private:
  std::uint64_t State;
};
}

#endif
