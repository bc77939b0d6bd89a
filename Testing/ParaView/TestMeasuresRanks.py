# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""
Guards that several ranks measure voxel lines again where what is measured may have changed: after another
array of radii or colours, another association or component of it, colours that are mapped or not, and
other lines. Each picture must be the one of a representation that has drawn nothing before.
"""
import os

import linesets_ranks as ranks
import linesets_testing as testing
from paraview import simple
from vtkmodules.vtkCommonCore import vtkDoubleArray

# The second lines are larger, so that none of them would be in the bounds of the first ones.
SHIFTS = (0.0, 3.0)
# All colours but one are at small values, by which the lines of the first rank are told apart from
# those that are rounded to a part of the range of all.
COLORS = [0.0, 0.2, 0.4, 0.9, 3.0, 0.9, 0.9, 0.9, 6.0, 0.9, 0.3, 0.1, 90.0, 0.2, 0.9, 0.2]


def make_lines(shift):
    """Helices with arrays whose ranges differ by a factor of 10 and more."""
    number = 12
    data = testing.make_helices(number, shift=shift)
    points = data.GetNumberOfPoints()

    def add(attributes, name, tuples):
        array = vtkDoubleArray()
        array.SetName(name)
        array.SetNumberOfComponents(len(tuples[0]))
        for values in tuples:
            array.InsertNextTuple(values)
        attributes.AddArray(array)
    along = [(i % 100) / 99.0 for i in range(points)]
    # The second half of the pieces is the last rank's.
    scale = [1.0 if i // 100 % 4 > 1 else 0.05 for i in range(points)]
    add(data.GetPointData(), "Small", [(2.0 * t,) for t in along])
    add(data.GetCellData(), "Small", [(5.0 * line,) for line in range(number)])
    add(data.GetPointData(), "Vector",
        [(2.0 * s * t, 10.0 * s * (1.0 - t), 80.0 * s * t) for s, t in zip(scale, along)])
    add(data.GetPointData(), "Thin", [(0.005 + 0.005 * t,) for t in along])
    add(data.GetPointData(), "Thick", [(0.02 + 0.03 * t,) for t in along])
    return data


# Each rank keeps its lines where tubes hide all behind them.
SETTINGS = {"RadiusArray": "Thin", "ColorArrayName": ["POINTS", "Small"], "MapScalars": 1,
            "SubPixelCoverage": 0}
# What is changed, one after the other, and the mode and component of the colour map.
CHANGES = (({}, "Component", 2),
           ({"RadiusArray": "Thick"}, "Component", 2),
           ({"ColorArrayName": ["CELLS", "Small"]}, "Component", 2),
           ({"ColorArrayName": ["POINTS", "Vector"], "MapScalars": 0}, "Component", 2),
           ({"MapScalars": 1}, "Component", 2),
           ({}, "Component", 0),
           ({}, "Magnitude", 0),
           ({"ColorArrayName": ["POINTS", "Small"]}, "Magnitude", 0))


def show(source, view, settings):
    display = simple.Show(source, view)
    display.Representation = "Voxel Lines"
    display.LookupTable = table
    for name, value in settings.items():
        setattr(display, name, value)
    return display


def draw(view, shift):
    view.CameraPosition = [4.0 + shift, 3.0, 3.5]
    view.CameraFocalPoint = [shift, 0.0, 1.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    # Whether tubes are thin is known after the first picture.
    for _ in range(2):
        simple.Render(view)
    return ranks.take_picture(view, "TestMeasuresRanks")


def check_same(settings, shift, what):
    """The picture against that of a new representation."""
    picture = draw(view, shift)
    simple.Hide(source, view)
    other = simple.PVDReader(FileName=path)
    show(other, view, settings)
    expected = draw(view, shift)
    simple.Delete(other)
    simple.Show(source, view)
    if ranks.RANK == 0:
        drawn = (abs(expected - expected[0, 0]).max(axis=2) > 10.0).sum()
        difference = abs(picture - expected).max()
        print(what, drawn, difference, flush=True)
        testing.check(drawn > 1000, "%s: %d pixels" % (what, drawn))
        testing.check(difference <= 1.0, "%s: differs by %d" % (what, difference))


testing.load_plugin()
messages = testing.Messages()
table = simple.GetColorTransferFunction("Measures")
table.ColorSpace = "RGB"
table.RGBPoints = COLORS
path = os.path.join(testing.OUTPUT, "TestMeasures-%d.pvd" % ranks.RANKS)
steps = [ranks.write_pieces(make_lines(shift), "TestMeasures%d" % i)
         for i, shift in enumerate(SHIFTS)]
if ranks.RANK == 0:
    with open(path, "w", encoding="utf-8") as file:
        file.write('<VTKFile type="Collection" version="0.1"><Collection>%s</Collection></VTKFile>'
                   % "".join('<DataSet timestep="%d" part="0" file="%s"/>' % step
                             for step in enumerate(steps)))
ranks.CONTROLLER.Barrier()
source = simple.PVDReader(FileName=path)
scene = simple.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
settings = dict(SETTINGS)
view = testing.make_view((120, 120))
view.UseFXAA = 0
display = show(source, view, settings)
for change, mode, component in CHANGES:
    settings.update(change)
    for name, value in change.items():
        setattr(display, name, value)
    table.VectorMode = mode
    table.VectorComponent = component
    check_same(settings, 0.0, "%s %s %d" % (change, mode, component))
scene.AnimationTime = 1
check_same(settings, SHIFTS[1], "other lines")
# Nothing is held against the ranges of another array.
said = messages.take()
testing.check(not said, "no errors and no warnings: %s" % said)
