// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineMapper.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkLineGlobalIllumination.h"
#include "vtkLineIllumination.h"
#include "vtkLineSetsCheckedValuePrivate.h"
#include "vtkLineVoxelizer.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVoxelLineAccumulator.h"
#include "vtkVoxelLineColoring.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineModelSource.h"
#include "vtkVoxelLinePainter.h"
#include "vtkVoxelLineReceivers.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace
{
// Automatic radius: this part of the longest side of the bounds.
constexpr double AutomaticRadius = 1.0 / 512.0;

// Kind of the mapper's own warning, beside those of the painter.
constexpr int StepsWarning = -1;

void PrintNumbers(ostream& os, vtkIndent indent, const char* name, const double* numbers, int count)
{
  os << indent << name << ":";
  for (int i = 0; i < count; ++i)
  {
    os << " " << numbers[i];
  }
  os << "\n";
}

double GetLongestSide(const double bounds[6])
{
  return std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
}
}

class vtkVoxelLineMapper::vtkInternals
{
public:
  explicit vtkInternals(vtkVoxelLineMapper* mapper)
    : Receivers(
        { [this, mapper](vtkVoxelLineScene& scene) { return this->DescribeCaster(mapper, scene); },
          this->Painter.GetLightFields(),
          [this, mapper](const vtkVoxelLineScene::Warnings& warnings)
          { this->WarnOnce(mapper, warnings); } })
  {
  }

  vtkVoxelLineModelSource Source;
  vtkVoxelLinePainter Painter;
  vtkSmartPointer<vtkLineIllumination> Illumination = vtkSmartPointer<vtkLineIllumination>::New();
  vtkSmartPointer<vtkLineGlobalIllumination> GlobalIllumination =
    vtkSmartPointer<vtkLineGlobalIllumination>::New();

  // What has been said, so that it is said once.
  std::string LastError;
  std::string LastColorWarning;
  std::set<std::string> WarnedTexts;
  vtkMTimeType WarnedModel = 0;
  std::set<int> WarnedKinds;

  // Reads what stands above.
  vtkVoxelLineReceivers Receivers;

  // Whether a kind of warning is to be said, once for each model; or, where it tells nothing about
  // the model, once each text.
  bool IsNews(int kind, const std::string& text)
  {
    if (kind >= vtkVoxelLineScene::NoGlobalLight)
    {
      return this->WarnedTexts.insert(text).second;
    }
    vtkVoxelLineModel* model = this->Source.GetModel();
    const vtkMTimeType time = model ? model->GetMTime() : 0;
    if (this->WarnedModel != time)
    {
      this->WarnedModel = time;
      this->WarnedKinds.clear();
    }
    return this->WarnedKinds.insert(kind).second;
  }

  void WarnOnce(vtkVoxelLineMapper* mapper, const vtkVoxelLineScene::Warnings& warnings)
  {
    for (const auto& [kind, text] : warnings)
    {
      if (this->IsNews(kind, text))
      {
        vtkWarningWithObjectMacro(mapper, << text);
      }
    }
  }

  static vtkVoxelLineModelSource::Parameters GetParameters(vtkVoxelLineMapper* mapper)
  {
    vtkVoxelLineModelSource::Parameters parameters;
    parameters.Resolution = mapper->Resolution;
    parameters.FaceBins = mapper->FaceBins;
    parameters.InteriorTolerance = mapper->InteriorTolerance;
    parameters.RadiusArrayName = mapper->RadiusArrayName;
    parameters.UseCustomBounds = mapper->UseCustomBounds;
    std::copy_n(mapper->CustomBounds, 6, parameters.Custom.Bounds);
    parameters.UseCustomRanges = mapper->UseCustomRanges;
    std::copy_n(mapper->CustomAttributeRange, 2, parameters.Custom.AttributeRange);
    parameters.Custom.MaximumRadius = mapper->CustomMaximumRadius;
    return parameters;
  }

  // DescribeScene() for receivers: the mapper may not be drawn; false: there are no lines.
  bool DescribeCaster(vtkVoxelLineMapper* mapper, vtkVoxelLineScene& scene)
  {
    vtkVoxelLineModel* model = mapper->GetModel();
    if (!model || model->GetNumberOfSegments() == 0 || !model->FindDefect().empty())
    {
      return false;
    }
    scene = this->DescribeScene(mapper);
    return true;
  }

  // What the painter needs to know of the mapper that these belong to, for a model that is valid.
  vtkVoxelLinePainter::Scene DescribeScene(vtkVoxelLineMapper* mapper)
  {
    vtkVoxelLinePainter::Scene scene;
    scene.Mapper = mapper;
    scene.Model = this->Source.GetModel();
    scene.Input = this->Source.GetLines();
    scene.Radius = mapper->GetRadiusInUse();
    scene.SmallestRadius =
      scene.Model->GetRadii() ? this->Source.GetSmallestRadius() : scene.Radius;
    scene.TranslucentColors = this->Source.HasTranslucentColors();
    return scene;
  }
};

vtkStandardNewMacro(vtkVoxelLineMapper);

//------------------------------------------------------------------------------
vtkVoxelLineMapper::vtkVoxelLineMapper()
  : Internals(new vtkInternals(this))
{
}

//------------------------------------------------------------------------------
vtkVoxelLineMapper::~vtkVoxelLineMapper()
{
  this->SetPointIdArrayName(nullptr);
  this->SetCellIdArrayName(nullptr);
  this->SetCompositeIdArrayName(nullptr);
  this->SetProcessIdArrayName(nullptr);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetInputData(vtkPolyData* input)
{
  this->SetInputDataInternal(0, input);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetInputData(vtkVoxelLineModel* input)
{
  this->SetInputDataInternal(0, input);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetRadius(double radius)
{
  if (!std::isfinite(radius) || radius < 0.0)
  {
    vtkErrorMacro("Radius " << radius << " is not valid: it must be a finite number above 0, or 0 "
                            << "for an automatic radius. It stays " << this->Radius << ".");
    return;
  }
  if (this->Radius != radius)
  {
    this->Radius = radius;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetRadiusArrayName(const std::string& name)
{
  if (this->RadiusArrayName != name)
  {
    this->RadiusArrayName = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetResolution(int resolution)
{
  vtkLineSetsSetInRange<int>(
    this, "Resolution", this->Resolution, resolution, 1, vtkLineVoxelizer::LargestResolution);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetFaceBins(int bins)
{
  const bool powerOfTwo = bins > 0 && (bins & (bins - 1)) == 0;
  if (bins != 0 && (!powerOfTwo || bins < 2 || bins > 2048))
  {
    vtkErrorMacro("FaceBins " << bins << " is not valid: it must be a power of two from 2 to 2048, "
                              << "or 0 for exact points. It stays " << this->FaceBins << ".");
    return;
  }
  if (this->FaceBins != bins)
  {
    this->FaceBins = bins;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetInteriorTolerance(double tolerance)
{
  if (std::isnan(tolerance) || tolerance < 0.0)
  {
    vtkErrorMacro("InteriorTolerance " << tolerance << " is not valid: it must be 0 or above. It "
                                       << "stays " << this->InteriorTolerance << ".");
    return;
  }
  if (this->InteriorTolerance != tolerance)
  {
    this->InteriorTolerance = tolerance;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetRegion(const double region[6])
{
  vtkLineSetsSetRegion(this, this->Region, region);
}

//------------------------------------------------------------------------------
vtkLineVoxelizer::Measures vtkVoxelLineMapper::MeasureLines(vtkPolyData* lines)
{
  return vtkVoxelLineModelSource::Measure(this, lines, this->Internals->GetParameters(this));
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetEarlyTermination(double opacity)
{
  vtkLineSetsSetInRange<double>(
    this, "EarlyTermination", this->EarlyTermination, opacity, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetOpacityAcceleration(double opacity)
{
  vtkLineSetsSetInRange<double>(
    this, "OpacityAcceleration", this->OpacityAcceleration, opacity, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetIllumination(vtkLineIllumination* illumination)
{
  if (illumination != this->Internals->Illumination || !illumination)
  {
    this->Internals->Illumination =
      illumination ? illumination : vtkSmartPointer<vtkLineIllumination>::New().Get();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkLineIllumination* vtkVoxelLineMapper::GetIllumination()
{
  return this->Internals->Illumination;
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetGlobalIllumination(vtkLineGlobalIllumination* illumination)
{
  if (illumination != this->Internals->GlobalIllumination || !illumination)
  {
    this->Internals->GlobalIllumination =
      illumination ? illumination : vtkSmartPointer<vtkLineGlobalIllumination>::New().Get();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkLineGlobalIllumination* vtkVoxelLineMapper::GetGlobalIllumination()
{
  return this->Internals->GlobalIllumination;
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::AddReceiver(vtkActor* actor)
{
  if (!actor)
  {
    vtkErrorMacro("There is no actor to receive light.");
  }
  else if (vtkVoxelLineMapper::SafeDownCast(actor->GetMapper()))
  {
    vtkErrorMacro("The actor " << actor << " draws by a vtkVoxelLineMapper, whose lines receive no "
                               << "light from another one's, and their own without this call.");
  }
  else if (!this->Internals->Receivers.Add(actor))
  {
    vtkErrorMacro("The actor " << actor << " receives from another vtkVoxelLineMapper, from which "
                               << "it must be removed first.");
  }
  else
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::RemoveReceiver(vtkActor* actor)
{
  if (this->Internals->Receivers.Remove(actor))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::RemoveAllReceivers()
{
  this->Internals->Receivers.RemoveAll();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkVoxelLineMapper::GetNumberOfReceivers()
{
  return this->Internals->Receivers.GetNumberOfReceivers();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVoxelLineMapper::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->Internals->Illumination->GetMTime(),
    this->Internals->GlobalIllumination->GetMTime() });
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetEngine(int engine)
{
  if (engine != Automatic && engine != Native && engine != Shader)
  {
    vtkErrorMacro("Engine " << engine << " is not valid: it must be Automatic (" << Automatic
                            << "), Native (" << Native << ") or Shader (" << Shader
                            << "). It stays " << this->Engine << ".");
    return;
  }
  if (this->Engine != engine)
  {
    this->Engine = engine;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetAccumulationFrames(int frames)
{
  vtkLineSetsSetInRange<int>(this, "AccumulationFrames", this->AccumulationFrames, frames, 1,
    vtkVoxelLineAccumulator::LargestNumber);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::SetQuality(int quality)
{
  if (quality != AutomaticQuality && quality != InteractiveQuality && quality != StillQuality)
  {
    vtkErrorMacro("Quality " << quality << " is not valid: it must be automatic ("
                             << AutomaticQuality << "), interactive (" << InteractiveQuality
                             << ") or still (" << StillQuality << "). It stays " << this->Quality
                             << ".");
    return;
  }
  if (this->Quality != quality)
  {
    this->Quality = quality;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkVoxelLineMapper::GetNumberOfAccumulatedPictures()
{
  return this->Internals->Painter.GetNumberOfAccumulatedPictures();
}

//------------------------------------------------------------------------------
int vtkVoxelLineMapper::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkVoxelLineModel");
  return 1;
}

//------------------------------------------------------------------------------
vtkVoxelLineModel* vtkVoxelLineMapper::GetModel()
{
  vtkVoxelLineModelSource& source = this->Internals->Source;
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    source.SetModel(nullptr);
    return nullptr;
  }
  // Does nothing where Static is on.
  this->Update();
  vtkDataObject* input = this->GetExecutive()->GetInputData(0, 0);
  if (auto* lines = vtkPolyData::SafeDownCast(input))
  {
    std::string warning = this->Internals->LastColorWarning;
    const double seconds = source.Build(this, lines, this->Internals->GetParameters(this), warning);
    this->ModelBuildTime = seconds >= 0.0 ? seconds : this->ModelBuildTime;
    this->WarnOnce(this->Internals->LastColorWarning, warning);
  }
  else
  {
    source.SetModel(vtkVoxelLineModel::SafeDownCast(input));
    this->ModelBuildTime = input ? 0.0 : this->ModelBuildTime;
  }
  return source.GetModel();
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::WarnOnce(std::string& last, const std::string& warning)
{
  if (last != warning)
  {
    last = warning;
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning << "; the lines get the property's colour instead.");
    }
  }
}

//------------------------------------------------------------------------------
double vtkVoxelLineMapper::GetRadiusInUse()
{
  vtkVoxelLineModel* model = this->GetModel();
  if (!model || model->GetNumberOfSegments() == 0)
  {
    return this->Radius;
  }
  if (model->GetRadii())
  {
    return model->GetMaximumRadius();
  }
  if (this->Radius > 0.0)
  {
    return this->Radius;
  }
  const double side =
    GetLongestSide(this->UseCustomBounds ? this->CustomBounds : model->GetBounds());
  // A single point has no extent; the voxel size is what is left.
  return side > 0.0 ? AutomaticRadius * side : 0.5 * model->GetVoxelSize();
}

//------------------------------------------------------------------------------
double vtkVoxelLineMapper::GetLightBuildTime()
{
  return this->Internals->Painter.GetLightBuildTime();
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineMapper::GetNumberOfPictures()
{
  return this->Internals->Painter.GetNumberOfPictures();
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineMapper::GetGraphicsMemory()
{
  return this->Internals->Painter.GetNumberOfBytes() +
    this->Internals->Receivers.GetNumberOfBytes();
}

//------------------------------------------------------------------------------
double* vtkVoxelLineMapper::GetBounds()
{
  this->ComputeBounds();
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::ComputeBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  vtkVoxelLineModel* model = this->GetModel();
  if (!model || model->GetNumberOfSegments() == 0)
  {
    return;
  }
  model->GetBounds(this->Bounds);
  const double radius = this->GetRadiusInUse();
  for (int i = 0; i < 3; ++i)
  {
    this->Bounds[2 * i] -= radius;
    this->Bounds[2 * i + 1] += radius;
  }
}

//------------------------------------------------------------------------------
bool vtkVoxelLineMapper::HasTranslucentPolygonalGeometry()
{
  vtkVoxelLineModel* model = this->GetModel();
  if (!model)
  {
    return false;
  }
  vtkVoxelLineFrame frame;
  vtkVoxelLineColoring::SetColors(frame, this, model);
  const bool translucent = frame.Coloring == vtkVoxelLineFrame::Direct
    ? this->Internals->Source.HasTranslucentColors()
    : !frame.IsOpaque();
  return translucent || this->Internals->Painter.HasLeftOpaquePass() ||
    (model->GetNumberOfSegments() > 0 && model->FindDefect().empty() &&
      this->Internals->Painter.HasThinTubes(this->Internals->DescribeScene(this)));
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    this->ErrorOnce("There is no input: set a vtkPolyData or a vtkVoxelLineModel.");
    return;
  }
  // One piece: there is no streaming, since all curves share the grid.
  this->RenderPiece(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  if (renderer->GetRenderWindow()->CheckAbortStatus())
  {
    return;
  }
  this->Internals->Receivers.SetDrawnBy(actor);
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  vtkVoxelLineModel* model = this->GetModel();
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  // An executing pipeline may have made another context current.
  renderer->GetRenderWindow()->MakeCurrent();
  const std::string defect = model ? model->FindDefect() : std::string();
  if (!defect.empty())
  {
    this->ErrorOnce(defect);
    return;
  }
  if (!model || model->GetNumberOfSegments() == 0)
  {
    return;
  }

  const vtkVoxelLinePainter::Scene scene = this->Internals->DescribeScene(this);
  if (this->Internals->Painter.IsLeftToTranslucentPass(scene, renderer, actor))
  {
    return;
  }
  vtkVoxelLinePainter::Warnings warnings;
  this->ErrorOnce(this->Internals->Painter.Draw(scene, renderer, actor, warnings));
  this->Internals->WarnOnce(this, warnings);
  // After the picture, which has brought the lookup table's range up to date.
  const std::string steps = vtkVoxelLineColoring::DescribeSteps(this, model);
  if (!steps.empty() && this->Internals->IsNews(StepsWarning, steps))
  {
    vtkWarningMacro(<< steps);
  }
  this->EngineInUse = this->Internals->Painter.GetEngineInUse();
  this->QualityInUse = this->Internals->Painter.GetQualityInUse();
  this->TimeToDraw = this->Internals->Painter.GetSeconds();
  this->UpdateProgress(1.0);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::ErrorOnce(const std::string& error)
{
  std::string& last = this->Internals->LastError;
  if (last != error)
  {
    last = error;
    if (!error.empty())
    {
      vtkErrorMacro("The lines are not drawn: " << error);
    }
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Painter.ReleaseGraphicsResources(window);
  this->Internals->Receivers.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  auto* other = vtkVoxelLineMapper::SafeDownCast(mapper);
  if (other)
  {
    this->SetRadius(other->Radius);
    this->SetRadiusArrayName(other->RadiusArrayName);
    this->SetResolution(other->Resolution);
    this->SetFaceBins(other->FaceBins);
    this->SetInteriorTolerance(other->InteriorTolerance);
    this->SetUseCustomBounds(other->UseCustomBounds);
    this->SetCustomBounds(other->CustomBounds);
    this->SetUseCustomRanges(other->UseCustomRanges);
    this->SetCustomAttributeRange(other->CustomAttributeRange);
    this->SetCustomMaximumRadius(other->CustomMaximumRadius);
    this->SetRegion(other->Region);
    this->SetEarlyTermination(other->EarlyTermination);
    this->SetOpacityAcceleration(other->OpacityAcceleration);
    this->SetEngine(other->Engine);
    this->SetIllumination(other->GetIllumination());
    this->SetGlobalIllumination(other->GetGlobalIllumination());
    this->SetSubPixelCoverage(other->SubPixelCoverage);
    this->SetAccumulationFrames(other->AccumulationFrames);
    this->SetOpacityByPathLength(other->OpacityByPathLength);
    this->SetQuality(other->Quality);
    this->SetPointIdArrayName(other->GetPointIdArrayName());
    this->SetCellIdArrayName(other->GetCellIdArrayName());
    this->SetCompositeIdArrayName(other->GetCompositeIdArrayName());
    this->SetProcessIdArrayName(other->GetProcessIdArrayName());
  }
  this->Superclass::ShallowCopy(mapper);
}

//------------------------------------------------------------------------------
void vtkVoxelLineMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "FaceBins: " << this->FaceBins << "\n";
  os << indent << "InteriorTolerance: " << this->InteriorTolerance << "\n";
  os << indent << "UseCustomBounds: " << (this->UseCustomBounds ? "On" : "Off") << "\n";
  PrintNumbers(os, indent, "CustomBounds", this->CustomBounds, 6);
  os << indent << "UseCustomRanges: " << (this->UseCustomRanges ? "On" : "Off") << "\n";
  PrintNumbers(os, indent, "CustomAttributeRange", this->CustomAttributeRange, 2);
  os << indent << "CustomMaximumRadius: " << this->CustomMaximumRadius << "\n";
  PrintNumbers(os, indent, "Region", this->Region, 6);
  os << indent << "EarlyTermination: " << this->EarlyTermination << "\n";
  os << indent << "OpacityAcceleration: " << this->OpacityAcceleration << "\n";
  os << indent << "Engine: " << this->Engine << "\n";
  os << indent << "SubPixelCoverage: " << (this->SubPixelCoverage ? "On" : "Off") << "\n";
  os << indent << "AccumulationFrames: " << this->AccumulationFrames << "\n";
  os << indent << "NumberOfAccumulatedPictures: " << this->GetNumberOfAccumulatedPictures() << "\n";
  os << indent << "OpacityByPathLength: " << (this->OpacityByPathLength ? "On" : "Off") << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "QualityInUse: " << this->QualityInUse << "\n";
  os << indent
     << "PointIdArrayName: " << (this->PointIdArrayName ? this->PointIdArrayName : "(none)")
     << "\n";
  os << indent << "CellIdArrayName: " << (this->CellIdArrayName ? this->CellIdArrayName : "(none)")
     << "\n";
  os << indent << "CompositeIdArrayName: "
     << (this->CompositeIdArrayName ? this->CompositeIdArrayName : "(none)") << "\n";
  os << indent
     << "ProcessIdArrayName: " << (this->ProcessIdArrayName ? this->ProcessIdArrayName : "(none)")
     << "\n";
  os << indent << "NumberOfReceivers: " << this->GetNumberOfReceivers() << "\n";
  os << indent << "Illumination:\n";
  this->Internals->Illumination->PrintSelf(os, indent.GetNextIndent());
  os << indent << "GlobalIllumination:\n";
  this->Internals->GlobalIllumination->PrintSelf(os, indent.GetNextIndent());
  os << indent << "EngineInUse: " << this->EngineInUse << "\n";
  os << indent << "ModelBuildTime: " << this->ModelBuildTime << "\n";
  os << indent << "LightBuildTime: " << this->GetLightBuildTime() << "\n";
  os << indent << "NumberOfPictures: " << this->GetNumberOfPictures() << "\n";
  os << indent << "GraphicsMemory: " << this->GetGraphicsMemory() << "\n";
  os << indent << "Model: ";
  if (this->Internals->Source.GetModel())
  {
    os << "\n";
    this->Internals->Source.GetModel()->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
}
