"""What an inspector answers: layers and picks, measures and clashes, figures, errors and charts of its view."""

from __future__ import annotations

import dataclasses
import math
import time
from typing import TYPE_CHECKING, Any, Iterable, Iterator

import numpy

from vtkmodules.vtkRenderingCore import vtkRenderer

from .._index import AssemblyIndex
from .._layers import Layer, layers_at, layers_in
from .._options import METHODS
from .._see_through import see_through
from .._stats import stats
from . import _output
from ._table import PartTable, hexadecimal

if TYPE_CHECKING:
    from ._inspection import Inspection

_VTK_METHODS = ("vtk-oit", "vtk-peeling")


def paths_of(parts: PartTable, named: Iterable[Any]) -> list[str]:
    """The paths of Parts, actors, or pairs of an actor and a block."""
    return [path for path in (_path_of(parts, each) for each in named) if path is not None]


def _path_of(parts: PartTable, named: Any) -> str | None:
    if hasattr(named, "path"):
        return named.path
    prop, block = named if isinstance(named, tuple) else (named, 0)
    return parts.path_of(prop, block)


# Under the cursor


def layers(inspection: Inspection, x: int, y: int) -> list[dict[str, Any]]:
    return [_told(inspection.parts, layer) for layer in layers_at(inspection.renderer, x, y)]


def _told(parts: PartTable, layer: Layer) -> dict[str, Any]:
    path = layer.part.path if layer.part is not None else parts.path_of(layer.actor, layer.block)
    return {
        "part": path.rsplit("/", 1)[-1] if path else "",
        "path": path,
        "opacity": layer.opacity,
        "share": layer.share,
        "distance": layer.distance,
        "position": list(layer.position),
        "color": hexadecimal(layer.color),
        "front": layer.front,
        "opaque": layer.opaque,
    }


def pick(inspection: Inspection, x: int, y: int, deeper: int, through: float = 0.5) -> str | None:
    """The part from the front that has at least a share of the picture, or else the most visible; then those behind."""
    if isinstance(deeper, bool) or not isinstance(deeper, int) or deeper < 0:
        raise ValueError(f"deeper is 0 or a positive whole number, not {deeper!r}")
    found = layers_at(inspection.renderer, x, y, all=deeper > 0)
    shares: dict[str, float] = {}
    for told in (_told(inspection.parts, layer) for layer in found):
        if told["path"] is not None:
            shares[told["path"]] = shares.get(told["path"], 0.0) + told["share"]
    order = list(shares)
    if not order:
        return None
    first = next((i for i, path in enumerate(order) if shares[path] >= through), None)
    if first is None:
        first = max(range(len(order)), key=lambda i: shares[order[i]])
    return order[(first + deeper) % len(order)]


# Measures


def what_is_indexed(inspection: Inspection) -> Any:
    """What an index depends on."""
    state = inspection.state_now
    if state["explode"] == 0.0 and len(inspection.parts.assemblies) == 1:
        return None
    return state["explode"], frozenset(path for path, look in state["parts"].items() if look.get("visible") is False)


def make_index(inspection: Inspection) -> AssemblyIndex:
    """An index of all parts. That of an assembly has hidden ones too, but not the places of an exploded view."""
    is_whole = inspection.state_now["explode"] == 0.0 and len(inspection.parts.assemblies) == 1
    return AssemblyIndex(inspection.assembly if is_whole else inspection.renderer)


def measure(inspection: Inspection, kind: str, **what: Any) -> dict[str, Any]:
    measures = {"distance": _distance, "thickness": _thickness, "clearance": _clearance}
    if kind not in measures:
        raise ValueError(f"what can be measured is {', '.join(measures)}, not {kind!r}")
    try:
        return measures[kind](inspection, **what)
    except TypeError as error:
        if "argument" in str(error):
            raise ValueError(f"{kind} needs other values: {error}") from None
        raise


def _distance(_inspection: Inspection, a: Any, b: Any) -> dict[str, Any]:
    points = [[float(value) for value in point] for point in (a, b)]
    if any(len(point) != 3 or not all(map(math.isfinite, point)) for point in points):
        raise ValueError("distance is between two points, each of three finite numbers")
    return {"distance": math.dist(*points), "points": points}


def _thickness(inspection: Inspection, x: int, y: int) -> dict[str, Any]:
    """How thick the part is that the pixel shows, along the line of sight."""
    path = inspection.pick(x, y)
    at = next((layer for layer in inspection.layers(x, y) if layer["path"] == path), None)
    if path is None or at is None:
        raise ValueError("there is no part at this pixel")
    eye, direction = _line_of_sight(inspection, at)
    for wall in inspection.index().thickness(eye, direction):
        if path in paths_of(inspection.parts, [wall.part]):
            return {
                "part": path,
                "thickness": wall.thickness,
                "points": [list(wall.start_point), list(wall.end_point)],
            }
    raise ValueError(f"{path!r} has no thickness here: its surface is open, or it is seen from within")


def _line_of_sight(inspection: Inspection, layer: dict[str, Any]) -> tuple[list[float], list[float]]:
    camera = inspection.renderer.GetActiveCamera()
    if not camera.GetParallelProjection():
        eye = list(camera.GetPosition())
        return eye, [a - b for a, b in zip(layer["position"], eye)]
    direction = list(camera.GetDirectionOfProjection())
    way = 2.0 * camera.GetClippingRange()[1]
    return [a - way * b for a, b in zip(layer["position"], direction)], direction


def _clearance(inspection: Inspection, a: str, b: str) -> dict[str, Any]:
    named = []
    for pattern in (a, b):
        paths = inspection.parts.find(pattern)
        if len(paths) != 1:
            raise ValueError(f"clearance is between two parts, and {pattern!r} names {len(paths)}")
        named.append(inspection.parts.named(paths[0])[0])
    if named[0] is named[1]:
        raise ValueError("clearance is between two parts, and both are the same")
    found = inspection.index().distance(*named)
    return {"distance": found.distance, "points": [list(point) for point in found.points]}


def clashes(inspection: Inspection, clearance: float, progress: Any) -> list[dict[str, Any]]:
    found = inspection.index().clashes(clearance, progress=progress)
    return [
        {
            "parts": [_path_of(inspection.parts, part) for part in clash.parts],
            "kind": clash.kind,
            "depth": clash.depth,
            "distance": clash.distance,
            "point": list(clash.point) if clash.point is not None else None,
        }
        for clash in found
    ]


# Figures


def figures(inspection: Inspection) -> dict[str, Any]:
    told = {**dataclasses.asdict(stats(inspection.renderer)), "frame_ms": inspection.frame_ms}
    told.pop("stages")
    state = inspection.state_now
    told["size"] = list(state["size"])
    told["coincidence"] = state["coincidence"]
    told["parts"] = len(inspection.parts.paths)
    told["hidden"] = sum(1 for look in state["parts"].values() if look.get("visible") is False)
    return told


def error(inspection: Inspection) -> dict[str, Any]:
    inspection.draw()
    given = _output.read_pixels(inspection.window)
    begin = time.perf_counter()
    truth = _picture_by(inspection, "truth")
    return {**_difference(given, truth), "seconds": time.perf_counter() - begin}


def _difference(given: numpy.ndarray, truth: numpy.ndarray) -> dict[str, float]:
    difference = numpy.abs(given.astype(float) - truth.astype(float)) / 255
    return {
        "max": float(difference.max()),
        "rmse": float(numpy.sqrt((difference**2).mean())),
        "wrong_pixels": float((difference.max(axis=2) > 1.5 / 255).mean()),
    }


def _picture_by(inspection: Inspection, method: str) -> numpy.ndarray:
    with _drawn_by(inspection, method):
        inspection.window.Render()
        return _output.read_pixels(inspection.window)


class _drawn_by:
    """While it is entered, the view is drawn by another method, also VTK's own."""

    def __init__(self, inspection: Inspection, method: str) -> None:
        self._inspection, self._method = inspection, method

    def __enter__(self) -> None:
        renderer, coincidence = self._inspection.renderer, self._inspection.state_now["coincidence"]
        self._inspection.shown.set_method_aside()
        self._before = renderer.GetUseDepthPeeling(), renderer.GetMaximumNumberOfPeels(), renderer.GetOcclusionRatio()
        self._handle = None
        if self._method in _VTK_METHODS:
            _set_peeling(renderer, self._method == "vtk-peeling", 1000, 0.0)
        else:
            tolerant = coincidence is not None and self._method != "stencil-routed"
            self._handle = see_through(
                renderer,
                self._method,
                coincidence=tuple(coincidence) if tolerant else None,
                cull=self._inspection.state_now["cull"],
            )

    def __exit__(self, *_: object) -> None:
        if self._handle is not None:
            self._handle.remove()
        _set_peeling(self._inspection.renderer, *self._before)
        self._inspection.shown.take_method_back()
        self._inspection.forget_frame()


def _set_peeling(renderer: vtkRenderer, on: bool, peels: int, ratio: float) -> None:
    renderer.SetUseDepthPeeling(on)
    renderer.SetMaximumNumberOfPeels(peels)
    renderer.SetOcclusionRatio(ratio)


def chart(inspection: Inspection, frames: int) -> Iterator[dict[str, Any]]:
    """A row for each method as it is measured. The first is that of truth."""
    if isinstance(frames, bool) or not isinstance(frames, int) or not 1 <= frames <= 100:
        raise ValueError(f"frames is a whole number from 1 to 100, not {frames!r}")
    inspection.draw()
    view = inspection.state_now
    truth = _picture_by(inspection, "truth")
    yield {"method": "truth", "frame_ms": None, "error": _difference(truth, truth)}
    for method in [*(method for method in METHODS if method != "truth"), *_VTK_METHODS]:
        if inspection.state_now is not view:
            raise InterruptedError("the view has changed, and a chart is of one view")
        inspection.draw()  # at the size of the state
        yield _measured(inspection, method, truth, frames)


def _measured(inspection: Inspection, method: str, truth: numpy.ndarray, frames: int) -> dict[str, Any]:
    """The median time of some frames, after one that is not timed, and the error of the last."""
    times = []
    with _drawn_by(inspection, method):
        for _ in range(1 + frames):
            begin = time.perf_counter()
            inspection.window.Render()
            inspection.window.WaitForCompletion()
            times.append(1000 * (time.perf_counter() - begin))
        picture = _output.read_pixels(inspection.window)
        reason = "" if method in _VTK_METHODS else stats(inspection.renderer).fallback_reason
    row = {"method": method, "frame_ms": sorted(times[1:])[frames // 2], "error": _difference(picture, truth)}
    return {**row, "fallback_reason": reason} if reason else row


def heat_map(inspection: Inspection) -> numpy.ndarray:
    """Black for no layer, then from blue over green, yellow and red to white for the most, by square roots."""
    width, height = inspection.renderer.GetSize()
    left, bottom = inspection.renderer.GetOrigin()
    found = layers_in(inspection.renderer, left, bottom, left + width - 1, bottom + height - 1)
    counts = numpy.diff(found.offsets).reshape(height, width)[::-1]
    shares = numpy.sqrt(counts / max(int(counts.max()), 1))
    stops = numpy.linspace(0.0, 1.0, len(_HEAT))
    channels = [numpy.interp(shares, stops, [color[i] for color in _HEAT]) for i in range(3)]
    return numpy.stack(channels, axis=2).round().astype(numpy.uint8)


_HEAT = ((0, 0, 0), (20, 40, 200), (0, 150, 220), (30, 180, 60), (240, 220, 30), (230, 40, 20), (255, 255, 255))


def culled(inspection: Inspection) -> list[dict[str, Any]]:
    culler = next((each for each in inspection.renderer.GetCullers() if each.IsA("vtkHierarchicalSBufferCuller")), None)
    if culler is None:
        return []
    reasons: dict[str, list[str]] = {}
    for path in inspection.parts.paths:
        reasons.setdefault(culler.GetReason(inspection.parts.actor_of(path)) or "", []).append(path)
    told = [
        {"reason": reason, "parts": len(paths), "paths": paths[:20]} for reason, paths in reasons.items() if reason
    ]
    if culler.GetReason():
        told.insert(0, {"reason": culler.GetReason(), "parts": len(inspection.parts.paths), "paths": []})
    return told
