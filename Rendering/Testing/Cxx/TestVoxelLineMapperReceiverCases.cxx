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
    if (key == lit)
    {
      // Shadows would be received without this key.
      reception.Caster->GetGlobalIllumination()->SetShadowsToNone();
      reception.Caster->GetGlobalIllumination()->SetOcclusionToHemisphereDensity();
      reception.Caster->GetGlobalIllumination()->SetOcclusionSamples(8);
    }
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
    bool isGreen = true;
    for (std::size_t i = 1; i < plain.Bytes.size(); i += 3)
    {
      isGreen = isGreen && (plain.Bytes[i] == 255 || plain.Bytes[i] == Background[1]);
    }
    check(key != lit || isGreen, code + ": drawn");
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

// An actor that is no receiver, but has the mapper and the shaders of one, in another renderer of
// the same window.
void CheckOthers(Checks& check)
{
  const auto tubes = MakeTubes(MakeTangle());
  Reception reception(tubes);
  reception.Stage.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> renderer;
  LitStage::SetScene(renderer, false);
  renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkActor> other;
  other->SetMapper(tubes);
  other->SetShaderProperty(reception.Actor->GetShaderProperty());
  SetUp(other->GetProperty());
  renderer->AddActor(other);
  reception.Stage.Window->AddRenderer(renderer);
  reception.Render();
  const Picture received = reception.Render();
  reception.Caster->RemoveAllReceivers();
  const Picture plain = reception.Render();
  int changes[2] = { 0, 0 };
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      changes[x / 32] += received.At(x, y) == plain.At(x, y) ? 0 : 1;
    }
  }
  check(changes[0] > 50, "a receiver beside another actor");
  check(changes[1] == 0, "an actor with the same shaders receives nothing");
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

// A surface with null normals is dimmed as one that faces the viewer.
void CheckNullNormals(Checks& check)
{
  vtkNew<vtkPlaneSource> source;
  source->Update();
  vtkPolyData* data = source->GetOutput();
  const auto render = [data](double z, bool isReceiver)
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (int i = 0; i < 4; ++i)
    {
      normals->InsertNextTuple3(0.0, 0.0, z);
    }
    data->GetPointData()->SetNormals(normals);
    vtkNew<vtkPolyDataMapper> plane;
    plane->SetInputData(data);
    Reception reception(plane);
    Global* global = reception.Caster->GetGlobalIllumination();
    global->SetShadowsToNone();
    global->SetOcclusionToHemisphereDensity();
    global->SetOcclusionSamples(4);
    vtkProperty* property = reception.Actor->GetProperty();
    property->SetAmbient(1.0);
    property->SetDiffuse(0.0);
    property->SetSpecular(0.0);
    vtkCamera* camera = reception.Stage.Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 4.0);
    camera->ParallelProjectionOn();
    if (!isReceiver)
    {
      reception.Caster->RemoveAllReceivers();
    }
    return reception.Render();
  };
  const Picture received = render(0.0, true);
  CheckDarker(check, render(0.0, false), received, "null normals");
  const Difference difference = Compare(received, render(1.0, true));
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
  CheckOthers(check);
  CheckEnd(check);
  CheckNullNormals(check);
  CheckStop(check);
  CheckOrder(check);
  check(messages->IsQuiet(), "nothing else is said");
  return check.GetResult();
}
