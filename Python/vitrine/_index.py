"""AssemblyIndex: measures between the parts of an assembly, and the parts that clash."""

from __future__ import annotations

import dataclasses
import math
import numbers
from typing import Any, Callable, Sequence, SupportsIndex

from vtkmodules.util.vtkConstants import VTK_DOUBLE
from vtkmodules.vtkCommonCore import vtkCommand, vtkIdList
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkRenderingCore import vtkProp

from ._assembly import Assembly
from ._options import check_boolean, finite_numbers, number_of_bytes
from ._parts import WHOLE, Chosen, Scope, choose, flat, named, shown_names
from ._target import _renderers_of
from .vtkVitrineRendering import vtkAssemblyIndex

KINDS: tuple[str, ...] = ("interfering", "touching", "near")


@dataclasses.dataclass(frozen=True, eq=False)
class Crossing:
    """Where a ray passes through the surface of a part.

    distance is that from the ray's origin, and point (x, y, z) a numpy array. cell is the cell of the part's geometry.
    entering is True where the ray goes into a closed part, or through the front of an open one.
    """

    part: Any
    distance: float
    point: Any
    cell: int
    entering: bool


@dataclasses.dataclass(frozen=True, eq=False)
class Wall:
    """A stretch of a ray in a closed part: from start to end, which are distances from the ray's origin.

    thickness is end - start. gap is the length of the stretch before it that is in no closed part, since the origin or
    the last wall. start_point and end_point (x, y, z) are numpy arrays.
    """

    part: Any
    start: float
    end: float
    thickness: float
    gap: float
    start_point: Any
    end_point: Any


@dataclasses.dataclass(frozen=True, eq=False)
class Nearest:
    """The part whose surface is nearest to a point, and its point (x, y, z) that is, a numpy array."""

    part: Any
    distance: float
    point: Any


@dataclasses.dataclass(frozen=True, eq=False)
class Distance:
    """The least distance of two surfaces, and the points (x, y, z) that have it: two numpy arrays."""

    distance: float
    points: tuple[Any, Any]


@dataclasses.dataclass(frozen=True, eq=False)
class Clash:
    """Two parts that clash.

    kind is "interfering", "touching" or "near". depth is 0 unless they interfere. distance is that of the surfaces.
    point (x, y, z) is the deepest point, or the middle of the gap: a numpy array. inside is the part that lies wholly
    in the other one without meeting its surface, or None.
    """

    parts: tuple[Any, Any]
    kind: str
    depth: float
    distance: float
    point: Any
    inside: Any


class AssemblyIndex:
    """Measures between the shapes of parts, without drawing. It needs numpy.

    The parts are those of an Assembly, or what a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter shows by polygons:
    the Part that an assembly's actor shows, other actors, and (actor, block) for each block of composite data, where
    block is its flat index. `parts` has them all. Where a method takes a part, it may be one of these, its number in
    `parts`, or a Selection or a pattern that chooses one part.

    Lengths and points are those of the world. The index keeps copies: make a new one if parts have changed or moved.

    A part is closed if each edge of its triangles has an even number of them. Only closed parts have walls, and an
    inside.

    memory_limit is how many bytes the triangles of parts and their octrees may take, of which each triangle takes about
    75. If all need more, they are in a temporary file, and read again where a query needs them. None means no limit.

    left_out is the number of actors and blocks that are hidden, without points or of other data. Caps of sections are
    no parts, and parts are whole where a section cuts them. index is the vtkAssemblyIndex.

    Raises:
        TypeError: the target is something else.
        ValueError: there are no parts, or the limit is no number of bytes above 0.
        OSError: the temporary file cannot be written, as on a full disk.

    Examples:

    >>> import vitrine
    >>> machine = vitrine.load("machine.glb")  # doctest: +SKIP
    >>> index = vitrine.AssemblyIndex(machine)  # doctest: +SKIP
    >>> for clash in index.clashes():  # doctest: +SKIP
    ...     print(clash.parts[0].name, clash.parts[1].name, clash.depth)
    """

    __slots__ = ("_known", "_names", "index", "left_out", "parts")

    def __init__(self, target: Any, *, memory_limit: SupportsIndex | None = None) -> None:
        self.index = vtkAssemblyIndex()
        if memory_limit is not None:
            self.index.SetMemoryLimit(number_of_bytes(memory_limit))
        self.left_out = 0
        self.parts: tuple[Any, ...]
        if isinstance(target, Assembly):
            self._names = Scope([target])
            self.index.AddAssembly(target.actors)
            self.parts = target.parts
        else:
            renderers = _renderers_of(target)
            self._names = shown_names(renderers)
            for renderer in renderers:
                self.left_out += self.index.AddActors(renderer)
            count = self.index.GetNumberOfParts()
            drawn = ((self.index.GetPartActor(i), self.index.GetPartBlock(i)) for i in range(count))
            self.parts = tuple(named(actor, block) for actor, block in drawn)
        self._known = {_key(part): number for number, part in reversed(list(enumerate(self.parts)))}
        if self.index.GetProblem():
            raise OSError(self.index.GetProblem())
        if not self.parts:
            raise ValueError("there are no parts to measure: nothing is shown by polygons")

    def __len__(self) -> int:
        return len(self.parts)

    def __repr__(self) -> str:
        return f"<AssemblyIndex of {len(self)} part{'s' if len(self) != 1 else ''}>"

    def is_closed(self, part: Any) -> bool:
        """Whether each edge of a part's triangles has an even number of them, so that the part has an inside."""
        return self.index.GetPartIsClosed(self._number(part))

    def ray(
        self, origin: Sequence[float], direction: Sequence[float], length: float = math.inf
    ) -> list[Crossing]:
        """All surfaces that a ray passes through, in order.

        Args:
            origin: where it begins.
            direction: of any length but 0.
            length: how far it goes.
        """
        ray = _ray(origin, direction, length)
        table = vtkTable()
        self.index.CastRay(*ray, table)
        rows = zip(
            *(_column(table, name) for name in ("part", "distance", "position", "cell", "entering"))
        )
        return [
            Crossing(self.parts[part], float(distance), point, int(cell), bool(entering))
            for part, distance, point, cell, entering in rows
        ]

    def thickness(
        self, origin: Sequence[float], direction: Sequence[float], length: float = math.inf
    ) -> list[Wall]:
        """The walls that a ray passes through, by the order of their beginnings, and the gaps before them.

        Only closed parts have walls. The arguments are those of ray().
        """
        import numpy

        ray = _ray(origin, direction, length)
        table = vtkTable()
        self.index.FindWalls(*ray, table)
        begin = numpy.array(ray[0])
        along = numpy.array(ray[1]) / numpy.linalg.norm(ray[1])
        walls = []
        filled = 0.0
        for part, start, end in zip(*(_column(table, name) for name in ("part", "start", "end"))):
            start, end = float(start), float(end)
            points = (begin + start * along, begin + end * along)
            gap = max(start - filled, 0.0)
            walls.append(Wall(self.parts[part], start, end, end - start, gap, *points))
            filled = max(filled, end)
        return walls

    def nearest(self, point: Sequence[float]) -> Nearest:
        """The part whose surface is nearest to a point."""
        import numpy

        where = finite_numbers("point", point, 3)
        found = [0.0, 0.0, 0.0]
        part = self.index.FindNearest(where, found)
        if part < 0:
            raise ValueError("no part has triangles")
        place = numpy.array(found)
        return Nearest(self.parts[part], float(numpy.linalg.norm(place - where)), place)

    def within_box(self, bounds: Sequence[float], *, wholly: bool = False) -> list[Any]:
        """The parts with a point of their surface in a box.

        Args:
            bounds: xmin, xmax, ymin, ymax, zmin, zmax.
            wholly: whether to list only parts that lie in it wholly.
        """
        check_boolean("wholly", wholly)
        box = finite_numbers("bounds", bounds, 6)
        if any(box[i] > box[i + 1] for i in (0, 2, 4)):
            raise ValueError(f"bounds are xmin, xmax, ymin, ymax, zmin, zmax, not {bounds!r}")
        found = vtkIdList()
        self.index.FindPartsInBox(box, wholly, found)
        return self._listed(found)

    def within_sphere(
        self, center: Sequence[float], radius: float, *, wholly: bool = False
    ) -> list[Any]:
        """The parts with a point of their surface in a sphere, or those that lie in it wholly."""
        check_boolean("wholly", wholly)
        found = vtkIdList()
        self.index.FindPartsInSphere(
            finite_numbers("center", center, 3), _length("radius", radius), wholly, found
        )
        return self._listed(found)

    def distance(self, first: Any, second: Any) -> Distance:
        """The least distance of the surfaces of two parts. It is 0 where they meet."""
        import numpy

        numbers_of = self._number(first), self._number(second)
        for number in numbers_of:
            if self.index.GetPartNumberOfTriangles(number) == 0:
                raise ValueError(f"{self.parts[number]!r} has no triangles, so it has no distance")
        places = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
        distance = self.index.GetDistance(*numbers_of, *places)
        return Distance(distance, (numpy.array(places[0]), numpy.array(places[1])))

    def clashes(
        self,
        clearance: float = 0.0,
        tolerance: float | None = None,
        *,
        progress: Callable[[float], Any] | None = None,
    ) -> list[Clash]:
        """The pairs of parts that interfere, touch, or are near each other.

        Parts interfere if they are deeper in one another than the tolerance. They touch if they do not, and are at most
        the tolerance apart. They are near if they do neither, and are at most the clearance apart. The depth is that of
        the deepest one of many points, so parts may be somewhat deeper in one another. For two open parts, it is how
        far their triangles reach through one another.

        Args:
            clearance: the largest distance of pairs that are near.
            tolerance: how exact the triangles are. None stands for a thousandth of the diagonal of the box around all.
            progress: is called with the share that is done, from 0 to 1. If it returns False, the work ends.

        Raises:
            TypeError: an argument is of another kind.
            ValueError: a length is negative or not finite.
            InterruptedError: progress() returned False.
        """
        if progress is not None and not callable(progress):
            raise TypeError(f"progress is called with a share, so it is a function, not {progress!r}")
        limits = (
            _length("clearance", clearance),
            self.index.GetDefaultTolerance() if tolerance is None else _length("tolerance", tolerance),
        )
        table = vtkTable()
        raised: list[BaseException] = []

        def tell(index: Any, _event: str, share: float) -> None:
            try:
                if progress is not None and progress(share) is False:
                    index.SetAbortExecute(1)
            except BaseException as error:  # VTK would print it and go on
                raised.append(error)
                index.SetAbortExecute(1)

        tell.CallDataType = VTK_DOUBLE  # type: ignore[attr-defined]
        observer = self.index.AddObserver(vtkCommand.ProgressEvent, tell)
        is_whole = self.index.FindClashes(*limits, table)
        self.index.RemoveObserver(observer)
        if raised:
            raise raised[0]
        if not is_whole:
            raise InterruptedError("progress() returned False")
        columns = ("first", "second", "kind", "depth", "distance", "position", "inside")
        return [
            Clash(
                (self.parts[first], self.parts[second]),
                KINDS[kind],
                float(depth),
                float(distance),
                point,
                self.parts[inside] if inside >= 0 else None,
            )
            for first, second, kind, depth, distance, point, inside in zip(
                *(_column(table, name) for name in columns)
            )
        ]

    def sees(self, first: Any, second: Any, *, through: Any = ()) -> bool:
        """False only if it is sure that two parts do not see each other: a surface of other parts, without a hole or an
        edge there, lies between their boxes.

        Args:
            through: parts that do not block the view, as if of glass: one, or several by a Selection, a pattern such as
                "housing*", or an iterable.
        """
        glass = vtkIdList()
        for part in self._numbers("through", through):
            glass.InsertNextId(part)
        return self.index.MaySee(self._number(first), self._number(second), glass)

    def _listed(self, found: vtkIdList) -> list[Any]:
        return [self.parts[found.GetId(i)] for i in range(found.GetNumberOfIds())]

    def _number(self, part: Any) -> int:
        """The number of what names one part."""
        found = self._numbers("part", part)
        if len(found) != 1:
            raise ValueError(f"{part!r} chooses {len(found)} parts: name one, or give its number")
        return found[0]

    def _numbers(self, argument: str, parts: Any) -> list[int]:
        """The numbers of what names parts, in which numbers name themselves."""
        found: list[int] = []
        for item in flat(parts):
            if isinstance(item, numbers.Integral) and not isinstance(item, bool):
                if not 0 <= item < len(self):
                    raise IndexError(f"there is no part {item}: there are {len(self)}")
                found.append(int(item))
            else:
                for chosen in choose(argument, item, self._names):
                    found += self._numbers_of(chosen)
        return found

    def _numbers_of(self, chosen: Chosen) -> list[int]:
        number = self._known.get(_key(chosen.named))
        if number is not None:
            return [number]
        drawn = range(len(self)) if chosen.block == WHOLE else ()
        found = [number for number in drawn if self.index.GetPartActor(number) is chosen.prop]
        if not found:
            raise KeyError(f"{chosen.named!r} is no part of this index")
        return found


def _key(part: Any) -> Any:
    """What tells apart the things that are named parts: an actor by itself, and a Part by its identity."""
    if isinstance(part, tuple):
        return (part[0].__this__, part[1])
    return part.__this__ if isinstance(part, vtkProp) else id(part)


def _column(table: vtkTable, name: str) -> Any:
    from vtkmodules.util.numpy_support import vtk_to_numpy

    return vtk_to_numpy(table.GetColumnByName(name)).copy()


def _length(name: str, value: Any, most: float = math.inf) -> float:
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name} is a number of at least 0, not {value!r}")
    if not 0.0 <= float(value) < most:
        raise ValueError(f"{name} is a finite number of at least 0, not {value!r}")
    return float(value)


def _ray(origin: Any, direction: Any, length: Any) -> tuple[list[float], list[float], float]:
    along = finite_numbers("direction", direction, 3)
    if not any(along):
        raise ValueError(f"direction may not be 0, but is {direction!r}")
    if length != math.inf:
        _length("length", length)
    return finite_numbers("origin", origin, 3), along, float(length)
