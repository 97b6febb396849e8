"""3MF files: objects, components, items, colours and units, and what is wrong with them."""

import io
import json
import struct
import unittest
import zipfile
import zlib

import scenes
from program import FileTest, info, read_png, run

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
MODEL_TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
MATERIALS = (
    '<basematerials id="5"><base name="glass" displaycolor="#FF000040"/><base name="wall" displaycolor="#00FF00"/>'
    "</basematerials>"
)
COLORS = (
    '<m:colorgroup id="6"><m:color color="#FF0000"/><m:color color="#0000FF80"/><m:color color="#00FF00FF"/>'
    "</m:colorgroup>"
)
SHIFTED = "1 0 0 0 1 0 0 0 1 10 0 0"


def mesh(triangles=tuple(scenes.TRIANGLES), looks=None):
    """A box. `looks` has the attributes of each triangle."""
    vertices = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in scenes.CORNERS)
    looks = looks or [""] * len(triangles)
    faces = "".join(
        f'<triangle v1="{a}" v2="{b}" v3="{c}" {look}/>' for (a, b, c), look in zip(triangles, looks)
    )
    return f"<mesh><vertices>{vertices}</vertices><triangles>{faces}</triangles></mesh>"


def obj(number, content, attributes=""):
    return f'<object id="{number}" {attributes}>{content}</object>'


def components(*uses):
    """An object's components: numbers, and attributes."""
    inner = "".join(f'<component objectid="{number}" {more}/>' for number, more in uses)
    return f"<components>{inner}</components>"


def model(resources, items=((1, ""),), attributes='unit="meter"'):
    build = "".join(f'<item objectid="{number}" {more}/>' for number, more in items)
    return (
        f'<?xml version="1.0"?><model xmlns="{CORE}" xmlns:m="m" xmlns:p="p" {attributes}>'
        f"<resources>{resources}</resources><build>{build}</build></model>"
    )


def package(content, others=None, relationships=None, compression=zipfile.ZIP_DEFLATED):
    """The bytes of a 3MF file with a first model and others by their names."""
    if relationships is None:
        relationships = (
            f'<Relationships><Relationship Type="{MODEL_TYPE}" Target="/3D/first.model" Id="r"/></Relationships>'
        )
    files = {"_rels/.rels": relationships, "3D/first.model": content, **(others or {})}
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", compression) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return data.getvalue()


def bomb(text, count):
    """A 3MF file whose model repeats a text in its middle, without making the whole text."""
    head, tail = model(obj(1, mesh())).split("</resources>")
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    packed, checksum, size = b"", 0, 0
    for piece in (head.encode(), *[text] * count, b"</resources>" + tail.encode()):
        packed += packer.compress(piece)
        checksum, size = zlib.crc32(piece, checksum), size + len(piece)
    packed += packer.flush()
    good = package("")
    at = good.index(b"PK\3\4", 4)
    end = good.index(b"PK\1\2")
    name = b"3D/first.model"
    fields = (checksum, len(packed), size, len(name), 0)
    header = b"PK\3\4" + struct.pack("<5HIIIHH", 20, 0, 8, 0, 33, *fields) + name
    rels = good[end : good.index(b"PK\1\2", end + 4)]
    entry = b"PK\1\2" + struct.pack("<6HIIIHHHHHII", 20, 20, 0, 8, 0, 33, *fields, 0, 0, 0, 0, at) + name
    directory = rels + entry
    begin = at + len(header) + len(packed)
    ending = b"PK\5\6" + struct.pack("<4HIIH", 0, 0, 2, 2, len(directory), begin, 0)
    return good[:at] + header + packed + directory + ending


class ThreeMfFiles(FileTest):
    def parts(self, content, *options):
        """What `info` tells of a file, and its parts by their paths."""
        path = self.write("model.3mf", content)
        result = run("info", path, "--size", "8x8", "--parts", "--json", "-", *options)
        self.assert_done(result)
        told = json.loads(result.stdout)
        return told, {part["path"]: part for part in told["part_list"]}

    def test_items_are_parts_by_their_names(self):
        resources = obj(1, mesh(), 'name="lid"') + obj(2, mesh()) + obj(3, mesh(), 'name="not built"')
        items = ((1, ""), (2, 'partnumber="P/7"'), (1, f'transform="{SHIFTED}"'), (2, ""))
        told, parts = self.parts(package(model(resources, items)))
        self.assertEqual(list(parts), ["/lid", "/P_7", "/lid (2)", "/object-2"])
        self.assertEqual(told["bounds"], [0.0, 11.0, 0.0, 1.0, 0.0, 1.0])
        self.assertEqual((told["triangles"], told["notes"]), (48, []))
        self.assertTrue(all(part["closed"] for part in parts.values()))

    def test_stored_archives_are_read(self):
        told, _ = self.parts(package(model(obj(1, mesh())), compression=zipfile.ZIP_STORED))
        self.assertEqual(told["triangles"], 12)

    def test_components_are_a_tree_with_places(self):
        turned = "0 1 0 -1 0 0 0 0 1 0 0 5"  # a quarter around z, and up
        resources = (
            obj(1, mesh(), 'name="bolt"')
            + obj(2, components((1, ""), (1, f'transform="{SHIFTED}"')), 'name="pair"')
            + obj(3, components((2, f'transform="{turned}"'), (1, "")), 'name="machine"')
        )
        told, parts = self.parts(package(model(resources, [(3, f'transform="{SHIFTED}"')])))
        bounds = {path: part["bounds"] for path, part in parts.items()}
        self.assertEqual(
            bounds,
            {
                "/machine/pair/bolt": [9.0, 10.0, 0.0, 1.0, 5.0, 6.0],
                "/machine/pair/bolt (2)": [9.0, 10.0, 10.0, 11.0, 5.0, 6.0],
                "/machine/bolt": [10.0, 11.0, 0.0, 1.0, 0.0, 1.0],
            },
        )
        _, parts = self.parts(package(model(resources, [(3, "")])), "--opacity", "pair=0.5")
        self.assertEqual([part["opacity"] for part in parts.values()], [0.5, 0.5, 1.0])

    def test_units_become_metres(self):
        for unit, metres in (("", 0.001), ("micron", 1e-6), ("inch", 0.0254), ("foot", 0.3048)):
            attributes = f'unit="{unit}"' if unit else ""
            told, _ = self.parts(package(model(obj(1, mesh()), attributes=attributes)))
            self.assertEqual(told["length_unit"], unit or "millimeter")
            for value, expected in zip(told["bounds"], [0.0, metres] * 3):
                self.assertAlmostEqual(value, expected, delta=1e-6 * metres)

    def test_units_that_differ_are_told_by_file(self):
        inch = self.write("a.3mf", package(model(obj(1, mesh()), attributes='unit="inch"')))
        box = self.write("b.stl", scenes.binary_stl())
        self.assertEqual(info(inch, inch)["length_unit"], "inch")
        told = info(inch, box)["length_unit"]
        self.assertEqual(told, f"inch ({inch}), none ({box})")

    def test_materials_are_colours_with_alpha(self):
        looks = ['pid="5" p1="0"'] * 4 + [""] * 8
        resources = MATERIALS + obj(1, mesh(looks=looks), 'name="box" pid="5" pindex="1"')
        told, parts = self.parts(package(model(resources)))
        self.assertEqual(
            {path: (part["material"], part["triangles"]) for path, part in parts.items()},
            {"/box/glass": ("glass", 4), "/box/wall": ("wall", 8)},
        )
        self.assertAlmostEqual(parts["/box/glass"]["opacity"], 64 / 255)
        self.assertEqual(told["translucent_parts"], 1)

    def test_colours_of_triangles_and_corners(self):
        looks = ['pid="6" p1="0"'] * 2 + ['pid="6" p1="0" p2="1" p3="2"'] * 3 + [""] * 7
        _, parts = self.parts(package(model(COLORS + obj(1, mesh(looks=looks), 'name="box"'))))
        self.assertEqual(
            {path: (part["triangles"], part["translucent"]) for path, part in parts.items()},
            {"/box/plain": (7, False), "/box/#FF0000FF": (2, False), "/box/colors": (3, True)},
        )

    def test_a_colour_is_seen(self):
        content = package(model(MATERIALS + obj(1, mesh(), 'pid="5" pindex="0"')))
        path, picture = self.write("red.3mf", content), self.folder / "red.png"
        self.assert_done(
            run("render", path, "-o", picture, "--size", "9x9", "--view", "0,0", "--opacity", "object-1=1")
        )
        self.assertEqual(tuple(read_png(picture)[2][4][12:15]), (255, 0, 0))

    def test_objects_of_other_models(self):
        other = model(obj(1, mesh(), 'name="far"') + obj(2, components((1, "")), 'name="group"'), ())
        resources = obj(3, mesh(), 'name="near"') + obj(
            1, components((2, 'p:path="/3D/Other.model"'), (3, "")), 'name="all"'
        )
        told, parts = self.parts(package(model(resources), {"3D/other.model": other}))
        self.assertEqual(list(parts), ["/all/group/far", "/all/near"])

    def test_what_is_not_shown_is_noted(self):
        lattice = mesh().replace("</mesh>", '<b:beamlattice xmlns:b="b"/></mesh>')
        resources = '<m:texture2dgroup id="9" texid="8"/>' + obj(1, lattice, 'pid="9" pindex="3"')
        told, _ = self.parts(package(model(resources)))
        self.assertEqual(told["notes"], ["beam lattices are not shown", "textures are not shown"])


class BadThreeMfFiles(FileTest):
    def refuse_model(self, text, *words, **more):
        self.refuse("bad.3mf", package(text, **more), *words)

    def test_corners_and_colours_that_are_not_there(self):
        for corner in ("8", "-1", "4294967295", "4294967296", "x", ""):
            bad = mesh().replace('v1="0"', f'v1="{corner}"', 1)
            self.refuse_model(model(obj(1, bad)), "first.model")
        for look in ('pid="5" p1="2"', 'pid="5" p1="-1"', 'pid="5" p1="0" p2="9"'):
            bad = mesh(looks=[look] + [""] * 11)
            self.refuse_model(model(MATERIALS + obj(1, bad)), "no colour")

    def test_numbers_that_are_none(self):
        for number in ("nan", "inf", "1e99", "", "1 2", "0x1"):
            self.refuse_model(model(obj(1, mesh().replace('x="0.0"', f'x="{number}"', 1))))
            transform = SHIFTED.replace("10", number or "x")
            self.refuse_model(model(obj(1, mesh()), [(1, f'transform="{transform}"')]))
        self.refuse_model(model(obj(1, mesh()), [(1, 'transform="1 2 3"')]), "12")
        self.refuse_model(model(MATERIALS.replace("#00FF00", "#00FF0") + obj(1, mesh())), "colour")
        self.refuse_model(model(obj(1, mesh()), attributes='unit="cubit"'), "cubit")

    def test_extensions_that_are_required(self):
        text = model(obj(1, mesh()), attributes='xmlns:x="http://example.org/x" requiredextensions="x"')
        self.refuse_model(text, "http://example.org/x")
        known = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
        path = self.write("good.3mf", package(text.replace("http://example.org/x", known)))
        self.assertEqual(run("info", path, "--size", "8x8").returncode, 0)

    def test_components_in_a_circle(self):
        resources = obj(1, components((2, ""))) + obj(2, components((1, "")))
        self.refuse_model(model(resources), "component of itself")
        other = model(obj(1, components((1, 'p:path="/3D/first.model"'))), ())
        resources = obj(1, components((1, 'p:path="/3D/o.model"')))
        self.refuse_model(model(resources), "component of itself", others={"3D/o.model": other})

    def test_components_that_multiply(self):
        resources = obj(1, mesh())
        for number in range(2, 40):
            resources += obj(number, components((number - 1, ""), (number - 1, "")))
        self.refuse_model(model(resources, [(39, "")]), "more components")
        resources = obj(1, mesh())
        for number in range(2, 400):
            resources += obj(number, components((number - 1, "")))
        self.refuse_model(model(resources, [(399, "")]), "more components")

    def test_what_is_missing(self):
        self.refuse_model(model(obj(1, mesh()), [(2, "")]), "object 2")
        self.refuse_model(model(obj(1, mesh()), [(1, 'p:path="/3D/none.model"')]), "none.model")
        self.refuse_model(model(obj(1, mesh()), [("", "")]), "objectid")
        self.refuse_model(model(obj(1, mesh()), ()), "nothing to draw")
        self.refuse_model(model(obj(1, "")), "nothing to draw")
        self.refuse_model(model(obj(1, mesh()) * 2), "two objects 1")
        self.refuse_model("<other/>", "no model")
        self.refuse_model(model(obj(1, mesh())), "no model", relationships="<Relationships/>")
        self.refuse_model(
            model(obj(1, mesh())), "_rels", relationships="<Relationships>"
        )
        data = io.BytesIO()
        with zipfile.ZipFile(data, "w") as archive:
            archive.writestr("3D/first.model", model(obj(1, mesh())))
        self.refuse("bad.3mf", data.getvalue(), "_rels/.rels")

    def test_documents_that_are_no_xml(self):
        good = model(obj(1, mesh()))
        for bad in ("", "{}", good[:-5], good + "<more/>", good.replace("<vertex", "<vertex <", 1)):
            self.refuse_model(bad, "first.model")
        doctype = '<!DOCTYPE model [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]>'
        self.refuse_model(good.replace("<model", doctype + "<model", 1), "first.model")

    def test_archives_that_are_damaged(self):
        good = package(model(obj(1, mesh())))
        for length in range(1, len(good), len(good) // 25):
            with self.subTest(length=length):
                self.refuse("cut.3mf", good[:length])
        directory, ending = good.index(b"PK\1\2"), good.index(b"PK\5\6")
        second = good.index(b"PK\1\2", directory + 4)
        for place, size in (
            (second + 16, 4), (second + 20, 4), (second + 24, 4), (second + 42, 4), (second + 28, 2), (second + 30, 2),
            (ending + 10, 2), (ending + 16, 4), (second + 8, 2), (second + 10, 2),
        ):  # fmt: skip
            for value in (1, 2 ** (8 * size) - 1, 2 ** (8 * size - 1)):
                bad = bytearray(good)
                bad[place : place + size] = value.to_bytes(size, "little")
                if bytes(bad) != good:
                    with self.subTest(place=place - second, value=value):
                        result = run("info", self.write("bad.3mf", bytes(bad)), "--size", "8x8")
                        if result.returncode != 0:
                            self.assert_refused(result, "bad.3mf")

    def test_bombs(self):
        self.refuse("bomb.3mf", bomb(b" " * 2**20, 300), "fill memory")
        small = bomb(b" " * 2**20, 3)
        self.assertEqual(run("info", self.write("small.3mf", small), "--size", "8x8").returncode, 0)


if __name__ == "__main__":
    unittest.main()
