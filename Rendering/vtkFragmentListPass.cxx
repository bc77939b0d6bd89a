// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFragmentListPass.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkFragmentLists.h"
#include "vtkLineSetsCheckedValuePrivate.h"
#include "vtkLineSetsQuad.h"
#include "vtkLineSetsSceneDepth.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderTimerLog.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTranslucentPass.h"

#include <array>

namespace
{
bool HasTranslucentProps(const vtkRenderState* state)
{
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    if (state->GetPropArray()[i]->HasTranslucentPolygonalGeometry())
    {
      return true;
    }
  }
  return false;
}

/// While it lives, draws go to the framebuffer, of which no value is written or tested.
class DrawTarget
{
public:
  DrawTarget(vtkOpenGLState* state, vtkOpenGLFramebufferObject* framebuffer,
    vtkTextureObject* texture, const std::array<int, 4>& scissor)
    : State(state)
    , Mask(state)
    , Viewport(state)
    , Scissor(state)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , Blend(state, GL_BLEND)
    , Cull(state, GL_CULL_FACE)
    , Multisample(state, GL_MULTISAMPLE)
  {
    state->PushDrawFramebufferBinding();
    framebuffer->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
    framebuffer->AddColorAttachment(0, texture);
    framebuffer->ActivateDrawBuffer(0);
    state->vtkglViewport(
      0, 0, static_cast<int>(texture->GetWidth()), static_cast<int>(texture->GetHeight()));
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(scissor[0], scissor[1], scissor[2], scissor[3]);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_MULTISAMPLE);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }

  ~DrawTarget() { this->State->PopDrawFramebufferBinding(); }

  DrawTarget(const DrawTarget&) = delete;
  void operator=(const DrawTarget&) = delete;

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglColorMask Mask;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable Cull;
  vtkOpenGLState::ScopedglEnableDisable Multisample;
};
}

class vtkFragmentListPass::vtkInternals
{
public:
  vtkSmartPointer<vtkRenderPass> TranslucentPass = vtkSmartPointer<vtkTranslucentPass>::New();
  vtkFragmentLists Lists;
  vtkLineSetsSceneDepth SceneDepth;
  // What is drawn to: OpenGL wants something, though nothing is written.
  vtkNew<vtkTextureObject> Target;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  // Of the current picture.
  vtkTextureObject* OpaqueDepth = nullptr;
  float HalfDepthStep = 0.0f;
  int Viewport[4] = { 0, 0, 0, 0 };

  std::string LastError;
  vtkIdType LastDropped = 0;

  ~vtkInternals() { this->Release(); }

  /// Release all in the context where it was made.
  void Release()
  {
    this->Lists.ReleaseGraphicsResources(this->Window);
    if (this->Window)
    {
      this->Window->PushContext();
      this->Framebuffer->ReleaseGraphicsResources(this->Window);
      this->Target->ReleaseGraphicsResources(this->Window);
      this->SceneDepth.ReleaseGraphicsResources(this->Window);
      this->Window->PopContext();
    }
    this->Window = nullptr;
  }

  std::string Prepare(vtkRenderer* renderer, vtkOpenGLRenderWindow* window);
  std::string Blend();
};

//------------------------------------------------------------------------------
// The target, and the depth of what is opaque.
std::string vtkFragmentListPass::vtkInternals::Prepare(
  vtkRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  if (this->Window != window)
  {
    this->Release();
    window->MakeCurrent();
    this->Window = window;
  }
  // The viewport of the framebuffer that is drawn to, which another pass may have made its own.
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport);
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  int readOrigin[2];
  vtkLineSetsSceneDepth::GetReadOrigin(window, this->Viewport, origin, readOrigin);
  this->HalfDepthStep = static_cast<float>(0.5 * vtkLineSetsSceneDepth::GetReadStep(window));
  const int width = this->Viewport[2];
  const int height = this->Viewport[3];
  this->OpaqueDepth = this->SceneDepth.Copy(window, readOrigin, width, height);
  if (!this->OpaqueDepth)
  {
    return "the depth of the opaque props cannot be read from the framebuffer";
  }
  this->Target->SetContext(window);
  if (this->Target->GetHandle() == 0 || static_cast<int>(this->Target->GetWidth()) != width ||
    static_cast<int>(this->Target->GetHeight()) != height)
  {
    this->Target->Allocate2D(
      static_cast<unsigned int>(width), static_cast<unsigned int>(height), 1, VTK_UNSIGNED_CHAR);
  }
  this->Framebuffer->SetContext(window);
  return {};
}

//------------------------------------------------------------------------------
// Blend what is stored and sorted, over what the framebuffer holds.
std::string vtkFragmentListPass::vtkInternals::Blend()
{
  vtkOpenGLState* state = this->Window->GetState();
  vtkShaderProgram* program =
    vtkLineSetsQuad::ReadyProgram(this->Window, vtkFragmentLists::GetBlendSource());
  if (!program)
  {
    return "the shader that blends fragments does not compile with this OpenGL";
  }
  this->Lists.SetReadParameters(program);
  program->SetUniform2i("fragmentListOrigin", this->Viewport);
  const vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  return vtkLineSetsQuad::Draw(this->Window, program);
}

vtkStandardNewMacro(vtkFragmentListPass);

//------------------------------------------------------------------------------
vtkFragmentListPass::vtkFragmentListPass()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkFragmentListPass::~vtkFragmentListPass() = default;

//------------------------------------------------------------------------------
void vtkFragmentListPass::SetTranslucentPass(vtkRenderPass* pass)
{
  if (this->Internals->TranslucentPass != pass)
  {
    this->Internals->TranslucentPass = pass;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkFragmentListPass::GetTranslucentPass()
{
  return this->Internals->TranslucentPass;
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::SetMaximumNumberOfBytes(vtkIdType bytes)
{
  vtkLineSetsSetInRange<vtkIdType>(
    this, "MaximumNumberOfBytes", this->MaximumNumberOfBytes, bytes, 16, VTK_ID_MAX);
}

//------------------------------------------------------------------------------
vtkIdType vtkFragmentListPass::GetNumberOfBytes()
{
  const vtkIdType target = this->Internals->Target->GetHandle() == 0
    ? 0
    : static_cast<vtkIdType>(this->Internals->Target->GetWidth()) *
      this->Internals->Target->GetHeight();
  return target + this->Internals->SceneDepth.GetNumberOfBytes() +
    this->Internals->Lists.GetNumberOfBytes();
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::Render(const vtkRenderState* state)
{
  this->NumberOfRenderedProps = 0;
  if (!this->Internals->TranslucentPass)
  {
    vtkWarningMacro("There is no TranslucentPass: translucent props are not drawn.");
    return;
  }
  this->NumberOfFragments = 0;
  this->LargestDepthComplexity = 0;
  this->MeanDepthComplexity = 0.0;
  this->NumberOfStrips = 0;
  this->NumberOfDroppedFragments = 0;
  vtkRenderer* renderer = state->GetRenderer();
  if (!HasTranslucentProps(state))
  {
    return;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    this->ReportErrorOnce("An OpenGL render window is needed.");
    return;
  }
  // A selector reads one value per pixel, which cannot be blended.
  if (renderer->GetSelector())
  {
    this->RenderDelegate(state);
    return;
  }
  VTK_SCOPED_RENDER_EVENT("vtkFragmentListPass::Render", window->GetRenderTimer());
  const std::string missing = vtkFragmentLists::GetMissingFeatures(window);
  const std::string error =
    missing.empty() ? this->RenderLists(state, window) : "OpenGL has not " + missing;
  if (!error.empty())
  {
    this->ReportErrorOnce("Translucent props are drawn without fragment lists, blended in the "
                          "order of the props, because " +
      error + ".");
    this->RenderDelegate(state);
    return;
  }
  this->Internals->LastError.clear();
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::RenderDelegate(const vtkRenderState* state)
{
  this->Internals->TranslucentPass->Render(state);
  this->NumberOfRenderedProps = this->Internals->TranslucentPass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
std::string vtkFragmentListPass::RenderLists(
  const vtkRenderState* state, vtkOpenGLRenderWindow* window)
{
  vtkInternals& data = *this->Internals;
  std::string error = data.Prepare(state->GetRenderer(), window);
  if (!error.empty())
  {
    return error;
  }
  data.Lists.SetMaximumNumberOfBytes(static_cast<std::size_t>(this->MaximumNumberOfBytes));
  error = data.Lists.Begin(window, data.Viewport[2], data.Viewport[3]);
  if (!error.empty())
  {
    return error;
  }
  data.OpaqueDepth->Activate();
  this->PreRender(state);
  error = this->CountFragments(state, window);
  for (int i = 0; error.empty() && i < data.Lists.GetNumberOfStrips(); ++i)
  {
    this->StoreFragments(state, window, i);
    error = this->BlendFragments(window);
  }
  this->PostRender(state);
  data.OpaqueDepth->Deactivate();
  data.Lists.End();
  if (error.empty())
  {
    this->UpdateStatistics();
  }
  return error;
}

//------------------------------------------------------------------------------
std::string vtkFragmentListPass::CountFragments(
  const vtkRenderState* state, vtkOpenGLRenderWindow* window)
{
  VTK_SCOPED_RENDER_EVENT("vtkFragmentListPass::CountFragments", window->GetRenderTimer());
  vtkInternals& data = *this->Internals;
  {
    const DrawTarget target(window->GetState(), data.Framebuffer, data.Target,
      { 0, 0, data.Viewport[2], data.Viewport[3] });
    this->RenderDelegate(state);
  }
  return data.Lists.FinishCounting();
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::StoreFragments(
  const vtkRenderState* state, vtkOpenGLRenderWindow* window, int strip)
{
  VTK_SCOPED_RENDER_EVENT("vtkFragmentListPass::StoreFragments", window->GetRenderTimer());
  vtkInternals& data = *this->Internals;
  const std::array<int, 2> rows = data.Lists.GetStripRows(strip);
  const DrawTarget target(window->GetState(), data.Framebuffer, data.Target,
    { 0, rows[0], data.Viewport[2], rows[1] - rows[0] });
  data.Lists.BeginStrip(strip);
  this->RenderDelegate(state);
}

//------------------------------------------------------------------------------
std::string vtkFragmentListPass::BlendFragments(vtkOpenGLRenderWindow* window)
{
  vtkInternals& data = *this->Internals;
  std::string error;
  {
    VTK_SCOPED_RENDER_EVENT("vtkFragmentListPass::SortFragments", window->GetRenderTimer());
    error = data.Lists.SortStrip();
  }
  VTK_SCOPED_RENDER_EVENT("vtkFragmentListPass::BlendFragments", window->GetRenderTimer());
  return error.empty() ? data.Blend() : error;
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::UpdateStatistics()
{
  const vtkFragmentLists& lists = this->Internals->Lists;
  this->NumberOfFragments = lists.GetNumberOfFragments();
  this->LargestDepthComplexity = lists.GetLargestNumberPerPixel();
  this->MeanDepthComplexity = lists.GetMeanNumberPerPixel();
  this->NumberOfStrips = lists.GetNumberOfStrips();
  this->NumberOfDroppedFragments = lists.GetNumberOfDroppedFragments();
  if (this->NumberOfDroppedFragments > 0 &&
    this->NumberOfDroppedFragments != this->Internals->LastDropped)
  {
    vtkWarningMacro("" << this->NumberOfDroppedFragments << " of " << this->NumberOfFragments
                       << " translucent fragments are missing in the picture. A pixel row must fit "
                          "into MaximumNumberOfBytes, 16 per fragment, which is "
                       << this->MaximumNumberOfBytes << ".");
  }
  this->Internals->LastDropped = this->NumberOfDroppedFragments;
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::ReportErrorOnce(const std::string& error)
{
  if (this->Internals->LastError != error)
  {
    vtkErrorMacro("" << error);
    this->Internals->LastError = error;
  }
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Internals->TranslucentPass)
  {
    this->Internals->TranslucentPass->ReleaseGraphicsResources(window);
  }
  this->Internals->Release();
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::PostReplaceShaderValues(std::string& vtkNotUsed(vertexShader),
  std::string& vtkNotUsed(geometryShader), std::string& fragmentShader,
  vtkAbstractMapper* vtkNotUsed(mapper), vtkProp* vtkNotUsed(prop))
{
  vtkFragmentLists::InsertExtensions(fragmentShader);
  // Where the mapper has set the depth, its tag is gone.
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::Depth::Impl", "gl_FragDepth = gl_FragCoord.z;");
  return vtkShaderProgram::Substitute(
           fragmentShader, "//VTK::DepthPeeling::Dec", vtkFragmentLists::GetColorStoreSource()) &&
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Impl",
      "storeFragmentColor(ivec2(gl_FragCoord.xy), gl_FragDepth, gl_FragData[0]);");
}

//------------------------------------------------------------------------------
bool vtkFragmentListPass::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* vtkNotUsed(mapper), vtkProp* vtkNotUsed(prop),
  vtkOpenGLVertexArrayObject* vtkNotUsed(vao))
{
  if (program->IsUniformUsed("fragmentListOpaqueDepth"))
  {
    program->SetUniformi("fragmentListOpaqueDepth", this->Internals->OpaqueDepth->GetTextureUnit());
    program->SetUniformf("fragmentListHalfDepthStep", this->Internals->HalfDepthStep);
  }
  this->Internals->Lists.SetParameters(program);
  return true;
}

//------------------------------------------------------------------------------
void vtkFragmentListPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TranslucentPass: ";
  if (this->Internals->TranslucentPass)
  {
    os << "\n";
    this->Internals->TranslucentPass->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
  os << indent << "MaximumNumberOfBytes: " << this->MaximumNumberOfBytes << "\n";
  os << indent << "NumberOfFragments: " << this->NumberOfFragments << "\n";
  os << indent << "NumberOfDroppedFragments: " << this->NumberOfDroppedFragments << "\n";
  os << indent << "LargestDepthComplexity: " << this->LargestDepthComplexity << "\n";
  os << indent << "MeanDepthComplexity: " << this->MeanDepthComplexity << "\n";
  os << indent << "NumberOfStrips: " << this->NumberOfStrips << "\n";
  os << indent << "NumberOfBytes: " << this->GetNumberOfBytes() << "\n";
}
