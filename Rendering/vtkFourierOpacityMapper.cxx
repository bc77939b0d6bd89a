// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityMapper.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkFourierOpacityElements.h"
#include "vtkFourierOpacityPainter.h"
#include "vtkFourierOpacityPrograms.h"
#include "vtkFourierOpacityShader.h"
#include "vtkFourierOpacityStage.h"
#include "vtkFourierOpacityVertices.h"
#include "vtkIlluminatedLineVertices.h"
#include "vtkLineSetsCheckedValuePrivate.h"
#include "vtkLineSetsFrameCounter.h"
#include "vtkLineSetsLayer.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpacityOptimization.h"
#include "vtkOpacitySegments.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObjectCache.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <vector>

class vtkFourierOpacityMapper::vtkInternals
{
public:
  vtkSmartPointer<vtkOpacityOptimization> Optimization =
    vtkSmartPointer<vtkOpacityOptimization>::New();
  vtkFourierOpacityVertices Vertices;
  bool IsRendering = false;
  // What is drawn: null for what vtkIlluminatedLineMapper draws.
  const vtkFourierOpacityStage* Stage = nullptr;
  vtkFourierOpacityPrograms Programs;

  // By itself.
  std::shared_ptr<vtkFourierOpacityPainter> Painter = std::make_shared<vtkFourierOpacityPainter>();
  // That of the last picture: the mapper's own or a pass's.
  std::weak_ptr<vtkFourierOpacityPainter> SelectionPainter;
  vtkLineSetsLayer Layer;
  vtkLineSetsFrameCounter Frames;
  vtkIdType Frame = -1;
  const vtkActor* LastActor = nullptr; ///< compared, never followed

  // What has been said, so that it is said once.
  std::vector<std::string> Said;
  std::string Error;
  std::string Warning;
};

vtkStandardNewMacro(vtkFourierOpacityMapper);

namespace
{
// Values of the points of a copy in which points of the input are repeated.
vtkSmartPointer<vtkFloatArray> Repeat(vtkFloatArray* values, vtkPolyData* drawn)
{
  vtkDataArray* ids = drawn->GetPointData()->GetArray(vtkIlluminatedLineVertices::GetPointIdName());
  if (!values || !ids)
  {
    return values;
  }
  const vtkIdType count = drawn->GetNumberOfPoints();
  auto repeated = vtkSmartPointer<vtkFloatArray>::New();
  repeated->SetNumberOfComponents(values->GetNumberOfComponents());
  repeated->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    repeated->SetTuple(i, static_cast<vtkIdType>(ids->GetComponent(i, 0)), values);
  }
  return repeated;
}

// A flag that is set while this lives.
struct Flag
{
  explicit Flag(bool& flag)
    : Place(flag)
    , Old(flag)
  {
    flag = true;
  }
  ~Flag() { this->Place = this->Old; }
  Flag(const Flag&) = delete;
  void operator=(const Flag&) = delete;

  bool& Place;
  const bool Old;
};

// Whether the opacity of a fragment is known only with its colour.
bool HasLateOpacity(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return actor->GetTexture() || actor->GetProperty()->GetNumberOfTextures() > 0 ||
    shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasFragmentShaderCode();
}
}

//------------------------------------------------------------------------------
vtkFourierOpacityMapper::vtkFourierOpacityMapper()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkFourierOpacityMapper::~vtkFourierOpacityMapper() = default;

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetOptimization(vtkOpacityOptimization* optimization)
{
  if (optimization != this->Internals->Optimization || !optimization)
  {
    this->Internals->Optimization =
      optimization ? optimization : vtkSmartPointer<vtkOpacityOptimization>::New().Get();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkOpacityOptimization* vtkFourierOpacityMapper::GetOptimization()
{
  return this->Internals->Optimization;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetImportanceArrayName(const std::string& name)
{
  if (this->ImportanceArrayName != name)
  {
    this->ImportanceArrayName = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetImportanceArrayAssociation(int association)
{
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    association != vtkDataObject::FIELD_ASSOCIATION_CELLS &&
    association != vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
  {
    vtkErrorMacro("ImportanceArrayAssociation "
      << association << " is not valid: it must be that of points ("
      << vtkDataObject::FIELD_ASSOCIATION_POINTS << "), of cells ("
      << vtkDataObject::FIELD_ASSOCIATION_CELLS << ") or of points and else cells ("
      << vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS << "). It stays "
      << this->ImportanceArrayAssociation << ".");
    return;
  }
  if (this->ImportanceArrayAssociation != association)
  {
    this->ImportanceArrayAssociation = association;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetImportanceRange(double low, double high)
{
  if (!std::isfinite(low) || !std::isfinite(high))
  {
    vtkErrorMacro("ImportanceRange (" << low << ", " << high
                                      << ") is not valid: it must be two finite numbers, the first "
                                         "above the second for the range of the array. It stays ("
                                      << this->ImportanceRange[0] << ", "
                                      << this->ImportanceRange[1] << ").");
    return;
  }
  if (this->ImportanceRange[0] != low || this->ImportanceRange[1] != high)
  {
    this->ImportanceRange[0] = low;
    this->ImportanceRange[1] = high;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetNumberOfLineSegments(int number)
{
  vtkLineSetsSetInRange(this, "NumberOfLineSegments", this->NumberOfLineSegments, number, 0,
    int{ vtkOpacitySegments::LargestNumberOfSegments });
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetNumberOfPatches(int number)
{
  vtkLineSetsSetInRange(this, "NumberOfPatches", this->NumberOfPatches, number, 1,
    int{ vtkOpacitySegments::LargestNumberOfSegments });
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetRegion(const double region[6])
{
  vtkLineSetsSetRegion(this, this->Region, region);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::ForgetOpacities()
{
  this->Internals->Painter->ForgetOpacities();
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityMapper::GetNumberOfBytes()
{
  return this->Internals->Painter->GetNumberOfBytes();
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityMapper::GetNumberOfSumBytes()
{
  return this->Internals->Painter->GetNumberOfSumBytes();
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityMapper::GetNumberOfFragments()
{
  return this->Internals->Painter->GetNumberOfFragments();
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityMapper::GetNumberOfDroppedFragments()
{
  return this->Internals->Painter->GetNumberOfDroppedFragments();
}

//------------------------------------------------------------------------------
double vtkFourierOpacityMapper::GetMeanDepthComplexity()
{
  return this->Internals->Painter->GetMeanDepthComplexity();
}

//------------------------------------------------------------------------------
int vtkFourierOpacityMapper::GetNumberOfAccumulatedPictures()
{
  return this->Internals->Painter->GetNumberOfAccumulatedPictures();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkFourierOpacityMapper::GetMTime()
{
  // A picture depends on the optimization, but none of the buffers does.
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Internals->IsRendering ? time
                                      : std::max(time, this->Internals->Optimization->GetMTime());
}

//------------------------------------------------------------------------------
vtkFourierOpacityGroup vtkFourierOpacityMapper::UpdateElements()
{
  vtkInternals& internals = *this->Internals;
  vtkFourierOpacityGroup group;
  if (!this->Static)
  {
    this->Update();
  }
  vtkPolyData* input = this->GetInput();
  if (!input)
  {
    return group;
  }
  vtkFourierOpacityVertices::Settings settings;
  settings.ArrayName = this->ImportanceArrayName;
  settings.Association = this->ImportanceArrayAssociation;
  settings.Range[0] = this->ImportanceRange[0];
  settings.Range[1] = this->ImportanceRange[1];
  settings.NumberOfLineSegments = this->NumberOfLineSegments;
  settings.NumberOfPatches = this->NumberOfPatches;
  if (internals.Vertices.Update(input, settings))
  {
    const std::vector<std::string> said = internals.Said;
    internals.Said = internals.Vertices.GetWarnings();
    for (const std::string& warning : internals.Said)
    {
      if (std::find(said.begin(), said.end(), warning) == said.end())
      {
        vtkWarningMacro(<< warning);
      }
    }
  }
  group.BuildTime = internals.Vertices.GetBuildTime();
  group.Count = internals.Vertices.GetNumberOfElements();
  group.Neighbors = internals.Vertices.GetNeighbors();
  return group;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::RenderStage(
  vtkRenderer* renderer, vtkActor* actor, const vtkFourierOpacityStage& stage, bool byActor)
{
  this->Internals->Stage = &stage;
  if (byActor)
  {
    actor->RenderTranslucentPolygonalGeometry(renderer);
  }
  else
  {
    this->RenderPiece(renderer, actor);
  }
  this->Internals->Stage = nullptr;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& internals = *this->Internals;
  const Flag rendering(internals.IsRendering);
  if (!internals.Stage && !renderer->GetSelector())
  {
    this->RenderAlone(renderer, actor);
    return;
  }
  if (!internals.Stage)
  {
    this->RenderSelection(renderer, actor);
    return;
  }
  // The actor turns off depth writing for what is translucent.
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState::ScopedglDepthMask mask(window->GetState());
  window->GetState()->vtkglDepthMask(internals.Stage->WritesDepth ? 1 : 0);
  this->Superclass::RenderPiece(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetSelectionPainter(
  const std::shared_ptr<vtkFourierOpacityPainter>& painter)
{
  this->Internals->SelectionPainter = painter;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::RenderSelection(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& internals = *this->Internals;
  const vtkFourierOpacityGroup elements = this->UpdateElements();
  vtkFourierOpacityStage stage;
  const std::shared_ptr<vtkFourierOpacityPainter> painter = internals.SelectionPainter.lock();
  const bool known = painter && painter->BeginSelection(renderer, { actor, this }, elements, stage);
  internals.Stage = known ? &stage : nullptr;
  this->Superclass::RenderPiece(renderer, actor);
  internals.Stage = nullptr;
  if (known)
  {
    painter->EndSelection();
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::RenderAlone(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& internals = *this->Internals;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->GetInput() && this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro("No input!");
    return;
  }
  // Depth peeling draws again what the frame has already.
  const vtkIdType frame = internals.Frames.GetFrame(renderer);
  std::string error;
  if (frame != internals.Frame || actor != internals.LastActor || !internals.Layer.HasPicture())
  {
    std::string warning;
    error = internals.Painter->Draw(
      renderer, { { actor, this } }, internals.Optimization,
      [&](const vtkFourierOpacityPainter::Item& item, const vtkFourierOpacityStage& stage)
      { item.Mapper->RenderStage(renderer, item.Actor, stage, false); },
      vtkFourierOpacityPainter::Picture, warning);
    if (!warning.empty() && warning != internals.Warning)
    {
      vtkWarningMacro(<< warning);
    }
    internals.Warning = warning;
    internals.SelectionPainter = internals.Painter;
    internals.Layer.SetTextures(internals.Painter->GetColor(), internals.Painter->GetDepth());
    internals.Frame = frame;
    internals.LastActor = actor;
  }
  if (error.empty())
  {
    int viewport[4];
    window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
    error = internals.Layer.Draw(window, this, actor, viewport[0], viewport[1]);
  }
  if (!error.empty() && error != internals.Error)
  {
    vtkErrorMacro(<< error);
  }
  internals.Error = error;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLVertexBufferObjectCache* cache = window->GetVBOCache();
  const vtkFourierOpacityVertices& vertices = this->Internals->Vertices;
  const auto add = [&](const char* name, vtkFloatArray* values)
  { this->VBOs->CacheDataArray(name, Repeat(values, this->CurrentInput), cache, VTK_FLOAT); };
  add(vtkFourierOpacityShader::ImportanceAttribute, vertices.GetImportance());
  add(vtkFourierOpacityShader::ElementsAttribute, vertices.GetElements());
  add(vtkFourierOpacityShader::WeightsAttribute, vertices.GetWeights());
  this->Superclass::BuildBufferObjects(renderer, actor);
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityMapper::HasHalo(vtkActor* actor)
{
  return this->Internals->Stage && this->Internals->Stage->HaloWidth > 0.0 &&
    this->LastBoundBO == &this->Primitives[PrimitiveLines] &&
    actor->GetProperty()->GetRepresentation() != VTK_POINTS &&
    !actor->GetProperty()->GetRenderLinesAsTubes();
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityMapper::HaveWideLines(vtkRenderer* renderer, vtkActor* actor)
{
  // Widths that the property does not tell are those of the geometry shader.
  return this->HasHalo(actor) || this->HasReducedLines(actor) ||
    this->Superclass::HaveWideLines(renderer, actor);
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  const bool isKnown = cellBO.Program != nullptr;
  const bool isNeeded = this->Superclass::GetNeedToRebuildShaders(cellBO, renderer, actor);
  if (isKnown && isNeeded)
  {
    // Something has changed that other stages depend on as well, and that is told once only.
    this->Internals->Programs.ForgetOthers(cellBO);
  }
  return isNeeded || !isKnown;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::UpdateShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  const vtkFourierOpacityStage* stage = this->Internals->Stage;
  this->LastBoundBO = &cellBO;
  std::size_t key = 0;
  if (stage)
  {
    // What else the shaders of a stage depend on.
    const std::size_t details = 1 + (HasLateOpacity(actor) ? 2 : 0) +
      (this->HaveWideLines(renderer, actor) ? 4 : 0) +
      (this->Internals->Vertices.GetElements() ? 8 : 0) +
      16 * static_cast<std::size_t>(this->GetNumberOfRegionPlanes());
    key = stage->Key ^ (details << 56);
  }
  this->Internals->Programs.Use(cellBO, key);
  this->Superclass::UpdateShaders(cellBO, renderer, actor);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  if (this->Internals->Stage)
  {
    vtkFourierOpacityShader::Insert(shaders, *this->Internals->Stage,
      this->Internals->Vertices.GetElements() != nullptr, HasLateOpacity(actor),
      this->IsOfPoints(*this->LastBoundBO, actor), this->HasHalo(actor),
      this->GetNumberOfRegionPlanes());
  }
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::ReplaceShaderRenderPass(std::map<vtkShader::Type, vtkShader*> shaders,
  vtkRenderer* renderer, vtkActor* actor, bool prePass)
{
  // Stages are drawn to the painter's own textures; passes get the layer.
  if (!this->Internals->Stage)
  {
    this->Superclass::ReplaceShaderRenderPass(shaders, renderer, actor, prePass);
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(cellBO, renderer, actor);
  if (this->Internals->Stage && this->Internals->Stage->SetParameters)
  {
    this->Internals->Stage->SetParameters(cellBO.Program);
  }
  if (this->Internals->Stage && cellBO.Program->IsUniformUsed("fourierCoverage"))
  {
    cellBO.Program->SetUniformf("fourierCoverage", this->GetCoverage(cellBO, actor));
  }
  if (this->Internals->Stage && this->GetNumberOfRegionPlanes() > 0 &&
    vtkFourierOpacityShader::IsCutOff(*this->Internals->Stage))
  {
    this->SetRegionParameters(cellBO.Program, renderer);
  }
  if (this->HasHalo(actor))
  {
    this->SetHaloParameters(cellBO.Program, renderer, actor);
  }
  else if (this->HasReducedLines(actor))
  {
    this->SetLineWidth(
      cellBO.Program, renderer, this->GetReducedSize(actor->GetProperty()->GetLineWidth()));
  }
}

//------------------------------------------------------------------------------
int vtkFourierOpacityMapper::GetNumberOfRegionPlanes() const
{
  return static_cast<int>(
    std::count_if(this->Region, this->Region + 6, [](double side) { return std::isfinite(side); }));
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetRegionParameters(vtkShaderProgram* program, vtkRenderer* renderer)
{
  vtkMatrix4x4* viewFromWorld;
  vtkMatrix3x3* normals;
  vtkMatrix4x4* clipFromView;
  vtkMatrix4x4* clipFromWorld;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, viewFromWorld, normals, clipFromView, clipFromWorld);
  // It comes transposed; so does what follows, and a plane is a column.
  vtkNew<vtkMatrix4x4> worldFromClip;
  vtkMatrix4x4::Invert(clipFromWorld, worldFromClip);
  std::vector<float> planes;
  for (int side = 0; side < 6; ++side)
  {
    if (std::isfinite(this->Region[side]))
    {
      const double sign = side % 2 == 0 ? 1.0 : -1.0;
      double plane[4] = { 0.0, 0.0, 0.0, -sign * this->Region[side] };
      plane[side / 2] = sign;
      worldFromClip->MultiplyPoint(plane, plane);
      planes.insert(planes.end(), plane, plane + 4);
    }
  }
  program->SetUniform4fv("fourierRegion", static_cast<int>(planes.size() / 4),
    reinterpret_cast<const float(*)[4]>(planes.data()));
}

//------------------------------------------------------------------------------
double vtkFourierOpacityMapper::GetReducedSize(double size)
{
  // Nothing is drawn smaller than a pixel.
  return std::max(size / this->Internals->Stage->Reduction, 1.0);
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityMapper::IsOfPoints(const vtkOpenGLHelper& cellBO, vtkActor* actor)
{
  return &cellBO == &this->Primitives[PrimitivePoints] ||
    actor->GetProperty()->GetRepresentation() == VTK_POINTS;
}

//------------------------------------------------------------------------------
float vtkFourierOpacityMapper::GetCoverage(vtkOpenGLHelper& cellBO, vtkActor* actor)
{
  const vtkFourierOpacityStage& stage = *this->Internals->Stage;
  vtkProperty* property = actor->GetProperty();
  const int representation = property->GetRepresentation();
  const bool isPoints = this->IsOfPoints(cellBO, actor);
  const bool isLines =
    &cellBO == &this->Primitives[PrimitiveLines] || representation == VTK_WIREFRAME;
  const double line = property->GetLineWidth() + (this->HasHalo(actor) ? 2.0 * stage.HaloWidth : 0);
  const double size = isPoints ? property->GetPointSize() : line;
  const double part = std::min(size / stage.SumReduction, 1.0);
  return isPoints ? static_cast<float>(part * part) : isLines ? static_cast<float>(part) : 1.0f;
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityMapper::HasReducedLines(vtkActor* actor)
{
  return this->Internals->Stage && this->Internals->Stage->Reduction > 1 &&
    actor->GetProperty()->GetLineWidth() > 1.0f &&
    (this->LastBoundBO == &this->Primitives[PrimitiveLines] ||
      actor->GetProperty()->GetRepresentation() == VTK_WIREFRAME) &&
    actor->GetProperty()->GetRepresentation() != VTK_POINTS;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (this->Internals->Stage && this->Internals->Stage->Reduction > 1)
  {
    window->GetState()->vtkglPointSize(
      static_cast<float>(this->GetReducedSize(actor->GetProperty()->GetPointSize())));
  }
  this->Superclass::RenderPieceDraw(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetLineWidth(
  vtkShaderProgram* program, vtkRenderer* renderer, double pixels)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float width[2] = { static_cast<float>(2.0 * pixels / viewport[2]),
    static_cast<float>(2.0 * pixels / viewport[3]) };
  program->SetUniform2f("lineWidthNVC", width);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::SetHaloParameters(
  vtkShaderProgram* program, vtkRenderer* renderer, vtkActor* actor)
{
  const vtkFourierOpacityStage& stage = *this->Internals->Stage;
  const float line = actor->GetProperty()->GetLineWidth();
  const auto halo = static_cast<float>(stage.HaloWidth);
  this->SetLineWidth(program, renderer, this->GetReducedSize(line + 2.0f * halo));
  const float extent[3] = { 0.5f * line, halo, static_cast<float>(stage.HaloDepth) };
  program->SetUniform3f("fourierHalo", extent);
  if (program->IsUniformUsed("fourierHaloColor"))
  {
    const double* background = renderer->GetBackground();
    const float color[3] = { static_cast<float>(background[0]), static_cast<float>(background[1]),
      static_cast<float>(background[2]) };
    program->SetUniform3f("fourierHaloColor", color);
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Painter->ReleaseGraphicsResources(window);
  this->Internals->Programs.Clear();
  this->Internals->Layer.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkFourierOpacityMapper::SafeDownCast(mapper))
  {
    this->SetImportanceArrayName(other->ImportanceArrayName);
    this->SetImportanceArrayAssociation(other->ImportanceArrayAssociation);
    this->SetImportanceRange(other->ImportanceRange);
    this->SetNumberOfLineSegments(other->NumberOfLineSegments);
    this->SetNumberOfPatches(other->NumberOfPatches);
    this->SetRegion(other->Region);
    this->SetOptimization(other->GetOptimization());
  }
  this->Superclass::ShallowCopy(mapper);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImportanceArrayName: " << this->ImportanceArrayName << "\n";
  os << indent << "ImportanceArrayAssociation: " << this->ImportanceArrayAssociation << "\n";
  os << indent << "ImportanceRange: " << this->ImportanceRange[0] << " " << this->ImportanceRange[1]
     << "\n";
  os << indent << "NumberOfLineSegments: " << this->NumberOfLineSegments << "\n";
  os << indent << "NumberOfPatches: " << this->NumberOfPatches << "\n";
  os << indent << "Region:";
  for (double side : this->Region)
  {
    os << " " << side;
  }
  os << "\n";
  os << indent << "Optimization:\n";
  this->Internals->Optimization->PrintSelf(os, indent.GetNextIndent());
}
