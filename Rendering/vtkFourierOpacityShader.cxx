// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityShader.h"

#include "vtkFourierOpacityStage.h"
#include "vtkLineSetsShaderCode.h"

#include <string>

using vtkLineSetsShaderCode::HandOn;
using vtkLineSetsShaderCode::InsertBefore;

namespace
{
// Elements are numbers, which a float holds exactly up to 2^24; vertices without one have -1.
constexpr const char* ElementDeclarations = "in vec3 fourierElementsMC;\n"
                                            "in vec2 fourierWeightsMC;\n";

constexpr const char* Element = "fourierElementVSOutput = %E < 0 ? -1 :\n"
                                "  (fourierFirstElement + %E) >> fourierElementShift;\n";

// Opacity between the centres of elements; a vertex that belongs to none is opaque.
constexpr const char* OpacityFunction =
  "uniform samplerBuffer fourierOpacities;\n"
  "float fourierElementOpacity(int element)\n"
  "{\n"
  "  return element < 0 ? 1.0 : texelFetch(fourierOpacities,\n"
  "    (fourierFirstElement + element) >> fourierElementShift).r;\n"
  "}\n";

constexpr const char* InterpolatedOpacity =
  "fourierOpacityVSOutput = fourierElementOpacity(int(fourierElementsMC.x));\n"
  "if (fourierWeightsMC.x < 1.0)\n"
  "{\n"
  "  fourierOpacityVSOutput = fourierWeightsMC.x * fourierOpacityVSOutput +\n"
  "    fourierWeightsMC.y * fourierElementOpacity(int(fourierElementsMC.y)) +\n"
  "    (1.0 - fourierWeightsMC.x - fourierWeightsMC.y) *\n"
  "      fourierElementOpacity(int(fourierElementsMC.z));\n"
  "}\n";

// A halo leans back, the more so the farther it is from its line. fourierHalo: half the width of
// the line and the width of the halo, in pixels; depth of the halo's edge.
constexpr const char* HaloDeclarations = "in float fourierAcrossVSOutput;\n"
                                         "uniform vec3 fourierHalo;\n"
                                         "uniform vec3 fourierHaloColor;\n";

constexpr const char* Halo =
  "  float fourierMargin = 2.0 * abs(fourierAcrossVSOutput) * (fourierHalo.x + fourierHalo.y) -\n"
  "    fourierHalo.x;\n"
  "  float fourierZ = gl_FragCoord.z;\n"
  "  if (fourierMargin > 0.0)\n"
  "  {\n"
  "    fourierZ = max(fourierZ, fourierBufferDepth(min(fourierSceneDepth(fourierZ) +\n"
  "      fourierHalo.z * min(fourierMargin / fourierHalo.y, 1.0), 1.0)));\n"
  "  }\n"
  "  gl_FragDepth = fourierZ;\n";

constexpr const char* HaloColor = "(fourierMargin > 0.0 ? fourierHaloColor : gl_FragData[0].rgb)";

// Where a fragment lies across its line, from -1/2 to 1/2. Newer versions of VTK make short
// segments longer, which would let halos of one line cover each other again and again.
void InsertHalo(vtkLineSetsShaderCode::Shaders& shaders)
{
  vtkShader* geometry = shaders[vtkShader::Geometry];
  InsertBefore(geometry, "//VTK::Light::Dec", "out float fourierAcrossGSOutput;\n");
  InsertBefore(
    geometry, "//VTK::Light::Impl", "fourierAcrossGSOutput = float((j + 1) % 2) - 0.5;\n");
  std::string source = geometry->GetSource();
  vtkShaderProgram::Substitute(
    source, "screenDelta = max(0.f, screenDelta);", "screenDelta = 0.0;");
  geometry->SetSource(source);
}

std::string Replaced(std::string text, const std::string& from, const std::string& to)
{
  vtkShaderProgram::Substitute(text, from, to, true);
  return text;
}

void InsertElements(vtkLineSetsShaderCode::Shaders& shaders, const vtkFourierOpacityStage& stage,
  bool hasElements, bool isPoints)
{
  vtkShader* vertex = shaders[vtkShader::Vertex];
  InsertBefore(vertex, "//VTK::Light::Dec",
    std::string(hasElements ? ElementDeclarations : "") +
      "uniform int fourierFirstElement;\n"
      "uniform int fourierElementShift;\n");
  if (stage.NeedsElement)
  {
    const std::string own = hasElements ? "int(fourierElementsMC.x)" : "gl_VertexID";
    InsertBefore(vertex, "//VTK::Light::Impl", Replaced(Element, "%E", own));
    HandOn(shaders, "int", "fourierElement", "flat");
  }
  if (stage.NeedsOpacity)
  {
    InsertBefore(vertex, "//VTK::Light::Dec", OpacityFunction);
    InsertBefore(vertex, "//VTK::Light::Impl",
      hasElements ? InterpolatedOpacity
                  : "fourierOpacityVSOutput = fourierElementOpacity(gl_VertexID);\n");
    if (isPoints && !stage.LeastOpacity.empty())
    {
      // Beyond the far plane, so that nothing is made of it.
      InsertBefore(vertex, "//VTK::Light::Impl",
        "if (fourierOpacityVSOutput < " + stage.LeastOpacity +
          ")\n{\n  gl_Position = vec4(0.0, 0.0, 2.0, 1.0);\n}\n");
    }
    HandOn(shaders, "float", "fourierOpacity");
  }
}

// Distances from the planes are linear in clip coordinates, which are interpolated with
// perspective.
void InsertRegion(vtkLineSetsShaderCode::Shaders& shaders, int planes)
{
  HandOn(shaders, "vec4", "fourierClip");
  InsertBefore(
    shaders[vtkShader::Vertex], "//VTK::Light::Impl", "fourierClipVSOutput = gl_Position;\n");
  const std::string count = std::to_string(planes);
  InsertBefore(shaders[vtkShader::Fragment], "//VTK::Light::Dec",
    "uniform vec4 fourierRegion[" + count + "];\n");
  InsertBefore(shaders[vtkShader::Fragment], "//VTK::Color::Impl",
    "  for (int i = 0; i < " + count +
      "; ++i)\n"
      "  {\n"
      "    if (dot(fourierRegion[i], fourierClipVSOutput) < 0.0)\n    {\n      discard;\n    }\n"
      "  }\n");
}

// Where the code of a stage belongs: as early as what it needs is known.
const char* GetPlace(const vtkFourierOpacityStage& stage, bool lateOpacity)
{
  switch (stage.Kind)
  {
    case vtkFourierOpacityStage::OpaqueLayer:
    case vtkFourierOpacityStage::Colors:
    case vtkFourierOpacityStage::ColorList:
      return "//VTK::DepthPeeling::Impl";
    case vtkFourierOpacityStage::OpticalDepth:
      return lateOpacity ? "//VTK::DepthPeeling::Impl" : "//VTK::Light::Impl";
    default:
      return "//VTK::Color::Impl";
  }
}
}

//------------------------------------------------------------------------------
void vtkFourierOpacityShader::Insert(std::map<vtkShader::Type, vtkShader*>& shaders,
  const vtkFourierOpacityStage& stage, bool hasElements, bool lateOpacity, bool isPoints,
  bool hasHalo, int regionPlanes)
{
  vtkShader* vertex = shaders[vtkShader::Vertex];
  vtkShader* fragment = shaders[vtkShader::Fragment];
  std::string source = fragment->GetSource();
  vtkShaderProgram::Substitute(
    source, "//VTK::System::Dec", "//VTK::System::Dec\n" + stage.Extensions, false);
  fragment->SetSource(source);
  if (stage.NeedsImportance)
  {
    InsertBefore(vertex, "//VTK::Light::Dec", "in float fourierImportanceMC;\n");
    InsertBefore(
      vertex, "//VTK::Light::Impl", "fourierImportanceVSOutput = fourierImportanceMC;\n");
    HandOn(shaders, "float", "fourierImportance");
  }
  if (stage.NeedsElement || stage.NeedsOpacity)
  {
    InsertElements(shaders, stage, hasElements, isPoints);
  }
  if (regionPlanes > 0 && IsCutOff(stage))
  {
    InsertRegion(shaders, regionPlanes);
  }
  // Pictures that are accumulated are shifted by parts of a pixel.
  InsertBefore(vertex, "//VTK::Light::Dec", "uniform vec2 fourierShift;\n");
  InsertBefore(vertex, "//VTK::Light::Impl", "gl_Position.xy += fourierShift * gl_Position.w;\n");
  InsertBefore(
    fragment, "//VTK::Light::Dec", stage.Declarations + (hasHalo ? HaloDeclarations : ""));
  if (hasHalo)
  {
    InsertHalo(shaders);
  }

  // The opacity is that of the colour where it is known there, and else that of VTK's variable.
  const char* place = GetPlace(stage, lateOpacity);
  const bool late = std::string(place) == "//VTK::DepthPeeling::Impl";
  std::string code = Replaced(stage.Code, "%OPACITY", late ? "gl_FragData[0].a" : "opacity");
  code = Replaced(code, "%COLOR", hasHalo ? HaloColor : "gl_FragData[0].rgb");
  code = Replaced(code, "%Z", hasHalo ? "fourierZ" : "gl_FragCoord.z");
  InsertBefore(fragment, place, "  {\n" + std::string(hasHalo ? Halo : "") + code + "  }\n");
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityShader::IsCutOff(const vtkFourierOpacityStage& stage)
{
  return stage.Kind != vtkFourierOpacityStage::ImportanceSums &&
    stage.Kind != vtkFourierOpacityStage::Opacities &&
    stage.Kind != vtkFourierOpacityStage::ImportanceList;
}
