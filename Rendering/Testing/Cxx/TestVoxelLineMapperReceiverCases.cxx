// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards what receivers of light meet: users' shader replacements with the same keys are kept, or
// told where they leave no place; shaders that are shared; actors that go; null normals; work that
// was stopped; and lines that are drawn after the receiver.

#include "VoxelLineReceiverTesting.h"
#include "vtkCallbackCommand.h"
#include "vtkFloatArray.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkShaderProperty.h"

using namespace VoxelLineReceiverTesting;

namespace
{
// Replacements of users with the same keys as ours.
void CheckReplacements(Checks& check, Messages* messages)
{
  const std::string lit = "(ambientColor + diffuse + specular, opacity);";
  const std::vector<std::pair<std::string, std::string>> replacements = {
    { lit, lit + "\n  gl_FragData[0].g = 1.0;\n" },
    { lit, "(diffuse + specular, 1.0);\n  gl_FragData[0].g = 1.0;\n" },
    { "void main(", "float green() { return 1.0; }\nvoid main(" },
    { "void main(", "void  main(" },
  };
  const auto tubes = MakeTubes(MakeTangle());
  for (const auto& [key, code] : replacements)
  {
    const bool hasPlace = code != "void  main(";
    Reception reception(tubes);
    vtkShaderProperty* property = reception.Actor->GetShaderProperty();
    const auto isKept = [property, &key, &code]
    {
      std::string name;
      std::string present;
      bool first = true;
      bool all = false;
      property->GetNthShaderReplacement(0, name, first, present, all);
      return property->GetNumberOfShaderReplacements() == 1 && name == key && present == code &&
        !first && all;
    };
    // Before the code is put in, and while it is there.
    property->AddFragmentShaderReplacement(key, false, code, true);
    const Picture received = reception.Render();
    check(property->GetNumberOfShaderReplacements() == (hasPlace ? 6 : 1), code + ": put in");
    property->AddFragmentShaderReplacement(key, false, code, true);
    check(reception.Render().Bytes == received.Bytes, code + ": put in again");
    check(messages->TakeWarnings("\"void main(\"") == (hasPlace ? 0 : 1), code + ": told");
    reception.Caster->RemoveReceiver(reception.Actor);
    check(isKept(), code + ": kept");
    const Picture plain = reception.Render();
    if (hasPlace)
    {
      CheckDarker(check, plain, received, code);
    }
    else
    {
      check(plain.Bytes == received.Bytes, code + ": without light");
    }
    int greenest = 0;
    for (std::size_t i = 1; i < plain.Bytes.size(); i += 3)
    {
      greenest = std::max<int>(greenest, plain.Bytes[i]);
    }
    check(key != lit || greenest == 255, code + ": drawn");
    check(messages->IsQuiet(), code + ": nothing else is said");
  }

  // Two receivers from different lines share their shaders.
  Reception one(tubes);
  const Picture alone = one.Render();
  Reception other(tubes);
  other.Actor->SetShaderProperty(one.Actor->GetShaderProperty());
  for (int frame = 0; frame < 2; ++frame)
  {
    check(other.Render().Bytes == alone.Bytes, "shared shaders");
    check(one.Render().Bytes == alone.Bytes, "shared shaders of the other one");
  }
  one.Caster->RemoveAllReceivers();
  other.Caster->RemoveAllReceivers();
  check(one.Actor->GetShaderProperty()->GetNumberOfShaderReplacements() == 0, "both are out");
}

// An actor that is no receiver, but has the mapper and the shaders of one.
void CheckOthers(Checks& check, Messages* messages)
{
  const auto tubes = MakeTubes(MakeTangle());
  Reception never(tubes);
  never.Caster->RemoveAllReceivers();
  const Picture plain = never.Render();
  Reception reception(tubes);
  const Picture received = reception.Render();
  LitStage stage(64, 64);
  auto other = stage.Add(tubes);
  SetUp(other->GetProperty());
  other->SetShaderProperty(reception.Actor->GetShaderProperty());
  check(stage.Render().Bytes == plain.Bytes, "an actor with the same shaders receives nothing");
  check(reception.Render().Bytes == received.Bytes, "and the receiver still does");
  check(messages->IsQuiet(), "nothing is said of others");
}

// What receivers hold goes with the last actor.
void CheckEnd(Checks& check)
{
  Reception reception(MakeTubes(MakeTangle()));
  reception.Render();
  const auto before = reception.Caster->GetGraphicsMemory();
  reception.Stage.Renderer->RemoveActor(reception.Actor);
  reception.Actor = nullptr;
  check(before > 0 && reception.Caster->GetGraphicsMemory() == 0, "memory goes with the actor");
}

// Far from all lines a surface with null normals looks as without them.
void CheckNullNormals(Checks& check)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-1.0, 6.0, -1.0);
  source->SetPoint1(-1.0, 6.0, 1.0);
  source->SetPoint2(1.0, 6.0, -1.0);
  source->Update();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(4);
  normals->Fill(0.0);
  source->GetOutput()->GetPointData()->SetNormals(normals);
  vtkNew<vtkPolyDataMapper> plane;
  plane->SetInputData(source->GetOutput());
  Reception reception(plane,
    [](vtkVoxelLineMapper* caster, vtkActor* actor, LitStage& stage)
    {
      caster->GetGlobalIllumination()->SetOcclusionToHemisphereDensity();
      caster->GetGlobalIllumination()->SetOcclusionSamples(4);
      actor->GetProperty()->SetAmbient(0.6);
      vtkCamera* camera = stage.Renderer->GetActiveCamera();
      camera->SetPosition(2.4, 9.0, 2.8);
      camera->SetFocalPoint(0.0, 6.0, 0.0);
      camera->SetClippingRange(1.0, 20.0);
    });
  const Picture received = reception.Render();
  reception.Caster->RemoveAllReceivers();
  const Difference difference = Compare(received, reception.Render());
  check(difference.Largest <= 1, "null normals" + Describe(difference));
}

// What is stopped in a frame is computed in the next one.
void CheckStop(Checks& check)
{
  const auto tubes = MakeTubes(MakeTangle());
  Reception whole(tubes);
  Reception stopped(tubes);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caster, unsigned long, void*, void*)
    { static_cast<vtkVoxelLineMapper*>(caster)->SetAbortExecute(1); });
  const unsigned long tag = stopped.Caster->AddObserver(vtkCommand::ProgressEvent, stop);
  const Picture before = stopped.Render();
  stopped.Caster->RemoveObserver(tag);
  const Picture wanted = whole.Render();
  check(before.Bytes != wanted.Bytes, "stopped");
  check(stopped.Render().Bytes == wanted.Bytes, "begun anew");
}

// The first frame draws the receiver before the lines.
void CheckOrder(Checks& check)
{
  Reception reception(MakeTubes(MakeTangle()),
    [](vtkVoxelLineMapper* caster, vtkActor*, LitStage& stage)
    {
      auto own = stage.Add(caster, 0.0);
      own->GetProperty()->SetOpacity(0.4);
      own->SetPosition(0.1, 0.2, 0.0);
      // Its picture is not compared.
      stage.Renderer->RemoveActor(own);
      vtkNew<vtkRenderer> other;
      LitStage::SetScene(other, false);
      other->AddActor(own);
      other->SetViewport(0.0, 0.0, 0.01, 0.01);
      stage.Window->AddRenderer(other);
    });
  const Picture first = reception.Render();
  check(reception.Render().Bytes == first.Bytes, "lines that are drawn later");
}
}

int TestVoxelLineMapperReceiverCases(int, char*[])
{
  const auto messages = Listen();
  Checks check;
  KeptDisplay display;
  CheckReplacements(check, messages);
  CheckOthers(check, messages);
  CheckEnd(check);
  CheckNullNormals(check);
  CheckStop(check);
  CheckOrder(check);
  check(messages->IsQuiet(), "nothing else is said");
  return check.GetResult();
}
