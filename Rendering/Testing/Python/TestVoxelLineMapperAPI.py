# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards: the mapper's interface in Python: defaults, inputs, errors, model, bounds, selection."""

from linesets import vtkLineVoxelizer, vtkVoxelLineMapper, vtkVoxelLineModel
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkHardwareSelector,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)


def make_bars(count=3):
    """Bars along x at y = 0, 1, 2 ..."""
    points, lines = vtkPoints(), vtkCellArray()
    for i in range(count):
        lines.InsertNextCell(2)
        for x in (-1.0, 1.0):
            lines.InsertCellPoint(points.InsertNextPoint(x, float(i), 0.0))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    return data


mapper = vtkVoxelLineMapper()
assert mapper.IsA("vtkPolyDataMapper") and isinstance(mapper, vtkPolyDataMapper)

# Defaults, as the documentation tells them.
assert mapper.GetRadius() == 0.0 and mapper.GetRadiusArrayName() == ""
assert mapper.GetResolution() == 256 and mapper.GetFaceBins() == 32
assert mapper.GetInteriorTolerance() == vtkLineVoxelizer().GetInteriorTolerance()
assert mapper.GetEarlyTermination() == 0.99 and mapper.GetOpacityAcceleration() == 1.0
assert mapper.GetEngine() == vtkVoxelLineMapper.Automatic
assert mapper.GetEngineInUse() == vtkVoxelLineMapper.Automatic
assert mapper.GetModel() is None and mapper.GetModelBuildTime() == 0.0
assert mapper.GetLightBuildTime() == 0.0
assert mapper.GetAccumulationFrames() == 1 and mapper.GetNumberOfAccumulatedPictures() == 0
assert mapper.GetNumberOfPictures() == 0 and mapper.GetGraphicsMemory() == 0

# Receivers of shadows.
receiver = vtkActor()
assert mapper.GetNumberOfReceivers() == 0
mapper.AddReceiver(receiver)
mapper.AddReceiver(receiver)
assert mapper.GetNumberOfReceivers() == 1
mapper.RemoveReceiver(receiver)
assert mapper.GetNumberOfReceivers() == 0
mapper.AddReceiver(receiver)
mapper.RemoveAllReceivers()
assert mapper.GetNumberOfReceivers() == 0
mapper.AddReceiver(receiver)
del receiver
assert mapper.GetNumberOfReceivers() == 0

# A value out of range is an error and changes nothing.
errors = []
mapper.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
for setter in (mapper.SetRadius, mapper.SetResolution, mapper.SetFaceBins):
    setter(-1)
mapper.SetEarlyTermination(2.0)
mapper.SetEngine(7)
mapper.SetAccumulationFrames(0)
mapper.SetAccumulationFrames(4097)
assert len(errors) == 7, errors
assert mapper.GetAccumulationFrames() == 1
assert mapper.GetRadius() == 0.0 and mapper.GetResolution() == 256 and mapper.GetFaceBins() == 32

# Polygonal data: the mapper builds the model, once.
bars = make_bars()
mapper.SetInputData(bars)
mapper.SetResolution(32)
mapper.SetRadius(0.125)
model = mapper.GetModel()
assert isinstance(model, vtkVoxelLineModel) and model.GetNumberOfCurves() == 3
assert mapper.GetModelBuildTime() > 0.0 and mapper.GetRadiusInUse() == 0.125
assert max(abs(a - b) for a, b in zip(mapper.GetBounds(), (-1.125, 1.125, -0.125, 2.125, -0.125, 0.125))) < 1e-6
built = model.GetMTime()
mapper.SetRadius(0.25)
assert mapper.GetModel() is model and model.GetMTime() == built
mapper.SetResolution(16)
assert mapper.GetModel().GetMTime() > built
bars.GetPoints().SetPoint(0, -3.0, 0.0, 0.0)
bars.GetPoints().Modified()
assert abs(mapper.GetBounds()[0] + 3.25) < 1e-6

# A model, shared.
other = vtkVoxelLineMapper()
other.SetInputData(mapper.GetModel())
assert other.GetModel() is mapper.GetModel()
copy = vtkVoxelLineMapper()
copy.ShallowCopy(mapper)
assert copy.GetRadius() == 0.25 and copy.GetResolution() == 16
assert copy.GetModel().GetNumberOfCurves() == 3

# Drawing and selection.
actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddActor(actor)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(100, 100)
window.AddRenderer(renderer)
window.Render()
assert mapper.GetNumberOfPictures() == 1 and mapper.GetTimeToDraw() > 0.0
assert mapper.GetNumberOfAccumulatedPictures() == 1
assert mapper.GetEngineInUse() in (vtkVoxelLineMapper.Native, vtkVoxelLineMapper.Shader)
assert mapper.GetGraphicsMemory() >= 100 * 100 * 8
selector = vtkHardwareSelector()
selector.SetRenderer(renderer)
selector.SetArea(0, 0, 99, 99)
selection = selector.Select()
assert selection.GetNumberOfNodes() == 1
cells = selection.GetNode(0).GetSelectionList()
assert sorted(cells.GetValue(i) for i in range(cells.GetNumberOfValues())) == [0, 1, 2]
mapper.ReleaseGraphicsResources(window)
assert mapper.GetGraphicsMemory() == 0

assert "Radius: 0.25" in str(mapper)
