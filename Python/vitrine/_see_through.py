"""Transparency for whole windows: see_through() sets a method, and its handle takes it away."""

from __future__ import annotations

import warnings
import weakref
from typing import Any, Callable, Iterable, SupportsIndex

from vtkmodules.vtkCommonCore import vtkWeakReference
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from . import _browser
from ._options import check_boolean, make_pass, method_name
from ._stats import Stats, _combined, _cullers_of, _frames_below
from ._target import _plotter_of, _renderers_now, _renderers_of, _weak
from .vtkVitrineRendering import vtkHierarchicalSBufferCuller, vtkSeeThroughPass


def see_through(
    target: Any,
    method: str | None = None,
    *,
    lights: str | bool | None = None,
    cull: bool = False,
    color_storage: str | None = None,
    memory_limit: SupportsIndex | None = None,
    coincidence: float | tuple[float, float] | None = None,
    part_numbers: bool = False,
    error: float | None = None,
    error_bounds: bool = False,
    frame_ms: float | None = None,
) -> SeeThrough:
    """Draw the translucent props of `target` exactly, from its next frame on; a plotter on show is drawn at once.

    Args:
        target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter. For a window or a plotter, this applies to all
            renderers, including those that are added later.
        method: "prefix-sum-predicted", the default, which needs only one pass over the geometry if the last frame
            predicts enough room; "automatic", the default with an `error`, `error_bounds` or a `frame_ms`, which
            chooses for each frame the cheapest way that keeps the error; "linked-list", which needs only one pass
            whatever the camera does; "prefix-sum", which counts fragments first; "stencil-routed" for drivers without
            OpenGL 4.3; or "truth", the slow reference, composited in float64 on the CPU.
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
        error: for automatic: the greatest error of a channel of the 8-bit picture that is allowed, with channels in
            [0, 1], before effects. The range is 0.6/255 to 1, since rounding to 8 bits alone makes 0.5/255. None
            means 1/255. The lights' cut-off is part of it.
        error_bounds: for automatic: whether frames keep the bound of each pixel for error_bound(), 4 bytes a pixel.
        frame_ms: for automatic: the milliseconds that a frame should take at most, on the CPU or the device. The error
            is then the least with which frames do: 0.6, 1, 2, 4, 8, 16 or 32 of 255, and at most `error`. It changes
            only after some frames. stats() tells it, and whether the time is kept. None means no time.

    Effects of the renderer stay, whether they are passes (EDL, SSAO, SSAA, shadows and the like) or flags (UseFXAA and
    the like), and whether they are switched on before or later. The method replaces the step that draws translucent
    geometry. A pass without such a step is set aside until remove(), with a warning, also where it is set later.

    A target that is see-through already takes the new method until the handle is removed.

    Returns:
        A handle. remove() puts back what was there before, and so does leaving a `with`.

    Raises:
        TypeError: the target or an option is of another kind.
        ValueError: the method or an option is unknown, out of range, or none of the method's.
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
    name = method_name(method, error, error_bounds, frame_ms)

    def make() -> vtkSeeThroughPass:
        return make_pass(
            name, lights, color_storage, memory_limit, coincidence, part_numbers, error, error_bounds, frame_ms
        )

    make()  # wrong options raise before anything is changed
    check_boolean("cull", cull)
    handle = SeeThrough(name, target, make, cull)
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


def _set_cullers(renderer: vtkRenderer, cullers: Iterable[Any]) -> None:
    renderer.GetCullers().RemoveAllItems()
    for culler in cullers:
        renderer.AddCuller(culler)


def _replaced(items: list[Any], old: Any, new: list[Any]) -> list[Any]:
    """The list with the items `new` in the place of `old`, without those of them that it has already."""
    place = items.index(old)
    missing = [item for item in new if item not in items]
    return items[:place] + missing + items[place + 1 :]
