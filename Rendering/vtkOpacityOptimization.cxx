// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpacityOptimization.h"

#include "vtkLineSetsCheckedValuePrivate.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOpacityOptimization);

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetRegularizationWeight(double weight)
{
  vtkLineSetsSetInRange(
    this, "RegularizationWeight", this->RegularizationWeight, weight, 1e-6, 1e6);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetForegroundWeight(double weight)
{
  vtkLineSetsSetInRange(this, "ForegroundWeight", this->ForegroundWeight, weight, 0.0, 1e6);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetBackgroundWeight(double weight)
{
  vtkLineSetsSetInRange(this, "BackgroundWeight", this->BackgroundWeight, weight, 0.0, 1e6);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetEmphasis(double emphasis)
{
  vtkLineSetsSetInRange(this, "Emphasis", this->Emphasis, emphasis, 0.01, 100.0);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetSmoothingIterations(int iterations)
{
  vtkLineSetsSetInRange(
    this, "SmoothingIterations", this->SmoothingIterations, iterations, 0, 1000);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetTransitionTime(double seconds)
{
  vtkLineSetsSetInRange(this, "TransitionTime", this->TransitionTime, seconds, 0.0, 60.0);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetNumberOfBands(int bands)
{
  vtkLineSetsSetInRange(this, "NumberOfBands", this->NumberOfBands, bands, 1, 16);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetSubset(int n)
{
  vtkLineSetsSetInRange(this, "Subset", this->Subset, n, 1, 10000);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetImportanceReduction(int reduction)
{
  vtkLineSetsSetInRange(this, "ImportanceReduction", this->ImportanceReduction, reduction, 1, 8);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetDepthReduction(int reduction)
{
  vtkLineSetsSetInRange(this, "DepthReduction", this->DepthReduction, reduction, 1, 8);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetBlending(int blending)
{
  vtkLineSetsSetInRange(this, "Blending", this->Blending, blending, static_cast<int>(Fourier),
    static_cast<int>(FragmentLists));
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetImportance(int importance)
{
  vtkLineSetsSetInRange(this, "Importance", this->Importance, importance,
    static_cast<int>(SeriesImportance), static_cast<int>(ExactImportance));
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetDepthScale(int scale)
{
  vtkLineSetsSetInRange(this, "DepthScale", this->DepthScale, scale, static_cast<int>(LinearDepth),
    static_cast<int>(LogarithmicDepth));
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetOpaqueThreshold(double opacity)
{
  vtkLineSetsSetInRange(this, "OpaqueThreshold", this->OpaqueThreshold, opacity, 0.5, 1.0);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetHaloWidth(double pixels)
{
  vtkLineSetsSetInRange(this, "HaloWidth", this->HaloWidth, pixels, 0.0, 100.0);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetHaloDepth(double part)
{
  vtkLineSetsSetInRange(this, "HaloDepth", this->HaloDepth, part, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetAccumulationFrames(int frames)
{
  vtkLineSetsSetInRange(this, "AccumulationFrames", this->AccumulationFrames, frames, 1, 4096);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::SetMaximumListMemory(int mebibytes)
{
  vtkLineSetsSetInRange(this, "MaximumListMemory", this->MaximumListMemory, mebibytes, 1, 1 << 20);
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RegularizationWeight: " << this->RegularizationWeight << "\n";
  os << indent << "ForegroundWeight: " << this->ForegroundWeight << "\n";
  os << indent << "BackgroundWeight: " << this->BackgroundWeight << "\n";
  os << indent << "Emphasis: " << this->Emphasis << "\n";
  os << indent << "SmoothingIterations: " << this->SmoothingIterations << "\n";
  os << indent << "TransitionTime: " << this->TransitionTime << "\n";
  os << indent << "NumberOfBands: " << this->NumberOfBands << "\n";
  os << indent << "Subset: " << this->Subset << "\n";
  os << indent << "ImportanceReduction: " << this->ImportanceReduction << "\n";
  os << indent << "DepthReduction: " << this->DepthReduction << "\n";
  os << indent << "HalfFloats: " << this->HalfFloats << "\n";
  os << indent << "Blending: " << this->Blending << "\n";
  os << indent << "Importance: " << this->Importance << "\n";
  os << indent << "DepthScale: " << this->DepthScale << "\n";
  os << indent << "TightDepth: " << this->TightDepth << "\n";
  os << indent << "OpaqueThreshold: " << this->OpaqueThreshold << "\n";
  os << indent << "HaloWidth: " << this->HaloWidth << "\n";
  os << indent << "HaloDepth: " << this->HaloDepth << "\n";
  os << indent << "AccumulationFrames: " << this->AccumulationFrames << "\n";
  os << indent << "MaximumListMemory: " << this->MaximumListMemory << "\n";
}
