"""Vitrine: see into large assemblies, with VTK and PyVista.

    import vitrine
    vitrine.see_through(plotter)  # or a vtkRenderer, or a vtkRenderWindow
    vitrine.stats(plotter)
    vitrine.load("machine.glb").add_to(plotter)
    print(vitrine.report())

The package has load(), from_multiblock(), see_through(), stats(), error_bound(), layers_at(), pick(), highlight(),
x_ray(), reveal(), levels(), inspect(), export_explorable(), AssemblyIndex and report(), and all classes of the VTK
module Vitrine::Rendering. VTK's own classes are in the package vtkmodules.
"""

import importlib
from typing import TYPE_CHECKING, Any

from ._build import VERSION as __version__, VTK_VERSION as _VTK_VERSION


def _load_vtk() -> None:
    """Load the VTK that this package extends, or say which one is missing."""
    needed = (
        f"vitrine needs the Python package of VTK {_VTK_VERSION}, which it was built with "
        f"(of PyPI: pip install vtk=={_VTK_VERSION}; of Debian: apt install python3-vtk9)"
    )
    try:
        import vtkmodules.vtkRenderingOpenGL2  # the base classes and their implementation
        from vtkmodules.vtkCommonCore import vtkVersion
    except ImportError as error:
        raise ImportError(f"{needed}: {error}") from error
    found = f"{vtkVersion.GetVTKMajorVersion()}.{vtkVersion.GetVTKMinorVersion()}"
    if not _VTK_VERSION.startswith(f"{found}."):
        raise ImportError(f"{needed}, and found VTK {found} at {vtkmodules.__path__[0]}")


_load_vtk()

try:  # only once VTK is known to fit
    from . import vtkVitrineRendering as _rendering
except ImportError as error:
    raise ImportError(
        f"vitrine's library is not there, or cannot be loaded: {error}. In a build tree "
        "`cmake --build` makes it"
    ) from error
from .vtkVitrineRendering import *  # noqa: E402,F401,F403
from ._assembly import Assembly, Part, Selection, from_multiblock, load  # noqa: E402
from ._highlight import Highlight, highlight  # noqa: E402
from ._index import AssemblyIndex, Clash, Crossing, Distance, Nearest, Wall  # noqa: E402
from ._layers import Layer, Layers, Picked, layers_at, layers_in, pick  # noqa: E402
from ._levels import Levels, LevelStats, levels  # noqa: E402
from ._report import report  # noqa: E402
from ._reveal import Faded, Reveal, reveal  # noqa: E402
from ._section import Section, SectionBox, section, section_box  # noqa: E402
from ._see_through import SeeThrough, see_through  # noqa: E402
from ._stats import Stats, error_bound, stats  # noqa: E402
from ._tree import Tree  # noqa: E402
from ._x_ray import XRay, x_ray  # noqa: E402

__all__ = [name for name in dir(_rendering) if name.startswith("vtk")]
__all__ += ["Assembly", "AssemblyIndex", "Clash", "Crossing", "Distance", "Faded", "Highlight", "Layer", "Layers"]
__all__ += ["Levels", "LevelStats"]
__all__ += ["Nearest", "Part", "Picked", "Reveal", "Section", "SectionBox", "SeeThrough", "Selection", "Stats"]
__all__ += ["Tree", "Wall", "XRay"]
__all__ += ["__version__", "error_bound", "export_explorable", "from_multiblock", "highlight", "inspect", "layers_at"]
__all__ += ["layers_in", "levels", "load"]
__all__ += ["pick", "report", "reveal", "section", "section_box", "see_through", "stats", "x_ray"]

if TYPE_CHECKING:
    from .explore import export_explorable as export_explorable
    from .inspector import inspect as inspect

# What needs packages that VTK does not need is loaded where somebody asks for it.
_LATER = {"export_explorable": "explore", "inspect": "inspector"}


def __getattr__(name: str) -> Any:
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    try:
        return getattr(importlib.import_module(f".{_LATER[name]}", __name__), name)
    except ModuleNotFoundError as error:
        raise ImportError(f"{name}() needs {error.name}: pip install 'vtk-vitrine[inspect]'") from error
