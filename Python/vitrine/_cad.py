"""STEP and IGES where vitrine-cad is not: `python _cad.py INPUT OUTPUT.glb` converts them by cascadio.

vtkAssemblyReader runs this as a program of its own, and calls it as it calls vitrine-cad. It needs nothing of its
package.
"""

from __future__ import annotations

import argparse
import contextlib
import importlib.util
import itertools
import json
import math
import os
import pathlib
import re
import shlex
import shutil
import struct
import sys
import tempfile
from typing import Any, Iterator, Sequence

CONVERSION = 2  # counts changes of what is made of a file
_ANGLE = 0.5  # radians
_TOLERANCE_OF_SIZE = 1e-3  # of the diagonal of the box around all
_LEAST_TOLERANCE = 1e-10  # metres; OpenCASCADE takes points that are nearer for one
_MISSING = "needs OpenCASCADE to read STEP and IGES: pip install 'vtk-vitrine[step]'"
_STEP = (".step", ".stp")
_IGES = (".iges", ".igs")
_METERS = {"metre": 1.0, "centimetre": 0.01, "millimetre": 0.001, "inch": 0.0254, "foot": 0.3048}
_GREY = [0.6038, 0.6038, 0.6038, 1.0]  # linear; of shapes without a colour


KINDS: tuple[str, ...] = (*_STEP, *_IGES, ".brep")


class CadError(Exception):
    """A file that cannot be converted. Its text says why in one line, without the file's name."""


def command() -> str | None:
    """The command that vtkAssemblyReader must run, or None where it finds a converter by itself."""
    if os.environ.get("VITRINE_CAD_CONVERTER"):
        return None
    package = pathlib.Path(__file__).resolve().parent
    if package.parts[-4:-1] == ("lib", "python3", "dist-packages"):
        if (package.parents[3] / "bin/vitrine-cad").is_file():
            return None
    if importlib.util.find_spec("cascadio") is None and shutil.which("vitrine-cad"):
        return None
    return shlex.join([sys.executable or "python3", str(package / "_cad.py")])


def set_up(reader: Any, tolerance: float, cache: bool) -> None:
    """Tell a vtkAssemblyReader how a file of KINDS is read."""
    if isinstance(tolerance, bool) or not 0.0 <= float(tolerance) < math.inf:
        raise ValueError(f"tolerance is a number of metres, at least 0, not {tolerance!r}")
    reader.SetConverter(command())
    reader.SetTolerance(float(tolerance))
    reader.SetUseCache(cache)


def notes_of(reader: Any) -> list[str]:
    """What a vtkAssemblyReader notes of its file, and the file's unit if its lengths were converted."""
    told = unit_notes(reader.GetLengthUnit())
    return told + [reader.GetNote(note) for note in range(reader.GetNumberOfNotes())]


def unit_notes(unit: str) -> list[str]:
    """The note of a file whose lengths were converted from a unit, none without one."""
    return [f"lengths are in metres; in the file their unit is the {unit}"] if unit else []


# STEP's text


class StepNames:
    """The products of a STEP file, and which of them each one is made of."""

    _ENTITY = re.compile(
        rb"#(\d+)\s*=\s*(NEXT_ASSEMBLY_USAGE_OCCURRENCE|PRODUCT_DEFINITION_FORMATION\w*|PRODUCT_DEFINITION"
        rb"(?:_WITH_ASSOCIATED_DOCUMENTS)?|PRODUCT)\s*(\()"
    )
    _ARGUMENT = re.compile(rb"\s*('(?:[^']|'')*'(?!')|\((?:[^()']|'(?:[^']|'')*'(?!'))*\)|[^,()']*)\s*([,)])")

    def __init__(self, text: bytes) -> None:
        self.products: dict[str, str] = {}  # names by definition
        self.uses: dict[str, list[tuple[set[str], str]]] = {}  # texts of a use, and the definition that is used
        names: dict[str, str] = {}
        formations: dict[str, str] = {}
        definitions: dict[str, str] = {}
        for match in self._ENTITY.finditer(text):
            number, kind = match[1].decode(), match[2].decode()
            arguments = self._arguments(text, match.end())
            if kind == "PRODUCT" and len(arguments) > 1:
                names[number] = arguments[1].strip() or arguments[0].strip()
            elif kind.startswith("PRODUCT_DEFINITION_FORMATION") and len(arguments) > 2:
                formations[number] = arguments[2]
            elif kind.startswith("PRODUCT_DEFINITION") and len(arguments) > 2:
                definitions[number] = arguments[2]
            elif kind.startswith("NEXT") and len(arguments) > 4:
                texts = {argument.strip() for argument in [*arguments[:3], *arguments[5:6]]}
                self.uses.setdefault(arguments[3], []).append((texts, arguments[4]))
        for number, formation in definitions.items():
            product = formations.get(formation.lstrip("#"), "").lstrip("#")
            self.products["#" + number] = names.get(product, "")

    def roots(self) -> list[str]:
        """The definitions that no other uses."""
        used = {definition for uses in self.uses.values() for _, definition in uses}
        return [definition for definition in self.products if definition not in used]

    def _arguments(self, text: bytes, begin: int) -> list[str]:
        arguments = []
        while match := self._ARGUMENT.match(text, begin):
            arguments.append(_step_text(match[1]))
            begin = match.end()
            if match[2] == b")":
                break
        return arguments


def _step_text(argument: bytes) -> str:
    """A string of STEP without its quotes and control directives (ISO 10303-21, 6.4.3); other arguments as they are."""
    text = argument.strip().decode("utf-8", "replace")
    if not text.startswith("'"):
        return text

    def wide(match: re.Match[str]) -> str:
        encoding = "utf-16-be" if match[1] == "2" else "utf-32-be"
        return bytes.fromhex(match[2]).decode(encoding, "replace")

    text = text[1:-1].replace("''", "'")
    with contextlib.suppress(ValueError):
        text = re.sub(r"\\X([24])\\([0-9A-F]*)\\X0\\", wide, text)
        text = re.sub(r"\\X\\([0-9A-F]{2})", lambda match: chr(int(match[1], 16)), text)
        text = re.sub(r"\\S\\(.)", lambda match: chr(ord(match[1]) + 128), text)
    return text.replace("\\\\", "\\")


def _step_units(text: bytes) -> list[str]:
    """The units of lengths that shapes have, such as "millimetre"."""
    used: set[bytes] = set()
    for match in re.finditer(rb"GLOBAL_UNIT_ASSIGNED_CONTEXT\s*\(\s*\(([^)]*)\)", text):
        used.update(re.findall(rb"#(\d+)", match[1]))
    units = set()
    for match in re.finditer(rb"#(\d+)\s*=\s*\(([^;]*?LENGTH_UNIT[^;]*)\)\s*;", text):
        if match[1] in used:
            units.add(_name_of_unit(match[2]))
    return sorted(filter(None, units))


def _name_of_unit(entity: bytes) -> str:
    if match := re.search(rb"CONVERSION_BASED_UNIT\s*\(\s*'([^']*)'", entity):
        return match[1].decode("ascii", "replace").lower()
    if match := re.search(rb"SI_UNIT\s*\(\s*(?:\.(\w+)\.|\$)\s*,\s*\.(\w+)\.", entity):
        return ((match[1] or b"") + match[2]).decode("ascii", "replace").lower()
    return ""


def _size_of_vertices(text: bytes, meters: float) -> float:
    """The diagonal in metres of the box around all vertices: near that of the shapes, whose places it leaves out.

    Other points are no measure: a plane's own may be far away.
    """
    vertices = set(re.findall(rb"VERTEX_POINT\s*\(\s*'[^']*'\s*,\s*#(\d+)", text))
    number = rb"\s*([-+0-9.Ee]+)\s*"
    point = rb"#(\d+)\s*=\s*CARTESIAN_POINT\s*\(\s*'[^']*'\s*,\s*\(" + rb",".join([number] * 3) + rb"\)"
    low, high = [math.inf] * 3, [-math.inf] * 3
    for match in re.finditer(point, text):
        if match[1] not in vertices:
            continue
        with contextlib.suppress(ValueError):
            for axis in range(3):
                value = float(match[axis + 2])
                low[axis], high[axis] = min(low[axis], value), max(high[axis], value)
    return meters * math.dist(low, high) if low[0] <= high[0] else 0.0


# GLB


class Glb:
    """The JSON of a GLB, and all that comes after it."""

    def __init__(self, data: bytes) -> None:
        if len(data) < 20 or data[:4] != b"glTF":
            raise CadError("has no shapes that OpenCASCADE can read")
        length = struct.unpack_from("<I", data, 12)[0]
        self.json: dict[str, Any] = json.loads(data[20 : 20 + length].decode("utf-8", "replace"))
        self.rest = data[20 + length :]

    def bytes(self) -> bytes:
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        length = 20 + len(text) + len(self.rest)
        return b"glTF" + struct.pack("<IIII", 2, length, len(text), 0x4E4F534A) + text + self.rest

    def nodes(self) -> list[dict[str, Any]]:
        return self.json.get("nodes", [])

    def roots(self) -> list[int]:
        scenes = self.json.get("scenes", [])
        return scenes[self.json.get("scene", 0)].get("nodes", []) if scenes else []

    def mesh_name(self, node: dict[str, Any]) -> str:
        return self.json["meshes"][node["mesh"]].get("name", "") if "mesh" in node else ""

    def size(self) -> float:
        """The diagonal in metres of the box around all."""
        low, high = [math.inf] * 3, [-math.inf] * 3
        for mesh, matrix in self._placed_meshes():
            for primitive in self.json["meshes"][mesh]["primitives"]:
                box = self.json["accessors"][primitive["attributes"]["POSITION"]]
                for corner in itertools.product(*zip(box["min"], box["max"])):
                    for axis in range(3):
                        value = sum(matrix[axis][i] * corner[i] for i in range(3)) + matrix[axis][3]
                        low[axis], high[axis] = min(low[axis], value), max(high[axis], value)
        return math.dist(low, high) if low[0] <= high[0] else 0.0

    def _placed_meshes(self) -> Iterator[tuple[int, list[list[float]]]]:
        identity = [[float(row == column) for column in range(4)] for row in range(3)]
        open_nodes = [(root, identity) for root in self.roots()]
        while open_nodes:
            number, parent = open_nodes.pop()
            node = self.nodes()[number]
            matrix = _product(parent, _matrix_of(node))
            if "mesh" in node:
                yield node["mesh"], matrix
            open_nodes += [(child, matrix) for child in node.get("children", [])]


def _matrix_of(node: dict[str, Any]) -> list[list[float]]:
    if "matrix" in node:
        return [[node["matrix"][4 * column + row] for column in range(4)] for row in range(3)]
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    scale = node.get("scale", (1.0, 1.0, 1.0))
    rotation = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )
    moved = node.get("translation", (0.0, 0.0, 0.0))
    return [[*(rotation[r][c] * scale[c] for c in range(3)), moved[r]] for r in range(3)]


def _product(a: Sequence[Sequence[float]], b: Sequence[Sequence[float]]) -> list[list[float]]:
    return [
        [sum(a[r][i] * b[i][c] for i in range(3)) + (a[r][3] if c == 3 else 0.0) for c in range(4)]
        for r in range(3)
    ]


# What cascadio leaves to be mended


def _is_numbered(name: str) -> bool:
    """Whether a name is a number that a program gave: "NAUO12", "12" or OpenCASCADE's "=>[0:1:1:2]"."""
    return bool(re.fullmatch(r"(NAUO)?\d*|=>\[.*", name))


def mend_axes(glb: Glb) -> None:
    """Have Y be upwards, as glTF says. cascadio leaves Z so, as CAD has it."""
    upright = [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, -1.0, 0.0, 0.0]]
    for root in glb.roots():
        node = glb.nodes()[root]
        matrix = [*_product(upright, _matrix_of(node)), [0.0, 0.0, 0.0, 1.0]]
        for key in ("translation", "rotation", "scale"):
            node.pop(key, None)
        node["matrix"] = [matrix[row][column] for column in range(4) for row in range(4)]


def mend_names(glb: Glb, step: StepNames, unnamed: str) -> None:
    """Give nodes the names of instances where these say something, and of products elsewhere."""
    roots = step.roots()
    named = {step.products[root]: root for root in roots}
    open_nodes = [
        (root, named.get(glb.nodes()[root].get("name", ""), roots[0] if len(roots) == 1 else None))
        for root in glb.roots()
    ]
    while open_nodes:
        number, definition = open_nodes.pop()
        node = glb.nodes()[number]
        instance = node.get("name", "").strip()
        product = (step.products.get(definition or "", "") or glb.mesh_name(node)).strip()
        names = [name for name in (instance, product) if not _is_numbered(name)]
        node["name"] = (names or [product or instance or unnamed])[0]
        uses = list(step.uses.get(definition or "", []))
        for child in node.get("children", []):
            used = _take_use(uses, glb.nodes()[child].get("name", "").strip())
            open_nodes.append((child, used))


def _take_use(uses: list[tuple[set[str], str]], name: str) -> str | None:
    for i, (texts, definition) in enumerate(uses):
        if name in texts:
            del uses[i]
            return definition
    return None


def mend_materials(glb: Glb) -> None:
    """Give materials that have a colour alone, and shapes that have none, a look other than glTF's bare metal."""
    plain = {"metallicFactor": 0.0, "roughnessFactor": 0.5}
    materials = glb.json.setdefault("materials", [])
    for material in materials:
        look = material.setdefault("pbrMetallicRoughness", {})
        for factor, value in plain.items():
            look.setdefault(factor, value)
    grey = len(materials)
    for mesh in glb.json.get("meshes", []):
        for primitive in mesh["primitives"]:
            primitive.setdefault("material", grey)
            if primitive["material"] == grey == len(materials):
                look = {"baseColorFactor": _GREY, **plain}
                materials.append({"name": f"mat_{grey}", "pbrMetallicRoughness": look, "doubleSided": True})
    if not materials:
        del glb.json["materials"]


# The conversion


def _tessellate(data: bytes, kind: str, tolerance: float, angle: float) -> Glb:
    import cascadio

    try:
        with _Captured() as printed:
            made = cascadio.load(data, file_type=kind, tol_linear=1000 * tolerance, tol_angular=angle)
    except RuntimeError as error:
        raise CadError(f"is damaged: OpenCASCADE fails with {' '.join(str(error).split())}") from None
    # OpenCASCADE goes on after an error of grammar.
    if re.search(r"ERR StepFile\b", printed.text):
        line = re.search(r"(Line \d+: [^*\n]*)", printed.text)
        what = "l" + line[1].strip()[1:] if line else "it is not what STEP's grammar says"
        raise CadError(f"is damaged: {what}")
    return Glb(made)


class _Captured:
    """Takes what libraries print, which is not to be among this process's own lines."""

    text = ""

    def __enter__(self) -> _Captured:
        self._file = tempfile.TemporaryFile()
        self._kept = [os.dup(descriptor) for descriptor in (1, 2)]
        for descriptor in (1, 2):
            os.dup2(self._file.fileno(), descriptor)
        return self

    def __exit__(self, *_: object) -> None:
        for descriptor, old in zip((1, 2), self._kept):
            os.dup2(old, descriptor)
            os.close(old)
        self._file.seek(0)
        self.text = self._file.read().decode("utf-8", "replace")
        self._file.close()


def _check_step(data: bytes) -> None:
    if b"ISO-10303-21" not in data[:4096]:
        raise CadError("is not STEP: it does not begin with ISO-10303-21")
    if b"END-ISO-10303-21" not in data[-4096:]:
        raise CadError("is cut off: END-ISO-10303-21 is missing at its end")


def convert(data: bytes, kind: str, unnamed: str, tolerance: float, angle: float) -> Glb:
    """Make a GLB of a file's bytes. tolerance is in metres, or 0 for a default by size."""
    if 0.0 < tolerance < _LEAST_TOLERANCE:
        raise CadError(f"cannot be made into triangles: its tolerance must be {_LEAST_TOLERANCE:g} metres at least")
    units: list[str] = []
    guess = tolerance or 1e-4
    if kind == "step":
        _check_step(data)
        units = _step_units(data)
        if not tolerance:
            meters = _METERS.get(units[0] if units else "", 0.001)
            guess = max(_TOLERANCE_OF_SIZE * _size_of_vertices(data, meters) or guess, _LEAST_TOLERANCE)
    glb = _tessellate(data, kind, guess, angle)
    wanted = tolerance or max(_TOLERANCE_OF_SIZE * glb.size(), _LEAST_TOLERANCE)
    if not 0.5 <= guess / wanted <= 2.0:
        guess = wanted
        glb = _tessellate(data, kind, guess, angle)
    mend_names(glb, StepNames(data if kind == "step" else b""), unnamed)
    mend_materials(glb)
    mend_axes(glb)
    extras = {"tolerance": f"{guess:g}", "angle": f"{angle:g}", "converter": version()}
    if units:
        extras["lengthUnit"] = " and ".join(units)
    glb.json["asset"]["extras"] = extras
    return glb


def version() -> str:
    from importlib import metadata  # It is slow to load, and the program vitrine waits for this module.

    try:
        return f"_cad.py {CONVERSION}, cascadio {metadata.version('cascadio')}"
    except metadata.PackageNotFoundError:
        raise CadError(_MISSING) from None


def _convert_file(arguments: argparse.Namespace) -> None:
    source, output = pathlib.Path(arguments.INPUT), pathlib.Path(arguments.OUTPUT)
    suffix = source.suffix.lower()
    if suffix not in (*_STEP, *_IGES):
        raise CadError(f"is not of a kind that is converted here: {', '.join((*_STEP, *_IGES))}")
    version()
    if arguments.progress:
        print("progress 0 making triangles", file=sys.stderr, flush=True)
    kind = "step" if suffix in _STEP else "iges"
    glb = convert(source.read_bytes(), kind, source.stem, arguments.tolerance, arguments.angle)
    unfinished = output.with_name(f"{output.name}.part{os.getpid()}")
    try:
        unfinished.write_bytes(glb.bytes())
        unfinished.replace(output)
    except OSError as error:
        unfinished.unlink(missing_ok=True)
        raise CadError(f"cannot be written: {error.strerror}") from None


def _main() -> int:
    parser = argparse.ArgumentParser(prog="_cad.py", description="Convert STEP or IGES to GLB, in metres, Y upwards.")
    parser.add_argument("INPUT", nargs="?")
    parser.add_argument("OUTPUT", nargs="?")
    parser.add_argument("--tolerance", type=float, default=0.0, help="metres; 0 for a thousandth of the diagonal")
    parser.add_argument("--angle", type=float, default=_ANGLE, help="radians between neighbouring normals")
    parser.add_argument("--progress", action="store_true", help="print lines of progress on stderr")
    parser.add_argument("--version", action="store_true", help="print the version")
    arguments = parser.parse_args()
    try:
        if arguments.version:
            print(version())
        elif not arguments.INPUT or not arguments.OUTPUT:
            raise CadError("INPUT and OUTPUT are needed")
        else:
            _convert_file(arguments)
    except CadError as error:
        problem = str(error)
    except OSError as error:
        problem = f"cannot be read: {error.strerror}"
    except MemoryError:
        problem = "is damaged, or needs more memory than there is"
    else:
        return 0
    print(": ".join(text for text in ("_cad.py", arguments.INPUT, problem) if text), file=sys.stderr)
    return 2


if __name__ == "__main__":
    # The folder of this file holds the modules of a package, which must not hide others.
    sys.path = [entry for entry in sys.path if entry != str(pathlib.Path(__file__).resolve().parent)]
    sys.exit(_main())
