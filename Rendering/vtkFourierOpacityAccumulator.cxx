// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityAccumulator.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <cstdint>

namespace
{
// Modification times and addresses are whole numbers below 2^53.
template <typename T>
double ToNumber(T value)
{
  return static_cast<double>(value);
}

void AddMatrix(vtkMatrix4x4* matrix, std::vector<double>& key)
{
  key.insert(key.end(), matrix->GetData(), matrix->GetData() + 16);
}
}

//------------------------------------------------------------------------------
int vtkFourierOpacityAccumulator::Begin(vtkRenderer* renderer, vtkObject* settings, int largest)
{
  std::vector<double> key;
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  key.insert(key.end(),
    { ToNumber(size[0]), ToNumber(size[1]), ToNumber(origin[0]), ToNumber(origin[1]),
      ToNumber(settings->GetMTime()) });
  vtkCamera* camera = renderer->GetActiveCamera();
  AddMatrix(camera->GetModelViewTransformMatrix(), key);
  AddMatrix(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0), key);
  // Halos have the colour of the background.
  key.insert(key.end(), renderer->GetBackground(), renderer->GetBackground() + 3);
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    key.push_back(ToNumber(reinterpret_cast<std::uintptr_t>(prop)));
    key.push_back(ToNumber(prop->GetRedrawMTime()));
  }
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    // A headlight is moved along in each frame; where it is follows from the camera.
    key.push_back(ToNumber(light->GetSwitch()));
    key.push_back(ToNumber(light->GetPositional()));
    key.push_back(light->GetIntensity());
    key.push_back(light->GetConeAngle());
    key.push_back(light->GetExponent());
    for (const double* three :
      { light->GetAmbientColor(), light->GetDiffuseColor(), light->GetSpecularColor(),
        light->GetAttenuationValues(), light->GetPosition(), light->GetFocalPoint() })
    {
      key.insert(key.end(), three, three + 3);
    }
  }
  if (key != this->Key)
  {
    this->Key = key;
    this->Number = 0;
  }
  this->Number = this->Number > largest ? 0 : this->Number;
  return this->Number;
}
