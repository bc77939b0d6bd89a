// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityPass.h"

#include "vtkActor.h"
#include "vtkFourierOpacityMapper.h"
#include "vtkFourierOpacityPainter.h"
#include "vtkFourierOpacityStage.h"
#include "vtkObjectFactory.h"
#include "vtkOpacityOptimization.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkTranslucentPass.h"

#include <string>
#include <vector>

class vtkFourierOpacityPass::vtkInternals
{
public:
  vtkSmartPointer<vtkOpacityOptimization> Optimization =
    vtkSmartPointer<vtkOpacityOptimization>::New();
  vtkSmartPointer<vtkRenderPass> TranslucentPass = vtkSmartPointer<vtkTranslucentPass>::New();
  // Shared with the mappers that it drew, for their selection.
  std::shared_ptr<vtkFourierOpacityPainter> Painter = std::make_shared<vtkFourierOpacityPainter>();
  std::vector<vtkFourierOpacityPainter::Item> Items;
  std::vector<vtkProp*> Others;
  // What has been said, so that it is said once.
  std::string Error;
  std::string Warning;
  std::size_t NumberOfOthers = 0;
};

vtkStandardNewMacro(vtkFourierOpacityPass);

//------------------------------------------------------------------------------
vtkFourierOpacityPass::vtkFourierOpacityPass()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkFourierOpacityPass::~vtkFourierOpacityPass() = default;

//------------------------------------------------------------------------------
void vtkFourierOpacityPass::SetOptimization(vtkOpacityOptimization* optimization)
{
  if (optimization != this->Internals->Optimization || !optimization)
  {
    this->Internals->Optimization =
      optimization ? optimization : vtkSmartPointer<vtkOpacityOptimization>::New().Get();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkOpacityOptimization* vtkFourierOpacityPass::GetOptimization()
{
  return this->Internals->Optimization;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPass::SetTranslucentPass(vtkRenderPass* pass)
{
  if (pass != this->Internals->TranslucentPass)
  {
    this->Internals->TranslucentPass = pass;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkFourierOpacityPass::GetTranslucentPass()
{
  return this->Internals->TranslucentPass;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPass::ForgetOpacities()
{
  this->Internals->Painter->ForgetOpacities();
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityPass::GetNumberOfBytes()
{
  return this->Internals->Painter->GetNumberOfBytes();
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityPass::GetNumberOfSumBytes()
{
  return this->Internals->Painter->GetNumberOfSumBytes();
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityPass::GetNumberOfFragments()
{
  return this->Internals->Painter->GetNumberOfFragments();
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityPass::GetNumberOfDroppedFragments()
{
  return this->Internals->Painter->GetNumberOfDroppedFragments();
}

//------------------------------------------------------------------------------
double vtkFourierOpacityPass::GetMeanDepthComplexity()
{
  return this->Internals->Painter->GetMeanDepthComplexity();
}

//------------------------------------------------------------------------------
int vtkFourierOpacityPass::GetNumberOfAccumulatedPictures()
{
  return this->Internals->Painter->GetNumberOfAccumulatedPictures();
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPass::Render(const vtkRenderState* state)
{
  vtkInternals& internals = *this->Internals;
  internals.Items.clear();
  internals.Others.clear();
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = state->GetPropArray()[i];
    auto* actor = vtkActor::SafeDownCast(prop);
    auto* mapper = vtkFourierOpacityMapper::SafeDownCast(actor ? actor->GetMapper() : nullptr);
    if (mapper)
    {
      internals.Items.push_back({ actor, mapper });
    }
    else if (prop->HasTranslucentPolygonalGeometry())
    {
      internals.Others.push_back(prop);
    }
  }
  this->NumberOfRenderedProps = 0;
  if (!internals.Items.empty())
  {
    vtkRenderer* renderer = state->GetRenderer();
    std::string warning;
    const std::string error = internals.Painter->Draw(
      renderer, internals.Items, internals.Optimization,
      [&](const vtkFourierOpacityPainter::Item& item, const vtkFourierOpacityStage& stage)
      { item.Mapper->RenderStage(renderer, item.Actor, stage, true); },
      vtkFourierOpacityPainter::Framebuffer, warning);
    if (!error.empty() && error != internals.Error)
    {
      vtkErrorMacro(<< error);
    }
    internals.Error = error;
    if (!warning.empty() && warning != internals.Warning)
    {
      vtkWarningMacro(<< warning);
    }
    internals.Warning = warning;
    for (const vtkFourierOpacityPainter::Item& item : internals.Items)
    {
      item.Mapper->SetSelectionPainter(internals.Painter);
    }
    this->NumberOfRenderedProps = error.empty() ? static_cast<int>(internals.Items.size()) : 0;
  }
  this->DrawOthers(state);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPass::DrawOthers(const vtkRenderState* state)
{
  vtkInternals& internals = *this->Internals;
  const std::size_t number = internals.Others.size();
  const bool mixed = !internals.Items.empty() && number > 0;
  if (mixed && number != internals.NumberOfOthers)
  {
    vtkWarningMacro(<< number
                    << " translucent props are no actors with a vtkFourierOpacityMapper: they are "
                    << (internals.TranslucentPass ? "drawn over what this pass draws, whatever "
                                                    "their depth."
                                                  : "not drawn, since there is no "
                                                    "TranslucentPass."));
  }
  internals.NumberOfOthers = mixed ? number : 0;
  if (number == 0 || !internals.TranslucentPass)
  {
    return;
  }
  vtkRenderState others(state->GetRenderer());
  others.SetPropArrayAndCount(internals.Others.data(), static_cast<int>(number));
  others.SetFrameBuffer(state->GetFrameBuffer());
  internals.TranslucentPass->Render(&others);
  this->NumberOfRenderedProps += internals.TranslucentPass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Painter->ReleaseGraphicsResources(window);
  if (this->Internals->TranslucentPass)
  {
    this->Internals->TranslucentPass->ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Optimization:\n";
  this->Internals->Optimization->PrintSelf(os, indent.GetNextIndent());
  os << indent << "TranslucentPass:";
  if (this->Internals->TranslucentPass)
  {
    os << "\n";
    this->Internals->TranslucentPass->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << " (none)\n";
  }
}
