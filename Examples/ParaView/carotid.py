# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Blood flow in the arteries of a head, drawn by the LineSets plugin in ParaView.

    pvpython carotid.py LineSets.so --output picture.png [--representation "Fourier Opacity"]
    paraview --script=carotid.py       (after loading the plugin by hand)

Works in ParaView's window, in pvpython and in pvbatch.
"""
import argparse
import os

from paraview.simple import *


def trace(data):
    """Streamlines that begin where the blood flows fast."""
    flow = XMLImageDataReader(registrationName="carotid", FileName=[data])
    fast = Threshold(registrationName="fast flow", Input=flow, Scalars=["POINTS", "speed"],
                     ThresholdMethod="Above Upper Threshold", UpperThreshold=4.0)
    seeds = MaskPoints(registrationName="seeds", Input=fast, OnRatio=1, MaximumNumberofPoints=2400,
                       RandomSampling=1, RandomSamplingMode="Random Sampling")
    lines = StreamTracerWithCustomSource(registrationName="streamlines", Input=flow,
                                         SeedSource=seeds)
    lines.Vectors = ["POINTS", "velocity"]
    lines.MaximumStreamlineLength = 100
    lines.TerminalSpeed = 1.2
    return lines


def draw(lines, representation, view):
    """Shows the lines as the representation does best."""
    display = Show(lines, view)
    ColorBy(display, ("POINTS", "speed"))
    # Few lines are faster.
    GetColorTransferFunction("speed").RescaleTransferFunction(0.0, 12.0)
    display.Representation = representation
    if representation == "Voxel Lines":
        display.Radius = 0.12
    elif representation == "Fourier Opacity":
        display.ImportanceArray = ["POINTS", "speed"]
        display.LineWidth = 1.5
    else:
        display.LineWidth = 1.5
    return display


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("plugin", nargs="?", help="LineSets.so, where it is not loaded already")
parser.add_argument("--representation", default="Voxel Lines",
                    choices=("Voxel Lines", "Illuminated Lines", "Fourier Opacity"))
parser.add_argument("--output", help="a PNG to write; default: none, as in ParaView's window")
arguments = parser.parse_args()
if arguments.plugin:
    LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=globals())

here = os.path.dirname(os.path.abspath(__file__))
streamlines = trace(os.path.join(here, "..", "..", "Testing", "Data", "carotid.vti"))
view = GetActiveViewOrCreate("RenderView")
if arguments.output:
    view.ViewSize = [1024, 768]
draw(streamlines, arguments.representation, view)
view.CameraFocalPoint = [0.0, 0.0, 0.0]
view.CameraPosition = [0.3, -0.9, 0.35]
view.CameraViewUp = [0.0, 0.0, 1.0]
ResetCamera(view)
GetActiveCamera().Zoom(1.3)
Render(view)
if arguments.output:
    SaveScreenshot(arguments.output, view)
