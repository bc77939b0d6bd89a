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

#include <algorithm>

vtkStandardNewMacro(vtkLineDensityFilter);

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr int NoExtent[6] = { 0, -1, 0, -1, 0, -1 };

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
  if (this->FindBounds(FindBlocks(vtkDataObject::GetData(inputVector[0]), numberOfOthers), bounds))
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
    auto mine = sums;
    sums = vtkSmartPointer<vtkFloatArray>::New();
    sums->SetNumberOfValues(size);
    this->Controller->AllReduce(
      mine->GetPointer(0), sums->GetPointer(0), size, vtkCommunicator::SUM_OP);
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
