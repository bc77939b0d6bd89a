# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards: lit lines in Python: defaults, names of arrays, the light model, drawing."""

from linesets import vtkIlluminatedLineMapper, vtkLineIllumination
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

mapper = vtkIlluminatedLineMapper()
assert isinstance(mapper, vtkPolyDataMapper)

# Defaults, as the documentation tells them.
assert mapper.GetTangentArrayName() == "" and mapper.GetSpecularPowerArrayName() == ""
own = mapper.GetIllumination()
assert own.GetModel() == vtkLineIllumination.CylinderAveraging
assert own.GetSpecularPower() == -1.0

# A model may be shared; None brings one of its own back; the mapper changes with its model.
other = vtkIlluminatedLineMapper()
other.SetIllumination(own)
assert other.GetIllumination() is own
time = mapper.GetMTime()
own.SetModelToMaximumReflection()
assert mapper.GetMTime() > time and other.GetMTime() > time
other.SetIllumination(None)
assert other.GetIllumination() is not own
assert other.GetIllumination().GetModel() == vtkLineIllumination.CylinderAveraging

time = mapper.GetMTime()
mapper.SetTangentArrayName("t")
mapper.SetSpecularPowerArrayName("p")
assert mapper.GetMTime() > time
other.ShallowCopy(mapper)
assert other.GetTangentArrayName() == "t" and other.GetSpecularPowerArrayName() == "p"
assert other.GetIllumination() is own
mapper.SetTangentArrayName("")
mapper.SetSpecularPowerArrayName("")

# A line across the view, lit from the viewer by a light in the scene: pi / 4 of the colour by
# averaging, all of it by maximum reflection.
points, lines = vtkPoints(), vtkCellArray()
lines.InsertNextCell(2)
for x in (-1.0, 1.0):
    lines.InsertCellPoint(points.InsertNextPoint(x, 0.0, 0.0))
data = vtkPolyData()
data.SetPoints(points)
data.SetLines(lines)
mapper.SetInputData(data)
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetLineWidth(9.0)
renderer = vtkRenderer()
renderer.AddActor(actor)
light = vtkLight()
light.SetPosition(0.0, 0.0, 1.0)
renderer.AddLight(light)
camera = renderer.GetActiveCamera()
camera.ParallelProjectionOn()
camera.SetPosition(0.0, 0.0, 5.0)
camera.SetParallelScale(1.0)
camera.SetClippingRange(1.0, 10.0)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(100, 100)
window.AddRenderer(renderer)


def read_pixel():
    window.Render()
    bytes_ = vtkUnsignedCharArray()
    window.GetPixelData(50, 50, 50, 50, 0, bytes_, 0)
    return bytes_.GetValue(0)


assert read_pixel() == 255
own.SetModelToCylinderAveraging()
assert abs(read_pixel() - 255 * 3.14159265 / 4) <= 1
assert abs(vtkLineIllumination.GetDiffuseTerm((1, 0, 0), (0, 0, 1), (0, 0, 1), own.GetModel()) - 3.14159265 / 4) < 1e-6
