"""Cameras and planes of the inspector: standard directions, fitting, and the middle of all that is shown."""

from __future__ import annotations

import math
from typing import Any, Sequence

from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

from ._shown import camera_place, place_camera
from ._table import hexadecimal

_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
# Directions to the eye, and what is upwards. Y is upwards, as in glTF.
DIRECTIONS = {
    "front": ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)),
    "back": ((0.0, 0.0, -1.0), (0.0, 1.0, 0.0)),
    "right": ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "left": ((-1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "top": ((0.0, 1.0, 0.0), (0.0, 0.0, -1.0)),
    "bottom": ((0.0, -1.0, 0.0), (0.0, 0.0, 1.0)),
    "iso": ((1.0, 0.8, 1.0), (0.0, 1.0, 0.0)),
}


def shown_bounds(renderer: vtkRenderer) -> tuple[float, ...]:
    """The box around all visible props, or a box around the origin if there are none."""
    bounds = renderer.ComputeVisiblePropBounds()
    return tuple(bounds) if bounds[0] <= bounds[1] else (-1.0, 1.0) * 3


def look_as_pyvista_would(renderer: Any) -> None:
    """Have a plotter's renderer that nobody has placed a camera for see all, as PyVista does when it is shown."""
    if getattr(renderer, "camera_set", True) or not hasattr(renderer, "get_default_cam_pos"):
        return
    renderer.camera_position = renderer.get_default_cam_pos()
    renderer.ResetCamera()


def background_of(renderer: vtkRenderer) -> str:
    return hexadecimal(renderer.GetBackground())


def plane(normal: Any, origin: Any, bounds: Sequence[float] | None) -> dict[str, Any]:
    """A plane of a state. Without an origin it goes through the middle of bounds. Raises TypeError and ValueError."""
    if isinstance(normal, str):
        if normal.lstrip("-") not in _AXES or normal.count("-") > 1:
            raise ValueError(f"a normal is x, y, z, -x, -y, -z or three numbers, not {normal!r}")
        sign = -1.0 if normal.startswith("-") else 1.0
        normal = [sign * value + 0.0 for value in _AXES[normal[-1]]]
    direction = _three_numbers("a normal", normal)
    length = math.hypot(*direction)
    if not 0.0 < length < math.inf:
        raise ValueError(f"a normal has a direction, unlike {normal!r}")
    if origin is None:
        assert bounds is not None
        origin = [(bounds[2 * axis] + bounds[2 * axis + 1]) / 2 for axis in range(3)]
    return {"normal": [value / length for value in direction], "origin": _three_numbers("an origin", origin)}


def _three_numbers(what: str, values: Any) -> list[float]:
    try:
        numbers = [float(value) for value in values]
    except (TypeError, ValueError):
        raise TypeError(f"{what} has three numbers, unlike {values!r}") from None
    if len(numbers) != 3 or not all(math.isfinite(value) for value in numbers):
        raise ValueError(f"{what} has three finite numbers, unlike {values!r}")
    return numbers


def looking_from(renderer: vtkRenderer, name: str, bounds: Sequence[float]) -> dict[str, Any]:
    """The camera that sees all of a box from a standard direction."""
    if name not in DIRECTIONS:
        raise ValueError(f"a view is one of {', '.join(DIRECTIONS)}, not {name!r}")
    towards_eye, up = DIRECTIONS[name]
    camera = vtkCamera()
    camera.DeepCopy(renderer.GetActiveCamera())
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetPosition(*towards_eye)
    camera.SetViewUp(*up)
    return _fit(renderer, camera, bounds)


def look_from(renderer: vtkRenderer, name: str, bounds: Sequence[float]) -> None:
    """Have a renderer's camera see all of a box from a standard direction."""
    place_camera(renderer.GetActiveCamera(), looking_from(renderer, name, bounds))


def fitted(renderer: vtkRenderer, bounds: Sequence[float]) -> dict[str, Any]:
    """The camera that sees all of a box from where the renderer's camera is."""
    camera = vtkCamera()
    camera.DeepCopy(renderer.GetActiveCamera())
    return _fit(renderer, camera, bounds)


def _fit(renderer: vtkRenderer, camera: vtkCamera, bounds: Sequence[float]) -> dict[str, Any]:
    """Move a camera along its direction so that the sphere around a box fills the picture's shorter side."""
    middle = [(bounds[2 * axis] + bounds[2 * axis + 1]) / 2 for axis in range(3)]
    radius = max(0.5 * math.dist(bounds[::2], bounds[1::2]), 1e-30)
    width, height = renderer.GetSize()
    aspect = min(1.0, width / height) if width > 0 and height > 0 else 1.0
    half_angle = math.atan(aspect * math.tan(math.radians(camera.GetViewAngle() / 2)))
    distance = radius / math.sin(half_angle)
    normal = camera.GetViewPlaneNormal()
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle[axis] + distance * normal[axis] for axis in range(3)))
    camera.SetParallelScale(radius / aspect)
    return camera_place(camera)


def projected(camera: dict[str, Any], parallel: bool) -> dict[str, Any]:
    """The camera in parallel projection or perspective, in which what is at the focal point has its size."""
    if not isinstance(parallel, bool):
        raise TypeError(f"parallel is True or False, not {parallel!r}")
    if parallel == camera["parallel"]:
        return camera
    tangent = math.tan(math.radians(camera["view_angle"] / 2))
    way = [a - b for a, b in zip(camera["position"], camera["focal_point"])]
    distance = math.hypot(*way)
    if parallel:
        return {**camera, "parallel": True, "parallel_scale": distance * tangent}
    share = camera["parallel_scale"] / tangent / distance
    position = [b + share * a for a, b in zip(way, camera["focal_point"])]
    return {**camera, "parallel": False, "position": position}


def turned(camera: dict[str, Any], degrees: float) -> dict[str, Any]:
    """The camera after going around its focal point, about the vertical axis."""
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def turn(vector: Sequence[float]) -> list[float]:
        x, y, z = vector
        return [cosine * x + sine * z, y, cosine * z - sine * x]

    middle = camera["focal_point"]
    way = turn([a - b for a, b in zip(camera["position"], middle)])
    position = [a + b for a, b in zip(middle, way)]
    return {**camera, "position": position, "view_up": turn(camera["view_up"])}
