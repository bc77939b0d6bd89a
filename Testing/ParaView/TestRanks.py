# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""
Guards that several ranks draw what one draws. Helices that lie between each other are parted among
the ranks, so that lines of all ranks are before and behind each other everywhere.
"""
import linesets_ranks as ranks
import linesets_testing as testing
from paraview import simple

testing.load_plugin()
# All layers, whose number the parts of space change.
settings = simple.GetSettingsProxy("RenderViewSettings")
settings.MaximumNumberOfPeels = 100
lines = simple.XMLPartitionedPolydataReader(
    FileName=[ranks.write_pieces(testing.make_helices(60, 300), "ranks")])
view = testing.make_view()
display = simple.Show(lines, view)
simple.ColorBy(display, ("CELLS", "Helix"))
# Each rank that runs the script knows the range of its own lines.
simple.GetColorTransferFunction("Helix").RescaleTransferFunction(0.0, 60.0)
view.CameraPosition = [4.0, 3.0, 3.5]
view.CameraFocalPoint = [0.0, 0.0, 1.0]
view.CameraViewUp = [0.0, 0.0, 1.0]
for name in ("Voxel Lines", "Illuminated Lines"):
    display.Representation = name
    if name == "Voxel Lines":
        display.Radius = 0.02
        display.Resolution = 64
    else:
        display.LineWidth = 3
    for opacity in (1.0, 0.25):
        display.Opacity = opacity
        key = "TestRanks%s%d" % (name.replace(" ", ""), 100 * opacity)
        ranks.check_baseline(view, key)
