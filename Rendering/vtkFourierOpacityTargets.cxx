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
const unsigned int HalfFormats[5] = { 0, GL_R16F, GL_RG16F, 0, GL_RGBA16F };
const unsigned int Layouts[5] = { 0, GL_RED, GL_RG, 0, GL_RGBA };

struct Format
{
  int Components;
  int Bytes; ///< per texel
};

Format GetFormat(unsigned int format)
{
  switch (format)
  {
    case GL_RGBA32F:
      return { 4, 16 };
    case GL_RG32F:
      return { 2, 8 };
    case GL_R32F:
      return { 1, 4 };
    case GL_RGBA16F:
      return { 4, 8 };
    case GL_RG16F:
      return { 2, 4 };
    case GL_R16F:
      return { 1, 2 };
    default:
      return { 4, 4 }; // GL_RGBA8
  }
}

vtkIdType GetBytes(vtkTextureObject* texture, unsigned int format)
{
  return texture->GetHandle() == 0
    ? 0
    : static_cast<vtkIdType>(texture->GetWidth()) * texture->GetHeight() * GetFormat(format).Bytes;
}

// Make a texture, or make it anew with another size; returns whether there was memory.
bool Make(
  vtkOpenGLRenderWindow* window, vtkTextureObject* texture, const int size[2], unsigned int format)
{
  const auto width = static_cast<unsigned int>(size[0]);
  const auto height = static_cast<unsigned int>(size[1]);
  if (texture->GetHandle() != 0 && (texture->GetWidth() != width || texture->GetHeight() != height))
  {
    texture->ReleaseGraphicsResources(window);
  }
  if (texture->GetHandle() != 0)
  {
    return true;
  }
  const int components = GetFormat(format).Components;
  const bool bytes = format == GL_RGBA8;
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetInternalFormat(format);
  texture->SetFormat(Layouts[components]);
  texture->SetDataType(bytes ? GL_UNSIGNED_BYTE : GL_FLOAT);
  return vtkLineSetsBufferTexture::ForgetGLErrors() &&
    texture->Allocate2D(width, height, components, bytes ? VTK_UNSIGNED_CHAR : VTK_FLOAT) &&
    glGetError() == GL_NO_ERROR;
}
}

//------------------------------------------------------------------------------
vtkFourierOpacityTargets::vtkFourierOpacityTargets() = default;

//------------------------------------------------------------------------------
vtkFourierOpacityTargets::~vtkFourierOpacityTargets() = default;

//------------------------------------------------------------------------------
std::vector<int> vtkFourierOpacityTargets::GetComponents(int sums, bool halfFloats)
{
  std::vector<int> components(halfFloats ? 1 : 0, 1);
  const int rest = halfFloats ? sums - 1 : sums;
  components.insert(components.end(), static_cast<std::size_t>(rest / 4), 4);
  for (int size : { 2, 1 })
  {
    if (rest & size)
    {
      components.push_back(size);
    }
  }
  return components;
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityTargets::Keep(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  bool wanted, const int size[2], unsigned int format)
{
  unsigned int& last = this->Formats[texture];
  if (!wanted || format != last)
  {
    texture->ReleaseGraphicsResources(window);
  }
  last = format;
  return !wanted || Make(window, texture, size, format);
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityTargets::Prepare(vtkOpenGLRenderWindow* window, const Layout& layout)
{
  const std::vector<int> components = GetComponents(layout.Sums, layout.HasHalfFloats);
  while (this->Sums.size() > components.size())
  {
    this->Sums.back()->ReleaseGraphicsResources(window);
    this->Formats.erase(this->Sums.back());
    this->Sums.pop_back();
  }
  while (this->Sums.size() < components.size())
  {
    this->Sums.push_back(vtkSmartPointer<vtkTextureObject>::New());
  }
  bool made = true;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    // The first sum is the optical depth of the pixel.
    const unsigned int* formats = layout.HasHalfFloats && i > 0 ? HalfFormats : FloatFormats;
    made = made && this->Keep(window, this->Sums[i], true, layout.SumsSize, formats[components[i]]);
  }
  const bool bounds = layout.HasBounds;
  made = made && this->Keep(window, this->Bounds, bounds, layout.BoundsSize, GL_RG16F) &&
    this->Keep(window, this->Widened, bounds, layout.WidenedSize, GL_RG16F) &&
    this->Keep(
      window, this->Colors, true, layout.Size, layout.HasHalfFloats ? GL_RGBA16F : GL_RGBA32F) &&
    this->Keep(window, this->Counts, layout.HasCounts, layout.Size, GL_RG32F) &&
    this->Keep(window, this->Totals, layout.HasTotals, layout.Size, GL_R32F) &&
    this->Keep(window, this->Opaque, layout.HasOpaqueLayer, layout.Size, GL_RGBA8) &&
    this->Keep(window, this->Color, layout.HasPicture, layout.Size, GL_RGBA8);
  if (!made)
  {
    this->ReleaseGraphicsResources(window);
    return "There is no memory on the graphics device for the sums of " +
      std::to_string(layout.Size[0]) + " x " + std::to_string(layout.Size[1]) + " pixels with " +
      std::to_string(layout.Sums) +
      " sums each: draw a smaller picture, with fewer bands or with a higher DepthReduction.";
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
  return Make(window, texture, size, GL_RGBA32F);
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityTargets::GetNumberOfColorBytes(vtkTextureObject* texture)
{
  return GetBytes(texture, GL_RGBA32F);
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityTargets::GetNumberOfSumBytes() const
{
  vtkIdType bytes = GetBytes(this->Totals, GL_R32F);
  for (const auto& texture : this->Sums)
  {
    bytes += GetBytes(texture, this->Formats.at(texture));
  }
  return bytes;
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityTargets::GetNumberOfBytes() const
{
  vtkIdType bytes = 0;
  for (const auto& [texture, format] : this->Formats)
  {
    bytes += GetBytes(texture, format);
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityTargets::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  for (const auto& [texture, format] : this->Formats)
  {
    texture->ReleaseGraphicsResources(window);
  }
}
