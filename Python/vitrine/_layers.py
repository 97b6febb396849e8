"""What lies under pixels: layers_at() and layers_in() tell all layers, pick() the part that a click gives."""

from __future__ import annotations

import dataclasses
import math
import numbers
import operator
from typing import Any

from vtkmodules.vtkRenderingCore import vtkRenderer

from ._assembly import Part
from ._options import check_boolean
from ._parts import name_of, part_of
from ._target import _renderers_of
from .vtkVitrineRendering import vtkLayerPicker


@dataclasses.dataclass(frozen=True)
class Layer:
    """A place where a surface covers a pixel.

    part is the Part of an Assembly, or None where no assembly draws it. actor is the prop that draws it, None if it is
    gone. block is the flat index of its block in composite data, and 0 for others. cell is the id of the cell in the
    data of the block or the actor; it is None if it was not asked for, or if the ray through the pixel's centre meets
    none.

    depth is the depth in the window, from 0 to 1. position is the place in world coordinates. distance is the way from
    the eye, in units of the world; in parallel projection it is the way from the near plane. color is the lit colour,
    RGB in [0, 1], not multiplied by opacity. share is the part of the picture's light that the layer has: its opacity
    by what the layers in front let through. front tells whether it is a front face, and opaque whether it ends the
    view.
    """

    part: Part | None
    actor: Any
    block: int
    cell: int | None
    depth: float
    position: tuple[float, float, float]
    distance: float
    color: tuple[float, float, float]
    opacity: float
    share: float
    front: bool
    opaque: bool

    @property
    def name(self) -> str:
        """The name of the part, or else of the block or the one that PyVista gave to the actor; empty without these."""
        return self.part.name if self.part is not None else name_of(self.actor, self.block)


@dataclasses.dataclass(frozen=True)
class Picked:
    """A part that pick() found: its first layer, and the share of the picture that all of its layers have."""

    layer: Layer
    share: float

    @property
    def part(self) -> Part | None:
        return self.layer.part

    @property
    def actor(self) -> Any:
        return self.layer.actor

    @property
    def block(self) -> int:
        return self.layer.block

    @property
    def name(self) -> str:
        return self.layer.name


class Layers:
    """The layers of a rectangle of pixels, as numpy arrays.

    width and height are those of the rectangle. The layers of pixel x, y, counted from its lower left corner, are those
    from offsets[y * width + x] up to the next offset, from front to back. numbers, opacities, depths and shares have a
    value for each layer: the number of its part, its opacity, its depth in the window, and its share of the picture.
    colors has RGB for each layer, as Layer.color.
    part(number), actor(number) and block(number) tell what a number stands for.
    """

    def __init__(self, renderer: vtkRenderer, picker: vtkLayerPicker, width: int, height: int) -> None:
        from vtkmodules.util.numpy_support import vtk_to_numpy

        self.width = width
        self.height = height
        self.offsets = vtk_to_numpy(picker.GetOffsets()).copy()
        self.numbers = vtk_to_numpy(picker.GetPartNumbers()).copy()
        self.opacities = vtk_to_numpy(picker.GetOpacities()).copy()
        self.depths = vtk_to_numpy(picker.GetWindowDepths()).copy()
        self.shares = vtk_to_numpy(picker.GetShares()).copy()
        self.colors = vtk_to_numpy(picker.GetColors()).copy()
        self._picker = picker

    def actor(self, number: int) -> Any:
        """The prop of a number, or None if it is gone, or if there is no such number."""
        return self._picker.GetPropOfPart(index) if (index := _part_number(number)) is not None else None

    def block(self, number: int) -> int:
        """The flat index of the block of a number, 0 for props without blocks."""
        return self._picker.GetBlockOfPart(index) if (index := _part_number(number)) is not None else 0

    def part(self, number: int) -> Part | None:
        """The part of an assembly that a number stands for, or None."""
        return part_of(self.actor(number), self.block(number))

    def __repr__(self) -> str:
        return f"<Layers of {self.width}x{self.height} pixels, {len(self.numbers)} in all>"


def layers_at(target: Any, x: int, y: int, *, all: bool = False, cells: bool = False) -> list[Layer]:
    """All layers of a pixel in the last frame of `target`, from front to back, down to the nearest opaque one.

    Args:
        target: a vtkRenderer, a vtkRenderWindow or a pyvista.Plotter. Of several renderers, that counts whose viewport
            has the pixel; of those, the one of the topmost layer.
        x, y: the pixel, in whole numbers from the window's lower left corner, as VTK's events tell it.
        all: whether layers behind the nearest opaque one are told, too. They have the share 0.
        cells: whether the cell of each layer is searched, on the CPU.

    The target need not be see-through. Where see_through() was called with part_numbers, translucent layers come from
    the lists of the frame. Else the props under the pixel are drawn once more, unseen.

    Raises:
        TypeError: the target is of another kind, or x or y is no whole number.
        ValueError: the pixel is outside of the window, or in no viewport.
        RuntimeError: the plotter is closed, there is no frame yet, or the driver lacks OpenGL 4.3.
    """
    check_boolean("all", all)
    check_boolean("cells", cells)
    renderer, place = _renderer_at(target, x, y)
    picker = _pick(renderer, (*place, *place), behind=all)
    return [_layer(picker, i, cells) for i in range(picker.GetNumberOfLayers())]


def layers_in(
    target: Any, x0: int, y0: int, x1: int, y1: int, *, all: bool = False, opaque: bool = True
) -> Layers:
    """The layers of all pixels of a rectangle of one viewport, as numpy arrays. Both corners belong to it.

    Args:
        target: as that of layers_at(). The lower left pixel tells the renderer.
        x0, y0, x1, y1: the lower left and the upper right pixel.
        all: as that of layers_at().
        opaque: whether opaque layers are told, too. Without, nothing is drawn where lists have part numbers.

    Raises as layers_at() does.
    """
    check_boolean("all", all)
    check_boolean("opaque", opaque)
    renderer, first = _renderer_at(target, x0, y0)
    last = (_whole("x1", x1), _whole("y1", y1))
    if last[0] < first[0] or last[1] < first[1]:
        raise ValueError(f"the upper right pixel {last} is left of or below {first}")
    picker = _pick(renderer, (*first, *last), behind=all, opaque=opaque, own=True)
    return Layers(renderer, picker, last[0] - first[0] + 1, last[1] - first[1] + 1)


def pick(target: Any, x: int, y: int, *, through: float = 0.5) -> Picked | None:
    """The part that a click on a pixel gives: the first one from the front that has at least a share of the picture.

    Args:
        target, x, y: as those of layers_at().
        through: the share that a part needs, above 0 and up to 1. All layers of a part count. A faint part is passed
            through to what is seen behind it.

    Returns None if no part has as much, as on the background.

    Raises as layers_at() does, and ValueError for a share out of range.
    """
    if isinstance(through, bool) or not isinstance(through, numbers.Real):
        raise TypeError(f"through is a number above 0 and up to 1, not {through!r}")
    if not 0.0 < through <= 1.0:
        raise ValueError(f"through is a number above 0 and up to 1, not {through!r}")
    renderer, place = _renderer_at(target, x, y)
    picker = _pick(renderer, (*place, *place))
    found = picker.PickThrough(float(through))
    if found < 0:
        return None
    number = picker.GetPartNumbers().GetValue(found)
    share = sum(
        picker.GetShare(i)
        for i in range(picker.GetNumberOfLayers())
        if picker.GetPartNumbers().GetValue(i) == number
    )
    return Picked(_layer(picker, found, False), share)


# Pickers by the address of their renderer, so that programs are compiled once.
_pickers: dict[str, vtkLayerPicker] = {}


def _picker_of(renderer: vtkRenderer) -> vtkLayerPicker:
    for address, picker in list(_pickers.items()):
        if picker.GetRenderer() is None:
            del _pickers[address]
    picker = _pickers.setdefault(renderer.__this__, vtkLayerPicker())
    picker.SetRenderer(renderer)
    return picker


def _pick(
    renderer: vtkRenderer,
    area: tuple[int, int, int, int],
    behind: bool = False,
    opaque: bool = True,
    own: bool = False,
) -> vtkLayerPicker:
    if own:
        picker = vtkLayerPicker()
        picker.SetRenderer(renderer)
    else:
        picker = _picker_of(renderer)
    picker.SetArea(*area)
    picker.SetBehindOpaque(behind)
    picker.SetOpaqueLayers(opaque)
    if not picker.Pick():
        problem = picker.GetProblem()
        raise (ValueError if "not within" in problem else RuntimeError)(problem)
    return picker


def _layer(picker: vtkLayerPicker, i: int, cells: bool) -> Layer:
    actor, block = picker.GetProp(i), picker.GetBlock(i)
    cell = picker.GetCellId(i) if cells else -1
    return Layer(
        part=part_of(actor, block),
        actor=actor,
        block=block,
        cell=cell if cell >= 0 else None,
        depth=picker.GetWindowDepth(i),
        position=tuple(picker.GetWorldPosition(i)),  # type: ignore[arg-type]
        distance=picker.GetDistance(i),
        color=tuple(picker.GetColor(i)),  # type: ignore[arg-type]
        opacity=picker.GetOpacity(i),
        share=picker.GetShare(i),
        front=picker.GetFrontFace(i),
        opaque=picker.GetOpaque(i),
    )


def _part_number(number: Any) -> int | None:
    """The number of a part, or None if no part can have it."""
    if isinstance(number, bool) or not hasattr(number, "__index__"):
        raise TypeError(f"the number of a part is one of Layers.numbers, not {number!r}")
    index = operator.index(number)
    return index if 0 <= index < 2**32 else None


def _whole(name: str, value: Any) -> int:
    """A whole number, which may be a float or of numpy."""
    if isinstance(value, bool) or not isinstance(value, (numbers.Real, numbers.Integral)):
        try:
            return operator.index(value)
        except TypeError:
            raise TypeError(f"{name} is a whole number of pixels, not {value!r}") from None
    if not math.isfinite(value) or value != math.floor(value):
        raise ValueError(f"{name} is a whole number of pixels, not {value!r}")
    return int(value)


def _renderer_at(target: Any, x: Any, y: Any) -> tuple[vtkRenderer, tuple[int, int]]:
    """The renderer whose viewport has a pixel, the topmost if there are several, and the pixel."""
    place = (_whole("x", x), _whole("y", y))
    renderers = _renderers_of(target)
    found = [renderer for renderer in renderers if _has_pixel(renderer, *place)]
    drawn = [renderer for renderer in found if renderer.GetDraw()]
    if not drawn:
        window = renderers[0].GetRenderWindow()
        size = "x".join(map(str, window.GetSize())) if window is not None else "no window"
        raise ValueError(f"pixel {place} is in no viewport of the target ({size} pixels)")
    return max(drawn, key=lambda renderer: renderer.GetLayer()), place


def _has_pixel(renderer: vtkRenderer, x: int, y: int) -> bool:
    if renderer.GetRenderWindow() is None:
        return True  # the picker tells that it is in no window
    width, height = renderer.GetSize()
    left, bottom = renderer.GetOrigin()
    return left <= x < left + width and bottom <= y < bottom + height
