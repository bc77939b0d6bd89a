# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards that the filters do not depend on which rank has which lines: the same lines in one file,
which one rank reads, and in four, which all ranks share, give the same image, piece by piece, and
lines cut by the same grid; one of the four files is empty."""
import os

import linesets_testing as testing
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.vtkParallelCore import vtkMultiProcessController

WHOLE_EXTENT = vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT()
controller = vtkMultiProcessController.GetGlobalController()
ranks, rank = controller.GetNumberOfProcesses(), controller.GetLocalProcessId()


def add_up(value):
    """Sum of a number over the ranks."""
    mine, all_ranks = vtkDoubleArray(), vtkDoubleArray()
    mine.InsertNextValue(value)
    controller.AllReduce(mine, all_ranks, 2)  # SUM_OP
    return all_ranks.GetValue(0)


def get_length(data):
    if data.GetNumberOfCells() == 0:
        return 0.0
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    offsets = vtk_to_numpy(data.GetLines().GetOffsetsArray())
    ids = vtk_to_numpy(data.GetLines().GetConnectivityArray())
    return sum(numpy.sum(numpy.linalg.norm(numpy.diff(points[ids[a:b]], axis=0), axis=1))
               for a, b in zip(offsets[:-1], offsets[1:]))


empty = vtkPolyData()
empty.DeepCopy(testing.make_helices(0))
parts = [testing.make_helices(10, shift=0.5 * i) for i in range(3)] + [empty]
folder = os.path.join(testing.OUTPUT, "ranks-%d" % ranks)
whole_path = os.path.join(folder, "whole.vtp")
if rank == 0:
    os.makedirs(folder, exist_ok=True)
    append = vtkAppendPolyData()
    writer = vtkXMLPolyDataWriter()
    for i, part in enumerate(parts):
        if part.GetNumberOfPoints():
            append.AddInputData(part)
        writer.SetInputData(part)
        writer.SetFileName(os.path.join(folder, "part-%d.vtp" % i))
        writer.Write()
    append.Update()
    writer.SetInputData(append.GetOutput())
    writer.SetFileName(whole_path)
    writer.Write()
    with open(os.path.join(folder, "parts.pvtp"), "w", encoding="utf-8") as file:
        file.write('<VTKFile type="PPolyData" version="0.1" byte_order="LittleEndian" '
                   'header_type="UInt32"><PPolyData GhostLevel="0"><PPointData>'
                   '<PDataArray type="Float64" Name="Height"/></PPointData>'
                   '<PPoints><PDataArray type="Float32" Name="Points" NumberOfComponents="3"/>'
                   '</PPoints>' + "".join('<Piece Source="part-%d.vtp"/>' % i for i in range(4)) +
                   '</PPolyData></VTKFile>')
controller.Barrier()

testing.load_plugin()
whole = simple.XMLPolyDataReader(FileName=[whole_path])
shared = simple.XMLPartitionedPolydataReader(FileName=[os.path.join(folder, "parts.pvtp")])
length = sum(get_length(part) for part in parts)


def get_output(source):
    source.UpdatePipeline()
    return source.GetClientSideObject().GetOutputDataObject(0)


images = []
for reader in (whole, shared):
    for level in (0, 1):
        density = simple.LineDensity(Input=reader, Resolution=48, Level=level, FaceBins="Exact",
                                     InteriorTolerance=0)
        image = get_output(density)
        images.append(image)
        extent = image.GetExtent()
        values = vtk_to_numpy(image.GetPointData().GetArray("Density")).astype(float)
        # Pieces share points with those that follow; the last one has its end.
        ends = density.GetClientSideObject().GetOutputInformation(0).Get(WHOLE_EXTENT)
        nx, ny, nz = image.GetDimensions()
        grid = values.reshape(nz, ny, nx)
        owned = grid[:nz - (extent[5] < ends[5]), :ny - (extent[3] < ends[3]),
                     :nx - (extent[1] < ends[1])]
        voxel = image.GetSpacing()[0] / 2 ** level
        total = add_up(numpy.sum(owned)) * voxel * 8 ** level
        testing.check(abs(total - length) < 1e-4 * length,
                      "level %d sums up to %g, the lines to %g" % (level, total, length))
for level in (0, 1):
    a, b = images[level], images[2 + level]
    testing.check(a.GetExtent() == b.GetExtent() and a.GetOrigin() == b.GetOrigin() and
                  a.GetSpacing() == b.GetSpacing(), "the pieces are the same")
    difference = numpy.max(numpy.abs(
        vtk_to_numpy(a.GetPointData().GetArray("Density")).astype(float) -
        vtk_to_numpy(b.GetPointData().GetArray("Density"))))
    testing.check(difference < 1e-5, "level %d differs by %g" % (level, difference))
    points = add_up(a.GetNumberOfPoints())
    testing.check(ranks == 1 or a.GetNumberOfPoints() < 0.8 * points, "the image is distributed")

# More values than are reduced at a time.
density = simple.LineDensity(Input=shared, Resolution=340, FaceBins="Exact", InteriorTolerance=0)
image = get_output(density)
ends = density.GetClientSideObject().GetOutputInformation(0).Get(WHOLE_EXTENT)
testing.check((ends[1] + 1) * (ends[3] + 1) * (ends[5] + 1) > 2 ** 24, "the image has two parts")
extent, (nx, ny, nz) = image.GetExtent(), image.GetDimensions()
grid = vtk_to_numpy(image.GetPointData().GetArray("Density")).reshape(nz, ny, nx)
total = add_up(numpy.sum(grid[:nz - (extent[5] < ends[5]), :ny - (extent[3] < ends[3]),
                              :nx - (extent[1] < ends[1])], dtype=float)) * image.GetSpacing()[0]
testing.check(abs(total - length) < 1e-4 * length,
              "a large image sums up to %g, the lines to %g" % (total, length))

lines = [get_output(simple.VoxelizeLines(Input=reader, Resolution=48, FaceBins="Exact",
                                         InteriorTolerance=0)) for reader in (whole, shared)]
for data in lines:
    total = add_up(get_length(data))
    testing.check(abs(total - length) < 1e-6 * length, "lines are %g long, not %g" % (total, length))
testing.check(add_up(lines[0].GetNumberOfPoints()) == add_up(lines[1].GetNumberOfPoints()),
              "lines are cut by the same grid, whichever rank has them")
