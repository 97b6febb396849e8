"""Files that ParaView saves: grids, legacy files, trees of blocks and VTKHDF."""

import json
import unittest

import scenes
from program import FileTest, run

VOLUME = "volume meshes are shown by their surfaces"
HIERARCHY = (
    '<Assembly type="vtkDataAssembly" version="1.0" id="0"><Housing id="1" label="The Housing">'
    '<dataset id="1"/><Lid id="2"><dataset id="0"/></Lid></Housing></Assembly>'
)


class VtkFiles(FileTest):
    def parts(self, path, *options):
        """What `info --parts` tells, and the paths of the parts."""
        result = run("info", path, "--size", "8x8", "--parts", "--json", "-", *options)
        self.assert_done(result)
        told = json.loads(result.stdout)
        return told, [part["path"] for part in told["part_list"]]

    def test_a_volume_is_shown_by_its_surface(self):
        cells = scenes.cells_of_two_boxes([scenes.HEXAHEDRON])
        for name, content in (
            ("boxes.vtu", scenes.vtu(cells=cells)),
            ("boxes.vtk", scenes.legacy_vtk(cells=cells)),
        ):
            told, paths = self.parts(self.write(name, content))
            self.assertEqual((told["parts"], told["triangles"]), (1, 24))
            self.assertEqual(told["bounds"], [0.0, 2.5, 0.0, 1.0, 0.0, 1.0])
            self.assertEqual(told["notes"], [VOLUME])
            self.assertEqual(paths, ["/boxes"])

    def test_faces_between_cells_are_not_shown(self):
        # two boxes that share their face at x = 1
        points = [*scenes.CORNERS, *((x + 1.0, y, z) for x, y, z in scenes.CORNERS[4:])]
        far = [8 + i for i in range(4)]
        cells = [scenes.HEXAHEDRON, (4, far[0], far[2], 6, 5, far[1], far[3], 7)]
        told, _ = self.parts(self.write("two.vtu", scenes.vtu(points, cells)))
        self.assertEqual(told["triangles"], 20)
        self.assertIs(told["part_list"][0]["closed"], True)

    def test_grids_of_every_shape(self):
        points = "\n".join("%g %g %g" % (x, y, z) for z, y, x in scenes.CORNERS)
        for shape, body in (
            ("STRUCTURED_POINTS", "ORIGIN 0 0 0\nSPACING 1 1 1\n"),
            ("RECTILINEAR_GRID", "".join(f"{a}_COORDINATES 2 float\n0 1\n" for a in "XYZ")),
            ("STRUCTURED_GRID", f"POINTS 8 float\n{points}\n"),
        ):
            head = f"# vtk DataFile Version 3.0\na box\nASCII\nDATASET {shape}\nDIMENSIONS 2 2 2\n"
            told, _ = self.parts(self.write("box.vtk", (head + body).encode()))
            self.assertEqual(told["triangles"], 12)
            self.assertEqual(told["bounds"], [0.0, 1.0, 0.0, 1.0, 0.0, 1.0])

    def test_blocks_are_parts_by_the_names_of_the_tree(self):
        self.write("leaf.vtp", scenes.vtp())
        self.write("grid.vtu", scenes.vtu())
        inner = (
            '<Block index="0" name="Housing"><DataSet index="0" name="lid" file="leaf.vtp"/>'
            '<DataSet index="1" name="base/1" file="grid.vtu"/></Block>'
            '<DataSet index="1" name="bolt" file="leaf.vtp"/><DataSet index="2" file="leaf.vtp"/>'
            '<DataSet index="3" name="bolt" file="leaf.vtp"/>'
        )
        tree = scenes.vtm().replace(b"</vtkMultiBlockDataSet>", inner.encode() + b"</vtkMultiBlockDataSet>")
        path = self.write("machine.vtm", tree)
        told, paths = self.parts(path)
        self.assertEqual(
            paths, ["/Housing/lid", "/Housing/base_1", "/bolt", "/block-5", "/bolt (2)"]
        )
        self.assertEqual(told["triangles"], 4 * 12 + 24)
        told, _ = self.parts(path, "--opacity", "Housing=0.2", "--hide", "bolt*")
        opacity = {part["path"]: part["opacity"] for part in told["part_list"]}
        self.assertEqual(
            opacity, {"/Housing/lid": 0.2, "/Housing/base_1": 0.2, "/block-5": 1.0}
        )

    def test_partitions_are_parts(self):
        self.write("leaf.vtp", scenes.vtp())
        path = self.write("whole.vtpd", scenes.vtpd("leaf.vtp", "leaf.vtp"))
        self.assertEqual(self.parts(path)[1], ["/partition-0", "/partition-1"])

    def test_the_hierarchy_of_a_collection_gives_paths(self):
        self.write("leaf.vtp", scenes.vtp())
        parts = {"lid": ["leaf.vtp"], "base": ["leaf.vtp", "leaf.vtp"], "bolt": ["leaf.vtp"]}
        flat = self.write("flat.vtpc", scenes.vtpc(parts))
        base = ["/base/partition-0", "/base/partition-1"]
        self.assertEqual(self.parts(flat)[1], ["/lid", *base, "/bolt"])
        tree = self.write("tree.vtpc", scenes.vtpc(parts, HIERARCHY))
        base = [f"/The Housing{path}" for path in base]
        self.assertEqual(self.parts(tree)[1], [*base, "/The Housing/Lid", "/bolt"])

    def test_vtkhdf(self):
        path = self.write("cells.vtkhdf", scenes.vtkhdf())
        result = run("info", path, "--size", "8x8", "--json", "-")
        if b"built without" in result.stderr:
            self.assert_refused(result, path)
            self.skipTest("this VTK has no reader of VTKHDF")
        told = json.loads(result.stdout)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertEqual((told["parts"], told["triangles"]), (1, 6))
        self.assertEqual([(a["name"], a["range"]) for a in told["arrays"]], [("T", [0.0, 4.0])])


class BadVtkFiles(FileTest):
    def test_corners_that_are_not_there(self):
        for cell in ((0, 1, 3, 16), (0, 1, 3, -1), (0, 1, 3, 2**40)):
            self.refuse("bad.vtu", scenes.vtu(cells=[cell]), "16 points")
        self.refuse("bad.vtk", scenes.legacy_vtk(cells=[(0, 1, 3, 16)]), "16 points")

    def test_cells_of_too_few_corners(self):
        for kind, corners in ((12, 4), (10, 8), (5, 4), (72, 9), (42, 8), (41, 3), (200, 4)):
            cell = tuple(range(corners))
            for name, content in (
                ("bad.vtu", scenes.vtu(cells=[cell], kinds=[kind])),
                ("bad.vtk", scenes.legacy_vtk(cells=[cell], kinds=[kind])),
            ):
                with self.subTest(kind=kind, name=name):
                    self.refuse(name, content)

    def test_coordinates_that_are_not_finite(self):
        points = [(float("nan"), 0.0, 0.0), *scenes.TWO_BOXES[1:]]
        self.refuse("bad.vtu", scenes.vtu(points))
        self.refuse("bad.vtk", scenes.legacy_vtk(points))

    def test_counts_that_are_wrong(self):
        good = scenes.vtu()
        for count in (0, 15, 17, 10**6, 10**15):
            for name, former in (("Points", 16), ("Cells", 12)):
                wrong = good.replace(
                    f'NumberOf{name}="{former}"'.encode(), f'NumberOf{name}="{count}"'.encode()
                )
                if wrong != good and not (name == "Cells" and count == 0):
                    with self.subTest(name=name, count=count):
                        self.refuse("bad.vtu", wrong)
        negative = good.replace(b'NumberOfCells="12"', b'NumberOfCells="-1"')
        result = run("info", self.write("bad.vtu", negative), "--size", "8x8")
        self.assert_refused(result, "bad.vtu")  # VTK 9.1 crashes, which the program tells
        good = scenes.legacy_vtk()
        for former, wrong in (
            (b"POINTS 16", b"POINTS 17"), (b"POINTS 16", b"POINTS 1000000000000"),
            (b"CELLS 12 60", b"CELLS 13 65"), (b"CELLS 12 60", b"CELLS 12 59"),
            (b"CELLS 12 60", b"CELLS -12 60"), (b"CELL_TYPES 12", b"CELL_TYPES 11"),
        ):  # fmt: skip
            with self.subTest(wrong=wrong):
                self.refuse("bad.vtk", good.replace(former, wrong))

    def test_arrays_that_are_too_short(self):
        short = scenes.xml_array("Float32", "T", range(15))
        self.refuse("bad.vtu", scenes.vtu(point_arrays=short))

    def test_nothing_to_draw(self):
        self.refuse("none.vtu", scenes.vtu(cells=[]), "nothing to draw")
        self.refuse("none.vtpd", scenes.vtpd(), "nothing to draw")
        self.refuse("none.vtpc", scenes.vtpc({}), "nothing to draw")
        self.refuse("none.vtk", scenes.legacy_vtk(cells=[]), "nothing to draw")

    def test_trees_that_are_damaged(self):
        self.write("leaf.vtp", scenes.vtp())
        self.refuse("bad.vtpd", scenes.vtpd("nowhere.vtp"))
        good = scenes.vtpc({"a": ["leaf.vtp"]})
        self.refuse("bad.vtpc", good.replace(b'index="0"', b'index="-1"', 1), "index")
        self.refuse("bad.vtpc", good.replace(b'index="0"', b'index="2000000000"', 1), "index")
        stray = good.replace(b"<Partitions", b'<DataSet index="0" file="leaf.vtp"/><Partitions', 1)
        self.refuse("bad.vtpc", stray, "outside")

    def test_vtkhdf_that_is_damaged(self):
        good = scenes.vtkhdf()
        for length in range(1, len(good), len(good) // 12):
            with self.subTest(length=length):
                self.refuse("cut.vtkhdf", good[:length])


if __name__ == "__main__":
    unittest.main()
