// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The decoded segments of a vtkVoxelLineModel as capsules: what a renderer of the model should
 * show, whatever the model has lost.
 */

#ifndef CapsulesFromModel_h
#define CapsulesFromModel_h

#include "Capsule.h"

class vtkVoxelLineModel;

namespace linesets
{
/**
 * One capsule per segment in the order of the model, its curve the model's curve. Coordinates are
 * relative to the model's Origin. Radii and attributes are those of the model's bytes; without
 * radii in the model, `radius` (in world units) holds for all.
 */
CapsuleScene MakeCapsulesFromModel(vtkVoxelLineModel* model, double radius);
}

#endif
