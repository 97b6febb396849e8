"""`vitrine render STATE.json`: the picture of a state, without a browser."""

from __future__ import annotations

import argparse
import pathlib
import re
import sys

from .._unpack import is_demo
from . import _state
from ._inspection import Inspection

SIZE = re.compile(r"([1-9]\d{0,4})x([1-9]\d{0,4})")


def main(arguments: list[str]) -> int:
    """Draw a state into a picture. Returns the status of the process: 2 for bad input, after one line on stderr."""
    parser = argparse.ArgumentParser(
        prog="vitrine render", description="Draw the picture of a state that the inspector has saved."
    )
    parser.add_argument("state", metavar="STATE.json")
    parser.add_argument("-o", "--output", metavar="FILE.png", required=True)
    parser.add_argument("--size", metavar="WxH", type=size, help="pixels; the state's by default")
    parser.add_argument("--transparent", action="store_true", help="leave the background transparent")
    options = parser.parse_args(arguments)
    try:
        opened(options.state).screenshot(options.output, options.size, transparent=options.transparent)
    except (ValueError, KeyError, TypeError, OSError, ImportError, RuntimeError) as error:
        print(f"vitrine render: {error.args[0] if isinstance(error, KeyError) else error}", file=sys.stderr)
        return 2
    return 0


def opened(path: str) -> Inspection:
    """An inspection that shows the state of a file. Raises as _state.read() and load() do."""
    state = _state.read(path)
    if not state["files"]:
        raise ValueError(f"{path}: the state has no files, since it was saved from Python's objects: apply() it there")
    paths = [entry["path"] for entry in state["files"]]
    missing = [path for path in paths if not is_demo(path) and not pathlib.Path(path).is_file()]
    if missing:
        raise FileNotFoundError(f"{path}: shows {missing[0]}, which is not there")
    inspection = Inspection(
        paths,
        size=state["size"],
        tolerance=state["files"][0].get("tolerance", 0.0),
    )
    inspection.apply(state)
    inspection.forget_changes()
    return inspection


def size(text: str) -> tuple[int, int]:
    """The width and height of a text such as 1280x720, as argparse's type."""
    found = SIZE.fullmatch(text)
    if not found:
        raise argparse.ArgumentTypeError(f"a size is WxH, such as 1280x720, not {text!r}")
    return int(found[1]), int(found[2])
