// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsActiveTextures
 * @brief   textures that programs read, from Add() to Clear()
 */

#ifndef vtkLineSetsActiveTextures_h
#define vtkLineSetsActiveTextures_h

#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <string>
#include <vector>

class vtkLineSetsActiveTextures
{
public:
  vtkLineSetsActiveTextures() = default;
  ~vtkLineSetsActiveTextures() { this->Clear(); }
  vtkLineSetsActiveTextures(const vtkLineSetsActiveTextures&) = delete;
  void operator=(const vtkLineSetsActiveTextures&) = delete;

  void Clear()
  {
    for (vtkTextureObject* texture : this->Textures)
    {
      texture->Deactivate();
    }
    this->Textures.clear();
    this->Names.clear();
  }

  void Add(const std::string& name, vtkTextureObject* texture)
  {
    if (texture && texture->GetHandle() != 0)
    {
      texture->Activate();
      this->Names.push_back(name);
      this->Textures.push_back(texture);
    }
  }

  void SetParameters(vtkShaderProgram* program) const
  {
    for (std::size_t i = 0; i < this->Names.size(); ++i)
    {
      if (program->IsUniformUsed(this->Names[i].c_str()))
      {
        program->SetUniformi(this->Names[i].c_str(), this->Textures[i]->GetTextureUnit());
      }
    }
  }

private:
  std::vector<std::string> Names;
  std::vector<vtkTextureObject*> Textures;
};

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsActiveTextures.h
