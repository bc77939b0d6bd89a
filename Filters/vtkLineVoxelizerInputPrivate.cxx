// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineVoxelizerInputPrivate.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace vtkLineVoxelizerPrivate
{

namespace
{

/// Lines that one task reads: enough to outweigh its cost, few enough to share the work.
constexpr vtkIdType LinesPerBlock = 512;

/// Largest radius, in units of the longest side of the lines' bounds: a tube of it holds all lines
/// and the camera. Rounding is not to lift it above the mapper's own limit of 4.
constexpr double LargestRadius = 4.0 * (1.0 - 1e-9);

/// What one task finds in its lines; joined in the order of the blocks.
struct Findings
{
  std::vector<Curve> Curves;
  double Low[3];
  double High[3];
  vtkIdType Dropped[vtkVoxelLineModel::NumberOfDropReasons] = { 0, 0, 0 };
  vtkIdType NonFinitePoints = 0;
  vtkIdType InvalidIds = 0;

  Findings()
  {
    std::fill_n(this->Low, 3, std::numeric_limits<double>::infinity());
    std::fill_n(this->High, 3, -std::numeric_limits<double>::infinity());
  }

  void AddPoint(const double point[3])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], point[axis]);
      this->High[axis] = std::max(this->High[axis], point[axis]);
    }
  }
};

/// Read a point of a line. Returns why it cannot be used, or -1.
int ReadPoint(const LineSet& set, vtkIdType id, double point[3], Findings& found)
{
  if (id < 0 || id >= set.Points.GetNumberOfPoints())
  {
    ++found.InvalidIds;
    return vtkVoxelLineModel::InvalidPointIds;
  }
  set.Points.Get(id, point);
  if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
  {
    ++found.NonFinitePoints;
    return vtkVoxelLineModel::NonFinitePoints;
  }
  return -1;
}

/// Part one line into stretches of points that exist and are finite.
void FindCurvesOfLine(
  const LineSet& set, int input, vtkIdType line, vtkIdList* ids, Findings& found)
{
  set.Lines->GetCellAtId(line, ids);
  const vtkIdType size = ids->GetNumberOfIds();
  // A stretch that is too short is put down to the last point that could not be used.
  int reason = vtkVoxelLineModel::TooFewPoints;
  bool isAnyStretch = false;
  vtkIdType first = 0;
  double previous[3] = { 0.0, 0.0, 0.0 };
  for (vtkIdType i = 0; i <= size; ++i)
  {
    double point[3] = { 0.0, 0.0, 0.0 };
    const int fault = i < size ? ReadPoint(set, ids->GetId(i), point, found) : reason;
    if (fault < 0)
    {
      // The first point of a stretch counts only once it is known to have a second one.
      if (i == first + 1)
      {
        found.AddPoint(previous);
      }
      if (i > first)
      {
        found.AddPoint(point);
      }
      std::copy_n(point, 3, previous);
      continue;
    }
    reason = fault;
    isAnyStretch = isAnyStretch || i > first;
    if (i - first >= 2)
    {
      found.Curves.push_back({ input, line, first, i - first });
    }
    else if (i - first == 1)
    {
      ++found.Dropped[reason];
    }
    first = i + 1;
  }
  if (!isAnyStretch)
  {
    ++found.Dropped[reason];
  }
}

/// Doubles of one component, or of the magnitude (-1), of the tuples [first, last).
void ReadTuples(vtkDataArray* array, int component, vtkIdType first, vtkIdType last, double* values)
{
  const int size = array->GetNumberOfComponents();
  if (component >= 0 || size == 1)
  {
    for (vtkIdType i = first; i < last; ++i)
    {
      *values++ = array->GetComponent(i, std::max(component, 0));
    }
    return;
  }
  std::vector<double> tuple(static_cast<std::size_t>(size));
  for (vtkIdType i = first; i < last; ++i)
  {
    array->GetTuple(i, tuple.data());
    double sum = 0.0;
    for (double value : tuple)
    {
      sum += value * value;
    }
    *values++ = std::sqrt(sum);
  }
}

/// All tuples; those that are not finite become NaN.
std::vector<double> ReadArray(vtkDataArray* array, int component)
{
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  vtkSMPTools::For(0, array->GetNumberOfTuples(), 16384,
    [&](vtkIdType first, vtkIdType last)
    {
      ReadTuples(array, component, first, last, values.data() + first);
      for (vtkIdType i = first; i < last; ++i)
      {
        double& value = values[static_cast<std::size_t>(i)];
        value = std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
      }
    });
  return values;
}

/// Where a value lies in a range, as a fraction that does not overflow; 0 where the range is a
/// point.
float FractionOf(double value, double low, double high)
{
  const double span = 0.5 * high - 0.5 * low;
  const double fraction = span > 0.0 ? (0.5 * value - 0.5 * low) / span : 0.0 * value;
  return static_cast<float>(
    std::isnan(fraction) ? fraction : std::min(std::max(fraction, 0.0), 1.0));
}

/// Red, green, blue and opacity of a colour tuple of 1 to 4 components, as vtkScalarsToColors reads
/// it.
void GetColor(vtkUnsignedCharArray* colors, vtkIdType i, float rgba[4])
{
  const int size = colors->GetNumberOfComponents();
  const unsigned char* color = colors->GetPointer(i * size);
  rgba[0] = color[0] / 255.0f;
  rgba[1] = color[size > 2 ? 1 : 0] / 255.0f;
  rgba[2] = color[size > 2 ? 2 : 0] / 255.0f;
  rgba[3] = size % 2 == 0 ? color[size - 1] / 255.0f : 1.0f;
}

}

//------------------------------------------------------------------------------
void PointReader::SetPoints(vtkDataArray* points)
{
  if (!points || points->GetNumberOfComponents() != 3)
  {
    return;
  }
  this->Array = points;
  this->NumberOfPoints = points->GetNumberOfTuples();
  if (vtkFloatArray* floats = vtkFloatArray::FastDownCast(points))
  {
    this->Floats = floats->GetPointer(0);
  }
  else if (vtkDoubleArray* doubles = vtkDoubleArray::FastDownCast(points))
  {
    this->Doubles = doubles->GetPointer(0);
  }
}

//------------------------------------------------------------------------------
void PointReader::Get(vtkIdType id, double point[3]) const
{
  if (this->Floats)
  {
    std::copy_n(this->Floats + 3 * id, 3, point);
  }
  else if (this->Doubles)
  {
    std::copy_n(this->Doubles + 3 * id, 3, point);
  }
  else
  {
    this->Array->GetTuple(id, point);
  }
}

//------------------------------------------------------------------------------
void Input::AddLineSet(vtkPolyData* lines, int connection)
{
  LineSet set;
  set.Connection = connection;
  set.Points.SetPoints(lines->GetPoints() ? lines->GetPoints()->GetData() : nullptr);
  set.Lines = lines->GetLines();
  set.FirstCell = lines->GetNumberOfVerts();
  set.NumberOfCells = lines->GetNumberOfCells();
  set.NumberOfLines = lines->GetNumberOfLines();
  this->NumberOfLines += set.NumberOfLines;
  this->LineSets.push_back(std::move(set));
}

//------------------------------------------------------------------------------
void Input::FindCurves()
{
  vtkSMPThreadLocalObject<vtkIdList> localIds;
  bool isFirst = true;
  for (std::size_t input = 0; input < this->LineSets.size(); ++input)
  {
    const LineSet& set = this->LineSets[input];
    const vtkIdType numberOfBlocks = (set.NumberOfLines + LinesPerBlock - 1) / LinesPerBlock;
    std::vector<Findings> blocks(static_cast<std::size_t>(numberOfBlocks));
    vtkSMPTools::For(0, numberOfBlocks, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType block = begin; block < end; ++block)
        {
          const vtkIdType last = std::min((block + 1) * LinesPerBlock, set.NumberOfLines);
          for (vtkIdType line = block * LinesPerBlock; line < last; ++line)
          {
            FindCurvesOfLine(set, static_cast<int>(input), line, localIds.Local(),
              blocks[static_cast<std::size_t>(block)]);
          }
        }
      });
    for (const Findings& found : blocks)
    {
      this->Curves.insert(this->Curves.end(), found.Curves.begin(), found.Curves.end());
      for (int reason = 0; reason < vtkVoxelLineModel::NumberOfDropReasons; ++reason)
      {
        this->NumberOfDroppedCurves[reason] += found.Dropped[reason];
      }
      this->NumberOfNonFinitePoints += found.NonFinitePoints;
      this->NumberOfInvalidIds += found.InvalidIds;
      if (found.Curves.empty())
      {
        continue;
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        double* bounds = this->Bounds + 2 * axis;
        bounds[0] = isFirst ? found.Low[axis] : std::min(bounds[0], found.Low[axis]);
        bounds[1] = isFirst ? found.High[axis] : std::max(bounds[1], found.High[axis]);
      }
      isFirst = false;
    }
  }
}

//------------------------------------------------------------------------------
void Input::GetCell(const Curve& curve, vtkIdType connectionAndCell[2]) const
{
  const LineSet& set = this->LineSets[static_cast<std::size_t>(curve.Input)];
  connectionAndCell[0] = set.Connection;
  connectionAndCell[1] = set.FirstCell + curve.Line;
}

//------------------------------------------------------------------------------
std::string Input::DescribeDropped() const
{
  const vtkIdType* dropped = this->NumberOfDroppedCurves;
  std::string text;
  const auto add = [&text](vtkIdType number, const char* what)
  {
    if (number > 0)
    {
      text += (text.empty() ? "Left out: " : ", ") + std::to_string(number) + " " + what;
    }
  };
  add(this->NumberOfNonFinitePoints, "points that are not finite");
  add(this->NumberOfInvalidIds, "point ids that do not exist");
  add(dropped[vtkVoxelLineModel::TooFewPoints], "lines of fewer than two points");
  add(dropped[vtkVoxelLineModel::NonFinitePoints],
    "lines or pieces of them with fewer than two finite points in a row");
  add(dropped[vtkVoxelLineModel::InvalidPointIds],
    "lines or pieces of them with fewer than two valid point ids in a row");
  return text.empty()
    ? text
    : text + ". A line needs at least two points in a row that exist and are finite.";
}

//------------------------------------------------------------------------------
bool Input::ChooseArray(
  std::size_t i, const ValueRequest& request, std::vector<std::string>& messages)
{
  LineSet& set = this->LineSets[i];
  vtkDataArray* array = request.Arrays[i];
  if (set.NumberOfLines == 0 || !array)
  {
    return set.NumberOfLines == 0;
  }
  const std::string name =
    std::string("Array ") + (array->GetName() ? array->GetName() : "(unnamed)");
  const vtkIdType size = array->GetNumberOfTuples();
  set.ValuesPerCell = request.PerCell[i];
  const vtkIdType expected = set.ValuesPerCell ? set.NumberOfCells : set.Points.GetNumberOfPoints();
  if (size != expected)
  {
    messages.push_back(name + " has " + std::to_string(size) + " tuples where there are " +
      std::to_string(expected) + (set.ValuesPerCell ? " cells" : " points") + "; it is not used.");
    return false;
  }
  const int components = array->GetNumberOfComponents();
  vtkUnsignedCharArray* colors =
    request.DirectColors && components <= 4 ? vtkUnsignedCharArray::SafeDownCast(array) : nullptr;
  const int kind = colors ? vtkVoxelLineModel::Color : vtkVoxelLineModel::Scalar;
  if (this->AttributeKind != kind && this->AttributeKind != vtkVoxelLineModel::NoAttribute)
  {
    messages.push_back(name + " of input " + std::to_string(set.Connection) +
      (colors ? " holds colours, those before it scalars; it is not used."
              : " holds scalars, those before it colours; it is not used."));
    return false;
  }
  this->AttributeKind = kind;
  set.Colors = colors;
  if (!colors)
  {
    set.Scalars.resize(static_cast<std::size_t>(expected));
    if (request.Component >= components)
    {
      messages.push_back(name + " has " + std::to_string(components) +
        " components, and AttributeComponent is " + std::to_string(request.Component) +
        "; the last one is used.");
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void Input::ReadValues(const ValueRequest& request, std::vector<std::string>& messages)
{
  int missing = 0;
  for (std::size_t i = 0; i < this->LineSets.size(); ++i)
  {
    missing += this->ChooseArray(i, request, messages) ? 0 : 1;
  }
  if (this->AttributeKind != vtkVoxelLineModel::NoAttribute)
  {
    const bool isColor = this->AttributeKind == vtkVoxelLineModel::Color;
    this->Values.AttributeSize = isColor ? 4 : 1;
    if (missing > 0)
    {
      messages.push_back(std::to_string(missing) + " of " + std::to_string(this->LineSets.size()) +
        " inputs have no values to colour by; their lines are " +
        (isColor ? "white." : "coloured as NaN."));
    }
    if (!isColor)
    {
      this->HasNaN = missing > 0;
      this->ReadScalars(request, messages);
    }
  }
  this->Values.LargestByte = this->HasNaN ? 254 : 255;
  this->ReadRadii(request, messages);
}

//------------------------------------------------------------------------------
void Input::ReadScalars(const ValueRequest& request, std::vector<std::string>& messages)
{
  std::vector<std::vector<double>> values(this->LineSets.size());
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < this->LineSets.size(); ++i)
  {
    if (this->LineSets[i].Scalars.empty())
    {
      continue;
    }
    const int last = request.Arrays[i]->GetNumberOfComponents() - 1;
    values[i] = ReadArray(request.Arrays[i], std::min(request.Component, last));
    for (double value : values[i])
    {
      // Comparisons with NaN are false, so that it changes neither.
      low = value < low ? value : low;
      high = value > high ? value : high;
      this->HasNaN = this->HasNaN || std::isnan(value);
    }
  }
  if (request.CustomRange[0] <= request.CustomRange[1])
  {
    low = request.CustomRange[0];
    high = request.CustomRange[1];
    vtkIdType outside = 0;
    for (const std::vector<double>& some : values)
    {
      outside += std::count_if(
        some.begin(), some.end(), [low, high](double v) { return v < low || v > high; });
    }
    if (outside > 0)
    {
      messages.push_back(std::to_string(outside) +
        " scalars are outside of CustomAttributeRange and taken as its nearer end.");
    }
  }
  else if (low > high)
  {
    low = 0.0;
    high = 1.0;
  }
  this->AttributeRange[0] = low;
  this->AttributeRange[1] = high;
  for (std::size_t i = 0; i < this->LineSets.size(); ++i)
  {
    std::vector<float>& scalars = this->LineSets[i].Scalars;
    vtkSMPTools::For(0, static_cast<vtkIdType>(scalars.size()), 16384,
      [&](vtkIdType first, vtkIdType end)
      {
        for (std::size_t j = static_cast<std::size_t>(first); j < static_cast<std::size_t>(end);
             ++j)
        {
          scalars[j] = FractionOf(values[i][j], low, high);
        }
      });
  }
}

//------------------------------------------------------------------------------
void Input::ReadRadii(const ValueRequest& request, std::vector<std::string>& messages)
{
  if (request.RadiusArrayName.empty())
  {
    return;
  }
  std::vector<std::vector<double>> values(this->LineSets.size());
  for (std::size_t i = 0; i < this->LineSets.size(); ++i)
  {
    if (this->LineSets[i].NumberOfLines == 0)
    {
      continue;
    }
    const vtkIdType expected = this->LineSets[i].Points.GetNumberOfPoints();
    vtkDataArray* array = request.Radii[i];
    const vtkIdType size = array ? array->GetNumberOfTuples() : 0;
    if (size != expected)
    {
      messages.push_back("Radius array " + request.RadiusArrayName +
        (array ? " has " + std::to_string(size) + " tuples where there are " +
              std::to_string(expected) + " points"
               : " is not among the point data of input " + std::to_string(i)) +
        "; all lines have the mapper's radius.");
      this->MaximumRadius = 0.0;
      return;
    }
    if (!array)
    {
      continue; // an input without points
    }
    values[i] = ReadArray(array, 0);
    for (double& value : values[i])
    {
      if (!(value >= 0.0))
      {
        value = 0.0;
        ++this->NumberOfInvalidRadii;
      }
    }
  }
  if (this->NumberOfInvalidRadii > 0)
  {
    messages.push_back(std::to_string(this->NumberOfInvalidRadii) + " radii of array " +
      request.RadiusArrayName + " are negative or not finite and taken as 0.");
  }
  this->LimitRadii(values, request, messages);
  if (!(this->MaximumRadius > 0.0))
  {
    messages.push_back("No radius of array " + request.RadiusArrayName +
      " is above 0; all lines have the mapper's radius.");
    return;
  }
  this->Values.HasRadii = true;
  for (std::size_t i = 0; i < this->LineSets.size(); ++i)
  {
    std::vector<float>& radii = this->LineSets[i].Radii;
    radii.resize(values[i].size());
    for (std::size_t j = 0; j < radii.size(); ++j)
    {
      radii[j] = static_cast<float>(values[i][j] / this->MaximumRadius);
    }
  }
}

//------------------------------------------------------------------------------
void Input::LimitRadii(std::vector<std::vector<double>>& radii, const ValueRequest& request,
  std::vector<std::string>& messages)
{
  const std::string& name = request.RadiusArrayName;
  double side = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    side = std::max(side, this->Bounds[2 * axis + 1] - this->Bounds[2 * axis]);
  }
  // A single point has no size that a radius could be held against.
  const bool isCustom = request.CustomRadius > 0.0;
  const double largest = isCustom ? request.CustomRadius
    : side > 0.0                  ? LargestRadius * side
                                  : std::numeric_limits<double>::max();
  vtkIdType clamped = 0;
  for (std::vector<double>& values : radii)
  {
    for (double& value : values)
    {
      clamped += value > largest ? 1 : 0;
      value = std::min(value, largest);
      this->MaximumRadius = std::max(this->MaximumRadius, value);
    }
  }
  this->MaximumRadius = isCustom ? largest : this->MaximumRadius;
  // Half a step of the bytes rounds up.
  const double smallest = 0.5 / 255.0 * this->MaximumRadius;
  vtkIdType vanishing = 0;
  for (const std::vector<double>& values : radii)
  {
    vanishing += std::count_if(values.begin(), values.end(),
      [smallest](double value) { return value > 0.0 && value < smallest; });
  }
  const auto add = [&](vtkIdType number, const char* what, double limit, const char* remedy)
  {
    if (number > 0)
    {
      std::ostringstream text;
      text << number << " radii of array " << name << what << limit << remedy;
      messages.push_back(text.str());
    }
  };
  add(clamped,
    isCustom ? " are above CustomMaximumRadius and taken as "
             : " are more than 4 times the size of all lines and taken as ",
    largest, "; correct these radii.");
  add(vanishing, " are above 0 but less than 1/510 of the largest one, ", this->MaximumRadius,
    ", and become 0 in 8 bits; where they are to be seen, reduce the largest radii.");
}

//------------------------------------------------------------------------------
void Input::GetSamples(
  const Curve& curve, const Grid& grid, vtkIdList* ids, std::vector<Sample>& samples) const
{
  const LineSet& set = this->LineSets[static_cast<std::size_t>(curve.Input)];
  set.Lines->GetCellAtId(curve.Line, ids);
  const vtkIdType* id = ids->GetPointer(curve.First);
  const vtkIdType cell = set.FirstCell + curve.Line;
  const float none = this->AttributeKind == vtkVoxelLineModel::Color
    ? 1.0f
    : std::numeric_limits<float>::quiet_NaN();
  samples.resize(static_cast<std::size_t>(curve.Size));
  for (Sample& sample : samples)
  {
    double point[3];
    set.Points.Get(*id, point);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double local = (point[axis] - grid.Origin[axis]) / grid.VoxelSize;
      sample.Point[axis] =
        std::min(std::max(local, 0.0), static_cast<double>(grid.Dimensions[axis]));
    }
    std::fill_n(sample.Attribute, 4, none);
    const vtkIdType index = set.ValuesPerCell ? cell : *id;
    if (!set.Scalars.empty())
    {
      sample.Attribute[0] = set.Scalars[static_cast<std::size_t>(index)];
    }
    else if (set.Colors)
    {
      GetColor(set.Colors, index, sample.Attribute);
    }
    sample.Radius = set.Radii.empty() ? 0.0f : set.Radii[static_cast<std::size_t>(*id)];
    ++id;
  }
}

}
