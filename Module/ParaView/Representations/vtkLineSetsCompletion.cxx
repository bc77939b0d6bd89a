// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsCompletion.h"

#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkLineSetsSpread.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPolyData.h"

#include <map>
#include <utility>

namespace
{
/// Name and association of an array; its components and type of values.
using Key = std::pair<std::string, int>;
using Kind = std::pair<int, int>;
using Arrays = std::map<Key, Kind>;

//------------------------------------------------------------------------------
Arrays FindArrays(vtkPolyData* lines, const std::vector<std::string>& names)
{
  Arrays arrays;
  for (const std::string& name : names)
  {
    for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      Kind kind;
      vtkLineSetsSpread::Describe(lines, name, association, kind.first, kind.second);
      if (kind.first > 0)
      {
        arrays[{ name, association }] = kind;
      }
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
void Write(const Arrays& arrays, vtkMultiProcessStream& stream)
{
  stream << static_cast<int>(arrays.size());
  for (const auto& array : arrays)
  {
    stream << array.first.first << array.first.second << array.second.first << array.second.second;
  }
}

//------------------------------------------------------------------------------
Arrays Read(vtkMultiProcessStream& stream)
{
  Arrays arrays;
  int size = 0;
  stream >> size;
  for (int i = 0; i < size; ++i)
  {
    Key key;
    Kind kind;
    stream >> key.first >> key.second >> kind.first >> kind.second;
    arrays[key] = kind;
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
vtkPolyData* vtkLineSetsCompletion::Complete(
  vtkPolyData* lines, const std::vector<std::string>& names, vtkMultiProcessController* controller)
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

  const Spreads partial = this->FindPartial(controller);
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
vtkLineSetsCompletion::Spreads vtkLineSetsCompletion::FindPartial(
  vtkMultiProcessController* controller) const
{
  vtkMultiProcessStream mine;
  mine << (this->Lines->GetNumberOfPoints() > 0 ? 1 : 0);
  Write(FindArrays(this->Lines, this->Names), mine);
  std::vector<vtkMultiProcessStream> streams;
  controller->AllGather(mine, streams);

  std::vector<Arrays> ranks;
  Arrays all;
  for (vtkMultiProcessStream& stream : streams)
  {
    int hasPoints = 0;
    stream >> hasPoints;
    if (hasPoints)
    {
      ranks.push_back(Read(stream));
      all.insert(ranks.back().begin(), ranks.back().end());
    }
  }
  Spreads partial;
  for (const auto& array : all)
  {
    vtkLineSetsSpread spread(array.first.first, array.first.second);
    for (const Arrays& rank : ranks)
    {
      const auto found = rank.find(array.first);
      const Kind kind = found == rank.end() ? Kind() : found->second;
      spread.Add(kind.first, kind.second);
    }
    // What is empty takes whatever there is.
    if (spread.IsPartial() || this->Lines->GetNumberOfPoints() == 0)
    {
      partial.push_back(spread);
    }
  }
  return partial;
}

//------------------------------------------------------------------------------
void vtkLineSetsCompletion::Release()
{
  *this = vtkLineSetsCompletion();
}
