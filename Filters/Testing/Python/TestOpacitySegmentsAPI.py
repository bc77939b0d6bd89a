# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards: segments for opacity optimization in Python: defaults, names of arrays, weights, counts."""

from linesets import vtkOpacitySegments
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm

segments = vtkOpacitySegments()
assert isinstance(segments, vtkPolyDataAlgorithm)

# Defaults, as the documentation tells them.
assert segments.GetNumberOfLineSegments() == 0
assert segments.GetSegmentLength() == 0.0
assert segments.GetNumberOfPatches() == 500
assert segments.GetNumberOfSegments() == 0

points = vtkPoints()
for i in range(5):
    points.InsertNextPoint(i, 0.0, 0.0)
lines = vtkCellArray()
lines.InsertNextCell(5, list(range(5)))
data = vtkPolyData()
data.SetPoints(points)
data.SetLines(lines)
segments.SetInputData(data)
segments.SetNumberOfLineSegments(2)
segments.Update()
output = segments.GetOutput()
ids = output.GetPointData().GetArray(vtkOpacitySegments.GetIdsName())
distances = output.GetPointData().GetArray(vtkOpacitySegments.GetDistancesName())
neighbors = output.GetFieldData().GetArray(vtkOpacitySegments.GetNeighborsName())
count = output.GetFieldData().GetArray(vtkOpacitySegments.GetCountName())
assert (ids.GetName(), distances.GetName()) == ("OpacitySegmentIds", "OpacitySegmentDistances")
assert neighbors.GetTuple(0) == (0.0, 1.0) and neighbors.GetNumberOfTuples() == 1
assert count.GetValue(0) == segments.GetNumberOfSegments() == 2
assert segments.GetNumberOfSegmentsOfLines() == 2
assert segments.GetNumberOfSegmentsOfSurfaces() == segments.GetNumberOfSegmentsOfPoints() == 0

# The point in the middle lies between both centres.
weights = [0.0] * 3
tuple_of_ids = [int(value) for value in ids.GetTuple(2)]
vtkOpacitySegments.GetWeights(tuple_of_ids, distances.GetTuple(2), weights)
assert sorted(tuple_of_ids) == [-1, 0, 1] and weights == [0.5, 0.5, 0.0]
