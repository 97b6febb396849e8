"""Show parts as an x-ray does: x_ray() makes faces towards the eye nearly vanish, and keeps rims."""

from __future__ import annotations

from typing import Any

from ._looks import PartLook, all_parts, attached, number
from ._target import _renderers_of
from .vtkVitrineRendering import vtkPartXRay


def x_ray(target: Any, parts: Any = None, *, falloff: float = 2.0, floor: float = 0.05) -> XRay:
    """Show parts as an x-ray does, from the next frame of `target` on: faces towards the eye nearly vanish.

    The opacity of a part is multiplied by floor + (1 - floor) * (1 - |n.v|) ** falloff, where n is the normal of a face
    and v the direction to the eye.

    Args:
        target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter. For a window or a plotter, this applies to all
            renderers that it has now.
        parts: an actor; a pair of an actor and the flat index of a block; a Part or a Selection of an Assembly; a
            pattern of names; what pick() returns; a Layer; or an iterable of these. None stands for all actors that
            the target has now.
        falloff: the power of the falloff, from 0 to 16. The larger it is, the narrower are the rims.
        floor: the share of its opacity that a face keeps which is turned towards the eye, from 0 to 1.

    Opaque parts become translucent, so call see_through() before. An x-ray that a renderer has already is removed
    first.

    Returns:
        A handle. remove() puts back the looks of all parts, as does leaving a `with`.

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
    >>> with vitrine.x_ray(renderer, actor, falloff=3) as shown:
    ...     print(shown)
    <XRay of 1 part>
    """
    power, least = number("falloff", falloff, 16.0), number("floor", floor)
    renderers = _renderers_of(target)

    def make() -> Any:
        xray: Any = vtkPartXRay()
        xray.SetFalloff(power)
        xray.SetFloor(least)
        return xray

    return XRay(target, attached(make, all_parts(renderers) if parts is None else parts, renderers))


class XRay(PartLook):
    """The handle that x_ray() returns. It keeps neither renderers nor windows alive."""
