// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsSceneDepth.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkLineSetsBufferTexture.h"
#include <algorithm>
#include <cmath>

namespace
{
unsigned int GetBinding(vtkOpenGLState* state, unsigned int which)
{
  int binding = 0;
  state->vtkglGetIntegerv(which, &binding);
  return static_cast<unsigned int>(binding);
}

// Samples per pixel of the framebuffer that is bound for reading; GL tells the drawn one's.
int GetReadSamples(vtkOpenGLState* state)
{
  const unsigned int reading = GetBinding(state, GL_READ_FRAMEBUFFER_BINDING);
  const bool same = reading == GetBinding(state, GL_DRAW_FRAMEBUFFER_BINDING);
  int samples = 0;
  if (!same)
  {
    state->PushDrawFramebufferBinding();
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, reading);
  }
  state->vtkglGetIntegerv(GL_SAMPLES, &samples);
  if (!same)
  {
    state->PopDrawFramebufferBinding();
  }
  return samples;
}

// Bits of an attachment of the framebuffer bound for reading, 0 where there is none.
int GetReadBits(unsigned int attachment, unsigned int bits)
{
  int type = GL_NONE;
  glGetFramebufferAttachmentParameteriv(
    GL_READ_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  int size = 0;
  if (type != GL_NONE)
  {
    glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, attachment, bits, &size);
  }
  return size;
}

// Attachment of the framebuffer bound for reading that holds depths; the window's own has another
// name for it.
unsigned int GetDepthAttachment(vtkOpenGLState* state)
{
  return GetBinding(state, GL_READ_FRAMEBUFFER_BINDING) == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
}

/**
 * While it lives, the rectangle can be read from the framebuffer bound for reading, at Origin:
 * where that one has several samples per pixel, they have been resolved into another one.
 */
class ReadableDepth
{
public:
  ReadableDepth(vtkOpenGLRenderWindow* window, const int origin[2], int width, int height)
    : State(window->GetState())
    , Origin{ origin[0], origin[1] }
  {
    this->State->PushFramebufferBindings();
    vtkLineSetsBufferTexture::ForgetGLErrors();
    if (GetReadSamples(this->State) > 0)
    {
      this->Resolve(window, width, height);
    }
  }

  ~ReadableDepth() { this->State->PopFramebufferBindings(); }

  ReadableDepth(const ReadableDepth&) = delete;
  void operator=(const ReadableDepth&) = delete;

  int GetX() const { return this->Origin[0]; }
  int GetY() const { return this->Origin[1]; }

private:
  void Resolve(vtkOpenGLRenderWindow* window, int width, int height)
  {
    // Depth is copied only between equal formats.
    const bool own = GetBinding(this->State, GL_READ_FRAMEBUFFER_BINDING) == 0;
    const int depthBits =
      GetReadBits(GetDepthAttachment(this->State), GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    const int stencilBits =
      GetReadBits(own ? GL_STENCIL : GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
    this->State->PushReadFramebufferBinding();
    this->Framebuffer->SetContext(window);
    this->Framebuffer->PopulateFramebuffer(
      width, height, true, 1, VTK_UNSIGNED_CHAR, true, depthBits, 0, stencilBits > 0);
    this->State->PopReadFramebufferBinding();
    {
      // The scissor would cut the copy.
      vtkOpenGLState::ScopedglEnableDisable scissor(this->State, GL_SCISSOR_TEST);
      this->State->vtkglDisable(GL_SCISSOR_TEST);
      this->State->vtkglBlitFramebuffer(this->Origin[0], this->Origin[1], this->Origin[0] + width,
        this->Origin[1] + height, 0, 0, width, height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    }
    this->Framebuffer->Bind(GL_READ_FRAMEBUFFER);
    this->Origin[0] = 0;
    this->Origin[1] = 0;
  }

  vtkOpenGLState* State;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  int Origin[2];
};
}

//------------------------------------------------------------------------------
vtkLineSetsSceneDepth::vtkLineSetsSceneDepth() = default;

//------------------------------------------------------------------------------
vtkLineSetsSceneDepth::~vtkLineSetsSceneDepth() = default;

//------------------------------------------------------------------------------
void vtkLineSetsSceneDepth::GetReadOrigin(
  vtkOpenGLRenderWindow* window, const int viewport[4], const int tiledOrigin[2], int readOrigin[2])
{
  vtkOpenGLState* state = window->GetState();
  const bool same = GetBinding(state, GL_READ_FRAMEBUFFER_BINDING) ==
    GetBinding(state, GL_DRAW_FRAMEBUFFER_BINDING);
  readOrigin[0] = same ? viewport[0] : tiledOrigin[0];
  readOrigin[1] = same ? viewport[1] : tiledOrigin[1];
}

//------------------------------------------------------------------------------
double vtkLineSetsSceneDepth::GetReadStep(vtkOpenGLRenderWindow* window)
{
  const unsigned int attachment = GetDepthAttachment(window->GetState());
  const int bits = GetReadBits(attachment, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  if (bits < 1)
  {
    return 0.0;
  }
  int type = GL_NONE;
  glGetFramebufferAttachmentParameteriv(
    GL_READ_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
  // What is read is rounded to single precision, whatever the framebuffer holds.
  const double single = std::ldexp(1.0, -23);
  return type == GL_FLOAT ? 0.0 : std::max(1.0 / (std::ldexp(1.0, bits) - 1.0), single);
}

//------------------------------------------------------------------------------
bool vtkLineSetsSceneDepth::Read(vtkOpenGLRenderWindow* window, const int origin[2], int width,
  int height, std::vector<float>& depth)
{
  const ReadableDepth readable(window, origin, width, height);
  depth.resize(static_cast<std::size_t>(width) * height);
  glReadPixels(
    readable.GetX(), readable.GetY(), width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  const bool valid = glGetError() == GL_NO_ERROR;
  if (!valid)
  {
    depth.clear();
  }
  return valid;
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkLineSetsSceneDepth::Copy(
  vtkOpenGLRenderWindow* window, const int origin[2], int width, int height)
{
  const ReadableDepth readable(window, origin, width, height);
  this->Texture->SetContext(window);
  if (this->Texture->GetHandle() == 0)
  {
    this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    this->Texture->AllocateDepth(static_cast<unsigned int>(width),
      static_cast<unsigned int>(height), vtkTextureObject::Float32);
  }
  else
  {
    this->Texture->Resize(static_cast<unsigned int>(width), static_cast<unsigned int>(height));
  }
  this->Texture->Activate();
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, readable.GetX(), readable.GetY(), width, height);
  const bool valid = glGetError() == GL_NO_ERROR;
  this->Texture->Deactivate();
  return valid ? this->Texture.Get() : nullptr;
}

//------------------------------------------------------------------------------
std::vector<float> vtkLineSetsSceneDepth::Download(vtkTextureObject* texture)
{
  std::vector<float> depth;
  if (texture)
  {
    depth.resize(static_cast<std::size_t>(texture->GetWidth()) * texture->GetHeight());
    texture->Activate();
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
    texture->Deactivate();
  }
  return depth;
}

//------------------------------------------------------------------------------
vtkIdType vtkLineSetsSceneDepth::GetNumberOfBytes() const
{
  return this->Texture->GetHandle() == 0
    ? 0
    : static_cast<vtkIdType>(this->Texture->GetWidth()) * this->Texture->GetHeight() * 4;
}

//------------------------------------------------------------------------------
void vtkLineSetsSceneDepth::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}
