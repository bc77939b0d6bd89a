# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""
Guards that a selection on several ranks gives the lines that are seen there: by the rank that has a
line, and not by the one that draws it. Translucent lines are handed on to the rank whose part of
space they pass. Lines of all ranks lie between each other.
"""
import linesets_ranks as ranks
import linesets_testing as testing
from paraview import simple, servermanager
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

LINES = 20
POINTS = 10
PIECES = 4
SCALE = 10  # pixels
SELECTIONS = ((3, 0, LINES - 1, "cells"), (15, 4, 7, "cells"), (4, 3, 12, "points"))
KINDS = (("Surface", 1.0), ("Voxel Lines", 0.5), ("Illuminated Lines", 0.5),
         ("Illuminated Lines", 1.0), ("Fourier Opacity", 1.0))


def make_bars():
    """Bars along x at y = 0, 1, ..."""
    points, lines = vtkPoints(), vtkCellArray()
    height = vtkDoubleArray()
    height.SetName("Height")
    for line in range(LINES):
        lines.InsertNextCell(POINTS)
        for k in range(POINTS):
            lines.InsertCellPoint(points.InsertNextPoint(2.0 * k, line, 0.0))
            height.InsertNextValue(k)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    data.GetPointData().AddArray(height)
    return data


def get_lines(rank):
    """The lines that a rank reads, in the order of its cells."""
    first, end = rank * PIECES // ranks.RANKS, (rank + 1) * PIECES // ranks.RANKS
    return [line for piece in range(first, end) for line in range(piece, LINES, PIECES)]


def select(source, view, rectangle, what):
    """Lines in a rectangle of pixels, or (line, point) in it."""
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


messages = testing.Messages()
testing.load_plugin()
# ParaView loads it on all ranks, and says wrongly that it did not.
messages.take()
view = testing.make_view((240, 240))
view.CameraParallelProjection = 1
view.CameraPosition = [9.0, 9.5, 40.0]
view.CameraFocalPoint = [9.0, 9.5, 0.0]
view.CameraParallelScale = 120.0 / SCALE
bars = simple.XMLPartitionedPolydataReader(
    FileName=[ranks.write_pieces(make_bars(), "TestSelectionRanks", PIECES, False)])
display = simple.Show(bars, view)
display.LineWidth = 3.0
display.ImportanceArray = "Height"
display.Radius = 0.1
bars.UpdatePipeline()
missed = []
for representation, opacity in KINDS:
    display.Representation = representation
    display.Opacity = opacity
    simple.Render(view)
    what = "%s, opacity %g, %d ranks" % (representation, opacity, ranks.RANKS)
    # Rectangles from below the first line to above the last one, at x.
    for x, first, last, kind in SELECTIONS:
        if kind == "points" and opacity == 1.0 and representation != "Fourier Opacity":
            # Of what each rank draws of its own ParaView finds the points of one rank.
            continue
        left, right = (int(120 + SCALE * (x - 9 + side)) for side in (-0.5, 0.5))
        bottom, top = (int(120 + SCALE * (y - 9.5)) for y in (first - 0.4, last + 0.4))
        found = select(bars, view, [left, bottom, right, top], kind)
        wanted = set(range(first, last + 1))
        if kind == "points":
            wanted = {(line, x // 2) for line in wanted}
        if found != wanted:
            missed.append("%s, %s of %d to %d at %g: %s" % (what, kind, first, last, x, found))
    print(what, flush=True)
testing.check(not missed, "\n".join(missed))
said = messages.take()
testing.check(not said, "nothing is said: %s" % said)
