// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Exact pictures of line sets, in double precision, without OpenGL.
 *
 * One ray goes through the centre of each pixel. Every capsule that it hits is found; each curve
 * gives one layer for each stretch of the ray inside the union of its capsules (RayLayers.h); each
 * layer is shaded by the normal of the capsule that is entered first (Lighting.h) with the
 * attribute at the hit, interpolated along the axis of the capsule and then mapped through the
 * lookup table; and all layers are blended front to back with their opacity:
 *   C = sum_i c_i a_i prod_(j<i) (1 - a_j) + background prod_i (1 - a_i).
 * Nothing ends early, unless all layers are opaque, where the nearest one is all there is to see.
 * The opacity of a layer is that of the material times that of the table or of the direct colour.
 */

#ifndef ReferenceRenderer_h
#define ReferenceRenderer_h

#include "Capsule.h"
#include "ColorTable.h"
#include "Lighting.h"
#include "ReferenceImage.h"

#include "vtkSmartPointer.h" // For the matrices

#include <array>  // For planes
#include <memory> // For the grid
#include <vector> // For planes

class vtkActor;
class vtkCamera;
class vtkMatrix4x4;
class vtkRenderer;

namespace linesets
{
class CapsuleGrid;
class ViewRays;

class ReferenceRenderer
{
public:
  /// The scene must outlive the renderer.
  explicit ReferenceRenderer(const CapsuleScene& scene);
  ~ReferenceRenderer();

  /// A half space in world coordinates that is kept: Normal . (x - Origin) >= 0.
  struct Plane
  {
    double Origin[3];
    double Normal[3];
  };

  ///@{
  /**
   * What may be set, with its default: size of the viewport in pixels (300 x 300), camera (none:
   * must be set), matrix of the actor (null: identity; affine), light (a headlight), material,
   * colours of scalars (white), background (black), planes (none).
   */
  int Width = 300;
  int Height = 300;
  vtkCamera* Camera = nullptr;
  vtkMatrix4x4* ActorMatrix = nullptr;
  LightSet Lights;
  Material Surface;
  ColorTable Table;
  double Background[3] = { 0.0, 0.0, 0.0 };
  std::vector<Plane> Planes;
  ///@}

  /**
   * Depth buffer values of other, opaque geometry, Width * Height of them, or empty (default).
   * Layers behind are hidden.
   */
  std::vector<float> SceneDepth;

  /**
   * Red, green and blue (0 to 1) of what is behind the lines, Width * Height * 3 numbers, used in
   * place of Background where not empty (default).
   */
  std::vector<double> BackgroundImage;

  /// Look for candidates in a grid (default), or try all capsules for all pixels.
  bool UseGrid = true;

  /// Go on behind opaque layers, so that ReferenceImage::Layers is complete. Default false.
  bool CountAllLayers = false;

  /**
   * Take size, camera, lights, background (a single colour), the actor's matrix, property and its
   * mapper's lookup table and clipping planes from a renderer that belongs to a window. The size is
   * that of the renderer's viewport.
   */
  void SetView(vtkRenderer* renderer, vtkActor* actor);

  /// Draw. Threads through vtkSMPTools; the result does not depend on their number.
  void Render(ReferenceImage& image);

private:
  struct Pixel;
  struct Workspace;
  void RenderRow(const ViewRays& rays, int row, ReferenceImage& image, Workspace& work) const;
  void GetInterval(const ViewRays& rays, Pixel& pixel) const;
  void CollectLayers(const Pixel& pixel, Workspace& work) const;
  void TryCapsule(vtkIdType index, const Pixel& pixel, Workspace& work) const;
  double ShadeLayer(const ViewRays& rays, const Pixel& pixel, double position, vtkIdType index,
    bool fromInside, double rgb[3]) const;
  bool IsOpaque() const;

  const CapsuleScene& Scene;
  std::unique_ptr<CapsuleGrid> Grid;
  bool EndAtFirst = false;
  vtkSmartPointer<vtkMatrix4x4> OwnActorMatrix;
};
}

#endif
