// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminatedLineShader.h"

#include "vtkLineSetsShaderCode.h"
#include "vtkShaderProgram.h"

using vtkLineSetsShaderCode::HandOn;
using vtkLineSetsShaderCode::InsertBefore;

namespace
{
// What the light model's shader source asks for.
constexpr const char* Declarations = "#define Real float\n"
                                     "#define LS_OUT(T) out T\n"
                                     "#define LS_INOUT(T) inout T\n";

// VTK's shaders discard what is wholly transparent, which keeps depth tests from coming first, even
// where nothing is transparent.
constexpr const char* TransparencyTest = "if (gl_FragData[0].a <= 0.0)";

// Light on the line, in the vertex shader for each point or in the fragment shader for each pixel.
constexpr const char* LineLight =
  "  float lineTangentSize = length(lineTangentVCVSOutput);\n"
  "  vec3 lineTangent = lineTangentSize > 0.0 ? lineTangentVCVSOutput / lineTangentSize\n"
  "    : vec3(0.0);\n"
  "  beginLight(vertexVCVSOutput.xyz);\n"
  "  lineLight(vertexVCVSOutput.xyz, lineTangent, lineShines, linePower,\n"
  "    lineDiffuseVSOutput, lineSpecularVSOutput);\n";

// The lit colour takes the place of the unlit one, which is the sum of the two.
constexpr const char* LitColor = "  ambientColor += diffuseColor * lineDiffuseVSOutput +\n"
                                 "    lineSpecularColor * lineSpecularVSOutput;\n"
                                 "  diffuseColor = vec3(0.0);\n"
                                 "  //VTK::Light::Impl\n";
}

//------------------------------------------------------------------------------
std::string vtkIlluminatedLineShader::GetKey() const
{
  return this->GetSource() + (this->IsFine ? "fine" : "") + (this->IsOpaque ? "opaque" : "");
}

//------------------------------------------------------------------------------
std::string vtkIlluminatedLineShader::GetSource() const
{
  return std::string(Declarations) + Visibility +
    "const bool lineShines = " + (this->Shines ? "true" : "false") + ";\n" +
    (this->HasPowers ? "#define linePower linePowerVSOutput\n" : "uniform float linePower;\n") +
    this->Lighting;
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineShader::Insert(std::map<vtkShader::Type, vtkShader*>& shaders) const
{
  vtkShader* vertex = shaders[vtkShader::Vertex];
  vtkShader* fragment = shaders[vtkShader::Fragment];
  InsertBefore(vertex, "//VTK::Light::Dec",
    "in vec3 lineTangentMC;\n"
    "uniform mat3 lineTangentMatrix;\n");
  InsertBefore(vertex, "//VTK::Light::Impl",
    std::string(this->IsFine ? "vec3 " : "") +
      "lineTangentVCVSOutput = lineTangentMatrix * lineTangentMC;\n");
  if (this->HasPowers)
  {
    InsertBefore(vertex, "//VTK::Light::Dec",
      "in float linePowerMC;\n"
      "uniform float linePowerElsewhere;\n");
    InsertBefore(vertex, "//VTK::Light::Impl",
      std::string(this->IsFine ? "float " : "") +
        "linePowerVSOutput = linePowerMC < 0.0 ? linePowerElsewhere : linePowerMC;\n");
  }
  InsertBefore(fragment, "//VTK::Light::Dec",
    "#define LineSetsLitLine\n"
    "uniform vec3 lineSpecularColor;\n");
  if (this->IsFine)
  {
    HandOn(shaders, "vec3", "lineDiffuse");
    HandOn(shaders, "vec3", "lineSpecular");
  }
  else
  {
    HandOn(shaders, "vec3", "lineTangentVC");
    if (this->HasPowers)
    {
      HandOn(shaders, "float", "linePower");
    }
    InsertBefore(fragment, "//VTK::Light::Impl",
      "  vec3 lineDiffuseVSOutput;\n"
      "  vec3 lineSpecularVSOutput;\n");
  }
  vtkShader* lit = this->IsFine ? vertex : fragment;
  InsertBefore(lit, "//VTK::Light::Dec", this->GetSource());
  InsertBefore(lit, "//VTK::Light::Impl", LineLight);
  InsertBefore(fragment, "//VTK::Light::Impl", LitColor);
  if (this->IsOpaque)
  {
    std::string source = fragment->GetSource();
    vtkShaderProgram::Substitute(source, TransparencyTest, "if (false)");
    fragment->SetSource(source);
  }
}
