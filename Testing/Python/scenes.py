"""Scenes whose pictures are known, windows to draw them in, and the pixels that come out."""

import os
import subprocess
import sys

import numpy
import vtkmodules.vtkRenderingFreeType  # noqa: F401, the factory of text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, the factory of everything else
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

import vitrine


def actor_of(source):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def plate(z, colour, opacity):
    """A square that fills the view of plates_renderer(), without shading."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-2, -2, z)
    plane.SetPoint1(2, -2, z)
    plane.SetPoint2(-2, 2, z)
    actor = actor_of(plane)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def plates_renderer(*plates, background=(0.0, 0.0, 0.0)):
    """A renderer that looks down the z axis at the plates, in parallel projection."""
    renderer = vtkRenderer()
    renderer.SetBackground(background)
    for actor in plates:
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(1.0)
    camera.SetPosition(0, 0, 10)
    renderer.ResetCameraClippingRange()
    return renderer


def plates(count, alpha=0.4):
    """A white renderer behind `count` black plates of this opacity."""
    return plates_renderer(
        *(plate(0.1 * i, (0, 0, 0), alpha) for i in range(count)), background=(1, 1, 1)
    )


def cone_renderer(opacity=1.0):
    renderer = vtkRenderer()
    renderer.SetBackground(0, 0, 1)
    cone = actor_of(vtkConeSource())
    cone.GetProperty().SetOpacity(opacity)
    renderer.AddActor(cone)
    return renderer


def add_lights(renderer, count):
    """Small lamps of several colours around the origin."""
    random = numpy.random.default_rng(count)
    for _ in range(count):
        light = vtkLight()
        light.PositionalOn()
        light.SetConeAngle(180)
        light.SetPosition(random.uniform(-2, 2, 3))
        light.SetColor(random.uniform(0.2, 1, 3))
        light.SetIntensity(0.5)
        light.SetAttenuationValues(1, 0, 4)
        renderer.AddLight(light)


def window_with(renderer, size=(64, 48), multisamples=0):
    window = vitrine.vtkHeadlessRenderWindow()
    window.SetMultiSamples(multisamples)
    window.SetSize(size)
    window.AddRenderer(renderer)
    return window


def drawn(renderer, **arguments):
    window = window_with(renderer, **arguments)
    window.Render()
    return window


def pixels(window):
    """The picture as an array (rows from below, columns, RGBA) of bytes; None if it cannot be read."""
    width, height = window.GetSize()
    data = vtkUnsignedCharArray()
    if window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 1, data) != 1:
        return None
    return vtk_to_numpy(data).reshape(height, width, 4).copy()


def rendered(renderer, **arguments):
    window = window_with(renderer, **arguments)
    window.Render()
    return pixels(window)


def run_python(program, **environment):
    """Run a program in an interpreter of its own, with changes to the environment."""
    return run_interpreter("-c", program, **environment)


def run_interpreter(*arguments, **environment):
    return subprocess.run(
        [sys.executable, "-B", *arguments],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )


class Plotter:
    """What see_through() asks of a pyvista.Plotter."""

    def __init__(self, *renderers):
        self.renderers = renderers
        self.render_window = vtkRenderWindow()
        self.frames = 0

    def render(self):
        self.frames += 1

    def close(self):
        self.render_window = None
