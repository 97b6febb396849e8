"""Transparency for whole windows: see_through() sets a method, its handle takes it away, stats() tells what it drew."""

from __future__ import annotations

import dataclasses
import warnings
import weakref
from typing import Any, Callable, Iterable, Iterator, SupportsIndex

from vtkmodules.vtkCommonCore import vtkObject, vtkWeakReference
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import vtkSequencePass, vtkShadowMapPass

from . import _browser
from ._options import check_boolean, make_pass
from .vtkVitrineRendering import (
    vtkClusteredLightsPass,
    vtkHierarchicalSBufferCuller,
    vtkSeeThroughPass,
    vtkTransparencyPass,
)


def see_through(
    target: Any,
    method: str = "prefix-sum-predicted",
    *,
    lights: str | bool | None = None,
    cull: bool = False,
    color_storage: str | None = None,
    memory_limit: SupportsIndex | None = None,
    coincidence: float | tuple[float, float] | None = None,
    part_numbers: bool = False,
) -> SeeThrough:
    """Draw the translucent props of `target` exactly, from its next frame on; a plotter on show is drawn at once.

    Args:
        target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter. For a window or a plotter, this applies to all
            renderers, including those that are added later.
        method: "prefix-sum-predicted", the default, which needs only one pass over the geometry if the last frame
            predicts enough room; "linked-list", which needs only one whatever the camera does; "prefix-sum", which
            counts fragments first; "stencil-routed" for drivers without OpenGL 4.3; or "truth", the slow reference,
            composited in float64 on the CPU.
        lights: "clustered" or True, or "deferred", for scenes with many lights. With None, VTK's mappers do the
            lighting.
        cull: whether hidden parts are left out (vtkHierarchicalSBufferCuller, which replaces the renderer's cullers).
        color_storage: for linked lists and prefix sums. "half-float" is the default. "compact" takes two thirds of
            the memory, is faster, and exact to 8-bit pictures of one sample a pixel. With several samples a few
            pixels are 2 of 255 off. "8-bit" rounds each fragment.
        memory_limit: for linked lists and prefix sums: the largest number of bytes that fragments may take on the
            device, for each renderer. Frames that need more are drawn in bands, and stay exact. None means no limit.
        coincidence: for linked lists, prefix sums and truth: the tolerance within which fragments coincide, as those
            of mating faces do. They are composited without an order. The unit is 2^-24 of the window's depth range. A
            pair adds a share of the fragment's slope of depth per pixel. A fragment takes 4 bytes more. None means no
            tolerance.
        part_numbers: for linked lists and prefix sums: whether fragments keep the number of their part, 4 bytes each,
            so that layers_at(), layers_in() and pick() are quick.

    Effects of the renderer stay, whether they are passes (EDL, SSAO, SSAA, shadows and the like) or flags (UseFXAA and
    the like), and whether they are switched on before or later. The method replaces the step that draws translucent
    geometry. A pass without such a step is set aside until remove(), with a warning, also where it is set later.

    A target that is see-through already takes the new method until the handle is removed.

    Returns:
        A handle. remove() puts back what was there before, and so does leaving a `with`.

    Raises:
        TypeError: the target is of another kind.
        ValueError: the method or an option is unknown.
        RuntimeError: the plotter is closed.

    Examples:

    >>> from vtkmodules.vtkRenderingCore import vtkRenderer
    >>> import vitrine
    >>> renderer = vtkRenderer()
    >>> with vitrine.see_through(renderer) as handle:
    ...     print(handle, renderer.GetPass().GetClassName())
    <SeeThrough prefix-sum-predicted, 1 renderer> vtkSeeThroughPass
    >>> renderer.GetPass() is None
    True
    """
    renderers = _renderers_of(target)

    def make() -> vtkSeeThroughPass:
        return make_pass(
            method, lights, color_storage, memory_limit, coincidence, part_numbers
        )

    make()  # wrong options raise before anything is changed
    check_boolean("cull", cull)
    handle = SeeThrough(method, target, make, cull)
    for renderer in renderers:
        handle._frames.take(renderer)
    handle._frames.warn(stacklevel=3)
    handle._watch_browsers()
    handle._render()
    return handle


class SeeThrough:
    """The handle that see_through() returns. It keeps neither renderers nor windows alive."""

    def __init__(
        self, method: str, target: Any, make: Callable[[], vtkSeeThroughPass], cull: bool
    ) -> None:
        self.method = method
        plotter = _plotter_of(target)
        self._plotter = weakref.ref(plotter) if plotter is not None else lambda: None
        self._frames = _Frames(make, cull)
        self._frames.watch(target)

    @property
    def renderers(self) -> list[vtkRenderer]:
        """The renderers that still live."""
        return self._frames.renderers()

    def stats(self) -> Stats:
        """What stats() tells of these renderers."""
        return _combined(self.renderers)

    def remove(self) -> None:
        """Put back the passes and cullers that were there before. Renderers that were given others since keep them.

        Handles of one target may be removed in any order. A plotter on show is drawn at once.
        """
        if self._frames.remove():
            if (plotter := self._plotter()) is not None:
                _browser.unwatch(plotter)
            self._render()

    def _watch_browsers(self) -> None:
        """Warn where a browser draws what the plotter shows."""
        plotter = self._plotter()
        if plotter is not None:
            _browser.watch(plotter)

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
        if self._frames.removed:
            return f"<SeeThrough {self.method}, removed>"
        count = len(self.renderers)
        return f"<SeeThrough {self.method}, {count} renderer{'s' if count != 1 else ''}>"


class _Frames:
    """The renderers of a handle. Observers of the window and the renderers hold this; this holds none of them."""

    def __init__(self, make: Callable[[], vtkSeeThroughPass], cull: bool) -> None:
        self.removed = False
        self._make = make
        self._cull = cull
        self._places: list[_Place] = []
        self._all: Callable[[], Iterable[vtkRenderer]] = tuple
        self._window: Any = None
        self._observer = 0
        self._told: set[str] = set()

    def watch(self, target: Any) -> None:
        """Take renderers that are added to a window or a plotter, each before its first frame."""
        plotter = _plotter_of(target)
        window = plotter.render_window if plotter is not None else target
        if not isinstance(window, vtkRenderWindow):
            return
        held = weakref.ref(plotter) if plotter is not None else _weak(window).Get
        self._all = lambda: _renderers_now(held())
        self._window = _weak(window)
        self._observer = window.AddObserver("StartEvent", self._take_new)

    def _take_new(self, *_: object) -> None:
        known = self.renderers()
        for renderer in self._all():
            if renderer not in known:
                self.take(renderer)

    def take(self, renderer: vtkRenderer) -> None:
        """Have a renderer draw by a pass of its own, and cull."""
        ours = self._make()
        ours.Attach(renderer)
        place = _Place(_weak(renderer), _weak(ours))
        if self._cull:
            place.cull(renderer)
        place.observer = renderer.AddObserver("EndEvent", lambda *_: self.warn(stacklevel=3))
        self._places.append(place)

    def renderers(self) -> list[vtkRenderer]:
        return [place.renderer.Get() for place in self._places if place.renderer.Get() is not None]

    def warn(self, stacklevel: int) -> None:
        """Warn of passes that are left out, once for as long as they are. The outermost handle of a renderer warns."""
        reasons: set[str] = set()
        for place in self._places:
            renderer, ours = place.renderer.Get(), place.ours.Get()
            if renderer is not None and ours is vtkSeeThroughPass.GetAttached(renderer):
                reasons.update(frame.GetSetAsideReason() for frame in _frames_below(ours))
        untold = reasons - self._told - {""}
        self._told = reasons
        for reason in sorted(untold):
            warnings.warn(f"see_through(): {reason}, until remove()", stacklevel=stacklevel)

    def remove(self) -> bool:
        """Put everything back. Returns whether there was anything to put back."""
        if self.removed:
            return False
        self.removed = True
        places, self._places = self._places, []
        window = self._window.Get() if self._window is not None else None
        if window is not None:
            window.RemoveObserver(self._observer)
        for place in places:
            place.put_back()
        return True


class _Place:
    """A renderer, what a handle gave it, and the cullers that it had before where they were replaced."""

    _all: weakref.WeakSet[_Place] = weakref.WeakSet()

    def __init__(self, renderer: vtkWeakReference, ours: vtkWeakReference) -> None:
        self.renderer: Any = renderer
        self.ours: Any = ours
        self.observer = 0
        self._culler: Any = None
        self._before: list[Any] = []
        self._all.add(self)

    def cull(self, renderer: vtkRenderer) -> None:
        """Replace the cullers of the renderer."""
        culler = vtkHierarchicalSBufferCuller()
        self._culler = _weak(culler)
        self._before = _cullers_of(renderer)
        _set_cullers(renderer, [culler])

    def put_back(self) -> None:
        renderer, ours = self.renderer.Get(), self.ours.Get()
        if ours is not None:
            ours.Detach()
        if renderer is None:
            return
        renderer.RemoveObserver(self.observer)
        culler = self._culler.Get() if self._culler is not None else None
        if culler is None:
            return
        there = _cullers_of(renderer)
        if culler in there:
            _set_cullers(renderer, _replaced(there, culler, self._before))
        for outer in self._all:
            if culler in outer._before:
                outer._before = _replaced(outer._before, culler, self._before)


def _cullers_of(renderer: vtkRenderer) -> list[Any]:
    collection: Any = renderer.GetCullers()
    return list(collection)


def _set_cullers(renderer: vtkRenderer, cullers: Iterable[Any]) -> None:
    renderer.GetCullers().RemoveAllItems()
    for culler in cullers:
        renderer.AddCuller(culler)


def _replaced(items: list[Any], old: Any, new: list[Any]) -> list[Any]:
    """The list with the items `new` in the place of `old`, without those of them that it has already."""
    place = items.index(old)
    missing = [item for item in new if item not in items]
    return items[:place] + missing + items[place + 1 :]


@dataclasses.dataclass(frozen=True)
class Stats:
    """The last frame of the renderers of a target.

    fragments, bytes, lights and parts are sums over renderers; bytes is what the method holds on the device.
    layers_max is the largest number of fragments in a pixel, layers_mean the mean over pixels that have any.
    geometry_passes is how often the geometry was drawn, the largest of all renderers.

    fallback_reason says why another way replaced the method. lights_reason says why VTK's mappers did the lighting.
    set_aside says which passes of the renderer are left out, and why. Each is empty if there is nothing to say.

    lights counts the lights that were lit by clusters. drawn_parts and culled_parts are of the culler, 0 without one.

    stages has the seconds that the stages of a frame took on the device, by name, summed over renderers. It is empty
    unless the method was told SetMeasureStages(True); vtkSeeThroughPass.GetAttached(renderer).GetTranslucentPass() is
    the method.
    """

    method: str
    fragments: int
    layers_max: int
    layers_mean: float
    geometry_passes: int
    bytes: int
    fallback_reason: str
    lights: int = 0
    lights_reason: str = ""
    drawn_parts: int = 0
    culled_parts: int = 0
    set_aside: str = ""
    stages: dict[str, float] = dataclasses.field(default_factory=dict)


def stats(target: Any) -> Stats:
    """What the last frame of `target` took, summed over its renderers that are see-through: zeros before the first.

    Raises as see_through() does, and ValueError for a target that is not see-through.
    """
    return _combined(_renderers_of(target))


def _combined(renderers: Iterable[vtkRenderer]) -> Stats:
    renderers = list(renderers)
    roots = [root for root in map(_root_of, renderers) if _method_of(root) is not None]
    if not roots:
        passes = {renderer.GetPass().GetClassName() for renderer in renderers if renderer.GetPass()}
        held = f" (the pass that is set is {', '.join(sorted(passes))})" if passes else ""
        raise ValueError(f"nothing here is see-through: call vitrine.see_through() first{held}")
    methods = [_method_of(root) for root in roots]
    frames = [frame for root in roots for frame in _frames_below(root)]
    lights = [light for light in map(_lights_of, roots) if light is not None]
    cullers = [culler for renderer in renderers for culler in _sbuffers_of(renderer)]
    fragments = sum(found.GetNumberOfFragments() for found in methods)
    pixels = sum(
        found.GetNumberOfFragments() / found.GetMeanNumberOfLayers()
        for found in methods
        if found.GetMeanNumberOfLayers() > 0
    )
    return Stats(
        method=", ".join(sorted({found.GetMethodName() for found in methods})),
        fragments=fragments,
        layers_max=max(found.GetMaximumNumberOfLayers() for found in methods),
        layers_mean=fragments / pixels if pixels else 0.0,
        geometry_passes=max(found.GetNumberOfGeometryPasses() for found in methods),
        bytes=sum(found.GetBytes() for found in methods),
        fallback_reason=_reasons(map(_fallback_of, roots)),
        lights=sum(light.GetNumberOfLights() for light in lights),
        lights_reason=_reasons(light.GetFallbackReason() for light in lights),
        drawn_parts=sum(culler.GetNumberOfDrawnParts() for culler in cullers),
        culled_parts=sum(culler.GetNumberOfCulledParts() for culler in cullers),
        set_aside=_reasons(frame.GetSetAsideReason() for frame in frames),
        stages=_stages(methods),
    )


def _stages(methods: Iterable[Any]) -> dict[str, float]:
    seconds: dict[str, float] = {}
    for method in methods:
        for stage in range(method.GetNumberOfStages()):
            name = method.GetStageName(stage)
            seconds[name] = seconds.get(name, 0.0) + method.GetStageTime(stage)
    return seconds


def _reasons(texts: Iterable[str]) -> str:
    return "; ".join(sorted(set(texts) - {""}))


def _root_of(renderer: vtkRenderer) -> Any:
    """The pass that draws the renderer: the one that is set, or else the one that will be set again."""
    set_now = renderer.GetPass()
    attached = vtkSeeThroughPass.GetAttached(renderer)
    return set_now if attached is None or isinstance(set_now, vtkSeeThroughPass) else attached


def _passes_below(render_pass: Any) -> Iterator[Any]:
    """A pass and those that draw for it, without chains that are set aside."""
    if render_pass is None:
        return
    yield render_pass
    delegates: list[Any] = []
    if isinstance(render_pass, vtkSeeThroughPass):
        if not render_pass.GetSetAsideReason():
            delegates.append(render_pass.GetEffectsPass())
    elif isinstance(render_pass, vtkSequencePass):
        passes: Any = render_pass.GetPasses()
        delegates += passes or ()
    elif isinstance(render_pass, vtkShadowMapPass):
        delegates.append(render_pass.GetOpaqueSequence())
    elif hasattr(render_pass, "GetDelegatePass"):
        delegates.append(render_pass.GetDelegatePass())
    for delegate in delegates:
        yield from _passes_below(delegate)


def _frames_below(root: Any) -> list[vtkSeeThroughPass]:
    """The frames that draw, the outermost first. It gives those within it its method, and its lights if it has any."""
    return [found for found in _passes_below(root) if isinstance(found, vtkSeeThroughPass)]


def _method_of(root: Any) -> Any:
    """The method that draws below a pass: the outermost frame's."""
    for frame in _frames_below(root):
        return _own_method_of(frame)
    return None


def _own_method_of(frame: vtkSeeThroughPass) -> Any:
    transparency = frame.GetTranslucentPass()
    return transparency if isinstance(transparency, vtkTransparencyPass) else None


def _lights_of(root: Any) -> Any:
    """The pass that lights what is drawn below a pass: the outermost one of a frame, or else one of the chain."""
    found: list[Any] = [frame.GetLightingPass() for frame in _frames_below(root)]
    found += [each for each in _passes_below(root) if isinstance(each, vtkClusteredLightsPass)]
    return next((lights for lights in found if lights is not None), None)


def _fallback_of(root: Any) -> str:
    """Why the method did not draw below a pass."""
    outermost, *inner = _frames_below(root)
    for frame in inner:
        reason = frame.GetFallbackReason()
        method = _own_method_of(frame)
        # Without a reason of its own, a frame has its method's, which did not draw here.
        if reason and (method is None or reason != method.GetFallbackReason()):
            return reason
    return outermost.GetFallbackReason()


def _sbuffers_of(renderer: vtkRenderer) -> list[Any]:
    cullers = _cullers_of(renderer)
    return [culler for culler in cullers if isinstance(culler, vtkHierarchicalSBufferCuller)]


def _is_plotter(target: Any) -> bool:
    return hasattr(target, "renderers") and hasattr(target, "render_window")


def _plotter_of(target: Any) -> Any:
    return target if not isinstance(target, vtkObject) and _is_plotter(target) else None


def _renderers_now(target: Any) -> list[vtkRenderer]:
    """The renderers that a target has, none if it is closed or gone."""
    if isinstance(target, vtkRenderer):
        return [target]
    if isinstance(target, vtkRenderWindow):
        collection: Any = target.GetRenderers()  # VTK's stubs do not know that it can be iterated
        return list(collection)
    is_open = target is not None and target.render_window is not None
    return list(target.renderers) if is_open else []


def _renderers_of(target: Any) -> list[vtkRenderer]:
    if not isinstance(target, (vtkRenderer, vtkRenderWindow)) and not _is_plotter(target):
        raise TypeError(
            "a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter is needed, "
            f"not {type(target).__name__}"
        )
    renderers = _renderers_now(target)
    if not renderers:
        if _plotter_of(target) is not None and target.render_window is None:
            raise RuntimeError("the plotter is closed")
        raise ValueError("the window has no renderer yet")
    return renderers


def _weak(instance: Any) -> vtkWeakReference:
    reference = vtkWeakReference()
    reference.Set(instance)
    return reference
