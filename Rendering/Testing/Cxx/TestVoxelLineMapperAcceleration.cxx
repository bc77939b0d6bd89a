// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards opacity acceleration of vtkVoxelLineMapper:
// - default, errors, copy and text of the property,
// - it is off at 1, and changes nothing of opaque lines,
// - for a block of lines at random the background shows through as it does without, on the mean
//   over the picture, for rays that end early and rays that go on for long,
// - the error grows as it begins earlier, and is bounded,
// - both engines give the same picture,
// - a change of opacity makes other densities.
#include "VoxelLineReferenceTesting.h"

using namespace VoxelLineMapperTesting;

namespace
{
double GetMean(const Picture& picture)
{
  double sum = 0.0;
  for (const unsigned char byte : picture.Bytes)
  {
    sum += byte;
  }
  return sum / static_cast<double>(picture.Bytes.size());
}

/// Black lines before white: bytes tell what shows through.
struct Block
{
  Stage Scene{ 100, 80 };
  vtkNew<vtkVoxelLineMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;

  Block(int lines, double opacity)
  {
    this->Mapper->SetInputData(MakeLines(MakeStraightLines(lines, 3)));
    this->Mapper->SetResolution(32);
    this->Mapper->SetRadius(0.03);
    this->Mapper->SetEngineToNative();
    this->Actor = this->Scene.Add(this->Mapper, opacity);
    this->Actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
    this->Scene.Renderer->SetBackground(1.0, 1.0, 1.0);
    LookAlongZ(this->Scene);
  }

  Picture Draw(double acceleration)
  {
    this->Mapper->SetOpacityAcceleration(acceleration);
    return this->Scene.Render();
  }
};

void TestProperty(Checks& check)
{
  const auto messages = Listen();
  vtkNew<vtkVoxelLineMapper> mapper;
  check(mapper->GetOpacityAcceleration() == 1.0, "off by default");
  for (double wrong : { -0.1, 1.1, std::nan("") })
  {
    mapper->SetOpacityAcceleration(wrong);
    check(messages->TakeErrors("must be from 0 to 1") == 1, "a value out of range is an error");
  }
  check(mapper->GetOpacityAcceleration() == 1.0, "the last valid value is kept");
  const vtkMTimeType before = mapper->GetMTime();
  mapper->SetOpacityAcceleration(0.75);
  check(mapper->GetMTime() > before, "a change is told");
  vtkNew<vtkVoxelLineMapper> copy;
  copy->ShallowCopy(mapper);
  check(copy->GetOpacityAcceleration() == 0.75, "copied");
  std::ostringstream text;
  mapper->Print(text);
  check(text.str().find("OpacityAcceleration: 0.75") != std::string::npos, "printed");
  check(messages->IsQuiet(), "nothing else is said");
}

void TestPictures(Checks& check)
{
  for (double opacity : { 0.1, 0.3 })
  {
    Block block(1500, opacity);
    const Picture exact = block.Draw(1.0);
    const std::string name = "opacity " + std::to_string(opacity) + ": ";
    check(GetMean(exact) > 10.0 && GetMean(exact) < 220.0, name + "the block is transparent");
    double lastRms = 0.0;
    for (double acceleration : { 0.9, 0.6, 0.3 })
    {
      const Picture fast = block.Draw(acceleration);
      const Difference difference = Compare(exact, fast);
      const double bias = GetMean(fast) - GetMean(exact);
      std::cout << name << "from " << acceleration << " on: mean " << GetMean(exact) << ", bias "
                << bias << Describe(difference) << std::endl;
      check(difference.Largest > 0, name + "rays go by densities");
      // At most what is left where they begin; on the mean a fifth of it.
      check(difference.Largest <= 255.0 * (1.0 - acceleration), name + "bounded by what is left");
      check(std::abs(bias) <= 0.2 * 255.0 * (1.0 - acceleration), name + "right on the mean");
      check(difference.Rms >= lastRms, name + "less exact, the earlier");
      lastRms = difference.Rms;
    }
  }
}

void TestWithoutEffect(Checks& check)
{
  Block block(200, 1.0);
  check(Compare(block.Draw(1.0), block.Draw(0.3)).Largest == 0, "opaque lines are as they were");
}

void TestChange(Checks& check)
{
  Block block(1500, 0.1);
  block.Draw(0.5);
  block.Actor->GetProperty()->SetOpacity(0.3);
  const Picture changed = block.Draw(0.5);
  Block fresh(1500, 0.3);
  check(Compare(changed, fresh.Draw(0.5)).Largest == 0, "densities follow the opacity");
}

void TestEngines(Checks& check)
{
  Block block(60, 0.3);
  const Picture native = block.Draw(0.4);
  block.Mapper->SetEngineToShader();
  const Difference difference = Compare(native, block.Draw(0.4));
  std::cout << "engines" << Describe(difference) << std::endl;
  check(
    difference.Part < 0.002 && difference.Rms < 0.7, "both engines alike" + Describe(difference));
  check(block.Mapper->GetEngineInUse() == vtkVoxelLineMapper::Shader, "the shader engine was used");
}
}

int TestVoxelLineMapperAcceleration(int, char*[])
{
  KeptDisplay display;
  Checks check;
  TestProperty(check);
  TestPictures(check);
  TestWithoutEffect(check);
  TestChange(check);
  TestEngines(check);
  return check.GetResult();
}
