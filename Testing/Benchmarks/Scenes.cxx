// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "PointScene.h"
#include "SceneFields.h"
#include "SceneImportance.h"
#include "SurfaceScene.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataReader.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace linesets
{
namespace
{
using Point = std::array<double, 3>;

void SeedInBox(Random& random, const double low[3], const double high[3], double point[3])
{
  for (int i = 0; i < 3; ++i)
  {
    point[i] = random.Uniform(low[i], high[i]);
  }
}

TraceOptions MakeOptions(const SceneOptions& options, vtkIdType lines, int vertices)
{
  TraceOptions trace;
  trace.Lines = options.Lines > 0 ? options.Lines : lines;
  trace.Vertices = options.Vertices > 0 ? options.Vertices : vertices;
  return trace;
}

// High speed is important. Smoothed along the lines, which have so many vertices.
void MakeSpeedImportant(vtkPolyData* lines, int vertices)
{
  constexpr int smoothings = 16; // to a Gaussian with a standard deviation of 2.8 vertices
  vtkDataArray* speeds = lines->GetPointData()->GetScalars();
  AddImportance(
    lines, [speeds](vtkIdType id, const double*) { return speeds->GetComponent(id, 0); }, vertices,
    smoothings);
}

// Updraft is important: the speed times the slope of the line.
void MakeRiseImportant(vtkPolyData* lines, int vertices)
{
  vtkDataArray* speeds = lines->GetPointData()->GetScalars();
  AddImportance(
    lines,
    [lines, speeds, vertices](vtkIdType id, const double*)
    {
      const vtkIdType first = id - id % vertices;
      double before[3];
      double after[3];
      lines->GetPoint(std::max(id - 1, first), before);
      lines->GetPoint(std::min(id + 1, first + vertices - 1), after);
      const double length = std::sqrt(vtkMath::Distance2BetweenPoints(before, after));
      return length > 0.0 ? speeds->GetComponent(id, 0) * (after[2] - before[2]) / length : 0.0;
    },
    vertices);
}

vtkSmartPointer<vtkPolyData> MakeTornado(const SceneOptions& options)
{
  TraceOptions trace = MakeOptions(options, 1000, 250);
  trace.Seed = 1993;
  trace.MakeSeed = [](vtkIdType, Random& random, double point[3])
  {
    const double low[3] = { 0.0, 0.0, 0.0 };
    const double high[3] = { 1.0, 1.0, 1.0 };
    SeedInBox(random, low, high, point);
  };
  trace.Step = 2.5 / (trace.Vertices - 1.0);
  trace.BothWays = true;
  trace.FewestSteps = trace.Vertices / 5;
  vtkSmartPointer<vtkPolyData> lines = TraceLines(TornadoField(), trace);
  AddImportance(
    lines, [](vtkIdType, const double point[3]) { return -TornadoField::GetCoreDistance(point); },
    trace.Vertices);
  return lines;
}

vtkSmartPointer<vtkPolyData> MakeTurbulence(const SceneOptions& options)
{
  TraceOptions trace = MakeOptions(options, 50000, 220);
  trace.Seed = 1941;
  trace.MakeSeed = [](vtkIdType, Random& random, double point[3])
  {
    const double low[3] = { 0.0, 0.0, 0.0 };
    const double high[3] = { 1.0, 1.0, 1.0 };
    SeedInBox(random, low, high, point);
  };
  trace.Step = 1.0 / 256.0;
  trace.BothWays = true;
  trace.FewestSteps = trace.Vertices / 5;
  vtkSmartPointer<vtkPolyData> lines = TraceLines(TurbulenceField(trace.Seed), trace);
  MakeSpeedImportant(lines, trace.Vertices);
  return lines;
}

vtkSmartPointer<vtkPolyData> MakeForecast(const SceneOptions& options)
{
  TraceOptions trace = MakeOptions(options, 212000, 13);
  trace.Seed = 1922;
  trace.MakeSeed = [](vtkIdType, Random& random, double point[3])
  {
    const double low[3] = { 0.0, 0.0, 0.0 };
    const double high[3] = { 2.0, 1.0, 0.25 };
    SeedInBox(random, low, high, point);
  };
  trace.ByTime = true;
  trace.Step = 1.0 / (trace.Vertices - 1.0);
  trace.Substeps = std::max(1, 36 / (trace.Vertices - 1));
  trace.FewestSteps = trace.Vertices - 2;
  vtkSmartPointer<vtkPolyData> lines = TraceLines(WindField(trace.Seed), trace);
  MakeRiseImportant(lines, trace.Vertices);
  return lines;
}

vtkSmartPointer<vtkPolyData> MakeLorenz(const SceneOptions& options)
{
  TraceOptions trace = MakeOptions(options, 10000, 250);
  trace.Seed = 1963;
  trace.MakeSeed = [](vtkIdType, Random& random, double point[3])
  {
    const double low[3] = { -20.0, -20.0, 5.0 };
    const double high[3] = { 20.0, 20.0, 45.0 };
    SeedInBox(random, low, high, point);
  };
  trace.ByTime = true;
  trace.Step = 0.01;
  vtkSmartPointer<vtkPolyData> lines = TraceLines(LorenzField(), trace);
  AddImportance(
    lines, [](vtkIdType, const double point[3]) { return -std::hypot(point[0], point[1]); },
    trace.Vertices);
  return lines;
}

// Corners of an octahedron whose faces are parted in four, again and again, on the unit sphere.
std::vector<Point> SubdivideSphere(vtkIdType fewest)
{
  std::vector<Point> points = { { { 1, 0, 0 } }, { { -1, 0, 0 } }, { { 0, 1, 0 } },
    { { 0, -1, 0 } }, { { 0, 0, 1 } }, { { 0, 0, -1 } } };
  using Face = std::array<std::size_t, 3>;
  std::vector<Face> faces;
  for (std::size_t i = 0; i < 8; ++i)
  {
    faces.push_back({ { i & 1, 2 + ((i >> 1) & 1), 4 + (i >> 2) } });
  }
  while (static_cast<vtkIdType>(points.size()) < fewest)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&points, &middles](std::size_t a, std::size_t b)
    {
      const auto edge = std::minmax(a, b);
      const auto found = middles.find(edge);
      if (found != middles.end())
      {
        return found->second;
      }
      Point point;
      for (int i = 0; i < 3; ++i)
      {
        point[i] = points[a][i] + points[b][i];
      }
      vtkMath::Normalize(point.data());
      points.push_back(point);
      middles[edge] = points.size() - 1;
      return points.size() - 1;
    };
    std::vector<Face> finer;
    for (const Face& face : faces)
    {
      const std::size_t ab = middle(face[0], face[1]);
      const std::size_t bc = middle(face[1], face[2]);
      const std::size_t ca = middle(face[2], face[0]);
      finer.push_back({ { face[0], ab, ca } });
      finer.push_back({ { ab, face[1], bc } });
      finer.push_back({ { ca, bc, face[2] } });
      finer.push_back({ { ab, bc, ca } });
    }
    faces.swap(finer);
  }
  return points;
}

vtkSmartPointer<vtkPolyData> MakeWater(const SceneOptions& options)
{
  TraceOptions trace = MakeOptions(options, 4098, 216);
  const std::vector<Point> sphere = SubdivideSphere(trace.Lines);
  const std::size_t available = sphere.size();
  // Where fewer lines are asked for than the sphere has points, take them evenly.
  trace.MakeSeed = [&sphere, &trace, available](vtkIdType line, Random&, double point[3])
  {
    const std::size_t index = available * static_cast<std::size_t>(line) / trace.Lines;
    for (int i = 0; i < 3; ++i)
    {
      point[i] = WaterField::OxygenRadius * sphere[index][i];
    }
  };
  // The field points to the oxygen: its lines are followed from there to a hydrogen or the border.
  trace.Backward = true;
  trace.Step = 0.01;
  trace.Steps = 4000;
  trace.Attempts = 1;
  vtkSmartPointer<vtkPolyData> lines = TraceLines(WaterField(), trace);
  AddImportance(
    lines, [](vtkIdType, const double point[3]) { return -WaterField::GetAtomDistance(point); },
    trace.Vertices);
  return lines;
}

vtkSmartPointer<vtkPolyData> MakeCarotid(const SceneOptions& options)
{
  const std::string fileName = options.DataFolder + "/carotid.vti";
  if (!vtksys::SystemTools::FileExists(fileName, true))
  {
    throw std::runtime_error("no file " + fileName);
  }
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  // Flow in the vessels runs at speeds up to 22.7; outside it is noise below 0.1.
  const double slowest = 0.5;
  const double slowestSeed = 2.0;
  const ImageField seeds(reader->GetOutput(), slowestSeed);
  TraceOptions trace = MakeOptions(options, 4700, 410);
  trace.Seed = 2019;
  double bounds[6];
  reader->GetOutput()->GetBounds(bounds);
  trace.MakeSeed = [&bounds, &seeds](vtkIdType, Random& random, double point[3])
  {
    const double low[3] = { bounds[0], bounds[2], bounds[4] };
    const double high[3] = { bounds[1], bounds[3], bounds[5] };
    double vector[3];
    do
    {
      SeedInBox(random, low, high, point);
    } while (!seeds.Evaluate(point, 0.0, vector));
  };
  trace.Step = 100.0 / (trace.Vertices - 1.0);
  trace.BothWays = true;
  trace.FewestSteps = trace.Vertices / 10;
  vtkSmartPointer<vtkPolyData> lines = TraceLines(ImageField(reader->GetOutput(), slowest), trace);
  MakeSpeedImportant(lines, trace.Vertices);
  return lines;
}

vtkSmartPointer<vtkPolyData> MakePoints(const SceneOptions& options)
{
  return MakePointScene(options.Lines > 0 ? options.Lines : 3000000);
}

vtkSmartPointer<vtkPolyData> MakeSurfaces(const SceneOptions& options)
{
  return MakeSurfaceScene(options.Lines > 0 ? static_cast<int>(options.Lines) : 200,
    options.Vertices > 0 ? options.Vertices : 250);
}

struct Scene
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> (*Make)(const SceneOptions&);
  bool Lines = true;
};

const std::vector<Scene>& GetScenes()
{
  static const std::vector<Scene> scenes = { { "tornado", MakeTornado }, { "carotid", MakeCarotid },
    { "turbulence", MakeTurbulence }, { "forecast", MakeForecast }, { "lorenz", MakeLorenz },
    { "water", MakeWater }, { "points", MakePoints, false }, { "surfaces", MakeSurfaces, false } };
  return scenes;
}

const Scene& GetScene(const std::string& name)
{
  for (const Scene& scene : GetScenes())
  {
    if (scene.Name == name)
    {
      return scene;
    }
  }
  throw std::invalid_argument("no scene named " + name);
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetSceneNames()
{
  std::vector<std::string> names;
  for (const Scene& scene : GetScenes())
  {
    names.push_back(scene.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
bool IsSceneOfLines(const std::string& name)
{
  return GetScene(name).Lines;
}

//------------------------------------------------------------------------------
void CheckSceneOptions(const std::string& name, const SceneOptions& options)
{
  GetScene(name);
  if (options.Lines < 0 || options.Vertices < 0 || options.Vertices == 1)
  {
    throw std::invalid_argument("a scene needs lines of at least two vertices");
  }
  if (name == "points" && options.Vertices > 0)
  {
    throw std::invalid_argument(
      "the scene points has no number of vertices, but of lines, which is "
      "that of its points");
  }
  if (name == "surfaces" && (options.Lines == 1 || options.Lines > 1000000))
  {
    throw std::invalid_argument(
      "the scene surfaces needs from 2 to 1000000 lines, which are those of each surface");
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeScene(const std::string& name, const SceneOptions& options)
{
  CheckSceneOptions(name, options);
  return GetScene(name).Make(options);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadScene(const std::string& fileName)
{
  if (!vtksys::SystemTools::FileExists(fileName, true))
  {
    throw std::runtime_error("no file " + fileName);
  }
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(fileName));
  vtkSmartPointer<vtkPolyData> data;
  if (extension == ".vtp")
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(fileName.c_str());
    reader->Update();
    data = reader->GetOutput();
  }
  else if (extension == ".vtk")
  {
    vtkNew<vtkPolyDataReader> reader;
    reader->SetFileName(fileName.c_str());
    reader->Update();
    data = reader->GetOutput();
  }
  else
  {
    throw std::runtime_error(fileName + " is neither .vtp nor .vtk");
  }
  if (data->GetNumberOfLines() == 0 && data->GetNumberOfVerts() == 0 &&
    data->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error(fileName + " has no lines, vertices or polygons");
  }
  return data;
}
}
