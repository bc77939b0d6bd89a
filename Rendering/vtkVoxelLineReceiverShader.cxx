// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineReceiverShader.h"

#include "vtkIlluminatedLineShader.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkShaderProgram.h"
#include "vtkVoxelLineDensities.h"
#include "vtkVoxelLineFieldBuffers.h"
#include "vtkVoxelLineLightFields.h"

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
// Surfaces are looked up below themselves by the radius of the lines, at most by so many voxels:
// the densities of a line reach no farther from it.
constexpr float DeepestSurface = 1.0f;

// Parts of the lines of VTK's fragment shaders after which, or before which, something goes.
constexpr const char* Main = "void main(";
constexpr const char* Lit = "(ambientColor + diffuse + specular, opacity);";
constexpr const char* Unlit = "(ambientColor + diffuseColor, opacity);";
constexpr const char* PhysicallyBased = "color += emissiveColor;";

// What goes there.
constexpr const char* AfterLit =
  "  gl_FragData[0].rgb *= receivedOnSurface(vertexVC.xyz, normalVCVSOutput);\n";
constexpr const char* AfterUnlit = "#ifdef LineSetsLitLine\n"
                                   "  gl_FragData[0].rgb *= receivedOnLine();\n"
                                   "#else\n"
                                   "  gl_FragData[0].rgb *= receivedOnUnlit();\n"
                                   "#endif\n";
constexpr const char* BeforePhysicallyBased =
  "color *= receivedOnSurface(vertexVC.xyz, normalVCVSOutput);\n";

// Takes the place of what vtkIlluminatedLineMapper asks.
constexpr const char* LineVisibility =
  "void beginLight(vec3 position) { receiveInView(position, vec3(0.0)); }\n"
  "float lightVisibility(int i) { return receivedPart(i); }\n";

// Around what is put in, so that it is found again between what a user has put there.
constexpr const char* Begin = "\n// Received from LineSets {\n";
constexpr const char* End = "// } Received from LineSets\n";
// Follows Begin where no user has replaced the key.
constexpr const char* Alone = "// Without a replacement by a user.\n";

// Where code goes in a user's replacement that does not hold the key, or holds it repeatedly.
enum class Otherwise
{
  Nowhere,
  Before,
  After
};

struct Part
{
  vtkShader::Type Type;
  const char* Key;
  std::string Before;
  std::string After;
  Otherwise Place;
};

constexpr std::array<std::pair<vtkShader::Type, const char*>, 6> Keys = { {
  { vtkShader::Fragment, Main },
  { vtkShader::Fragment, Lit },
  { vtkShader::Fragment, Unlit },
  { vtkShader::Fragment, PhysicallyBased },
  { vtkShader::Fragment, vtkIlluminatedLineShader::Visibility },
  { vtkShader::Vertex, vtkIlluminatedLineShader::Visibility },
} };

struct Replacement
{
  bool IsThere = false;
  std::string Code;
  bool All = false;
};

Replacement GetReplacement(
  vtkOpenGLShaderProperty* property, vtkShader::Type type, const std::string& key)
{
  for (const auto& [spec, value] : property->GetAllShaderReplacements())
  {
    if (spec.ShaderType == type && !spec.ReplaceFirst && spec.OriginalValue == key)
    {
      return { true, value.Replacement, value.ReplaceAll };
    }
  }
  return {};
}

// What a user has put there, without what was put in here.
Replacement GetUsers(Replacement present, const std::string& key)
{
  bool isAlone = false;
  for (auto begin = present.Code.find(Begin); begin != std::string::npos;
       begin = present.Code.find(Begin))
  {
    const auto end = present.Code.find(End, begin);
    if (end == std::string::npos)
    {
      break;
    }
    const auto first = begin + std::string(Begin).size();
    isAlone = isAlone || present.Code.compare(first, std::string(Alone).size(), Alone) == 0;
    present.Code.erase(begin, end + std::string(End).size() - begin);
  }
  // More than the key only where a user has changed what was put in.
  return isAlone && present.Code == key ? Replacement{} : present;
}

// Put code into a user's replacement, if there is one. Returns whether there is a place for it.
bool Compose(const Part& part, Replacement& users)
{
  const auto enclose = [&users](const std::string& code)
  { return code.empty() ? code : Begin + (users.IsThere ? "" : std::string(Alone)) + code + End; };
  const std::string before = enclose(part.Before);
  const std::string after = enclose(part.After);
  const std::string key = part.Key;
  std::string code = users.IsThere ? users.Code : key;
  const auto found = code.find(key);
  if (found != std::string::npos && code.find(key, found + 1) == std::string::npos)
  {
    code.replace(found, key.size(), before + key + after);
  }
  else if (part.Place == Otherwise::Before)
  {
    code.insert(0, before);
  }
  else
  {
    // Only after a statement.
    const auto last = code.find_last_not_of(" \t\r\n");
    if (part.Place == Otherwise::Nowhere || last == std::string::npos ||
      (code[last] != ';' && code[last] != '}'))
    {
      return false;
    }
    code += after;
  }
  users.Code = code;
  return true;
}

// The first line of a key.
std::string GetName(const std::string& key)
{
  return key.substr(0, key.find('\n'));
}

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
  this->Global.ConeStart = this->SurfaceDepth + vtkVoxelLineLightFields::ConeMargin;
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
  os << vtkVoxelLineReceiverFetch << vtkVoxelLineFieldBuffers::GetSource(this->Global)
     << vtkVoxelLineDensity << vtkVoxelLineSoftLight << vtkVoxelLineReceiver << "#endif\n";
  return os.str();
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineReceiverShader::Install(vtkShaderProperty* property)
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
  // The key itself is kept, too, so that a user's code is what remains without the rest.
  const std::string lines = source + LineVisibility + "#if 0\n";
  const char* asked = vtkIlluminatedLineShader::Visibility;
  const std::array<Part, Keys.size()> parts = { {
    { vtkShader::Fragment, Main, fragment.str(), {}, Otherwise::Nowhere },
    { vtkShader::Fragment, Lit, {}, AfterLit, Otherwise::After },
    { vtkShader::Fragment, Unlit, {}, AfterUnlit, Otherwise::After },
    { vtkShader::Fragment, PhysicallyBased, BeforePhysicallyBased, {}, Otherwise::Before },
    { vtkShader::Fragment, asked, lines, "#endif\n", Otherwise::Nowhere },
    { vtkShader::Vertex, asked, lines, "#endif\n", Otherwise::Nowhere },
  } };
  auto* shaders = vtkOpenGLShaderProperty::SafeDownCast(property);
  std::array<Replacement, Keys.size()> wanted;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const Part& part = parts[i];
    wanted[i] = GetUsers(GetReplacement(shaders, part.Type, part.Key), part.Key);
    if (!Compose(part, wanted[i]))
    {
      return "its vtkShaderProperty replaces \"" + GetName(part.Key) +
        "\" by code that does not hold this once, where light would have to be put in.";
    }
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const Replacement present = GetReplacement(shaders, parts[i].Type, parts[i].Key);
    if (!present.IsThere || present.Code != wanted[i].Code)
    {
      shaders->AddShaderReplacement(
        parts[i].Type, parts[i].Key, false, wanted[i].Code, wanted[i].All);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceiverShader::Remove(vtkShaderProperty* property) const
{
  auto* shaders = vtkOpenGLShaderProperty::SafeDownCast(property);
  const std::string code = GetReplacement(shaders, vtkShader::Fragment, Main).Code;
  if (code.find(Begin) != std::string::npos && code.find(this->Mark + "\n") == std::string::npos)
  {
    return;
  }
  for (const auto& [type, key] : Keys)
  {
    const Replacement present = GetReplacement(shaders, type, key);
    const Replacement users = GetUsers(present, key);
    if (present.IsThere && !users.IsThere)
    {
      shaders->ClearShaderReplacement(type, key, false);
    }
    else if (present.Code != users.Code)
    {
      shaders->AddShaderReplacement(type, key, false, users.Code, users.All);
    }
  }
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
