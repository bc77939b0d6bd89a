// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What VTK's fragment shaders call.

uniform mat4 LocalFromWindow;
uniform vec3 LocalViewer;
uniform float ViewerDistant;

vec3 towardViewer()
{
  return normalize(LocalViewer - ShadedPoint * (1.0 - ViewerDistant));
}

// A point that VTK gives no position and no normal, as it does to lines; for hemispheres it faces
// the viewer.
void receiveInWindow(bool faces)
{
  vec4 position = LocalFromWindow * vec4(gl_FragCoord.xyz, 1.0);
  receiveAt(position.xyz / position.w, vec3(0.0));
  ShadedNormal = faces ? towardViewer() : vec3(0.0);
}

// What VTK has lit, light by light. Data may give null normals, which stand on no hemisphere: the
// point faces the viewer then.
float receivedOnSurface(vec3 position, vec3 normal)
{
  receiveInView(position, normal);
  ShadedNormal = ShadedNormal == vec3(0.0) ? towardViewer() : ShadedNormal;
  return receivedAmbient();
}

// What VTK draws without light.
float receivedOnUnlit()
{
  receiveInWindow(false);
  float light = receivedMean();
  receiveInWindow(true);
  return light * receivedAmbient();
}

// What vtkIlluminatedLineMapper has lit.
float receivedOnLine()
{
  receiveInWindow(true);
  return receivedAmbient();
}
