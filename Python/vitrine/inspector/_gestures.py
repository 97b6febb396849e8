"""Gestures in the view: what the mouse does to the camera, or to a plane, by pixels."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from vtkmodules.vtkRenderingCore import vtkCamera

from ._shown import camera_place, place_camera

if TYPE_CHECKING:
    from ._inspection import Inspection

KINDS = ("rotate", "turn", "pan", "zoom", "roll", "plane")
_MOST_PIXELS = 20000
_STEEPEST = 89.0  # degrees above and below the horizon, on a turntable


def move(inspection: Inspection, kind: str, across: Any, down: Any, stroke: Any, plane: Any = 0) -> None:
    """Move by pixels to the right and downwards. All moves of a stroke are one step of undo().

    Kinds: rotate (a trackball), turn (a turntable), pan, zoom (downwards comes nearer), roll, and plane, which moves
    the section with the number `plane` along its normal.

    Raises ValueError for an unknown kind, or numbers that are no pixels.
    """
    if kind not in KINDS:
        raise ValueError(f"a gesture is {', '.join(KINDS)}, not {kind!r}")
    right, up = _pixels(across), -_pixels(down)
    if kind == "plane":
        _move_plane(inspection, plane, right, up)
        return
    camera = vtkCamera()
    place_camera(camera, inspection.camera())
    # The window may be smaller than the picture that the mouse moves over.
    height = inspection.state_now["size"][1]
    _MOVES[kind](camera, right / height, up / height)
    moved = camera_place(camera)
    if all(map(math.isfinite, [*moved["position"], *moved["focal_point"], *moved["view_up"]])):
        inspection.set_camera(moved, merge=("stroke", stroke if isinstance(stroke, (int, str)) else 0))


def _pixels(value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not abs(value) <= _MOST_PIXELS:
        raise ValueError(f"a gesture goes by at most {_MOST_PIXELS} pixels, not {value!r}")
    return float(value)


def _rotate(camera: vtkCamera, right: float, up: float) -> None:
    camera.Azimuth(-180.0 * right)
    camera.Elevation(-180.0 * up)
    camera.OrthogonalizeViewUp()


def _turn(camera: vtkCamera, right: float, up: float) -> None:
    """Around the vertical axis, and up and down between the poles. Y is upwards."""
    axis = camera.GetViewPlaneNormal()
    height = math.degrees(math.asin(max(-1.0, min(1.0, axis[1]))))
    if abs(height) < _STEEPEST:
        camera.SetViewUp(0.0, 1.0, 0.0)
    camera.Azimuth(-180.0 * right)
    wanted = max(-_STEEPEST, min(_STEEPEST, height - 180.0 * up))
    camera.Elevation(wanted - height)
    camera.OrthogonalizeViewUp()


def _pan(camera: vtkCamera, right: float, up: float) -> None:
    size = _height_of_view(camera)
    up_axis, towards_eye = camera.GetViewUp(), camera.GetViewPlaneNormal()
    right_axis = _cross(up_axis, towards_eye)
    way = [-size * (right * a + up * b) for a, b in zip(right_axis, _cross(towards_eye, right_axis))]
    camera.SetPosition(*(a + b for a, b in zip(camera.GetPosition(), way)))
    camera.SetFocalPoint(*(a + b for a, b in zip(camera.GetFocalPoint(), way)))


def _zoom(camera: vtkCamera, _right: float, up: float) -> None:
    factor = math.exp(max(-3.0, min(3.0, -3.0 * up)))
    if camera.GetParallelProjection():
        camera.SetParallelScale(camera.GetParallelScale() / factor)
    else:
        camera.Dolly(factor)


def _roll(camera: vtkCamera, right: float, _up: float) -> None:
    camera.Roll(180.0 * right)


_MOVES = {"rotate": _rotate, "turn": _turn, "pan": _pan, "zoom": _zoom, "roll": _roll}


def _move_plane(inspection: Inspection, index: Any, right: float, up: float) -> None:
    """Have a plane follow the cursor along its normal, as the normal is seen in the view."""
    sections = inspection.state_now["sections"]
    if isinstance(index, bool) or not isinstance(index, int) or not 0 <= index < len(sections):
        raise ValueError(f"there is no section {index!r}: there are {len(sections)}, counted from 0")
    normal, origin = sections[index]["normal"], sections[index]["origin"]
    camera = inspection.renderer.GetActiveCamera()
    towards_eye, up_axis = camera.GetViewPlaneNormal(), camera.GetViewUp()
    right_axis = _cross(up_axis, towards_eye)
    seen = (_dot(normal, right_axis), _dot(normal, _cross(towards_eye, right_axis)))
    length = math.hypot(*seen)
    # A plane that faces the eye goes away from it with an upward stroke.
    along = (
        (seen[0] * right + seen[1] * up) / length
        if length > 0.1
        else -up * (1 if _dot(normal, towards_eye) > 0 else -1)
    )
    scale = _height_of_view(camera) / inspection.state_now["size"][1] / max(length, 0.1 if length > 0.1 else 1.0)
    inspection.move_section(index, origin=[a + scale * along * b for a, b in zip(origin, normal)])


def _height_of_view(camera: vtkCamera) -> float:
    """The height of what the view shows at the focal point, in world coordinates."""
    if camera.GetParallelProjection():
        return 2.0 * camera.GetParallelScale()
    return 2.0 * camera.GetDistance() * math.tan(math.radians(camera.GetViewAngle() / 2))


def _cross(a: Any, b: Any) -> list[float]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _dot(a: Any, b: Any) -> float:
    return float(sum(x * y for x, y in zip(a, b)))
