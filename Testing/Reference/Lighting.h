// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The light model of VTK's polydata mapper (vtkOpenGLPolyDataMapper and vtkOpenGLRenderer of VTK
 * 9.1, all interpolations but PBR), in double precision and with a normal per pixel.
 *
 * In view coordinates, with the surface point p, the unit normal n, v = -p / |p| and for each light
 * the colour c = intensity * diffuse colour:
 *   color = ambient + diffuse * sum_l df_l c_l + specular * sum_l sf_l c_l
 * where ambient, diffuse and specular are the material's colours times their coefficients. The
 * lights that are switched on decide on one of four cases:
 * - 0, no light, or a material without lighting: color = ambient + diffuse;
 * - 1, a single headlight: df = max(0, n_z), sf = df^power;
 * - 2, directional lights with direction l: df = max(0, -n.l),
 *   sf = sign(df) max(0, reflect(l, n).v)^power, with reflect(l, n) = l - 2 (n.l) n;
 * - 3, at least one positional light: as 2 with df = max(0, -a n.l) and sf = sign(df) a
 * (...)^power. For a positional light at q, l = (p - q) / |p - q| and, with d = |p - q|, a = 1 /
 * (a0 + a1 d + a2 d^2), times (l.axis)^exponent inside the cone of a light whose cone angle is
 * below 90 degrees, and a = 0 outside it. a = 1 for other lights. The colour is clamped to [0,1],
 * as a framebuffer with 8 bits per channel does before it blends.
 *
 * In parallel views v = (0, 0, 1), the direction from which the surface is seen. There VTK itself
 * takes -p / |p| as well, by which highlights move with the camera's distance.
 */

#ifndef Lighting_h
#define Lighting_h

#include <vector> // For Lights

class vtkProperty;
class vtkRenderer;

namespace linesets
{
/// Coefficients and colours of a vtkProperty, with VTK's defaults.
struct Material
{
  bool Lighting = true;
  double Ambient = 0.0;
  double Diffuse = 1.0;
  double Specular = 0.0;
  double SpecularPower = 1.0;
  double Opacity = 1.0;
  double AmbientColor[3] = { 1.0, 1.0, 1.0 };
  double DiffuseColor[3] = { 1.0, 1.0, 1.0 };
  double SpecularColor[3] = { 1.0, 1.0, 1.0 };

  static Material FromProperty(vtkProperty* property);
};

/// One light, in view coordinates.
struct Light
{
  double Color[3] = { 1.0, 1.0, 1.0 };
  double Direction[3] = { 0.0, 0.0, -1.0 };
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Attenuation[3] = { 1.0, 0.0, 0.0 };
  double ConeAngle = 90.0; ///< degrees
  double Exponent = 1.0;
  bool Positional = false;
};

/// All lights of a scene. By default a single white headlight.
struct LightSet
{
  int Complexity = 1; ///< case 0 to 3 above
  std::vector<Light> Lights = std::vector<Light>(1);
  bool ParallelView = false; ///< whether v is (0, 0, 1)

  /**
   * The lights of a renderer as it uses them with its active camera. Lights that follow the camera
   * are moved with it, and a renderer without lights is counted as one with the headlight that it
   * would create. The user light transform of vtkOpenGLRenderer is not looked at.
   */
  static LightSet FromRenderer(vtkRenderer* renderer);
};

/**
 * Colour of a surface point in view coordinates. `colors` replaces the ambient and the diffuse
 * colour of the material where it is not null, as scalars do in VTK.
 */
void Shade(const LightSet& lights, const Material& material, const double* colors,
  const double point[3], const double normal[3], double rgb[3]);
}

#endif
