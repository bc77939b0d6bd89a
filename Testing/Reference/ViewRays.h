// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rays through the pixels of a view. A ray has one parameter t in all spaces: t is the distance
 * from the near plane in view coordinates.
 *
 * Model coordinates are those of the data, relative to a reference point near the data; together
 * with world coordinates relative to the camera this keeps data precise that lies far from the
 * origin.
 */

#ifndef ViewRays_h
#define ViewRays_h

class vtkCamera;
class vtkMatrix4x4;

namespace linesets
{
struct Ray
{
  double ViewOrigin[3]; ///< on the near plane
  double ViewDirection[3];
  double ModelOrigin[3];
  double ModelDirection[3];
  double Length; ///< t at the far plane
};

class ViewRays
{
public:
  /**
   * View of a camera (perspective or parallel) on a viewport of width x height pixels, of an actor
   * with an affine matrix (null: identity). `reference` is the point of the data that model
   * coordinates are relative to.
   */
  ViewRays(
    vtkCamera* camera, int width, int height, vtkMatrix4x4* actor, const double reference[3]);

  /// Ray through a point of the viewport in pixels; the centre of pixel (i,j) is (i+0.5, j+0.5).
  Ray GetRay(double x, double y) const;

  /// Depth buffer value, 0 to 1, of a point in view coordinates.
  double GetDepth(const double viewPoint[3]) const;

  /// Parameter of the ray through (x,y) at which the depth buffer has the given value.
  double GetParameter(double x, double y, double depth) const;

  /// Unit normal in view coordinates for a normal in model coordinates.
  void TransformNormal(const double model[3], double view[3]) const;

  /**
   * Restrict [first, last] of a ray to where normal . (x - origin) >= 0 for a plane in world
   * coordinates.
   */
  void Clip(const Ray& ray, const double origin[3], const double normal[3], double& first,
    double& last) const;

private:
  void Unproject(double x, double y, double depth, double view[3]) const;

  int Width;
  int Height;
  double Projection[16];
  double InverseProjection[16];
  double CameraPosition[3];
  double ViewOfCamera[3];        // view coordinates of the camera's position, 0 in all usual cases
  double ReferenceFromCamera[3]; // world coordinates of the reference point, camera subtracted
  double ViewToWorld[3][3];
  double WorldToModel[3][3];
  double ViewToModel[3][3];
  double NormalToView[3][3];
};
}

#endif
