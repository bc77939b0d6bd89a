// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineFrameBuilder.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLineIllumination.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
glm::vec3 ToVec3(const double v[3])
{
  return glm::vec3(static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]));
}

// Row-major product of two 4x4 matrices.
void Multiply(const double a[16], const double b[16], double product[16])
{
  vtkMatrix4x4::Multiply4x4(a, b, product);
}

// Grid-local to data coordinates.
void GetDataFromLocal(const vtkVoxelLineFrameBuilder::Grid& grid, double matrix[16])
{
  std::fill(matrix, matrix + 16, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    matrix[5 * i] = grid.VoxelSize;
    matrix[4 * i + 3] = grid.Origin[i];
  }
  matrix[15] = 1.0;
}

bool IsFinite(const double* values, int count)
{
  return std::all_of(values, values + count, [](double v) { return std::isfinite(v); });
}

// Largest and smallest distance along the view direction of the box of all that is drawn.
void GetBoxDistances(
  const vtkVoxelLineFrameBuilder::Grid& grid, const double viewFromLocal[16], double distances[2])
{
  distances[0] = std::numeric_limits<double>::max();
  distances[1] = std::numeric_limits<double>::lowest();
  for (int corner = 0; corner < 8; ++corner)
  {
    double z = viewFromLocal[11];
    for (int i = 0; i < 3; ++i)
    {
      const double local = (corner >> i) & 1 ? grid.Dimensions[i] + grid.Margin : -grid.Margin;
      z += viewFromLocal[8 + i] * local;
    }
    distances[0] = std::min(distances[0], -z);
    distances[1] = std::max(distances[1], -z);
  }
}

/**
 * Rays in view coordinates. On a plane of constant z the projection maps (x, y) to normalized
 * device coordinates n by n w(z) = A (x, y) + c z + d with w(z) = p32 z + p33, which is affine in n
 * when solved for (x, y) and in z as well: so rays need no inverse of the whole matrix.
 */
class ViewRays
{
public:
  explicit ViewRays(const double projection[16])
    : P(projection)
  {
    const double determinant = this->P[0] * this->P[5] - this->P[1] * this->P[4];
    this->Inverse[0] = this->P[5] / determinant;
    this->Inverse[1] = -this->P[1] / determinant;
    this->Inverse[2] = -this->P[4] / determinant;
    this->Inverse[3] = this->P[0] / determinant;
  }

  bool IsValid() const
  {
    // What follows relies on a w and a depth that depend on z alone.
    return IsFinite(this->Inverse, 4) && this->P[8] == 0.0 && this->P[9] == 0.0 &&
      this->P[12] == 0.0 && this->P[13] == 0.0;
  }

  // A^-1 (w n - f (c, d)) for the four parts that the rays are made of.
  void Solve(double w, const double n[2], const double offset[2], double xy[2]) const
  {
    const double right[2] = { w * n[0] - offset[0], w * n[1] - offset[1] };
    xy[0] = this->Inverse[0] * right[0] + this->Inverse[1] * right[1];
    xy[1] = this->Inverse[2] * right[0] + this->Inverse[3] * right[1];
  }

  const double* P;

private:
  double Inverse[4];
};

// Part i of the rays' origins and directions in view coordinates: 0 the corner, 1 and 2 the pixel
// steps. distance is that of the plane of the origins.
void GetRayPart(const ViewRays& rays, int i, const vtkVoxelLineFrameBuilder::View& view,
  double distance, double origin[3], double direction[3])
{
  const double* p = rays.P;
  const double step[2] = { 2.0 / view.ViewportSize[0], 2.0 / view.ViewportSize[1] };
  const double n[3][2] = { { -1.0 + step[0] * view.PictureOrigin[0],
                             -1.0 + step[1] * view.PictureOrigin[1] },
    { step[0], 0.0 }, { 0.0, step[1] } };
  const double none[2] = { 0.0, 0.0 };
  const double originOffset[2] = { -p[2] * distance + p[3], -p[6] * distance + p[7] };
  const double directionOffset[2] = { -p[2], -p[6] };
  const bool corner = i == 0;
  rays.Solve(p[15] - p[14] * distance, n[i], corner ? originOffset : none, origin);
  rays.Solve(-p[14], n[i], corner ? directionOffset : none, direction);
  origin[2] = corner ? -distance : 0.0;
  direction[2] = corner ? -1.0 : 0.0;
}

void TransformVector(const double matrix[16], const double v[3], double w, double out[3])
{
  for (int i = 0; i < 3; ++i)
  {
    out[i] = matrix[4 * i] * v[0] + matrix[4 * i + 1] * v[1] + matrix[4 * i + 2] * v[2] +
      matrix[4 * i + 3] * w;
  }
}

// Half of a side of a pixel at the distance s, as a sum of a constant and a multiple of s. Where
// the pixels' edges begin and where they go are parallel.
glm::vec2 GetHalfSide(const double atOrigin[3], const double perS[3])
{
  const double sign = vtkMath::Dot(atOrigin, perS) < 0.0 ? -0.5 : 0.5;
  return glm::vec2(static_cast<float>(0.5 * vtkMath::Norm(atOrigin)),
    static_cast<float>(sign * vtkMath::Norm(perS)));
}

// s at which the depth is -1 (near) or 1 (far) in normalized device coordinates.
float GetPlaneS(const double z[2], const double w[2], double side)
{
  const double s = (side * w[0] - z[0]) / (z[1] - side * w[1]);
  const double limit = std::numeric_limits<float>::max();
  return static_cast<float>(std::isfinite(s) ? std::clamp(s, -limit, limit) : side * limit);
}

// Inverse transpose of the upper left 3x3 part, up to scale: normals are normalized where used.
glm::mat3 GetNormalMatrix(const double matrix[16])
{
  double linear[3][3];
  double largest = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    linear[i / 3][i % 3] = matrix[4 * (i / 3) + i % 3];
    largest = std::max(largest, std::abs(linear[i / 3][i % 3]));
  }
  for (auto& row : linear)
  {
    std::transform(row, row + 3, row, [largest](double v) { return v / largest; });
  }
  double inverse[3][3];
  vtkMath::Invert3x3(linear, inverse);
  glm::mat3 normals;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      normals[column][row] = static_cast<float>(inverse[column][row]);
    }
  }
  return normals;
}

void GetWorldFromLocal(const vtkVoxelLineFrameBuilder::View& view,
  const vtkVoxelLineFrameBuilder::Grid& grid, double worldFromLocal[16])
{
  double dataFromLocal[16];
  GetDataFromLocal(grid, dataFromLocal);
  Multiply(view.WorldFromData, dataFromLocal, worldFromLocal);
}

// The half space that a plane in world coordinates keeps, in grid-local coordinates.
void AddPlane(const double worldFromLocal[16], const double normal[3], const double origin[3],
  std::vector<glm::vec4>& planes)
{
  double local[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      local[j] += worldFromLocal[4 * i + j] * normal[i];
    }
    // The difference first: both terms may be large.
    local[3] += (worldFromLocal[4 * i + 3] - origin[i]) * normal[i];
  }
  const double length = vtkMath::Norm(local);
  if (length > 0.0)
  {
    planes.emplace_back(static_cast<float>(local[0] / length),
      static_cast<float>(local[1] / length), static_cast<float>(local[2] / length),
      static_cast<float>(local[3] / length));
  }
}

bool IsNear(float a, float b, float tolerance)
{
  return a == b || std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

// Whether three vectors are alike, of which the last two are steps from pixel to pixel: to a part
// of a step that nobody sees, over the whole picture.
bool AreSteppingAlike(const glm::vec3 a[3], const glm::vec3 b[3], float pixels)
{
  constexpr float part = 1.0f / 256.0f;
  const float step = std::max(glm::length(a[1]), glm::length(a[2]));
  const float tolerance = std::max(part * step, 1e-6f * glm::length(a[0]));
  return glm::length(a[0] - b[0]) <= tolerance && pixels * glm::length(a[1] - b[1]) <= tolerance &&
    pixels * glm::length(a[2] - b[2]) <= tolerance;
}

// Views that differ by rounding are the same: whoever sets a camera to where it was need not get
// the very same numbers.
bool IsSameView(const vtkVoxelLineFrame& a, const vtkVoxelLineFrame& b)
{
  constexpr float tolerance = 1e-5f;
  const float pixels = static_cast<float>(std::max({ a.Width, a.Height, 1 }));
  bool same = a.Width == b.Width && a.Height == b.Height &&
    AreSteppingAlike(a.Origin, b.Origin, pixels) &&
    AreSteppingAlike(a.Direction, b.Direction, pixels) &&
    IsNear(a.NearestS, b.NearestS, tolerance) && IsNear(a.FarthestS, b.FarthestS, tolerance);
  for (int i = 0; i < 2; ++i)
  {
    same = same && IsNear(a.DepthZ[i], b.DepthZ[i], tolerance) &&
      IsNear(a.DepthW[i], b.DepthW[i], tolerance);
  }
  for (int i = 0; i < 4; ++i)
  {
    same = same &&
      glm::length(a.ViewFromLocal[i] - b.ViewFromLocal[i]) <=
        tolerance * glm::length(a.ViewFromLocal[i]) &&
      (i == 3 ||
        glm::length(a.NormalFromLocal[i] - b.NormalFromLocal[i]) <=
          tolerance * glm::length(a.NormalFromLocal[i]));
  }
  return same;
}
}

//------------------------------------------------------------------------------
vtkVoxelLineFrameBuilder::View vtkVoxelLineFrameBuilder::GetView(
  vtkRenderer* renderer, vtkActor* actor, int width, int height)
{
  View view;
  view.ViewportSize[0] = view.PictureSize[0] = width;
  view.ViewportSize[1] = view.PictureSize[1] = height;
  vtkCamera* camera = renderer->GetActiveCamera();
  if (auto* glCamera = vtkOpenGLCamera::SafeDownCast(camera))
  {
    // The very matrices that other actors use; they come transposed.
    vtkMatrix4x4* viewFromWorld;
    vtkMatrix3x3* normals;
    vtkMatrix4x4* clipFromView;
    vtkMatrix4x4* clipFromWorld;
    glCamera->GetKeyMatrices(renderer, viewFromWorld, normals, clipFromView, clipFromWorld);
    vtkMatrix4x4::Transpose(viewFromWorld->GetData(), view.ViewFromWorld);
    vtkMatrix4x4::Transpose(clipFromView->GetData(), view.ClipFromView);
  }
  else
  {
    vtkMatrix4x4::DeepCopy(view.ViewFromWorld, camera->GetModelViewTransformMatrix());
    vtkMatrix4x4::DeepCopy(view.ClipFromView,
      camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  }
  actor->ComputeMatrix();
  vtkMatrix4x4::DeepCopy(view.WorldFromData, actor->GetMatrix());
  return view;
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineFrameBuilder::SetView(
  vtkVoxelLineFrame& frame, const View& view, const Grid& grid)
{
  double dataFromLocal[16];
  GetDataFromLocal(grid, dataFromLocal);
  double viewFromData[16];
  double viewFromLocal[16];
  // First the two that may hold large opposite translations, then the small scale.
  Multiply(view.ViewFromWorld, view.WorldFromData, viewFromData);
  Multiply(viewFromData, dataFromLocal, viewFromLocal);
  double localFromView[16];
  vtkMatrix4x4::Invert(viewFromLocal, localFromView);
  const double determinant = vtkMatrix4x4::Determinant(viewFromLocal);
  if (!IsFinite(viewFromLocal, 16) || !IsFinite(localFromView, 16) || determinant == 0.0)
  {
    return "the matrix of the actor or of the camera is not finite or cannot be inverted";
  }
  const ViewRays rays(view.ClipFromView);
  if (!IsFinite(view.ClipFromView, 16) || !rays.IsValid())
  {
    return "the camera's projection matrix is not one whose depth depends on the distance along "
           "the view direction alone";
  }

  frame.Width = view.PictureSize[0];
  frame.Height = view.PictureSize[1];

  // The origins lie on the plane where the box of all that is drawn begins, but not before the
  // near plane: s is then small wherever the camera stands.
  const double* p = view.ClipFromView;
  const double zNear = -(p[11] + p[15]) / (p[10] + p[14]);
  double distances[2];
  GetBoxDistances(grid, viewFromLocal, distances);
  const double distance = std::isfinite(zNear) ? std::max(distances[0], -zNear) : distances[0];
  frame.HalfPixel = glm::vec2(0.0f);
  for (int i = 0; i < 3; ++i)
  {
    double origin[3];
    double direction[3];
    GetRayPart(rays, i, view, distance, origin, direction);
    double local[3];
    TransformVector(localFromView, origin, i == 0 ? 1.0 : 0.0, local);
    frame.Origin[i] = ToVec3(local);
    double perS[3];
    TransformVector(localFromView, direction, 0.0, perS);
    frame.Direction[i] = ToVec3(perS);
    const glm::vec2 side = GetHalfSide(local, perS);
    if (i > 0 && side.x + std::abs(side.y) > frame.HalfPixel.x + std::abs(frame.HalfPixel.y))
    {
      frame.HalfPixel = side;
    }
  }

  const double z[2] = { p[11] - p[10] * distance, -p[10] };
  const double w[2] = { p[15] - p[14] * distance, -p[14] };
  frame.NearestS = GetPlaneS(z, w, -1.0);
  frame.FarthestS = GetPlaneS(z, w, 1.0);
  frame.BoxS = glm::vec2(
    static_cast<float>(distances[0] - distance), static_cast<float>(distances[1] - distance));
  frame.DepthZ = glm::vec2(static_cast<float>(z[0]), static_cast<float>(z[1]));
  frame.DepthW = glm::vec2(static_cast<float>(w[0]), static_cast<float>(w[1]));

  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      frame.ViewFromLocal[column][row] = static_cast<float>(viewFromLocal[4 * row + column]);
    }
  }
  frame.NormalFromLocal = GetNormalMatrix(viewFromLocal);
  return {};
}

//------------------------------------------------------------------------------
double vtkVoxelLineFrameBuilder::GetLargestWidening(const Grid& grid, double segments)
{
  int sides[3];
  std::copy(grid.Dimensions, grid.Dimensions + 3, sides);
  std::sort(sides, sides + 3);
  const double section = static_cast<double>(sides[1]) * sides[2];
  return std::max(2.0, 0.5 * std::sqrt(4096.0 * section / std::max(segments, 1.0)));
}

//------------------------------------------------------------------------------
bool vtkVoxelLineFrameBuilder::SetWidths(
  vtkVoxelLineFrame& frame, double smallest, bool widen, double limit)
{
  const float nearest = std::max(frame.NearestS, frame.BoxS.x);
  const float farthest = std::min(frame.FarthestS, frame.BoxS.y);
  const double perS = frame.HalfPixel.y;
  const double largest = frame.HalfPixel.x + std::max(perS * nearest, perS * farthest);
  const bool visible = widen && nearest <= farthest && frame.Radius > 0.0f;
  frame.NarrowTubes = visible && smallest < 2.0 * largest;
  frame.ThinTubes = visible && smallest < largest;
  frame.LargestRadius = frame.Radius;
  if (frame.ThinTubes)
  {
    // With the tubes the box grows, and with the box the largest distance.
    double perVoxel = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      perVoxel += std::abs(frame.ViewFromLocal[i].z);
    }
    perVoxel *= std::abs(perS);
    const double radius = perVoxel < 1.0 ? largest / (1.0 - perVoxel) : limit;
    frame.LargestRadius = std::max(frame.Radius, static_cast<float>(std::min(radius, limit)));
    return largest > std::max(limit, static_cast<double>(frame.Radius));
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkVoxelLineFrameBuilder::SetClippingPlanes(
  vtkVoxelLineFrame& frame, vtkPlaneCollection* planes, const View& view, const Grid& grid)
{
  frame.ClippingPlanes.clear();
  if (!planes)
  {
    return;
  }
  double worldFromLocal[16];
  GetWorldFromLocal(view, grid, worldFromLocal);
  vtkCollectionSimpleIterator iterator;
  planes->InitTraversal(iterator);
  while (vtkPlane* plane = planes->GetNextPlane(iterator))
  {
    double normal[3];
    double origin[3];
    plane->GetNormal(normal);
    plane->GetOrigin(origin);
    AddPlane(worldFromLocal, normal, origin, frame.ClippingPlanes);
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineFrameBuilder::SetRegion(
  vtkVoxelLineFrame& frame, const double region[6], const View& view, const Grid& grid)
{
  frame.RegionPlanes.clear();
  double worldFromLocal[16];
  GetWorldFromLocal(view, grid, worldFromLocal);
  for (int side = 0; side < 6; ++side)
  {
    if (std::isfinite(region[side]))
    {
      double normal[3] = { 0.0, 0.0, 0.0 };
      double origin[3] = { 0.0, 0.0, 0.0 };
      normal[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
      origin[side / 2] = region[side];
      AddPlane(worldFromLocal, normal, origin, frame.RegionPlanes);
    }
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineFrameBuilder::SetProperty(vtkVoxelLineFrame& frame, vtkProperty* property)
{
  frame.AmbientColor = ToVec3(property->GetAmbientColor());
  frame.DiffuseColor = ToVec3(property->GetDiffuseColor());
  frame.SpecularColor = ToVec3(property->GetSpecularColor());
  frame.Ambient = static_cast<float>(property->GetAmbient());
  frame.Diffuse = static_cast<float>(property->GetDiffuse());
  frame.Specular = static_cast<float>(property->GetSpecular());
  frame.Opacity = static_cast<float>(property->GetOpacity());
}

//------------------------------------------------------------------------------
bool vtkVoxelLineFrameBuilder::SetLighting(vtkVoxelLineFrame& frame, vtkRenderer* renderer,
  vtkLineIllumination* illumination, vtkProperty* property)
{
  frame.Light.SetRenderer(renderer);
  const bool isValid = frame.Light.SetModel(illumination, property);
  frame.Lighting = property->GetLighting() && !frame.Light.Lights.empty();
  // The brightest light of any facet, and stretched light, are not what a surface reflects.
  frame.LitAsLines = illumination->GetModel() == vtkLineIllumination::MaximumReflection ||
    illumination->GetStretchDynamicRange();
  return isValid || !frame.Lighting;
}

//------------------------------------------------------------------------------
bool vtkVoxelLineFrameBuilder::IsSamePicture(const vtkVoxelLineFrame& a, const vtkVoxelLineFrame& b)
{
  const bool sameView =
    IsSameView(a, b) && a.ClippingPlanes == b.ClippingPlanes && a.RegionPlanes == b.RegionPlanes;
  const bool sameColors = a.Coloring == b.Coloring && a.HasNaN == b.HasNaN &&
    (a.Coloring != vtkVoxelLineFrame::Table || a.ColorTable == b.ColorTable);
  const bool sameMaterial = a.AmbientColor == b.AmbientColor && a.DiffuseColor == b.DiffuseColor &&
    a.SpecularColor == b.SpecularColor && a.Ambient == b.Ambient && a.Diffuse == b.Diffuse &&
    a.Specular == b.Specular && a.Opacity == b.Opacity && a.Lighting == b.Lighting;
  return sameView && sameColors && sameMaterial && a.Light == b.Light && a.Radius == b.Radius &&
    a.LitAsLines == b.LitAsLines && a.NarrowTubes == b.NarrowTubes && a.ThinTubes == b.ThinTubes &&
    IsNear(a.LargestRadius, b.LargestRadius, 1e-5f) && a.EarlyTermination == b.EarlyTermination &&
    a.AccelerationOpacity == b.AccelerationOpacity &&
    a.OpacityByPathLength == b.OpacityByPathLength && a.Interactive == b.Interactive &&
    a.Global == b.Global && a.SecondaryRays == b.SecondaryRays && a.LevelRays == b.LevelRays &&
    a.ShadowLevel == b.ShadowLevel && a.Picking == b.Picking;
}

//------------------------------------------------------------------------------
void vtkVoxelLineFrameBuilder::GetDataPosition(
  const vtkVoxelLineFrame& frame, const Grid& grid, int x, int y, double depth, double position[3])
{
  const double ndc = 2.0 * depth - 1.0;
  const double s = (ndc * frame.DepthW[0] - frame.DepthZ[0]) /
    (frame.DepthZ[1] - ndc * static_cast<double>(frame.DepthW[1]));
  for (int i = 0; i < 3; ++i)
  {
    const double origin =
      frame.Origin[0][i] + (x + 0.5) * frame.Origin[1][i] + (y + 0.5) * frame.Origin[2][i];
    const double direction =
      frame.Direction[0][i] + (x + 0.5) * frame.Direction[1][i] + (y + 0.5) * frame.Direction[2][i];
    position[i] = grid.Origin[i] + grid.VoxelSize * (origin + s * direction);
  }
}
