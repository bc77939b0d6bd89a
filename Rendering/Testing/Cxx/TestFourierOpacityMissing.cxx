// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards what vtkFourierOpacityMapper and vtkFourierOpacityPass do where OpenGL is below 4.2: they
// say so once, and the rest of the scene is drawn. Mesa can be told to be older than it is; with
// other drivers the test is skipped.

#include "FourierOpacityPassTesting.h"
#include "vtkOpenGLRenderWindow.h"

#include "vtksys/SystemTools.hxx"

using namespace FourierOpacityTesting;

namespace
{
// Something opaque and something of another mapper, translucent, beside each other.
void AddRest(Stage& stage)
{
  stage.AddSphere(-0.5, 0.5, 0.0, 0.3)->GetProperty()->LightingOff();
  stage.Add(MakeMapper({ { 0.5, 0.5, 0.0, 0.3, { 250, 120, 30, 130 } } }))
    ->GetProperty()
    ->LightingOff();
}

void CheckRest(Checks& check, const std::string& name, const Picture& picture)
{
  CheckColor(check, name + ", opaque", picture.At(15, 45), { 255, 255, 255 }, 1.0);
  CheckColor(check, name + ", translucent", picture.At(45, 45),
    Blend({ { 0.5, 0.5, 0.0, 0.3, { 250, 120, 30, 130 } } }, Background), 1.6);
  check(picture.At(30, 12) == Background, name + ": the actor itself is not drawn");
}
}

int TestFourierOpacityMissing(int, char*[])
{
  vtksys::SystemTools::PutEnv("MESA_GL_VERSION_OVERRIDE=3.2");
  vtksys::SystemTools::PutEnv("MESA_EXTENSION_OVERRIDE=-GL_ARB_shader_image_load_store");
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  const Square square{ 0.0, -0.6, 0.0, 0.3, { 200, 200, 20, 255 } };

  OpacityStage alone(SceneSize, SceneSize);
  alone.Mapper->SetInputData(MakeStack({ square }));
  AddRest(alone);
  alone.Window->Render();
  int major = 0;
  int minor = 0;
  vtkOpenGLRenderWindow::SafeDownCast(alone.Window)->GetOpenGLVersion(major, minor);
  if (10 * major + minor >= 42)
  {
    std::cout << "OpenGL is " << major << "." << minor << " whatever Mesa's variables say."
              << std::endl;
    return 125; // VTK's code for a test that is skipped
  }
  CheckRest(check, "mapper", alone.Stage::Render());
  check(messages->TakeErrors("opacity optimization needs OpenGL 4.2") == 1,
    "the mapper tells once what is missing");
  check(alone.Mapper->GetNumberOfBytes() == 0, "the mapper makes nothing");

  PassStage stage;
  stage.AddItem(MakeStack({ square }));
  stage.AddItem(MakeStack({ square }));
  AddRest(stage);
  for (int i = 0; i < 2; ++i)
  {
    CheckRest(check, "pass", stage.Render());
  }
  check(messages->TakeErrors("opacity optimization needs OpenGL 4.2") == 1,
    "the pass tells once what is missing");
  check(
    messages->TakeWarnings("1 translucent props are no actors with a vtkFourierOpacityMapper") == 1,
    "the pass tells of other props");
  check(stage.Pass->GetNumberOfRenderedProps() == 1, "the pass counts the other one");
  check(messages->IsQuiet(), "no other errors and no warnings");
  return check.GetResult();
}
