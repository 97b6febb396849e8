#!/usr/bin/env python3
"""
A gearbox of blocks
===================

Look through the housing of a gearbox that PyVista holds as blocks, each with its own opacity.

``pyvista_assembly.py [PICTURE.png]`` prints, for PyVista's default, its depth peeling and Vitrine, the time of a
frame and how far its picture is off the truth. It writes the pictures side by side (``pyvista_assembly.png`` by
default).
"""

import sys

import numpy
import pyvista
from comparison import compare

TEETH, PLANETS = 18, 5


def gear(radius, centre, height=0.5):
    """A toothed wheel about the z axis."""
    angles = numpy.linspace(0, 2 * numpy.pi, 4 * TEETH, endpoint=False)
    tooth = numpy.tile([1.0, 1.0, 0.86, 0.86], TEETH) * radius
    points = numpy.c_[tooth * numpy.cos(angles), tooth * numpy.sin(angles), 0 * angles]
    outline = pyvista.PolyData(points + centre, faces=[len(points), *range(len(points))])
    return outline.triangulate().extrude((0, 0, height), capping=True)


def gearbox():
    """Blocks by name, and the colour and the opacity of each."""
    blocks, looks = pyvista.MultiBlock(), {}

    def add(name, mesh, color, opacity=1.0):
        blocks.append(mesh.extract_surface(algorithm="dataset_surface"), name)
        looks[name] = (color, opacity)

    add(
        "housing",
        pyvista.Cylinder(direction=(0, 0, 1), radius=3.4, height=2.6),
        "lightsteelblue",
        0.25,
    )
    add(
        "cover",
        pyvista.Cylinder(center=(0, 0, 1.4), direction=(0, 0, 1), radius=3.6, height=0.3),
        "steelblue",
        0.35,
    )
    add(
        "ring",
        pyvista.CylinderStructured(radius=[2.9, 3.2], height=0.8, direction=(0, 0, 1)),
        "slategray",
        0.4,
    )
    add("sun", gear(1.0, (0, 0, -0.25)), "goldenrod", 0.8)
    add("shaft", pyvista.Cylinder(direction=(0, 0, 1), radius=0.3, height=4.4), "dimgray")
    for i in range(PLANETS):
        angle = 2 * numpy.pi * i / PLANETS
        centre = 1.9 * numpy.array([numpy.cos(angle), numpy.sin(angle), 0])
        add(f"planet {i}", gear(0.85, centre - (0, 0, 0.25)), "indianred", 0.5)
        add(
            f"pin {i}",
            pyvista.Cylinder(center=centre, direction=(0, 0, 1), radius=0.2, height=1.4),
            "gray",
        )
        bolt = 1.75 * centre + (0, 0, 1.6)
        add(
            f"bolt {i}",
            pyvista.Cylinder(center=bolt, direction=(0, 0, 1), radius=0.15, height=0.5),
            "black",
        )
    return blocks, looks


def main():
    blocks, looks = gearbox()
    plotter = pyvista.Plotter(off_screen=True, window_size=(480, 360))
    plotter.background_color = "white"
    actor, mapper = plotter.add_composite(blocks, smooth_shading=True, split_sharp_edges=True)
    for index, name in enumerate(blocks.keys(), start=1):
        mapper.block_attr[index].color, mapper.block_attr[index].opacity = looks[name]
    plotter.camera_position = [(9, -11, 8), (0, 0, 0), (0, 0, 1)]
    compare(plotter, sys.argv[1] if len(sys.argv) > 1 else "pyvista_assembly.png")


if __name__ == "__main__":
    main()

# sphinx_gallery_thumbnail_path = "images/thumbnails/pyvista-assembly.png"
# %%
# .. image:: /images/pyvista-assembly.png
#    :alt: The gearbox by PyVista's default, by its depth peeling, and by Vitrine
