// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards vtkVoxelLineDensities: the densities of all levels are what a direct sum over the segments
 * gives, with constant opacity, with a table by attribute, with NaN, with direct colours, and with
 * radii, on grids of odd sizes, of a single voxel and of none; a change of opacity gives the same
 * as a new build; threads change nothing; and sampling is trilinear. And that vtkVoxelLineDensity
 * hands out each level in its place.
 */

#include "VoxelLineTesting.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkVoxelLineDensities.h"
#include "vtkVoxelLineDensity.h"

#include <functional>
#include <limits>

using namespace VoxelLineTesting;

namespace
{

using Table = std::array<double, 256>;
/// Mean opacity of a segment by its index.
using OpacityOf = std::function<double(vtkIdType)>;

/// Curves in a box of unequal sides, with an array of values or colours.
vtkSmartPointer<vtkPolyData> MakeInput(vtkDataArray* values = nullptr)
{
  std::vector<Curve> curves = MakeSmoothCurves(40, 60);
  for (Curve& curve : curves)
  {
    for (Point& point : curve)
    {
      point[1] *= 0.55;
      point[2] *= 0.3;
    }
  }
  vtkSmartPointer<vtkPolyData> lines = MakeLines(curves);
  if (values)
  {
    values->SetName("Values");
    values->SetNumberOfTuples(lines->GetNumberOfPoints());
    std::mt19937 generator(7);
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      for (int component = 0; component < values->GetNumberOfComponents(); ++component)
      {
        values->SetComponent(i, component, static_cast<double>(generator() % 256));
      }
    }
    lines->GetPointData()->SetScalars(values);
  }
  return lines;
}

Table MakeTable()
{
  Table table;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    table[i] = 0.5 + 0.5 * std::sin(0.37 * static_cast<double>(i));
  }
  return table;
}

/// Mean of the table along a segment by many small steps, the table being interpolated linearly.
double IntegrateTable(const Table& table, int start, int end, bool hasNaN)
{
  constexpr int steps = 4096;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double t = (i + 0.5) / steps;
    if (hasNaN && (start == 255 || end == 255))
    {
      sum += table[static_cast<std::size_t>(t < 0.5 ? start : end)];
      continue;
    }
    const double q = (1.0 - t) * start + t * end;
    const std::size_t low = std::min<std::size_t>(static_cast<std::size_t>(q), 254);
    sum += table[low] + (q - static_cast<double>(low)) * (table[low + 1] - table[low]);
  }
  return sum / steps;
}

/// Densities of all voxels of a level by the definition, straight from the segments: a voxel of
/// level L has the sum over all segments inside it, divided by 8^L.
std::map<std::array<int, 3>, double> SumDirectly(
  vtkVoxelLineModel* model, int level, const OpacityOf& opacityOf)
{
  std::map<std::array<int, 3>, double> sums;
  for (const Segment& segment : DecodeModel(model))
  {
    std::array<int, 3> voxel;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      voxel[axis] = segment.Voxel[axis] / (1 << level);
    }
    sums[voxel] += Length(segment.End - segment.Start) * opacityOf(segment.Index);
  }
  for (auto& entry : sums)
  {
    entry.second /= std::pow(8.0, level);
  }
  return sums;
}

/// All levels against direct sums, in every voxel.
void CompareWithSums(Checks& check, const std::string& name, vtkVoxelLineModel* model,
  vtkVoxelLineDensities* densities, const OpacityOf& opacityOf)
{
  const int* size = model->GetDimensions();
  const int largest = std::max({ size[0], size[1], size[2] });
  const int levels = 1 + static_cast<int>(std::ceil(std::log2(largest)));
  check(densities->GetNumberOfLevels() == levels, name + ": number of levels");
  for (int level = 0; level < densities->GetNumberOfLevels(); ++level)
  {
    const std::string here = name + ", level " + std::to_string(level);
    const std::map<std::array<int, 3>, double> sums = SumDirectly(model, level, opacityOf);
    int dimensions[3];
    densities->GetDimensions(level, dimensions);
    double scale = 0.0;
    double error = 0.0;
    for (int k = 0; k < dimensions[2]; ++k)
    {
      for (int j = 0; j < dimensions[1]; ++j)
      {
        for (int i = 0; i < dimensions[0]; ++i)
        {
          const auto sum = sums.find({ i, j, k });
          const double expected = sum == sums.end() ? 0.0 : sum->second;
          scale = std::max(scale, std::abs(expected));
          error = std::max(error, std::abs(densities->GetVoxel(level, i, j, k) - expected));
        }
      }
    }
    bool isSized = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int edge = 1 << level;
      isSized = isSized && dimensions[axis] == (size[axis] + edge - 1) / edge;
    }
    check(isSized, here + ": dimensions");
    // Single precision, rounded once per level.
    check(scale > 0.0 && error <= scale * 1e-7 * (level + 1),
      here + ": densities, off by " + std::to_string(error / scale));
    for (const std::array<int, 3>& outside : { std::array<int, 3>{ -1, 0, 0 },
           std::array<int, 3>{ 0, dimensions[1], 0 }, std::array<int, 3>{ 0, 0, dimensions[2] } })
    {
      check(densities->GetVoxel(level, outside[0], outside[1], outside[2]) == 0.0f,
        here + ": nothing outside the grid");
    }
  }
  int dimensions[3];
  densities->GetDimensions(levels - 1, dimensions);
  check(dimensions[0] == 1 && dimensions[1] == 1 && dimensions[2] == 1, name + ": a single voxel");
  densities->GetDimensions(levels, dimensions);
  check(dimensions[0] == 0 && !densities->GetValues(levels) && !densities->GetValues(-1) &&
      densities->GetVoxel(levels, 0, 0, 0) == 0.0f && densities->GetNumberOfBytes(levels) == 0,
    name + ": no further level");
  check(densities->GetNumberOfBytes(0) == 256 * model->GetNumberOfBricks(),
    name + ": level 0 has the occupied bricks only");
}

/// Grids whose sides are not powers of two, and all encodings.
void TestConstant(Checks& check)
{
  vtkSmartPointer<vtkPolyData> lines = MakeInput();
  for (const std::array<int, 2>& grid :
    { std::array<int, 2>{ 27, 32 }, std::array<int, 2>{ 21, 256 }, std::array<int, 2>{ 32, 0 },
      std::array<int, 2>{ 1, 32 }, std::array<int, 2>{ 3, 8 } })
  {
    vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, lines, grid[0], grid[1]);
    vtkNew<vtkVoxelLineDensities> densities;
    densities->SetOpacity(0.3);
    check(densities->Build(model), "build");
    CompareWithSums(check, "constant, resolution " + std::to_string(grid[0]), model, densities,
      [](vtkIdType) { return 0.3; });
  }
}

void TestTable(Checks& check)
{
  for (const bool hasNaN : { false, true })
  {
    vtkNew<vtkFloatArray> values;
    vtkSmartPointer<vtkPolyData> lines = MakeInput(values);
    for (vtkIdType i = 0; hasNaN && i < values->GetNumberOfTuples(); i += 5)
    {
      values->SetValue(i, std::numeric_limits<float>::quiet_NaN());
    }
    vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, lines, 19, 32);
    check(model->GetAttributeKind() == vtkVoxelLineModel::Scalar &&
        model->GetHasNaNAttribute() == hasNaN,
      "a model with scalars");
    const Table table = MakeTable();
    vtkNew<vtkVoxelLineDensities> densities;
    densities->SetOpacity(0.5);
    densities->SetOpacityTable(table.data());
    check(densities->Build(model), "build");
    vtkUnsignedCharArray* bytes = model->GetAttributes();
    const OpacityOf opacityOf = [&](vtkIdType i) {
      return 0.5 *
        IntegrateTable(table, bytes->GetValue(2 * i), bytes->GetValue(2 * i + 1), hasNaN);
    };
    // The reference takes steps: each kink of the table costs it a little.
    const std::map<std::array<int, 3>, double> sums = SumDirectly(model, 0, opacityOf);
    double error = 0.0;
    for (const auto& entry : sums)
    {
      error = std::max(error,
        std::abs(
          densities->GetVoxel(0, entry.first[0], entry.first[1], entry.first[2]) - entry.second));
    }
    check(sums.size() > 500 && error < 2e-5, "table, each voxel, off by " + std::to_string(error));
    double sum = 0.0;
    for (const auto& entry : sums)
    {
      sum += entry.second;
    }
    const int top = densities->GetNumberOfLevels() - 1;
    check(std::abs(densities->GetVoxel(top, 0, 0, 0) * std::pow(8.0, top) / sum - 1.0) < 1e-5,
      "table, the whole");

    // One that is the same for all values is a constant.
    Table constant;
    constant.fill(0.25);
    densities->SetOpacityTable(constant.data());
    densities->Build(model);
    CompareWithSums(
      check, "constant table", model, densities, [](vtkIdType) { return 0.5 * 0.25; });
  }
}

void TestColors(Checks& check)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  vtkSmartPointer<vtkPolyData> lines = MakeInput(colors);
  vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, lines, 19, 32);
  check(model->GetAttributeKind() == vtkVoxelLineModel::Color, "a model with colours");
  vtkUnsignedCharArray* bytes = model->GetAttributes();
  vtkNew<vtkVoxelLineDensities> densities;
  densities->SetOpacity(0.5);
  check(densities->Build(model), "build");
  CompareWithSums(check, "colours", model, densities,
    [bytes](vtkIdType i)
    { return 0.5 * 0.5 * (bytes->GetValue(8 * i + 3) + bytes->GetValue(8 * i + 7)) / 255.0; });
  densities->UseColorOpacityOff();
  check(densities->Build(model), "build");
  CompareWithSums(
    check, "colours without opacity", model, densities, [](vtkIdType) { return 0.5; });
}

/// A model with one radius per point.
vtkSmartPointer<vtkVoxelLineModel> MakeModelWithRadii(
  Checks& check, vtkPolyData* lines, const std::function<double(vtkIdType)>& radiusOf)
{
  vtkNew<vtkFloatArray> radii;
  radii->SetName("Radii");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    radii->InsertNextValue(static_cast<float>(radiusOf(i)));
  }
  lines->GetPointData()->AddArray(radii);
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetResolution(19);
  voxelizer->SetRadiusArrayName("Radii");
  vtkNew<MessageObserver> observer;
  vtkSmartPointer<vtkVoxelLineModel> model = Update(voxelizer, observer);
  check(!observer->GetError() && model->GetRadii() != nullptr, "a model with radii");
  return model;
}

void TestRadii(Checks& check)
{
  vtkSmartPointer<vtkVoxelLineModel> model = MakeModelWithRadii(check, MakeInput(),
    [](vtkIdType i) { return 0.01 + 0.009 * std::sin(0.4 * static_cast<double>(i)); });
  vtkNew<vtkVoxelLineDensities> densities;
  check(!densities->GetUseRadii(), "radii do not count by default");
  densities->SetOpacity(0.5);
  check(densities->Build(model), "build");
  CompareWithSums(check, "radii, off", model, densities, [](vtkIdType) { return 0.5; });
  const vtkMTimeType time = densities->GetBuildTime();
  densities->UseRadiiOn();
  check(densities->Build(model) && densities->GetBuildTime() > time, "a change builds again");
  vtkUnsignedCharArray* bytes = model->GetRadii();
  CompareWithSums(check, "radii", model, densities,
    [bytes](vtkIdType i)
    { return 0.5 * 0.5 * (bytes->GetValue(2 * i) + bytes->GetValue(2 * i + 1)) / 255.0; });
  std::ostringstream os;
  densities->Print(os);
  check(os.str().find("UseRadii: On") != std::string::npos, "PrintSelf tells it");

  // A cone, seen from the side: a trapezoid, whose area the densities tell.
  model = MakeModelWithRadii(check, MakeLines({ { { 0.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 } } }),
    [](vtkIdType i) { return i == 0 ? 0.1 : 0.4; });
  densities->SetOpacity(1.0);
  check(densities->Build(model), "build");
  const int top = densities->GetNumberOfLevels() - 1;
  const double area = densities->GetVoxel(top, 0, 0, 0) * std::pow(8.0, top) *
    model->GetVoxelSize() * 2.0 * model->GetMaximumRadius();
  check(std::abs(area / 1.5 - 1.0) < 0.01, "the area of a cone, not " + std::to_string(area));

  // Without radii in the model there is no difference.
  model = MakeModel(check, MakeInput(), 19, 32);
  densities->Build(model);
  CompareWithSums(check, "no radii", model, densities, [](vtkIdType) { return 1.0; });
}

/// All values of all levels.
std::vector<std::vector<float>> ValuesOf(vtkVoxelLineDensities* densities)
{
  std::vector<std::vector<float>> values;
  for (int level = 0; level < densities->GetNumberOfLevels(); ++level)
  {
    vtkFloatArray* array = densities->GetValues(level);
    values.emplace_back(array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues());
  }
  return values;
}

/// What a new object makes of the same model and opacities.
std::vector<std::vector<float>> BuildAfresh(
  vtkVoxelLineModel* model, double opacity, const double* table)
{
  vtkNew<vtkVoxelLineDensities> densities;
  densities->SetOpacity(opacity);
  if (table)
  {
    densities->SetOpacityTable(table);
  }
  densities->Build(model);
  return ValuesOf(densities);
}

void TestChanges(Checks& check)
{
  vtkNew<vtkFloatArray> values;
  vtkSmartPointer<vtkPolyData> lines = MakeInput(values);
  vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, lines, 30, 32);
  const Table table = MakeTable();
  vtkNew<vtkVoxelLineDensities> densities;
  check(densities->Build(model) && ValuesOf(densities) == BuildAfresh(model, 1.0, nullptr),
    "the same densities every time");
  const vtkMTimeType time = densities->GetBuildTime();
  densities->SetOpacity(1.0);
  check(densities->Build(model) && densities->GetBuildTime() == time, "no change, no work");

  densities->SetOpacity(0.2);
  check(densities->Build(model) && densities->GetBuildTime() > time &&
      ValuesOf(densities) == BuildAfresh(model, 0.2, nullptr),
    "another opacity");
  densities->SetOpacityTable(table.data());
  check(densities->Build(model) && ValuesOf(densities) == BuildAfresh(model, 0.2, table.data()) &&
      ValuesOf(densities) != BuildAfresh(model, 0.2, nullptr),
    "a table");
  const vtkMTimeType tableTime = densities->GetBuildTime();
  densities->SetOpacityTable(table.data());
  check(densities->Build(model) && densities->GetBuildTime() == tableTime, "an equal table");
  check(densities->GetTableOpacity(9) == table[9], "entry of the table");
  densities->RemoveOpacityTable();
  check(densities->Build(model) && ValuesOf(densities) == BuildAfresh(model, 0.2, nullptr),
    "no table again");

  // Another model: smaller, so that what was there must go.
  vtkSmartPointer<vtkVoxelLineModel> other = MakeModel(check, lines, 9, 32);
  check(densities->Build(other) && ValuesOf(densities) == BuildAfresh(other, 0.2, nullptr),
    "another model");
  // The same object with another content.
  other->ShallowCopy(model);
  check(densities->Build(other) && ValuesOf(densities) == BuildAfresh(model, 0.2, nullptr),
    "another content");
}

void TestThreads(Checks& check)
{
  vtkSmartPointer<vtkVoxelLineModel> model =
    MakeModel(check, MakeLines(MakeSmoothCurves(3000, 40)), 60, 32);
  vtkSMPTools::SetBackend("Sequential");
  const std::vector<std::vector<float>> expected = BuildAfresh(model, 0.7, nullptr);
  check(expected.size() == 7 && expected[0].size() > 100000, "enough for many tasks");
  for (int threads : { 1, 2, 7 })
  {
    vtkSMPTools::SetBackend("STDThread");
    vtkSMPTools::Initialize(threads);
    check(BuildAfresh(model, 0.7, nullptr) == expected, std::to_string(threads) + " threads");
  }
}

/// Values in the centres of voxels, linear in between, fading to 0 within half a voxel outside.
void TestSampling(Checks& check)
{
  vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, MakeInput(), 21, 32);
  vtkNew<vtkVoxelLineDensities> densities;
  densities->Build(model);
  double centreError = 0.0;
  double linearError = 0.0;
  double largest = 0.0;
  for (int level = 0; level < densities->GetNumberOfLevels(); ++level)
  {
    int size[3];
    densities->GetDimensions(level, size);
    const double edge = 1 << level;
    for (int k = -1; k < size[2]; ++k)
    {
      for (int j = -1; j < size[1]; ++j)
      {
        for (int i = -1; i < size[0]; ++i)
        {
          const double centre[3] = { edge * (i + 0.5), edge * (j + 0.5), edge * (k + 0.5) };
          const double here = densities->GetVoxel(level, i, j, k);
          largest = std::max(largest, here);
          centreError =
            std::max(centreError, std::abs(densities->GetDensity(level, centre) - here));
          // The trilinear function between eight centres, written out.
          const double f[3] = { 0.25, 0.6, 0.9 };
          const double between[3] = { centre[0] + edge * f[0], centre[1] + edge * f[1],
            centre[2] + edge * f[2] };
          double expected = 0.0;
          for (int corner = 0; corner < 8; ++corner)
          {
            const int x = corner % 2;
            const int y = corner / 2 % 2;
            const int z = corner / 4;
            expected += (x ? f[0] : 1.0 - f[0]) * (y ? f[1] : 1.0 - f[1]) *
              (z ? f[2] : 1.0 - f[2]) * densities->GetVoxel(level, i + x, j + y, k + z);
          }
          linearError =
            std::max(linearError, std::abs(densities->GetDensity(level, between) - expected));
        }
      }
    }
  }
  check(largest > 1.0 && centreError < 1e-12 && linearError < 1e-12, "trilinear sampling");
  const double far[3] = { 1e300, 3.0, 3.0 };
  const double nan[3] = { 3.0, std::numeric_limits<double>::quiet_NaN(), 3.0 };
  const double inside[3] = { 3.0, 3.0, 3.0 };
  check(densities->GetDensity(0, far) == 0.0 && densities->GetDensity(0, nan) == 0.0 &&
      densities->GetDensity(-1, inside) == 0.0 && densities->GetDensity(99, inside) == 0.0,
    "nothing far away, nowhere, and at levels that do not exist");
}

void TestBadInput(Checks& check)
{
  vtkNew<MessageObserver> observer;
  vtkNew<vtkVoxelLineDensities> densities;
  densities->AddObserver(vtkCommand::ErrorEvent, observer);
  densities->AddObserver(vtkCommand::WarningEvent, observer);
  vtkNew<vtkVoxelLineModel> empty;
  check(densities->Build(empty) && densities->GetNumberOfLevels() == 0 &&
      densities->GetNumberOfBytes() == 0 && !observer->GetError(),
    "an empty model has no levels");
  check(!densities->Build(nullptr) && observer->NumberOfErrors == 1, "no model");
  observer->Clear();

  vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, MakeInput(), 21, 32);
  check(densities->Build(model) && densities->GetNumberOfLevels() > 0, "build");
  densities->SetOpacity(std::numeric_limits<double>::infinity());
  check(!densities->Build(model) && observer->NumberOfErrors == 1 &&
      observer->ErrorMessage.find("Opacity is inf") != std::string::npos &&
      densities->GetNumberOfLevels() == 0,
    "infinite opacity");
  observer->Clear();
  densities->SetOpacity(1.0);
  vtkNew<vtkVoxelLineModel> incomplete;
  incomplete->ShallowCopy(model);
  incomplete->SetVoxelStarts(nullptr);
  check(!densities->Build(incomplete) && observer->NumberOfErrors == 1 &&
      observer->ErrorMessage.find("VoxelStarts is missing") != std::string::npos,
    "an incomplete model");
  observer->Clear();
  Table table = MakeTable();
  table[3] = std::numeric_limits<double>::quiet_NaN();
  densities->SetOpacityTable(table.data());
  check(observer->NumberOfWarnings == 1 &&
      observer->WarningMessage.find("1 of the 256") != std::string::npos &&
      densities->GetTableOpacity(3) == 0.0 && densities->GetTableOpacity(4) == table[4],
    "a table with NaN");

  // Stopped half-way, there is nothing; afterwards everything.
  struct Stopper : vtkCommand
  {
    void Execute(vtkObject* caller, unsigned long, void*) override
    {
      static_cast<vtkVoxelLineDensities*>(caller)->SetAbortBuild(true);
    }
  };
  vtkNew<vtkVoxelLineDensities> stopped;
  vtkSmartPointer<Stopper> stopper;
  stopper.TakeReference(new Stopper);
  const unsigned long tag = stopped->AddObserver(vtkCommand::ProgressEvent, stopper);
  check(!stopped->Build(model) && stopped->GetNumberOfLevels() == 0, "an aborted build");
  stopped->RemoveObserver(tag);
  check(stopped->Build(model) && stopped->GetNumberOfLevels() == 6, "a build after it");
}

/// The filter: every level in its place, opacity by values, and its errors.
void TestFilter(Checks& check)
{
  vtkNew<vtkFloatArray> values;
  vtkSmartPointer<vtkPolyData> lines = MakeInput(values);
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetResolution(21);
  vtkNew<vtkVoxelLineDensity> density;
  density->SetInputConnection(voxelizer->GetOutputPort());
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.2);
  function->AddPoint(255.0, 0.8);
  density->SetOpacityFunction(function);
  density->Update();
  vtkVoxelLineModel* model = voxelizer->GetOutput();
  vtkNew<vtkVoxelLineDensities> densities;
  Table table;
  const double* range = model->GetAttributeRange();
  for (std::size_t i = 0; i < 256; ++i)
  {
    const double value = range[0] + static_cast<double>(i) / 255.0 * (range[1] - range[0]);
    table[i] = 0.2 + 0.6 * value / 255.0;
  }
  densities->SetOpacityTable(table.data());
  densities->Build(model);
  for (int level = 0; level < densities->GetNumberOfLevels(); ++level)
  {
    const std::string name = "image of level " + std::to_string(level);
    density->SetLevel(level);
    density->Update();
    vtkImageData* image = density->GetOutput();
    int size[3];
    densities->GetDimensions(level, size);
    check(image->GetDimensions()[0] == size[0] && image->GetDimensions()[1] == size[1] &&
        image->GetDimensions()[2] == size[2],
      name + ": size");
    double error = 0.0;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      Point world;
      image->GetPoint(i, world.data());
      const Point local = ToLocal(model, world);
      error = std::max(error,
        std::abs(image->GetPointData()->GetScalars()->GetComponent(i, 0) -
          densities->GetDensity(level, local.data())));
    }
    check(error < 1e-5, name + ": values, off by " + std::to_string(error));
  }
  // A change of the function is a change of the filter.
  density->SetLevel(densities->GetNumberOfLevels() - 1);
  density->Update();
  const double before = density->GetOutput()->GetPointData()->GetScalars()->GetComponent(0, 0);
  function->RemoveAllPoints();
  function->AddPoint(0.0, 0.1);
  density->Update();
  const double after = density->GetOutput()->GetPointData()->GetScalars()->GetComponent(0, 0);
  check(after > 0.0 && after < 0.5 * before, "another opacity function");

  vtkNew<MessageObserver> observer;
  density->AddObserver(vtkCommand::ErrorEvent, observer);
  density->AddObserver(vtkCommand::WarningEvent, observer);
  for (const int level : { -1, 6 })
  {
    observer->Clear();
    density->SetLevel(level);
    density->Update();
    check(observer->NumberOfErrors == 1 &&
        observer->ErrorMessage.find("levels 0 to 5") != std::string::npos &&
        density->GetErrorCode() == vtkErrorCode::UserError &&
        density->GetOutput()->GetNumberOfPoints() == 0,
      "a level that does not exist");
  }
  observer->Clear();
  density->SetLevel(0);
  density->SetOpacity(std::numeric_limits<double>::quiet_NaN());
  density->Update();
  check(observer->NumberOfErrors == 1 && density->GetErrorCode() == vtkErrorCode::UserError,
    "an opacity of NaN");
  observer->Clear();
  density->SetOpacity(1.0);
  voxelizer->GenerateAttributesOff();
  density->Update();
  check(observer->NumberOfErrors == 0 && observer->NumberOfWarnings == 1 &&
      density->GetOutput()->GetNumberOfPoints() > 0,
    "an opacity function without attributes");
}

}

int TestVoxelLineDensities(int, char*[])
{
  Checks check;
  TestConstant(check);
  TestTable(check);
  TestColors(check);
  TestRadii(check);
  TestChanges(check);
  TestThreads(check);
  TestSampling(check);
  TestBadInput(check);
  TestFilter(check);
  return check.GetResult();
}
