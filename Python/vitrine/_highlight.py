"""Show parts through all that hides them: highlight() draws their outlines over the picture."""

from __future__ import annotations

import numbers
import weakref
from typing import Any, Iterable, Sequence

from vtkmodules.vtkRenderingCore import vtkProp, vtkRenderer

from ._assembly import _rgb
from ._parts import choose, shown_assemblies
from ._see_through import _plotter_of, _renderers_of
from .vtkVitrineRendering import vtkPartOutlines


def highlight(
    target: Any,
    parts: Any,
    *,
    color: str | Sequence[float] = (1.0, 0.5, 0.0),
    width: int = 2,
    opacity: float = 1.0,
    fill: float = 0.25,
) -> Highlight:
    """Draw the outlines of parts over what `target` shows, through all that hides them, from its next frame on.

    Args:
        target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter. For a window or a plotter, this applies to all
            renderers that it has now.
        parts: an actor; a pair of an actor and the flat index of a block; a Part or a Selection of an Assembly; a
            pattern of names; what pick() returns; a Layer; or an iterable of these.
        color: the colour of outlines and of the tint: a name, #RRGGBB, or RGB in [0, 1].
        width: the width of outlines in pixels, from 0 to 8. They are inside of their part.
        opacity: the opacity of outlines, from 0 to 1.
        fill: the opacity of a tint over the parts, from 0 to 1.

    Sections and clipping planes cut outlines as they cut their parts. Hidden parts have none.

    Returns:
        A handle. remove() takes the outlines away, as does leaving a `with`.

    Raises:
        TypeError: an argument is of another kind.
        KeyError: a pattern chooses no part.
        ValueError: a number is out of range, or no part is shown by the target.
        RuntimeError: the plotter is closed.

    Examples:

    >>> from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer
    >>> import vitrine
    >>> renderer, actor = vtkRenderer(), vtkActor()
    >>> renderer.AddActor(actor)
    >>> with vitrine.highlight(renderer, actor, color="tomato") as shown:
    ...     print(shown)
    <Highlight of 1 part>
    """
    if isinstance(width, bool) or not isinstance(width, numbers.Integral):
        raise TypeError(f"width is a whole number of pixels, not {width!r}")
    if not 0 <= width <= 8:
        raise ValueError(f"outlines are from 0 to 8 pixels wide, not {width!r}")
    rgb, line, tint = _rgb(color), share("opacity", opacity), share("fill", fill)
    renderers = _renderers_of(target)
    chosen = shown_pairs(parts, renderers)
    drawn = []
    for renderer, pairs in chosen:
        outlines: Any = vtkPartOutlines()
        outlines.SetColor(*rgb)
        outlines.SetWidth(int(width))
        outlines.SetOpacity(line)
        outlines.SetFillOpacity(tint)
        for prop, block in pairs:
            outlines.AddPart(prop, block)
        outlines.Attach(renderer)
        drawn.append(outlines)
    handle = Highlight(target, drawn)
    handle._render()
    return handle


class Highlight:
    """The handle that highlight() returns. It keeps neither renderers nor windows alive."""

    def __init__(self, target: Any, drawn: list[Any]) -> None:
        plotter = _plotter_of(target)
        self._plotter = weakref.ref(plotter) if plotter is not None else lambda: None
        self._drawn = drawn

    def remove(self) -> None:
        """Take the outlines away. A plotter on show is drawn at once."""
        for outlines in self._drawn:
            outlines.Detach()
        self._drawn = []
        self._render()

    def _render(self) -> None:
        plotter = self._plotter()
        if plotter is not None and plotter.render_window is not None:
            plotter.render()

    def __enter__(self) -> Highlight:
        return self

    def __exit__(self, *_: object) -> None:
        self.remove()

    def __repr__(self) -> str:
        if not self._drawn:
            return "<Highlight, removed>"
        count = sum(outlines.GetNumberOfParts() for outlines in self._drawn)
        return f"<Highlight of {count} part{'s' * (count != 1)}>"


def shown_pairs(
    parts: Any, renderers: Iterable[vtkRenderer]
) -> list[tuple[vtkRenderer, list[tuple[vtkProp, int]]]]:
    """The renderers that show one of the parts, each with the props and blocks that draw its parts there."""
    all_renderers = list(renderers)
    named = choose("parts", parts, shown_assemblies(all_renderers))
    pairs = [(chosen.prop, chosen.block) for chosen in named]
    for prop, _ in pairs:
        if not vtkPartOutlines.CanChoose(prop):
            raise TypeError(f"parts are actors, and a {prop.GetClassName()} is none: choose the actors that it shows")
    shown = []
    for renderer in all_renderers:
        has = {prop for prop in {prop for prop, _ in pairs} if renderer.HasViewProp(prop)}
        if has:
            shown.append((renderer, [(prop, block) for prop, block in pairs if prop in has]))
    if not shown:
        raise ValueError("none of the parts is shown by the target: add their actors to a renderer of it first")
    return shown


def share(argument: str, value: Any) -> float:
    """The value of an argument that is a number from 0 to 1."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{argument} is a number from 0 to 1, not {value!r}")
    if not 0.0 <= value <= 1.0:
        raise ValueError(f"{argument} is a number from 0 to 1, not {value!r}")
    return float(value)
