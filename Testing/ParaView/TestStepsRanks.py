# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""
Guards time steps on several ranks: a step without lines ends nothing, the steps around it are those of
one rank, and so is what is drawn while the view is moved, at once after a change. One rank goes first
and leaves its pictures.
"""
import os

import linesets_ranks as ranks
import linesets_testing as testing
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkCellArray


def make_empty():
    """No lines, but with the arrays of helices."""
    data = testing.make_helices(1, 2)
    data.SetPoints(type(data.GetPoints())())
    data.SetLines(vtkCellArray())
    for attributes in (data.GetPointData(), data.GetCellData()):
        for i in range(attributes.GetNumberOfArrays()):
            attributes.GetArray(i).Initialize()
    return data


def check_alone(picture, key, bound=1.0):
    """Compares a picture with that of one rank."""
    if ranks.RANKS == 1:
        return
    alone = os.path.join(testing.OUTPUT, key + "-1.png")
    testing.check(os.path.exists(alone), "one rank has left " + alone)
    difference = testing.rmse(picture, testing.read_picture(alone))
    print("%s: RMSE %.2f of 255 to one rank" % (key, difference), flush=True)
    testing.check(difference < bound, "%s differs from one rank's by %.2f" % (key, difference))


testing.load_plugin()
path = os.path.join(testing.OUTPUT, "TestSteps-%d.pvd" % ranks.RANKS)
steps = [ranks.write_pieces(data, "TestSteps%d" % i) for i, data in enumerate(
    (testing.make_helices(20), make_empty(), testing.make_helices(40, shift=0.6)))]
if ranks.RANK == 0:
    with open(path, "w", encoding="utf-8") as file:
        file.write('<VTKFile type="Collection" version="0.1"><Collection>')
        for i, name in enumerate(steps):
            file.write('<DataSet timestep="%d" part="0" file="%s"/>' % (i, name))
        file.write("</Collection></VTKFile>")
ranks.CONTROLLER.Barrier()

series = simple.PVDReader(FileName=path)
view = testing.make_view((150, 150))
view.UseFXAA = 0
view.CameraPosition = [4.0, 3.0, 3.5]
view.CameraFocalPoint = [0.0, 0.0, 1.0]
view.CameraViewUp = [0.0, 0.0, 1.0]
view.LODThreshold = 0.0
scene = simple.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
display = simple.Show(series, view)
testing.color_by(display, "POINTS", "Height", 0.0, 2.0)
display.ImportanceArray = "Height"
display.Radius = 0.02
for name in ("Voxel Lines", "Illuminated Lines", "Fourier Opacity"):
    display.Representation = name
    for step in (0, 1, 2, 1, 0):
        scene.AnimationTime = step
        simple.Render(view)
        key = "TestSteps%s%d" % (name.replace(" ", ""), step)
        picture = ranks.take_picture(view, key)
        if ranks.RANK != 0:
            continue
        drawn = (abs(picture - picture[0, 0]).max(axis=2) > 10.0).sum()
        testing.check((drawn > 1000) == (step != 1), "%s, step %d: %d" % (name, step, drawn))
        check_alone(picture, key)

# Voxel lines have a level of detail of the same lines.
display.Representation = "Voxel Lines"
view.UseInteractiveRenderingForScreenshots = 1
# Several ranks would draw fewer pixels.
view.ImageReductionFactor = 1
before = None
for name, value in (("Radius", 0.01), ("Opacity", 0.5), ("Resolution", 64)):
    setattr(display, name, value)
    view.InteractiveRender()
    key = "TestStepsMoving" + name
    picture = ranks.take_picture(view, key)
    testing.check(view.GetClientSideObject().GetUsedLODForLastRender(), "a level of detail is drawn")
    if ranks.RANK == 0:
        drawn = (abs(picture - picture[0, 0]).max(axis=2) > 10.0).sum()
        testing.check(drawn > 1000, "moving after another %s: %d" % (name, drawn))
        changed = 0.0 if before is None else testing.rmse(picture, before)
        testing.check(before is None or changed > 3.0,
                      "moving after another %s: changed by %.2f" % (name, changed))
        check_alone(picture, key, 3.0)
        before = picture
