# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards that a server draws as a client alone does: remote and local rendering, while the user
interacts, selection, and what is told to be in use."""
import linesets_server
import linesets_testing as testing
from paraview import servermanager, simple

REPRESENTATIONS = ("Voxel Lines", "Illuminated Lines", "Fourier Opacity")
# By the samples, on lines; 40 would be another picture.
BOUND = 5.0
# Something that each tells of its last frame.
IN_USE = {"Voxel Lines": ("RadiusInUse", "EngineInUse", "QualityInUse"),
          "Illuminated Lines": ("NumberOfDrawnSegments",),
          "Fourier Opacity": ("OpacityMemory", "NumberOfAccumulatedOpacityPictures")}


def make_scene(path):
    source = simple.XMLPolyDataReader(FileName=[path])
    view = testing.make_view((200, 200))
    view.CameraParallelProjection = 1
    view.CameraPosition = [4.0, 3.0, 5.0]
    view.CameraFocalPoint = [0.0, 0.0, 1.0]
    view.CameraParallelScale = 1.5
    return source, view


def show(source, view, representation):
    display = simple.Show(source, view)
    display.Representation = representation
    simple.ColorBy(display, ("POINTS", "Height"))
    display.ImportanceArray = "Height"
    display.LineWidth = 3.0
    display.Opacity = 0.5
    return display


def draw(view):
    """The picture in blocks of 4 x 4 pixels: a client's window and a server's make pixels of lines that
    are wider than one by other rules, for ParaView's own Wireframe as well."""
    for _ in range(2):
        simple.Render(view)
    picture = testing.take_picture(view, "TestClientServer")
    return picture.reshape(50, 4, 50, 4, 3).mean(axis=(1, 3))


def select(source, view):
    """Ids of what is selected in the middle of the view."""
    simple.ClearSelection(source)
    simple.SelectSurfaceCells(View=view, Rectangle=[90, 90, 110, 110])
    selection = servermanager._getPyProxy(source.SMProxy.GetSelectionInput(0))
    ids = set()
    for node in selection.Input if selection else ():
        ids |= set(list(node.IDs)[1::2])
    simple.ClearSelection(source)
    return ids


def tell(display, representation):
    """What is told to be in use."""
    display.UpdatePropertyInformation()
    return {name: display.GetProperty(name).GetData() for name in IN_USE[representation]}


def draw_all(source, view):
    pictures = {}
    for representation in REPRESENTATIONS:
        display = show(source, view, representation)
        picture = draw(view)
        pictures[representation] = picture, tell(display, representation), select(source, view)
        simple.Hide(source, view)
    return pictures


def compare(path, alone):
    """All that is drawn by the server or from its data, against what the client alone draws."""
    source, view = make_scene(path)
    view.LODThreshold = 0.0
    for mode, threshold in (("remote", 0.0), ("local", 1000.0)):
        view.RemoteRenderThreshold = threshold
        for representation in REPRESENTATIONS:
            what = "%s, %s" % (representation, mode)
            display = show(source, view, representation)
            expected, in_use, ids = alone[representation]
            picture = draw(view)
            is_remote = view.SMProxy.GetClientSideObject().GetUseDistributedRenderingForRender()
            testing.check(bool(is_remote) == (mode == "remote"), "%s: where it is drawn" % what)
            difference = testing.rmse(picture, expected)
            print(what, difference, flush=True)
            testing.check(difference <= BOUND, "%s: differs by %.2f" % (what, difference))
            told = tell(display, representation)
            testing.check(all(told.values()) and all(in_use.values()) and all(
                # Pictures have other sizes.
                told[key] == in_use[key] for key in told if key != "OpacityMemory"),
                          "%s: %s in use, not %s" % (what, told, in_use))
            for _ in range(2):
                view.SMProxy.InteractiveRender()
            difference = testing.rmse(draw(view), expected)
            testing.check(difference <= BOUND, "%s: differs by %.2f after interaction" % (
                what, difference))
            testing.check(ids and select(source, view) == ids, "%s: selection" % what)
            simple.Hide(source, view)


def compare_moving(path, alone):
    """Something large beside the lines is drawn by the server, its level of detail by the client."""
    source, view = make_scene(path)
    view.LODThreshold = 0.0
    # In MiB: more than the level of detail, less than the whole, in each version of ParaView.
    view.RemoteRenderThreshold = 16.0
    view.UseInteractiveRenderingForScreenshots = 1
    sphere = simple.Sphere(Center=[20.0, 0.0, 0.0], ThetaResolution=400, PhiResolution=400)
    simple.Show(sphere, view)
    for representation in REPRESENTATIONS:
        show(source, view, representation)
        simple.Render(view)
        lines = abs(alone[representation][0] - alone[representation][0][0, 0]).max(axis=2) > 10.0
        view.SMProxy.InteractiveRender()
        picture = draw(view)
        seen = view.SMProxy.GetClientSideObject()
        testing.check(seen.GetUsedLODForLastRender() and
                      seen.GetUseDistributedRenderingForRender() and
                      not seen.GetUseDistributedRenderingForLODRender(),
                      "%s: the client draws while the view is moved" % representation)
        moving = abs(picture - picture[0, 0]).max(axis=2) > 10.0
        print(representation, "moving", moving.sum(), "of", lines.sum(), flush=True)
        testing.check(moving.sum() > 0.1 * lines.sum(), "%s: is there while moved" % representation)
        simple.Hide(source, view)
    simple.Delete(sphere)


testing.load_plugin()
messages = testing.Messages()
path = testing.write_lines(testing.make_helices(20), "TestClientServer")
alone = draw_all(*make_scene(path))
with linesets_server.Server("TestClientServer"):
    compare(path, alone)
    compare_moving(path, alone)
said = messages.take()
testing.check(not said, "the client says nothing: %s" % said)
