"""Sections with caps: section() cuts what a target shows by a plane, section_box() by a box. Handles move them."""

from __future__ import annotations

import dataclasses
import math
import numbers
import warnings
import weakref
from typing import Any, Iterable, Mapping, Sequence, TypeVar

from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingCore import vtkActor, vtkProp, vtkRenderer

from ._options import check_boolean, finite_numbers
from ._parts import WHOLE, Chosen, block_count, choose, named, shown_names
from ._reveal import has_cutaway
from ._target import _plotter_of, _renderers_of
from .vtkVitrineRendering import vtkSection

_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
_Handle = TypeVar("_Handle", bound="_Cut")
HATCHES: tuple[str, ...] = ("none", "lines", "pairs", "dashes", "cross", "level", "dots")


def section(
    target: Any,
    normal: str | Sequence[float] = "x",
    origin: Sequence[float] | None = None,
    *,
    parts: Any = None,
    but: Any = None,
    caps: bool | None = None,
    hatch: str | Mapping[Any, str] | None = None,
    edges: int | None = None,
    stripes: bool | None = None,
) -> Section:
    """Cut what `target` shows by a plane, and fill the cuts of closed parts, from its next frame on.

    Args:
        target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter. For a window or a plotter, this applies to all
            renderers that it has now.
        normal: the side that is kept: "x", "y", "z", "-x", "-y", "-z" or a vector.
        origin: a point of the plane, in world coordinates. None stands for the middle of all that is shown.
        parts: the parts that the plane cuts: an actor, a pair of an actor and a block, a Part or a Selection of an
            assembly, a pattern of names such as "gear*", or an iterable of these. None stands for all.
        but: the parts that the plane leaves whole, instead of `parts`.
        caps: whether cuts are filled, as they are at first.
        hatch: the hatch of caps: "none", as at first, "lines" (cast iron), "pairs" (steel), "dashes" (bronze, brass),
            "cross" (plastic), "level" (fluids, glass) or "dots" (insulation). A mapping from parts to hatches gives
            these parts a hatch of their own, such as {"material:steel*": "pairs"}.
        edges: the width of the lines around cuts, in pixels, from 0 to 4. It is 1 at first.
        stripes: whether a warning pattern shows where parts interfere, as it does at first. Without it, such points
            have the cap of one of the parts.

    caps, hatch, edges and stripes are those of all planes of the target. None leaves them as they are; look() of the
    handle changes them later.

    A target may have six planes. It may be see-through or not, before or after this. Caps have their part's colour and
    opacity.

    Returns:
        A handle. move() moves the plane, and remove() takes it away, as does leaving a `with`.

    Raises:
        TypeError: the target or a part is of another kind.
        KeyError: a pattern chooses no part.
        ValueError: the normal is 0 or not finite, the hatch is unknown, there are six planes already, or a part is not
            shown by the target.
        RuntimeError: the plotter is closed.

    Examples:

    >>> from vtkmodules.vtkRenderingCore import vtkRenderer
    >>> import vitrine
    >>> renderer = vtkRenderer()
    >>> with vitrine.section(renderer, "y", (0, 0, 0)) as cut:
    ...     print(cut)
    <Section normal (0, 1, 0), origin (0, 0, 0)>
    """
    renderers = _renderers_of(target)
    plane = vtkPlane()
    plane.SetNormal(_normal_of(normal))
    plane.SetOrigin(_point_of(origin) if origin is not None else _middle_of(renderers))
    look = _look_of(renderers, caps, hatch, edges, stripes)
    if parts is not None and but is not None:
        raise ValueError("give either parts or but")
    chosen = _chosen_of(parts if parts is not None else but, renderers)
    if parts is not None and not chosen:
        raise ValueError("parts is empty, so the plane would cut nothing: leave it out to cut all parts")
    _check_free(renderers)
    if any(found.GetNumberOfPlanes() >= vtkSection.GetMaximumNumberOfPlanes() for found in _attached(renderers)):
        raise ValueError(f"a target has {vtkSection.GetMaximumNumberOfPlanes()} planes at most: remove one")
    sections = [_section_of(renderer) for renderer in renderers]
    for found in sections:
        found.AddPlane(plane)
        if parts is not None or but is not None:
            found.SetParts(plane, vtkSection.ONLY_CHOSEN if parts is not None else vtkSection.ALL_BUT_CHOSEN)
        for each in chosen:
            found.ChoosePart(plane, each.prop, each.block)
        look.apply_to(found)
    handle = Section(target, plane, sections)
    handle._render()
    return handle


def section_box(
    target: Any,
    bounds: Sequence[float],
    *,
    inside: bool = True,
    caps: bool | None = None,
    hatch: str | Mapping[Any, str] | None = None,
    edges: int | None = None,
    stripes: bool | None = None,
) -> SectionBox:
    """Cut what `target` shows by the six faces of a box, and fill the cuts of closed parts, from its next frame on.

    Args:
        target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter. For a window or a plotter, this applies to all
            renderers that it has now.
        bounds: xmin, xmax, ymin, ymax, zmin and zmax of the box, in world coordinates.
        inside: whether the inside of the box is kept. False keeps the outside.
        caps, hatch, edges, stripes: as of section().

    A target may have one box, besides the planes of section(). The box cuts all parts.

    Returns:
        A handle. move() moves the box, and remove() takes it away, as does leaving a `with`.

    Raises:
        TypeError: the target is of another kind.
        ValueError: the bounds are no box, the hatch is unknown, or there is a box already.
        RuntimeError: the plotter is closed.

    Examples:

    >>> from vtkmodules.vtkRenderingCore import vtkRenderer
    >>> import vitrine
    >>> renderer = vtkRenderer()
    >>> with vitrine.section_box(renderer, (0, 1, 0, 1, 0, 2)) as cut:
    ...     print(cut)
    <SectionBox inside (0, 1, 0, 1, 0, 2)>
    """
    renderers = _renderers_of(target)
    box = _box_of(bounds)
    check_boolean("inside", inside)
    look = _look_of(renderers, caps, hatch, edges, stripes)
    _check_free(renderers)
    if any(found.HasBox() for found in _attached(renderers)):
        raise ValueError("a target has one box at most: move or remove it")
    sections = [_section_of(renderer) for renderer in renderers]
    for found in sections:
        look.apply_to(found)
    handle = SectionBox(target, box, inside, sections)
    handle.move()
    return handle


class _Cut:
    """What handles of planes and boxes have in common. They keep neither renderers nor windows alive."""

    def __init__(self, target: Any, sections: Iterable[vtkSection]) -> None:
        plotter = _plotter_of(target)
        self._plotter = weakref.ref(plotter) if plotter is not None else lambda: None
        self._sections = list(sections)

    @property
    def cut_parts(self) -> list[Any]:
        """The parts that the planes of the target cut, by their boxes.

        Each is a Part of an assembly, or else an actor, or a pair of an actor and the flat index of a block.
        """
        return [part for found in self._sections for part in _cut_parts(found)]

    @property
    def open_parts(self) -> list[Any]:
        """Those of cut_parts that are not closed. Their cuts are filled only where that is safe.

        Glyphs, wireframes and points are among them. Their cuts are not filled.
        """
        self._warn()
        return [
            part
            for found in self._sections
            for index, part in enumerate(_cut_parts(found))
            if not found.IsCutPartClosed(index)
        ]

    @property
    def interfering(self) -> list[tuple[Any, Any]]:
        """The pairs of parts that had a point of a plane in common in the last frame, found at the pixels of caps."""
        self._warn()
        pairs = []
        for found in self._sections:
            ids = vtkIdList()
            found.GetInterferingParts(ids)
            named = [_part(found, ids.GetId(i)) for i in range(ids.GetNumberOfIds())]
            pairs += list(zip(named[::2], named[1::2]))
        return pairs

    def look(
        self,
        *,
        caps: bool | None = None,
        hatch: str | Mapping[Any, str] | None = None,
        edges: int | None = None,
        stripes: bool | None = None,
    ) -> None:
        """Change how the caps of all planes of the target look, as section() does. None leaves a value as it is.

        A plotter on show is drawn at once.
        """
        self._check_there()
        look = _look_of([found.GetRenderer() for found in self._sections], caps, hatch, edges, stripes)
        for found in self._sections:
            look.apply_to(found)
        self._render()

    def remove(self) -> None:
        """Take the plane or the box away. A plotter on show is drawn at once."""
        for found in self._sections:
            self._leave(found)
            if found.GetNumberOfPlanes() == 0 and not found.HasBox():
                found.Detach()
        self._sections = []
        self._render()

    def _leave(self, found: vtkSection) -> None:
        raise NotImplementedError

    def _check_there(self) -> None:
        if not self._sections:
            raise RuntimeError("the section was removed, so it cannot change: make a new one")

    def _render(self) -> None:
        plotter = self._plotter()
        if plotter is not None and plotter.render_window is not None:
            plotter.render()
            self._warn()

    def _warn(self) -> None:
        for reason in {found.GetFallbackReason() for found in self._sections} - {""}:
            warnings.warn(f"caps cannot be drawn: {reason}", RuntimeWarning, stacklevel=3)

    def __enter__(self: _Handle) -> _Handle:
        return self

    def __exit__(self, *_: object) -> None:
        self.remove()


class Section(_Cut):
    """The handle that section() returns: a plane. It keeps neither renderers nor windows alive."""

    def __init__(self, target: Any, plane: vtkPlane, sections: Iterable[vtkSection]) -> None:
        super().__init__(target, sections)
        self._plane = plane

    @property
    def normal(self) -> tuple[float, ...]:
        """The normal of the plane. What lies on its side is kept."""
        return tuple(self._plane.GetNormal())

    @property
    def origin(self) -> tuple[float, ...]:
        """A point of the plane, in world coordinates."""
        return tuple(self._plane.GetOrigin())

    def move(self, normal: str | Sequence[float] | None = None, origin: Sequence[float] | None = None) -> None:
        """Give the plane another normal or origin. None leaves it. A plotter on show is drawn at once.

        Raises TypeError and ValueError as section() does, and RuntimeError after remove().
        """
        self._check_there()
        new_normal = _normal_of(normal) if normal is not None else self.normal
        new_origin = _point_of(origin) if origin is not None else self.origin
        self._plane.SetNormal(new_normal)
        self._plane.SetOrigin(new_origin)
        self._render()

    def _leave(self, found: vtkSection) -> None:
        found.RemovePlane(self._plane)

    def __repr__(self) -> str:
        if not self._sections:
            return "<Section, removed>"
        normal, origin = (", ".join(f"{value:g}" for value in vector) for vector in (self.normal, self.origin))
        return f"<Section normal ({normal}), origin ({origin})>"


class SectionBox(_Cut):
    """The handle that section_box() returns: a box. It keeps neither renderers nor windows alive."""

    def __init__(
        self, target: Any, bounds: tuple[float, ...], inside: bool, sections: Iterable[vtkSection]
    ) -> None:
        super().__init__(target, sections)
        self._bounds = bounds
        self._inside = inside

    @property
    def bounds(self) -> tuple[float, ...]:
        """xmin, xmax, ymin, ymax, zmin and zmax of the box, in world coordinates."""
        return self._bounds

    @property
    def inside(self) -> bool:
        """Whether the inside of the box is kept, or its outside."""
        return self._inside

    def move(self, bounds: Sequence[float] | None = None, inside: bool | None = None) -> None:
        """Give the box other bounds, or keep its other side. None leaves it. A plotter on show is drawn at once.

        Raises TypeError and ValueError as section_box() does, and RuntimeError after remove().
        """
        self._check_there()
        box = _box_of(bounds) if bounds is not None else self._bounds
        if inside is not None:
            check_boolean("inside", inside)
            self._inside = inside
        self._bounds = box
        for found in self._sections:
            found.SetBox(*self._bounds, self._inside)
        self._render()

    def _leave(self, found: vtkSection) -> None:
        found.RemoveBox()

    def __repr__(self) -> str:
        if not self._sections:
            return "<SectionBox, removed>"
        side = "inside" if self._inside else "outside"
        return f"<SectionBox {side} ({', '.join(f'{value:g}' for value in self._bounds)})>"


@dataclasses.dataclass(frozen=True)
class _Look:
    """How caps shall look. None leaves a value as it is."""

    caps: bool | None
    hatch: int | None
    hatches: tuple[tuple[Chosen, int], ...]
    edges: int | None
    stripes: bool | None

    def apply_to(self, found: vtkSection) -> None:
        if self.caps is not None:
            found.SetCaps(self.caps)
        if self.hatch is not None:
            found.SetHatch(self.hatch)
        for part, hatch in self.hatches:
            found.SetHatchOf(part.prop, hatch, part.block)
        if self.edges is not None:
            found.SetEdgeWidth(self.edges)
        if self.stripes is not None:
            found.SetInterferenceStripes(self.stripes)


def _look_of(
    renderers: list[vtkRenderer],
    caps: bool | None,
    hatch: str | Mapping[Any, str] | None,
    edges: int | None,
    stripes: bool | None,
) -> _Look:
    """The look that a user gave. Raises as section() does."""
    for name, value in (("caps", caps), ("stripes", stripes)):
        if value is not None:
            check_boolean(name, value)
    if edges is not None and (isinstance(edges, bool) or not isinstance(edges, numbers.Real)):
        raise TypeError(f"edges is the width of lines in whole pixels, from 0 to 4, not {edges!r}")
    if edges is not None and edges not in range(5):
        raise ValueError(f"edges is the width of lines in whole pixels, from 0 to 4, not {edges!r}")
    hatches: list[tuple[Chosen, int]] = []
    if isinstance(hatch, Mapping):
        for parts, of_parts in hatch.items():
            hatches += [(part, _hatch_of(of_parts)) for part in _chosen_of(parts, renderers)]
    general = _hatch_of(hatch) if hatch is not None and not isinstance(hatch, Mapping) else None
    return _Look(caps, general, tuple(hatches), None if edges is None else int(edges), stripes)


def _hatch_of(name: Any) -> int:
    if name not in HATCHES:
        raise ValueError(f"there is no hatch {name!r}: choose {', '.join(HATCHES)}")
    return HATCHES.index(name)


def _attached(renderers: Iterable[vtkRenderer]) -> list[vtkSection]:
    """The sections that renderers have already."""
    found = map(vtkSection.GetAttached, renderers)
    return [each for each in found if each is not None]


def _check_free(renderers: Iterable[vtkRenderer]) -> None:
    if any(map(has_cutaway, renderers)):
        raise ValueError("a reveal cuts parts of the target away: remove it, or call it without cutaway")


def _section_of(renderer: vtkRenderer) -> vtkSection:
    """The section of a renderer, which is made if it has none."""
    found: Any = vtkSection.GetAttached(renderer)
    if found is None:
        found = vtkSection()
        found.Attach(renderer)
    return found


def _part(found: vtkSection, index: int) -> Any:
    """A part as a user knows it: of an assembly, or else an actor, or a pair of an actor and a block."""
    return named(found.GetCutProp(index), found.GetCutBlock(index))


def _cut_parts(found: vtkSection) -> list[Any]:
    return [_part(found, index) for index in range(found.GetNumberOfCutParts())]


def _normal_of(normal: str | Sequence[float]) -> tuple[float, float, float]:
    if isinstance(normal, str):
        axis = _AXES.get(normal.lstrip("+-"))
        if axis is None or len(normal) > 2:
            raise ValueError(f"a normal is x, y, z, -x, -y, -z or a vector, not {normal!r}")
        sign = -1.0 if normal.startswith("-") else 1.0
        return (sign * axis[0] + 0.0, sign * axis[1] + 0.0, sign * axis[2] + 0.0)
    x, y, z = finite_numbers("normal", normal, 3)
    length = math.hypot(x, y, z)
    if length == 0.0:
        raise ValueError("the normal of a plane must not be 0")
    return (x / length, y / length, z / length)


def _point_of(point: Sequence[float]) -> tuple[float, float, float]:
    x, y, z = finite_numbers("origin", point, 3)
    return x, y, z


def _box_of(bounds: Sequence[float]) -> tuple[float, ...]:
    box = finite_numbers("bounds", bounds, 6)
    if any(box[i] >= box[i + 1] for i in (0, 2, 4)):
        raise ValueError(f"a box has xmin < xmax, ymin < ymax, zmin < zmax, not {bounds!r}")
    return tuple(box)


def _middle_of(renderers: Iterable[vtkRenderer]) -> tuple[float, float, float]:
    for renderer in renderers:
        bounds = renderer.ComputeVisiblePropBounds()
        if bounds[0] <= bounds[1]:
            return tuple((bounds[2 * axis] + bounds[2 * axis + 1]) / 2.0 for axis in range(3))  # type: ignore
    return (0.0, 0.0, 0.0)


def _chosen_of(parts: Any, renderers: list[vtkRenderer]) -> list[Chosen]:
    """What a user gave as parts. Each can be cut by a section of the renderers."""
    chosen = choose("parts", parts, shown_names(renderers)) if parts is not None else []
    counts = {each.prop: block_count(each.prop) for each in chosen if isinstance(each.prop, vtkActor)}
    for each in chosen:
        _check_chosen(renderers, each.prop, each.block, counts.get(each.prop, 1))
    return chosen


def _check_chosen(renderers: Iterable[vtkRenderer], prop: vtkProp, block: int, count: int) -> None:
    """Raise an exception that says what to do for a part that the renderers do not draw as one."""
    if not isinstance(prop, vtkActor):
        raise TypeError(f"a section cannot choose a {prop.GetClassName()}: choose actors, or cut all parts")
    if not any(renderer.HasViewProp(prop) for renderer in renderers):
        raise ValueError(
            "a chosen actor is not shown by the target: add it to the renderer first. "
            "An actor within a vtkAssembly cannot be chosen"
        )
    if block != WHOLE and block >= count:
        raise ValueError(f"a chosen actor has no block {block}: its blocks are flat indices from 0 to {count - 1}")
