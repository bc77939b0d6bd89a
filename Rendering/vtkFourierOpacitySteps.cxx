// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacitySteps.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkFourierOpacityElements.h"
#include "vtkLineSetsQuad.h"
#include "vtkLineSetsScopedState.h"
#include "vtkOpacityOptimization.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace
{
// What each draw writes where there are more sums than targets of one draw.
std::vector<vtkFourierOpacityStages::Outputs> PartOutputs(int sums, bool bounds, int most)
{
  std::vector<vtkFourierOpacityStages::Outputs> parts;
  for (int first = 0; first < sums; first += most)
  {
    parts.push_back({ first, std::min(sums - first, most), false });
  }
  if (bounds)
  {
    if (parts.empty() || parts.back().Count == most)
    {
      parts.push_back({ sums, 0, false });
    }
    parts.back().Bounds = true;
  }
  return parts;
}
}

//------------------------------------------------------------------------------
vtkFourierOpacitySteps::vtkFourierOpacitySteps() = default;

//------------------------------------------------------------------------------
vtkFourierOpacitySteps::~vtkFourierOpacitySteps() = default;

//------------------------------------------------------------------------------
std::string vtkFourierOpacitySteps::Prepare(vtkFourierOpacityFrame& frame)
{
  int draws = 8;
  int attachments = 8;
  frame.State->vtkglGetIntegerv(GL_MAX_DRAW_BUFFERS, &draws);
  frame.State->vtkglGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &attachments);
  frame.MostTargets = std::min(draws, attachments);
  const auto reduce = [&frame](int reduction, int size[2])
  {
    for (int i = 0; i < 2; ++i)
    {
      size[i] = (frame.Now.Size[i] + reduction - 1) / reduction;
    }
  };

  vtkFourierOpacityTargets::Layout layout;
  reduce(1, layout.Size);
  layout.Sums = frame.Stages.Sums;
  reduce(frame.Stages.ImportanceReduction, frame.ReducedSize);
  reduce(frame.Stages.DepthReduction, frame.DepthSize);
  // The sums of importance have the same place.
  reduce(std::min(frame.Stages.ImportanceReduction, frame.Stages.DepthReduction), layout.SumsSize);
  layout.HasHalfFloats = frame.Stages.HasHalfFloats;
  layout.HasTotals = frame.Stages.HasTotals;
  layout.HasBounds = frame.Stages.HasBounds;
  reduce(frame.Stages.ImportanceReduction, layout.BoundsSize);
  reduce(frame.Stages.WidenedReduction, layout.WidenedSize);
  layout.HasCounts = !frame.Stages.HasSums && !frame.Stages.HasLists;
  layout.HasOpaqueLayer = frame.Stages.HasOpaqueLayer;
  layout.HasPicture = frame.HasPicture;
  return this->Targets.Prepare(frame.Window, layout);
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacitySteps::UploadValues(
  vtkOpenGLRenderWindow* window, const std::vector<float>& values, unsigned int format)
{
  const int type = format == GL_R32F ? VTK_FLOAT : VTK_UNSIGNED_INT;
  return this->Opacities.Upload(
           window, values.data(), values.size(), sizeof(float), format, 1, type)
    ? std::string()
    : "There is no memory on the graphics device for the opacities of " +
      std::to_string(values.size()) + " segments.";
}

//------------------------------------------------------------------------------
void vtkFourierOpacitySteps::SumImportance(vtkFourierOpacityFrame& frame)
{
  // Opacities stay as they are in later pictures of the same view and in tiles, of which only
  // bounds are needed.
  const bool sumsUp = !frame.Stages.Exact && frame.FindsOpacities();
  const int sums = sumsUp ? static_cast<int>(this->Targets.Sums.size()) : 0;
  frame.State->vtkglDisable(GL_DEPTH_TEST);
  frame.State->vtkglDepthMask(GL_FALSE);
  frame.State->vtkglEnable(GL_BLEND);
  frame.State->vtkglBlendFunc(GL_ONE, GL_ONE);
  frame.State->vtkglViewport(0, 0, frame.ReducedSize[0], frame.ReducedSize[1]);
  frame.Textures.Add("fourierScene", frame.Scene);
  for (const auto& outputs : PartOutputs(sums, frame.Stages.HasBounds, frame.MostTargets))
  {
    const auto first = this->Targets.Sums.begin() + outputs.First;
    std::vector<vtkTextureObject*> targets(first, first + outputs.Count);
    if (outputs.Bounds)
    {
      targets.push_back(this->Targets.Bounds);
    }
    this->Targets.Bind(targets, nullptr);
    frame.State->vtkglClear(GL_COLOR_BUFFER_BIT);
    // Each target has its blend equation, of which VTK's state knows nothing.
    const auto boundsTarget = static_cast<unsigned int>(outputs.Count);
    if (outputs.Bounds)
    {
      glBlendEquationi(boundsTarget, GL_MAX);
    }
    vtkFourierOpacityStage stage = frame.Stages.SumImportance(outputs);
    frame.DrawStage(stage);
    if (outputs.Bounds)
    {
      glBlendEquationi(boundsTarget, GL_FUNC_ADD);
    }
  }
  frame.Textures.Clear();
}

//------------------------------------------------------------------------------
int vtkFourierOpacitySteps::GetElementShift(
  vtkOpenGLRenderWindow* window, const vtkFourierOpacityElements& elements)
{
  // Where the device takes fewer places than there are elements, neighbours share one.
  int most = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  int shift = 0;
  while (((elements.GetNumberOfElements() - 1) >> shift) >= most)
  {
    ++shift;
  }
  return shift;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacitySteps::FindOpacities(vtkFourierOpacityFrame& frame)
{
  frame.ElementShift = GetElementShift(frame.Window, frame.Elements);
  if (!frame.FindsOpacities())
  {
    // What was found for the first picture of this view, or for the whole picture.
    return this->UploadOpacities(frame.Window, frame.Elements);
  }
  const vtkIdType last = std::max<vtkIdType>(frame.Elements.GetNumberOfElements() - 1, 0);
  std::vector<float>& values = this->Values;
  values.assign(
    static_cast<std::size_t>((last >> frame.ElementShift) + 1), vtkFourierOpacityElements::NotSeen);
  // Floats that are not negative are in the order of their bits.
  std::string error = this->UploadValues(frame.Window, values, GL_R32UI);
  if (!error.empty())
  {
    return error;
  }
  const vtkLineSetsScopedState::SavedImageUnit savedUnit(vtkFourierOpacityFrame::SmallestUnit);
  glBindImageTexture(vtkFourierOpacityFrame::SmallestUnit, this->Opacities.GetHandle(), 0, GL_FALSE,
    0, GL_READ_WRITE, GL_R32UI);
  frame.Textures.Add("fourierScene", frame.Scene);
  if (frame.Stages.Exact)
  {
    vtkFourierOpacityStage stage = frame.Stages.ListImportance();
    error = this->DrawLists(
      frame, stage, frame.ReducedSize, this->Targets.Colors, frame.Stages.ResolveImportance());
  }
  else
  {
    frame.State->vtkglViewport(0, 0, frame.ReducedSize[0], frame.ReducedSize[1]);
    // Wide lines and points reach beyond the viewport, where there are no sums of this picture.
    const vtkOpenGLState::ScopedglEnableDisable scissorTest(frame.State, GL_SCISSOR_TEST);
    frame.State->vtkglScissor(0, 0, frame.ReducedSize[0], frame.ReducedSize[1]);
    frame.State->vtkglEnable(GL_SCISSOR_TEST);
    frame.State->vtkglDisable(GL_DEPTH_TEST);
    frame.State->vtkglDisable(GL_BLEND);
    frame.State->vtkglDepthMask(GL_FALSE);
    frame.State->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    this->Targets.Bind({ this->Targets.Colors }, nullptr);
    this->AddSumTextures(frame);
    vtkFourierOpacityStage stage = frame.Stages.FindOpacities();
    frame.DrawStage(stage);
    frame.State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  frame.Textures.Clear();
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  if (!error.empty())
  {
    return error;
  }
  this->Opacities.Download(values.data(), values.size() * sizeof(float));
  frame.Elements.Update(
    values, frame.ElementShift, frame.Optimization->GetSmoothingIterations(), frame.Blend);
  return this->UploadOpacities(frame.Window, frame.Elements);
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacitySteps::UploadOpacities(
  vtkOpenGLRenderWindow* window, const vtkFourierOpacityElements& elements)
{
  const std::vector<float>& opacities = elements.GetOpacities();
  const int shift = GetElementShift(window, elements);
  if (shift == 0 && !opacities.empty())
  {
    return this->UploadValues(window, opacities, GL_R32F);
  }
  std::vector<float> shared((opacities.size() >> shift) + 1, 1.0f);
  for (std::size_t i = 0; i < opacities.size(); ++i)
  {
    float& value = shared[i >> shift];
    value = std::min(value, opacities[i]);
  }
  return this->UploadValues(window, shared, GL_R32F);
}

//------------------------------------------------------------------------------
void vtkFourierOpacitySteps::AddSumTextures(vtkFourierOpacityFrame& frame)
{
  for (std::size_t i = 0; i < this->Targets.Sums.size(); ++i)
  {
    frame.Textures.Add("fourierSums" + std::to_string(i), this->Targets.Sums[i]);
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacitySteps::DrawOpaqueLayer(vtkFourierOpacityFrame& frame)
{
  frame.State->vtkglViewport(0, 0, frame.Now.Size[0], frame.Now.Size[1]);
  frame.State->vtkglEnable(GL_DEPTH_TEST);
  frame.State->vtkglDepthFunc(GL_LEQUAL);
  frame.State->vtkglDepthMask(GL_TRUE);
  frame.State->vtkglDisable(GL_BLEND);
  this->Targets.Bind({ this->Targets.Opaque }, frame.Scene);
  frame.State->vtkglClear(GL_COLOR_BUFFER_BIT);
  frame.Textures.Add("fourierOpacities", this->Opacities.GetTexture());
  vtkFourierOpacityStage stage = frame.Stages.DrawOpaqueLayer();
  frame.DrawStage(stage);
  frame.Textures.Clear();
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacitySteps::Widen(vtkFourierOpacityFrame& frame)
{
  frame.State->vtkglViewport(0, 0, static_cast<int>(this->Targets.Widened->GetWidth()),
    static_cast<int>(this->Targets.Widened->GetHeight()));
  frame.State->vtkglDisable(GL_DEPTH_TEST);
  frame.State->vtkglDisable(GL_BLEND);
  this->Targets.Bind({ this->Targets.Widened }, nullptr);
  frame.Textures.Add("fourierBounds", this->Targets.Bounds);
  frame.Textures.Add("fourierScene", frame.Scene);
  std::string error = this->DrawQuad(frame, frame.Stages.Widen());
  frame.Textures.Clear();
  return error;
}

//------------------------------------------------------------------------------
void vtkFourierOpacitySteps::SumOpticalDepth(vtkFourierOpacityFrame& frame)
{
  // Where several pixels share a sum, shaders leave out what none of them shows.
  const bool isReduced = frame.Stages.DepthReduction > 1;
  frame.State->vtkglViewport(0, 0, frame.DepthSize[0], frame.DepthSize[1]);
  frame.State->SetEnumState(GL_DEPTH_TEST, !isReduced);
  frame.State->vtkglDepthFunc(GL_LEQUAL);
  frame.State->vtkglDepthMask(GL_FALSE);
  frame.State->vtkglEnable(GL_BLEND);
  frame.State->vtkglBlendFunc(GL_ONE, GL_ONE);
  frame.Textures.Add("fourierOpacities", this->Opacities.GetTexture());
  if (frame.Stages.HasBounds)
  {
    frame.Textures.Add("fourierBounds", this->Targets.Widened);
  }
  else if (isReduced)
  {
    frame.Textures.Add("fourierScene", frame.Scene);
  }
  const int sums = frame.Stages.HasSums ? static_cast<int>(this->Targets.Sums.size()) : 0;
  for (const auto& outputs : PartOutputs(sums, false, frame.MostTargets))
  {
    const auto first = this->Targets.Sums.begin() + outputs.First;
    this->Targets.Bind(std::vector<vtkTextureObject*>(first, first + outputs.Count),
      isReduced ? nullptr : frame.Scene);
    frame.State->vtkglClear(GL_COLOR_BUFFER_BIT);
    vtkFourierOpacityStage stage = frame.Stages.SumOpticalDepth(outputs);
    frame.DrawStage(stage);
  }
  frame.Textures.Clear();
}

//------------------------------------------------------------------------------
void vtkFourierOpacitySteps::AddColors(vtkFourierOpacityFrame& frame)
{
  frame.State->vtkglViewport(0, 0, frame.Now.Size[0], frame.Now.Size[1]);
  frame.State->vtkglEnable(GL_DEPTH_TEST);
  frame.State->vtkglDepthFunc(GL_LEQUAL);
  frame.State->vtkglDepthMask(GL_FALSE);
  frame.State->vtkglEnable(GL_BLEND);
  frame.State->vtkglBlendFunc(GL_ONE, GL_ONE);
  frame.Textures.Add("fourierOpacities", this->Opacities.GetTexture());
  if (frame.Stages.HasBounds)
  {
    frame.Textures.Add("fourierBounds", this->Targets.Widened);
  }
  std::vector<vtkTextureObject*> targets = { this->Targets.Colors };
  if (frame.Stages.HasSums)
  {
    this->AddSumTextures(frame);
  }
  if (frame.Stages.HasTotals)
  {
    targets.push_back(this->Targets.Totals);
  }
  else if (!frame.Stages.HasSums)
  {
    targets.push_back(this->Targets.Counts);
  }
  this->Targets.Bind(targets, frame.Scene);
  frame.State->vtkglClear(GL_COLOR_BUFFER_BIT);
  vtkFourierOpacityStage stage = frame.Stages.AddColors();
  frame.DrawStage(stage);
  frame.Textures.Clear();
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacitySteps::ListColors(vtkFourierOpacityFrame& frame)
{
  frame.Textures.Add("fourierOpacities", this->Opacities.GetTexture());
  frame.Textures.Add("fragmentListOpaqueDepth", frame.Scene);
  vtkFourierOpacityStage stage = frame.Stages.ListColors();
  std::string error = this->DrawLists(
    frame, stage, frame.Now.Size, this->Targets.Colors, frame.Stages.ResolveColors());
  frame.Textures.Clear();
  return error;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacitySteps::DrawQuad(
  vtkFourierOpacityFrame& frame, const std::string& source)
{
  vtkShaderProgram* program = vtkLineSetsQuad::ReadyProgram(frame.Window, source);
  if (!program)
  {
    return "A shader of opacity optimization does not compile.";
  }
  frame.SetParameters(program);
  return vtkLineSetsQuad::Draw(frame.Window, program);
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacitySteps::DrawLists(vtkFourierOpacityFrame& frame,
  vtkFourierOpacityStage& stage, const int size[2], vtkTextureObject* target,
  const std::string& resolve)
{
  this->Lists.SetMaximumNumberOfBytes(
    static_cast<std::size_t>(frame.Optimization->GetMaximumListMemory()) << 20);
  frame.State->vtkglViewport(0, 0, size[0], size[1]);
  frame.State->vtkglDisable(GL_DEPTH_TEST);
  frame.State->vtkglDisable(GL_BLEND);
  frame.State->vtkglDepthMask(GL_FALSE);
  this->Targets.Bind({ target }, nullptr);
  frame.State->vtkglClear(GL_COLOR_BUFFER_BIT);
  std::string error = this->Lists.Begin(frame.Window, size[0], size[1]);
  if (!error.empty())
  {
    return error;
  }
  frame.Lists = &this->Lists;
  frame.State->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  frame.DrawStage(stage);
  error = this->Lists.FinishCounting();
  for (int i = 0; error.empty() && i < this->Lists.GetNumberOfStrips(); ++i)
  {
    this->Lists.BeginStrip(i);
    frame.DrawStage(stage);
    error = this->Lists.SortStrip();
    vtkShaderProgram* program =
      error.empty() ? vtkLineSetsQuad::ReadyProgram(frame.Window, resolve) : nullptr;
    if (program)
    {
      frame.State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      frame.SetParameters(program);
      this->Lists.SetReadParameters(program);
      error = vtkLineSetsQuad::Draw(frame.Window, program);
      frame.State->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    }
    else if (error.empty())
    {
      error = "A shader of fragment lists does not compile.";
    }
  }
  frame.Lists = nullptr;
  frame.State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  this->Lists.End();
  this->NumberOfDroppedFragments += this->Lists.GetNumberOfDroppedFragments();
  return error;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacitySteps::Finish(vtkFourierOpacityFrame& frame)
{
  if (frame.Stages.HasTotals)
  {
    frame.Textures.Add("fourierTotals", this->Targets.Totals);
  }
  else if (frame.Stages.HasSums)
  {
    this->AddSumTextures(frame);
  }
  frame.Textures.Add("fourierColors", this->Targets.Colors);
  frame.Textures.Add("fourierCounts", this->Targets.Counts);
  frame.Textures.Add("fourierOpaque", this->Targets.Opaque);
  if (frame.Stages.HasBounds)
  {
    frame.Textures.Add("fourierBounds", this->Targets.Widened);
  }
  std::string error = this->DrawQuad(frame, frame.Stages.Finish(frame.Number >= 0));
  frame.Textures.Clear();
  return error;
}

//------------------------------------------------------------------------------
void vtkFourierOpacitySteps::BindPicture()
{
  this->Targets.Bind({ this->Targets.Color }, this->SceneDepth.GetTexture());
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacitySteps::MakePicture(vtkFourierOpacityFrame& frame, const int origin[2])
{
  frame.Scene = this->SceneDepth.Copy(frame.Window, origin, frame.Now.Size[0], frame.Now.Size[1]);
  if (!frame.Scene)
  {
    return "The depth of the opaque scene cannot be read.";
  }
  frame.State->vtkglDisable(GL_SCISSOR_TEST);
#ifdef GL_MULTISAMPLE
  frame.State->vtkglDisable(GL_MULTISAMPLE);
#endif
  frame.State->vtkglBlendEquation(GL_FUNC_ADD);
  frame.State->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  frame.State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

  this->NumberOfDroppedFragments = 0;
  this->SumImportance(frame);
  std::string error = this->FindOpacities(frame);
  if (error.empty() && frame.Stages.HasOpaqueLayer)
  {
    this->DrawOpaqueLayer(frame);
  }
  if (error.empty() && frame.Stages.HasBounds)
  {
    error = this->Widen(frame);
  }
  if (error.empty() && frame.Stages.HasLists)
  {
    error = this->ListColors(frame);
  }
  else if (error.empty())
  {
    this->SumOpticalDepth(frame);
    this->AddColors(frame);
  }
  return error;
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacitySteps::GetNumberOfBytes() const
{
  return this->Targets.GetNumberOfBytes() + this->SceneDepth.GetNumberOfBytes() +
    static_cast<vtkIdType>(this->Opacities.GetNumberOfBytes()) + this->Lists.GetNumberOfBytes();
}

//------------------------------------------------------------------------------
void vtkFourierOpacitySteps::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Targets.ReleaseGraphicsResources(window);
  this->SceneDepth.ReleaseGraphicsResources(window);
  this->Opacities.Release(window);
  this->Lists.ReleaseGraphicsResources(window);
}
