"""Levels of detail: levels() has the parts of assemblies drawn no finer than the picture while the camera moves."""

from __future__ import annotations

import dataclasses
import numbers
import weakref
from typing import Any

from vtkmodules.vtkRenderingCore import vtkRenderer

from ._assembly import Assembly
from ._options import check_boolean
from ._target import _plotter_of, _renderers_of, _weak
from .vtkVitrineRendering import vtkPartLevels

_FINEST, _COARSEST = 0.001, 64.0


def levels(target: Any, pixels: float = 0.5, *, exact_while_still: bool = True, cache: bool = True) -> Levels:
    """Draw the parts of assemblies that `target` shows at levels of detail while the camera moves.

    Each part is drawn at the coarsest level with which no point of it is farther from where it should be than `pixels`.
    That is a computed bound of the distance of both surfaces, both ways. Levels are made in the background; until then
    parts are drawn as they are. Parts with textures, lines or vertices always are. So are parts that a section or the
    near plane cuts, those that an x-ray or a plane of a section has been given, and those whose data have changed
    since.

    Args:
        target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter. For a window or a plotter, this applies to all
            renderers that it has now.
        pixels: by how many pixels points may move, from 0.001 to 64.
        exact_while_still: whether parts are shown as they are in the first frame, and in one whose camera is that of
            the frame before.
        cache: whether levels of the same geometry that took a second or more are kept, and used the next time, in
            vitrine/levels of the system's folder for caches.

    Levels that a renderer has already are removed first.

    Returns:
        A handle. wait() waits until levels are made, stats() tells what the last frame drew, and remove() ends it.

    Raises:
        TypeError: an argument is of another kind.
        ValueError: pixels is out of range, or the target shows no assembly.
        RuntimeError: the plotter is closed.

    Examples:

    >>> from vtkmodules.vtkRenderingCore import vtkRenderer
    >>> import vitrine
    >>> renderer = vtkRenderer()
    >>> robot = vitrine.load("Examples/models/robot.glb")
    >>> robot.add_to(renderer)
    >>> with vitrine.levels(renderer, pixels=1) as shown:
    ...     print(shown)
    <Levels of 1 pixel>
    """
    if isinstance(pixels, bool) or not isinstance(pixels, numbers.Real):
        raise TypeError(f"pixels is a number from {_FINEST:g} to {_COARSEST:g}, not {pixels!r}")
    if not _FINEST <= pixels <= _COARSEST:
        raise ValueError(f"pixels is a number from {_FINEST:g} to {_COARSEST:g}, not {pixels!r}")
    check_boolean("exact_while_still", exact_while_still)
    check_boolean("cache", cache)
    shown = []
    for renderer in _renderers_of(target):
        assemblies = [assembly for assembly in Assembly.living() if _shows(renderer, assembly)]
        if assemblies:
            made: Any = vtkPartLevels()
            made.SetPixels(float(pixels))
            made.SetExactWhileStill(exact_while_still)
            made.SetUseCache(cache)
            for assembly in assemblies:
                made.AddAssembly(assembly.actors)
            made.Attach(renderer)
            shown.append(made)
    if not shown:
        raise ValueError("the target shows no assembly: call add_to() of one that load() or from_multiblock() gave")
    return Levels(target, shown)


def _shows(renderer: vtkRenderer, assembly: Assembly) -> bool:
    actors = assembly.actors
    return actors.GetNumberOfActors() > 0 and actors.GetActor(0).IsConsumer(renderer)


@dataclasses.dataclass(frozen=True)
class LevelStats:
    """What the last frames drew of the parts that have levels, in all renderers.

    triangles were drawn of whole_triangles. They are equal where parts were drawn as they are. No point is farther from
    where it should be than distance, in pixels. drew_levels tells whether levels were drawn.
    """

    drew_levels: bool
    triangles: int
    whole_triangles: int
    distance: float


class Levels:
    """The handle that levels() returns. It keeps neither renderers nor windows alive."""

    def __init__(self, target: Any, shown: list[Any]) -> None:
        plotter = _plotter_of(target)
        self._plotter = weakref.ref(plotter) if plotter is not None else lambda: None
        self._shown = shown
        self._renderers: list[Any] = [_weak(each.GetRenderer()) for each in shown]

    @property
    def progress(self) -> float:
        """How much of the levels is made, from 0 to 1."""
        return min((each.GetProgress() for each in self._shown), default=1.0)

    def wait(self) -> None:
        """Wait until all levels are made."""
        for each in self._shown:
            each.WaitUntilMade()

    def stats(self) -> LevelStats:
        """What the last frames drew."""
        return LevelStats(
            any(each.GetDrewLevels() for each in self._shown),
            sum(each.GetNumberOfTriangles() for each in self._shown),
            sum(each.GetNumberOfWholeTriangles() for each in self._shown),
            max((each.GetGreatestDistance() for each in self._shown), default=0.0),
        )

    def _switch(self, on: bool) -> None:
        """Draw parts as they are until they are switched on again. Their levels are kept."""
        for each, renderer in zip(self._shown, self._renderers):
            if not on:
                each.Detach()
            elif renderer.Get() is not None:
                each.Attach(renderer.Get())

    def remove(self) -> None:
        """Draw parts as they are from now on. A plotter on show is drawn at once."""
        for each in self._shown:
            each.Detach()
        self._shown = []
        plotter = self._plotter()
        if plotter is not None and plotter.render_window is not None:
            plotter.render()

    def __enter__(self) -> Levels:
        return self

    def __exit__(self, *_: object) -> None:
        self.remove()

    def __repr__(self) -> str:
        if not self._shown:
            return "<Levels, removed>"
        pixels = self._shown[0].GetPixels()
        return f"<Levels of {pixels:g} pixel{'s' * (pixels != 1)}>"
