// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkOptions.h"

#include "BenchmarkMethod.h"
#include "Scenes.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

namespace linesets
{
namespace
{
std::vector<std::string> Split(const std::string& text)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == ',')
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

std::string Join(const std::vector<std::string>& parts)
{
  std::string text;
  for (const std::string& part : parts)
  {
    text += (text.empty() ? "" : " ") + part;
  }
  return text;
}

double ToNumber(const std::string& option, const std::string& text, double low, double high)
{
  std::size_t used = 0;
  double value = 0.0;
  try
  {
    value = std::stod(text, &used);
  }
  catch (const std::logic_error&)
  {
    used = 0;
  }
  if (used == 0 || used != text.size() || !(value >= low && value <= high))
  {
    throw std::invalid_argument(option + ": " + text + " is not a number from " +
      std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

long long ToInteger(
  const std::string& option, const std::string& text, long long low, long long high)
{
  std::size_t used = 0;
  long long value = 0;
  try
  {
    value = std::stoll(text, &used);
  }
  catch (const std::logic_error&)
  {
    used = 0;
  }
  if (used == 0 || used != text.size() || value < low || value > high)
  {
    throw std::invalid_argument(option + ": " + text + " is not a whole number from " +
      std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

int ToInt(const std::string& option, const std::string& text, int low, int high)
{
  return static_cast<int>(ToInteger(option, text, low, high));
}

std::vector<std::string> ToNames(
  const std::string& option, const std::string& text, const std::vector<std::string>& known)
{
  std::vector<std::string> names = Split(text);
  for (const std::string& name : names)
  {
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      throw std::invalid_argument(
        option + ": " + (name.empty() ? "an empty name" : name) + " is none of " + Join(known));
    }
    if (std::count(names.begin(), names.end(), name) > 1)
    {
      throw std::invalid_argument(option + ": " + name + " is named twice");
    }
  }
  return names;
}

std::string ToOneName(
  const std::string& option, const std::string& text, const std::vector<std::string>& known)
{
  if (std::find(known.begin(), known.end(), text) == known.end())
  {
    throw std::invalid_argument(
      option + ": " + (text.empty() ? "an empty name" : text) + " is none of " + Join(known));
  }
  return text;
}

std::string ToGivenName(const std::string& option, const std::string& text)
{
  if (text.empty())
  {
    throw std::invalid_argument(option + ": an empty name");
  }
  return text;
}

void SetSize(BenchmarkOptions& options, const std::string& text)
{
  const std::size_t x = text.find('x');
  if (x == std::string::npos)
  {
    throw std::invalid_argument("--size: " + text + " is not of the form WIDTHxHEIGHT");
  }
  options.Width = ToInt("--size", text.substr(0, x), 1, 16384);
  options.Height = ToInt("--size", text.substr(x + 1), 1, 16384);
}

int ToFaceBins(const std::string& text)
{
  const int bins = ToInt("--face-bins", text, 0, 2048);
  if (bins == 1 || (bins & (bins - 1)) != 0)
  {
    throw std::invalid_argument(
      "--face-bins: " + text + " is neither a power of two from 2 to 2048 nor 0 (exact)");
  }
  return bins;
}

std::array<double, 4> ToWeights(const std::string& text)
{
  const std::vector<std::string> parts = Split(text);
  if (parts.size() != 4)
  {
    throw std::invalid_argument("--weights: " + text + " is not of the form P,Q,R,LAMBDA");
  }
  // As vtkOpacityOptimization has them.
  constexpr double least = 1e-6;
  constexpr double most = 1e6;
  return { { ToNumber("--weights, p", parts[0], least, most),
    ToNumber("--weights, q", parts[1], 0.0, most), ToNumber("--weights, r", parts[2], 0.0, most),
    ToNumber("--weights, lambda", parts[3], 0.01, 100.0) } };
}

using Setter = std::function<void(BenchmarkOptions&, const std::string&)>;

std::map<std::string, Setter> GetSetters()
{
  using O = BenchmarkOptions;
  using S = std::string;
  return {
    { "--scene", [](O& o, const S& v) { o.Scene = v; } },
    { "--methods",
      [](O& o, const S& v) { o.Methods = ToNames("--methods", v, GetMethodNames()); } },
    { "--engine",
      [](O& o, const S& v) {
        o.Engines = ToNames("--engine", v, { "automatic", "native", "shader" });
      } },
    { "--radius", [](O& o, const S& v) { o.Radius = ToNumber("--radius", v, 1e-300, 1e300); } },
    { "--lines", [](O& o, const S& v) { o.Lines = ToInteger("--lines", v, 1, 100000000); } },
    { "--vertices", [](O& o, const S& v) { o.Vertices = ToInt("--vertices", v, 2, 1000000); } },
    { "--size", SetSize },
    { "--zoom", [](O& o, const S& v) { o.Zoom = ToNumber("--zoom", v, 0.1, 100.0); } },
    { "--opacity", [](O& o, const S& v) { o.Opacity = ToNumber("--opacity", v, 0.0, 1.0); } },
    { "--frames", [](O& o, const S& v) { o.Frames = ToInt("--frames", v, 1, 100000); } },
    { "--threads", [](O& o, const S& v) { o.Threads = ToInt("--threads", v, 1, 1024); } },
    { "--resolution", [](O& o, const S& v) { o.Resolution = ToInt("--resolution", v, 1, 4096); } },
    { "--face-bins", [](O& o, const S& v) { o.FaceBins = ToFaceBins(v); } },
    { "--peels", [](O& o, const S& v) { o.Peels = ToInt("--peels", v, 0, VTK_INT_MAX); } },
    { "--line-width",
      [](O& o, const S& v) { o.LineWidth = ToNumber("--line-width", v, 0.1, 1000.0); } },
    { "--samples", [](O& o, const S& v) { o.Samples = ToInt("--samples", v, 0, 64); } },
    { "--light",
      [](O& o, const S& v) {
        o.Light = ToOneName("--light", v, { "headlight", "right", "studio" });
      } },
    { "--shadow-level",
      [](O& o, const S& v) { o.ShadowLevel = ToInt("--shadow-level", v, 1, 12); } },
    { "--cone-angle",
      [](O& o, const S& v) { o.ConeAngle = ToNumber("--cone-angle", v, 0.0, 60.0); } },
    { "--occlusion-radius",
      [](O& o, const S& v)
      { o.OcclusionRadius = ToNumber("--occlusion-radius", v, 1.0, 4096.0); } },
    { "--occlusion-samples",
      [](O& o, const S& v) { o.OcclusionSamples = ToInt("--occlusion-samples", v, 1, 10000); } },
    { "--occlusion-places",
      [](O& o, const S& v) { o.OcclusionPlaces = ToInt("--occlusion-places", v, 1, 1000000); } },
    { "--bands", [](O& o, const S& v) { o.Opacities.Bands = ToInt("--bands", v, 1, 16); } },
    { "--subset", [](O& o, const S& v) { o.Opacities.Subset = ToInt("--subset", v, 1, 10000); } },
    { "--line-segments",
      [](O& o, const S& v)
      { o.Opacities.LineSegments = ToInt("--line-segments", v, 0, (1 << 24) - 1); } },
    { "--patches",
      [](O& o, const S& v) { o.Opacities.Patches = ToInt("--patches", v, 1, (1 << 24) - 1); } },
    { "--smoothing",
      [](O& o, const S& v) { o.Opacities.Smoothing = ToInt("--smoothing", v, 0, 1000); } },
    { "--weights", [](O& o, const S& v) { o.Opacities.Weights = ToWeights(v); } },
    { "--importance-sums",
      [](O& o, const S& v) {
        o.Opacities.ImportanceSums = ToOneName("--importance-sums", v, { "fourier", "exact" });
      } },
    { "--importance-reduction",
      [](O& o, const S& v)
      { o.Opacities.ImportanceReduction = ToInt("--importance-reduction", v, 1, 8); } },
    { "--depth-reduction",
      [](O& o, const S& v) { o.Opacities.DepthReduction = ToInt("--depth-reduction", v, 1, 8); } },
    { "--half-floats",
      [](O& o, const S& v) {
        o.Opacities.HalfFloats = ToOneName("--half-floats", v, { "on", "off" }) == "on";
      } },
    { "--depth-scale",
      [](O& o, const S& v) {
        o.Opacities.DepthScale = ToOneName("--depth-scale", v, { "linear", "logarithmic" });
      } },
    { "--tight-depth",
      [](O& o, const S& v) {
        o.Opacities.TightDepth = ToOneName("--tight-depth", v, { "on", "off" }) == "on";
      } },
    { "--opaque-threshold",
      [](O& o, const S& v)
      { o.Opacities.OpaqueThreshold = ToNumber("--opaque-threshold", v, 0.5, 1.0); } },
    { "--list-memory",
      [](O& o, const S& v) { o.Opacities.ListMemory = ToInt("--list-memory", v, 1, 1 << 20); } },
    { "--color",
      [](O& o, const S& v) {
        o.Color = ToOneName("--color", v, { "scalars", "importance" });
      } },
    { "--importance",
      [](O& o, const S& v) { o.Opacities.ImportanceArray = ToGivenName("--importance", v); } },
    { "--json", [](O& o, const S& v) { o.JsonFile = v; } },
    { "--image", [](O& o, const S& v) { o.ImagePrefix = v; } },
    { "--data", [](O& o, const S& v) { o.DataFolder = v; } },
  };
}

std::map<std::string, bool BenchmarkOptions::*> GetFlags()
{
  return { { "--reference", &BenchmarkOptions::Reference },
    { "--reference-decoded", &BenchmarkOptions::DecodedReference },
    { "--occlusion-reference", &BenchmarkOptions::OcclusionReference },
    { "--stretch", &BenchmarkOptions::Stretch }, { "--plain", &BenchmarkOptions::Plain },
    { "--animate", &BenchmarkOptions::Animate }, { "--help", &BenchmarkOptions::Help } };
}

void CheckOcclusionReference(const BenchmarkOptions& options)
{
  if (std::none_of(options.Methods.begin(), options.Methods.end(), HasSphericalOcclusion))
  {
    throw std::invalid_argument("--occlusion-reference: none of the methods has spherical "
                                "occlusion, as voxel-occlusion and voxel-full have");
  }
  if (options.Opacity < 1.0)
  {
    throw std::invalid_argument("--occlusion-reference: needs an opacity of 1");
  }
}

void CheckTogether(BenchmarkOptions& options)
{
  if (options.Scene.empty())
  {
    throw std::invalid_argument(
      "no scene: name one of " + Join(GetSceneNames()) + " or a file of lines, .vtp or .vtk");
  }
  const std::vector<std::string> scenes = GetSceneNames();
  const bool named = std::find(scenes.begin(), scenes.end(), options.Scene) != scenes.end();
  if (!named && (options.Lines > 0 || options.Vertices > 0))
  {
    throw std::invalid_argument("--lines and --vertices do not apply to files");
  }
  if (!named && options.Scene.find('.') == std::string::npos)
  {
    throw std::invalid_argument(
      options.Scene + " is none of " + Join(scenes) + ", nor a file .vtp or .vtk");
  }
  if (named)
  {
    CheckSceneOptions(options.Scene, { options.Lines, options.Vertices, "" });
  }
  if (options.Methods.empty() && named && !IsSceneOfLines(options.Scene))
  {
    options.Methods = { "lines" };
  }
  if (options.Methods.empty())
  {
    options.Methods = options.Opacity < 1.0
      ? std::vector<std::string>{ "voxel", "oit" }
      : std::vector<std::string>{ "voxel", "tubes", "line-tubes" };
  }
  for (const std::string& name : options.Methods)
  {
    if (HasShadows(name) && options.Light == "headlight")
    {
      throw std::invalid_argument("--methods: " + name +
        " needs --light right or studio: a headlight casts no shadows that the camera sees");
    }
  }
  if (options.OcclusionReference)
  {
    CheckOcclusionReference(options);
  }
}
}

//------------------------------------------------------------------------------
BenchmarkOptions ParseBenchmarkOptions(int argc, char* argv[])
{
  BenchmarkOptions options;
  const auto setters = GetSetters();
  const auto flags = GetFlags();
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const auto flag = flags.find(argument);
    const auto setter = setters.find(argument);
    if (flag != flags.end())
    {
      options.*(flag->second) = true;
    }
    else if (setter != setters.end())
    {
      if (i + 1 == argc)
      {
        throw std::invalid_argument(argument + " needs a value");
      }
      setter->second(options, argv[++i]);
    }
    else if (!argument.empty() && argument[0] == '-')
    {
      throw std::invalid_argument("unknown option " + argument + "; --help tells all");
    }
    else if (!options.Scene.empty())
    {
      throw std::invalid_argument("two scenes: " + options.Scene + " and " + argument);
    }
    else
    {
      options.Scene = argument;
    }
  }
  if (!options.Help)
  {
    CheckTogether(options);
  }
  return options;
}
}
