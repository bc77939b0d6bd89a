# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards that bad input is told in one clear message each, not at every frame, and that the rest is
drawn: surfaces, vertices, lines of one point, points that are NaN, arrays that are missing."""
import linesets_testing as testing
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource

VOXELS, LIT, FOURIER = "Voxel Lines", "Illuminated Lines", "Fourier Opacity"
NOTHING_IMPORTANT = "that could tell importance"


def make_sphere():
    source = vtkSphereSource()
    source.Update()
    return source.GetOutput()


def make_vertices():
    data = vtkPolyData()
    data.SetPoints(testing.make_helices(1).GetPoints())
    cells = vtkCellArray()
    for i in range(50):
        cells.InsertNextCell(1)
        cells.InsertCellPoint(i)
    data.SetVerts(cells)
    return data


def make_one_point():
    data = testing.make_helices(5)
    data.GetLines().InsertNextCell(1)
    data.GetLines().InsertCellPoint(3)
    data.GetCellData().GetArray(0).InsertNextValue(1.0)
    return data


def make_nan():
    data = testing.make_helices(5)
    data.GetPoints().SetPoint(50, float("nan"), 0.0, 0.0)
    return data


# Input; what is said of it for each representation; for which of them something is drawn.
CASES = (
    ("empty", vtkPolyData(), {VOXELS: (), LIT: (), FOURIER: ()}, ()),
    ("surface", make_sphere(),
     {VOXELS: ("no lines, only 96 other cells",), LIT: ("no lines, only other cells",),
      FOURIER: (NOTHING_IMPORTANT,)}, (LIT, FOURIER)),
    ("vertices", make_vertices(),
     {VOXELS: ("no lines, only 50 other cells",), LIT: ("no lines, only other cells",),
      FOURIER: (NOTHING_IMPORTANT,)}, (LIT, FOURIER)),
    ("one point", make_one_point(),
     {VOXELS: ("1 lines of fewer than two points",), LIT: (),
      FOURIER: ("1 lines of fewer than two points", NOTHING_IMPORTANT)}, (VOXELS, LIT, FOURIER)),
    ("not finite", make_nan(),
     {VOXELS: ("1 points that are not finite",), LIT: ("1 points of lines",),
      FOURIER: ("1 points that are not finite", "1 points of lines", NOTHING_IMPORTANT)},
     (VOXELS, LIT, FOURIER)),
)

testing.load_plugin()
messages = testing.Messages()
view = testing.make_view((200, 200))


def check_messages(what, expected):
    """Each of the texts is said once, and nothing else."""
    said = messages.take()
    for text in expected:
        testing.check(sum(text in one for one in said) == 1,
                      '%s: "%s" once in %s' % (what, text, said))
    testing.check(len(said) == len(expected), "%s: nothing else in %s" % (what, said))


def draw(what):
    """Draws several frames; returns how many pixels are no background."""
    for _ in range(2):
        simple.Render(view)
    picture = testing.take_picture(view, "TestBadInput")
    print(what, flush=True)
    return (abs(picture - picture[0, 0]).max(axis=2) > 20.0).sum()


for name, data, said, drawn in CASES:
    source = simple.XMLPolyDataReader(FileName=[testing.write_lines(data, "bad")])
    for representation in (VOXELS, LIT, FOURIER):
        what = "%s by %s" % (name, representation)
        display = simple.Show(source, view)
        display.ColorArrayName = ["POINTS", ""]
        display.Representation = representation
        display.ImportanceArray = ["POINTS", ""]  # ParaView chooses the first one
        simple.ResetCamera(view)
        pixels = draw(what)
        check_messages(what, said[representation])
        testing.check((pixels > 50) == (representation in drawn), "%s: %d pixels" % (what, pixels))
    simple.Delete(source)

source = simple.XMLPolyDataReader(FileName=[testing.write_lines(testing.make_helices(5), "bad")])
for representation in (VOXELS, LIT, FOURIER):
    for association in ("POINTS", "CELLS"):
        what = "missing array of %s by %s" % (association, representation)
        display = simple.Show(source, view)
        display.Representation = representation
        display.ImportanceArray = "Height"
        display.ColorArrayName = [association, "Nothing"]
        simple.ResetCamera(view)
        testing.check(draw(what) > 50, "%s: drawn" % what)
        check_messages(what, ("no array",))
