// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityPrograms
 * @brief   one shader program for each stage of each kind of primitive
 *
 * A mapper of VTK has one program per kind of primitive, and makes its text anew when another one
 * is needed, which takes about a tenth of a millisecond. A mapper that is drawn stage after stage
 * in every frame keeps them: Use() puts the program of a stage in the place of the last one, so
 * that VTK goes on with it as if there were no other.
 */

#ifndef vtkFourierOpacityPrograms_h
#define vtkFourierOpacityPrograms_h

#include "vtkOpenGLHelper.h"
#include "vtkTimeStamp.h"

#include <cstddef>
#include <map>

class vtkShaderProgram;

class vtkFourierOpacityPrograms
{
public:
  vtkFourierOpacityPrograms() = default;

  /// Put the program of a key in place; there may be none yet.
  void Use(vtkOpenGLHelper& primitives, std::size_t key);

  /// Forget the programs of all other keys of the primitives: what they were made for has changed.
  void ForgetOthers(vtkOpenGLHelper& primitives);

  /// Forget all.
  void Clear() { this->Primitives.clear(); }

private:
  vtkFourierOpacityPrograms(const vtkFourierOpacityPrograms&) = delete;
  void operator=(const vtkFourierOpacityPrograms&) = delete;

  struct Entry
  {
    vtkShaderProgram* Program = nullptr;
    vtkTimeStamp ShaderSourceTime;
  };
  struct Programs
  {
    std::size_t Current = 0;
    std::map<std::size_t, Entry> Entries;
  };
  std::map<const vtkOpenGLHelper*, Programs> Primitives;
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityPrograms.h
