"""The command `vitrine explore`."""

from __future__ import annotations

import argparse
import pathlib
import sys
from typing import Any

from vtkmodules.vtkRenderingCore import vtkCamera

from ..inspector import Inspection, _render, _shown, _views
from ._export import export_explorable

_STANDARD = ("iso", "front", "back", "left", "right", "top", "bottom")
_MOST_VIEWS = 360


def main(arguments: list[str]) -> int:
    """Write an explorable picture. Returns the status of the process: 2 for bad input, after one line on stderr."""
    parser = argparse.ArgumentParser(
        prog="vitrine explore",
        description="Write a picture that a browser can take apart: hide parts, see through them, pick them.",
    )
    parser.add_argument("inputs", metavar="INPUT", nargs="+", help="files of an assembly, or a state of the inspector")
    parser.add_argument("-o", "--output", metavar="PAGE.html", required=True)
    parser.add_argument("--size", metavar="WxH", type=_render.size, help="pixels; 1280x720, or the state's, by default")
    parser.add_argument("--views", metavar="V", type=_view_names, help="standard, or turntable,N: N views of a turn")
    parser.add_argument("--depths", action="store_true", help="keep the depth of each fragment")
    parser.add_argument("--exr", metavar="FILE.exr", help="write the fragments as deep OpenEXR, too")
    options = parser.parse_args(arguments)
    try:
        _explore(options)
    except (ValueError, KeyError, TypeError, OSError, ImportError, RuntimeError) as error:
        print(f"vitrine explore: {error.args[0] if isinstance(error, KeyError) else error}", file=sys.stderr)
        return 2
    return 0


def _explore(options: argparse.Namespace) -> None:
    output = pathlib.Path(options.output)
    if output.suffix.lower() not in (".html", ".htm"):
        raise ValueError(f"{output}: explorable pictures are written as .html")
    inspection = _opened(options)
    views = options.views(inspection) if options.views is not None else None
    title = pathlib.Path(inspection.state_now["files"][0]["path"]).name
    export_explorable(
        inspection.renderer, output, depths=options.depths, views=views, title=title, exr=options.exr
    )


def _opened(options: argparse.Namespace) -> Inspection:
    if options.inputs[0].lower().endswith(".json"):
        if len(options.inputs) > 1:
            raise ValueError("give one state, or files of assemblies")
        inspection = _render.opened(options.inputs[0])
        if options.size is not None:
            inspection.set_size(*options.size)
    else:
        inspection = Inspection(options.inputs, size=options.size or (1280, 720))
    inspection.draw()
    return inspection


def _view_names(text: str) -> Any:
    """What makes the cameras of --views, by name."""
    kind, _, count = text.partition(",")
    if kind == "standard" and not count:
        return lambda inspection: {
            name: _camera(_views.looking_from(inspection.renderer, name, _views.shown_bounds(inspection.renderer)))
            for name in _STANDARD
        }
    if kind == "turntable" and count.isdecimal() and 2 <= int(count) <= _MOST_VIEWS:
        steps = [360.0 * number / int(count) for number in range(int(count))]
        return lambda inspection: {
            f"{degrees:g}°": _camera(_views.turned(inspection.camera(), degrees)) for degrees in steps
        }
    raise argparse.ArgumentTypeError(f"views are standard or turntable,N, with N from 2 to {_MOST_VIEWS}, not {text!r}")


def _camera(place: dict[str, Any]) -> vtkCamera:
    camera = vtkCamera()
    _shown.place_camera(camera, place)
    return camera


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
