// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards how stacks of layers are blended by each method: against the method's own formula in
// double precision, over the exact background, within the colours of the layers, near to what lists
// give, with opaque layers, opaque actors, equal depths and thousands of layers.

#include "FourierOpacityTesting.h"

using namespace FourierOpacityTesting;

namespace
{
// The picture and its opacity are rounded to bytes before they are blended with the background.
constexpr double Tolerance = 1.6;

constexpr int Methods[] = { Optimization::Fourier, Optimization::PaperFourier, Optimization::Bins,
  Optimization::WeightedAverage, Optimization::WeightedBlended, Optimization::FragmentLists };

std::array<int, 3> Draw(OpacityStage& stage, const std::vector<Square>& squares)
{
  const Picture picture = stage.Render(MakeStack(squares));
  return picture.At(16, 16);
}

Square MakeLayer(double depth, const std::array<unsigned char, 4>& color)
{
  return { 0.0, 0.0, GetZ(depth), 0.5, color };
}

constexpr std::array<unsigned char, 4> Red{ 230, 20, 40, 128 };
constexpr std::array<unsigned char, 4> Green{ 30, 210, 10, 90 };
constexpr std::array<unsigned char, 4> Blue{ 0, 60, 250, 200 };

struct NamedStack
{
  std::string Name;
  std::vector<Square> Squares;
};

std::vector<NamedStack> MakeStacks()
{
  std::vector<NamedStack> stacks = {
    { "one layer", { MakeLayer(0.3, Red) } },
    { "two layers", { MakeLayer(0.3, Red), MakeLayer(0.6, Blue) } },
    { "two near layers", { MakeLayer(0.50, Blue), MakeLayer(0.52, Red) } },
    { "layers at the ends", { MakeLayer(0.0, Red), MakeLayer(1.0, Blue) } },
    { "two layers at one depth", { MakeLayer(0.4, Red), MakeLayer(0.4, Blue) } },
    { "two and two layers at one depth",
      { MakeLayer(0.2, Red), MakeLayer(0.2, Green), MakeLayer(0.7, Blue), MakeLayer(0.7, Red) } },
    { "a layer of opacity 0", { MakeLayer(0.2, { 255, 255, 255, 0 }), MakeLayer(0.5, Red) } },
    { "4 layers", MakeSquares(4, 20, 240) },
    { "10 layers", MakeSquares(10, 5, 200) },
    { "50 layers", MakeSquares(50, 2, 60) },
  };
  for (double depth : { 0.02, 0.47, 0.98 })
  {
    std::vector<Square> squares = MakeSquares(10, 10, 120);
    squares.push_back(MakeLayer(depth, { 255, 255, 255, 255 }));
    stacks.push_back({ "opaque at " + std::to_string(depth), squares });
  }
  return stacks;
}

void CheckHull(Checks& check, const std::string& name, const std::array<int, 3>& color,
  const std::vector<Square>& squares)
{
  for (int k = 0; k < 3; ++k)
  {
    int low = Background[k];
    int high = low;
    for (const Square& square : squares)
    {
      low = std::min<int>(low, square.Color[k]);
      high = std::max<int>(high, square.Color[k]);
    }
    check(color[k] >= low - 1 && color[k] <= high + 1, name + ": colour within its layers");
  }
}

// Where depths are equal, lists have some order; the rest of the methods has none.
bool HasEqualDepths(const std::vector<Square>& squares)
{
  for (std::size_t i = 1; i < squares.size(); ++i)
  {
    if (squares[i].Z == squares[i - 1].Z)
    {
      return true;
    }
  }
  return false;
}

void CheckFormulas(Checks& check)
{
  const std::vector<NamedStack> stacks = MakeStacks();
  for (int method : Methods)
  {
    // By the depths of the scene, then of the pixel; and with no layer that counts as opaque.
    std::vector<Blending> variants = { { method, 5, false } };
    if (method == Optimization::Fourier)
    {
      variants.push_back({ method, 5, true });
      variants.push_back({ method, 3, true });
      variants.push_back({ method, 5, true, 1.0 });
      variants.push_back({ method, 5, false, 0.5 });
    }
    for (const Blending& by : variants)
    {
      OpacityStage stage;
      by.Set(stage.GetOptimization());
      const std::string name = std::string(MethodNames[method]) + ", " + std::to_string(by.Bands) +
        " bands" + (by.Tight ? ", tight" : "") + ", opaque from " +
        std::to_string(by.OpaqueThreshold) + ", ";
      check(IsNear(Draw(stage, {}), Background, 0), name + "nothing");
      for (const NamedStack& stack : stacks)
      {
        std::vector<Square> drawn = stack.Squares;
        AddEnds(drawn);
        const auto color = Draw(stage, drawn);
        if (method != Optimization::FragmentLists || !HasEqualDepths(stack.Squares))
        {
          CheckColor(
            check, name + stack.Name, color, BlendBy(by, stack.Squares, Background), Tolerance);
        }
        CheckHull(check, name + stack.Name, color, stack.Squares);
      }
    }
  }
}

// Black layers over white: what is left of the white is the product of what they let through.
void CheckBackground(Checks& check)
{
  for (int method : Methods)
  {
    OpacityStage stage;
    stage.Renderer->SetBackground(1.0, 1.0, 1.0);
    stage.GetOptimization()->SetBlending(method);
    for (int layers : { 1, 2, 5, 30, 300 })
    {
      const int most = layers < 10 ? 200 : 400 / layers + 2;
      std::vector<Square> squares = MakeSquares(layers, 1, most);
      double through = 255.0;
      for (Square& square : squares)
      {
        square.Color = { 0, 0, 0, square.Color[3] };
        through *= 1.0 - square.Color[3] / 255.0;
      }
      const auto color = Draw(stage, squares);
      // The mean of opacities lets through what the others do only where all are alike.
      if (method != Optimization::WeightedAverage || layers == 1)
      {
        CheckColor(check,
          std::string(MethodNames[method]) + ", background behind " + std::to_string(layers), color,
          { through, through, through }, Tolerance);
      }
    }
  }
}

// Half of the layers red, the farther half blue.
void CheckThousands(Checks& check)
{
  for (int method : Methods)
  {
    OpacityStage stage(16, 16);
    stage.GetOptimization()->SetBlending(method);
    std::vector<Square> squares = MakeSquares(5000, 3, 3);
    for (std::size_t i = 0; i < squares.size(); ++i)
    {
      squares[i].HalfSize = 0.2;
      squares[i].Color = squares[i].Z > 0.0 ? std::array<unsigned char, 4>{ 220, 0, 20, 3 }
                                            : std::array<unsigned char, 4>{ 0, 0, 240, 3 };
    }
    const auto color = stage.Render(MakeStack(squares)).At(8, 8);
    Blending by;
    by.Method = method;
    const std::string name = std::string(MethodNames[method]) + ", 5000 layers";
    // An optical depth of 29 hides the blue ones where order counts.
    const bool hasOrder =
      method != Optimization::WeightedAverage && method != Optimization::WeightedBlended;
    CheckColor(check, name, color,
      hasOrder ? Point{ 220.0, 0.0, 20.0 } : BlendBy(by, squares, Background), Tolerance);
    CheckHull(check, name, color, squares);
  }
}

// An opaque actor hides what is behind it, and shows through what is in front of it.
void CheckOpaqueActors(Checks& check)
{
  const std::vector<Square> squares = MakeSquares(6, 30, 150);
  const Square block{ 0.0, 0.0, 0.0, 0.5, { 250, 160, 40, 255 } };
  for (int method : Methods)
  {
    OpacityStage stage;
    stage.GetOptimization()->SetBlending(method);
    auto data = MakeStack({ block });
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto opaque = stage.Add(mapper);
    opaque->GetProperty()->LightingOff();
    opaque->ForceOpaqueOn();
    // In front of all, behind the first, just behind the third, between others, behind all.
    for (double z : { 0.95, 0.7, squares[2].Z - 1e-4, 0.05, -0.7, -0.95 })
    {
      opaque->SetPosition(0.0, 0.0, z);
      std::vector<Square> seen;
      std::copy_if(squares.begin(), squares.end(), std::back_inserter(seen),
        [z](const Square& square) { return square.Z > z; });
      std::vector<Square> drawn = squares;
      AddEnds(drawn);
      const auto color = Draw(stage, drawn);
      Blending by;
      by.Method = method;
      CheckColor(check, std::string(MethodNames[method]) + ", opaque actor at " + std::to_string(z),
        color, BlendBy(by, seen, { 250, 160, 40 }), Tolerance);
    }
  }
}

// Mean difference to exact blending, in units of a byte.
void CheckAgainstLists(Checks& check)
{
  std::array<double, 6> errors{};
  int samples = 0;
  std::array<std::unique_ptr<OpacityStage>, 6> stages;
  for (int method : Methods)
  {
    stages[method] = std::make_unique<OpacityStage>();
    stages[method]->GetOptimization()->SetBlending(method);
  }
  for (int round = 0; round < 12; ++round)
  {
    std::vector<Square> squares = MakeSquares(round % 2 == 0 ? 4 : 10, 3, 80);
    Random random(round + 1);
    for (Square& square : squares)
    {
      square.Z = random(-0.9, 0.9);
      for (int k = 0; k < 3; ++k)
      {
        square.Color[k] = static_cast<unsigned char>(random(0.0, 255.0));
      }
      // Some are nearly opaque, below what is drawn as a layer with depth.
      square.Color[3] = random(0.0, 1.0) < 0.2 ? 245 : square.Color[3];
    }
    const Point exact = Blend(squares, Background);
    for (int method : Methods)
    {
      const auto color = Draw(*stages[method], squares);
      for (int k = 0; k < 3; ++k)
      {
        errors[method] += std::abs(color[k] - exact[k]);
      }
    }
    samples += 3;
  }
  for (int method : Methods)
  {
    errors[method] /= samples;
    std::cout << MethodNames[method] << ": mean error " << errors[method] << "\n";
  }
  check(errors[Optimization::FragmentLists] < 0.6, "lists are exact");
  check(errors[Optimization::Fourier] < 5.0, "Fourier is near to exact");
  check(errors[Optimization::Fourier] < 0.5 * errors[Optimization::PaperFourier] &&
      errors[Optimization::Fourier] < errors[Optimization::WeightedAverage] &&
      errors[Optimization::Fourier] < errors[Optimization::WeightedBlended],
    "Fourier is nearer than the paper and than means");
}
}

int TestFourierOpacityBlending(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  CheckFormulas(check);
  CheckBackground(check);
  CheckThousands(check);
  CheckOpaqueActors(check);
  CheckAgainstLists(check);
  return check.GetResult();
}
