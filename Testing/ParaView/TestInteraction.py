# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards levels of detail while the user interacts: every second line of a small set, by a mapper
that follows the settings; voxel lines by their own quality; outlines where the view wants them; and
that what is drawn between interactions is neither changed nor built anew."""
import re

import linesets_testing as testing
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

VOXELS, LIT, FOURIER = "Voxel Lines", "Illuminated Lines", "Fourier Opacity"


def get_actor(display):
    return display.GetClientSideObject().GetActiveRepresentation().GetActor()


def interact(view):
    """Draws as during interaction; returns the pixels."""
    view.SMProxy.InteractiveRender()
    grab = vtkWindowToImageFilter()
    grab.SetInput(view.GetRenderWindow())
    grab.ShouldRerenderOff()
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    return pixels[:, :, :3].astype(float)


def get_state(mapper):
    """All by which a mapper would notice that it has to build something anew."""
    lines = mapper.GetInputDataObject(0, 0)
    return mapper.GetMTime(), lines, lines.GetMTime()


def get_setting(mapper, name):
    return re.search(name + ": (.*)", str(mapper)).group(1)


def count(picture):
    return int((abs(picture - picture[0, 0]).max(axis=2) > 20.0).sum())


testing.load_plugin()
messages = testing.Messages()
view = testing.make_view((200, 200))
view.LODThreshold = 0.0
source = simple.XMLPolyDataReader(
    FileName=[testing.write_lines(testing.make_helices(20), "TestInteraction")])
for name in (VOXELS, LIT, FOURIER):
    display = simple.Show(source, view)
    display.Representation = name
    display.ImportanceArray = "Height"
    display.ColorArrayName = ["POINTS", "Height"]
    display.LookupTable = simple.GetColorTransferFunction("Height")
    simple.ResetCamera(view)
    for _ in range(2):
        before = testing.take_picture(view, "TestInteraction")
    actor = get_actor(display)
    mapper = actor.GetMapper()
    state = get_state(mapper)
    built = get_setting(mapper, "ModelBuildTime") if name == VOXELS else None

    moving = interact(view)
    detail = actor.GetLODMapper()
    testing.check(count(moving) > 0.2 * count(before), "%s: drawn while moving" % name)
    testing.check(actor.GetEnableLOD() == (0 if name == VOXELS else 1), "%s: level" % name)
    if name == VOXELS:
        testing.check(get_setting(mapper, "QualityInUse") == "1", "interactive quality")
    else:
        number = detail.GetInput().GetNumberOfLines()
        testing.check(number == 10, "%s: %d lines while moving" % (name, number))
        testing.check(detail.GetInput().GetNumberOfPoints() == 1000, "%s: their points" % name)
        testing.check(count(moving) < count(before), "%s: fewer lines are seen" % name)
        detail_state = get_state(detail)
        interact(view)
        testing.check(get_state(detail) == detail_state, "%s: kept while moving" % name)
        # Whatever is set for the one counts for the other.
        if name == LIT:
            display.MergeLength = 1.5
            interact(view)
            testing.check(get_setting(detail, "MergeLength") == "1.5", "settings are the same")
            display.MergeLength = 3.0
        display.ColorArrayName = ["POINTS", ""]
        interact(view)
        testing.check(not detail.GetScalarVisibility(), "%s: colours are the same" % name)
        display.ColorArrayName = ["POINTS", "Height"]
        simple.Render(view)
        state = get_state(mapper)
        interact(view)
    after = testing.take_picture(view, "TestInteraction")
    difference = testing.rmse(before, after)
    testing.check(difference <= 1.0, "%s: the picture after moving: %.2f" % (name, difference))
    testing.check(get_state(mapper) == state, "%s: nothing is built anew" % name)
    if name == VOXELS:
        testing.check(get_setting(mapper, "QualityInUse") == "2", "quality afterwards")
        testing.check(get_setting(mapper, "ModelBuildTime") == built, "the model is kept")

    display.SuppressLOD = 1
    interact(view)
    testing.check(actor.GetEnableLOD() == 0, "%s: no level where it is suppressed" % name)
    display.SuppressLOD = 0
    simple.Hide(source, view)
    print(name, count(before), count(moving), flush=True)

# Polygons are decimated as ParaView does it.
sphere = vtkSphereSource()
sphere.SetThetaResolution(200)
sphere.SetPhiResolution(200)
sphere.Update()
surface = simple.XMLPolyDataReader(
    FileName=[testing.write_lines(sphere.GetOutput(), "TestInteractionSphere")])
display = simple.Show(surface, view)
display.Representation = FOURIER
display.ColorArrayName = ["POINTS", ""]
simple.ResetCamera(view)
simple.Render(view)
view.LODResolution = 0.1
moving = interact(view)
fewer = get_actor(display).GetLODMapper().GetInput().GetNumberOfPolys()
# How many are left differs between versions.
testing.check(0 < fewer < sphere.GetOutput().GetNumberOfPolys() and count(moving) > 1000,
              "decimated to %d polygons" % fewer)
simple.Hide(surface, view)
messages.take()

# Outlines.
view.UseOutlineForLODRendering = 1
again = simple.XMLPolyDataReader(
    FileName=[testing.write_lines(testing.make_helices(20), "TestInteraction")])
for name in (VOXELS, LIT, FOURIER):
    display = simple.Show(again, view)
    display.Representation = name
    display.ImportanceArray = "Height"
    simple.ResetCamera(view)
    simple.Render(view)
    moving = interact(view)
    outline = get_actor(display).GetLODMapper().GetInput()
    testing.check(outline.GetNumberOfPoints() == 8, "%s: outline" % name)
    testing.check(count(moving) > 100, "%s: the outline is seen" % name)
    simple.Delete(display)
said = messages.take()
testing.check(not said, "nothing is said: %s" % said)
