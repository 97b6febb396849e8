"""Explorable pictures: export_explorable() writes a view that a browser can take apart."""

from __future__ import annotations

from ._export import export_explorable

__all__ = ["export_explorable"]
