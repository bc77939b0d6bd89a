# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards that each representation draws coloured lines: one baseline each."""
import linesets_testing as testing
from paraview import simple

testing.load_plugin()
lines = simple.XMLPolyDataReader(FileName=[testing.write_lines(testing.make_helices(), "helices")])
view = testing.make_view()
display = simple.Show(lines, view)
simple.ColorBy(display, ("POINTS", "Height"))
for name in ("Voxel Lines", "Illuminated Lines", "Fourier Opacity"):
    display.Representation = name
    if name == "Fourier Opacity":
        display.ImportanceArray = "Height"
    simple.ResetCamera(view)
    key = "TestRepresentations" + name.replace(" ", "")
    testing.check_baseline(testing.take_picture(view, key), key)
