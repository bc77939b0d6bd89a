# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards composite input: which blocks are drawn, with visibility that blocks inherit, as the own
Wireframe of ParaView draws them; arrays that only some blocks have; colours by field data; and that what is
not supported per block, or left out, is told once."""
import os

import linesets_testing as testing
from paraview import simple
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import (vtkMultiBlockDataSet, vtkPartitionedDataSet,
                                           vtkPartitionedDataSetCollection, vtkPolyData)
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOParallelXML import vtkXMLPartitionedDataSetCollectionWriter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter

REPRESENTATIONS = ("Voxel Lines", "Illuminated Lines", "Fourier Opacity")
SPHERE = 2  # of the places in which something is, the one with polygons


def make_parts():
    """Things at x = 0, 3, 6, 9: lines with field data Tag, lines without Height, a sphere, lines."""
    bare = testing.make_helices(10, shift=3.0)
    bare.GetPointData().RemoveArray("Height")
    sphere = vtkSphereSource()
    sphere.SetCenter(6.0, 0.0, 1.0)
    sphere.Update()
    tag = vtkDoubleArray()
    tag.SetName("Tag")
    tag.InsertNextValue(1.0)
    tagged = testing.make_helices(10)
    tagged.GetFieldData().AddArray(tag)
    return [tagged, bare, sphere.GetOutput(), testing.make_helices(10, shift=9.0)]


def write(data, writer, name):
    path = os.path.join(testing.OUTPUT, name)
    os.makedirs(testing.OUTPUT, exist_ok=True)
    writer.SetInputDataObject(data)
    writer.SetFileName(path)
    writer.Write()
    return path


def open_multiblock():
    parts = make_parts()
    data = vtkMultiBlockDataSet()
    inner = vtkMultiBlockDataSet()
    inner.SetBlock(0, parts[2])
    inner.SetBlock(1, vtkPolyData())
    inner.SetBlock(2, parts[3])
    for i, block in enumerate((parts[0], None, parts[1], inner)):
        data.SetBlock(i, block)
    return simple.XMLMultiBlockDataReader(
        FileName=[write(data, vtkXMLMultiBlockDataWriter(), "TestBlocks.vtm")])


def open_collection():
    data = vtkPartitionedDataSetCollection()
    parts = make_parts()
    for i, block in enumerate(((parts[0], parts[1]), (), (parts[2],), (parts[3],))):
        partitions = vtkPartitionedDataSet()
        for k, part in enumerate(block):
            partitions.SetPartition(k, part)
        data.SetPartitionedDataSet(i, partitions)
    return simple.XMLPartitionedDatasetCollectionReader(
        FileName=[write(data, vtkXMLPartitionedDataSetCollectionWriter(), "TestBlocks.vtpc")])


def find_drawn(view):
    """Which of the four places show something, from left to right, and their mean colours."""
    picture = testing.take_picture(view, "TestBlocks")
    drawn, colors = set(), {}
    for i in range(4):
        place = picture[:, 100 * i:100 * (i + 1)].reshape(-1, 3)
        shown = place[abs(place - picture[0, 0]).max(axis=1) > 20.0]
        if len(shown) > 20:
            drawn.add(i)
            colors[i] = shown.mean(axis=0)
    return drawn, colors


def check_partial(display, association, array, name):
    """Blocks without the array have the NaN colour, and others their own, which is told once."""
    simple.ColorBy(display, (association, array))
    table = simple.GetColorTransferFunction(array)
    table.NanColor = [0.0, 1.0, 0.0]
    table.RGBPoints = [0.0, 1.0, 0.0, 0.0, 2.0, 1.0, 0.0, 0.0]
    _, colors = find_drawn(view)
    testing.check(colors[0][0] > colors[0][1] + 50.0, "%s, %s: red: %s" % (name, array, colors[0]))
    testing.check(colors[1][1] > colors[1][0] + 50.0, "%s, %s: green: %s" % (name, array, colors[1]))
    said = messages.take()
    testing.check(len(said) == 1 and '1 of 2 visible blocks have no array "%s"' % array in said[0],
                  "%s: partial arrays are told once: %s" % (name, said))


testing.load_plugin()
messages = testing.Messages()
view = testing.make_view((400, 100))
view.CameraParallelProjection = 1
view.CameraPosition = [4.5, 0.0, 20.0]
view.CameraFocalPoint = [4.5, 0.0, 0.0]
view.CameraParallelScale = 1.5

for source, choices in (
        # An inner node's visibility is that of its blocks, but for blocks that have one themselves.
        (open_multiblock(), (["/"], ["/Root/Block3"], ["/Root/Block0", "/Root/Block3/Block2"])),
        (open_collection(), (["/Root/Block2", "/Root/Block3"], []))):
    display = simple.Show(source, view)
    for blocks in choices:
        display.BlockSelectors = blocks
        display.ColorArrayName = ["POINTS", ""]
        display.Representation = "Wireframe"
        expected, _ = find_drawn(view)
        for name in REPRESENTATIONS:
            display.Representation = name
            display.ImportanceArray = "Helix"
            drawn, _ = find_drawn(view)
            wanted = expected - {SPHERE} if name == "Voxel Lines" else expected
            testing.check(drawn == wanted, "%s of %s shows %s, not %s" % (
                name, blocks, sorted(drawn), sorted(wanted)))
    messages.take()
    simple.Hide(source, view)

source = open_multiblock()
for name in REPRESENTATIONS:
    display = simple.Show(source, view)
    display.Representation = name
    display.ImportanceArray = "Helix"
    display.ColorArrayName = ["POINTS", ""]
    display.BlockSelectors = ["/Root/Block0", "/Root/Block2"]
    messages.take_notes()
    find_drawn(view)
    messages.take()
    # What one of the blocks lacks and is not in use; then what the sphere has or lacks as well.
    notes = messages.take_notes()
    testing.check(len(notes) == 1 and notes[0].endswith(' them: "Height" of points.'),
                  "%s: what is left out is told once: %s" % (name, notes))
    display.BlockSelectors = ["/Root/Block0", "/Root/Block2", "/Root/Block3/Block0"]
    find_drawn(view)
    notes = messages.take_notes()
    wanted = ' them: %s"Normals" of points.' % (
        "" if name == "Fourier Opacity" else '"Helix" of cells, ')
    testing.check(len(notes) == 1 and notes[0].endswith(wanted),
                  "%s: more that is left out is told once: %s" % (name, notes))
    display.BlockSelectors = ["/Root/Block0", "/Root/Block2"]
    messages.take()
    check_partial(display, "POINTS", "Height", name)

    # Other blocks lack it now.
    display.BlockSelectors = ["/Root/Block0", "/Root/Block2", "/Root/Block3/Block2"]
    find_drawn(view)
    said = messages.take() + messages.take_notes()
    testing.check(not said, "%s: partial arrays are told once: %s" % (name, said))
    display.BlockSelectors = ["/Root/Block0", "/Root/Block2"]

    # By field data of whole blocks, as multiblock data sets are coloured when they are opened.
    simple.ColorBy(display, ("FIELD", "vtkBlockColors"))
    _, colors = find_drawn(view)
    testing.check(abs(colors[0] - colors[1]).max() > 50.0,
                  "%s: colours of blocks differ: %s" % (name, colors))

    messages.take()
    check_partial(display, "FIELD", "Tag", name)
    # The next representation begins without.
    simple.ColorBy(display, ("FIELD", "vtkBlockColors"))

    # What is not supported.
    messages.take()
    display.BlockColors = ["/Root/Block0", "1", "0", "0"]
    find_drawn(view)
    display.BlockOpacities = ["/Root/Block0", "0.5"]
    find_drawn(view)
    said = messages.take()
    testing.check(len(said) == 1 and "of single blocks are ignored" in said[0],
                  "%s: settings of blocks are told once: %s" % (name, said))
    display.BlockColors = []
    display.BlockOpacities = []
    simple.Hide(source, view)
    find_drawn(view)
    messages.take()
