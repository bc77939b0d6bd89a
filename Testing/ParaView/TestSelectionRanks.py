# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""
Guards that a selection on several ranks gives the lines that are seen there: by the rank that has a
line, and not by the one that draws it. Translucent lines are handed on to the rank whose part of space
they pass. Lines of all ranks lie between each other.
"""
import linesets_ranks as ranks
import linesets_testing as testing
from paraview import simple, servermanager
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

LINES = 20
POINTS = 10
PIECES = 4
KINDS = (("Surface", 1.0), ("Voxel Lines", 0.5), ("Illuminated Lines", 0.5),
         ("Illuminated Lines", 1.0), ("Fourier Opacity", 1.0))


def make_bars():
    """Bars along x at y = 0, 1, ..."""
    points, lines = vtkPoints(), vtkCellArray()
    number, height = vtkDoubleArray(), vtkDoubleArray()
    number.SetName("Line")
    height.SetName("Height")
    for line in range(LINES):
        lines.InsertNextCell(POINTS)
        number.InsertNextValue(line)
        for k in range(POINTS):
            lines.InsertCellPoint(points.InsertNextPoint(2.0 * k, line, 0.0))
            height.InsertNextValue(1.0)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    data.GetCellData().AddArray(number)
    data.GetPointData().AddArray(height)
    return data


def get_lines(rank):
    """The lines that a rank reads, in the order of its cells."""
    first, end = rank * PIECES // ranks.RANKS, (rank + 1) * PIECES // ranks.RANKS
    return [line for piece in range(first, end) for line in range(piece, LINES, PIECES)]


def select(source, view, rectangle, what):
    """Lines in a rectangle of pixels, and (line, point) in it; None where the root is another."""
    simple.ClearSelection(source)
    if what == "cells":
        simple.SelectSurfaceCells(View=view, Rectangle=rectangle)
    else:
        simple.SelectSurfacePoints(View=view, Rectangle=rectangle)
    found = set()
    selection = servermanager._getPyProxy(source.SMProxy.GetSelectionInput(0))
    for node in selection.Input if selection else []:
        values = [int(value) for value in node.IDs]
        for rank, index in zip(values[0::2], values[1::2]):
            lines = get_lines(rank)
            found.add(lines[index] if what == "cells" else
                      (lines[index // POINTS], index % POINTS))
    return found


testing.load_plugin()
view = testing.make_view((400, 400))
view.CameraParallelProjection = 1
view.CameraPosition = [10.0, 10.0, 40.0]
view.CameraFocalPoint = [10.0, 10.0, 0.0]
view.CameraParallelScale = 12.5  # 16 pixels each
bars = simple.XMLPartitionedPolydataReader(
    FileName=[ranks.write_pieces(make_bars(), "TestSelectionRanks", PIECES)])
display = simple.Show(bars, view)
display.LineWidth = 3.0
display.ImportanceArray = "Height"
display.Radius = 0.1
bars.UpdatePipeline()
mine = bars.GetClientSideObject().GetOutputDataObject(0)
mine = list(vtk_to_numpy(WrapDataObject(mine).VTKObject.GetCellData().GetArray("Line")).astype(int))
testing.check(mine == get_lines(ranks.RANK), "rank %d reads the lines %s" % (ranks.RANK, mine))
missed = []
for representation, opacity in KINDS:
    display.Representation = representation
    display.Opacity = opacity
    simple.Render(view)
    what = "%s, opacity %g, %d ranks" % (representation, opacity, ranks.RANKS)
    for x in (3.0, 15.0):
        for first, last in ((0, LINES - 1), (4, 7), (12, 12)):
            # Around the point k = x / 2, and from below the first line to above the last one.
            left, right = (int(200 + 16 * (x - 10 + side)) for side in (-0.5, 0.5))
            bottom, top = (int(200 + 16 * (y - 10)) for y in (first - 0.4, last + 0.4))
            cells = select(bars, view, [left, bottom, right, top], "cells")
            if ranks.RANK == 0 and cells != set(range(first, last + 1)):
                missed.append("%s, lines %d to %d at %g: %s" % (what, first, last, x, cells))
            if representation == "Surface":
                continue  # Its points are found where they are drawn alone.
            points = select(bars, view, [left + 16, bottom, right + 16, top], "points")
            wanted = {(line, int(x + 1) // 2) for line in range(first, last + 1)}
            if ranks.RANK == 0 and points != wanted:
                missed.append("%s, points of %d to %d at %g: %s" % (what, first, last, x, points))
    print(what, flush=True)
testing.check(not missed, "\n".join(missed))
