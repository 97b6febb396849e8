"""PyVista's plugin: `plotter.vitrine` has Vitrine's calls as methods of a plotter.

PyVista imports this by the entry point of its group pyvista.plotter_components, when somebody first asks a plotter for
`vitrine`. `import vitrine` is not needed before.
"""

from __future__ import annotations

import functools
from typing import Any, Callable, Concatenate, ParamSpec, TypeVar

import pyvista

from ._highlight import highlight
from ._layers import layers_at, layers_in, pick
from ._levels import levels
from ._reveal import reveal
from ._section import section, section_box
from ._see_through import see_through
from ._stats import error_bound, stats
from ._x_ray import x_ray
from .explore import export_explorable
from .inspector._server import inspect

_Options = ParamSpec("_Options")
_Result = TypeVar("_Result")


def _method(function: Callable[Concatenate[Any, _Options], _Result]) -> Callable[Concatenate[Any, _Options], _Result]:
    """A method of PlotterMethods that gives a function its plotter as the target."""

    @functools.wraps(function)
    def method(self: Any, *arguments: _Options.args, **options: _Options.kwargs) -> _Result:
        return function(self._plotter, *arguments, **options)

    return method


@pyvista.register_plotter_component("vitrine")
class PlotterMethods:
    """Vitrine's calls for one plotter: `plotter.vitrine.see_through()` is `vitrine.see_through(plotter)`.

    Each method takes the arguments of the call behind its `target`, which is the plotter. The parts that a call names
    may be the names that add_mesh() gave to actors.

    Examples:

    >>> import pyvista
    >>> plotter = pyvista.Plotter()
    >>> lid = plotter.add_mesh(pyvista.Sphere(), name="lid", opacity=0.5)
    >>> plotter.vitrine.see_through()
    <SeeThrough prefix-sum-predicted, 1 renderer>
    >>> plotter.vitrine.highlight("lid")
    <Highlight of 1 part>
    """

    def __init__(self, plotter: pyvista.BasePlotter) -> None:
        self._plotter = plotter

    see_through = _method(see_through)
    stats = _method(stats)
    error_bound = _method(error_bound)
    layers_at = _method(layers_at)
    layers_in = _method(layers_in)
    pick = _method(pick)
    highlight = _method(highlight)
    x_ray = _method(x_ray)
    levels = _method(levels)
    reveal = _method(reveal)
    section = _method(section)
    section_box = _method(section_box)
    inspect = _method(inspect)
    export_explorable = _method(export_explorable)
