"""Pictures for the page: exact ones when still, and smaller ones, as exact in their order, while something moves."""

from __future__ import annotations

import collections
import io
import statistics
import time
from typing import TYPE_CHECKING, Any

import numpy
from PIL import Image
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from . import _output

if TYPE_CHECKING:
    from ._inspection import Inspection

_SCALES = (1.0, 0.75, 0.5, 0.35, 0.25)
_WANTED = 0.060  # seconds of a frame while something moves, which leaves time for the browser
_LITTLE = 0.85  # a smaller picture is worth it if it takes at most this share of the time
_KEPT = 5  # frames of each scale
_MEMORY = 1.0  # seconds
_QUALITY = 80


class Pictures:
    """Draws an Inspection for the page, in its thread. Nothing is drawn without being asked, so nothing queues up."""

    def __init__(self, inspection: Inspection) -> None:
        self._inspection = inspection
        self._speed = Speed()

    def moving(self) -> dict[str, Any]:
        """A picture of the state, smaller if need be, as JPEG, with its scale and the milliseconds that it took."""
        begin = time.perf_counter()
        inspection = self._inspection
        scale = self._speed.scale()
        width, height = inspection.state_now["size"]
        self._resize(max(1, round(scale * width)), max(1, round(scale * height)))
        inspection.renderer.ResetCameraClippingRange(inspection.parts.bounds())
        with inspection.shown.moving():
            inspection.window.Render()
        pixels = _output.read_pixels(inspection.window)
        inspection.forget_frame()
        data = _jpeg(pixels)
        seconds = time.perf_counter() - begin
        self._speed.note(scale, seconds)
        return {"type": "image/jpeg", "data": data, "scale": scale, "ms": 1000 * seconds, "exact": False}

    def still(self) -> dict[str, Any]:
        """The exact picture as PNG."""
        self.settle()
        self._speed.hope()
        begin = time.perf_counter()
        pixels = self._inspection.picture()
        data = _output.png(pixels, 1)
        milliseconds = 1000 * (time.perf_counter() - begin)
        return {"type": "image/png", "data": data, "scale": 1.0, "ms": milliseconds, "exact": True}

    def settle(self) -> None:
        """Give the window the size of the state, as all but moving pictures need it."""
        self._resize(*self._inspection.state_now["size"])

    def _resize(self, width: int, height: int) -> None:
        window: vtkRenderWindow = self._inspection.window
        if tuple(window.GetSize()) != (width, height):
            window.SetSize(width, height)
            self._inspection.forget_frame()


class Speed:
    """Which scale is fast enough, by the last frames of each."""

    def __init__(self) -> None:
        self._seconds: dict[float, collections.deque[float]] = {}
        self._noted: dict[float, float] = {}

    def note(self, scale: float, seconds: float) -> None:
        """Count a frame. What larger scales took a while ago is forgotten, so that they are tried again."""
        now = time.monotonic()
        self._seconds.setdefault(scale, collections.deque(maxlen=_KEPT)).append(seconds)
        self._noted[scale] = now
        for other in [each for each in self._seconds if each > scale and now - self._noted[each] > _MEMORY]:
            del self._seconds[other]

    def hope(self) -> None:
        """Forget the scales that were too slow, so that the next moves try the largest again."""
        best = self.scale()
        self._seconds = {scale: seconds for scale, seconds in self._seconds.items() if scale <= best}

    def scale(self) -> float:
        """The largest scale that is fast enough as far as is known, or else the largest that is as fast as any."""
        if not self._seconds:
            return _SCALES[0]
        expected = {scale: self._expected(scale) for scale in _SCALES}
        fast = [scale for scale, seconds in expected.items() if seconds <= _WANTED]
        fastest = min(expected.values())
        best = max(fast or [scale for scale, seconds in expected.items() if seconds * _LITTLE <= fastest])
        return self._larger(best) if fast else best

    def _larger(self, scale: float) -> float:
        """The next larger scale, if it was not tried since a scale is fast enough; or else that scale."""
        larger = [each for each in _SCALES if each > scale]
        is_sure = len(self._seconds.get(scale, ())) == _KEPT
        return min(larger) if larger and is_sure and min(larger) not in self._seconds else scale

    def _expected(self, scale: float) -> float:
        """The median of the last frames, or what the next scale gives, if the time goes with the number of pixels."""
        known = min(self._seconds, key=lambda each: (abs(each - scale), each < scale))
        return statistics.median(self._seconds[known]) * (scale / known) ** 2


def _jpeg(pixels: numpy.ndarray) -> bytes:
    stream = io.BytesIO()
    # By Pillow, since VTK's writer keeps colours at half the resolution.
    Image.fromarray(numpy.ascontiguousarray(pixels)).save(stream, "JPEG", quality=_QUALITY, subsampling=0)
    return stream.getvalue()
