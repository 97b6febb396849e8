"""The parts that an inspector shows, by paths: those of assemblies, and actors of a plotter that no assembly draws."""

from __future__ import annotations

import collections
import dataclasses
from typing import Any, Iterable, Mapping

from vtkmodules.vtkCommonDataModel import vtkBoundingBox
from vtkmodules.vtkRenderingCore import vtkActor

from .._assembly import Assembly, Part, Selection, _triangles
from .._blocks import in_path
from .._parts import Scope, choose, name_of, part_of

Look = Mapping[str, Any]  # "visible", "opacity" and "color" (#RRGGBB), as far as they are not those of the file


@dataclasses.dataclass(frozen=True)
class Row:
    """What a part is: its path and name, its material, its triangles, and its box in world coordinates."""

    path: str
    name: str
    material: str
    triangles: int
    bounds: tuple[float, ...]


class PartTable:
    """Parts by paths. Parts of several assemblies that have one path have one look."""

    def __init__(self, assemblies: Iterable[Assembly], actors: Mapping[str, vtkActor]) -> None:
        self.assemblies = list(assemblies)
        self._parts: dict[str, list[tuple[Assembly, Part]]] = collections.defaultdict(list)
        for assembly in self.assemblies:
            for part in assembly.parts:
                self._parts[part.path].append((assembly, part))
        self._actors = {"/" + in_path(name): _Plain(actor) for name, actor in actors.items()}
        self._actors = {path: plain for path, plain in self._actors.items() if path not in self._parts}
        self.paths = [*self._parts, *self._actors]
        self._below: dict[str, list[str]] | None = None
        self._bounds: tuple[float, ...] | None = None

    def __contains__(self, path: object) -> bool:
        return path in self._parts or path in self._actors

    def find(self, patterns: str | Iterable[str]) -> list[str]:
        """The paths that are meant by paths of parts or nodes, or by patterns of names. Raises KeyError for none."""
        found: dict[str, None] = {}
        for pattern in [patterns] if isinstance(patterns, str) else patterns:
            if not isinstance(pattern, str):
                raise TypeError(f"parts are paths or patterns of names, not {pattern!r}")
            found.update(dict.fromkeys(self._found(pattern)))
        return list(found)

    def _found(self, pattern: str) -> list[str]:
        if pattern in self:
            return [pattern]
        below = self._nodes().get(pattern)
        if below is not None:
            return below
        scope = Scope(self.assemblies, [plain.actor for plain in self._actors.values() if name_of(plain.actor)])
        chosen = choose("parts", pattern, scope)
        found = [each.part.path if each.part is not None else self.path_of(each.prop, each.block) for each in chosen]
        return [path for path in found if path is not None]

    def _nodes(self) -> dict[str, list[str]]:
        """The paths below each node that is no part."""
        if self._below is None:
            self._below = collections.defaultdict(list)
            for path in self.paths:
                end = path.rfind("/")
                while end > 0:
                    self._below[path[:end]].append(path)
                    end = path.rfind("/", 0, end)
        return self._below

    def path_of(self, prop: Any, block: int) -> str | None:
        """The path of what a prop shows by a block."""
        part = part_of(prop, block)
        if part is not None:
            return part.path
        return next((path for path, plain in self._actors.items() if plain.actor is prop), None)

    def named(self, path: str) -> list[Any]:
        """The parts of a path as vitrine's calls take them: each a Part or an actor."""
        if path in self._actors:
            return [self._actors[path].actor]
        return [part for _, part in self._parts[path]]

    def actor_of(self, path: str) -> vtkActor:
        """The actor that draws a part, perhaps among others."""
        if path in self._actors:
            return self._actors[path].actor
        assembly, part = self._parts[path][0]
        return assembly.actors.GetPartActor(part.number)

    def row(self, path: str) -> Row:
        if path in self._actors:
            return self._actors[path].row(path)
        part = self._parts[path][0][1]
        return Row(path, part.name, part.material, part.triangles, part.bounds)

    def bounds(self, paths: Iterable[str] | None = None) -> tuple[float, ...]:
        """The box around parts where they are now, in an exploded view too. None stands for all, also hidden ones."""
        if paths is None:
            self._bounds = self._bounds or self.bounds(self.paths)
            return self._bounds
        box, offset = vtkBoundingBox(), [0.0] * 3
        for path in paths:
            if path in self._actors:
                box.AddBounds(self._actors[path].actor.GetBounds())
                continue
            for assembly, part in self._parts[path]:
                assembly.actors.GetPartOffset(part.number, offset)
                box.AddBounds([value + offset[i // 2] for i, value in enumerate(part.bounds)])
        if not box.IsValid():
            return (-1.0, 1.0) * 3
        bounds = [0.0] * 6
        box.GetBounds(bounds)
        return tuple(bounds)

    def forget_places(self) -> None:
        """Have bounds() look again, since parts have moved."""
        self._bounds = None

    def given_looks(self) -> dict[str, dict[str, Any]]:
        """By path how parts look otherwise than by themselves."""
        changed = [each.parts[number].path for each in self.assemblies for number in each._looks]
        looks = {path: self.given_look(path) for path in changed}
        return {path: look for path, look in looks.items() if look}

    def set_look(self, path: str, before: Look, look: Look) -> None:
        """Have a part drawn by a look. What the look does not have is as the file says."""
        changed = [key for key in ("visible", "opacity", "color") if before.get(key) != look.get(key)]
        if path in self._actors:
            self._actors[path].set_look(look)
            return
        for assembly, part in self._parts[path]:
            selection = Selection(assembly, [part.number])
            for key in changed:
                value = look.get(key)
                # As numbers, since names of colours are looked up slowly.
                setattr(selection, key, rgb(value) if key == "color" and value is not None else value)

    def has_colors(self, path: str) -> bool:
        """Whether textures or colours of points and cells colour a part of an assembly, which a colour replaces."""
        if path in self._actors:
            return False
        assembly, part = self._parts[path][0]
        data = assembly.actors.GetPartGeometry(part.number)
        scalars = data.GetPointData().GetScalars() or data.GetCellData().GetScalars()
        is_colored = "color" in self.given_look(path)
        return not is_colored and (
            scalars is not None or assembly.actors.GetPartProperty(part.number).GetNumberOfTextures() > 0
        )

    def given_look(self, path: str) -> dict[str, Any]:
        """How a part looks otherwise than by itself, as set_look() takes it."""
        if path in self._actors:
            own, now = self._actors[path].own, self._actors[path].now()
            return {key: value for key, value in now.items() if value != own[key]}
        assembly, part = self._parts[path][0]
        selection = Selection(assembly, [part.number])
        given = {"visible": selection.visible, "opacity": selection.opacity, "color": selection.color}
        look = {key: value for key, value in given.items() if value is not None}
        return {**look, "color": hexadecimal(look["color"])} if "color" in look else look

    def shown_look(self, path: str) -> dict[str, Any]:
        """How a part is drawn: "visible", "opacity" and "color"."""
        return {**self.look_of_file(path), **self.given_look(path)}

    def look_of_file(self, path: str) -> dict[str, Any]:
        """How a part looks by itself: "opacity" and "color"."""
        if path in self._actors:
            return self._actors[path].own
        assembly, part = self._parts[path][0]
        material = assembly.actors.GetPartProperty(part.number)
        shown = [0.0, 0.0, 0.0]
        assembly.actors.GetShownColor(material, shown)
        return {"visible": True, "opacity": material.GetOpacity(), "color": hexadecimal(shown)}


class _Plain:
    """An actor that no assembly draws, and how it looked at first."""

    def __init__(self, actor: vtkActor) -> None:
        self.actor = actor
        self._color = actor.GetProperty().GetColor()
        self.own = self.now()

    def now(self) -> dict[str, Any]:
        look = self.actor.GetProperty()
        visible = bool(self.actor.GetVisibility())
        return {"visible": visible, "opacity": look.GetOpacity(), "color": hexadecimal(look.GetColor())}

    def set_look(self, look: Look) -> None:
        shown = {**self.own, **look}
        self.actor.SetVisibility(shown["visible"])
        self.actor.GetProperty().SetOpacity(shown["opacity"])
        color = rgb(look["color"]) if look.get("color", self.own["color"]) != self.own["color"] else self._color
        self.actor.GetProperty().SetColor(*color)

    def row(self, path: str) -> Row:
        mapper = self.actor.GetMapper()
        data = mapper.GetInputDataObject(0, 0) if mapper is not None else None
        triangles = _triangles(data.GetPolys()) if hasattr(data, "GetPolys") else 0
        return Row(path, path[1:], "", triangles, tuple(self.actor.GetBounds() or (0.0,) * 6))


def hexadecimal(color: Iterable[float]) -> str:
    """RGB in [0, 1] as #RRGGBB."""
    return "#" + "".join(f"{round(255 * min(max(value, 0.0), 1.0)):02x}" for value in color)


def rgb(color: str) -> tuple[float, float, float]:
    """#RRGGBB as RGB in [0, 1]."""
    values = bytes.fromhex(color[1:])
    return (values[0] / 255, values[1] / 255, values[2] / 255)
