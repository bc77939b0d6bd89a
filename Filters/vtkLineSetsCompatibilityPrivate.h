// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * All differences between the versions of VTK that the project builds with, in one place.
 *
 * The code is written for the newest release; what an older one lacks is supplied here. Only
 * sources, tests and private headers include this file, never a public header.
 *
 * A source that calls OpenGL defines LINESETS_USE_OPENGL before including this file and gets VTK's
 * OpenGL loader with it; without that definition nothing of OpenGL is included, so that Filters
 * stay free of it.
 */

#ifndef vtkLineSetsCompatibilityPrivate_h
#define vtkLineSetsCompatibilityPrivate_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

#include <string>

namespace vtkLineSetsCompatibility
{
/**
 * Whether the algorithm should stop: asked for by the user or, from VTK 9.3 on, by an algorithm
 * upstream or downstream. Call it from one thread only (vtkSMPTools::GetSingleThread), once per
 * batch: newer versions look up the pipeline.
 */
inline bool CheckAbort(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/**
 * Choose between order-independent (true, the default of every version) and sorted drawing of
 * translucent props. VTK before 9.5 has no choice: the return value says whether it was taken.
 */
template <typename RendererT>
bool SetUseOIT(RendererT* renderer, bool useOIT)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
  renderer->SetUseOIT(useOIT);
  return true;
#else
  static_cast<void>(renderer);
  return useOIT;
#endif
}

/**
 * Takes out of a fragment shader what VTK from 9.6 on appends for PBR, even where it lights
 * nothing: the encoding of linear colours. Colours that are not lit by PBR are not linear.
 */
inline void RemoveColorEncoding(std::string& source)
{
  const std::string encoding = "gl_FragData[0].rgb = pow(gl_FragData[0].rgb, vec3(1.0/2.2));";
  const std::size_t place = source.find(encoding);
  if (place != std::string::npos)
  {
    source.erase(place, encoding.size());
  }
}
}

#endif // vtkLineSetsCompatibilityPrivate_h

// Outside the include guard: a source may ask for OpenGL after a header has included this file.
#ifdef LINESETS_USE_OPENGL
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
#include "vtk_glad.h" // IWYU pragma: keep
#else
#include "vtk_glew.h" // IWYU pragma: keep
#endif
#endif

// VTK-HeaderTest-Exclude: vtkLineSetsCompatibilityPrivate.h
