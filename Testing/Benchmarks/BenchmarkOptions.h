// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The command line of linesets-bench.
 */

#ifndef BenchmarkOptions_h
#define BenchmarkOptions_h

#include <array>    // For weights
#include <iosfwd>   // For the help
#include <optional> // For weights
#include <string>   // For names
#include <vector>   // For lists

namespace linesets
{
/// Of the methods with opacity optimization: Baeza Rojo et al., 2019.
struct OpacityOptions
{
  int Bands = 5;        ///< of the Fourier series, 1 to 16
  int Subset = 1;       ///< one of so many segments is taken for the series, 1 to 10000
  int LineSegments = 0; ///< of all lines together, up to 2^24-1; 0: by the filter
  int Patches = 500;    ///< of all surfaces together, 1 to 2^24-1
  /// Steps of smoothing of opacities along the geometry, 0 to 1000, and p (1e-6 to 1e6), q and r (0
  /// to 1e6) and lambda (0.01 to 100) of the energy, Eq. 1. Without, those of the scene.
  std::optional<int> Smoothing;
  std::optional<std::array<double, 4>> Weights;
  std::string ImportanceSums = "fourier"; ///< or exact
  int ImportanceReduction = 2;            ///< pixels of a side for a sum of importance, 1 to 8
  int DepthReduction = 1;                 ///< the same for a sum of optical depth
  bool HalfFloats = true;                 ///< whether sums of fourier have 2 bytes
  std::string DepthScale = "linear";      ///< or logarithmic
  bool TightDepth = true;                 ///< whether each pixel has its own range of depths
  double OpaqueThreshold = 0.98;          ///< from which on fragments hide, 0.5 to 1
  int ListMemory = 1024;                  ///< MiB, 1 to 1048576
  std::string ImportanceArray;            ///< empty: importance, or else the active scalars
};

struct BenchmarkOptions
{
  std::string Scene;
  std::vector<std::string> Methods;
  std::vector<std::string> Engines = { "automatic" };
  double Radius = 0.0; ///< 0: 1/512 of the longest side of the bounds
  long long Lines = 0;
  int Vertices = 0;
  int Width = 1024;
  int Height = 768;
  double Zoom = 1.0; ///< of the middle of the picture, 0.1 to 100
  double Opacity = 1.0;
  int Frames = 5;
  int Threads = 0; ///< 0: all
  int Resolution = 256;
  int FaceBins = 32;
  int Peels = 0;          ///< 0: no limit
  double LineWidth = 1.0; ///< pixels
  int Samples = 0;        ///< per pixel
  bool Stretch = false;
  std::string Color;  ///< scalars, importance, or empty: importance for opacity optimization alone
  bool Plain = false; ///< one colour on a dark background
  std::string Light = "headlight";
  int ShadowLevel = 1;           ///< of voxel-line-shadow, 1 to 12
  double ConeAngle = 10.0;       ///< of soft shadows, full, in degrees, 0 to 60
  double OcclusionRadius = 15.0; ///< voxels, 1 to 4096
  int OcclusionSamples = 64;     ///< rays per point of hemispheres, 1 to 10000
  bool Animate = false;          ///< other lines in every frame
  bool Reference = false;
  bool DecodedReference = false;
  bool OcclusionReference = false;
  int OcclusionPlaces = 300; ///< held against the occlusion reference, 1 to 1000000
  OpacityOptions Opacities;
  std::string JsonFile;
  std::string ImagePrefix;
  std::string DataFolder;
  bool Help = false;
};

/// Parse the command line; throws std::invalid_argument naming what is wrong and what would be
/// right. Without --methods, Methods are those that suit the opacity.
BenchmarkOptions ParseBenchmarkOptions(int argc, char* argv[]);

/// Tell all options.
void PrintBenchmarkHelp(std::ostream& out);
}

#endif
