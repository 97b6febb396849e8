"""Long work of the inspector's page: it tells how far it is, and can be stopped."""

from __future__ import annotations

import asyncio
import pathlib
import tempfile
import threading
from typing import Any, Callable, Coroutine, Iterator

from ..explore import export_explorable
from . import _output, _requests, _state
from ._session import Session
from ._worker import Worker

_MOST_CLASHES = 500
_MOST_FRAMES = 1000
_MOST_SIDE = 16384
_STEPWISE = {"chart", "turntable", "save_state"}
_TITLES = {
    "chart": "Measuring all methods",
    "clashes": "Looking for clashes",
    "heat_map": "Counting layers",
    "screenshot": "Drawing the picture",
    "turntable": "Drawing the turntable",
    "save_state": "Saving the state",
    "explorable": "Taking the picture apart",
}


class Jobs:
    """Runs one job at a time in the worker, step by step, so that pictures and requests pass in between."""

    def __init__(self, worker: Worker, show_progress: Callable[[dict[str, Any] | None], None]) -> None:
        self._worker, self._show_progress = worker, show_progress
        self._running: str | None = None
        self._stopped = threading.Event()

    def knows(self, name: str) -> bool:
        return name in _TITLES

    def stop(self) -> None:
        """Have the job that runs end with InterruptedError at its next step."""
        self._stopped.set()

    def view_changed(self) -> None:
        """A chart is of one view, so that it ends with the view."""
        if self._running == "chart":
            self.stop()

    @property
    def blocks(self) -> bool:
        """Whether a job runs during which the worker has no time for pictures."""
        return self._running is not None and self._running not in _STEPWISE

    def refuse(self) -> None:
        """Raise Refused, since a job runs."""
        raise _requests.Refused(f"{_TITLES[self._running or '']} is not done yet: stop it first")

    def begin(
        self, session: Session, name: str, values: dict[str, Any], show: Callable[..., None]
    ) -> asyncio.Task[Any]:
        """Begin a job, whose task has the result. It raises InterruptedError if the job was stopped.

        Raises Refused if another one runs, or values are not right.
        """
        if self._running is not None:
            self.refuse()
        coroutine = getattr(self, f"_{name}")(session, show, **_checked(name, values))
        self._running = name
        self._stopped.clear()
        self._progress(None)
        return asyncio.ensure_future(self._ended(coroutine))

    async def _ended(self, coroutine: Coroutine[Any, Any, Any]) -> Any:
        try:
            return await coroutine
        finally:
            self._running = None
            self._show_progress(None)

    def _progress(self, share: float | None) -> None:
        if self._running is not None:
            self._show_progress({"title": _TITLES[self._running], "share": share})

    async def _steps(self, steps: Iterator[Any], on_step: Callable[[Any], None]) -> None:
        """Take all steps of a generator, each in the worker."""
        try:
            while True:
                step = await self._worker(next, steps, None)
                if step is None:
                    return
                if self._stopped.is_set():
                    raise InterruptedError
                on_step(step)
        finally:
            await self._worker(steps.close)  # type: ignore[attr-defined]

    async def _chart(self, session: Session, show: Callable[..., None], frames: Any = 3) -> None:
        rows: list[dict[str, Any]] = []

        def add(row: dict[str, Any]) -> None:
            rows.append(row)
            show(chart=list(rows))

        show(chart=[])
        await self._steps(_settled(session, _refused(session.inspection.chart, frames)), add)

    async def _clashes(self, session: Session, show: Callable[..., None], clearance: Any = 0.0) -> None:
        loop = asyncio.get_running_loop()

        def progress(share: float) -> bool:
            loop.call_soon_threadsafe(self._progress, share)
            return not self._stopped.wait(0.0005)  # lets the event loop have its turn

        values = {"clearance": clearance, "progress": progress}
        found = await self._worker(_requests.call, session.inspection.clashes, values)
        found.sort(key=lambda clash: (clash["kind"] != "interfering", -(clash["depth"] or 0.0)))
        show(clashes={"count": len(found), "rows": found[:_MOST_CLASHES]})

    async def _heat_map(self, session: Session, show: Callable[..., None]) -> dict[str, Any]:
        def drawn() -> bytes:
            session.pictures.settle()
            return _output.png(session.inspection.heat_map())

        return {"type": "image/png", "data": await self._worker(drawn)}

    async def _screenshot(
        self,
        session: Session,
        show: Callable[..., None],
        width: Any = None,
        height: Any = None,
        transparent: Any = False,
    ) -> dict[str, Any]:
        size = None if width is None else (_side(width), _side(height))

        def drawn() -> bytes:
            session.pictures.settle()
            return _output.png(session.inspection.picture(size, transparent=transparent is True))

        return {"type": "image/png", "name": "vitrine.png", "data": await self._worker(drawn)}

    async def _turntable(
        self, session: Session, show: Callable[..., None], frames: Any = 120, width: Any = 1280, height: Any = 720
    ) -> dict[str, Any]:
        if isinstance(frames, bool) or not isinstance(frames, int) or not 2 <= frames <= _MOST_FRAMES:
            raise _requests.Refused(f"a turntable has 2 to {_MOST_FRAMES} pictures, not {frames!r}")
        size = (min(_side(width), 4096), min(_side(height), 4096))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "turntable.mp4"
            steps = _output.turntable(session.inspection, file, frames, size)
            try:
                await self._steps(steps, self._progress)
            except ImportError as error:
                raise _requests.Refused(str(error)) from None
            return {"type": "video/mp4", "name": "turntable.mp4", "data": file.read_bytes()}

    async def _explorable(self, session: Session, show: Callable[..., None]) -> dict[str, Any]:
        def drawn() -> bytes:
            session.pictures.settle()
            session.inspection.draw()
            with tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder) / "explorable.html"
                values = {"target": session.inspection.renderer, "path": file, "title": session.title()}
                _requests.call(export_explorable, values)
                session.inspection.forget_frame()
                return file.read_bytes()

        return {"type": "text/html", "name": "explorable.html", "data": await self._worker(drawn)}

    async def _save_state(self, session: Session, show: Callable[..., None]) -> dict[str, Any]:
        return {"type": "application/json", "name": "state.json", "data": _state.text_of(session.inspection.state_now)}


def _side(value: Any) -> int:
    side = _requests.pixels(value)
    if side > _MOST_SIDE:
        raise _requests.Refused(f"the page makes pictures of up to {_MOST_SIDE} pixels a side, not {side}")
    return side


def _refused(function: Callable[..., Iterator[Any]], *arguments: Any) -> Iterator[Any]:
    """The steps of a generator. What it cannot do is refused."""
    try:
        yield from function(*arguments)
    except (ValueError, TypeError) as error:
        raise _requests.Refused(str(error)) from None


def _settled(session: Session, steps: Iterator[Any]) -> Iterator[Any]:
    """The steps of a generator, each in the window's whole size, which moving pictures make smaller."""
    session.pictures.settle()
    for step in steps:
        yield step
        session.pictures.settle()


_VALUES = {
    "chart": {"frames"},
    "clashes": {"clearance"},
    "screenshot": {"width", "height", "transparent"},
    "turntable": {"frames", "width", "height"},
}


def _checked(name: str, values: dict[str, Any]) -> dict[str, Any]:
    unknown = set(values) - _VALUES.get(name, set())
    if unknown:
        raise _requests.Refused(f"{name} has no value {sorted(unknown)[0][:100]!r}")
    return values
