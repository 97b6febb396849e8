"""What the inspector does, without a page: Inspection opens an assembly, changes its state, and takes changes back."""

from __future__ import annotations

import copy
import os
from typing import Any, Iterable, Iterator, Mapping, NoReturn, Sequence

import numpy

from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from .._assembly import Assembly
from .._parts import shown_assemblies
from .._target import _plotter_of, _renderers_of
from . import _ask, _output, _script, _state, _views
from ._shown import Shown, camera_place
from ._state import State
from ._table import PartTable
from ._target import new_window, opened, plain_actors, warn_of_other_subplots

GHOST = 0.15  # the opacity of what ghost() and isolate() make faint
_MOST_UNDONE = 200
_MOST_SECTIONS = 6
_UNTIL_CLOSED = ("window", "renderer", "parts", "shown")


class Inspection:
    """An assembly in a window without a page, with a state that can be changed, undone, saved and opened again.

    Parts are named by paths, by nodes' paths, or by patterns of names as of Assembly. Coordinates are world
    coordinates. Pixels are counted from the lower left corner of a picture of the state's size. Each change is a step
    that undo() takes back. A change that cannot be made raises, and the state stays as it was.

    Attributes:
        window, renderer: what draws.
        state_now: the state itself, which nobody may change.
        frame_ms: the milliseconds that the last frame took.
        assembly: the Assembly that is shown, the first if there are several, or None for a plotter without one.
        parts: the PartTable.
    """

    def __init__(self, target: Any, *, size: Sequence[int] = (1024, 640), tolerance: float = 0.0) -> None:
        """Show an Assembly, files (a path or several), or what a pyvista.Plotter shows.

        Args:
            target: an Assembly, a path, an iterable of paths, or a pyvista.Plotter, whose window and camera are used.
            size: width and height of pictures in pixels. A plotter keeps its own.
            tolerance: as that of load(), for files.

        Raises as load() does, and TypeError for another target.
        """
        files: list[dict[str, Any]] = []
        plotter = _plotter_of(target)
        if plotter is not None:
            _renderers_of(target)  # raises for one that is closed
            warn_of_other_subplots(plotter)
            _views.look_as_pyvista_would(plotter.renderer)
            self.renderer: vtkRenderer = plotter.renderer
            self.window: vtkRenderWindow = plotter.render_window
            assemblies, actors = shown_assemblies([self.renderer]), plain_actors(plotter)
            size = self.window.GetSize()
        else:
            assemblies, files = opened(target, tolerance)
            self.window, self.renderer, actors = new_window(), vtkRenderer(), {}
            self.window.AddRenderer(self.renderer)
            for assembly in assemblies:
                assembly.add_to(self.renderer)
        self.assembly: Assembly | None = assemblies[0] if assemblies else None
        self.parts = PartTable(assemblies, actors)
        self.frame_ms = 0.0
        self.drawn: State | None = None  # the state that the last frame shows
        self._plotter = plotter  # kept alive
        self.shown = Shown(self.renderer, self.parts)
        self._undo: list[State] = []
        self._redo: list[State] = []
        self._merge: Any = None
        self._index: Any = None
        self._state: State = {}
        self._begin(files, size, keep_camera=plotter is not None)

    @property
    def state_now(self) -> State:
        return self._state

    def _begin(self, files: list[dict[str, Any]], size: Sequence[int], keep_camera: bool) -> None:
        width, height = _output.size_pair(size)
        given = {"vitrine": _state.FORMAT, "files": files, "size": [width, height], "parts": self.parts.given_looks()}
        _state.check(given)
        state = _state.with_defaults(given)
        if keep_camera:
            state["background"] = _views.background_of(self.renderer)
            state["lights"] = None
        self.shown.show(state)
        if not keep_camera:
            _views.look_from(self.renderer, "iso", self._bounds())
        state["camera"] = camera_place(self.renderer.GetActiveCamera())
        self._state = state

    # The state

    def state(self) -> State:
        """A copy of the state, as state.schema.json describes it."""
        return copy.deepcopy(self._state)

    def apply(self, state: Mapping[str, Any]) -> None:
        """Take a state, such as one that state() returned. "files" stay those that are shown.

        Raises:
            ValueError: it is not as state.schema.json says, or names parts that are not there.
        """
        new = _state.complete(state)
        new["files"] = self._state["files"]
        new.setdefault("camera", self._state["camera"])
        self._check_parts(new)
        self._change(new)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the state into a JSON file, which `vitrine render` draws and `vitrine inspect` opens."""
        _state.write(self._state, path)

    def undo(self) -> bool:
        """Take the last change back. Returns False if there is none."""
        return self._step(self._undo, self._redo)

    def redo(self) -> bool:
        """Make the change again that undo() took back last. Returns False if there is none."""
        return self._step(self._redo, self._undo)

    @property
    def can_undo(self) -> bool:
        return bool(self._undo)

    @property
    def can_redo(self) -> bool:
        return bool(self._redo)

    def forget_changes(self) -> None:
        """Have nothing to undo or redo, as after opening."""
        self._undo.clear()
        self._redo.clear()

    def _step(self, taken: list[State], kept: list[State]) -> bool:
        if not taken:
            return False
        self.shown.show(taken[-1])
        kept.append(self._state)
        self._state = taken.pop()
        self._merge = None
        return True

    def _change(self, new: State, merge: Any = None) -> None:
        """Show a new state. Changes that follow each other with one `merge` are one step of undo()."""
        if new == self._state:
            return
        self.shown.show(new)
        if merge is None or merge != self._merge:
            self._undo.append(self._state)
            del self._undo[:-_MOST_UNDONE]
        self._redo.clear()
        self._merge = merge
        self._state = new

    def _set(self, merge: Any = None, **values: Any) -> None:
        """Change keys of the state, which are checked."""
        _state.check({"vitrine": _state.FORMAT, **values})
        self._change({**self._state, **values}, merge)

    def _check_parts(self, state: State) -> None:
        named = [*state["parts"], *state["selected"], *state["highlight"]]
        named += [state["reveal"]["part"]] if state["reveal"] else []
        named += state["x_ray"]["parts"] if state["x_ray"] else []
        unknown = [path for path in dict.fromkeys(named) if path not in self.parts]
        if unknown:
            more = f" and {len(unknown) - 1} more" if len(unknown) > 1 else ""
            raise ValueError(f"the state names a part that is not there: {unknown[0]!r}{more}")

    def script(self) -> str:
        """A Python script that draws the picture of the state with vitrine's calls."""
        return _script.script_of(self._state, self.parts.bounds())

    # Parts

    def hide(self, parts: str | Iterable[str]) -> None:
        """Have parts not drawn."""
        self._look(self.parts.find(parts), visible=False)

    def show(self, parts: str | Iterable[str]) -> None:
        """Have parts drawn."""
        self._look(self.parts.find(parts), visible=True)

    def ghost(self, parts: str | Iterable[str], opacity: float = GHOST) -> None:
        """Make parts faint."""
        self._look(self.parts.find(parts), opacity=opacity)

    def isolate(self, parts: str | Iterable[str], opacity: float = 0.0) -> None:
        """Have parts drawn as they are by themselves, and others with an opacity: 0 hides them. Hidden ones stay so."""
        kept = set(self.parts.find(parts))
        rest = {"visible": False} if opacity == 0.0 else {"opacity": opacity}
        _state.check({"vitrine": _state.FORMAT, "parts": {"/": rest}})
        looks = {}
        for path in self.parts.paths:
            look = dict(self._state["parts"].get(path, {}))
            if path in kept:
                look.pop("visible", None)
                look.pop("opacity", None)
            else:
                look.update(rest)
            if look:
                looks[path] = look
        self._change({**self._state, "parts": looks})

    def look(
        self, parts: str | Iterable[str], *, opacity: float | None = None, color: str | None = None, merge: Any = None
    ) -> None:
        """Give parts an opacity in [0, 1], or a colour #RRGGBB. None leaves it as it is."""
        given = {"opacity": opacity, "color": color}
        self._look(self.parts.find(parts), merge, **{key: value for key, value in given.items() if value is not None})

    def reset(self, parts: str | Iterable[str] | None = None) -> None:
        """Have parts look as their file says. None stands for all."""
        paths = set(self.parts.paths if parts is None else self.parts.find(parts))
        looks = {path: look for path, look in self._state["parts"].items() if path not in paths}
        self._change({**self._state, "parts": looks})

    def _look(self, paths: Iterable[str], merge: Any = None, **values: Any) -> None:
        _state.check({"vitrine": _state.FORMAT, "parts": {"/": values}})
        looks = dict(self._state["parts"])
        for path in paths:
            look = {**looks.get(path, {}), **values}
            if look.get("visible") and self.parts.look_of_file(path)["visible"]:
                del look["visible"]  # as the file has it
            if look:
                looks[path] = look
            else:
                looks.pop(path, None)
        self._change({**self._state, "parts": looks}, merge)

    def select(self, parts: str | Iterable[str] | None, *, add: bool = False) -> None:
        """Select parts, whose outlines are drawn. None selects none. `add` keeps those that are selected, and takes
        away those of `parts` that are selected already."""
        found = self.parts.find(parts) if parts is not None else []
        before = self._state["selected"]
        new = [path for path in before if path not in set(found)] + [p for p in found if p not in set(before)]
        self._change({**self._state, "selected": new if add else found})

    def highlight(self, parts: str | Iterable[str] | None) -> None:
        """Have the outlines of parts drawn, through all that hides them. None stands for no parts."""
        self._change({**self._state, "highlight": self.parts.find(parts) if parts is not None else []})

    def explode(self, factor: float) -> None:
        """Have parts drawn apart, by 0 to 1000 times their distances from the middles of their groups."""
        self._set(merge="explode", explode=factor)

    # Seeing in

    def add_section(self, normal: str | Sequence[float] = "x", origin: Sequence[float] | None = None) -> int:
        """Cut by a plane that keeps the side of its normal. Without an origin it goes through the middle of all.

        Returns the plane's place in "sections" of the state. There are six at most.
        """
        plane = _views.plane(normal, origin, self._bounds())
        if len(self._state["sections"]) == _MOST_SECTIONS:
            raise ValueError(f"there are {_MOST_SECTIONS} planes already: remove one")
        self._set(sections=[*self._state["sections"], plane])
        return len(self._state["sections"]) - 1

    def move_section(
        self, index: int, normal: str | Sequence[float] | None = None, origin: Sequence[float] | None = None
    ) -> None:
        """Give a plane another normal or origin. None leaves it."""
        plane = self._section(index)
        moved = _views.plane(
            plane["normal"] if normal is None else normal, plane["origin"] if origin is None else origin, None
        )
        sections = list(self._state["sections"])
        sections[index] = moved
        self._set(merge=("section", index), sections=sections)

    def remove_section(self, index: int) -> None:
        """Take a plane away."""
        self._section(index)
        self._set(sections=[plane for i, plane in enumerate(self._state["sections"]) if i != index])

    def _section(self, index: Any) -> dict[str, Any]:
        sections = self._state["sections"]
        if isinstance(index, bool) or not isinstance(index, int) or not 0 <= index < len(sections):
            raise ValueError(f"there is no section {index!r}: there are {len(sections)}, counted from 0")
        return sections[index]

    def set_box(self, bounds: Sequence[float] | None = None, inside: bool = True) -> None:
        """Cut by a box: xmin, xmax, ymin, ymax, zmin, zmax. `inside` tells which side is kept. None takes it away."""
        box = None if bounds is None else {"bounds": [*bounds], "inside": inside}
        self._set(merge="box" if box is not None and self._state["box"] is not None else None, box=box)

    def set_caps(self, **look: Any) -> None:
        """Change how cuts look: show (bool), hatch (a name), edges (pixels, 0 to 4), stripes (bool)."""
        self._set(caps={**self._state["caps"], **look})

    def cut_parts(self) -> list[str]:
        """The paths of parts that planes or the box cut, by their boxes."""
        found = [part for handle in self.shown.cuts[:1] for part in handle.cut_parts]
        return _ask.paths_of(self.parts, found)

    def reveal(self, part: str | None, share: float = 0.7, cutaway: bool = False) -> None:
        """Fade what stands in front of a part, so that `share` of its light passes in each of its pixels. None ends it.

        It is anew for each still picture.
        """
        wanted = None
        if part is not None:
            paths = self.parts.find(part)
            if len(paths) != 1:
                raise ValueError(f"reveal() takes one part, and {part!r} names {len(paths)}")
            wanted = {"part": paths[0], "share": share, "cutaway": cutaway}
        self._set(merge="reveal" if wanted and self._state["reveal"] else None, reveal=wanted)

    def x_ray(self, parts: str | Iterable[str] | None, falloff: float = 2.0, floor: float = 0.05) -> None:
        """Show parts as an x-ray does. None ends it."""
        look = None if parts is None else {"parts": self.parts.find(parts), "falloff": falloff, "floor": floor}
        self._set(x_ray=look)

    # The view

    def camera(self) -> dict[str, Any]:
        """The camera, as the state has it."""
        return copy.deepcopy(self._state["camera"])

    def set_camera(self, camera: Mapping[str, Any], merge: Any = "camera") -> None:
        """Look from elsewhere. Moves that follow each other are one step of undo()."""
        self._set(merge=merge, camera={**_state.CAMERA_DEFAULTS, **self._state["camera"], **camera})

    def take_camera(self, merge: Any = "camera") -> None:
        """Take the camera of the renderer, which something else has moved, into the state."""
        self.set_camera(camera_place(self.renderer.GetActiveCamera()), merge)

    def fit(self, parts: str | Iterable[str] | None = None) -> None:
        """Have parts, or all that is drawn, fill the picture, seen from the same direction."""
        bounds = self._bounds() if parts is None else self.parts.bounds(self.parts.find(parts))
        self.set_camera(_views.fitted(self.renderer, bounds), merge=None)

    def view(self, name: str) -> None:
        """Look from a standard direction: front, back, left, right, top, bottom or iso, with Y upwards."""
        self.set_camera(_views.looking_from(self.renderer, name, self._bounds()), merge=None)

    def save_view(self, name: str) -> None:
        """Keep the camera under a name."""
        if not isinstance(name, str):
            raise TypeError(f"the name of a view is a text, not {name!r}")
        self._set(views={**self._state["views"], name: self.camera()})

    def remove_view(self, name: str) -> None:
        """Forget a view that save_view() kept."""
        self._view(name)
        self._set(views={key: camera for key, camera in self._state["views"].items() if key != name})

    def go_to(self, name: str) -> None:
        """Look from a view that save_view() kept."""
        self.set_camera(self._view(name), merge=None)

    def _view(self, name: str) -> dict[str, Any]:
        if name not in self._state["views"]:
            raise KeyError(f"no view has the name {name!r}: there are {', '.join(self._state['views']) or 'none'}")
        return self._state["views"][name]

    def parallel(self, on: bool) -> None:
        """Switch parallel projection on or off. What lies in the middle keeps its size."""
        self.set_camera(_views.projected(self.camera(), on), merge=None)

    def set_size(self, width: int, height: int) -> None:
        """Have pictures of so many pixels. This is no step of undo()."""
        _state.check({"vitrine": _state.FORMAT, "size": [width, height]})
        self._state = {**self._state, "size": [width, height]}
        self.shown.show(self._state)

    def set_lights(self, preset: str | None) -> None:
        """Light by "headlight", "studio", "side" or "above", or for None as a plotter was lit."""
        self._set(lights=preset)

    def set_background(self, color: str) -> None:
        """Give the background a colour #RRGGBB."""
        self._set(merge="background", background=color)

    def set_method(
        self, method: str, coincidence: Sequence[float] | None = None, cull: bool | None = None
    ) -> None:
        """Draw by another method of see_through(), with its coincidence, and with or without culling.

        Methods other than automatic have no error budget.
        """
        tolerance = None if coincidence is None else [*coincidence]
        error = self._state["error"] if method == "automatic" else None
        cull = self._state["cull"] if cull is None else cull
        self._set(method=method, error=error, coincidence=tolerance, cull=cull)

    def set_error(self, error: float | None) -> None:
        """Draw by automatic within an error budget: of a channel from 0 to 1, at least 0.6/255. None ends it."""
        self._set(method=_state.DEFAULTS["method"] if error is None else "automatic", error=error)

    def set_levels(self, pixels: float | None) -> None:
        """Show the page parts of assemblies at levels of detail while the camera moves. No point moves by more pixels.

        All other pictures show parts as they are. None ends it.
        """
        self._set(levels=pixels)

    def _bounds(self) -> tuple[float, ...]:
        return _views.shown_bounds(self.renderer)

    # Answers and pictures

    def layers(self, x: int, y: int) -> list[dict[str, Any]]:
        """All layers of a pixel, from front to back, down to the nearest opaque one."""
        self.draw()
        return _ask.layers(self, x, y)

    def pick(self, x: int, y: int, deeper: int = 0) -> str | None:
        """The path of the part that a click on a pixel gives, or of one so many parts deeper. None if there is none."""
        self.draw()
        return _ask.pick(self, x, y, deeper)

    def measure(self, kind: str, **what: Any) -> dict[str, Any]:
        """Measure: "distance" between points `a` and `b`, "thickness" of what the pixel `x`, `y` shows first, or
        "clearance" between the parts `a` and `b`."""
        return _ask.measure(self, kind, **what)

    def clashes(self, clearance: float = 0.0, progress: Any = None) -> list[dict[str, Any]]:
        """The pairs of parts that interfere or are within a clearance. `progress` is that of AssemblyIndex."""
        return _ask.clashes(self, clearance, progress)

    def index(self) -> Any:
        """The AssemblyIndex of all that is shown. It is made where the exploded view has changed since, which takes
        seconds for large assemblies."""
        shown = _ask.what_is_indexed(self)
        if self._index is None or self._index[0] != shown:
            self._index = shown, _ask.make_index(self)
        return self._index[1]

    def figures(self) -> dict[str, Any]:
        """What the last frame took: method, milliseconds, layers, bytes, what was culled and why."""
        return _ask.figures(self)

    def error(self) -> dict[str, Any]:
        """How far the picture is from truth, in colours from 0 to 1. It draws the truth, which takes seconds."""
        return _ask.error(self)

    def chart(self, frames: int = 3) -> Iterator[dict[str, Any]]:
        """Measure all methods on this view, one after another: milliseconds a frame, and error against truth."""
        return _ask.chart(self, frames)

    def heat_map(self) -> numpy.ndarray:
        """The number of layers of each pixel as colours: bytes of RGB, rows from the top."""
        self.draw()
        return _ask.heat_map(self)

    def culled(self) -> list[dict[str, Any]]:
        """What the culler did with parts, and why: reasons, with the number of parts and some paths."""
        return _ask.culled(self)

    def forget_frame(self) -> None:
        """Have the next draw() draw, since something else has changed what the window shows."""
        self.drawn = None

    def look_from(self, camera: Mapping[str, Any]) -> None:
        """Look from elsewhere. This is no step of undo()."""
        self._state = {**self._state, "camera": dict(camera)}
        self.shown.show(self._state)

    def draw(self) -> None:
        """Draw the state. Nothing happens if the last frame shows it already."""
        _output.draw(self)

    def picture(self, size: Sequence[int] | None = None, *, transparent: bool = False) -> numpy.ndarray:
        """The picture of the state: bytes of RGB or RGBA, rows from the top. Sizes beyond 4096 are drawn in tiles."""
        return _output.picture(self, size, transparent)

    def screenshot(
        self, path: str | os.PathLike[str], size: Sequence[int] | None = None, *, transparent: bool = False
    ) -> None:
        """Write the picture into a PNG file."""
        _output.screenshot(self, path, size, transparent)

    def turntable(self, path: str | os.PathLike[str], frames: int = 120, size: Sequence[int] | None = None) -> None:
        """Write a video (.mp4, .gif or .webp) of one turn around the vertical axis. The state stays."""
        for _ in _output.turntable(self, path, frames, size):
            pass

    def close(self) -> None:
        """Put a plotter's renderer back as it was, or let the window go. What needs them raises RuntimeError then."""
        if "window" not in vars(self):
            return
        self.shown.remove()
        if self._plotter is None:
            self.window.Finalize()
        self._index = None
        for name in _UNTIL_CLOSED:
            delattr(self, name)

    def __getattr__(self, name: str) -> NoReturn:
        if name in _UNTIL_CLOSED:
            raise RuntimeError("this Inspection is closed: make another one")
        raise AttributeError(f"an Inspection has no {name!r}")
