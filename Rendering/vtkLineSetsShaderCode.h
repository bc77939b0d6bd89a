// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Puts code into the shaders of vtkOpenGLPolyDataMapper, before its own code at a tag.
 */

#ifndef vtkLineSetsShaderCode_h
#define vtkLineSetsShaderCode_h

#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <map>
#include <string>

namespace vtkLineSetsShaderCode
{
using Shaders = std::map<vtkShader::Type, vtkShader*>;

/// Put code before what is put at a tag of a shader later on; the tag stays.
inline void InsertBefore(vtkShader* shader, const std::string& tag, const std::string& code)
{
  std::string source = shader->GetSource();
  vtkShaderProgram::Substitute(source, tag, code + tag, false);
  shader->SetSource(source);
}

/**
 * Declare a value that goes from the vertex shader to the fragment shader, NAMEVSOutput, and hand
 * it through the geometry shader, where there is one. The qualifier may be "flat" or empty.
 */
inline void HandOn(Shaders& shaders, const std::string& type, const std::string& name,
  const std::string& qualifier = "")
{
  const std::string flat = qualifier.empty() ? "" : qualifier + " ";
  const std::string before = type + " " + name + "VSOutput";
  const std::string after = type + " " + name + "GSOutput";
  InsertBefore(shaders[vtkShader::Vertex], "//VTK::Light::Dec", flat + "out " + before + ";\n");
  InsertBefore(shaders[vtkShader::Geometry], "//VTK::Light::Dec",
    flat + "in " + before + "[];\n" + flat + "out " + after + ";\n");
  InsertBefore(shaders[vtkShader::Geometry], "//VTK::Light::Impl",
    name + "GSOutput = " + name + "VSOutput[i];\n");
  InsertBefore(shaders[vtkShader::Fragment], "//VTK::Light::Dec", flat + "in " + before + ";\n");
}
}

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsShaderCode.h
