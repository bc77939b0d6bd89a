# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards that a click gives the line of the input that is seen there, by cell and by point, and its
block, as ParaView's own Wireframe gives it; and that what is selected is highlighted."""
import os

import linesets_testing as testing
from paraview import simple, servermanager
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter

REPRESENTATIONS = ("Wireframe", "Voxel Lines", "Illuminated Lines", "Fourier Opacity")
ROWS = 5


def make_rows(shift):
    """A vertex (cell 0) and bars along x at y = 0, 1, ... (cells 1, 2, ...), ten points each, that
    follow one point that no cell has."""
    points, lines, verts = vtkPoints(), vtkCellArray(), vtkCellArray()
    value = vtkDoubleArray()
    value.SetName("Height")
    points.InsertNextPoint(shift, 0.0, 0.0)
    verts.InsertNextCell(1)
    verts.InsertCellPoint(0)
    value.InsertNextValue(0.0)
    for row in range(ROWS):
        lines.InsertNextCell(10)
        for k in range(10):
            lines.InsertCellPoint(points.InsertNextPoint(shift + k, row, 0.0))
            value.InsertNextValue(row)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetVerts(verts)
    data.SetLines(lines)
    data.GetPointData().AddArray(value)
    return data


def get_ids(source):
    """Of a selection: (block or None, id)."""
    found = set()
    selection = servermanager._getPyProxy(source.SMProxy.GetSelectionInput(0))
    if selection is None:
        return found
    for node in selection.Input:
        values = list(node.IDs)
        if "Composite" in node.SMProxy.GetXMLName():
            found |= {(values[i], values[i + 2]) for i in range(0, len(values), 3)}
        else:
            found |= {(None, values[i + 1]) for i in range(0, len(values), 2)}
    return found


def click(source, view, x, y, what):
    simple.ClearSelection(source)
    rectangle = [x - 1, y - 1, x + 1, y + 1]
    if what == "cells":
        simple.SelectSurfaceCells(View=view, Rectangle=rectangle)
    else:
        simple.SelectSurfacePoints(View=view, Rectangle=rectangle)
    return get_ids(source)


testing.load_plugin()
messages = testing.Messages()
view = testing.make_view((400, 200))
view.CameraParallelProjection = 1
view.CameraPosition = [10.0, 2.0, 20.0]
view.CameraFocalPoint = [10.0, 2.0, 0.0]
view.CameraParallelScale = 4.0  # 25 pixels each

blocks = vtkMultiBlockDataSet()
blocks.SetBlock(1, make_rows(2.0))
inner = vtkMultiBlockDataSet()
inner.SetBlock(0, make_rows(12.0))
blocks.SetBlock(2, inner)
writer = vtkXMLMultiBlockDataWriter()
writer.SetFileName(os.path.join(testing.OUTPUT, "TestSelection.vtm"))
writer.SetInputDataObject(blocks)
os.makedirs(testing.OUTPUT, exist_ok=True)
writer.Write()

single = simple.XMLPolyDataReader(FileName=[testing.write_lines(make_rows(2.0), "TestSelection")])
several = simple.XMLMultiBlockDataReader(FileName=[writer.GetFileName()])
for source, columns in ((single, {2: None}), (several, {2: 2, 12: 4})):
    display = simple.Show(source, view)
    display.LineWidth = 3.0
    for representation in REPRESENTATIONS:
        display.Representation = representation
        display.ImportanceArray = "Height"
        display.SelectionLineWidth = 5.0
        if representation == "Voxel Lines":
            # The highlight is a line in the middle of the tube, of which it must stand out.
            display.Radius = 0.1
            display.SelectionLineWidth = 11.0
        simple.Render(view)
        for left, block in columns.items():
            for row in (1, 4):
                # 5 units to the right of the bar's left end, a bit beside a point.
                x = int(200 + 25 * (left + 5 - 10)) + 4
                y = int(100 + 25 * (row - 2))
                what = "%s, column %d, row %d" % (representation, left, row)
                cells = click(source, view, x, y, "cells")
                testing.check(cells == {(block, 1 + row)}, "%s: cells %s" % (what, cells))
                if representation != "Wireframe":
                    points = click(source, view, x - 4, y, "points")
                    wanted = {(block, 1 + 10 * row + 5)}
                    testing.check(points == wanted, "%s: points %s" % (what, points))
            beside = click(source, view, x, y + 12, "cells")
            testing.check(not beside, "%s: nothing beside: %s" % (representation, beside))
        print(representation, columns, flush=True)
        # The highlight of the last bar is seen.
        click(source, view, x, y, "cells")
        picture = testing.take_picture(view, "TestSelection" + representation.replace(" ", ""))
        color = picture[y - 5:y + 6, x - 40:x - 20].reshape(-1, 3)
        pink = (color[:, 0] > 200) & (color[:, 1] < 60) & (color[:, 2] > 200)
        testing.check(pink.sum() > 15, "%s: the selected line is highlighted: %d pixels" % (
            representation, pink.sum()))
        simple.ClearSelection(source)
    simple.Hide(source, view)
said = messages.take()
testing.check(not said, "nothing is said: %s" % said)
