// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Endpoint codes of vtkVoxelLineModel and their places in the words of a segment.
 *
 * vtkVoxelLineModel.h tells the layout; this header is its only implementation in the filters.
 */

#ifndef vtkVoxelLineEncodingPrivate_h
#define vtkVoxelLineEncodingPrivate_h

#include "vtkVoxelLineModel.h"

#include <cmath>
#include <cstdint>

namespace vtkVoxelLineEncoding
{

/// Bits of the local curve id in each word of a segment, and where they start.
constexpr int CurveBitsPerWord = 6;
constexpr int CurveShift = 26;
constexpr std::uint32_t CurveMask = (1u << CurveBitsPerWord) - 1u;

/// Faces from here on mark a point inside the voxel.
constexpr std::uint32_t InteriorFace = 6;

/// Whether this is a number of bins per face that the model knows.
inline bool IsFaceBins(int bins)
{
  return bins == 0 || (bins >= 2 && bins <= 2048 && (bins & (bins - 1)) == 0);
}

inline int EncodingOf(int faceBins)
{
  if (faceBins == 0)
  {
    return vtkVoxelLineModel::Exact;
  }
  return faceBins <= 32 ? vtkVoxelLineModel::OneWord : vtkVoxelLineModel::TwoWords;
}

inline int InteriorBinsOf(int faceBins)
{
  // 2 FaceBins^2 numbers are free in the two interior faces. Integer search: cbrt() may round.
  const std::int64_t codes = 2 * static_cast<std::int64_t>(faceBins) * faceBins;
  std::int64_t bins = 0;
  while ((bins + 1) * (bins + 1) * (bins + 1) <= codes)
  {
    ++bins;
  }
  return static_cast<int>(bins);
}

/// Numbers that are needed again and again to code and decode end points.
struct Codec
{
  explicit Codec(int faceBins)
    : FaceBins(faceBins)
    , InteriorBins(InteriorBinsOf(faceBins))
    , Encoding(EncodingOf(faceBins))
    , Words(Encoding == vtkVoxelLineModel::Exact ? 6 : Encoding + 1)
    , CurveBits(Encoding == vtkVoxelLineModel::Exact ? 0 : Words * CurveBitsPerWord)
  {
    for (this->Bits = 0; (1 << this->Bits) < faceBins; ++this->Bits)
    {
    }
    this->CodeMask = (1u << (2 * this->Bits + 3)) - 1u;
  }

  /// The bin of a voxel-local coordinate among the given number; 1 belongs to the last one.
  static std::uint32_t Bin(double coordinate, int bins)
  {
    const int bin = static_cast<int>(coordinate * bins);
    return static_cast<std::uint32_t>(bin < 0 ? 0 : (bin < bins ? bin : bins - 1));
  }

  std::uint32_t FaceCode(std::uint32_t face, std::uint32_t u, std::uint32_t v) const
  {
    return u | (v << this->Bits) | (face << (2 * this->Bits));
  }

  /// The code of the same point in the voxel on the other side of its face.
  std::uint32_t Opposite(std::uint32_t faceCode) const
  {
    return faceCode ^ (1u << (2 * this->Bits));
  }

  /// Code of a point inside the voxel, from its voxel-local coordinates.
  std::uint32_t InteriorCode(const double point[3]) const
  {
    const std::uint32_t m = static_cast<std::uint32_t>(this->InteriorBins);
    const std::uint32_t q = Bin(point[0], this->InteriorBins) +
      m * (Bin(point[1], this->InteriorBins) + m * Bin(point[2], this->InteriorBins));
    // q = (face - 6) N^2 + v N + u is what the bits spell, read as one number.
    return q + (InteriorFace << (2 * this->Bits));
  }

  /// Voxel-local coordinates of a code. All bin centres are exact in double precision but those of
  /// interior bins, which are the nearest doubles.
  void Decode(std::uint32_t code, double point[3]) const
  {
    const std::uint32_t n = static_cast<std::uint32_t>(this->FaceBins);
    const std::uint32_t face = code >> (2 * this->Bits);
    if (face >= InteriorFace)
    {
      const std::uint32_t m = static_cast<std::uint32_t>(this->InteriorBins);
      const std::uint32_t q = code - (InteriorFace << (2 * this->Bits));
      point[0] = (q % m + 0.5) / m;
      point[1] = (q / m % m + 0.5) / m;
      point[2] = (q / (m * m) + 0.5) / m;
      return;
    }
    const std::uint32_t axis = face / 2;
    point[axis] = face % 2;
    point[(axis + 1) % 3] = ((code & (n - 1u)) + 0.5) / n;
    point[(axis + 2) % 3] = (((code >> this->Bits) & (n - 1u)) + 0.5) / n;
  }

  /// Put two codes into the words of a segment, the local curve id being left 0.
  void Pack(std::uint32_t start, std::uint32_t end, std::uint32_t* words) const
  {
    if (this->Words == 1)
    {
      words[0] = start | (end << (2 * this->Bits + 3));
      return;
    }
    words[0] = start;
    words[1] = end;
  }

  std::uint32_t StartCode(const std::uint32_t* words) const { return words[0] & this->CodeMask; }

  std::uint32_t EndCode(const std::uint32_t* words) const
  {
    return (this->Words == 1 ? words[0] >> (2 * this->Bits + 3) : words[1]) & this->CodeMask;
  }

  /// Add the lower bits of the local curve id; those above CurveBits go into CurveIdExtension.
  void PackCurve(std::uint32_t id, std::uint32_t* words) const
  {
    for (int shift = 0, word = 0; shift < this->CurveBits; shift += CurveBitsPerWord, ++word)
    {
      words[word] |= ((id >> shift) & CurveMask) << CurveShift;
    }
  }

  std::uint32_t Curve(const std::uint32_t* words) const
  {
    std::uint32_t id = 0;
    for (int shift = 0, word = 0; shift < this->CurveBits; shift += CurveBitsPerWord, ++word)
    {
      id |= (words[word] >> CurveShift) << shift;
    }
    return id;
  }

  int FaceBins;
  int InteriorBins;
  int Encoding;
  int Words;
  /// Bits of the local curve id that the words hold.
  int CurveBits;
  int Bits;
  std::uint32_t CodeMask;
};

}

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineEncodingPrivate.h
