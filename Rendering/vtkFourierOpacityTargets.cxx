// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityTargets.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkLineSetsBufferTexture.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

namespace
{
const unsigned int FloatFormats[5] = { 0, GL_R32F, GL_RG32F, 0, GL_RGBA32F };
const unsigned int Layouts[5] = { 0, GL_RED, GL_RG, 0, GL_RGBA };

int GetBytesPerTexel(unsigned int format)
{
  switch (format)
  {
    case GL_RGBA32F:
      return 16;
    case GL_RG32F:
      return 8;
    default:
      // One float, two half floats or four bytes.
      return 4;
  }
}

vtkIdType GetBytes(vtkTextureObject* texture, unsigned int format)
{
  return texture->GetHandle() == 0
    ? 0
    : static_cast<vtkIdType>(texture->GetWidth()) * texture->GetHeight() * GetBytesPerTexel(format);
}
}

//------------------------------------------------------------------------------
vtkFourierOpacityTargets::vtkFourierOpacityTargets() = default;

//------------------------------------------------------------------------------
vtkFourierOpacityTargets::~vtkFourierOpacityTargets() = default;

//------------------------------------------------------------------------------
std::vector<int> vtkFourierOpacityTargets::GetComponents(int sums)
{
  std::vector<int> components(static_cast<std::size_t>(sums / 4), 4);
  for (int size : { 2, 1 })
  {
    if (sums & size)
    {
      components.push_back(size);
    }
  }
  return components;
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityTargets::Make(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  bool wanted, int width, int height, int components, unsigned int format)
{
  const auto w = static_cast<unsigned int>(width);
  const auto h = static_cast<unsigned int>(height);
  if (!wanted ||
    (texture->GetHandle() != 0 && (texture->GetWidth() != w || texture->GetHeight() != h)))
  {
    texture->ReleaseGraphicsResources(window);
  }
  if (!wanted || texture->GetHandle() != 0)
  {
    return true;
  }
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetInternalFormat(format);
  texture->SetFormat(Layouts[components]);
  const bool bytes = format == GL_RGBA8;
  texture->SetDataType(bytes ? GL_UNSIGNED_BYTE : GL_FLOAT);
  return vtkLineSetsBufferTexture::ForgetGLErrors() &&
    texture->Allocate2D(w, h, components, bytes ? VTK_UNSIGNED_CHAR : VTK_FLOAT) &&
    glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityTargets::Prepare(vtkOpenGLRenderWindow* window, const Layout& layout)
{
  const int w = layout.Width;
  const int h = layout.Height;
  const std::vector<int> components = GetComponents(layout.Sums);
  if (components != this->Components)
  {
    for (const auto& texture : this->Sums)
    {
      texture->ReleaseGraphicsResources(window);
    }
    this->Sums.resize(components.size());
    for (auto& texture : this->Sums)
    {
      texture = vtkSmartPointer<vtkTextureObject>::New();
    }
    this->Components = components;
  }
  bool made = true;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    made = made &&
      this->Make(window, this->Sums[i], true, w, h, components[i], FloatFormats[components[i]]);
  }
  const bool bounds = layout.BoundsWidth > 0;
  made = made &&
    this->Make(
      window, this->Bounds, bounds, layout.BoundsWidth, layout.BoundsHeight, 2, GL_RG16F) &&
    this->Make(
      window, this->Widened, bounds, layout.BoundsWidth, layout.BoundsHeight, 2, GL_RG16F) &&
    this->Make(window, this->Colors, true, w, h, 4, GL_RGBA32F) &&
    this->Make(window, this->Counts, layout.HasCounts, w, h, 2, GL_RG32F) &&
    this->Make(window, this->Opaque, layout.HasOpaqueLayer, w, h, 4, GL_RGBA8) &&
    this->Make(window, this->Color, layout.HasPicture, w, h, 4, GL_RGBA8) &&
    this->Make(window, this->Depth, layout.HasPicture, w, h, 1, GL_R32F);
  if (!made)
  {
    this->ReleaseGraphicsResources(window);
    return "There is no memory on the graphics device for the sums of " + std::to_string(w) +
      " x " + std::to_string(h) + " pixels with " + std::to_string(layout.Sums) +
      " sums each: draw a smaller picture or with fewer bands.";
  }
  this->Framebuffer->SetContext(window);
  return {};
}

//------------------------------------------------------------------------------
void vtkFourierOpacityTargets::Bind(
  const std::vector<vtkTextureObject*>& textures, vtkTextureObject* depth)
{
  this->Framebuffer->Bind();
  const auto count = static_cast<unsigned int>(textures.size());
  const auto old = static_cast<unsigned int>(this->Framebuffer->GetNumberOfColorAttachments());
  // All are removed: VTK takes a texture for attached that was attached before it got another size.
  this->Framebuffer->RemoveColorAttachments(old);
  for (unsigned int i = 0; i < count; ++i)
  {
    this->Framebuffer->AddColorAttachment(i, textures[i]);
  }
  this->Framebuffer->RemoveDepthAttachment();
  if (depth)
  {
    this->Framebuffer->AddDepthAttachment(depth);
  }
  // VTK's state takes draw buffers after the first one for those of the framebuffer bound before,
  // and would not set what it takes for set.
  this->Framebuffer->DeactivateDrawBuffers();
  this->Framebuffer->ActivateDrawBuffers(count);
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityTargets::MakeColors(
  vtkOpenGLRenderWindow* window, vtkTextureObject* texture, const int size[2])
{
  return Make(window, texture, true, size[0], size[1], 4, GL_RGBA32F);
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityTargets::GetNumberOfColorBytes(vtkTextureObject* texture)
{
  return GetBytes(texture, GL_RGBA32F);
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityTargets::GetNumberOfSumBytes() const
{
  vtkIdType bytes = 0;
  for (std::size_t i = 0; i < this->Sums.size(); ++i)
  {
    bytes += GetBytes(this->Sums[i], FloatFormats[this->Components[i]]);
  }
  return bytes;
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityTargets::GetNumberOfBytes() const
{
  return this->GetNumberOfSumBytes() + GetBytes(this->Bounds, GL_RG16F) +
    GetBytes(this->Widened, GL_RG16F) + GetBytes(this->Colors, GL_RGBA32F) +
    GetBytes(this->Counts, GL_RG32F) + GetBytes(this->Opaque, GL_RGBA8) +
    GetBytes(this->Color, GL_RGBA8) + GetBytes(this->Depth, GL_R32F);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityTargets::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  for (const auto& texture : this->Sums)
  {
    texture->ReleaseGraphicsResources(window);
  }
  for (vtkTextureObject* texture : { this->Bounds.Get(), this->Widened.Get(), this->Colors.Get(),
         this->Counts.Get(), this->Opaque.Get(), this->Color.Get(), this->Depth.Get() })
  {
    texture->ReleaseGraphicsResources(window);
  }
}
