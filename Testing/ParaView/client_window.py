# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the client of TestClientWindow.sh does: one view per representation, beside each other. Then
it waits for clicks, and keeps what they select in window.selection: CELL or POINT and the ids, or
NOTHING."""
import os

import linesets_testing as testing
from paraview import servermanager, simple

MARKED = 12  # of 20: behind some and before others


def write_selection(*_):
    """All at once, for whom reads it meanwhile."""
    selection = servermanager._getPyProxy(lines.SMProxy.GetSelectionInput(0))
    nodes = ["%s %s" % (str(node.FieldType).strip("'"), " ".join(str(i) for i in node.IDs[1::2]))
             for node in (selection.Input if selection else ())]
    path = os.path.join(testing.OUTPUT, "window.selection")
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write("".join(node + "\n" for node in nodes) or "NOTHING\n")
    os.replace(path + ".new", path)


testing.load_plugin()
lines = simple.XMLPolyDataReader(registrationName="helices",
                                 FileName=[testing.write_lines(testing.make_helices(20), "window")])
layout = simple.GetLayout()
first = simple.GetActiveViewOrCreate("RenderView")
layout.SplitHorizontal(0, 0.5)
layout.SplitVertical(2, 0.5)
views = [first]
for place in (5, 6):  # the places of the right side: 2 (right) has the children 5 and 6
    views.append(simple.CreateView("RenderView"))
    layout.AssignView(place, views[-1])
for view, name in zip(views, ("Voxel Lines", "Illuminated Lines", "Fourier Opacity")):
    view.UseColorPaletteForBackground = 0
    view.Background = [0.0, 0.0, 0.0]
    view.OrientationAxesVisibility = 0
    display = simple.Show(lines, view)
    # One line is orange.
    table = testing.color_by(display, "CELLS", "Helix", 0.0, 19.0)
    blue, orange = [0.2, 0.4, 0.9], [0.9, 0.3, 0.1]
    steps = ((0.0, blue), (MARKED - 0.5, blue), (MARKED - 0.4, orange), (MARKED + 0.4, orange),
             (MARKED + 0.5, blue), (19.0, blue))
    table.RGBPoints = [value for place, color in steps for value in (place, *color)]
    display.Representation = name
    display.LineWidth = 4.0
    if name == "Voxel Lines":
        display.Radius = 0.02
        display.SetScalarBarVisibility(view, True)
    if name == "Fourier Opacity":
        display.ImportanceArray = ["POINTS", "Height"]
    simple.SetActiveView(view)
    testing.look_from(view, zoom=1.0)
simple.SetActiveView(first)
simple.SetActiveSource(lines)
simple.RenderAllViews()
lines.SMProxy.AddObserver("SelectionChangedEvent", write_selection)
with open(os.path.join(testing.OUTPUT, "window.ready"), "w") as ready:
    ready.write("drawn\n")
