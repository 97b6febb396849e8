"""Assemblies: load() reads a file as a tree of named parts, from_multiblock() takes data; parts are chosen by name."""

from __future__ import annotations

import dataclasses
import numbers
import operator
import os
import pathlib
import weakref
from typing import Any, Callable, Iterable, Iterator, Sequence

from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

from . import _blocks, _cad, _unpack
from ._options import check_boolean
from ._target import _plotter_of, _renderers_of
from ._tree import Tree, make_tree
from .vtkVitrineRendering import vtkAssemblyActors, vtkAssemblyReader

KINDS: tuple[str, ...] = (".glb", ".gltf", *_cad.KINDS, *_unpack.KINDS)
_FAINT = 0.1  # the opacity of what isolate() leaves


def load(
    path: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    *more: str | os.PathLike[str],
    tolerance: float = 0.0,
    cache: bool = True,
) -> Assembly:
    """Read a file of an assembly, or several as one: all kinds that the program reads, and its demo scenes.

    These are glTF 2.0 (.glb, .gltf), also with compressed or quantized geometry; STEP, IGES and BREP (.step, .stp,
    .iges, .igs, .brep); 3MF, OBJ with its materials, STL and PLY; and VTK's own .vtp, .vtu, .vtm, .vtpd, .vtpc, .vtk
    and .vtkhdf. A name such as "demo:assembly" makes a scene instead; `vitrine --help` lists them.

    Args:
        path: the file, or an iterable of files.
        more: further files. Names and paths of their parts that are there already get a number.
        tolerance: how far triangles may be from the shapes of STEP, IGES and BREP, in metres. 0 stands for a thousandth
            of the diagonal of the box around all.
        cache: whether triangles that were made of the same file before are used, and new ones are kept, in vitrine/cad
            of the system's folder for caches.

    Other files than glTF, STEP, IGES and BREP are read by the program, in a process of its own.

    Raises:
        FileNotFoundError: there is no such file, or the program that reads it is not installed.
        IsADirectoryError: it is a folder.
        TypeError: it is no name of a file.
        ValueError: the file is of another kind, or damaged, or what converts STEP is not installed; or none was given.

    Examples:

    >>> import vitrine
    >>> machine = vitrine.load("machine.glb")  # doctest: +SKIP
    >>> machine["/Housing/*"].opacity = 0.2  # doctest: +SKIP
    >>> machine.add_to(plotter)  # doctest: +SKIP
    """
    check_boolean("cache", cache)
    sources = _sources(path, more)
    for source in sources:
        _check_source(source)
    actors = vtkAssemblyActors()
    notes = [note for source in sources for note in _add_parts(actors, source, tolerance, cache)]
    if len(sources) > 1:
        _make_names_unique(actors)
    return Assembly(actors, notes)


def _sources(path: Any, more: Iterable[Any]) -> list[str]:
    """The names of files that load() was given."""
    first = [path] if isinstance(path, (str, bytes, os.PathLike)) or not isinstance(path, Iterable) else path
    sources = [*first, *more]
    for source in sources:
        if not isinstance(source, (str, os.PathLike)):
            raise TypeError(f"a file is named by a str or a path, and several by an iterable of these, not {source!r}")
    if not sources:
        raise ValueError("name one file at least to load")
    return [os.fsdecode(source) for source in sources]


def _check_source(source: str) -> None:
    """Raise an exception for what cannot be read, before anything is."""
    if _unpack.is_demo(source):
        return
    file = pathlib.Path(source)
    if file.is_dir():
        raise IsADirectoryError(f"{file}: is a folder, not a file")
    if not file.is_file():
        raise FileNotFoundError(f"{file}: there is no such file")
    if file.suffix.lower() not in KINDS:
        raise ValueError(f"{file}: is not of a kind that can be read: {', '.join(KINDS)}")
    if file.stat().st_size == 0:
        raise ValueError(f"{file}: is empty")


def _add_parts(actors: vtkAssemblyActors, source: str, tolerance: float, cache: bool) -> list[str]:
    """Add the parts of a file, and return what there is to note of it."""
    suffix = pathlib.Path(source).suffix.lower()
    if _unpack.is_demo(source) or suffix in _unpack.KINDS:
        return _unpack.add_parts(actors, source)
    reader = vtkAssemblyReader()
    reader.SetFileName(source)
    if suffix in _cad.KINDS:
        _cad.set_up(reader, tolerance, cache)
    if not reader.Open():
        raise ValueError(f"{source}: {reader.GetErrorMessage()}")
    actors.AddParts(reader)
    return _cad.notes_of(reader)


def _make_names_unique(actors: vtkAssemblyActors) -> None:
    names, paths = _blocks.UniqueNames(), _blocks.UniqueNames()
    for number in range(actors.GetNumberOfParts()):
        name, path = names.make(actors.GetPartName(number)), paths.make(actors.GetPartPath(number))
        actors.SetPartNames(number, name, path, actors.GetPartMaterialName(number))


def from_multiblock(blocks: Any) -> Assembly:
    """Make an assembly of all data sets in a pyvista.MultiBlock, or in VTK's vtkMultiBlockDataSet or
    vtkPartitionedDataSetCollection. Names of blocks are names of nodes. A collection's vtkDataAssembly is its tree.

    Other data sets than vtkPolyData are drawn by the surface of their cells. A block may say how it looks in its field
    data: "color" (RGB in [0, 1]), "opacity" (in [0, 1]) and "material" (a text), as to_multiblock() writes them. Active
    scalars of points are shown where they are colours: RGB or RGBA in bytes. Other scalars are not. What has no cells
    is left out, and Assembly.notes says so.

    Raises:
        TypeError: it is something else.

    Examples:

    >>> import vitrine
    >>> from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
    >>> from vtkmodules.vtkFiltersSources import vtkSphereSource
    >>> ball = vtkSphereSource()
    >>> ball.Update()
    >>> blocks = vtkMultiBlockDataSet()
    >>> blocks.SetBlock(0, ball.GetOutput())
    >>> blocks.GetMetaData(0).Set(blocks.NAME(), "ball")
    >>> machine = vitrine.from_multiblock(blocks)
    >>> machine["ball"].opacity = 0.2
    >>> print(machine.tree())
    ball  (96 triangles)
    """
    return Assembly(*_blocks.make_actors(blocks))


@dataclasses.dataclass(frozen=True)
class Part:
    """A piece of geometry of one material at one place.

    number is its place in Assembly.parts. name tells all parts of an assembly apart, and so does path, which has the
    names of its nodes from the root, each after a slash. material is the name of its material, which may be empty.
    triangles is the number of triangles that its polygons come to. bounds are those of its points in world
    coordinates: xmin, xmax, ymin, ymax, zmin, zmax.
    """

    number: int
    name: str
    path: str
    material: str
    triangles: int
    bounds: tuple[float, float, float, float, float, float]


class Assembly:
    """Named parts, and the actors that draw them. load() and from_multiblock() make one.

    `assembly[pattern]` is a Selection: the parts that a pattern chooses by name. `bolt*` chooses each node of that name
    with its subtree, `/Housing/lid*` each node of that whole path with its subtree, and `material:glass*` all parts of
    a material. `*` stands for any characters of a name, `**` also for slashes, and `?` for one character. A backslash
    takes the meaning from the character after it. Case counts. A pattern that chooses nothing is a KeyError.

    notes has a line for each thing that is shown otherwise than the file says. actors is the vtkAssemblyActors.
    """

    __slots__ = ("__weakref__", "_faint", "_looks", "_parts", "_window", "actors", "notes")  # typing errors raise

    _living: weakref.WeakSet[Assembly] = weakref.WeakSet()

    @classmethod
    def living(cls) -> list[Assembly]:
        """All assemblies that there are."""
        return list(cls._living)

    def __init__(self, actors: vtkAssemblyActors, notes: Iterable[str] = ()) -> None:
        self.actors = actors
        self._living.add(self)
        self.notes: tuple[str, ...] = tuple(notes)
        self._parts: tuple[Part, ...] | None = None
        self._looks: dict[int, dict[str, Any]] = {}
        self._faint: dict[int, float | None] = {}  # parts, with the opacity that was set before isolate()
        self._window: weakref.ref[Any] | None = None  # where the actors have been shown

    @property
    def parts(self) -> tuple[Part, ...]:
        """All parts, in the order of the tree."""
        if self._parts is None:
            self._parts = tuple(_describe(self.actors, number) for number in range(len(self)))
        return self._parts

    def __len__(self) -> int:
        return self.actors.GetNumberOfParts()

    def __iter__(self) -> Iterator[Part]:
        return iter(self.parts)

    def __contains__(self, pattern: object) -> bool:
        return isinstance(pattern, str) and self.actors.FindParts(pattern, vtkIdList()) == ""

    def __getitem__(self, pattern: str) -> Selection:
        if not isinstance(pattern, str):
            raise TypeError(f"a pattern is a str, such as 'bolt*', not {pattern!r}")
        found = vtkIdList()
        problem = self.actors.FindParts(pattern, found)
        if problem:
            raise KeyError(problem)
        return Selection(self, [found.GetId(i) for i in range(found.GetNumberOfIds())])

    def tree(self) -> Tree:
        """The tree of nodes. Printed, it shows names, numbers of parts and triangles."""
        return make_tree(self.parts)

    def isolate(self, pattern: str, opacity: float = _FAINT) -> Selection:
        """Have all but the parts of a pattern drawn with a share of their opacity, in [0, 1].

        This undoes an earlier isolate(). Returns the parts of the pattern.
        """
        kept = self[pattern]
        share = _opacity(opacity)
        for number, before in list(self._faint.items()):
            Selection(self, [number])._set("opacity", before)
        numbers = set(kept.numbers)
        faint = {number: self._opacity_set(number) for number in range(len(self)) if number not in numbers}
        for number in faint:
            Selection(self, [number])._set("opacity", share * self._look(number)[1])
        self._faint = faint
        return kept

    def explode(self, factor: float) -> None:
        """Have all parts drawn apart, as in an exploded view; 0 puts them back.

        Each node of the tree moves with its parent, and away from the middle of its parent by `factor` times its
        distance from there. So groups move apart, and within them their own parts. Parts around one middle, such as a
        shaft in its bore, stay together. The camera stays where it is. The next frame takes time, since parts that
        share an actor are copied. Part.bounds, to_multiblock() and AssemblyIndex(assembly) are still of the whole.

        Raises:
            TypeError: the factor is no number.
            ValueError: it is out of 0 to 1000.
        """
        value = _number("factor is a number from 0 to 1000", factor)
        if not 0.0 <= value <= 1000.0:
            raise ValueError(f"factor is a number from 0 to 1000, not {factor!r}")
        self.actors.Explode(value)

    def reset(self) -> None:
        """Have all parts drawn with the looks that their file says. explode(0) puts them back."""
        Selection(self, list(self._looks)).reset()

    def add_to(self, target: Any) -> Assembly:
        """Add all parts to a vtkRenderer, to the first renderer of a vtkRenderWindow, or to a pyvista.Plotter's active
        one. It has no effect where they are there already.

        Raises:
            TypeError: the target is something else.
            RuntimeError: the plotter is closed, or the assembly is shown in another window.
        """
        renderer = _renderer_of(target)
        window = renderer.GetRenderWindow()
        shown = self._window() if self._window is not None else None
        if window is not None and shown is not None and shown is not window:
            raise RuntimeError("the assembly is shown in another window, and VTK's actors are for one: load it again")
        if window is not None:
            self._window = weakref.ref(window)
        self.actors.AddTo(renderer)
        return self

    def remove_from(self, target: Any) -> None:
        """Take all parts out of the renderer that add_to() would add them to. Raises as add_to() does."""
        self.actors.RemoveFrom(_renderer_of(target))

    def part_of(self, actor: vtkActor, block: int = 0) -> Part | None:
        """The part that an actor shows by a block, or None if it shows none of this assembly.

        `block` is the flat index of the block, as a vtkHardwareSelector (COMPOSITE_INDEX) or a vtkCellPicker
        (GetFlatBlockIndex()) tells it. It does not count for actors of one part. A vtkCellPicker finds hidden blocks
        too, and a vtkHardwareSelector does not.
        """
        number = self.actors.GetPart(actor, max(operator.index(block), 0))
        return self.parts[number] if number >= 0 else None

    def to_multiblock(self) -> Any:
        """All parts as a pyvista.MultiBlock, with the nesting and the names of the tree, in world coordinates.

        Field data of each block have "color", "opacity" and "material", as they are now. Without PyVista it is a
        vtkMultiBlockDataSet. Other properties of materials, textures and visible are not kept.
        """
        return _blocks.make_blocks(self.tree(), self.actors, self._look)

    def _opacity_set(self, number: int) -> float | None:
        return self._looks.get(number, {}).get("opacity")

    def _look(self, number: int) -> tuple[tuple[float, float, float], float]:
        """The colour and the opacity that a part is drawn with."""
        look = self._looks.get(number, {})
        material = self.actors.GetPartProperty(number)
        shown = [0.0, 0.0, 0.0]
        vtkAssemblyActors.GetShownColor(material, shown)
        return look.get("color", tuple(shown)), look.get("opacity", material.GetOpacity())

    def __repr__(self) -> str:
        count = f"{len(self)} part{'s' if len(self) != 1 else ''}"
        return f"<Assembly of {count}, drawn by {self.actors.GetNumberOfActors()} actors>"


class Selection:
    """Parts of an assembly, whose looks are set together.

    opacity, color and visible are None where nothing was set, or where the parts differ. To set None undoes what was
    set before.
    """

    __slots__ = ("_assembly", "numbers")

    def __init__(self, assembly: Assembly, numbers: Iterable[int]) -> None:
        self._assembly = assembly
        self.numbers = list(numbers)

    @property
    def parts(self) -> list[Part]:
        """The parts, in the order of the tree."""
        return [self._assembly.parts[number] for number in self.numbers]

    def __len__(self) -> int:
        return len(self.numbers)

    def __iter__(self) -> Iterator[Part]:
        return iter(self.parts)

    @property
    def opacity(self) -> float | None:
        """The opacity, in [0, 1], in place of the material's."""
        return self._common("opacity")

    @opacity.setter
    def opacity(self, opacity: float | None) -> None:
        self._set("opacity", None if opacity is None else _opacity(opacity))

    @property
    def color(self) -> tuple[float, float, float] | None:
        """The colour, RGB in [0, 1] of sRGB, in place of the material's. It may be set to a name of CSS or #RRGGBB."""
        return self._common("color")

    @color.setter
    def color(self, color: str | Sequence[float] | None) -> None:
        self._set("color", None if color is None else _rgb(color))

    @property
    def visible(self) -> bool | None:
        """Whether the parts are drawn."""
        return self._common("visible")

    @visible.setter
    def visible(self, visible: bool | None) -> None:
        if visible is not None:
            check_boolean("visible", visible)
        self._set("visible", visible)

    def reset(self) -> None:
        """Have the parts drawn as their file says."""
        for number in self.numbers:
            self._assembly.actors.ResetPart(number)
            self._assembly._looks.pop(number, None)
            self._assembly._faint.pop(number, None)

    def _set(self, name: str, value: Any) -> None:
        actors = self._assembly.actors
        for number in self.numbers:
            look = self._assembly._looks.setdefault(number, {})
            look.pop(name, None)
            if value is None:
                actors.ResetPart(number)
            else:
                look[name] = value
            if name == "opacity":
                self._assembly._faint.pop(number, None)
            for key in look if value is None else (name,):
                _SETTERS[key](actors, number, look[key])

    def _common(self, name: str) -> Any:
        values = {self._assembly._looks.get(number, {}).get(name) for number in self.numbers}
        return values.pop() if len(values) == 1 else None

    def __repr__(self) -> str:
        return f"<Selection of {len(self)} part{'s' if len(self) != 1 else ''}>"


_SETTERS: dict[str, Callable[[vtkAssemblyActors, int, Any], None]] = {
    "opacity": lambda actors, number, opacity: actors.SetPartOpacity(number, opacity),
    "color": lambda actors, number, color: actors.SetPartColor(number, *color),
    "visible": lambda actors, number, visible: actors.SetPartVisibility(number, visible),
}


def _renderer_of(target: Any) -> vtkRenderer:
    """The renderer that parts are added to."""
    first = _renderers_of(target)[0]
    return target.renderer if _plotter_of(target) is not None else first


def _describe(actors: vtkAssemblyActors, number: int) -> Part:
    geometry = actors.GetPartGeometry(number)
    return Part(
        number=number,
        name=actors.GetPartName(number),
        path=actors.GetPartPath(number),
        material=actors.GetPartMaterialName(number),
        triangles=_triangles(geometry.GetPolys()) + _triangles(geometry.GetStrips()),
        bounds=_placed_bounds(actors, number),
    )


def _triangles(cells: Any) -> int:
    """How many triangles polygons or strips come to."""
    return cells.GetNumberOfConnectivityIds() - 2 * cells.GetNumberOfCells()


def _placed_bounds(actors: vtkAssemblyActors, number: int) -> Any:
    """Bounds of a part in world coordinates."""
    bounds = [0.0] * 6
    actors.GetPlacedBounds(actors.GetPartGeometry(number), actors.GetPartPlace(number), bounds)
    return tuple(bounds)


def _number(argument: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{argument}, not {value!r}")
    return float(value)


def _opacity(opacity: Any) -> float:
    value = _number("opacity is a number from 0 to 1", opacity)
    if not 0.0 <= value <= 1.0:
        raise ValueError(f"opacity is a number from 0 to 1, not {opacity!r}")
    return value


def _rgb(color: Any) -> tuple[float, float, float]:
    """The colour of a name of CSS, of #RRGGBB, of RGB, or of a pyvista.Color."""
    wanted = "color is a name such as 'tomato', #RRGGBB or RGB in [0, 1]"
    if isinstance(color, str):
        rgba = vtkNamedColors().HTMLColorToRGBA(color)
        if rgba.GetAlpha() == 0:  # what it returns for other texts
            raise ValueError(f"{wanted}, not {color!r}")
        return (rgba.GetRed() / 255, rgba.GetGreen() / 255, rgba.GetBlue() / 255)
    try:
        values = [_number(wanted, value) for value in getattr(color, "float_rgb", color)]
    except TypeError:
        raise TypeError(f"{wanted}, not {color!r}") from None
    if len(values) != 3 or not all(0.0 <= value <= 1.0 for value in values):
        raise ValueError(f"{wanted}, not {color!r}")
    return (values[0], values[1], values[2])
