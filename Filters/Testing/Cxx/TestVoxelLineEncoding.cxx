// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the packing of end points and curve ids into words, for every number of bins: what is
 * packed is what the documentation of vtkVoxelLineModel reads back, no field spills into another,
 * and a face point is the same place from both sides.
 */

#include "VoxelLineTesting.h"
#include "vtkVoxelLineEncodingPrivate.h"

using namespace VoxelLineTesting;
using vtkVoxelLineEncoding::Codec;

namespace
{

/// Codes to try: all of them if there are not too many, else a sample with both ends.
std::vector<std::uint32_t> CodesOf(int bins, int interiorBins)
{
  const std::uint32_t faceCodes = 6u * static_cast<std::uint32_t>(bins * bins);
  const std::uint32_t all = faceCodes + static_cast<std::uint32_t>(std::pow(interiorBins, 3) + 0.5);
  const std::uint32_t step = all < 20000 ? 1 : all / 9973;
  std::vector<std::uint32_t> codes;
  for (std::uint32_t code = 0; code < all; code += step)
  {
    codes.push_back(code);
  }
  codes.push_back(faceCodes - 1);
  codes.push_back(faceCodes);
  codes.push_back(all - 1);
  return codes;
}

void CheckCodes(Checks& check, int bins)
{
  const Codec codec(bins);
  const std::string name = std::to_string(bins) + " bins";
  check(codec.Words == (bins <= 32 ? 1 : 2), name + ": words");
  const int m = codec.InteriorBins;
  check(m * m * m <= 2 * bins * bins && (m + 1) * (m + 1) * (m + 1) > 2 * bins * bins,
    name + ": interior bins are floor(cbrt(2 N^2))");

  int wrongPoints = 0;
  int wrongOpposites = 0;
  int wrongCodes = 0;
  for (std::uint32_t code : CodesOf(bins, m))
  {
    double point[3];
    codec.Decode(code, point);
    const Point expected = DecodeCode(code, bins, m);
    wrongPoints += Point{ point[0], point[1], point[2] } != expected;
    const std::uint32_t face = code >> (2 * codec.Bits);
    if (face >= 6)
    {
      wrongCodes += codec.InteriorCode(point) != code;
      continue;
    }
    const std::uint32_t axis = face / 2;
    const std::uint32_t u = Codec::Bin(point[(axis + 1) % 3], bins);
    const std::uint32_t v = Codec::Bin(point[(axis + 2) % 3], bins);
    wrongCodes += codec.FaceCode(face, u, v) != code;
    double other[3];
    codec.Decode(codec.Opposite(code), other);
    other[axis] += face % 2 == 1 ? 1.0 : -1.0;
    wrongOpposites += !std::equal(point, point + 3, other);
  }
  check(wrongPoints == 0, name + ": decoded points");
  check(wrongCodes == 0, name + ": a point goes back into its code");
  check(wrongOpposites == 0, name + ": both sides of a face are one place");
}

void CheckWords(Checks& check, int bins)
{
  const Codec codec(bins);
  const std::string name = std::to_string(bins) + " bins";
  std::mt19937 generator(7);
  int wrong = 0;
  for (int i = 0; i < 100000; ++i)
  {
    // All bits set or clear in a field find a spill into its neighbour soonest.
    const std::uint32_t start = i % 3 == 0 ? codec.CodeMask : generator() & codec.CodeMask;
    const std::uint32_t end = i % 5 == 0 ? codec.CodeMask : generator() & codec.CodeMask;
    const std::uint32_t id = i % 7 == 0 ? ~0u : generator();
    std::uint32_t words[2] = { 0, 0 };
    codec.Pack(start, end, words);
    codec.PackCurve(id, words);
    const std::uint32_t mask = (1u << codec.CurveBits) - 1u;
    wrong += codec.StartCode(words) != start || codec.EndCode(words) != end ||
      codec.Curve(words) != (id & mask);
    // The same, as the documentation tells it.
    if (bins <= 32)
    {
      const int b = codec.Bits;
      const std::uint32_t word = start | end << (2 * b + 3) | (id & 63u) << 26;
      wrong += words[0] != word;
    }
    else
    {
      wrong += words[0] != (start | (id & 63u) << 26) || words[1] != (end | (id >> 6 & 63u) << 26);
    }
  }
  check(wrong == 0, name + ": words");
}

}

int TestVoxelLineEncoding(int, char*[])
{
  Checks check;
  for (int bins = 2; bins <= 2048; bins *= 2)
  {
    check(vtkVoxelLineEncoding::IsFaceBins(bins), "IsFaceBins");
    CheckCodes(check, bins);
    CheckWords(check, bins);
  }
  for (int bins : { -1, 1, 3, 33, 48, 4096 })
  {
    check(!vtkVoxelLineEncoding::IsFaceBins(bins), "IsFaceBins rejects " + std::to_string(bins));
  }
  check(vtkVoxelLineEncoding::IsFaceBins(0), "0 bins are exact end points");
  check(Codec(32).InteriorBins == 12, "32 bins have 12 interior bins");

  // The points of a bin come back as its centre; the upper bound belongs to the last bin.
  check(Codec::Bin(0.0, 32) == 0 && Codec::Bin(1.0, 32) == 31 && Codec::Bin(0.5, 32) == 16,
    "bins of the ends and the middle");
  return check.GetResult();
}
