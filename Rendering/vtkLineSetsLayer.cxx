// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsLayer.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkAbstractMapper.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkProp.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include "vtkLineSetsLayerFS.h"
#include "vtkLineSetsLayerVS.h"

#include <vector>

namespace
{
// The render passes that have announced themselves at the prop.
std::vector<vtkOpenGLRenderPass*> GetRenderPasses(vtkProp* prop)
{
  std::vector<vtkOpenGLRenderPass*> passes;
  vtkInformation* keys = prop->GetPropertyKeys();
  if (keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    const int count = keys->Length(vtkOpenGLRenderPass::RenderPasses());
    for (int i = 0; i < count; ++i)
    {
      auto* pass = vtkOpenGLRenderPass::SafeDownCast(
        vtkObject::SafeDownCast(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i)));
      if (pass)
      {
        passes.push_back(pass);
      }
    }
  }
  return passes;
}

bool Upload(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int width, int height,
  int components, int type, const void* data)
{
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  // vtkTextureObject asks for a pointer to what could be changed, but does not change it.
  return texture->Create2DFromRaw(static_cast<unsigned int>(width),
    static_cast<unsigned int>(height), components, type, const_cast<void*>(data));
}

vtkIdType GetBytes(vtkTextureObject* texture, int bytesPerTexel)
{
  return texture->GetHandle() == 0
    ? 0
    : static_cast<vtkIdType>(texture->GetWidth()) * texture->GetHeight() * bytesPerTexel;
}
}

//------------------------------------------------------------------------------
vtkLineSetsLayer::vtkLineSetsLayer() = default;

//------------------------------------------------------------------------------
vtkLineSetsLayer::~vtkLineSetsLayer() = default;

//------------------------------------------------------------------------------
bool vtkLineSetsLayer::SetPicture(vtkOpenGLRenderWindow* window, int width, int height,
  const std::uint8_t* color, const float* depth)
{
  this->Color = this->OwnColor;
  this->Depth = this->OwnDepth;
  return Upload(this->OwnColor, window, width, height, 4, VTK_UNSIGNED_CHAR, color) &&
    Upload(this->OwnDepth, window, width, height, 1, VTK_FLOAT, depth);
}

//------------------------------------------------------------------------------
void vtkLineSetsLayer::SetTextures(vtkTextureObject* color, vtkTextureObject* depth)
{
  this->Color = color;
  this->Depth = depth;
}

//------------------------------------------------------------------------------
bool vtkLineSetsLayer::HasPicture() const
{
  // A window that closes releases textures by itself.
  return this->Color && this->Depth && this->Color->GetHandle() != 0 &&
    this->Depth->GetHandle() != 0;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkLineSetsLayer::ReadyProgram(
  vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper, vtkProp* prop, std::string& error)
{
  std::string vertexShader = vtkLineSetsLayerVS;
  std::string geometryShader;
  std::string fragmentShader = vtkLineSetsLayerFS;
  const std::vector<vtkOpenGLRenderPass*> passes = GetRenderPasses(prop);
  for (vtkOpenGLRenderPass* pass : passes)
  {
    if (!pass->PreReplaceShaderValues(vertexShader, geometryShader, fragmentShader, mapper, prop))
    {
      error = std::string("the render pass ") + pass->GetClassName() + " failed before replacement";
    }
  }
  for (vtkOpenGLRenderPass* pass : passes)
  {
    if (!pass->PostReplaceShaderValues(vertexShader, geometryShader, fragmentShader, mapper, prop))
    {
      error = std::string("the render pass ") + pass->GetClassName() + " failed after replacement";
    }
  }
  // The text is made anew for every draw, since a pass may change it from stage to stage; the
  // shader cache compiles each text once.
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    vertexShader.c_str(), fragmentShader.c_str(), geometryShader.c_str());
  if (!program)
  {
    error = "the shader of the final draw does not compile";
  }
  return program;
}

//------------------------------------------------------------------------------
std::string vtkLineSetsLayer::Draw(vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper,
  vtkProp* prop, int originX, int originY, float depthOffset)
{
  if (!this->Color || !this->Depth)
  {
    return "there is no picture";
  }
  std::string error;
  vtkShaderProgram* program = this->ReadyProgram(window, mapper, prop, error);
  if (!program)
  {
    return error;
  }

  vtkNew<vtkOpenGLVertexArrayObject> vao;
  vao->Bind();
  if (!vao->AddAttributeArray(
        program, window->GetTQuad2DVBO(), "ndCoordIn", 0, 4 * sizeof(float), VTK_FLOAT, 2, false))
  {
    vao->Release();
    return "the vertices of the final draw cannot be bound";
  }

  this->Color->Activate();
  this->Depth->Activate();
  const int origin[2] = { originX, originY };
  const int size[2] = { static_cast<int>(this->Color->GetWidth()),
    static_cast<int>(this->Color->GetHeight()) };
  program->SetUniformi("layerColor", this->Color->GetTextureUnit());
  program->SetUniformi("layerDepth", this->Depth->GetTextureUnit());
  program->SetUniform2i("layerOrigin", origin);
  program->SetUniform2i("layerSize", size);
  program->SetUniformf("layerDepthOffset", depthOffset);
  for (vtkOpenGLRenderPass* pass : GetRenderPasses(prop))
  {
    if (!pass->SetShaderParameters(program, mapper, prop, vao))
    {
      error = std::string("the render pass ") + pass->GetClassName() + " set no parameters";
    }
  }

  {
    // The property's culling is about the surface of tubes; the quad always faces the front.
    vtkOpenGLState* state = window->GetState();
    vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
    state->vtkglDisable(GL_CULL_FACE);
    vtkOpenGLRenderUtilities::DrawFullScreenQuad();
  }
  vao->Release();
  this->Depth->Deactivate();
  this->Color->Deactivate();
  vao->ReleaseGraphicsResources();
  return error;
}

//------------------------------------------------------------------------------
vtkIdType vtkLineSetsLayer::GetNumberOfBytes() const
{
  return GetBytes(this->OwnColor, 4) + GetBytes(this->OwnDepth, 4);
}

//------------------------------------------------------------------------------
void vtkLineSetsLayer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->OwnColor->ReleaseGraphicsResources(window);
  this->OwnDepth->ReleaseGraphicsResources(window);
  this->Color = nullptr;
  this->Depth = nullptr;
}
