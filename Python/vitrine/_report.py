"""report(): the device, and what Vitrine does there, in a form to paste into a bug report."""

from __future__ import annotations

import os
import platform
import sys
from typing import Any

from vtkmodules.vtkRenderingCore import vtkRenderWindow

from . import vtkVitrineRendering
from ._build import VERSION
from ._stats import stats


def report(target: Any = None) -> str:
    """What OpenGL and VTK are here, what each method does with them, and how `target` was drawn last.

    target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter that is see-through; None leaves that part out.

    Returns a text of a few lines. It draws small frames in a window of its own, without a display where there is none.
    Raises as stats() does.
    """
    lines = [f"Vitrine: {VERSION}, Python {platform.python_version()}, {platform.platform()}"]
    window = _window()
    lines += vtkVitrineRendering.vtkDeviceReport.Describe(window).splitlines()
    window.Finalize()
    if target is not None:
        figures = vars(stats(target))
        lines.append("last frame: " + ", ".join(f"{name}={value!r}" for name, value in figures.items()))
    return "\n".join(lines)


def _window() -> vtkRenderWindow:
    headless = getattr(vtkVitrineRendering, "vtkHeadlessRenderWindow", None)
    has_display = sys.platform != "linux" or os.environ.get("DISPLAY")
    window = vtkRenderWindow() if has_display or headless is None else headless()
    window.SetOffScreenRendering(True)
    return window
