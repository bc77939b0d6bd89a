// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityPrograms.h"

#include "vtkOpenGLVertexArrayObject.h"

//------------------------------------------------------------------------------
void vtkFourierOpacityPrograms::Use(vtkOpenGLHelper& primitives, std::size_t key)
{
  const auto found = this->Primitives.find(&primitives);
  if (found == this->Primitives.end())
  {
    // What is in place was made for whatever was drawn before.
    this->Primitives[&primitives].Current = key;
    primitives.Program = nullptr;
    return;
  }
  Programs& programs = found->second;
  if (programs.Current == key)
  {
    return;
  }
  programs.Entries[programs.Current] = { primitives.Program, primitives.ShaderSourceTime };
  const Entry& next = programs.Entries[key];
  primitives.Program = next.Program;
  primitives.ShaderSourceTime = next.ShaderSourceTime;
  // Each program has its own places for attributes: they are all set again.
  primitives.VAO->ShaderProgramChanged();
  primitives.AttributeUpdateTime = vtkTimeStamp();
  programs.Current = key;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPrograms::ForgetOthers(vtkOpenGLHelper& primitives)
{
  this->Primitives[&primitives].Entries.clear();
}
