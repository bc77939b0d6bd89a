# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards the programs in Examples/: they read both formats of line files, take all their options,
draw the same lines in C++ and Python under the same lights, and refuse what they cannot do
with a message.

    TestExamples.py --render-lines PROGRAM --launcher SCRIPT --source FOLDER --scratch FOLDER
    TestExamples.py ... --lines FOLDER    draws every .vtp file of the folder instead
"""

import argparse
import math
import operator
import pathlib
import statistics
import subprocess
import sys

from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

SKIPPED = 125

parser = argparse.ArgumentParser()
parser.add_argument("--render-lines", required=True)
parser.add_argument("--launcher", required=True)
parser.add_argument("--source", type=pathlib.Path, required=True)
parser.add_argument("--scratch", type=pathlib.Path, required=True)
parser.add_argument("--lines", type=pathlib.Path)
options = parser.parse_args()
options.scratch.mkdir(parents=True, exist_ok=True)


def run(command, *arguments):
    """Runs a program, which has to succeed and to say nothing on the error channel."""
    call = [str(part) for part in (*command, *arguments)]
    done = subprocess.run(call, capture_output=True, text=True)
    assert done.returncode == 0 and not done.stderr, f"{call}: {done.returncode}\n{done.stderr}"


def cxx(*arguments):
    run([options.render_lines], *arguments)


def python(script, *arguments):
    run([sys.executable, options.launcher, options.source / "Examples/Python" / script], *arguments)


def pixels(picture):
    """The picture's size and the list of its colours."""
    reader = vtkPNGReader()
    reader.SetFileName(str(picture))
    reader.Update()
    data = bytes(memoryview(reader.GetOutput().GetPointData().GetScalars()))
    return reader.GetOutput().GetDimensions()[:2], list(zip(data[0::3], data[1::3], data[2::3]))


def covered(picture):
    """Which pixels are not background."""
    return [color != (255, 255, 255) for color in pixels(picture)[1]]


def light_of_shadows(name):
    """What the light that casts shadows does to the brightness of each pixel of lines, in comparison
    with the headlight. It depends less on colours, which are others in C++ and Python."""
    lit, plain = (pixels(options.scratch / f"{name}{end}.png")[1] for end in ("-shadow", ""))
    return [min(4, max(a) / max(*b, 1)) for a, b in zip(lit, plain) if b != (255, 255, 255)]


def correlation(a, b):
    """Pearson's coefficient."""
    def center(values):
        mean = statistics.fmean(values)
        return [value - mean for value in values]

    a, b = center(a), center(b)
    return sum(map(operator.mul, a, b)) / math.hypot(*a) / math.hypot(*b)


def refused(message, *arguments):
    """RenderLines must fail with this message and write no picture."""
    picture = options.scratch / "refused.png"
    picture.unlink(missing_ok=True)
    call = [options.render_lines, *map(str, arguments), "--output", str(picture)]
    done = subprocess.run(call, capture_output=True, text=True)
    assert done.returncode == 1 and message in done.stderr, f"{call}: {done.stderr}"
    assert not picture.exists(), call


def test_examples():
    lines = options.scratch / "lines.vtp"
    python("trace_streamlines.py", options.source / "Testing/Data/carotid.vti", lines,
           "--vectors", "velocity", "--weights", "speed", "--count", 100, "--terminal-speed", 1.2)

    # The same lines in the legacy format, with an array of cells and one of vectors.
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(lines))
    reader.Update()
    data = reader.GetOutput()
    for name, components, fields in (("row", 1, data.GetCellData()), ("place", 3, data.GetPointData())):
        array = vtkFloatArray()
        array.SetName(name)
        array.SetNumberOfComponents(components)
        array.SetNumberOfTuples(data.GetNumberOfCells() if components == 1 else data.GetNumberOfPoints())
        for i in range(array.GetNumberOfValues()):
            array.SetValue(i, i)
        fields.AddArray(array)
    legacy = options.scratch / "lines.vtk"
    writer = vtkPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileTypeToBinary()
    writer.SetFileName(str(legacy))
    assert writer.Write()

    common = ("--radius", 0.3, "--size", "300x200")
    pictures = {}
    for name, draw in (("cxx", cxx), ("python", lambda *a: python("render_lines.py", *a))):
        pictures[name] = options.scratch / f"{name}.png"
        draw(lines, *common, "--color-by", "speed", "--output", pictures[name])
        size, colors = pixels(pictures[name])
        assert size == (300, 200), size
        assert len(set(colors)) > 50, f"{name}: only {len(set(colors))} colours"
        share = sum(covered(pictures[name])) / len(colors)
        assert 0.05 < share < 0.6, f"{name}: {share} of the picture is covered"
        plain = options.scratch / f"{name}-plain.png"
        draw(lines, *common, "--output", plain)
        for array in ("row", "place"):
            other = options.scratch / f"{name}-{array}.png"
            draw(legacy, *common, "--color-by", array, "--output", other)
            assert covered(other) == covered(pictures[name]), f"{other}: other lines"
            assert pixels(other)[1] not in (colors, pixels(plain)[1]), f"{other}: not by {array}"
        thin = options.scratch / f"{name}-opacity.png"
        draw(lines, *common, "--color-by", "speed", "--opacity", 0.25, "--output", thin)
        brightness = [sum(map(sum, pixels(p)[1])) for p in (pictures[name], thin)]
        assert brightness[1] > brightness[0], f"{name}: opacity changes nothing"
        lit = options.scratch / f"{name}-lit.png"
        draw(lines, "--line-width", 2, "--size", "300x200", "--color-by", "speed", "--output", lit)
        share = sum(covered(lit)) / len(colors)
        assert 0.02 < share < 0.6 and pixels(lit)[1] != colors, f"{name}: {share} by lit lines"
        faded = options.scratch / f"{name}-faded.png"
        draw(legacy, "--line-width", 2, "--size", "300x200", "--color-by", "row", "--output", lit)
        draw(legacy, "--line-width", 2, "--size", "300x200", "--color-by", "row", "--importance",
             "row", "--output", faded)
        brightness = [sum(map(sum, pixels(p)[1])) for p in (lit, faded)]
        assert brightness[1] > brightness[0], f"{name}: importance fades nothing"
        shadow = options.scratch / f"{name}-shadow.png"
        draw(lines, *common, "--color-by", "speed", "--shadows", "soft", "--occlusion", "spherical",
             "--output", shadow)
        assert covered(shadow) == covered(pictures[name]), f"{name}: shadows move lines"
        assert pixels(shadow)[1] != colors, f"{name}: no light for shadows"
        for option, values in (("--shadows", ("none", "hard", "level")),
                               ("--occlusion", ("none", "spherical", "hemisphere"))):
            for value in values:
                other = options.scratch / f"{name}{option}-{value}.png"
                draw(lines, *common, "--color-by", "speed", option, value, "--output", other)
                assert covered(other) == covered(pictures[name]), f"{other}: other lines"
                assert value != "none" or pixels(other)[1] == colors, f"{other}: not none"
        default = options.scratch / f"{name}-default.png"
        draw(lines, "--output", default)
        assert pixels(default)[0] == (1024, 768) and any(covered(default))
    assert covered(pictures["cxx"]) == covered(pictures["python"]), "C++ and Python differ"
    lit = [covered(options.scratch / f"{name}-lit.png") for name in pictures]
    assert lit[0] == lit[1], "lit lines in C++ and Python differ"
    assert correlation(*(light_of_shadows(name) for name in pictures)) > 0.9, "other lights"

    refused("--line-width takes a number of pixels above 0", lines, "--line-width", 0)
    refused("--shadows and --occlusion are for tubes", lines, "--line-width", 2, "--shadows", "soft")
    refused("--shadows and --occlusion are for tubes", lines, "--importance", "speed",
            "--shadows", "soft")
    refused('there is no array "nothing"', lines, "--importance", "nothing")
    refused("--shadows takes one of none hard level soft", lines, "--shadows", "dark")
    refused("--occlusion takes one of none spherical hemisphere", lines, "--occlusion", "hard")
    refused("there is no array", lines, "--color-by", "nothing")
    refused("--size takes", lines, "--size", "300")
    refused("--radius takes a number", lines, "--radius", "wide")
    refused("unknown option", lines, "--colour", "red")
    refused("no data set", options.scratch / "missing.vtp")
    refused("holds no lines", options.source / "Testing/Data/carotid.vti")


def test_lines_of(folder):
    files = sorted(folder.glob("*.vtp"))
    if not files:
        print(f"Skipped: there are no line files in {folder}")
        sys.exit(SKIPPED)
    for file in files:
        picture = options.scratch / (file.stem + ".png")
        cxx(file, "--size", "200x150", "--output", picture)
        share = sum(covered(picture)) / (200 * 150)
        print(f"{file.name}: {100 * share:.1f} % of the picture is covered")
        assert share > 0.01, f"{file} is not to be seen"


if options.lines:
    test_lines_of(options.lines)
else:
    test_examples()
