// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What VTK's fragment shaders call.

uniform mat4 LocalFromWindow;
uniform vec3 LocalViewer;
uniform float ViewerDistant;

// A point that VTK gives no position and no normal, as it does to lines; for hemispheres it faces
// the viewer.
void receiveInWindow(bool faces)
{
  vec4 position = LocalFromWindow * vec4(gl_FragCoord.xyz, 1.0);
  vec3 local = position.xyz / position.w;
  receiveAt(local, vec3(0.0));
  ShadedNormal = faces ? normalize(LocalViewer - local * (1.0 - ViewerDistant)) : vec3(0.0);
}

// What VTK has lit, light by light.
float receivedOnSurface(vec3 position, vec3 normal)
{
  receiveInView(position, normal);
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
