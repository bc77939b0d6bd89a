// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the qualities of vtkVoxelLineMapper:
// - automatic quality follows the window's desired update rate, and a change of it makes another
//   picture,
// - an interactive picture lacks parts of tubes but adds nothing: where it shows something, the
//   whole one does; tubes that stay within their voxels are whole in it,
// - the setter's errors, default, copy and text.
#include "VoxelLineMapperTesting.h"

using namespace VoxelLineMapperTesting;

namespace
{
void TestAutomatic(Checks& check)
{
  Stage stage(80, 60);
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(MakeHelices(3, 100));
  mapper->SetResolution(32);
  mapper->SetEngineToNative();
  stage.Add(mapper, 1.0);
  check(mapper->GetQuality() == vtkVoxelLineMapper::AutomaticQuality, "automatic by default");
  check(mapper->GetQualityInUse() == vtkVoxelLineMapper::AutomaticQuality, "none before a frame");
  const auto expect = [&](double rate, int quality)
  {
    stage.Window->SetDesiredUpdateRate(rate);
    stage.Render();
    check(mapper->GetQualityInUse() == quality, "quality at the rate " + std::to_string(rate));
  };
  stage.Render();
  check(mapper->GetQualityInUse() == vtkVoxelLineMapper::StillQuality, "still by default");
  expect(15.0, vtkVoxelLineMapper::InteractiveQuality);
  expect(1.0, vtkVoxelLineMapper::InteractiveQuality);
  expect(0.9, vtkVoxelLineMapper::StillQuality);
  expect(0.0001, vtkVoxelLineMapper::StillQuality);
  mapper->SetQualityToInteractive();
  expect(0.0001, vtkVoxelLineMapper::InteractiveQuality);
  mapper->SetQualityToStill();
  expect(15.0, vtkVoxelLineMapper::StillQuality);
}

Picture Draw(vtkVoxelLineMapper* mapper, int quality, double opacity)
{
  Stage stage(160, 120);
  stage.Add(mapper, opacity);
  mapper->SetQuality(quality);
  return stage.Render();
}

void TestPictures(Checks& check)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(MakeHelices(4, 200));
  mapper->SetResolution(32);
  mapper->SetEngineToNative();
  mapper->SubPixelCoverageOff();
  for (double opacity : { 1.0, 0.3 })
  {
    const std::string name = opacity < 1.0 ? "transparent: " : "opaque: ";
    mapper->SetRadius(0.04);
    const Picture still = Draw(mapper, vtkVoxelLineMapper::StillQuality, opacity);
    const Picture fast = Draw(mapper, vtkVoxelLineMapper::InteractiveQuality, opacity);
    int lacking = 0;
    int added = 0;
    int kept = 0;
    for (int y = 0; y < still.Height; ++y)
    {
      for (int x = 0; x < still.Width; ++x)
      {
        const bool isWhole = still.At(x, y) != still.At(0, 0);
        const bool isSeen = fast.At(x, y) != still.At(0, 0);
        lacking += isWhole && !isSeen ? 1 : 0;
        added += isSeen && !isWhole ? 1 : 0;
        kept += isSeen && isWhole ? 1 : 0;
      }
    }
    std::cout << name << kept << " pixels kept, " << lacking << " lacking\n";
    check(added == 0, name + "an interactive picture adds nothing");
    check(kept > 1000 && lacking > 0 && lacking < kept / 2, name + "some parts are missing");
    // Half a voxel is 0.03.
    mapper->SetRadius(0.002);
    const Difference difference = Compare(Draw(mapper, vtkVoxelLineMapper::StillQuality, opacity),
      Draw(mapper, vtkVoxelLineMapper::InteractiveQuality, opacity));
    check(difference.Part < 0.01, name + "thin tubes are whole" + Describe(difference));
  }
}

void TestSetter(Checks& check, Messages* messages)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetQualityToInteractive();
  const vtkMTimeType before = mapper->GetMTime();
  mapper->SetQuality(3);
  mapper->SetQuality(-1);
  check(messages->TakeErrors("must be automatic (0), interactive (1) or still (2)") == 2,
    "errors name the range");
  check(
    mapper->GetQuality() == vtkVoxelLineMapper::InteractiveQuality && mapper->GetMTime() == before,
    "the valid value stays");
  mapper->SetQualityToStill();
  check(mapper->GetMTime() > before, "the setter modifies the mapper");
  vtkNew<vtkVoxelLineMapper> copy;
  copy->ShallowCopy(mapper);
  check(copy->GetQuality() == vtkVoxelLineMapper::StillQuality, "a copy has it");
  std::ostringstream text;
  mapper->Print(text);
  check(text.str().find("Quality: 2") != std::string::npos, "it is printed");
}
}

int TestVoxelLineMapperQuality(int, char*[])
{
  Checks check;
  auto messages = Listen();
  TestAutomatic(check);
  TestPictures(check);
  TestSetter(check, messages);
  check(messages->IsQuiet(), "nothing else is said");
  return check.GetResult();
}
