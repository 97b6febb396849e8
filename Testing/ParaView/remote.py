"""Vitrine's view with data and drawing on a server: pvpython remote.py PLUGIN FOLDER PORT RANKS.

A pvserver of so many ranks listens at the port. The picture is drawn on the server, and on the client. Prints a line of
JSON for each. A server of several ranks draws as ParaView does, and says so.
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


def opaque(view):
    """Surfaces alone: lines of ParaView's own views of one session differ between views."""
    scenes.spheres(view, 1, 1.0)


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


def draw_exactly(folder, *thresholds):
    """Rows of pictures that are drawn with these thresholds. Truth is drawn on the client, which knows its layers."""
    view = show("VitrineRenderView", glass)
    view.TransparencyMethod = "truth"
    right = draw(view, ON_CLIENT, folder)
    layers_of(view)
    view.TransparencyMethod = "linked-list"
    return [
        {"by": "truth", "allowed": 1.0, "wrong": difference(draw(view, threshold, folder), right)}
        for threshold in thresholds]


def draw_by_ranks(folder):
    pictures = [draw(show(kind, opaque), ON_SERVER, folder) for kind in ("RenderView", "VitrineRenderView")]
    return {"by": "ParaView's own", "allowed": 0.0, "wrong": difference(*pictures)}


def main(plugin, folder, port, ranks):
    folder = pathlib.Path(folder)
    Connect("127.0.0.1", int(port))  # a clean root does not know "localhost"
    LoadPlugin(plugin, remote=True, ns=globals())
    LoadPlugin(plugin, remote=False, ns=globals())
    if int(ranks) > 1:
        rows = [*draw_exactly(folder, ON_CLIENT), draw_by_ranks(folder)]
    else:
        rows = draw_exactly(folder, ON_CLIENT, ON_SERVER)
    for place, row in zip(("client", "server"), rows):
        print(json.dumps({"scene": f"drawn on the {place}; ranks of the server: {ranks}"} | row), flush=True)
    Disconnect()


main(*sys.argv[1:])
