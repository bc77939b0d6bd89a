// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What tests of OpenGL's state share: a render pass that compares it before and after another one.
 */

#ifndef GLStateTesting_h
#define GLStateTesting_h

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <iostream>
#include <vector>

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

namespace VoxelLineMapperTesting
{
/// Takes down OpenGL's own values, not VTK's copies of them.
inline std::vector<int> GetGLState()
{
  std::vector<int> state;
  for (GLenum test :
    { GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE, GL_MULTISAMPLE, GL_STENCIL_TEST })
  {
    state.push_back(glIsEnabled(test));
  }
  for (GLenum name : { GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA,
         GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK,
         GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING, GL_DRAW_BUFFER, GL_READ_BUFFER,
         GL_VERTEX_ARRAY_BINDING, GL_SCISSOR_BOX, GL_VIEWPORT, GL_COLOR_WRITEMASK })
  {
    int values[4] = { 0, 0, 0, 0 };
    glGetIntegerv(name, values);
    state.insert(state.end(), values, values + 4);
  }
  for (GLuint unit = 0; unit < 8; ++unit)
  {
    for (GLenum name : { GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_LEVEL, GL_IMAGE_BINDING_ACCESS,
           GL_IMAGE_BINDING_FORMAT })
    {
      int value = 0;
      glGetIntegeri_v(name, unit, &value);
      state.push_back(value);
    }
  }
  return state;
}

/// Sets an unusual state and compares it with the one after its delegate.
class StatePass : public vtkRenderPass
{
public:
  static StatePass* New();
  vtkTypeMacro(StatePass, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    vtkOpenGLState* state = window->GetState();
    const vtkOpenGLState::ScopedglScissor scissor(state);
    const vtkOpenGLState::ScopedglBlendFuncSeparate blend(state);
    const vtkOpenGLState::ScopedglDepthFunc function(state);
    const vtkOpenGLState::ScopedglColorMask mask(state);
    const vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
    const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
    state->vtkglScissor(0, 0, 30, 60);
    if (this->HasScissor)
    {
      state->vtkglEnable(GL_SCISSOR_TEST);
    }
    else
    {
      state->vtkglDisable(GL_SCISSOR_TEST);
    }
    state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE, GL_ZERO, GL_ONE);
    // Depth peeling draws with a maximum.
    state->vtkglBlendEquationSeparate(GL_MAX, GL_MIN);
    state->vtkglDepthFunc(GL_LESS);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_FALSE, GL_TRUE);
    if (this->HasCulling)
    {
      state->vtkglEnable(GL_CULL_FACE);
    }
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 4, 4, 0, GL_RED, GL_FLOAT, nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindImageTexture(1, texture, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32F);
    const std::vector<int> before = GetGLState();
    while (glGetError() != GL_NO_ERROR)
    {
    }
    this->Delegate->Render(s);
    this->Error = glGetError();
    const std::vector<int> after = GetGLState();
    this->IsSame = before == after && before.size() > 50;
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      if (before[i] != after[i])
      {
        std::cerr << "state " << i << ": " << before[i] << " became " << after[i] << std::endl;
      }
    }
    state->vtkglBlendEquation(GL_FUNC_ADD);
    glBindImageTexture(1, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32F);
    glDeleteTextures(1, &texture);
  }

  vtkSmartPointer<vtkRenderPass> Delegate;
  bool HasScissor = true;
  /// Not where the delegate draws actors: their properties set it.
  bool HasCulling = true;
  GLenum Error = GL_NO_ERROR;
  bool IsSame = false;
};
inline vtkStandardNewMacro(StatePass);
}

#endif
