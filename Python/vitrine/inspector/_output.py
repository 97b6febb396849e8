"""Pictures of an inspector: of the window, of any size in tiles, and videos of a turn."""

from __future__ import annotations

import dataclasses
import math
import os
import pathlib
import time
from typing import TYPE_CHECKING, Any, Iterator, Sequence

import numpy

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from . import _shown, _state, _views

if TYPE_CHECKING:
    from ._inspection import Inspection

LARGEST = 65536  # pixels a side
_TILE = 4096
_MARGIN = 16  # pixels of a tile beside those that are kept
_VIDEOS = (".mp4", ".gif", ".webp")
_FRAMES_PER_SECOND = 30


def draw(inspection: Inspection) -> None:
    """Draw what is not drawn yet. A reveal is found anew if the camera has moved."""
    state = inspection.state_now
    if inspection.drawn is state:
        return
    # By all parts, so that hiding one does not turn the order of faces elsewhere that are all but equally deep.
    inspection.renderer.ResetCameraClippingRange(inspection.parts.bounds())
    inspection.shown.update_reveal()
    begin = time.perf_counter()
    inspection.window.Render()
    inspection.window.WaitForCompletion()
    inspection.frame_ms = 1000 * (time.perf_counter() - begin)
    inspection.drawn = state


def read_pixels(window: vtkRenderWindow, alpha: bool = False) -> numpy.ndarray:
    """The last frame: bytes of RGB or RGBA, rows from the top."""
    width, height = window.GetSize()
    pixels = vtkUnsignedCharArray()
    front = 0 if window.GetDoubleBuffer() else 1
    if alpha:
        window.GetRGBACharPixelData(0, 0, width - 1, height - 1, front, pixels, 0)
    else:
        window.GetPixelData(0, 0, width - 1, height - 1, front, pixels, 0)
    return vtk_to_numpy(pixels).reshape(height, width, 4 if alpha else 3)[::-1]


def picture(inspection: Inspection, size: Sequence[int] | None, transparent: bool) -> numpy.ndarray:
    wanted = _size_of(inspection, size)
    tile = tuple(min(side, _TILE) for side in wanted)
    with _Resized(inspection, tile, transparent):
        if tile == wanted:
            draw(inspection)
            pixels = read_pixels(inspection.window, transparent).copy()
        else:
            pixels = _tiled(inspection, wanted, transparent)
    return _straight(pixels) if transparent else pixels


def _straight(pixels: numpy.ndarray) -> numpy.ndarray:
    """RGBA whose colours are not multiplied by alpha, as PNG has it, of RGBA whose colours are."""
    alpha = numpy.maximum(pixels[..., 3:].astype(numpy.float32), 1.0)
    colors = numpy.minimum(pixels[..., :3] * (255.0 / alpha), 255.0).round()
    return numpy.concatenate([colors.astype(numpy.uint8), pixels[..., 3:]], axis=2)


def _size_of(inspection: Inspection, size: Sequence[int] | None) -> tuple[int, int]:
    return size_pair(inspection.state_now["size"] if size is None else size)


def size_pair(size: Any) -> tuple[int, int]:
    """A size that a user gave as width and height. Raises ValueError."""
    if isinstance(size, str):
        raise ValueError(f"a size is a width and a height in pixels, not {size!r}")
    try:
        width, height = size
    except (TypeError, ValueError):
        raise ValueError(f"a size is a width and a height in pixels, not {size!r}") from None
    for value in (width, height):
        if isinstance(value, bool) or not isinstance(value, (int, numpy.integer)) or not 1 <= value <= LARGEST:
            raise ValueError(f"width and height are whole numbers from 1 to {LARGEST}, not {value!r}")
    return int(width), int(height)


class _Resized:
    """While it is entered, the window has a size, and a background of that transparency."""

    def __init__(self, inspection: Inspection, size: tuple[int, int], transparent: bool) -> None:
        self._inspection, self._size, self._transparent = inspection, size, transparent

    def __enter__(self) -> None:
        inspection = self._inspection
        renderer = inspection.renderer
        self._before = inspection.window.GetSize(), renderer.GetBackground(), renderer.GetBackgroundAlpha()
        if self._size != tuple(self._before[0]) or self._transparent:
            inspection.forget_frame()
        inspection.window.SetSize(*self._size)
        if self._transparent:
            inspection.window.SetAlphaBitPlanes(1)
            inspection.renderer.SetBackground(0.0, 0.0, 0.0)
            inspection.renderer.SetBackgroundAlpha(0.0)

    def __exit__(self, *_: object) -> None:
        inspection = self._inspection
        size, background, alpha = self._before
        if tuple(inspection.window.GetSize()) != tuple(size) or self._transparent:
            inspection.forget_frame()
        inspection.window.SetSize(*size)
        inspection.renderer.SetBackground(background)
        inspection.renderer.SetBackgroundAlpha(alpha)


def _tiled(inspection: Inspection, size: tuple[int, int], transparent: bool) -> numpy.ndarray:
    """A picture of tiles, each of the window's size. Their margins, at which outlines end, are cut off."""
    draw(inspection)  # finds a reveal for the whole view
    camera, window = inspection.renderer.GetActiveCamera(), inspection.window
    columns, rows = (_tiles_of(side, tile) for side, tile in zip(size, window.GetSize()))
    share = window.GetSize()[1] / size[1]  # of the picture's height in a tile
    whole = numpy.empty((size[1], size[0], 4 if transparent else 3), numpy.uint8)
    tangent = math.tan(math.radians(camera.GetViewAngle() / 2))
    camera.SetViewAngle(math.degrees(2.0 * math.atan(share * tangent)))
    camera.SetParallelScale(share * camera.GetParallelScale())
    try:
        for down in rows:
            for across in columns:
                camera.SetWindowCenter(across.center, -down.center)
                window.Render()
                whole[down.kept, across.kept] = read_pixels(window, transparent)[down.of_tile, across.of_tile]
    finally:
        camera.SetWindowCenter(0.0, 0.0)
        _shown.place_camera(camera, inspection.state_now["camera"])
        inspection.forget_frame()
    return whole


@dataclasses.dataclass(frozen=True)
class _Tile:
    """A tile along one axis, from the left or the top: pixels of the picture, and those of the tile that they are."""

    kept: slice
    of_tile: slice
    center: float  # from the picture's middle, in halves of a tile


def _tiles_of(side: int, tile: int) -> list[_Tile]:
    margin = 0 if tile >= side else _MARGIN
    tiles = []
    for first in range(0, side, tile - 2 * margin):
        end, begin = min(first + tile - 2 * margin, side), first - margin
        center = (2 * begin + tile - side) / tile
        tiles.append(_Tile(slice(first, end), slice(first - begin, end - begin), center))
    return tiles


def png(pixels: numpy.ndarray, level: int = 5) -> bytes:
    """A picture as PNG."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData

    height, width, channels = pixels.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = numpy.ascontiguousarray(pixels[::-1]).reshape(-1, channels)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=False))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetCompressionLevel(level)
    writer.WriteToMemoryOn()
    writer.Write()
    return vtk_to_numpy(writer.GetResult()).tobytes()


def screenshot(
    inspection: Inspection, path: str | os.PathLike[str], size: Sequence[int] | None, transparent: bool
) -> None:
    file = pathlib.Path(path)
    if file.suffix.lower() != ".png":
        raise ValueError(f"{file}: pictures are written as .png")
    _state.write_whole(file, png(picture(inspection, size, transparent)))


def turntable(
    inspection: Inspection, path: str | os.PathLike[str], frames: int, size: Sequence[int] | None
) -> Iterator[float]:
    """Write a video, frame by frame. Yields the share that is done. If it is closed before, no file is left."""
    file = pathlib.Path(path)
    if file.suffix.lower() not in _VIDEOS:
        raise ValueError(f"{file}: videos are written as {', '.join(_VIDEOS)}")
    if isinstance(frames, bool) or not isinstance(frames, int) or not 2 <= frames <= 10000:
        raise ValueError(f"frames is a whole number from 2 to 10000, not {frames!r}")
    writer = _video_writer()
    width, height = _size_of(inspection, size)
    before, camera = inspection.camera(), inspection.renderer.GetActiveCamera()
    with _state.unfinished(file) as begun, writer.get_writer(begun, **_settings(file.suffix.lower())) as video:
        for number in range(frames):
            try:
                _shown.place_camera(camera, _views.turned(before, 360.0 * number / frames))
                inspection.forget_frame()
                video.append_data(picture(inspection, (width - width % 2, height - height % 2), False))
            finally:  # What others do until the next step is done with the camera of the state.
                _shown.place_camera(camera, inspection.state_now["camera"])
                inspection.forget_frame()
            yield (number + 1) / frames


def _video_writer() -> Any:
    try:
        import imageio.v2
        import imageio_ffmpeg  # noqa: F401
    except ImportError:
        raise ImportError("videos need imageio: pip install 'vtk-vitrine[inspect]'") from None
    return imageio.v2


def _settings(suffix: str) -> dict[str, Any]:
    if suffix == ".mp4":
        return {"fps": _FRAMES_PER_SECOND, "quality": 9, "macro_block_size": 2}
    return {"duration": 1000 / _FRAMES_PER_SECOND, "loop": 0}
