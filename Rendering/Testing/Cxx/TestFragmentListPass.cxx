// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that vtkFragmentListPass blends layers as double precision does, that no order of cells
// changes a bit, and that opaque props hide what is behind them and nothing else.

#include "FragmentListTesting.h"

using namespace FragmentListTesting;

namespace
{
void CheckLayers(Checks& check)
{
  for (int layers : { 0, 1, 2, 3, 50 })
  {
    ListStage stage;
    const std::vector<Square> squares = MakeSquares(layers, 5, 120);
    stage.AddSquares(MakeMapper(squares, Shuffle(MakeOrder(squares.size()), 3)));
    const std::string name = std::to_string(layers) + " layers";
    CheckMiddle(check, name, stage, squares);
    CheckStatistics(check, name, stage.Pass, layers, layers > 0 ? 30 * 30 : 0);
    check(layers == 0 || stage.Pass->GetNumberOfBytes() >= 16 * layers * 30 * 30,
      name + ": number of bytes");
  }
  // One of opacity 1 hides all behind it.
  ListStage stage;
  std::vector<Square> squares = MakeSquares(50, 5, 60);
  squares[25].Color[3] = 255;
  stage.AddSquares(squares);
  CheckMiddle(check, "opacity 1 in the middle", stage, squares);
}

void CheckOrder(Checks& check)
{
  // Equal depths as well: every fifth square lies where its predecessor does.
  std::vector<Square> squares = MakeSquares(200, 5, 120);
  for (std::size_t i = 5; i < squares.size(); i += 5)
  {
    squares[i].Z = squares[i - 1].Z;
  }
  Picture first;
  for (int seed = 0; seed < 4; ++seed)
  {
    ListStage stage;
    const std::vector<int> order = MakeOrder(squares.size());
    stage.AddSquares(MakeMapper(squares, seed == 0 ? order : Shuffle(order, seed)));
    const Picture picture = stage.Render();
    if (seed == 0)
    {
      first = picture;
    }
    check(
      picture.Bytes == first.Bytes, "order " + std::to_string(seed) + " gives the same picture");
  }
}

// Opaque squares in front of and between the translucent ones.
void CheckOpaque(Checks& check)
{
  const std::vector<Square> squares = MakeSquares(40, 20, 120);
  for (double z : { 0.95, 0.0, -0.95 })
  {
    for (int samples : { 0, 4 })
    {
      ListStage stage;
      stage.Window->SetMultiSamples(samples);
      stage.AddSquares(squares);
      Square opaque;
      opaque.Z = z;
      opaque.Color = { 10, 200, 30, 255 };
      stage.AddSquares(std::vector<Square>{ opaque })->ForceOpaqueOn();
      std::vector<Square> visible;
      std::copy_if(squares.begin(), squares.end(), std::back_inserter(visible),
        [z](const Square& square) { return square.Z > z; });
      const std::string name =
        "opaque at " + std::to_string(z) + " with samples " + std::to_string(samples);
      CheckMiddle(check, name, stage, visible, { 10, 200, 30 });
      CheckStatistics(
        check, name, stage.Pass, static_cast<vtkIdType>(visible.size()), visible.empty() ? 0 : 900);
    }
  }
  // In the plane of the opaque square, whose depths are rounded up and down: seen, as the depth
  // test of OpenGL has it.
  ListStage stage;
  stage.Renderer->GetActiveCamera()->Azimuth(30.0);
  Square opaque;
  opaque.Color = { 10, 200, 30, 255 };
  Square translucent;
  auto actor = stage.AddSquares(std::vector<Square>{ opaque });
  actor->ForceOpaqueOn();
  stage.AddSquares(std::vector<Square>{ translucent });
  CheckMiddle(check, "in one plane", stage, { translucent }, { 10, 200, 30 });
  const vtkIdType fragments = stage.Pass->GetNumberOfFragments();
  actor->VisibilityOff();
  stage.Render();
  check(fragments == stage.Pass->GetNumberOfFragments() && fragments > 700,
    "in one plane: fragments " + std::to_string(fragments) + " of " +
      std::to_string(stage.Pass->GetNumberOfFragments()));
}
}

int TestFragmentListPass(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckLayers(check);
  CheckOrder(check);
  CheckOpaque(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
