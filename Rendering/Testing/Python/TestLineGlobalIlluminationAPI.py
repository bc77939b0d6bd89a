# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards: shadows and ambient occlusion in Python: defaults, errors, sharing, and that they dim."""

from linesets import vtkLineGlobalIllumination, vtkVoxelLineMapper
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer, vtkRenderWindow

light = vtkLineGlobalIllumination()
assert light.IsA("vtkObject")
assert light.GetShadows() == vtkLineGlobalIllumination.NoShadows
assert light.GetShadowLevel() == 1 and light.GetShadowConeAngle() == 10.0
assert light.GetOcclusion() == vtkLineGlobalIllumination.NoOcclusion
assert light.GetOcclusionRadius() == 15.0 and light.GetOcclusionSamples() == 64
assert light.GetOcclusionStrength() == 1.0

# A value out of range is an error and changes nothing.
errors = []
light.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
for setter, value in (
    (light.SetShadows, 4),
    (light.SetShadowLevel, 0),
    (light.SetShadowConeAngle, 61.0),
    (light.SetOcclusion, -1),
    (light.SetOcclusionRadius, 0.5),
    (light.SetOcclusionSamples, 0),
    (light.SetOcclusionStrength, float("nan")),
):
    setter(value)
assert len(errors) == 7, errors
assert light.GetShadows() == 0 and light.GetOcclusionRadius() == 15.0

# Shared by mappers.
mapper, other = vtkVoxelLineMapper(), vtkVoxelLineMapper()
assert mapper.GetGlobalIllumination() is not other.GetGlobalIllumination()
mapper.SetGlobalIllumination(light)
other.ShallowCopy(mapper)
assert other.GetGlobalIllumination() is light
other.SetGlobalIllumination(None)
assert other.GetGlobalIllumination() is not light
time = mapper.GetMTime()
light.SetShadowsToHard()
assert light.GetShadows() == vtkLineGlobalIllumination.HardShadows and mapper.GetMTime() > time


def make_block(count=12):
    """Bars along x, next to each other in y and z."""
    points, lines = vtkPoints(), vtkCellArray()
    for i in range(count * count):
        lines.InsertNextCell(2)
        for x in (-1.0, 1.0):
            lines.InsertCellPoint(points.InsertNextPoint(x, 2.0 * (i % count) / count, 2.0 * (i // count) / count))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    return data


mapper.SetInputData(make_block())
mapper.SetResolution(24)
mapper.SetRadius(0.05)
actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddActor(actor)
lamp = vtkLight()
lamp.SetLightTypeToSceneLight()
lamp.SetPosition(1.0, 4.0, 6.0)
renderer.AddLight(lamp)
renderer.ResetCamera()
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(60, 60)
window.AddRenderer(renderer)


def brightness():
    window.Render()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, 59, 59, 0, pixels, 0)
    return sum(pixels.GetValue(i) for i in range(pixels.GetNumberOfValues()))


light.SetShadowsToNone()
plain = brightness()
assert plain > 0
for shadows in (light.SetShadowsToHard, light.SetShadowsToLevel, light.SetShadowsToSoft):
    shadows()
    assert 0 < brightness() < plain
light.SetShadowsToNone()
assert brightness() == plain
for occlusion in (light.SetOcclusionToSpherical, light.SetOcclusionToHemisphereDensity, light.SetOcclusionToHemisphereTubes):
    occlusion()
    assert 0 < brightness() < plain
light.SetOcclusionStrength(0.0)
assert brightness() == plain
