// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityPainter.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkActor.h"
#include "vtkFourierOpacityAccumulator.h"
#include "vtkFourierOpacityMapper.h"
#include "vtkFourierOpacityStages.h"
#include "vtkLineSetsQuad.h"
#include "vtkOpacityOptimization.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkVoxelLineAccumulator.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace
{
// The image unit of the smallest opacities.
// Fragment lists use the first ones.
constexpr unsigned int SmallestUnit = 7;

/// State that draws change; it is as before when this ends.
class SavedState
{
public:
  explicit SavedState(vtkOpenGLState* state)
    : Bindings(state)
    , Viewport(state)
    , Scissor(state)
    , ClearColor(state)
    , ColorMask(state)
    , DepthMask(state)
    , DepthFunction(state)
    , Blending(state)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
#ifdef GL_MULTISAMPLE
    , Multisample(state, GL_MULTISAMPLE)
#endif
  {
  }

private:
  struct FramebufferBindings
  {
    explicit FramebufferBindings(vtkOpenGLState* state)
      : State(state)
    {
      state->PushFramebufferBindings();
    }
    ~FramebufferBindings() { this->State->PopFramebufferBindings(); }
    vtkOpenGLState* State;
  };

  FramebufferBindings Bindings;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunction;
  vtkOpenGLState::ScopedglBlendFuncSeparate Blending;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
#ifdef GL_MULTISAMPLE
  vtkOpenGLState::ScopedglEnableDisable Multisample;
#endif
};

/// What is bound to an image unit; it is bound again when this ends.
class SavedImageUnit
{
public:
  explicit SavedImageUnit(unsigned int unit)
    : Unit(unit)
    , Name(Get(GL_IMAGE_BINDING_NAME))
    , Level(Get(GL_IMAGE_BINDING_LEVEL))
    , IsLayered(Get(GL_IMAGE_BINDING_LAYERED))
    , Layer(Get(GL_IMAGE_BINDING_LAYER))
    , Access(Get(GL_IMAGE_BINDING_ACCESS))
    , Format(Get(GL_IMAGE_BINDING_FORMAT))
  {
  }
  ~SavedImageUnit()
  {
    glBindImageTexture(this->Unit, static_cast<GLuint>(this->Name), this->Level,
      this->IsLayered ? GL_TRUE : GL_FALSE, this->Layer, static_cast<GLenum>(this->Access),
      static_cast<GLenum>(this->Format));
  }
  SavedImageUnit(const SavedImageUnit&) = delete;
  void operator=(const SavedImageUnit&) = delete;

private:
  int Get(GLenum which) const
  {
    int value = 0;
    glGetIntegeri_v(which, this->Unit, &value);
    return value;
  }

  unsigned int Unit;
  int Name;
  int Level;
  int IsLayered;
  int Layer;
  int Access;
  int Format;
};

/// Textures that programs read, until Clear().
class ActiveTextures
{
public:
  ActiveTextures() = default;
  ~ActiveTextures() { this->Clear(); }
  ActiveTextures(const ActiveTextures&) = delete;
  void operator=(const ActiveTextures&) = delete;

  void Clear()
  {
    for (vtkTextureObject* texture : this->Textures)
    {
      texture->Deactivate();
    }
    this->Textures.clear();
    this->Names.clear();
  }

  void Add(const std::string& name, vtkTextureObject* texture)
  {
    if (texture && texture->GetHandle() != 0)
    {
      texture->Activate();
      this->Names.push_back(name);
      this->Textures.push_back(texture);
    }
  }

  void SetParameters(vtkShaderProgram* program) const
  {
    for (std::size_t i = 0; i < this->Names.size(); ++i)
    {
      if (program->IsUniformUsed(this->Names[i].c_str()))
      {
        program->SetUniformi(this->Names[i].c_str(), this->Textures[i]->GetTextureUnit());
      }
    }
  }

private:
  std::vector<std::string> Names;
  std::vector<vtkTextureObject*> Textures;
};

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

void SetIfUsed(vtkShaderProgram* program, const char* name, int value)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniformi(name, value);
  }
}
}

//------------------------------------------------------------------------------
struct vtkFourierOpacityPainter::View
{
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkFourierOpacityElements Elements;
  vtkFourierOpacityView Last;
  bool HasLast = false;
  std::chrono::steady_clock::time_point Time;
  std::chrono::steady_clock::time_point LastChange;
  vtkFourierOpacityAccumulator Accumulator;
  vtkNew<vtkTextureObject> Sum; ///< of the pictures, colours multiplied by opacity
};

//------------------------------------------------------------------------------
struct vtkFourierOpacityPainter::Frame
{
  Frame(vtkRenderer* renderer, const std::vector<Item>& items,
    vtkOpacityOptimization* optimization, const DrawFunction& drawItem,
    const vtkFourierOpacityView& now, vtkFourierOpacityPainter::View& view)
    : Window(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
    , State(this->Window->GetState())
    , Renderer(renderer)
    , Items(items)
    , Optimization(optimization)
    , DrawItem(drawItem)
    , Now(now)
    , Stages(optimization, now.IsParallel)
    , View(view)
  {
  }

  vtkOpenGLRenderWindow* Window;
  vtkOpenGLState* State;
  vtkRenderer* Renderer;
  const std::vector<Item>& Items;
  vtkOpacityOptimization* Optimization;
  const DrawFunction& DrawItem;
  vtkFourierOpacityView Now;
  vtkFourierOpacityStages Stages;
  vtkFourierOpacityPainter::View& View;
  vtkTextureObject* Scene = nullptr;
  int Reduction = 1;
  int ReducedSize[2] = { 0, 0 };
  int MostTargets = 8;
  double Blend = 1.0;
  bool IsListing = false;
  DestinationType Destination = Picture;
  /// Number of pictures in the sum before this one; -1 where pictures are not summed up.
  int Number = -1;
  float Shift[2] = { 0.0f, 0.0f };
  /// Pixel of the framebuffer on which the picture's first one falls.
  int Origin[2] = { 0, 0 };
  ActiveTextures Textures;
};

//------------------------------------------------------------------------------
vtkFourierOpacityPainter::vtkFourierOpacityPainter() = default;

//------------------------------------------------------------------------------
vtkFourierOpacityPainter::~vtkFourierOpacityPainter() = default;

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::Check(vtkOpenGLRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  if (major < 4 || (major == 4 && minor < 2))
  {
    return "OpenGL " + std::to_string(major) + "." + std::to_string(minor) +
      " has no images that shaders write to: opacity optimization needs OpenGL 4.2. "
      "vtkIlluminatedLineMapper and vtkVoxelLineMapper need 3.2.";
  }
  return {};
}

//------------------------------------------------------------------------------
vtkFourierOpacityPainter::View& vtkFourierOpacityPainter::GetView(vtkRenderer* renderer)
{
  this->Views.remove_if([](const std::unique_ptr<View>& view) { return !view->Renderer; });
  for (const std::unique_ptr<View>& view : this->Views)
  {
    if (view->Renderer == renderer)
    {
      return *view;
    }
  }
  this->Views.push_back(std::make_unique<View>());
  this->Views.back()->Renderer = renderer;
  return *this->Views.back();
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::Prepare(Frame& frame)
{
  std::vector<vtkFourierOpacityGroup> groups;
  for (const Item& item : frame.Items)
  {
    groups.push_back(item.Mapper->UpdateElements());
  }
  frame.View.Elements.SetGroups(groups);

  const auto time = std::chrono::steady_clock::now();
  const double transition = frame.Optimization->GetTransitionTime();
  if (transition > 0.0 && frame.View.HasLast && !frame.View.Last.IsJump(frame.Now))
  {
    const double seconds =
      std::chrono::duration<double>(time - frame.View.Time).count();
    frame.Blend = vtkOpacitySmoothing::GetBlend(seconds, transition);
  }
  const int largest = frame.Optimization->GetAccumulationFrames();
  if (largest > 1)
  {
    frame.Number = frame.View.Accumulator.Begin(frame.Renderer, frame.Optimization, largest);
    // While opacities follow, no picture shows the same as the one before.
    const bool follows =
      std::chrono::duration<double>(time - frame.View.LastChange).count() < transition;
    if (frame.Number == 0)
    {
      frame.View.LastChange = time;
    }
    else if (follows)
    {
      frame.Number = 0;
    }
    const glm::dvec2 offset =
      vtkVoxelLineAccumulator::GetOffset(std::min(frame.Number, largest - 1));
    frame.Shift[0] = static_cast<float>(2.0 * offset.x / frame.Now.Size[0]);
    frame.Shift[1] = static_cast<float>(2.0 * offset.y / frame.Now.Size[1]);
  }
  frame.View.Last = frame.Now;
  frame.View.HasLast = true;
  frame.View.Time = time;

  int draws = 8;
  int attachments = 8;
  frame.State->vtkglGetIntegerv(GL_MAX_DRAW_BUFFERS, &draws);
  frame.State->vtkglGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &attachments);
  frame.MostTargets = std::min(draws, attachments);
  frame.Reduction = frame.Optimization->GetImportanceReduction();
  for (int i = 0; i < 2; ++i)
  {
    frame.ReducedSize[i] = (frame.Now.Size[i] + frame.Reduction - 1) / frame.Reduction;
  }

  vtkFourierOpacityTargets::Layout layout;
  layout.Width = frame.Now.Size[0];
  layout.Height = frame.Now.Size[1];
  layout.Sums = frame.Stages.Sums;
  layout.BoundsWidth = frame.Stages.HasBounds ? frame.ReducedSize[0] : 0;
  layout.BoundsHeight = frame.Stages.HasBounds ? frame.ReducedSize[1] : 0;
  layout.HasCounts = !frame.Stages.HasSums && !frame.Stages.HasLists;
  layout.HasOpaqueLayer = frame.Stages.HasOpaqueLayer;
  layout.HasPicture = frame.Destination == Picture;
  return this->Targets.Prepare(frame.Window, layout);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::SetCommonParameters(const Frame& frame, vtkShaderProgram* program)
{
  if (program->IsUniformUsed("fourierProjection"))
  {
    const double* from = frame.Now.Projection;
    const float projection[4] = { static_cast<float>(from[0]), static_cast<float>(from[1]),
      static_cast<float>(from[2]), static_cast<float>(from[3]) };
    program->SetUniform4f("fourierProjection", projection);
  }
  if (program->IsUniformUsed("fourierRange"))
  {
    const double near = frame.Now.Range[0];
    const double far = frame.Now.Range[1];
    const double size = frame.Stages.IsLogarithmic ? std::log(far / near) : far - near;
    const float range[2] = { static_cast<float>(near), static_cast<float>(1.0 / size) };
    program->SetUniform2f("fourierRange", range);
  }
  if (program->IsUniformUsed("fourierWeights"))
  {
    vtkOpacityOptimization* from = frame.Optimization;
    const float weights[4] = { static_cast<float>(from->GetRegularizationWeight()),
      static_cast<float>(from->GetForegroundWeight()),
      static_cast<float>(from->GetBackgroundWeight()), static_cast<float>(from->GetEmphasis()) };
    program->SetUniform4f("fourierWeights", weights);
  }
  if (program->IsUniformUsed("fourierOrigin"))
  {
    program->SetUniform2i("fourierOrigin", frame.Origin);
  }
  if (program->IsUniformUsed("fourierMeanFactor"))
  {
    program->SetUniformf(
      "fourierMeanFactor", 1.0f / std::max(1, frame.View.Accumulator.GetNumber()));
  }
  if (program->IsUniformUsed("fourierSize"))
  {
    program->SetUniform2i("fourierSize", frame.Now.Size);
  }
  if (program->IsUniformUsed("fourierShift"))
  {
    program->SetUniform2f("fourierShift", frame.Shift);
  }
  SetIfUsed(program, "fourierReduction", frame.Reduction);
  SetIfUsed(program, "fourierElementShift", this->Shift);
  SetIfUsed(program, "fourierSmallest", static_cast<int>(SmallestUnit));
  frame.Textures.SetParameters(program);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::DrawStage(Frame& frame, vtkFourierOpacityStage& stage)
{
  stage.SetParameters = [&](vtkShaderProgram* program)
  {
    this->SetCommonParameters(frame, program);
    SetIfUsed(program, "fourierFirstElement", stage.FirstElement);
    if (frame.IsListing)
    {
      this->Lists.SetParameters(program);
    }
  };
  stage.Reduction = stage.IsReduced ? frame.Reduction : 1;
  for (std::size_t i = 0; i < frame.Items.size(); ++i)
  {
    stage.FirstElement = static_cast<int>(frame.View.Elements.GetFirstElement(i));
    frame.DrawItem(frame.Items[i], stage);
  }
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::UploadElements(Frame& frame, const std::vector<float>& values,
  vtkLineSetsBufferTexture& buffer, unsigned int format)
{
  const int type = format == GL_R32F ? VTK_FLOAT : VTK_UNSIGNED_INT;
  return buffer.Upload(frame.Window, values.data(), values.size(), sizeof(float), format, 1, type)
    ? std::string()
    : "There is no memory on the graphics device for the opacities of " +
      std::to_string(values.size()) + " segments.";
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::SumImportance(Frame& frame)
{
  // Opacities stay as they are in later pictures of the same view, of which only bounds are needed.
  const bool sumsUp = !frame.Stages.Exact && frame.Number <= 0;
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
    this->DrawStage(frame, stage);
    if (outputs.Bounds)
    {
      glBlendEquationi(boundsTarget, GL_FUNC_ADD);
    }
  }
  frame.Textures.Clear();
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::PrepareSmallest(Frame& frame, std::vector<float>& values)
{
  const vtkIdType count = std::max<vtkIdType>(frame.View.Elements.GetNumberOfElements(), 1);
  // Where the device takes fewer places than there are elements, neighbours share one.
  int most = 0;
  frame.State->vtkglGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  this->Shift = 0;
  while (((count - 1) >> this->Shift) >= most)
  {
    ++this->Shift;
  }
  values.assign(static_cast<std::size_t>(((count - 1) >> this->Shift) + 1),
    vtkFourierOpacityElements::NotSeen);
  // Floats that are not negative are in the order of their bits.
  return this->UploadElements(frame, values, this->Smallest, GL_R32UI);
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::FindOpacities(Frame& frame)
{
  std::vector<float> values;
  std::string error = this->PrepareSmallest(frame, values);
  if (error.empty() && frame.Number > 0)
  {
    return this->UploadOpacities(frame, values);
  }
  if (!error.empty())
  {
    return error;
  }
  const SavedImageUnit savedUnit(SmallestUnit);
  glBindImageTexture(
    SmallestUnit, this->Smallest.GetHandle(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  frame.Textures.Add("fourierScene", frame.Scene);
  if (frame.Stages.Exact)
  {
    vtkFourierOpacityStage stage = frame.Stages.ListImportance();
    error = this->DrawLists(frame, stage, frame.ReducedSize, this->Targets.Colors,
      frame.Stages.ResolveImportance());
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
    this->DrawStage(frame, stage);
    frame.State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  frame.Textures.Clear();
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  if (!error.empty())
  {
    return error;
  }
  this->Smallest.Download(values.data(), values.size() * sizeof(float));
  frame.View.Elements.Update(
    values, this->Shift, frame.Optimization->GetSmoothingIterations(), frame.Blend);
  return this->UploadOpacities(frame, values);
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::UploadOpacities(Frame& frame, std::vector<float>& values)
{
  const std::vector<float>& opacities = frame.View.Elements.GetOpacities();
  if (this->Shift == 0 && !opacities.empty())
  {
    return this->UploadElements(frame, opacities, this->Opacities, GL_R32F);
  }
  std::fill(values.begin(), values.end(), 1.0f);
  for (std::size_t i = 0; i < opacities.size(); ++i)
  {
    float& value = values[i >> this->Shift];
    value = std::min(value, opacities[i]);
  }
  return this->UploadElements(frame, values, this->Opacities, GL_R32F);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::AddSumTextures(Frame& frame)
{
  for (std::size_t i = 0; i < this->Targets.Sums.size(); ++i)
  {
    frame.Textures.Add("fourierSums" + std::to_string(i), this->Targets.Sums[i]);
  }
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::DrawOpaqueLayer(Frame& frame)
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
  this->DrawStage(frame, stage);
  frame.Textures.Clear();
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::Widen(Frame& frame)
{
  frame.State->vtkglViewport(0, 0, frame.ReducedSize[0], frame.ReducedSize[1]);
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
void vtkFourierOpacityPainter::SumOpticalDepth(Frame& frame)
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
  const int sums = frame.Stages.HasSums ? static_cast<int>(this->Targets.Sums.size()) : 0;
  for (const auto& outputs : PartOutputs(sums, false, frame.MostTargets))
  {
    const auto first = this->Targets.Sums.begin() + outputs.First;
    this->Targets.Bind(
      std::vector<vtkTextureObject*>(first, first + outputs.Count), frame.Scene);
    frame.State->vtkglClear(GL_COLOR_BUFFER_BIT);
    vtkFourierOpacityStage stage = frame.Stages.SumOpticalDepth(outputs);
    this->DrawStage(frame, stage);
  }
  // The next stage reads the same textures.
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::AddColors(Frame& frame)
{
  std::vector<vtkTextureObject*> targets = { this->Targets.Colors };
  if (frame.Stages.HasSums)
  {
    this->AddSumTextures(frame);
  }
  else
  {
    targets.push_back(this->Targets.Counts);
  }
  this->Targets.Bind(targets, frame.Scene);
  frame.State->vtkglClear(GL_COLOR_BUFFER_BIT);
  vtkFourierOpacityStage stage = frame.Stages.AddColors();
  this->DrawStage(frame, stage);
  frame.Textures.Clear();
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::ListColors(Frame& frame)
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
std::string vtkFourierOpacityPainter::DrawQuad(Frame& frame, const std::string& source)
{
  vtkShaderProgram* program = vtkLineSetsQuad::ReadyProgram(frame.Window, source);
  if (!program)
  {
    return "A shader of opacity optimization does not compile.";
  }
  this->SetCommonParameters(frame, program);
  return vtkLineSetsQuad::Draw(frame.Window, program);
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::DrawLists(Frame& frame, vtkFourierOpacityStage& stage,
  const int size[2], vtkTextureObject* target, const std::string& resolve)
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
  frame.IsListing = true;
  frame.State->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  this->DrawStage(frame, stage);
  error = this->Lists.FinishCounting();
  for (int i = 0; error.empty() && i < this->Lists.GetNumberOfStrips(); ++i)
  {
    this->Lists.BeginStrip(i);
    this->DrawStage(frame, stage);
    error = this->Lists.SortStrip();
    vtkShaderProgram* program =
      error.empty() ? vtkLineSetsQuad::ReadyProgram(frame.Window, resolve) : nullptr;
    if (program)
    {
      frame.State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      this->SetCommonParameters(frame, program);
      this->Lists.SetReadParameters(program);
      error = vtkLineSetsQuad::Draw(frame.Window, program);
      frame.State->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    }
    else if (error.empty())
    {
      error = "A shader of fragment lists does not compile.";
    }
  }
  frame.IsListing = false;
  frame.State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  this->Lists.End();
  this->NumberOfDroppedFragments += this->Lists.GetNumberOfDroppedFragments();
  return error;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::Accumulate(Frame& frame)
{
  vtkTextureObject* sum = frame.View.Sum;
  if (frame.Number == 0 && !vtkFourierOpacityTargets::MakeColors(frame.Window, sum, frame.Now.Size))
  {
    return "There is no memory on the graphics device to accumulate pictures.";
  }
  this->Targets.Bind({ sum }, nullptr);
  if (frame.Number == 0)
  {
    frame.State->vtkglClear(GL_COLOR_BUFFER_BIT);
  }
  frame.State->vtkglViewport(0, 0, frame.Now.Size[0], frame.Now.Size[1]);
  frame.State->vtkglDisable(GL_DEPTH_TEST);
  frame.State->vtkglEnable(GL_BLEND);
  frame.State->vtkglBlendFunc(GL_ONE, GL_ONE);
  std::string error = this->Finish(frame);
  if (error.empty())
  {
    frame.View.Accumulator.Add();
  }
  return error;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::Finish(Frame& frame)
{
  if (frame.Stages.HasSums)
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
std::string vtkFourierOpacityPainter::Show(Frame& frame)
{
  frame.State->vtkglDisable(GL_DEPTH_TEST);
  frame.State->vtkglDepthMask(GL_FALSE);
  if (frame.Destination == Picture)
  {
    frame.State->vtkglDisable(GL_BLEND);
    frame.State->vtkglViewport(0, 0, frame.Now.Size[0], frame.Now.Size[1]);
    this->Targets.Bind({ this->Targets.Color, this->Targets.Depth }, nullptr);
  }
  else
  {
    frame.State->vtkglEnable(GL_BLEND);
    frame.State->vtkglBlendFuncSeparate(
      GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  if (frame.Number < 0)
  {
    return this->Finish(frame);
  }
  frame.Textures.Add("fourierColors", frame.View.Sum);
  std::string error = this->DrawQuad(frame, frame.Stages.ShowMean());
  frame.Textures.Clear();
  return error;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::MakePicture(Frame& frame, const int origin[2])
{
  frame.Scene =
    this->SceneDepth.Copy(frame.Window, origin, frame.Now.Size[0], frame.Now.Size[1]);
  if (!frame.Scene)
  {
    return "The depth of the opaque scene cannot be read.";
  }
  frame.State->vtkglDisable(GL_SCISSOR_TEST);
#ifdef GL_MULTISAMPLE
  frame.State->vtkglDisable(GL_MULTISAMPLE);
#endif
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
  return error.empty() && frame.Number >= 0 ? this->Accumulate(frame) : error;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::Draw(vtkRenderer* renderer, const std::vector<Item>& items,
  vtkOpacityOptimization* optimization, const DrawFunction& drawItem, DestinationType destination,
  std::string& warning)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return "The renderer has no window of OpenGL.";
  }
  std::string error = this->Check(window);
  if (!error.empty())
  {
    return error;
  }
  if (this->Window && this->Window != window)
  {
    vtkSmartPointer<vtkOpenGLRenderWindow> other = this->Window.GetPointer();
    other->PushContext();
    this->ReleaseGraphicsResources(other);
    other->PopContext();
    window->MakeCurrent();
  }
  this->Window = window;

  vtkFourierOpacityView now;
  std::vector<vtkActor*> actors;
  for (const Item& item : items)
  {
    actors.push_back(item.Actor);
  }
  now.Set(renderer, actors);
  Frame frame(renderer, items, optimization, drawItem, now, this->GetView(renderer));
  frame.Destination = destination;
  this->LastView = &frame.View;
  this->LastItems = items;
  error = this->Prepare(frame);
  if (!error.empty())
  {
    return error;
  }

  const SavedState saved(frame.State);
  int viewport[4];
  frame.State->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  frame.Origin[0] = destination == Picture ? 0 : viewport[0];
  frame.Origin[1] = destination == Picture ? 0 : viewport[1];
  int tiledOrigin[2];
  int size[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &tiledOrigin[0], &tiledOrigin[1]);
  int readOrigin[2];
  vtkLineSetsSceneDepth::GetReadOrigin(window, viewport, tiledOrigin, readOrigin);
  // Enough pictures are in the sum, or one more is made.
  if (frame.Number < optimization->GetAccumulationFrames())
  {
    const SavedState target(frame.State);
    error = this->MakePicture(frame, readOrigin);
  }
  error = error.empty() ? this->Show(frame) : error;
  if (!error.empty())
  {
    frame.View.Accumulator.Forget();
  }
  this->NumberOfAccumulatedPictures = frame.Number < 0 ? 1 : frame.View.Accumulator.GetNumber();
  if (this->NumberOfDroppedFragments > 0)
  {
    warning = std::to_string(this->NumberOfDroppedFragments) +
      " fragments did not fit into the lists and are not drawn: MaximumListMemory is " +
      std::to_string(optimization->GetMaximumListMemory()) + " MiB.";
  }
  return error;
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityPainter::BeginSelection(
  vtkRenderer* renderer, const Item& item, vtkFourierOpacityStage& stage)
{
  vtkTextureObject* texture = this->Opacities.GetTexture();
  const auto found = std::find_if(this->LastItems.begin(), this->LastItems.end(),
    [&item](const Item& last) { return last.Actor == item.Actor && last.Mapper == item.Mapper; });
  if (!this->LastView || this->LastView->Renderer != renderer || found == this->LastItems.end() ||
    texture->GetHandle() == 0)
  {
    return false;
  }
  texture->Activate();
  const auto first = static_cast<int>(
    this->LastView->Elements.GetFirstElement(found - this->LastItems.begin()));
  const int shift = this->Shift;
  stage = vtkFourierOpacityStages::Select();
  stage.SetParameters = [texture, first, shift](vtkShaderProgram* program)
  {
    SetIfUsed(program, "fourierOpacities", texture->GetTextureUnit());
    SetIfUsed(program, "fourierFirstElement", first);
    SetIfUsed(program, "fourierElementShift", shift);
  };
  return true;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::EndSelection()
{
  this->Opacities.Deactivate();
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityPainter::GetNumberOfBytes() const
{
  vtkIdType bytes = this->Targets.GetNumberOfBytes() + this->SceneDepth.GetNumberOfBytes() +
    static_cast<vtkIdType>(this->Smallest.GetNumberOfBytes() + this->Opacities.GetNumberOfBytes()) +
    this->Lists.GetNumberOfBytes();
  for (const std::unique_ptr<View>& view : this->Views)
  {
    bytes += vtkFourierOpacityTargets::GetNumberOfColorBytes(view->Sum);
  }
  return bytes;
}

//------------------------------------------------------------------------------
const std::vector<float>& vtkFourierOpacityPainter::GetOpacities() const
{
  static const std::vector<float> none;
  return this->LastView ? this->LastView->Elements.GetOpacities() : none;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  // A mapper that meets a new window in the middle of a picture leaves the old one then.
  if (window && this->Window && window != this->Window.GetPointer())
  {
    return;
  }
  this->Targets.ReleaseGraphicsResources(window);
  this->SceneDepth.ReleaseGraphicsResources(window);
  for (const std::unique_ptr<View>& view : this->Views)
  {
    view->Sum->ReleaseGraphicsResources(window);
    view->Accumulator.Forget();
  }
  this->Smallest.Release(window);
  this->Opacities.Release(window);
  this->Lists.ReleaseGraphicsResources(window);
  this->Window = nullptr;
}
