"""A small assembly whose names, places and materials are known, as a GLB, and the same scene of plain actors."""

import json
import pathlib
import struct
import tempfile
import unittest
import zlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProperty, vtkRenderer

import vitrine

MATERIALS = {  # base colour with alpha, roughness
    "Grey paint": ((0.5, 0.5, 0.5, 1.0), 0.75),
    "glass, clear": ((0.25, 0.5, 1.0, 0.25), 0.5),
    "steel": ((0.75, 0.5, 0.25, 1.0), 0.25),
}
# Cubes of a length of 1, by path: material, and centre and scale in world coordinates.
BOXES = {
    "/Machine/Housing/lid": ("Grey paint", (-2, 2, 0), (2, 1, 1)),
    "/Machine/Housing/window": ("glass, clear", (2, 2, 0), (1, 1, 1)),
    "/Machine/Gearbox/gear-1": ("steel", (-2, -2, 0), (1, 1, 1)),
    "/Machine/Gearbox/gear-2": ("steel", (2, -2, 0), (1, 1, 1)),
    "/Machine/Gearbox/gear-2/bolt": ("Grey paint", (2, 0, 0), (0.5, 0.5, 0.5)),
}
PATHS = tuple(BOXES)
GAMMA = 2.2  # of physically based materials, whose colours are linear
SIZE = (80, 80)  # 10 pixels for a unit of length in machine_view()


def cube():
    """Points, normals and triangles of a cube around the origin."""
    points, normals, triangles = [], [], []
    for axis in range(3):
        for side in (-0.5, 0.5):
            first = len(points)
            for u, v in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
                point = [0.0, 0.0, 0.0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, u, v
                points.append(point)
                normals.append([2 * side if i == axis else 0.0 for i in range(3)])
            corners = [(0, 1, 2), (0, 2, 3)] if side > 0 else [(0, 2, 1), (0, 3, 2)]
            triangles += [[first + i for i in corner] for corner in corners]
    return (
        numpy.array(points, numpy.float32),
        numpy.array(normals, numpy.float32),
        numpy.array(triangles, numpy.uint32),
    )


def write_glb(file, nodes, roots, meshes, materials=()):
    """Write a GLB. Meshes are tuples (points, normals, triangles, number of the material or None)."""
    data, views, accessors, made = b"", [], [], []
    for points, normals, triangles, material in meshes:
        first = len(accessors)
        for array, count, kind, component in (
            (points, len(points), "VEC3", 5126),
            (normals, len(normals), "VEC3", 5126),
            (triangles, triangles.size, "SCALAR", 5125),
        ):
            views.append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes})
            accessors.append(
                {"bufferView": len(accessors), "componentType": component, "count": count, "type": kind}
            )
            if array is points:
                accessors[-1]["min"] = points.min(axis=0).tolist()
                accessors[-1]["max"] = points.max(axis=0).tolist()
            data += array.tobytes()
        primitive = {"attributes": {"POSITION": first, "NORMAL": first + 1}, "indices": first + 2}
        if material is not None:
            primitive["material"] = material
        made.append({"primitives": [primitive]})
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": roots}],
        "nodes": nodes,
        "meshes": made,
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": views,
        "accessors": accessors,
        "materials": list(materials),
    }
    write_chunks(file, document, data)


def write_chunks(file, document, data):
    """Write a GLB of its two chunks: JSON and binary data of whole words."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(data), 0x004E4942) + data
    head = struct.pack("<4sII", b"glTF", 2, 12 + len(chunks))
    pathlib.Path(file).write_bytes(head + chunks)


# A cube of a length of 1: 8 points and 12 triangles, as meshoptimizer 0.18 and Draco 1.5 encoded them.
MESHOPT_POINTS = bytes.fromhex(
    "a0000000013fff0000ffffffffffffff000000010ccc0000ffffff0000000100c00000ff00000000000000000000000000000000000000"
    "00000000bf000000bf000000bf"
)
MESHOPT_TRIANGLES = bytes.fromhex(
    "e1fe1eff1e7312a10f6712950ff004ff0202020000007687566778a9866589689801690000"
)
DRACO_MESH = bytes.fromhex(
    "445241434f02020101000000080c000b010003af3e0a01011001ff0000010009030000000000003f0000003f0000003f0000003f000000"
    "3f000000bf000000bf0000003f0000003f000000bf0000003f000000bf0000003f000000bf000000bf0000003f000000bf0000003f0000"
    "00bf000000bf0000003f000000bf000000bf000000bf"
)


def png(width, height, rows):
    """A PNG of RGB bytes. Its header may state another size than the rows have."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
    pixels = chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows)))
    return b"\x89PNG\r\n\x1a\n" + header + pixels + chunk(b"IEND", b"")


def write_textured(file, picture, is_unlit=False):
    """Write two squares beside each other, "left" and "right", of one material whose colour is a PNG."""
    corners = [(-0.4, -0.4, 0), (0.4, -0.4, 0), (0.4, 0.4, 0), (-0.4, 0.4, 0)]
    data = b"".join(struct.pack("<3f", *corner) for corner in corners)
    data += struct.pack("<8f", 0, 0, 1, 0, 1, 1, 0, 1) + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    begin = len(data)
    data += picture + bytes(-len(picture) % 4)
    views = [(0, 48), (48, 32), (80, 12), (begin, len(picture))]
    material = {"doubleSided": True, "pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 0}}}
    if is_unlit:
        material["extensions"] = {"KHR_materials_unlit": {}}
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [
            {"name": "left", "mesh": 0, "translation": [-0.5, 0, 0]},
            {"name": "right", "mesh": 0, "translation": [0.5, 0, 0]},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [material],
        "textures": [{"source": 0}],
        "images": [{"bufferView": 3, "mimeType": "image/png"}],
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": [{"buffer": 0, "byteOffset": first, "byteLength": size} for first, size in views],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-0.4, -0.4, 0],
             "max": [0.4, 0.4, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
    }  # fmt: skip
    write_chunks(file, document, data)


def write_compressed_cube(file, extension):
    """Write a cube that is compressed by an extension of glTF."""
    points = {"componentType": 5126, "count": 8, "type": "VEC3", "min": [-0.5] * 3, "max": [0.5] * 3}
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": [extension],
        "extensionsRequired": [extension],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "cube", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [points, {"componentType": 5125, "count": 36, "type": "SCALAR"}],
    }
    if extension == "KHR_draco_mesh_compression":
        parts = [DRACO_MESH]
        document["bufferViews"] = [{"buffer": 0, "byteLength": len(DRACO_MESH)}]
        compressed = {"bufferView": 0, "attributes": {"POSITION": 0}}
        document["meshes"][0]["primitives"][0]["extensions"] = {extension: compressed}
    else:
        parts = [MESHOPT_POINTS, MESHOPT_TRIANGLES]
        document["bufferViews"] = []
        begin, place = 0, 0
        for part, mode, stride, count in zip(parts, ("ATTRIBUTES", "TRIANGLES"), (12, 4), (8, 36)):
            compressed = {"buffer": 0, "byteOffset": begin, "byteLength": len(part)}
            compressed.update(byteStride=stride, count=count, mode=mode)
            view = {"buffer": 1, "byteOffset": place, "byteLength": stride * count}
            document["bufferViews"].append({**view, "extensions": {extension: compressed}})
            begin, place = begin + len(part) + -len(part) % 4, place + stride * count
        for number, accessor in enumerate(document["accessors"]):
            accessor["bufferView"] = number
    data = b"".join(part + bytes(-len(part) % 4) for part in parts)
    document["buffers"] = [{"byteLength": len(data)}]
    if extension != "KHR_draco_mesh_compression":
        document["buffers"].append({"byteLength": place, "extensions": {extension: {"fallback": True}}})
    write_chunks(file, document, data)


def write_machine(file):
    """Write the machine. gear-2 has a mesh and a node below, which stands 2 above it."""
    names = list(MATERIALS)
    materials = [
        {
            "name": name,
            "doubleSided": True,
            "alphaMode": "BLEND" if color[3] < 1 else "OPAQUE",
            "pbrMetallicRoughness": {
                "baseColorFactor": color,
                "metallicFactor": 0,
                "roughnessFactor": roughness,
            },
        }
        for name, (color, roughness) in MATERIALS.items()
    ]
    nodes = [
        {"name": "Machine", "children": [1, 2]},
        {"name": "Housing", "children": [3, 4]},
        {"name": "Gearbox", "children": [5, 6]},
    ]
    for path, (material, center, scale) in BOXES.items():
        place = {"translation": center, "scale": scale}
        if path.endswith("bolt"):
            place["translation"] = (0, 2, 0)
        name = path.rpartition("/")[2]
        nodes.append({"name": name, "mesh": names.index(material), **place})
    nodes[6]["children"] = [7]
    write_glb(file, nodes, [0], [(*cube(), i) for i in range(len(names))], materials)


def box_bounds(path):
    _, center, scale = BOXES[path]
    return tuple(center[i] + sign * scale[i] / 2 for i in range(3) for sign in (-1, 1))


def poly_data(points, normals, triangles):
    data = vtkPolyData()
    corners = vtkPoints()
    corners.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(corners)
    data.GetPointData().SetNormals(numpy_to_vtk(normals, deep=True))
    cells = vtkCellArray()
    for triangle in triangles:
        cells.InsertNextCell(3, [int(i) for i in triangle])
    data.SetPolys(cells)
    return data


def box_data(path):
    """A box in world coordinates."""
    _, center, scale = BOXES[path]
    points, normals, triangles = cube()
    placed = points * numpy.array(scale, numpy.float32) + numpy.array(center, numpy.float32)
    return poly_data(placed, normals, triangles)


def box_property(path):
    """What glTF says of the material of a box."""
    color, roughness = MATERIALS[BOXES[path][0]]
    made = vtkProperty()
    made.SetInterpolationToPBR()
    made.SetMetallic(0)
    made.SetRoughness(roughness)
    made.SetColor(color[:3])
    made.SetOpacity(color[3])
    return made


def plain_actor(path, **looks):
    """A box as an actor of its own: `opacity` and `color`, which is of sRGB, in place of its material's."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(box_data(path))
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetProperty(box_property(path))
    if "opacity" in looks:
        actor.GetProperty().SetOpacity(looks["opacity"])
    if "color" in looks:
        actor.GetProperty().SetColor([value**GAMMA for value in looks["color"]])
    return actor


def machine_view():
    """A renderer that looks down the z axis, from -4 to 4 in x and y."""
    renderer = vtkRenderer()
    renderer.SetBackground(0.0, 0.0, 0.5)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(4.0)
    camera.SetPosition(0, 0, 10)
    camera.SetClippingRange(1, 20)
    return renderer


def plain_view(looks=None, hidden=()):
    """The machine of plain actors, with other looks by path."""
    renderer = machine_view()
    for path in PATHS:
        if path not in hidden:
            renderer.AddActor(plain_actor(path, **(looks or {}).get(path, {})))
    return renderer


class Files(unittest.TestCase):
    """Tests with a folder of their own, which has the machine."""

    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "machine.glb"
        write_machine(self.file)
        self.machine = vitrine.load(self.file)

    def view(self, machine=None):
        renderer = machine_view()
        (machine or self.machine).add_to(renderer)
        return renderer
