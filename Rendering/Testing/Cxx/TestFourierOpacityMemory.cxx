// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards what saves memory: sums of optical depth at reduced resolution, half floats, and the bytes
// that are told. Stacks must blend by the same formula in double precision; each pixel must keep
// its own opacity; what covers a pixel once must hide as much at any reduction; a thousand faint
// layers must add up in half floats; OpenGL must have as many bytes as are told, also after
// changes.

#include "FourierOpacityTesting.h"

#include "vtkCellArray.h"
#include "vtkOpenGLRenderWindow.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

using namespace FourierOpacityTesting;

namespace
{
// The picture and its opacity are rounded to bytes before they are blended with the background.
constexpr double Tolerance = 1.6;

constexpr int Size = 32;

struct Memory
{
  int Reduction;
  bool HalfFloats;

  void Set(Optimization* by) const
  {
    by->SetDepthReduction(this->Reduction);
    by->SetHalfFloats(this->HalfFloats);
  }
  std::string GetName() const
  {
    return "reduction " + std::to_string(this->Reduction) +
      (this->HalfFloats ? ", half floats, " : ", ");
  }
};

constexpr Memory Memories[] = { { 1, true }, { 1, false }, { 2, false }, { 3, true } };

// Squares reach well beyond the pixels that share sums with the one that is looked at.
void CheckFormulas(Checks& check)
{
  for (const Memory& memory : Memories)
  {
    for (const Blending& by : { Blending{}, Blending{ Optimization::Fourier, 3, false, 1.0 } })
    {
      OpacityStage stage;
      by.Set(stage.GetOptimization());
      memory.Set(stage.GetOptimization());
      for (int layers : { 2, 10 })
      {
        std::vector<Square> squares = MakeSquares(layers, 5, 200);
        for (Square& square : squares)
        {
          square.HalfSize = 0.9;
        }
        for (bool hasOpaque : { false, true })
        {
          if (hasOpaque)
          {
            squares.push_back({ 0.0, 0.0, 0.1, 0.9, { 255, 255, 255, 255 } });
          }
          std::vector<Square> drawn = squares;
          AddEnds(drawn);
          CheckColor(check,
            memory.GetName() + std::to_string(by.Bands) + " bands, " + std::to_string(layers) +
              (by.Tight ? " layers, tight" : " layers") + (hasOpaque ? ", opaque" : ""),
            stage.Render(MakeStack(drawn)).At(Size / 2, Size / 2), BlendBy(by, squares, Background),
            Tolerance);
        }
      }
    }
  }
}

// Black squares of all places and sizes before white: no order of theirs changes what a pixel lets
// through, which is the product of its own layers.
void CheckOwnOpacity(Checks& check)
{
  std::vector<Square> squares = MakeSquares(30, 10, 120);
  Random random(4);
  for (Square& square : squares)
  {
    square.X = random(-0.7, 0.7);
    square.Y = random(-0.7, 0.7);
    square.HalfSize = random(0.03, 0.5);
    square.Color = { 0, 0, 0, square.Color[3] };
  }
  for (bool tight : { true, false })
  {
    OpacityStage stage(Size + 1, Size - 1);
    stage.Renderer->SetBackground(1.0, 1.0, 1.0);
    stage.GetOptimization()->SetTightDepth(tight);
    const Picture expected = stage.Render(MakeStack(squares));
    for (const Memory& memory : Memories)
    {
      memory.Set(stage.GetOptimization());
      const Difference difference = Compare(stage.Stage::Render(), expected);
      check(difference.Largest <= 1,
        memory.GetName() + "opacity of each pixel" + VoxelLineMapperTesting::Describe(difference));
    }
  }
}

// Half red lines or points that cover each pixel once, before half a blue square: the blue is seen
// through half of the red, whatever the part of a sum that each of them covers.
vtkSmartPointer<vtkPolyData> MakeCover(bool points, int pixels)
{
  auto data = MakeStack({ { 0.0, 0.0, -0.5, 0.9, { 0, 0, 255, 128 } } });
  data->GetCellData()->Initialize();
  vtkNew<vtkCellArray> cells;
  for (int y = 0; y < Size; y += pixels)
  {
    const double top = (2.0 * y + pixels) / Size - 1.0;
    if (!points)
    {
      cells->InsertNextCell({ data->GetPoints()->InsertNextPoint(-1.1, top, 0.5),
        data->GetPoints()->InsertNextPoint(1.1, top, 0.5) });
    }
    for (int x = 0; points && x < Size; x += pixels)
    {
      cells->InsertNextCell(
        { data->GetPoints()->InsertNextPoint((2.0 * x + pixels) / Size - 1.0, top, 0.5) });
    }
  }
  points ? data->SetVerts(cells) : data->SetLines(cells);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  vtkNew<vtkFloatArray> importance;
  importance->SetName("Importance");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    colors->InsertNextTuple4(i < 4 ? 0 : 255, 0, i < 4 ? 255 : 0, 128);
    importance->InsertNextValue(0.0f);
  }
  data->GetPointData()->SetScalars(colors);
  data->GetPointData()->AddArray(importance);
  return data;
}

void CheckCoverage(Checks& check)
{
  const std::vector<Square> same = { { 0.0, 0.0, 0.5, 0.9, { 255, 0, 0, 128 } },
    { 0.0, 0.0, -0.5, 0.9, { 0, 0, 255, 128 } } };
  const Point expected = BlendBy({}, same, { 0, 0, 0 });
  for (bool points : { false, true })
  {
    for (int pixels : { 1, 8 })
    {
      OpacityStage stage(Size, Size);
      stage.Renderer->SetBackground(0.0, 0.0, 0.0);
      stage.Mapper->SetInputData(MakeCover(points, pixels));
      stage.Actor->GetProperty()->SetLineWidth(static_cast<float>(pixels));
      stage.Actor->GetProperty()->SetPointSize(static_cast<float>(pixels));
      for (int reduction : { 1, 2 })
      {
        stage.GetOptimization()->SetDepthReduction(reduction);
        CheckColor(check,
          std::string(points ? "points" : "lines") + " of " + std::to_string(pixels) +
            " pixels, reduction " + std::to_string(reduction),
          stage.Stage::Render().At(Size / 2, Size / 2), expected, 3.0);
      }
    }
  }
}

// An optical depth of about 12 in a thousand layers, the nearer half red: blue does not show, and
// less of it where layers lie in two clumps, whose sums are large in each band.
void CheckFaintLayers(Checks& check)
{
  for (bool clumps : { false, true })
  {
    std::vector<Square> squares = MakeSquares(1000, 3, 3);
    for (Square& square : squares)
    {
      square.HalfSize = 0.9;
      square.Color = square.Z > 0.0 ? std::array<unsigned char, 4>{ 220, 0, 20, 3 }
                                    : std::array<unsigned char, 4>{ 0, 0, 240, 3 };
      square.Z = clumps ? std::copysign(0.7 + 0.1 * std::abs(square.Z), square.Z) : square.Z;
    }
    const Point exact = BlendBy({}, squares, Background);
    for (const Memory& memory : Memories)
    {
      OpacityStage stage(16, 16);
      memory.Set(stage.GetOptimization());
      CheckColor(check, memory.GetName() + (clumps ? "two clumps" : "a thousand layers"),
        stage.Render(MakeStack(squares)).At(8, 8), exact, memory.HalfFloats ? 8.0 : Tolerance);
    }
  }
}

// Sums of so many opaque layers stop growing in half floats, or are infinite where each stands for
// several: the colour of all is that of each.
void CheckLargeSums(Checks& check)
{
  for (int subset : { 1, 4 })
  {
    const int layers = 10000;
    std::vector<Square> squares = MakeSquares(layers, 250, 255);
    for (Square& square : squares)
    {
      square.HalfSize = 0.9;
      square.Color = { 240, 120, 30, 255 };
    }
    OpacityStage stage(8, 8);
    stage.GetOptimization()->SetOpaqueThreshold(1.0);
    stage.GetOptimization()->SetSubset(subset);
    CheckColor(check, "opaque layers, subset " + std::to_string(subset),
      stage.Render(MakeStack(squares)).At(4, 4), { 240.0, 120.0, 30.0 }, Tolerance);
  }
}

vtkIdType Reduce(int size, int reduction)
{
  return (size + reduction - 1) / reduction;
}

// Bytes of all planar textures of a window, as OpenGL tells their sizes and bits per texel.
vtkIdType CountTextureBytes(vtkRenderWindow* window)
{
  window->MakeCurrent();
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  vtkIdType bytes = 0;
  for (GLuint name = 1; name < 10000; ++name)
  {
    if (!glIsTexture(name))
    {
      continue;
    }
    glBindTexture(GL_TEXTURE_2D, name);
    if (glGetError() != GL_NO_ERROR)
    {
      continue; // another kind of texture
    }
    const auto get = [](GLenum what)
    {
      GLint value = 0;
      glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, what, &value);
      return static_cast<vtkIdType>(value);
    };
    vtkIdType bits = 0;
    for (GLenum channel : { GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
           GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE })
    {
      bits += get(channel);
    }
    bytes += get(GL_TEXTURE_WIDTH) * get(GL_TEXTURE_HEIGHT) * bits / 8;
  }
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
  return bytes;
}

// Those that VTK has for translucent props of its own.
vtkIdType CountOtherBytes(OpacityStage& stage, vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkSmartPointer<vtkActor> actor = stage.Add(mapper, 0.5);
  stage.Actor->VisibilityOff();
  stage.Stage::Render();
  const vtkIdType bytes = CountTextureBytes(stage.Window);
  stage.Renderer->RemoveActor(actor);
  stage.Actor->VisibilityOn();
  return bytes;
}

// What is told is what there is, format by format.
void CheckBytes(Checks& check)
{
  // Points, which are elements each.
  auto data = MakeStack(MakeSquares(7, 10, 90));
  data->GetCellData()->Initialize();
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    cells->InsertNextCell({ i });
  }
  data->SetPolys(nullptr);
  data->SetVerts(cells);
  vtkNew<vtkFloatArray> array;
  array->SetName("Importance");
  array->SetNumberOfValues(data->GetNumberOfPoints());
  array->FillValue(0.5f);
  data->GetPointData()->AddArray(array);
  {
    constexpr int width = 31;
    constexpr int height = 40;
    OpacityStage stage(width, height);
    stage.Mapper->SetInputData(data);
    Optimization* by = stage.GetOptimization();
    const vtkIdType others = CountOtherBytes(stage, data);
    for (int importance : { 2, 3 })
    {
      by->SetImportanceReduction(importance);
      for (int reduction : { 1, 2, 3, 1 })
      {
        for (bool half : { false, true })
        {
          by->SetDepthReduction(reduction);
          by->SetHalfFloats(half);
          stage.Stage::Render();
          const auto pixels = [&](int by_) { return Reduce(width, by_) * Reduce(height, by_); };
          const vtkIdType sums = pixels(std::min(reduction, importance)) * (half ? 24 : 44) +
            (reduction > 1 ? pixels(1) * 4 : 0);
          const std::string name = std::to_string(width) + " pixels, importance " +
            std::to_string(importance) + ", reduction " + std::to_string(reduction) +
            (half ? ", half floats: " : ": ");
          const vtkIdType toldSums = stage.Mapper->GetNumberOfSumBytes();
          check(toldSums == sums,
            name + std::to_string(toldSums) + " bytes of sums, not " + std::to_string(sums));
          // Colours; opaque layer, picture and its depth; two bounds of depth; opacities.
          const vtkIdType rest = pixels(1) * ((half ? 8 : 16) + 4 + 4 + 4) +
            (pixels(importance) + pixels(reduction > 1 ? reduction : importance)) * 4 +
            data->GetNumberOfPoints() * 4;
          const vtkIdType told = stage.Mapper->GetNumberOfBytes();
          check(told == sums + rest,
            name + std::to_string(told) + " bytes, not " + std::to_string(sums + rest));
          // Opacities of elements are in a buffer.
          const vtkIdType textures = told - data->GetNumberOfPoints() * 4;
          const vtkIdType there = CountTextureBytes(stage.Window) - others;
          check(there == textures,
            name + std::to_string(there) + " bytes of textures, not " + std::to_string(textures));
        }
      }
    }
  }
}
}

int TestFourierOpacityMemory(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  CheckFormulas(check);
  CheckOwnOpacity(check);
  CheckCoverage(check);
  CheckFaintLayers(check);
  CheckLargeSums(check);
  CheckBytes(check);
  return check.GetResult();
}
