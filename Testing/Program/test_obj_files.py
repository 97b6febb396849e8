"""OBJ files: groups and materials as parts, cells of every kind, and what is wrong with them."""

import json
import unittest

import scenes
from program import FileTest, png, read_png, run

SQUARE = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"


class ObjFiles(FileTest):
    def parts(self, content, *options, name="model.obj"):
        """What `info` tells of a file, and its parts by their paths."""
        path = self.write(name, content)
        result = run("info", path, "--size", "8x8", "--parts", "--json", "-", *options)
        self.assert_done(result)
        told = json.loads(result.stdout)
        return told, {part["path"]: part for part in told["part_list"]}

    def test_groups_and_objects_are_parts(self):
        content = SQUARE + (
            b"f 1 2 3\no Housing\nf 1 2 3\ng lid\nf 1 2 3 4\ng base plate\nf 1 2 3\ng lid\nf 1 3 4\n"
            b"o other/one\nf 1 2 3\n"
        )
        told, parts = self.parts(content)
        self.assertEqual(
            {path: part["triangles"] for path, part in parts.items()},
            {"/model": 1, "/Housing": 1, "/Housing/lid": 3, "/Housing/base plate": 1, "/other_one": 1},
        )
        _, parts = self.parts(content, "--only", "Housing", "--opacity", "/Housing/l*=0.5")
        self.assertEqual(
            {path: part["opacity"] for path, part in parts.items()},
            {"/Housing": 1.0, "/Housing/lid": 0.5, "/Housing/base plate": 1.0},
        )

    def test_parts_of_exploded_views_move_apart(self):
        content = SQUARE + b"v 4 0 0\nv 5 0 0\nv 5 1 0\no a\nf 1 2 3 4\no b\nf 5 6 7\n"
        _, parts = self.parts(content, "--explode", "0.5")
        bounds = {path: part["bounds"] for path, part in parts.items()}
        self.assertEqual(bounds, {"/a": [-1, 0, 0, 1, 0, 0], "/b": [5, 6, 0, 1, 0, 0]})

    def test_materials_of_a_group_are_parts_below_it(self):
        (self.folder / "boxes.mtl").write_bytes(scenes.mtl())
        content = b"mtllib boxes.mtl\n" + SQUARE + (
            b"g box\nusemtl left\nf 1 2 3\nusemtl right\nf 1 3 4\nusemtl left\nf 1 2 4\n"
            b"g\nusemtl right\nf 1 2 3\n"
        )
        told, parts = self.parts(content)
        self.assertEqual(
            {path: (part["triangles"], part["material"], part["opacity"]) for path, part in parts.items()},
            {"/box/left": (2, "left", 0.25), "/box/right": (1, "right", 1.0), "/right": (1, "right", 1.0)},
        )
        self.assertEqual((told["materials"], told["notes"]), (2, []))

    def test_opacity_is_d_or_what_tr_leaves(self):
        for line, opacity in ((b"d 0.25", 0.25), (b"Tr 0.75", 0.25), (b"d 0.5\nTr 0.5", 0.5), (b"Tr 0", 1.0)):
            with self.subTest(line=line):
                (self.folder / "one.mtl").write_bytes(b"newmtl one\n" + line + b"\n")
                _, parts = self.parts(b"mtllib one.mtl\n" + SQUARE + b"usemtl one\nf 1 2 3\n")
                self.assertEqual([part["opacity"] for part in parts.values()], [opacity])

    def test_light_from_everywhere_does_not_bleach(self):
        pictures = []
        for ambient in (b"", b"Ka 1 1 1\n"):
            (self.folder / "one.mtl").write_bytes(b"newmtl one\nKd 0.2 0.4 0.8\n" + ambient)
            model = self.write("one.obj", b"mtllib one.mtl\n" + SQUARE + b"usemtl one\nf 1 2 3 4\n")
            picture = self.folder / "picture.png"
            self.assert_done(run("render", model, "--size", "9x9", "--view", "0,0", "-o", picture))
            pictures.append([bytes(row) for row in read_png(picture)[2]])
        self.assertEqual(*pictures)

    def test_options_of_parts_take_one_value_each(self):
        model = self.write("two.obj", SQUARE + b"g [a]\nf 1 2 3\ng b\nf 1 3 4\n")
        picture = self.folder / "picture.png"
        for words, status in ((("--hide", "b"), 0), (("--only", "[a]"), 0), (("--hide", "[x]"), 2)):
            with self.subTest(words=words):
                result = run("render", *words, model, "--size", "8x8", "-o", picture)
                self.assertEqual(result.returncode, status, result.stderr)

    def test_outlines_and_x_rays_of_what_others_hide(self):
        front = b"v 0 0 1\nv 2 0 1\nv 2 2 1\nv 0 2 1\ng front\nf 1 2 3 4\n"
        behind = b"v 0.5 0.5 0\nv 1.5 0.5 0\nv 1.5 1.5 0\nv 0.5 1.5 0\ng behind\nf 5 6 7 8\n"
        model = self.write("two.obj", front + behind)
        picture = self.folder / "picture.png"

        def colors(*words):
            options = ("--size", "40x40", "--view", "0,0", "--color", "behind=#0000ff", "-o", picture)
            self.assert_done(run("render", model, *options, *words))
            return {tuple(pixel[:3]) for row in read_png(picture)[2] for pixel in zip(*[iter(row)] * 3)}

        orange = (255, 128, 0)
        self.assertNotIn(orange, colors())
        self.assertIn(orange, colors("--highlight", "behind"))
        seen = colors("--x-ray", "behind", "--x-ray-falloff", "2")
        self.assertTrue(any(blue > 200 and red < 40 for red, _, blue in seen), seen)
        for words in (("--x-ray-falloff", "2"), ("--highlight", "nothing"), ("--x-ray-falloff", "nan")):
            with self.subTest(words=words):
                result = run("render", model, "--size", "8x8", "-o", picture, *words)
                self.assertNotEqual(result.returncode, 0)

    def test_indices_from_the_end(self):
        content = SQUARE + b"f -4 -3 -2\nv 5 5 5\nf -2 -1 1\n"
        told, _ = self.parts(content)
        self.assertEqual(told["triangles"], 2)
        self.assertEqual(told["bounds"], [0.0, 5.0, 0.0, 5.0, 0.0, 5.0])
        for index in (b"-5", b"5", b"0"):
            self.refuse("bad.obj", SQUARE + b"f 1 2 " + index + b"\n", "line 5", "index", "not there")

    def test_polygons_lines_and_points(self):
        told, _ = self.parts(SQUARE + b"f 1 2 3 4\nl 1 2 3\np 1 2\n")
        self.assertEqual((told["triangles"], told["lines"], told["points"]), (2, 1, 1))

    def test_a_concave_polygon_is_not_a_fan(self):
        # an arrow whose notch shows the background
        points = [(0, 0), (2, 0), (2, 2), (1, 1), (0, 2)]
        content = "".join(f"v {x} {y} 0\n" for x, y in points) + "f 5 1 2 3 4\n"
        path = self.write("arrow.obj", content.encode())
        picture = self.folder / "arrow.png"
        self.assert_done(run("render", path, "-o", picture, "--size", "40x40", "--view", "0,0"))
        _, _, rows = read_png(picture)
        ground = bytes(rows[0][:3])
        shown = [[bytes(row[3 * x : 3 * x + 3]) != ground for x in range(40)] for row in rows]
        inside = [y for y in range(40) if any(shown[y])]
        self.assertFalse(shown[inside[0] + 2][20])
        self.assertTrue(shown[inside[-1] - 2][20])

    def test_lines_that_go_on_and_comments(self):
        told, _ = self.parts(
            b"\xef\xbb\xbf# a square\r\n" + SQUARE.replace(b"\n", b" # corner\r\n") + b"f 1 2 \\\r\n 3 4\r\n"
        )
        self.assertEqual(told["triangles"], 2)

    def test_a_library_that_is_not_there_is_noted(self):
        content = b"mtllib none.mtl\n" + SQUARE + b"usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n"
        told, _ = self.parts(content)
        self.assertEqual(
            told["notes"],
            [
                "its material library 'none.mtl' is not there",
                "there are no materials 'blue', 'red': their parts are white",
            ],
        )
        (self.folder / "model.mtl").write_bytes(b"newmtl red\nd 0.5\nnewmtl blue\n")
        told, _ = self.parts(content)
        self.assertEqual(
            told["notes"],
            ["its material library 'none.mtl' is not there; 'model.mtl' is read instead"],
        )
        self.assertEqual(told["translucent_parts"], 1)

    def test_a_texture_that_is_not_there_is_noted(self):
        (self.folder / "model.mtl").write_bytes(b"newmtl red\nmap_Kd -s 2 2 1 my wood.png\n")
        told, _ = self.parts(SQUARE + b"usemtl red\nf 1 2 3\n")
        self.assertEqual(told["notes"], ["texture 'my wood.png' of material 'red' is not there"])

    def test_a_texture_is_drawn(self):
        (self.folder / "green.png").write_bytes(png([[(0, 255, 0)] * 4] * 4))
        (self.folder / "model.mtl").write_bytes(b"newmtl green\nKd 1 1 1\nillum 1\nmap_Kd green.png\n")
        square = SQUARE + b"vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl green\nf 1/1 2/2 3/3 4/4\n"
        path, picture = self.write("model.obj", square), self.folder / "model.png"
        self.assert_done(run("render", path, "-o", picture, "--size", "9x9", "--view", "0,0"))
        self.assertEqual(tuple(read_png(picture)[2][4][12:15]), (0, 255, 0))

    def test_the_colour_of_a_material_without_lights_is_drawn(self):
        (self.folder / "model.mtl").write_bytes(b"newmtl red\nKd 1 0 0.2\nillum 0\n")
        path, picture = self.write("model.obj", SQUARE + b"usemtl red\nf 1 2 3 4\n"), self.folder / "model.png"
        self.assert_done(run("render", path, "-o", picture, "--size", "9x9", "--view", "0,0"))
        self.assertEqual(tuple(read_png(picture)[2][4][12:15]), (255, 0, 51))

    def test_colours_of_vertices(self):
        colored = b"v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3 4\n"
        path, picture = self.write("model.obj", colored), self.folder / "model.png"
        self.assert_done(run("render", path, "-o", picture, "--size", "9x9", "--view", "0,0"))
        self.assertEqual(tuple(read_png(picture)[2][4][12:15]), (255, 0, 0))

    def test_many_groups_are_chosen_by_name(self):
        content = SQUARE + b"".join(b"g part %d\nf 1 2 3 4\n" % i for i in range(500))
        path, picture = self.write("model.obj", content), self.folder / "model.png"
        options = ("--color", "part 250=#00ff00", "--only", "part 250")
        self.assert_done(
            run("render", path, "-o", picture, "--size", "9x9", "--view", "0,0", *options)
        )
        self.assertEqual(tuple(read_png(picture)[2][4][12:15]), (0, 255, 0))
        self.assertEqual(self.parts(content, "--hide", "part 1?")[0]["parts"], 490)

    def test_curves_are_noted(self):
        told, _ = self.parts(SQUARE + b"f 1 2 3\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nend\n")
        self.assertEqual(told["notes"], ["curves and curved surfaces are not drawn"])

    def test_lines_that_are_not_understood(self):
        for line in (
            b"f 1 2", b"f 1 2 x", b"f 1/x 2 3", b"f 1/1/1/1 2 3", b"f 1 2 99999999999999999999", b"l 1", b"p",
            b"v 1 2", b"v 1 2 x", b"v 1 2 nan", b"v 1 2 1e999", b"vn 0 0", b"vn 0 0 inf", b"vt", b"f 1/1 2/1 3/1",
            b"f 1//1 2//1 3//1", b"v 1 2 3 1 1 x",
        ):  # fmt: skip
            with self.subTest(line=line):
                self.refuse("bad.obj", SQUARE + line + b"\n", "line 5")

    def test_materials_that_are_damaged(self):
        content = SQUARE + b"usemtl red\nf 1 2 3\n"
        for line in (b"Kd 1 1 1 1", b"Kd", b"Kd x", b"d nan", b"Ns", b"map_Kd -s 1 2 3 4 a.png", b"map_Kd -o a.png"):
            with self.subTest(line=line):
                (self.folder / "bad.mtl").write_bytes(b"newmtl red\n" + line + b"\n")
                path = self.write("bad.obj", content)
                self.assert_refused(run("info", path), "bad.mtl", "line 2")


if __name__ == "__main__":
    unittest.main()
