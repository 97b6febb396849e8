"""Scenes as pieces for ranks: the cells of a model, divided in one of several ways, with ghost cells or without them.

A scene is one vtkPolyData in world coordinates, with the colours of its cells as unsigned char RGBA. So each rank has
one actor, and cells of one part can be on several ranks.
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

PARTITIONS = ("kd-tree", "round-robin", "random")
DUPLICATE_CELL = 1  # of vtkDataSetAttributes::CellGhostTypes


class Scene:
    """Triangles: the points (n, 3), the numbers of three points for each (m, 3), and their colours (m, 4) of 8 bits."""

    def __init__(self, points, triangles, colors):
        self.points = np.ascontiguousarray(points, dtype=np.float32)
        self.triangles = np.ascontiguousarray(triangles, dtype=np.int64)
        self.colors = np.ascontiguousarray(colors, dtype=np.uint8)

    def centres(self):
        return self.points[self.triangles].mean(axis=1)

    def piece(self, cells, ghosts=()):
        """The cells of these numbers, and ghost cells after them, as vtkPolyData."""
        cells, ghosts = np.asarray(cells, dtype=np.int64), np.asarray(ghosts, dtype=np.int64)
        numbers = np.concatenate([cells, ghosts])
        used, corners = np.unique(self.triangles[numbers], return_inverse=True)
        data = vtkPolyData()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(self.points[used], deep=True))
        data.SetPoints(points)
        polygons = vtkCellArray()
        kind = vtkIdTypeArray().GetDataType()
        offsets = numpy_to_vtk(np.arange(0, 3 * len(numbers) + 1, 3), deep=True, array_type=kind)
        polygons.SetData(offsets, numpy_to_vtk(corners.reshape(-1), deep=True, array_type=kind))
        data.SetPolys(polygons)
        colors = numpy_to_vtk(self.colors[numbers], deep=True)
        colors.SetName("colors")
        data.GetCellData().SetScalars(colors)
        if len(ghosts):
            types = np.zeros(len(numbers), dtype=np.uint8)
            types[len(cells) :] = DUPLICATE_CELL
            array = numpy_to_vtk(types, deep=True)
            array.SetName("vtkGhostType")
            data.GetCellData().AddArray(array)
        return data


def owners(scene, ranks, partition, random):
    """The rank of each cell."""
    count = len(scene.triangles)
    if partition == "round-robin":
        return np.arange(count) % ranks
    if partition == "random":
        return random.integers(0, ranks, count)
    ranks_of = np.zeros(count, dtype=np.int64)
    divide(scene.centres(), np.arange(count), 0, ranks, ranks_of)
    return ranks_of


def divide(centres, cells, first, ranks, ranks_of):
    """Divide cells among `ranks` ranks from `first` on, by planes across the longest side of their centres' box."""
    if ranks == 1 or not len(cells):
        ranks_of[cells] = first
        return
    axis = np.argmax(np.ptp(centres[cells], axis=0))
    lower = ranks // 2
    order = cells[np.argsort(centres[cells, axis], kind="stable")]
    cut = len(order) * lower // ranks
    divide(centres, order[:cut], first, lower, ranks_of)
    divide(centres, order[cut:], first + lower, ranks - lower, ranks_of)


def neighbours(scene, own):
    """The numbers of the cells that share a point with cells of a mask, and are not in it."""
    touched = np.zeros(len(scene.points), dtype=bool)
    touched[scene.triangles[own].reshape(-1)] = True
    return np.flatnonzero(touched[scene.triangles].any(axis=1) & ~own)


def piece_of(scene, rank, ranks, partition, ghosts, random):
    own = owners(scene, ranks, partition, random) == rank
    return scene.piece(np.flatnonzero(own), neighbours(scene, own) if ghosts else ())


def actor_of(data):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetColorModeToDirectScalars()
    mapper.SetVBOShiftScaleMethod(0)  # DISABLE_SHIFT_SCALE: by bounds, which pieces do not share
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.ForceTranslucentOn() if data.GetNumberOfCells() else None
    return actor


def scene_of(machine, opacity=None):
    """The triangles of a loaded assembly. With an opacity, all of them have it."""
    points, triangles, colors, first = [], [], [], 0
    blocks = machine.to_multiblock()
    iterator = blocks.NewIterator()
    while not iterator.IsDoneWithTraversal():
        data = iterator.GetCurrentDataObject()
        iterator.GoToNextItem()
        if not data.GetNumberOfPolys():
            continue
        field = data.GetFieldData()
        color = vtk_to_numpy(field.GetAbstractArray("color")).reshape(-1)
        alpha = vtk_to_numpy(field.GetAbstractArray("opacity")).reshape(-1)[0] if opacity is None else opacity
        corners = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        points.append(vtk_to_numpy(data.GetPoints().GetData()))
        triangles.append(corners + first)
        colors.append(np.tile(np.round(255 * np.append(color, alpha)).astype(np.uint8), (len(corners), 1)))
        first += data.GetNumberOfPoints()
    return Scene(np.concatenate(points), np.concatenate(triangles), np.concatenate(colors))
