# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Traces streamlines of a vector field on an image (.vti) and writes them as lines (.vtp).

Seeds are drawn from the points of the image with a probability proportional to an array of
weights, and moved at random within their cell, so that the lines lie where the flow is. The
random numbers have a fixed seed: the same call gives the same lines. Each seed gives up to two
lines, one downstream and one upstream, with the array of weights at their points.

    python3 trace_streamlines.py FIELD.vti LINES.vtp --vectors velocity --weights speed
"""

import argparse
import random

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataWriter

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("field", help="image with a point array of vectors (.vti)")
parser.add_argument("lines", help="where to write the streamlines (.vtp)")
parser.add_argument("--vectors", required=True, help="array to follow")
parser.add_argument("--weights", required=True, help="array that says where seeds are likely")
parser.add_argument("--count", type=int, default=1000, help="number of seeds")
parser.add_argument("--length", type=float, default=200.0, help="largest length, in data units")
parser.add_argument("--terminal-speed", type=float, default=0.0, help="lines end below this speed")
options = parser.parse_args()

reader = vtkXMLImageDataReader()
reader.SetFileName(options.field)
reader.Update()
image = reader.GetOutput()
weights = image.GetPointData().GetArray(options.weights)
if weights is None or not image.GetPointData().HasArray(options.vectors):
    parser.error(f"{options.field} lacks a point array {options.weights} or {options.vectors}")

generator = random.Random(1)
spacing = image.GetSpacing()
seeds = vtkPoints()
for point in generator.choices(
    range(image.GetNumberOfPoints()),
    [max(weights.GetValue(i), 0.0) for i in range(weights.GetNumberOfValues())],
    k=options.count,
):
    position = image.GetPoint(point)
    seeds.InsertNextPoint(
        [x + (generator.random() - 0.5) * step for x, step in zip(position, spacing)]
    )
seed_data = vtkPolyData()
seed_data.SetPoints(seeds)

tracer = vtkStreamTracer()
tracer.SetInputData(image)
tracer.SetSourceData(seed_data)
tracer.SetInputArrayToProcess(0, 0, 0, 0, options.vectors)
tracer.SetIntegratorTypeToRungeKutta4()
tracer.SetIntegrationDirectionToBoth()
tracer.SetIntegrationStepUnit(tracer.CELL_LENGTH_UNIT)
tracer.SetInitialIntegrationStep(0.25)
tracer.SetMaximumPropagation(options.length)
tracer.SetMaximumNumberOfSteps(2000)
tracer.SetTerminalSpeed(max(options.terminal_speed, 1e-12))
tracer.SetComputeVorticity(False)
tracer.Update()

lines = vtkPolyData()
lines.SetPoints(tracer.GetOutput().GetPoints())
lines.SetLines(tracer.GetOutput().GetLines())
lines.GetPointData().SetScalars(tracer.GetOutput().GetPointData().GetArray(options.weights))

writer = vtkXMLPolyDataWriter()
writer.SetInputData(lines)
writer.SetFileName(options.lines)
if not writer.Write():
    raise SystemExit(f"Could not write {options.lines}")
print(f"{options.lines}: {lines.GetNumberOfLines()} lines, {lines.GetNumberOfPoints()} points")
