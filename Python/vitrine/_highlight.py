"""Show parts through all that hides them: highlight() draws their outlines over the picture."""

from __future__ import annotations

from typing import Any, Sequence

from ._assembly import _rgb
from ._looks import PartLook, attached, number, width_in_pixels
from ._target import _renderers_of
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
    rgb, pixels = _rgb(color), width_in_pixels("width", width)
    line, tint = number("opacity", opacity), number("fill", fill)

    def make() -> Any:
        outlines: Any = vtkPartOutlines()
        outlines.SetColor(*rgb)
        outlines.SetWidth(pixels)
        outlines.SetOpacity(line)
        outlines.SetFillOpacity(tint)
        return outlines

    return Highlight(target, attached(make, parts, _renderers_of(target)))


class Highlight(PartLook):
    """The handle that highlight() returns. It keeps neither renderers nor windows alive."""
