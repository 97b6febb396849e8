"""How calls name parts: one grammar for reveal(), section() and AssemblyIndex, and one name for a part that is told."""

from __future__ import annotations

import dataclasses
import numbers
from typing import Any, Iterable, Iterator

from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkDataObjectTree, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkProp, vtkProperty, vtkRenderer

from ._assembly import Assembly, Part, Selection
from ._blocks import in_path, named_children
from .vtkVitrineRendering import vtkAssemblyActors

WHOLE = -1  # the block of a prop that was given without one


@dataclasses.dataclass(frozen=True, eq=False)
class Chosen:
    """A part that a call names: the prop that draws it, its block, and its Part if an assembly draws it.

    block is the flat index of the block in composite data. It is 0 for props without blocks, and WHOLE for a prop that
    was given without a block, if no Part is told by that.
    """

    prop: vtkProp
    block: int
    part: Part | None

    @property
    def named(self) -> Any:
        """The part as a user knows it: a Part, or else an actor, or a pair of an actor and a block."""
        if self.part is not None:
            return self.part
        return self.prop if self.block <= 0 else (self.prop, self.block)


@dataclasses.dataclass(frozen=True)
class Scope:
    """Where patterns choose parts by name: in assemblies, and among actors that have a name, as PyVista gives it."""

    assemblies: list[Assembly]
    actors: list[vtkActor] = dataclasses.field(default_factory=list)


def choose(name: str, parts: Any, scope: Scope) -> list[Chosen]:
    """The parts that an argument names.

    Args:
        name: that of the argument, for messages.
        parts: an actor; a pair of an actor and the flat index of a block, where an inner node stands for all below it;
            a Part or a Selection of an assembly; a pattern of names; what tells an actor and a block, as pick() returns
            it; or an iterable of these.
        scope: that in which patterns choose.

    Raises:
        TypeError: it is something else.
        KeyError: a pattern chooses no part.
        ValueError: the index of a block is negative, or the assembly of a Part or the actor that was picked is gone.
    """
    trees: dict[vtkProp, list[Any]] = {}  # the nodes of props, read once
    return [chosen for item in flat(parts) for chosen in _chosen(name, item, scope, trees)]


def flat(parts: Any) -> Iterator[Any]:
    """The single items of an argument that names parts: what iterables have, at any depth."""
    if _is_single(parts):
        yield parts
    else:
        for part in parts:
            yield from flat(part)


def shown_assemblies(renderers: Iterable[vtkRenderer]) -> list[Assembly]:
    """The assemblies whose actors are in one of the renderers."""
    shown = list(renderers)
    return [
        assembly
        for assembly in Assembly.living()
        if len(assembly) > 0 and any(each.HasViewProp(assembly.actors.GetPartActor(0)) for each in shown)
    ]


def shown_names(renderers: Iterable[vtkRenderer]) -> Scope:
    """The names of all that the renderers show: of parts of assemblies, and of other actors."""
    shown = list(renderers)
    props = dict.fromkeys(prop for renderer in shown for prop in renderer.GetViewProps())
    return Scope(shown_assemblies(shown), [prop for prop in props if name_of(prop)])


def name_of(prop: Any, block: int = 0) -> str:
    """The name that PyVista gave to an actor, as in `plotter.actors`, or that of its block; empty for others."""
    name = getattr(prop, "name", "") if isinstance(prop, vtkActor) else ""
    if not isinstance(name, str):
        return ""
    path = dict(_named_blocks(prop)).get(block, "") if block > 0 else ""
    return path.rpartition("/")[2] or name


def part_of(prop: Any, block: int) -> Part | None:
    """The part of any assembly that a prop shows by a block, or None."""
    if not isinstance(prop, vtkActor):
        return None
    found = (assembly.part_of(prop, block) for assembly in Assembly.living())
    return next((part for part in found if part is not None), None)


def named(prop: Any, block: int) -> Any:
    """A part as a user knows it: a Part of an assembly, or else an actor, or a pair of an actor and a block."""
    return Chosen(prop, block, part_of(prop, block)).named


def block_count(prop: Any) -> int:
    """The number of flat indices of the data that an actor draws: 1 without blocks."""
    return max(1, len(_nodes_of(prop)))


def _nodes_of(prop: Any) -> list[Any]:
    """The nodes of the composite data that an actor draws, by flat indices. It is empty without blocks."""
    tree = _tree_of(prop)
    return _nodes_below(tree) if tree is not None else []


def _tree_of(prop: Any) -> vtkDataObjectTree | None:
    """The composite data that an actor draws, or None."""
    prop.GetBounds()  # updates the pipeline
    mapper = prop.GetMapper() if hasattr(prop, "GetMapper") else None
    data = mapper.GetInputDataObject(0, 0) if mapper is not None and mapper.GetNumberOfInputPorts() > 0 else None
    return data if isinstance(data, vtkDataObjectTree) else None


def _nodes_below(tree: vtkDataObjectTree) -> list[Any]:
    """A tree and the nodes below it, by flat indices. Empty ones are None."""
    each = tree.NewTreeIterator()
    each.SkipEmptyNodesOff()
    each.VisitOnlyLeavesOff()
    each.TraverseSubTreeOn()
    each.InitTraversal()
    nodes: list[Any] = [tree]
    while not each.IsDoneWithTraversal():
        nodes += [None] * (each.GetCurrentFlatIndex() - len(nodes)) + [each.GetCurrentDataObject()]
        each.GoToNextItem()
    return nodes


def _is_single(parts: Any) -> bool:
    if isinstance(parts, tuple) and len(parts) == 2 and isinstance(parts[0], vtkProp):
        return isinstance(parts[1], numbers.Integral)
    return isinstance(parts, (str, vtkProp, Part, Selection)) or not isinstance(parts, Iterable)


def _tells_place(item: Any) -> bool:
    """Whether it is a Layer, what pick() returns, or a Faded part."""
    return hasattr(item, "actor") and hasattr(item, "block")


def _chosen(
    name: str, item: Any, scope: Scope, trees: dict[vtkProp, list[Any]]
) -> Iterator[Chosen]:
    if isinstance(item, vtkProp):
        yield Chosen(item, WHOLE, None)
    elif isinstance(item, tuple) and not isinstance(item[1], bool):
        block = int(item[1])
        if block < 0:
            raise ValueError(f"the flat index of a block is 0 or more, not {block}")
        if item[0] not in trees:
            trees[item[0]] = _nodes_of(item[0])
        yield from _below(item[0], block, trees[item[0]])
    elif isinstance(item, Selection):
        yield from (_drawn_by(item._assembly, number) for number in item.numbers)
    elif isinstance(item, Part):
        yield _drawn_by(_assembly_of(item), item.number)
    elif isinstance(item, str):
        yield from _matching(item, scope)
    elif _tells_place(item):
        if item.actor is None:
            raise ValueError("the actor that was picked is gone")
        yield Chosen(item.actor, item.block, part_of(item.actor, item.block))
    else:
        raise TypeError(
            f"{name} is an actor, a pair of an actor and the flat index of a block, a Part or a Selection of an "
            f"assembly, a pattern of names, what pick() returns, or an iterable of these, not {item!r}"
        )


def _below(prop: vtkProp, block: int, nodes: list[Any]) -> Iterator[Chosen]:
    """The part of a block, or those of all blocks below it if it is an inner node. The root stands for the whole."""
    if not nodes or block >= len(nodes) or not isinstance(nodes[block], vtkDataObjectTree):
        yield Chosen(prop, block, part_of(prop, block))
    elif block == 0:
        yield Chosen(prop, WHOLE, None)
    else:
        # The nodes below it have the flat indices behind its own, up to the next node of its level.
        last = block + len(_nodes_below(nodes[block]))
        for leaf in range(block + 1, min(last, len(nodes))):
            if nodes[leaf] is not None and not isinstance(nodes[leaf], vtkDataObjectTree):
                yield Chosen(prop, leaf, part_of(prop, leaf))


def _matching(pattern: str, scope: Scope) -> Iterator[Chosen]:
    if not scope.assemblies and not scope.actors:
        raise KeyError(f"the target shows no assembly, so no part has the name {pattern!r}: add_to() adds one")
    found = [assembly[pattern] for assembly in scope.assemblies if pattern in assembly]
    actors, problem = _actors_named(pattern, scope.actors)
    if not found and not actors:
        for assembly in scope.assemblies:
            assembly[pattern]  # a KeyError that tells names like it
        raise KeyError(problem)
    for selection in found:
        yield from (_drawn_by(selection._assembly, number) for number in selection.numbers)
    yield from actors


def _actors_named(pattern: str, actors: list[vtkActor]) -> tuple[list[Chosen], str]:
    """The actors and blocks whose names a pattern chooses, or why there are none, by the rules of assemblies."""
    drawn = [(actor, block, path) for actor in actors for block, path in _named_blocks(actor)]
    names = vtkAssemblyActors()
    for number, (_, _, path) in enumerate(drawn):
        names.AddPart(vtkPolyData(), None, vtkProperty(), None, False)
        names.SetPartNames(number, path.rpartition("/")[2], path, "")
    found = vtkIdList()
    problem = names.FindParts(pattern, found)
    chosen = [drawn[found.GetId(i)] for i in range(found.GetNumberOfIds())]
    return [Chosen(actor, block, None) for actor, block, _ in chosen], problem


def _named_blocks(actor: vtkActor) -> Iterator[tuple[int, str]]:
    """The flat indices and the paths of the blocks that an actor with a name draws. It is one itself without blocks."""
    root = f"/{in_path(name_of(actor))}"
    tree = _tree_of(actor)
    waiting: list[tuple[Any, str]] = [(tree, root)]
    index = -1
    while waiting:
        node, path = waiting.pop()
        index += 1
        if isinstance(node, vtkDataObjectTree):
            waiting += reversed([(child, f"{path}/{name}") for name, child in named_children(node)])
        elif node is not None or tree is None:
            yield (index if tree is not None else WHOLE), path


def _assembly_of(part: Part) -> Assembly:
    for assembly in Assembly.living():
        if part.number < len(assembly) and assembly.parts[part.number] is part:
            return assembly
    raise ValueError(f"the assembly of {part.path!r} is gone: keep what load() returned")


def _drawn_by(assembly: Assembly, number: int) -> Chosen:
    actors = assembly.actors
    return Chosen(actors.GetPartActor(number), actors.GetPartBlock(number), assembly.parts[number])
