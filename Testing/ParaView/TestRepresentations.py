# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards that each representation draws coloured lines: one baseline each."""
import linesets_testing as testing
from paraview import simple

testing.load_plugin()
lines = simple.XMLPolyDataReader(FileName=[testing.write_lines(testing.make_helices(), "helices")])
view = testing.make_view()
display = simple.Show(lines, view)
testing.color_by(display, "POINTS", "Height", 0.0, 2.0)
testing.look_from(view)
pictures = {}
for name in ("Voxel Lines", "Illuminated Lines", "Fourier Opacity"):
    display.Representation = name
    if name == "Voxel Lines":
        display.Radius = 0.02
    if name == "Fourier Opacity":
        display.ImportanceArray = ["POINTS", "Height"]
    key = "TestRepresentations" + name.replace(" ", "")
    pictures[key] = testing.take_picture(view, key)
for key, picture in pictures.items():
    testing.check_baseline(picture, key)
