// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsQuad
 * @brief   draws a quad over the viewport with a fragment shader
 *
 * Unlike vtkOpenGLQuadHelper it asks nothing of the shader, which finds its pixel by gl_FragCoord;
 * programs stay in the window's shader cache.
 */

#ifndef vtkLineSetsQuad_h
#define vtkLineSetsQuad_h

#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace vtkLineSetsQuad
{
/// Compile a fragment shader, if it is not known yet, and use it; nullptr where that fails.
vtkShaderProgram* ReadyProgram(vtkOpenGLRenderWindow* window, const std::string& fragmentShader);

/// Draw with the program in use. Returns an empty string, or what went wrong.
std::string Draw(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);
}

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsQuad.h
