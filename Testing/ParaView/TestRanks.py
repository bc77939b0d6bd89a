# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""
Guards that several ranks draw what one draws. Lines that lie between each other are parted among the
ranks, so that those of all ranks are before and behind each other everywhere. Also that a level of
detail has no more points with more ranks.
"""
import linesets_ranks as ranks
import linesets_testing as testing
from paraview import simple
from vtkmodules.vtkCommonCore import vtkDoubleArray

testing.load_plugin()
# All layers, whose number the parts of space change.
settings = simple.GetSettingsProxy("RenderViewSettings")
settings.MaximumNumberOfPeels = 100


def show(data, name, association, array, largest):
    """A view of lines from all ranks, coloured by an array from 0 to its largest value."""
    lines = simple.XMLPartitionedPolydataReader(FileName=[ranks.write_pieces(data, name)])
    view = testing.make_view()
    # It makes differences of one larger, where they decide what is an edge.
    view.UseFXAA = 0
    display = simple.Show(lines, view)
    # Each rank that runs the script knows the range of its own lines.
    testing.color_by(display, association, array, 0.0, largest)
    view.CameraPosition = [4.0, 3.0, 3.5]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    return view, display


def check_kinds(view, display, key):
    """Pictures of the three representations, opaque and translucent."""
    display.Radius = 0.02
    display.Resolution = 64
    display.ImportanceArray = "Height"
    display.LineWidth = 3
    for name, opacities in (("Voxel Lines", (1.0, 0.25)), ("Illuminated Lines", (1.0, 0.25)),
                            ("Fourier Opacity", (1.0,))):
        display.Representation = name
        for opacity in opacities:
            display.Opacity = opacity
            # Opaque lines are the same to the pixel; the sums of Fourier opacity approximate the
            # colours of each part by themselves.
            ranks.check_baseline(
                view, "TestRanks%s%s%d" % (key, name.replace(" ", ""), 100 * opacity),
                2.0 if name == "Fourier Opacity" else 0.5 if opacity == 1.0 else 1.0)


helices_view, helices = show(testing.make_helices(60, 300), "helices", "CELLS", "Helix", 60.0)
helices_view.CameraFocalPoint = [0.0, 0.0, 1.0]
check_kinds(helices_view, helices, "Helices")
# Many points to a pixel, of which some are left out; moved, turned and stretched after the view has
# parted space.
waves_view, waves = show(ranks.make_waves(), "waves", "POINTS", "Height", 1.0)
waves.Scale = [0.8, 0.6, 1.0]
waves.Orientation = [20.0, 0.0, 40.0]
waves.Translation = [0.1, -0.2, 0.0]
check_kinds(waves_view, waves, "Waves")

# The level of detail, of 10 000 points at this resolution.
lines = simple.XMLPartitionedPolydataReader(
    FileName=[ranks.write_pieces(testing.make_helices(100, 600), "details")])
view = testing.make_view()
view.LODThreshold = 0.0
view.LODResolution = 0.0
display = simple.Show(lines, view)
display.Representation = "Illuminated Lines"
simple.ResetCamera(view)
simple.Render(view)
view.SMProxy.InteractiveRender()
actor = display.GetClientSideObject().GetActiveRepresentation().GetActor()
testing.check(actor.GetEnableLOD(), "a level of detail is drawn")
mine, total = vtkDoubleArray(), vtkDoubleArray()
mine.InsertNextValue(actor.GetLODMapper().GetInput().GetNumberOfPoints())
ranks.CONTROLLER.AllReduce(mine, total, 2)  # SUM_OP
# Lines are kept whole; a rank may have one more than its part.
testing.check(5000 < total.GetValue(0) <= 10000 + 600 * ranks.RANKS,
              "%d points while moving" % total.GetValue(0))
