"""Scenes of tests of levels of detail."""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer

import vitrine
from scenes import pixels, window_with

SIZE = 200


def ball(x, y, radius, resolution=32):
    source = vtkSphereSource()
    source.SetCenter(x, y, 0.3 * x)
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    return source.GetOutput()


def rod(x, y):
    source = vtkCylinderSource()
    source.SetCenter(x, y, 0)
    source.SetRadius(0.3)
    source.SetHeight(1.5)
    source.SetResolution(64)
    source.Update()
    return source.GetOutput()


def machine():
    """Balls of several sizes, rods, and a cloud of tiny balls, by name."""
    parts = {f"ball_{i}": ball(i - 2, 1.5, 0.2 + 0.06 * i) for i in range(5)}
    parts.update({f"rod_{i}": rod(i - 2, -1) for i in range(5)})
    random = np.random.default_rng(53)
    parts.update({f"dust_{i}": ball(*random.uniform(-0.02, 0.02, 2), 0.004, 12) for i in range(30)})
    blocks = vtkMultiBlockDataSet()
    for i, (name, data) in enumerate(parts.items()):
        blocks.SetBlock(i, data)
        blocks.GetMetaData(i).Set(blocks.NAME(), name)
    return vitrine.from_multiblock(blocks)


class Scene:
    """An assembly in a window, and steps of its camera."""

    def __init__(self, assembly, lit=False, parallel=False):
        self.assembly = assembly
        self.renderer = vtkRenderer()
        self.window = window_with(self.renderer, size=(SIZE, SIZE))
        assembly.add_to(self.renderer)
        for number in range(assembly.actors.GetNumberOfActors()):
            assembly.actors.GetActor(number).GetProperty().SetLighting(lit)
        vitrine.see_through(self.window)
        self.renderer.ResetCamera()
        self.camera = self.renderer.GetActiveCamera()
        self.camera.SetParallelProjection(parallel)

    def frame(self, degrees=0.0):
        self.camera.Azimuth(degrees)
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        return pixels(self.window)

    def levels(self, **options):
        shown = vitrine.levels(self.window, **options)
        shown.wait()
        return shown
