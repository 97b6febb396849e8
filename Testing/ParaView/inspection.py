"""Sections and layers under a pixel, for behave.py."""

import scenes
from paraview import smstate
from paraview.simple import Box, GetViews, LoadState, RenameSource, Render, ResetCamera, SaveState, Sphere
from pictures import delete_all, difference, picture
from tests import new_view, off_truth, test

SECTION = {
    "SectionPlane": 1, "SectionOrigin": [0.1, 0.0, 0.0], "SectionNormal": [-1.0, -0.5, -1.0],
    "SectionPlanes": [0.0, 0.3, 0.0, 0.0, -1.0, 0.0], "SectionBox": "Remove inside",
    "SectionBounds": [0.0, 1.0, 0.0, 1.0, 0.0, 2.0], "SectionHatch": "Cross", "SectionHatchSpacing": 0.1,
    "SectionEdgeWidth": 2, "SectionCaps": 1, "SectionInterference": 0, "SectionRemoveBeyondAll": 0}


def settle(view, **values):
    for name, value in values.items():
        setattr(view, name, value)


def show_box(view, **shape):
    scenes.show(Box(**shape), view, 1.0, [0.2, 0.5, 0.8])
    Render(view)  # a first one sets the camera
    view.CameraPosition, view.CameraFocalPoint = [3, 2, 4], [0, 0, 0]


@test("ParaView's own, of a shorter box", 0.0)
def section_of_a_box(folder):
    """A cube whose half is cut away, with a cap, is a cuboid."""
    view = new_view("RenderView")
    show_box(view, XLength=0.75, Center=[-0.125, 0, 0])
    right = picture(view, folder / "shorter.png")
    delete_all(view)
    view = new_view()
    show_box(view)
    view.SectionEdgeWidth = 0
    uncut = picture(view, folder / "uncut.png")
    ways = (
        {"SectionPlane": 1, "SectionOrigin": [0.25, 0, 0], "SectionNormal": [-2, 0, 0]},
        {"SectionPlane": 0, "SectionPlanes": [0.25, 0, 0, -1, 0, 0]},
        {"SectionPlanes": [], "SectionBox": "Keep inside", "SectionBounds": [-2, 0.25, -2, 2, -2, 2]},
        {"SectionBox": "Remove inside", "SectionBounds": [0.25, 2, -2, 2, -2, 2]})
    wrong = []
    for way in ways:
        settle(view, **way)
        wrong.append(difference(right, picture(view, folder / "cut.png")))
    view.SectionBox = "None"
    wrong.append(difference(uncut, picture(view, folder / "whole-again.png")))
    delete_all(view)
    return max(wrong)


@test("truth, four sections", 1.0)
def section_of_glass(folder):
    view = new_view()
    shown = scenes.show(scenes.blocks(), view)
    shown.BlockOpacities = ["/Root/part0", "0.3", "/Root/part2", "0.5"]
    scenes.spheres(view, 3, 0.3)
    ResetCamera(view)
    Render(view)
    pictures, wrong = [picture(view, folder / "whole.png")], []
    for way in (
            {"SectionPlane": 1, "SectionNormal": [-1, 0, -1]}, {"SectionHatch": "Lines"}, {"SectionCaps": 0}, SECTION):
        settle(view, **way)
        wrong.append(off_truth(view, folder / "section.png"))
        pictures.append(picture(view, folder / "section.png"))
        if difference(*pictures[-2:]) < 10:
            raise AssertionError(f"{way} changes nothing")
    delete_all(view)
    return max(wrong)


@test("the picture without tiles", 0.0)
def stripes_in_tiles(folder):
    """ParaView draws a screenshot that is larger than the view in tiles. Stripes go on from tile to tile."""
    view = new_view()
    scenes.spheres(view, 2, 1.0)
    ResetCamera(view)
    settle(view, SectionPlane=1, SectionNormal=[0, 0, -1], SectionEdgeWidth=0)
    tiles = picture(view, folder / "tiles.png", ImageResolution=[480, 400])
    view.ViewSize = [480, 400]
    whole = picture(view, folder / "whole.png", ImageResolution=[480, 400])
    delete_all(view)
    cap = slice(150, 250)  # in the middle of both directions, where tiles meet
    return difference(tiles[cap, cap], whole[cap, cap])


def loaded(folder, way):
    """The view that a state restores, which is saved in one of two ways."""
    if way == "pvsm":
        SaveState(str(folder / "section.pvsm"))
        delete_all(*GetViews())
        LoadState(str(folder / "section.pvsm"))
    else:
        script = smstate.get_state()
        delete_all(*GetViews())
        exec(compile(script, "state", "exec"), {})
    (view,) = [found for found in GetViews() if found.GetXMLName() == "VitrineRenderView"]
    view.UseFXAA = 0  # a setting of ParaView, which states do not keep
    return view


@test("the same view before, two kinds of states", 0.0)
def section_in_states(folder):
    worst = 0.0
    for way in ("pvsm", "python"):
        view = new_view()
        scenes.spheres(view, 3, 0.3)
        ResetCamera(view)
        settle(view, LayersPixel=[12, 34], **SECTION)
        before = picture(view, folder / "before.png")
        view = loaded(folder, way)
        for name, value in {"LayersPixel": [12, 34], **SECTION}.items():
            found = getattr(view, name)
            if found != value:
                raise AssertionError(f"{way}: {name} is {found}, and was {value}")
        worst = max(worst, difference(before, picture(view, folder / "after.png")))
        delete_all(view)
    return worst


@test("the same view without", 0.0)
def culling(folder):
    """A wall hides blocks, and one of two blocks; glass is before it and behind."""
    view = new_view()
    scenes.show(Box(XLength=4, YLength=4, ZLength=0.2, Center=[0, 0, 2]), view)
    scenes.show(scenes.blocks(), view, color=[0.2, 0.5, 0.8])
    for i in range(6):
        scenes.show(Sphere(Center=[i - 2, 1, -1], Radius=0.4), view, 0.3 if i % 2 else 1.0, [0.9, 0.5, 0.1])
    scenes.show(Sphere(Center=[0, 0, 3], Radius=0.5), view, 0.3)
    Render(view)  # a first one sets the camera
    view.CameraFocalPoint, view.CameraViewUp = [0, 0, 0], [0, 1, 0]
    worst = 0.0
    for position, fewest in (([0.3, 0.2, 12], 4), ([5, 1, 8], 1), ([12, 1, -3], 0)):
        view.CameraPosition = position
        pictures = []
        for view.Culling in (0, 1):
            pictures.append(picture(view, folder / "culling.png"))
            view.UpdatePropertyInformation()
            reason, parts = (view.GetProperty(name)[0] for name in ("CullingReason", "NumberOfCulledParts"))
            if reason or (parts < fewest if view.Culling else parts != 0):
                raise AssertionError(f"{parts} parts are culled: {reason}")
        worst = max(worst, difference(*pictures))
    delete_all(view)
    return worst


def layers_under(view, *pixel):
    """Names of sources and blocks, distances and shares of a pixel's layers."""
    view.LayersPixel = pixel
    Render(view)
    view.UpdatePropertyInformation()
    problem = view.GetProperty("LayersProblem")[0]
    if problem:
        raise AssertionError(problem)
    names = ("LayerSources", "LayerBlocks", "LayerDistances", "LayerShares")
    return list(zip(*(view.GetProperty(name) for name in names)))


@test("computed", 0.0)
def layers_under_a_pixel(folder):
    """Balls around balls, and four blocks of which one is opaque. A ray meets balls at their radii."""
    view = new_view()
    for radius in (3, 2):
        scenes.show(Sphere(
            registrationName=f"ball{radius}", Radius=radius, ThetaResolution=180, PhiResolution=181), view, 0.25)
    group = scenes.blocks()
    RenameSource("group", group)
    scenes.show(group, view).BlockOpacities = ["/Root/part0", "0.5"]
    Render(view)  # a first one sets the camera
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.4, 0, 10], [0.4, 0, 0], [0, 1, 0]
    view.CameraParallelProjection, view.CameraParallelScale = 1, 4
    ahead = layers_under(view, 120, 100)
    expected = [("ball3", "", 0.25), ("ball2", "", 0.1875), ("group", "part0", 0.28125), ("group", "part1", 0.28125)]
    if [(source, block, round(share, 5)) for source, block, _, share in ahead] != expected:
        raise AssertionError(f"layers: {ahead}")
    distances = [layer[2] - ahead[0][2] for layer in ahead[:3]]
    if any(abs(found - right) > 0.02 for found, right in zip(distances, (0, 1.013, 2.28))):
        raise AssertionError(f"distances: {distances}")
    view.SectionPlane, view.SectionNormal, view.SectionCaps = 1, [0, 0, -1], 0
    behind = [layer[:2] for layer in layers_under(view, 120, 100)]
    if behind != [("group", "part1")]:
        raise AssertionError(f"layers behind a section: {behind}")
    if layers_under(view, 0, 0):
        raise AssertionError("there are layers where nothing is")
    delete_all(view)
    return 0.0


@test("the message", 0.0)
def pixel_outside_of_the_view(folder):
    view = new_view()
    scenes.spheres(view, 1, 0.5)
    try:
        layers_under(view, 10000, 5)
    except AssertionError as error:
        if "not within the renderer's viewport" in str(error):
            delete_all(view)
            return 0.0
        raise
    raise AssertionError("no message")
