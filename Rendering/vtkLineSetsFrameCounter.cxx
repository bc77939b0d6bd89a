// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsFrameCounter.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkLineSetsFrameCounter::vtkLineSetsFrameCounter() = default;

//------------------------------------------------------------------------------
vtkLineSetsFrameCounter::~vtkLineSetsFrameCounter()
{
  for (const auto& entry : this->Entries)
  {
    if (entry->Renderer)
    {
      entry->Renderer->RemoveObserver(entry->StartTag);
      entry->Renderer->RemoveObserver(entry->EndTag);
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkLineSetsFrameCounter::GetFrame(vtkRenderer* renderer)
{
  return this->GetEntry(renderer).Frame;
}

//------------------------------------------------------------------------------
bool vtkLineSetsFrameCounter::IsInFrame(vtkRenderer* renderer)
{
  return this->GetEntry(renderer).InFrame;
}

//------------------------------------------------------------------------------
vtkLineSetsFrameCounter::Entry& vtkLineSetsFrameCounter::GetEntry(vtkRenderer* renderer)
{
  const auto gone = [](const std::unique_ptr<Entry>& entry) { return !entry->Renderer; };
  this->Entries.erase(
    std::remove_if(this->Entries.begin(), this->Entries.end(), gone), this->Entries.end());
  for (const auto& entry : this->Entries)
  {
    if (entry->Renderer == renderer)
    {
      return *entry;
    }
  }

  auto entry = std::make_unique<Entry>();
  entry->Renderer = renderer;
  entry->Next = &this->Next;
  entry->Frame = ++this->Next;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(entry.get());
  command->SetCallback(
    [](vtkObject*, unsigned long event, void* data, void*)
    {
      auto* self = static_cast<Entry*>(data);
      self->InFrame = event == vtkCommand::StartEvent;
      if (self->InFrame)
      {
        self->Frame = ++*self->Next;
      }
    });
  entry->StartTag = renderer->AddObserver(vtkCommand::StartEvent, command);
  entry->EndTag = renderer->AddObserver(vtkCommand::EndEvent, command);
  this->Entries.push_back(std::move(entry));
  return *this->Entries.back();
}
