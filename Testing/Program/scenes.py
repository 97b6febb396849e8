"""Small files of every kind that the program reads: two boxes that stand side by side."""

import base64
import itertools
import json
import lzma
import struct

CORNERS = [tuple(map(float, corner)) for corner in itertools.product((0, 1), repeat=3)]
TRIANGLES = [
    (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
    (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3),
]  # fmt: skip


def gltf_document(binary_length, uri=None):
    buffer = {"byteLength": binary_length}
    if uri is not None:
        buffer["uri"] = uri
    positions = 4 * 3 * len(CORNERS)
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [
            {"name": "machine", "children": [1, 2]},
            {"name": "left box", "mesh": 0},
            {"name": "right box", "mesh": 1, "translation": [1.5, 0.0, 0.0]},
        ],
        "meshes": [
            {"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": material}]}
            for material in (0, 1)
        ],
        "materials": [
            {
                "name": "glass",
                "alphaMode": "BLEND",
                "doubleSided": True,
                "pbrMetallicRoughness": {"baseColorFactor": [0.2, 0.4, 0.8, 0.25]},
            },
            {"name": "wall", "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.4, 0.2, 0.25]}},
        ],
        "buffers": [buffer],
        "bufferViews": [
            {"buffer": 0, "byteLength": positions},
            {"buffer": 0, "byteOffset": positions, "byteLength": 6 * len(TRIANGLES)},
        ],
        "accessors": [
            {
                "bufferView": 0, "componentType": 5126, "count": len(CORNERS), "type": "VEC3",
                "min": [0.0, 0.0, 0.0], "max": [1.0, 1.0, 1.0],
            },
            {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"},
        ],
    }  # fmt: skip


def gltf_binary(corners=tuple(CORNERS), triangles=tuple(TRIANGLES)):
    data = b"".join(struct.pack("<3f", *corner) for corner in corners)
    return data + b"".join(struct.pack("<3H", *triangle) for triangle in triangles)


def pack_glb(document, binary):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    length = 12 + 8 + len(text) + 8 + len(binary)
    return (
        struct.pack("<4sII", b"glTF", 2, length)
        + struct.pack("<I4s", len(text), b"JSON") + text
        + struct.pack("<I4s", len(binary), b"BIN\0") + binary
    )  # fmt: skip


def glb():
    binary = gltf_binary()
    return pack_glb(gltf_document(len(binary)), binary)


def gltf():
    binary = gltf_binary()
    uri = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
    return json.dumps(gltf_document(len(binary), uri)).encode()


def obj(material_library="boxes.mtl"):
    lines = [f"mtllib {material_library}"]
    for box, shift in (("left", 0.0), ("right", 1.5)):
        lines += [f"v {x + shift} {y} {z}" for x, y, z in CORNERS]
        offset = 1 if box == "left" else 9
        lines += [f"o {box} box", f"usemtl {box}"]
        lines += ["f " + " ".join(str(i + offset) for i in t) for t in TRIANGLES]
    return ("\n".join(lines) + "\n").encode()


def mtl():
    return b"newmtl left\nKd 0.2 0.4 0.8\nd 0.25\nnewmtl right\nKd 0.8 0.4 0.2\nd 1.0\n"


def binary_stl():
    data = b"two boxes".ljust(80, b" ") + struct.pack("<I", 2 * len(TRIANGLES))
    for shift in (0.0, 1.5):
        for triangle in TRIANGLES:
            data += struct.pack("<3f", 0.0, 0.0, 1.0)
            for i in triangle:
                x, y, z = CORNERS[i]
                data += struct.pack("<3f", x + shift, y, z)
            data += b"\0\0"
    return data


def text_stl(name="boxes"):
    lines = [f"solid {name}"]
    for triangle in TRIANGLES:
        lines += ["facet normal 0 0 1", "outer loop"]
        lines += ["vertex {} {} {}".format(*CORNERS[i]) for i in triangle]
        lines += ["endloop", "endfacet"]
    return ("\n".join([*lines, f"endsolid {name}"]) + "\n").encode()


def ply_header(form):
    return (
        f"ply\nformat {form} 1.0\ncomment a box\nelement vertex {len(CORNERS)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        f"element face {len(TRIANGLES)}\nproperty list uchar int vertex_indices\nend_header\n"
    ).encode()


def binary_ply(order="<"):
    data = ply_header("binary_little_endian" if order == "<" else "binary_big_endian")
    data += b"".join(struct.pack(order + "3f3B", *corner, 200, 100, 50) for corner in CORNERS)
    return data + b"".join(struct.pack(order + "B3i", 3, *triangle) for triangle in TRIANGLES)


def text_ply():
    lines = ["{} {} {} 200 100 50".format(*corner) for corner in CORNERS]
    lines += ["3 {} {} {}".format(*triangle) for triangle in TRIANGLES]
    return ply_header("ascii") + ("\n".join(lines) + "\n").encode()


def xml_array(kind, name, values, components=1):
    return (
        f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">'
        + " ".join(map(str, values))
        + "</DataArray>"
    )


def vtp(corners=tuple(CORNERS), triangles=tuple(TRIANGLES)):
    points = xml_array("Float32", "Points", itertools.chain(*corners), 3)
    corner_ids = xml_array("Int64", "connectivity", itertools.chain(*triangles))
    offsets = xml_array("Int64", "offsets", range(3, 3 * len(triangles) + 1, 3))
    return (
        '<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>'
        f'<Piece NumberOfPoints="{len(corners)}" NumberOfPolys="{len(triangles)}">'
        f"<Points>{points}</Points><Polys>{corner_ids}{offsets}</Polys>"
        "</Piece></PolyData></VTKFile>"
    ).encode()


def vtm(*files):
    blocks = "".join(
        f'<DataSet index="{i}" name="block {i}" file="{name}"/>' for i, name in enumerate(files)
    )
    return (
        '<VTKFile type="vtkMultiBlockDataSet" version="1.0" byte_order="LittleEndian">'
        f"<vtkMultiBlockDataSet>{blocks}</vtkMultiBlockDataSet></VTKFile>"
    ).encode()


QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
HEXAHEDRON = (0, 4, 6, 2, 1, 5, 7, 3)  # corners in VTK's order
KIND_OF_CORNERS = {4: 9, 8: 12}  # VTK_QUAD, VTK_HEXAHEDRON
TWO_BOXES = [(x + shift, y, z) for shift in (0.0, 1.5) for x, y, z in CORNERS]


def cells_of_two_boxes(cells):
    return [tuple(i + offset for i in cell) for offset in (0, 8) for cell in cells]


def vtu(points=tuple(TWO_BOXES), cells=tuple(cells_of_two_boxes(QUADS)), kinds=None, point_arrays="", cell_arrays=""):
    """A grid of two boxes. Arrays are elements of xml_array()."""
    ends = list(itertools.accumulate(map(len, cells)))
    kinds = kinds or [KIND_OF_CORNERS[len(cell)] for cell in cells]
    return (
        '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>'
        f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">'
        f"<PointData>{point_arrays}</PointData><CellData>{cell_arrays}</CellData>"
        f'<Points>{xml_array("Float32", "Points", itertools.chain(*points), 3)}</Points>'
        f'<Cells>{xml_array("Int64", "connectivity", itertools.chain(*cells))}'
        f'{xml_array("Int64", "offsets", ends)}{xml_array("UInt8", "types", kinds)}</Cells>'
        "</Piece></UnstructuredGrid></VTKFile>"
    ).encode()


def legacy_vtk(points=tuple(TWO_BOXES), cells=tuple(cells_of_two_boxes(QUADS)), kinds=None):
    kinds = kinds or [KIND_OF_CORNERS[len(cell)] for cell in cells]
    lines = ["# vtk DataFile Version 3.0", "two boxes", "ASCII", "DATASET UNSTRUCTURED_GRID"]
    lines += [f"POINTS {len(points)} float", *(" ".join(map(str, point)) for point in points)]
    lines += [f"CELLS {len(cells)} {sum(1 + len(cell) for cell in cells)}"]
    lines += [" ".join(map(str, (len(cell), *cell))) for cell in cells]
    lines += [f"CELL_TYPES {len(kinds)}", *map(str, kinds)]
    return ("\n".join(lines) + "\n").encode()


def vtpd(*files):
    pieces = "".join(f'<DataSet index="{i}" file="{name}"/>' for i, name in enumerate(files))
    return (
        '<VTKFile type="vtkPartitionedDataSet" version="1.0" byte_order="LittleEndian">'
        f"<vtkPartitionedDataSet>{pieces}</vtkPartitionedDataSet></VTKFile>"
    ).encode()


def vtpc(parts, hierarchy=None):
    """A collection. `parts` has the files of each name, and `hierarchy` is the XML of a vtkDataAssembly."""
    body = ""
    for i, (name, files) in enumerate(parts.items()):
        pieces = "".join(f'<DataSet index="{j}" file="{file}"/>' for j, file in enumerate(files))
        body += f'<Partitions index="{i}" name="{name}">{pieces}</Partitions>'
    if hierarchy is not None:
        encoded = base64.b64encode(hierarchy.encode()).decode()
        body += f'<DataAssembly encoding="base64">{encoded}</DataAssembly>'
    return (
        '<VTKFile type="vtkPartitionedDataSetCollection" version="1.0" byte_order="LittleEndian">'
        f"<vtkPartitionedDataSetCollection>{body}</vtkPartitionedDataSetCollection></VTKFile>"
    ).encode()


def vtkhdf():
    """Two tetrahedra on a common triangle with the array T of 0 to 4 at the points, as VTK 9.6's writer made it."""
    return lzma.decompress(base64.b64decode(VTKHDF))


VTKHDF = (
    "/Td6WFoAAATm1rRGAgAhARwAAAAQz1jM4F9XAtBdAESSBIRvent3SsRmT2odD3JpHhjMHwQgHlv6tmjdTs0VKNJ0R2WZiizT"
    "qaTwDQabdgd2VSfTDNRL6hLod+jzzKPFaBoE43rao3GBJ6vZjp+ovLdc+B2wWTniiXzCi+sW4QFArPf1zVpKuHlZ9BaTrJX8"
    "SOhEts79pA2hgcN2imNkwfUFoELRuKW3kuVSvM2MXLmGaXAFBJYQGuzioqTWF6sxSirc3x1eJ3B1o/lsHNdsNWgzgKLZFsOF"
    "pd7gh6Kvg2pfQbtpskTQt3mmkmSLxSKgpAJ0mOSihewZy0gN9aiWAJO0+pIt6rO50tsId/VCOqeyM+CS2pi4K8eqwc2nuW4p"
    "CcgcqQYbXqvrO0jUiuF1FvVkmrnkfSWIJI98NDzenvQTDwIcPW41lFIzyOX4T8X+SkhWCpQ1+GgcJ5QwBUMfz6GO5cmsfQ53"
    "Lyf1tO2PstWMr+tKpxP+bIHKyfQ4oxzbALGlDIyKbGTSDennzfb/zHXYeydh1Xy+tXKepvXGDu92mzMrZQisX//a5CsXW1E5"
    "8q9Uwcs9VUro22ZnXS+Pnk4CQv+n/tsqDSId4pxkCVMeG2Wx0KDWvse0vb4BxG1bTlpyjV6cMoSJpEaW71F6tF32fO+JN2yU"
    "SOj1VQTGxjhg/PVPgpy9HE6ql7epK3+xf7JYnB9fkgE/9+gYW7qADQxjs/mbqB3AeZWXjORN0kbVkhm8C7joWH2deYDtOqFH"
    "Y6g8D0aNvdPryLTelM1ut+M7zLHx8tFOZKihV3UBSxLqQAm/Wneq6EVm8h3S5QKIXvGpImlOgRlPWqsaBy4b1zArK1dWKcA5"
    "uR6QkXKstXuNVleLGYHDsJrGH5Gj53mIdZssSn7OGO7j4cfQTBoOHK/b/ESEdbc0jeDewtDtyS1FjjijTeSoEnO0QgmHPpsw"
    "HuNBbfRViDRjjAF+Ll3UiN8ZCtM0kKNCwdDdhmsgVgDfeCHFdBrU1QAB7AXYvgEAefMIX7HEZ/sCAAAAAARZWg=="
)


def write_all(folder):
    """Write a file of each kind; their paths."""
    (folder / "boxes.mtl").write_bytes(mtl())
    (folder / "leaf.vtp").write_bytes(vtp())
    kinds = {
        "boxes.glb": glb(), "boxes.gltf": gltf(), "boxes.obj": obj(), "boxes.stl": binary_stl(),
        "text.stl": text_stl(), "boxes.ply": binary_ply(), "big.ply": binary_ply(">"), "text.ply": text_ply(),
        "boxes.vtp": vtp(), "boxes.vtm": vtm("leaf.vtp", "leaf.vtp"), "boxes.vtu": vtu(), "boxes.vtk": legacy_vtk(),
        "boxes.vtpd": vtpd("leaf.vtp", "leaf.vtp"), "boxes.vtpc": vtpc({"a": ["leaf.vtp"], "b": ["leaf.vtp"]}),
    }  # fmt: skip
    paths = []
    for name, content in kinds.items():
        (folder / name).write_bytes(content)
        paths.append(folder / name)
    return paths
