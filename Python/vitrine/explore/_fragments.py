"""All fragments of a view with their light apart from their colour, so that parts can take other looks later."""

from __future__ import annotations

import contextlib
import dataclasses
from typing import Any, Iterator

import numpy

from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

from .._layers import Layers, layers_in
from .._parts import name_of, shown_assemblies
from .._reveal import update_reveal
from ..inspector._table import PartTable, rgb

STEPS = 1020  # of light, from 0 to 1: four for each step of a picture
_FIXED, _LINEAR, _GAMMA, _BENT, _PLAIN_BENT = 0, 1, 2, 3, 4
_GAMMA_OF_VTK = 2.2
_MIDDLE = "#bcbcbc"
# For fragments that are as bright as can be where their part is white.
_DARKER = ("#101010", "#202020", "#404040", "#808080")
_MOST_OFF = 0.5 / 255  # by which a model of light may miss the colours that it is checked with
_BRIGHTEST = 8.0  # of light that is kept; 1 is white


@dataclasses.dataclass
class Shade:
    """How the colour of fragments of one number follows from their light and the colour of their part.

    part is the place of the part in Fragments.parts. model is 0 if colours are fixed, 1 if they are linear in the
    part's colour, and 2 if they are so before a gamma of 2.2, as in physically based rendering, where bend is the share
    of the quadratic term that metallic parts have. It is 3 if that share differs by fragment, as middle tells, and 4 if
    then the part's colour has no gamma, as that of VTK's actors.
    is_blended tells whether fragments count as translucent even where their opacity is 1: among those of equal depth
    they are then in front of opaque ones.
    """

    part: int
    model: int
    bend: float
    is_blended: bool


@dataclasses.dataclass
class ShownPart:
    """A part: its path, its colour #RRGGBB, and its opacity, which is that of all of its fragments but where
    Fragments.alphas has others."""

    path: str
    color: str
    opacity: float


@dataclasses.dataclass
class Fragments:
    """The fragments of a view: those of a pixel are in a row, from front to back; pixels go row by row from the top.

    Arrays have a value for each fragment. shade is a place in shades. black and white are the light (RGB in STEPS) that
    a fragment shows where its part is black or white. middle is that where it is #bcbcbc, or None if no shade needs it.
    is_tied tells whether it is as deep as the one before, and depth is the depth in the window. alphas are opacities as
    shares of the part's, in 255 steps, or None if all are 1. counts has the number of fragments of each pixel.
    background is RGB in [0, 1] of the lower and the upper edge.
    """

    width: int
    height: int
    parts: list[ShownPart]
    shades: list[Shade]
    counts: numpy.ndarray
    shade: numpy.ndarray
    black: numpy.ndarray
    white: numpy.ndarray
    middle: numpy.ndarray | None
    is_tied: numpy.ndarray
    depth: numpy.ndarray
    alphas: numpy.ndarray | None
    background: tuple[tuple[float, ...], tuple[float, ...]]

    def __len__(self) -> int:
        return len(self.shade)


def take(renderer: vtkRenderer, parts: PartTable | None = None) -> Fragments:
    """Draw a view several times with other colours, and take its fragments. The renderer is as before in the end.

    Hidden parts are left out. Raises as layers_in() does, and ValueError if there are no parts.
    """
    table = parts if parts is not None else table_of(renderer)
    every = {path: table.shown_look(path) for path in table.paths}
    looks = {path: look for path, look in every.items() if look["visible"] and look["opacity"] > 0.0}
    if not looks:
        raise ValueError("nothing is shown that can be explored: no part is visible")
    unseen = [path for path, look in every.items() if look["visible"] and path not in looks]
    with _one_sample(renderer):
        fragments = _take(renderer, table, looks, unseen)
    update_reveal(renderer)
    renderer.GetRenderWindow().Render()  # so that the window shows again what it showed
    return fragments


def _take(
    renderer: vtkRenderer, table: PartTable, looks: dict[str, Any], unseen: list[str]
) -> Fragments:
    given = _layers(renderer)
    if len(given.numbers) == 0:
        raise ValueError("nothing is shown that can be explored: the camera sees no part")
    with _opaque(table, looks, unseen) as color:

        def layers_in_color(value: str) -> Layers:
            color(value)
            return _layers(renderer)

        lit = {each: layers_in_color(each) for each in ("#000000", _MIDDLE, "#ffffff")}
        return _assembled(renderer, table, looks, given, lit, layers_in_color)


@contextlib.contextmanager
def _one_sample(renderer: vtkRenderer) -> Iterator[None]:
    """Pixels have one sample while this is entered, since fragments of edges would count for several pixels."""
    window = renderer.GetRenderWindow()
    samples = window.GetMultiSamples()
    window.SetMultiSamples(0)
    try:
        yield
    finally:
        window.SetMultiSamples(samples)


def table_of(renderer: vtkRenderer) -> PartTable:
    """The parts of all that a renderer shows. Actors without a name are named by their place."""
    assemblies = shown_assemblies([renderer])
    drawn = {
        each.actors.GetActor(i) for each in assemblies for i in range(each.actors.GetNumberOfActors())
    }
    actors: dict[str, vtkActor] = {}
    for number, prop in enumerate(renderer.GetViewProps()):
        if isinstance(prop, vtkActor) and prop not in drawn:
            actors[name_of(prop) or f"actor {number}"] = prop
    return PartTable(assemblies, actors)


@contextlib.contextmanager
def _opaque(table: PartTable, looks: dict[str, Any], unseen: list[str]) -> Iterator[Any]:
    """Parts are opaque while this is entered, so that ties are in VTK's order, and unseen ones are hidden.

    It gives a function that colours all.
    """

    def look_like(path: str, look: dict[str, Any]) -> None:
        table.set_look(path, table.given_look(path), look)

    before = {path: dict(table.given_look(path)) for path in [*looks, *unseen]}
    colored = [path for path in looks if not table.has_colors(path)]
    for path in unseen:
        look_like(path, {**before[path], "visible": False})
    for path in set(looks) - set(colored):  # which a colour would take textures from
        look_like(path, {**before[path], "opacity": 1.0})

    def color(value: str) -> None:
        for path in colored:
            look_like(path, {**before[path], "opacity": 1.0, "color": value})

    try:
        yield color
    finally:
        for path, look in before.items():
            look_like(path, look)


def _layers(renderer: vtkRenderer) -> Layers:
    renderer.GetRenderWindow().Render()
    left, bottom = renderer.GetOrigin()
    width, height = renderer.GetSize()
    return layers_in(renderer, left, bottom, left + width - 1, bottom + height - 1, all=True)


def _assembled(
    renderer: vtkRenderer, table: PartTable, looks: dict[str, Any], given: Layers, lit: dict[str, Layers], draw: Any
) -> Fragments:
    """draw gives the layers of parts of another colour, which are drawn only if needed."""
    black = lit["#000000"]
    order = _rows_from_top(black)
    own, opacity = _in_order_of(black, given)
    colors = {each: _in_order_of(black, layers)[0] for each, layers in lit.items()}
    names = list(looks)
    numbers, shade = numpy.unique(black.numbers, return_inverse=True)
    models_and_bends = _models(colors, shade)
    if _is_full(colors).any() or any(model == _BENT for model, _ in models_and_bends):
        colors.update({each: _in_order_of(black, draw(each))[0] for each in _DARKER})
        models_and_bends = _models(colors, shade)
    dark, middle, light = _brightened(colors, shade, models_and_bends)
    actors = [black.actor(int(number)) for number in numbers]
    shades = [
        Shade(part, model, bend, actor is not None and bool(actor.HasTranslucentPolygonalGeometry()))
        for part, (model, bend), actor in zip(_parts_of(table, black, numbers, names), models_and_bends, actors)
    ]
    models = numpy.array([each.model for each in shades])[shade]
    dark, middle, light = (_steps(each) for each in (dark, middle, light))
    for each in (dark, light):
        each[models == _FIXED] = _steps(own)[models == _FIXED]
    has_middle = (models == _BENT) | (models == _PLAIN_BENT)
    middle[~has_middle] = 0
    parts = [_shown_part(path, looks) for path in names]
    opacities = numpy.array([part.opacity for part in parts], numpy.float32)
    alphas = _shares_of_opacity(opacity, opacities[[each.part for each in shades]][shade])
    pixel = numpy.repeat(numpy.arange(len(black.offsets) - 1), numpy.diff(black.offsets))
    tied = numpy.zeros(len(shade), bool)
    tied[1:] = (pixel[1:] == pixel[:-1]) & (black.depths[1:] == black.depths[:-1])
    return Fragments(
        width=black.width,
        height=black.height,
        parts=parts,
        shades=shades,
        counts=numpy.diff(black.offsets).reshape(black.height, black.width)[::-1].ravel(),
        shade=shade[order],
        black=dark[order],
        white=light[order],
        middle=middle[order] if has_middle.any() else None,
        is_tied=tied[order],
        depth=black.depths[order],
        alphas=alphas[order] if alphas is not None else None,
        background=_background(renderer),
    )


def _rows_from_top(layers: Layers) -> numpy.ndarray:
    """The fragments in the order of rows from the top, where layers_in() has them from below."""
    ends = layers.offsets[:: layers.width]
    rows = [numpy.arange(ends[row], ends[row + 1]) for row in reversed(range(layers.height))]
    return numpy.concatenate(rows)


def _parts_of(table: PartTable, layers: Layers, numbers: numpy.ndarray, names: list[str]) -> list[int]:
    """The place among names of the part of each number."""
    places = {path: place for place, path in enumerate(names)}
    found = []
    for number in numbers:
        actor, block = layers.actor(int(number)), layers.block(int(number))
        path = table.path_of(actor, block)
        if path not in places:
            path = path or name_of(actor) or "/others"
            places[path] = len(names)
            names.append(path)
        found.append(places[path])
    return found


def _shown_part(path: str, looks: dict[str, Any]) -> ShownPart:
    """A part by its look. What is in no table, as caps of sections, has its colours and opacities by fragment."""
    look = looks.get(path, {"color": "#ffffff", "opacity": 1.0})
    return ShownPart(path, look["color"], float(look["opacity"]))


def _in_order_of(black: Layers, other: Layers) -> tuple[numpy.ndarray, numpy.ndarray]:
    """The colours and opacities of a capture, in the order of the fragments of another, which may differ among ties."""
    keys, places = [], []
    for layers in (other, black):
        pixel = numpy.repeat(numpy.arange(len(layers.offsets) - 1), numpy.diff(layers.offsets))
        place = numpy.lexsort((layers.numbers, layers.depths, pixel))
        keys.append((pixel[place], layers.depths[place], layers.numbers[place]))
        places.append(place)
    if not all(map(numpy.array_equal, *keys)):
        raise RuntimeError("the view changes from frame to frame, so its fragments cannot be taken apart")
    order = numpy.empty(len(places[0]), numpy.int64)
    order[places[1]] = places[0]
    return other.colors[order], other.opacities[order]


def _is_full(colors: dict[str, numpy.ndarray]) -> numpy.ndarray:
    """Where light ends at 1, the most that pictures have."""
    return numpy.maximum(colors[_MIDDLE], colors["#ffffff"]) >= 1.0


def _models(colors: dict[str, numpy.ndarray], shade: numpy.ndarray) -> list[tuple[int, float]]:
    """For each number the model that tells middle colours best from those of black and white parts, and its bend.

    Fragments that are as bright as can be tell nothing.
    """
    black, middle, white = colors["#000000"], colors[_MIDDLE], colors["#ffffff"]
    tells = ~_is_full(colors).any(axis=1)
    count = int(shade.max(initial=-1)) + 1

    def most(values: numpy.ndarray) -> numpy.ndarray:
        largest = numpy.zeros(count)
        numpy.maximum.at(largest, shade[tells], numpy.abs(values[tells]).max(axis=1))
        return largest

    bends = _bends(black, middle, white, shade, count)
    misses = [
        most(lit_color(model, bend, black, white, rgb(_MIDDLE)[0]) - middle)
        for model, bend in ((_LINEAR, 0.0), (_GAMMA, bends[shade]))
    ]
    best = numpy.where(misses[0] <= misses[1], _LINEAR, _GAMMA)
    best[numpy.minimum(*misses) > _MOST_OFF] = _BENT
    if _DARKER[0] in colors:
        color, seen = rgb(_DARKER[2])[0], colors[_DARKER[2]]
        bent, plain = (
            most(lit_color(model, 0.0, black, white, color, middle) - seen) for model in (_BENT, _PLAIN_BENT)
        )
        best[(best == _BENT) & (plain < bent)] = _PLAIN_BENT
    is_colored = numpy.zeros(count, bool)
    is_colored[shade[(white - black).max(axis=1) >= 1 / 255]] = True
    best[~is_colored] = _FIXED
    bends[best != _GAMMA] = 0.0
    return list(zip(best.tolist(), bends.tolist()))


def _brightened(
    colors: dict[str, numpy.ndarray], shade: numpy.ndarray, models: list[tuple[int, float]]
) -> tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]:
    """The light where parts are black, middle and white. Pictures end at 1: more follows from darker parts."""
    black, middle, white = colors["#000000"], colors[_MIDDLE], colors["#ffffff"]
    if len(colors) == 3:
        return black, middle, white
    model, bend = (numpy.array(each)[shade][:, None] for each in zip(*models))
    middle, white = middle.copy(), white.copy()
    low, is_full = _linear(black), _is_full(colors)
    is_plain = model == _PLAIN_BENT
    between = _share_of(rgb(_MIDDLE)[0], is_plain)
    # From dark to bright, so that the brightest part tells whose fragment is not as bright as can be.
    probes = [(rgb(each)[0], colors[each]) for each in (*_DARKER, _MIDDLE)]
    for place, (color, seen) in enumerate(probes):
        tells = is_full & (seen < 1.0)
        share = _share_of(color, is_plain)
        straight = black + (seen - black) / color
        curved = low + (_linear(seen) - low) / (share * (1 - bend) + bend * share * share)
        estimate = numpy.where(model == _LINEAR, straight, curved ** (1 / _GAMMA_OF_VTK))
        at_middle = low + (curved - low) * between
        if place > 0:
            # A parabola through the light of this part, of the one before and of a black one.
            before, light = _share_of(probes[place - 1][0], is_plain), _linear(probes[place - 1][1]) - low
            square = ((_linear(seen) - low) / share - light / before) / (share - before)
            slope = light / before - square * before
            is_bent = (model == _BENT) | is_plain
            estimate = numpy.where(is_bent, numpy.maximum(low + slope + square, 0.0) ** (1 / _GAMMA_OF_VTK), estimate)
            at_middle = numpy.where(is_bent, low + slope * between + square * between * between, at_middle)
        white[tells] = estimate[tells]
        middle[tells] = numpy.maximum(at_middle, 0.0)[tells] ** (1 / _GAMMA_OF_VTK)
    return black, middle, white


def _bends(
    black: numpy.ndarray, middle: numpy.ndarray, white: numpy.ndarray, shade: numpy.ndarray, count: int
) -> numpy.ndarray:
    """The median share of the quadratic term by number, of physically based parts."""
    low, mid, high = (_linear(each[:, 0]) for each in (black, middle, white))
    color = rgb(_MIDDLE)[0] ** _GAMMA_OF_VTK
    span = high - low
    sure = (span > 0.02) & (high < 1.0)
    share = (mid - low - color * span)[sure] / (color * color - color) / span[sure]
    order = numpy.lexsort((share, shade[sure]))
    owners = shade[sure][order]
    first = numpy.searchsorted(owners, numpy.arange(count))
    number = numpy.searchsorted(owners, numpy.arange(count), side="right") - first
    bends = numpy.zeros(count)
    has = number > 0
    bends[has] = share[order][(first + number // 2)[has]]
    bends[(numpy.abs(bends) < 1e-3) | (bends < -1.0) | (bends > 0.5)] = 0.0
    return numpy.round(bends, 4)


def lit_color(
    model: int, bend: Any, black: numpy.ndarray, white: numpy.ndarray, color: Any, middle: numpy.ndarray | None = None
) -> numpy.ndarray:
    """The colour of fragments, RGB in [0, 1], by their light and a part's colour (sRGB in [0, 1]), as in compose.js."""
    if model == _FIXED:
        return black
    if model == _LINEAR:
        return black + (white - black) * color
    low, high = _linear(black), _linear(white)
    linear = numpy.asarray(color) ** _GAMMA_OF_VTK
    span = high - low
    if model in (_BENT, _PLAIN_BENT):
        between = _share_of(rgb(_MIDDLE)[0], model == _PLAIN_BENT)
        linear = _share_of(color, model == _PLAIN_BENT)
        curve = (_linear(middle) - low - between * span) / (between * between - between)
    else:
        bend = numpy.asarray(bend)
        curve = span * (bend[:, None] if bend.ndim else bend)
    return numpy.maximum(low + (span - curve) * linear + curve * linear * linear, 0.0) ** (1 / _GAMMA_OF_VTK)


def _share_of(color: float, is_plain: Any) -> numpy.ndarray:
    """What the light of bent models depends on: a part's colour, with or without a gamma."""
    return numpy.where(is_plain, color, _linear(color))


def _linear(colors: Any) -> numpy.ndarray:
    return numpy.maximum(colors, 0.0) ** _GAMMA_OF_VTK


def _steps(colors: numpy.ndarray) -> numpy.ndarray:
    return (numpy.clip(colors, 0.0, _BRIGHTEST) * STEPS).round().astype(numpy.int32)


def _shares_of_opacity(opacities: numpy.ndarray, of_parts: numpy.ndarray) -> numpy.ndarray | None:
    """Opacities of fragments as shares of those of their parts, or None if all are 1."""
    share = opacities / numpy.maximum(of_parts, 1e-6)
    if numpy.abs(share - 1.0).max() < 1 / 510:
        return None
    return (numpy.clip(share, 0.0, 1.0) * 255).round().astype(numpy.uint8)


def _background(renderer: vtkRenderer) -> tuple[tuple[float, ...], tuple[float, ...]]:
    lower = tuple(renderer.GetBackground())
    return lower, tuple(renderer.GetBackground2()) if renderer.GetGradientBackground() else lower
