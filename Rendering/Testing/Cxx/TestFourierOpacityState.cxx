// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that OpenGL's state is the same after a picture with optimized opacity as before, with any
// method; any number of bands, also of more sums than a draw has targets; a mapper of two actors;
// and a locale with another decimal point.

#include "FourierOpacityScene.h"
#include "GLStateTesting.h"
#include "vtkTranslucentPass.h"

#include <clocale>

using namespace FourierOpacityTesting;

namespace
{
constexpr Method Methods[] = { { Optimization::Fourier, Optimization::SeriesImportance },
  { Optimization::Fourier, Optimization::ExactImportance },
  { Optimization::PaperFourier, Optimization::SeriesImportance },
  { Optimization::Bins, Optimization::ExactImportance },
  { Optimization::WeightedAverage, Optimization::SeriesImportance },
  { Optimization::WeightedAverage, Optimization::ExactImportance },
  { Optimization::WeightedBlended, Optimization::ExactImportance },
  { Optimization::FragmentLists, Optimization::ExactImportance },
  { Optimization::FragmentLists, Optimization::SeriesImportance } };

void CheckState(Checks& check, const Method& method)
{
  Scene stage(method);
  vtkNew<StatePass> state;
  state->Delegate = vtkSmartPointer<vtkTranslucentPass>::New();
  state->HasCulling = false;
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(state);
  vtkOpenGLRenderer::SafeDownCast(stage.Renderer)->SetPass(steps);
  for (int bands : { 1, 5, 16 })
  {
    stage.GetOptimization()->SetNumberOfBands(bands);
    stage.Render();
    check(state->Error == GL_NO_ERROR, GetName(method) + ": error of OpenGL");
    check(state->IsSame, GetName(method) + ": the state of OpenGL is the same afterwards");
  }
  stage.GetOptimization()->SetAccumulationFrames(3);
  for (int i = 0; i < 4; ++i)
  {
    stage.Render();
    check(state->IsSame && state->Error == GL_NO_ERROR,
      GetName(method) + ": state while pictures accumulate");
  }
}

// Sums of 1 to 16 bands: on this device there are at most 8 targets of a draw, or more elsewhere.
void CheckBands(Checks& check)
{
  std::vector<Square> squares = MakeSquares(12, 5, 40);
  // What is in the last of any number of bins is seen.
  squares.back().Z = GetZ(0.995);
  squares.back().Color = { 255, 255, 255, 150 };
  for (int method : { Optimization::Fourier, Optimization::PaperFourier, Optimization::Bins })
  {
    OpacityStage stage(16, 16);
    std::vector<Square> drawn = squares;
    AddEnds(drawn);
    stage.Mapper->SetInputData(MakeStack(drawn));
    for (int bands = 1; bands <= 16; ++bands)
    {
      Blending by;
      by.Method = method;
      by.Bands = bands;
      by.Set(stage.GetOptimization());
      CheckColor(check, std::string(MethodNames[method]) + ", " + std::to_string(bands) + " bands",
        stage.Stage::Render().At(8, 8), BlendBy(by, squares, Background), 2.0);
      // Half floats, but the first sum, where Fourier has them.
      const int bytes = 4 + 2 * bands * (method == Optimization::Fourier ? 2 : 4);
      check(stage.Mapper->GetNumberOfSumBytes() == 16 * 16 * bytes,
        "bytes of the sums of " + std::to_string(bands) + " bands");
      check(stage.Mapper->GetNumberOfBytes() > stage.Mapper->GetNumberOfSumBytes(), "bytes");
    }
  }
}

// Two actors of one mapper are two layers, each in its place.
void CheckSharedMapper(Checks& check)
{
  OpacityStage stage;
  stage.Mapper->SetInputData(MakeStack({ { 0.0, 0.0, 0.0, 0.2, { 250, 120, 30, 255 } } }));
  stage.Actor->SetPosition(-0.5, 0.0, 0.0);
  auto other = stage.Add(stage.Mapper);
  other->GetProperty()->LightingOff();
  other->SetPosition(0.5, 0.0, 0.0);
  for (int i = 0; i < 2; ++i)
  {
    const Picture picture = stage.Stage::Render();
    for (int x : { 8, 24 })
    {
      CheckColor(check, "an actor of a shared mapper", picture.At(x, 16), { 250, 120, 30 }, 1.0);
    }
    check(picture.At(16, 16) == Background, "between the actors of a shared mapper");
  }
}

// Shaders have a decimal point whatever the locale has.
void CheckLocale(Checks& check)
{
  Scene plain;
  const Picture expected = plain.Render();
  const std::string old = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* locale : { "de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "German_Germany.1252" })
  {
    if (std::setlocale(LC_NUMERIC, locale))
    {
      Scene other;
      CheckSame(check, std::string("locale ") + locale, other.Render(), expected);
      std::setlocale(LC_NUMERIC, old.c_str());
    }
  }
}
}

int TestFourierOpacityState(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  auto messages = Listen();
  for (const Method& method : Methods)
  {
    CheckState(check, method);
  }
  CheckBands(check);
  CheckSharedMapper(check);
  CheckLocale(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
