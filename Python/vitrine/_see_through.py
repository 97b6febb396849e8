"""Transparency for whole windows: see_through() sets a method, its handle takes it away, stats() tells what it drew."""

from __future__ import annotations

import dataclasses
from typing import Any, Iterable

from vtkmodules.vtkCommonCore import vtkWeakReference
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from .vtkVitrineRendering import (
    vtkLinkedListTransparencyPass,
    vtkSeeThroughPass,
    vtkTruthTransparencyPass,
)

METHODS = {
    "linked-list": vtkLinkedListTransparencyPass,
    "truth": vtkTruthTransparencyPass,
}
_COLOR_STORAGES = {
    "half-float": vtkLinkedListTransparencyPass.HALF_FLOAT,
    "8-bit": vtkLinkedListTransparencyPass.EIGHT_BIT,
}


def see_through(
    target: Any,
    method: str = "linked-list",
    *,
    color_storage: str | None = None,
    memory_limit: int | None = None,
) -> SeeThrough:
    """Draw the translucent props of `target` exactly, from its next frame on.

    target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter; of the latter two all renderers.
    method: "linked-list", or "truth", the slow yardstick, composited in float64 on the CPU.
    color_storage: of linked-list: "half-float", the default, or "8-bit", which takes less memory and
        rounds each fragment.
    memory_limit: of linked-list: the largest number of bytes that its fragments may take on the device, for
        each renderer. Frames that need more are drawn in bands, and stay exact. None is no limit.

    Returns a handle: remove() puts back the passes that were there before, and so does leaving a `with`.
    A target that is see-through already takes the new method until then.

    Raises TypeError for another kind of target, ValueError for an unknown method or option, RuntimeError
    for a plotter that is closed.

    >>> from vtkmodules.vtkRenderingCore import vtkRenderer
    >>> import vitrine
    >>> renderer = vtkRenderer()
    >>> with vitrine.see_through(renderer) as handle:
    ...     print(handle, renderer.GetPass().GetClassName())
    <SeeThrough linked-list, 1 renderer> vtkSeeThroughPass
    >>> renderer.GetPass() is None
    True
    """
    renderers = _renderers_of(target)
    passes = [_make_pass(method, color_storage, memory_limit) for _ in renderers]
    return SeeThrough(method, renderers, passes)


class SeeThrough:
    """What see_through() has set, to be taken away again. It keeps neither renderers nor windows alive."""

    def __init__(
        self, method: str, renderers: list[vtkRenderer], passes: list[vtkSeeThroughPass]
    ) -> None:
        self.method = method
        self._places = []
        for renderer, see_through_pass in zip(renderers, passes):
            self._places.append((_weak(renderer), _weak(see_through_pass), renderer.GetPass()))
            renderer.SetPass(see_through_pass)

    @property
    def renderers(self) -> list[vtkRenderer]:
        """The renderers that still live."""
        return [place[0].Get() for place in self._places if place[0].Get() is not None]

    def stats(self) -> Stats:
        """What stats() tells of these renderers."""
        return _combined(self.renderers)

    def remove(self) -> None:
        """Put back the passes that were there before. Renderers that were given others since keep them."""
        for renderer, ours, before in self._places:
            if renderer.Get() is not None and renderer.Get().GetPass() is ours.Get():
                renderer.Get().SetPass(before)
        self._places = []

    def __enter__(self) -> SeeThrough:
        return self

    def __exit__(self, *_: object) -> None:
        self.remove()

    def __repr__(self) -> str:
        count = len(self._places)
        if count == 0:
            return f"<SeeThrough {self.method}, removed>"
        return f"<SeeThrough {self.method}, {count} renderer{'s' if count > 1 else ''}>"


@dataclasses.dataclass(frozen=True)
class Stats:
    """The last frame of the renderers of a target.

    fragments, and bytes that the methods hold on the device, are sums; layers_max is the largest number of fragments
    in a pixel, layers_mean the mean over pixels that have any; geometry_passes is how often the geometry was
    drawn, the largest of all renderers. fallback_reason says why VTK's own way was taken, and is empty where it was not.
    """

    method: str
    fragments: int
    layers_max: int
    layers_mean: float
    geometry_passes: int
    bytes: int
    fallback_reason: str


def stats(target: Any) -> Stats:
    """What the last frame of `target`, which is see-through, took: zeros before the first.

    Raises as see_through() does, and ValueError for a target that is not see-through.
    """
    return _combined(_renderers_of(target))


def _combined(renderers: Iterable[vtkRenderer]) -> Stats:
    passes = [_transparency_pass(renderer) for renderer in renderers]
    passes = [found for found in passes if found is not None]
    if not passes:
        raise ValueError("nothing here is see-through: call vitrine.see_through() first")
    fragments = sum(found.GetFragmentCount() for found in passes)
    pixels = sum(
        found.GetFragmentCount() / found.GetLayersMean()
        for found in passes
        if found.GetLayersMean() > 0
    )
    return Stats(
        method=", ".join(sorted({found.GetMethodName() for found in passes})),
        fragments=fragments,
        layers_max=max(found.GetLayersMax() for found in passes),
        layers_mean=fragments / pixels if pixels else 0.0,
        geometry_passes=max(found.GetGeometryPasses() for found in passes),
        bytes=sum(found.GetBytes() for found in passes),
        fallback_reason="; ".join(sorted({found.GetFallbackReason() for found in passes} - {""})),
    )


def _transparency_pass(renderer: vtkRenderer) -> Any:
    if isinstance(renderer.GetPass(), vtkSeeThroughPass):
        return renderer.GetPass().GetTranslucentPass()
    return None


def _renderers_of(target: Any) -> list[vtkRenderer]:
    if isinstance(target, vtkRenderer):
        return [target]
    if isinstance(target, vtkRenderWindow):
        renderers = [renderer for renderer in target.GetRenderers()]
    elif hasattr(target, "renderers") and hasattr(target, "render_window"):
        if target.render_window is None:
            raise RuntimeError("the plotter is closed")
        renderers = list(target.renderers)
    else:
        raise TypeError(
            "a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter is needed, "
            f"not {type(target).__name__}"
        )
    if not renderers:
        raise ValueError("the window has no renderer yet")
    return renderers


def _make_pass(
    method: str, color_storage: str | None, memory_limit: int | None
) -> vtkSeeThroughPass:
    if method not in METHODS:
        raise ValueError(f"unknown method {method!r}: known are {', '.join(METHODS)}")
    transparency = METHODS[method]()
    if color_storage is not None:
        _only_of_linked_list(method, "color_storage")
        if color_storage not in _COLOR_STORAGES:
            raise ValueError(
                f"unknown color_storage {color_storage!r}: known are {', '.join(_COLOR_STORAGES)}"
            )
        transparency.SetColorStorage(_COLOR_STORAGES[color_storage])
    if memory_limit is not None:
        _only_of_linked_list(method, "memory_limit")
        if isinstance(memory_limit, bool) or not isinstance(memory_limit, int):
            raise TypeError(f"memory_limit is a number of bytes, an int, not {memory_limit!r}")
        if not 0 < memory_limit < 2**63:
            raise ValueError(f"memory_limit is a number of bytes above 0, not {memory_limit}")
        transparency.SetMemoryLimit(memory_limit)
    whole = vtkSeeThroughPass()
    whole.SetTranslucentPass(transparency)
    return whole


def _only_of_linked_list(method: str, option: str) -> None:
    if method != "linked-list":
        raise ValueError(f"{option} is an option of linked-list, not of {method}")


def _weak(instance: Any) -> vtkWeakReference:
    reference = vtkWeakReference()
    reference.Set(instance)
    return reference
