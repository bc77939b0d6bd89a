// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceRenderer.h"

#include "CapsuleGrid.h"
#include "RayLayers.h"
#include "ViewRays.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <stdexcept>

namespace linesets
{
// One pixel and the visible part of its ray.
struct ReferenceRenderer::Pixel
{
  int X;
  int Y;
  Ray Line;
  double First;
  double Last;
};

// What a thread reuses from pixel to pixel.
struct ReferenceRenderer::Workspace
{
  std::vector<CapsuleHit> Hits;
  std::vector<RayLayer> Layers;
  // Number of the last ray that a capsule was tried for, since it stands in several cells.
  std::vector<unsigned int> LastRay;
  unsigned int RayNumber = 0;
};

//------------------------------------------------------------------------------
ReferenceRenderer::ReferenceRenderer(const CapsuleScene& scene)
  : Scene(scene)
{
}

//------------------------------------------------------------------------------
ReferenceRenderer::~ReferenceRenderer() = default;

//------------------------------------------------------------------------------
void ReferenceRenderer::SetView(vtkRenderer* renderer, vtkActor* actor)
{
  renderer->GetTiledSize(&this->Width, &this->Height);
  this->Camera = renderer->GetActiveCamera();
  this->Lights = LightSet::FromRenderer(renderer);
  renderer->GetBackground(this->Background);
  this->Surface = Material::FromProperty(actor->GetProperty());
  this->OwnActorMatrix = vtkSmartPointer<vtkMatrix4x4>::New();
  actor->GetMatrix(this->OwnActorMatrix);
  this->ActorMatrix = this->OwnActorMatrix;
  this->Planes.clear();
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  if (vtkScalarsToColors* table = mapper->GetLookupTable())
  {
    // As vtkMapper::MapScalars does before it maps.
    if (!mapper->GetUseLookupTableScalarRange())
    {
      table->SetRange(mapper->GetScalarRange());
    }
    this->Table = ColorTable(table);
  }
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  vtkCollectionSimpleIterator iterator;
  if (planes)
  {
    planes->InitTraversal(iterator);
    while (vtkPlane* plane = planes->GetNextPlane(iterator))
    {
      Plane copy;
      plane->GetOrigin(copy.Origin);
      plane->GetNormal(copy.Normal);
      this->Planes.push_back(copy);
    }
  }
}

//------------------------------------------------------------------------------
void ReferenceRenderer::Render(ReferenceImage& image)
{
  if (!this->Camera)
  {
    throw std::logic_error("ReferenceRenderer: no camera");
  }
  image.Allocate(this->Width, this->Height);
  const std::size_t pixels = image.Depth.size();
  if (!this->SceneDepth.empty() && this->SceneDepth.size() != pixels)
  {
    throw std::logic_error("ReferenceRenderer: SceneDepth needs one value per pixel");
  }
  if (!this->BackgroundImage.empty() && this->BackgroundImage.size() != 3 * pixels)
  {
    throw std::logic_error("ReferenceRenderer: BackgroundImage needs three values per pixel");
  }
  if (pixels == 0)
  {
    return;
  }
  if (this->UseGrid && !this->Grid)
  {
    this->Grid = std::make_unique<CapsuleGrid>(this->Scene.Capsules);
  }
  this->EndAtFirst = this->IsOpaque() && !this->CountAllLayers;
  const ViewRays rays(
    this->Camera, this->Width, this->Height, this->ActorMatrix, this->Scene.Origin);
  vtkSMPThreadLocal<Workspace> workspaces;
  vtkSMPTools::For(0, this->Height, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      Workspace& work = workspaces.Local();
      work.LastRay.resize(this->Scene.Capsules.size(), 0);
      for (vtkIdType row = begin; row < end; ++row)
      {
        this->RenderRow(rays, static_cast<int>(row), image, work);
      }
    });
}

//------------------------------------------------------------------------------
void ReferenceRenderer::RenderRow(
  const ViewRays& rays, int row, ReferenceImage& image, Workspace& work) const
{
  for (int x = 0; x < this->Width; ++x)
  {
    Pixel pixel;
    pixel.X = x;
    pixel.Y = row;
    this->GetInterval(rays, pixel);
    this->CollectLayers(pixel, work);

    const std::size_t index = static_cast<std::size_t>(row) * this->Width + x;
    double color[3] = { 0.0, 0.0, 0.0 };
    double transmittance = 1.0;
    for (const RayLayer& layer : work.Layers)
    {
      double rgb[3];
      const double opacity =
        this->ShadeLayer(rays, pixel, layer.Position, layer.Capsule, layer.FromInside, rgb);
      for (int i = 0; i < 3; ++i)
      {
        color[i] += transmittance * opacity * rgb[i];
      }
      transmittance *= 1.0 - opacity;
    }
    const double* background =
      this->BackgroundImage.empty() ? this->Background : &this->BackgroundImage[3 * index];
    for (int i = 0; i < 3; ++i)
    {
      image.Color[3 * index + i] = color[i] + transmittance * background[i];
    }
    image.Opacity[index] = 1.0 - transmittance;
    image.Layers[index] = static_cast<int>(work.Layers.size());
    if (!work.Layers.empty())
    {
      const RayLayer& nearest = work.Layers.front();
      double point[3];
      for (int i = 0; i < 3; ++i)
      {
        point[i] = pixel.Line.ViewOrigin[i] + nearest.Position * pixel.Line.ViewDirection[i];
      }
      image.Depth[index] = rays.GetDepth(point);
      image.Curve[index] = nearest.Curve;
    }
  }
}

//------------------------------------------------------------------------------
void ReferenceRenderer::GetInterval(const ViewRays& rays, Pixel& pixel) const
{
  const double x = pixel.X + 0.5;
  const double y = pixel.Y + 0.5;
  pixel.Line = rays.GetRay(x, y);
  pixel.First = 0.0;
  pixel.Last = pixel.Line.Length;
  for (const Plane& plane : this->Planes)
  {
    rays.Clip(pixel.Line, plane.Origin, plane.Normal, pixel.First, pixel.Last);
  }
  if (!this->SceneDepth.empty())
  {
    const float depth = this->SceneDepth[static_cast<std::size_t>(pixel.Y) * this->Width + pixel.X];
    pixel.Last = std::min(pixel.Last, rays.GetParameter(x, y, depth));
  }
}

//------------------------------------------------------------------------------
void ReferenceRenderer::TryCapsule(vtkIdType index, const Pixel& pixel, Workspace& work) const
{
  const Capsule& capsule = this->Scene.Capsules[index];
  CapsuleHit hit;
  if (IntersectCapsule(
        capsule, pixel.Line.ModelOrigin, pixel.Line.ModelDirection, hit.Entry, hit.Exit))
  {
    hit.Curve = capsule.Curve;
    hit.Capsule = index;
    work.Hits.push_back(hit);
  }
}

//------------------------------------------------------------------------------
void ReferenceRenderer::CollectLayers(const Pixel& pixel, Workspace& work) const
{
  work.Hits.clear();
  work.Layers.clear();
  if (!(pixel.First < pixel.Last))
  {
    return;
  }
  if (!this->UseGrid)
  {
    for (std::size_t i = 0; i < this->Scene.Capsules.size(); ++i)
    {
      this->TryCapsule(static_cast<vtkIdType>(i), pixel, work);
    }
    FindLayers(work.Hits, pixel.First, pixel.Last, work.Layers);
  }
  else
  {
    const unsigned int number = ++work.RayNumber;
    CapsuleGrid::Walk walk(
      *this->Grid, pixel.Line.ModelOrigin, pixel.Line.ModelDirection, pixel.First, pixel.Last);
    for (; walk.IsValid(); walk.Next())
    {
      const std::size_t before = work.Hits.size();
      for (const std::uint32_t index : walk)
      {
        if (work.LastRay[index] != number)
        {
          work.LastRay[index] = number;
          this->TryCapsule(index, pixel, work);
        }
      }
      // All capsules entered before the end of this cell are known, so that nothing found later
      // can come before a layer within it.
      if (this->EndAtFirst && !work.Hits.empty())
      {
        if (work.Hits.size() != before || work.Layers.empty())
        {
          FindLayers(work.Hits, pixel.First, pixel.Last, work.Layers);
        }
        if (!work.Layers.empty() && work.Layers.front().Position < walk.GetExit())
        {
          break;
        }
      }
    }
    FindLayers(work.Hits, pixel.First, pixel.Last, work.Layers);
  }
  if (this->EndAtFirst && work.Layers.size() > 1)
  {
    work.Layers.resize(1);
  }
}

//------------------------------------------------------------------------------
double ReferenceRenderer::ShadeLayer(const ViewRays& rays, const Pixel& pixel, double position,
  vtkIdType index, bool fromInside, double rgb[3]) const
{
  const Capsule& capsule = this->Scene.Capsules[index];
  double model[3];
  double view[3];
  for (int i = 0; i < 3; ++i)
  {
    model[i] = pixel.Line.ModelOrigin[i] + position * pixel.Line.ModelDirection[i];
    view[i] = pixel.Line.ViewOrigin[i] + position * pixel.Line.ViewDirection[i];
  }
  double normal[3];
  GetCapsuleNormal(capsule, model, normal);
  rays.TransformNormal(normal, normal);
  if (fromInside)
  {
    vtkMath::MultiplyScalar(normal, -1.0);
  }
  std::array<double, 4> color = { { 1.0, 1.0, 1.0, 1.0 } };
  const double along = GetCapsulePosition(capsule, model);
  switch (this->Scene.Colors)
  {
    case ColorSource::Scalars:
      color = this->Table.Map(capsule.StartValue + along * (capsule.EndValue - capsule.StartValue));
      break;
    case ColorSource::Direct:
      for (int i = 0; i < 4; ++i)
      {
        color[i] =
          (capsule.StartColor[i] + along * (capsule.EndColor[i] - capsule.StartColor[i])) / 255.0;
      }
      break;
    case ColorSource::Material:
      break;
  }
  const bool own = this->Scene.Colors == ColorSource::Material;
  Shade(this->Lights, this->Surface, own ? nullptr : color.data(), view, normal, rgb);
  return std::min(std::max(this->Surface.Opacity * color[3], 0.0), 1.0);
}

//------------------------------------------------------------------------------
bool ReferenceRenderer::IsOpaque() const
{
  if (this->Surface.Opacity < 1.0)
  {
    return false;
  }
  switch (this->Scene.Colors)
  {
    case ColorSource::Scalars:
      return this->Table.IsOpaque();
    case ColorSource::Direct:
      return std::all_of(this->Scene.Capsules.begin(), this->Scene.Capsules.end(),
        [](const Capsule& capsule)
        { return capsule.StartColor[3] == 255 && capsule.EndColor[3] == 255; });
    case ColorSource::Material:
      break;
  }
  return true;
}
}
