// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkReport.h"

#include "JsonObject.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkVersion.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace linesets
{
namespace
{
void AddFinite(JsonObject& object, const std::string& key, double value)
{
  if (std::isfinite(value))
  {
    object.Add(key, value);
  }
}

// Median time of a method; NaN where it was not run or failed. `engine` is empty for methods
// without a choice of engines.
double GetPeerMedian(const std::vector<BenchmarkEntry>& entries, const std::string& name,
  const std::string& engine = "")
{
  for (const BenchmarkEntry& entry : entries)
  {
    const BenchmarkMethod& method = *entry.Method;
    if (method.Name == name && method.Engine == engine && method.Error.empty())
    {
      return GetMedian(method.FrameMilliseconds);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// Of the cells that there are. Geometry without cells does not come here.
void AddCounts(JsonObject& object, vtkPolyData* geometry)
{
  const std::pair<const char*, vtkIdType> counts[] = { { "lines", geometry->GetNumberOfLines() },
    { "points", geometry->GetNumberOfVerts() }, { "polygons", geometry->GetNumberOfPolys() } };
  for (const auto& count : counts)
  {
    if (count.second > 0)
    {
      object.Add(count.first, static_cast<long long>(count.second));
    }
  }
  object.Add("vertices", static_cast<long long>(geometry->GetNumberOfPoints()));
}

void AddTimes(JsonObject& object, const BenchmarkMethod& method)
{
  const auto range =
    std::minmax_element(method.FrameMilliseconds.begin(), method.FrameMilliseconds.end());
  object.Add("frames", static_cast<long long>(method.FrameMilliseconds.size()));
  object.Add("median_ms", GetMedian(method.FrameMilliseconds));
  object.Add("min_ms", *range.first);
  object.Add("max_ms", *range.second);
  object.Add("cpu_ms", GetMedian(method.ProcessorMilliseconds));
  AddFinite(object, "rebuild_ms", GetMedian(method.RebuildMilliseconds));
  AddFinite(object, "draw_ms", GetMedian(method.DrawMilliseconds));
  object.Add("build_ms", method.BuildMilliseconds);
  object.Add("first_frame_ms", method.FirstFrameMilliseconds);
}

void AddOcclusion(JsonObject& object, const OcclusionMeasures& measures)
{
  AddFinite(object, "densities_ms", measures.DensityMilliseconds);
  AddFinite(object, "occlusion_ms", measures.OcclusionMilliseconds);
  AddFinite(object, "rmse_occlusion", measures.VoxelRmse);
  AddFinite(object, "bias_occlusion", measures.VoxelBias);
  AddFinite(object, "rmse_occlusion_lines", measures.LineRmse);
  AddFinite(object, "bias_occlusion_lines", measures.LineBias);
  AddFinite(object, "rmse_occlusion_seen", measures.SeenRmse);
  AddFinite(object, "bias_occlusion_seen", measures.SeenBias);
}

void AddRatios(
  JsonObject& object, const BenchmarkMethod& method, const std::vector<BenchmarkEntry>& entries)
{
  const double median = GetMedian(method.FrameMilliseconds);
  for (const std::string peer : { "tubes", "peeling", "lines" })
  {
    AddFinite(object, "ratio_" + peer, GetPeerMedian(entries, peer) / median);
  }
  AddFinite(object, "ratio_fragment_list", GetPeerMedian(entries, "fragment-list") / median);
  // The other way round: what shadows and occlusion cost.
  AddFinite(object, "ratio_voxel", median / GetPeerMedian(entries, "voxel", method.Engine));
}
}

//------------------------------------------------------------------------------
std::string DescribeEntry(const BenchmarkEntry& entry, const std::vector<BenchmarkEntry>& entries,
  const BenchmarkInput& input, const std::string& renderer)
{
  BenchmarkMethod& method = *entry.Method;
  JsonObject object;
  object.Add("scene", vtksys::SystemTools::GetFilenameName(input.Options.Scene));
  AddCounts(object, input.Geometry);
  object.Add("method", method.Name);
  object.Add("width", input.Options.Width);
  object.Add("height", input.Options.Height);
  object.Add("opacity", input.Options.Opacity);
  object.Add("radius", input.Radius);
  object.Add("light", input.Options.Light);
  if (input.Options.Animate)
  {
    object.Add("animated", 1);
  }
  if (method.Error.empty())
  {
    AddTimes(object, method);
    method.Describe(object);
    AddFinite(object, "depth_complexity", method.DepthComplexity);
    AddFinite(object, "rmse", entry.Rmse);
    AddFinite(object, "ssim", entry.Ssim);
    AddFinite(object, "rmse_full", entry.FullRmse);
    AddFinite(object, "ssim_full", entry.FullSsim);
    AddFinite(object, "rmse_decoded", entry.DecodedRmse);
    AddOcclusion(object, entry.Occlusion);
    AddRatios(object, method, entries);
  }
  if (!renderer.empty())
  {
    object.Add("renderer", renderer);
  }
  object.Add("vtk", std::string(vtkVersion::GetVTKVersion()));
  object.Add("threads", vtkSMPTools::GetEstimatedNumberOfThreads());
  if (!method.Error.empty())
  {
    object.Add("error", method.Error);
  }
  return object.GetText();
}
}
