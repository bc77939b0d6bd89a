// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What tests of vtkFourierOpacityPass share: a window drawn by it, and actors of squares.
 */

#ifndef FourierOpacityPassTesting_h
#define FourierOpacityPassTesting_h

#include "FourierOpacityScene.h"

#include "vtkFourierOpacityPass.h"

namespace FourierOpacityTesting
{
inline void UsePass(vtkRenderer* renderer, vtkRenderPass* pass)
{
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(pass);
  vtkOpenGLRenderer::SafeDownCast(renderer)->SetPass(steps);
}

inline vtkSmartPointer<vtkFourierOpacityMapper> MakeOpacityMapper(vtkPolyData* data)
{
  auto mapper = vtkSmartPointer<vtkFourierOpacityMapper>::New();
  mapper->SetImportanceArrayName("Importance");
  mapper->SetImportanceRange(0.0, 1.0);
  mapper->SetInputData(data);
  return mapper;
}

/// An off-screen window that looks along -z at what lies between -1 and 1, drawn by the pass.
struct PassStage : Stage
{
  vtkNew<vtkFourierOpacityPass> Pass;

  explicit PassStage(int width = SceneSize, int height = SceneSize)
    : Stage(width, height)
  {
    LookAlongZ(*this);
    UsePass(this->Renderer, this->Pass);
  }

  Optimization* GetOptimization() { return this->Pass->GetOptimization(); }

  vtkSmartPointer<vtkActor> AddItem(vtkMapper* mapper)
  {
    auto actor = this->Add(mapper);
    actor->GetProperty()->LightingOff();
    return actor;
  }

  vtkSmartPointer<vtkActor> AddItem(vtkPolyData* data)
  {
    return this->AddItem(MakeOpacityMapper(data));
  }
};

/// What MakeScene() holds, with the importance of each.
struct SceneSquares
{
  std::vector<Square> Squares = MakeSquares(9, 40, 250);
  std::vector<double> Importance;

  SceneSquares()
  {
    Random random(8);
    for (Square& square : this->Squares)
    {
      square.X = random(-0.2, 0.2);
      square.Y = random(-0.2, 0.2);
      this->Importance.push_back(random(0.0, 1.0) * random(0.0, 1.0));
    }
  }

  /// Every count-th one, from some one on.
  vtkSmartPointer<vtkPolyData> MakePart(int first, int count) const
  {
    std::vector<int> order;
    for (int i = first; i < static_cast<int>(this->Squares.size()); i += count)
    {
      order.push_back(i);
    }
    return MakeStack(this->Squares, this->Importance, order);
  }
};

/// The same scene as Scene, of three actors whose squares lie between each other.
struct PassScene : PassStage
{
  std::vector<vtkSmartPointer<vtkActor>> Actors;

  explicit PassScene(const Method& method = {}, int width = SceneSize, int height = SceneSize)
    : PassStage(width, height)
  {
    SetMethod(this->GetOptimization(), method);
    const SceneSquares squares;
    for (int i = 0; i < 3; ++i)
    {
      this->Actors.push_back(this->AddItem(squares.MakePart(i, 3)));
    }
    this->AddSphere(0.1, -0.3, 0.0, 0.25)->GetProperty()->SetColor(0.3, 0.9, 0.2);
  }
};
}

#endif
