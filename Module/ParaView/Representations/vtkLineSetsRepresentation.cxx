// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsRepresentation.h"

#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkLineSetsBlocks.h"
#include "vtkLineSetsShare.h"
#include "vtkLineSetsThinning.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOutputWindow.h"
#include "vtkPVGeometryFilter.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkVoxelLineMapper.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Field array that tells a level of detail which is no more than an outline.
constexpr const char* OutlineMark = "vtkLineSetsOutline";

//------------------------------------------------------------------------------
template <typename MapperT>
void SetIdNames(MapperT* mapper, const char* pointArray, const char* cellArray)
{
  mapper->SetPointIdArrayName(pointArray ? pointArray : "vtkOriginalPointIds");
  mapper->SetCellIdArrayName(cellArray ? cellArray : "vtkOriginalCellIds");
  mapper->SetCompositeIdArrayName("vtkCompositeIndex");
  mapper->SetProcessIdArrayName("vtkProcessId");
}

//------------------------------------------------------------------------------
/// Sets the input only where it is another one, since that modifies the mapper.
void SetInput(vtkPolyDataMapper* mapper, vtkPolyData* lines)
{
  if (mapper->GetInputDataObject(0, 0) != lines)
  {
    mapper->SetInputDataObject(lines);
  }
}
}

struct vtkLineSetsRepresentation::Level
{
  vtkLineSetsBlocks Blocks;
  vtkLineSetsShare Shared;
  vtkNew<vtkCompositeDataDisplayAttributes> Attributes;
  /// What the attributes are of.
  vtkSmartPointer<vtkDataObject> Data;
  vtkTimeStamp AttributesTime;

  /// The visible blocks, with the arrays in use that any rank has.
  vtkPolyData* Join(vtkDataObject* data, const vtkLineSetsBlocks::Request& request,
    vtkInformation* viewInfo, bool isDetail)
  {
    this->Shared.SetView(vtkPVRenderView::SafeDownCast(viewInfo->Get(vtkPVView::VIEW())), isDetail);
    std::vector<std::string> names = request.Arrays;
    if (!request.FieldArray.empty())
    {
      names.push_back(request.FieldArray);
    }
    vtkPolyData* joined = this->Blocks.Join(data, this->Attributes, request);
    return this->Shared.Complete(joined, names, this->Blocks.GetLeftOut());
  }

  /// The arrays of blocks or ranks that do not go along.
  const std::set<vtkLineSetsSpread::Identity>& GetLeftOut() const
  {
    return this->Shared.IsParted() ? this->Shared.GetLeftOut() : this->Blocks.GetLeftOut();
  }

  bool IsCurrent(vtkDataObject* data) const
  {
    return this->Data == data && (!data || data->GetMTime() < this->AttributesTime.GetMTime());
  }
};

//------------------------------------------------------------------------------
vtkLineSetsRepresentation::vtkLineSetsRepresentation()
  : Whole(new Level)
  , Thin(new Level)
  , Thinning(new vtkLineSetsThinning)
  , OutlineMapper(vtkSmartPointer<vtkPolyDataMapper>::New())
{
  this->OutlineMapper->ScalarVisibilityOff();
}

//------------------------------------------------------------------------------
vtkLineSetsRepresentation::~vtkLineSetsRepresentation() = default;

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::SetLineMapper(vtkPolyDataMapper* mapper)
{
  if (!mapper || mapper == this->Mapper)
  {
    return;
  }
  if (!mapper->IsA(this->GetLineMapperType()))
  {
    vtkErrorMacro("The mapper is a " << mapper->GetClassName() << "; it must be a "
                                     << this->GetLineMapperType() << ".");
    return;
  }
  // ParaView observes the progress of every algorithm that has a proxy, and its client processes
  // events upon progress: in the middle of a picture those would draw other parts of the window and
  // leave their OpenGL context current.
  mapper->RemoveObservers(vtkCommand::ProgressEvent);
  this->Mapper->Delete();
  this->Mapper = mapper;
  this->Mapper->Register(this);
  if (this->IsThinned())
  {
    this->LODMapper->Delete();
    this->LODMapper = mapper->NewInstance();
    this->ThinMapperTime = vtkTimeStamp();
  }
  this->SetArrayIdNames(nullptr, nullptr);
  // Connects the new mapper with all else.
  this->SetupDefaults();
  this->MarkModified();
}

//------------------------------------------------------------------------------
vtkPolyDataMapper* vtkLineSetsRepresentation::GetLineMapper()
{
  return vtkPolyDataMapper::SafeDownCast(this->Mapper);
}

//------------------------------------------------------------------------------
std::string vtkLineSetsRepresentation::GetArrayName(const char* name)
{
  return name && std::string(name) != "None" ? name : "";
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::SetArrayIdNames(const char* pointArray, const char* cellArray)
{
  if (auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(this->Mapper))
  {
    SetIdNames(mapper, pointArray, cellArray);
  }
  else if (auto* voxels = vtkVoxelLineMapper::SafeDownCast(this->Mapper))
  {
    SetIdNames(voxels, pointArray, cellArray);
  }
}

//------------------------------------------------------------------------------
int vtkLineSetsRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  const bool isDetail = request == vtkPVView::REQUEST_UPDATE_LOD();
  if (!isDetail && request != vtkPVView::REQUEST_RENDER())
  {
    const int done = this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
    if (done && request == vtkPVView::REQUEST_UPDATE())
    {
      this->LeaveStaleMeasures();
      if (!this->GetUseDataPartitions())
      {
        // The view parts space by these lines, but they are handed on here, not by the view.
        vtkPVRenderView::SetOrderedCompositingConfiguration(
          inInfo, this, vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
      }
      // Nothing can be parted where there is nothing, and the view would try to. The piece may be
      // one of another time step that the view has kept.
      if (!vtkLineSetsShare::HasExtent(vtkPVView::GetPiece(inInfo, this)))
      {
        outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), 0);
      }
    }
    return done;
  }
  // Polygons have only the superclass's level of detail.
  if (isDetail && this->IsThinned() && !inInfo->Has(vtkPVRenderView::USE_OUTLINE_FOR_LOD()) &&
    !vtkLineSetsThinning::IsPossible(vtkPVView::GetPiece(inInfo, this)))
  {
    return this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
  }
  // The superclass would give the composite data set to the mapper.
  if (!this->vtkPVDataRepresentation::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (isDetail)
  {
    this->UpdateLevelOfDetail(inInfo);
  }
  else
  {
    this->UpdateColoringParameters();
    this->UpdateLines(inInfo);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::UpdateLevelOfDetail(vtkInformation* viewInfo)
{
  vtkDataObject* data = vtkPVView::GetPiece(viewInfo, this);
  if (!data || this->SuppressLOD)
  {
    return;
  }
  if (viewInfo->Has(vtkPVRenderView::USE_OUTLINE_FOR_LOD()))
  {
    this->LODOutlineFilter->SetInputDataObject(data);
    this->LODOutlineFilter->Update();
    vtkDataObject* made = this->LODOutlineFilter->GetOutputDataObject(0);
    auto outline = vtkSmartPointer<vtkDataObject>::Take(made->NewInstance());
    outline->ShallowCopy(made);
    vtkNew<vtkIntArray> mark;
    mark->SetName(OutlineMark);
    outline->GetFieldData()->AddArray(mark);
    vtkPVView::SetPieceLOD(viewInfo, this, outline);
  }
  else if (this->IsThinned())
  {
    const double resolution = viewInfo->Has(vtkPVRenderView::LOD_RESOLUTION())
      ? viewInfo->Get(vtkPVRenderView::LOD_RESOLUTION())
      : 0.5;
    vtkPVView::SetPieceLOD(viewInfo, this, this->Thinning->Thin(data, resolution));
  }
  else
  {
    // The mapper draws less of the same, wherever a level of detail is delivered to.
    vtkPVView::SetPieceLOD(viewInfo, this, data);
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::UpdateLines(vtkInformation* viewInfo)
{
  vtkDataObject* data = vtkPVView::GetDeliveredPiece(viewInfo, this);
  vtkDataObject* detail = !this->SuppressLOD && viewInfo->Has(vtkPVRenderView::USE_LOD())
    ? vtkPVView::GetDeliveredPieceLOD(viewInfo, this)
    : nullptr;
  if (detail && !this->IsThinned() && !this->IsOutline(detail))
  {
    // The whole, where that is not delivered for itself: what is delivered to a client that does
    // not draw it is empty.
    data = data && data->GetNumberOfElements(vtkDataObject::POINT) > 0 ? data : detail;
    detail = nullptr;
  }
  this->UpdateBlockAttributes(data, detail);

  vtkLineSetsBlocks::Request request;
  vtkInformation* color = this->GetInputArrayInformation(0);
  const char* name = this->GetColorArrayName();
  const bool isField =
    name && color->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_NONE;
  (isField ? request.FieldArray : request.Arrays.emplace_back()) = name ? name : "";
  for (const std::string& array : this->GetArraysInUse())
  {
    request.Arrays.push_back(array);
  }
  request.Arrays.erase(
    std::remove(request.Arrays.begin(), request.Arrays.end(), std::string()), request.Arrays.end());
  std::sort(request.Arrays.begin(), request.Arrays.end());
  request.Arrays.erase(
    std::unique(request.Arrays.begin(), request.Arrays.end()), request.Arrays.end());

  if (detail)
  {
    // Settles what the mapper of the whole is told, before that of the detail takes it over.
    vtkPolyData* mine = this->IsOutline(detail)
      ? this->Thin->Blocks.Join(detail, this->Thin->Attributes, request)
      : this->Share(*this->Thin, this->Thin->Join(detail, request, viewInfo, true));
    SetInput(this->UpdateLevelOfDetailMapper(detail), mine);
  }
  else
  {
    vtkPolyData* lines = this->Whole->Join(data, request, viewInfo, false);
    SetInput(this->GetLineMapper(), this->Share(*this->Whole, lines));
    this->CheckLines(lines);
    for (const vtkLineSetsBlocks::Warning& warning : this->Whole->Blocks.GetWarnings())
    {
      this->WarnOnce(warning.Text, warning.Key);
    }
    for (const std::string& warning : this->Whole->Shared.GetWarnings())
    {
      this->WarnOnce(warning);
    }
    this->TellLeftOut();
  }
  this->Actor->SetEnableLOD(detail ? 1 : 0);
}

//------------------------------------------------------------------------------
bool vtkLineSetsRepresentation::IsOutline(vtkDataObject* detail)
{
  return detail->GetFieldData()->HasArray(OutlineMark);
}

//------------------------------------------------------------------------------
vtkPolyDataMapper* vtkLineSetsRepresentation::UpdateLevelOfDetailMapper(vtkDataObject* detail)
{
  auto* lines = vtkPolyDataMapper::SafeDownCast(this->LODMapper);
  const bool isOutline = this->IsOutline(detail);
  if (!isOutline && this->ThinMapperTime < this->Mapper->GetMTime())
  {
    // Shares the illumination and all else that is an object.
    lines->ShallowCopy(this->Mapper);
    this->ThinMapperTime.Modified();
  }
  vtkPolyDataMapper* used = isOutline ? this->OutlineMapper.Get() : lines;
  this->Actor->SetLODMapper(used);
  return used;
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::UpdateBlockAttributes(vtkDataObject* data, vtkDataObject* detail)
{
  const bool areChanged = this->BlockAttrChanged;
  const auto update = [&](Level& level, vtkDataObject* object)
  {
    if (areChanged)
    {
      level.Data = nullptr;
    }
    if (object && !level.IsCurrent(object))
    {
      this->PopulateBlockAttributes(level.Attributes, object);
      level.Data = object;
      level.AttributesTime.Modified();
    }
  };
  update(*this->Whole, data);
  update(*this->Thin, detail);
  if (!data || !areChanged)
  {
    return;
  }
  // By these the superclass knows when to compute the bounds of what is visible.
  this->BlockAttributeTime.Modified();
  this->BlockAttrChanged = false;

  if (!this->BlockColors.empty() || !this->BlockOpacities.empty() ||
    !this->BlockInterpolateScalarsBeforeMapping.empty() || !this->BlockColorModes.empty() ||
    !this->BlockArrayNames.empty())
  {
    this->WarnOnce("Colours, opacities and colour arrays of single blocks are ignored: all lines "
                   "are drawn together, by one colour, opacity and colour array. Of the blocks' "
                   "own settings only their visibility counts.");
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::UpdateColoringParameters()
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  const bool isField = info && info->Has(vtkDataObject::FIELD_ASSOCIATION()) &&
    info->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_NONE;
  if (isField)
  {
    // For the while of the call: the mapper's settings change once only.
    info->Set(vtkDataObject::FIELD_ASSOCIATION(), vtkDataObject::FIELD_ASSOCIATION_CELLS);
  }
  this->Superclass::UpdateColoringParameters();
  if (isField)
  {
    info->Set(vtkDataObject::FIELD_ASSOCIATION(), vtkDataObject::FIELD_ASSOCIATION_NONE);
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::CheckColorArray(vtkPolyData* lines)
{
  const char* name = this->GetColorArrayName();
  if (!name || !name[0] || lines->GetNumberOfPoints() == 0)
  {
    return;
  }
  const bool isOfPoints = this->GetInputArrayInformation(0)->Get(
                            vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::POINT;
  if (!lines->GetAttributes(isOfPoints ? vtkDataObject::POINT : vtkDataObject::CELL)
         ->GetAbstractArray(name))
  {
    this->WarnOnce(std::string("There is no array \"") + name + "\" of " +
      (isOfPoints ? "points" : "cells") + " to colour by: the lines have one colour.");
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::CheckCells(vtkPolyData* lines)
{
  if (lines->GetNumberOfLines() == 0 && lines->GetNumberOfCells() > 0)
  {
    this->WarnOnce("The input has no lines, only other cells (vertices, polygons or strips): these "
                   "are drawn as they are, without the light of lines. Stream tracers, contours "
                   "of slices and feature edges make lines.");
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::WarnOnce(const std::string& warning, const std::string& key)
{
  if (this->Said.insert(key.empty() ? warning : key).second)
  {
    vtkWarningMacro(<< warning);
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::TellLeftOut()
{
  std::string names;
  for (const vtkLineSetsSpread::Identity& array : this->Whole->GetLeftOut())
  {
    const std::string name =
      "\"" + array.first + "\" of " + (array.second == vtkDataObject::POINT ? "points" : "cells");
    if (this->Said.insert("Left out: " + name).second)
    {
      names += (names.empty() ? "" : ", ") + name;
    }
  }
  if (!names.empty() && vtkObject::GetGlobalWarningDisplay())
  {
    const std::string note = std::string(this->GetClassName()) +
      ": left out, since only some blocks or ranks have them and nothing drawn uses them: " +
      names + ".\n";
    vtkOutputWindowDisplayText(note.c_str());
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::LeaveStaleMeasures() {}

//------------------------------------------------------------------------------
vtkPolyData* vtkLineSetsRepresentation::Share(Level& level, vtkPolyData* lines)
{
  if (!level.Shared.IsParted())
  {
    level.Shared.Release();
    this->SetSharedMeasures(nullptr);
    this->Margin = -1.0;
    this->SetRegion(level.Shared.GetRegion().data());
    return lines;
  }
  const Measures measures = level.Shared.Reduce(this->MeasureLines(lines), lines);
  // A level of detail is drawn with what was measured of the whole, which so keeps what it built.
  if (&level == this->Whole.get() || this->Margin < 0.0)
  {
    this->Margin = this->SetSharedMeasures(&measures);
  }
  // A view that has data partitioned by ranks already leaves it where it is.
  const bool moves = level.Shared.IsOrdered() && !this->GetUseDataPartitions();
  vtkPolyData* mine = lines;
  if (moves)
  {
    vtkNew<vtkMatrix4x4> matrix;
    this->Actor->GetMatrix(matrix);
    mine = level.Shared.Distribute(lines, matrix, this->Margin);
  }
  else
  {
    level.Shared.ReleasePieces();
  }
  this->SetRegion(
    moves ? level.Shared.GetRegion().data() : vtkLineSetsDistribution::GetOpenBox().data());
  return mine;
}

//------------------------------------------------------------------------------
vtkLineSetsRepresentation::Measures vtkLineSetsRepresentation::MeasureLines(vtkPolyData* lines)
{
  Measures measures;
  lines->GetBounds(measures.Bounds);
  return measures;
}

//------------------------------------------------------------------------------
double vtkLineSetsRepresentation::SetSharedMeasures(const Measures* vtkNotUsed(measures))
{
  return 0.0;
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::SetRegion(const double region[6])
{
  std::vector<vtkSmartPointer<vtkPlane>> planes;
  for (int side = 0; side < 6; ++side)
  {
    if (std::isfinite(region[side]))
    {
      double normal[3] = { 0.0, 0.0, 0.0 };
      double origin[3] = { 0.0, 0.0, 0.0 };
      normal[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
      origin[side / 2] = region[side];
      auto plane = vtkSmartPointer<vtkPlane>::New();
      plane->SetNormal(normal);
      plane->SetOrigin(origin);
      planes.push_back(plane);
    }
  }
  const auto isSame = [](vtkPlane* a, vtkPlane* b)
  {
    return std::equal(a->GetNormal(), a->GetNormal() + 3, b->GetNormal()) &&
      std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin());
  };
  if (std::equal(
        planes.begin(), planes.end(), this->RegionPlanes.begin(), this->RegionPlanes.end(), isSame))
  {
    return;
  }
  for (vtkPlane* plane : this->RegionPlanes)
  {
    this->Mapper->RemoveClippingPlane(plane);
  }
  for (vtkPlane* plane : planes)
  {
    this->Mapper->AddClippingPlane(plane);
  }
  this->RegionPlanes = planes;
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
