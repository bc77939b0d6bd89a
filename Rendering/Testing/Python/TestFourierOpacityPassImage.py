# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards: a picture of points, lines and a surface in one vtkFourierOpacityPass, made from Python.

An important knot lies within a shell, curves about it and a cloud of points. On the left nothing
fades; on the right the knot is revealed.
"""

import math
import sys

from linesets import vtkFourierOpacityMapper, vtkFourierOpacityPass
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkMinimalStandardRandomSequence, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass
from vtkmodules.vtkTestingRendering import vtkTesting


def make_data(points, cells, kind, importance):
    """Points and cells, all of one importance."""
    data, places, array, ids = vtkPolyData(), vtkPoints(), vtkFloatArray(), vtkCellArray()
    array.SetName("importance")
    for point in points:
        places.InsertNextPoint(point)
        array.InsertNextValue(importance)
    for cell in cells:
        ids.InsertNextCell(len(cell))
        for i in cell:
            ids.InsertCellPoint(i)
    data.SetPoints(places)
    getattr(data, "Set" + kind)(ids)
    data.GetPointData().AddArray(array)
    return data


def make_knot(size=600):
    """A trefoil knot as a bundle of lines."""
    points, lines = [], []
    for strand in range(12):
        phase = 2.0 * math.pi * strand / 12.0
        lines.append(range(len(points), len(points) + size))
        for k in range(size):
            t = 2.0 * math.pi * k / (size - 1)
            r = 0.62 + 0.26 * math.cos(3.0 * t) + 0.06 * math.cos(phase + 9.0 * t)
            z = 0.3 * math.sin(3.0 * t) + 0.06 * math.sin(phase + 9.0 * t)
            points.append((r * math.cos(2.0 * t), r * math.sin(2.0 * t), z))
    return make_data(points, lines, "Lines", 1.0)


def make_curves(count=60, size=160):
    """Curves that wind about the knot, on spheres."""
    points, lines = [], []
    for i in range(count):
        radius = 1.05 + 0.25 * (i % 5) / 4.0
        turn = 2.399963 * i
        lines.append(range(len(points), len(points) + size))
        for k in range(size):
            t = k / (size - 1.0)
            height = 0.95 * math.sin(math.pi * (t - 0.5))
            r = radius * math.sqrt(1.0 - height * height)
            angle = turn + 4.0 * t
            points.append((r * math.cos(angle), r * math.sin(angle), radius * height))
    return make_data(points, lines, "Lines", 0.0)


def make_shell(rows=60, columns=120):
    """A wavy sphere, open at a side."""
    points, squares = [], []
    for i in range(rows):
        for k in range(columns):
            polar = math.pi * (0.06 + 0.88 * i / (rows - 1.0))
            angle = 2.0 * math.pi * (0.12 + 0.76 * k / (columns - 1.0))
            r = 1.5 + 0.07 * math.cos(6.0 * polar) * math.cos(5.0 * angle)
            x, y = r * math.sin(polar) * math.cos(angle), r * math.sin(polar) * math.sin(angle)
            points.append((x, y, r * math.cos(polar)))
            if i and k:
                a = i * columns + k
                squares.append((a - columns - 1, a - columns, a, a - 1))
    return make_data(points, squares, "Polys", 0.0)


def make_cloud(count=1500):
    """Points about all of it, by chance but the same in every run."""
    random = vtkMinimalStandardRandomSequence()
    random.SetSeed(5)
    points = []
    while len(points) < count:
        point = []
        for _ in range(3):
            random.Next()
            point.append(random.GetRangeValue(-1.9, 1.9))
        if 1.6 < math.sqrt(sum(x * x for x in point)) < 1.9:
            points.append(point)
    return make_data(points, [(i,) for i in range(count)], "Verts", 0.0)


# Data, colour, line width, point size.
parts = (
    (make_knot(), (0.93, 0.42, 0.1), 2.0, 1.0),
    (make_curves(), (0.1, 0.45, 0.62), 2.0, 1.0),
    (make_shell(), (0.78, 0.84, 0.86), 1.0, 1.0),
    (make_cloud(), (0.35, 0.3, 0.5), 1.0, 2.0),
)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(600, 300)
for i, weight in enumerate((0.0, 150.0)):
    opacity = vtkFourierOpacityPass()
    opacity.GetOptimization().SetForegroundWeight(weight)
    opacity.GetOptimization().SetBackgroundWeight(0.1 * weight)
    opacity.GetOptimization().SetSmoothingIterations(5)
    opacity.GetOptimization().SetHaloWidth(1.0)
    opacity.GetOptimization().SetAccumulationFrames(8)
    steps = vtkRenderStepsPass()
    steps.SetTranslucentPass(opacity)
    renderer = vtkRenderer()
    renderer.SetPass(steps)
    renderer.SetViewport(0.5 * i, 0.0, 0.5 * i + 0.5, 1.0)
    renderer.SetBackground(0.97, 0.97, 0.95)
    for data, color, line_width, point_size in parts:
        mapper = vtkFourierOpacityMapper()
        mapper.SetInputData(data)
        mapper.SetImportanceArrayName("importance")
        mapper.SetImportanceRange(0.0, 1.0)
        mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        look = actor.GetProperty()
        look.SetColor(color)
        look.SetAmbient(0.2)
        look.SetSpecular(0.25)
        look.SetSpecularPower(30.0)
        look.SetLineWidth(line_width)
        look.SetPointSize(point_size)
        renderer.AddActor(actor)
    renderer.GetActiveCamera().SetPosition(3.0, -1.2, 2.4)
    renderer.GetActiveCamera().SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Zoom(1.5)
    window.AddRenderer(renderer)
# The first one makes what later ones use, and does not count.
for _ in range(9):
    window.Render()

tester = vtkTesting()
for argument in sys.argv[1:]:
    tester.AddArgument(argument)
tester.SetRenderWindow(window)
# The threshold of VTK's own image tests.
assert tester.RegressionTest(10.0) == vtkTesting.PASSED
