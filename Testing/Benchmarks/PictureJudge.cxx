// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureJudge.h"

#include "CapsulesFromLines.h"
#include "CapsulesFromModel.h"
#include "ImageMeasures.h"
#include "ReferenceRenderer.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVoxelLineModel.h"

#include <iostream>
#include <stdexcept>

namespace linesets
{
namespace
{
void DrawReference(const CapsuleScene& scene, BenchmarkMethod& method, vtkImageData* picture)
{
  ReferenceRenderer reference(scene);
  reference.SetView(method.GetRenderer(), method.GetActor());
  ReferenceImage image;
  reference.Render(image);
  image.ToImageData(picture);
}
}

//------------------------------------------------------------------------------
PictureJudge::PictureJudge(const BenchmarkInput& input)
  : Input(input)
{
}

//------------------------------------------------------------------------------
void PictureJudge::DrawExact(BenchmarkMethod& method)
{
  std::cerr << "reference\n";
  LineOptions lineOptions;
  lineOptions.Radius = this->Input.Radius;
  if (vtkDataArray* scalars = this->Input.Geometry->GetPointData()->GetScalars())
  {
    if (!scalars->GetName())
    {
      scalars->SetName("scalars");
    }
    lineOptions.ColorArray = scalars->GetName();
  }
  // Camera, lights and material are the same for all methods.
  DrawReference(MakeCapsulesFromLines(this->Input.Geometry, lineOptions), method, this->Exact);
  this->Drawn = true;
  const std::string& prefix = this->Input.Options.ImagePrefix;
  if (!prefix.empty() && !WriteImage(this->Exact, prefix + "-reference.png"))
  {
    throw std::runtime_error("cannot write the picture of the reference");
  }
}

//------------------------------------------------------------------------------
void PictureJudge::Judge(BenchmarkEntry& entry)
{
  BenchmarkMethod& method = *entry.Method;
  if (!method.Error.empty() || HasGlobalIllumination(method.Name) ||
    this->Input.Geometry->GetNumberOfLines() == 0)
  {
    return;
  }
  if (this->Input.Options.Reference)
  {
    if (!this->Drawn)
    {
      this->DrawExact(method);
    }
    entry.Rmse = CompareImages(entry.Picture, this->Exact).Rmse;
    entry.Ssim = GetStructuralSimilarity(entry.Picture, this->Exact);
  }
  if (this->Input.Options.DecodedReference && method.GetModel())
  {
    std::cerr << "reference of the model of " << method.FileName << "\n";
    vtkNew<vtkImageData> decoded;
    DrawReference(MakeCapsulesFromModel(method.GetModel(), this->Input.Radius), method, decoded);
    entry.DecodedRmse = CompareImages(entry.Picture, decoded).Rmse;
  }
}

//------------------------------------------------------------------------------
bool WriteImage(vtkImageData* image, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(image);
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}
