// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineDensityFilter.h"

#include "vtkCellArray.h"
#include "vtkCommunicator.h"
#include "vtkErrorCode.h"
#include "vtkExtentTranslator.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLineVoxelizer.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVoxelLineDensity.h"
#include "vtkVoxelLineModel.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkLineDensityFilter);

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr int NoExtent[6] = { 0, -1, 0, -1, 0, -1 };
constexpr int BrickSize = vtkVoxelLineModel::BrickSize;
/// Values that are reduced at a time: MPI counts in 31 bits, and needs memory of its own.
constexpr vtkIdType ValuesPerReduction = vtkIdType(1) << 24;
constexpr double BytesPerGiB = 1024.0 * 1024.0 * 1024.0;

//------------------------------------------------------------------------------
/// What was asked for, or all where nothing was.
void GetPiece(vtkInformation* outInfo, int& piece, int& numberOfPieces)
{
  piece = 0;
  numberOfPieces = 1;
  if (outInfo->Has(Pipeline::UPDATE_PIECE_NUMBER()) &&
    outInfo->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    piece = outInfo->Get(Pipeline::UPDATE_PIECE_NUMBER());
    numberOfPieces = outInfo->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
  }
}

//------------------------------------------------------------------------------
/// Leave only a piece of the image.
void CropToPiece(vtkImageData* image, vtkInformation* outInfo)
{
  int piece = 0;
  int numberOfPieces = 1;
  GetPiece(outInfo, piece, numberOfPieces);
  if (numberOfPieces <= 1 || image->GetNumberOfPoints() == 0)
  {
    return;
  }
  const int ghosts = outInfo->Has(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())
    ? outInfo->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())
    : 0;
  int whole[6];
  image->GetExtent(whole);
  int extent[6];
  vtkNew<vtkExtentTranslator> translator;
  if (translator->PieceToExtentThreadSafe(
        piece, numberOfPieces, ghosts, whole, extent, vtkExtentTranslator::BLOCK_MODE, 0))
  {
    image->Crop(extent);
    if (ghosts > 0)
    {
      int zeroExtent[6];
      translator->PieceToExtentThreadSafe(
        piece, numberOfPieces, 0, whole, zeroExtent, vtkExtentTranslator::BLOCK_MODE, 0);
      image->GenerateGhostArray(zeroExtent);
    }
  }
  else
  {
    image->Initialize();
  }
}

//------------------------------------------------------------------------------
/// Bytes in words.
std::string DescribeBytes(double bytes)
{
  std::ostringstream text;
  text.precision(3);
  text << bytes / BytesPerGiB << " GiB";
  return text.str();
}

//------------------------------------------------------------------------------
/// The sum of all ranks, in place of what this one has.
void SumOverRanks(vtkMultiProcessController* controller, vtkFloatArray* values)
{
  vtkNew<vtkFloatArray> sums;
  sums->SetNumberOfValues(std::min(values->GetNumberOfValues(), ValuesPerReduction));
  for (vtkIdType first = 0; first < values->GetNumberOfValues(); first += ValuesPerReduction)
  {
    const vtkIdType count = std::min(values->GetNumberOfValues() - first, ValuesPerReduction);
    float* mine = values->GetPointer(first);
    controller->AllReduce(mine, sums->GetPointer(0), count, vtkCommunicator::SUM_OP);
    std::copy_n(sums->GetPointer(0), count, mine);
  }
}

//------------------------------------------------------------------------------
/// Numbers of values that are stored on the way to the densities of a level of a grid.
struct Sizes
{
  /// Points of the image along each axis.
  double Dimensions[3];
  double Image = 1.0;
  double All = 0.0;

  /// The grid has as many voxels along the longest side of the bounds as the resolution tells, and
  /// about as many as they need along the others.
  Sizes(const double bounds[6], int resolution, int level)
  {
    double sides[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      sides[axis] = bounds[2 * axis + 1] - bounds[2 * axis];
    }
    const double longest = *std::max_element(sides, sides + 3);
    const auto sizeOf = [&](int axis, double edge)
    {
      const double part = longest > 0.0 ? sides[axis] / longest : 0.0;
      const double voxels = std::max(1.0, std::ceil(part * resolution - 1e-9));
      return std::ceil(voxels / edge);
    };
    const auto count = [&](double edge)
    { return sizeOf(0, edge) * sizeOf(1, edge) * sizeOf(2, edge); };
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Dimensions[axis] = sizeOf(axis, std::ldexp(1.0, level));
      this->Image *= this->Dimensions[axis];
    }
    // The grid of bricks, and the densities of the levels from 1 on, which are computed together.
    this->All = count(BrickSize);
    for (int edge = 2; edge < 2 * resolution; edge *= 2)
    {
      this->All += count(edge);
    }
    this->All += level == 0 ? this->Image : 0.0;
  }
};
}

//------------------------------------------------------------------------------
vtkLineDensityFilter::vtkLineDensityFilter() = default;

//------------------------------------------------------------------------------
vtkLineDensityFilter::~vtkLineDensityFilter() = default;

//------------------------------------------------------------------------------
int vtkLineDensityFilter::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkLineDensityFilter::FindSizeError(const double bounds[6])
{
  const Sizes sizes(bounds, this->Resolution, this->Level);
  const double bytes = sizes.All * sizeof(float);
  vtksys::SystemInformation system;
  // In KiB; not known on every system.
  double memory = 1024.0 * static_cast<double>(system.GetHostMemoryTotal());
  if (this->Controller && this->Controller->GetNumberOfProcesses() > 1)
  {
    // All ranks go on, or none.
    const double mine = memory;
    this->Controller->AllReduce(&mine, &memory, 1, vtkCommunicator::MIN_OP);
  }
  const bool isCountable = sizes.All < static_cast<double>(VTK_ID_MAX);
  if (isCountable && (memory <= 0.0 || bytes <= memory))
  {
    return std::string();
  }
  std::ostringstream text;
  text.precision(12);
  text << "The image would have " << sizes.Dimensions[0] << " x " << sizes.Dimensions[1] << " x "
       << sizes.Dimensions[2] << " points (" << DescribeBytes(sizes.Image * sizeof(float))
       << "), and " << DescribeBytes(bytes) << " are needed to compute it, ";
  if (isCountable)
  {
    text << "where " << DescribeBytes(memory) << " of memory are in the machine.";
  }
  else
  {
    text << "more values than vtkIdType can count.";
  }
  text << " Choose a lower Resolution" << (this->Level == 0 ? " or a higher Level." : ".");
  return text.str();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkLineDensityFilter::PlaceImage(const double bounds[6])
{
  // The grid depends on the bounds alone: a line between two corners has them.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(bounds[0], bounds[2], bounds[4]);
  points->InsertNextPoint(bounds[1], bounds[3], bounds[5]);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  vtkNew<vtkPolyData> diagonal;
  diagonal->SetPoints(points);
  diagonal->SetLines(lines);
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputDataObject(diagonal);
  voxelizer->SetResolution(this->Resolution);
  vtkNew<vtkVoxelLineDensity> density;
  density->SetInputConnection(voxelizer->GetOutputPort());
  density->SetLevel(this->Level);
  density->UpdateInformation();

  vtkInformation* info = density->GetOutputInformation(0);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(info->Get(Pipeline::WHOLE_EXTENT()));
  image->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  image->SetSpacing(info->Get(vtkDataObject::SPACING()));
  return image;
}

//------------------------------------------------------------------------------
int vtkLineDensityFilter::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  int port = 0;
  vtkAlgorithm* producer = this->GetInputAlgorithm(0, 0, port);
  if (producer && inInfo)
  {
    // As the update that follows asks for it, so that the input is made once. The time stays that
    // of the last update.
    const bool isParallel = this->Controller && this->Controller->GetNumberOfProcesses() > 1;
    inInfo->Set(
      Pipeline::UPDATE_PIECE_NUMBER(), isParallel ? this->Controller->GetLocalProcessId() : 0);
    inInfo->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(),
      isParallel ? this->Controller->GetNumberOfProcesses() : 1);
    inInfo->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    producer->Update(port);
  }
  int numberOfOthers = 0;
  double bounds[6];
  vtkSmartPointer<vtkImageData> image;
  if (this->FindBounds(
        FindBlocks(vtkDataObject::GetData(inputVector[0]), numberOfOthers), bounds) &&
    this->FindSizeError(bounds).empty()) // which the update tells
  {
    image = this->PlaceImage(bounds);
  }
  outInfo->Set(Pipeline::WHOLE_EXTENT(), image ? image->GetExtent() : NoExtent, 6);
  if (image)
  {
    outInfo->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
    outInfo->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
  }
  vtkDataObject::SetPointDataActiveScalarInfo(outInfo, VTK_FLOAT, 1);
  // Pieces are cut here: the whole extent may have changed with the time.
  outInfo->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkLineDensityFilter::SumLines(
  const std::vector<Block>& blocks, const double bounds[6], vtkImageData* image)
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  this->SetUpVoxelizer(voxelizer, bounds);
  // Opacities are numbers here, whatever type they have.
  voxelizer->SetDirectColors(false);
  for (const Block& block : blocks)
  {
    voxelizer->AddInputDataObject(block.Lines);
  }
  if (!this->RunInside(voxelizer, 0.0, 0.6))
  {
    return false;
  }
  vtkNew<vtkVoxelLineDensity> density;
  density->SetInputConnection(voxelizer->GetOutputPort());
  density->SetLevel(this->Level);
  density->SetOpacity(this->Opacity);
  if (voxelizer->GetOutput()->GetAttributeKind() == vtkVoxelLineModel::Scalar)
  {
    // The identity over the range of the array.
    const double* range = voxelizer->GetOutput()->GetAttributeRange();
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(range[0], range[0]);
    opacity->AddPoint(range[1], range[1]);
    density->SetOpacityFunction(opacity);
    density->SetNaNOpacity(0.0);
  }
  if (!this->RunInside(density, 0.6, 0.9))
  {
    return false;
  }
  vtkImageData* result = density->GetOutput();
  if (result->GetNumberOfPoints() > 0)
  {
    image->GetPointData()->SetScalars(result->GetPointData()->GetScalars());
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkLineDensityFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  int numberOfOthers = 0;
  const std::vector<Block> blocks =
    FindBlocks(vtkDataObject::GetData(inputVector[0]), numberOfOthers);
  this->TellOthers(numberOfOthers);
  double bounds[6];
  if (!this->FindBounds(blocks, bounds))
  {
    // No rank has lines. Whether there is something else in their place, the voxelizer tells.
    std::fill(bounds, bounds + 6, 0.0);
    vtkNew<vtkImageData> none;
    if (!blocks.empty())
    {
      this->SumLines(blocks, bounds, none);
    }
    return 1;
  }

  const std::string error = this->FindSizeError(bounds);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::UserError);
    return 1;
  }
  vtkSmartPointer<vtkImageData> image = this->PlaceImage(bounds);
  int isDone = blocks.empty() || this->SumLines(blocks, bounds, image) ? 1 : 0;
  const bool isParallel = this->Controller && this->Controller->GetNumberOfProcesses() > 1;
  if (isParallel)
  {
    // What is wrong on one rank leaves all of them without an image, and none of them waiting.
    int isDoneByAll = 0;
    this->Controller->AllReduce(&isDone, &isDoneByAll, 1, vtkCommunicator::MIN_OP);
    isDone = isDoneByAll;
  }
  const vtkIdType size = image->GetNumberOfPoints();
  if (!isDone || size == 0)
  {
    return 1;
  }
  vtkSmartPointer<vtkFloatArray> sums =
    vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  if (!sums)
  {
    // No lines here, but elsewhere.
    sums = vtkSmartPointer<vtkFloatArray>::New();
    sums->SetNumberOfValues(size);
    sums->FillValue(0.0f);
  }
  if (isParallel)
  {
    SumOverRanks(this->Controller, sums);
  }
  sums->SetName("Density");
  image->GetPointData()->SetScalars(sums);
  outInfo->Set(Pipeline::WHOLE_EXTENT(), image->GetExtent(), 6);
  output->ShallowCopy(image);
  CropToPiece(output, outInfo);
  return 1;
}

//------------------------------------------------------------------------------
void vtkLineDensityFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Opacity: " << this->Opacity << "\n";
}
