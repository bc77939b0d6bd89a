// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsDistribution.h"

#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkLineSetsPieces.h"
#include "vtkLineSetsStretchPrivate.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Box = vtkLineSetsDistribution::Box;
using Parts = std::vector<vtkSmartPointer<vtkPolyData>>;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr int SizeTag = 73201;
constexpr int PartTag = 73202;

//------------------------------------------------------------------------------
bool IsEmpty(const Box& box)
{
  return box[0] > box[1] || box[2] > box[3] || box[4] > box[5];
}

//------------------------------------------------------------------------------
/// The box with a margin all around. Sums with infinite sides stay infinite.
Box Grow(const Box& box, double margin)
{
  Box grown = box;
  for (std::size_t side = 0; side < 6; ++side)
  {
    grown[side] += side % 2 == 0 ? -margin : margin;
  }
  return std::isfinite(margin) ? grown : vtkLineSetsDistribution::GetOpenBox();
}

//------------------------------------------------------------------------------
void SendPart(vtkMultiProcessController* controller, vtkPolyData* part, int to)
{
  vtkIdType size = part->GetNumberOfCells();
  controller->Send(&size, 1, to, SizeTag);
  if (size > 0)
  {
    controller->Send(part, to, PartTag);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReceivePart(vtkMultiProcessController* controller, int from)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkIdType size = 0;
  controller->Receive(&size, 1, from, SizeTag);
  if (size > 0)
  {
    controller->Receive(part, from, PartTag);
  }
  return part;
}

//------------------------------------------------------------------------------
/**
 * Sends each part to the process that it is for, and puts what came from a process in its place.
 * The processes meet in pairs as in a tournament: each round every process has one partner at most,
 * and the lower one speaks first, so that none waits for another in a circle.
 */
void Exchange(Parts& parts, vtkMultiProcessController* controller)
{
  const int me = controller->GetLocalProcessId();
  const int size = controller->GetNumberOfProcesses();
  const int players = size + size % 2;
  for (int round = 0; round < players - 1; ++round)
  {
    int partner = players - 1;
    if (me == players - 1)
    {
      // Who would meet itself in this round: 2 p = round modulo players - 1, which is odd.
      partner = round % 2 == 0 ? round / 2 : (round + players - 1) / 2;
    }
    else
    {
      partner = ((round - me) % (players - 1) + players - 1) % (players - 1);
      partner = partner == me ? players - 1 : partner;
    }
    if (partner >= size)
    {
      continue;
    }
    vtkSmartPointer<vtkPolyData>& part = parts[static_cast<std::size_t>(partner)];
    if (me < partner)
    {
      SendPart(controller, part, partner);
      part = ReceivePart(controller, partner);
    }
    else
    {
      vtkSmartPointer<vtkPolyData> received = ReceivePart(controller, partner);
      SendPart(controller, part, partner);
      part = received;
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Join(const Parts& parts)
{
  auto joined = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkAppendPolyData> append;
  for (const auto& part : parts)
  {
    if (part->GetNumberOfCells() > 0)
    {
      append->AddInputData(part);
    }
  }
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
    joined->ShallowCopy(append->GetOutput());
  }
  return joined;
}
}

//------------------------------------------------------------------------------
Box vtkLineSetsDistribution::GetOpenBox()
{
  return { -Infinity, Infinity, -Infinity, Infinity, -Infinity, Infinity };
}

//------------------------------------------------------------------------------
std::vector<Box> vtkLineSetsDistribution::OpenBoxes(const std::vector<vtkBoundingBox>& cuts)
{
  vtkBoundingBox all;
  for (const vtkBoundingBox& cut : cuts)
  {
    all.AddBox(cut);
  }
  Box outer;
  all.GetBounds(outer.data());
  std::vector<Box> boxes;
  for (const vtkBoundingBox& cut : cuts)
  {
    Box box = { Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity };
    if (cut.IsValid())
    {
      cut.GetBounds(box.data());
      for (std::size_t side = 0; side < 6; ++side)
      {
        const double open = side % 2 == 0 ? -Infinity : Infinity;
        box[side] = box[side] == outer[side] ? open : box[side];
      }
    }
    boxes.push_back(box);
  }
  return boxes;
}

//------------------------------------------------------------------------------
bool vtkLineSetsDistribution::IsChanged(vtkPolyData* lines) const
{
  return !this->Result || this->Lines != lines || this->LinesTime != lines->GetMTime();
}

//------------------------------------------------------------------------------
vtkPolyData* vtkLineSetsDistribution::Distribute(vtkPolyData* lines, bool isChanged,
  const std::vector<Box>& boxes, vtkMatrix4x4* matrix, double margin,
  vtkMultiProcessController* controller)
{
  std::array<double, 16> elements;
  std::copy_n(matrix->GetData(), 16, elements.begin());
  if (!isChanged && this->Result && boxes == this->Boxes && elements == this->Matrix &&
    margin == this->Margin)
  {
    return this->Result;
  }
  this->Lines = lines;
  this->LinesTime = lines->GetMTime();
  this->Boxes = boxes;
  this->Matrix = elements;
  this->Margin = margin;

  // In world coordinates, and some more for rounding.
  const double reach = 1.001 * margin * vtkLineSetsGetLargestStretch(matrix);
  const vtkLineSetsPieces pieces(lines, matrix, BlockSize);
  this->NumberOfInvalidCells = pieces.GetNumberOfInvalidCells();
  Parts parts;
  for (const Box& box : boxes)
  {
    parts.push_back(
      IsEmpty(box) ? vtkSmartPointer<vtkPolyData>::New() : pieces.Select(Grow(box, reach)));
  }
  Exchange(parts, controller);
  this->Result = Join(parts);
  return this->Result;
}

//------------------------------------------------------------------------------
void vtkLineSetsDistribution::Release()
{
  *this = vtkLineSetsDistribution();
}
