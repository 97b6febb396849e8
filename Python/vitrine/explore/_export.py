"""Explorable pictures: one HTML file with all fragments of views, which any browser shows without a network."""

from __future__ import annotations

import json
import os
import pathlib
from typing import Any, Iterable, Mapping

from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

from .._target import _renderers_of
from ..inspector._state import write_whole
from ..inspector._table import PartTable
from . import _fragments, _pack
from ._exr import write_exr
from ._fragments import Fragments, ShownPart

_SCRIPTS = ("decode.js", "compose.js", "page.js")


def export_explorable(
    target: Any,
    path: str | os.PathLike[str],
    *,
    depths: bool = False,
    views: Mapping[str, vtkCamera] | None = None,
    title: str | None = None,
    exr: str | os.PathLike[str] | None = None,
) -> None:
    """Write what `target` shows as a picture that a browser can take apart: one HTML file that needs no network.

    The file has all fragments of the view, also those that opaque parts hide, with the light of each apart from the
    colour of its part. On the page parts can be hidden, made faint, coloured, searched, and picked through layers. It
    has no mesh. Parts that are hidden are not in it.

    Args:
        target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter. Of several renderers, the first counts.
        path: the file, which is replaced.
        depths: whether the depth of each fragment is kept, with which points could be measured. This takes more bytes
            than all else.
        views: cameras by name, for several views in one file. None stands for the view as it is.
        title: the title of the page. None stands for the name of the file.
        exr: a file .exr for the same fragments as a deep picture, for programs that put pictures together. It has the
            channels R, G, B (multiplied by opacity), A, Z (the distance along the view) and id, and the paths of parts
            in the attribute idmanifest. Colours are those of the picture, not of linear light.

    Raises:
        TypeError: the target is of another kind.
        ValueError: no part is visible; or there are both exr and views, as a deep picture has one view.
        ImportError: exr without the package OpenEXR.
        RuntimeError: the plotter is closed, or the driver lacks OpenGL 4.3.
        OSError: the file cannot be written.
    """
    if views is not None and not isinstance(views, Mapping):
        raise TypeError(f"views are cameras by name, not {views!r}")
    if exr is not None and views is not None:
        raise ValueError("a deep picture has one view: leave out exr or views")
    renderer = _renderers_of(target)[0]
    table = _fragments.table_of(renderer)
    name = title if title is not None else pathlib.Path(path).stem
    taken = {key: taken for key, taken in _views(renderer, table, views)}
    if exr is not None:
        write_exr(exr, *taken.values(), renderer)
    write_whole(path, page_of(taken, name, depths).encode())


def _views(
    renderer: vtkRenderer, table: PartTable, views: Mapping[str, vtkCamera] | None
) -> Iterable[tuple[str, Fragments]]:
    if views is None:
        renderer.GetRenderWindow().Render()
        yield "view", _fragments.take(renderer, table)
        return
    if not views:
        raise ValueError("views is empty: leave it out for the view as it is")
    before = renderer.GetActiveCamera()
    try:
        for key, camera in views.items():
            renderer.SetActiveCamera(camera)
            renderer.ResetCameraClippingRange()
            yield key, _fragments.take(renderer, table)
    finally:
        renderer.SetActiveCamera(before)
        renderer.ResetCameraClippingRange()


def page_of(views: Mapping[str, Fragments], title: str, depths: bool) -> str:
    """The text of the page."""
    parts: dict[str, ShownPart] = {}
    for fragments in views.values():
        parts.update({part.path: part for part in fragments.parts if part.path not in parts})
    places = {path: place for place, path in enumerate(parts)}
    data = {
        "title": title,
        "parts": _pack.deflated(_listed(parts.values())),
        "views": [_view(name, fragments, places, depths) for name, fragments in views.items()],
    }
    return _filled(_text("page.html"), data, title)


def _listed(parts: Iterable[ShownPart]) -> bytes:
    return json.dumps([[part.path, part.color, part.opacity] for part in parts]).encode()


def _view(name: str, fragments: Fragments, places: Mapping[str, int], depths: bool) -> dict[str, Any]:
    shades = [
        [places[fragments.parts[each.part].path], each.model, each.bend, int(each.is_blended)]
        for each in fragments.shades
    ]
    return {"name": name, "shades": shades, **_pack.pack(fragments, depths)}


def _filled(page: str, data: Any, title: str) -> str:
    texts = {
        "title": title.replace("&", "&amp;").replace("<", "&lt;"),
        "style": _text("page.css"),
        "script": "".join(_text(name) for name in _SCRIPTS),
        # In a script only "</" and "<!--" end or change anything.
        "data": json.dumps(data, separators=(",", ":"), ensure_ascii=True).replace("<", "\\u003c"),
    }
    pieces = page.split("{{")
    filled = [pieces[0]]
    for piece in pieces[1:]:
        name, rest = piece.split("}}", 1)
        filled += [texts[name], rest]
    return "".join(filled)


def _text(name: str) -> str:
    return pathlib.Path(__file__).with_name(name).read_text(encoding="utf-8")
