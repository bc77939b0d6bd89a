# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests on several ranks share: lines in pieces, and pictures of one rank."""
import os

import linesets_testing as testing
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.vtkParallelCore import vtkMultiProcessController

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK = CONTROLLER.GetLocalProcessId()
RANKS = CONTROLLER.GetNumberOfProcesses()
TYPES = {"double": "Float64", "float": "Float32"}


def make_waves(number=40, points=1500):
    """Long curves through all of a cube, with many points to a pixel."""
    random = numpy.random.RandomState(7)
    t = numpy.linspace(0.0, 1.0, points)
    curves = []
    for _ in range(number):
        curve = numpy.zeros((points, 3))
        for axis in range(3):
            for frequency in range(1, 5):
                a, phase = random.uniform(0.2, 0.5), random.uniform(0.0, 6.3)
                curve[:, axis] += a * numpy.sin(frequency * 3.0 * t + phase)
        curves.append(curve)
    data = vtkPolyData()
    positions = vtkPoints()
    positions.SetData(numpy_to_vtk(numpy.concatenate(curves).astype(numpy.float32), deep=True))
    data.SetPoints(positions)
    cells = vtkCellArray()
    for line in range(number):
        cells.InsertNextCell(points)
        for i in range(points):
            cells.InsertCellPoint(line * points + i)
    data.SetLines(cells)
    height = numpy_to_vtk(numpy.tile(t, number), deep=True)
    height.SetName("Height")
    data.GetPointData().AddArray(height)
    return data


def take_lines(data, lines):
    """Some of the lines, with their points and arrays."""
    piece = vtkPolyData()
    points = vtkPoints()
    cells = vtkCellArray()
    ids = vtkIdList()
    attributes = piece.GetPointData(), piece.GetCellData()
    sources = data.GetPointData(), data.GetCellData()
    for to, source in zip(attributes, sources):
        to.CopyAllocate(source)
    for line in lines:
        data.GetLines().GetCellAtId(line, ids)
        attributes[1].CopyData(sources[1], line, cells.InsertNextCell(ids.GetNumberOfIds()))
        for i in range(ids.GetNumberOfIds()):
            point = points.InsertNextPoint(data.GetPoint(ids.GetId(i)))
            attributes[0].CopyData(sources[0], ids.GetId(i), point)
            cells.InsertCellPoint(point)
    piece.SetPoints(points)
    piece.SetLines(cells)
    return piece


def write_pieces(data, name, number=4, is_symmetric=True):
    """
    Writes the lines in pieces that a reader parts among ranks: line by line in turn, so that those of
    different ranks lie between each other. All ranks run this, or the root alone does (not
    symmetric). Returns the path of the file that names the pieces.
    """
    folder = os.path.join(testing.OUTPUT, "%s-%d" % (name, RANKS))
    path = os.path.join(folder, name + ".pvtp")
    if RANK == 0:
        os.makedirs(folder, exist_ok=True)
        for i in range(number):
            writer = vtkXMLPolyDataWriter()
            writer.SetInputData(take_lines(data, range(i, data.GetNumberOfLines(), number)))
            writer.SetFileName(os.path.join(folder, "%s_%d.vtp" % (name, i)))
            writer.Write()

        def declare(arrays):
            return "".join('<PDataArray type="%s" Name="%s" NumberOfComponents="%d"/>' % (
                TYPES[arrays.GetArray(i).GetDataTypeAsString()],
                arrays.GetArray(i).GetName(), arrays.GetArray(i).GetNumberOfComponents())
                for i in range(arrays.GetNumberOfArrays()))
        with open(path, "w") as file:
            file.write('<VTKFile type="PPolyData" version="0.1">\n<PPolyData GhostLevel="0">\n')
            file.write("<PPointData>%s</PPointData>\n" % declare(data.GetPointData()))
            file.write("<PCellData>%s</PCellData>\n" % declare(data.GetCellData()))
            file.write('<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>\n')
            for i in range(number):
                file.write('<Piece Source="%s_%d.vtp"/>\n' % (name, i))
            file.write("</PPolyData>\n</VTKFile>\n")
    if is_symmetric:
        CONTROLLER.Barrier()
    return path


def take_picture(view, name):
    """The picture on rank 0, None elsewhere."""
    path = os.path.join(testing.OUTPUT, "%s-%d.png" % (name, RANKS))
    simple.SaveScreenshot(path, view)
    return testing.read_picture(path) if RANK == 0 else None


def check_baseline(view, name, bound=1.0):
    """The picture against the one of one rank: Baseline/NAME.png."""
    picture = take_picture(view, name)
    if RANK == 0:
        testing.check_baseline(picture, name, bound)
