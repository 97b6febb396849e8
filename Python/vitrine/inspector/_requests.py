"""What a page may ask of an Inspection: each request has a name and values, and any of both may be hostile."""

from __future__ import annotations

import inspect
from typing import Any, Callable, Mapping

from . import _state
from ._inspection import Inspection

_CHANGES = (
    "hide show isolate ghost look reset select highlight explode add_section move_section remove_section set_box"
    " set_caps reveal x_ray fit view save_view remove_view go_to parallel set_lights set_background set_method"
    " set_error set_levels"
    " undo redo apply"
).split()
_ANSWERS = "pick measure figures culled error cut_parts script".split()
_OF_SELECTION = {"hide", "show", "isolate", "ghost", "look", "reset"}
_LONGEST_NAME = 200
_MOST_POINTS = 65536  # pixels


class Refused(ValueError):
    """A request that cannot be done, with what the page says about it."""


def change(inspection: Inspection, name: str, values: Any) -> None:
    """Do a change. Raises Refused, and then the state is as before."""
    try:
        call(getattr(inspection, name), _with_parts(inspection, name, _checked(values)))
    except Refused:
        inspection.forget_frame()  # what was tried has changed what the window shows
        raise


def answer(inspection: Inspection, name: str, values: Any) -> Any:
    """Answer a question about the state. Raises Refused."""
    return call(getattr(inspection, name), _checked(values))


def is_change(name: Any) -> bool:
    return name in _CHANGES


def is_answer(name: Any) -> bool:
    return name in _ANSWERS


def apply_text(inspection: Inspection, text: Any) -> None:
    """Take the state of a JSON text that the page has read from a file. Raises Refused."""
    if not isinstance(text, str) or len(text) > _state.LARGEST_FILE:
        raise Refused(f"a state is a text of at most {_state.LARGEST_FILE >> 20} MiB")
    call(inspection.apply, {"state": _refusing(_state.parse, text)})


def pixel(inspection: Inspection, x: Any, y: Any) -> tuple[int, int]:
    """A pixel of the picture. Raises Refused for one outside."""
    width, height = inspection.state_now["size"]
    for value, most in ((x, width), (y, height)):
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < most:
            raise Refused(f"the picture has {width} x {height} pixels, and {value!r} is outside")
    return x, y


def pixels(value: Any) -> int:
    """A width or a height. Raises Refused."""
    if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= _MOST_POINTS:
        raise Refused(f"a picture has 1 to {_MOST_POINTS} pixels a side, not {value!r}")
    return value


def _checked(values: Any) -> dict[str, Any]:
    if values is None:
        return {}
    if not isinstance(values, Mapping) or not all(isinstance(key, str) for key in values):
        raise Refused("a request has values with names")
    return dict(values)


def _with_parts(inspection: Inspection, name: str, values: dict[str, Any]) -> dict[str, Any]:
    """Values in which "selected" and "all" are the paths that they stand for."""
    wanted = values.get("parts", "selected" if name in _OF_SELECTION else None)
    if wanted == "all":
        return {**values, "parts": list(inspection.parts.paths)}
    if wanted == "selected":
        selected = inspection.state_now["selected"]
        if not selected:
            raise Refused("select parts first, in the tree or in the view")
        return {**values, "parts": list(selected)}
    if name in ("save_view", "remove_view") and len(str(values.get("name", ""))) > _LONGEST_NAME:
        raise Refused(f"a name has at most {_LONGEST_NAME} characters")
    return values


def call(function: Callable[..., Any], values: dict[str, Any]) -> Any:
    try:
        inspect.signature(function).bind(**values)
    except TypeError as error:
        raise Refused(f"{function.__name__}: {error}") from None
    return _refusing(function, **values)


def _refusing(function: Callable[..., Any], *arguments: Any, **values: Any) -> Any:
    try:
        return function(*arguments, **values)
    except InterruptedError:
        raise
    except KeyError as error:
        raise Refused(str(error.args[0]) if error.args else "unknown") from None
    except (ValueError, TypeError, AttributeError, ArithmeticError, LookupError) as error:
        raise Refused(str(error)) from None
    except (OSError, ImportError, RuntimeError, MemoryError, RecursionError) as error:
        raise Refused(f"{function.__name__}: {error}") from None
