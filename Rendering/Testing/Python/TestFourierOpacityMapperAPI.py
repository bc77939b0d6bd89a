# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards: opacity optimization in Python: defaults, enumerations, sharing, copies, drawing."""

from linesets import vtkFourierOpacityMapper, vtkIlluminatedLineMapper, vtkOpacityOptimization
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow

mapper = vtkFourierOpacityMapper()
assert isinstance(mapper, vtkIlluminatedLineMapper)

# Defaults, as the documentation tells them.
own = mapper.GetOptimization()
defaults = {
    "RegularizationWeight": 1.0,
    "ForegroundWeight": 50.0,
    "BackgroundWeight": 50.0,
    "Emphasis": 2.0,
    "SmoothingIterations": 15,
    "TransitionTime": 0.0,
    "NumberOfBands": 5,
    "Subset": 1,
    "ImportanceReduction": 2,
    "DepthReduction": 1,
    "HalfFloats": True,
    "Blending": vtkOpacityOptimization.Fourier,
    "Importance": vtkOpacityOptimization.SeriesImportance,
    "DepthScale": vtkOpacityOptimization.LinearDepth,
    "TightDepth": True,
    "OpaqueThreshold": 0.98,
    "AccumulationFrames": 1,
    "MaximumListMemory": 1024,
}
for name, value in defaults.items():
    assert getattr(own, "Get" + name)() == value, name
assert mapper.GetImportanceArrayName() == ""
assert mapper.GetImportanceRange() == (1.0, 0.0)
assert mapper.GetNumberOfLineSegments() == 0 and mapper.GetNumberOfPatches() == 500
assert mapper.GetNumberOfBytes() == 0 and mapper.GetNumberOfSumBytes() == 0

# Each way by name.
for number, name in enumerate(
    ("Fourier", "PaperFourier", "Bins", "WeightedAverage", "WeightedBlended", "FragmentLists")
):
    getattr(own, "SetBlendingTo" + name)()
    assert own.GetBlending() == number == getattr(vtkOpacityOptimization, name)
own.SetImportanceToExact()
assert own.GetImportance() == vtkOpacityOptimization.ExactImportance
own.SetImportanceToSeries()
own.SetBlendingToFourier()
own.TightDepthOff()
assert not own.GetTightDepth()
own.TightDepthOn()
own.HalfFloatsOff()
assert not own.GetHalfFloats()
own.HalfFloatsOn()

# May be shared; None brings one of its own back; a picture depends on it.
other = vtkFourierOpacityMapper()
other.SetOptimization(own)
assert other.GetOptimization() is own
time = mapper.GetMTime()
own.SetEmphasis(3.0)
assert mapper.GetMTime() > time and other.GetMTime() > time
own.SetEmphasis(2.0)
other.SetOptimization(None)
assert other.GetOptimization() is not own

time = mapper.GetMTime()
mapper.SetImportanceArrayName("g")
mapper.SetImportanceRange(0.0, 1.0)
mapper.SetNumberOfLineSegments(100)
mapper.SetNumberOfPatches(7)
assert mapper.GetMTime() > time
other.ShallowCopy(mapper)
assert other.GetImportanceArrayName() == "g" and other.GetImportanceRange() == (0.0, 1.0)
assert other.GetNumberOfLineSegments() == 100 and other.GetNumberOfPatches() == 7
assert other.GetOptimization() is own
assert "ForegroundWeight: 50" in str(mapper)

# A white point in front of a red one that is important: 1 / (1 + 50) of white.
points, verts, importance = vtkPoints(), vtkCellArray(), vtkFloatArray()
colors = vtkUnsignedCharArray()
colors.SetNumberOfComponents(3)
importance.SetName("g")
for z, value, color in ((0.5, 0.0, (255, 255, 255)), (-0.5, 1.0, (255, 0, 0))):
    verts.InsertNextCell(1)
    verts.InsertCellPoint(points.InsertNextPoint(0.0, 0.0, z))
    importance.InsertNextValue(value)
    colors.InsertNextTuple3(*color)
data = vtkPolyData()
data.SetPoints(points)
data.SetVerts(verts)
data.GetPointData().AddArray(importance)
data.GetPointData().SetScalars(colors)
mapper.SetInputData(data)
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetPointSize(20.0)
actor.GetProperty().LightingOff()
renderer = vtkRenderer()
renderer.AddActor(actor)
camera = renderer.GetActiveCamera()
camera.ParallelProjectionOn()
camera.SetPosition(0.0, 0.0, 5.0)
camera.SetParallelScale(1.0)
camera.SetClippingRange(1.0, 10.0)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(60, 60)
window.AddRenderer(renderer)


def read_pixel():
    window.Render()
    bytes_ = vtkUnsignedCharArray()
    window.GetPixelData(30, 30, 30, 30, 0, bytes_, 0)
    return tuple(bytes_.GetValue(i) for i in range(3))


def is_near(color, expected):
    return all(abs(a - b) <= 2 for a, b in zip(color, expected))


assert is_near(read_pixel(), (255, 5, 5)), read_pixel()
assert mapper.GetNumberOfSumBytes() == 60 * 60 * (4 + 2 * 10)
assert mapper.GetNumberOfBytes() > mapper.GetNumberOfSumBytes()
own.SetForegroundWeight(0.0)
assert is_near(read_pixel(), (255, 255, 255)), read_pixel()
own.SetForegroundWeight(1.0)
own.SetBlendingToFragmentLists()
own.SetImportanceToExact()
assert is_near(read_pixel(), (255, 127, 127)), read_pixel()
assert mapper.GetNumberOfFragments() == 2 * 20 * 20
assert mapper.GetMeanDepthComplexity() == 2.0
assert mapper.GetNumberOfDroppedFragments() == 0
