// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the benchmark scenes: the counts of the table, finite coordinates, a speed and an
// importance per vertex, the same bytes for all numbers of threads, turbulence without divergence,
// points that gather and are important where they do, and surfaces whose normals and stream lines
// are those of the flow. And the importance of data in general: its array, its range, its gaps.

#include "ReferenceTesting.h"
#include "SceneFields.h"
#include "SceneImportance.h"
#include "Scenes.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>
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
  std::uint64_t hash = AddToHash(0xcbf29ce484222325u, lines->GetPoints()->GetData());
  for (const char* name : { "speed", "importance", "Normals" })
  {
    if (vtkDataArray* array = lines->GetPointData()->GetArray(name))
    {
      hash = AddToHash(hash, array);
    }
  }
  return hash;
}

// What holds for all scenes.
void CheckPointData(
  Checker& checker, const std::string& name, const SceneOptions& options, vtkPolyData* data)
{
  double range[2];
  vtkDataArray* speed = data->GetPointData()->GetScalars();
  if (!checker.Check(speed && speed->GetNumberOfTuples() == data->GetNumberOfPoints() &&
          std::string(speed->GetName()) == "speed",
        name + ": speed"))
  {
    return;
  }
  speed->GetRange(range);
  checker.Check(range[0] >= 0.0 && range[1] > range[0], name + ": speeds");
  vtkDataArray* importance = data->GetPointData()->GetArray("importance");
  if (!checker.Check(importance && importance->GetDataType() == VTK_FLOAT &&
          importance->GetNumberOfTuples() == data->GetNumberOfPoints(),
        name + ": importance"))
  {
    return;
  }
  // Of lines by length, of others by points.
  const bool isLines = data->GetNumberOfLines() > 0;
  double important = 0.0;
  double all = 0.0;
  double before[3] = { 0.0, 0.0, 0.0 };
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    checker.Check(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]) &&
        std::isfinite(speed->GetComponent(i, 0)),
      name + ": finite points");
    const double value = importance->GetComponent(i, 0);
    checker.Check(value >= 0.0 && value <= 1.0, name + ": range of importance");
    const bool begins = isLines && i % options.Vertices == 0;
    const double weight = !isLines ? 1.0
      : begins                     ? 0.0
                                   : std::sqrt(vtkMath::Distance2BetweenPoints(point, before));
    std::copy_n(point, 3, before);
    important += value > 0.5 ? weight : 0.0;
    all += weight;
  }
  const double share = important / all;
  checker.Check(share > 0.03 && share < 0.25, name + ": important are " + std::to_string(share));
  const std::uint64_t hash = GetHash(data);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
    [&]() { checker.Check(GetHash(MakeScene(name, options)) == hash, name + ": one thread"); });
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 5, "STDThread", false },
    [&]() { checker.Check(GetHash(MakeScene(name, options)) == hash, name + ": five threads"); });
}

// Means of a quantity over the points that are important (at least 0.9) and those that are not
// (0), so that a sign that was mistaken is found out.
void CheckMeaning(
  Checker& checker, const std::string& name, vtkPolyData* data, const Quantity& quantity)
{
  vtkDataArray* importance = data->GetPointData()->GetArray("importance");
  double sums[2] = { 0.0, 0.0 };
  double counts[2] = { 0.0, 0.0 };
  for (vtkIdType i = 0; importance && i < data->GetNumberOfPoints(); ++i)
  {
    const double value = importance->GetComponent(i, 0);
    if (value == 0.0 || value >= 0.9)
    {
      double point[3];
      data->GetPoint(i, point);
      const int side = value > 0.0 ? 1 : 0;
      sums[side] += quantity(i, point);
      counts[side] += 1.0;
    }
  }
  checker.Check(counts[0] > 0.0 && counts[1] > 0.0 && sums[1] / counts[1] > sums[0] / counts[0],
    name + ": what is important");
}

// What is important in a scene of lines, told apart from how the scene tells it.
Quantity GetImportantQuantity(const std::string& name, vtkPolyData* data)
{
  if (name == "tornado")
  {
    return [](vtkIdType, const double p[3])
    {
      return -std::hypot(
        p[0] - 0.5 - 0.1 * std::sin(10.0 * p[2]), p[1] - 0.5 - 0.1 * std::cos(3.0 * p[2]));
    };
  }
  if (name == "forecast")
  {
    return [wind = WindField(1922)](vtkIdType id, const double p[3])
    {
      double vector[3] = { 0.0, 0.0, 0.0 };
      wind.Evaluate(p, (id % 13) / 12.0, vector);
      return vector[2];
    };
  }
  if (name == "lorenz")
  {
    return [](vtkIdType, const double p[3]) { return -std::fabs(p[0]); };
  }
  if (name == "water")
  {
    return [](vtkIdType, const double p[3]) { return -vtkMath::Norm(p); };
  }
  vtkDataArray* speeds = data->GetPointData()->GetScalars();
  return [speeds](vtkIdType id, const double*) { return speeds->GetComponent(id, 0); };
}

void CheckScene(Checker& checker, const std::string& name, const SceneOptions& options)
{
  vtkSmartPointer<vtkPolyData> lines = MakeScene(name, options);
  checker.Check(lines->GetNumberOfLines() == options.Lines, name + ": lines");
  checker.Check(
    lines->GetNumberOfPoints() == options.Lines * options.Vertices, name + ": vertices");
  CheckPointData(checker, name, options, lines);
  CheckMeaning(checker, name, lines, GetImportantQuantity(name, lines));
  int frozen = 0;
  for (vtkIdType i = 1; i < lines->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    lines->GetPoint(i - 1, a);
    lines->GetPoint(i, b);
    frozen += a[0] == b[0] && a[1] == b[1] && a[2] == b[2] ? 1 : 0;
  }
  checker.Check(frozen == 0, name + ": repeated points");
  // Along a line, importance changes little by little.
  vtkDataArray* importance = lines->GetPointData()->GetArray("importance");
  int jumps = 0;
  for (vtkIdType i = 1; importance && i < lines->GetNumberOfPoints(); ++i)
  {
    const double change = importance->GetComponent(i, 0) - importance->GetComponent(i - 1, 0);
    jumps += i % options.Vertices != 0 && std::fabs(change) > 0.5 ? 1 : 0;
  }
  checker.Check(jumps < 0.01 * lines->GetNumberOfPoints(),
    name + ": " + std::to_string(jumps) + " jumps of importance along lines");
}

// The scene of points: cells, the cube, and density by brute force over a sample.
void CheckPoints(Checker& checker)
{
  SceneOptions options;
  options.Lines = 20000;
  vtkSmartPointer<vtkPolyData> data = MakeScene("points", options);
  checker.Check(data->GetNumberOfPoints() == 20000 && data->GetNumberOfVerts() == 20000 &&
      data->GetNumberOfCells() == 20000 && data->GetVerts()->GetNumberOfConnectivityIds() == 20000,
    "points: counts");
  double bounds[6];
  data->GetBounds(bounds);
  for (int i = 0; i < 3; ++i)
  {
    checker.Check(bounds[2 * i] >= 0.0 && bounds[2 * i] < 0.01 && bounds[2 * i + 1] > 0.99 &&
        bounds[2 * i + 1] <= 1.0,
      "points: the cube is filled");
  }
  CheckPointData(checker, "points", options, data);
  const auto countNeighbours = [&data](vtkIdType, const double p[3])
  {
    double count = 0.0;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); i += 20)
    {
      double q[3];
      data->GetPoint(i, q);
      count += vtkMath::Distance2BetweenPoints(p, q) < 0.05 * 0.05 ? 1.0 : 0.0;
    }
    return count;
  };
  CheckMeaning(checker, "points", data, countNeighbours);
  // Even points would have 1000 * 4/3 pi 0.05^3, that is 0.5, on average over all of them.
  double sum = 0.0;
  for (vtkIdType i = 1; i < data->GetNumberOfPoints(); i += 20)
  {
    sum += countNeighbours(i, data->GetPoint(i)) / 1000.0;
  }
  checker.Check(sum > 1.5 * 0.52, "points gather: " + std::to_string(sum) + " neighbours");
}

// Radians per unit of time at which a flow goes around the tornado's core.
double GetTurnRate(const double p[3], const double flow[3])
{
  const double x = p[0] - 0.5 - 0.1 * std::sin(10.0 * p[2]);
  const double y = p[1] - 0.5 - 0.1 * std::cos(3.0 * p[2]);
  return (x * flow[1] - y * flow[0]) / (x * x + y * y);
}

// The scene of surfaces: cells, stream lines that follow the flow, at the rate that makes a turn of
// 5 radians, hence none of which ended early, and normals that agree with those of the triangles.
void CheckSurfaces(Checker& checker)
{
  SceneOptions options;
  options.Lines = 12;
  options.Vertices = 41;
  vtkSmartPointer<vtkPolyData> data = MakeScene("surfaces", options);
  checker.Check(data->GetNumberOfPoints() == 20 * 12 * 41 &&
      data->GetNumberOfPolys() == 20 * 11 * 40 * 2 &&
      data->GetNumberOfCells() == data->GetNumberOfPolys(),
    "surfaces: counts");
  CheckPointData(checker, "surfaces", options, data);
  const TornadoField field;
  for (vtkIdType line = 0; line < 20 * 12; ++line)
  {
    for (vtkIdType i = line * 41; i < line * 41 + 40; ++i)
    {
      double a[3];
      double b[3];
      data->GetPoint(i, a);
      data->GetPoint(i + 1, b);
      double middle[3];
      double flow[3];
      for (int j = 0; j < 3; ++j)
      {
        middle[j] = 0.5 * (a[j] + b[j]);
        b[j] -= a[j];
      }
      checker.Check(field.Evaluate(middle, 0.0, flow), "surfaces: domain");
      const double expected =
        vtkMath::Norm(flow) * 5.0 / 40.0 / std::fabs(GetTurnRate(middle, flow));
      const double length = vtkMath::Norm(b);
      checker.Check(vtkMath::Dot(flow, b) > 0.99 * vtkMath::Norm(flow) * length,
        "surfaces: direction of stream lines");
      checker.CheckNear(length / expected, 1.0, 0.03, "surfaces: steps of stream lines");
    }
  }
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  if (!checker.Check(normals, "surfaces: normals"))
  {
    return;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfPolys(); ++cell)
  {
    data->GetPolys()->GetCellAtId(cell, ids);
    double corners[3][3];
    for (int i = 0; i < 3; ++i)
    {
      data->GetPoint(ids->GetId(i), corners[i]);
    }
    double normal[3];
    vtkTriangle::ComputeNormal(corners[0], corners[1], corners[2], normal);
    for (int i = 0; i < 3; ++i)
    {
      const double* other = normals->GetTuple3(ids->GetId(i));
      checker.Check(
        vtkMath::Dot(normal, other) > 0.7 && std::fabs(vtkMath::Norm(other) - 1.0) < 1e-5,
        "surfaces: normals of triangles");
    }
  }
  CheckMeaning(checker, "surfaces", data,
    [](vtkIdType id, const double*) { return -static_cast<double>(id); }); // from within outward
}

// A line of length 9 whose quantity rises from 0 to 1, and one of length 1 from 1 to 2: by length,
// the quantile 0.76 is at 0.84 of the first and the quantile 0.98 at 0.8 of the second.
void CheckQuantiles(Checker& checker)
{
  constexpr int vertices = 101;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 2 * vertices; ++i)
  {
    const double along = (i % vertices) / 100.0;
    points->InsertNextPoint(i < vertices ? 9.0 * along : along, i < vertices ? 0.0 : 1.0, 0.0);
  }
  data->SetPoints(points);
  const Quantity rising = [](vtkIdType id, const double*)
  { return (id % vertices) / 100.0 + (id < vertices ? 0.0 : 1.0); };
  AddImportance(data, rising, vertices);
  vtkDataArray* importance = data->GetPointData()->GetArray("importance");
  const auto get = [&importance](vtkIdType id) { return importance->GetComponent(id, 0); };
  checker.Check(get(83) == 0.0 && get(86) > 0.0 && get(100) > get(86), "low quantile of length");
  checker.Check(get(vertices + 78) < 1.0 && get(vertices + 82) == 1.0, "high quantile of length");
  // An alternating part goes with smoothing, but at the ends of a line.
  const Quantity alternating = [&rising](vtkIdType id, const double* point)
  { return rising(id, point) + (id % 2 == 0 ? 0.3 : -0.3); };
  AddImportance(data, alternating, vertices, 16);
  importance = data->GetPointData()->GetArray("importance");
  for (int i = 20; i + 20 < vertices; ++i)
  {
    checker.Check(get(vertices + i) >= get(vertices + i - 1), "smoothing");
  }
}

void CheckImportanceOfData(Checker& checker)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(3);
  data->SetPoints(points);
  checker.Check(!MakeImportance(data, ""), "importance of nothing");
  const double values[][3] = { { -2.0, 0.0, 6.0 }, { 0.25, std::nan(""), 0.5 }, { 3, 3, 3 } };
  const double expected[][3] = { { 0.0, 0.25, 1.0 }, { 0.25, 0.0, 0.5 }, { 0, 0, 0 } };
  const char* const names[] = { "heat", "importance", "constant" };
  for (int array = 0; array < 3; ++array)
  {
    vtkNew<vtkDoubleArray> added;
    added->SetName(names[array]);
    for (const double value : values[array])
    {
      added->InsertNextValue(value);
    }
    data->GetPointData()->AddArray(added);
    data->GetPointData()->SetActiveScalars("heat");
    for (const std::string name : { names[array], "" })
    {
      // Without a name, scalars serve until there is an array of that name.
      const int from = name.empty() && array == 2 ? 1 : array;
      vtkSmartPointer<vtkFloatArray> importance = MakeImportance(data, name);
      for (int i = 0; i < 3; ++i)
      {
        checker.CheckNear(importance->GetValue(i), expected[from][i], 1e-6,
          std::string("importance of ") + names[from]);
      }
    }
  }
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(3);
  vectors->Fill(0.5);
  data->GetPointData()->AddArray(vectors);
  vtkNew<vtkDoubleArray> gaps;
  gaps->SetName("gaps");
  gaps->SetNumberOfTuples(3);
  gaps->Fill(std::nan(""));
  data->GetPointData()->AddArray(gaps);
  for (const std::string name : { "none", "vectors", "gaps" })
  {
    bool thrown = false;
    try
    {
      MakeImportance(data, name);
    }
    catch (const std::runtime_error&)
    {
      thrown = true;
    }
    checker.Check(thrown, "no importance of " + name);
  }
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
    if (!IsSceneOfLines(name))
    {
      continue;
    }
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
  CheckPoints(checker);
  CheckSurfaces(checker);
  CheckQuantiles(checker);
  CheckImportanceOfData(checker);
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
