// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineShaderEngine.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkLineSetsBufferTexture.h"
#include "vtkLineSetsLightingUniforms.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkVoxelLineFieldBuffers.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineModelBuffers.h"
#include "vtkVoxelLineShaderUniforms.h"
#include "vtkWeakPointer.h"

#include "vtkVoxelLineAcceleration.h"
#include "vtkVoxelLineCapsule.h"
#include "vtkVoxelLineCount.h"
#include "vtkVoxelLineDensity.h"
#include "vtkVoxelLineFetch.h"
#include "vtkVoxelLineFragment.h"
#include "vtkVoxelLineHits.h"
#include "vtkVoxelLineLayers.h"
#include "vtkVoxelLineOccluder.h"
#include "vtkVoxelLineOcclusionRay.h"
#include "vtkVoxelLinePacking.h"
#include "vtkVoxelLinePixel.h"
#include "vtkVoxelLineRay.h"
#include "vtkVoxelLineSegment.h"
#include "vtkVoxelLineShading.h"
#include "vtkVoxelLineShadow.h"
#include "vtkVoxelLineSlabs.h"
#include "vtkVoxelLineSoftLight.h"
#include "vtkVoxelLineTraversal.h"
#include "vtkVoxelLineVertex.h"

#include <algorithm>
#include <sstream>

namespace
{
/// Whether samples are being counted by somebody else.
bool IsQueryUnderWay(vtkOpenGLRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  const int version = 10 * major + minor;
  GLint query = 0;
  glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &query);
  if (query == 0 && version >= 33)
  {
    glGetQueryiv(GL_ANY_SAMPLES_PASSED, GL_CURRENT_QUERY, &query);
  }
  if (query == 0 && version >= 43)
  {
    glGetQueryiv(GL_ANY_SAMPLES_PASSED_CONSERVATIVE, GL_CURRENT_QUERY, &query);
  }
  return query != 0;
}
}

struct vtkVoxelLineShaderEngine::Internals
{
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkVoxelLineModelBuffers Model{ "", true };
  vtkVoxelLineModelBuffers Level{ "Level", false };
  vtkVoxelLineFieldBuffers Fields;
  vtkLineSetsBufferTexture ColorTable;
  vtkLineSetsLightingUniforms Lighting;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::string QuadKind;
  // Counts the pixels in which an exit had to be forgotten.
  vtkNew<vtkOpenGLFramebufferObject> CountFramebuffer;
  std::unique_ptr<vtkOpenGLQuadHelper> CountQuad;
  unsigned int CountQuery = 0;
  vtkIdType NumberOfOverflows = 0;
  std::string Error;
  int Size[2] = { 0, 0 };

  bool Fail(const std::string& error)
  {
    this->Error = error;
    return false;
  }

  void ReleaseTargets(vtkWindow* window);
  bool IsContextGone() const;
  void Forget();
  void Release();
  bool Check(vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame);
  bool CheckTextures(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model,
    const vtkVoxelLineFrame& frame, bool hasScene, bool hasLevel);
  bool UploadModels(
    vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model, vtkVoxelLineModel* level);
  bool UploadFields(vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame);
  bool UploadTable(vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame);
  bool PrepareTargets(vtkOpenGLRenderWindow* window, int width, int height);
  bool BindTargets(vtkOpenGLRenderWindow* window);
  bool PrepareQuad(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model,
    const vtkVoxelLineFrame& frame, bool hasScene, bool hasLevel);
  void ActivateBuffers(bool hasLevel);
  void DeactivateBuffers();
  void CountOverflows(vtkOpenGLRenderWindow* window);
};

void vtkVoxelLineShaderEngine::Internals::ReleaseTargets(vtkWindow* window)
{
  this->Lighting.ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->CountFramebuffer->ReleaseGraphicsResources(window);
  this->Color->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->Size[0] = this->Size[1] = 0;
}

bool vtkVoxelLineShaderEngine::Internals::IsContextGone() const
{
  // A window releases textures by itself before its context goes, but not buffers.
  return !this->Window || this->Model.IsGone() || this->Fields.IsGone();
}

void vtkVoxelLineShaderEngine::Internals::Forget()
{
  // What went with its context must not be deleted by number in another one, which VTK's objects
  // would do at their end: these few small objects are left behind without an owner.
  this->Model.Forget();
  this->Level.Forget();
  this->Fields.Forget();
  this->ColorTable.Forget();
  static_cast<void>(this->Quad.release());
  static_cast<void>(this->CountQuad.release());
  this->CountQuery = 0;
}

void vtkVoxelLineShaderEngine::Internals::Release()
{
  // Buffers, queries and vertex arrays are numbers that every context gives anew: they are deleted
  // while the context is current that they were made in.
  vtkOpenGLRenderWindow* window = this->Window;
  const bool gone = this->IsContextGone();
  if (gone)
  {
    this->Forget();
  }
  else
  {
    window->PushContext();
    this->Model.Release(window);
    this->Level.Release(window);
    this->Fields.Release(window);
    this->ColorTable.Release(window);
    this->Quad.reset();
    this->CountQuad.reset();
    if (this->CountQuery != 0)
    {
      glDeleteQueries(1, &this->CountQuery);
    }
    this->ReleaseTargets(window);
    window->PopContext();
  }
  this->QuadKind.clear();
  this->CountQuery = 0;
  this->Size[0] = this->Size[1] = 0;
  this->Model.Retry();
  this->Level.Retry();
  this->Window = nullptr;
}

bool vtkVoxelLineShaderEngine::Internals::Check(
  vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame)
{
  using namespace vtkVoxelLineShaderUniforms;
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  if (major < 3 || (major == 3 && minor < 2))
  {
    return this->Fail("OpenGL " + std::to_string(major) + "." + std::to_string(minor) +
      " has no texture buffers: the shader engine needs OpenGL 3.2; the native engine needs no "
      "more "
      "than VTK itself.");
  }
  if (frame.ClippingPlanes.size() > MaximumPlanes)
  {
    return this->Fail(std::to_string(frame.ClippingPlanes.size()) +
      " clipping planes are set, the shader engine takes at most " + std::to_string(MaximumPlanes) +
      "; the native engine takes any number.");
  }
  if (frame.Light.Lights.size() > vtkLineSetsLightingUniforms::MaximumLights)
  {
    return this->Fail(std::to_string(frame.Light.Lights.size()) +
      " lights are switched on, the shader engine takes at most " +
      std::to_string(vtkLineSetsLightingUniforms::MaximumLights) +
      "; the native engine takes any number.");
  }
  return true;
}

bool vtkVoxelLineShaderEngine::Internals::CheckTextures(vtkOpenGLRenderWindow* window,
  vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame, bool hasScene, bool hasLevel)
{
  const int attributes = frame.Coloring == vtkVoxelLineFrame::Uniform ? 0 : 1;
  const int radii = model->GetRadii() ? 1 : 0;
  const vtkVoxelLineGlobalLight& light = frame.Global;
  // Grid, bricks, starts, segments and curves; the level has no curves.
  const int textures = 5 + (model->GetCurveIdExtension() ? 1 : 0) + attributes + radii +
    (hasLevel ? 4 + attributes + radii : 0) + (frame.Coloring == vtkVoxelLineFrame::Table ? 1 : 0) +
    (hasScene ? 1 : 0) + (frame.Lighting && frame.Light.Table ? 1 : 0) + (light.Densities ? 1 : 0) +
    (light.SphericalOcclusion ? 1 : 0);
  int units = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  return textures <= units ||
    this->Fail("This picture takes " + std::to_string(textures) +
      " textures at once; a shader of this OpenGL reads at most " + std::to_string(units) +
      " (GL_MAX_TEXTURE_IMAGE_UNITS). Use soft shadows in place of those of a level, colours "
      "without "
      "data, or the native engine.");
}

bool vtkVoxelLineShaderEngine::Internals::UploadModels(
  vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model, vtkVoxelLineModel* level)
{
  if (!this->Model.Upload(window, model))
  {
    return this->Fail(this->Model.GetError());
  }
  if (!level)
  {
    // Nothing reads it: others may need its memory.
    this->Level.Release(window);
    return true;
  }
  return this->Level.Upload(window, level) || this->Fail(this->Level.GetError());
}

bool vtkVoxelLineShaderEngine::Internals::UploadFields(
  vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame)
{
  return this->Fields.Upload(window, frame.Global) || this->Fail(this->Fields.GetError());
}

bool vtkVoxelLineShaderEngine::Internals::UploadTable(
  vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame)
{
  return this->ColorTable.Upload(window, frame.ColorTable.data(), frame.ColorTable.size(),
           sizeof(float), GL_RGBA32F, 4, VTK_FLOAT) ||
    this->Fail("There is no memory on the graphics device for a colour table of 4096 bytes.");
}

bool vtkVoxelLineShaderEngine::Internals::PrepareTargets(
  vtkOpenGLRenderWindow* window, int width, int height)
{
  if (this->Size[0] == width && this->Size[1] == height)
  {
    return true;
  }
  int largest = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const std::string size = std::to_string(width) + " by " + std::to_string(height) + " pixels";
  if (width > largest || height > largest)
  {
    return this->Fail("The picture has " + size + "; a texture of this OpenGL has at most " +
      std::to_string(largest) + " (GL_MAX_TEXTURE_SIZE) in each direction.");
  }
  for (vtkTextureObject* texture : { this->Color.Get(), this->Depth.Get() })
  {
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  // Not Resize(), which does not tell whether there was memory.
  if (!vtkLineSetsBufferTexture::ForgetGLErrors() ||
    !this->Color->Allocate2D(width, height, 4, VTK_UNSIGNED_CHAR) ||
    !this->Depth->Allocate2D(width, height, 2, VTK_FLOAT) || glGetError() != GL_NO_ERROR)
  {
    this->ReleaseTargets(window);
    return this->Fail("There is no memory on the graphics device for a picture of " + size + ".");
  }
  this->Size[0] = width;
  this->Size[1] = height;
  return true;
}

bool vtkVoxelLineShaderEngine::Internals::BindTargets(vtkOpenGLRenderWindow* window)
{
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->AddColorAttachment(1, this->Depth);
  // VTK's state takes draw buffers after the first one for those of the framebuffer bound before,
  // which depth peeling and order-independent translucency have several of, and would not set what
  // it takes for set: depth would stay undefined.
  this->Framebuffer->DeactivateDrawBuffers();
  this->Framebuffer->ActivateDrawBuffers(2);
  const unsigned int status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
  {
    std::ostringstream os;
    os << "This OpenGL cannot draw into a picture of " << this->Size[0] << " by " << this->Size[1]
       << " pixels (framebuffer status 0x" << std::hex << status << ").";
    this->ReleaseTargets(window);
    return this->Fail(os.str());
  }
  return this->Framebuffer->Start(this->Size[0], this->Size[1]);
}

bool vtkVoxelLineShaderEngine::Internals::PrepareQuad(vtkOpenGLRenderWindow* window,
  vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame, bool hasScene, bool hasLevel)
{
  const std::string kind =
    vtkVoxelLineShaderUniforms::MakeConstants(model, frame, hasScene, hasLevel);
  if (!this->Quad || this->QuadKind != kind)
  {
    std::string source = std::string("//VTK::System::Dec\n//VTK::Output::Dec\n") +
      vtkVoxelLineFetch + vtkVoxelLinePacking + vtkVoxelLineCapsule + vtkVoxelLineRay +
      vtkVoxelLineSegment + vtkVoxelLineOccluder + vtkVoxelLineHits + vtkVoxelLineSlabs +
      vtkVoxelLineOcclusionRay + vtkVoxelLineDensity + vtkVoxelLineSoftLight + vtkVoxelLineShadow +
      vtkVoxelLineAcceleration + vtkVoxelLineShading + vtkVoxelLineLayers + vtkVoxelLineTraversal +
      vtkVoxelLinePixel + vtkVoxelLineFragment;
    vtkShaderProgram::Substitute(source, "//LineSets::Constants", kind);
    this->Quad.reset();
    if (!window->GetShaderCache()->ReadyShaderProgram(vtkVoxelLineVertex, source.c_str(), ""))
    {
      return this->Fail("The ray casting shader does not compile with this OpenGL; the native "
                        "engine needs none.");
    }
    this->Quad =
      std::make_unique<vtkOpenGLQuadHelper>(window, vtkVoxelLineVertex, source.c_str(), "");
    this->QuadKind = kind;
  }
  window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  return true;
}

void vtkVoxelLineShaderEngine::Internals::ActivateBuffers(bool hasLevel)
{
  vtkShaderProgram* program = this->Quad->Program;
  this->Model.Activate(program);
  if (hasLevel)
  {
    this->Level.Activate(program);
  }
  this->Fields.Activate(program);
  this->ColorTable.Activate(program, "ColorTable");
}

void vtkVoxelLineShaderEngine::Internals::DeactivateBuffers()
{
  this->Model.Deactivate();
  this->Level.Deactivate();
  this->Fields.Deactivate();
  this->ColorTable.Deactivate();
}

void vtkVoxelLineShaderEngine::Internals::CountOverflows(vtkOpenGLRenderWindow* window)
{
  this->NumberOfOverflows = 0;
  // Occlusion queries do not nest, and the one of depth peeling may be under way.
  if (IsQueryUnderWay(window))
  {
    return;
  }
  if (!this->CountQuad)
  {
    this->CountQuad =
      std::make_unique<vtkOpenGLQuadHelper>(window, vtkVoxelLineVertex, vtkVoxelLineCount, "");
    glGenQueries(1, &this->CountQuery);
  }
  if (!this->CountQuad->Program)
  {
    // The shader program has told its error itself.
    return;
  }
  // Its own framebuffer: the texture that is read must not be attached to the one that is drawn to.
  window->GetState()->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  this->CountFramebuffer->SetContext(window);
  this->CountFramebuffer->Bind();
  this->CountFramebuffer->AddColorAttachment(0, this->Color);
  this->CountFramebuffer->ActivateDrawBuffer(0);
  window->GetShaderCache()->ReadyShaderProgram(this->CountQuad->Program);
  this->Depth->Activate();
  this->CountQuad->Program->SetUniformi("Picture", this->Depth->GetTextureUnit());
  glBeginQuery(GL_SAMPLES_PASSED, this->CountQuery);
  this->CountQuad->Render();
  glEndQuery(GL_SAMPLES_PASSED);
  this->Depth->Deactivate();
  GLuint count = 0;
  glGetQueryObjectuiv(this->CountQuery, GL_QUERY_RESULT, &count);
  this->NumberOfOverflows = static_cast<vtkIdType>(count);
}

vtkVoxelLineShaderEngine::vtkVoxelLineShaderEngine()
  : Data(new Internals)
{
}

vtkVoxelLineShaderEngine::~vtkVoxelLineShaderEngine()
{
  this->Data->Release();
}

bool vtkVoxelLineShaderEngine::Render(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model,
  const vtkVoxelLineFrame& frame, vtkTextureObject* sceneDepth, vtkVoxelLineModel* levelModel)
{
  Internals& data = *this->Data;
  data.Error.clear();
  if (data.Window != window || data.IsContextGone())
  {
    data.Release();
    window->MakeCurrent();
    data.Window = window;
  }
  if (frame.Width < 1 || frame.Height < 1)
  {
    return data.Fail("The picture has no pixels.");
  }
  if (model->GetNumberOfSegments() == 0)
  {
    return data.Fail("The model has no segments.");
  }
  vtkVoxelLineModel* level =
    frame.LevelRays && levelModel && levelModel->GetNumberOfSegments() > 0 ? levelModel : nullptr;
  if (!data.Check(window, frame) ||
    !data.CheckTextures(window, model, frame, sceneDepth != nullptr, level != nullptr) ||
    !data.UploadModels(window, model, level) || !data.UploadFields(window, frame) ||
    !data.UploadTable(window, frame) || !data.PrepareTargets(window, frame.Width, frame.Height))
  {
    return false;
  }

  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  {
    vtkOpenGLState::ScopedglViewport viewport(state);
    vtkOpenGLState::ScopedglScissor scissor(state);
    vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
    vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
    vtkOpenGLState::ScopedglColorMask colorMask(state);
    vtkOpenGLState::ScopedglDepthMask depthMask(state);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglDepthMask(GL_FALSE);

    if (data.BindTargets(window) &&
      data.PrepareQuad(window, model, frame, sceneDepth != nullptr, level != nullptr))
    {
      if (sceneDepth)
      {
        sceneDepth->Activate();
        data.Quad->Program->SetUniformi("SceneDepth", sceneDepth->GetTextureUnit());
      }
      data.ActivateBuffers(level != nullptr);
      vtkVoxelLineShaderUniforms::Set(data.Quad->Program, model, frame, level);
      if (data.Lighting.Activate(window, data.Quad->Program, frame.Light))
      {
        data.Quad->Render();
      }
      else
      {
        data.Fail("There is no memory on the graphics device for the table of the light model.");
      }
      data.Lighting.Deactivate();
      data.DeactivateBuffers();
      if (sceneDepth)
      {
        sceneDepth->Deactivate();
      }
      // Opaque lines seen from outside have no stretches, thus nothing to forget.
      data.NumberOfOverflows = 0;
      if (!frame.IsOpaque())
      {
        data.CountOverflows(window);
      }
    }
  }
  state->PopFramebufferBindings();
  return data.Error.empty();
}

vtkTextureObject* vtkVoxelLineShaderEngine::GetColorTexture() const
{
  return this->Data->Size[0] > 0 ? this->Data->Color.Get() : nullptr;
}

vtkTextureObject* vtkVoxelLineShaderEngine::GetDepthTexture() const
{
  return this->Data->Size[0] > 0 ? this->Data->Depth.Get() : nullptr;
}

const std::string& vtkVoxelLineShaderEngine::GetError() const
{
  return this->Data->Error;
}

vtkIdType vtkVoxelLineShaderEngine::GetNumberOfOverflows() const
{
  return this->Data->NumberOfOverflows;
}

vtkIdType vtkVoxelLineShaderEngine::GetNumberOfBytes() const
{
  // The picture has 4 bytes of colour and 8 of depth per pixel.
  const vtkIdType bytes = static_cast<vtkIdType>(12) * this->Data->Size[0] * this->Data->Size[1];
  return bytes + this->Data->Model.GetNumberOfBytes() + this->Data->Level.GetNumberOfBytes() +
    this->Data->Fields.GetNumberOfBytes() +
    static_cast<vtkIdType>(this->Data->ColorTable.GetNumberOfBytes());
}

void vtkVoxelLineShaderEngine::ReleaseGraphicsResources(vtkWindow* vtkNotUsed(window))
{
  this->Data->Release();
}
