// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityPrograms.h"

//------------------------------------------------------------------------------
vtkFourierOpacityPrograms::~vtkFourierOpacityPrograms()
{
  vtkSmartPointer<vtkOpenGLRenderWindow> window = this->Window.GetPointer();
  if (window)
  {
    window->PushContext();
    this->Clear();
    window->PopContext();
    return;
  }
  // They went with their context, and must not be deleted by number in another one.
  for (auto& primitives : this->Primitives)
  {
    for (auto& entry : primitives.second.Entries)
    {
      if (entry.second.Vertices)
      {
        entry.second.Vertices->Register(nullptr);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPrograms::Use(
  vtkOpenGLRenderWindow* window, vtkOpenGLHelper& primitives, std::size_t key)
{
  this->Window = window;
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
  Entry& last = programs.Entries[programs.Current];
  last.Program = primitives.Program;
  last.ShaderSourceTime = primitives.ShaderSourceTime;
  last.AttributeUpdateTime = primitives.AttributeUpdateTime;
  last.Vertices = primitives.VAO;

  Entry& next = programs.Entries[key];
  if (!next.Vertices)
  {
    next.Vertices = vtkSmartPointer<vtkOpenGLVertexArrayObject>::New();
  }
  primitives.Program = next.Program;
  primitives.ShaderSourceTime = next.ShaderSourceTime;
  primitives.AttributeUpdateTime = next.AttributeUpdateTime;
  // The primitives own what is in place.
  next.Vertices->Register(nullptr);
  primitives.VAO->UnRegister(nullptr);
  primitives.VAO = next.Vertices;
  programs.Current = key;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPrograms::ForgetOthers(vtkOpenGLHelper& primitives)
{
  Programs& programs = this->Primitives[&primitives];
  for (auto& entry : programs.Entries)
  {
    entry.second.Program = nullptr;
  }
}
