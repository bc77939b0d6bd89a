// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFragmentLists.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkLineSetsQuad.h"
#include "vtkLineSetsScopedState.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include "vtkFragmentListPassResolve.h"
#include "vtkFragmentListPassStore.h"
#include "vtkFragmentListsRead.h"
#include "vtkFragmentListsSort.h"
#include "vtkFragmentListsStore.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace
{
// Image units, in the order of the uniforms below.
enum Unit
{
  RoomUnit,
  RangesUnit,
  NodesUnit,
  DroppedUnit,
  NumberOfUnits
};
constexpr const char* UniformNames[NumberOfUnits] = { "fragmentListRoom", "fragmentListRanges",
  "fragmentListNodes", "fragmentListDropped" };

// Four components of 32 bits.
constexpr std::size_t BytesPerNode = 16;

// Software OpenGL ends the loops of a shader after 65535 turns in all; one draw stays below that.
constexpr int MaximumNumberOfTurns = 60000;

// A buffer of up to so many nodes (16 MiB) is kept however few are needed.
constexpr std::size_t KeptNodes = std::size_t(1) << 20;

int GetInteger(unsigned int which)
{
  int value = 0;
  glGetIntegerv(which, &value);
  return value;
}

bool HasExtension(const char* name)
{
  const int count = GetInteger(GL_NUM_EXTENSIONS);
  for (int i = 0; i < count; ++i)
  {
    const auto* extension =
      reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (extension && std::strcmp(extension, name) == 0)
    {
      return true;
    }
  }
  return false;
}

// One or two unsigned integers per texel, undefined for null.
bool CreateIntegers(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int width, int height,
  int components, std::uint32_t* data)
{
  texture->SetContext(window);
  // An integer texture that were filtered would be incomplete.
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetInternalFormat(components == 1 ? GL_R32UI : GL_RG32UI);
  texture->SetFormat(components == 1 ? GL_RED_INTEGER : GL_RG_INTEGER);
  return vtkLineSetsBufferTexture::ForgetGLErrors() &&
    texture->Create2DFromRaw(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
      components, VTK_UNSIGNED_INT, data) &&
    glGetError() == GL_NO_ERROR;
}

void ReadIntegers(vtkTextureObject* texture, std::uint32_t* data)
{
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  texture->Activate();
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, data);
  texture->Deactivate();
}
}

//------------------------------------------------------------------------------
vtkFragmentLists::vtkFragmentLists() = default;

//------------------------------------------------------------------------------
vtkFragmentLists::~vtkFragmentLists()
{
  this->Release();
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::GetMissingFeatures(vtkOpenGLRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  const int version = 10 * major + minor;
  std::string missing;
  const auto need = [&missing](bool isThere, const std::string& what)
  {
    if (!isThere)
    {
      missing += (missing.empty() ? "" : ", ") + what;
    }
    return isThere;
  };
  need(version >= 33 || HasExtension("GL_ARB_shader_bit_encoding"),
    "OpenGL 3.3 or GL_ARB_shader_bit_encoding");
  if (need(version >= 42 || HasExtension("GL_ARB_shader_image_load_store"),
        "OpenGL 4.2 or GL_ARB_shader_image_load_store"))
  {
    const std::string least = std::to_string(static_cast<int>(NumberOfUnits));
    need(GetInteger(GL_MAX_FRAGMENT_IMAGE_UNIFORMS) >= NumberOfUnits &&
        GetInteger(GL_MAX_IMAGE_UNITS) >= NumberOfUnits,
      least + " images in fragment shaders (GL_MAX_FRAGMENT_IMAGE_UNIFORMS, GL_MAX_IMAGE_UNITS)");
  }
  return missing;
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::GetExtensionSource()
{
  // Parts of later versions of GLSL than the one that VTK asks for.
  return "#extension GL_ARB_shader_image_load_store : require\n"
         "#extension GL_ARB_shader_bit_encoding : require\n";
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::GetStoreSource()
{
  return vtkFragmentListsStore;
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::GetReadSource()
{
  return vtkFragmentListsRead;
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::GetColorStoreSource()
{
  return GetStoreSource() + vtkFragmentListPassStore;
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::GetBlendSource()
{
  std::string source = vtkFragmentListPassResolve;
  vtkShaderProgram::Substitute(source, "//LineSets::FragmentLists::Dec", GetReadSource());
  InsertExtensions(source);
  return source;
}

//------------------------------------------------------------------------------
void vtkFragmentLists::InsertExtensions(std::string& fragmentShader)
{
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::System::Dec", "//VTK::System::Dec\n" + GetExtensionSource(), false);
}

//------------------------------------------------------------------------------
bool vtkFragmentLists::IsContextGone() const
{
  // A window releases textures by itself before its context goes, but not buffers.
  return !this->Window || this->Nodes.IsGone() || (this->Width > 0 && this->Room->GetHandle() == 0);
}

//------------------------------------------------------------------------------
void vtkFragmentLists::Release()
{
  if (this->IsContextGone())
  {
    this->Nodes.Forget();
  }
  else
  {
    vtkOpenGLRenderWindow* window = this->Window;
    window->PushContext();
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Nodes.Release(window);
    for (vtkTextureObject* texture : { this->Room.Get(), this->Ranges.Get(), this->Dropped.Get() })
    {
      texture->ReleaseGraphicsResources(window);
    }
    window->PopContext();
  }
  this->Window = nullptr;
  this->Width = 0;
  this->Height = 0;
  this->Strips.clear();
}

//------------------------------------------------------------------------------
void vtkFragmentLists::ReleaseGraphicsResources(vtkWindow* vtkNotUsed(window))
{
  this->Release();
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::Begin(vtkOpenGLRenderWindow* window, int width, int height)
{
  if (this->Window != window || this->IsContextGone())
  {
    this->Release();
    window->MakeCurrent();
    this->Window = window;
  }
  this->NumberOfFragments = 0;
  this->NumberOfDroppedFragments = 0;
  this->LargestNumberPerPixel = 0;
  this->MeanNumberPerPixel = 0.0;
  this->Strips.clear();
  const std::string size = std::to_string(width) + " by " + std::to_string(height) + " pixels";
  const int largest = GetInteger(GL_MAX_TEXTURE_SIZE);
  if (width < 1 || height < 1 || width > largest || height > largest)
  {
    return "fragment lists of " + size + " were asked for; from 1 to " + std::to_string(largest) +
      " (GL_MAX_TEXTURE_SIZE) are possible in each direction";
  }
  std::uint32_t none = 0;
  if (!this->Resize(width, height) || !CreateIntegers(this->Dropped, window, 1, 1, 1, &none))
  {
    return "there is no memory on the graphics device for the counters of " + size;
  }
  this->ClearCounters();
  for (unsigned int unit = 0; unit < NumberOfUnits; ++unit)
  {
    this->SavedUnits.push_back(std::make_unique<vtkLineSetsScopedState::SavedImageUnit>(unit));
  }
  this->IsCounting = true;
  return {};
}

//------------------------------------------------------------------------------
bool vtkFragmentLists::Resize(int width, int height)
{
  if (this->Width == width && this->Height == height)
  {
    return true;
  }
  this->Width = 0;
  this->Height = 0;
  if (!CreateIntegers(this->Room, this->Window, width, height, 1, nullptr) ||
    !CreateIntegers(this->Ranges, this->Window, width, height, 2, nullptr))
  {
    return false;
  }
  this->Width = width;
  this->Height = height;
  return true;
}

//------------------------------------------------------------------------------
void vtkFragmentLists::ClearCounters()
{
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglColorMask mask(state);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(this->Window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Room);
  this->Framebuffer->ActivateDrawBuffer(0);
  const GLuint zero[4] = { 0, 0, 0, 0 };
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
  glClearBufferuiv(GL_COLOR, 0, zero);
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkFragmentLists::BindImages(vtkShaderProgram* program)
{
  const unsigned int names[NumberOfUnits] = { this->Room->GetHandle(), this->Ranges->GetHandle(),
    this->Nodes.GetHandle(), this->Dropped->GetHandle() };
  const unsigned int formats[NumberOfUnits] = { GL_R32UI, GL_RG32UI, GL_RGBA32UI, GL_R32UI };
  for (int unit = 0; unit < NumberOfUnits; ++unit)
  {
    glBindImageTexture(
      static_cast<GLuint>(unit), names[unit], 0, GL_FALSE, 0, GL_READ_WRITE, formats[unit]);
    if (program->IsUniformUsed(UniformNames[unit]))
    {
      program->SetUniformi(UniformNames[unit], unit);
    }
  }
  int rows[2] = { 0, this->Height };
  if (!this->IsCounting && !this->Strips.empty())
  {
    rows[0] = this->Strips[this->CurrentStrip].First;
    rows[1] = this->Strips[this->CurrentStrip].End;
  }
  program->SetUniformi("fragmentListWidth", this->Width);
  program->SetUniform2i("fragmentListRows", rows);
}

//------------------------------------------------------------------------------
void vtkFragmentLists::SetParameters(vtkShaderProgram* program)
{
  // The compiler may have removed all of it, where a shader stores nothing.
  if (program->IsUniformUsed("fragmentListIsCounting"))
  {
    this->BindImages(program);
    program->SetUniformi("fragmentListIsCounting", this->IsCounting ? 1 : 0);
  }
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::FinishCounting()
{
  this->IsCounting = false;
  this->Counters.resize(static_cast<std::size_t>(this->Width) * this->Height);
  ReadIntegers(this->Room, this->Counters.data());
  this->MeasureCounters();
  const std::size_t maximum = this->GetMaximumNumberOfNodes();
  const bool isLimited = this->MakeStrips(maximum);
  if (this->Strips.empty())
  {
    return {};
  }
  // Where rows do not fit, the room of their pixels is less than what was counted.
  const bool hasCounters = !isLimited ||
    CreateIntegers(this->Room, this->Window, this->Width, this->Height, 1, this->Counters.data());
  if (!hasCounters || !this->UploadRanges())
  {
    this->Strips.clear();
    return "there is no memory on the graphics device for fragment lists of " +
      std::to_string(this->Width) + " by " + std::to_string(this->Height) + " pixels";
  }
  if (!this->AllocateNodes(maximum))
  {
    const std::string bytes = std::to_string(this->Nodes.GetNumberOfBytes());
    this->Nodes.Release(this->Window);
    this->Strips.clear();
    return "there is no memory on the graphics device for the " + bytes +
      " bytes of the fragment lists; a smaller limit of memory divides the picture";
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkFragmentLists::MeasureCounters()
{
  vtkIdType covered = 0;
  for (std::uint32_t count : this->Counters)
  {
    this->NumberOfFragments += count;
    this->LargestNumberPerPixel =
      std::max(this->LargestNumberPerPixel, static_cast<vtkIdType>(count));
    covered += count > 0 ? 1 : 0;
  }
  this->MeanNumberPerPixel =
    covered > 0 ? static_cast<double>(this->NumberOfFragments) / static_cast<double>(covered) : 0.0;
}

//------------------------------------------------------------------------------
std::size_t vtkFragmentLists::GetMaximumNumberOfNodes() const
{
  const std::size_t texels = static_cast<std::size_t>(GetInteger(GL_MAX_TEXTURE_BUFFER_SIZE));
  return std::max<std::size_t>(std::min(this->MaximumNumberOfBytes / BytesPerNode, texels), 1);
}

//------------------------------------------------------------------------------
bool vtkFragmentLists::LimitRow(int row, std::size_t nodes)
{
  std::uint32_t* const first = this->Counters.data() + static_cast<std::size_t>(row) * this->Width;
  std::uint32_t* const last = first + this->Width;
  const auto sum = [first, last](std::uint32_t limit)
  {
    std::size_t total = 0;
    for (const std::uint32_t* count = first; count != last; ++count)
    {
      total += std::min(*count, limit);
    }
    return total;
  };
  // The largest number that all pixels can have.
  std::uint32_t fits = 0;
  std::uint32_t failsFrom = std::numeric_limits<std::uint32_t>::max();
  if (sum(failsFrom) <= nodes)
  {
    return false;
  }
  while (failsFrom - fits > 1)
  {
    const std::uint32_t middle = fits + (failsFrom - fits) / 2;
    (sum(middle) <= nodes ? fits : failsFrom) = middle;
  }
  // Some pixels may have one more.
  std::size_t rest = nodes - sum(fits);
  for (std::uint32_t* count = first; count != last; ++count)
  {
    const bool hasMore = *count > fits && rest > 0;
    rest -= hasMore ? 1 : 0;
    *count = std::min(*count, fits + (hasMore ? 1 : 0));
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkFragmentLists::MakeStrips(std::size_t nodes)
{
  bool isLimited = false;
  this->CurrentStrip = 0;
  for (int row = 0; row < this->Height; ++row)
  {
    isLimited = this->LimitRow(row, nodes) || isLimited;
    const std::uint32_t* count =
      this->Counters.data() + static_cast<std::size_t>(row) * this->Width;
    std::size_t total = 0;
    for (int x = 0; x < this->Width; ++x)
    {
      total += count[x];
    }
    if (total == 0)
    {
      continue;
    }
    if (this->Strips.empty() || this->Strips.back().Nodes + total > nodes)
    {
      this->Strips.push_back({ row, row + 1, 0 });
    }
    this->Strips.back().End = row + 1;
    this->Strips.back().Nodes += total;
  }
  return isLimited;
}

//------------------------------------------------------------------------------
bool vtkFragmentLists::UploadRanges()
{
  std::vector<std::uint32_t> ranges(2 * this->Counters.size(), 0);
  for (const Strip& strip : this->Strips)
  {
    std::uint32_t next = 0;
    const std::size_t end = static_cast<std::size_t>(strip.End) * this->Width;
    for (std::size_t i = static_cast<std::size_t>(strip.First) * this->Width; i < end; ++i)
    {
      ranges[2 * i] = next;
      ranges[2 * i + 1] = this->Counters[i];
      next += this->Counters[i];
    }
  }
  return CreateIntegers(this->Ranges, this->Window, this->Width, this->Height, 2, ranges.data());
}

//------------------------------------------------------------------------------
bool vtkFragmentLists::AllocateNodes(std::size_t maximum)
{
  std::size_t needed = 1;
  for (const Strip& strip : this->Strips)
  {
    needed = std::max(needed, strip.Nodes);
  }
  const std::size_t present = this->Nodes.GetNumberOfBytes() / BytesPerNode;
  const bool isWasted = present > maximum || (present > KeptNodes && present / 4 > needed);
  if (present >= needed && !isWasted)
  {
    return true;
  }
  // Some more than needed, since the next picture may be like this one.
  this->Nodes.Release(this->Window);
  return this->Nodes.Allocate(this->Window, std::min(needed + needed / 8, maximum),
    sizeof(std::uint32_t), GL_RGBA32UI, 4, VTK_UNSIGNED_INT);
}

//------------------------------------------------------------------------------
std::array<int, 2> vtkFragmentLists::GetStripRows(int strip) const
{
  return { this->Strips[strip].First, this->Strips[strip].End };
}

//------------------------------------------------------------------------------
void vtkFragmentLists::BeginStrip(int strip)
{
  // The strip before was sorted in the same buffer.
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  this->CurrentStrip = strip;
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::SortStrip()
{
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  if (this->LargestNumberPerPixel < 2)
  {
    return {};
  }
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglScissor scissor(state);
  const vtkOpenGLState::ScopedglColorMask mask(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglEnableDisable multisample(state, GL_MULTISAMPLE);
  const std::array<int, 2> rows = this->GetStripRows(this->CurrentStrip);
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, rows[0], this->Width, rows[1] - rows[0]);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_MULTISAMPLE);
  state->PushDrawFramebufferBinding();
  // OpenGL wants something to draw to, of the lists' size; no value is written.
  this->Framebuffer->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
  this->Framebuffer->AddColorAttachment(0, this->Room);
  this->Framebuffer->ActivateDrawBuffer(0);
  std::string error = this->DrawSort();
  state->PopDrawFramebufferBinding();
  return error;
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::DrawSort()
{
  std::string source =
    std::string("//VTK::System::Dec\n") + vtkFragmentListsRead + vtkFragmentListsSort;
  InsertExtensions(source);
  vtkShaderProgram* program = vtkLineSetsQuad::ReadyProgram(this->Window, source);
  if (!program)
  {
    return "the shader that sorts fragments does not compile with this OpenGL";
  }
  this->BindImages(program);
  // A step takes one turn and one for each level of the heap.
  const int largest = static_cast<int>(this->LargestNumberPerPixel);
  int turns = 2;
  for (int size = largest; size > 1; size /= 2)
  {
    ++turns;
  }
  const int stepsPerDraw = MaximumNumberOfTurns / turns;
  const int numberOfSteps = largest / 2 + largest - 1;
  std::string error;
  for (int step = 0; error.empty() && step < numberOfSteps; step += stepsPerDraw)
  {
    const int steps[2] = { step, step + stepsPerDraw };
    program->SetUniform2i("fragmentListSteps", steps);
    error = vtkLineSetsQuad::Draw(this->Window, program);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  }
  return error;
}

//------------------------------------------------------------------------------
void vtkFragmentLists::SetReadParameters(vtkShaderProgram* program)
{
  this->BindImages(program);
}

//------------------------------------------------------------------------------
void vtkFragmentLists::End()
{
  this->IsCounting = false;
  std::uint32_t dropped = 0;
  ReadIntegers(this->Dropped, &dropped);
  this->NumberOfDroppedFragments = dropped;
  this->SavedUnits.clear();
}

//------------------------------------------------------------------------------
vtkIdType vtkFragmentLists::GetNumberOfBytes() const
{
  // A counter of 4 bytes and a range of 8 per pixel.
  return static_cast<vtkIdType>(12) * this->Width * this->Height +
    static_cast<vtkIdType>(this->Nodes.GetNumberOfBytes());
}
