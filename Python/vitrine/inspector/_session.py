"""What a page shows: the Inspection behind it, its tree, its changes, and its pictures. All of it is in one thread."""

from __future__ import annotations

import collections
import pathlib
from typing import Any

from .._options import METHODS
from . import _gestures, _requests, _state, _views
from ._inspection import Inspection
from ._pictures import Pictures
from ._render import opened

_KEPT = 64  # revisions of looks, so that pages get only what has changed
_MOST_TOLD = 300  # rows of a list in a page
_NOT_OF_PICTURE = ("files", "selected", "highlight", "views")  # of the state: layers and figures stay
_LEAST_SIDE, _MOST_SIDE = 16, 4096  # pixels of a picture in a page


class Session:
    """An Inspection, its pictures, and revisions: a number for each state that was shown."""

    def __init__(self, target: Any, size: Any, tolerance: float) -> None:
        """Open a target, as inspect() takes it. It takes seconds."""
        self.inspection = _opened(target, size, tolerance)
        self._size_before = tuple(self.inspection.state_now["size"])
        self._size: list[int] | None = None  # of the page's view
        self._fits = _state_file(target) is None and not hasattr(target, "render_window")
        self.pictures = Pictures(self.inspection)
        self.revision = 1
        self.picture = 1  # a number for each picture, of which outlines are no part
        self._state = self.inspection.state_now
        self._looks: collections.OrderedDict[int, dict[str, Any]] = collections.OrderedDict()
        self._keep_looks()
        self._numbers = {path: number for number, path in enumerate(self.inspection.parts.paths)}

    def warm_up(self) -> None:
        """Do what the first picture and the first change need, while the browser loads the page."""
        self.inspection.draw()
        _state.check({"vitrine": _state.FORMAT})

    def _keep_looks(self) -> None:
        self._looks[self.revision] = self.inspection.state_now["parts"]
        while len(self._looks) > _KEPT:
            self._looks.popitem(last=False)

    def note_change(self) -> None:
        """Count a new revision if the state is another one. Pictures keep the page's size."""
        if self._size is not None and self._size != self.inspection.state_now["size"]:
            self.inspection.set_size(*self._size)
        if self._state is self.inspection.state_now:
            return
        before, self._state = self._state, self.inspection.state_now
        self.revision += 1
        if any(before.get(key) != value for key, value in self._state.items() if key not in _NOT_OF_PICTURE):
            self.picture += 1
        self._keep_looks()

    # Pictures

    def moving(self) -> dict[str, Any]:
        return {**self.pictures.moving(), "revision": self.revision}

    def still(self) -> dict[str, Any]:
        return {**self.pictures.still(), "revision": self.revision}

    def move(self, kind: Any = None, across: Any = 0, down: Any = 0, stroke: Any = 0, plane: Any = 0) -> dict[str, Any]:
        """Move by the mouse, and draw at once. Raises Refused."""
        self._refusing_move(kind, across, down, stroke, plane)
        self.note_change()
        return self.moving()

    def _refusing_move(self, *values: Any) -> None:
        try:
            _gestures.move(self.inspection, *values)
        except (ValueError, TypeError) as error:
            raise _requests.Refused(str(error)) from None

    def resize(self, width: Any, height: Any) -> None:
        """Have pictures of the size of the page's view. The first view is fitted to it. Raises Refused."""
        is_first = self._size is None
        sides = [_requests.pixels(side) for side in (width, height)]
        shrink = min(1.0, _MOST_SIDE / max(sides))  # of both, so that nothing is stretched
        self._size = [max(_LEAST_SIDE, round(shrink * side)) for side in sides]
        self.note_change()
        if is_first and self._fits:
            renderer = self.inspection.renderer
            self.inspection.look_from(_views.fitted(renderer, _views.shown_bounds(renderer)))
            self.note_change()

    def click(self, x: Any, y: Any, deeper: Any = False, add: Any = False) -> dict[str, Any]:
        """Select what a pixel shows, or the next part behind what is selected. Returns the layers there."""
        self.note_change()
        self.pictures.settle()
        inspection = self.inspection
        place = _requests.pixel(inspection, x, y)
        layers = inspection.layers(*place)
        path = inspection.pick(*place)
        if deeper is True:
            path = _next_deeper(layers, inspection.state_now["selected"]) or path
        if path is not None:
            inspection.select([path], add=add is True)
        elif add is not True:
            inspection.select(None)
        shown = layers[:_MOST_TOLD]
        return {"x": x, "y": y, "picture": self.picture, "path": path, "count": len(layers), "layers": shown}

    # What the page says

    def told(self) -> dict[str, Any]:
        """What panels show of the state: all of it but what belongs to single parts."""
        state = self._state
        shown = {key: value for key, value in state.items() if key not in ("parts", "selected", "highlight", "files")}
        return {
            "ins": shown,
            "revision": self.revision,
            "picture": self.picture,
            "can_undo": self.inspection.can_undo,
            "can_redo": self.inspection.can_redo,
            "selection": self._selection(state),
            "cut": self._cut(state),
        }

    def told_once(self) -> dict[str, Any]:
        """What panels show that does not change."""
        return {
            "title": self.title(),
            "methods": list(METHODS),
            "bounds": list(_views.shown_bounds(self.inspection.renderer)),
        }

    def _selection(self, state: dict[str, Any]) -> dict[str, Any]:
        selected = state["selected"]
        if not selected:
            return {"count": 0, "name": "", "path": "", "pair": [], "opacity": 1.0, "color": "#808080"}
        path = selected[-1]
        look = {**self.inspection.parts.look_of_file(path), **state["parts"].get(path, {})}
        name = path.rsplit("/", 1)[-1]
        return {
            "count": len(selected),
            "name": name,
            "path": path,
            "pair": selected[:2],
            "opacity": look["opacity"],
            "color": look["color"],
        }

    def _cut(self, state: dict[str, Any]) -> dict[str, Any]:
        if not state["sections"] and state["box"] is None:
            return {"count": 0, "paths": []}
        paths = self.inspection.cut_parts()
        return {"count": len(paths), "paths": paths[:_MOST_TOLD]}

    def tree(self, known: Any = None) -> dict[str, Any]:
        """The tree, and what looks otherwise than at a revision that the page knows. Without one, all of it."""
        before = self._looks.get(known) if isinstance(known, int) else None
        state = self._state  # of the revision, while the inspection may be further on
        numbers = self._numbers
        told: dict[str, Any] = {
            "revision": self.revision,
            "looks": [[numbers[path], look] for path, look in _changed(before or {}, state["parts"])],
            "selected": [numbers[path] for path in state["selected"]],
        }
        return {**told, **nodes_of(self.inspection.parts.paths)} if before is None else told

    def find(self, pattern: Any) -> list[int]:
        """The numbers of the parts that a pattern of names chooses. It may choose none, as while it is typed."""
        try:
            return [self._numbers[path] for path in self.inspection.parts.find(pattern)]
        except KeyError:
            return []

    def title(self) -> str:
        """The name of what is shown."""
        files = self.inspection.state_now["files"]
        names = [pathlib.PurePath(entry["path"]).name for entry in files]
        return names[0] + (f" and {len(names) - 1} more" if len(names) > 1 else "") if names else "Assembly"

    def close(self) -> None:
        """Let the window go, or give a plotter back as it was."""
        self.inspection.window.SetSize(*self._size_before)
        self.inspection.close()


def _opened(target: Any, size: Any, tolerance: float) -> Inspection:
    """An inspection of a target, which may be the file of a state."""
    state = _state_file(target)
    return opened(state) if state is not None else Inspection(target, size=size, tolerance=tolerance)


def _state_file(target: Any) -> str | None:
    """The path of a target that is the file of a state. Raises ValueError for one among other files."""
    files = [target] if isinstance(target, (str, pathlib.Path)) else target
    if not isinstance(files, (list, tuple)):
        return None
    states = [str(file) for file in files if str(file).lower().endswith(".json")]
    if states and len(files) > 1:
        raise ValueError(f"{states[0]}: a state names its files, so it is opened alone: vitrine inspect {states[0]}")
    return states[0] if states else None


def _next_deeper(layers: list[dict[str, Any]], selected: list[str]) -> str | None:
    """The part behind the one that is selected, among those of a pixel, and after the last one the first again."""
    order = list(dict.fromkeys(layer["path"] for layer in layers if layer["path"] is not None))
    if not order:
        return None
    at = next((i for i, path in enumerate(order) if selected and path == selected[-1]), -1)
    return order[(at + 1) % len(order)]


def _changed(before: dict[str, Any], after: dict[str, Any]) -> list[tuple[str, Any]]:
    return [(path, after.get(path, {})) for path in {**before, **after} if before.get(path) != after.get(path)]


def nodes_of(paths: list[str]) -> dict[str, list[Any]]:
    """The tree of paths, depth first: the names of nodes, the numbers of the nodes above, and of the parts or -1."""
    below: dict[str, list[str]] = {"": []}
    for path in paths:
        above = [path]
        while above[-1] not in below:
            above.append(above[-1][: above[-1].rfind("/")])
        for child, parent in zip(reversed(above[:-1]), reversed(above[1:])):
            below[parent].append(child)
            below[child] = []
    numbers = {path: number for number, path in enumerate(paths)}
    names: list[str] = []
    parents: list[int] = []
    parts: list[int] = []
    waiting = [(path, -1) for path in reversed(below[""])]
    while waiting:
        path, parent = waiting.pop()
        node = len(names)
        names.append(path[path.rfind("/") + 1 :])
        parents.append(parent)
        parts.append(numbers.get(path, -1))
        waiting += [(child, node) for child in reversed(below[path])]
    return {"names": names, "parents": parents, "parts": parts}
