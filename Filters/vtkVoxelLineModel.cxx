// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineModel.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineEncodingPrivate.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

vtkStandardNewMacro(vtkVoxelLineModel);

namespace
{

vtkIdType BytesOf(vtkDataArray* array)
{
  return array ? array->GetNumberOfValues() * array->GetDataTypeSize() : 0;
}

template <typename ArrayT>
void CopyDeep(vtkSmartPointer<ArrayT>& target, const vtkSmartPointer<ArrayT>& source)
{
  target = nullptr;
  if (source)
  {
    target.TakeReference(source->NewInstance());
    target->DeepCopy(source);
  }
}

const std::uint32_t* WordsOf(vtkDataArray* array)
{
  return static_cast<const std::uint32_t*>(array->GetVoidPointer(0));
}

/// Why an array does not have one of the types, the components and the rows that it has to have;
/// empty where it has. A negative number of rows: any.
std::string FindArrayDefect(const std::string& name, vtkDataArray* array,
  std::initializer_list<int> types, int components, vtkIdType rows)
{
  if (!array)
  {
    return name + " is missing";
  }
  if (std::find(types.begin(), types.end(), array->GetDataType()) == types.end() ||
    !array->HasStandardMemoryLayout())
  {
    return name + " holds " + array->GetDataTypeAsString() + ", which is not a type it may have";
  }
  if (array->GetNumberOfComponents() != components)
  {
    return name + " has " + std::to_string(array->GetNumberOfComponents()) +
      " components where there are to be " + std::to_string(components);
  }
  if (rows >= 0 && array->GetNumberOfTuples() != rows)
  {
    return name + " has " + std::to_string(array->GetNumberOfTuples()) +
      " rows where there are to be " + std::to_string(rows);
  }
  return std::string();
}

}

//------------------------------------------------------------------------------
vtkVoxelLineModel::vtkVoxelLineModel() = default;

//------------------------------------------------------------------------------
vtkVoxelLineModel::~vtkVoxelLineModel() = default;

//------------------------------------------------------------------------------
void vtkVoxelLineModel::Initialize()
{
  this->Superclass::Initialize();
  std::fill_n(this->Dimensions, 3, 0);
  std::fill_n(this->Origin, 3, 0.0);
  this->VoxelSize = 1.0;
  this->FaceBins = 32;
  this->AttributeKind = NoAttribute;
  this->AttributeRange[0] = 0.0;
  this->AttributeRange[1] = 1.0;
  this->HasNaNAttribute = false;
  this->MaximumRadius = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Bounds[2 * axis] = 1.0;
    this->Bounds[2 * axis + 1] = -1.0;
  }
  this->NumberOfDuplicates = 0;
  this->NumberOfCollapsedSegments = 0;
  std::fill_n(this->NumberOfDroppedCurves, static_cast<int>(NumberOfDropReasons), 0);
  this->NumberOfDroppedPoints = 0;
  this->LargestDeviation = 0.0;
  this->BrickGrid = nullptr;
  this->Bricks = nullptr;
  this->VoxelStarts = nullptr;
  this->Segments = nullptr;
  this->CurveIdExtension = nullptr;
  this->BrickCurves = nullptr;
  this->CurveCells = nullptr;
  this->Attributes = nullptr;
  this->Radii = nullptr;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkVoxelLineModel::CopyMembers(vtkVoxelLineModel* model)
{
  std::copy_n(model->Dimensions, 3, this->Dimensions);
  std::copy_n(model->Origin, 3, this->Origin);
  this->VoxelSize = model->VoxelSize;
  this->FaceBins = model->FaceBins;
  this->AttributeKind = model->AttributeKind;
  std::copy_n(model->AttributeRange, 2, this->AttributeRange);
  this->HasNaNAttribute = model->HasNaNAttribute;
  this->MaximumRadius = model->MaximumRadius;
  std::copy_n(model->Bounds, 6, this->Bounds);
  this->NumberOfDuplicates = model->NumberOfDuplicates;
  this->NumberOfCollapsedSegments = model->NumberOfCollapsedSegments;
  std::copy_n(model->NumberOfDroppedCurves, static_cast<int>(NumberOfDropReasons),
    this->NumberOfDroppedCurves);
  this->NumberOfDroppedPoints = model->NumberOfDroppedPoints;
  this->LargestDeviation = model->LargestDeviation;
}

//------------------------------------------------------------------------------
void vtkVoxelLineModel::ShallowCopy(vtkDataObject* source)
{
  vtkVoxelLineModel* model = vtkVoxelLineModel::SafeDownCast(source);
  if (model && model != this)
  {
    this->CopyMembers(model);
    this->BrickGrid = model->BrickGrid;
    this->Bricks = model->Bricks;
    this->VoxelStarts = model->VoxelStarts;
    this->Segments = model->Segments;
    this->CurveIdExtension = model->CurveIdExtension;
    this->BrickCurves = model->BrickCurves;
    this->CurveCells = model->CurveCells;
    this->Attributes = model->Attributes;
    this->Radii = model->Radii;
    this->Modified();
  }
  this->Superclass::ShallowCopy(source);
}

//------------------------------------------------------------------------------
void vtkVoxelLineModel::DeepCopy(vtkDataObject* source)
{
  vtkVoxelLineModel* model = vtkVoxelLineModel::SafeDownCast(source);
  if (model && model != this)
  {
    this->CopyMembers(model);
    CopyDeep(this->BrickGrid, model->BrickGrid);
    CopyDeep(this->Bricks, model->Bricks);
    CopyDeep(this->VoxelStarts, model->VoxelStarts);
    CopyDeep(this->Segments, model->Segments);
    CopyDeep(this->CurveIdExtension, model->CurveIdExtension);
    CopyDeep(this->BrickCurves, model->BrickCurves);
    CopyDeep(this->CurveCells, model->CurveCells);
    CopyDeep(this->Attributes, model->Attributes);
    CopyDeep(this->Radii, model->Radii);
    this->Modified();
  }
  this->Superclass::DeepCopy(source);
}

//------------------------------------------------------------------------------
vtkVoxelLineModel* vtkVoxelLineModel::GetData(vtkInformation* info)
{
  return info ? vtkVoxelLineModel::SafeDownCast(info->Get(DATA_OBJECT())) : nullptr;
}

//------------------------------------------------------------------------------
vtkVoxelLineModel* vtkVoxelLineModel::GetData(vtkInformationVector* v, int i)
{
  return vtkVoxelLineModel::GetData(v->GetInformationObject(i));
}

//------------------------------------------------------------------------------
void vtkVoxelLineModel::GetBrickDimensions(int dimensions[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] = (this->Dimensions[axis] + BrickSize - 1) / BrickSize;
  }
}

//------------------------------------------------------------------------------
int vtkVoxelLineModel::GetEncoding() const
{
  return vtkVoxelLineEncoding::EncodingOf(this->FaceBins);
}

//------------------------------------------------------------------------------
int vtkVoxelLineModel::GetSegmentWords() const
{
  return vtkVoxelLineEncoding::Codec(this->FaceBins).Words;
}

//------------------------------------------------------------------------------
int vtkVoxelLineModel::GetInteriorBins() const
{
  return vtkVoxelLineEncoding::InteriorBinsOf(this->FaceBins);
}

//------------------------------------------------------------------------------
#define LINESETS_ARRAY_MEMBER(name, type)                                                          \
  void vtkVoxelLineModel::Set##name(type* array)                                                   \
  {                                                                                                \
    if (this->name != array)                                                                       \
    {                                                                                              \
      this->name = array;                                                                          \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  type* vtkVoxelLineModel::Get##name() const                                                       \
  {                                                                                                \
    return this->name;                                                                             \
  }

LINESETS_ARRAY_MEMBER(BrickGrid, vtkDataArray)
LINESETS_ARRAY_MEMBER(Bricks, vtkDataArray)
LINESETS_ARRAY_MEMBER(VoxelStarts, vtkDataArray)
LINESETS_ARRAY_MEMBER(Segments, vtkDataArray)
LINESETS_ARRAY_MEMBER(CurveIdExtension, vtkDataArray)
LINESETS_ARRAY_MEMBER(BrickCurves, vtkDataArray)
LINESETS_ARRAY_MEMBER(CurveCells, vtkIdTypeArray)
LINESETS_ARRAY_MEMBER(Attributes, vtkUnsignedCharArray)
LINESETS_ARRAY_MEMBER(Radii, vtkUnsignedCharArray)

#undef LINESETS_ARRAY_MEMBER

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineModel::GetNumberOfSegments() const
{
  return this->Segments ? this->Segments->GetNumberOfTuples() : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineModel::GetNumberOfBricks() const
{
  // The last row only ends the ranges of the brick before it.
  return this->Bricks ? std::max<vtkIdType>(this->Bricks->GetNumberOfTuples() - 1, 0) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineModel::GetNumberOfCurves() const
{
  return this->CurveCells ? this->CurveCells->GetNumberOfTuples() : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineModel::GetNumberOfOccupiedVoxels() const
{
  // Each brick has one start per occupied voxel and a closing one.
  return this->VoxelStarts ? this->VoxelStarts->GetNumberOfTuples() - this->GetNumberOfBricks() : 0;
}

//------------------------------------------------------------------------------
void vtkVoxelLineModel::SetNumberOfDroppedCurves(int reason, vtkIdType number)
{
  if (reason < 0 || reason >= NumberOfDropReasons)
  {
    vtkErrorMacro(
      "Drop reason " << reason << " is outside 0 to " << NumberOfDropReasons - 1 << ".");
    return;
  }
  if (this->NumberOfDroppedCurves[reason] != number)
  {
    this->NumberOfDroppedCurves[reason] = number;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineModel::GetNumberOfDroppedCurves(int reason) const
{
  return reason >= 0 && reason < NumberOfDropReasons ? this->NumberOfDroppedCurves[reason] : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineModel::GetNumberOfBytes(int part) const
{
  switch (part)
  {
    case SegmentPart:
      return BytesOf(this->Segments) + BytesOf(this->CurveIdExtension);
    case AttributePart:
      return BytesOf(this->Attributes);
    case RadiusPart:
      return BytesOf(this->Radii);
    case GridPart:
      return BytesOf(this->BrickGrid) + BytesOf(this->Bricks) + BytesOf(this->VoxelStarts);
    case CurvePart:
      return BytesOf(this->BrickCurves) + BytesOf(this->CurveCells);
    default:
      return 0;
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineModel::GetNumberOfBytes() const
{
  vtkIdType bytes = 0;
  for (int part = 0; part < NumberOfParts; ++part)
  {
    bytes += this->GetNumberOfBytes(part);
  }
  return bytes;
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineModel::FindGridDefect() const
{
  bool isPlaced = std::isfinite(this->VoxelSize) && this->VoxelSize > 0.0;
  bool hasVoxels = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    isPlaced = isPlaced && std::isfinite(this->Origin[axis]);
    hasVoxels = hasVoxels && this->Dimensions[axis] > 0;
  }
  const int bins = this->FaceBins;
  if (bins != 0 && (bins < 2 || bins > 2048 || (bins & (bins - 1)) != 0))
  {
    return "FaceBins is " + std::to_string(bins) + "; it must be a power of two from 2 to 2048, " +
      "or 0";
  }
  return !isPlaced ? "Origin and VoxelSize must be finite, and VoxelSize above 0"
    : !hasVoxels   ? "Dimensions must be above 0"
                   : std::string();
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineModel::FindArraysDefect() const
{
  int cells[3];
  this->GetBrickDimensions(cells);
  const vtkIdType segments = this->GetNumberOfSegments();
  std::string defect = FindArrayDefect("BrickGrid", this->BrickGrid, { VTK_INT }, 1,
    static_cast<vtkIdType>(cells[0]) * cells[1] * cells[2]);
  const auto require = [&defect](const char* name, vtkDataArray* array,
                         std::initializer_list<int> types, int components, vtkIdType rows)
  { defect = defect.empty() ? FindArrayDefect(name, array, types, components, rows) : defect; };
  require("Bricks", this->Bricks, { VTK_UNSIGNED_INT }, 5, -1);
  require("Segments", this->Segments,
    { this->GetEncoding() == Exact ? VTK_FLOAT : VTK_UNSIGNED_INT }, this->GetSegmentWords(), -1);
  if (!defect.empty())
  {
    return defect;
  }
  if (this->GetNumberOfBricks() == 0)
  {
    return "Bricks has no brick for the " + std::to_string(segments) + " segments";
  }
  const std::uint32_t* ends = WordsOf(this->Bricks) + 5 * this->GetNumberOfBricks();
  if (ends[2] != static_cast<std::uint64_t>(segments))
  {
    return "Segments has " + std::to_string(segments) + " rows where Bricks ends at " +
      std::to_string(ends[2]);
  }
  require("VoxelStarts", this->VoxelStarts, { VTK_UNSIGNED_SHORT, VTK_UNSIGNED_INT }, 1, ends[3]);
  require("BrickCurves", this->BrickCurves, { VTK_UNSIGNED_INT }, 1, ends[4]);
  require("CurveCells", this->CurveCells, { VTK_ID_TYPE }, 2, -1);
  if (this->CurveIdExtension)
  {
    require("CurveIdExtension", this->CurveIdExtension,
      { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_UNSIGNED_INT }, 1, segments);
  }
  if (this->Attributes || this->AttributeKind != NoAttribute)
  {
    require("Attributes", this->Attributes, { VTK_UNSIGNED_CHAR },
      this->AttributeKind == Color ? 8 : 2, segments);
  }
  if (this->Radii)
  {
    require("Radii", this->Radii, { VTK_UNSIGNED_CHAR }, 2, segments);
  }
  return defect;
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineModel::FindDefect() const
{
  const bool isEmpty = !this->BrickGrid && !this->Bricks && !this->VoxelStarts && !this->Segments &&
    !this->CurveIdExtension && !this->BrickCurves && !this->Attributes && !this->Radii;
  if (isEmpty || (this->Segments && this->Segments->GetNumberOfTuples() == 0))
  {
    return std::string();
  }
  std::string defect = this->FindGridDefect();
  if (defect.empty())
  {
    defect = this->FindArraysDefect();
  }
  if (defect.empty() && this->Radii &&
    !(std::isfinite(this->MaximumRadius) && this->MaximumRadius > 0.0))
  {
    defect = "MaximumRadius must be finite and above 0 where there are Radii";
  }
  return defect.empty() ? defect : "The model is not complete: " + defect + ".";
}

//------------------------------------------------------------------------------
unsigned long vtkVoxelLineModel::GetActualMemorySize()
{
  return this->Superclass::GetActualMemorySize() +
    static_cast<unsigned long>((this->GetNumberOfBytes() + 1023) / 1024);
}

//------------------------------------------------------------------------------
void vtkVoxelLineModel::GetSegmentPoints(vtkIdType segment, double start[3], double end[3]) const
{
  if (segment < 0 || segment >= this->GetNumberOfSegments())
  {
    vtkErrorMacro("Segment " << segment << " is outside the " << this->GetNumberOfSegments()
                             << " segments of the model.");
    std::fill_n(start, 3, 0.0);
    std::fill_n(end, 3, 0.0);
    return;
  }
  const vtkVoxelLineEncoding::Codec codec(this->FaceBins);
  if (codec.Encoding == Exact)
  {
    const float* floats = static_cast<const float*>(this->Segments->GetVoidPointer(6 * segment));
    std::copy_n(floats, 3, start);
    std::copy_n(floats + 3, 3, end);
    return;
  }
  const std::uint32_t* words = WordsOf(this->Segments) + codec.Words * segment;
  codec.Decode(codec.StartCode(words), start);
  codec.Decode(codec.EndCode(words), end);
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineModel::GetSegmentCurve(vtkIdType brick, vtkIdType segment) const
{
  const vtkIdType numberOfBricks = this->GetNumberOfBricks();
  const std::uint32_t* row =
    brick >= 0 && brick < numberOfBricks ? WordsOf(this->Bricks) + 5 * brick : nullptr;
  if (!row || segment < row[2] || segment >= row[5 + 2])
  {
    vtkErrorMacro("Brick " << brick << " of " << numberOfBricks << " does not have the segment "
                           << segment << ".");
    return -1;
  }
  const vtkVoxelLineEncoding::Codec codec(this->FaceBins);
  vtkIdType local = 0;
  if (codec.Encoding != Exact)
  {
    local = codec.Curve(WordsOf(this->Segments) + codec.Words * segment);
  }
  if (this->CurveIdExtension)
  {
    local |= static_cast<vtkIdType>(this->CurveIdExtension->GetComponent(segment, 0))
      << codec.CurveBits;
  }
  return WordsOf(this->BrickCurves)[row[4] + local];
}

//------------------------------------------------------------------------------
void vtkVoxelLineModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << " "
     << this->Dimensions[2] << "\n";
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n";
  os << indent << "VoxelSize: " << this->VoxelSize << "\n";
  os << indent << "FaceBins: " << this->FaceBins << "\n";
  os << indent << "AttributeKind: " << this->AttributeKind << "\n";
  os << indent << "AttributeRange: " << this->AttributeRange[0] << " " << this->AttributeRange[1]
     << "\n";
  os << indent << "HasNaNAttribute: " << (this->HasNaNAttribute ? "On" : "Off") << "\n";
  os << indent << "MaximumRadius: " << this->MaximumRadius << "\n";
  os << indent << "Bounds:";
  for (double bound : this->Bounds)
  {
    os << " " << bound;
  }
  os << "\n";
  os << indent << "Number of curves: " << this->GetNumberOfCurves() << "\n";
  os << indent << "Number of segments: " << this->GetNumberOfSegments() << "\n";
  os << indent << "Number of bricks: " << this->GetNumberOfBricks() << "\n";
  os << indent << "Number of occupied voxels: " << this->GetNumberOfOccupiedVoxels() << "\n";
  os << indent << "NumberOfDuplicates: " << this->NumberOfDuplicates << "\n";
  os << indent << "NumberOfCollapsedSegments: " << this->NumberOfCollapsedSegments << "\n";
  os << indent << "NumberOfDroppedCurves:";
  for (vtkIdType number : this->NumberOfDroppedCurves)
  {
    os << " " << number;
  }
  os << "\n";
  os << indent << "NumberOfDroppedPoints: " << this->NumberOfDroppedPoints << "\n";
  os << indent << "LargestDeviation: " << this->LargestDeviation << "\n";
  const char* parts[NumberOfParts] = { "segments", "attributes", "radii", "grid", "curves" };
  for (int part = 0; part < NumberOfParts; ++part)
  {
    os << indent << "Bytes of " << parts[part] << ": " << this->GetNumberOfBytes(part) << "\n";
  }
  struct
  {
    const char* Name;
    vtkDataArray* Array;
  } const arrays[] = { { "BrickGrid", this->BrickGrid }, { "Bricks", this->Bricks },
    { "VoxelStarts", this->VoxelStarts }, { "Segments", this->Segments },
    { "CurveIdExtension", this->CurveIdExtension }, { "BrickCurves", this->BrickCurves },
    { "CurveCells", this->CurveCells }, { "Attributes", this->Attributes },
    { "Radii", this->Radii } };
  for (const auto& entry : arrays)
  {
    os << indent << entry.Name << ": ";
    if (entry.Array)
    {
      os << entry.Array->GetNumberOfTuples() << " x " << entry.Array->GetNumberOfComponents() << " "
         << entry.Array->GetDataTypeAsString() << "\n";
    }
    else
    {
      os << "(none)\n";
    }
  }
}
