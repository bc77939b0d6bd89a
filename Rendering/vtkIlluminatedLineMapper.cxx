// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminatedLineMapper.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIlluminatedLineVertices.h"
#include "vtkLineIllumination.h"
#include "vtkLineSetsLighting.h"
#include "vtkLineSetsLightingUniforms.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectCache.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace
{
// Vertex attributes, in data coordinates.
constexpr const char* TangentAttribute = "lineTangentMC";
constexpr const char* PowerAttribute = "linePowerMC";

// What the light model's shader source asks for.
constexpr const char* Declarations = "#define Real float\n"
                                     "#define LS_OUT(T) out T\n"
                                     "#define LS_INOUT(T) inout T\n"
                                     "in vec3 lineTangentVCVSOutput;\n";

// The lit colour takes the place of the unlit one, which is the sum of the two.
constexpr const char* LightImplementation =
  "  float lineTangentSize = length(lineTangentVCVSOutput);\n"
  "  vec3 lineTangent = lineTangentSize > 0.0 ? lineTangentVCVSOutput / lineTangentSize\n"
  "    : vec3(0.0);\n"
  "  ambientColor = lightLine(vertexVC.xyz, lineTangent, ambientColor, diffuseColor,\n"
  "    lineSpecularColor, linePower);\n"
  "  diffuseColor = vec3(0.0);\n"
  "  //VTK::Light::Impl\n";

// Put code before what the superclass will put at a place of a shader.
void InsertBefore(vtkShader* shader, const std::string& place, const std::string& code)
{
  std::string source = shader->GetSource();
  vtkShaderProgram::Substitute(source, place, code + place, false);
  shader->SetSource(source);
}
}

class vtkIlluminatedLineMapper::vtkInternals
{
public:
  using Complexity = decltype(primitiveInfo::LastLightComplexity);

  vtkSmartPointer<vtkLineIllumination> Illumination = vtkSmartPointer<vtkLineIllumination>::New();
  vtkIlluminatedLineVertices Vertices;
  vtkLineSetsLighting Lighting;
  vtkLineSetsLightingUniforms Uniforms;

  // Whether the lines being drawn are lit, by which shader source, and how VTK would light them.
  bool IsLit = false;
  std::string Source;
  Complexity VTKComplexity = static_cast<Complexity>(0);

  // What has been said, so that it is said once.
  std::vector<std::string> VertexWarnings;
  std::string LightWarning;
  bool HasFailed = false;
};

vtkStandardNewMacro(vtkIlluminatedLineMapper);

//------------------------------------------------------------------------------
vtkIlluminatedLineMapper::vtkIlluminatedLineMapper()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkIlluminatedLineMapper::~vtkIlluminatedLineMapper() = default;

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::SetIllumination(vtkLineIllumination* illumination)
{
  if (illumination != this->Internals->Illumination || !illumination)
  {
    this->Internals->Illumination =
      illumination ? illumination : vtkSmartPointer<vtkLineIllumination>::New().Get();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkLineIllumination* vtkIlluminatedLineMapper::GetIllumination()
{
  return this->Internals->Illumination;
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::SetTangentArrayName(const std::string& name)
{
  if (this->TangentArrayName != name)
  {
    this->TangentArrayName = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::SetSpecularPowerArrayName(const std::string& name)
{
  if (this->SpecularPowerArrayName != name)
  {
    this->SpecularPowerArrayName = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkIlluminatedLineMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Internals->Illumination->GetMTime());
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::UpdateVertices()
{
  vtkInternals& internals = *this->Internals;
  vtkPolyData* input = this->GetInput();
  const bool isDrawingOldData =
    internals.Vertices.IsCopied() && this->CurrentInput == internals.Vertices.GetData();
  if (!internals.Vertices.Update(input, this->TangentArrayName, this->SpecularPowerArrayName))
  {
    return;
  }
  if (isDrawingOldData)
  {
    this->CurrentInput = internals.Vertices.GetData();
  }
  const std::vector<std::string> said = internals.VertexWarnings;
  internals.VertexWarnings = internals.Vertices.GetWarnings();
  for (const std::string& warning : internals.VertexWarnings)
  {
    if (std::find(said.begin(), said.end(), warning) == said.end())
    {
      vtkWarningMacro(<< warning);
    }
  }
}

//------------------------------------------------------------------------------
vtkUnsignedCharArray* vtkIlluminatedLineMapper::MapScalars(
  vtkDataSet* input, double alpha, int& cellFlag)
{
  if (input && input == this->GetInput())
  {
    this->UpdateVertices();
    input = this->Internals->Vertices.GetData();
  }
  return this->Superclass::MapScalars(input, alpha, cellFlag);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::UpdateCameraShiftScale(vtkRenderer* renderer, vtkActor* actor)
{
  // The superclass has just brought the input up to date and uses it for the first time here.
  this->UpdateVertices();
  this->CurrentInput = this->Internals->Vertices.GetData();
  this->Superclass::UpdateCameraShiftScale(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->UpdateVertices();
  this->CurrentInput = this->Internals->Vertices.GetData();
  this->Superclass::RenderPieceStart(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  this->Internals->Uniforms.Deactivate();
  this->Superclass::RenderPieceFinish(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  // The superclass uploads these together with its own; a null array removes the attribute.
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const vtkIlluminatedLineVertices& vertices = this->Internals->Vertices;
  vtkOpenGLVertexBufferObjectCache* cache = window->GetVBOCache();
  this->VBOs->CacheDataArray(TangentAttribute, vertices.GetTangents(), cache, VTK_FLOAT);
  this->VBOs->CacheDataArray(PowerAttribute, vertices.GetPowers(), cache, VTK_FLOAT);
  this->Superclass::BuildBufferObjects(renderer, actor);
}

//------------------------------------------------------------------------------
bool vtkIlluminatedLineMapper::AreLinesLit(
  vtkOpenGLHelper& lines, vtkRenderer* renderer, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  return property->GetRepresentation() != VTK_POINTS && property->GetLighting() &&
    !renderer->GetSelector() && !this->DrawingTubes(lines, actor) &&
    this->Internals->Vertices.GetTangents();
}

//------------------------------------------------------------------------------
bool vtkIlluminatedLineMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& internals = *this->Internals;
  if (&cellBO != &this->Primitives[PrimitiveLines])
  {
    internals.IsLit = false;
    return this->Superclass::GetNeedToRebuildShaders(cellBO, renderer, actor);
  }
  // The superclass lights lines by normals, where there are some. Between its decision and the next
  // one it is made to take them for unlit, so that the light of this class meets no other.
  auto& complexity = this->PrimitiveInfo[&cellBO].LastLightComplexity;
  if (!internals.Source.empty())
  {
    complexity = internals.VTKComplexity;
  }
  bool isNeeded = this->Superclass::GetNeedToRebuildShaders(cellBO, renderer, actor);
  internals.IsLit = this->AreLinesLit(cellBO, renderer, actor);
  std::string source;
  if (internals.IsLit)
  {
    internals.Lighting.SetRenderer(renderer);
    internals.Lighting.SetModel(internals.Illumination, actor->GetProperty());
    internals.IsLit = !internals.Lighting.Lights.empty();
  }
  if (internals.IsLit)
  {
    internals.VTKComplexity = complexity;
    complexity = static_cast<vtkInternals::Complexity>(0);
    source = Declarations;
    // A constant 0 lets compilers leave out all that computes highlights.
    source += actor->GetProperty()->GetSpecular() > 0.0
      ? "uniform vec3 lineSpecularColor;\n"
      : "const vec3 lineSpecularColor = vec3(0.0);\n";
    source += internals.Vertices.GetPowers()
      ? "in float linePowerVSOutput;\n#define linePower linePowerVSOutput\n"
      : "uniform float linePower;\n";
    source += vtkLineSetsLightingUniforms::GetSource(internals.Lighting);
  }
  isNeeded |= source != internals.Source;
  internals.Source = source;
  return isNeeded;
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::ReplaceShaderLight(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  if (this->Internals->IsLit)
  {
    std::string vertexDeclarations = "in vec3 lineTangentMC;\n"
                                     "out vec3 lineTangentVCVSOutput;\n"
                                     "uniform mat3 lineTangentMatrix;\n";
    std::string vertexCode = "lineTangentVCVSOutput = lineTangentMatrix * lineTangentMC;\n";
    std::string geometryDeclarations = "in vec3 lineTangentVCVSOutput[];\n"
                                       "out vec3 lineTangentVCGSOutput;\n";
    std::string geometryCode = "lineTangentVCGSOutput = lineTangentVCVSOutput[i];\n";
    if (this->Internals->Vertices.GetPowers())
    {
      vertexDeclarations += "in float linePowerMC;\n"
                            "out float linePowerVSOutput;\n"
                            "uniform float linePowerElsewhere;\n";
      vertexCode += "  linePowerVSOutput = linePowerMC < 0.0 ? linePowerElsewhere : linePowerMC;\n";
      geometryDeclarations += "in float linePowerVSOutput[];\n"
                              "out float linePowerGSOutput;\n";
      geometryCode += "    linePowerGSOutput = linePowerVSOutput[i];\n";
    }
    InsertBefore(shaders[vtkShader::Vertex], "//VTK::Light::Dec", vertexDeclarations);
    InsertBefore(shaders[vtkShader::Vertex], "//VTK::Light::Impl", vertexCode);
    InsertBefore(shaders[vtkShader::Geometry], "//VTK::Light::Dec", geometryDeclarations);
    InsertBefore(shaders[vtkShader::Geometry], "//VTK::Light::Impl", geometryCode);
    InsertBefore(shaders[vtkShader::Fragment], "//VTK::Light::Dec", this->Internals->Source + "\n");
    InsertBefore(shaders[vtkShader::Fragment], "//VTK::Light::Impl", LightImplementation);
  }
  this->Superclass::ReplaceShaderLight(shaders, renderer, actor);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::ReplaceShaderPositionVC(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  // The superclass gives positions in view coordinates only to what it lights itself.
  auto& complexity = this->PrimitiveInfo[this->LastBoundBO].LastLightComplexity;
  const auto unlit = complexity;
  if (this->Internals->IsLit)
  {
    complexity = static_cast<vtkInternals::Complexity>(3);
  }
  this->Superclass::ReplaceShaderPositionVC(shaders, renderer, actor);
  complexity = unlit;
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::SetLightingShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetLightingShaderParameters(cellBO, renderer, actor);
  vtkInternals& internals = *this->Internals;
  if (!internals.IsLit)
  {
    return;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const bool isActive = internals.Uniforms.Activate(window, cellBO.Program, internals.Lighting);
  if (!isActive && !internals.HasFailed)
  {
    vtkErrorMacro("There is no memory on the graphics device for the table of the light model: "
                  "highlights are missing.");
  }
  internals.HasFailed = !isActive;

  const int lights = static_cast<int>(internals.Lighting.Lights.size());
  const int most = vtkLineSetsLightingUniforms::MaximumLights;
  this->WarnOnce(internals.LightWarning,
    lights > most ? std::to_string(lights) + " lights are switched on; lines are lit by at most " +
        std::to_string(most) + ": the last " + std::to_string(lights - most) + " are left out."
                  : std::string());

  vtkProperty* property = actor->GetProperty();
  float specular[3];
  for (int i = 0; i < 3; ++i)
  {
    specular[i] = static_cast<float>(property->GetSpecular() * property->GetSpecularColor()[i]);
  }
  cellBO.Program->SetUniform3f("lineSpecularColor", specular);
  cellBO.Program->SetUniformf(internals.Vertices.GetPowers() ? "linePowerElsewhere" : "linePower",
    internals.Lighting.SpecularPower);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetCameraShaderParameters(cellBO, renderer, actor);
  if (!this->Internals->IsLit)
  {
    return;
  }
  // VTK keeps these matrices transposed, as shaders take them.
  vtkMatrix4x4* dataToWorld;
  vtkMatrix3x3* dataToWorldNormals;
  static_cast<vtkOpenGLActor*>(actor)->GetKeyMatrices(dataToWorld, dataToWorldNormals);
  vtkMatrix4x4* worldToView;
  vtkMatrix3x3* worldToViewNormals;
  vtkMatrix4x4* viewToDisplay;
  vtkMatrix4x4* worldToDisplay;
  static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, worldToView, worldToViewNormals, viewToDisplay, worldToDisplay);
  vtkNew<vtkMatrix4x4> dataToView;
  vtkMatrix4x4::Multiply4x4(dataToWorld, worldToView, dataToView);

  // Tangents are directions along the line, not normals; their length does not matter.
  double largest = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    largest = std::max(largest, std::abs(dataToView->GetElement(i / 3, i % 3)));
  }
  float matrix[9];
  for (int i = 0; i < 9; ++i)
  {
    matrix[i] =
      static_cast<float>(largest > 0.0 ? dataToView->GetElement(i / 3, i % 3) / largest : 0.0);
  }
  cellBO.Program->SetUniformMatrix3x3("lineTangentMatrix", matrix);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& pixelOffsets, vtkProp* prop)
{
  if (this->PointIdArrayName || !this->Internals->Vertices.IsCopied())
  {
    this->Superclass::ProcessSelectorPixelBuffers(selector, pixelOffsets, prop);
    return;
  }
  // For the while of the call, not by the setter: the mapper is not modified.
  std::string name = vtkIlluminatedLineVertices::GetPointIdName();
  this->PointIdArrayName = &name[0];
  this->Superclass::ProcessSelectorPixelBuffers(selector, pixelOffsets, prop);
  this->PointIdArrayName = nullptr;
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::WarnOnce(std::string& last, const std::string& warning)
{
  if (last != warning)
  {
    last = warning;
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Uniforms.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkIlluminatedLineMapper::SafeDownCast(mapper))
  {
    this->SetTangentArrayName(other->TangentArrayName);
    this->SetSpecularPowerArrayName(other->SpecularPowerArrayName);
    this->SetIllumination(other->GetIllumination());
  }
  if (auto* other = vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    this->SetPointIdArrayName(other->GetPointIdArrayName());
    this->SetCellIdArrayName(other->GetCellIdArrayName());
    this->SetProcessIdArrayName(other->GetProcessIdArrayName());
    this->SetCompositeIdArrayName(other->GetCompositeIdArrayName());
  }
  // Not by the direct superclass: it does no more than this, but until VTK 9.1 it also copies
  // shader code by deprecated ways, which warn and take the place of the actor's shader property.
  this->vtkPolyDataMapper::ShallowCopy(mapper); // NOLINT(bugprone-parent-virtual-call)
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TangentArrayName: " << this->TangentArrayName << "\n";
  os << indent << "SpecularPowerArrayName: " << this->SpecularPowerArrayName << "\n";
  os << indent << "Illumination:\n";
  this->Internals->Illumination->PrintSelf(os, indent.GetNextIndent());
}
