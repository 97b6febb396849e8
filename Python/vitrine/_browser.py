"""Views that a browser draws by itself: a warning for plotters that are see-through, where Vitrine takes no part.

PyVista's views for notebooks (of trame-pyvista) tell nobody that they are made. But each adds a callback to its plotter
at once, by add_on_render_callback(). So that method is replaced on the plotters that are see-through, and on no others.
"""

from __future__ import annotations

import inspect
import sys
import warnings
import weakref
from typing import Any

_EXACT = "plotter.show(jupyter_backend='server') and 'static' show the exact picture"
_BROWSER = f"see_through(): the browser draws this view by itself, and Vitrine takes no part there: {_EXACT}"
_EITHER = (
    "see_through(): Vitrine takes no part while the browser draws this view: leave its switch on server rendering. "
    + _EXACT
)
_WARNINGS = {"PyVistaLocalView": _BROWSER, "PyVistaWasmView": _BROWSER, "PyVistaRemoteLocalView": _EITHER}
_METHOD = "add_on_render_callback"
_LIBRARIES = {"pyvista", "trame_pyvista", __package__}

_watches: weakref.WeakKeyDictionary[Any, _Watch] = weakref.WeakKeyDictionary()


def watch(plotter: Any) -> None:
    """Warn once of each kind of view of a plotter that a browser draws. Each call needs one of unwatch()."""
    if hasattr(plotter, _METHOD):
        found = _watches.setdefault(plotter, _Watch(plotter))
        found.count += 1
        found.look()


def unwatch(plotter: Any) -> None:
    """Warn of views no more, once all that called watch() have called this."""
    found = _watches.get(plotter)
    if found is not None:
        found.count -= 1
        if found.count == 0:
            del _watches[plotter]
            vars(plotter).pop(_METHOD, None)


class _Watch:
    """What watch() keeps of a plotter, without keeping it alive."""

    def __init__(self, plotter: Any) -> None:
        self.count = 0
        self._told: set[str] = set()
        self._plotter = weakref.ref(plotter)

    def look(self) -> None:
        """Warn of the views that there are, and look at those that come."""
        plotter = self._plotter()
        for callback in list(getattr(plotter, "_on_render_callbacks", ())):
            self._warn(callback)
        vars(plotter)[_METHOD] = self._add_callback

    def _add_callback(self, callback: Any, *arguments: Any, **options: Any) -> None:
        plotter = self._plotter()
        getattr(type(plotter), _METHOD)(plotter, callback, *arguments, **options)
        self._warn(callback)

    def _warn(self, callback: Any) -> None:
        for kind in type(_view_of(callback)).__mro__:
            text = _WARNINGS.get(kind.__name__)
            if text is not None and text not in self._told:
                self._told.add(text)
                warnings.warn(text, stacklevel=_level_of_caller())


def _view_of(callback: Any) -> Any:
    """The object that a method or a function within one of its methods belongs to."""
    if inspect.isfunction(callback):
        return inspect.getclosurevars(callback).nonlocals.get("self")
    return getattr(callback, "__self__", None)


def _level_of_caller() -> int:
    """How far above the function that called this the code stands that called PyVista or Vitrine."""
    level, frame = 1, sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] in _LIBRARIES:
        level, frame = level + 1, frame.f_back
    return level
