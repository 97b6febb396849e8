"""Effects of VTK's, each with transparency, lights, the culler, and all three: what cells of the table say, measured.

    python3 matrix.py NAME...     prints the rows of these effects; of all without names
    python3 matrix.py --update    writes the table into docs/effects.md

A scene has opaque parts, glass, and a few lights, drawn in small windows. Each cell is one of
    exact      opaque scenes are VTK's with that effect, to the last bit; glass is as the same chain around truth draws
    same       lights, or the culler: the picture is VTK's, to the last bit
    view only  the culler leaves out what lies outside of the view, and nothing else; the picture is VTK's
    off        it does nothing, and says why; the picture is VTK's
    refused    VTK draws in its place, and says why
    WRONG      anything else, with the numbers
"""

import dataclasses
import functools
import pathlib
import sys
from typing import Any, Callable

import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401, a factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401, a factory
from scenes import actor_of, pixels, window_with
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkBillboardTextActor3D,
    vtkColorTransferFunction,
    vtkLight,
    vtkPointGaussianMapper,
    vtkPropPicker,
    vtkRenderer,
    vtkTextActor,
    vtkTexture,
    vtkVolume,
    vtkVolumeProperty,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingLOD import vtkLODActor
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkDepthOfFieldPass,
    vtkEDLShading,
    vtkOpenGLFXAAPass,
    vtkRenderPassCollection,
    vtkRenderStepsPass,
    vtkSSAAPass,
    vtkSSAOPass,
    vtkSequencePass,
    vtkShadowMapPass,
    vtkToneMappingPass,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

import vitrine

SIZE = (120, 90)


def sphere(place, radius, color, opacity):
    source = vtkSphereSource()
    source.SetThetaResolution(20)
    source.SetPhiResolution(14)
    source.SetRadius(radius)
    actor = actor_of(source)
    actor.SetPosition(place)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def box(place, size, color):
    source = vtkCubeSource()
    source.SetXLength(size)
    source.SetYLength(size)
    source.SetZLength(size)
    actor = actor_of(source)
    actor.SetPosition(place)
    actor.GetProperty().SetColor(color)
    return actor


class Scene:
    """Opaque parts, of which a wall hides some and the view some others, glass, and lights."""

    def __init__(self):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.2, 0.3, 0.5)
        self.wall = box((0, 0, -1.5), 1.0, (0.7, 0.7, 0.6))
        self.wall.SetScale(3.4, 2.6, 0.2)
        self.opaque = [
            self.wall,
            sphere((-0.5, 0.1, 0.0), 0.4, (0.9, 0.3, 0.2), 1.0),
            sphere((0.6, -0.3, 0.2), 0.3, (0.2, 0.5, 0.9), 1.0),
        ]
        self.opaque += [box((0.2 * i - 0.6, 0, -2.6), 0.15, (1, 1, 0)) for i in range(7)]
        self.opaque += [box((40 + 3 * i, 0, -3), 1.0, (0, 1, 1)) for i in range(3)]
        self.glass = [
            sphere((0.3 * i - 0.4, 0.15 * i - 0.1, 0.5), 0.45, (0.2, 0.3 * i, 0.9), 0.4)
            for i in range(3)
        ]
        self.glass.append(sphere((0.1, 0.3, -0.2), 0.5, (0.9, 0.8, 0.2), 0.3))
        for actor in self.opaque + self.glass:
            self.renderer.AddActor(actor)
        self.renderer.AutomaticLightCreationOff()
        for i in range(5):
            light = vtkLight()
            light.SetLightTypeToSceneLight()
            light.SetPositional(True)
            light.SetConeAngle(180 if i else 40)
            light.SetPosition(1.5 - 0.8 * i, 1.8 - 0.5 * i, 3)
            light.SetFocalPoint(0.2, 0, 0)
            light.SetIntensity(0.3 if i else 0.6)
            self.renderer.AddLight(light)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.2, 0.3, 5)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewAngle(30)
        camera.SetClippingRange(2, 12)
        self.samples = 0
        self.layer: Any = None
        self.on_window: Callable[[Any], None] = lambda window: None
        self.take: Callable[[Any, Any], numpy.ndarray] = lambda window, renderer: pixels(window)

    def add(self, prop, is_glass=False):
        (self.glass if is_glass else self.opaque).append(prop)
        self.renderer.AddViewProp(prop)


def around(kind, **settings):
    """A pass around the usual steps, as applications set it."""

    def apply(scene):
        effect = kind()
        effect.SetDelegatePass(vtkRenderStepsPass())
        for name, value in settings.items():
            getattr(effect, f"Set{name}")(value)
        scene.renderer.SetPass(effect)

    return apply


def flag(name, **settings):
    """A flag of the renderer."""

    def apply(scene):
        getattr(scene.renderer, f"{name}On")()
        for setting, value in settings.items():
            getattr(scene.renderer, f"Set{setting}")(value)

    return apply


def shadow_pass(scene):
    shadows = vtkShadowMapPass()
    passes = vtkRenderPassCollection()
    passes.AddItem(shadows.GetShadowMapBakerPass())
    passes.AddItem(shadows)
    sequence = vtkSequencePass()
    sequence.SetPasses(passes)
    camera = vtkCameraPass()
    camera.SetDelegatePass(sequence)
    scene.renderer.SetPass(camera)


def stereo(scene):
    def switch(window):
        window.SetStereoTypeToRedBlue()
        window.StereoRenderOn()

    scene.on_window = switch


def picking(scene):
    """What a selector finds at some places, beside the picture."""

    def take(window, renderer):
        picture = pixels(window)
        props = list(renderer.GetViewProps())
        found = numpy.zeros_like(picture)
        picker = vtkPropPicker()
        for x in range(5, SIZE[0], 22):
            for y in range(5, SIZE[1], 16):
                picker.Pick(x, y, 0, renderer)
                prop = picker.GetViewProp()
                found[y, x] = 1 + props.index(prop) if prop is not None else 0
        return numpy.concatenate((picture, found))

    scene.take = take


def multisampled(scene):
    scene.samples = 4


def layers(scene):
    """A second renderer over the first one, with parts of its own."""
    scene.layer = vtkRenderer()
    scene.layer.SetLayer(1)
    scene.layer.SetActiveCamera(scene.renderer.GetActiveCamera())
    for prop in (
        sphere((-0.8, -0.5, 0.3), 0.3, (1, 1, 1), 1.0),
        sphere((-0.9, -0.4, 0.6), 0.3, (0, 1, 0), 0.5),
    ):
        scene.layer.AddActor(prop)


def tiled(scene):
    """An image of twice the size, in four tiles."""

    def take(window, _):
        tiles = vtkWindowToImageFilter()
        tiles.SetInput(window)
        tiles.SetScale(2)
        tiles.SetInputBufferTypeToRGBA()
        tiles.ReadFrontBufferOff()
        tiles.Update()
        image = tiles.GetOutput()
        width, height, _ = image.GetDimensions()
        scalars = vtk_to_numpy(image.GetPointData().GetScalars())
        return scalars.reshape(height, width, 4).copy()

    scene.take = take


def volume(scene):
    image = vtkImageData()
    image.SetDimensions(12, 12, 12)
    image.SetSpacing(0.08, 0.08, 0.08)
    image.SetOrigin(-0.9, -0.9, 0.1)
    grid = numpy.indices((12, 12, 12)).sum(axis=0).astype(numpy.uint8) * 7
    image.GetPointData().SetScalars(numpy_to_vtk(grid.ravel(), deep=True))
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.SetAutoAdjustSampleDistances(False)
    mapper.SetSampleDistance(0.04)
    look = vtkVolumeProperty()
    opacity, color = vtkPiecewiseFunction(), vtkColorTransferFunction()
    opacity.AddPoint(0, 0.0)
    opacity.AddPoint(255, 0.6)
    color.AddRGBPoint(0, 1, 0, 0)
    color.AddRGBPoint(255, 1, 1, 0)
    look.SetScalarOpacity(opacity)
    look.SetColor(color)
    prop = vtkVolume()
    prop.SetMapper(mapper)
    prop.SetProperty(look)
    scene.add(prop)


def peeled_volume(scene):
    volume(scene)
    scene.renderer.UseDepthPeelingOn()
    scene.renderer.UseDepthPeelingForVolumesOn()
    scene.renderer.SetMaximumNumberOfPeels(50)
    scene.renderer.SetOcclusionRatio(0)


def environment(scene):
    image = vtkImageData()
    image.SetDimensions(16, 8, 1)
    rows = numpy.linspace(0.1, 0.9, 16 * 8 * 3, dtype=numpy.float32).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(rows, deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.SetColorModeToDirectScalars()
    texture.MipmapOn()
    texture.InterpolateOn()
    scene.renderer.UseImageBasedLightingOn()
    scene.renderer.SetEnvironmentTexture(texture)
    scene.renderer.GetEnvMapPrefiltered().SetPrefilterMaxSamples(16)
    scene.renderer.GetEnvMapPrefiltered().SetPrefilterLevels(3)
    scene.renderer.GetEnvMapLookupTable().SetLUTSize(32)
    scene.renderer.GetEnvMapLookupTable().SetLUTSamples(16)
    scene.renderer.GetEnvMapIrradiance().SetIrradianceSize(16)
    for actor in scene.opaque + scene.glass:
        actor.GetProperty().SetInterpolationToPBR()
        actor.GetProperty().SetMetallic(0.4)
        actor.GetProperty().SetRoughness(0.4)


def wireframe(scene):
    for actor in (scene.opaque[1], scene.glass[0]):
        actor.GetProperty().SetRepresentationToWireframe()


def edges(scene):
    for actor in (scene.opaque[1], scene.glass[0]):
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetEdgeColor(0, 0, 0)


def assembly(scene):
    for group in (scene.opaque[1:3], scene.glass[:2]):
        whole = vtkAssembly()
        for actor in group:
            scene.renderer.RemoveActor(actor)
            whole.AddPart(actor)
        whole.RotateZ(10)
        scene.renderer.AddViewProp(whole)


def levels_of_detail(scene):
    for like, glass in ((scene.opaque[1], False), (scene.glass[0], True)):
        actor = vtkLODActor()
        actor.SetMapper(like.GetMapper())
        actor.SetProperty(like.GetProperty())
        actor.SetPosition(0.2, -0.5, 0.4)
        scene.add(actor, glass)


def splats(scene):
    random = numpy.random.default_rng(5)
    for opacity, glass in ((1.0, False), (0.5, True)):
        places = vtkPoints()
        places.SetData(numpy_to_vtk(random.uniform(-0.7, 0.7, (40, 3)), deep=True))
        cloud = vtkPolyData()
        cloud.SetPoints(places)
        mapper = vtkPointGaussianMapper()
        mapper.SetInputData(cloud)
        mapper.SetScaleFactor(0.05)
        mapper.EmissiveOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.1, 0.9, 0.4)
        actor.GetProperty().SetOpacity(opacity)
        scene.add(actor, glass)


def texts(scene):
    flat, standing = vtkTextActor(), vtkBillboardTextActor3D()
    flat.SetInput("flat")
    flat.SetPosition(5, 5)
    standing.SetInput("label")
    standing.SetPosition(0.3, 0.2, 0.7)
    standing.GetTextProperty().SetFontSize(14)
    scene.renderer.AddViewProp(flat)
    scene.add(standing, is_glass=True)


@dataclasses.dataclass(frozen=True)
class Effect:
    """tolerance: of glass, in 1/255; 2 where the effect works on pictures whose colours are rounded.

    FXAA takes 3: it compares contrasts with thresholds, which a difference of 1/255 before it may cross.
    """

    name: str
    apply: Callable[[Scene], None]
    tolerance: int = 1
    changes: bool = True  # the picture of an opaque scene
    one_stage: bool = False  # VTK draws it otherwise in each window, as it reads memory that nobody has set


EFFECTS = (
    Effect("FXAA, flag", flag("UseFXAA"), 3),
    Effect("FXAA, pass", around(vtkOpenGLFXAAPass), 3),
    Effect("SSAA", around(vtkSSAAPass), 2),
    Effect("SSAO, flag", flag("UseSSAO", SSAORadius=0.5, SSAOBias=0.01)),
    Effect("SSAO, pass", around(vtkSSAOPass, Radius=0.5, Bias=0.01), 2),
    Effect("EDL", around(vtkEDLShading), 2),
    Effect("tone mapping", around(vtkToneMappingPass), 2),
    Effect("depth of field", around(vtkDepthOfFieldPass), 2, one_stage=True),
    Effect("shadows, flag", flag("UseShadows")),
    Effect("shadows, pass", shadow_pass),
    Effect("hidden lines, flag", lambda s: (wireframe(s), flag("UseHiddenLineRemoval")(s))[0]),
    Effect("stereo", stereo, 2),
    Effect("picking", picking, changes=False),
    Effect("MSAA", multisampled),
    Effect("layers of renderers", layers),
    Effect("tiled export", tiled, changes=False),
    Effect("volumes", volume),
    Effect("volumes, peeled", peeled_volume),
    Effect("PBR, environment", environment),
    Effect("wireframe", wireframe),
    Effect("edges shown", edges),
    Effect("vtkAssembly", assembly),
    Effect("LOD actors", levels_of_detail),
    Effect("point splats", splats),
    Effect("text and labels", texts),
)

COLUMNS = ("transparency", "lights", "culler", "all three")


def release(render_pass, window):
    """VTK's sequences release nothing of what they hold."""
    if isinstance(render_pass, vtkCameraPass):
        passes: Any = render_pass.GetDelegatePass().GetPasses()
        for one in passes:
            one.ReleaseGraphicsResources(window)
    render_pass.ReleaseGraphicsResources(window)


class Stage:
    """A scene with an effect, in a window."""

    def __init__(self, effect):
        self.scene = Scene()
        self.window = window_with(self.scene.renderer, size=SIZE)
        effect.apply(self.scene)
        self.window.SetMultiSamples(self.scene.samples)
        if self.scene.layer is not None:
            self.window.SetNumberOfLayers(2)
            self.window.AddRenderer(self.scene.layer)
        self.scene.on_window(self.window)
        self.chain = self.scene.renderer.GetPass()
        self.scene.renderer.GetCullers().RemoveAllItems()

    def show_glass(self, shown):
        for prop in self.scene.glass:
            prop.SetVisibility(shown)
        if self.scene.layer is not None:
            list(self.scene.layer.GetActors())[1].SetVisibility(shown)

    def picture(self):
        for _ in range(3):  # VTK 9.1's depth of field is black until the window was read once
            self.window.Render()
            pixels(self.window)
        self.window.Render()
        return self.scene.take(self.window, self.scene.renderer)

    def end(self):
        if self.chain is not None:
            release(self.chain, self.window)
        self.scene.renderer.SetPass(None)
        self.window.Finalize()


class Drawing:
    """What a stage shows with features that are switched on, and what they say."""

    def __init__(self, stage, *, glass, method=None, lights=None, cull=False):
        renderer = stage.scene.renderer
        stage.show_glass(glass)
        culler = vitrine.vtkHierarchicalSBufferCuller() if cull else None
        if cull:
            renderer.AddCuller(culler)
        handle = vitrine.see_through(stage.window, method, lights=lights) if method else None
        if lights:
            renderer.GetPass().GetLightingPass().SetCutOff(0.0)
        self.picture = stage.picture()
        self.stats = handle.stats() if handle else None
        self.mode = culler.GetCullingModeAsString() if cull else ""
        self.culling_reason = culler.GetReason() if cull else ""
        if handle:
            handle.remove()
        if cull:
            renderer.RemoveCuller(culler)


def difference(one, other):
    """The largest difference of a channel, and the number of pixels that differ."""
    if one.shape != other.shape:
        return 256, -1
    each = numpy.abs(one.astype(int) - other.astype(int)).max(axis=-1)
    return int(each.max()), int((each > 0).sum())


@dataclasses.dataclass(frozen=True)
class Cell:
    """What one feature does beside one effect."""

    kind: str
    reason: str = ""

    def __str__(self):
        return f"{self.kind}: {self.reason}" if self.reason else self.kind


class Row:
    """The cells of one effect; pictures are drawn once."""

    def __init__(self, effect):
        self.effect = effect
        self.shared = Stage(effect) if effect.one_stage else None

    @functools.cache
    def drawing(self, **features):
        stage = self.shared or Stage(self.effect)
        drawing = Drawing(stage, **features)
        if stage is not self.shared:
            stage.end()
        return drawing

    def end(self):
        if self.shared is not None:
            self.shared.end()

    def wrong(self, what, one, other, tolerance=0):
        """A cell that says what differs, or None."""
        most, count = difference(one.picture, other.picture)
        return None if most <= tolerance else Cell("WRONG", f"{what}: {count} pixels by up to {most}")

    def transparency(self, lights=None, cull=False):
        features = {"lights": lights, "cull": cull}
        plain = self.drawing(glass=False)
        opaque = self.drawing(glass=False, method="linked-list", **features)
        exact = self.drawing(glass=True, method="linked-list", **features)
        truth = self.drawing(glass=True, method="truth", **features)
        wrong = self.wrong("opaque", opaque, plain) or self.wrong(
            "glass", exact, truth, self.effect.tolerance
        )
        if wrong:
            return wrong
        if difference(exact.picture, opaque.picture)[1] == 0:
            return Cell("WRONG", "the glass is missing")
        reason = exact.stats.fallback_reason or exact.stats.set_aside
        return Cell("refused", reason) if reason else Cell("exact")

    def lights(self):
        plain = self.drawing(glass=False)
        reasons = set()
        for kind in ("clustered", "deferred"):
            lit = self.drawing(glass=False, method="linked-list", lights=kind)
            wrong = self.wrong(kind, lit, plain)
            if wrong:
                return wrong
            reasons.add(lit.stats.lights_reason)
            if not lit.stats.lights_reason and lit.stats.lights == 0:
                return Cell("WRONG", f"{kind}: no light was lit by clusters, and nothing says why")
        reason = "; ".join(sorted(reasons - {""}))
        return Cell("off", reason) if reason else Cell("same")

    def culler(self):
        for glass in (False, True):
            with_culler = self.drawing(glass=glass, cull=True)
            wrong = self.wrong("culled", with_culler, self.drawing(glass=glass))
            if wrong:
                return wrong
        return self.culled(with_culler)

    @staticmethod
    def culled(drawing):
        kind = drawing.mode if drawing.mode in ("off", "view only") else "same"
        return Cell(kind, drawing.culling_reason if kind != "same" else "")

    def all_three(self):
        exact = self.transparency(lights="clustered", cull=True)
        if exact.kind == "WRONG":
            return exact
        drawn = self.drawing(glass=True, method="linked-list", lights="clustered", cull=True)
        lights = Cell("off", drawn.stats.lights_reason) if drawn.stats.lights_reason else Cell("same")
        parts = {"": exact, "lights ": lights, "culler ": self.culled(drawn)}
        differing = [
            f"{name}{cell.kind}" for name, cell in parts.items() if cell.kind not in ("exact", "same")
        ]
        return Cell(", ".join(differing) or "exact")

    def cells(self):
        return (self.transparency(), self.lights(), self.culler(), self.all_three())

    def changes_the_picture(self):
        bare = Row(Effect("nothing", lambda scene: None)).drawing(glass=False)
        return difference(bare.picture, self.drawing(glass=False).picture)[1] != 0


def table(names=()):
    """The rows as Markdown, and after them the reasons that cells give."""
    reasons: dict[str, int] = {}
    lines = ["| effect | " + " | ".join(COLUMNS) + " |", "| --- |" + " --- |" * len(COLUMNS)]
    for effect in EFFECTS:
        if names and effect.name not in names:
            continue
        row, cells = Row(effect), []
        for cell in row.cells():
            mark = ""
            if cell.reason:
                mark = f" [{reasons.setdefault(cell.reason, len(reasons) + 1)}]"
            cells.append(cell.kind + mark)
        row.end()
        lines.append(f"| {effect.name} | " + " | ".join(cells) + " |")
    lines.append("")
    lines += [f"{number}. {reason}" for reason, number in reasons.items()]
    return "\n".join(lines)


def update(page):
    """Put the table between the marks of a page."""
    begin, end = "<!-- table -->", "<!-- end of table -->"
    text = page.read_text(encoding="utf-8")
    head, _, rest = text.partition(begin)
    _, _, tail = rest.partition(end)
    page.write_text(f"{head}{begin}\n{table()}\n{end}{tail}", encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1:] == ["--update"]:
        update(pathlib.Path(__file__).resolve().parents[2] / "docs" / "effects.md")
    else:
        print(table(sys.argv[1:]))
