"""What an Inspection opens: files, an Assembly, or what a plotter shows."""

from __future__ import annotations

import os
import warnings
from typing import Any, Iterable

from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderWindow

from .._assembly import Assembly, load
from .._unpack import is_demo
from ..vtkVitrineRendering import vtkHeadlessRenderWindow


def warn_of_other_subplots(plotter: Any) -> None:
    """Say which subplot of several is inspected."""
    if len(list(plotter.renderers)) > 1:
        place = plotter.renderers.index_to_loc(plotter.renderers.active_index)
        told = ", ".join(str(int(index)) for index in (place if hasattr(place, "__len__") else [place]))
        warnings.warn(
            f"subplot ({told}) of the plotter is inspected, which is the active one: plotter.subplot() chooses another",
            stacklevel=3,
        )


def new_window() -> vtkRenderWindow:
    window = vtkHeadlessRenderWindow()
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    return window


def plain_actors(plotter: Any) -> dict[str, vtkActor]:
    """The actors of a plotter that no assembly draws, by their names."""
    named = {str(name): actor for name, actor in plotter.renderer.actors.items()}
    # Axes and labels are actors, too, but without a mapper or a property of surfaces.
    actors = {
        name: actor for name, actor in named.items() if isinstance(actor, vtkActor) and actor.GetMapper() is not None
    }
    return {name: actor for name, actor in actors.items() if not _is_of_assembly(actor)}


def _is_of_assembly(actor: vtkActor) -> bool:
    return any(
        assembly.actors.GetActor(i) is actor
        for assembly in Assembly.living()
        for i in range(assembly.actors.GetNumberOfActors())
    )


def opened(target: Any, tolerance: float) -> tuple[list[Assembly], list[dict[str, Any]]]:
    """The assemblies of a target, and the files that they come from."""
    if isinstance(target, Assembly):
        return [target], []
    if isinstance(target, (str, os.PathLike)):
        target = [target]
    if not isinstance(target, Iterable):
        raise TypeError(f"an Assembly, a path, paths or a pyvista.Plotter can be inspected, not {target!r}")
    paths = [path if is_demo(path) else os.path.abspath(path) for path in map(os.fspath, target)]
    if not paths:
        raise ValueError("there is no file to inspect")
    entry = {"tolerance": tolerance} if tolerance else {}
    assembly = load(*paths, tolerance=tolerance)
    if len(assembly) == 0:
        raise ValueError(f"{', '.join(paths)}: has no parts that can be shown")
    return [assembly], [{"path": path, **entry} for path in paths]
