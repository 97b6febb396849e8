"""Compares GLBs with twins that gltf-transform and this script make of them: parts, triangles, bounds and pictures.

    VITRINE_PROGRAM=build/release/bin/vitrine python3 Testing/Program/twin_figures.py FILE.glb... \
        [--by 'npx @gltf-transform/cli']

Twins are made by `copy`, `draco`, `meshopt`, `quantize` and `instance`, and here by texture coordinates that
KHR_texture_transform turns back. Bounds are told in steps of 14 bits of the model, by which the tools quantize.
Instances have no names, so that their bounds are those of the whole.
"""

import argparse
import json
import pathlib
import shlex
import struct
import subprocess
import tempfile

from program import info, read_png, run

KINDS = ("copy", "draco", "meshopt", "quantize", "instance", "texture transform")
STEPS = (1 << 14) - 1
OFFSET, SCALE = (0.25, -0.5), (2.0, 0.5)  # exact in binary


def with_texture_transforms(data):
    """A GLB with other texture coordinates, and transforms that turn them back; None if it has no floats of them."""
    length = struct.unpack_from("<I", data, 12)[0]
    glb, binary = json.loads(data[20 : 20 + length]), bytearray(data[28 + length :])
    sets = {
        number
        for mesh in glb.get("meshes", [])
        for primitive in mesh["primitives"]
        for name, number in primitive["attributes"].items()
        if name.startswith("TEXCOORD_")
    }
    if not sets or any(glb["accessors"][number]["componentType"] != 5126 for number in sets):
        return None
    for number in sets:
        accessor = glb["accessors"][number]
        view = glb["bufferViews"][accessor["bufferView"]]
        first = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        for i in range(accessor["count"]):
            at = first + i * view.get("byteStride", 8)
            u, v = struct.unpack_from("<2f", binary, at)
            struct.pack_into("<2f", binary, at, (u - OFFSET[0]) / SCALE[0], (v - OFFSET[1]) / SCALE[1])
    transform = {"KHR_texture_transform": {"offset": OFFSET, "scale": SCALE}}
    for material in glb.get("materials", []):
        for owner in (material, material.get("pbrMetallicRoughness", {})):
            for key, use in owner.items():
                if key.endswith("Texture"):
                    use["extensions"] = transform
    glb["extensionsUsed"] = sorted({*glb.get("extensionsUsed", []), "KHR_texture_transform"})
    text = json.dumps(glb).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x4E4942) + binary
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def make_twin(kind, file, twin, command):
    """Whether there is such a twin."""
    if kind == "texture transform":
        data = with_texture_transforms(file.read_bytes())
        twin.write_bytes(data or b"")
        return data is not None
    result = subprocess.run([*command, kind, file, twin], capture_output=True, check=False)
    return result.returncode == 0


class Opened:
    """What a file is opened to."""

    def __init__(self, file, picture):
        told = info(file, "--parts")
        self.parts = {part["path"]: part["bounds"] for part in told["part_list"]}
        self.triangles = told["triangles"]
        self.bounds = told["bounds"]
        result = run("render", file, "--size", "256x256", "-o", picture)
        if result.returncode != 0:
            raise SystemExit(result.stderr.decode())
        self.values = b"".join(map(bytes, read_png(picture)[2]))

    def steps_to(self, other):
        """The greatest difference of bounds of a part, or of the whole where the names are others."""
        step = max(self.bounds[axis + 1] - self.bounds[axis] for axis in (0, 2, 4)) / STEPS
        pairs = [(self.bounds, other.bounds)]
        if self.parts.keys() == other.parts.keys():
            pairs += [(bounds, other.parts[path]) for path, bounds in self.parts.items()]
        return max(abs(a - b) for left, right in pairs for a, b in zip(left, right)) / step

    def pixels_off(self, other):
        """Percent of pixels that differ at all, and that differ by more than 1/255."""
        changes = [max(map(abs, map(int.__sub__, pair[0], pair[1])))
                   for pair in zip(zip(*[iter(self.values)] * 3), zip(*[iter(other.values)] * 3))]  # fmt: skip
        return [100 * sum(change > least for change in changes) / len(changes) for least in (0, 1)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--by", default="npx @gltf-transform/cli", metavar="COMMAND")
    arguments = parser.parse_args()
    print("| file | twin | parts | triangles | bounds off, steps | pixels off, % | by more than 1/255, % |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file in arguments.files:
            plain = Opened(file, folder / "picture.png")
            for kind in KINDS:
                path = folder / file.name
                if not make_twin(kind, file, path, shlex.split(arguments.by)):
                    print(f"| {file.name} | {kind} | none is made | | | | |", flush=True)
                    continue
                twin = Opened(path, folder / "picture.png")
                off = plain.pixels_off(twin)
                print(f"| {file.name} | {kind} | {len(twin.parts) - len(plain.parts):+d} "
                      f"| {twin.triangles - plain.triangles:+d} | {plain.steps_to(twin):.2f} "
                      f"| {off[0]:.3f} | {off[1]:.3f} |", flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
