"""What a call of Vitrine may be given as its target, and the renderers of it."""

from __future__ import annotations

from typing import Any

from vtkmodules.vtkCommonCore import vtkObject, vtkWeakReference
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow


def _is_plotter(target: Any) -> bool:
    return hasattr(target, "renderers") and hasattr(target, "render_window")


def _plotter_of(target: Any) -> Any:
    return target if not isinstance(target, vtkObject) and _is_plotter(target) else None


def _renderers_now(target: Any) -> list[vtkRenderer]:
    """The renderers that a target has, none if it is closed or gone."""
    if isinstance(target, vtkRenderer):
        return [target]
    if isinstance(target, vtkRenderWindow):
        collection: Any = target.GetRenderers()  # VTK's stubs do not know that it can be iterated
        return list(collection)
    is_open = target is not None and target.render_window is not None
    return list(target.renderers) if is_open else []


def _renderers_of(target: Any) -> list[vtkRenderer]:
    if not isinstance(target, (vtkRenderer, vtkRenderWindow)) and not _is_plotter(target):
        raise TypeError(
            "a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter is needed, "
            f"not {type(target).__name__}"
        )
    renderers = _renderers_now(target)
    if not renderers:
        if _plotter_of(target) is not None and target.render_window is None:
            raise RuntimeError("the plotter is closed")
        raise ValueError("the window has no renderer yet")
    return renderers


def _weak(instance: Any) -> vtkWeakReference:
    reference = vtkWeakReference()
    reference.Set(instance)
    return reference
