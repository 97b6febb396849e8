"""Fragments as few bytes, without loss: what a page reads. decode.js has the other way."""

from __future__ import annotations

import base64
import zlib
from typing import Any

import numpy

from ._fragments import Fragments

# What a pixel's list of shades is.
SAME_AS_ABOVE, SAME_AS_LEFT, NEW = 0, 1, 2


def pack(fragments: Fragments, depths: bool = False) -> dict[str, Any]:
    """A view as an object for JSON: sizes, and columns of deflated bytes in base64.

    "kinds" tells for each pixel whether its list of shades is that above, that at the left, or a new one. New ones are
    in "counts" and "shades". "black", "white" and "middle" are what light differs by from a prediction: of the
    fragments of the same shade above, at the left and between, the median of a gradient (as lossless JPEG has it).
    Numbers have two bytes, or four of depths; all first bytes come before all second ones.
    """
    kinds = _kinds(fragments)
    neighbours = _Neighbours(fragments)
    is_new = numpy.repeat(kinds == NEW, fragments.counts)
    lights = {"black": fragments.black, "white": fragments.white, "middle": fragments.middle}
    lights = {name: light for name, light in lights.items() if light is not None}
    grey = all((light[:, :1] == light).all() for light in lights.values())
    columns = {
        "kinds": kinds.astype(numpy.uint8).tobytes(),
        "counts": _planes(fragments.counts[kinds == NEW], 2),
        "shades": _planes(fragments.shade[is_new], 2 if len(fragments.shades) <= 1 << 16 else 4),
        "ties": numpy.packbits(fragments.is_tied).tobytes(),
    }
    for name, light in lights.items():
        channels = [_planes(_folded(neighbours.differences(light[:, i])), 2) for i in range(1 if grey else 3)]
        columns[name] = b"".join(channels)
    if fragments.alphas is not None:
        columns["alphas"] = fragments.alphas.tobytes()
    if depths:
        bits = fragments.depth.astype(numpy.float32).view(numpy.int32)
        columns["depths"] = _planes(_folded(neighbours.differences(bits)), 4)
    return {
        "width": fragments.width,
        "height": fragments.height,
        "fragments": len(fragments),
        "channels": 1 if grey else 3,
        "background": [[round(255 * value, 3) for value in edge] for edge in fragments.background],
        "columns": {name: deflated(data) for name, data in columns.items()},
    }


def deflated(data: bytes) -> str:
    """Bytes as they are in a page: raw deflate in base64."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    return base64.b64encode(packer.compress(data) + packer.flush()).decode()


def _planes(values: numpy.ndarray, count: int) -> bytes:
    """All first bytes of numbers, then all second ones, and so on."""
    numbers = values.astype(numpy.uint64)
    planes = [(numbers >> numpy.uint64(8 * i)) & numpy.uint64(255) for i in range(count)]
    return b"".join(plane.astype(numpy.uint8).tobytes() for plane in planes)


def _folded(values: numpy.ndarray) -> numpy.ndarray:
    """Integers as 0, -1, 1, -2, ... are 0, 1, 2, 3, ..."""
    wide = values.astype(numpy.int64)
    return (wide << 1) ^ (wide >> 63)


def _kinds(fragments: Fragments) -> numpy.ndarray:
    """Lists are told apart by two sums, and then for certain."""
    width, height = fragments.width, fragments.height
    starts = _starts(fragments)
    pixel = _pixels(fragments)
    place = numpy.arange(len(fragments)) - starts[pixel]
    random = numpy.random.default_rng(1)
    by_shade = random.integers(1, 1 << 62, len(fragments.shades), dtype=numpy.uint64)
    by_place = random.integers(1, 1 << 62, int(fragments.counts.max(initial=0)) + 1, dtype=numpy.uint64)
    with numpy.errstate(over="ignore"):
        mixed = by_shade[fragments.shade] * (by_place[place] | numpy.uint64(1))
        mixed ^= mixed >> numpy.uint64(29)
        sums = numpy.zeros(width * height, numpy.uint64)
        numpy.add.at(sums, pixel, mixed)
    sums = sums.reshape(height, width)
    kinds = numpy.full((height, width), NEW)
    kinds[:, 1:][sums[:, 1:] == sums[:, :-1]] = SAME_AS_LEFT
    kinds[1:][sums[1:] == sums[:-1]] = SAME_AS_ABOVE
    kinds = kinds.ravel()
    _check(fragments, kinds, starts)
    return kinds


def _check(fragments: Fragments, kinds: numpy.ndarray, starts: numpy.ndarray) -> None:
    """Make lists new whose sums are equal by chance to those of other lists."""
    for kind, step in ((SAME_AS_ABOVE, fragments.width), (SAME_AS_LEFT, 1)):
        same = numpy.flatnonzero(kinds == kind)
        wrong = same[fragments.counts[same] != fragments.counts[same - step]]
        kinds[wrong] = NEW
        same = numpy.flatnonzero(kinds == kind)
        counts = fragments.counts[same]
        owner = numpy.repeat(same, counts)
        place = numpy.arange(len(owner)) - numpy.repeat(numpy.cumsum(counts) - counts, counts)
        differ = fragments.shade[starts[owner] + place] != fragments.shade[starts[owner - step] + place]
        kinds[owner[differ]] = NEW


def _starts(fragments: Fragments) -> numpy.ndarray:
    return numpy.cumsum(fragments.counts) - fragments.counts


def _pixels(fragments: Fragments) -> numpy.ndarray:
    return numpy.repeat(numpy.arange(fragments.width * fragments.height), fragments.counts)


class _Neighbours:
    """For each fragment the one of the same shade, by its turn in the list, in the pixels left, above and between."""

    def __init__(self, fragments: Fragments) -> None:
        pixel = _pixels(fragments)
        turn = _turns(pixel, fragments.shade, len(fragments.shades))
        most = int(turn.max(initial=0)) + 1
        keys = (pixel.astype(numpy.int64) * len(fragments.shades) + fragments.shade) * most + turn
        order = numpy.argsort(keys)
        ordered = keys[order]
        per_pixel = len(fragments.shades) * most
        has_left = pixel % fragments.width > 0

        def found(step: int, has: numpy.ndarray) -> numpy.ndarray:
            wanted = keys - step * per_pixel
            place = numpy.minimum(numpy.searchsorted(ordered, wanted), max(len(keys) - 1, 0))
            return numpy.where(has & (ordered[place] == wanted), order[place], -1)

        has_above = pixel >= fragments.width
        self._left = found(1, has_left)
        self._above = found(fragments.width, has_above)
        self._between = found(fragments.width + 1, has_left & has_above)

    def differences(self, values: numpy.ndarray) -> numpy.ndarray:
        """By how much values differ from predictions."""
        wide = values.astype(numpy.int64)
        left, above, between = wide[self._left], wide[self._above], wide[self._between]
        has_left, has_above, has_between = self._left >= 0, self._above >= 0, self._between >= 0
        gradient = numpy.clip(left + above - between, numpy.minimum(left, above), numpy.maximum(left, above))
        one = numpy.where(has_left, left, numpy.where(has_above, above, 0))
        return wide - numpy.where(has_left & has_above & has_between, gradient, one)


def _turns(pixel: numpy.ndarray, shade: numpy.ndarray, shades: int) -> numpy.ndarray:
    """How many fragments of the same shade are before a fragment in its list."""
    keys = pixel.astype(numpy.int64) * shades + shade
    order = numpy.argsort(keys, kind="stable")
    ordered = keys[order]
    first = numpy.ones(len(keys), bool)
    first[1:] = ordered[1:] != ordered[:-1]
    starts = numpy.flatnonzero(first)
    turns = numpy.empty(len(keys), numpy.int64)
    turns[order] = numpy.arange(len(keys)) - numpy.repeat(starts, numpy.diff(numpy.append(starts, len(keys))))
    return turns
