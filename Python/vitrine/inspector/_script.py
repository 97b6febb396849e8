"""Copy as Python: a script that draws the picture of a state with vitrine's public calls."""

from __future__ import annotations

import math
from typing import Any, Sequence

from ._state import State
from ._table import rgb


def script_of(state: State, bounds: Sequence[float]) -> str:
    """The script. bounds are those of all parts. Where the state has no files, it leaves a place for them."""
    sections = [
        _opening(state),
        _window(state),
        _looks(state["parts"]),
        _camera(state["camera"]),
        _lights(state["lights"]),
        _method(state),
        _x_ray(state),
        _cuts(state),
        _reveal(state, bounds),
        _highlight(state),
        _ending(bounds),
        _levels(state["levels"]),
    ]
    return "\n".join(line for section in sections for line in section) + "\n"


def _opening(state: State) -> list[str]:
    lines = ["import vitrine"]
    lines += ["from vtkmodules.vtkRenderingCore import vtkRenderer", "from vtkmodules.vtkIOImage import vtkPNGWriter"]
    lines += ["from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter", ""]
    if not state["files"]:
        return [*lines, "assemblies = [vitrine.load('assembly.glb')]  # the file or Assembly that was inspected"]
    paths = ", ".join(repr(entry["path"]) for entry in state["files"])
    tolerance = state["files"][0].get("tolerance")
    return [*lines, f"assemblies = [vitrine.load({paths}{f', tolerance={tolerance}' if tolerance else ''})]"]


def _window(state: State) -> list[str]:
    return [
        "window = vitrine.vtkHeadlessRenderWindow()",
        "window.SetMultiSamples(0)",
        f"window.SetSize({state['size'][0]}, {state['size'][1]})",
        "renderer = vtkRenderer()",
        f"renderer.SetBackground({_numbers(rgb(state['background']))})",
        "window.AddRenderer(renderer)",
        "for assembly in assemblies:",
        "    assembly.add_to(renderer)",
        *([f"    assembly.explode({state['explode']!r})"] if state["explode"] else []),
    ]


def _looks(looks: dict[str, Any]) -> list[str]:
    """One loop for all parts of one look."""
    groups: dict[tuple[tuple[str, Any], ...], list[str]] = {}
    for path, look in looks.items():
        groups.setdefault(tuple(sorted(look.items())), []).append(path)
    lines = []
    for look, paths in groups.items():
        lines += [f"for path in {_list(paths)}:", "    for assembly in assemblies:"]
        lines += ["        if (pattern := glob_escaped(path)) in assembly:"]
        lines += [f"            assembly[pattern].{key} = {value!r}" for key, value in look]
    if lines:
        lines = [
            "",
            "def glob_escaped(path):  # the pattern of this path alone",
            '    return "".join("\\\\" + c if c in "\\\\*?" else c for c in path)',
            "",
            *lines,
        ]
    return lines


def _camera(camera: dict[str, Any]) -> list[str]:
    return [
        "camera = renderer.GetActiveCamera()",
        f"camera.SetPosition({_numbers(camera['position'])})",
        f"camera.SetFocalPoint({_numbers(camera['focal_point'])})",
        f"camera.SetViewUp({_numbers(camera['view_up'])})",
        f"camera.SetViewAngle({camera['view_angle']!r})",
        f"camera.SetParallelScale({camera['parallel_scale']!r})",
        f"camera.SetParallelProjection({camera['parallel']!r})",
    ]


def _lights(preset: str | None) -> list[str]:
    return [f"vitrine.vtkLightPresets.Apply(renderer, {preset!r})"] if preset not in (None, "headlight") else []


def _method(state: State) -> list[str]:
    options = ""
    if state["error"] is not None:
        options += f", error={255 * state['error']!r} / 255"
    if state["coincidence"] is not None:
        options += f", coincidence=({_numbers(state['coincidence'])})"
    if state["cull"]:
        options += ", cull=True"
    return [f"vitrine.see_through(renderer, {state['method']!r}{options})"]


def _cuts(state: State) -> list[str]:
    caps = state["caps"]
    look = f"caps={caps['show']!r}, hatch={caps['hatch']!r}, edges={caps['edges']!r}, stripes={caps['stripes']!r}"
    lines = [
        f"vitrine.section(renderer, ({_numbers(plane['normal'])}), ({_numbers(plane['origin'])}), {look})"
        for plane in state["sections"]
    ]
    box = state["box"]
    if box is not None:
        lines += [
            f"vitrine.section_box(renderer, ({_numbers(box['bounds'])}), inside={box['inside']!r}, {look})"
        ]
    return lines


def _x_ray(state: State) -> list[str]:
    look = state["x_ray"]
    if look is None or not look["parts"]:
        return []
    return [
        f"paths = set({_list(look['parts'])})",
        "parts = [part for assembly in assemblies for part in assembly if part.path in paths]",
        f"vitrine.x_ray(renderer, parts, falloff={look['falloff']!r}, floor={look['floor']!r})",
    ]


def _reveal(state: State, bounds: Sequence[float]) -> list[str]:
    wanted = state["reveal"]
    if wanted is None:
        return []
    return [
        f"renderer.ResetCameraClippingRange({_numbers(bounds)})",
        "window.Render()",
        f"parts = [part for assembly in assemblies for part in assembly if part.path == {wanted['part']!r}]",
        f"vitrine.reveal(renderer, parts, {wanted['share']!r}, cutaway={wanted['cutaway']!r})",
    ]


def _highlight(state: State) -> list[str]:
    lines = []
    for key, color in (("highlight", "(0.0, 0.6, 1.0)"), ("selected", "(1.0, 0.5, 0.0)")):
        if state[key]:
            lines += [
                f"paths = set({_list(state[key])})",
                "parts = [part for assembly in assemblies for part in assembly if part.path in paths]",
                f"vitrine.highlight(renderer, parts, color={color})",
            ]
    return lines


def _ending(bounds: Sequence[float]) -> list[str]:
    return [
        f"renderer.ResetCameraClippingRange({_numbers(bounds)})",
        "window.Render()",
        "picture = vtkWindowToImageFilter()",
        "picture.SetInput(window)",
        "picture.ReadFrontBufferOff()",
        "picture.ShouldRerenderOff()",  # would round the camera's angle
        "writer = vtkPNGWriter()",
        "writer.SetInputConnection(picture.GetOutputPort())",
        'writer.SetFileName("picture.png")',
        "writer.Write()",
    ]


def _levels(pixels: float | None) -> list[str]:
    """After the picture, which shows parts as they are."""
    return [] if pixels is None else [f"vitrine.levels(renderer, pixels={pixels!r})  # while the camera moves"]


def _list(paths: list[str]) -> str:
    if len(paths) <= 3:
        return repr(paths)
    return "[\n" + "".join(f"    {path!r},\n" for path in paths) + "]"


def _numbers(values: Any) -> str:
    assert all(math.isfinite(value) for value in values)
    return ", ".join(repr(float(value)) for value in values)
