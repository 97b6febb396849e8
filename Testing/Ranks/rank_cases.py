"""What each rank of mpirun does in the tests of vtkDistributedTransparencyPass; test_ranks.py starts it.

    mpirun -np N python3 -m mpi4py rank_cases.py CASE...

Rank 0 writes a line of JSON for each case: what each rank found. It draws the whole scene alone, too, and tells the
number of bytes in which the picture of all ranks differs from that.
"""

import functools
import json
import os
import sys

import numpy as np
from mpi4py import MPI  # which initializes MPI
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkParallelMPI import vtkMPIController
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkDataSetMapper,
    vtkGlyph3DMapper,
    vtkLight,
    vtkPointGaussianMapper,
    vtkPolyDataMapper,
    vtkRenderer,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkToneMappingPass

import vitrine
from pieces import Scene, actor_of, piece_of

SIZE = (160, 120)
SEED = 54
BACKGROUND = (0.2, 0.3, 0.4)

comm = MPI.COMM_WORLD
controller = vtkMPIController()
controller.Initialize()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()


def tangle(count=400, opaque=0.1):
    """Triangles through each other, of any colour and alpha. A share is opaque. Some translucent ones coincide."""
    random = np.random.default_rng(SEED)
    centres = random.uniform(-1, 1, (count, 1, 3))
    points = (centres + random.normal(0, 0.35, (count, 3, 3))).reshape(-1, 3)
    triangles = np.arange(3 * count).reshape(-1, 3)
    is_opaque = random.uniform(0, 1, count) < opaque
    triangles = np.concatenate([triangles, triangles[~is_opaque][: count // 10]])
    colors = random.integers(0, 256, (len(triangles), 4))
    colors[:, 3] //= 2
    colors[:count][is_opaque, 3] = 255
    return Scene(points, triangles, colors)


def split(scene):
    """The cells that hide what is behind, and the others. VTK draws an actor as a whole either way."""
    is_opaque = scene.colors[:, 3] == 255
    return [
        Scene(scene.points, scene.triangles[mask], scene.colors[mask]) for mask in (is_opaque, ~is_opaque)
    ]


class View:
    """A window with a renderer."""

    def __init__(self, size=SIZE, method=None, viewport=(0, 0, 1, 1), window=None, samples=0):
        self.window = window or vitrine.vtkHeadlessRenderWindow()
        self.window.SetSize(*size)
        self.window.SetMultiSamples(samples)
        self.renderer = vtkRenderer()
        self.renderer.SetViewport(*viewport)
        self.renderer.SetBackground(*BACKGROUND)
        self.window.AddRenderer(self.renderer)
        self.frame = vitrine.vtkSeeThroughPass()
        self.method = method or vitrine.vtkLinkedListTransparencyPass()
        self.frame.SetTranslucentPass(self.method)
        self.renderer.SetPass(self.frame)

    def add(self, opaque, translucent):
        for data, is_translucent in ((opaque, False), (translucent, True)):
            if data.GetNumberOfCells():
                actor = actor_of(data)
                actor.ForceTranslucentOn() if is_translucent else actor.ForceOpaqueOn()
                self.renderer.AddActor(actor)
        return self

    def picture(self):
        self.window.Render()
        width, height = self.window.GetActualSize()
        pixels = vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
        return vtk_to_numpy(pixels).copy()


def method_of_ranks():
    method = vitrine.vtkDistributedTransparencyPass()
    method.SetController(controller)
    return method


def pieces_of(scene, partition="random", ghosts=False):
    random = np.random.default_rng(SEED)
    return [piece_of(part, rank, ranks, partition, ghosts, random) for part in split(scene)]


def view_of_ranks(scene, partition="random", ghosts=False, **options):
    """This rank's piece of a scene, and the camera that all share."""
    view = View(method=method_of_ranks(), **options)
    view.add(*pieces_of(scene, partition, ghosts))
    view.method.ResetCamera(view.renderer)
    return view


def view_of_one(scene, view, **options):
    """All of a scene, seen as in another view."""
    one = View(**options)
    one.add(*(part.piece(np.arange(len(part.triangles))) for part in split(scene)))
    one.renderer.SetActiveCamera(view.renderer.GetActiveCamera())
    one.method.SetColorStorage(view.method.GetColorStorage())
    return one


def found(view, one, **more):
    """What a rank tells of a frame. On rank 0 it is compared with that of one rank."""
    picture = view.picture()
    told = {
        "reason": view.method.GetFallbackReason(),
        "fragments": view.method.GetNumberOfFragments(),
        "sent": view.method.GetSentFragments(),
        "bytes": view.method.GetSentFragmentBytes(),
        "node": view.method.GetNodeBytes(),
        "bands": view.method.GetNumberOfBands(),
        **more,
    }
    if rank == 0:
        expected = one().picture()
        told["differing"] = int((picture != expected).sum())
        told["covered"] = int((expected[:, :3] != expected[0, :3]).any(axis=1).sum())
        folder = os.environ.get("VITRINE_RANKS_PICTURES")
        if folder and told["differing"]:
            np.save(f"{folder}/ranks-{ranks}-{case}.npy", np.stack([picture, expected]))
    return told


def divided(partition, ghosts, storage="HalfFloat"):
    scene = tangle()
    view = view_of_ranks(scene, partition, ghosts)
    getattr(view.method, f"SetColorStorageTo{storage}")()
    return found(view, lambda: view_of_one(scene, view))


def multisampled(samples, partition="random", ghosts=False, **options):
    """Edges of opaque and translucent triangles within pixels, of which ranks have some each."""
    scene = tangle(opaque=0.2)
    options["samples"] = samples
    view = view_of_ranks(scene, partition, ghosts, **options)
    told = found(view, lambda: view_of_one(scene, view, **options))
    if rank == 0:
        pictures = [view_of_one(scene, view, **{**options, "samples": n}).picture() for n in (samples, 0)]
        told["smoothed"] = int((pictures[0] != pictures[1]).sum())
    return told


def parallel():
    """Opaque depths of samples from 0 on, where depth buffers have the finest steps."""
    scene = tangle(opaque=0.5)
    view = view_of_ranks(scene, samples=4)
    view.renderer.GetActiveCamera().ParallelProjectionOn()
    view.method.ResetCamera(view.renderer)
    return found(view, lambda: view_of_one(scene, view, samples=4))


def bands(samples=0):
    scene = tangle()
    view = view_of_ranks(scene, samples=samples)
    view.method.SetMemoryLimit(90_000 // ranks + 1000 * rank)
    view.picture()
    return found(view, lambda: view_of_one(scene, view, samples=samples))


def moving():
    """Rooms that were predicted for another camera, and lists that grow."""
    scene = tangle()
    view = view_of_ranks(scene)
    view.picture()
    camera = view.renderer.GetActiveCamera()
    camera.Zoom(3)
    if rank == 0:
        camera.Azimuth(31)
        camera.Elevation(17)
    view.method.SynchronizeCamera(view.renderer)
    return found(view, lambda: view_of_one(scene, view))


def empty():
    """All of the scene is on the last rank."""
    scene = tangle()
    view = View(method=method_of_ranks())
    parts = [part.piece(np.arange(len(part.triangles)) if rank == ranks - 1 else []) for part in split(scene)]
    view.add(*parts)
    view.method.ResetCamera(view.renderer)
    return found(view, lambda: view_of_one(scene, view))


def nothing():
    """No rank has translucent geometry."""
    scene = tangle(opaque=1)
    view = view_of_ranks(scene)
    return found(view, lambda: view_of_one(scene, view))


def viewport():
    scene = tangle()
    place = {"viewport": (0.1, 0.2, 0.7, 0.9)}
    view = view_of_ranks(scene, **place)
    return found(view, lambda: view_of_one(scene, view, **place))


def floats():
    """A floating-point target, in which colours pass 1."""
    scene = tangle()
    views = [view_of_ranks(scene)]
    if rank == 0:
        views.append(view_of_one(scene, views[0]))
    for view in views:
        effect = vtkToneMappingPass()
        effect.SetDelegatePass(view.frame)
        view.renderer.SetPass(effect)
    return found(views[0], lambda: views[1])


def all_ranks():
    """Each rank gets the picture."""
    scene = tangle()
    view = view_of_ranks(scene)
    view.method.SetPictureRank(-1)
    picture = view.picture()
    same = [bool((picture == other).all()) for other in comm.allgather(picture)]
    return found(view, lambda: view_of_one(scene, view), same=same)


def tiles():
    """A wall of screens: all ranks draw the tile of each rank, which keeps it."""
    scene = tangle()
    view = view_of_ranks(scene)
    one = view_of_one(scene, view)

    def draw(view, tile):
        view.window.SetTileScale(ranks, 1)
        view.window.SetTileViewport(tile / ranks, 0, (tile + 1) / ranks, 1)
        return view.picture()

    pictures = []
    for tile in range(ranks):
        view.method.SetPictureRank(tile)
        pictures.append(draw(view, tile))
    same = [bool((pictures[rank] == draw(one, rank)).all())]
    view.method.SetPictureRank(0)
    draw(view, 0)
    draw(one, 0)
    return found(view, lambda: one, same=same)


def splats_of():
    mapper = vtkPointGaussianMapper()
    mapper.SetInputData(tangle(40, 0).piece(np.arange(40)))
    mapper.SetScaleFactor(0.1)
    mapper.ScalarVisibilityOff()
    mapper.EmissiveOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(0.5)
    return actor


def splats(frames=1):
    """Light that is added, on the last rank alone. In the first frame, shaders do not expect it."""
    scene = tangle()
    view = view_of_ranks(scene)
    if rank == ranks - 1:
        view.renderer.AddActor(splats_of())
    view.method.ResetCamera(view.renderer)

    def one():
        other = view_of_one(scene, view)
        other.renderer.AddActor(splats_of())
        return other

    for _ in range(frames - 1):
        view.picture()
    return found(view, one)


def drift():
    """The last rank drew splats alone before, so that its shaders expect them and others do not."""
    if rank == ranks - 1:
        view = View(method=method_of_ranks())
        view.method.SetController(None)
        view.renderer.AddActor(splats_of())
        view.renderer.ResetCamera()
        view.picture()
    scene = tangle()
    both = view_of_ranks(scene)
    if rank == ranks - 1:
        view.renderer.RemoveAllViewProps()
        view.method.SetController(controller)
        view.add(*pieces_of(scene))
        both = view
    both.method.ResetCamera(both.renderer)
    both.picture()  # with other roundings: one rank's first frame without splats has them, too
    return found(both, lambda: view_of_one(scene, both))


def forced():
    """Ghost cells of an actor whose opaque colours are forced to be translucent."""
    scene = tangle()
    scene.colors[:, 3] = 255
    view = View(method=method_of_ranks())
    random = np.random.default_rng(SEED)
    view.add(scene.piece([]), piece_of(scene, rank, ranks, "random", True, random))
    view.method.ResetCamera(view.renderer)
    one = View()
    one.add(scene.piece([]), scene.piece(np.arange(len(scene.triangles))))
    one.renderer.SetActiveCamera(view.renderer.GetActiveCamera())
    return found(view, lambda: one)


def whole_part(number):
    """A part that no other touches: a sphere, a cube, blocks, or glyphs; some are lines, and some are opaque."""
    source = vtkCubeSource() if number % 2 else vtkSphereSource()
    source.SetCenter(1.1 * (number % 4), 1.1 * (number // 4), 0.05 * number)
    source.Update()
    mapper = (vtkPolyDataMapper, vtkPolyDataMapper, vitrine.vtkCulledCompositePolyDataMapper, vtkGlyph3DMapper)[
        number % 4
    ]()
    data = source.GetOutput()
    if number % 4 == 2:
        data = vtkMultiBlockDataSet()
        data.SetBlock(0, source.GetOutput())
    if number % 4 == 3:
        mapper.SetSourceData(source.GetOutput())
        mapper.SetScaleFactor(0.2)
    mapper.SetInputDataObject(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(1 if number % 5 == 0 else 0.4)
    actor.GetProperty().SetColor(0.2 + 0.05 * number, 1 - 0.05 * number, 0.5)
    if number == 4:
        actor.GetProperty().SetRepresentationToWireframe()
    return actor


def features_of(views):
    """Whole parts with lights and a tolerance; and beside them with caps, an x-ray and a culler."""
    is_shared = isinstance(views[0].method, vitrine.vtkDistributedTransparencyPass)
    numbers = range(rank, 12, ranks) if is_shared else range(12)
    for view in views:
        for number in numbers:
            view.renderer.AddActor(whole_part(number))
    lit, cut = views
    for number in range(12):
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.PositionalOn()
        light.SetPosition(number % 4, number // 4, 2)
        light.SetIntensity(0.2)
        lit.renderer.AddLight(light)
    lit.frame.SetLightingPass(vitrine.vtkDeferredLightsPass())
    lit.method.SetCoincidenceSteps(16)
    plane = vtkPlane()
    plane.SetOrigin(1.5, 1.2, 0.1)
    plane.SetNormal(0.1, -0.2, -1)
    section = vitrine.vtkSection()
    section.AddPlane(plane)
    bounds_of = cut.method if is_shared else vitrine.vtkDistributedTransparencyPass()
    section.SetSceneBounds(*bounds_of.ComputeVisiblePropBounds(cut.renderer))
    section.Attach(cut.renderer)
    x_ray = vitrine.vtkPartXRay()
    for number, actor in zip(numbers, cut.renderer.GetActors()):
        if number == 6:
            x_ray.AddPart(actor)
    x_ray.Attach(cut.renderer)
    cut.renderer.GetCullers().RemoveAllItems()
    cut.renderer.AddCuller(vitrine.vtkHierarchicalSBufferCuller())


def views_beside(make, samples):
    """Two renderers of one window."""
    first = View(method=make(), viewport=(0, 0, 0.55, 1), samples=samples)
    return [first, View(method=make(), viewport=(0.45, 0.1, 1, 0.9), window=first.window, samples=samples)]


def picker_of(view, hidden, controller_of_picker=None):
    picker = vitrine.vtkLayerPicker()
    picker.SetController(controller_of_picker)
    picker.SetRenderer(view.renderer)
    left = 20 if view.renderer.GetViewport()[0] == 0 else 85
    picker.SetArea(left, 30, left + 49, 89)
    picker.SetBehindOpaque(hidden)
    return picker


def layers_of(view, *options):
    """The layers of a rectangle; and for each of them the rank that has it, and the place of its part there."""
    picker = picker_of(view, *options)
    good = picker.Pick()
    count = picker.GetNumberOfLayers()
    arrays = (picker.GetOffsets(), picker.GetWindowDepths(), picker.GetShares(), picker.GetColors())
    props = list(view.renderer.GetActors())
    owned = [props.index(picker.GetProp(i)) if picker.GetProp(i) else -1 for i in range(count)]
    of_ranks = np.array([picker.GetRank(i) for i in range(count)])
    return good, [vtk_to_numpy(array).copy() for array in arrays], of_ranks, np.array(owned)


def features(samples=0):
    """Two renderers of one window with what else a renderer can have, and the layers of pixels."""
    views = views_beside(method_of_ranks, samples)
    features_of(views)
    for view in views:
        view.method.ResetCamera(view.renderer)
        if rank == 0:
            camera = view.renderer.GetActiveCamera()
            camera.Elevation(20)
            camera.Zoom(1.5)
            camera.SetScreenBottomLeft(-1, -1, 0)
            camera.SetScreenBottomRight(1, -1, 0)
            camera.SetScreenTopRight(1, 1, 0)
            camera.SetEyePosition([0.5, 0.2, 6])
            camera.SetUseOffAxisProjection(view is views[0])
        view.method.SynchronizeCamera(view.renderer)
    one = views_beside(vitrine.vtkPrefixSumTransparencyPass, samples)
    features_of(one)
    for view, other in zip(views, one):
        other.renderer.SetActiveCamera(view.renderer.GetActiveCamera())
    for view in (views[0], one[0]):
        view.method.SetPartNumbers(True)
    told = found(views[0], lambda: one[0])
    told["reason"] += views[1].method.GetFallbackReason()
    one[0].window.Render()
    same = []
    for number, hidden in ((0, False), (1, False), (1, True)):
        good, arrays, of_ranks, owned = layers_of(views[number], hidden, controller)
        _, expected, _, props = layers_of(one[number], hidden)
        same.append(good and len(props) > 500 and all(np.array_equal(*pair) for pair in zip(arrays, expected)))
        same.append(np.array_equal(of_ranks, props % ranks))
        same.append(np.array_equal(owned, np.where(of_ranks == rank, props // ranks, -1)))
    other_pixels = picker_of(views[0], False, controller)
    other_pixels.SetArea(20, 30, 69 + (rank == ranks - 1), 89)
    other_pixels.Pick()
    same.append(other_pixels.GetProblem().startswith(f"rank {ranks - 1} asks for other pixels or layers than rank 0"))
    return {**told, "same": [bool(each) for each in same]}


def refused(change):
    """A frame that cannot be drawn, and one after it that can."""
    scene = tangle()
    view = view_of_ranks(scene)
    undo = change(view)
    view.picture()
    reason = view.method.GetFallbackReason()
    undo()
    view.method.SynchronizeCamera(view.renderer)
    return found(view, lambda: view_of_one(scene, view), refused=reason)


def on_last(change, undo):
    """Changes a view on the last rank."""

    def changed(view):
        if rank == ranks - 1:
            change(view)
        return lambda: undo(view) if rank == ranks - 1 else None

    return changed


def lacking():
    """A rank whose driver lacks what the method needs."""
    scene = tangle()
    if rank == ranks - 1:
        os.environ["MESA_GL_VERSION_OVERRIDE"] = "4.2"
        os.environ["MESA_EXTENSION_OVERRIDE"] = "-GL_ARB_compute_shader -GL_ARB_shader_storage_buffer_object"
    view = view_of_ranks(scene)
    view.picture()
    return {"reason": view.method.GetFallbackReason()}


def killed():
    """The last rank ends in the middle."""
    view = view_of_ranks(tangle())
    view.picture()
    if rank == ranks - 1:
        os.kill(os.getpid(), 9)
    view.picture()
    return {}


def raising():
    view = view_of_ranks(tangle())
    view.picture()
    if rank == ranks - 1:
        raise RuntimeError("this rank raises")
    view.picture()
    return {}


def set_size(size):
    return lambda view: view.window.SetSize(*size)


def add_grid(view):
    """Ghost cells that cannot be left out, since their mapper is of another kind."""
    append = vtkAppendFilter()
    append.AddInputData(pieces_of(tangle(), ghosts=True)[1])
    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(append.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(0.5)
    view.renderer.AddActor(actor)


def remove_last(view):
    view.renderer.RemoveActor(view.renderer.GetActors().GetLastActor())


def set_background(color):
    return lambda view: view.renderer.SetBackground(*color)


CASES = {
    **{
        f"{partition}{'-ghosts' if ghosts else ''}": functools.partial(divided, partition, ghosts)
        for partition in ("kd-tree", "round-robin", "random")
        for ghosts in (False, True)
    },
    "compact": lambda: divided("random", False, "Compact"),
    "eight-bit": lambda: divided("random", False, "EightBit"),
    "bands": bands,
    "samples-bands": lambda: bands(4),
    "samples-2": lambda: multisampled(2),
    "samples-4": lambda: multisampled(4, "kd-tree"),
    "samples-4-ghosts": lambda: multisampled(4, "random", True),
    "samples-8": lambda: multisampled(8),
    "samples-viewport": lambda: multisampled(4, viewport=(0.1, 0.2, 0.7, 0.9)),
    "samples-parallel": parallel,
    "samples-features": lambda: features(4),
    "moving": moving,
    "empty": empty,
    "nothing": nothing,
    "viewport": viewport,
    "floats": floats,
    "all-ranks": all_ranks,
    "tiles": tiles,
    "splats": splats,
    "splats-expected": lambda: splats(2),
    "drift": drift,
    "forced": forced,
    "features": features,
    "sizes": lambda: refused(on_last(set_size((100, 80)), set_size(SIZE))),
    "cameras": lambda: refused(
        on_last(lambda view: view.renderer.GetActiveCamera().Azimuth(5), lambda view: None)
    ),
    "storages": lambda: refused(
        on_last(
            lambda view: view.method.SetColorStorageToCompact(), lambda view: view.method.SetColorStorageToHalfFloat()
        )
    ),
    "memory": lambda: refused(
        on_last(lambda view: view.method.SetMemoryLimit(16), lambda view: view.method.SetMemoryLimit(0))
    ),
    "backgrounds": lambda: refused(
        on_last(set_background((0, 0, 0)), set_background(BACKGROUND)),
    ),
    "grids": lambda: refused(on_last(add_grid, remove_last)),
    "occlusion": lambda: refused(
        on_last(lambda view: view.renderer.UseSSAOOn(), lambda view: view.renderer.UseSSAOOff())
    ),
    "samples": lambda: refused(
        on_last(lambda view: view.window.SetMultiSamples(4), lambda view: view.window.SetMultiSamples(0))
    ),
    "lacking": lacking,
    "killed": killed,
    "raising": raising,
}

for case in sys.argv[1:]:
    rows = comm.gather({"case": case, **CASES[case]()})
    if rank == 0:
        print(json.dumps(rows), flush=True)
