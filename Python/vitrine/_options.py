"""The options of see_through(): what they may be, and the pass that they make."""

from __future__ import annotations

import math
import numbers
import operator
from typing import Any, Mapping, SupportsIndex

from .vtkVitrineRendering import (
    vtkABufferTransparencyPass,
    vtkClusteredLightsPass,
    vtkDeferredLightsPass,
    vtkErrorBudgetTransparencyPass,
    vtkSeeThroughPass,
    vtkTolerantTransparencyPass,
    vtkTransparencyPass,
)

METHODS: tuple[str, ...] = tuple(vtkTransparencyPass.GetExactMethods().split(","))
_LIGHTS: dict[str, Any] = {
    "clustered": vtkClusteredLightsPass,
    "deferred": vtkDeferredLightsPass,
}
_COLOR_STORAGES = {
    "half-float": vtkABufferTransparencyPass.HALF_FLOAT,
    "8-bit": vtkABufferTransparencyPass.EIGHT_BIT,
    "compact": vtkABufferTransparencyPass.COMPACT,
}


def method_name(method: str | None, error: float | None, error_bounds: bool, frame_ms: float | None) -> str:
    """The method that see_through() takes: without a name, the default one, or the one that keeps an error budget."""
    if method is not None:
        return method
    return "automatic" if error is not None or error_bounds or frame_ms is not None else "prefix-sum-predicted"


def make_pass(
    method: str,
    lights: str | bool | None,
    color_storage: str | None,
    memory_limit: SupportsIndex | None,
    coincidence: float | tuple[float, float] | None,
    part_numbers: bool,
    error: float | None,
    error_bounds: bool,
    frame_ms: float | None,
) -> vtkSeeThroughPass:
    transparency = _new_method(method)
    if color_storage is not None:
        _only_of(vtkABufferTransparencyPass, method, "color_storage")
        if isinstance(transparency, vtkErrorBudgetTransparencyPass):
            raise ValueError(f"color_storage is no option of {method}, which chooses it by the error")
        transparency.SetColorStorage(_known("color_storage", color_storage, _COLOR_STORAGES))
    if memory_limit is not None:
        _only_of(vtkABufferTransparencyPass, method, "memory_limit")
        transparency.SetMemoryLimit(number_of_bytes(memory_limit))
    if coincidence is not None:
        _only_of(vtkTolerantTransparencyPass, method, "coincidence")
        steps, slope = _steps_and_slope(coincidence)
        transparency.SetCoincidenceSteps(steps)
        transparency.SetCoincidenceSlope(slope)
    check_boolean("part_numbers", part_numbers)
    if part_numbers:
        _only_of(vtkABufferTransparencyPass, method, "part_numbers")
        transparency.SetPartNumbers(True)
    if error is not None:
        _only_of(vtkErrorBudgetTransparencyPass, method, "error")
        transparency.SetErrorBudget(_budget(error))
    check_boolean("error_bounds", error_bounds)
    if error_bounds:
        _only_of(vtkErrorBudgetTransparencyPass, method, "error_bounds")
        transparency.SetKeepErrorBounds(True)
    whole = vtkSeeThroughPass()
    whole.SetTranslucentPass(transparency)
    if frame_ms is not None:
        _only_of(vtkErrorBudgetTransparencyPass, method, "frame_ms")
        whole.SetErrorBudget(whole.GetLargestTimedBudget() if error is None else _budget(error))
        whole.SetFrameTime(_milliseconds(frame_ms))
    if lights is not None and lights is not False:
        whole.SetLightingPass(_known("lights", "clustered" if lights is True else lights, _LIGHTS)())
    return whole


def finite_numbers(argument: str, values: Any, count: int) -> list[float]:
    """So many finite numbers, or an exception that names the argument."""
    wanted = f"{argument} has {count} finite numbers"
    try:
        found = [float(value) for value in values]
    except (TypeError, ValueError):
        raise TypeError(f"{wanted}, not {values!r}") from None
    if len(found) != count or not all(math.isfinite(value) for value in found):
        raise ValueError(f"{wanted}, not {values!r}")
    return found


def check_boolean(argument: str, value: Any) -> None:
    if not isinstance(value, bool):
        raise TypeError(f"{argument} is True or False, not {value!r}")


def _new_method(name: str) -> Any:
    if name not in METHODS:
        raise ValueError(f"unknown method {name!r}: known are {', '.join(METHODS)}")
    return vtkTransparencyPass.NewMethod(name)


def _known(argument: str, value: Any, values: Mapping[str, Any]) -> Any:
    if not isinstance(value, str) or value not in values:
        raise ValueError(f"unknown {argument} {value!r}: known are {', '.join(values)}")
    return values[value]


def number_of_bytes(limit: SupportsIndex) -> int:
    try:
        number = operator.index(limit)
    except TypeError:
        number = None
    if number is None or isinstance(limit, bool):
        raise TypeError(f"memory_limit is a number of bytes, an int, not {limit!r}")
    if not 0 < number < 2**63:
        raise ValueError(f"memory_limit is a number of bytes above 0 and below 2**63, not {number}")
    return number


def _budget(error: Any) -> float:
    if not isinstance(error, numbers.Real) or isinstance(error, bool):
        raise TypeError(f"error is a number such as 2 / 255, not {error!r}")
    least = vtkErrorBudgetTransparencyPass.GetLeastBudget()
    if not least - 1e-9 <= error <= 1:  # 0.6 / 255 of a single precision may be a rounding below
        raise ValueError(f"error is from 0.6/255 to 1, not {error!r}: rounding to 8 bits alone makes 0.5/255")
    return max(float(error), least)


def _milliseconds(time: Any) -> float:
    if not isinstance(time, numbers.Real) or isinstance(time, bool):
        raise TypeError(f"frame_ms is a number of milliseconds such as 33, not {time!r}")
    if not (time > 0 and math.isfinite(time)):
        raise ValueError(f"frame_ms is a finite number of milliseconds above 0, not {time!r}")
    return float(time)


def _steps_and_slope(coincidence: Any) -> tuple[float, float]:
    pair = coincidence if isinstance(coincidence, (tuple, list)) else (coincidence, 0.0)
    if len(pair) != 2 or not all(
        isinstance(value, numbers.Real) and not isinstance(value, bool) for value in pair
    ):
        raise TypeError(f"coincidence is a number or a pair of numbers, not {coincidence!r}")
    try:
        steps, slope = float(pair[0]), float(pair[1])
    except OverflowError:  # an int beyond all floats
        steps = slope = math.inf
    if not (math.isfinite(steps) and math.isfinite(slope) and steps >= 0 and slope >= 0):
        raise ValueError(f"coincidence is finite and at least 0, not {coincidence!r}")
    return steps, slope


def _only_of(kind: type, method: str, option: str) -> None:
    if not isinstance(_new_method(method), kind):
        known = [name for name in METHODS if isinstance(vtkTransparencyPass.NewMethod(name), kind)]
        raise ValueError(f"{option} is no option of {method}: it is one of {', '.join(known)}")
