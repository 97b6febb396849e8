"""Scenes with effects of VTK's, for the table that matrix.py makes of them."""

import dataclasses
from typing import Any, Callable

import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401, a factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401, a factory
from scenes import actor_of, pixels
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource
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
    vtkTranslucentPass,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

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


def pane(place, size, color, opacity):
    """A square, turned a little from the camera."""
    source = vtkPlaneSource()
    source.SetOrigin(-size / 2, -size / 2, 0)
    source.SetPoint1(size / 2, -size / 2, 0)
    source.SetPoint2(-size / 2, size / 2, 0)
    actor = actor_of(source)
    actor.SetPosition(place)
    actor.RotateX(15)
    actor.RotateY(-20)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(opacity)
    return actor


# Where a thin scene has neither panes nor opaque parts other than the wall.
FREE_PLACES = ((1.2, 0.35, 0.4), (1.2, 0.8, 0.4), (1.2, -0.8, 0.4), (-1.1, 0.7, 0.4), (0.4, -0.8, 0.4))


class Scene:
    """Opaque parts, of which a wall hides some and the view some others, glass, and lights.

    The glass of a thin scene covers no pixel twice, so VTK's own blending is exact. It is all panes then, of which one
    stands in front of an opaque part, and one goes through another.
    """

    def __init__(self, thin=False):
        self.thin = thin
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
        self.glass = self.panes() if thin else self.spheres()
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
        self.take: Callable[[Any], numpy.ndarray] = pixels
        self.find: Callable[[Any], numpy.ndarray] = lambda renderer: numpy.zeros((1, 1, 1))

    @staticmethod
    def spheres():
        spheres = [
            sphere((0.3 * i - 0.4, 0.15 * i - 0.1, 0.5), 0.45, (0.2, 0.3 * i, 0.9), 0.4)
            for i in range(3)
        ]
        return [*spheres, sphere((0.1, 0.3, -0.2), 0.5, (0.9, 0.8, 0.2), 0.3)]

    @staticmethod
    def panes():
        places = ((-0.5, 0.1, 0.6), (0.6, -0.3, 0.2), (0.2, 0.8, -0.3), (-0.3, -0.8, 0.3))
        return [
            pane(place, 0.55, (0.2 + 0.2 * i, 0.3 * i, 0.9 - 0.2 * i), 0.4 + 0.1 * i)
            for i, place in enumerate(places)
        ]

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


def occlusion_pass(scene):
    """Without a radius in thin scenes: VTK's glass hides ambient light around it, and Vitrine's hides none."""
    around(vtkSSAOPass, Radius=1e-6 if scene.thin else 0.5, Bias=0.01)(scene)


def shadow_pass(scene):
    shadows = vtkShadowMapPass()
    passes = vtkRenderPassCollection()
    passes.AddItem(shadows.GetShadowMapBakerPass())
    passes.AddItem(shadows)
    if scene.thin:
        passes.AddItem(vtkTranslucentPass())  # without which VTK draws no glass
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

    def find(renderer):
        props = list(renderer.GetViewProps())
        found = numpy.zeros((SIZE[1], SIZE[0], 1), dtype=int)
        picker = vtkPropPicker()
        for x in range(5, SIZE[0], 22):
            for y in range(5, SIZE[1], 16):
                picker.Pick(x, y, 0, renderer)
                prop = picker.GetViewProp()
                found[y, x] = 1 + props.index(prop) if prop is not None else 0
        return found

    scene.find = find


def multisampled(scene):
    scene.samples = 4


def layers(scene):
    """A second renderer over the first one, with parts of its own."""
    scene.layer = vtkRenderer()
    scene.layer.SetLayer(1)
    scene.layer.SetActiveCamera(scene.renderer.GetActiveCamera())
    scene.layer.AddActor(sphere((-0.8, -0.5, 0.3), 0.3, (1, 1, 1), 1.0))
    glass = pane if scene.thin else sphere
    scene.layer.AddActor(glass((-0.9, -0.4, 0.6), 0.3, (0, 1, 0), 0.5))


def tiled(scene):
    """An image of twice the size, in four tiles."""

    def take(window):
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


def hidden_lines(scene):
    wireframe(scene)
    flag("UseHiddenLineRemoval")(scene)


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
        actor.SetPosition(FREE_PLACES[0] if scene.thin and glass else (0.2, -0.5, 0.4))
        scene.add(actor, glass)


def splats(scene):
    random = numpy.random.default_rng(5)
    for opacity, glass in ((1.0, False), (0.5, True)):
        places = vtkPoints()
        anywhere = random.uniform(-0.7, 0.7, (40, 3))
        chosen = numpy.array(FREE_PLACES) if scene.thin and glass else anywhere
        places.SetData(numpy_to_vtk(chosen, deep=True))
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
    standing.SetPosition(FREE_PLACES[0] if scene.thin else (0.3, 0.2, 0.7))
    standing.GetTextProperty().SetFontSize(14)
    scene.renderer.AddViewProp(flat)
    scene.add(standing, is_glass=True)


@dataclasses.dataclass(frozen=True)
class Thin:
    """How VTK's picture of a thin scene is made, and how near to it Vitrine's has to be.

    apply: what makes VTK draw the effect; the effect's own by default.
    blends: VTK draws the glass by vtkTranslucentPass, which blends. Flags and selectors do without passes, so glass is
        drawn by vtkOrderIndependentTranslucentPass there. It is up to 1/255 off what blending draws, and has another
        alpha, so the alpha is not compared.
    tolerance: in 1/255. It is 2 where VTK does not blend, or the effect works on pictures whose colours are rounded.
    outliers: pixels that may differ by more. VTK's own picture changes by 14/255 in up to 13 pixels with FXAA where
        the opacity of the panes changes by 0.002, as FXAA compares contrasts with thresholds.
    """

    apply: Callable[[Scene], None] | None = None
    blends: bool = True
    tolerance: int = 1
    outliers: int = 0


ROUNDED = Thin(tolerance=2)
NOT_BLENDED = Thin(blends=False, tolerance=2)


@dataclasses.dataclass(frozen=True)
class Effect:
    """tolerance: of glass against truth, in 1/255; 2 where the effect works on pictures whose colours are rounded.
    FXAA takes 3: it compares contrasts with thresholds, which a difference of 1/255 before it may cross.

    thin: how a thin scene compares with VTK's own picture.
    """

    name: str
    apply: Callable[[Scene], None]
    tolerance: int = 1
    thin: Thin = Thin()
    changes: bool = True  # the picture of an opaque scene
    one_stage: bool = False  # VTK draws it otherwise in each window, as it reads memory that nobody has set


EFFECTS = (
    Effect("FXAA, flag", flag("UseFXAA"), 3, Thin(blends=False, tolerance=2, outliers=20)),
    Effect("FXAA, pass", around(vtkOpenGLFXAAPass), 3, Thin(tolerance=2, outliers=20)),
    Effect("SSAA", around(vtkSSAAPass), 2, ROUNDED),
    Effect("SSAO, flag", flag("UseSSAO", SSAORadius=0.5, SSAOBias=0.01), 1, NOT_BLENDED),
    Effect("SSAO, pass", occlusion_pass, 2),
    Effect("EDL", around(vtkEDLShading), 2),
    Effect("tone mapping", around(vtkToneMappingPass), 2),
    Effect("depth of field", around(vtkDepthOfFieldPass), 2, one_stage=True),
    Effect("shadows, flag", flag("UseShadows"), 1, Thin(shadow_pass)),  # the flag loses glass
    Effect("shadows, pass", shadow_pass),
    Effect("hidden lines, flag", hidden_lines, 1, NOT_BLENDED),
    Effect("stereo", stereo, 2, NOT_BLENDED),
    Effect("picking", picking, 1, NOT_BLENDED, changes=False),
    Effect("MSAA", multisampled),
    Effect("layers of renderers", layers),
    Effect("tiled export", tiled, changes=False),
    Effect("volumes", volume),
    Effect("volumes, peeled", peeled_volume, 1, Thin(blends=False, tolerance=0)),
    Effect("PBR, environment", environment),
    Effect("wireframe", wireframe),
    Effect("edges shown", edges),
    Effect("vtkAssembly", assembly),
    Effect("LOD actors", levels_of_detail),
    Effect("point splats", splats),
    Effect("text and labels", texts),
)
