// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the colours of lit lines: straight wide lines in many directions, at pixels where place,
// direction and lights are known exactly, against the double precision functions of
// vtkLineIllumination. All kinds of lights, views and models, exponents up to 1000 and per vertex,
// scaled and mirrored actors, given tangents.

#include "LineIlluminationTesting.h"
#include "VoxelLineMapperTesting.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLineIllumination.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLVertexBufferObject.h"

#include <functional>

using namespace VoxelLineMapperTesting;
using LineIlluminationTesting::Vector;

namespace
{
constexpr int Columns = 8;
constexpr int Rows = 6;
constexpr int CellSize = 30;
constexpr int Width = Columns * CellSize;
constexpr int Height = Rows * CellSize;

// In steps of 8 bits: half a one for rounding, and as much for the table (a quarter at most),
// single precision, and the rasterizer, which places line ends on a grid of 1/256 pixel.
constexpr double Tolerance = 1.0;

struct Line
{
  int Pixel[2];
  Vector Middle;  // on the ray through the pixel's middle, world coordinates
  Vector Tangent; // world coordinates
  double Power;   // below 0: the scene's
};

// A renderer of its own in the window of all.
struct Scene
{
  Stage& Shared;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkIlluminatedLineMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
  vtkLineIllumination* Illumination;
  std::vector<Line> Lines;
  bool VaryPower = false;
  bool GiveTangents = false;
  // Lines to which the mirrored light of AddDirectional() is near.
  bool IsAtHighlight = false;
  double Turn = 0.3;

  explicit Scene(Stage& stage)
    : Shared(stage)
    , Actor(vtkSmartPointer<vtkActor>::New())
  {
    this->Shared.Window->AddRenderer(this->Renderer);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Illumination = this->Mapper->GetIllumination();
    vtkProperty* property = this->Actor->GetProperty();
    property->SetLineWidth(5.0);
    property->SetAmbient(0.1);
    property->SetDiffuse(0.5);
    property->SetSpecular(0.4);
    property->SetSpecularPower(20.0);
    property->SetAmbientColor(0.3, 0.6, 1.0);
    property->SetDiffuseColor(1.0, 0.8, 0.5);
    property->SetSpecularColor(0.6, 1.0, 0.9);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(3.0, -4.0, 5.0);
    camera->SetFocalPoint(0.5, 0.2, -0.3);
    camera->SetViewUp(0.1, 1.0, 0.2);
    camera->SetViewAngle(40.0);
    camera->SetParallelScale(2.0);
    camera->SetClippingRange(0.5, 30.0);
    this->Renderer->RemoveAllLights();
    this->Renderer->AutomaticLightCreationOff();
  }

  ~Scene() { this->Shared.Window->RemoveRenderer(this->Renderer); }

  vtkLight* AddLight(const Vector& position, const Vector& focalPoint)
  {
    vtkNew<vtkLight> light;
    light->SetPosition(position.x, position.y, position.z);
    light->SetFocalPoint(focalPoint.x, focalPoint.y, focalPoint.z);
    this->Renderer->AddLight(light);
    return light;
  }

  Vector Unproject(const int pixel[2], double depth)
  {
    this->Renderer->SetDisplayPoint(pixel[0] + 0.5, pixel[1] + 0.5, depth);
    this->Renderer->DisplayToWorld();
    double* world = this->Renderer->GetWorldPoint();
    return Vector(world[0], world[1], world[2]) / world[3];
  }

  void MakeLines();
  Picture Draw();
};

// One line per cell of the window, about 20 pixels long.
void Scene::MakeLines()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vector axis(camera->GetDirectionOfProjection()[0], camera->GetDirectionOfProjection()[1],
    camera->GetDirectionOfProjection()[2]);
  const Vector eye(camera->GetPosition()[0], camera->GetPosition()[1], camera->GetPosition()[2]);
  for (int i = 0; i < Columns * Rows; ++i)
  {
    Line line;
    line.Pixel[0] = CellSize * (i % Columns) + CellSize / 2;
    line.Pixel[1] = CellSize * (i / Columns) + CellSize / 2;
    const Vector near = this->Unproject(line.Pixel, 0.0);
    const Vector far = this->Unproject(line.Pixel, 1.0);
    const double distance = 5.0 + 0.1 * (i % 7);
    const double s = (distance - glm::dot(near - eye, axis)) / glm::dot(far - near, axis);
    line.Middle = near + s * (far - near);
    line.Tangent = LineIlluminationTesting::GetDirection(i, Columns * Rows, this->Turn);
    if (this->IsAtHighlight)
    {
      const Vector view = glm::normalize(near - far);
      const Vector halfway = glm::normalize(view + glm::normalize(Vector(2.0, 1.0, 3.0)));
      const double along = 0.01 * (i % 8);
      line.Tangent -= halfway * glm::dot(line.Tangent, halfway);
      line.Tangent =
        glm::normalize(line.Tangent) * std::sqrt(1.0 - along * along) + halfway * along;
    }
    line.Power = this->VaryPower ? 3.0 + 5.0 * i : -1.0;
    this->Lines.push_back(line);
  }
}

Picture Scene::Draw()
{
  this->MakeLines();
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(this->Actor->GetMatrix(), inverse);
  std::vector<Curve> curves;
  vtkNew<vtkDoubleArray> powers;
  powers->SetName("power");
  vtkNew<vtkDoubleArray> tangents;
  tangents->SetName("tangent");
  tangents->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    const Line& line = this->Lines[i];
    // Where tangents are given, all lines run across the view.
    Vector direction(camera->GetViewUp()[0], camera->GetViewUp()[1], camera->GetViewUp()[2]);
    Vector view = this->Unproject(line.Pixel, 1.0) - this->Unproject(line.Pixel, 0.0);
    view = glm::normalize(view);
    if (!this->GiveTangents)
    {
      direction = line.Tangent;
    }
    const double sine = LineIlluminationTesting::GetSine(glm::normalize(direction), view);
    const double pixel = 4.0 / Height;
    direction = glm::normalize(direction) * (10.0 * pixel / sine);
    Curve curve;
    for (double s : { -1.0, 1.0 })
    {
      const Vector world = line.Middle + s * direction;
      double point[4] = { world.x, world.y, world.z, 1.0 };
      inverse->MultiplyPoint(point, point);
      curve.push_back({ point[0], point[1], point[2] });
      powers->InsertNextValue(line.Power * (1.0 + 0.5 * s));
      // Of any length and either sense.
      const double length = (i % 3 ? 7.0 : -0.2) * (s < 0.0 ? 1.0 : -1.0);
      double tangent[4] = { length * line.Tangent.x, length * line.Tangent.y,
        length * line.Tangent.z, 0.0 };
      inverse->MultiplyPoint(tangent, tangent);
      // Interpolated at the middle, unit vectors of one sense in data coordinates are as they are.
      tangents->InsertNextTuple(tangent);
    }
    curves.push_back(curve);
  }
  auto data = VoxelLineMapperTesting::MakeLines(curves);
  data->GetPointData()->AddArray(powers);
  data->GetPointData()->AddArray(tangents);
  this->Mapper->SetInputData(data);
  if (this->VaryPower)
  {
    this->Mapper->SetSpecularPowerArrayName("power");
  }
  if (this->GiveTangents)
  {
    this->Mapper->SetTangentArrayName("tangent");
  }
  return this->Shared.Render();
}

struct Arrival
{
  Vector ToLight;
  Vector Color;
  bool IsLoneHeadlight = false;
};

// What of a light arrives at a point, from VTK's documentation of vtkLight.
Arrival GetArrival(Scene& scene, vtkLight* light, const Vector& point)
{
  double p[3];
  double f[3];
  light->GetTransformedPosition(p);
  light->GetTransformedFocalPoint(f);
  const Vector position(p[0], p[1], p[2]);
  const Vector axis = glm::normalize(Vector(f[0], f[1], f[2]) - position);
  Arrival arrival;
  arrival.ToLight = -axis;
  const double* color = light->GetDiffuseColor();
  arrival.Color = light->GetIntensity() * Vector(color[0], color[1], color[2]);
  if (light->GetPositional())
  {
    const double distance = glm::length(point - position);
    arrival.ToLight = (position - point) / distance;
    const double* a = light->GetAttenuationValues();
    arrival.Color /= a[0] + a[1] * distance + a[2] * distance * distance;
    if (light->GetConeAngle() < 90.0)
    {
      const double cosine = glm::dot(-arrival.ToLight, axis);
      const bool isInside = cosine >= std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle()));
      arrival.Color *= isInside ? std::pow(cosine, light->GetExponent()) : 0.0;
    }
  }
  arrival.IsLoneHeadlight = light->LightTypeIsHeadlight() && !light->GetPositional() &&
    scene.Renderer->GetLights()->GetNumberOfItems() == 1;
  return arrival;
}

Vector GetExpected(Scene& scene, const Line& line)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double* d = camera->GetDirectionOfProjection();
  const double* e = camera->GetPosition();
  const Vector viewer = camera->GetParallelProjection()
    ? -Vector(d[0], d[1], d[2])
    : glm::normalize(Vector(e[0], e[1], e[2]) - line.Middle);
  vtkLineIllumination* model = scene.Illumination;
  vtkProperty* property = scene.Actor->GetProperty();
  const double ofModel = model->GetSpecularPower();
  const double power =
    line.Power >= 0.0 ? line.Power : (ofModel >= 0.0 ? ofModel : property->GetSpecularPower());
  Vector diffuse(0.0);
  Vector specular(0.0);
  vtkCollectionSimpleIterator iterator;
  scene.Renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* light = scene.Renderer->GetLights()->GetNextLight(iterator))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    const Arrival arrival = GetArrival(scene, light, line.Middle);
    const double* t = &line.Tangent.x;
    const double* v = &viewer.x;
    const double* l = &arrival.ToLight.x;
    double df = vtkLineIllumination::GetDiffuseTerm(t, v, l, model->GetModel());
    const bool byNormal =
      arrival.IsLoneHeadlight && model->GetReflection() == vtkLineIllumination::Phong;
    double sf = byNormal
      ? vtkLineIllumination::GetHeadlightSpecularTerm(t, v, l, power, model->GetModel())
      : vtkLineIllumination::GetSpecularTerm(
          t, v, l, power, model->GetModel(), model->GetReflection());
    if (model->GetStretchDynamicRange())
    {
      df /= vtkLineIllumination::GetDiffusePeak(model->GetModel());
      sf /= vtkLineIllumination::GetSpecularPeak(
        power, model->GetModel(), byNormal ? vtkLineIllumination::Blinn : model->GetReflection());
    }
    diffuse += df * arrival.Color;
    specular += sf * arrival.Color;
  }
  Vector color;
  for (int i = 0; i < 3; ++i)
  {
    color[i] = property->GetAmbient() * property->GetAmbientColor()[i] +
      property->GetDiffuse() * property->GetDiffuseColor()[i] * diffuse[i] +
      property->GetSpecular() * property->GetSpecularColor()[i] * specular[i];
    color[i] = 255.0 * std::min(1.0, color[i]);
  }
  return color;
}

void CheckColors(Checks& check, const std::string& name, const std::function<void(Scene&)>& change)
{
  static Stage stage(Width, Height);
  Scene scene(stage);
  change(scene);
  const Picture picture = scene.Draw();
  double worst = 0.0;
  double least = 255.0;
  double most = 0.0;
  for (const Line& line : scene.Lines)
  {
    const auto color = picture.At(line.Pixel[0], line.Pixel[1]);
    const Vector expected = GetExpected(scene, line);
    for (int i = 0; i < 3; ++i)
    {
      worst = std::max(worst, std::abs(color[i] - expected[i]));
      least = std::min(least, expected[i]);
      most = std::max(most, expected[i]);
    }
  }
  check(worst <= Tolerance, name + ": colours differ by " + std::to_string(worst));
  check(most > least + 20.0, name + ": there are several colours");
  std::cout << name << ": " << worst << " of colours from " << least << " to " << most << std::endl;
}

using Change = std::function<void(Scene&)>;

void AddDirectional(Scene& scene)
{
  scene.AddLight(Vector(2.0, 1.0, 3.0), Vector(0.0));
}

void AddSeveral(Scene& scene)
{
  AddDirectional(scene);
  vtkLight* red = scene.AddLight(Vector(-1.0, -5.0, 1.0), Vector(0.0, 0.0, 1.0));
  red->SetDiffuseColor(1.0, 0.2, 0.1);
  red->SetIntensity(0.7);
  vtkLight* lamp = scene.AddLight(Vector(0.6, -0.5, 2.0), Vector(0.5, 0.2, 0.0));
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  lamp->SetAttenuationValues(0.5, 0.3, 0.2);
  lamp->SetDiffuseColor(0.2, 0.9, 0.4);
  vtkLight* head = scene.AddLight(Vector(0.0, 0.0, 1.0), Vector(0.0));
  head->SetLightTypeToHeadlight();
  head->SetIntensity(0.4);
  vtkLight* camera = scene.AddLight(Vector(1.0, 1.0, 1.0), Vector(0.0));
  camera->SetLightTypeToCameraLight();
  camera->SetDiffuseColor(0.1, 0.3, 0.8);
}

const std::vector<std::pair<std::string, Change>>& GetLights()
{
  static const std::vector<std::pair<std::string, Change>> lights = { { "directional",
                                                                        AddDirectional },
    { "lone headlight",
      [](Scene& scene)
      { scene.AddLight(Vector(0.0, 0.0, 1.0), Vector(0.0))->SetLightTypeToHeadlight(); } },
    // VTK then no longer takes the highlight from the normal.
    { "headlight beside a light that is off",
      [](Scene& scene)
      {
        scene.AddLight(Vector(0.0, 0.0, 1.0), Vector(0.0))->SetLightTypeToHeadlight();
        scene.AddLight(Vector(1.0, 0.0, 1.0), Vector(0.0))->SwitchOff();
      } },
    { "positional",
      [](Scene& scene)
      {
        vtkLight* light = scene.AddLight(Vector(0.8, -0.2, 2.5), Vector(0.0));
        light->PositionalOn();
        light->SetConeAngle(90.0);
        light->SetAttenuationValues(0.3, 0.2, 0.1);
      } },
    { "spot",
      [](Scene& scene)
      {
        vtkLight* light = scene.AddLight(Vector(0.8, -0.2, 3.0), Vector(0.6, 0.1, 0.0));
        light->PositionalOn();
        light->SetConeAngle(30.0);
        light->SetExponent(3.0);
      } },
    { "several", AddSeveral } };
  return lights;
}

// Every light in both views by every model.
void CheckModels(Checks& check)
{
  for (const auto& [name, addLights] : GetLights())
  {
    for (int kind = 0; kind < 8; ++kind)
    {
      const bool isParallel = kind & 1;
      const bool isMaximum = kind & 2;
      const bool isBlinn = kind & 4;
      CheckColors(check,
        name + (isParallel ? ", parallel" : ", perspective") + (isMaximum ? ", maximum" : "") +
          (isBlinn ? ", Blinn" : ", Phong"),
        [&, addLights = addLights](Scene& scene)
        {
          addLights(scene);
          scene.Renderer->GetActiveCamera()->SetParallelProjection(isParallel);
          scene.Illumination->SetModel(isMaximum);
          scene.Illumination->SetReflection(isBlinn);
          scene.Turn = 0.3 + kind;
        });
    }
  }
}

void CheckPowers(Checks& check)
{
  for (double power : { 0.0, 1.0, 100.0, 500.0, 1000.0 })
  {
    for (bool isBlinn : { false, true })
    {
      for (bool isDirect : { false, true })
      {
        CheckColors(check,
          "exponent " + std::to_string(power) + (isBlinn ? ", Blinn" : "") +
            (isDirect ? ", without table" : ""),
          [&](Scene& scene)
          {
            AddDirectional(scene);
            scene.Illumination->SetSpecularPower(power);
            scene.Illumination->SetReflection(isBlinn);
            scene.Illumination->SetEvaluation(isDirect);
            scene.Illumination->StretchDynamicRangeOn();
            scene.IsAtHighlight = true;
          });
      }
    }
  }
  CheckColors(check, "exponents per vertex",
    [](Scene& scene)
    {
      AddDirectional(scene);
      scene.VaryPower = true;
      scene.IsAtHighlight = true;
    });
  CheckColors(check, "stretched, lone headlight",
    [](Scene& scene)
    {
      GetLights()[1].second(scene);
      scene.Illumination->StretchDynamicRangeOn();
    });
  CheckColors(check, "no specular term",
    [](Scene& scene)
    {
      AddSeveral(scene);
      scene.Actor->GetProperty()->SetSpecular(0.0);
    });
}

// Tangents are directions: scaled and mirrored with the data. Far from the origin they stay.
void CheckActors(Checks& check)
{
  const auto place = [](Scene& scene)
  {
    AddSeveral(scene);
    scene.Actor->SetScale(1.0, 3.0, -0.4);
    scene.Actor->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
    scene.Actor->SetPosition(0.3, -0.2, 0.5);
  };
  CheckColors(check, "scaled and mirrored", place);
  // Vertices scaled for the graphics device, by other factors along each axis.
  CheckColors(check, "scaled vertices",
    [&](Scene& scene)
    {
      place(scene);
      scene.Mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
    });
  CheckColors(check, "given tangents",
    [](Scene& scene)
    {
      AddDirectional(scene);
      scene.GiveTangents = true;
    });
  CheckColors(check, "far from the origin",
    [](Scene& scene)
    {
      AddDirectional(scene);
      scene.Actor->SetPosition(-1e9, 2e9, -1e9);
    });
}
}

int TestIlluminatedLineMapperShading(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckModels(check);
  CheckPowers(check);
  CheckActors(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
