# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards animations: each time step looks as it does when it is opened alone, also where steps are
empty, where the geometry of steps is cached, and where one goes back."""
import os

import linesets_testing as testing
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkPolyData

REPRESENTATIONS = ("Voxel Lines", "Illuminated Lines", "Fourier Opacity")
EMPTY = 2  # the step without lines


def draw(view, name):
    # Opacities of a step may depend on the one before for some frames.
    for _ in range(2):
        simple.Render(view)
    return testing.take_picture(view, name)


testing.load_plugin()
messages = testing.Messages()
view = testing.make_view((150, 150))
view.CameraPosition = [1.5, 0.0, 8.0]
view.CameraFocalPoint = [1.5, 0.0, 0.0]
files = []
for step in range(4):
    data = testing.make_helices(3 + 3 * step, shift=float(step))
    files.append(testing.write_lines(vtkPolyData() if step == EMPTY else data,
                                     "TestAnimation%d" % step))
collection = os.path.join(testing.OUTPUT, "TestAnimation.pvd")
with open(collection, "w", encoding="utf-8") as file:
    file.write('<VTKFile type="Collection" version="0.1"><Collection>')
    for step, name in enumerate(files):
        file.write('<DataSet timestep="%d" part="0" file="%s"/>' % (step, os.path.basename(name)))
    file.write("</Collection></VTKFile>")

alone = {}
for representation in REPRESENTATIONS:
    for step, name in enumerate(files):
        reader = simple.XMLPolyDataReader(FileName=[name])
        testing.show_by_height(reader, view, representation)
        alone[representation, step] = draw(view, "TestAnimationAlone")
        simple.Delete(reader)

series = simple.PVDReader(FileName=collection)
settings = simple.GetSettingsProxy("GeneralSettings")
scene = simple.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
for is_cached in (0, 1):
    settings.CacheGeometryForAnimation = is_cached
    for representation in REPRESENTATIONS:
        testing.show_by_height(series, view, representation)
        for step in (0, 1, 2, 3, 1, 0, 2, 0):
            scene.AnimationTime = float(step)
            picture = draw(view, "TestAnimation")
            difference = testing.rmse(picture, alone[representation, step])
            testing.check(difference <= 1.0, "%s, step %d%s: differs by %.2f" % (
                representation, step, " cached" if is_cached else "", difference))
        print(representation, is_cached, flush=True)
        simple.Hide(series, view)
said = messages.take()
testing.check(not said, "nothing is said: %s" % said)
