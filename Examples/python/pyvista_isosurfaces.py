#!/usr/bin/env python3
"""
Isosurfaces of an orbital
=========================

Look through the isosurfaces of an orbital of hydrogen, one inside the other.

``pyvista_isosurfaces.py [PICTURE.png]`` prints, for PyVista's default, its depth peeling and Vitrine, the time of a
frame and how far its picture is off the truth. It writes the pictures side by side (``pyvista_isosurfaces.png`` by
default).
"""

import sys

import numpy
import pyvista
from comparison import compare

SURFACES = 8


def orbital():
    """|psi| of the 3d_z2 state on a grid, in Bohr radii, 1 at its largest."""
    grid = pyvista.ImageData(dimensions=(81, 81, 81), spacing=(0.6,) * 3, origin=(-24,) * 3)
    x, y, z = grid.points.T
    psi = (2 * z**2 - x**2 - y**2) * numpy.exp(-numpy.sqrt(x**2 + y**2 + z**2) / 3)
    grid["psi"] = abs(psi) / abs(psi).max()
    return grid


def main():
    plotter = pyvista.Plotter(off_screen=True, window_size=(480, 360))
    plotter.background_color = "white"
    surfaces = orbital().contour(numpy.linspace(0.08, 0.92, SURFACES), scalars="psi")
    plotter.add_mesh(
        surfaces,
        scalars="psi",
        cmap="viridis",
        opacity=0.25,
        smooth_shading=True,
        show_scalar_bar=False,
    )
    plotter.camera_position = [(62, 46, 38), (0, 0, 0), (0, 0, 1)]
    compare(plotter, sys.argv[1] if len(sys.argv) > 1 else "pyvista_isosurfaces.png")


if __name__ == "__main__":
    main()

# sphinx_gallery_thumbnail_path = "images/thumbnails/pyvista-isosurfaces.png"
# %%
# .. image:: /images/pyvista-isosurfaces.png
#    :alt: The orbital by PyVista's default, by its depth peeling, and by Vitrine
