// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineFrame
 * @brief   all that an engine needs to know to ray cast one picture of a voxel line model
 *
 * The mapper fills it once per render; both engines read it. Everything is in single precision
 * and in grid-local or view coordinates: the world placement has been folded into the vectors in
 * double precision before.
 *
 * <b>Rays.</b> The ray of pixel (x,y), whose centre is (x + 1/2, y + 1/2) in pixels of the
 * viewport, passes the points O(x,y) + s D(x,y) in grid-local coordinates with O = Origin[0] + (x +
 * 1/2) Origin[1] + (y + 1/2) Origin[2] and D alike from Direction. s is the distance along the view
 * direction in world units, counted from a plane near the grid, so that nothing is lost when the
 * camera is far away; D has unit length along the view direction. Only s in [NearestS, FarthestS]
 * is visible. The depth of a point is 0.5 (DepthZ[0] + s DepthZ[1]) / (DepthW[0] + s DepthW[1]) +
 * 0.5.
 *
 * <b>Widths.</b> Half a pixel, of its two sides the larger one, has at s the length HalfPixel[0] +
 * s HalfPixel[1] in voxels. Where ThinTubes is set, a tube is drawn with at least that radius.
 */

#ifndef vtkVoxelLineFrame_h
#define vtkVoxelLineFrame_h

#include "vtkLineSetsLighting.h"
#include "vtkVoxelLineGlobalLight.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

struct vtkVoxelLineFrame
{
  /// Size of the viewport (or tile), in pixels.
  int Width = 0;
  int Height = 0;

  glm::vec3 Origin[3];
  glm::vec3 Direction[3];
  float NearestS = 0.0f;
  float FarthestS = 0.0f;
  glm::vec2 HalfPixel = glm::vec2(0.0f);
  /// Smallest and largest s of the box of all that is drawn.
  glm::vec2 BoxS = glm::vec2(0.0f);
  glm::vec2 DepthZ = glm::vec2(0.0f);
  glm::vec2 DepthW = glm::vec2(1.0f, 0.0f);

  /// Grid-local to view coordinates, for points; and for normals (inverse transpose).
  glm::mat4 ViewFromLocal = glm::mat4(1.0f);
  glm::mat3 NormalFromLocal = glm::mat3(1.0f);

  /// Half spaces a x + b y + c z + d >= 0 in grid-local coordinates that are kept.
  std::vector<glm::vec4> ClippingPlanes;
  /// The same for the region in which what is seen is drawn; it cuts no tube open.
  std::vector<glm::vec4> RegionPlanes;

  /// Tube radius in voxels. Where the model has radii, the radius that byte 255 stands for.
  float Radius = 0.25f;
  /// Whether some tube may be narrower than two pixels, by which its light changes over to that of
  /// a line; and narrower than one, by which it is widened to that and covers a part of it only.
  bool NarrowTubes = false;
  bool ThinTubes = false;
  /// With ThinTubes: no radius is drawn larger than this, in voxels.
  float LargestRadius = 0.0f;

  /// What colours the lines: Color, or Table by scalar attribute, or direct colour attributes.
  enum ColoringType
  {
    Uniform = 0,
    Table = 1,
    Direct = 2
  };
  int Coloring = Uniform;
  /// Colour (0 to 1) and opacity for each attribute byte, not multiplied by opacity.
  std::array<glm::vec4, 256> ColorTable;
  /// Whether byte 255 marks NaN, which is never interpolated with its neighbours.
  bool HasNaN = false;

  /// vtkProperty. With Table and Direct, the attribute's colour replaces both colours.
  glm::vec3 AmbientColor = glm::vec3(1.0f);
  glm::vec3 DiffuseColor = glm::vec3(1.0f);
  glm::vec3 SpecularColor = glm::vec3(1.0f);
  float Ambient = 0.0f;
  float Diffuse = 1.0f;
  float Specular = 0.0f;
  float Opacity = 1.0f;
  /// False where vtkProperty's lighting is off: the colour is then shown as it is.
  bool Lighting = true;
  /// Lights, light model and exponent.
  vtkLineSetsLighting Light;
  /// Whether wide tubes are lit as lines are, because the light model is for lines alone.
  bool LitAsLines = false;

  /// Whether opacity is that of a ray through the whole diameter of a tube, and less or more of the
  /// way inside gives less or more of it; else each tube has it. Opaque tubes stay opaque.
  bool OpacityByPathLength = false;

  /// Whether rays look only into voxels that they pass, by which parts of tubes that reach out of
  /// their voxel are missing.
  bool Interactive = false;

  /// A ray ends where its opacity reaches this. Above 1: only behind opaque lines.
  float EarlyTermination = 0.99f;

  /// The rest of a ray goes by densities where its opacity reaches this. Above 1: never.
  float AccelerationOpacity = 2.0f;

  /// Whether any ray may go by densities.
  bool IsAccelerated() const { return this->AccelerationOpacity <= 1.0f && !this->IsOpaque(); }

  /// Shadows and ambient occlusion.
  vtkVoxelLineGlobalLight Global;

  /// Whether shading casts rays through the tubes; and whether it casts them through the model of a
  /// level, which is then given to the engine: the one that vtkVoxelLineLevel makes at ShadowLevel.
  bool SecondaryRays = false;
  bool LevelRays = false;
  int ShadowLevel = 1;

  /// Opaque selection picture: every line is opaque, and engines give curve indices as well.
  bool Picking = false;

  /// Whether every line is opaque, so that the first hit is all that is seen.
  bool IsOpaque() const
  {
    if (this->Picking)
    {
      return true;
    }
    bool opaque = this->Opacity >= 1.0f && this->Coloring != Direct && !this->ThinTubes;
    for (std::size_t i = 0; this->Coloring == Table && i < this->ColorTable.size(); ++i)
    {
      opaque = opaque && this->ColorTable[i].w >= 1.0f;
    }
    return opaque;
  }

  /// Depth of the opaque scene per pixel, row by row from the bottom, 0 to 1; empty: none.
  std::vector<float> SceneDepth;
};

#endif
