// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What tests of translucency share: VTK's three ways to draw translucent actors, and the colour
 * that they give.
 */

#ifndef RenderPassTesting_h
#define RenderPassTesting_h

#include "VoxelLineMapperTesting.h"

#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"

namespace VoxelLineMapperTesting
{
enum Pass
{
  Independent, // order-independent translucency, VTK's own choice
  Peeling,     // dual depth peeling
  Plain        // drawn and blended one after the other
};
constexpr const char* PassNames[] = { "order-independent", "peeling", "plain" };

inline void SetPass(Stage& stage, Pass pass)
{
  if (pass == Peeling)
  {
    stage.Renderer->UseDepthPeelingOn();
    stage.Renderer->SetMaximumNumberOfPeels(20);
    stage.Renderer->SetOcclusionRatio(0.0);
  }
  else if (pass == Plain)
  {
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(vtkNew<vtkLightsPass>());
    passes->AddItem(vtkNew<vtkOpaquePass>());
    passes->AddItem(vtkNew<vtkTranslucentPass>());
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(sequence);
    vtkOpenGLRenderer::SafeDownCast(stage.Renderer)->SetPass(camera);
  }
}

/// The colour a, of an opacity, over b.
inline std::array<int, 3> Mix(
  const std::array<int, 3>& a, const std::array<int, 3>& b, double weightOfA)
{
  std::array<int, 3> mixed;
  for (int i = 0; i < 3; ++i)
  {
    mixed[i] = static_cast<int>(std::lround(weightOfA * a[i] + (1.0 - weightOfA) * b[i]));
  }
  return mixed;
}
}

#endif
