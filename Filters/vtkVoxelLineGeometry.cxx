// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineGeometry.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLineSetsCompatibilityPrivate.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineLevelsPrivate.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineRepresentativesPrivate.h"
#include "vtkVoxelLineSegmentsPrivate.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>

vtkStandardNewMacro(vtkVoxelLineGeometry);

namespace
{

using Point = std::array<double, 3>;

constexpr vtkIdType CurvesPerBlock = 64;

/// A segment and where it is: all that is needed to place its end points.
struct PlacedSegment
{
  vtkIdType Index;
  std::array<std::int16_t, 3> Voxel;
};

/// The segments of a model by curve, in the order of the model within each.
struct CurveTable
{
  std::vector<vtkIdType> Starts;
  std::vector<PlacedSegment> Segments;
};

/// A polyline: segments that follow each other.
struct Stretch
{
  vtkIdType Curve;
  std::vector<PlacedSegment> Segments;
};

CurveTable SortByCurve(vtkVoxelLineModel* model, const vtkVoxelLineSegments::Reader& reader)
{
  const std::size_t size = static_cast<std::size_t>(model->GetNumberOfSegments());
  std::vector<std::uint32_t> curves(size);
  std::vector<PlacedSegment> placed(size);
  vtkSMPTools::For(0, reader.GetNumberOfBricks(), 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType brick = begin; brick < end; ++brick)
      {
        reader.VisitVoxels(brick,
          [&](const int voxel[3], vtkIdType first, vtkIdType last)
          {
            for (vtkIdType i = first; i < last; ++i)
            {
              curves[static_cast<std::size_t>(i)] = reader.GetCurve(brick, i);
              placed[static_cast<std::size_t>(i)] = { i,
                { static_cast<std::int16_t>(voxel[0]), static_cast<std::int16_t>(voxel[1]),
                  static_cast<std::int16_t>(voxel[2]) } };
            }
          });
      }
    });

  CurveTable table;
  table.Starts.assign(static_cast<std::size_t>(model->GetNumberOfCurves()) + 1, 0);
  for (std::uint32_t curve : curves)
  {
    ++table.Starts[curve + 1];
  }
  std::partial_sum(table.Starts.begin(), table.Starts.end(), table.Starts.begin());
  std::vector<vtkIdType> cursors(table.Starts);
  table.Segments.resize(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    table.Segments[static_cast<std::size_t>(cursors[curves[i]]++)] = placed[i];
  }
  return table;
}

/// Puts the segments of a curve in a row.
class Joiner
{
public:
  explicit Joiner(const vtkVoxelLineSegments::Reader& reader)
    : Reader(reader)
  {
  }

  void Join(vtkIdType curve, const PlacedSegment* segments, std::size_t size,
    std::vector<Stretch>& stretches)
  {
    this->FindNodes(segments, size);
    // The trail comes out from its end to its start.
    this->FindTrail(this->FindStart(segments, size));
    std::size_t previous = size;
    for (auto i = this->Trail.rbegin(); i != this->Trail.rend(); ++i)
    {
      if (previous == size || this->Ends[previous] != this->Starts[*i])
      {
        stretches.push_back({ curve, {} });
      }
      stretches.back().Segments.push_back(segments[*i]);
      previous = *i;
    }
  }

private:
  /// Number the distinct end points, and list for each the segments that leave it.
  void FindNodes(const PlacedSegment* segments, std::size_t size)
  {
    this->Points.resize(2 * size);
    for (std::size_t i = 0; i < size; ++i)
    {
      Point& start = this->Points[i];
      Point& end = this->Points[size + i];
      this->Reader.GetPoints(segments[i].Index, start.data(), end.data());
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        // The same sum on both sides of a face, so that equal points are equal exactly.
        start[axis] += segments[i].Voxel[axis];
        end[axis] += segments[i].Voxel[axis];
      }
    }
    std::vector<Point>& distinct = this->Distinct;
    distinct = this->Points;
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    const auto nodeOf = [&distinct](const Point& point)
    {
      return static_cast<std::size_t>(
        std::lower_bound(distinct.begin(), distinct.end(), point) - distinct.begin());
    };
    this->Starts.resize(size);
    this->Ends.resize(size);
    this->FirstLeaving.assign(distinct.size() + 1, 0);
    this->Balance.assign(distinct.size(), 0);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Starts[i] = nodeOf(this->Points[i]);
      this->Ends[i] = nodeOf(this->Points[size + i]);
      ++this->FirstLeaving[this->Starts[i] + 1];
      ++this->Balance[this->Starts[i]];
      --this->Balance[this->Ends[i]];
    }
    std::partial_sum(
      this->FirstLeaving.begin(), this->FirstLeaving.end(), this->FirstLeaving.begin());
    this->Cursors = this->FirstLeaving;
    this->Leaving.resize(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Leaving[this->Cursors[this->Starts[i]]++] = i;
    }
    this->Cursors = this->FirstLeaving;
  }

  /// Where more segments leave than arrive; for a closed curve, where it begins inside a voxel.
  std::size_t FindStart(const PlacedSegment* segments, std::size_t size) const
  {
    const auto unbalanced = std::find_if(
      this->Balance.begin(), this->Balance.end(), [](int balance) { return balance > 0; });
    if (unbalanced != this->Balance.end())
    {
      return static_cast<std::size_t>(unbalanced - this->Balance.begin());
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      bool isInside = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double local = this->Points[i][axis] - segments[i].Voxel[axis];
        isInside = isInside && local > 0.0 && local < 1.0;
      }
      if (isInside)
      {
        return this->Starts[i];
      }
    }
    return this->Starts[0];
  }

  /// Where the next stretch begins: where more segments leave than arrive, as long as there are
  /// such points, then where any one leaves.
  std::size_t FindNextStart()
  {
    const std::size_t size = this->Balance.size();
    for (; this->NextStart < 2 * size; ++this->NextStart)
    {
      const std::size_t node = this->NextStart % size;
      if ((this->NextStart >= size || this->Balance[node] > 0) &&
        this->Cursors[node] < this->FirstLeaving[node + 1])
      {
        break;
      }
    }
    return this->NextStart % size;
  }

  void FindTrail(std::size_t node)
  {
    this->NextStart = 0;
    this->Trail.clear();
    this->Path.clear();
    std::size_t remaining = this->Starts.size();
    while (true)
    {
      if (this->Cursors[node] < this->FirstLeaving[node + 1])
      {
        this->Path.push_back(this->Leaving[this->Cursors[node]++]);
        node = this->Ends[this->Path.back()];
        --remaining;
      }
      else if (!this->Path.empty())
      {
        this->Trail.push_back(this->Path.back());
        node = this->Starts[this->Path.back()];
        this->Path.pop_back();
      }
      else if (remaining > 0)
      {
        // Where the segments do not hang together, as those of representatives: another stretch.
        node = this->FindNextStart();
      }
      else
      {
        return;
      }
    }
  }

  const vtkVoxelLineSegments::Reader& Reader;
  std::vector<Point> Points;
  std::vector<Point> Distinct;
  std::vector<std::size_t> Starts;
  std::vector<std::size_t> Ends;
  std::vector<int> Balance;
  std::vector<std::size_t> FirstLeaving;
  std::vector<std::size_t> Cursors;
  std::vector<std::size_t> Leaving;
  std::vector<std::size_t> Path;
  std::vector<std::size_t> Trail;
  /// How far FindNextStart() has looked: once at all nodes for either kind of start.
  std::size_t NextStart = 0;
};

/// Writes points and their data; several threads may write different points.
class PointWriter
{
public:
  PointWriter(vtkVoxelLineModel* model, const vtkVoxelLineSegments::Reader& reader,
    vtkIdType numberOfPoints, vtkPolyData* output)
    : Model(model)
    , Reader(reader)
  {
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(numberOfPoints);
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    output->SetPoints(points);
    this->Points = coordinates->GetPointer(0);
    vtkPointData* data = output->GetPointData();
    if (model->GetAttributes() && model->GetAttributeKind() == vtkVoxelLineModel::Color)
    {
      vtkNew<vtkUnsignedCharArray> colors;
      colors->SetName("Color");
      colors->SetNumberOfComponents(4);
      colors->SetNumberOfTuples(numberOfPoints);
      this->Colors = colors->GetPointer(0);
      data->SetScalars(colors);
    }
    else if (model->GetAttributes())
    {
      vtkNew<vtkFloatArray> scalars;
      scalars->SetName("Attribute");
      scalars->SetNumberOfTuples(numberOfPoints);
      this->Scalars = scalars->GetPointer(0);
      data->SetScalars(scalars);
    }
    if (model->GetRadii())
    {
      vtkNew<vtkDoubleArray> radii;
      radii->SetName("Radius");
      radii->SetNumberOfTuples(numberOfPoints);
      this->Radii = radii->GetPointer(0);
      data->AddArray(radii);
    }
  }

  /// Write the start (0) or end (1) of a segment as the given point.
  void Write(vtkIdType point, const PlacedSegment& segment, int end) const
  {
    double ends[2][3];
    this->Reader.GetPoints(segment.Index, ends[0], ends[1]);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Points[3 * point + axis] = this->Model->GetOrigin()[axis] +
        this->Model->GetVoxelSize() *
          (segment.Voxel[static_cast<std::size_t>(axis)] + ends[end][axis]);
    }
    const vtkIdType row = 2 * segment.Index + end;
    if (this->Colors)
    {
      std::copy_n(this->Model->GetAttributes()->GetPointer(4 * row), 4, this->Colors + 4 * point);
    }
    else if (this->Scalars)
    {
      this->Scalars[point] = this->GetScalar(this->Model->GetAttributes()->GetValue(row));
    }
    if (this->Radii)
    {
      this->Radii[point] =
        this->Model->GetRadii()->GetValue(row) / 255.0 * this->Model->GetMaximumRadius();
    }
  }

private:
  float GetScalar(int byte) const
  {
    const bool hasNaN = this->Model->GetHasNaNAttribute();
    if (hasNaN && byte == 255)
    {
      return std::numeric_limits<float>::quiet_NaN();
    }
    const double* range = this->Model->GetAttributeRange();
    const double fraction = byte / (hasNaN ? 254.0 : 255.0);
    // Not by the difference of the range, which may overflow.
    return static_cast<float>((1.0 - fraction) * range[0] + fraction * range[1]);
  }

  vtkVoxelLineModel* Model;
  const vtkVoxelLineSegments::Reader& Reader;
  double* Points = nullptr;
  unsigned char* Colors = nullptr;
  float* Scalars = nullptr;
  double* Radii = nullptr;
};

vtkIdTypeArray* AddCellArray(vtkPolyData* output, const char* name, vtkIdType size)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(size);
  output->GetCellData()->AddArray(array);
  return array; // The cell data keeps it alive.
}

/// Lines of consecutive points, and the ids of their curves. Returns the first point of each.
vtkSmartPointer<vtkIdTypeArray> WriteCells(
  vtkVoxelLineModel* model, const std::vector<Stretch>& stretches, vtkPolyData* output)
{
  const vtkIdType size = static_cast<vtkIdType>(stretches.size());
  auto offsets = vtkSmartPointer<vtkIdTypeArray>::New();
  offsets->SetNumberOfTuples(size + 1);
  vtkIdTypeArray* curveIds = AddCellArray(output, "CurveId", size);
  vtkIdTypeArray* inputIds = AddCellArray(output, "InputId", size);
  vtkIdTypeArray* cellIds = AddCellArray(output, "CellId", size);
  vtkIdType point = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const Stretch& stretch = stretches[static_cast<std::size_t>(i)];
    offsets->SetValue(i, point);
    point += static_cast<vtkIdType>(stretch.Segments.size()) + 1;
    curveIds->SetValue(i, stretch.Curve);
    inputIds->SetValue(i, model->GetCurveCells()->GetTypedComponent(stretch.Curve, 0));
    cellIds->SetValue(i, model->GetCurveCells()->GetTypedComponent(stretch.Curve, 1));
  }
  offsets->SetValue(size, point);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfTuples(point);
  std::iota(connectivity->GetPointer(0), connectivity->GetPointer(0) + point, 0);
  vtkNew<vtkCellArray> lines;
  lines->SetData(offsets, connectivity);
  output->SetLines(lines);
  return offsets;
}

/// The stretches of all curves, in the order of the curves.
std::vector<Stretch> JoinCurves(const vtkVoxelLineSegments::Reader& reader, const CurveTable& table)
{
  const vtkIdType numberOfCurves = static_cast<vtkIdType>(table.Starts.size()) - 1;
  const vtkIdType numberOfBlocks = (numberOfCurves + CurvesPerBlock - 1) / CurvesPerBlock;
  std::vector<std::vector<Stretch>> blocks(static_cast<std::size_t>(numberOfBlocks));
  vtkSMPTools::For(0, numberOfBlocks, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      Joiner joiner(reader);
      for (vtkIdType block = begin; block < end; ++block)
      {
        const vtkIdType last = std::min((block + 1) * CurvesPerBlock, numberOfCurves);
        for (vtkIdType curve = block * CurvesPerBlock; curve < last; ++curve)
        {
          const std::size_t first =
            static_cast<std::size_t>(table.Starts[static_cast<std::size_t>(curve)]);
          const std::size_t size =
            static_cast<std::size_t>(table.Starts[static_cast<std::size_t>(curve) + 1]) - first;
          if (size > 0)
          {
            joiner.Join(
              curve, table.Segments.data() + first, size, blocks[static_cast<std::size_t>(block)]);
          }
        }
      }
    });
  std::vector<Stretch> stretches;
  for (std::vector<Stretch>& block : blocks)
  {
    std::move(block.begin(), block.end(), std::back_inserter(stretches));
  }
  return stretches;
}

/// Each segment by itself, in the order of the model.
std::vector<Stretch> ListSegments(const CurveTable& table)
{
  std::vector<Stretch> stretches(table.Segments.size());
  for (std::size_t curve = 0; curve + 1 < table.Starts.size(); ++curve)
  {
    for (vtkIdType i = table.Starts[curve]; i < table.Starts[curve + 1]; ++i)
    {
      const PlacedSegment& segment = table.Segments[static_cast<std::size_t>(i)];
      stretches[static_cast<std::size_t>(segment.Index)] = { static_cast<vtkIdType>(curve),
        { segment } };
    }
  }
  return stretches;
}

}

//------------------------------------------------------------------------------
vtkVoxelLineGeometry::vtkVoxelLineGeometry() = default;

//------------------------------------------------------------------------------
vtkVoxelLineGeometry::~vtkVoxelLineGeometry() = default;

//------------------------------------------------------------------------------
int vtkVoxelLineGeometry::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkVoxelLineModel");
  return 1;
}

//------------------------------------------------------------------------------
int vtkVoxelLineGeometry::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkVoxelLineModel* model = vtkVoxelLineModel::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->SetErrorCode(vtkErrorCode::NoError);
  std::string error = model ? model->FindDefect() : std::string();
  if (error.empty())
  {
    error = vtkVoxelLineLevels::FindLevelError(model, this->Level);
  }
  vtkNew<vtkVoxelLineModel> representatives;
  if (error.empty() && model && this->Level > 0)
  {
    const auto goesOn = [this](double progress)
    {
      this->UpdateProgress(0.3 * progress);
      return !vtkLineSetsCompatibility::CheckAbort(this);
    };
    error = vtkVoxelLineRepresentatives::MakeLevel(model, this->Level, goesOn, representatives);
    model = representatives;
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::UserError);
    return 1;
  }
  if (!model || model->GetNumberOfSegments() == 0)
  {
    return 1;
  }

  const vtkVoxelLineSegments::Reader reader(model);
  const CurveTable table = SortByCurve(model, reader);
  this->UpdateProgress(0.3);
  if (vtkLineSetsCompatibility::CheckAbort(this))
  {
    return 1;
  }
  const std::vector<Stretch> stretches =
    this->Join ? JoinCurves(reader, table) : ListSegments(table);
  this->UpdateProgress(0.7);
  if (vtkLineSetsCompatibility::CheckAbort(this))
  {
    return 1;
  }

  const vtkSmartPointer<vtkIdTypeArray> offsets = WriteCells(model, stretches, output);
  const PointWriter writer(model, reader, output->GetLines()->GetNumberOfConnectivityIds(), output);
  vtkSMPTools::For(0, static_cast<vtkIdType>(stretches.size()), CurvesPerBlock,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        vtkIdType point = offsets->GetValue(i);
        const std::vector<PlacedSegment>& segments =
          stretches[static_cast<std::size_t>(i)].Segments;
        for (const PlacedSegment& segment : segments)
        {
          writer.Write(point++, segment, 0);
        }
        writer.Write(point, segments.back(), 1);
      }
    });
  return 1;
}

//------------------------------------------------------------------------------
void vtkVoxelLineGeometry::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "Join: " << (this->Join ? "On" : "Off") << "\n";
}
