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
from pictures import SIZE, difference, picture  # noqa: E402


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


def draw_exactly(threshold, folder):
    view = show("VitrineRenderView", glass)
    drawn = draw(view, threshold, folder)
    view.TransparencyMethod = "truth"
    return {"by": "truth", "allowed": 1.0, "wrong": difference(drawn, draw(view, threshold, folder))}


def draw_by_ranks(folder):
    pictures = [draw(show(kind, opaque), 0, folder) for kind in ("RenderView", "VitrineRenderView")]
    return {"by": "ParaView's own", "allowed": 0.0, "wrong": difference(*pictures)}


def main(plugin, folder, port, ranks):
    folder = pathlib.Path(folder)
    Connect("127.0.0.1", int(port))  # a clean root does not know "localhost"
    LoadPlugin(plugin, remote=True, ns=globals())
    LoadPlugin(plugin, remote=False, ns=globals())
    rows = {
        "client": draw_exactly(1e6, folder),
        "server": draw_by_ranks(folder) if int(ranks) > 1 else draw_exactly(0, folder)}
    for place, row in rows.items():
        print(json.dumps({"scene": f"drawn on the {place}, {ranks} ranks on the server"} | row), flush=True)
    Disconnect()


main(*sys.argv[1:])
