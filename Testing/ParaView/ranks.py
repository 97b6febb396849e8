"""Draws scenes on the ranks of pvbatch: mpirun -np N pvbatch ranks.py PLUGIN FOLDER.

Writes a picture of each scene to FOLDER/ranks-N, and prints a line of JSON for each: what the view told about it.
programs.py compares them with those of one rank. The sources give each rank some of their cells, so that all ranks
together have the same cells, whatever their number.
"""

import json
import pathlib
import sys

from paraview.simple import (
    ColorBy, Contour, CreateView, GroupDatasets, LoadPlugin, Plane, ProgrammableSource, QuerySelect, Render,
    ResetCamera, Show, Text, Wavelet)
from vtkmodules.vtkParallelCore import vtkMultiProcessController

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.dont_write_bytecode = True

from pictures import SIZE, delete_all, picture  # noqa: E402
from scenes import clustered, settings, show  # noqa: E402

RANKS = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
SCENES = {}
TOLD = ("FallbackReason", "NumberOfFragments", "LayersProblem", "LayerBlocks", "LayerDepths", "LayerShares")

# What a source runs on each rank. ParaView adds the names of this and of numpy to those of this script. A sphere is
# divided by cells, or whole on one of the ranks.
CODE = """
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()

def share_of_sphere(number, x, radius, keeps):
    source, heights = vtkSphereSource(), vtkElevationFilter()
    source.SetCenter(x, 0, 0)
    source.SetRadius(radius)
    source.SetThetaResolution(40)
    source.SetPhiResolution(30)
    heights.SetLowPoint(0, -1, 0)
    heights.SetHighPoint(0, 1, 0)
    heights.SetInputConnection(source.GetOutputPort())
    heights.Update()
    data = heights.GetOutput()
    data.BuildCells()
    for cell in range(data.GetNumberOfCells()):
        if not keeps(cell, number):
            data.DeleteCell(cell)
    data.RemoveDeletedCells()
    return data

def divided(cell, number):
    return cell % ranks == rank

def whole(cell, number):
    return number % ranks == rank

def with_ghosts(data):
    # The first cells of this rank again, as the others would have them.
    ghosts = vtkUnsignedCharArray()
    ghosts.SetName("vtkGhostType")
    ghosts.SetNumberOfTuples(data.GetNumberOfCells())
    ghosts.Fill(0)
    for cell in range(50 * (ranks > 1)):
        data.InsertNextCell(data.GetCellType(cell), data.GetCell(cell).GetPointIds())
        ghosts.InsertNextValue(1)
    data.GetCellData().AddArray(ghosts)
    return data

"""


# Without this, rank 0 alone runs CODE.
PIECES = """
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
self.GetOutputInformation(0).Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
"""


def scene(function):
    SCENES[function.__name__.replace("_", " ")] = function
    return function


def program(data):
    """A source of what an expression is on each rank, with the names of CODE."""
    return ProgrammableSource(
        OutputDataSetType="vtkPolyData", Script=f"{CODE}output.ShallowCopy({data})", ScriptRequestInformation=PIECES)


def sphere(view, number, opacity, keeps="divided", x=0.0, radius=None, change=""):
    radius = 1 + 0.1 * number if radius is None else radius
    data = f"{change}(share_of_sphere({number}, {x}, {radius}, {keeps}))"
    return show(program(data), view, opacity, [number / 8, 0.5, 1 - number / 8])


def spheres(view, opacity=0.3, keeps="divided", numbers=range(8)):
    for number in numbers:
        sphere(view, number, opacity, keeps)


@scene
def glass(view):
    spheres(view)


@scene
def camera_that_turned(view):
    """The view up vector is of length 1 but for its last bits."""
    spheres(view)
    ResetCamera(view)
    camera = view.GetActiveCamera()
    for angle in (31, 17, 12):
        camera.Azimuth(angle)
        camera.Elevation(angle)


@scene
def opaque(view):
    for number in range(4):
        sphere(view, number, 1.0, x=0.8 * number, radius=1)


@scene
def glass_around_opaque(view):
    spheres(view, numbers=range(3, 8))
    sphere(view, 1, 1.0)


@scene
def scalars_bar_and_text(view):
    for number in range(4):
        shown = sphere(view, number, 0.4)
        ColorBy(shown, ("POINTS", "Elevation"))
        shown.SetScalarBarVisibility(view, True)
    Show(Text(Text="a title"), view)


@scene
def blocks(view):
    parts = [program(f"share_of_sphere({i}, {i}, 0.8, divided)") for i in range(4)]
    shown = show(GroupDatasets(Input=parts, BlockNames=[f"part{i}" for i in range(4)]), view)
    shown.BlockOpacities = ["/Root/part0", "0.3", "/Root/part2", "0.5"]
    shown.BlockColors = ["/Root/part0", "1", "0", "0", "/Root/part2", "0", "0.5", "1"]


@scene
def selection(view):
    spheres(view, numbers=range(3))
    QuerySelect(QueryString="Elevation > 0.7", FieldType="POINT", InsideOut=0)


@scene
def lines_and_points(view):
    spheres(view, numbers=range(3))
    for number, kind in ((4, "Wireframe"), (5, "Points"), (6, "Surface With Edges")):
        sphere(view, number, 0.5).SetRepresentationType(kind)


@scene
def background_of_two_colours(view):
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Gradient"
    view.Background, view.Background2 = [0.1, 0.2, 0.3], [0.9, 0.8, 0.7]
    spheres(view)


@scene
def memory_limit_and_compact_nodes(view):
    settings(view, MemoryLimit=1, ColorStorage="Compact")
    spheres(view)


@scene
def coincident_faces(view):
    settings(view, CoincidenceSteps=16, CoincidenceSlope=0.5)
    for number in range(3):
        sphere(view, number, 0.4, radius=1)


@scene
def clustered_lights(view):
    clustered(view)
    spheres(view, numbers=range(5))


@scene
def section_of_whole_parts(view):
    settings(view, SectionPlane=1, SectionOrigin=[0, 0, 0.2], SectionNormal=[0, 0.3, -1])
    for number in range(4):
        sphere(view, number, 0.5 + 0.5 * (number % 2), "whole", x=2.5 * number)


@scene
def section_of_parts_of_all_ranks(view):
    settings(view, SectionPlane=1, SectionNormal=[0, 0.3, -1], SectionCaps=0)
    spheres(view, 0.5)


@scene
def caps_of_divided_parts(view):
    settings(view, SectionPlane=1, SectionNormal=[0, 0.3, -1])
    spheres(view, 0.5)


@scene
def culling(view):
    settings(view, Culling=1)
    sphere(view, 7, 1.0, "whole")
    spheres(view, 0.4, numbers=range(7))


@scene
def ghost_cells(view):
    for number in range(5):
        sphere(view, number, 0.4, change="with_ghosts")


@scene
def volume(view):
    shown = Show(Wavelet(), view, "UniformGridRepresentation")
    shown.SetRepresentationType("Volume")
    ColorBy(shown, ("POINTS", "RTData"))


@scene
def tone_mapping_and_smoothing(view):
    view.UseToneMapping = view.UseFXAA = 1
    spheres(view, numbers=range(4))


@scene
def text_in_space(view):
    shown = Show(Text(Text="a part"), view, "TextSourceRepresentation")
    shown.TextPropMode, shown.BillboardPosition = "Billboard 3D Text", [0, 0, 1.5]
    shown.Opacity, shown.FontSize = 0.5, 40
    spheres(view, numbers=range(3))


@scene
def section_of_open_parts(view):
    settings(view, SectionPlane=1, SectionNormal=[0.1, 0.3, -1])
    show(Plane(), view)
    sphere(view, 1, 0.5).SetRepresentationType("Wireframe")


@scene
def ambient_occlusion(view):
    view.UseAmbientOcclusion = 1
    spheres(view, numbers=range(2))


@scene
def transparent_screenshot(view):
    spheres(view, numbers=range(4))
    return {"TransparentBackground": 1}


@scene
def contours(view):
    """ParaView divides the grid, and each rank rounds the points at its borders anew."""
    contour = Contour(Input=Wavelet(), ContourBy=["POINTS", "RTData"], Isosurfaces=[100, 130, 160, 190, 220])
    contour.ComputeNormals = 0
    show(contour, view, 0.3)


def draw(name, fill, folder):
    view = CreateView("VitrineRenderView")
    view.ViewSize = SIZE
    view.UseFXAA = 0
    options = fill(view) or {}
    if fill is not camera_that_turned:
        ResetCamera(view)
    view.LayersPixel = [120, 100]
    Render(view)
    picture(view, folder / f"{name.replace(' ', '-')}.png", **options)
    view.UpdatePropertyInformation()
    told = {
        key: [round(value, 4) if isinstance(value, float) else value for value in view.GetProperty(key)]
        for key in TOLD}
    delete_all(view)
    return told


def main(plugin, folder, *names):
    LoadPlugin(plugin, remote=False, ns=globals())
    folder = pathlib.Path(folder, f"ranks-{RANKS}")
    folder.mkdir(exist_ok=True)
    for name, fill in SCENES.items():
        if not names or name in names:
            print(json.dumps({"scene": name} | draw(name, fill, folder)), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
