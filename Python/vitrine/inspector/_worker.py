"""The thread that has the inspector's window: a window's context belongs to one thread."""

from __future__ import annotations

import asyncio
import concurrent.futures
from typing import Any, Callable, TypeVar

Result = TypeVar("Result")


class Worker:
    """Calls functions one after another in a thread of its own, so that the event loop goes on.

    A plotter's window belongs to the thread that made it. For one, functions are called at once: `inline`.
    """

    def __init__(self, inline: bool = False) -> None:
        self._pool = None if inline else concurrent.futures.ThreadPoolExecutor(1, "vitrine-inspector")
        self._running = 0

    async def __call__(self, function: Callable[..., Result], *arguments: Any) -> Result:
        """The result of a function, or what it raises."""
        if self._pool is None:
            await asyncio.sleep(0)
            return function(*arguments)
        return await asyncio.get_running_loop().run_in_executor(self._pool, self._counted, function, *arguments)

    def _counted(self, function: Callable[..., Result], *arguments: Any) -> Result:
        self._running += 1
        try:
            return function(*arguments)
        finally:
            self._running -= 1

    def close(self) -> None:
        """Let the thread end after what it does."""
        if self._pool is not None:
            self._pool.shutdown(wait=False, cancel_futures=True)

    @property
    def is_busy(self) -> bool:
        """Whether the thread is in a function, such as a frame that takes seconds."""
        return self._running > 0
