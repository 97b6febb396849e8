"""The inspector: open an assembly, see in, ask, share. inspect() serves its page, and Inspection does without one."""

from __future__ import annotations

from ._inspection import Inspection
from ._server import inspect

__all__ = ["Inspection", "inspect"]
