// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineModelBuilderPrivate.h"

#include "vtkFloatArray.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeUInt16Array.h"
#include "vtkTypeUInt32Array.h"
#include "vtkTypeUInt8Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineDistancePrivate.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace vtkLineVoxelizerPrivate
{

namespace
{

constexpr std::size_t VoxelsPerBrick = 64;
constexpr vtkIdType BricksPerTask = 64;
constexpr int WordsPerRow = 5;
constexpr vtkIdType SegmentsPerTask = 8192;
/// Emission indices that share an entry of the table that tells their curves.
constexpr std::size_t EmissionsPerEntry = 64;

template <typename T>
void CopyTo(const std::vector<T>& source, T* target)
{
  std::copy(source.begin(), source.end(), target);
}

template <typename T>
void Release(std::vector<T>& values)
{
  std::vector<T>().swap(values);
}

template <typename ArrayT>
vtkSmartPointer<ArrayT> MakeArray(int components, std::size_t tuples)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

/// How many values are equal to another one before them. Sorts the values.
template <typename T>
std::int64_t CountRepetitions(std::vector<T>& values)
{
  std::sort(values.begin(), values.end());
  return values.end() - std::unique(values.begin(), values.end());
}

/// Call worker(cell, first, size) for each run of segments in the same cell: curves are coherent,
/// so that this saves most of the atomic operations.
template <typename WorkerT>
void ForEachRun(const std::uint32_t* cells, vtkIdType begin, vtkIdType end, WorkerT&& worker)
{
  while (begin < end)
  {
    vtkIdType last = begin + 1;
    while (last < end && cells[last] == cells[begin])
    {
      ++last;
    }
    worker(
      cells[begin], static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(last - begin));
    begin = last;
  }
}

}

/// What a task has of its bricks until the sizes of all are known.
struct ModelBuilder::Assembly
{
  std::vector<std::uint32_t> VoxelStarts;
  std::vector<std::uint32_t> Curves;
  std::int64_t NumberOfDuplicates = 0;
  std::uint32_t LargestBrickCurves = 0;
};

/// The arrays of the model that the bricks are written to. Those that it lacks are null.
struct ModelBuilder::Target
{
  std::uint32_t* Rows = nullptr;
  std::uint32_t* Words = nullptr;
  std::uint8_t* Attributes = nullptr;
  std::uint8_t* Radii = nullptr;
};

/// Writes the segments of one brick after the other to their final place.
class ModelBuilder::BrickWriter
{
public:
  void Write(ModelBuilder& builder, std::size_t brick, Assembly& assembly, const Target& target);

private:
  void ListCurves(const ModelBuilder& builder, Assembly& assembly);
  /// Returns the occupancy mask.
  std::uint64_t FindVoxels(const ModelBuilder& builder, Assembly& assembly);
  void PlaceSegments(const ModelBuilder& builder, std::uint32_t* order, const Target& target);
  std::int64_t CountDuplicates(
    const vtkVoxelLineEncoding::Codec& codec, const std::uint32_t* words, std::size_t size);

  /// Emission indices of the brick's segments in ascending order, the local ids of their curves,
  /// and their voxels.
  std::vector<std::uint32_t> Emissions;
  std::vector<std::uint32_t> LocalIds;
  std::vector<std::uint8_t> VoxelBits;
  /// First segment of each voxel, occupied or not, and the number of segments.
  std::array<std::uint32_t, VoxelsPerBrick + 1> VoxelStarts{};
  std::vector<std::uint64_t> Keys;
  std::vector<std::array<std::uint32_t, 6>> ExactKeys;
};

//------------------------------------------------------------------------------
ModelBuilder::ModelBuilder(const Grid& grid, int faceBins, const Payload& payload)
  : Cells(grid)
  , Codec(faceBins)
  , Values(payload)
  , Layout(this->Codec, payload)
{
}

//------------------------------------------------------------------------------
void ModelBuilder::TakeSegments(std::vector<Trace>& blocks)
{
  std::vector<std::size_t> starts(1, 0);
  for (const Trace& block : blocks)
  {
    for (std::uint32_t size : block.CurveSizes)
    {
      this->CurveStarts.push_back(static_cast<std::uint32_t>(this->NumberOfSegments));
      this->NumberOfSegments += size;
    }
    starts.push_back(this->NumberOfSegments);
  }
  this->CurveStarts.push_back(static_cast<std::uint32_t>(this->NumberOfSegments));
  for (std::size_t curve = 0; curve + 1 < this->CurveStarts.size(); ++curve)
  {
    while (this->FirstCurves.size() * EmissionsPerEntry < this->CurveStarts[curve + 1])
    {
      this->FirstCurves.push_back(static_cast<std::uint32_t>(curve));
    }
  }

  const std::size_t stride = this->Layout.Stride;
  this->SegmentCells.Allocate(this->NumberOfSegments);
  this->Records.Allocate(stride * this->NumberOfSegments);
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        Trace& block = blocks[i];
        CopyTo(block.Cells, this->SegmentCells.Get(starts[i]));
        CopyTo(block.Records, this->Records.Get(stride * starts[i]));
        block = Trace();
      }
    });
  Release(blocks);
}

//------------------------------------------------------------------------------
void ModelBuilder::SortIntoBricks()
{
  const int* bricks = this->Cells.BrickDimensions;
  const std::size_t numberOfCells = static_cast<std::size_t>(bricks[0]) *
    static_cast<std::size_t>(bricks[1]) * static_cast<std::size_t>(bricks[2]);
  const vtkIdType numberOfSegments = static_cast<vtkIdType>(this->NumberOfSegments);
  const std::uint32_t* cells = this->SegmentCells.Get();
  // Counts first, cursors later.
  std::unique_ptr<std::atomic<std::uint32_t>[]> cursors(
    new std::atomic<std::uint32_t>[numberOfCells]());
  vtkSMPTools::For(0, numberOfSegments, SegmentsPerTask,
    [&](vtkIdType begin, vtkIdType end)
    {
      ForEachRun(cells, begin, end,
        [&](std::uint32_t cell, std::uint32_t, std::uint32_t size)
        { cursors[cell].fetch_add(size, std::memory_order_relaxed); });
    });

  std::uint32_t start = 0;
  for (std::size_t cell = 0; cell < numberOfCells; ++cell)
  {
    const std::uint32_t size = cursors[cell].load(std::memory_order_relaxed);
    if (size > 0)
    {
      this->BrickCells.push_back(static_cast<std::uint32_t>(cell));
      this->BrickStarts.push_back(start);
      cursors[cell].store(start, std::memory_order_relaxed);
      start += size;
    }
  }
  this->BrickStarts.push_back(start);

  this->Order.Allocate(this->NumberOfSegments);
  vtkSMPTools::For(0, numberOfSegments, SegmentsPerTask,
    [&](vtkIdType begin, vtkIdType end)
    {
      ForEachRun(cells, begin, end,
        [&](std::uint32_t cell, std::uint32_t first, std::uint32_t size)
        {
          std::uint32_t* target =
            this->Order.Get(cursors[cell].fetch_add(size, std::memory_order_relaxed));
          for (std::uint32_t i = 0; i < size; ++i)
          {
            target[i] = first + i;
          }
        });
    });
  this->SegmentCells.Free();
}

//------------------------------------------------------------------------------
void ModelBuilder::BrickWriter::ListCurves(const ModelBuilder& builder, Assembly& assembly)
{
  const std::vector<std::uint32_t>& starts = builder.CurveStarts;
  this->LocalIds.resize(this->Emissions.size());
  std::uint32_t size = 0;
  std::uint32_t curveEnd = 0;
  for (std::size_t i = 0; i < this->Emissions.size(); ++i)
  {
    // Curves own consecutive emission indices, and these ascend here: one search for each curve.
    if (this->Emissions[i] >= curveEnd)
    {
      std::uint32_t curve = builder.FirstCurves[this->Emissions[i] / EmissionsPerEntry];
      while (starts[curve + 1] <= this->Emissions[i])
      {
        ++curve;
      }
      assembly.Curves.push_back(curve);
      curveEnd = starts[curve + 1];
      ++size;
    }
    this->LocalIds[i] = size - 1;
  }
  assembly.LargestBrickCurves = std::max(assembly.LargestBrickCurves, size);
}

//------------------------------------------------------------------------------
std::int64_t ModelBuilder::BrickWriter::CountDuplicates(
  const vtkVoxelLineEncoding::Codec& codec, const std::uint32_t* words, std::size_t size)
{
  // A key is the same for both directions of a segment.
  if (codec.FaceBins == 0)
  {
    this->ExactKeys.resize(size);
    for (std::array<std::uint32_t, 6>& key : this->ExactKeys)
    {
      const bool isSwapped = std::lexicographical_compare(words + 3, words + 6, words, words + 3);
      std::copy_n(words + (isSwapped ? 3 : 0), 3, key.begin());
      std::copy_n(words + (isSwapped ? 0 : 3), 3, key.begin() + 3);
      words += codec.Words;
    }
    return CountRepetitions(this->ExactKeys);
  }
  this->Keys.resize(size);
  for (std::uint64_t& key : this->Keys)
  {
    const std::uint64_t start = codec.StartCode(words);
    const std::uint64_t end = codec.EndCode(words);
    key = start < end ? start << 32 | end : end << 32 | start;
    words += codec.Words;
  }
  return CountRepetitions(this->Keys);
}

//------------------------------------------------------------------------------
std::uint64_t ModelBuilder::BrickWriter::FindVoxels(const ModelBuilder& builder, Assembly& assembly)
{
  const RecordLayout& layout = builder.Layout;
  this->VoxelStarts.fill(0);
  this->VoxelBits.resize(this->Emissions.size());
  for (std::size_t i = 0; i < this->Emissions.size(); ++i)
  {
    this->VoxelBits[i] =
      layout.GetVoxelBit(builder.Records.Get(layout.Stride * this->Emissions[i]));
    ++this->VoxelStarts[this->VoxelBits[i] + 1u];
  }
  std::uint64_t mask = 0;
  for (std::size_t voxel = 0; voxel < VoxelsPerBrick; ++voxel)
  {
    if (this->VoxelStarts[voxel + 1] > 0)
    {
      mask |= std::uint64_t(1) << voxel;
      assembly.VoxelStarts.push_back(this->VoxelStarts[voxel]);
    }
    this->VoxelStarts[voxel + 1] += this->VoxelStarts[voxel];
  }
  assembly.VoxelStarts.push_back(this->VoxelStarts[VoxelsPerBrick]);
  return mask;
}

//------------------------------------------------------------------------------
void ModelBuilder::BrickWriter::PlaceSegments(
  const ModelBuilder& builder, std::uint32_t* order, const Target& target)
{
  const RecordLayout& layout = builder.Layout;
  std::array<std::uint32_t, VoxelsPerBrick + 1> cursors = this->VoxelStarts;
  for (std::size_t i = 0; i < this->Emissions.size(); ++i)
  {
    const std::uint32_t* record = builder.Records.Get(layout.Stride * this->Emissions[i]);
    const std::uint8_t* bytes = layout.GetBytes(record);
    const std::size_t place = cursors[this->VoxelBits[i]]++;
    std::copy_n(record, layout.Words, target.Words + layout.Words * place);
    builder.Codec.PackCurve(this->LocalIds[i], target.Words + layout.Words * place);
    order[place] = this->LocalIds[i];
    if (layout.AttributeBytes > 0)
    {
      std::copy_n(bytes, layout.AttributeBytes, target.Attributes + layout.AttributeBytes * place);
    }
    if (layout.RadiusBytes > 0)
    {
      std::copy_n(bytes + layout.AttributeBytes, layout.RadiusBytes,
        target.Radii + layout.RadiusBytes * place);
    }
  }
}

//------------------------------------------------------------------------------
void ModelBuilder::BrickWriter::Write(
  ModelBuilder& builder, std::size_t brick, Assembly& assembly, const Target& target)
{
  const std::uint32_t first = builder.BrickStarts[brick];
  std::uint32_t* order = builder.Order.Get(first);
  this->Emissions.assign(order, builder.Order.Get(builder.BrickStarts[brick + 1]));
  std::sort(this->Emissions.begin(), this->Emissions.end());

  std::uint32_t* row = target.Rows + WordsPerRow * brick;
  row[2] = first;
  row[3] = static_cast<std::uint32_t>(assembly.VoxelStarts.size());
  row[4] = static_cast<std::uint32_t>(assembly.Curves.size());
  this->ListCurves(builder, assembly);
  const std::uint64_t mask = this->FindVoxels(builder, assembly);
  row[0] = static_cast<std::uint32_t>(mask);
  row[1] = static_cast<std::uint32_t>(mask >> 32);

  const RecordLayout& layout = builder.Layout;
  Target here = target;
  here.Words += layout.Words * first;
  here.Attributes += layout.AttributeBytes * first;
  here.Radii += layout.RadiusBytes * first;
  this->PlaceSegments(builder, order, here);
  for (std::size_t voxel = 0; voxel < VoxelsPerBrick; ++voxel)
  {
    const std::size_t start = this->VoxelStarts[voxel];
    const std::size_t size = this->VoxelStarts[voxel + 1] - start;
    if (size > 1)
    {
      assembly.NumberOfDuplicates +=
        this->CountDuplicates(builder.Codec, here.Words + layout.Words * start, size);
    }
  }
}

//------------------------------------------------------------------------------
ModelBuilder::Target ModelBuilder::MakeArrays(vtkVoxelLineModel* model) const
{
  Target target;
  if (this->Codec.FaceBins == 0)
  {
    model->SetSegments(MakeArray<vtkFloatArray>(this->Codec.Words, this->NumberOfSegments));
  }
  else
  {
    model->SetSegments(MakeArray<vtkTypeUInt32Array>(this->Codec.Words, this->NumberOfSegments));
  }
  target.Words = static_cast<std::uint32_t*>(model->GetSegments()->GetVoidPointer(0));
  if (this->Values.AttributeSize > 0)
  {
    model->SetAttributes(
      MakeArray<vtkUnsignedCharArray>(2 * this->Values.AttributeSize, this->NumberOfSegments));
    target.Attributes = model->GetAttributes()->GetPointer(0);
  }
  if (this->Values.HasRadii)
  {
    model->SetRadii(MakeArray<vtkUnsignedCharArray>(2, this->NumberOfSegments));
    target.Radii = model->GetRadii()->GetPointer(0);
  }
  model->SetBricks(MakeArray<vtkTypeUInt32Array>(WordsPerRow, this->NumberOfBricks() + 1));
  target.Rows = static_cast<std::uint32_t*>(model->GetBricks()->GetVoidPointer(0));
  return target;
}

//------------------------------------------------------------------------------
void ModelBuilder::AssembleBricks(vtkVoxelLineModel* model)
{
  const Target target = this->MakeArrays(model);
  const vtkIdType numberOfBricks = static_cast<vtkIdType>(this->NumberOfBricks());
  const vtkIdType numberOfTasks = (numberOfBricks + BricksPerTask - 1) / BricksPerTask;
  std::vector<Assembly> assemblies(static_cast<std::size_t>(numberOfTasks));
  vtkSMPThreadLocal<BrickWriter> writers;
  vtkSMPTools::For(0, numberOfTasks, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      BrickWriter& writer = writers.Local();
      for (vtkIdType task = begin; task < end; ++task)
      {
        const vtkIdType last = std::min((task + 1) * BricksPerTask, numberOfBricks);
        for (vtkIdType brick = task * BricksPerTask; brick < last; ++brick)
        {
          writer.Write(*this, static_cast<std::size_t>(brick),
            assemblies[static_cast<std::size_t>(task)], target);
        }
      }
    });
  this->Records.Free();
  this->JoinBricks(model, assemblies);
}

//------------------------------------------------------------------------------
void ModelBuilder::JoinBricks(vtkVoxelLineModel* model, std::vector<Assembly>& assemblies)
{
  std::uint32_t* rows = static_cast<std::uint32_t*>(model->GetBricks()->GetVoidPointer(0));
  std::size_t voxelStarts = 0;
  std::size_t curves = 0;
  std::uint32_t largestBrickCurves = 0;
  std::int64_t duplicates = 0;
  for (std::size_t task = 0; task < assemblies.size(); ++task)
  {
    const std::size_t first = task * static_cast<std::size_t>(BricksPerTask);
    const std::size_t last =
      std::min(first + static_cast<std::size_t>(BricksPerTask), this->NumberOfBricks());
    for (std::size_t brick = first; brick < last; ++brick)
    {
      rows[WordsPerRow * brick + 3] += static_cast<std::uint32_t>(voxelStarts);
      rows[WordsPerRow * brick + 4] += static_cast<std::uint32_t>(curves);
    }
    voxelStarts += assemblies[task].VoxelStarts.size();
    curves += assemblies[task].Curves.size();
    largestBrickCurves = std::max(largestBrickCurves, assemblies[task].LargestBrickCurves);
    duplicates += assemblies[task].NumberOfDuplicates;
  }
  std::uint32_t* closing = rows + WordsPerRow * this->NumberOfBricks();
  closing[0] = 0;
  closing[1] = 0;
  closing[2] = static_cast<std::uint32_t>(this->NumberOfSegments);
  closing[3] = static_cast<std::uint32_t>(voxelStarts);
  closing[4] = static_cast<std::uint32_t>(curves);
  model->SetNumberOfDuplicates(duplicates);

  auto brickCurves = MakeArray<vtkTypeUInt32Array>(1, curves);
  std::uint32_t* target = brickCurves->GetPointer(0);
  for (const Assembly& assembly : assemblies)
  {
    target = std::copy(assembly.Curves.begin(), assembly.Curves.end(), target);
  }
  model->SetBrickCurves(brickCurves);

  std::uint32_t largestBrick = 0;
  for (std::size_t brick = 0; brick < this->NumberOfBricks(); ++brick)
  {
    largestBrick = std::max(largestBrick, this->BrickStarts[brick + 1] - this->BrickStarts[brick]);
  }
  if (largestBrick <= VTK_UNSIGNED_SHORT_MAX)
  {
    this->JoinVoxelStarts<vtkTypeUInt16Array>(model, assemblies);
  }
  else
  {
    this->JoinVoxelStarts<vtkTypeUInt32Array>(model, assemblies);
  }
  Release(assemblies);
  this->MakeCurveIdExtension(model, largestBrickCurves);
  this->Order.Free();
}

//------------------------------------------------------------------------------
template <typename ArrayT>
void ModelBuilder::JoinVoxelStarts(
  vtkVoxelLineModel* model, const std::vector<Assembly>& assemblies) const
{
  std::size_t size = 0;
  for (const Assembly& assembly : assemblies)
  {
    size += assembly.VoxelStarts.size();
  }
  auto starts = MakeArray<ArrayT>(1, size);
  auto* target = starts->GetPointer(0);
  for (const Assembly& assembly : assemblies)
  {
    for (std::uint32_t start : assembly.VoxelStarts)
    {
      *target++ = static_cast<typename ArrayT::ValueType>(start);
    }
  }
  model->SetVoxelStarts(starts);
}

//------------------------------------------------------------------------------
void ModelBuilder::MakeCurveIdExtension(vtkVoxelLineModel* model, std::uint32_t largestBrickCurves)
{
  const std::uint32_t largest = (largestBrickCurves - 1) >> this->Codec.CurveBits;
  if (largest == 0)
  {
    return;
  }
  vtkSmartPointer<vtkDataArray> extension;
  if (largest <= VTK_UNSIGNED_CHAR_MAX)
  {
    extension = MakeArray<vtkTypeUInt8Array>(1, this->NumberOfSegments);
  }
  else if (largest <= VTK_UNSIGNED_SHORT_MAX)
  {
    extension = MakeArray<vtkTypeUInt16Array>(1, this->NumberOfSegments);
  }
  else
  {
    extension = MakeArray<vtkTypeUInt32Array>(1, this->NumberOfSegments);
  }
  void* target = extension->GetVoidPointer(0);
  const int width = extension->GetDataTypeSize();
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->NumberOfSegments), SegmentsPerTask,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const std::uint32_t bits = this->Order[i] >> this->Codec.CurveBits;
        switch (width)
        {
          case 1:
            static_cast<std::uint8_t*>(target)[i] = static_cast<std::uint8_t>(bits);
            break;
          case 2:
            static_cast<std::uint16_t*>(target)[i] = static_cast<std::uint16_t>(bits);
            break;
          default:
            static_cast<std::uint32_t*>(target)[i] = bits;
            break;
        }
      }
    });
  model->SetCurveIdExtension(extension);
}

//------------------------------------------------------------------------------
void ModelBuilder::MakeBrickGrid(vtkVoxelLineModel* model)
{
  const int* bricks = this->Cells.BrickDimensions;
  const std::size_t numberOfCells = static_cast<std::size_t>(bricks[0]) *
    static_cast<std::size_t>(bricks[1]) * static_cast<std::size_t>(bricks[2]);
  std::vector<std::uint8_t> distances(numberOfCells, 255);
  for (std::uint32_t cell : this->BrickCells)
  {
    distances[cell] = 0;
  }
  vtkVoxelLineDistance::Transform(distances, bricks, vtkVoxelLineModel::LargestBrickDistance);
  auto grid = MakeArray<vtkTypeInt32Array>(1, numberOfCells);
  std::int32_t* target = grid->GetPointer(0);
  std::transform(distances.begin(), distances.end(), target,
    [](std::uint8_t distance) { return -static_cast<std::int32_t>(distance); });
  for (std::size_t brick = 0; brick < this->BrickCells.size(); ++brick)
  {
    target[this->BrickCells[brick]] = static_cast<std::int32_t>(brick);
  }
  model->SetBrickGrid(grid);
}

}
