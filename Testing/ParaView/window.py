"""Runs within ParaView's window: paraview --script=window.py. Shows blocks of glass in Vitrine's view, as a user does.

Writes a line of JSON to window.json in the folder of results, and a picture of the screen. Then ParaView ends.
"""

import json
import os
import pathlib
import sys

from paraview.simple import (
    AssignViewToLayout, CreateRenderView, CreateView, GetActiveView, GetLayout, LoadPlugin, Render, ResetCamera)
from PIL import ImageGrab

FOLDER = pathlib.Path(os.environ["VITRINE_RESULTS"])
sys.path.insert(0, os.environ["VITRINE_SCRIPTS"])
sys.dont_write_bytecode = True

import scenes  # noqa: E402
from pictures import difference, layers_of, picture  # noqa: E402



def show():
    """Show the blocks in ParaView's view and in Vitrine's beside it; returns the row."""
    LoadPlugin(os.environ["VITRINE_PLUGIN"], remote=False, ns=globals())
    own = GetActiveView() or CreateRenderView()
    layout = GetLayout(own)
    view = CreateView("VitrineRenderView")
    if not GetLayout(view):
        AssignViewToLayout(view, layout)
    for one in (own, view):
        scenes.EXACT["blocks with opacity and colour"](one)
        ResetCamera(one)
        Render(one)
    view.UseFXAA = 0
    drawn = picture(view, FOLDER / "window-view.png")
    layers_of(view)
    view.TransparencyMethod = "truth"
    right = picture(view, FOLDER / "window-truth.png")
    view.TransparencyMethod = "linked-list"
    Render(view)
    ImageGrab.grab(xdisplay=os.environ["DISPLAY"]).save(FOLDER / "window.png")
    return {"wrong": difference(drawn, right)}


row = {"scene": "ParaView's window", "by": "truth", "allowed": 1.0}
try:
    row |= show()
except Exception as error:  # which ParaView would show in a window
    row["error"] = f"{type(error).__name__}: {error}"
(FOLDER / "window.json").write_text(json.dumps(row), encoding="utf-8")
os._exit(0)  # no call of paraview.simple closes the window
