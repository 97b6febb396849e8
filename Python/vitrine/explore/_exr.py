"""Deep OpenEXR: all layers of each pixel with their part, for programs that put pictures together."""

from __future__ import annotations

import io
import os
import pathlib
from typing import Any

import numpy

from vtkmodules.vtkRenderingCore import vtkRenderer

from ..inspector._state import write_whole
from ..inspector._table import rgb
from ._fragments import STEPS, Fragments, lit_color


def write_exr(path: str | os.PathLike[str], fragments: Fragments, renderer: vtkRenderer) -> None:
    """Write fragments as a deep picture, which flattens to the picture that they make before a black background.

    The channels are R, G, B and A as 16 bit floats, the first three multiplied by opacity; Z as a 32 bit float, the
    distance from the eye along the view in units of the world; and id as a whole number of 32 bits, the place of the
    part in fragments.parts. The attribute idmanifest has the paths of the parts. Colours are those of the picture,
    without a change to linear light. Of a pixel's fragments with equal depths, each one's Z is the next number after
    that of the one before, in the order in which Vitrine composites them.

    Args:
        path: a file that ends in .exr.
        fragments: what take() gave.
        renderer: the one that they were taken of. Its camera tells Z.

    Raises ValueError for a file of another kind, ImportError without the package OpenEXR, and OSError.
    """
    file = pathlib.Path(path)
    if file.suffix.lower() != ".exr":
        raise ValueError(f"{file}: deep pictures are written as .exr")
    exr = _library()
    colors, opacities = colors_of(fragments), opacities_of(fragments)
    order = _as_drawn(fragments, colors, opacities)
    premultiplied = (colors * opacities[:, None])[order].astype(numpy.float16)
    values = {
        **dict(zip("RGB", premultiplied.T.copy())),  # the library takes what lies in a row
        "A": opacities[order].astype(numpy.float16),
        "Z": _growing(_distances(fragments.depth, renderer), fragments.counts),
        "id": parts_of(fragments)[order].astype(numpy.uint32),
    }
    channels = {name: exr.Channel(_deep(column, fragments)) for name, column in values.items()}
    header = {
        "type": exr.deepscanline,
        "compression": exr.ZIPS_COMPRESSION,
        "idmanifest": _manifest(exr, fragments),
    }
    written = io.BytesIO()
    exr.File(header, channels).write(written)
    write_whole(file, written.getvalue())


def parts_of(fragments: Fragments) -> numpy.ndarray:
    """The place of the part of each fragment."""
    return numpy.array([shade.part for shade in fragments.shades])[fragments.shade]


def opacities_of(fragments: Fragments) -> numpy.ndarray:
    """The opacity of each fragment with the present looks of the parts."""
    opacity = numpy.array([part.opacity for part in fragments.parts], numpy.float32)[parts_of(fragments)]
    return opacity if fragments.alphas is None else opacity * (fragments.alphas / numpy.float32(255))


def colors_of(fragments: Fragments) -> numpy.ndarray:
    """The lit colour of each fragment with the present looks of the parts, RGB in [0, 1]."""
    own = numpy.array([rgb(part.color) for part in fragments.parts])[parts_of(fragments)]
    black, white, middle = (
        each / STEPS if each is not None else None for each in (fragments.black, fragments.white, fragments.middle)
    )
    model = numpy.array([shade.model for shade in fragments.shades])[fragments.shade]
    bend = numpy.array([shade.bend for shade in fragments.shades])[fragments.shade]
    colors = numpy.empty(black.shape)
    for each in numpy.unique(model):
        are = model == each
        between = middle[are] if middle is not None else None
        colors[are] = lit_color(int(each), bend[are], black[are], white[are], own[are], between)
    return colors.clip(0.0, 1.0)


def _library() -> Any:
    try:
        import OpenEXR
    except ImportError:
        OpenEXR = None
    if not hasattr(OpenEXR, "IDManifest"):
        raise ImportError("deep pictures need the package OpenEXR, 3.5 or later: pip install 'vtk-vitrine[exr]'")
    return OpenEXR


def _as_drawn(fragments: Fragments, colors: numpy.ndarray, opacities: numpy.ndarray) -> numpy.ndarray:
    """The order in which Vitrine composites: translucent ones of equal depth by their packed colours, then opaque ones
    as they come."""
    is_blended = numpy.array([shade.is_blended for shade in fragments.shades])[fragments.shade]
    is_opaque = (opacities >= 1.0) & ~is_blended
    moved = numpy.clip(opacities, 0, 1).astype(numpy.float32) + numpy.float32(1 / 32768)  # as in FineColor.glsl
    alphas = (moved.view(numpy.int32) - (0x38000000 - 0x400)) >> 11
    steps = numpy.clip(colors, 0, 1).astype(numpy.float32) * numpy.float32(51840)
    fine = numpy.column_stack([(steps + numpy.float32(0.5)).astype(numpy.int32), alphas])
    coarse = numpy.column_stack([(fine[:, :3] + 64) >> 7, (alphas + 8) >> 4])
    packed = numpy.column_stack([fine, coarse])
    packed[is_opaque] = 0
    run = numpy.cumsum(~fragments.is_tied)
    return numpy.lexsort((*packed.T, is_opaque, run))


def _distances(depths: numpy.ndarray, renderer: vtkRenderer) -> numpy.ndarray:
    """Distances from the eye along the view, of depths in the window."""
    matrix = renderer.GetActiveCamera().GetProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1.0, 1.0)
    zz, zw, wz, ww = (matrix.GetElement(row, column) for row in (2, 3) for column in (2, 3))
    device = 2.0 * depths.astype(numpy.float64) - 1.0
    return -(device * ww - zw) / (zz - device * wz)


def _growing(distances: numpy.ndarray, counts: numpy.ndarray) -> numpy.ndarray:
    """Distances as 32 bit floats that grow from fragment to fragment of each pixel, changed as little as can be."""
    bits = distances.astype(numpy.float32).view(numpy.int32).astype(numpy.int64)
    steps = numpy.where(bits < 0, -(bits & 0x7FFFFFFF), bits)  # of neighbouring floats they differ by one
    place = numpy.arange(len(steps)) - numpy.repeat(numpy.cumsum(counts) - counts, counts)
    # A running maximum of all pixels at once: the values of each pixel lie above those of all pixels before.
    floor = numpy.repeat(numpy.arange(len(counts)), counts) << 33
    steps = numpy.maximum.accumulate(steps - place + floor) - floor + place
    bits = numpy.where(steps < 0, -steps - 2**31, steps)
    return bits.astype(numpy.int32).view(numpy.float32)


def _deep(values: numpy.ndarray, fragments: Fragments) -> numpy.ndarray:
    """Pixels as OpenEXR takes them: the values of each as an array, None where there are none."""
    ends = numpy.cumsum(fragments.counts).tolist()
    pixels = numpy.empty(len(ends), dtype=object)
    pixels[:] = [values[first:end] if end > first else None for first, end in zip([0, *ends], ends)]
    return pixels.reshape(fragments.height, fragments.width)


def _manifest(exr: Any, fragments: Fragments) -> Any:
    """What the numbers of the channel id stand for, as OpenEXR's deep ids have it."""
    group = exr.ChannelGroupManifest()
    group.setChannels({"id"})
    group.setComponents(["path"])
    group.setLifetime(exr.LIFETIME_STABLE)
    group.setHashScheme(exr.ID_MANIFEST_NOTHASHED)
    group.setEncodingScheme(exr.ID_MANIFEST_ID_SCHEME)
    for number, part in enumerate(fragments.parts):
        group.insert(number, [part.path])
    manifest = exr.IDManifest()
    manifest.add(group)
    return manifest
