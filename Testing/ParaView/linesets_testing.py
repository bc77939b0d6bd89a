# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the plugin share: the plugin, lines to draw, pictures to compare."""
import math
import os
import sys

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import (VTK_STRING, vtkDoubleArray, vtkLogger, vtkOutputWindow,
                                      vtkPoints)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

SOURCE = os.environ["LINESETS_SOURCE"]
OUTPUT = os.environ["LINESETS_TEST_OUTPUT"]


def load_plugin():
    """Loads the plugin that was built, and fails where that does not work."""
    simple.LoadPlugin(os.environ["LINESETS_PLUGIN"], remote=False, ns=simple.__dict__)


def make_helices(number=40, points=100, shift=0.0, is_double=False):
    """Helices around each other, shifted along x; arrays "Height" (points) and "Helix" (cells)."""
    positions = vtkPoints()
    if is_double:
        positions.SetDataTypeToDouble()
    lines = vtkCellArray()
    height = vtkDoubleArray()
    height.SetName("Height")
    helix = vtkDoubleArray()
    helix.SetName("Helix")
    for line in range(number):
        lines.InsertNextCell(points)
        radius = 0.2 + 0.8 * line / number
        for i in range(points):
            angle = 0.15 * i + 2.4 * line
            z = 2.0 * i / points
            lines.InsertCellPoint(positions.InsertNextPoint(
                radius * math.cos(angle) + shift, radius * math.sin(angle), z))
            height.InsertNextValue(z)
        helix.InsertNextValue(line)
    data = vtkPolyData()
    data.SetPoints(positions)
    data.SetLines(lines)
    data.GetPointData().AddArray(height)
    data.GetCellData().AddArray(helix)
    return data


def write_lines(data, name):
    """Writes the lines into the test's output folder and returns the path, for readers to open."""
    path = os.path.join(OUTPUT, name + ".vtp")
    os.makedirs(OUTPUT, exist_ok=True)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.Write()
    return path


def make_view(size=(300, 300)):
    """A view without decoration, which differs between versions of ParaView."""
    # Cameras are those of the test from the first picture on.
    simple._DisableFirstRenderCameraReset()
    view = simple.CreateView("RenderView")
    view.ViewSize = list(size)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.1, 0.1, 0.2]
    return view


def color_by(display, association, name, low, high):
    """Colours by an array with a map of our own: the default one differs between versions."""
    simple.ColorBy(display, (association, name))
    table = simple.GetColorTransferFunction(name)
    table.ColorSpace = "RGB"
    table.RGBPoints = [low, 0.2, 0.4, 0.9, (low + high) / 2, 0.9, 0.9, 0.9, high, 0.9, 0.3, 0.1]
    return table


def show_by_height(source, view, representation):
    """Shows helices by a representation, coloured by their height, which is what is important."""
    display = simple.Show(source, view)
    display.Representation = representation
    display.ColorArrayName = ["POINTS", "Height"]
    table = simple.GetColorTransferFunction("Height")
    table.RGBPoints = [0.0, 0.0, 0.0, 1.0, 2.0, 1.0, 0.0, 0.0]
    display.LookupTable = table
    display.ImportanceArray = "Height"
    return display


def look_from(view, direction=(1.0, 0.6, 0.4), zoom=1.3):
    """Looks at the middle of everything from a direction that no helix or box is aligned with."""
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = list(direction)
    view.CameraViewUp = [0, 0, 1]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(zoom)


def read_picture(path):
    """The picture as an array of height x width x 3 floats from 0 to 255."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[:, :, :3].astype(float)


def take_picture(view, name):
    """Draws the view into NAME.png of the output folder and returns its pixels."""
    path = os.path.join(OUTPUT, name + ".png")
    os.makedirs(OUTPUT, exist_ok=True)
    simple.SaveScreenshot(path, view)
    return read_picture(path)


class Messages:
    """Listens to errors and warnings, which are not printed from then on, and to notes, which ParaView's
    client shows without opening its window of messages."""

    def __init__(self):
        self.texts = []
        self.notes = []
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)

        def note(_, event, text):
            # What comes before is the place in the source.
            self.texts.append(event.replace("Event", ": ") + text.strip().split("): ", 1)[-1])
        note.CallDataType = VTK_STRING
        window = vtkOutputWindow.GetInstance()
        window.AddObserver("ErrorEvent", note)
        window.AddObserver("WarningEvent", note)

        def keep(_, __, text):
            # What a script prints comes here as well.
            if text.startswith("vtk"):
                self.notes.append(text.strip())
        keep.CallDataType = VTK_STRING
        window.AddObserver("TextEvent", keep)

    def take(self):
        """What was said since the last call."""
        texts = self.texts
        self.texts = []
        return texts

    def take_notes(self):
        """The notes since the last call."""
        notes = self.notes
        self.notes = []
        return notes


def rmse(a, b):
    """Root mean square difference of two pictures, of 255."""
    return math.sqrt(numpy.mean((a - b) ** 2))


def check(condition, message):
    """Ends the test with the message unless the condition holds."""
    if not condition:
        print("FAILED:", message)
        sys.stdout.flush()
        sys.exit(1)


def check_baseline(picture, name, bound=3.0):
    """Compares a picture with Baseline/NAME.png. The bound leaves room for another rasterizer."""
    path = os.path.join(SOURCE, "Testing", "ParaView", "Baseline", name + ".png")
    check(os.path.exists(path), "there is no baseline " + path)
    difference = rmse(picture, read_picture(path))
    print("%s: RMSE %.2f of 255 to the baseline" % (name, difference))
    check(difference <= bound, "%s differs from its baseline by %.2f" % (name, difference))
