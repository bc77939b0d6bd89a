// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * State of OpenGL that is as before when an object ends.
 * The source that includes this includes OpenGL before.
 */

#ifndef vtkLineSetsScopedState_h
#define vtkLineSetsScopedState_h

#include "vtkOpenGLState.h"

namespace vtkLineSetsScopedState
{
/// State that draws change; it is as before when this ends.
class SavedState
{
public:
  explicit SavedState(vtkOpenGLState* state)
    : Bindings(state)
    , Viewport(state)
    , Scissor(state)
    , ClearColor(state)
    , ColorMask(state)
    , DepthMask(state)
    , DepthFunction(state)
    , Blending(state)
    , Equation(state)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
#ifdef GL_MULTISAMPLE
    , Multisample(state, GL_MULTISAMPLE)
#endif
  {
  }

private:
  struct FramebufferBindings
  {
    explicit FramebufferBindings(vtkOpenGLState* state)
      : State(state)
    {
      state->PushFramebufferBindings();
    }
    ~FramebufferBindings() { this->State->PopFramebufferBindings(); }
    vtkOpenGLState* State;
  };

  struct BlendEquation
  {
    explicit BlendEquation(vtkOpenGLState* state)
      : State(state)
    {
      int color = GL_FUNC_ADD;
      int alpha = GL_FUNC_ADD;
      glGetIntegerv(GL_BLEND_EQUATION_RGB, &color);
      glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &alpha);
      this->Color = static_cast<unsigned int>(color);
      this->Alpha = static_cast<unsigned int>(alpha);
    }
    ~BlendEquation() { this->State->vtkglBlendEquationSeparate(this->Color, this->Alpha); }
    vtkOpenGLState* State;
    unsigned int Color;
    unsigned int Alpha;
  };

  FramebufferBindings Bindings;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunction;
  vtkOpenGLState::ScopedglBlendFuncSeparate Blending;
  BlendEquation Equation;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
#ifdef GL_MULTISAMPLE
  vtkOpenGLState::ScopedglEnableDisable Multisample;
#endif
};

/// What is bound to an image unit; it is bound again when this ends.
class SavedImageUnit
{
public:
  explicit SavedImageUnit(unsigned int unit)
    : Unit(unit)
    , Name(Get(GL_IMAGE_BINDING_NAME))
    , Level(Get(GL_IMAGE_BINDING_LEVEL))
    , IsLayered(Get(GL_IMAGE_BINDING_LAYERED))
    , Layer(Get(GL_IMAGE_BINDING_LAYER))
    , Access(Get(GL_IMAGE_BINDING_ACCESS))
    , Format(Get(GL_IMAGE_BINDING_FORMAT))
  {
  }
  ~SavedImageUnit()
  {
    glBindImageTexture(this->Unit, static_cast<GLuint>(this->Name), this->Level,
      this->IsLayered ? GL_TRUE : GL_FALSE, this->Layer, static_cast<GLenum>(this->Access),
      static_cast<GLenum>(this->Format));
  }
  SavedImageUnit(const SavedImageUnit&) = delete;
  void operator=(const SavedImageUnit&) = delete;

private:
  int Get(GLenum which) const
  {
    int value = 0;
    glGetIntegeri_v(which, this->Unit, &value);
    return value;
  }

  unsigned int Unit;
  int Name;
  int Level;
  int IsLayered;
  int Layer;
  int Access;
  int Format;
};
}

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsScopedState.h
