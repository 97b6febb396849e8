"""The inspector's server: inspect() opens a page on this machine, which one browser shows."""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import socket
import sys
import webbrowser
from typing import Any, Callable, Iterator, Sequence

from ._worker import Worker

_NEEDED = ("trame", "trame_vuetify", "PIL", "aiohttp", "jsonschema")
_EXTRA = "pip install 'vtk-vitrine[inspect]'"
_PATIENCE = 1.0  # seconds
LOOPBACK = ("127.0.0.1", "localhost", "::1")


def check_installed() -> None:
    """Raise ImportError, with what installs it, if something is missing that the page needs."""
    try:
        for name in _NEEDED:
            __import__(name)
    except ImportError as error:
        raise ImportError(f"the inspector needs {error.name}, which is not installed: {_EXTRA}") from None


def inspect(
    target: Any,
    *,
    host: str = "127.0.0.1",
    port: int = 0,
    open_browser: bool = True,
    size: Sequence[int] = (1024, 640),
    tolerance: float = 0.0,
) -> Server | None:
    """Show an assembly in the inspector, a page in the browser.

    The address has a random token, and without it the server answers nothing. In a script the call returns when the
    page's "Quit" or Ctrl-C ends the server. Where an event loop runs already, as in notebooks, it returns at once, and
    the result shows the page in the notebook.

    Until then, a plotter's window is drawn by the page alone.

    Args:
        target: an Assembly, a file, several files, a state that Inspection.save() wrote, or a pyvista.Plotter.
        host: the address of the network card that listens. By default only this machine can reach the page.
        port: where the server listens. 0 takes a free one.
        open_browser: whether the page is opened in the browser.
        size: width and height of the picture in pixels, until the page tells its own.
        tolerance: as that of load(), for files.

    Returns None in scripts, and a Server with `address` and `stop()` where an event loop runs.

    Raises ImportError if the packages of vtk-vitrine[inspect] are missing, and OSError if it cannot listen.
    """
    check_installed()
    server = Server(target, host=host, port=port, size=size, tolerance=tolerance)
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        asyncio.run(server.run(open_browser=open_browser))
        return None
    server.begin()
    return server


class Server:
    """A page of the inspector and what serves it, until stop()."""

    def __init__(
        self,
        target: Any,
        *,
        host: str,
        port: int,
        size: Sequence[int] = (1024, 640),
        tolerance: float = 0.0,
        dark: bool = False,
    ) -> None:
        from ._guard import Guard

        self._target, self._size, self._tolerance = target, size, tolerance
        self._host, self._port, self._dark = host, port, dark
        self._guard = Guard()
        self._worker = Worker(inline=hasattr(target, "render_window"))
        self._task: asyncio.Task[None] | None = None
        self._stopped: asyncio.Event | None = None
        self._trame: Any = None

    @property
    def port(self) -> int:
        """Where the server listens, once it does."""
        return self._port or (int(self._trame.port) if self._trame is not None else 0)

    @property
    def address(self) -> str:
        """The page's address with its token."""
        host = "127.0.0.1" if self._host in ("0.0.0.0", "::", "") else self._host
        return f"http://{f'[{host}]' if ':' in host else host}:{self.port}/?token={self._guard.token}"

    @property
    def is_busy(self) -> bool:
        """Whether a frame is still drawn, which nothing can end."""
        return self._worker.is_busy

    def begin(self) -> None:
        """Serve in the event loop that runs."""
        self._port = self._port or _free_port(self._host)
        self._task = asyncio.get_running_loop().create_task(self.run(open_browser=False, in_notebook=True))
        self._task.add_done_callback(_tell_failure)

    def stop(self) -> None:
        """End the server, close its page and its window."""
        if self._stopped is not None:
            self._stopped.set()

    async def run(self, *, open_browser: bool, in_notebook: bool = False) -> None:
        """Serve until stop() or "Quit" in the page, or, in programs, a signal."""
        from ._page import Page

        self._stopped = asyncio.Event()
        page = Page(self._worker, self.stop, dark=self._dark)
        self._trame = page.server
        self._trame.controller.on_server_bind.add(lambda web_server: self._prepare(page, web_server.app))
        with contextlib.nullcontext() if in_notebook else _ended_by_signals(self.stop):
            serving = self._serve(page)
            try:
                await _first_of(self._trame.ready, serving)
                opening = asyncio.ensure_future(page.open(self._target, self._size, self._tolerance))
                # What cannot be opened is mostly known at once, and then there is no page.
                await _first_of(opening, serving, timeout=_PATIENCE)
                if not in_notebook:
                    self._announce()
                if open_browser:
                    webbrowser.open(self.address)
                await _first_of(opening, serving, self._stopped.wait())
                await _first_of(serving, self._stopped.wait())
            finally:
                page.interrupt()
                with contextlib.suppress(Exception):
                    await self._trame.stop()
                closing = asyncio.ensure_future(page.close())
                await asyncio.wait([closing, *([] if serving.done() else [serving])], timeout=3)
                self._worker.close()
                page.forget()

    def _prepare(self, page: Any, application: Any) -> None:
        self._guard.protect(application)
        page.serve_files(application)

    def _serve(self, page: Any) -> asyncio.Task[None]:
        with _no_arguments():
            coroutine = self._trame.start(
                port=self._port,
                host=self._host,
                thread=True,
                timeout=0,
                open_browser=False,
                show_connection_info=False,
                disable_logging=True,
                exec_mode="coroutine",
                backend="aiohttp",
            )
        return asyncio.ensure_future(coroutine)

    def _announce(self) -> None:
        if self._host not in LOOPBACK:
            print(
                f"vitrine: the server listens on {self._host}. Everybody who can reach this machine and knows the "
                "address sees the assembly. The connection is not encrypted.",
                file=sys.stderr,
                flush=True,
            )
        print(f"{self.address}\nCtrl-C ends it.", flush=True)

    def _repr_html_(self) -> str:
        """The page in a notebook. It waits for the server, and has the notebook's name of this machine."""
        return _FRAME % {"name": f"vitrine-{self._guard.token[:8]}", "address": self.address}


_FRAME = """<iframe id="%(name)s" style="width: 100%%; height: 700px; border: 1px solid #8888" allow="clipboard-write">
</iframe><script>(async () => {
  const address = new URL("%(address)s");
  if (["localhost", "127.0.0.1"].includes(location.hostname)) address.hostname = location.hostname;
  for (;;) {
    try { await fetch(address.origin, { mode: "no-cors" }); break; }
    catch { await new Promise((again) => setTimeout(again, 200)); }
  }
  document.getElementById("%(name)s").src = address;
})();</script>"""


def _tell_failure(task: asyncio.Task[None]) -> None:
    """Say why a notebook's server has ended, which nobody waits for."""
    error = None if task.cancelled() else task.exception()
    if error is not None:
        told = error.args[0] if isinstance(error, KeyError) and error.args else error
        print(f"vitrine: the inspector has ended: {told}", file=sys.stderr, flush=True)


def _free_port(host: str) -> int:
    with socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET) as probe:
        probe.bind((host, 0))
        return int(probe.getsockname()[1])


async def _first_of(*waited: Any, timeout: float | None = None) -> None:
    """Wait for the first, and raise what it raises."""
    tasks = [asyncio.ensure_future(each) for each in waited]
    done, _ = await asyncio.wait(tasks, timeout=timeout, return_when=asyncio.FIRST_COMPLETED)
    for task in done:
        task.result()


@contextlib.contextmanager
def _ended_by_signals(stop: Callable[[], None]) -> Iterator[None]:
    loop = asyncio.get_running_loop()
    signals = (signal.SIGINT, signal.SIGTERM)
    for each in signals:
        loop.add_signal_handler(each, stop)
    try:
        yield
    finally:
        for each in signals:
            loop.remove_signal_handler(each)


@contextlib.contextmanager
def _no_arguments() -> Iterator[None]:
    """Trame would take this program's arguments for its own."""
    arguments, variable = sys.argv, os.environ.pop("TRAME_ARGS", None)
    sys.argv = arguments[:1]
    try:
        yield
    finally:
        sys.argv = arguments
        if variable is not None:
            os.environ["TRAME_ARGS"] = variable
