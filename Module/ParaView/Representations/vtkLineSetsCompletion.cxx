// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsCompletion.h"

#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace
{
using Identity = vtkLineSetsSpread::Identity;

//------------------------------------------------------------------------------
void Write(const std::set<Identity>& arrays, vtkMultiProcessStream& stream)
{
  stream << static_cast<int>(arrays.size());
  for (const Identity& array : arrays)
  {
    stream << array.first << array.second;
  }
}

//------------------------------------------------------------------------------
std::set<Identity> Read(vtkMultiProcessStream& stream)
{
  std::set<Identity> arrays;
  int size = 0;
  stream >> size;
  for (int i = 0; i < size; ++i)
  {
    Identity array;
    stream >> array.first >> array.second;
    arrays.insert(array);
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
vtkPolyData* vtkLineSetsCompletion::Complete(vtkPolyData* lines,
  const std::vector<std::string>& names, const std::set<Identity>& leftOut,
  vtkMultiProcessController* controller)
{
  const bool isSame = this->Result && this->Lines == lines && this->LinesTime == lines->GetMTime();
  const int mine = isSame && this->Names == names ? 0 : 1;
  int any = 0;
  controller->AllReduce(&mine, &any, 1, vtkCommunicator::MAX_OP);
  if (any == 0)
  {
    return this->Result;
  }
  this->Lines = lines;
  this->LinesTime = lines->GetMTime();
  this->Names = names;

  std::set<Identity> allLeftOut = leftOut;
  const std::vector<Arrays> ranks = this->Gather(allLeftOut, controller);
  const Spreads partial = this->FindPartial(ranks, allLeftOut);
  this->LeftOut.clear();
  if (controller->GetLocalProcessId() == 0)
  {
    this->LeftOut = std::move(allLeftOut);
  }
  std::vector<std::string> changes;
  this->Warnings.clear();
  for (const vtkLineSetsSpread& spread : partial)
  {
    changes.push_back(spread.GetKey());
    if (spread.GetMissing() > 0 && controller->GetLocalProcessId() == 0)
    {
      this->Warnings.push_back(spread.GetWarning("ranks that have lines"));
    }
  }
  if (isSame && changes == this->Changes)
  {
    // What was built of it stays.
    return this->Result;
  }
  this->Changes = std::move(changes);
  this->Result = lines;
  if (!partial.empty())
  {
    this->Result = vtkSmartPointer<vtkPolyData>::New();
    this->Result->ShallowCopy(lines);
    for (const vtkLineSetsSpread& spread : partial)
    {
      spread.Apply(this->Result);
    }
  }
  return this->Result;
}

//------------------------------------------------------------------------------
std::vector<vtkLineSetsCompletion::Arrays> vtkLineSetsCompletion::Gather(
  std::set<Identity>& leftOut, vtkMultiProcessController* controller) const
{
  vtkMultiProcessStream mine;
  Write(leftOut, mine);
  mine << (this->Lines->GetNumberOfPoints() > 0 ? 1 : 0);
  const std::set<Identity> arrays = vtkLineSetsSpread::FindArrays(this->Lines);
  Write(arrays, mine);
  for (const Identity& array : arrays)
  {
    int components = 0;
    int type = 0;
    vtkLineSetsSpread::Describe(this->Lines, array.first, array.second, components, type);
    mine << components << type;
  }
  std::vector<vtkMultiProcessStream> streams;
  controller->AllGather(mine, streams);

  std::vector<Arrays> ranks;
  for (vtkMultiProcessStream& stream : streams)
  {
    leftOut.merge(Read(stream));
    int hasPoints = 0;
    stream >> hasPoints;
    Arrays found;
    for (const Identity& array : Read(stream))
    {
      stream >> found[array].first >> found[array].second;
    }
    if (hasPoints)
    {
      ranks.push_back(std::move(found));
    }
  }
  return ranks;
}

//------------------------------------------------------------------------------
vtkLineSetsCompletion::Spreads vtkLineSetsCompletion::FindPartial(
  const std::vector<Arrays>& ranks, std::set<Identity>& leftOut) const
{
  Arrays all;
  for (const Arrays& rank : ranks)
  {
    all.insert(rank.begin(), rank.end());
  }
  Spreads partial;
  for (const auto& array : all)
  {
    const Identity& identity = array.first;
    const bool isInUse =
      std::find(this->Names.begin(), this->Names.end(), identity.first) != this->Names.end();
    vtkLineSetsSpread spread(identity.first, identity.second);
    bool isEverywhere = true;
    bool hasNumbers = false;
    for (const Arrays& rank : ranks)
    {
      const auto found = rank.find(identity);
      const std::pair<int, int> kind = found == rank.end() ? std::make_pair(0, 0) : found->second;
      spread.Add(kind.first, kind.second);
      isEverywhere = isEverywhere && found != rank.end();
      hasNumbers = hasNumbers || kind.first > 0;
    }
    // What is empty takes whatever there is.
    const bool isTaken = hasNumbers && this->Lines->GetNumberOfPoints() == 0;
    if (isInUse && (spread.IsPartial() || isTaken))
    {
      partial.push_back(spread);
    }
    else if (spread.IsPartial() || !isEverywhere)
    {
      leftOut.insert(identity);
    }
  }
  return partial;
}

//------------------------------------------------------------------------------
void vtkLineSetsCompletion::Release()
{
  *this = vtkLineSetsCompletion();
}
