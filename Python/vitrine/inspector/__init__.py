"""The inspector: open an assembly, see in, ask, share. Inspection does all of it without a page."""

from __future__ import annotations

from ._inspection import Inspection

__all__ = ["Inspection"]
