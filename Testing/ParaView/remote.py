"""Vitrine's view with data and drawing on a server: pvpython remote.py PLUGIN FOLDER PORT RANKS.

A pvserver of so many ranks listens at the port. The picture is drawn on the client, and on the server. Prints a line of
JSON for each.
"""

import json
import pathlib
import sys

from paraview.simple import Connect, CreateView, Disconnect, LoadPlugin, Render, ResetCamera

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.dont_write_bytecode = True

import scenes  # noqa: E402
from pictures import SIZE, difference, layers_of, picture  # noqa: E402

ON_CLIENT, ON_SERVER = 1e6, 0  # megabytes from which on data are drawn on the server


def glass(view):
    """Few spheres: each takes ParaView half a second with a server."""
    scenes.spheres(view, 4, 0.3)


def show(kind, scene):
    view = CreateView(kind)
    view.ViewSize = SIZE
    view.UseFXAA = 0
    view.OrientationAxesVisibility = 0  # the client draws them, and smooths those of its first view
    scene(view)
    ResetCamera(view)
    return view


def draw(view, threshold, folder):
    """The picture, drawn on the server where data are larger than `threshold`, in megabytes."""
    view.RemoteRenderThreshold = threshold
    Render(view)
    return picture(view, folder / f"remote-{view.GetXMLName()}.png")


def answers_of(view):
    """What is told about the last picture: why it was not exact, layers at most, and the layers under a pixel."""
    view.UpdatePropertyInformation()
    names = ("FallbackReason", "MaximumNumberOfLayers", "LayerSources", "LayerShares", "LayersProblem")
    return [list(view.GetProperty(name)) for name in names]


def draw_exactly(folder, *thresholds):
    """Rows of pictures that are drawn with these thresholds. Truth is drawn on the client."""
    view = show("VitrineRenderView", glass)
    view.TransparencyMethod = "truth"
    right = draw(view, ON_CLIENT, folder)
    layers_of(view)
    view.TransparencyMethod, view.LayersPixel = "linked-list", [120, 100]
    rows, answers = [], []
    for threshold in thresholds:
        rows.append({"by": "truth", "allowed": 1.0, "wrong": difference(draw(view, threshold, folder), right)})
        answers.append(answers_of(view))
    if any(answer != answers[0] for answer in answers) or len(answers[0][2]) != 8 or not all(answers[0][2]):
        rows[-1]["error"] = f"what the client is told: {answers}"
    return rows


def main(plugin, folder, port, ranks):
    folder = pathlib.Path(folder)
    Connect("127.0.0.1", int(port))  # a clean root does not know "localhost"
    LoadPlugin(plugin, remote=True, ns=globals())
    LoadPlugin(plugin, remote=False, ns=globals())
    for place, row in zip(("client", "server"), draw_exactly(folder, ON_CLIENT, ON_SERVER)):
        print(json.dumps({"scene": f"drawn on the {place}; ranks of the server: {ranks}"} | row), flush=True)
    Disconnect()


main(*sys.argv[1:])
