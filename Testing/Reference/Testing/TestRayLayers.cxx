// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards how intervals of capsules become layers: unions per curve, order, ties, rays that start
// inside, and the ends of the visible interval.

#include "RayLayers.h"
#include "ReferenceTesting.h"

using namespace linesets;

namespace
{
// Whether the layers on [0, 100] are at these positions, of these curves.
bool Gives(std::vector<CapsuleHit> hits, const std::vector<double>& positions,
  const std::vector<vtkIdType>& capsules)
{
  std::vector<RayLayer> layers;
  FindLayers(hits, 0.0, 100.0, layers);
  bool equal = layers.size() == positions.size();
  for (std::size_t i = 0; equal && i < layers.size(); ++i)
  {
    equal = layers[i].Position == positions[i] && layers[i].Capsule == capsules[i];
  }
  return equal;
}
}

int TestRayLayers(int, char*[])
{
  Checker checker;
  checker.Check(Gives({}, {}, {}), "nothing");
  checker.Check(Gives({ { 1, 2, 0, 7 } }, { 1 }, { 7 }), "one capsule");
  checker.Check(
    Gives({ { 1, 3, 0, 0 }, { 2, 4, 0, 1 }, { 4, 5, 0, 2 } }, { 1 }, { 0 }), "one stretch");
  checker.Check(Gives({ { 3, 4, 0, 0 }, { 1, 2, 0, 1 } }, { 1, 3 }, { 1, 0 }), "two stretches");
  checker.Check(Gives({ { 1, 9, 0, 0 }, { 2, 3, 0, 1 }, { 5, 6, 0, 2 } }, { 1 }, { 0 }),
    "a long capsule holds short ones");
  checker.Check(
    Gives({ { 1, 3, 0, 0 }, { 2, 4, 1, 1 } }, { 1, 2 }, { 0, 1 }), "curves do not unite");
  checker.Check(Gives({ { 2, 4, 5, 3 }, { 2, 3, 1, 9 } }, { 2, 2 }, { 9, 3 }), "ties by curve");
  checker.Check(Gives({ { 2, 4, 0, 9 }, { 2, 3, 0, 3 } }, { 2 }, { 3 }), "ties by capsule");
  checker.Check(
    Gives({ { -5, -1, 0, 0 }, { -2, 3, 0, 1 }, { 1, 6, 0, 2 } }, { 3 }, { 1 }), "from inside");
  checker.Check(Gives({ { -2, 8, 0, 0 }, { 3, 4, 1, 1 } }, { 3, 8 }, { 1, 0 }),
    "from inside, sorted by the far side");
  checker.Check(Gives({ { 100, 101, 0, 0 }, { -3, 0, 0, 1 } }, {}, {}), "outside the interval");
  checker.Check(Gives({ { -1, 101, 0, 0 } }, {}, {}), "both ends outside the interval");
  checker.Check(Gives({ { 99, 101, 0, 0 } }, { 99 }, { 0 }), "only the entry is seen");

  std::vector<CapsuleHit> hits = { { -1, 2, 0, 0 }, { 1, 2, 1, 1 } };
  std::vector<RayLayer> layers;
  FindLayers(hits, 0.0, 10.0, layers);
  checker.Check(layers.size() == 2 && !layers[0].FromInside && layers[1].FromInside,
    "layers know whether they are seen from inside");
  return checker.GetExitCode();
}
