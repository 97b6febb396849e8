"""The inspector's page: its requests, its long work, and what it shows of a Session. _panels.py lays it out."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import pathlib
import secrets
from typing import Any, Awaitable, Callable

from aiohttp import web
from trame.app import core, get_server

from . import _jobs, _requests, _state
from ._panels import lay_out
from ._session import Session
from ._worker import Worker

_SCRIPTS, _STYLE = ("tools.js", "keys.js", "view.js", "tree.js"), "inspector.css"
_ADDRESS = "vitrine"
_ASKED_AGAIN = ("resize", "moving", "still", "tree")  # by the page itself, once long work is done
_LOG = logging.getLogger(__name__)
logging.getLogger("wslink").setLevel(logging.CRITICAL)  # it would tell of each page that is closed
# What the page tells of one picture, and of one place of the parts. It goes when that is another one.
_OF_PICTURE: dict[str, Any] = {"heat": None, "figures": None, "error_told": None, "culled": []}
_OF_PLACES: dict[str, Any] = {"clashes": None, "measured": None, "picked": None, "before": None}
_EMPTY: dict[str, Any] = {
    "ins": {**_state.DEFAULTS, "camera": {"parallel": False}},
    "revision": 0,
    "picture": 0,
    "can_undo": False,
    "can_redo": False,
    "selection": {"count": 0, "name": "", "path": "", "opacity": 1.0, "color": "#808080"},
    "cut": {"count": 0, "paths": []},
    "message": {"text": "", "kind": "info"},
    "busy": None,
    **_OF_PICTURE,
    **_OF_PLACES,
    "chart": [],
    "job_done": 0,
    "bounds": [0.0, 1.0] * 3,
    "methods": [],
    "ended": False,
}


class Page:
    """A trame server with the page, and the requests that come from it. Its methods run in the event loop."""

    def __init__(self, worker: Worker, quit_: Callable[[], None], *, dark: bool = False) -> None:
        self._worker, self._quit = worker, quit_
        self._session: Session | None = None
        self._jobs = _jobs.Jobs(worker, self._show_progress)
        self._job: asyncio.Future[Any] | None = None
        self._job_number = 0
        self.server = get_server(f"vitrine-{secrets.token_hex(8)}", client_type="vue3")
        self.server.enable_module(
            {
                "scripts": [f"{_ADDRESS}/{name}" for name in _SCRIPTS],
                "styles": [f"{_ADDRESS}/{_STYLE}"],
                "vue_use": ["vitrine_view", "vitrine_tree"],
            }
        )
        self.server.state.update({**_EMPTY, "title": "", "trame__title": "Vitrine"})
        self.server.trigger("vitrine")(self._request)
        lay_out(self.server, dark)
        self._handlers: dict[str, Callable[[Session, dict[str, Any]], Any]] = {
            "resize": lambda session, values: session.resize(**values),
            "moving": lambda session, values: session.moving(),
            "still": lambda session, values: session.still(),
            "move": lambda session, values: session.move(**values),
            "click": lambda session, values: session.click(**values),
            "tree": lambda session, values: session.tree(**values),
            "find": lambda session, values: session.find(**values),
            "apply_text": lambda session, values: _requests.apply_text(session.inspection, **values),
        }

    def serve_files(self, application: web.Application) -> None:
        """Have an application serve the page's own scripts and style."""
        folder = pathlib.Path(__file__).parent
        for name in (*_SCRIPTS, _STYLE):
            application.router.add_get(f"/{_ADDRESS}/{name}", _sender(folder / name))

    async def open(self, target: Any, size: Any, tolerance: float) -> None:
        """Open what the page shows. Raises what opening raises."""
        self._show(busy={"title": "Opening", "share": None})
        try:
            self._session = await self._worker(Session, target, size, tolerance)
        finally:
            self._show(busy=None)
        self._show(**self._session.told_once(), **self._session.told())
        self._warming = asyncio.ensure_future(self._worker(self._session.warm_up))

    def interrupt(self) -> None:
        """Have long work stop soon."""
        self._jobs.stop()
        self._show(ended=True)

    async def close(self) -> None:
        """Let the window go."""
        if self._session is not None:
            await self._worker(self._session.close)

    def forget(self) -> None:
        """Take the server, which has ended, from trame's list of all."""
        core.AVAILABLE_SERVERS.pop(self.server.name, None)

    async def _request(self, name: Any = None, values: Any = None) -> Any:
        """Do what the page asks. A request that cannot be done leaves a message in the page, and answers None."""
        return await self._told(self._done(name, values if values is not None else {}))

    async def _told(self, work: Awaitable[Any]) -> Any:
        try:
            return await work
        except _requests.Refused as error:
            self._say(str(error))
        except InterruptedError:
            self._say("Stopped.", "info")
        except Exception as error:  # whatever it is, the page and the server go on
            _LOG.exception("a request of the inspector's page failed")
            self._say(f"{type(error).__name__}: {error}")
        return None

    async def _done(self, name: Any, values: Any) -> Any:
        if not isinstance(name, str) or not isinstance(values, dict) or not all(isinstance(key, str) for key in values):
            raise _requests.Refused("a request has a name and values with names")
        if name == "quit":
            return self._quit()
        if name == "stop":
            return self._jobs.stop()
        if self._session is None:
            return None
        if name == "collect":
            return await self._collect(**{key: value for key, value in values.items() if key == "job"})
        if self._jobs.knows(name):
            return self._begin_job(self._session, name, values)
        if self._jobs.blocks:
            return self._jobs.refuse() if name not in _ASKED_AGAIN else None
        return await self._asked(self._session, name, values)

    async def _asked(self, session: Session, name: str, values: dict[str, Any]) -> Any:
        if name in self._handlers:
            result = await self._worker(_handled, self._handlers[name], session, values)
        elif _requests.is_change(name):
            result = await self._worker(_requests.change, session.inspection, name, values)
        elif _requests.is_answer(name):
            result = await self._worker(_answered, session, name, values)
        else:
            raise _requests.Refused(f"there is no request {name[:100]!r}")
        if name not in ("moving", "still", "tree", "find"):
            await self._publish(session, says=name != "resize")
        self._show_answer(name, result)
        return result

    def _begin_job(self, session: Session, name: str, values: dict[str, Any]) -> dict[str, int]:
        """Begin long work. A connection takes one request after another, so that none may wait for it.

        The page asks for the result by "collect" once the state's "job_done" is the number that this returns.
        """
        task = self._jobs.begin(session, name, values, self._show)
        self._job_number += 1
        self._job = asyncio.ensure_future(self._finished(session, task, self._job_number))
        return {"job": self._job_number}

    async def _finished(self, session: Session, task: asyncio.Task[Any], number: int) -> Any:
        result = await self._told(task)
        await self._publish(session, says=False)
        self._show(job_done=number)
        return result

    async def _collect(self, job: Any = None) -> Any:
        if job != self._job_number or self._job is None:
            raise _requests.Refused("there is no such work")
        return await self._job

    async def _publish(self, session: Session, says: bool = True) -> None:
        """Show what has changed. A message that was there goes, if the request says something itself."""
        await self._worker(session.note_change)
        if session.revision != self.server.state.revision:
            self._jobs.view_changed()
            told = await self._worker(session.told)
            self._show(**told, **self._stale(told))
        if says and self.server.state.message["text"]:
            self._say("", "info")

    def _stale(self, told: dict[str, Any]) -> dict[str, Any]:
        """What the page shows no longer, once it shows what is told."""
        shown = self.server.state
        of_picture = _OF_PICTURE if told["picture"] != shown.picture else {}
        return {**of_picture, **(_OF_PLACES if told["ins"]["explode"] != shown.ins["explode"] else {})}

    def _show_answer(self, name: str, result: Any) -> None:
        shown = {"figures": "figures", "error": "error_told", "culled": "culled", "measure": "measured"}
        if name in shown:
            self._show(**{shown[name]: result})

    def _show_progress(self, progress: dict[str, Any] | None) -> None:
        self._show(busy=progress)

    def _say(self, text: str, kind: str = "error") -> None:
        self._show(message={"text": text[:500], "kind": kind})

    def _show(self, **values: Any) -> None:
        with self.server.state, contextlib.suppress(asyncio.CancelledError):
            self.server.state.update(values)
            self.server.state.dirty(*values)


def _sender(file: pathlib.Path) -> Callable[[web.Request], Awaitable[web.StreamResponse]]:
    async def send(_request: web.Request) -> web.StreamResponse:
        return web.FileResponse(file)

    return send


def _handled(handler: Callable[[Session, dict[str, Any]], Any], session: Session, values: dict[str, Any]) -> Any:
    try:
        return handler(session, values)
    except TypeError as error:
        if "argument" in str(error):
            raise _requests.Refused(f"the request has other values: {error}") from None
        raise


def _answered(session: Session, name: str, values: dict[str, Any]) -> Any:
    session.pictures.settle()
    return _requests.answer(session.inspection, name, values)
