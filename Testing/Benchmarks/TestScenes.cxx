// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the benchmark scenes: the counts of the table, finite coordinates, a speed per vertex,
// the same bytes for all numbers of threads, and turbulence without divergence.

#include "ReferenceTesting.h"
#include "SceneFields.h"
#include "Scenes.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <stdexcept>

using namespace linesets;

namespace
{
std::uint64_t AddToHash(std::uint64_t hash, vtkDataArray* array)
{
  const auto* bytes = static_cast<const unsigned char*>(array->GetVoidPointer(0));
  const std::size_t count =
    static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize();
  for (std::size_t i = 0; i < count; ++i)
  {
    hash = (hash ^ bytes[i]) * 0x100000001b3u;
  }
  return hash;
}

std::uint64_t GetHash(vtkPolyData* lines)
{
  return AddToHash(AddToHash(0xcbf29ce484222325u, lines->GetPoints()->GetData()),
    lines->GetPointData()->GetArray("speed"));
}

void CheckScene(Checker& checker, const std::string& name, const SceneOptions& options)
{
  vtkSmartPointer<vtkPolyData> lines = MakeScene(name, options);
  checker.Check(lines->GetNumberOfLines() == options.Lines, name + ": lines");
  checker.Check(
    lines->GetNumberOfPoints() == options.Lines * options.Vertices, name + ": vertices");
  double range[2];
  vtkDataArray* speed = lines->GetPointData()->GetScalars();
  checker.Check(speed && speed->GetNumberOfTuples() == lines->GetNumberOfPoints() &&
      std::string(speed->GetName()) == "speed",
    name + ": speed");
  speed->GetRange(range);
  checker.Check(range[0] >= 0.0 && range[1] > range[0], name + ": speeds");
  int frozen = 0;
  for (vtkIdType i = 1; i < lines->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    lines->GetPoint(i - 1, a);
    lines->GetPoint(i, b);
    checker.Check(
      std::isfinite(b[0]) && std::isfinite(b[1]) && std::isfinite(b[2]), name + ": finite points");
    frozen += a[0] == b[0] && a[1] == b[1] && a[2] == b[2] ? 1 : 0;
  }
  checker.Check(frozen == 0, name + ": repeated points");
  const std::uint64_t hash = GetHash(lines);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
    [&]() { checker.Check(GetHash(MakeScene(name, options)) == hash, name + ": one thread"); });
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 5, "STDThread", false },
    [&]() { checker.Check(GetHash(MakeScene(name, options)) == hash, name + ": five threads"); });
}

void CheckDivergence(Checker& checker)
{
  // Differences over two cells of the grid of 128^3: the finest wave has 5.3 cells, so that they
  // see divergence and gradient alike, and the ratio of both is small.
  const TurbulenceField field(1941);
  const double h = 1.0 / 128.0;
  Random random(1);
  double divergence2 = 0.0;
  double gradient2 = 0.0;
  for (int sample = 0; sample < 2000; ++sample)
  {
    double point[3];
    for (double& x : point)
    {
      x = (1.0 + std::floor(random.Uniform(0, 126))) / 128.0;
    }
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      double after[3] = { point[0], point[1], point[2] };
      double before[3] = { point[0], point[1], point[2] };
      after[axis] += h;
      before[axis] -= h;
      double v[3];
      double w[3];
      field.Evaluate(after, 0.0, v);
      field.Evaluate(before, 0.0, w);
      sum += v[axis] - w[axis];
      for (int i = 0; i < 3; ++i)
      {
        gradient2 += (v[i] - w[i]) * (v[i] - w[i]);
      }
    }
    divergence2 += sum * sum;
  }
  const double ratio = std::sqrt(divergence2 / gradient2);
  checker.Check(ratio < 0.12, "turbulence has no divergence, ratio " + std::to_string(ratio));
}
}

int TestScenes(int argc, char* argv[])
{
  Checker checker;
  SceneOptions options;
  if (argc > 1)
  {
    options.DataFolder = argv[1];
  }
  for (const std::string& name : GetSceneNames())
  {
    options.Lines = 300;
    options.Vertices = name == "forecast" ? 13 : 100;
    CheckScene(checker, name, options);
  }
  // The counts of the paper hold without options; the small scenes stand for all.
  options.Lines = 0;
  options.Vertices = 0;
  vtkSmartPointer<vtkPolyData> tornado = MakeScene("tornado", options);
  checker.Check(tornado->GetNumberOfLines() == 1000 && tornado->GetNumberOfPoints() == 250000,
    "default counts");
  CheckDivergence(checker);
  bool thrown = false;
  try
  {
    MakeScene("nothing", options);
  }
  catch (const std::invalid_argument&)
  {
    thrown = true;
  }
  checker.Check(thrown, "an unknown scene is an error");
  return checker.GetExitCode();
}
