"""The scenes of scripts/test-paraview. pvbatch and pvpython run them.

A scene is a function that shows something in a view. It returns nothing, or a function that computes the picture that
the view must give. Those of SAME must be ParaView's own to the last bit. Those of EXACT are held to 1/255 of truth.
"""

import numpy
from paraview.simple import (
    AddLight, Clip, ColorBy, Cone, Contour, Cylinder, GetColorTransferFunction, Glyph, GroupDatasets, Plane,
    QuerySelect, Show, Slice, Sphere, Superquadric, Text, Wavelet)

SAME = {}
EXACT = {}


def same(function):
    SAME[function.__name__.replace("_", " ")] = function
    return function


def exact(function):
    EXACT[function.__name__.replace("_", " ")] = function
    return function


def show(source, view, opacity=1.0, color=None, representation="Surface"):
    """Show a source; returns what shows it."""
    shown = Show(source, view)
    shown.SetRepresentationType(representation)
    shown.Opacity = opacity
    shown.ColorArrayName = ["POINTS", ""]
    if color:
        shown.AmbientColor = shown.DiffuseColor = color
    return shown


def spheres(view, count, opacity):
    for i in range(count):
        sphere = Sphere(Radius=1 + 0.1 * i, ThetaResolution=40, PhiResolution=30)
        show(sphere, view, opacity, [i / count, 0.5, 1 - i / count])


def settings(view, **values):
    """Change settings that only Vitrine's view has."""
    if view.GetXMLName() == "VitrineRenderView":
        for name, value in values.items():
            setattr(view, name, value)


def clustered(view):
    """Add lights, which Vitrine's view assigns to clusters."""
    settings(view, ClusteredLights=1)
    for i in range(6):
        light = AddLight(view)
        light.Coords, light.Type = "Scene", "Positional"
        light.Position, light.FocalPoint = [3 * (i - 2), 2, 3], [0, 0, 0]
        light.DiffuseColor, light.Intensity = [i % 2, 0.5, 1 - i % 2], 0.3


def grid():
    return Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])


def wavelet(view, opacity, representation="Surface"):
    """Show a grid, coloured by its scalars; returns what shows it."""
    shown = Show(grid(), view, "UniformGridRepresentation")
    shown.SetRepresentationType(representation)
    shown.Opacity = opacity
    ColorBy(shown, ("POINTS", "RTData"))
    return shown


def blocks():
    """Four blocks along x, of which neighbours overlap."""
    parts = [Sphere(Center=[i, 0, 0], Radius=0.8, ThetaResolution=24, PhiResolution=24) for i in range(4)]
    return GroupDatasets(Input=parts, BlockNames=[f"part{i}" for i in range(4)])


@same
def scalars_and_bar(view):
    shown = wavelet(view, 1.0)
    shown.SetScalarBarVisibility(view, True)
    Show(Text(Text="a title"), view)


@same
def opaque_blocks(view):
    shown = show(blocks(), view)
    ColorBy(shown, ("FIELD", "vtkBlockColors"))


@same
def edges_and_points(view):
    show(Cone(Resolution=20), view, representation="Surface With Edges")
    show(Superquadric(Center=[1.5, 0, 0]), view, representation="Points")
    show(Cylinder(Center=[-1.5, 0, 0], Resolution=12), view, representation="Wireframe")


@same
def opaque_volume(view):
    wavelet(view, 1.0, "Volume")
    show(Sphere(Center=[14, 0, 0], Radius=5), view)


@same
def opaque_glyphs(view):
    show(Glyph(Input=Sphere(ThetaResolution=12, PhiResolution=12), GlyphType="Arrow"), view)


@same
def opaque_selection(view):
    wavelet(view, 1.0)
    QuerySelect(QueryString="RTData > 200", FieldType="POINT", InsideOut=0)


@same
def ambient_occlusion(view):
    view.UseAmbientOcclusion = 1
    spheres(view, 1, 1.0)
    show(Plane(Origin=[-3, -3, -1], Point1=[3, -3, -1], Point2=[-3, 3, -1]), view)


@same
def smoothed(view):
    view.UseFXAA = 1
    show(Cone(Resolution=6), view)


@same
def volume_amid_glass(view):
    """ParaView peels volumes and translucent geometry together: with its limit of peels it leaves layers out."""
    view.MaximumNumberOfPeels = 100
    wavelet(view, 1.0, "Volume")
    for i in range(5):
        show(Sphere(Center=[4, 0, 0], Radius=3 + i), view, 0.2, [0.2 * i, 0.4, 0.8])


@exact
def planes(view):
    """Planes that face the camera, unlit: their picture is computed here."""
    colors = [(0.9, 0.2, 0.1), (0.1, 0.8, 0.3), (0.2, 0.3, 0.9), (0.9, 0.8, 0.1), (0.5, 0.5, 0.5)]
    opacities = [0.3, 0.5, 0.2, 0.7, 0.4]
    for i, (color, opacity) in enumerate(zip(colors, opacities)):
        plane = Plane(Origin=[-1, -1, -0.1 * i], Point1=[1, -1, -0.1 * i], Point2=[-1, 1, -0.1 * i])
        shown = show(plane, view, opacity, color)
        shown.Ambient, shown.Diffuse, shown.Specular = 1.0, 0.0, 0.0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [0.2, 0.4, 0.6]
    view.OrientationAxesVisibility = view.CenterAxesVisibility = 0
    view.CameraPosition, view.CameraFocalPoint = [0, 0, 3], [0, 0, 0]
    view.CameraParallelProjection, view.CameraParallelScale = 1, 0.5

    def computed(shape):
        color = numpy.array([0.2, 0.4, 0.6])
        for front, opacity in reversed(list(zip(colors, opacities))):
            color = opacity * numpy.array(front) + (1 - opacity) * color
        return numpy.broadcast_to(255 * color, shape)

    return computed


@exact
def nested_spheres(view):
    spheres(view, 15, 0.15)


@exact
def blocks_with_opacity_and_colour(view):
    shown = show(blocks(), view)
    shown.BlockOpacities = ["/Root/part0", "0.3", "/Root/part2", "0.5"]
    shown.BlockColors = ["/Root/part0", "1", "0", "0", "/Root/part2", "0", "0.5", "1"]


@exact
def all_blocks(view):
    shown = show(blocks(), view, 0.4)
    ColorBy(shown, ("FIELD", "vtkBlockColors"))


@exact
def scalars_bar_and_axes(view):
    shown = wavelet(view, 0.4)
    shown.SetScalarBarVisibility(view, True)
    view.AxesGrid.Visibility = 1


@exact
def opacity_by_scalars(view):
    contour = Contour(Input=grid(), ContourBy=["POINTS", "RTData"], Isosurfaces=[100, 130, 160, 190, 220])
    shown = Show(contour, view)
    ColorBy(shown, ("POINTS", "RTData"))
    shown.RescaleTransferFunctionToDataRange(False, True)
    GetColorTransferFunction("RTData").EnableOpacityMapping = 1


@exact
def selection(view):
    wavelet(view, 0.4)
    QuerySelect(QueryString="RTData > 200", FieldType="POINT", InsideOut=0)


@exact
def clip_and_slice(view):
    source = grid()
    show(Clip(Input=source, ClipType="Plane"), view, 0.35, [0.3, 0.6, 0.9])
    show(Slice(Input=source, SliceType="Plane"), view, 1.0, [0.9, 0.5, 0.1])


@exact
def volume_beside(view):
    view.DepthPeelingForVolumes = 0
    wavelet(view, 1.0, "Volume")
    for i in range(5):
        show(Sphere(Center=[16, 0, 0], Radius=3 + i), view, 0.2, [0.2 * i, 0.4, 0.8])


@exact
def edges(view):
    for i in range(4):
        show(Sphere(Radius=1 + 0.2 * i), view, 0.3, representation="Surface With Edges")


@exact
def lines_and_points(view):
    spheres(view, 3, 0.3)
    show(Superquadric(), view, 0.5, [1, 0, 0], "Wireframe")
    show(Superquadric(Center=[0.5, 0, 0]), view, 0.5, [0, 0, 1], "Points")


@exact
def glyphs(view):
    show(Glyph(Input=Sphere(ThetaResolution=12, PhiResolution=12), GlyphType="Sphere"), view, 0.3)


@exact
def glyphs_of_the_view(view):
    show(Sphere(Radius=2, ThetaResolution=8, PhiResolution=8), view, 0.5, representation="3D Glyphs")


@exact
def parallel_projection(view):
    spheres(view, 5, 0.3)
    view.CameraParallelProjection = 1


@exact
def background_of_two_colours(view):
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Gradient"
    view.Background, view.Background2 = [0.1, 0.2, 0.3], [0.9, 0.8, 0.7]
    spheres(view, 5, 0.3)


@exact
def glass_around_opaque(view):
    show(Cone(Resolution=30, Height=2), view, 1.0, [0.8, 0.7, 0.2])
    spheres(view, 6, 0.2)


@exact
def packed_lists(view):
    settings(view, TransparencyMethod="prefix-sum-predicted", ColorStorage="Compact")
    spheres(view, 15, 0.15)


@exact
def automatic_by_budget(view):
    settings(view, TransparencyMethod="automatic", ErrorBudget=1 / 255)
    spheres(view, 15, 0.15)


@exact
def stencil_routed(view):
    settings(view, TransparencyMethod="stencil-routed")
    spheres(view, 10, 0.2)


@exact
def memory_limit(view):
    settings(view, MemoryLimit=1)
    spheres(view, 15, 0.15)


@exact
def coincident_faces(view):
    settings(view, CoincidenceSteps=16, CoincidenceSlope=0.5)
    for color in ([1, 0, 0], [0, 1, 0], [0, 0, 1]):
        show(Sphere(ThetaResolution=30, PhiResolution=30), view, 0.4, color)


@exact
def clustered_lights(view):
    clustered(view)
    spheres(view, 5, 0.3)
