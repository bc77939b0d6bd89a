# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""
Guards that a pvserver on several ranks draws for its client what one on one rank draws, opaque and
translucent and in another time step, that lines are there while the user interacts, and that what
is selected is what is seen. Lines of all ranks lie between each other. Argument: the number of ranks.
"""
import os
import sys

import linesets_ranks as ranks
import linesets_server
import linesets_testing as testing
from paraview import servermanager, simple

# The bounds are those of one rank's pictures; what is laid over each other has 8 bits, and the sums of
# Fourier Opacity are those of each part of space.
KINDS = (("Voxel Lines", 1.0, 0.1), ("Voxel Lines", 0.25, 1.0), ("Illuminated Lines", 1.0, 0.1),
         ("Illuminated Lines", 0.25, 1.0), ("Fourier Opacity", 1.0, 1.0))
LINES = 20
PIECES = 4
# The tests of other numbers of ranks run beside this one.
NAME = "TestClientServerRanks%s" % sys.argv[1]


def write_steps():
    steps = [ranks.write_pieces(testing.make_helices(LINES, points), "%s-%d" % (NAME, i), PIECES, False)
             for i, points in enumerate((100, 50))]
    path = os.path.join(testing.OUTPUT, NAME + ".pvd")
    with open(path, "w", encoding="utf-8") as file:
        file.write('<VTKFile type="Collection" version="0.1"><Collection>')
        for i, name in enumerate(steps):
            file.write('<DataSet timestep="%d" part="0" file="%s"/>' % (i, name))
        file.write("</Collection></VTKFile>")
    return path


def select(source, view, number):
    """The lines that are selected in the middle of the view, where a number of ranks has them."""
    simple.ClearSelection(source)
    simple.SelectSurfaceCells(View=view, Rectangle=[90, 90, 110, 110])
    selection = servermanager._getPyProxy(source.SMProxy.GetSelectionInput(0))
    lines = set()
    for node in selection.Input if selection else ():
        ids = [int(i) for i in node.IDs]
        for rank, cell in zip(ids[0::2], ids[1::2]):
            first, end = rank * PIECES // number, (rank + 1) * PIECES // number
            lines.add([line for piece in range(first, end)
                       for line in range(piece, LINES, PIECES)][cell])
    simple.ClearSelection(source)
    return lines


def make_view(source):
    view = testing.make_view((200, 200))
    view.UseFXAA = 0
    view.RemoteRenderThreshold = 0.0
    # While moving, a level of detail in pictures of full size.
    view.LODThreshold = 0.0
    view.ImageReductionFactor = 1
    view.CameraPosition = [4.0, 3.0, 3.5]
    view.CameraFocalPoint = [0.0, 0.0, 1.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    display = simple.Show(source, view)
    testing.color_by(display, "POINTS", "Height", 0.0, 2.0)
    display.ImportanceArray = "Height"
    display.Radius = 0.03
    display.Resolution = 64
    display.LineWidth = 3.0
    # ParaView 6.1 cuts its own highlight at the sides of boxes, and warns of all but straight lines.
    display.SelectionVisibility = 0
    return view, display


def draw(path, number):
    """For each kind three pictures, still, moving and of a later time, and a set of lines."""
    simple.GetSettingsProxy("RenderViewSettings").MaximumNumberOfPeels = 100
    source = simple.PVDReader(FileName=path)
    view, display = make_view(source)
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    drawn = []
    for name, opacity, _ in KINDS:
        display.Representation = name
        display.Opacity = opacity
        scene.AnimationTime = 0
        still = testing.take_picture(view, NAME)
        view.UseInteractiveRenderingForScreenshots = 1
        moving = testing.take_picture(view, NAME)
        view.UseInteractiveRenderingForScreenshots = 0
        selected = select(source, view, number)
        scene.AnimationTime = 1
        later = testing.take_picture(view, NAME)
        drawn.append((still, moving, later, selected))
    is_remote = view.SMProxy.GetClientSideObject().GetUseDistributedRenderingForRender()
    testing.check(is_remote, "the server draws")
    return drawn


def count(picture):
    return (abs(picture - picture[0, 0]).max(axis=2) > 10.0).sum()


testing.load_plugin()
messages = testing.Messages()
path = write_steps()
drawn = {}
number = int(sys.argv[1])
for size in (1, number):
    with linesets_server.Server("%s-%d" % (NAME, size), size):
        # ParaView's session with the server before says that this has gone.
        messages.take()
        drawn[size] = draw(path, size)
        said = messages.take()
        testing.check(not said, "the client says nothing: %s" % said)
failed = []
for (name, opacity, bound), expected, found in zip(KINDS, drawn[1], drawn[number]):
    what = "%s, opacity %g" % (name, opacity)
    for time in (0, 2):
        difference = testing.rmse(found[time], expected[time])
        print("%s, time %d: RMSE %.2f, worst pixel %d" % (
            what, time // 2, difference, abs(found[time] - expected[time]).max()))
        if difference > bound or count(expected[time]) < 5000:
            failed.append("%s, time %d: differs by %.2f" % (what, time // 2, difference))
    # Each rank keeps some of its own lines.
    parts = count(found[1]) / count(expected[1])
    print("%s, moving: %.2f of one rank's pixels" % (what, parts))
    if not 0.7 < parts < 1.4:
        failed.append("%s, moving: %.2f of one rank's pixels" % (what, parts))
    if len(expected[3]) < 5 or found[3] != expected[3]:
        failed.append("%s: %s is selected, not %s" % (what, found[3], expected[3]))
testing.check(not failed, "\n".join(failed))
