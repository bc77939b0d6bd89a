// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards what vtkFragmentListPass does where OpenGL lacks what it needs: it says so once, and the
// delegate draws. Mesa can be told to be older than it is; with other drivers the test is skipped.

#include "FragmentListTesting.h"
#include "vtkOpenGLRenderWindow.h"

#include "vtksys/SystemTools.hxx"

using namespace FragmentListTesting;

int TestFragmentListPassMissing(int, char*[])
{
  vtksys::SystemTools::PutEnv("MESA_GL_VERSION_OVERRIDE=3.2");
  vtksys::SystemTools::PutEnv(
    "MESA_EXTENSION_OVERRIDE=-GL_ARB_shader_image_load_store -GL_ARB_shader_bit_encoding");
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  ListStage stage;
  stage.Window->Render();
  int major = 0;
  int minor = 0;
  vtkOpenGLRenderWindow::SafeDownCast(stage.Window)->GetOpenGLVersion(major, minor);
  if (10 * major + minor >= 33)
  {
    std::cout << "OpenGL is " << major << "." << minor << " whatever Mesa's variables say."
              << std::endl;
    return 125; // VTK's code for a test that is skipped
  }
  const std::vector<Square> squares = MakeSquares(1, 100, 100);
  stage.AddSquares(squares);
  const auto color = stage.Render().At(30, 30);
  check(IsExact(color, Blend(squares, Background), 1.0), "the delegate draws" + Describe(color));
  stage.Render();
  check(
    messages->TakeErrors("OpenGL has not OpenGL 3.3 or GL_ARB_shader_bit_encoding, OpenGL 4.2 or "
                         "GL_ARB_shader_image_load_store") == 1,
    "what is missing is told once");
  check(stage.Pass->GetNumberOfFragments() == 0, "there are no fragments");
  check(messages->IsQuiet(), "no other errors and no warnings");
  return check.GetResult();
}
