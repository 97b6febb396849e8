"""Draws the scenes of baselines that the program has no command for: draw.py SCENE FILE.png

culled    boxes behind a wall, by a renderer with vtkHierarchicalSBufferCuller, which must leave out some
whole     the same boxes, by a renderer without cullers
lights    spheres in many lights, by vtkClusteredLightsPass
deferred  the same, by vtkDeferredLightsPass
vtk       the same, as VTK lights them
together  translucent spheres in many lights, with the culler
"""

import math
import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, the factory of what draws
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkWindowToImageFilter,
)

import vitrine

SIZE = (160, 120)
LIGHTS = 24


def add(renderer, source, position, color, scale=(1, 1, 1), opacity=1.0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(position)
    actor.SetScale(scale)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(opacity)
    renderer.AddActor(actor)


def look(renderer):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2, 3, 12)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetClippingRange(5, 25)


def boxes():
    """A wall over the left, and boxes behind it and beside it."""
    renderer = vtkRenderer()
    renderer.SetBackground(0.9, 0.9, 0.9)
    cube = vtkCubeSource()
    add(renderer, cube, (-2.5, 0, 1), (0.3, 0.5, 0.7), scale=(5, 8, 0.2))
    for i in range(150):
        x, y = i % 15 - 7, i // 15 - 4.5
        add(renderer, cube, (x * 0.6, y * 0.6, -1 - i % 4), (0.4 + 0.04 * (i % 15), 0.5, 0.2), (0.4,) * 3)
    look(renderer)
    return renderer


def lit_spheres(opacity):
    """Rows of spheres before a wall, and small lights in circles around them."""
    renderer = vtkRenderer()
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(24)
    for i in range(20):
        place = (i % 5 * 1.6 - 3.2, i // 5 * 1.6 - 2.4, 0.3 * (i % 3))
        add(renderer, sphere, place, (0.8, 0.8, 0.8), opacity=opacity if i % 2 else 1.0)
    cube = vtkCubeSource()
    add(renderer, cube, (0, 0, -1), (0.7, 0.7, 0.7), scale=(12, 10, 0.2))
    add(renderer, cube, (0, 0, -2), (0.9, 0.2, 0.2), scale=(2, 2, 0.2))  # hidden
    renderer.AutomaticLightCreationOff()
    for i in range(LIGHTS):
        turn = 2 * math.pi * i / LIGHTS
        light = vtkLight()
        light.PositionalOn()
        light.SetConeAngle(180)  # it shines all around
        light.SetPosition((2 + i % 3) * math.cos(turn), (1 + i % 3) * math.sin(turn), 1.2)
        light.SetAttenuationValues(1.0, 0.0, 0.6)
        light.SetColor(0.5 + 0.5 * math.cos(turn), 0.6, 0.5 + 0.5 * math.sin(turn))
        light.SetIntensity(0.5)
        renderer.AddLight(light)
    look(renderer)
    return renderer


def light_by(renderer, lights):
    """Light by a pass around the transparency of linked lists."""
    steps = vitrine.vtkSeeThroughPass()
    if lights is None:
        renderer.SetPass(steps)
    else:
        lights.SetDelegatePass(steps)
        lights.SetCutOff(0.0)
        renderer.SetPass(lights)


def cull(renderer):
    culler = vitrine.vtkHierarchicalSBufferCuller()
    renderer.GetCullers().RemoveAllItems()
    renderer.AddCuller(culler)
    return culler


def draw(renderer, file):
    window = vitrine.vtkHeadlessRenderWindow()
    window.SetMultiSamples(0)
    window.SetSize(SIZE)
    window.AddRenderer(renderer)
    window.Render()
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    grabber.ShouldRerenderOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grabber.GetOutputPort())
    writer.SetFileName(file)
    writer.Write()


def main(scene, file):
    culler, least = None, 0
    if scene in ("culled", "whole"):
        renderer = boxes()
        renderer.GetCullers().RemoveAllItems()
        if scene == "culled":
            culler, least = cull(renderer), 50
    else:
        passes = {
            "lights": vitrine.vtkClusteredLightsPass,
            "deferred": vitrine.vtkDeferredLightsPass,
            "together": vitrine.vtkClusteredLightsPass,
        }
        opacity = 0.5 if scene == "together" else 1.0
        renderer = lit_spheres(opacity)
        light_by(renderer, passes[scene]() if scene in passes else None)
        if scene == "together":
            culler, least = cull(renderer), 1
    draw(renderer, file)
    if culler is not None and culler.GetNumberOfCulledParts() < least:
        sys.exit(f"the culler has left out {culler.GetNumberOfCulledParts()} parts, not {least}")


if __name__ == "__main__":
    main(*sys.argv[1:])
