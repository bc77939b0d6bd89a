# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards the filters: lengths and integrals along lines are kept, held against sums over the input
in numpy; blocks are told apart; and bad input is answered with a message and an empty output."""
import re

import linesets_testing as testing
import numpy
from message_testing import Messages
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

EPSILON = 1e-9


def fetch(source):
    source.UpdatePipeline()
    return servermanager.Fetch(source)


def get_lines(data):
    """Points of each line."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    offsets = vtk_to_numpy(data.GetLines().GetOffsetsArray())
    ids = vtk_to_numpy(data.GetLines().GetConnectivityArray())
    return [ids[a:b] for a, b in zip(offsets[:-1], offsets[1:])], points


def integrate(data, array=None):
    """Length of all lines, or the integral of a point array along them."""
    values = vtk_to_numpy(data.GetPointData().GetArray(array)) if array else None
    lines, points = get_lines(data)
    total = 0.0
    for ids in lines:
        lengths = numpy.linalg.norm(numpy.diff(points[ids], axis=0), axis=1)
        weights = 0.5 * (values[ids[1:]] + values[ids[:-1]]) if array else 1.0
        total += numpy.sum(lengths * weights)
    return total


def is_near(a, b, tolerance):
    return abs(a - b) <= tolerance * abs(b)


def check_silent(messages, what):
    testing.check(messages.text == "", "%s: nothing is said, but\n%s" % (what, messages.text))


testing.load_plugin()
helices = testing.make_helices()
source = simple.XMLPolyDataReader(FileName=[testing.write_lines(helices, "filters")])
length = integrate(helices)

# Voxelize Lines
voxelized = simple.VoxelizeLines(Input=source, Resolution=64, FaceBins="Exact", InteriorTolerance=0)
voxelized.AttributeArray = ["POINTS", "Height"]
output = fetch(voxelized)
testing.check(is_near(integrate(output), length, EPSILON), "exact lines keep their length")
testing.check(is_near(integrate(output, "Height"), integrate(helices, "Height"), 0.005),
              "the attribute keeps its name and its integral")
testing.check(output.GetNumberOfCells() == 40, "a curve is one line")
testing.check(sorted(vtk_to_numpy(output.GetCellData().GetArray("CellId"))) == list(range(40)),
              "lines tell their cells")
voxelized.FaceBins = "32"
voxelized.InteriorTolerance = 0.1
testing.check(is_near(integrate(fetch(voxelized)), length, 0.01), "rounded lines nearly do")
voxelized.JoinSegments = 0
testing.check(fetch(voxelized).GetNumberOfCells() > 1000, "without joining, each segment is a line")

# Line Density
density = simple.LineDensity(Input=source, Resolution=64, FaceBins="Exact", InteriorTolerance=0)


def sum_density():
    image = fetch(density)
    values = vtk_to_numpy(image.GetPointData().GetArray("Density")).astype(float)
    return numpy.sum(values), image


total, image = sum_density()
voxel = image.GetSpacing()[0]
testing.check(is_near(voxel, 2.0 / 64, 0.1) and max(image.GetDimensions()) == 64,
              "there are 64 voxels along the longest side")
testing.check(is_near(total * voxel, length, 1e-4), "densities sum up to the length")
density.Opacity = 0.25
testing.check(is_near(sum_density()[0] * voxel, 0.25 * length, 1e-4), "opacity multiplies it")
density.OpacityArray = ["POINTS", "Height"]
testing.check(is_near(sum_density()[0] * voxel, 0.25 * integrate(helices, "Height"), 0.005),
              "values of an array multiply it")
density.OpacityArray = ["POINTS", "None"]
density.Opacity = 1
for level in (1, 3, 6):
    density.Level = level
    total, image = sum_density()
    testing.check(is_near(image.GetSpacing()[0], voxel * 2 ** level, EPSILON) and
                  is_near(total * 8 ** level * voxel, length, 1e-4),
                  "level %d has the means over its voxels" % level)
# One line stands for those of each voxel.
density.Level = voxelized.Level = 2
voxelized.FaceBins = "Exact"
voxelized.InteriorTolerance = 0
values, image = sum_density()
filled = numpy.count_nonzero(vtk_to_numpy(image.GetPointData().GetArray("Density")))
representatives = fetch(voxelized).GetNumberOfCells()
testing.check(representatives == filled, "%d voxels of level 2 have lines, %d representatives" %
              (filled, representatives))

# Blocks
shifted = simple.XMLPolyDataReader(
    FileName=[testing.write_lines(testing.make_helices(10, shift=3.0), "filters_shifted")])
group = simple.GroupDatasets(Input=[source, shifted])
blocks = simple.VoxelizeLines(Input=group, Resolution=64, FaceBins="Exact", InteriorTolerance=0)
output = fetch(blocks)
inputs = vtk_to_numpy(output.GetCellData().GetArray("InputId"))
testing.check(output.GetClassName() == "vtkPolyData", "blocks are merged")
both = length + integrate(testing.make_helices(10))
testing.check(is_near(integrate(output), both, EPSILON), "the lines of all blocks are there")
testing.check(len(set(inputs)) == 2 and min(inputs) > 0 and
              sorted(numpy.unique(inputs, return_counts=True)[1]) == [10, 40],
              "lines tell the flat index of their block")
of_blocks = simple.LineDensity(Input=group, Resolution=64)
image = fetch(of_blocks)
testing.check(is_near(numpy.sum(vtk_to_numpy(image.GetPointData().GetArray("Density")), dtype=float)
                      * image.GetSpacing()[0], both, 0.01), "one image holds all blocks")
mixed = simple.GroupDatasets(Input=[source, simple.Wavelet(WholeExtent=[0, 2, 0, 2, 0, 2])])
for make in (simple.VoxelizeLines, simple.LineDensity):
    with Messages() as messages:
        output = fetch(make(Input=mixed, Resolution=16))
    testing.check(output.GetNumberOfPoints() > 0 and "1 blocks that are no vtkPolyData" in
                  messages.text, "other blocks are told: " + messages.text)

# Opacity Segments
segments = simple.OpacitySegments(Input=source, NumberOfLineSegments=400)
output = fetch(segments)
ids = vtk_to_numpy(output.GetPointData().GetArray("OpacitySegmentIds"))[:, 0]
testing.check(abs(len(set(ids)) - 400) <= 40, "about as many segments as asked for")
segments.SegmentLength = length / 200
segments.UpdatePipeline()
segments.UpdatePropertyInformation()
told = segments.GetProperty("NumberOfSegments").GetData()
testing.check(abs(told - 200) <= 40, "segments of a length: %s" % told)
output = fetch(simple.OpacitySegments(Input=group))
testing.check(output.IsA("vtkDataObjectTree"), "each block has segments of its own")

# Progress and abort
for source_proxy in (voxelized, density):
    algorithm = source_proxy.GetClientSideObject()
    progress = []
    observer = algorithm.AddObserver("ProgressEvent",
                                     lambda caller, _: progress.append(caller.GetProgress()))
    algorithm.Modified()
    algorithm.Update()
    testing.check(len(progress) > 5 and progress == sorted(progress) and progress[-1] <= 1.0 and
                  progress[0] < 0.2, "progress rises: %s" % progress)
    algorithm.RemoveObserver(observer)
    observer = algorithm.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
    algorithm.Modified()
    algorithm.Update()
    testing.check(algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0,
                  "an abort leaves nothing half done")
    algorithm.RemoveObserver(observer)
    algorithm.SetAbortExecute(0)
    algorithm.Modified()
    algorithm.Update()
    testing.check(algorithm.GetOutputDataObject(0).GetNumberOfPoints() > 0, "and can be mended")

# Bad input
sphere = simple.Sphere()
empty = simple.Threshold(Input=source, Scalars=["POINTS", "Height"], LowerThreshold=9,
                         UpperThreshold=10)
nothing = simple.ExtractSurface(Input=empty)
for make in (simple.VoxelizeLines, simple.LineDensity):
    with Messages() as messages:
        output = fetch(make(Input=sphere))
    testing.check("The input has no lines, only 96 other cells" in messages.text,
                  "a surface is no lines: " + messages.text)
    testing.check(output.GetNumberOfPoints() == 0, "and gives nothing")
    with Messages() as messages:
        output = fetch(make(Input=nothing))
    check_silent(messages, "nothing")
    testing.check(output.GetNumberOfPoints() == 0, "nothing gives nothing")
    with Messages() as messages:
        bad = make(Input=source, Resolution=16, Level=5)
        output = fetch(bad)
    testing.check("Level" in messages.text and output.GetNumberOfPoints() == 0,
                  "there is no such level: " + messages.text)
    bad.Level = 4
    with Messages() as messages:
        testing.check(fetch(bad).GetNumberOfPoints() > 0, "a valid level brings the output back")
    check_silent(messages, "a valid level")
    with Messages() as messages:
        bad = make(Input=source, Resolution=16)
        property_name = "AttributeArray" if make is simple.VoxelizeLines else "OpacityArray"
        bad.GetProperty(property_name).SetData(["POINTS", "Nonesuch"])
        output = fetch(bad)
    testing.check("Nonesuch" in messages.text and output.GetNumberOfPoints() > 0,
                  "an array that is missing is told, and costs nothing else: " + messages.text)
# More memory than computers have that run tests.
large = simple.LineDensity(Input=source, Resolution=4096)
with Messages() as messages:
    output = fetch(large)
testing.check(re.search(r"\d{4} x \d{4} x 4096 points \(2\d\d GiB\), and 2\d\d GiB are needed.* where "
                        r".*lower Resolution or a higher Level", messages.text, re.DOTALL) and
              messages.text.count("points (") == 1 and output.GetNumberOfPoints() == 0,
              "an image that is too large is told once: " + messages.text)
large.Resolution = 32
with Messages() as messages:
    testing.check(fetch(large).GetNumberOfPoints() > 0, "a lower resolution brings the image back")
check_silent(messages, "a lower resolution")
with Messages() as messages:
    output = fetch(simple.OpacitySegments(Input=nothing))
check_silent(messages, "no segments")
