// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineReceiverBuffers.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkDataArray.h"
#include "vtkOpenGLState.h"
#include "vtkVoxelLineModel.h"

//------------------------------------------------------------------------------
vtkVoxelLineReceiverBuffers::vtkVoxelLineReceiverBuffers(vtkOpenGLRenderWindow* window)
  : Window(window)
{
}

//------------------------------------------------------------------------------
vtkVoxelLineReceiverBuffers::~vtkVoxelLineReceiverBuffers()
{
  this->Release();
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceiverBuffers::Release()
{
  // A window releases textures by itself before its context goes, but not buffers, which must not
  // be deleted by number in another context.
  if (!this->Window || this->Fields.IsGone() || this->BrickGrid.IsGone())
  {
    this->Fields.Forget();
    this->BrickGrid.Forget();
  }
  else if (this->ModelTime > 0)
  {
    this->Window->PushContext();
    this->Deactivate();
    this->Fields.Release(this->Window);
    this->BrickGrid.Release(this->Window);
    this->Window->PopContext();
  }
  this->ModelTime = 0;
  this->Active = false;
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineReceiverBuffers::Upload(
  vtkVoxelLineModel* model, const vtkVoxelLineGlobalLight& light)
{
  int major = 0;
  int minor = 0;
  this->Window->GetOpenGLVersion(major, minor);
  if (10 * major + minor < 32)
  {
    return "OpenGL 3.2 is needed for texture buffers.";
  }
  if (!this->Fields.Upload(this->Window, light))
  {
    return this->Fields.GetError();
  }
  if (this->ModelTime == model->GetMTime())
  {
    return {};
  }
  vtkDataArray* cells = model->GetBrickGrid();
  const auto count = static_cast<std::size_t>(cells->GetNumberOfValues());
  int largest = 0;
  this->Window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest);
  if (count > static_cast<std::size_t>(largest))
  {
    return "The model has " + std::to_string(count) +
      " bricks and empty places for them; a texture buffer of this OpenGL holds at most " +
      std::to_string(largest) + " values (GL_MAX_TEXTURE_BUFFER_SIZE). Lower the Resolution.";
  }
  if (!this->BrickGrid.Upload(
        this->Window, cells->GetVoidPointer(0), count, 4, GL_R32I, 1, cells->GetDataType()))
  {
    return "There is no memory on the graphics device for " +
      std::to_string(this->BrickGrid.GetNumberOfBytes()) + " bytes of the model.";
  }
  this->ModelTime = model->GetMTime();
  return {};
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceiverBuffers::Activate(vtkShaderProgram* program)
{
  this->Active = true;
  this->Fields.Activate(program);
  this->BrickGrid.Activate(program, "BrickGrid");
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceiverBuffers::Deactivate()
{
  if (this->Active)
  {
    this->Active = false;
    this->Fields.Deactivate();
    this->BrickGrid.Deactivate();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineReceiverBuffers::GetNumberOfBytes() const
{
  return this->Fields.GetNumberOfBytes() +
    static_cast<vtkIdType>(this->BrickGrid.GetNumberOfBytes());
}
