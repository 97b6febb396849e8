"""Transparency for whole windows: see_through() sets a method, its handle takes it away, stats() tells what it drew."""

from __future__ import annotations

import dataclasses
import math
import numbers
import operator
import warnings
import weakref
from typing import Any, Iterable, Mapping, SupportsIndex

from vtkmodules.vtkCommonCore import vtkObject, vtkWeakReference
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from .vtkVitrineRendering import (
    vtkABufferTransparencyPass,
    vtkLinkedListTransparencyPass,
    vtkPrefixSumTransparencyPass,
    vtkSeeThroughPass,
    vtkStencilRoutedTransparencyPass,
    vtkTolerantTransparencyPass,
    vtkTransparencyPass,
    vtkTruthTransparencyPass,
)

METHODS: dict[str, Any] = {
    "linked-list": vtkLinkedListTransparencyPass,
    "prefix-sum": vtkPrefixSumTransparencyPass,
    "stencil-routed": vtkStencilRoutedTransparencyPass,
    "truth": vtkTruthTransparencyPass,
}
_COLOR_STORAGES = {
    "half-float": vtkABufferTransparencyPass.HALF_FLOAT,
    "8-bit": vtkABufferTransparencyPass.EIGHT_BIT,
    "compact": vtkABufferTransparencyPass.COMPACT,
}


def see_through(
    target: Any,
    method: str = "linked-list",
    *,
    color_storage: str | None = None,
    memory_limit: SupportsIndex | None = None,
    coincidence: float | tuple[float, float] | None = None,
) -> SeeThrough:
    """Draw the translucent props of `target` exactly, from its next frame on; a plotter on show is drawn at once.

    target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter; of the latter two all renderers that they have now.
    method: "linked-list", "prefix-sum", "stencil-routed" for drivers without OpenGL 4.3, or "truth", the slow
        yardstick, composited in float64 on the CPU.
    color_storage: of the first two methods: "half-float", the default; "compact", which takes two thirds of the memory and
        is faster, and exact to 8-bit pictures; or "8-bit", which rounds each fragment.
    memory_limit: of the first two methods: the largest number of bytes that its fragments may take on the device, for
        each renderer. Frames that need more are drawn in bands, and stay exact. None is no limit.
    coincidence: of the first two methods and truth: the tolerance within which fragments coincide, as those of mating faces
        do, and are composited without an order, in steps of 2^-24 of the window's depth; or a pair of that and a share of the
        fragment's slope of depth per pixel. It takes 4 bytes more a fragment. None is no tolerance.

    Returns a handle: remove() puts back the passes that were there before, and so does leaving a `with`.
    A target that is see-through already takes the new method until then.

    Warns where another pass is set aside (PyVista's SSAO, shadows, depth of field, SSAA and the like are passes): the
    effect is gone until remove(). Switching one on or off later takes Vitrine's pass away: call see_through() again.

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
    passes = [_make_pass(method, color_storage, memory_limit, coincidence) for _ in renderers]
    for name in sorted({_foreign_pass(renderer) for renderer in renderers} - {""}):
        warnings.warn(f"see_through() sets {name} aside until remove()", stacklevel=2)
    return SeeThrough(method, renderers, passes, _plotter_of(target))


class SeeThrough:
    """The handle that see_through() returns. It keeps neither renderers nor windows alive."""

    _alive: weakref.WeakSet[SeeThrough] = weakref.WeakSet()

    def __init__(
        self,
        method: str,
        renderers: list[vtkRenderer],
        passes: list[vtkSeeThroughPass],
        plotter: Any = None,
    ) -> None:
        self.method = method
        self._plotter = weakref.ref(plotter) if plotter is not None else lambda: None
        self._places: list[_Place] = []
        for renderer, see_through_pass in zip(renderers, passes):
            place = _Place(_weak(renderer), _weak(see_through_pass), renderer.GetPass())
            self._places.append(place)
            renderer.SetPass(see_through_pass)
        SeeThrough._alive.add(self)
        self._render()

    @property
    def renderers(self) -> list[vtkRenderer]:
        """The renderers that still live."""
        return [place.renderer.Get() for place in self._places if place.renderer.Get() is not None]

    def stats(self) -> Stats:
        """What stats() tells of these renderers."""
        return _combined(self.renderers)

    def remove(self) -> None:
        """Put back the passes that were there before. Renderers that were given others since keep them.

        Handles of one target may be removed in any order. A plotter on show is drawn at once.
        """
        places, self._places = self._places, []
        for place in places:
            renderer, ours = place.renderer.Get(), place.ours.Get()
            if renderer is None or ours is None:
                continue
            if renderer.GetPass() is ours:
                renderer.SetPass(place.before)
            for later in SeeThrough._alive:
                later._forget(ours, place.before)
        if places:
            self._render()

    def _forget(self, removed: vtkSeeThroughPass, before: Any) -> None:
        for place in self._places:
            if place.before is removed:
                place.before = before

    def _render(self) -> None:
        """Draw the plotter, which does nothing before it is shown, and must not once it is closed."""
        plotter = self._plotter()
        if plotter is not None and plotter.render_window is not None:
            plotter.render()

    def __enter__(self) -> SeeThrough:
        return self

    def __exit__(self, *_: object) -> None:
        self.remove()

    def __repr__(self) -> str:
        if not self._places:
            return f"<SeeThrough {self.method}, removed>"
        count = len(self.renderers)
        return f"<SeeThrough {self.method}, {count} renderer{'s' if count != 1 else ''}>"


@dataclasses.dataclass
class _Place:
    """A renderer, the pass that a handle gave it, and the one it had before."""

    renderer: Any
    ours: Any
    before: Any


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
    """What the last frame of `target` took, summed over its renderers that are see-through: zeros before the first.

    Raises as see_through() does, and ValueError for a target that is not see-through.
    """
    return _combined(_renderers_of(target))


def _combined(renderers: Iterable[vtkRenderer]) -> Stats:
    renderers = list(renderers)
    passes = [found for found in map(_transparency_pass, renderers) if found is not None]
    if not passes:
        others = ", ".join(sorted({_foreign_pass(renderer) for renderer in renderers} - {""}))
        held = f" (the pass that is set is {others})" if others else ""
        raise ValueError(f"nothing here is see-through: call vitrine.see_through() first{held}")
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
    whole = renderer.GetPass()
    if isinstance(whole, vtkSeeThroughPass):
        transparency = whole.GetTranslucentPass()
        return transparency if isinstance(transparency, vtkTransparencyPass) else None
    return None


def _foreign_pass(renderer: vtkRenderer) -> str:
    """The class of a pass that is not Vitrine's, or ""."""
    there = renderer.GetPass()
    return "" if there is None or isinstance(there, vtkSeeThroughPass) else there.GetClassName()


def _is_plotter(target: Any) -> bool:
    return hasattr(target, "renderers") and hasattr(target, "render_window")


def _plotter_of(target: Any) -> Any:
    return target if not isinstance(target, vtkObject) and _is_plotter(target) else None


def _renderers_of(target: Any) -> list[vtkRenderer]:
    if isinstance(target, vtkRenderer):
        return [target]
    if isinstance(target, vtkRenderWindow):
        collection: Any = target.GetRenderers()  # VTK's stubs do not know that it can be iterated
        renderers = list(collection)
    elif _is_plotter(target):
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
    method: str,
    color_storage: str | None,
    memory_limit: SupportsIndex | None,
    coincidence: float | tuple[float, float] | None,
) -> vtkSeeThroughPass:
    transparency = _known("method", method, METHODS)()
    if color_storage is not None:
        _only_of(vtkABufferTransparencyPass, method, "color_storage")
        transparency.SetColorStorage(_known("color_storage", color_storage, _COLOR_STORAGES))
    if memory_limit is not None:
        _only_of(vtkABufferTransparencyPass, method, "memory_limit")
        transparency.SetMemoryLimit(_number_of_bytes(memory_limit))
    if coincidence is not None:
        _only_of(vtkTolerantTransparencyPass, method, "coincidence")
        steps, slope = _steps_and_slope(coincidence)
        transparency.SetCoincidenceSteps(steps)
        transparency.SetCoincidenceSlope(slope)
    whole = vtkSeeThroughPass()
    whole.SetTranslucentPass(transparency)
    return whole


def _known(argument: str, value: Any, values: Mapping[str, Any]) -> Any:
    if not isinstance(value, str) or value not in values:
        raise ValueError(f"unknown {argument} {value!r}: known are {', '.join(values)}")
    return values[value]


def _number_of_bytes(limit: SupportsIndex) -> int:
    try:
        number = operator.index(limit)
    except TypeError:
        number = None
    if number is None or isinstance(limit, bool):
        raise TypeError(f"memory_limit is a number of bytes, an int, not {limit!r}")
    if not 0 < number < 2**63:
        raise ValueError(f"memory_limit is a number of bytes above 0 and below 2**63, not {number}")
    return number


def _steps_and_slope(coincidence: Any) -> tuple[float, float]:
    pair = coincidence if isinstance(coincidence, (tuple, list)) else (coincidence, 0.0)
    if len(pair) != 2 or not all(
        isinstance(value, numbers.Real) and not isinstance(value, bool) for value in pair
    ):
        raise TypeError(f"coincidence is a number or a pair of numbers, not {coincidence!r}")
    if not all(math.isfinite(value) and value >= 0 for value in pair):
        raise ValueError(f"coincidence is finite and at least 0, not {coincidence!r}")
    return float(pair[0]), float(pair[1])


def _only_of(kind: type, method: str, option: str) -> None:
    if not issubclass(METHODS[method], kind):
        raise ValueError(f"{option} is no option of {method}")


def _weak(instance: Any) -> vtkWeakReference:
    reference = vtkWeakReference()
    reference.Set(instance)
    return reference
