// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityShader
 * @brief   code that makes the shaders of a mapper draw a stage of opacity optimization
 *
 * It goes into the shaders of vtkOpenGLPolyDataMapper, so that clipping, colours and light are
 * the mapper's own. Stages that need no colour end the fragment shader before it is computed.
 */

#ifndef vtkFourierOpacityShader_h
#define vtkFourierOpacityShader_h

#include "vtkShader.h"

#include <map>

struct vtkFourierOpacityStage;

namespace vtkFourierOpacityShader
{
/// Names of vertex attributes: importance; three elements; the weights of the first two.
constexpr const char* ImportanceAttribute = "fourierImportanceMC";
constexpr const char* ElementsAttribute = "fourierElementsMC";
constexpr const char* WeightsAttribute = "fourierWeightsMC";

/**
 * Put a stage into the shaders before the mapper replaces VTK's tags. Without elements per vertex
 * each vertex is one. lateOpacity: the opacity of a fragment is known only with its colour.
 * isPoints: what is drawn are points, each of one vertex. hasHalo: what is drawn are lines, made
 * wide by a geometry shader, and the stage gives them halos. regionPlanes: number of planes in clip
 * coordinates, fourierRegion[], beyond which nothing is drawn that is seen; what is measured of
 * importance is not cut off.
 */
void Insert(std::map<vtkShader::Type, vtkShader*>& shaders, const vtkFourierOpacityStage& stage,
  bool hasElements, bool lateOpacity, bool isPoints, bool hasHalo, int regionPlanes);

/// Whether planes of a region cut off what a stage draws.
bool IsCutOff(const vtkFourierOpacityStage& stage);
}

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityShader.h
