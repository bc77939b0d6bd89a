// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineVoxelizer.h"

#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLineSetsCompatibilityPrivate.h"
#include "vtkLineVoxelizerInputPrivate.h"
#include "vtkLineVoxelizerTracePrivate.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkVoxelLineEncodingPrivate.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineModelBuilderPrivate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>

vtkStandardNewMacro(vtkLineVoxelizer);

namespace
{

/// Bounds above this overflow on the way to grid-local coordinates.
constexpr double LargestExtent = 1e300;

/// The smallest voxel: its inverse times the largest extent of a point in it does not overflow.
constexpr double SmallestVoxel = 1e-300;

/// Points of the curves that one task traces.
constexpr vtkIdType PointsPerBlock = 8192;

/// Rounds of tracing; progress and abort are looked at between them.
constexpr std::size_t NumberOfRounds = 16;

/// What a thread needs to trace curves.
struct Tracer
{
  Tracer(const vtkLineVoxelizerPrivate::Grid& grid, int faceBins, double interiorTolerance,
    const vtkLineVoxelizerPrivate::Payload& payload)
    : Curves(grid, faceBins, interiorTolerance, payload)
  {
  }

  vtkLineVoxelizerPrivate::CurveTracer Curves;
  std::vector<vtkLineVoxelizerPrivate::Sample> Samples;
  vtkNew<vtkIdList> Ids;
};

/// Ranges of curves with about equally many points, independent of the number of threads.
std::vector<std::size_t> PartCurves(const std::vector<vtkLineVoxelizerPrivate::Curve>& curves)
{
  std::vector<std::size_t> starts(1, 0);
  vtkIdType points = 0;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    points += curves[i].Size;
    if (points >= PointsPerBlock || i + 1 == curves.size())
    {
      starts.push_back(i + 1);
      points = 0;
    }
  }
  return starts;
}

void AddLine(std::string& text, const std::string& line)
{
  text += (text.empty() ? "" : "\n") + line;
}

}

//------------------------------------------------------------------------------
vtkLineVoxelizer::vtkLineVoxelizer()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
vtkLineVoxelizer::~vtkLineVoxelizer() = default;

//------------------------------------------------------------------------------
vtkVoxelLineModel* vtkLineVoxelizer::GetOutput()
{
  return vtkVoxelLineModel::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
int vtkLineVoxelizer::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkLineVoxelizer::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkVoxelLineModel");
  return 1;
}

//------------------------------------------------------------------------------
int vtkLineVoxelizer::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  if (!vtkVoxelLineModel::GetData(outInfo))
  {
    vtkNew<vtkVoxelLineModel> model;
    outInfo->Set(vtkDataObject::DATA_OBJECT(), model);
  }
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkLineVoxelizer::FindPropertyError() const
{
  if (this->Resolution < 1 || this->Resolution > LargestResolution)
  {
    return "Resolution is " + std::to_string(this->Resolution) + "; it must be 1 to " +
      std::to_string(LargestResolution) + ".";
  }
  if (!vtkVoxelLineEncoding::IsFaceBins(this->FaceBins))
  {
    return "FaceBins is " + std::to_string(this->FaceBins) +
      "; it must be 0 (exact) or a power of two from 2 to 2048.";
  }
  if (!(this->InteriorTolerance >= 0.0))
  {
    return "InteriorTolerance is " + std::to_string(this->InteriorTolerance) +
      "; it must be 0 or above.";
  }
  if (this->AttributeComponent < -1)
  {
    return "AttributeComponent is " + std::to_string(this->AttributeComponent) +
      "; it must be -1 (magnitude) or the number of a component.";
  }
  for (int axis = 0; this->UseCustomBounds && axis < 3; ++axis)
  {
    const double low = this->CustomBounds[2 * axis];
    const double high = this->CustomBounds[2 * axis + 1];
    if (!std::isfinite(low) || !std::isfinite(high) || low > high)
    {
      return "CustomBounds along axis " + std::to_string(axis) + " are " + std::to_string(low) +
        " to " + std::to_string(high) + "; they must be finite and ascend.";
    }
  }
  if (this->UseCustomRanges &&
    !(std::isfinite(this->CustomAttributeRange[0]) && std::isfinite(this->CustomAttributeRange[1])))
  {
    return "CustomAttributeRange is " + std::to_string(this->CustomAttributeRange[0]) + " to " +
      std::to_string(this->CustomAttributeRange[1]) + "; both values must be finite.";
  }
  if (this->UseCustomRanges &&
    !(std::isfinite(this->CustomMaximumRadius) && this->CustomMaximumRadius >= 0.0))
  {
    return "CustomMaximumRadius is " + std::to_string(this->CustomMaximumRadius) +
      "; it must be finite and 0 or above.";
  }
  return std::string();
}

//------------------------------------------------------------------------------
void vtkLineVoxelizer::ReadInput(vtkInformationVector* inputs, bool useCustomRanges,
  vtkLineVoxelizerPrivate::Input& input, std::string& warning)
{
  vtkLineVoxelizerPrivate::ValueRequest request;
  request.Component = this->AttributeComponent;
  request.DirectColors = this->DirectColors;
  request.RadiusArrayName = this->RadiusArrayName;
  if (useCustomRanges)
  {
    std::copy_n(this->CustomAttributeRange, 2, request.CustomRange);
    request.CustomRadius = this->CustomMaximumRadius;
  }
  vtkIdType otherCells = 0;
  bool isAnyArray = false;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkPolyData* lines = vtkPolyData::GetData(inputs, i);
    if (!lines)
    {
      continue;
    }
    input.AddLineSet(lines, i);
    otherCells += lines->GetNumberOfCells() - lines->GetNumberOfLines();
    int association = vtkDataObject::FIELD_ASSOCIATION_NONE;
    vtkDataArray* array =
      this->GenerateAttributes ? this->GetInputArrayToProcess(0, lines, association) : nullptr;
    isAnyArray = isAnyArray || array;
    if (array && association != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
      association != vtkDataObject::FIELD_ASSOCIATION_CELLS)
    {
      AddLine(
        warning, "The attribute array must belong to the points or the cells; it is not used.");
      array = nullptr;
    }
    request.Arrays.push_back(array);
    request.PerCell.push_back(association == vtkDataObject::FIELD_ASSOCIATION_CELLS);
    request.Radii.push_back(this->RadiusArrayName.empty()
        ? nullptr
        : lines->GetPointData()->GetArray(this->RadiusArrayName.c_str()));
  }
  vtkInformation* arrayInfo = this->GetInputArrayInformation(0);
  if (this->GenerateAttributes && !isAnyArray && input.NumberOfLines > 0 &&
    arrayInfo->Has(vtkDataObject::FIELD_NAME()))
  {
    AddLine(warning,
      std::string("No input has an array named ") + arrayInfo->Get(vtkDataObject::FIELD_NAME()) +
        " where it is asked for; the model has no attributes.");
  }
  if (input.NumberOfLines == 0)
  {
    if (otherCells > 0)
    {
      AddLine(warning,
        "The input has no lines, only " + std::to_string(otherCells) +
          " other cells; the model is empty.");
    }
    return;
  }
  // Radii are held against the bounds of the curves.
  input.FindCurves();
  std::vector<std::string> messages;
  input.ReadValues(request, messages);
  for (const std::string& message : messages)
  {
    AddLine(warning, message);
  }
}

//------------------------------------------------------------------------------
vtkLineVoxelizer::Measures vtkLineVoxelizer::MeasureInput()
{
  Measures measures;
  vtkNew<vtkInformationVector> inputs;
  for (int i = 0; i < this->GetNumberOfInputConnections(0); ++i)
  {
    this->GetInputAlgorithm(0, i)->Update();
    vtkNew<vtkInformation> info;
    info->Set(vtkDataObject::DATA_OBJECT(), this->GetInputDataObject(0, i));
    inputs->Append(info);
  }
  vtkLineVoxelizerPrivate::Input input;
  std::string warning; // the update tells it
  this->ReadInput(inputs, false, input, warning);
  if (!input.Curves.empty())
  {
    std::copy_n(input.Bounds, 6, measures.Bounds);
    measures.MaximumRadius = input.MaximumRadius;
    if (input.AttributeKind == vtkVoxelLineModel::Scalar)
    {
      std::copy_n(input.AttributeRange, 2, measures.AttributeRange);
    }
  }
  return measures;
}

//------------------------------------------------------------------------------
std::string vtkLineVoxelizer::MakeGrid(const vtkLineVoxelizerPrivate::Input& input,
  vtkLineVoxelizerPrivate::Grid& grid, std::string& warning) const
{
  double bounds[6];
  std::copy_n(this->UseCustomBounds ? this->CustomBounds : input.Bounds, 6, bounds);
  bool isEnlarged = false;
  double longest = 0.0;
  double magnitude = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    double& low = bounds[2 * axis];
    double& high = bounds[2 * axis + 1];
    isEnlarged = isEnlarged || input.Bounds[2 * axis] < low || input.Bounds[2 * axis + 1] > high;
    low = std::min(low, input.Bounds[2 * axis]);
    high = std::max(high, input.Bounds[2 * axis + 1]);
    longest = std::max(longest, high - low);
    magnitude = std::max(magnitude, std::max(std::abs(low), std::abs(high)));
  }
  if (isEnlarged)
  {
    AddLine(warning, "CustomBounds do not contain all curves; the grid is enlarged.");
  }
  if (!(longest <= LargestExtent) || !(magnitude <= LargestExtent))
  {
    return "The coordinates of the lines exceed 1e300, which the grid cannot represent.";
  }

  if (longest > 0.0)
  {
    grid.VoxelSize = std::max(longest / this->Resolution, SmallestVoxel);
  }
  else
  {
    // A single point: any size will do that changes the coordinates when added to them.
    grid.VoxelSize = std::max(1.0, std::ldexp(magnitude, -40));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double side = bounds[2 * axis + 1] - bounds[2 * axis];
    // Rounding may add to a whole number of voxels, which is not worth a voxel more.
    const double voxels = std::ceil(side / grid.VoxelSize - 1e-9);
    grid.Dimensions[axis] =
      static_cast<int>(std::min(std::max(voxels, 1.0), static_cast<double>(this->Resolution)));
    grid.BrickDimensions[axis] =
      (grid.Dimensions[axis] + vtkVoxelLineModel::BrickSize - 1) / vtkVoxelLineModel::BrickSize;
    // The data is in the middle of the grid, so that a plane does not lie on the faces of voxels.
    grid.Origin[axis] = bounds[2 * axis] + 0.5 * (side - grid.Dimensions[axis] * grid.VoxelSize);
  }
  return std::string();
}

//------------------------------------------------------------------------------
std::string vtkLineVoxelizer::BuildModel(const vtkLineVoxelizerPrivate::Input& input,
  const vtkLineVoxelizerPrivate::Grid& grid, vtkVoxelLineModel* model)
{
  const std::vector<std::size_t> starts = PartCurves(input.Curves);
  const std::size_t numberOfBlocks = starts.size() - 1;
  std::vector<vtkLineVoxelizerPrivate::Trace> blocks(numberOfBlocks);
  vtkSMPThreadLocal<std::shared_ptr<Tracer>> tracers;
  std::size_t numberOfSegments = 0;
  for (std::size_t round = 0; round < NumberOfRounds; ++round)
  {
    const std::size_t first = round * numberOfBlocks / NumberOfRounds;
    const std::size_t last = (round + 1) * numberOfBlocks / NumberOfRounds;
    vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::shared_ptr<Tracer>& local = tracers.Local();
        if (!local)
        {
          local =
            std::make_shared<Tracer>(grid, this->FaceBins, this->InteriorTolerance, input.Values);
        }
        Tracer& tracer = *local;
        for (std::size_t block = static_cast<std::size_t>(begin);
             block < static_cast<std::size_t>(end); ++block)
        {
          for (std::size_t curve = starts[block]; curve < starts[block + 1]; ++curve)
          {
            input.GetSamples(input.Curves[curve], grid, tracer.Ids, tracer.Samples);
            tracer.Curves.AddCurve(tracer.Samples, blocks[block]);
          }
        }
      });
    for (std::size_t block = first; block < last; ++block)
    {
      numberOfSegments += blocks[block].Cells.size();
    }
    // One start per voxel and one more per brick are counted in 32 bits too.
    if (numberOfSegments > std::numeric_limits<std::uint32_t>::max() / 2)
    {
      return "The model would have more than 2^31 segments; reduce Resolution or the lines.";
    }
    this->UpdateProgress(0.1 + 0.4 * static_cast<double>(round + 1) / NumberOfRounds);
    if (vtkLineSetsCompatibility::CheckAbort(this))
    {
      return std::string();
    }
  }

  vtkIdType collapsed = 0;
  double deviation2 = 0.0;
  for (const vtkLineVoxelizerPrivate::Trace& block : blocks)
  {
    collapsed += block.NumberOfCollapsed;
    deviation2 = std::max(deviation2, block.LargestDeviation2);
  }
  model->SetNumberOfCollapsedSegments(collapsed);
  model->SetLargestDeviation(std::sqrt(deviation2) * grid.VoxelSize);

  vtkLineVoxelizerPrivate::ModelBuilder builder(grid, this->FaceBins, input.Values);
  builder.TakeSegments(blocks);
  builder.SortIntoBricks();
  this->UpdateProgress(0.7);
  if (vtkLineSetsCompatibility::CheckAbort(this))
  {
    return std::string();
  }
  builder.AssembleBricks(model);
  this->UpdateProgress(0.9);
  if (!vtkLineSetsCompatibility::CheckAbort(this))
  {
    builder.MakeBrickGrid(model);
  }
  return std::string();
}

//------------------------------------------------------------------------------
std::string vtkLineVoxelizer::Execute(
  vtkInformationVector* inputs, vtkVoxelLineModel* model, std::string& warning)
{
  std::string error = this->FindPropertyError();
  if (!error.empty())
  {
    return error;
  }
  vtkLineVoxelizerPrivate::Input input;
  this->ReadInput(inputs, this->UseCustomRanges, input, warning);
  const std::string dropped = input.DescribeDropped();
  if (!dropped.empty())
  {
    AddLine(warning, dropped);
  }
  this->UpdateProgress(0.1);
  if (vtkLineSetsCompatibility::CheckAbort(this))
  {
    return std::string();
  }

  vtkLineVoxelizerPrivate::Grid grid;
  if (!input.Curves.empty())
  {
    error = this->MakeGrid(input, grid, warning);
    if (!error.empty())
    {
      return error;
    }
    error = this->BuildModel(input, grid, model);
    model->SetDimensions(grid.Dimensions);
    model->SetOrigin(grid.Origin);
    model->SetVoxelSize(grid.VoxelSize);
    model->SetBounds(input.Bounds);
  }
  model->SetFaceBins(this->FaceBins);
  model->SetAttributeKind(input.AttributeKind);
  model->SetAttributeRange(input.AttributeRange);
  model->SetHasNaNAttribute(input.HasNaN);
  model->SetMaximumRadius(input.MaximumRadius);
  model->SetNumberOfDroppedPoints(input.NumberOfNonFinitePoints + input.NumberOfInvalidIds);
  vtkNew<vtkIdTypeArray> cells;
  cells->SetNumberOfComponents(2);
  cells->SetNumberOfTuples(static_cast<vtkIdType>(input.Curves.size()));
  for (std::size_t i = 0; i < input.Curves.size(); ++i)
  {
    input.GetCell(input.Curves[i], cells->GetPointer(2 * static_cast<vtkIdType>(i)));
  }
  model->SetCurveCells(cells);
  for (int reason = 0; reason < vtkVoxelLineModel::NumberOfDropReasons; ++reason)
  {
    model->SetNumberOfDroppedCurves(reason, input.NumberOfDroppedCurves[reason]);
  }
  return error;
}

//------------------------------------------------------------------------------
int vtkLineVoxelizer::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkVoxelLineModel* model = vtkVoxelLineModel::GetData(outputVector);
  model->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);

  std::string warning;
  std::string error;
  try
  {
    error = this->Execute(inputVector[0], model, warning);
  }
  catch (const std::bad_alloc&)
  {
    error = "There is not enough memory for the model; reduce Resolution or the lines.";
  }
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::UserError);
  }
  if (!error.empty() || vtkLineSetsCompatibility::CheckAbort(this))
  {
    model->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkLineVoxelizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "FaceBins: " << this->FaceBins << "\n";
  os << indent << "InteriorTolerance: " << this->InteriorTolerance << "\n";
  os << indent << "GenerateAttributes: " << (this->GenerateAttributes ? "On" : "Off") << "\n";
  os << indent << "AttributeComponent: " << this->AttributeComponent << "\n";
  os << indent << "DirectColors: " << (this->DirectColors ? "On" : "Off") << "\n";
  os << indent
     << "RadiusArrayName: " << (this->RadiusArrayName.empty() ? "(none)" : this->RadiusArrayName)
     << "\n";
  os << indent << "UseCustomBounds: " << (this->UseCustomBounds ? "On" : "Off") << "\n";
  os << indent << "CustomBounds:";
  for (double bound : this->CustomBounds)
  {
    os << " " << bound;
  }
  os << "\n";
  os << indent << "UseCustomRanges: " << (this->UseCustomRanges ? "On" : "Off") << "\n";
  os << indent << "CustomAttributeRange: " << this->CustomAttributeRange[0] << " "
     << this->CustomAttributeRange[1] << "\n";
  os << indent << "CustomMaximumRadius: " << this->CustomMaximumRadius << "\n";
}
