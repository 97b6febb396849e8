"""What users do with Vitrine's view in ParaView: pvbatch behave.py PLUGIN FOLDER [NAME...].

Prints a line of JSON for each: its name, how many levels of 255 a picture differs from what is right, how many are
allowed, and by what it was judged. Pictures that could not be made, or other answers than ParaView's own, are errors.
"""

import contextlib
import io
import json
import os
import pathlib
import re
import sys

import numpy
from paraview import servermanager, smstate
from paraview.simple import (
    AssignViewToLayout, CompositeKeyFrame, CreateLayout, CreateView, Delete, GetAnimationScene, GetAnimationTrack,
    GetSources, GetViews, LoadPlugin, LoadState, Render, ResetCamera, ResetSession, SaveAnimation, SaveState,
    SelectCellsThrough, SelectSurfaceBlocks, SelectSurfaceCells, SelectSurfacePoints, Show, Sphere)

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.dont_write_bytecode = True

import inspection  # noqa: E402, F401, for its tests
import scenes  # noqa: E402
from pictures import SIZE, delete_all, difference, layers_of, picture, read  # noqa: E402
from tests import TESTS, glass, new_view, off_truth, test  # noqa: E402


def premultiplied(pixels):
    """Colours of a file are divided by alpha, which enlarges their errors."""
    alpha = pixels[:, :, 3:]
    return numpy.concatenate([pixels[:, :, :3] * alpha / 255, alpha], axis=2)


@test("truth; ParaView takes alpha from two pictures", 2.0)
def transparent_screenshot(folder):
    view = new_view()
    view.OrientationAxesVisibility = 0
    glass(view)
    worst = off_truth(view, folder / "transparent.png", premultiplied, TransparentBackground=1)
    alpha = read(folder / "transparent.png")[:, :, 3]
    if alpha.min() != 0 or not 0 < alpha.max() < 255:
        raise AssertionError(f"alpha from {alpha.min()} to {alpha.max()}")
    delete_all(view)
    return worst


@test("ParaView's own, with the alpha channel", 0.0)
def opaque_on_transparent(folder):
    pictures = []
    for kind in ("RenderView", "VitrineRenderView"):
        view = new_view(kind)
        scenes.SAME["edges and points"](view)
        ResetCamera(view)
        pictures.append(picture(view, folder / "opaque.png", TransparentBackground=1))
        delete_all(view)
    return difference(*pictures)


@test("truth", 1.0)
def screenshot_thrice_as_large(folder):
    view = new_view()
    glass(view)
    worst = off_truth(view, folder / "large.png", ImageResolution=[3 * size for size in SIZE])
    delete_all(view)
    return worst


@test("the same view before", 0.0)
def state_saved_and_loaded(folder):
    view = new_view()
    view.TransparencyMethod, view.MemoryLimit, view.ColorStorage = "prefix-sum", 64, "Compact"
    view.CoincidenceSteps = 16
    glass(view)
    before = picture(view, folder / "before.png")
    SaveState(str(folder / "state.pvsm"))
    delete_all(view)
    LoadState(str(folder / "state.pvsm"))
    (view,) = [found for found in GetViews() if found.GetXMLName() == "VitrineRenderView"]
    view.UseFXAA = 0  # a setting of ParaView, which states do not keep
    found = view.TransparencyMethod, view.MemoryLimit, view.ColorStorage, view.CoincidenceSteps
    if found != ("prefix-sum", 64, "Compact", 16):
        raise AssertionError(f"settings that were loaded: {found}")
    after = picture(view, folder / "after.png")
    delete_all(view)
    return difference(before, after)


@test("the same view before", 0.0)
def state_as_python(folder):
    view = new_view()
    view.TransparencyMethod = "prefix-sum"
    glass(view)
    before = picture(view, folder / "before.png")
    script = smstate.get_state()
    delete_all(view)
    exec(compile(script, "state", "exec"), {})
    (view,) = [found for found in GetViews() if found.GetXMLName() == "VitrineRenderView"]
    view.UseFXAA = 0
    if view.TransparencyMethod != "prefix-sum":
        raise AssertionError(f"method that was loaded: {view.TransparencyMethod}")
    after = picture(view, folder / "after.png")
    delete_all(view)
    return difference(before, after)


@test("each view alone", 0.0)
def two_views(folder):
    """ParaView's own and Vitrine's side by side, with the same sources."""
    layout = CreateLayout("two views")
    views = []
    for hint, kind in enumerate(("RenderView", "VitrineRenderView")):
        view = new_view(kind)
        AssignViewToLayout(view, layout, hint)
        views.append(view)
    for view in views:
        view.OrientationAxesVisibility = 0
        glass(view)
    layout.SetSize(481, 200)
    both = picture(layout, folder / "both.png", ImageResolution=[481, 200], SeparatorColor=[1, 0, 0])
    (line,) = numpy.flatnonzero((both == [255, 0, 0]).all(axis=(0, 2)))
    sides = both[:, :line], both[:, line + 1:]
    worst = max(
        difference(side, picture(view, folder / "alone.png", ImageResolution=[side.shape[1], 200]))
        for view, side in zip(views, sides))
    delete_all(*views)
    Delete(layout)
    return worst


@test("truth, five frames", 1.0)
def animation(folder):
    view = new_view()
    glass(view)
    scene = GetAnimationScene()
    scene.NumberOfFrames = 5
    track = GetAnimationTrack("Radius", proxy=list(GetSources().values())[0])
    track.KeyFrames = [
        CompositeKeyFrame(KeyTime=time, KeyValues=[radius]) for time, radius in ((0, 0.5), (1, 2.5))]
    layers_of(view)
    frames = {}
    for method in ("linked-list", "truth"):
        view.TransparencyMethod = method
        SaveAnimation(str(folder / f"{method}.png"), view, ImageResolution=SIZE, FrameWindow=[0, 4])
        frames[method] = [read(folder / f"{method}.{i:04}.png") for i in range(5)]
    if difference(frames["truth"][0], frames["truth"][4]) < 10:
        raise AssertionError("nothing moves")
    worst = max(map(difference, frames["linked-list"], frames["truth"]))
    Delete(track)
    delete_all(view)
    return worst


@test("truth, four panels", 1.0)
def comparative_view(folder):
    view = CreateView("VitrineComparativeRenderView")
    view.ViewSize = [2 * size for size in SIZE]
    sphere = Sphere()
    shown = Show(sphere, view)
    shown.Opacity = 0.3
    cue = servermanager.animation.ComparativeAnimationCue(
        AnimatedProxy=sphere, AnimatedPropertyName="Radius", AnimatedElement=0)
    cue.SMProxy.UpdateWholeRange(0.5, 2.0)
    view.Cues = [cue]
    ResetCamera(view)
    Render(view)
    worst = off_truth(view, folder / "panels.png", ImageResolution=[2 * size for size in SIZE])
    panels = read(folder / "panels.png")
    if difference(panels[:SIZE[1], :SIZE[0]], panels[SIZE[1]:, SIZE[0]:]) < 10:
        raise AssertionError("all panels are alike")
    delete_all(view)
    return worst


def selected(view, select, rectangle):
    """What is selected in a rectangle, as texts."""
    select(Rectangle=rectangle, View=view)
    texts = []
    for source in GetSources().values():
        selection = source.GetSelectionInput(0)
        if selection:
            values = getattr(selection, "IDs", None) or getattr(selection, "Blocks", None) or \
                getattr(selection, "BlockSelectors", None)
            texts.append(str(list(values)) if values else selection.GetXMLLabel())
    return texts


@test("ParaView's own answers", 0.0)
def selections(folder):
    answers = []
    for kind in ("RenderView", "VitrineRenderView"):
        view = new_view(kind)
        shown = scenes.show(scenes.blocks(), view)
        scenes.show(Sphere(Center=[1.5, 0, -2]), view)
        shown.BlockOpacities = ["/Root/part0", "0.3"]
        ResetCamera(view)
        Render(view)
        answers.append([
            selected(view, select, [60, 60, 180, 140])
            for select in (SelectSurfaceCells, SelectSurfacePoints, SelectCellsThrough, SelectSurfaceBlocks)])
        delete_all(view)
    if answers[0] != answers[1] or not all(answers[0]):
        raise AssertionError(f"selections: {str(answers)[:1000]}")
    return 0.0


@test("truth", 1.0)
def example_of_the_documentation(folder):
    page = pathlib.Path(__file__).resolve().parents[2] / "docs/howto/paraview.md"
    (example,) = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.S)
    lines = [line for line in example.splitlines() if not line.startswith("LoadPlugin")]
    names = {}
    os.chdir(folder)
    told = io.StringIO()
    with contextlib.redirect_stdout(told):
        exec(compile("\n".join(lines), page.name, "exec"), names)
    view = names["view"]
    if told.getvalue().count("Sphere") != 6:
        raise AssertionError(f"layers: {told.getvalue()}")
    view.ViewSize = SIZE
    view.UseFXAA = 0
    worst = off_truth(view, folder / "example.png")
    delete_all(view)
    return worst


@test("a picture before", 0.0)
def bad_values_are_refused(folder):
    view = new_view()
    glass(view)
    before = picture(view, folder / "good.png")
    view.TransparencyMethod = "no such method"
    view.SectionPlane, view.SectionNormal = 1, [0, 0, 0]
    view.SectionBox, view.SectionBounds = "Keep inside", [1, 0, 0, 1, 0, 1]
    after = picture(view, folder / "bad.png")
    delete_all(view)
    return difference(before, after)


def main(plugin, folder, *names):
    LoadPlugin(plugin, remote=False, ns=globals())
    for name, (function, by, allowed) in TESTS.items():
        if not names or name in names:
            row = {"scene": name, "by": by, "allowed": allowed}
            try:
                row["wrong"] = function(pathlib.Path(folder))
            except Exception as error:  # all others are to be run
                row["error"] = f"{type(error).__name__}: {error}"
                ResetSession()
                LoadPlugin(plugin, remote=False, ns=globals())
            print(json.dumps(row), flush=True)


main(*sys.argv[1:])
