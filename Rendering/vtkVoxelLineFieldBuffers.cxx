// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineFieldBuffers.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkVoxelLineDensities.h"
#include "vtkVoxelLineGlobalLight.h"
#include "vtkVoxelLineOcclusion.h"

#include "vtkVoxelLineFields.h"

#include <new>

//------------------------------------------------------------------------------
std::string vtkVoxelLineFieldBuffers::GetSource(const vtkVoxelLineGlobalLight& light)
{
  return std::string(light.Densities ? "#define LineSetsHasDensities\n" : "") +
    (light.SphericalOcclusion ? "#define LineSetsHasOcclusion\n" : "") + vtkVoxelLineFields;
}

//------------------------------------------------------------------------------
bool vtkVoxelLineFieldBuffers::Upload(
  vtkOpenGLRenderWindow* window, const vtkVoxelLineGlobalLight& light)
{
  try
  {
    return this->UploadDensities(window, light) && this->UploadOcclusion(window, light);
  }
  catch (const std::bad_alloc&)
  {
    this->Error =
      "There is no memory for a copy of the densities of the lines. Lower the Resolution "
      "or use the native engine.";
    return false;
  }
}

//------------------------------------------------------------------------------
bool vtkVoxelLineFieldBuffers::Fits(vtkOpenGLRenderWindow* window, std::size_t values)
{
  int largest = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest);
  if (values <= static_cast<std::size_t>(largest))
  {
    return true;
  }
  this->Error = "Densities or occlusion of the lines have " + std::to_string(values) +
    " values; a texture buffer of this OpenGL holds at most " + std::to_string(largest) +
    " (GL_MAX_TEXTURE_BUFFER_SIZE). Lower the Resolution or use the native engine.";
  return false;
}

//------------------------------------------------------------------------------
bool vtkVoxelLineFieldBuffers::UploadDensities(
  vtkOpenGLRenderWindow* window, const vtkVoxelLineGlobalLight& light)
{
  if (!light.Densities || this->DensitiesTime == light.DensitiesTime)
  {
    return true;
  }
  this->DensitiesTime = 0;
  this->Starts.clear();
  std::vector<float> values;
  for (int level = 0; level < light.Densities->GetNumberOfLevels(); ++level)
  {
    vtkFloatArray* array = light.Densities->GetValues(level);
    this->Starts.push_back(static_cast<int>(values.size()));
    values.insert(
      values.end(), array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues());
    if (!this->Fits(window, values.size()))
    {
      return false;
    }
  }
  if (!this->Densities.Upload(
        window, values.data(), values.size(), sizeof(float), GL_R32F, 1, VTK_FLOAT))
  {
    this->Error = "There is no memory on the graphics device for the densities of the lines, " +
      std::to_string(sizeof(float) * values.size()) +
      " bytes. Lower the Resolution or use the native engine.";
    return false;
  }
  this->DensitiesTime = light.DensitiesTime;
  return true;
}

//------------------------------------------------------------------------------
bool vtkVoxelLineFieldBuffers::UploadOcclusion(
  vtkOpenGLRenderWindow* window, const vtkVoxelLineGlobalLight& light)
{
  if (!light.SphericalOcclusion || this->OcclusionTime == light.SphericalOcclusionTime)
  {
    return true;
  }
  this->OcclusionTime = 0;
  const std::vector<std::uint8_t>& values = light.SphericalOcclusion->GetValues();
  if (!this->Fits(window, values.size()))
  {
    return false;
  }
  if (!this->Occlusion.Upload(window, values.data(), values.size(), 1, GL_R8, 1, VTK_UNSIGNED_CHAR))
  {
    this->Error = "There is no memory on the graphics device for the occlusion of the lines, " +
      std::to_string(values.size()) + " bytes. Lower the Resolution or use the native engine.";
    return false;
  }
  this->OcclusionTime = light.SphericalOcclusionTime;
  return true;
}

//------------------------------------------------------------------------------
void vtkVoxelLineFieldBuffers::Activate(vtkShaderProgram* program)
{
  if (this->DensitiesTime > 0)
  {
    this->Densities.Activate(program, "Densities");
    if (program->IsUniformUsed("DensityStarts"))
    {
      program->SetUniform1iv(
        "DensityStarts", static_cast<int>(this->Starts.size()), this->Starts.data());
    }
  }
  if (this->OcclusionTime > 0)
  {
    this->Occlusion.Activate(program, "OcclusionOfVoxels");
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineFieldBuffers::Deactivate()
{
  this->Densities.Deactivate();
  this->Occlusion.Deactivate();
}

//------------------------------------------------------------------------------
void vtkVoxelLineFieldBuffers::Release(vtkWindow* window)
{
  this->Densities.Release(window);
  this->Occlusion.Release(window);
  this->DensitiesTime = 0;
  this->OcclusionTime = 0;
}

//------------------------------------------------------------------------------
void vtkVoxelLineFieldBuffers::Forget()
{
  this->Densities.Forget();
  this->Occlusion.Forget();
  this->DensitiesTime = 0;
  this->OcclusionTime = 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineFieldBuffers::GetNumberOfBytes() const
{
  return static_cast<vtkIdType>(
    this->Densities.GetNumberOfBytes() + this->Occlusion.GetNumberOfBytes());
}
