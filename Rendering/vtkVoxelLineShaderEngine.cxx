// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineShaderEngine.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkDataArray.h"
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
#include "vtkWeakPointer.h"

#include "vtkVoxelLineCapsule.h"
#include "vtkVoxelLineCount.h"
#include "vtkVoxelLineFetch.h"
#include "vtkVoxelLineFragment.h"
#include "vtkVoxelLinePacking.h"
#include "vtkVoxelLinePixel.h"
#include "vtkVoxelLineShading.h"
#include "vtkVoxelLineTraversal.h"
#include "vtkVoxelLineVertex.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace
{
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
    while (glGetError() != GL_NO_ERROR)
    {
      // Errors of others are theirs to report.
    }
    if (!this->Buffer->Upload(static_cast<const unsigned char*>(data), this->Bytes,
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
  std::map<std::string, BufferTexture> Buffers;
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

  void Release(vtkWindow* window);
  bool Check(vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame);
  bool UploadModel(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model);
  bool UploadArray(vtkOpenGLRenderWindow* window, const char* name, vtkDataArray* array,
    unsigned int format, int components = 1);
  bool UploadTable(vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame);
  bool PrepareTargets(vtkOpenGLRenderWindow* window, int width, int height);
  bool PrepareQuad(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model,
    const vtkVoxelLineFrame& frame, bool hasScene);
  void SetUniforms(vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame);
  void CountOverflows(vtkOpenGLRenderWindow* window);
};

namespace
{
// As many clipping planes as OpenGL guarantees, and lights that fit into the uniforms that
// OpenGL 3.2 guarantees.
constexpr int MaximumPlanes = 8;
constexpr int MaximumLights = 16;

/// The constants that make one kind of shader out of the common source.
std::string MakeConstants(
  vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame, bool hasScene)
{
  int faceBits = 0;
  while ((1 << faceBits) < model->GetFaceBins())
  {
    ++faceBits;
  }
  std::ostringstream os;
  const auto constant = [&os](const char* type, const char* name, int value)
  { os << "const " << type << " " << name << " = " << type << "(" << value << ");\n"; };
  constant("int", "MaximumPlanes", MaximumPlanes);
  constant("int", "MaximumLights", MaximumLights);
  constant("int", "PlaneCount", static_cast<int>(frame.ClippingPlanes.size()));
  constant("int", "LightCount", static_cast<int>(frame.Lights.size()));
  constant("int", "SegmentWords", model->GetSegmentWords());
  constant("int", "FaceBits", faceBits);
  constant("int", "InteriorBins", std::max(model->GetInteriorBins(), 1));
  constant("int", "Coloring", frame.Coloring);
  constant("bool", "HasRadii", model->GetRadii() ? 1 : 0);
  constant("bool", "IdExtension", model->GetCurveIdExtension() ? 1 : 0);
  constant("bool", "HasNaN", frame.HasNaN ? 1 : 0);
  constant("bool", "Lighting", frame.Lighting && !frame.Picking ? 1 : 0);
  constant("bool", "Picking", frame.Picking ? 1 : 0);
  constant("bool", "AllOpaque", frame.IsOpaque() ? 1 : 0);
  constant("bool", "HasScene", hasScene ? 1 : 0);
  return os.str();
}
}

void vtkVoxelLineShaderEngine::Internals::Release(vtkWindow* window)
{
  for (auto& buffer : this->Buffers)
  {
    buffer.second.Release(window);
  }
  this->Buffers.clear();
  this->Quad.reset();
  this->QuadKind.clear();
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->CountQuad.reset();
  this->CountFramebuffer->ReleaseGraphicsResources(window);
  if (this->CountQuery != 0 && window)
  {
    glDeleteQueries(1, &this->CountQuery);
  }
  this->CountQuery = 0;
  this->Color->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->Size[0] = this->Size[1] = 0;
  this->Model = nullptr;
  this->ModelTime = 0;
  this->Window = nullptr;
}

bool vtkVoxelLineShaderEngine::Internals::Check(
  vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  if (major < 3 || (major == 3 && minor < 2))
  {
    return this->Fail("OpenGL " + std::to_string(major) + "." + std::to_string(minor) +
      " has no texture buffers: the shader engine needs OpenGL 3.2; the native engine needs no more "
      "than VTK itself.");
  }
  if (frame.ClippingPlanes.size() > MaximumPlanes)
  {
    return this->Fail(std::to_string(frame.ClippingPlanes.size()) +
      " clipping planes are set, the shader engine takes at most " +
      std::to_string(MaximumPlanes) + "; the native engine takes any number.");
  }
  if (frame.Lights.size() > MaximumLights)
  {
    return this->Fail(std::to_string(frame.Lights.size()) +
      " lights are switched on, the shader engine takes at most " + std::to_string(MaximumLights) +
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
    return this->Fail("There is no memory on the graphics device for " + std::to_string(buffer.Bytes) +
      " bytes of the model (array " + name + "). Lower the Resolution or use the native engine.");
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
  this->Model = nullptr;
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
  this->Framebuffer->SetContext(window);
  this->Color->SetContext(window);
  this->Depth->SetContext(window);
  if (this->Size[0] == 0)
  {
    this->Color->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Color->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Depth->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Depth->SetMagnificationFilter(vtkTextureObject::Nearest);
    if (!this->Color->Allocate2D(width, height, 4, VTK_UNSIGNED_CHAR) ||
      !this->Depth->Allocate2D(width, height, 2, VTK_FLOAT))
    {
      return this->Fail("There is no memory on the graphics device for a picture of " +
        std::to_string(width) + " by " + std::to_string(height) + " pixels.");
    }
  }
  else
  {
    this->Color->Resize(width, height);
    this->Depth->Resize(width, height);
  }
  this->Size[0] = width;
  this->Size[1] = height;
  return true;
}

bool vtkVoxelLineShaderEngine::Internals::PrepareQuad(vtkOpenGLRenderWindow* window,
  vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame, bool hasScene)
{
  const std::string kind = MakeConstants(model, frame, hasScene);
  if (!this->Quad || this->QuadKind != kind)
  {
    std::string source = std::string("//VTK::System::Dec\n//VTK::Output::Dec\n") +
      vtkVoxelLineFetch + vtkVoxelLinePacking + vtkVoxelLineCapsule + vtkVoxelLineShading +
      vtkVoxelLineTraversal + vtkVoxelLinePixel + vtkVoxelLineFragment;
    vtkShaderProgram::Substitute(source, "//LineSets::Constants", kind);
    this->Quad.reset();
    if (!window->GetShaderCache()->ReadyShaderProgram(
          vtkVoxelLineVertex, source.c_str(), ""))
    {
      return this->Fail("The ray casting shader does not compile with this OpenGL; the native "
                        "engine needs none.");
    }
    this->Quad.reset(new vtkOpenGLQuadHelper(window, vtkVoxelLineVertex, source.c_str(), ""));
    this->QuadKind = kind;
  }
  window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  return true;
}

void vtkVoxelLineShaderEngine::Internals::SetUniforms(
  vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame)
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
  const auto set1 = [program](const char* name, float value)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniformf(name, value);
    }
  };
  const auto set3 = [program](const char* name, const glm::vec3& value)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniform3f(name, &value[0]);
    }
  };
  const float pictureSize[2] = { static_cast<float>(frame.Width), static_cast<float>(frame.Height) };
  program->SetUniform2f("PictureSize", pictureSize);
  program->SetUniform3fv("RayOrigins", 3, &frame.Origin[0][0]);
  program->SetUniform3fv("RayDirections", 3, &frame.Direction[0][0]);
  set1("NearestS", frame.NearestS);
  set1("FarthestS", frame.FarthestS);
  program->SetUniform2f("DepthZ", &frame.DepthZ[0]);
  program->SetUniform2f("DepthW", &frame.DepthW[0]);
  if (!frame.ClippingPlanes.empty())
  {
    program->SetUniform4fv(
      "Planes", static_cast<int>(frame.ClippingPlanes.size()), &frame.ClippingPlanes[0][0]);
  }
  int size[3];
  model->GetDimensions(size);
  set3("GridSize", glm::vec3(size[0], size[1], size[2]));
  model->GetBrickDimensions(size);
  set3("BrickGridSize", glm::vec3(size[0], size[1], size[2]));
  set1("Radius", frame.Radius);
  set3("AmbientColor", frame.AmbientColor);
  set3("DiffuseColor", frame.DiffuseColor);
  set3("SpecularColor", frame.SpecularColor * frame.Specular);
  set1("Ambient", frame.Ambient);
  set1("Diffuse", frame.Diffuse);
  set1("SpecularPower", frame.SpecularPower);
  set1("Opacity", frame.Opacity);
  set1("EarlyTermination", frame.EarlyTermination);
  glm::mat4 view = frame.ViewFromLocal;
  glm::mat3 normal = frame.NormalFromLocal;
  if (program->IsUniformUsed("ViewFromLocal"))
  {
    program->SetUniformMatrix4x4("ViewFromLocal", &view[0][0]);
  }
  if (program->IsUniformUsed("NormalFromLocal"))
  {
    program->SetUniformMatrix3x3("NormalFromLocal", &normal[0][0]);
  }

  const int lights = static_cast<int>(frame.Lights.size());
  if (lights == 0)
  {
    return;
  }
  std::vector<int> kinds;
  std::vector<float> directions;
  std::vector<float> positions;
  std::vector<float> colors;
  std::vector<float> attenuations;
  std::vector<float> spots;
  const auto append = [](std::vector<float>& values, const glm::vec3& v)
  { values.insert(values.end(), { v.x, v.y, v.z }); };
  for (const vtkVoxelLineLight& light : frame.Lights)
  {
    kinds.push_back(light.Kind);
    append(directions, light.Direction);
    append(positions, light.Position);
    append(colors, light.Color);
    append(attenuations, light.Attenuation);
    spots.insert(spots.end(), { light.CosConeAngle, light.Exponent });
  }
  program->SetUniform1iv("LightKind", lights, kinds.data());
  program->SetUniform3fv("LightDirection", lights, directions.data());
  program->SetUniform3fv("LightPosition", lights, positions.data());
  program->SetUniform3fv("LightColor", lights, colors.data());
  program->SetUniform3fv("LightAttenuation", lights, attenuations.data());
  program->SetUniform2fv("LightSpot", lights, spots.data());
}

void vtkVoxelLineShaderEngine::Internals::CountOverflows(vtkOpenGLRenderWindow* window)
{
  this->NumberOfOverflows = 0;
  if (!this->CountQuad)
  {
    this->CountQuad.reset(
      new vtkOpenGLQuadHelper(window, vtkVoxelLineVertex, vtkVoxelLineCount, ""));
    glGenQueries(1, &this->CountQuery);
  }
  if (!this->CountQuad->Program)
  {
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

vtkVoxelLineShaderEngine::~vtkVoxelLineShaderEngine() = default;

bool vtkVoxelLineShaderEngine::Render(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model,
  const vtkVoxelLineFrame& frame, vtkTextureObject* sceneDepth)
{
  Internals& data = *this->Data;
  data.Error.clear();
  if (data.Window != window)
  {
    data.Release(data.Window);
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

    data.Framebuffer->SetContext(window);
    data.Framebuffer->Bind();
    data.Framebuffer->AddColorAttachment(0, data.Color);
    data.Framebuffer->AddColorAttachment(1, data.Depth);
    data.Framebuffer->ActivateDrawBuffers(2);
    data.Framebuffer->Start(frame.Width, frame.Height);

    if (data.PrepareQuad(window, model, frame, sceneDepth != nullptr))
    {
      if (sceneDepth)
      {
        sceneDepth->Activate();
        data.Quad->Program->SetUniformi("SceneDepth", sceneDepth->GetTextureUnit());
      }
      data.SetUniforms(model, frame);
      data.Quad->Render();
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

void vtkVoxelLineShaderEngine::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Data->Release(window);
}
