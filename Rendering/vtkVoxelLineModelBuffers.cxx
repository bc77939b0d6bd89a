// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineModelBuffers.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkUnsignedCharArray.h"

namespace
{
/// The integer formats by size of a number.
unsigned int UnsignedFormat(vtkDataArray* array)
{
  const int size = array ? array->GetDataTypeSize() : 4;
  return size == 1 ? GL_R8UI : (size == 2 ? GL_R16UI : GL_R32UI);
}
}

//------------------------------------------------------------------------------
vtkVoxelLineModelBuffers::vtkVoxelLineModelBuffers(const std::string& prefix, bool withCurves)
  : Prefix(prefix)
  , WithCurves(withCurves)
{
}

//------------------------------------------------------------------------------
bool vtkVoxelLineModelBuffers::Upload(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model)
{
  if (this->Model == model && this->ModelTime == model->GetMTime())
  {
    return true;
  }
  if (this->FailedModel == model && this->FailedTime == model->GetMTime())
  {
    return false;
  }
  this->Model = nullptr;
  this->Retry();
  if (!this->UploadArrays(window, model))
  {
    // A part of a model is of no use: others may need its memory.
    this->Release(window);
    this->FailedModel = model;
    this->FailedTime = model->GetMTime();
    return false;
  }
  this->Model = model;
  this->ModelTime = model->GetMTime();
  return true;
}

//------------------------------------------------------------------------------
void vtkVoxelLineModelBuffers::Retry()
{
  this->FailedModel = nullptr;
  this->FailedTime = 0;
}

//------------------------------------------------------------------------------
bool vtkVoxelLineModelBuffers::UploadArrays(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model)
{
  vtkDataArray* starts = model->GetVoxelStarts();
  vtkDataArray* extension = model->GetCurveIdExtension();
  const bool direct = model->GetAttributeKind() == vtkVoxelLineModel::Color;
  return this->UploadArray(window, "BrickGrid", model->GetBrickGrid(), GL_R32I) &&
    this->UploadArray(window, "Bricks", model->GetBricks(), GL_R32UI) &&
    this->UploadArray(window, "VoxelStarts", starts, UnsignedFormat(starts)) &&
    this->UploadArray(window, "Segments", model->GetSegments(), GL_R32UI) &&
    this->UploadArray(
      window, "Attributes", model->GetAttributes(), direct ? GL_RGBA8 : GL_R8, direct ? 4 : 1) &&
    this->UploadArray(window, "Radii", model->GetRadii(), GL_R8) &&
    (!this->WithCurves ||
      (this->UploadArray(window, "CurveIdExtension", extension, UnsignedFormat(extension)) &&
        this->UploadArray(window, "BrickCurves", model->GetBrickCurves(), GL_R32UI)));
}

//------------------------------------------------------------------------------
bool vtkVoxelLineModelBuffers::UploadArray(vtkOpenGLRenderWindow* window, const char* name,
  vtkDataArray* array, unsigned int format, int components)
{
  // A sampler must have a buffer even where the shader never reads it.
  static const unsigned char nothing[16] = { 0 };
  const std::size_t values =
    array ? static_cast<std::size_t>(array->GetNumberOfValues()) / components : 0;
  int largest = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest);
  if (values > static_cast<std::size_t>(largest))
  {
    this->Error = "The model's array " + std::string(name) + " has " + std::to_string(values) +
      " values; a texture buffer of this OpenGL holds at most " + std::to_string(largest) +
      " (GL_MAX_TEXTURE_BUFFER_SIZE). Lower the Resolution or use the native engine.";
    return false;
  }
  const int valueSize = array ? array->GetDataTypeSize() : 4;
  const int type = array ? array->GetDataType() : VTK_UNSIGNED_INT;
  vtkLineSetsBufferTexture& buffer = this->Buffers[this->Prefix + name];
  if (!buffer.Upload(window, values ? array->GetVoidPointer(0) : nothing, values ? values : 1,
        valueSize, format, components, type))
  {
    this->Error = "There is no memory on the graphics device for " +
      std::to_string(buffer.GetNumberOfBytes()) + " bytes of the model (array " + name +
      "). Lower the Resolution or use the native engine.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkVoxelLineModelBuffers::Activate(vtkShaderProgram* program)
{
  for (auto& [name, buffer] : this->Buffers)
  {
    buffer.Activate(program, name.c_str());
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineModelBuffers::Deactivate()
{
  for (auto& [name, buffer] : this->Buffers)
  {
    buffer.Deactivate();
  }
}

//------------------------------------------------------------------------------
bool vtkVoxelLineModelBuffers::IsGone() const
{
  return !this->Buffers.empty() && this->Buffers.begin()->second.IsGone();
}

//------------------------------------------------------------------------------
void vtkVoxelLineModelBuffers::Release(vtkWindow* window)
{
  for (auto& [name, buffer] : this->Buffers)
  {
    buffer.Release(window);
  }
  this->Buffers.clear();
  this->Model = nullptr;
  this->ModelTime = 0;
}

//------------------------------------------------------------------------------
void vtkVoxelLineModelBuffers::Forget()
{
  for (auto& [name, buffer] : this->Buffers)
  {
    buffer.Forget();
  }
  this->Buffers.clear();
  this->Model = nullptr;
  this->ModelTime = 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineModelBuffers::GetNumberOfBytes() const
{
  vtkIdType bytes = 0;
  for (const auto& [name, buffer] : this->Buffers)
  {
    bytes += static_cast<vtkIdType>(buffer.GetNumberOfBytes());
  }
  return bytes;
}
