// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineReceiverShader.h"

#include "vtkIlluminatedLineShader.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkShaderProgram.h"
#include "vtkVoxelLineDensities.h"

#include "vtkVoxelLineDensity.h"
#include "vtkVoxelLineReceiver.h"
#include "vtkVoxelLineReceiverFetch.h"
#include "vtkVoxelLineReceiverFragment.h"
#include "vtkVoxelLineSoftLight.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

namespace
{
// As in vtkVoxelLineLightFields: cones begin so far outside a tube.
constexpr float ConeMargin = 0.75f;

// Surfaces are looked up below themselves by the radius of the lines, at most by so many voxels:
// the densities of a line reach no farther from it.
constexpr float DeepestSurface = 1.0f;

// Parts of the lines of VTK's fragment shaders after which, or before which, something goes.
constexpr const char* Main = "void main(";
constexpr const char* Lit = "(ambientColor + diffuse + specular, opacity);";
constexpr const char* Unlit = "(ambientColor + diffuseColor, opacity);";
constexpr const char* PhysicallyBased = "color += emissiveColor;";
constexpr std::array<const char*, 4> FragmentKeys = { Main, Lit, Unlit, PhysicallyBased };

// With what they are replaced.
constexpr const char* AfterLit =
  "\n  gl_FragData[0].rgb *= receivedOnSurface(vertexVC.xyz, normalVCVSOutput);\n";
constexpr const char* AfterUnlit = "\n"
                                   "#ifdef LineSetsLitLine\n"
                                   "  gl_FragData[0].rgb *= receivedOnLine();\n"
                                   "#else\n"
                                   "  gl_FragData[0].rgb *= receivedOnUnlit();\n"
                                   "#endif\n";
constexpr const char* BeforePhysicallyBased =
  "color *= receivedOnSurface(vertexVC.xyz, normalVCVSOutput);\n  ";

// Takes the place of what vtkIlluminatedLineMapper asks.
constexpr const char* LineVisibility =
  "void beginLight(vec3 position) { receiveInView(position, vec3(0.0)); }\n"
  "float lightVisibility(int i) { return receivedPart(i); }\n";

glm::dmat4 FromRows(const double rows[16])
{
  glm::dmat4 matrix;
  for (int i = 0; i < 16; ++i)
  {
    matrix[i % 4][i / 4] = rows[i];
  }
  return matrix;
}

glm::dmat4 GetDataFromLocal(const vtkVoxelLineFrameBuilder::Grid& grid)
{
  glm::dmat4 matrix(grid.VoxelSize);
  matrix[3] = glm::dvec4(grid.Origin[0], grid.Origin[1], grid.Origin[2], 1.0);
  return matrix;
}

glm::dmat4 GetClipFromWindow(const int viewport[4])
{
  glm::dmat4 matrix(1.0);
  for (int i = 0; i < 3; ++i)
  {
    const double size = i < 2 ? viewport[2 + i] : 1.0;
    const double origin = i < 2 ? viewport[i] : 0.0;
    matrix[i][i] = 2.0 / size;
    matrix[3][i] = -1.0 - 2.0 * origin / size;
  }
  return matrix;
}

// Share of each light in the light of all.
std::vector<float> GetWeights(const std::vector<vtkLineSetsLight>& lights)
{
  std::vector<float> weights;
  float sum = 0.0f;
  for (const vtkLineSetsLight& light : lights)
  {
    weights.push_back(std::max(light.Color.x + light.Color.y + light.Color.z, 0.0f));
    sum += weights.back();
  }
  const float even = 1.0f / static_cast<float>(std::max<std::size_t>(weights.size(), 1));
  for (float& weight : weights)
  {
    weight = sum > 0.0f ? weight / sum : even;
  }
  return weights;
}
}

//------------------------------------------------------------------------------
vtkVoxelLineReceiverShader::vtkVoxelLineReceiverShader(vtkMTimeType number)
  // A uniform that all of the code reads.
  : Mark("GridSize" + std::to_string(number))
{
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceiverShader::SetFrame(const vtkVoxelLineFrame& frame,
  const vtkVoxelLineFrameBuilder::View& view, const vtkVoxelLineFrameBuilder::Grid& grid,
  const int viewport[4])
{
  this->Global = frame.Global;
  // Engines need no lights where there are no shadows.
  this->Global.Lights.resize(
    std::max<std::size_t>(frame.Light.Lights.size(), 1), glm::vec4(0.0f, 0.0f, 0.0f, -1.0f));
  this->Weights = GetWeights(frame.Light.Lights);
  this->Weights.resize(this->Global.Lights.size(), 1.0f);
  this->DensityLevels = frame.Global.Densities ? frame.Global.Densities->GetNumberOfLevels() : 0;
  this->SurfaceDepth = std::min(frame.Radius, DeepestSurface);
  this->Global.ConeStart = this->SurfaceDepth + ConeMargin;
  this->GridSize = glm::vec3(grid.Dimensions[0], grid.Dimensions[1], grid.Dimensions[2]);

  // First the two that may hold large opposite translations, then the small scale.
  const glm::dmat4 viewFromLocal =
    (FromRows(view.ViewFromWorld) * FromRows(view.WorldFromData)) * GetDataFromLocal(grid);
  const glm::dmat4 localFromView = glm::inverse(viewFromLocal);
  this->LocalFromView = glm::mat4(localFromView);
  this->LocalNormalFromView = glm::mat3(glm::transpose(glm::dmat3(viewFromLocal)));
  this->LocalFromWindow = glm::mat4(
    localFromView * glm::inverse(FromRows(view.ClipFromView)) * GetClipFromWindow(viewport));
  this->ViewerDistant = frame.Light.ParallelView ? 1.0f : 0.0f;
  this->LocalViewer = glm::vec3(localFromView *
    (frame.Light.ParallelView ? glm::dvec4(0.0, 0.0, 1.0, 0.0) : glm::dvec4(0.0, 0.0, 0.0, 1.0)));
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineReceiverShader::GetSource() const
{
  std::ostringstream os;
  os << "#ifndef LineSetsReceiver\n"
        "#define LineSetsReceiver\n"
        "#define Real float\n"
        "#define LS_OUT(T) out T\n"
        "#define LS_INOUT(T) inout T\n"
     << "#define GridSize " << this->Mark << "\n";
  const auto constant = [&os](const char* name, std::size_t value)
  { os << "const int " << name << " = " << value << ";\n"; };
  constant("Shadows", static_cast<std::size_t>(this->Global.Shadows));
  constant("Occlusion", static_cast<std::size_t>(this->Global.Occlusion));
  constant("DensityLevels", static_cast<std::size_t>(this->DensityLevels));
  constant("ReceivedLights", this->Global.Lights.size());
  os << vtkVoxelLineReceiverFetch << vtkVoxelLineDensity << vtkVoxelLineSoftLight
     << vtkVoxelLineReceiver << "#endif\n";
  return os.str();
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceiverShader::Install(vtkShaderProperty* property)
{
  const std::string source = this->GetSource();
  std::ostringstream fragment;
  fragment << source << vtkVoxelLineReceiverFragment;
  for (std::size_t i = 0; this->Global.Shadows != 0 && i < this->Weights.size(); ++i)
  {
    fragment << "#ifndef LineSetsLitLine\n"
             << "vec3 receivedLight" << i << "(vec3 position, vec3 normal)\n{\n"
             << "  receiveInView(position, normal);\n  receiveLights();\n"
             << "  return lightColor" << i << " * ReceivedParts[" << i << "];\n}\n"
             << "#define lightColor" << i << " receivedLight" << i
             << "(vertexVC.xyz, normalVCVSOutput)\n"
             << "#endif\n";
  }
  fragment << Main;

  const std::string lines = source + LineVisibility;
  const std::array<std::pair<std::string, std::string>, 5> fragmentCode = {
    { { Main, fragment.str() }, { Lit, std::string(Lit) + AfterLit },
      { Unlit, std::string(Unlit) + AfterUnlit },
      { PhysicallyBased, std::string(BeforePhysicallyBased) + PhysicallyBased },
      { vtkIlluminatedLineShader::Visibility, lines } }
  };
  auto* shaders = vtkOpenGLShaderProperty::SafeDownCast(property);
  const auto isThere = [shaders](
                         vtkShader::Type type, const std::string& key, const std::string& code)
  {
    for (const auto& [spec, value] : shaders->GetAllShaderReplacements())
    {
      if (spec.ShaderType == type && !spec.ReplaceFirst && spec.OriginalValue == key)
      {
        return value.Replacement == code;
      }
    }
    return false;
  };
  for (const auto& [key, code] : fragmentCode)
  {
    if (!isThere(vtkShader::Fragment, key, code))
    {
      shaders->AddFragmentShaderReplacement(key, false, code, false);
    }
  }
  if (!isThere(vtkShader::Vertex, vtkIlluminatedLineShader::Visibility, lines))
  {
    shaders->AddVertexShaderReplacement(vtkIlluminatedLineShader::Visibility, false, lines, false);
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceiverShader::Remove(vtkShaderProperty* property)
{
  for (const char* key : FragmentKeys)
  {
    property->ClearFragmentShaderReplacement(key, false);
  }
  property->ClearFragmentShaderReplacement(vtkIlluminatedLineShader::Visibility, false);
  property->ClearVertexShaderReplacement(vtkIlluminatedLineShader::Visibility, false);
}

//------------------------------------------------------------------------------
bool vtkVoxelLineReceiverShader::IsUsed(vtkShaderProgram* program) const
{
  return program && program->IsUniformUsed(this->Mark.c_str());
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceiverShader::SetUniforms(vtkShaderProgram* program) const
{
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
  const auto set4x4 = [program](const char* name, glm::mat4 value)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniformMatrix4x4(name, &value[0][0]);
    }
  };
  set3(this->Mark.c_str(), this->GridSize);
  // Bricks of 4 voxels.
  set3("BrickGridSize", glm::ceil(0.25f * this->GridSize));
  const int lights = static_cast<int>(this->Global.Lights.size());
  if (program->IsUniformUsed("LocalLights"))
  {
    program->SetUniform4fv("LocalLights", lights, &this->Global.Lights[0][0]);
  }
  if (program->IsUniformUsed("LightWeights"))
  {
    program->SetUniform1fv("LightWeights", lights, this->Weights.data());
  }
  set1("ConeSpread", this->Global.ConeSpread);
  set1("ConeStart", this->Global.ConeStart);
  set1("SurfaceDepth", this->SurfaceDepth);
  set1("OcclusionRadius", this->Global.OcclusionRadius);
  set1("OcclusionStrength", this->Global.OcclusionStrength);
  set1("Extinction", this->Global.Extinction);
  if (program->IsUniformUsed("OcclusionSamples"))
  {
    program->SetUniformi("OcclusionSamples", this->Global.OcclusionSamples);
  }
  set4x4("LocalFromView", this->LocalFromView);
  set4x4("LocalFromWindow", this->LocalFromWindow);
  if (program->IsUniformUsed("LocalNormalFromView"))
  {
    glm::mat3 matrix = this->LocalNormalFromView;
    program->SetUniformMatrix3x3("LocalNormalFromView", &matrix[0][0]);
  }
  set3("LocalViewer", this->LocalViewer);
  set1("ViewerDistant", this->ViewerDistant);
}
