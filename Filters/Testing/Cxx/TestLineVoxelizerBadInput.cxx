// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards that input which cannot be used never costs the valid rest, is counted, and is told once;
 * and that properties and extents that cannot be used give an error and an empty model.
 */

#include "VoxelLineTesting.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"

#include <limits>

using namespace VoxelLineTesting;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

const Curve Good = { { 0.0, 0.0, 0.0 }, { 1.0, 0.5, 0.25 } };

/// What a voxelizer makes of a line set, and what it says.
struct Outcome
{
  vtkNew<vtkLineVoxelizer> Voxelizer;
  vtkNew<MessageObserver> Observer;
  vtkVoxelLineModel* Model;

  explicit Outcome(vtkPolyData* lines, int resolution = 8, int bins = 32)
  {
    this->Voxelizer->SetInputData(lines);
    this->Voxelizer->SetResolution(resolution);
    this->Voxelizer->SetFaceBins(bins);
    this->Model = Update(this->Voxelizer, this->Observer);
  }

  /// One warning that has the text and no error; no warning at all for an empty text.
  bool Warns(const std::string& text)
  {
    return !this->Observer->GetError() && this->Observer->GetWarning() == !text.empty() &&
      this->Observer->NumberOfWarnings == (text.empty() ? 0 : 1) &&
      this->Observer->WarningMessage.find(text) != std::string::npos;
  }

  bool Fails(const std::string& text)
  {
    return this->Observer->GetError() && this->Model->GetNumberOfSegments() == 0 &&
      this->Voxelizer->GetErrorCode() != vtkErrorCode::NoError &&
      this->Observer->ErrorMessage.find(text) != std::string::npos;
  }

  vtkIdType Dropped(int reason) { return this->Model->GetNumberOfDroppedCurves(reason); }
};

void TestPoints(Checks& check)
{
  for (double bad : { NaN, Infinity, -Infinity })
  {
    const Curve interrupted = { { 0.1, 0.1, 0.1 }, { 0.2, 0.2, 0.1 }, { 0.3, bad, 0.1 },
      { 0.4, 0.2, 0.1 }, { 0.5, 0.3, 0.1 }, { bad, 0.0, 0.0 }, { 0.6, 0.3, 0.1 } };
    Outcome outcome(MakeLines({ Good, interrupted, { { bad, bad, bad }, { 0.0, 0.0, 0.0 } } }));
    const std::string name = "a coordinate of " + std::to_string(bad);
    check(outcome.Warns("3 points that are not finite"), name + ": said once");
    check(outcome.Model->GetNumberOfCurves() == 3, name + ": the curve goes on behind it");
    check(outcome.Model->GetCurveCells()->GetTypedComponent(1, 1) == 1 &&
        outcome.Model->GetCurveCells()->GetTypedComponent(2, 1) == 1,
      name + ": both parts belong to the same cell");
    check(outcome.Model->GetNumberOfDroppedPoints() == 3, name + ": counted");
    check(outcome.Dropped(vtkVoxelLineModel::NonFinitePoints) == 2, name + ": single points left");
    check(outcome.Model->GetBounds()[1] == 1.0 && outcome.Model->GetBounds()[0] == 0.0,
      name + ": bounds");
    const std::vector<Segment> segments = DecodeModel(outcome.Model);
    for (vtkIdType curve = 0; curve < 3; ++curve)
    {
      check(!Chain(segments, curve).empty(), name + ": the rest is there");
    }
  }
}

void TestLines(Checks& check)
{
  {
    Outcome outcome(MakeLines({ { { 5.0, 5.0, 5.0 } }, Good, {} }));
    check(outcome.Warns("2 lines of fewer than two points"), "one-point lines: said once");
    check(outcome.Dropped(vtkVoxelLineModel::TooFewPoints) == 2, "one-point lines: counted");
    check(outcome.Model->GetNumberOfCurves() == 1, "one-point lines: the rest is there");
    check(outcome.Model->GetBounds()[1] == 1.0, "one-point lines are not in the bounds");
    check(outcome.Model->GetCurveCells()->GetTypedComponent(0, 1) == 1, "cell of the rest");
  }
  for (int bins : { 0, 32, 64 })
  {
    const Point place = { 0.3, 0.4, 0.2 };
    Outcome outcome(MakeLines({ Good, { place, place, place } }), 8, bins);
    check(outcome.Warns(""), "zero-length line: no complaint");
    const std::vector<Segment> chain = Chain(DecodeModel(outcome.Model), 1);
    check(chain.size() == 1 && chain[0].Start == chain[0].End, "zero-length line: one point");
    check(!chain.empty() && Length(chain[0].Start - ToLocal(outcome.Model, place)) < 0.08,
      "zero-length line: its place");
  }
  {
    const Curve repeated = { Good[0], Good[0], Good[0], { 0.5, 0.25, 0.125 }, { 0.5, 0.25, 0.125 },
      Good[1], Good[1] };
    Outcome once(MakeLines({ { Good[0], { 0.5, 0.25, 0.125 }, Good[1] } }));
    Outcome outcome(MakeLines({ repeated }));
    check(outcome.Warns(""), "repeated points: no complaint");
    const std::vector<Segment> a = DecodeModel(once.Model);
    const std::vector<Segment> b = DecodeModel(outcome.Model);
    bool isSame = a.size() == b.size();
    for (std::size_t i = 0; isSame && i < a.size(); ++i)
    {
      isSame = a[i].Start == b[i].Start && a[i].End == b[i].End;
    }
    check(isSame, "repeated points change nothing");
  }
  {
    // An id behind the last point, and one before the first.
    vtkSmartPointer<vtkPolyData> lines = MakeLines({ Good, Good, Good });
    vtkNew<vtkCellArray> cells;
    const vtkIdType ids[3][4] = { { 0, 1, 99, 3 }, { 2, 3, -1, 4 }, { 0, 99, 1, -7 } };
    for (const auto& line : ids)
    {
      cells->InsertNextCell(4, line);
    }
    lines->SetLines(cells);
    Outcome outcome(lines);
    check(outcome.Warns("4 point ids that do not exist"), "invalid point ids: said once");
    check(outcome.Model->GetNumberOfCurves() == 2, "invalid point ids: the rest is there");
    check(outcome.Dropped(vtkVoxelLineModel::InvalidPointIds) == 4, "invalid point ids: counted");
    check(outcome.Model->GetNumberOfDroppedPoints() == 4, "invalid point ids: points counted");
  }
}

void TestEmpty(Checks& check)
{
  {
    vtkNew<vtkPolyData> empty;
    Outcome outcome(empty);
    check(outcome.Warns(""), "empty input: no complaint");
    check(outcome.Model->GetNumberOfSegments() == 0 && outcome.Model->GetNumberOfBricks() == 0 &&
        outcome.Model->GetNumberOfOccupiedVoxels() == 0,
      "empty input: empty model");
    check(outcome.Model->GetBounds()[0] > outcome.Model->GetBounds()[1], "empty input: no bounds");
  }
  {
    vtkSmartPointer<vtkPolyData> points = MakeLines({ Good });
    points->SetVerts(points->GetLines());
    points->SetLines(nullptr);
    Outcome outcome(points);
    check(outcome.Warns("no lines, only 1 other cells"), "no lines: said once");
    check(outcome.Model->GetNumberOfSegments() == 0, "no lines: empty model");
  }
  {
    vtkSmartPointer<vtkPolyData> lines = MakeLines({ Good });
    lines->SetPoints(nullptr);
    Outcome outcome(lines);
    check(outcome.Warns("2 point ids that do not exist"), "lines without points: said once");
    check(outcome.Model->GetNumberOfSegments() == 0, "lines without points: empty model");
  }
  {
    // Vertices stand before lines in the numbering of cells.
    vtkSmartPointer<vtkPolyData> lines = MakeLines({ Good });
    vtkNew<vtkCellArray> verts;
    verts->InsertNextCell({ 0 });
    verts->InsertNextCell({ 1 });
    lines->SetVerts(verts);
    Outcome outcome(lines);
    check(outcome.Warns(""), "lines and vertices: no complaint");
    check(
      outcome.Model->GetCurveCells()->GetTypedComponent(0, 1) == 2, "lines and vertices: cell id");
  }
}

/// Every curve is connected and ends where it should, to half the diagonal of an interior bin.
void CheckPlacement(Checks& check, vtkVoxelLineModel* model, const std::vector<Curve>& curves,
  const std::string& name)
{
  const std::vector<Segment> segments = DecodeModel(model);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const std::vector<Segment> chain = Chain(segments, static_cast<vtkIdType>(i));
    const double bound = std::sqrt(0.75) / model->GetInteriorBins() + 1e-9;
    check(!chain.empty() &&
        Length(chain.front().Start - ToLocal(model, curves[i].front())) <= bound &&
        Length(chain.back().End - ToLocal(model, curves[i].back())) <= bound,
      name + ": curve " + std::to_string(i));
  }
  const double* bounds = model->GetBounds();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = model->GetOrigin()[axis];
    const double high = low + model->GetDimensions()[axis] * model->GetVoxelSize();
    const double slack = 1e-6 * model->GetVoxelSize();
    check(low <= bounds[2 * axis] + slack && high >= bounds[2 * axis + 1] - slack,
      name + ": the grid contains the data along axis " + std::to_string(axis));
  }
}

void TestExtents(Checks& check)
{
  const auto moved = [](const std::vector<Curve>& curves, double scale, const Point& offset)
  {
    std::vector<Curve> result = curves;
    for (Curve& curve : result)
    {
      for (Point& point : curve)
      {
        point = scale * point + offset;
      }
    }
    return result;
  };
  const std::vector<Curve> planar = { { { 0.0, 0.0, 3.0 }, { 1.0, 0.7, 3.0 } },
    { { 0.3, 0.9, 3.0 }, { 0.8, 0.1, 3.0 } } };
  const std::vector<Curve> solid = { Good, { { 0.2, 0.9, 0.1 }, { 0.9, 0.1, 1.0 } } };
  struct
  {
    const char* Name;
    std::vector<Curve> Curves;
  } const cases[] = { { "planar data", planar }, { "one line", { Good } },
    { "a line along an axis", { { { 2.0, 5.0, 7.0 }, { 2.0, 5.0, 9.0 } } } },
    { "one point", { { { 2.0, 5.0, 7.0 }, { 2.0, 5.0, 7.0 } } } },
    { "one point at 1e9", { { { 1e9, -1e9, 1e9 }, { 1e9, -1e9, 1e9 } } } },
    { "one point at 1e20", { { { 1e20, 0.0, 1e20 }, { 1e20, 0.0, 1e20 } } } },
    { "coordinates near 1e9", moved(solid, 1.0, { 1e9, -1e9, 1e9 }) },
    { "small data near 1e9", moved(solid, 1e-3, { 1e9, 0.0, 1e9 }) },
    { "large data", moved(solid, 1e299, { 0.0, 0.0, 0.0 }) },
    { "small data", moved(solid, 1e-280, { 0.0, 0.0, 0.0 }) } };
  for (const auto& one : cases)
  {
    Outcome outcome(MakeLines(one.Curves));
    check(outcome.Warns(""), std::string(one.Name) + ": no complaint");
    CheckPlacement(check, outcome.Model, one.Curves, one.Name);
  }
  {
    Outcome outcome(MakeLines(planar));
    check(outcome.Model->GetDimensions()[2] == 1, "planar data: one voxel across");
    check(std::abs(ToLocal(outcome.Model, planar[0][0])[2] - 0.5) < 1e-9,
      "planar data: in the middle of its voxels");
  }
  {
    Outcome outcome(MakeLines(moved(solid, 1e-320, { 0.0, 0.0, 0.0 })));
    check(outcome.Warns("") && outcome.Model->GetNumberOfCurves() == 2 &&
        outcome.Model->GetNumberOfSegments() >= 2,
      "data smaller than the smallest voxel");
  }
  for (double huge : { 1e301, 1.7e308 })
  {
    Outcome outcome(MakeLines({ { { -huge, 0.0, 0.0 }, { huge, 1.0, 0.0 } } }));
    check(outcome.Fails("exceed 1e300"), "coordinates that overflow: error");
  }
}

void TestProperties(Checks& check)
{
  vtkSmartPointer<vtkPolyData> lines = MakeLines({ Good });
  struct
  {
    int Resolution;
    int FaceBins;
    double Tolerance;
    int Component;
    const char* Text;
  } const cases[] = { { 0, 32, 0.1, 0, "Resolution is 0" }, { -5, 32, 0.1, 0, "Resolution is -5" },
    { 4097, 32, 0.1, 0, "Resolution is 4097; it must be 1 to 4096" },
    { 8, 1, 0.1, 0, "FaceBins is 1" }, { 8, 33, 0.1, 0, "FaceBins is 33" },
    { 8, -2, 0.1, 0, "FaceBins is -2" }, { 8, 4096, 0.1, 0, "FaceBins is 4096" },
    { 8, 32, -1.0, 0, "InteriorTolerance is -1" }, { 8, 32, NaN, 0, "InteriorTolerance" },
    { 8, 32, 0.1, -2, "AttributeComponent is -2" } };
  vtkNew<vtkLineVoxelizer> voxelizer;
  vtkNew<MessageObserver> observer;
  voxelizer->SetInputData(lines);
  for (const auto& one : cases)
  {
    voxelizer->SetResolution(one.Resolution);
    voxelizer->SetFaceBins(one.FaceBins);
    voxelizer->SetInteriorTolerance(one.Tolerance);
    voxelizer->SetAttributeComponent(one.Component);
    vtkVoxelLineModel* model = Update(voxelizer, observer);
    check(observer->GetError() && observer->ErrorMessage.find(one.Text) != std::string::npos,
      std::string("error: ") + one.Text);
    check(observer->NumberOfErrors == 1, std::string("one error: ") + one.Text);
    check(voxelizer->GetErrorCode() == vtkErrorCode::UserError, "error code");
    check(model && model->GetNumberOfSegments() == 0, "empty model");
    Update(voxelizer, observer);
    check(!observer->GetError(), "the error is not told again while nothing changes");
  }
  voxelizer->SetResolution(8);
  voxelizer->SetFaceBins(32);
  voxelizer->SetInteriorTolerance(0.1);
  voxelizer->SetAttributeComponent(0);
  check(Update(voxelizer, observer)->GetNumberOfSegments() > 0 && !observer->GetError() &&
      voxelizer->GetErrorCode() == vtkErrorCode::NoError,
    "right properties after wrong ones");

  voxelizer->UseCustomBoundsOn();
  voxelizer->SetCustomBounds(0.0, 1.0, 2.0, 1.0, 0.0, 1.0);
  Update(voxelizer, observer);
  check(observer->GetError() &&
      observer->ErrorMessage.find("CustomBounds along axis 1") != std::string::npos,
    "error: bounds that do not ascend");
  voxelizer->SetCustomBounds(0.0, 1.0, 0.0, 0.25, 0.0, 1.0);
  vtkVoxelLineModel* model = Update(voxelizer, observer);
  check(!observer->GetError() &&
      observer->WarningMessage.find("do not contain all curves") != std::string::npos,
    "bounds too small: said");
  CheckPlacement(check, model, { Good }, "bounds too small");
  voxelizer->SetCustomBounds(-1.0, 3.0, -1.0, 1.0, 0.0, 1.0);
  model = Update(voxelizer, observer);
  check(!observer->GetWarning() && model->GetVoxelSize() == 0.5 && model->GetOrigin()[0] == -1.0 &&
      model->GetDimensions()[0] == 8 && model->GetDimensions()[1] == 4 &&
      model->GetDimensions()[2] == 2,
    "larger bounds make the grid");
  CheckPlacement(check, model, { Good }, "larger bounds");
}

}

int TestLineVoxelizerBadInput(int, char*[])
{
  Checks check;
  TestPoints(check);
  TestLines(check);
  TestEmpty(check);
  TestExtents(check);
  TestProperties(check);
  return check.GetResult();
}
