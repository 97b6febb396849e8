#!/usr/bin/env python3
"""Make a GLB's transmission plain transparency, which VTK's importer reads.

    blend_transmission.py SOURCE.glb RESULT.glb

A material of KHR_materials_transmission becomes one of alphaMode BLEND. Its alpha is multiplied by 1 - 0.7 times its
transmissionFactor, unless it was of BLEND already. KHR_materials_volume goes too. All else stays as it is.
"""

import json
import struct
import sys

HIDDEN = 0.7  # of what a wholly transmitting surface would hide
JSON_CHUNK = 0x4E4F534A


def blend(material):
    transmission = material["extensions"].pop("KHR_materials_transmission")
    material["extensions"].pop("KHR_materials_volume", None)
    if material.get("alphaMode") != "BLEND":
        color = material.setdefault("pbrMetallicRoughness", {}).setdefault("baseColorFactor", [1, 1, 1, 1])
        color[3] *= 1 - HIDDEN * transmission.get("transmissionFactor", 0)
        material["alphaMode"] = "BLEND"


def convert(source):
    """The bytes of the result."""
    if len(source) < 20 or source[:8] != struct.pack("<4sI", b"glTF", 2):
        sys.exit("blend_transmission.py: the source is no GLB file of glTF 2")
    length, kind = struct.unpack("<II", source[12:20])
    if kind != JSON_CHUNK or struct.unpack("<I", source[8:12])[0] != len(source) or 20 + length > len(source):
        sys.exit("blend_transmission.py: the source is damaged")
    document = json.loads(source[20 : 20 + length])
    for material in document.get("materials", []):
        if "KHR_materials_transmission" in material.get("extensions", {}):
            blend(material)
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    rest = source[20 + length :]
    header = struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), JSON_CHUNK)
    return header + text + rest


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: blend_transmission.py SOURCE.glb RESULT.glb")
    with open(sys.argv[1], "rb") as file:
        result = convert(file.read())
    with open(sys.argv[2], "wb") as file:
        file.write(result)


if __name__ == "__main__":
    main()
