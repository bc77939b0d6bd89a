// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that vtkFragmentListPass blends any number of layers as double precision does, that no
// order of cells changes a bit, that strips change nothing, and that what a limit of memory costs
// is counted and told.

#include "FragmentListTesting.h"

using namespace FragmentListTesting;

namespace
{
// A byte is rounded once; what comes before has an error far below that.
constexpr double Tolerance = 1.0;

std::string Describe(const Point& color)
{
  std::ostringstream text;
  text << " (" << color[0] << " " << color[1] << " " << color[2] << ")";
  return text.str();
}

void CheckMiddle(Checks& check, const std::string& name, ListStage& stage,
  const std::vector<Square>& squares, const std::array<int, 3>& background = Background)
{
  const Picture picture = stage.Render();
  const Point expected = Blend(squares, background);
  for (int x : { 20, 30, 40 })
  {
    const auto color = picture.At(x, 30);
    check(IsExact(color, expected, Tolerance),
      name + ": " + VoxelLineMapperTesting::Describe(color) + " instead of" + Describe(expected));
  }
  check(picture.At(4, 4) == Background, name + ": beside the squares");
}

void CheckStatistics(Checks& check, const std::string& name, vtkFragmentListPass* pass,
  vtkIdType layers, vtkIdType pixels)
{
  check(pass->GetNumberOfFragments() == layers * pixels,
    name + ": number of fragments " + std::to_string(pass->GetNumberOfFragments()));
  check(pass->GetLargestDepthComplexity() == (pixels > 0 ? layers : 0),
    name + ": largest depth complexity " + std::to_string(pass->GetLargestDepthComplexity()));
  check(pass->GetMeanDepthComplexity() == static_cast<double>(pixels > 0 ? layers : 0),
    name + ": mean depth complexity " + std::to_string(pass->GetMeanDepthComplexity()));
  check(pass->GetNumberOfDroppedFragments() == 0, name + ": nothing is dropped");
}

void CheckLayers(Checks& check)
{
  // Up to 16 are sorted in another way than more.
  for (int layers : { 0, 1, 2, 3, 16, 17, 50 })
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
  check(messages->TakeWarnings("MaximumNumberOfBytes of 496") == 1, "another number is told");
  stage.Pass->SetMaximumNumberOfBytes(vtkIdType(1) << 30);
  check(stage.Render().Bytes == whole.Bytes, "all is there again");
  check(stage.Pass->GetNumberOfDroppedFragments() == 0, "nothing is dropped again");
  stage.Pass->SetMaximumNumberOfBytes(15);
  check(messages->TakeErrors("must be from 16") == 1 &&
      stage.Pass->GetMaximumNumberOfBytes() == vtkIdType(1) << 30,
    "less than a fragment is refused");
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
  // In the plane of the opaque square: seen, as the depth test of OpenGL has it.
  for (double z : { 0.1, 0.3, 0.7 })
  {
    ListStage stage;
    Square opaque;
    opaque.Color = { 10, 200, 30, 255 };
    Square translucent;
    opaque.Z = translucent.Z = z;
    stage.AddSquares(std::vector<Square>{ opaque })->ForceOpaqueOn();
    stage.AddSquares(std::vector<Square>{ translucent });
    CheckMiddle(check, "in one plane", stage, { translucent }, { 10, 200, 30 });
  }
}
}

int TestFragmentListPass(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckLayers(check);
  CheckManyLayers(check);
  CheckOrder(check);
  CheckStrips(check, messages);
  CheckOpaque(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
