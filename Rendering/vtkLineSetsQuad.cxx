// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsQuad.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"

#include "vtkLineSetsLayerVS.h"

//------------------------------------------------------------------------------
vtkShaderProgram* vtkLineSetsQuad::ReadyProgram(
  vtkOpenGLRenderWindow* window, const std::string& fragmentShader)
{
  return window->GetShaderCache()->ReadyShaderProgram(
    vtkLineSetsLayerVS, fragmentShader.c_str(), "");
}

//------------------------------------------------------------------------------
std::string vtkLineSetsQuad::Draw(vtkOpenGLRenderWindow* window, vtkShaderProgram* program)
{
  vtkNew<vtkOpenGLVertexArrayObject> vao;
  vao->Bind();
  if (!vao->AddAttributeArray(
        program, window->GetTQuad2DVBO(), "ndCoordIn", 0, 4 * sizeof(float), VTK_FLOAT, 2, false))
  {
    vao->Release();
    return "the vertices of a quad cannot be bound";
  }
  {
    // The quad always faces the front, but which side that is may have been changed.
    vtkOpenGLState* state = window->GetState();
    vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
    state->vtkglDisable(GL_CULL_FACE);
    vtkOpenGLRenderUtilities::DrawFullScreenQuad();
  }
  vao->Release();
  vao->ReleaseGraphicsResources();
  return {};
}
