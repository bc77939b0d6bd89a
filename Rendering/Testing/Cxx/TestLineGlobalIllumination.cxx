// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the parameters of vtkLineGlobalIllumination: defaults, ranges, what setters do with values
 * out of range, what PrintSelf tells; and that vtkVoxelLineMapper takes part in its changes, shares
 * it with copies, and makes a new one for nullptr.
 */

#include "VoxelLineMapperTesting.h"
#include "vtkLineGlobalIllumination.h"

#include <functional>
#include <limits>

namespace
{
using VoxelLineMapperTesting::Checks;
using VoxelLineMapperTesting::Messages;
using Light = vtkLineGlobalIllumination;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// A parameter with its ends and values beyond them.
struct Parameter
{
  std::string Name;
  std::function<void(Light*, double)> Set;
  std::function<double(Light*)> Get;
  double Default;
  double Lowest;
  double Highest;
  std::vector<double> Invalid;
};

template <typename T>
Parameter Describe(const std::string& name, void (Light::*set)(T), T (Light::*get)(),
  double standard, double lowest, double highest, const std::vector<double>& invalid)
{
  return { name, [set](Light* light, double value) { (light->*set)(static_cast<T>(value)); },
    [get](Light* light) { return static_cast<double>((light->*get)()); }, standard, lowest, highest,
    invalid };
}

std::vector<Parameter> MakeParameters()
{
  return { Describe("Shadows", &Light::SetShadows, &Light::GetShadows, Light::NoShadows,
             Light::NoShadows, Light::SoftShadows, { -1.0, 4.0 }),
    Describe("ShadowLevel", &Light::SetShadowLevel, &Light::GetShadowLevel, 1.0, 1.0, 12.0,
      { 0.0, 13.0, -1.0 }),
    Describe("ShadowConeAngle", &Light::SetShadowConeAngle, &Light::GetShadowConeAngle, 10.0, 0.0,
      60.0, { -1e-9, 60.001, NaN, Infinity }),
    Describe("Occlusion", &Light::SetOcclusion, &Light::GetOcclusion, Light::NoOcclusion,
      Light::NoOcclusion, Light::HemisphereTubes, { -1.0, 4.0 }),
    Describe("OcclusionRadius", &Light::SetOcclusionRadius, &Light::GetOcclusionRadius, 15.0, 1.0,
      4096.0, { 0.999, 4096.5, NaN, -Infinity }),
    Describe("OcclusionSamples", &Light::SetOcclusionSamples, &Light::GetOcclusionSamples, 64.0,
      1.0, 10000.0, { 0.0, 10001.0, -5.0 }),
    Describe("OcclusionStrength", &Light::SetOcclusionStrength, &Light::GetOcclusionStrength, 1.0,
      0.0, 10.0, { -0.001, 10.01, NaN, Infinity }) };
}

void CheckParameters(Checks& check, Messages* messages)
{
  for (const Parameter& parameter : MakeParameters())
  {
    vtkNew<Light> light;
    const std::string& name = parameter.Name;
    check(parameter.Get(light) == parameter.Default, name + ": default");
    for (const double value : { parameter.Highest, parameter.Lowest })
    {
      const vtkMTimeType time = light->GetMTime();
      const bool changes = parameter.Get(light) != value;
      parameter.Set(light, value);
      check(messages->IsQuiet() && parameter.Get(light) == value, name + ": ends of the range");
      check((light->GetMTime() > time) == changes, name + ": a change is told, once");
    }
    parameter.Set(light, parameter.Highest);
    const vtkMTimeType time = light->GetMTime();
    parameter.Set(light, parameter.Highest);
    check(light->GetMTime() == time, name + ": the same value is no change");
    for (const double value : parameter.Invalid)
    {
      parameter.Set(light, value);
      check(
        messages->TakeErrors(name + " ") == 1, name + ": an error for " + std::to_string(value));
      check(parameter.Get(light) == parameter.Highest && light->GetMTime() == time,
        name + ": a value out of range changes nothing");
    }
    parameter.Set(light, parameter.Invalid[0]);
    check(messages->TakeErrors("it must be from") == 1, name + ": the range is told");
  }
}

void CheckNames(Checks& check)
{
  vtkNew<Light> light;
  const auto shadows = [&](void (Light::*set)(), int type)
  {
    (light.Get()->*set)();
    check(light->GetShadows() == type, "kind of shadows " + std::to_string(type));
  };
  shadows(&Light::SetShadowsToSoft, Light::SoftShadows);
  shadows(&Light::SetShadowsToLevel, Light::LevelShadows);
  shadows(&Light::SetShadowsToHard, Light::HardShadows);
  shadows(&Light::SetShadowsToNone, Light::NoShadows);
  const auto occlusion = [&](void (Light::*set)(), int type)
  {
    (light.Get()->*set)();
    check(light->GetOcclusion() == type, "kind of occlusion " + std::to_string(type));
  };
  occlusion(&Light::SetOcclusionToHemisphereTubes, Light::HemisphereTubes);
  occlusion(&Light::SetOcclusionToHemisphereDensity, Light::HemisphereDensity);
  occlusion(&Light::SetOcclusionToSpherical, Light::SphericalOcclusion);
  occlusion(&Light::SetOcclusionToNone, Light::NoOcclusion);

  light->SetShadowsToSoft();
  light->SetShadowLevel(3);
  light->SetShadowConeAngle(21.5);
  light->SetOcclusionToSpherical();
  light->SetOcclusionRadius(9.5);
  light->SetOcclusionSamples(77);
  light->SetOcclusionStrength(1.25);
  std::ostringstream os;
  light->Print(os);
  for (const char* text : { "Shadows: SoftShadows", "ShadowLevel: 3", "ShadowConeAngle: 21.5",
         "Occlusion: SphericalOcclusion", "OcclusionRadius: 9.5", "OcclusionSamples: 77",
         "OcclusionStrength: 1.25" })
  {
    check(os.str().find(text) != std::string::npos, std::string("Print tells ") + text);
  }
}

void CheckMapper(Checks& check)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  Light* own = mapper->GetGlobalIllumination();
  check(own && own->GetShadows() == Light::NoShadows && own->GetOcclusion() == Light::NoOcclusion,
    "a mapper has one of its own, by which there is nothing");
  vtkMTimeType time = mapper->GetMTime();
  own->SetShadowsToHard();
  check(mapper->GetMTime() > time, "its changes are changes of the mapper");

  vtkNew<Light> shared;
  time = mapper->GetMTime();
  mapper->SetGlobalIllumination(shared);
  check(mapper->GetGlobalIllumination() == shared && mapper->GetMTime() > time, "another one");
  time = mapper->GetMTime();
  mapper->SetGlobalIllumination(shared);
  check(mapper->GetMTime() == time, "the same one is no change");

  vtkNew<vtkVoxelLineMapper> copy;
  copy->ShallowCopy(mapper);
  check(copy->GetGlobalIllumination() == shared, "copies share it");
  time = copy->GetMTime();
  shared->SetOcclusionRadius(3.0);
  check(copy->GetMTime() > time && mapper->GetMTime() > time, "changes reach all who share it");

  time = mapper->GetMTime();
  mapper->SetGlobalIllumination(nullptr);
  Light* fresh = mapper->GetGlobalIllumination();
  check(fresh && fresh != shared && fresh->GetOcclusionRadius() == 15.0 &&
      mapper->GetMTime() > time && copy->GetGlobalIllumination() == shared,
    "nullptr brings one with defaults");
  std::ostringstream os;
  copy->Print(os);
  check(os.str().find("GlobalIllumination:") != std::string::npos &&
      os.str().find("OcclusionRadius: 3") != std::string::npos,
    "Print of the mapper tells it");
}
}

int TestLineGlobalIllumination(int, char*[])
{
  Checks check;
  auto messages = VoxelLineMapperTesting::Listen();
  CheckParameters(check, messages);
  CheckNames(check);
  CheckMapper(check);
  check(messages->IsQuiet(), "nothing else is said");
  return check.GetResult();
}
