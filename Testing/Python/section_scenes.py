"""Scenes that the tests of sections cut."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkWindowToImageFilter
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

import vitrine

SIZE = 48
COLORS = ((10, 20, 200), (10, 90, 220))
BACKGROUND = (0, 0, 255)


def data_of(points, corners):
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(places)
    cells = vtkCellArray()
    for corner in corners:
        cells.InsertNextCell(3, [int(i) for i in corner])
    data.SetPolys(cells)
    return data


class Scene:
    """Parts of which only the caps are seen, in colours that tell them apart."""

    def __init__(self):
        self.window = vitrine.vtkHeadlessRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIZE, SIZE)
        self.renderer = vtkRenderer()
        self.window.AddRenderer(self.renderer)
        self.renderer.SetBackground(*(value / 255 for value in BACKGROUND))
        self.nothing = vtkPlane()
        self.nothing.SetNormal(0, 0, 1)
        self.nothing.SetOrigin(0, 0, 1e6)
        self.actors = []

    def show(self, parts, hidden=True):
        for actor in self.actors:
            self.renderer.RemoveActor(actor)
        self.actors = []
        for (points, corners), color in zip(parts, COLORS):
            mapper = vtkPolyDataMapper()
            mapper.SetInputData(data_of(points, corners))
            if hidden:
                mapper.AddClippingPlane(self.nothing)  # it leaves caps alone
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().SetColor(*(value / 255 for value in color))
            actor.GetProperty().SetAmbient(1.0)
            actor.GetProperty().SetDiffuse(0.0)
            self.renderer.AddActor(actor)
            self.actors.append(actor)

    def look(self, random, parallel):
        camera = self.renderer.GetActiveCamera()
        direction = random.normal(size=3)
        camera.SetFocalPoint(*random.uniform(-0.2, 0.2, 3))
        camera.SetPosition(*(direction / np.linalg.norm(direction) * 3.0))
        camera.SetViewUp(*random.normal(size=3))
        camera.SetParallelProjection(parallel)
        self.renderer.ResetCamera()
        camera.Zoom(1.3)

    def picture(self):
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).astype(int)[:, :3]


def ball(radius=0.5, center=(0.0, 0.0, 0.0), color=(0.2, 0.4, 0.9), opacity=1.0):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(center)
    source.SetThetaResolution(24)
    source.SetPhiResolution(16)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetOpacity(opacity)
    return actor


class SectionCase(unittest.TestCase):
    """A scene with a camera that looks along y, at what add() adds."""

    def setUp(self):
        self.scene = Scene()
        self.renderer = self.scene.renderer
        self.renderer.SetBackground(1, 1, 1)

    def add(self, *actors):
        for actor in actors:
            self.renderer.AddActor(actor)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.4, -3, 0.5)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCamera()
        return actors

    def at_center(self):
        return tuple(self.scene.picture()[(SIZE // 2) * SIZE + SIZE // 2])
