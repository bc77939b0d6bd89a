# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the lines of a file (.vtp, .vtk) as tubes or as lit lines, into a window or a picture; with
--importance what hides important lines fades."""
import argparse
import os

import vtkmodules.vtkInteractionStyle
from linesets import vtkFourierOpacityMapper, vtkIlluminatedLineMapper, vtkVoxelLineMapper
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

# In the order of the values of vtkLineGlobalIllumination.
SHADOWS = ("none", "hard", "level", "soft")
OCCLUSIONS = ("none", "spherical", "hemisphere")
parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("file")
parser.add_argument("--radius", type=float, default=0.0, help="in data units; 0: by size")
parser.add_argument("--line-width", type=float, metavar="W",
                    help="draw lines of so many pixels in place of tubes")
parser.add_argument("--opacity", type=float, default=1.0)
parser.add_argument("--color-by", metavar="ARRAY", help="of points or cells; vectors by magnitude")
parser.add_argument("--importance", metavar="ARRAY",
                    help="of points or cells: lines of low values fade where they hide high ones")
parser.add_argument("--shadows", choices=SHADOWS, default="none")
parser.add_argument("--occlusion", choices=OCCLUSIONS, default="none")
parser.add_argument("--size", default="1024x768", metavar="WxH")
parser.add_argument("--output", metavar="PNG", help="without it, a window opens")
options = parser.parse_args()
if options.importance and options.line_width is None:
    options.line_width = 1.0
if options.line_width is not None and (options.shadows, options.occlusion) != ("none", "none"):
    parser.error("--shadows and --occlusion are for tubes, not for --line-width or --importance")

if not os.path.isfile(options.file):
    parser.error(f"there is no file {options.file}")
reader = vtkPolyDataReader() if options.file.endswith(".vtk") else vtkXMLPolyDataReader()
reader.SetFileName(options.file)
reader.Update()
lines = reader.GetOutput()
if lines.GetNumberOfLines() == 0:
    parser.error(f"{options.file} holds no lines")
def find_array(name):
    """The array of points or else of cells, and which of the two."""
    for data in (lines.GetPointData(), lines.GetCellData()):
        if data.GetArray(name):
            return data.GetArray(name), data is lines.GetPointData()
    names = [data.GetArrayName(i) or "" for data in (lines.GetPointData(), lines.GetCellData())
             for i in range(data.GetNumberOfArrays())]
    return parser.error(f'there is no array "{name}", but {" ".join(names) or "none"}')


if options.importance:
    find_array(options.importance)
    mapper = vtkFourierOpacityMapper()
    mapper.SetImportanceArrayName(options.importance)
elif options.line_width is None:
    mapper = vtkVoxelLineMapper()
    mapper.SetRadius(options.radius)
    mapper.GetGlobalIllumination().SetShadows(SHADOWS.index(options.shadows))
    mapper.GetGlobalIllumination().SetOcclusion(OCCLUSIONS.index(options.occlusion))
else:
    mapper = vtkIlluminatedLineMapper()
mapper.SetInputData(lines)
mapper.SetScalarVisibility(options.color_by is not None)
if options.color_by:
    array, on_points = find_array(options.color_by)
    table = mapper.GetLookupTable()
    table.SetHueRange(0.667, 0.0)
    table.SetVectorModeToMagnitude()
    mapper.SetScalarRange(array.GetFiniteRange(-1 if array.GetNumberOfComponents() > 1 else 0))
    mapper.SetScalarMode(3 if on_points else 4)  # VTK_SCALAR_MODE_USE_..._FIELD_DATA
    mapper.SelectColorArray(options.color_by)
actor, renderer, window = vtkActor(), vtkRenderer(), vtkRenderWindow()
actor.SetMapper(mapper)
actor.GetProperty().SetOpacity(options.opacity)
actor.GetProperty().SetLineWidth(options.line_width or 1)
renderer.AddActor(actor)
renderer.SetBackground(1, 1, 1)
window.AddRenderer(renderer)
window.SetMultiSamples(0 if options.line_width is None else 8)  # ray cast tubes take no samples
window.SetSize([int(length) for length in options.size.split("x")])
window.SetOffScreenRendering(options.output is not None)
renderer.GetActiveCamera().SetPosition(0, -1, 0.3)
renderer.GetActiveCamera().SetViewUp(0, 0, 1)
renderer.ResetCameraScreenSpace()
if options.shadows != "none":
    # The headlight that VTK makes by itself casts no shadows that are seen: what lies in them lies
    # behind what casts them, for the camera as well. So a light is put into the scene, to the upper
    # right of the first view, where it stays while the camera moves. A weak headlight keeps what is
    # in the shadow from being black.
    camera, sun, fill = renderer.GetActiveCamera(), vtkLight(), vtkLight()
    # In coordinates in which the camera looks from (0, 0, 1) to the origin.
    sun.SetPosition(camera.GetCameraLightTransformMatrix().MultiplyPoint((1, 1, 1, 1))[:3])
    sun.SetFocalPoint(camera.GetFocalPoint())
    sun.SetLightTypeToSceneLight()
    sun.SetIntensity(0.8)
    fill.SetLightTypeToHeadlight()
    fill.SetIntensity(0.4)
    renderer.AddLight(sun)
    renderer.AddLight(fill)
window.Render()
if options.output:
    picture, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    picture.SetInput(window)
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(options.output)
    writer.Write()
else:
    window.MakeRenderWindowInteractor().Start()
