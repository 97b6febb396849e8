"""
Times and errors
================

Compare a plotter's scene as PyVista draws it, with its depth peeling, and as Vitrine does: times, errors and pictures.

``pyvista_assembly.py`` and ``pyvista_isosurfaces.py`` import this file.
"""

import statistics
import time

import numpy
import pyvista
from PIL import Image

import vitrine

FRAMES = 5
PEELS = 100


def compare(plotter, file_name):
    """Print the methods' figures, and write their pictures side by side: the default, depth peeling, Vitrine.

    Without multisampling, under which VTK's depth peeling leaves out all that is translucent.
    """
    plotter.disable_anti_aliasing()
    plotter.show(auto_close=False)
    with vitrine.see_through(plotter, "truth"):
        truth = picture(plotter)
        print("layers in a pixel: at most", vitrine.stats(plotter).layers_max)
    print(f"{'method':22}{'ms a frame':>10}{'largest error':>15}  of 255")
    pictures = []
    for name, draw in {
        "default": by_default,
        "depth peeling": peeled,
        "linked-list": seen_through,
    }.items():
        milliseconds, drawn = draw(plotter)
        pictures.append(drawn)
        print(f"{name:22}{milliseconds:10.1f}{abs(drawn - truth).max():15.1f}")
    Image.fromarray(numpy.concatenate(pictures, axis=1).astype(numpy.uint8)).save(file_name)
    print("wrote", file_name)


def by_default(plotter):
    return timed(plotter)


def peeled(plotter):
    """PyVista's depth peeling, with as many peels as the scene needs."""
    plotter.enable_depth_peeling(number_of_peels=PEELS, occlusion_ratio=0)
    try:
        return timed(plotter)
    finally:
        plotter.disable_depth_peeling()


def seen_through(plotter):
    with vitrine.see_through(plotter):
        return timed(plotter)


def timed(plotter):
    """The median time of a frame in milliseconds, and the picture."""
    drawn = picture(plotter)
    times = []
    for _ in range(FRAMES):
        start = time.perf_counter()
        plotter.render()
        plotter.render_window.WaitForCompletion()
        times.append(1000 * (time.perf_counter() - start))
    return statistics.median(times), drawn


def picture(plotter):
    plotter.render()
    return plotter.screenshot(None, return_img=True).astype(float)
