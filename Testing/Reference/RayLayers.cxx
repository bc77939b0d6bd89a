// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayLayers.h"

#include <algorithm>
#include <tuple>

namespace linesets
{
void FindLayers(
  std::vector<CapsuleHit>& hits, double first, double last, std::vector<RayLayer>& layers)
{
  layers.clear();
  std::sort(hits.begin(), hits.end(),
    [](const CapsuleHit& a, const CapsuleHit& b)
    { return std::tie(a.Curve, a.Entry, a.Capsule) < std::tie(b.Curve, b.Entry, b.Capsule); });
  bool inside = false;
  vtkIdType curve = 0;
  double exit = 0.0;
  for (const CapsuleHit& hit : hits)
  {
    if (hit.Exit <= first || hit.Entry >= last)
    {
      continue;
    }
    if (inside && hit.Curve == curve && hit.Entry <= exit)
    {
      exit = std::max(exit, hit.Exit);
      continue;
    }
    inside = true;
    curve = hit.Curve;
    exit = hit.Exit;
    const bool fromInside = hit.Entry < first;
    const double position = fromInside ? hit.Exit : hit.Entry;
    if (position < last)
    {
      layers.push_back({ position, hit.Curve, hit.Capsule, fromInside });
    }
  }
  std::sort(layers.begin(), layers.end(),
    [](const RayLayer& a, const RayLayer& b) {
      return std::tie(a.Position, a.Curve, a.Capsule) < std::tie(b.Position, b.Curve, b.Capsule);
    });
}
}
