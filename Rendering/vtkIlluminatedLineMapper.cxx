// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminatedLineMapper.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIlluminatedLineShader.h"
#include "vtkIlluminatedLineVertices.h"
#include "vtkLineIllumination.h"
#include "vtkLineMerging.h"
#include "vtkLineSetsCompatibilityPrivate.h"
#include "vtkLineSetsLighting.h"
#include "vtkLineSetsLightingUniforms.h"
#include "vtkMatrix4x4.h"
#include "vtkMergedLineBuffers.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectCache.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// Vertex attributes, in data coordinates.
constexpr const char* TangentAttribute = "lineTangentMC";
constexpr const char* PowerAttribute = "linePowerMC";

// Product of an actor's matrix and the camera's view, transposed as VTK keeps it for shaders; and
// the camera's projection, alike.
void GetMatrices(
  vtkRenderer* renderer, vtkActor* actor, vtkMatrix4x4* dataToView, vtkMatrix4x4*& viewToDisplay)
{
  vtkMatrix4x4* dataToWorld;
  vtkMatrix3x3* dataToWorldNormals;
  static_cast<vtkOpenGLActor*>(actor)->GetKeyMatrices(dataToWorld, dataToWorldNormals);
  vtkMatrix4x4* worldToView;
  vtkMatrix3x3* worldToViewNormals;
  vtkMatrix4x4* worldToDisplay;
  static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, worldToView, worldToViewNormals, viewToDisplay, worldToDisplay);
  vtkMatrix4x4::Multiply4x4(dataToWorld, worldToView, dataToView);
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
  vtkMergedLineBuffers Merged;

  // Whether the lines being drawn are lit, by which shader (no key: none), and how VTK would light
  // them.
  bool IsLit = false;
  vtkIlluminatedLineShader Shader;
  std::string ShaderKey;
  // Length in data units below which nothing is told apart, and whether all segments are shorter.
  double MergeLength = 0.0;
  bool IsFine = false;
  Complexity VTKComplexity = static_cast<Complexity>(0);

  // What has been said, so that it is said once.
  std::vector<std::string> VertexWarnings;
  std::string LightWarning;
  std::string PowerWarning;
  bool HasBadPower = false;
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
void vtkIlluminatedLineMapper::SetMergeLength(double pixels)
{
  if (!std::isfinite(pixels) || pixels < 0.0)
  {
    vtkErrorMacro("MergeLength " << pixels
                                 << " is not valid: it must be a finite number of pixels, 0"
                                 << " or above. It stays " << this->MergeLength << ".");
    return;
  }
  if (this->MergeLength != pixels)
  {
    this->MergeLength = pixels;
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
void vtkIlluminatedLineMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  // What a selection draws does not count.
  if (!renderer->GetSelector())
  {
    this->NumberOfDrawnSegments = 0;
  }
  this->Superclass::RenderPiece(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  vtkOpenGLHelper& lines = this->Primitives[PrimitiveLines];
  vtkOpenGLIndexBufferObject* whole = lines.IBO;
  this->Superclass::RenderPieceDraw(renderer, actor);
  if (!renderer->GetSelector() && actor->GetProperty()->GetRepresentation() != VTK_POINTS)
  {
    this->NumberOfDrawnSegments = static_cast<vtkIdType>(lines.IBO->IndexCount / 2);
  }
  lines.IBO = whole;
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::UpdateShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& internals = *this->Internals;
  const bool isLines = &cellBO == &this->Primitives[PrimitiveLines];
  if (isLines)
  {
    this->UpdateMergeLength(renderer, actor);
  }
  this->Superclass::UpdateShaders(cellBO, renderer, actor);
  if (!isLines || !internals.IsLit || internals.MergeLength <= 0.0 || !cellBO.Program)
  {
    return;
  }
  // Colours of cells, and whatever else passes may want, are found by the number of the segment.
  const std::string source = cellBO.Program->GetFragmentShader()->GetSource();
  if (source.find("gl_PrimitiveID") == std::string::npos)
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    // Until it is drawn: RenderPieceDraw() puts the whole buffer back.
    vtkOpenGLIndexBufferObject* merged = internals.Merged.Get(
      window, this->CurrentInput, internals.MergeLength, cellBO.IBO->IndexCount);
    cellBO.IBO = merged ? merged : cellBO.IBO;
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::UpdateMergeLength(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& internals = *this->Internals;
  internals.MergeLength = 0.0;
  internals.IsFine = false;
  if (this->MergeLength <= 0.0 || renderer->GetSelector() ||
    actor->GetProperty()->GetRepresentation() == VTK_POINTS)
  {
    return;
  }
  vtkNew<vtkMatrix4x4> viewFromData;
  vtkMatrix4x4* viewToDisplay;
  GetMatrices(renderer, actor, viewFromData, viewToDisplay);
  viewFromData->Transpose();
  vtkNew<vtkMatrix4x4> clipFromView;
  vtkMatrix4x4::Transpose(viewToDisplay, clipFromView);
  int size[2];
  renderer->GetTiledSize(&size[0], &size[1]);
  const double* bounds =
    this->UseCustomBounds ? this->CustomBounds : this->CurrentInput->GetBounds();
  internals.MergeLength =
    vtkLineMerging::GetLength(this->MergeLength, bounds, viewFromData, clipFromView, size);
  internals.IsFine = internals.MergeLength > 0.0 &&
    internals.Merged.GetLongestSegment(this->CurrentInput) <= internals.MergeLength;
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
bool vtkIlluminatedLineMapper::IsOpaqueEverywhere(vtkActor* actor)
{
  // Not by the actor, who may be made to pass for opaque; textures and code of users may have any
  // opacity.
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return actor->GetProperty()->GetOpacity() >= 1.0 && !this->HasTranslucentPolygonalGeometry() &&
    !actor->GetTexture() && actor->GetProperty()->GetNumberOfTextures() == 0 &&
    shaders->GetNumberOfShaderReplacements() == 0 && !shaders->HasVertexShaderCode() &&
    !shaders->HasFragmentShaderCode() && !shaders->HasGeometryShaderCode();
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
  if (!internals.ShaderKey.empty())
  {
    complexity = internals.VTKComplexity;
  }
  bool isNeeded = this->Superclass::GetNeedToRebuildShaders(cellBO, renderer, actor);
  internals.IsLit = this->AreLinesLit(cellBO, renderer, actor);
  if (internals.IsLit)
  {
    internals.Lighting.SetRenderer(renderer);
    internals.HasBadPower =
      !internals.Lighting.SetModel(internals.Illumination, actor->GetProperty());
    internals.IsLit = !internals.Lighting.Lights.empty();
  }
  std::string key;
  if (internals.IsLit)
  {
    internals.VTKComplexity = complexity;
    complexity = static_cast<vtkInternals::Complexity>(0);
    internals.Shader.Shines = actor->GetProperty()->GetSpecular() > 0.0;
    internals.Shader.HasPowers = internals.Vertices.GetPowers() != nullptr;
    internals.Shader.IsFine = internals.IsFine;
    internals.Shader.IsOpaque = this->IsOpaqueEverywhere(actor);
    internals.Shader.Lighting = vtkLineSetsLightingUniforms::GetSource(internals.Lighting);
    key = internals.Shader.GetKey();
  }
  isNeeded |= key != internals.ShaderKey;
  internals.ShaderKey = key;
  return isNeeded;
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::ReplaceShaderLight(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  if (this->Internals->IsLit)
  {
    this->Internals->Shader.Insert(shaders);
  }
  this->Superclass::ReplaceShaderLight(shaders, renderer, actor);
  if (this->Internals->IsLit)
  {
    std::string source = shaders[vtkShader::Fragment]->GetSource();
    vtkLineSetsCompatibility::RemoveColorEncoding(source);
    shaders[vtkShader::Fragment]->SetSource(source);
  }
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

  this->WarnOnce(internals.PowerWarning,
    internals.HasBadPower ? "The property's SpecularPower is not a number from 0 on; 1 is taken."
                          : std::string());

  vtkProperty* property = actor->GetProperty();
  float specular[3];
  for (int i = 0; i < 3; ++i)
  {
    specular[i] = isActive
      ? static_cast<float>(property->GetSpecular() * property->GetSpecularColor()[i])
      : 0.0f;
  }
  if (cellBO.Program->IsUniformUsed("lineSpecularColor"))
  {
    cellBO.Program->SetUniform3f("lineSpecularColor", specular);
  }
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
  vtkNew<vtkMatrix4x4> dataToView;
  vtkMatrix4x4* viewToDisplay;
  GetMatrices(renderer, actor, dataToView, viewToDisplay);

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
  }
  else
  {
    // For the while of the call, not by the setter: the mapper is not modified.
    std::string name = vtkIlluminatedLineVertices::GetPointIdName();
    this->PointIdArrayName = &name[0];
    this->Superclass::ProcessSelectorPixelBuffers(selector, pixelOffsets, prop);
    this->PointIdArrayName = nullptr;
  }
  this->WriteProcesses(selector, pixelOffsets);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::WriteProcesses(
  vtkHardwareSelector* selector, const std::vector<unsigned int>& pixelOffsets)
{
  if (selector->GetCurrentPass() != vtkHardwareSelector::PROCESS_PASS ||
    !selector->GetUseProcessIdFromData() || !this->PopulateSelectionSettings ||
    !this->CurrentInput || !this->ProcessIdArrayName)
  {
    return;
  }
  // As the superclass does: by the point that the pixel shows, whose number in the data that is
  // drawn an earlier pass has left in the raw buffers.
  vtkDataArray* processes = this->CurrentInput->GetPointData()->GetArray(this->ProcessIdArrayName);
  const unsigned char* low = selector->GetRawPixelBuffer(vtkHardwareSelector::POINT_ID_LOW24);
  const unsigned char* high = selector->GetRawPixelBuffer(vtkHardwareSelector::POINT_ID_HIGH24);
  unsigned char* pixels = selector->GetPixelBuffer(vtkHardwareSelector::PROCESS_PASS);
  if (!processes || processes->GetDataType() != VTK_UNSIGNED_INT || !low || !pixels)
  {
    return;
  }
  for (unsigned int offset : pixelOffsets)
  {
    const vtkIdType point = low[offset] | (low[offset + 1] << 8) | (low[offset + 2] << 16) |
      ((high ? vtkIdType{ high[offset] } : vtkIdType{ 0 }) << 24);
    if (point < processes->GetNumberOfTuples())
    {
      const unsigned int value = static_cast<unsigned int>(processes->GetComponent(point, 0)) + 1;
      pixels[offset] = value & 0xff;
      pixels[offset + 1] = (value >> 8) & 0xff;
      pixels[offset + 2] = (value >> 16) & 0xff;
    }
  }
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
  this->Internals->Merged.ReleaseGraphicsResources();
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkIlluminatedLineMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkIlluminatedLineMapper::SafeDownCast(mapper))
  {
    this->SetTangentArrayName(other->TangentArrayName);
    this->SetSpecularPowerArrayName(other->SpecularPowerArrayName);
    this->SetMergeLength(other->MergeLength);
    this->SetUseCustomBounds(other->UseCustomBounds);
    this->SetCustomBounds(other->CustomBounds);
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
  os << indent << "MergeLength: " << this->MergeLength << "\n";
  os << indent << "UseCustomBounds: " << (this->UseCustomBounds ? "On" : "Off") << "\n";
  os << indent << "CustomBounds:";
  for (double bound : this->CustomBounds)
  {
    os << " " << bound;
  }
  os << "\n";
  os << indent << "NumberOfDrawnSegments: " << this->NumberOfDrawnSegments << "\n";
  os << indent << "Illumination:\n";
  this->Internals->Illumination->PrintSelf(os, indent.GetNextIndent());
}
