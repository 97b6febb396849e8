"""What highlight(), x_ray() and edges() share: how they name parts, their handles, and numbers from 0 to 1."""

from __future__ import annotations

import numbers
import weakref
from typing import Any, Iterable, TypeVar

from vtkmodules.vtkRenderingCore import vtkActor, vtkProp, vtkRenderer

from ._parts import block_count, choose, shown_names
from ._target import _plotter_of

_Handle = TypeVar("_Handle", bound="PartLook")


class PartLook:
    """The handle of a look that some parts have. It keeps neither renderers nor windows alive."""

    def __init__(self, target: Any, shown: list[Any]) -> None:
        plotter = _plotter_of(target)
        self._plotter = weakref.ref(plotter) if plotter is not None else lambda: None
        self._shown = shown
        self._render()

    def remove(self) -> None:
        """Show the parts as they were before. A plotter on show is drawn at once."""
        for each in self._shown:
            each.Detach()
        self._shown = []
        self._render()

    def _render(self) -> None:
        plotter = self._plotter()
        if plotter is not None and plotter.render_window is not None:
            plotter.render()

    def __enter__(self: _Handle) -> _Handle:
        return self

    def __exit__(self, *_: object) -> None:
        self.remove()

    def __repr__(self) -> str:
        name = type(self).__name__
        if not self._shown:
            return f"<{name}, removed>"
        count = sum(each.GetNumberOfParts() for each in self._shown)
        return f"<{name} of {count} part{'s' * (count != 1)}>"


def attached(make: Any, parts: Any, renderers: Iterable[vtkRenderer]) -> list[Any]:
    """Objects of make() for all renderers that show one of the parts. Each has its parts, and is attached.

    Raises:
        TypeError: a part is of another kind.
        KeyError: a pattern chooses no part.
        ValueError: no renderer shows a part.
    """
    all_renderers = list(renderers)
    named = choose("parts", parts, shown_names(all_renderers))
    pairs = [(chosen.prop, chosen.block) for chosen in named]
    for prop, _ in pairs:
        if not make().CanChoose(prop):
            raise TypeError(f"parts are actors, and a {prop.GetClassName()} is none: choose the actors that it shows")
    # Blocks of assemblies are there. To count those of large ones takes as long as to draw them.
    given = [(chosen.prop, chosen.block) for chosen in named if chosen.block > 0 and chosen.part is None]
    counts = {prop: block_count(prop) for prop in {prop for prop, _ in given}}
    for prop, block in given:
        if block >= (count := counts[prop]):
            raise ValueError(f"an actor has no block {block}: its blocks are flat indices from 0 to {count - 1}")
    shown = []
    for renderer in all_renderers:
        has = {prop for prop in {prop for prop, _ in pairs} if renderer.HasViewProp(prop)}
        if has:
            look = make()
            for prop, block in pairs:
                if prop in has:
                    look.AddPart(prop, block)
            look.Attach(renderer)
            shown.append(look)
    if not shown:
        raise ValueError("none of the parts is shown by the target: add their actors to a renderer of it first")
    return shown


def all_parts(renderers: Iterable[vtkRenderer]) -> list[vtkProp]:
    """The actors that renderers have."""
    return [prop for each in renderers for prop in each.GetViewProps() if isinstance(prop, vtkActor)]


def number(argument: str, value: Any, most: float = 1.0) -> float:
    """The value of an argument that is a number from 0 up to `most`."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{argument} is a number from 0 to {most:g}, not {value!r}")
    if not 0.0 <= value <= most:
        raise ValueError(f"{argument} is a number from 0 to {most:g}, not {value!r}")
    return float(value)


def width_in_pixels(argument: str, value: Any) -> int:
    """The value of an argument that is a width from 0 to 8 pixels."""
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise TypeError(f"{argument} is a whole number of pixels, not {value!r}")
    if not 0 <= value <= 8:
        raise ValueError(f"{argument} is from 0 to 8 pixels, not {value!r}")
    return int(value)
