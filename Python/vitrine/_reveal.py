"""Let a part show behind others: reveal() fades what stands in front of it, and its handle tells by how much."""

from __future__ import annotations

import dataclasses
import numbers
import weakref
from typing import Any, Iterable

from vtkmodules.vtkRenderingCore import vtkProp, vtkRenderer

from ._assembly import Part
from ._options import check_boolean
from ._parts import WHOLE, block_count, choose, named, part_of, shown_names
from ._target import _plotter_of, _renderers_of
from .vtkVitrineRendering import vtkPartOutlines, vtkReveal

_LEAST_SHARE = 0.01
_CUTAWAY = 0.1  # the share of opacity below which cutaway=True cuts


@dataclasses.dataclass(frozen=True)
class Faded:
    """A part in front that reveal() has faded.

    part is the Part of an Assembly, or None where no assembly draws it. actor is the prop that draws it, and block the
    flat index of its block in composite data, 0 for others. opacity is what it has now, 0 if it is hidden, and original
    what it had.
    """

    part: Part | None
    actor: Any
    block: int
    opacity: float
    original: float


def reveal(
    target: Any,
    part: Any,
    share: float = 0.7,
    *,
    follow: bool = False,
    least_opacity: float = 1 / 255,
    outlines: bool = True,
    cutaway: bool | float = False,
    weights: str = "area",
) -> Reveal:
    """Fade what stands in front of a part, as little as it takes for the part to show; a plotter on show is drawn.

    Args:
        target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter that has drawn a frame.
        part: an actor; a pair of an actor and the flat index of a block; a Part or a Selection of an Assembly; a
            pattern of names of parts or of a plotter's actors, such as "gear_17"; or an iterable of these.
        share: the share of the part's light that passes what is in front, in each of its pixels: 0.01 to 1.
        follow: whether opacities follow the camera before each frame. They then change by 0.05 at most for each degree,
            but where the share asks for more. Where parts or the window change, opacities change at once.
        least_opacity: parts in front that would have less are hidden.
        outlines: whether lines show where faded and hidden parts are, except over the part. The handle's `outlines` is
            the vtkPartOutlines that draws them, with their colour, width and opacity.
        cutaway: whether parts that would nearly vanish are cut along the view instead. They get a hole with caps before
            the part, and stay as they are around it. A number is the share of its opacity below which a part is cut;
            True stands for 0.1. It takes the place of sections, so the target must have none.
        weights: "area", so that parts keep opacity by their areas in the picture, or "equal", so that small parts count
            for as much as large ones.

    Opaque parts in front become translucent, so call see_through() before. A reveal that the renderer has already is
    removed first, and put back if this one fails.

    Raises:
        TypeError: an argument is of another kind.
        KeyError: the pattern chooses no part.
        ValueError: a number is out of range, or no pixel of the part is drawn.
        RuntimeError: the plotter is closed, there is no frame yet, or the driver lacks OpenGL 4.3.
    """
    check_boolean("follow", follow)
    check_boolean("outlines", outlines)
    if weights not in ("area", "equal"):
        raise ValueError(f'weights is "area" or "equal", not {weights!r}')
    cut = (_CUTAWAY if cutaway else 0.0) if isinstance(cutaway, bool) else _number("cutaway", cutaway, 0.0)
    share = _number("share", share, _LEAST_SHARE)
    least_opacity = _number("least_opacity", least_opacity, 0.0)
    renderers = _renderers_of(target)
    shown = _shown(part, renderers)
    if not shown:
        raise ValueError("part names no part: an empty Selection or iterable was given")
    renderer = next((found for found in renderers if _has(found, shown)), None)
    if renderer is None:
        raise ValueError("the part is in no renderer of the target: add it first")
    for address in [at for at, handle in _reveals.items() if handle._reveal.GetRenderer() is None]:
        del _reveals[address]
    made = _reveal_of(renderer, shown, share, least_opacity)
    made.SetCutawayOpacity(cut)
    made.SetWeightByArea(weights == "area")
    if outlines:
        made.SetOutlines(_thin_outlines(renderer))
    handle = Reveal(made, follow, _plotter_of(target))
    former = _reveals.get(renderer.__this__)
    if former is not None:
        former._put_back()
    try:
        handle._start()
    except Exception:
        if former is not None:
            former._start()
        raise
    return handle


class Reveal:
    """The handle that reveal() returns. remove() puts back the looks of all parts."""

    def __init__(self, made: vtkReveal, follow: bool, plotter: Any) -> None:
        self._reveal = made
        self._follow = follow
        self._plotter = weakref.ref(plotter) if plotter is not None else lambda: None

    @property
    def outlines(self) -> vtkPartOutlines | None:
        """What draws the outlines, with their colour, width and opacity. None without outlines."""
        return self._reveal.GetOutlines()

    def update(self) -> None:
        """Find the best opacities for the camera as it is now, and set them at once. Raises as reveal() does."""
        if self not in _reveals.values():
            raise RuntimeError("the reveal was removed, or another one took its place: call reveal() again")
        if not self._reveal.Update():
            raise RuntimeError(self._reveal.GetProblem())
        self._draw()

    def remove(self) -> None:
        """Put back the looks of all parts, and stop following the camera."""
        self._put_back()
        self._draw()

    def _start(self) -> None:
        """Fade for the first time. On failure nothing is faded. Raises as reveal() does."""
        if not self._reveal.Update():
            raise RuntimeError(self._reveal.GetProblem())
        if self.pixels == 0:
            self._reveal.PutBack()
            raise ValueError("no pixel of the part is drawn: it is hidden, or outside of the view")
        self._reveal.SetFollowCamera(self._follow)
        _reveals[self._reveal.GetRenderer().__this__] = self
        self._draw()

    def _put_back(self) -> None:
        self._reveal.PutBack()
        for address, handle in list(_reveals.items()):
            if handle is self or handle._reveal.GetRenderer() is None:
                del _reveals[address]

    @property
    def faded(self) -> list[Faded]:
        """The parts that are faded, the hidden ones among them."""
        found = []
        for i in range(self._reveal.GetNumberOfFadedParts()):
            actor, block = self._reveal.GetFadedProp(i), self._reveal.GetFadedBlock(i)
            opacities = self._reveal.GetFadedOpacity(i), self._reveal.GetOriginalOpacity(i)
            found.append(Faded(part_of(actor, block), actor, block, *opacities))
        return found

    @property
    def hidden(self) -> int:
        """How many of the faded parts are hidden."""
        opacities = map(self._reveal.GetFadedOpacity, range(self._reveal.GetNumberOfFadedParts()))
        return sum(opacity == 0.0 for opacity in opacities)

    @property
    def cut(self) -> list[Any]:
        """The parts that are cut away: Parts of an assembly, or else actors, or pairs of an actor and a block."""
        count = self._reveal.GetNumberOfCutParts()
        return [named(self._reveal.GetCutProp(i), self._reveal.GetCutBlock(i)) for i in range(count)]

    @property
    def pixels(self) -> int:
        """The number of pixels of the part."""
        return self._reveal.GetNumberOfPixels()

    @property
    def layers(self) -> int:
        """The largest number of layers in front of a pixel."""
        return self._reveal.GetNumberOfLayersInFront()

    @property
    def share(self) -> float:
        """The least share of the part's light that passes what is in front, over all of its pixels."""
        return self._reveal.GetLeastShare()

    @property
    def context(self) -> float:
        """The mean opacity of the parts in front, weighted by their areas on the screen."""
        return self._reveal.GetContext()

    @property
    def proved(self) -> float:
        """The share of the best context that the opacities are proved to reach, before faint parts were hidden."""
        return self._reveal.GetProvedShare()

    def _draw(self) -> None:
        plotter = self._plotter()
        if plotter is not None and plotter.render_window is not None:
            plotter.render()

    def __repr__(self) -> str:
        return f"<Reveal of {self.pixels} pixels: share {self.share:.3f}, {len(self.faded)} parts faded>"


def _reveal_of(
    renderer: vtkRenderer, shown: Iterable[tuple[vtkProp, int]], share: float, least_opacity: float
) -> vtkReveal:
    made = vtkReveal()
    made.SetRenderer(renderer)
    for prop, block in shown:
        made.AddPart(prop, block)
    made.SetShare(share)
    made.SetLeastOpacity(least_opacity)
    return made


def _thin_outlines(renderer: vtkRenderer) -> vtkPartOutlines:
    """Outlines that are seen on the renderer's background without being loud."""
    outlines = vtkPartOutlines()
    is_dark = sum(renderer.GetBackground()) < 1.5
    outlines.SetColor(*[1.0 if is_dark else 0.0] * 3)
    outlines.SetOpacity(0.6)
    outlines.SetWidth(1)
    return outlines


# The reveal of each renderer, by its address. A handle keeps no renderer alive.
_reveals: dict[str, Reveal] = {}


def _number(argument: str, value: Any, least: float) -> float:
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{argument} is a number from {least:g} to 1, not {value!r}")
    if not least <= value <= 1.0:
        raise ValueError(f"{argument} is a number from {least:g} to 1, not {value!r}")
    return float(value)


def _shown(part: Any, renderers: list[vtkRenderer]) -> list[tuple[vtkProp, int]]:
    """The props that draw what reveal() takes as a part, and their blocks."""
    shown = []
    for chosen in choose("part", part, shown_names(renderers)):
        blocks = range(block_count(chosen.prop)) if chosen.block == WHOLE else (chosen.block,)
        shown += [(chosen.prop, block) for block in blocks]
    return shown


def has_cutaway(renderer: vtkRenderer) -> bool:
    """Whether a reveal of the renderer cuts parts away, or may do so."""
    handle = _reveals.get(renderer.__this__)
    return handle is not None and handle._reveal.GetCutawayOpacity() > 0.0


def _has(renderer: vtkRenderer, shown: list[tuple[vtkProp, int]]) -> bool:
    return any(renderer.HasViewProp(prop) for prop, _ in shown)


def update_reveal(renderer: vtkRenderer) -> None:
    """Have the reveal of a renderer fade parts anew, whose looks something else has changed. It may have none."""
    handle = _reveals.get(renderer.__this__)
    if handle is not None:
        handle.update()
