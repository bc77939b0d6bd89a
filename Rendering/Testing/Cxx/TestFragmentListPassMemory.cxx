// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards vtkFragmentListPass with much to store: thousands of layers are sorted and blended whole,
// strips change nothing in the picture, and what a limit of memory costs is counted and told.

#include "FragmentListTesting.h"

using namespace FragmentListTesting;

namespace
{
void CheckManyLayers(Checks& check)
{
  // Opacity 3/255, about 0.01.
  ListStage stage(20, 20);
  std::vector<Square> squares = MakeSquares(5000, 3, 3);
  stage.AddSquares(MakeMapper(squares, Shuffle(MakeOrder(squares.size()), 3)));
  const auto color = stage.Render().At(10, 10);
  const Point expected = Blend(squares, Background);
  check(IsExact(color, expected, Tolerance),
    "5000 layers: " + VoxelLineMapperTesting::Describe(color) + " instead of" + Describe(expected));
  CheckStatistics(check, "5000 layers", stage.Pass, 5000, 100);
}

void CheckStrips(Checks& check, Messages* messages)
{
  const std::vector<Square> squares = MakeSquares(20, 5, 120);
  ListStage stage;
  stage.AddSquares(squares);
  const Picture whole = stage.Render();
  check(stage.Pass->GetNumberOfStrips() == 1, "one strip is enough");
  // A row of the squares has 600 fragments: three rows fit, then one.
  for (int rows : { 3, 1 })
  {
    stage.Pass->SetMaximumNumberOfBytes(16 * 600 * rows + 16 * 10);
    const Picture strips = stage.Render();
    const std::string name = "strips of " + std::to_string(rows) + " rows";
    check(strips.Bytes == whole.Bytes, name + " give the same picture");
    check(stage.Pass->GetNumberOfStrips() == 30 / rows, name + ": their number");
    CheckStatistics(check, name, stage.Pass, 20, 900);
  }
  check(messages->IsQuiet(), "strips need no words");

  // Half a row fits: ten of the twenty fragments of each pixel.
  stage.Pass->SetMaximumNumberOfBytes(16 * 300);
  stage.Render();
  stage.Render();
  check(stage.Pass->GetNumberOfFragments() == 20 * 900, "half a row: fragments");
  check(stage.Pass->GetNumberOfDroppedFragments() == 10 * 900,
    "half a row: dropped " + std::to_string(stage.Pass->GetNumberOfDroppedFragments()));
  check(messages->TakeWarnings("9000 of 18000 translucent fragments are missing") == 1,
    "what is dropped is told once");
  // One fragment more than one for each pixel.
  stage.Pass->SetMaximumNumberOfBytes(16 * 31);
  stage.Render();
  check(stage.Pass->GetNumberOfDroppedFragments() == 900 * 20 - 30 * 31, "a row of 31 nodes");
  check(messages->TakeWarnings("per fragment, which is 496") == 1, "another number is told");
  stage.Pass->SetMaximumNumberOfBytes(vtkIdType(1) << 30);
  check(stage.Render().Bytes == whole.Bytes, "all is there again");
  check(stage.Pass->GetNumberOfDroppedFragments() == 0, "nothing is dropped again");
  stage.Pass->SetMaximumNumberOfBytes(15);
  check(messages->TakeErrors("must be from 16") == 1 &&
      stage.Pass->GetMaximumNumberOfBytes() == vtkIdType(1) << 30,
    "less than a fragment is refused");
}
}

int TestFragmentListPassMemory(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckManyLayers(check);
  CheckStrips(check, messages);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
