# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards views: the same lines in two views by two representations, of different size; parallel and
perspective cameras, by which lines are where ParaView's own are; placement of the representation and
coordinates far away; decoration; and lines before, in and behind a translucent surface, for which
ParaView peels depths."""
import linesets_testing as testing
import numpy
from paraview import simple

REPRESENTATIONS = ("Voxel Lines", "Illuminated Lines", "Fourier Opacity")


def show(source, view, representation):
    display = testing.show_by_height(source, view, representation)
    if representation == "Voxel Lines":
        display.Radius = 0.02
    display.LineWidth = 3
    return display


def look(view, center=(0.0, 0.0, 1.0), scale=1.0):
    view.CameraFocalPoint = list(center)
    view.CameraPosition = [center[0] + 3.0 * scale, center[1] + 4.0 * scale,
                           center[2] + 2.0 * scale]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraParallelScale = 1.4 * scale


def draw(view, name="TestViews"):
    for _ in range(2):
        simple.Render(view)
    return testing.take_picture(view, name)


def count(picture):
    """Pixels that are no background."""
    return int((abs(picture - picture[0, 0]).max(axis=2) > 20.0).sum())


def find_lines(picture):
    return abs(picture - picture[0, 0]).max(axis=2) > 20.0


def get_share_near(a, b):
    """Share of the pixels of a that are a pixel or less from one of b."""
    wide = numpy.zeros_like(b)
    for y in (-1, 0, 1):
        for x in (-1, 0, 1):
            wide |= numpy.roll(b, (y, x), (0, 1))
    return (a & wide).sum() / a.sum()


def draw_plainly(view, name):
    """ParaView's own lines, alone and with the sphere around their middle."""
    display = simple.Show(plain_source, view)
    display.Representation = "Surface"
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [1.0, 0.0, 0.0]
    display.LineWidth = 3
    plain = draw(view, name)
    show_sphere(view)
    both = draw(view, name + "Sphere")
    simple.Hide(sphere, view)
    simple.Hide(plain_source, view)
    return plain, both


def show_sphere(view):
    around = simple.Show(sphere, view)
    around.Opacity = 0.3
    around.AmbientColor = around.DiffuseColor = [0.0, 1.0, 0.0]
    around.ColorArrayName = ["POINTS", ""]


def check_order(plain, both, expected, what):
    """Of opaque lines those are green that ParaView's own lines show behind the sphere's surface."""
    lines = find_lines(plain) & find_lines(expected[0])
    before, behind = [numpy.abs(b - a)[lines].max(axis=1) > 15.0
                      for a, b in ((plain, both), expected)]
    share = (before == behind).mean()
    print(what, "order", share, behind.mean(), flush=True)
    testing.check(0.1 < behind.mean() < 0.9, "%s: there are lines on both sides" % what)
    testing.check(share > 0.95, "%s: only %.2f of the lines are in order" % (what, share))


testing.load_plugin()
messages = testing.Messages()
helices = testing.make_helices(12)
path = testing.write_lines(helices, "TestViews")
source, plain_source = [simple.XMLPolyDataReader(FileName=[path]) for _ in range(2)]
# Floats would be a sixteenth apart there.
FAR = 1e6
far = testing.make_helices(12, shift=FAR, is_double=True)
far_source = simple.XMLPolyDataReader(FileName=[testing.write_lines(far, "TestViewsFar")])
view = testing.make_view((200, 200))
sphere = simple.Sphere(Radius=0.5, Center=[0.0, 0.0, 1.0], ThetaResolution=32, PhiResolution=32)

for representation in REPRESENTATIONS:
    for is_parallel in (0, 1):
        what = "%s, %s" % (representation, "parallel" if is_parallel else "perspective")
        view.CameraParallelProjection = is_parallel
        look(view)
        surface = draw_plainly(view, "TestViewsSurface%d" % is_parallel)
        display = show(source, view, representation)
        look(view)
        plain = draw(view, "TestViews%s%d" % (representation.replace(" ", ""), is_parallel))
        testing.check(count(plain) > 2000, "%s: drawn" % what)
        lines, expected = find_lines(plain), find_lines(surface[0])
        near = get_share_near(lines, expected), get_share_near(expected, lines)
        print(what, "near", near, flush=True)
        testing.check(min(near) > 0.95, "%s: lines are where ParaView's are: %s" % (what, near))
        if representation != "Fourier Opacity":
            show_sphere(view)
            check_order(plain, draw(view, "TestViewsOrder"), surface, what)
            simple.Hide(sphere, view)

        # Moved and scaled together with the camera, nothing changes.
        display.Translation = [10.0, 0.0, 0.0]
        display.Scale = [2.0, 2.0, 2.0]
        look(view, (10.0, 0.0, 2.0), 2.0)
        difference = testing.rmse(draw(view), plain)
        testing.check(difference <= 4.0, "%s: placed, differs by %.2f" % (what, difference))
        # Half a turn about z with the camera, too.
        display.Translation = [0.0, 0.0, 0.0]
        display.Scale = [1.0, 1.0, 1.0]
        display.Orientation = [0.0, 0.0, 180.0]
        look(view)
        view.CameraPosition = [-3.0, -4.0, 3.0]
        difference = testing.rmse(draw(view), plain)
        testing.check(difference <= 6.0, "%s: turned, differs by %.2f" % (what, difference))
        display.Orientation = [0.0, 0.0, 0.0]

        # A quarter of the opacity: fainter, and not gone.
        look(view)
        display.Opacity = 0.25
        faint = draw(view)
        background = plain[0, 0]
        ratio = abs(faint - background).mean() / abs(plain - background).mean()
        testing.check(0.1 < ratio < 0.8, "%s: opacity 0.25 gives %.2f" % (what, ratio))

        # A translucent surface around the middle changes what is behind it and hides nothing.
        show_sphere(view)
        both = draw(view, "TestViewsSphere%s%d" % (representation.replace(" ", ""), is_parallel))
        middle = (both - faint)[80:120, 80:120]
        testing.check(middle[:, :, 1].mean() > 10.0, "%s: the surface is seen: %.1f" % (
            what, middle[:, :, 1].mean()))
        testing.check(both[80:120, 80:120, 0].std() > 3.0, "%s: lines are seen through it" % what)
        simple.Hide(sphere, view)
        display.Opacity = 1.0
        simple.Hide(source, view)

        # Far from the origin as near it.
        show(far_source, view, representation)
        look(view, (FAR, 0.0, 1.0))
        difference = testing.rmse(draw(view, "TestViewsFar" + representation.replace(" ", "")),
                                  plain)
        testing.check(difference <= 0.5, "%s: far away, differs by %.2f" % (what, difference))
        simple.Hide(far_source, view)
        print(what, flush=True)

    # A scalar bar and axes are beside the lines and leave them as they are.
    display = show(source, view, representation)
    view.CameraParallelProjection = 0
    look(view)
    plain = draw(view)
    display.SetScalarBarVisibility(view, True)
    view.OrientationAxesVisibility = 1
    decorated = draw(view, "TestViewsDecorated")
    testing.check(testing.rmse(decorated[100:, :100], plain[100:, :100]) <= 1.0,
                  "%s: the decorated picture where nothing else is" % representation)
    testing.check(testing.rmse(decorated, plain) > 2.0, "%s: decoration" % representation)
    display.SetScalarBarVisibility(view, False)
    view.OrientationAxesVisibility = 0
    simple.Hide(source, view)

# Two views of one source; each is as if it were alone.
other = testing.make_view((120, 160))
other.Background = [0.3, 0.0, 0.0]
for first, second in (("Voxel Lines", "Fourier Opacity"), ("Illuminated Lines", "Voxel Lines"),
                      ("Fourier Opacity", "Illuminated Lines")):
    pictures = []
    for one, representation in ((view, first), (other, second)):
        show(source, one, representation)
        look(one)
        pictures.append(draw(one))
    for _ in range(2):
        for one, expected in zip((view, other), pictures):
            difference = testing.rmse(draw(one), expected)
            testing.check(difference <= 1.0, "%s and %s: differs by %.2f" % (
                first, second, difference))
    print(first, second, flush=True)
said = messages.take()
testing.check(not said, "nothing is said: %s" % said)
