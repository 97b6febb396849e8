"""The tree of an assembly, for printing and for walking through."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Iterable, Iterator

if TYPE_CHECKING:
    from ._assembly import Part

_LINES = 60
_LEAST_CHILDREN = 10


@dataclasses.dataclass(repr=False)
class Tree:
    """A node of an assembly: its name, its path, the nodes below, and its own part if it has one.

    Printed, it has some 60 lines at most. text(None) has all.
    """

    name: str
    path: str
    children: list[Tree]
    part: Part | None = None
    _parts: int = 0
    _triangles: int = 0

    def parts(self) -> list[Part]:
        """The parts of the node and of all below, in the order of the tree."""
        return [node.part for node in self._nodes() if node.part is not None]

    def text(self, lines: int | None = _LINES) -> str:
        """The tree as a text of at most about so many lines. Nodes near the root come first. None means all lines."""
        if lines is not None and (isinstance(lines, bool) or not isinstance(lines, int)):
            raise TypeError(f"lines is an int or None, not {lines!r}")
        if lines is not None and lines < 1:
            raise ValueError(f"lines is at least 1, not {lines}")
        return "\n".join(self._lines(self._shown_children(lines)))

    def __str__(self) -> str:
        return self.text()

    __repr__ = __str__

    def _nodes(self) -> Iterator[Tree]:
        waiting = [self]
        while waiting:
            node = waiting.pop()
            yield node
            waiting += reversed(node.children)

    def _shown_children(self, lines: int | None) -> dict[int, int]:
        """How many children of a node are shown, by the node's id()."""
        if lines is None:
            return {id(node): len(node.children) for node in self._nodes()}
        shown: dict[int, int] = {}
        left = lines - 1
        level = [self]
        while level and left > 0:
            below: list[Tree] = []
            for node in level:
                count = len(node.children)
                most = max(_LEAST_CHILDREN, left // 2)
                if count > most:
                    count = most - 1  # and a line that says how many more there are
                needed = count + (count < len(node.children))
                if needed <= left:
                    shown[id(node)] = count
                    left -= needed
                    below += node.children[:count]
            level = below
        return shown

    def _lines(self, shown: dict[int, int]) -> Iterator[str]:
        waiting: list[tuple[int, Tree | str]] = [(0, self)]
        while waiting:
            depth, node = waiting.pop()
            if isinstance(node, str):
                yield "  " * depth + node
                continue
            yield "  " * depth + f"{node.name or '/'}  ({node._summary()})"
            count = shown.get(id(node), 0)
            if 0 < count < len(node.children):
                waiting.append((depth + 1, f"... {len(node.children) - count:,} more"))
            waiting += [(depth + 1, child) for child in reversed(node.children[:count])]

    def _summary(self) -> str:
        triangles = f"{self._triangles:,} triangle{'s' if self._triangles != 1 else ''}"
        return triangles if self._parts == 1 else f"{self._parts:,} parts, {triangles}"


def make_tree(parts: Iterable[Part]) -> Tree:
    """The tree of parts: its only root, or else a node without a name above all roots."""
    top = Tree("", "", [])
    nodes = {"": top}
    for part in parts:
        _node_at(part.path, nodes).part = part
        end = len(part.path)
        while end >= 0:
            node = nodes[part.path[:end]]
            node._parts += 1
            node._triangles += part.triangles
            end = part.path.rfind("/", 0, end) if end > 0 else -1
    return top.children[0] if len(top.children) == 1 else top


def _node_at(path: str, nodes: dict[str, Tree]) -> Tree:
    """The node of a path, which is made with those above it if it is not there yet."""
    end = len(path)
    while path[:end] not in nodes:
        end = path.rfind("/", 0, end)
    node = nodes[path[:end]]
    while end < len(path):
        begin = end + 1
        end = path.find("/", begin)
        end = end if end >= 0 else len(path)
        child = Tree(path[begin:end], path[:end], [])
        node.children.append(child)
        nodes[child.path] = child
        node = child
    return node
