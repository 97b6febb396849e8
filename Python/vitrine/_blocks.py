"""Assemblies of data sets in blocks, in and out: from_multiblock(), and what Assembly.to_multiblock() makes."""

from __future__ import annotations

from typing import Any, Callable, Iterator, Sequence

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkDataAssembly,
    vtkDataSet,
    vtkMultiBlockDataSet,
    vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection,
    vtkPolyData,
)
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkRenderingCore import vtkProperty

from ._tree import Tree
from .vtkVitrineRendering import vtkAssemblyActors

_BYTE = 3  # VTK_UNSIGNED_CHAR
_Look = tuple[tuple[float, float, float], float, str]  # colour, opacity, and the material's name
_DEFAULT: _Look = ((1.0, 1.0, 1.0), 1.0, "")


def make_actors(blocks: Any) -> tuple[vtkAssemblyActors, list[str]]:
    """Parts of all blocks, with their names, and notes of what is left out."""
    if not isinstance(blocks, (vtkMultiBlockDataSet, vtkPartitionedDataSetCollection)):
        raise TypeError(
            "a pyvista.MultiBlock, a vtkMultiBlockDataSet or a vtkPartitionedDataSetCollection is needed, "
            f"not {type(blocks).__name__}"
        )
    collection = isinstance(blocks, vtkPartitionedDataSetCollection)
    leaves = _leaves_of_collection(blocks) if collection else _leaves_of_blocks(blocks)
    actors: Any = vtkAssemblyActors()
    properties: dict[_Look, vtkProperty] = {}
    names = UniqueNames()
    notes: list[str] = []
    for path, data in leaves:
        surface = _surface(data)
        if surface is None:
            notes.append(f"{path} has no cells" if _is_data_set(data) else f"{path} is no data set")
            continue
        look = _look_of(data)
        if look not in properties:
            properties[look] = _property_of(look)
        number = actors.AddPart(surface, None, properties[look], None, False)
        actors.SetPartNames(number, names.make(path.rpartition("/")[2]), path, look[2])
    return actors, notes


class UniqueNames:
    """Names that tell things apart: the second of a name becomes "name (2)", as vtkAssemblyReader has it."""

    def __init__(self) -> None:
        self._seen: dict[str, int] = {}

    def make(self, name: str) -> str:
        while True:
            count = self._seen[name] = self._seen.get(name, 0) + 1
            if count == 1:
                return name
            name = f"{name} ({count})"


def _leaves_of_blocks(root: Any) -> Iterator[tuple[str, Any]]:
    """Paths and data of all that is no group."""
    paths = UniqueNames()
    waiting: list[tuple[str, Any, tuple[Any, ...]]] = [("", root, ())]
    while waiting:
        path, data, above = waiting.pop()
        if not isinstance(data, (vtkMultiBlockDataSet, vtkPartitionedDataSet)):
            if data is not None:
                yield path, data
            continue
        if any(data is group for group in above):
            raise ValueError(f"{path}: the group contains itself")
        children = [
            (paths.make(f"{path}/{name}"), child, (*above, data))
            for name, child in named_children(data)
            if child is not None
        ]
        waiting += reversed(children)


def _children(group: Any) -> list[Any]:
    if isinstance(group, vtkPartitionedDataSetCollection):
        return [group.GetPartitionedDataSet(i) for i in range(group.GetNumberOfPartitionedDataSets())]
    if isinstance(group, vtkPartitionedDataSet):
        partitions = range(group.GetNumberOfPartitions())
        return [group.GetPartitionAsDataObject(i) for i in partitions]
    return [group.GetBlock(i) for i in range(group.GetNumberOfBlocks())]


def named_children(group: Any) -> list[tuple[str, Any]]:
    """The names of a group's blocks, as they stand in paths, and the blocks. Empty ones are None."""
    return [(in_path(_name_of(group, i)), child) for i, child in enumerate(_children(group))]


def _name_of(group: Any, number: int) -> str:
    """The name of a block, or else one with its number."""
    name = ""
    if group.HasMetaData(number):
        name = group.GetMetaData(number).Get(vtkCompositeDataSet.NAME()) or ""
    pieces = isinstance(group, vtkPartitionedDataSet)
    return name or (str(number) if pieces else f"block-{number}")


def in_path(name: str) -> str:
    """A slash would be taken for the end of a name."""
    return name.replace("/", "_")


def _leaves_of_collection(collection: Any) -> Iterator[tuple[str, Any]]:
    paths = UniqueNames()
    placed: set[int] = set()
    for path, numbers in _nodes_of(collection.GetDataAssembly(), paths):
        count = collection.GetNumberOfPartitionedDataSets()  # a tree may name others
        own = [number for number in numbers if number not in placed and number < count]
        placed.update(own)
        for number in own:
            place = path
            if len(own) > 1:
                # vtkAssemblyReader calls them "lid/0" and "lid/1".
                place = paths.make(f"{path}/{_name_of(collection, number).rpartition('/')[2]}")
            yield from _pieces(place, collection.GetPartitionedDataSet(number))
    for number in range(collection.GetNumberOfPartitionedDataSets()):
        if number not in placed:
            place = paths.make("/" + in_path(_name_of(collection, number)))
            yield from _pieces(place, collection.GetPartitionedDataSet(number))


def _pieces(path: str, pieces: Any) -> Iterator[tuple[str, Any]]:
    found = [piece for piece in _children(pieces) if piece is not None] if pieces is not None else []
    for i, piece in enumerate(found):
        yield (f"{path}/{i}" if len(found) > 1 else path), piece


def _nodes_of(assembly: Any, paths: UniqueNames) -> Iterator[tuple[str, list[int]]]:
    """Nodes of a vtkDataAssembly below its root: paths, and numbers of their own data sets. The root's are left out."""
    if assembly is None:
        return
    root = vtkDataAssembly.GetRootNode()
    waiting = [(child, "") for child in reversed(_child_nodes(assembly, root))]
    while waiting:
        node, parent = waiting.pop()
        name = assembly.GetAttributeOrDefault(node, "label", "") or assembly.GetNodeName(node)
        path = paths.make(f"{parent}/{in_path(name)}")
        yield path, list(assembly.GetDataSetIndices(node, False))
        waiting += [(child, path) for child in reversed(_child_nodes(assembly, node))]


def _child_nodes(assembly: Any, node: int) -> list[int]:
    return [assembly.GetChild(node, i) for i in range(assembly.GetNumberOfChildren(node))]


def _is_data_set(data: Any) -> bool:
    return isinstance(data, vtkDataSet)


def _surface(data: Any) -> vtkPolyData | None:
    """What is drawn of a data set: itself, or the surface of its cells, with scalars only if these are colours."""
    if not _is_data_set(data) or data.GetNumberOfCells() == 0:
        return None
    surface: Any = vtkPolyData()
    if isinstance(data, vtkPolyData):
        surface.ShallowCopy(data)
    else:
        outside = vtkDataSetSurfaceFilter()
        outside.SetInputData(data)
        outside.Update()
        surface.ShallowCopy(outside.GetOutput())
    if not _has_colors(surface):
        surface.GetPointData().SetActiveScalars(None)
    return surface


def _has_colors(surface: Any) -> bool:
    scalars = surface.GetPointData().GetScalars()
    return (
        scalars is not None
        and scalars.GetDataType() == _BYTE
        and scalars.GetNumberOfComponents() in (3, 4)
    )


def _look_of(data: Any) -> _Look:
    """What the arrays "color", "opacity" and "material" of the data's field data say."""
    color: Any = _numbers(data, "color", 3) or _DEFAULT[0]
    opacity = _numbers(data, "opacity", 1) or (_DEFAULT[1],)
    material = data.GetFieldData().GetAbstractArray("material")
    is_text = isinstance(material, vtkStringArray) and material.GetNumberOfValues() == 1
    return color, opacity[0], material.GetValue(0) if is_text else _DEFAULT[2]


def _numbers(data: Any, name: str, count: int) -> tuple[float, ...] | None:
    """Numbers in [0, 1] of an array of so many, or None if there are no such ones."""
    array = data.GetFieldData().GetArray(name)
    if array is None or array.GetNumberOfValues() != count:
        return None
    values = tuple(float(array.GetVariantValue(i).ToDouble()) for i in range(count))
    return values if all(0.0 <= value <= 1.0 for value in values) else None


def _property_of(look: _Look) -> vtkProperty:
    color, opacity, material = look
    made = vtkProperty()
    made.SetColor(*color)
    made.SetOpacity(opacity)
    made.SetMaterialName(material)
    return made


def make_blocks(root: Tree, actors: vtkAssemblyActors, look_of: Callable[[int], Any]) -> Any:
    """A pyvista.MultiBlock, or a vtkMultiBlockDataSet without PyVista, with the nesting and the names of a tree.

    `look_of` takes the number of a part, and returns its colour and its opacity.
    """
    new_group, wrap = _kinds_of_blocks()
    blocks = new_group()
    kept = []  # VTK searches through all objects that have lost theirs in Python for each one that does
    roots = [root] if root.name else root.children
    waiting: list[tuple[Any, Sequence[Tree]]] = [(blocks, roots)]
    while waiting:
        group, nodes = waiting.pop()
        for node in nodes:
            place = group
            if node.children:
                place = new_group()
                kept.append(place)
                _add(group, node.name, place)
                waiting.append((place, node.children))
            if node.part is not None:
                look = (*look_of(node.part.number), node.part.material)
                geometry = wrap(actors.CopyPlacedGeometry(node.part.number))
                kept.append(_add_look(geometry, look))
                _add(place, node.name, geometry)
                kept.append(geometry)
    blocks.__dict__["_kept"] = kept
    return blocks


def _kinds_of_blocks() -> tuple[Callable[[], Any], Callable[[Any], Any]]:
    """How groups are made, and what makes a geometry a block: PyVista's, or VTK's without it."""
    try:
        import pyvista
    except ImportError:
        return vtkMultiBlockDataSet, lambda geometry: geometry

    def wrap(geometry: vtkPolyData) -> Any:
        """As pyvista.wrap(), without its checks of arrays, which take the longer, the more parts there are."""
        made = pyvista.PolyData()
        made.ShallowCopy(geometry)
        return made

    return pyvista.MultiBlock, wrap


def _add(group: Any, name: str, data: Any) -> None:
    """Adds a block as VTK does. PyVista's append() takes the longer, the more blocks there are."""
    number = group.GetNumberOfBlocks()
    group.SetBlock(number, data)
    group.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name)


def _add_look(geometry: Any, look: _Look) -> list[Any]:
    """Adds field data, and returns their objects."""
    color, opacity, material = look
    data = geometry.GetFieldData()
    added: list[Any] = [data]
    for name, values in (("color", color), ("opacity", (opacity,))):
        array = vtkDoubleArray()
        array.SetName(name)
        array.SetNumberOfComponents(len(values))
        array.InsertNextTuple(values)
        data.AddArray(array)
        added.append(array)
    text = vtkStringArray()
    text.SetName("material")
    text.InsertNextValue(material)
    data.AddArray(text)
    return [*added, text]
