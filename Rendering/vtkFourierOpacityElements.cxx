// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityElements.h"

#include "vtkIntArray.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
bool AreSame(const vtkFourierOpacityGroup& a, const vtkFourierOpacityGroup& b)
{
  return a.Owner == b.Owner && a.BuildTime == b.BuildTime && a.Count == b.Count;
}
}

//------------------------------------------------------------------------------
vtkFourierOpacityElements::vtkFourierOpacityElements() = default;

//------------------------------------------------------------------------------
vtkFourierOpacityElements::~vtkFourierOpacityElements() = default;

//------------------------------------------------------------------------------
void vtkFourierOpacityElements::SetGroups(const std::vector<vtkFourierOpacityGroup>& groups)
{
  std::vector<std::unique_ptr<State>> states;
  this->Total = 0;
  for (const vtkFourierOpacityGroup& group : groups)
  {
    const auto isSame = [&group](const std::unique_ptr<State>& state)
    { return state && AreSame(state->Source, group); };
    auto found = std::find_if(this->States.begin(), this->States.end(), isSame);
    std::unique_ptr<State> state;
    if (found != this->States.end())
    {
      state = std::move(*found);
    }
    else
    {
      state = std::make_unique<State>();
      state->Source = group;
      state->Seen.assign(static_cast<std::size_t>(group.Count), 1.0f);
      state->Shown = state->Seen;
      state->WasSeen.assign(state->Seen.size(), 0);
      if (group.Neighbors && group.Neighbors->GetNumberOfTuples() > 0)
      {
        state->Smoothing = std::make_unique<vtkOpacitySmoothing>();
        state->Smoothing->SetNeighbors(static_cast<int>(group.Count), group.Neighbors);
      }
    }
    // Its array may go with the mapper's input.
    state->Source.Neighbors = nullptr;
    state->First = this->Total;
    this->Total += group.Count;
    states.push_back(std::move(state));
  }
  this->States = std::move(states);
  this->Shown.resize(static_cast<std::size_t>(this->Total));
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityElements::IsGroup(
  std::size_t group, const vtkFourierOpacityGroup& elements) const
{
  return group < this->States.size() && AreSame(this->States[group]->Source, elements);
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityElements::AreKnown() const
{
  return std::none_of(this->States.begin(), this->States.end(),
    [](const std::unique_ptr<State>& state) { return state->IsNew; });
}

//------------------------------------------------------------------------------
void vtkFourierOpacityElements::Update(
  const std::vector<float>& smallest, int shift, int iterations, double blend)
{
  std::vector<float> smooth;
  for (const std::unique_ptr<State>& state : this->States)
  {
    const vtkIdType first = state->First;
    const vtkIdType count = state->Source.Count;
    std::vector<float>& seen = state->Seen;
    vtkSMPTools::For(0, count,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const float value = smallest[static_cast<std::size_t>((first + i) >> shift)];
          seen[i] = value <= 1.0f ? value : seen[i];
          state->WasSeen[i] = value <= 1.0f ? 1 : state->WasSeen[i];
        }
      });
    if (state->Smoothing)
    {
      state->Smoothing->Fill(state->WasSeen, seen);
    }
    const bool smoothed = state->Smoothing && iterations > 0;
    if (smoothed)
    {
      state->Smoothing->Smooth(seen, iterations, smooth);
    }
    const std::vector<float>& target = smoothed ? smooth : seen;
    const float part = state->IsNew ? 1.0f : static_cast<float>(blend);
    state->IsNew = false;
    vtkSMPTools::For(0, count,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          float& shown = state->Shown[i];
          shown = part >= 1.0f ? target[i] : shown + part * (target[i] - shown);
          this->Shown[first + i] = shown;
        }
      });
  }
}
