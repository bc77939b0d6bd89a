# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the client of TestClientWindow.sh does: one view per representation, beside each other."""
import os

import linesets_testing as testing
from paraview import simple

testing.load_plugin()
lines = simple.XMLPolyDataReader(registrationName="helices",
                                 FileName=[testing.write_lines(testing.make_helices(), "window")])
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
    testing.color_by(display, "POINTS", "Height", 0.0, 2.0)
    display.Representation = name
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
with open(os.path.join(testing.OUTPUT, "window.ready"), "w") as ready:
    ready.write("drawn\n")
