// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineShaderEngine.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkDataArray.h"
#include "vtkLineSetsLightingUniforms.h"
#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineShaderUniforms.h"
#include "vtkWeakPointer.h"

#include "vtkVoxelLineCapsule.h"
#include "vtkVoxelLineCount.h"
#include "vtkVoxelLineFetch.h"
#include "vtkVoxelLineFragment.h"
#include "vtkVoxelLineHits.h"
#include "vtkVoxelLineLayers.h"
#include "vtkVoxelLinePacking.h"
#include "vtkVoxelLinePixel.h"
#include "vtkVoxelLineRay.h"
#include "vtkVoxelLineSegment.h"
#include "vtkVoxelLineShading.h"
#include "vtkVoxelLineTraversal.h"
#include "vtkVoxelLineVertex.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace
{
/// Errors of others are theirs to report. Returns false where they do not end.
bool ForgetGLErrors()
{
  // A context without a window reports errors without end, hence the limit.
  int errors = 0;
  while (errors < 16 && glGetError() != GL_NO_ERROR)
  {
    ++errors;
  }
  return errors < 16;
}

/// A buffer of the model and the texture through which the shader reads it.
struct BufferTexture
{
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  std::size_t Bytes = 0;

  /// Upload values of one component each. Returns whether there was memory for them.
  bool Upload(vtkOpenGLRenderWindow* window, const void* data, std::size_t values,
    std::size_t valueSize, unsigned int format, int components, int vtkType)
  {
    this->Bytes = values * components * valueSize;
    if (!ForgetGLErrors() ||
      !this->Buffer->Upload(static_cast<const unsigned char*>(data), this->Bytes,
        vtkOpenGLBufferObject::TextureBuffer) ||
      glGetError() != GL_NO_ERROR)
    {
      return false;
    }
    this->Texture->SetContext(window);
    this->Texture->SetInternalFormat(format);
    return this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(values), components, vtkType, this->Buffer);
  }

  void Release(vtkWindow* window)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Buffer->ReleaseGraphicsResources();
    this->Bytes = 0;
  }
};

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

/// The integer formats by size of a number.
unsigned int UnsignedFormat(int size)
{
  return size == 1 ? GL_R8UI : (size == 2 ? GL_R16UI : GL_R32UI);
}
}

struct vtkVoxelLineShaderEngine::Internals
{
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkWeakPointer<vtkVoxelLineModel> Model;
  vtkMTimeType ModelTime = 0;
  // The model that found no room, and what was said: it is not tried again in every frame.
  vtkWeakPointer<vtkVoxelLineModel> FailedModel;
  vtkMTimeType FailedTime = 0;
  std::string FailedError;
  std::map<std::string, BufferTexture> Buffers;
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

  void ReleaseBuffers(vtkWindow* window);
  void ReleaseTargets(vtkWindow* window);
  bool IsContextGone() const;
  void Forget();
  void Release();
  bool Check(vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame);
  bool UploadModel(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model);
  bool UploadArray(vtkOpenGLRenderWindow* window, const char* name, vtkDataArray* array,
    unsigned int format, int components = 1);
  bool UploadTable(vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame);
  bool PrepareTargets(vtkOpenGLRenderWindow* window, int width, int height);
  bool BindTargets(vtkOpenGLRenderWindow* window);
  bool PrepareQuad(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model,
    const vtkVoxelLineFrame& frame, bool hasScene);
  void ActivateBuffers();
  void CountOverflows(vtkOpenGLRenderWindow* window);
};

void vtkVoxelLineShaderEngine::Internals::ReleaseBuffers(vtkWindow* window)
{
  for (auto& buffer : this->Buffers)
  {
    buffer.second.Release(window);
  }
  this->Buffers.clear();
  this->Model = nullptr;
  this->ModelTime = 0;
}

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
  return !this->Window ||
    (!this->Buffers.empty() && this->Buffers.begin()->second.Texture->GetHandle() == 0);
}

void vtkVoxelLineShaderEngine::Internals::Forget()
{
  // What went with its context must not be deleted by number in another one, which VTK's objects
  // would do at their end: these few small objects are left behind without an owner.
  for (auto& buffer : this->Buffers)
  {
    buffer.second.Buffer->Register(nullptr);
  }
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
    this->ReleaseBuffers(window);
    this->Quad.reset();
    this->CountQuad.reset();
    if (this->CountQuery != 0)
    {
      glDeleteQueries(1, &this->CountQuery);
    }
    this->ReleaseTargets(window);
    window->PopContext();
  }
  this->Buffers.clear();
  this->QuadKind.clear();
  this->CountQuery = 0;
  this->Size[0] = this->Size[1] = 0;
  this->Model = nullptr;
  this->ModelTime = 0;
  this->FailedModel = nullptr;
  this->FailedTime = 0;
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

bool vtkVoxelLineShaderEngine::Internals::UploadArray(vtkOpenGLRenderWindow* window,
  const char* name, vtkDataArray* array, unsigned int format, int components)
{
  // A sampler must have a buffer even where the shader never reads it.
  static const unsigned char nothing[16] = { 0 };
  const std::size_t values =
    array ? static_cast<std::size_t>(array->GetNumberOfValues()) / components : 0;
  int largest = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest);
  if (values > static_cast<std::size_t>(largest))
  {
    return this->Fail("The model's array " + std::string(name) + " has " + std::to_string(values) +
      " values; a texture buffer of this OpenGL holds at most " + std::to_string(largest) +
      " (GL_MAX_TEXTURE_BUFFER_SIZE). Lower the Resolution or use the native engine.");
  }
  const int valueSize = array ? array->GetDataTypeSize() : 4;
  const int type = array ? array->GetDataType() : VTK_UNSIGNED_INT;
  BufferTexture& buffer = this->Buffers[name];
  if (!buffer.Upload(window, values ? array->GetVoidPointer(0) : nothing, values ? values : 1,
        valueSize, format, components, type))
  {
    return this->Fail("There is no memory on the graphics device for " +
      std::to_string(buffer.Bytes) + " bytes of the model (array " + name +
      "). Lower the Resolution or use the native engine.");
  }
  return true;
}

bool vtkVoxelLineShaderEngine::Internals::UploadModel(
  vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model)
{
  if (this->Model == model && this->ModelTime == model->GetMTime())
  {
    return true;
  }
  if (this->FailedModel == model && this->FailedTime == model->GetMTime())
  {
    return this->Fail(this->FailedError);
  }
  this->Model = nullptr;
  this->FailedModel = nullptr;
  vtkDataArray* extension = model->GetCurveIdExtension();
  const bool direct = model->GetAttributeKind() == vtkVoxelLineModel::Color;
  const bool uploaded = this->UploadArray(window, "BrickGrid", model->GetBrickGrid(), GL_R32I) &&
    this->UploadArray(window, "Bricks", model->GetBricks(), GL_R32UI) &&
    this->UploadArray(window, "VoxelStarts", model->GetVoxelStarts(),
      UnsignedFormat(model->GetVoxelStarts()->GetDataTypeSize())) &&
    this->UploadArray(window, "Segments", model->GetSegments(), GL_R32UI) &&
    this->UploadArray(window, "CurveIdExtension", extension,
      UnsignedFormat(extension ? extension->GetDataTypeSize() : 4)) &&
    this->UploadArray(window, "BrickCurves", model->GetBrickCurves(), GL_R32UI) &&
    this->UploadArray(
      window, "Attributes", model->GetAttributes(), direct ? GL_RGBA8 : GL_R8, direct ? 4 : 1) &&
    this->UploadArray(window, "Radii", model->GetRadii(), GL_R8);
  if (uploaded)
  {
    this->Model = model;
    this->ModelTime = model->GetMTime();
  }
  else
  {
    // A part of a model is of no use: others may need its memory.
    this->ReleaseBuffers(window);
    this->FailedModel = model;
    this->FailedTime = model->GetMTime();
    this->FailedError = this->Error;
  }
  return uploaded;
}

bool vtkVoxelLineShaderEngine::Internals::UploadTable(
  vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame)
{
  return this->Buffers["ColorTable"].Upload(window, frame.ColorTable.data(),
           frame.ColorTable.size(), sizeof(float), GL_RGBA32F, 4, VTK_FLOAT) ||
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
  if (!ForgetGLErrors() || !this->Color->Allocate2D(width, height, 4, VTK_UNSIGNED_CHAR) ||
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
  vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame, bool hasScene)
{
  const std::string kind = vtkVoxelLineShaderUniforms::MakeConstants(model, frame, hasScene);
  if (!this->Quad || this->QuadKind != kind)
  {
    std::string source = std::string("//VTK::System::Dec\n//VTK::Output::Dec\n") +
      vtkVoxelLineFetch + vtkVoxelLinePacking + vtkVoxelLineCapsule + vtkVoxelLineRay +
      vtkVoxelLineSegment + vtkVoxelLineHits + vtkVoxelLineShading + vtkVoxelLineLayers +
      vtkVoxelLineTraversal + vtkVoxelLinePixel + vtkVoxelLineFragment;
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

void vtkVoxelLineShaderEngine::Internals::ActivateBuffers()
{
  vtkShaderProgram* program = this->Quad->Program;
  for (auto& buffer : this->Buffers)
  {
    // The compiler may have removed what this kind of shader does not read.
    if (program->IsUniformUsed(buffer.first.c_str()))
    {
      buffer.second.Texture->Activate();
      program->SetUniformi(buffer.first.c_str(), buffer.second.Texture->GetTextureUnit());
    }
  }
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
  const vtkVoxelLineFrame& frame, vtkTextureObject* sceneDepth)
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
  if (!data.Check(window, frame) || !data.UploadModel(window, model) ||
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

    if (data.BindTargets(window) && data.PrepareQuad(window, model, frame, sceneDepth != nullptr))
    {
      if (sceneDepth)
      {
        sceneDepth->Activate();
        data.Quad->Program->SetUniformi("SceneDepth", sceneDepth->GetTextureUnit());
      }
      data.ActivateBuffers();
      vtkVoxelLineShaderUniforms::Set(data.Quad->Program, model, frame);
      if (data.Lighting.Activate(window, data.Quad->Program, frame.Light))
      {
        data.Quad->Render();
      }
      else
      {
        data.Fail("There is no memory on the graphics device for the table of the light model.");
      }
      data.Lighting.Deactivate();
      for (auto& buffer : data.Buffers)
      {
        buffer.second.Texture->Deactivate();
      }
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
  vtkIdType bytes = static_cast<vtkIdType>(12) * this->Data->Size[0] * this->Data->Size[1];
  for (const auto& buffer : this->Data->Buffers)
  {
    bytes += static_cast<vtkIdType>(buffer.second.Bytes);
  }
  return bytes;
}

void vtkVoxelLineShaderEngine::ReleaseGraphicsResources(vtkWindow* vtkNotUsed(window))
{
  this->Data->Release();
}
