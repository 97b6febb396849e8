#!/usr/bin/env python3
"""
Nested shells
=============

See through nested translucent shells to the core within, exactly and without a display.

``see_through.py [PICTURE.png]`` draws the scene with ``vtkSeeThroughPass``, reads the pixels back, prints the one in
the middle and writes the picture (``see_through.png`` by default).
"""

import sys

import vtkmodules.vtkRenderingFreeType  # noqa: F401, VTK's implementations of its rendering classes
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

import vitrine

SHELLS = [  # radius, colour, opacity
    (1.0, (0.2, 0.5, 0.9), 0.25),
    (0.8, (0.3, 0.8, 0.4), 0.25),
    (0.6, (0.9, 0.8, 0.2), 0.35),
    (0.3, (0.9, 0.2, 0.1), 1.0),
]


def shell(radius, colour, opacity):
    sphere = vtkSphereSource()
    sphere.SetRadius(radius)
    sphere.SetThetaResolution(64)
    sphere.SetPhiResolution(64)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def main():
    file_name = sys.argv[1] if len(sys.argv) > 1 else "see_through.png"
    vitrine.vtkHeadlessRenderWindow.InstallOverride()

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for radius, colour, opacity in SHELLS:
        renderer.AddActor(shell(radius, colour, opacity))
    renderer.SetPass(vitrine.vtkSeeThroughPass())

    window = vtkRenderWindow()
    window.SetSize(400, 400)
    window.AddRenderer(renderer)
    window.Render()

    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.Update()
    pixels = vtk_to_numpy(picture.GetOutput().GetPointData().GetScalars()).reshape(400, 400, 3)
    print("the pixel in the middle:", *pixels[200, 200])

    writer = vtkPNGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(file_name)
    writer.Write()
    print("wrote", file_name)


if __name__ == "__main__":
    main()
