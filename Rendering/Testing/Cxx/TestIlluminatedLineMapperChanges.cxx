// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that what is not to be lit is drawn as vtkPolyDataMapper draws it, that flags and arrays
// which govern VTK's own light make no difference, that nothing is uploaded anew without need, and
// that neither the frame before nor another renderer or window leaves a trace.

#include "IlluminatedLineTesting.h"
#include "vtkFloatArray.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"

#include <functional>

using namespace IlluminatedLineTesting;

namespace
{
// The flags of vtkProperty and arrays that would disturb VTK's own light on lines.
void CheckUndisturbed(Checks& check)
{
  auto lines = MakeCross();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 5; ++i)
  {
    normals->InsertNextTuple3(0.0, -0.6, -0.8);
  }
  Scene scene(lines);
  for (bool hasNormals : { false, true })
  {
    lines->GetPointData()->SetNormals(hasNormals ? normals.Get() : nullptr);
    for (int interpolation : { VTK_FLAT, VTK_GOURAUD, VTK_PHONG, VTK_PBR })
    {
      for (int representation : { VTK_SURFACE, VTK_WIREFRAME })
      {
        scene.Actor->GetProperty()->SetInterpolation(interpolation);
        scene.Actor->GetProperty()->SetRepresentation(representation);
        CheckCross(check,
          "interpolation " + std::to_string(interpolation) + (hasNormals ? ", normals" : ""),
          scene.Render());
      }
    }
  }
}

// The same picture as that of vtkPolyDataMapper.
void CheckAsPlain(
  Checks& check, const std::string& name, const std::function<void(Scene&, vtkActor*)>& change)
{
  auto data = MakeCross();
  Picture pictures[2];
  for (int plain : { 0, 1 })
  {
    Scene scene(data);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    if (plain)
    {
      scene.Actor->SetMapper(mapper);
    }
    change(scene, scene.Actor);
    pictures[plain] = scene.Render();
  }
  const Difference difference = Compare(pictures[0], pictures[1]);
  check(difference.Largest == 0 && GetCoverage(pictures[0], Background) > 0.0001,
    name + " as vtkPolyDataMapper" + Describe(difference));
}

void CheckNotLit(Checks& check)
{
  CheckAsPlain(
    check, "lighting off", [](Scene&, vtkActor* actor) { actor->GetProperty()->LightingOff(); });
  CheckAsPlain(check, "no light",
    [](Scene& scene, vtkActor*)
    {
      scene.Renderer->RemoveAllLights();
      scene.Renderer->AutomaticLightCreationOff();
    });
  CheckAsPlain(
    check, "tubes", [](Scene&, vtkActor* actor) { actor->GetProperty()->RenderLinesAsTubesOn(); });
  CheckAsPlain(check, "points",
    [](Scene&, vtkActor* actor) { actor->GetProperty()->SetRepresentationToPoints(); });

  // Other cells of the same data set.
  auto data = MakeCross();
  data->GetPoints()->InsertNextPoint(-0.8, 0.8, 0.0);
  data->GetPoints()->InsertNextPoint(-0.2, 0.8, 0.0);
  data->GetPoints()->InsertNextPoint(-0.2, 0.3, 0.0);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 5, 6, 7 });
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 1 });
  for (int representation : { VTK_SURFACE, VTK_WIREFRAME })
  {
    Picture pictures[3];
    for (int kind : { 0, 1, 2 })
    {
      // 0: lines alone, 1: all, 2: all but the lines by vtkPolyDataMapper.
      vtkNew<vtkPolyData> part;
      part->SetPoints(data->GetPoints());
      part->SetLines(kind == 2 ? vtkNew<vtkCellArray>().Get() : data->GetLines());
      if (kind > 0)
      {
        part->SetPolys(polys);
        part->SetVerts(verts);
      }
      Scene scene(part);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(part);
      if (kind == 2)
      {
        scene.Actor->SetMapper(mapper);
      }
      scene.Actor->GetProperty()->SetRepresentation(representation);
      scene.Actor->GetProperty()->SetPointSize(13.0);
      pictures[kind] = scene.Render();
    }
    bool isSum = true;
    for (int y = 0; y < 200; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        const auto all = pictures[1].At(x, y);
        const auto others = pictures[2].At(x, y);
        isSum &= all == others || (all == pictures[0].At(x, y));
        isSum &= all != Background || (others == Background && pictures[0].At(x, y) == Background);
      }
    }
    check(isSum && GetCoverage(pictures[2], Background) > 0.01,
      "other cells are drawn as vtkPolyDataMapper draws them");
  }
}

// Nothing is computed or uploaded anew but for the input and its arrays.
void CheckUploads(Checks& check)
{
  Scene scene;
  scene.Render();
  const auto getTime = [&]
  { return scene.Mapper->GetVBOs()->GetVBO("lineTangentMC")->GetUploadTime().GetMTime(); };
  vtkMTimeType time = getTime();
  scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  scene.Actor->RotateZ(1.0);
  scene.Actor->GetProperty()->SetSpecular(0.3);
  scene.Mapper->GetIllumination()->SetSpecularPower(300.0);
  scene.Mapper->ScalarVisibilityOff();
  vtkNew<vtkLight> light;
  scene.Renderer->AddLight(light);
  scene.Render();
  check(getTime() == time, "no upload for camera, actor, property, model and lights");
  scene.Mapper->GetInput()->Modified();
  scene.Render();
  check(getTime() > time, "an upload for a changed input");
}

// What the frame before was drawn with must not matter.
void CheckChanges(Checks& check)
{
  Scene scene;
  CheckCross(check, "at first", scene.Render());
  scene.Actor->GetProperty()->LightingOff();
  scene.Render();
  scene.Actor->GetProperty()->LightingOn();
  CheckCross(check, "lighting on again", scene.Render());
  const vtkMTimeType time = scene.Mapper->GetMTime();
  scene.Mapper->GetIllumination()->SetModelToMaximumReflection();
  check(scene.Mapper->GetMTime() > time, "the mapper changes with its model");
  CheckPixel(check, "maximum reflection", scene.Render(), Upright,
    { static_cast<int>(std::lround(255 * 0.925)), 118, 59 });
  scene.Mapper->SetIllumination(nullptr);
  CheckCross(check, "the default model again", scene.Render());

  // One mapper in two viewports under different lights, and in another window.
  vtkNew<vtkRenderer> other;
  vtkNew<vtkLight> light;
  light->SetPosition(0.0, 0.0, 1.0);
  light->SetIntensity(0.5);
  other->AddLight(light);
  vtkNew<vtkLight> lamp;
  lamp->SetPosition(0.0, 0.0, 1.0);
  lamp->SetIntensity(0.25);
  other->AddLight(lamp);
  other->AddActor(scene.Actor);
  other->SetActiveCamera(scene.Renderer->GetActiveCamera());
  other->SetBackground(scene.Renderer->GetBackground());
  scene.Window->SetSize(400, 200);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene.Window->AddRenderer(other);
  for (int frame = 0; frame < 2; ++frame)
  {
    const Picture picture = scene.Render();
    CheckCross(check, "left viewport", picture);
    const double across = 0.125 + 0.75 * std::atan(1.0);
    const int place[2] = { 200 + Upright[0], Upright[1] };
    CheckPixel(check, "right viewport", picture, place,
      { static_cast<int>(std::lround(255 * across)), static_cast<int>(std::lround(127.5 * across)),
        static_cast<int>(std::lround(63.75 * across)) });
  }
  Scene second;
  second.Actor->SetMapper(scene.Mapper);
  CheckCross(check, "second window", second.Render());
  CheckCross(check, "first window again", scene.Render());
  second.Actor->SetMapper(nullptr);
  second.Renderer->RemoveAllViewProps();
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  CheckCross(check, "after release", scene.Render());

  vtkNew<vtkIlluminatedLineMapper> copy;
  scene.Mapper->GetIllumination()->StretchDynamicRangeOn();
  scene.Mapper->SetTangentArrayName("t");
  scene.Mapper->SetSpecularPowerArrayName("p");
  copy->ShallowCopy(scene.Mapper);
  check(copy->GetIllumination() == scene.Mapper->GetIllumination() &&
      copy->GetTangentArrayName() == "t" && copy->GetSpecularPowerArrayName() == "p" &&
      copy->GetInput() == scene.Mapper->GetInput(),
    "a shallow copy has all");
  std::ostringstream text;
  copy->Print(text);
  for (const char* name : { "TangentArrayName: t", "SpecularPowerArrayName: p", "Illumination:" })
  {
    check(text.str().find(name) != std::string::npos, std::string("printed: ") + name);
  }
}
}

int TestIlluminatedLineMapperChanges(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckUndisturbed(check);
  CheckNotLit(check);
  CheckUploads(check);
  CheckChanges(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
