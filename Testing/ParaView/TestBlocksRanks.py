# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""
Guards that several ranks draw what one draws where only some of them have an array that is in use, or no
lines at all, and that this is told once; also of arrays that are not in use, which are left out.
"""
import os

import linesets_ranks as ranks
import linesets_testing as testing
from paraview import simple
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter

# Back to opaque, when each rank draws its own lines again.
KINDS = (("Voxel Lines", (1.0, 0.25, 1.0)), ("Illuminated Lines", (1.0, 0.25, 1.0)),
         ("Fourier Opacity", (1.0,)))
MISSING = 'have no array "Height" of points with 1 component'


def make_blocks():
    """Helices in turn in two blocks, of which the second has no "Height", and the first no "Name"."""
    data = testing.make_helices(30, 300)
    blocks = [ranks.take_lines(data, range(i, 30, 2)) for i in range(2)]
    blocks[1].GetPointData().RemoveArray("Height")
    names = vtkStringArray()
    names.SetName("Name")
    for _ in range(blocks[1].GetNumberOfCells()):
        names.InsertNextValue("helix")
    blocks[1].GetCellData().AddArray(names)
    return blocks


def open_blocks(blocks, name):
    """Shows the blocks, which the reader gives to one rank after the other."""
    path = os.path.join(testing.OUTPUT, "%s-%d.vtm" % (name, ranks.RANKS))
    if ranks.RANK == 0:
        os.makedirs(testing.OUTPUT, exist_ok=True)
        data = vtkMultiBlockDataSet()
        for i, block in enumerate(blocks):
            data.SetBlock(i, block)
        writer = vtkXMLMultiBlockDataWriter()
        writer.SetInputDataObject(data)
        writer.SetFileName(path)
        writer.Write()
    ranks.CONTROLLER.Barrier()
    return simple.XMLMultiBlockDataReader(FileName=[path])


def show(source, view):
    display = simple.Show(source, view)
    display.BlockSelectors = ["/"]
    # Not by ColorBy(), which does something else on ranks that do not have the array.
    table = simple.GetColorTransferFunction("Height")
    table.ColorSpace = "RGB"
    table.RGBPoints = [0.0, 0.2, 0.4, 0.9, 1.0, 0.9, 0.9, 0.9, 2.0, 0.9, 0.3, 0.1]
    display.ColorArrayName = ["POINTS", "Height"]
    display.LookupTable = table
    table.NanColor = [0.1, 0.9, 0.2]
    display.Radius = 0.02
    display.Resolution = 64
    display.ImportanceArray = ["POINTS", "Height"]
    display.LineWidth = 3
    return display


testing.load_plugin()
messages = testing.Messages()
settings = simple.GetSettingsProxy("RenderViewSettings")
settings.MaximumNumberOfPeels = 100
view = testing.make_view()
view.UseFXAA = 0
view.CameraPosition = [4.0, 3.0, 3.5]
view.CameraViewUp = [0.0, 0.0, 1.0]
view.CameraFocalPoint = [0.0, 0.0, 1.0]

partial = open_blocks(make_blocks(), "partial")
display = show(partial, view)
for name, opacities in KINDS:
    display.Representation = name
    messages.take()
    messages.take_notes()
    # Other blocks before, and then another array.
    display.ColorArrayName = ["POINTS", ""]
    for selectors in (["/Root/Block0"], ["/"]):
        display.BlockSelectors = selectors
        simple.Render(view)
    display.ColorArrayName = ["POINTS", "Height"]
    for opacity in opacities:
        display.Opacity = opacity
        ranks.check_baseline(view, "TestBlocksRanks%s%d" % (name.replace(" ", ""), 100 * opacity),
                             2.0 if name == "Fourier Opacity" else 0.5 if opacity == 1.0 else 1.0)
    # What Fourier Opacity says of NaN.
    said = [text for text in messages.take() if "not a finite number" not in text]
    told = [text for text in said if text.startswith("Warning: 1 of 2 ") and MISSING in text]
    testing.check(len(told) == (1 if ranks.RANK == 0 else 0) and len(said) == len(told),
                  "%s: what is missing is told once, by rank 0 alone: %s" % (name, said))
    notes = messages.take_notes()
    # At first the lines are not coloured by the other array, which is of importance for some.
    left = "" if name == "Fourier Opacity" else '"Height" of points, '
    told = [note for note in notes if note.endswith(' them: %s"Name" of cells.' % left)]
    testing.check(len(told) == (1 if ranks.RANK == 0 else 0) and len(notes) == len(told),
                  "%s: what is left out is told once, by rank 0 alone: %s" % (name, notes))
simple.Delete(partial)
