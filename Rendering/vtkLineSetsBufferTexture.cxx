// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsBufferTexture.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
vtkLineSetsBufferTexture::vtkLineSetsBufferTexture()
  : Buffer(vtkSmartPointer<vtkOpenGLBufferObject>::New())
  , Texture(vtkSmartPointer<vtkTextureObject>::New())
{
}

//------------------------------------------------------------------------------
vtkLineSetsBufferTexture::~vtkLineSetsBufferTexture()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
bool vtkLineSetsBufferTexture::ForgetGLErrors()
{
  // A context without a window reports errors without end, hence the limit.
  int errors = 0;
  while (errors < 16 && glGetError() != GL_NO_ERROR)
  {
    ++errors;
  }
  return errors < 16;
}

//------------------------------------------------------------------------------
bool vtkLineSetsBufferTexture::Upload(vtkOpenGLRenderWindow* window, const void* data,
  std::size_t texels, std::size_t componentSize, unsigned int format, int components, int vtkType)
{
  this->Bytes = texels * components * componentSize;
  if (!ForgetGLErrors() ||
    !this->Buffer->Upload(
      static_cast<const unsigned char*>(data), this->Bytes, vtkOpenGLBufferObject::TextureBuffer) ||
    glGetError() != GL_NO_ERROR)
  {
    return false;
  }
  return this->CreateTexture(window, texels, format, components, vtkType);
}

//------------------------------------------------------------------------------
bool vtkLineSetsBufferTexture::Allocate(vtkOpenGLRenderWindow* window, std::size_t texels,
  std::size_t componentSize, unsigned int format, int components, int vtkType)
{
  this->Bytes = texels * components * componentSize;
  // VTK's own Upload() takes no null pointer in every version: a byte makes the buffer.
  const unsigned char nothing = 0;
  if (!ForgetGLErrors() ||
    !this->Buffer->Upload(&nothing, 1, vtkOpenGLBufferObject::TextureBuffer) ||
    !this->Buffer->Bind())
  {
    return false;
  }
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(this->Bytes), nullptr, GL_DYNAMIC_COPY);
  return glGetError() == GL_NO_ERROR &&
    this->CreateTexture(window, texels, format, components, vtkType);
}

//------------------------------------------------------------------------------
bool vtkLineSetsBufferTexture::CreateTexture(vtkOpenGLRenderWindow* window, std::size_t texels,
  unsigned int format, int components, int vtkType)
{
  this->Window = window;
  this->Texture->SetContext(window);
  this->Texture->SetInternalFormat(format);
  return this->Texture->CreateTextureBuffer(
    static_cast<unsigned int>(texels), components, vtkType, this->Buffer);
}

//------------------------------------------------------------------------------
void vtkLineSetsBufferTexture::Activate(vtkShaderProgram* program, const char* name)
{
  if (program->IsUniformUsed(name))
  {
    this->Texture->Activate();
    program->SetUniformi(name, this->Texture->GetTextureUnit());
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsBufferTexture::Deactivate()
{
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
void vtkLineSetsBufferTexture::Download(void* data, std::size_t bytes)
{
  this->Buffer->Bind();
  glGetBufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), data);
  this->Buffer->Release();
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkLineSetsBufferTexture::GetTexture() const
{
  return this->Texture;
}

//------------------------------------------------------------------------------
unsigned int vtkLineSetsBufferTexture::GetHandle() const
{
  return this->Texture->GetHandle();
}

//------------------------------------------------------------------------------
bool vtkLineSetsBufferTexture::IsGone() const
{
  return this->Bytes > 0 && this->Texture->GetHandle() == 0;
}

//------------------------------------------------------------------------------
void vtkLineSetsBufferTexture::Release(vtkWindow* window)
{
  if (this->Bytes == 0)
  {
    return;
  }
  // Until the texture was made there is no window to make current: the caller's is.
  if ((!this->Window && this->Texture->GetHandle() != 0) || this->IsGone())
  {
    this->Forget();
    return;
  }
  vtkSmartPointer<vtkOpenGLRenderWindow> own = this->Window.GetPointer();
  if (own)
  {
    own->PushContext();
  }
  this->Texture->ReleaseGraphicsResources(own ? own.Get() : window);
  this->Buffer->ReleaseGraphicsResources();
  if (own)
  {
    own->PopContext();
  }
  this->Window = nullptr;
  this->Bytes = 0;
}

//------------------------------------------------------------------------------
void vtkLineSetsBufferTexture::Forget()
{
  this->Buffer->Register(nullptr);
  this->Buffer = vtkSmartPointer<vtkOpenGLBufferObject>::New();
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Window = nullptr;
  this->Bytes = 0;
}
