"""Draws the scenes of scenes.py in ParaView's own view and in Vitrine's, and compares: pvbatch draw.py PLUGIN FOLDER.

Prints a line of JSON for each scene: its name, how many levels of 255 the picture differs from what is right, by what
it was judged, how many levels ParaView's own picture differs, and the seconds of the processor for frames of both.
"""

import json
import pathlib
import sys
import time

from paraview.simple import CreateView, GetViews, LoadPlugin, Render, ResetCamera

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.dont_write_bytecode = True

import scenes  # noqa: E402
from pictures import SIZE, delete_all, difference, layers_of, picture  # noqa: E402

FRAMES = 5


def frame_time(view):
    """The least time of the processor for a frame, of some frames, in seconds."""
    times = []
    for _ in range(FRAMES):
        start = time.process_time()
        Render(view)
        times.append(time.process_time() - start)
    return min(times)


def begin(kind, scene):
    """Show a scene in a new view; returns the view and what the scene returned."""
    view = CreateView(kind)
    view.ViewSize = SIZE
    view.UseFXAA = 0
    ResetCamera(view)
    computed = scene(view)
    if not computed:
        ResetCamera(view)
    Render(view)
    return view, computed


def draw(name, scene, is_same, folder):
    file = folder / name.replace(" ", "-")
    view, computed = begin("RenderView", scene)
    own = picture(view, f"{file}-paraview.png")
    own_time = frame_time(view)
    delete_all(view)
    view, _ = begin("VitrineRenderView", scene)
    drawn = picture(view, f"{file}-vitrine.png")
    taken = frame_time(view)
    layers = 0 if is_same else layers_of(view)
    if is_same:
        by, right = "ParaView's own", own
    elif computed:
        by, right = "computed", computed(drawn.shape)
    else:
        view.TransparencyMethod = "truth"
        by, right = "truth", picture(view, f"{file}-truth.png")
    delete_all(view)
    return {
        "scene": name, "by": by, "wrong": difference(drawn, right), "allowed": 0.0 if is_same else 1.0,
        "paraview": difference(own, right), "layers": layers, "time": taken, "paraview time": own_time}


def main(plugin, folder, *names):
    LoadPlugin(plugin, remote=False, ns=globals())
    folder = pathlib.Path(folder)
    for table in (scenes.SAME, scenes.EXACT):
        for name, scene in table.items():
            if not names or name in names:
                try:
                    row = draw(name, scene, table is scenes.SAME, folder)
                except AssertionError as error:
                    row = {"scene": name, "error": str(error)}
                    delete_all(*GetViews())
                print(json.dumps(row), flush=True)


main(*sys.argv[1:])
