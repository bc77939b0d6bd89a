// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineDensities.h"

#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineLevelsPrivate.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineSegmentsPrivate.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

vtkStandardNewMacro(vtkVoxelLineDensities);

namespace
{

constexpr int BrickSize = vtkVoxelLineModel::BrickSize;
constexpr vtkIdType VoxelsPerBrick = BrickSize * BrickSize * BrickSize;
constexpr vtkIdType BricksPerTask = 64;
/// Parts of the bricks after which progress is told.
constexpr vtkIdType NumberOfRounds = 8;
constexpr int NaNByte = 255;

/// Mean opacity of a segment by its attribute bytes, without the constant factor.
class OpacityOfSegments
{
public:
  OpacityOfSegments(vtkVoxelLineModel* model, const double* table, bool useColorOpacity)
    : Table(table)
    , HasNaN(model->GetHasNaNAttribute())
  {
    const unsigned char* bytes =
      model->GetAttributes() ? model->GetAttributes()->GetPointer(0) : nullptr;
    if (model->GetAttributeKind() == vtkVoxelLineModel::Color && useColorOpacity)
    {
      this->Colors = bytes;
    }
    else if (model->GetAttributeKind() == vtkVoxelLineModel::Scalar && table)
    {
      this->Scalars = bytes;
      this->Integral[0] = 0.0;
      for (std::size_t i = 1; i < this->Integral.size(); ++i)
      {
        this->Integral[i] = this->Integral[i - 1] + 0.5 * (table[i - 1] + table[i]);
      }
    }
  }

  double operator()(vtkIdType segment) const
  {
    if (this->Scalars)
    {
      return this->GetMean(this->Scalars[2 * segment], this->Scalars[2 * segment + 1]);
    }
    if (this->Colors)
    {
      return (this->Colors[8 * segment + 3] + this->Colors[8 * segment + 7]) / (2.0 * 255.0);
    }
    return 1.0;
  }

private:
  double GetMean(int start, int end) const
  {
    if (start == end)
    {
      return this->Table[start];
    }
    if (this->HasNaN && (start == NaNByte || end == NaNByte))
    {
      return 0.5 * (this->Table[start] + this->Table[end]);
    }
    return (this->Integral[static_cast<std::size_t>(end)] -
             this->Integral[static_cast<std::size_t>(start)]) /
      (end - start);
  }

  const double* Table;
  const bool HasNaN;
  const unsigned char* Scalars = nullptr;
  const unsigned char* Colors = nullptr;
  /// Of the table from its first entry to each.
  std::array<double, vtkVoxelLineDensities::TableSize> Integral{};
};

vtkIdType Product(const int dimensions[3])
{
  return static_cast<vtkIdType>(dimensions[0]) * dimensions[1] * dimensions[2];
}

}

//------------------------------------------------------------------------------
vtkVoxelLineDensities::vtkVoxelLineDensities() = default;

//------------------------------------------------------------------------------
vtkVoxelLineDensities::~vtkVoxelLineDensities() = default;

//------------------------------------------------------------------------------
void vtkVoxelLineDensities::SetOpacityTable(const double opacities[256])
{
  std::array<double, TableSize> table;
  int unusable = 0;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const bool isUsable = std::isfinite(opacities[i]);
    table[i] = isUsable ? opacities[i] : 0.0;
    unusable += !isUsable;
  }
  if (this->HasOpacityTable && table == this->OpacityTable)
  {
    return;
  }
  if (unusable > 0)
  {
    vtkWarningMacro(<< unusable << " of the 256 entries of the opacity table are not finite; they "
                    << "are taken as 0.");
  }
  this->OpacityTable = table;
  this->HasOpacityTable = true;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkVoxelLineDensities::RemoveOpacityTable()
{
  if (this->HasOpacityTable)
  {
    this->HasOpacityTable = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkVoxelLineDensities::GetTableOpacity(int byte) const
{
  return this->HasOpacityTable && byte >= 0 && byte < TableSize
    ? this->OpacityTable[static_cast<std::size_t>(byte)]
    : 1.0;
}

//------------------------------------------------------------------------------
void vtkVoxelLineDensities::Initialize()
{
  this->Model = nullptr;
  this->ModelTime = 0;
  std::fill_n(this->GridDimensions, 3, 0);
  this->BrickGrid = nullptr;
  this->Levels.clear();
}

//------------------------------------------------------------------------------
bool vtkVoxelLineDensities::Build(vtkVoxelLineModel* model)
{
  if (model && this->Model == model && this->ModelTime == model->GetMTime() &&
    this->BuildTime > this->GetMTime())
  {
    return true;
  }
  std::string error = model ? model->FindDefect() : std::string("There is no model.");
  if (error.empty() && !std::isfinite(this->Opacity))
  {
    error = "Opacity is " + std::to_string(this->Opacity) + "; it must be finite.";
  }
  this->AbortBuild = false;
  bool isBuilt = false;
  if (error.empty())
  {
    try
    {
      this->Allocate(model);
      isBuilt = this->SumSegments(model);
    }
    catch (const std::bad_alloc&)
    {
      error = "There is not enough memory for the densities; reduce the model's resolution.";
    }
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  if (!isBuilt)
  {
    this->Initialize();
    return false;
  }
  if (!this->Levels.empty())
  {
    this->AverageBricks(model);
    for (int level = 2; level < this->GetNumberOfLevels(); ++level)
    {
      this->AverageLevel(level);
    }
  }
  for (const vtkSmartPointer<vtkFloatArray>& level : this->Levels)
  {
    level->Modified();
  }
  this->Model = model;
  this->ModelTime = model->GetMTime();
  this->BuildTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkVoxelLineDensities::Allocate(vtkVoxelLineModel* model)
{
  const bool isEmpty = model->GetNumberOfSegments() == 0;
  const int none[3] = { 0, 0, 0 };
  std::copy_n(isEmpty ? none : model->GetDimensions(), 3, this->GridDimensions);
  this->BrickGrid = isEmpty ? nullptr : model->GetBrickGrid();
  const std::size_t size =
    static_cast<std::size_t>(vtkVoxelLineLevels::CountLevels(this->GridDimensions));
  this->Levels.resize(size);
  for (std::size_t level = 0; level < size; ++level)
  {
    if (!this->Levels[level])
    {
      this->Levels[level] = vtkSmartPointer<vtkFloatArray>::New();
      this->Levels[level]->SetName("Density");
    }
    int dimensions[3];
    this->GetDimensions(static_cast<int>(level), dimensions);
    this->Levels[level]->SetNumberOfValues(
      level == 0 ? VoxelsPerBrick * model->GetNumberOfBricks() : Product(dimensions));
  }
}

//------------------------------------------------------------------------------
bool vtkVoxelLineDensities::SumSegments(vtkVoxelLineModel* model)
{
  if (this->Levels.empty())
  {
    return true;
  }
  const vtkVoxelLineSegments::Reader reader(model);
  const OpacityOfSegments opacity(
    model, this->HasOpacityTable ? this->OpacityTable.data() : nullptr, this->UseColorOpacity);
  const unsigned char* radii =
    this->UseRadii && model->GetRadii() ? model->GetRadii()->GetPointer(0) : nullptr;
  float* values = this->Levels[0]->GetPointer(0);
  const vtkIdType numberOfBricks = reader.GetNumberOfBricks();
  for (vtkIdType round = 0; round < NumberOfRounds; ++round)
  {
    // Each voxel belongs to one brick, and its sum has one order: threads change nothing.
    vtkSMPTools::For(round * numberOfBricks / NumberOfRounds,
      (round + 1) * numberOfBricks / NumberOfRounds, BricksPerTask,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::fill(values + VoxelsPerBrick * begin, values + VoxelsPerBrick * end, 0.0f);
        for (vtkIdType brick = begin; brick < end; ++brick)
        {
          reader.VisitVoxels(brick,
            [&](const int voxel[3], vtkIdType first, vtkIdType last)
            {
              double sum = 0.0;
              for (vtkIdType i = first; i < last; ++i)
              {
                double start[3];
                double stop[3];
                reader.GetPoints(i, start, stop);
                const double width =
                  radii ? (radii[2 * i] + radii[2 * i + 1]) / (2.0 * 255.0) : 1.0;
                sum += opacity(i) * width * std::sqrt(vtkMath::Distance2BetweenPoints(start, stop));
              }
              const int bit = voxel[0] % BrickSize +
                BrickSize * (voxel[1] % BrickSize + BrickSize * (voxel[2] % BrickSize));
              values[VoxelsPerBrick * brick + bit] = static_cast<float>(this->Opacity * sum);
            });
        }
      });
    double progress = 0.9 * static_cast<double>(round + 1) / NumberOfRounds;
    this->InvokeEvent(vtkCommand::ProgressEvent, &progress);
    if (this->AbortBuild)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkVoxelLineDensities::AverageBricks(vtkVoxelLineModel* model)
{
  if (this->GetNumberOfLevels() < 2)
  {
    return;
  }
  int bricks[3];
  model->GetBrickDimensions(bricks);
  int dimensions[3];
  this->GetDimensions(1, dimensions);
  const int* grid = static_cast<const int*>(this->BrickGrid->GetVoidPointer(0));
  const float* source = this->Levels[0]->GetPointer(0);
  float* target = this->Levels[1]->GetPointer(0);
  // A row of level 1 lies in one row of bricks; a brick has two voxels along it.
  vtkSMPTools::For(0, static_cast<vtkIdType>(dimensions[1]) * dimensions[2], 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const vtkIdType y = row % dimensions[1];
        const vtkIdType z = row / dimensions[1];
        const int* cells = grid + bricks[0] * (y / 2 + bricks[1] * (z / 2));
        for (vtkIdType x = 0; x < dimensions[0]; ++x)
        {
          const int brick = cells[x / 2];
          double sum = 0.0;
          if (brick >= 0)
          {
            // Voxels of the brick beyond an odd grid are 0.
            const float* first =
              source + VoxelsPerBrick * brick + 2 * (x % 2) + 8 * (y % 2) + 32 * (z % 2);
            for (int child : { 0, 1, 4, 5, 16, 17, 20, 21 })
            {
              sum += first[child];
            }
          }
          target[row * dimensions[0] + x] = static_cast<float>(sum / 8.0);
        }
      }
    });
}

//------------------------------------------------------------------------------
void vtkVoxelLineDensities::AverageLevel(int level)
{
  int fine[3];
  int coarse[3];
  this->GetDimensions(level - 1, fine);
  this->GetDimensions(level, coarse);
  const float* source = this->GetValues(level - 1)->GetPointer(0);
  float* target = this->GetValues(level)->GetPointer(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(coarse[1]) * coarse[2], 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const int y = 2 * static_cast<int>(row % coarse[1]);
        const int z = 2 * static_cast<int>(row / coarse[1]);
        for (int x = 0; x < coarse[0]; ++x)
        {
          double sum = 0.0;
          for (int k = z; k < std::min(z + 2, fine[2]); ++k)
          {
            for (int j = y; j < std::min(y + 2, fine[1]); ++j)
            {
              const float* cells = source + fine[0] * (j + static_cast<vtkIdType>(fine[1]) * k);
              sum += cells[2 * x];
              sum += 2 * x + 1 < fine[0] ? cells[2 * x + 1] : 0.0f;
            }
          }
          target[row * coarse[0] + x] = static_cast<float>(sum / 8.0);
        }
      }
    });
}

//------------------------------------------------------------------------------
int vtkVoxelLineDensities::GetNumberOfLevels() const
{
  return static_cast<int>(this->Levels.size());
}

//------------------------------------------------------------------------------
void vtkVoxelLineDensities::GetDimensions(int level, int dimensions[3]) const
{
  const bool exists = level >= 0 && level < this->GetNumberOfLevels();
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] = exists ? vtkVoxelLineLevels::SizeOf(this->GridDimensions[axis], level) : 0;
  }
}

//------------------------------------------------------------------------------
vtkFloatArray* vtkVoxelLineDensities::GetValues(int level) const
{
  return level >= 0 && level < this->GetNumberOfLevels()
    ? this->Levels[static_cast<std::size_t>(level)].Get()
    : nullptr;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkVoxelLineDensities::GetBrickGrid() const
{
  return this->BrickGrid;
}

//------------------------------------------------------------------------------
float vtkVoxelLineDensities::GetVoxel(int level, int i, int j, int k) const
{
  int size[3];
  this->GetDimensions(level, size);
  if (i < 0 || j < 0 || k < 0 || i >= size[0] || j >= size[1] || k >= size[2])
  {
    return 0.0f;
  }
  const float* values = this->GetValues(level)->GetPointer(0);
  if (level > 0)
  {
    return values[i + size[0] * (j + static_cast<vtkIdType>(size[1]) * k)];
  }
  const vtkIdType bricks[2] = { (size[0] + BrickSize - 1) / BrickSize,
    (size[1] + BrickSize - 1) / BrickSize };
  const int brick = static_cast<const int*>(this->BrickGrid->GetVoidPointer(
    0))[i / BrickSize + bricks[0] * (j / BrickSize + bricks[1] * (k / BrickSize))];
  const int bit = i % BrickSize + BrickSize * (j % BrickSize + BrickSize * (k % BrickSize));
  return brick >= 0 ? values[VoxelsPerBrick * brick + bit] : 0.0f;
}

//------------------------------------------------------------------------------
double vtkVoxelLineDensities::GetDensity(int level, const double position[3]) const
{
  int size[3];
  this->GetDimensions(level, size);
  int low[3];
  double fraction[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double coordinate = std::ldexp(position[axis], -level) - 0.5;
    if (!(coordinate > -1.0 && coordinate < size[axis]))
    {
      return 0.0;
    }
    low[axis] = static_cast<int>(std::floor(coordinate));
    fraction[axis] = coordinate - low[axis];
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    int voxel[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int side = corner >> axis & 1;
      weight *= side == 1 ? fraction[axis] : 1.0 - fraction[axis];
      voxel[axis] = low[axis] + side;
    }
    sum += weight * this->GetVoxel(level, voxel[0], voxel[1], voxel[2]);
  }
  return sum;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineDensities::GetNumberOfBytes(int level) const
{
  vtkFloatArray* values = this->GetValues(level);
  return values ? values->GetNumberOfValues() * static_cast<vtkIdType>(sizeof(float)) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineDensities::GetNumberOfBytes() const
{
  vtkIdType bytes = 0;
  for (int level = 0; level < this->GetNumberOfLevels(); ++level)
  {
    bytes += this->GetNumberOfBytes(level);
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkVoxelLineDensities::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "HasOpacityTable: " << (this->HasOpacityTable ? "On" : "Off") << "\n";
  os << indent << "UseColorOpacity: " << (this->UseColorOpacity ? "On" : "Off") << "\n";
  os << indent << "UseRadii: " << (this->UseRadii ? "On" : "Off") << "\n";
  os << indent << "AbortBuild: " << (this->AbortBuild ? "On" : "Off") << "\n";
  os << indent << "Model: " << this->Model.Get() << "\n";
  os << indent << "BuildTime: " << this->BuildTime.GetMTime() << "\n";
  os << indent << "BrickGrid: " << this->BrickGrid.Get() << "\n";
  os << indent << "Number of levels: " << this->GetNumberOfLevels() << "\n";
  for (int level = 0; level < this->GetNumberOfLevels(); ++level)
  {
    int dimensions[3];
    this->GetDimensions(level, dimensions);
    os << indent << "Level " << level << ": " << dimensions[0] << " x " << dimensions[1] << " x "
       << dimensions[2] << ", " << this->GetNumberOfBytes(level) << " bytes\n";
  }
}
