// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityFrame.h"

#include "vtkFourierOpacityElements.h"
#include "vtkFragmentLists.h"
#include "vtkOpacityOptimization.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <cmath>

namespace
{
void SetIfUsed(vtkShaderProgram* program, const char* name, int value)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniformi(name, value);
  }
}
}

//------------------------------------------------------------------------------
vtkFourierOpacityFrame::vtkFourierOpacityFrame(vtkRenderer* renderer,
  const std::vector<vtkFourierOpacityItem>& items, vtkOpacityOptimization* optimization,
  const vtkFourierOpacityDrawFunction& drawItem, const vtkFourierOpacityView& view,
  vtkFourierOpacityElements& elements)
  : Window(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
  , State(this->Window->GetState())
  , Items(items)
  , Optimization(optimization)
  , DrawItem(drawItem)
  , Now(view)
  , Stages(optimization, view.IsParallel)
  , Elements(elements)
{
}

//------------------------------------------------------------------------------
void vtkFourierOpacityFrame::SetParameters(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("fourierProjection"))
  {
    const double* from = this->Now.Projection;
    const float projection[4] = { static_cast<float>(from[0]), static_cast<float>(from[1]),
      static_cast<float>(from[2]), static_cast<float>(from[3]) };
    program->SetUniform4f("fourierProjection", projection);
  }
  if (program->IsUniformUsed("fourierRange"))
  {
    const double near = this->Now.Range[0];
    const double far = this->Now.Range[1];
    const double size = this->Stages.IsLogarithmic ? std::log(far / near) : far - near;
    const float range[2] = { static_cast<float>(near), static_cast<float>(1.0 / size) };
    program->SetUniform2f("fourierRange", range);
  }
  if (program->IsUniformUsed("fourierWeights"))
  {
    vtkOpacityOptimization* from = this->Optimization;
    const float weights[4] = { static_cast<float>(from->GetRegularizationWeight()),
      static_cast<float>(from->GetForegroundWeight()),
      static_cast<float>(from->GetBackgroundWeight()), static_cast<float>(from->GetEmphasis()) };
    program->SetUniform4f("fourierWeights", weights);
  }
  if (program->IsUniformUsed("fourierOrigin"))
  {
    program->SetUniform2i("fourierOrigin", this->Origin);
  }
  if (program->IsUniformUsed("fourierMeanFactor"))
  {
    program->SetUniformf("fourierMeanFactor", this->MeanFactor);
  }
  if (program->IsUniformUsed("fourierSize"))
  {
    program->SetUniform2i("fourierSize", this->Now.Size);
  }
  if (program->IsUniformUsed("fourierShift"))
  {
    program->SetUniform2f("fourierShift", this->Shift);
  }
  SetIfUsed(program, "fourierElementShift", this->ElementShift);
  SetIfUsed(program, "fourierSmallest", static_cast<int>(SmallestUnit));
  this->Textures.SetParameters(program);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityFrame::DrawStage(vtkFourierOpacityStage& stage)
{
  stage.SetParameters = [&](vtkShaderProgram* program)
  {
    this->SetParameters(program);
    SetIfUsed(program, "fourierFirstElement", stage.FirstElement);
    if (this->Lists)
    {
      this->Lists->SetParameters(program);
    }
  };
  stage.MakeKey();
  for (std::size_t i = 0; i < this->Items.size(); ++i)
  {
    stage.FirstElement = static_cast<int>(this->Elements.GetFirstElement(i));
    this->DrawItem(this->Items[i], stage);
  }
}
