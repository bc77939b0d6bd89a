# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards: a picture of lines drawn from Python, opaque and transparent beside each other."""

import math
import sys

from linesets import vtkVoxelLineMapper
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkTestingRendering import vtkTesting


def make_knots(count=4, size=300):
    """Torus knots, coloured by the place along them."""
    points, lines, place = vtkPoints(), vtkCellArray(), vtkFloatArray()
    place.SetName("place")
    for i in range(count):
        lines.InsertNextCell(size)
        for k in range(size):
            t = 2.0 * math.pi * k / (size - 1)
            r = 1.0 + (0.1 + 0.09 * i) * math.cos(7.0 * t)
            point = (r * math.cos(2.0 * t), r * math.sin(2.0 * t), (0.1 + 0.09 * i) * math.sin(7.0 * t))
            lines.InsertCellPoint(points.InsertNextPoint(point))
            place.InsertNextValue(k / (size - 1.0))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    data.GetPointData().SetScalars(place)
    return data


knots = make_knots()
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(400, 200)
for i, opacity in enumerate((1.0, 0.25)):
    mapper = vtkVoxelLineMapper()
    mapper.SetInputData(knots)
    mapper.SetRadius(0.025)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(opacity)
    renderer = vtkRenderer()
    renderer.SetViewport(0.5 * i, 0.0, 0.5 * i + 0.5, 1.0)
    renderer.SetBackground(0.95, 0.95, 0.95)
    renderer.AddActor(actor)
    renderer.GetActiveCamera().SetPosition(1.0, -3.0, 4.0)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Zoom(1.3)
    window.AddRenderer(renderer)
window.Render()

tester = vtkTesting()
for argument in sys.argv[1:]:
    tester.AddArgument(argument)
tester.SetRenderWindow(window)
# The threshold of VTK's own image tests.
assert tester.RegressionTest(10.0) == vtkTesting.PASSED
