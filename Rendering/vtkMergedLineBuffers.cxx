// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMergedLineBuffers.h"

#include "vtkLineMerging.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr std::size_t MostEntries = 4;
}

//------------------------------------------------------------------------------
vtkMergedLineBuffers::vtkMergedLineBuffers() = default;

//------------------------------------------------------------------------------
vtkMergedLineBuffers::~vtkMergedLineBuffers()
{
  this->ReleaseGraphicsResources();
}

//------------------------------------------------------------------------------
void vtkMergedLineBuffers::SetData(vtkPolyData* data)
{
  if (this->Data != data || this->DataTime != data->GetMTime())
  {
    this->ReleaseGraphicsResources();
    this->Data = data;
    this->DataTime = data->GetMTime();
  }
}

//------------------------------------------------------------------------------
double vtkMergedLineBuffers::GetLongestSegment(vtkPolyData* data)
{
  this->SetData(data);
  if (this->LongestSegment < 0.0)
  {
    this->LongestSegment = vtkLineMerging::GetLongestSegment(data);
  }
  return this->LongestSegment;
}

//------------------------------------------------------------------------------
vtkOpenGLIndexBufferObject* vtkMergedLineBuffers::Get(
  vtkOpenGLRenderWindow* window, vtkPolyData* data, double length, std::size_t allIndices)
{
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return nullptr;
  }
  this->SetData(data);
  const int level = static_cast<int>(std::floor(4.0 * std::log2(length)));
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [level](const Entry& entry) { return entry.Level == level; });
  if (found != this->Entries.end())
  {
    this->Entries.splice(this->Entries.begin(), this->Entries, found);
    return this->Entries.front().Buffer;
  }

  const std::vector<unsigned int> indices =
    vtkLineMerging::GetIndices(data, std::exp2(0.25 * level));
  this->Window = window;
  Entry entry{ level, nullptr };
  if (indices.size() * 10 < allIndices * 9)
  {
    entry.Buffer = vtkSmartPointer<vtkOpenGLIndexBufferObject>::New();
    entry.Buffer->Upload(indices, vtkOpenGLBufferObject::ElementArrayBuffer);
    entry.Buffer->IndexCount = indices.size();
  }
  this->Entries.push_front(entry);
  if (this->Entries.size() > MostEntries)
  {
    if (this->Entries.back().Buffer)
    {
      this->Entries.back().Buffer->ReleaseGraphicsResources();
    }
    this->Entries.pop_back();
  }
  return entry.Buffer;
}

//------------------------------------------------------------------------------
void vtkMergedLineBuffers::ReleaseGraphicsResources()
{
  if (this->Window)
  {
    this->Window->PushContext();
    for (Entry& entry : this->Entries)
    {
      if (entry.Buffer)
      {
        entry.Buffer->ReleaseGraphicsResources();
      }
    }
    this->Window->PopContext();
    this->Window = nullptr;
  }
  this->Entries.clear();
  this->Data = nullptr;
  this->DataTime = 0;
  this->LongestSegment = -1.0;
}
