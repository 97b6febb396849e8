"""What comes out of good files."""

import json
import unittest

import scenes
import test_render
from program import FileTest, info, png, read_png, run


class GoodFiles(FileTest):
    def test_every_kind_is_read(self):
        parts = {"text.stl": 1, "boxes.stl": 1, "boxes.ply": 1, "big.ply": 1, "text.ply": 1, "boxes.vtp": 1}
        parts |= {"boxes.vtu": 1, "boxes.vtk": 1}
        triangles = {"boxes.stl": 24, "boxes.vtu": 24, "boxes.vtk": 24}
        for path in scenes.write_all(self.folder):
            with self.subTest(file=path.name):
                told = info(path)
                count = parts.get(path.name, 2)
                self.assertEqual(told["scene"], str(path))
                self.assertEqual(told["parts"], count)
                self.assertEqual(told["triangles"], triangles.get(path.name, 12 * count))
                self.assertEqual(told["skipped"], [])

    def test_upper_case_extension(self):
        for name, content in (("BOXES.STL", scenes.binary_stl()), ("BOXES.PLY", scenes.text_ply())):
            self.assertEqual(info(self.write(name, content))["parts"], 1)

    def test_solids_of_text_stl_are_parts(self):
        content = scenes.text_stl("Left/box") + scenes.text_stl("").replace(b"vertex 0.0", b"vertex 3.0")
        content += b"SOLID nothing\nendsolid\n" + scenes.text_stl("Left/box ")
        path = self.write("boxes.stl", content)
        result = run("info", path, "--size", "8x8", "--parts", "--json", "-")
        told = json.loads(result.stdout)
        self.assertEqual(
            [(part["path"], part["triangles"], part["closed"]) for part in told["part_list"]],
            [("/Left_box", 12, True), ("/solid-2", 12, True), ("/Left_box (2)", 12, True)],
        )
        self.assertEqual(told["part_list"][1]["bounds"], [1.0, 3.0, 0.0, 1.0, 0.0, 1.0])
        self.assertEqual([part["part"] for part in told["skipped"]], ["nothing"])

    def test_byte_orders_of_ply_are_one_picture(self):
        pictures = []
        for order in "<>":
            path, picture = self.write("box.ply", scenes.binary_ply(order)), self.folder / "box.png"
            self.assert_done(run("render", path, "-o", picture, "--size", "40x40"))
            pictures.append(picture.read_bytes())
        self.assertEqual(*pictures)

    def test_alpha_of_gltf_counts_where_it_is_blended_only(self):
        told = info(self.write("boxes.glb", scenes.glb()))
        self.assertEqual(told["translucent_parts"], 1)
        self.assertEqual(told["materials"], 2)
        self.assertEqual(told["bounds"], [0.0, 2.5, 0.0, 1.0, 0.0, 1.0])

    def test_alpha_of_gltf_is_the_opacity(self):
        # an unlit wall of alpha 0.25 before the background of 0.95
        document = scenes.gltf_document(168)
        document["extensionsUsed"] = ["KHR_materials_unlit"]
        document["materials"][0]["extensions"] = {"KHR_materials_unlit": {}}
        document["materials"][0]["doubleSided"] = False
        document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][:3] = [0.0, 0.0, 0.0]
        document["nodes"][0]["children"] = [1]
        path = self.write("wall.glb", scenes.pack_glb(document, scenes.gltf_binary()))
        picture = self.folder / "wall.png"
        self.assert_done(run("render", path, "-o", picture, "--size", "9x9", "--view", "0,0"))
        _, _, rows = read_png(picture)
        self.assertAlmostEqual(rows[4][3 * 4], 255 * 0.95 * 0.75, delta=1)

    def test_opacity_of_obj(self):
        (self.folder / "boxes.mtl").write_bytes(scenes.mtl())
        told = info(self.write("boxes.obj", scenes.obj()))
        self.assertEqual(told["translucent_parts"], 1)

    def test_obj_finds_the_library_that_it_names(self):
        (self.folder / "other.mtl").write_bytes(scenes.mtl())
        told = info(self.write("boxes.obj", scenes.obj("other.mtl")))
        self.assertEqual(told["translucent_parts"], 1)
        self.assertEqual(told["notes"], [])

    def test_obj_without_its_library_is_drawn_and_noted(self):
        told = info(self.write("boxes.obj", scenes.obj()))
        self.assertEqual(told["parts"], 2)
        self.assertEqual(len(told["notes"]), 2)
        self.assertIn("'left'", " ".join(told["notes"]))

    def test_part_without_triangles_is_skipped_and_told(self):
        self.write("leaf.vtp", scenes.vtp())
        self.write("none.vtp", scenes.vtp(triangles=()))
        told = info(self.write("boxes.vtm", scenes.vtm("leaf.vtp", "none.vtp")))
        self.assertEqual(told["parts"], 1)
        self.assertEqual([part["part"] for part in told["skipped"]], ["block 1"])
        self.assertIn("no triangles", told["skipped"][0]["reason"])

    def test_lines_are_drawn(self):
        document = scenes.gltf_document(168)
        document["meshes"][0]["primitives"][0]["mode"] = 1
        path = self.write("lines.glb", scenes.pack_glb(document, scenes.gltf_binary()))
        told = info(path)
        self.assertEqual((told["parts"], told["triangles"], told["lines"]), (2, 12, 18))

    def test_several_files_make_one_scene(self):
        paths = scenes.write_all(self.folder)
        told = info(paths[0], paths[3], "demo:stack,layers=3")
        self.assertEqual(told["parts"], 2 + 1 + 3)
        self.assertEqual(told["triangles"], 24 + 24 + 6)

    def test_opacity_makes_every_part_translucent(self):
        path = self.write("boxes.glb", scenes.glb())
        self.assertEqual(info(path, "--opacity", "0.5")["translucent_parts"], 2)
        self.assertEqual(info(path, "--opacity", "1")["translucent_parts"], 1)

    def test_alpha_of_textures_counts_as_the_mode_says(self):
        ground, full = 242, {}  # 0.95 of 255, as VTK rounds it
        for is_unlit in (False, True):
            for mode in ("OPAQUE", "MASK", "BLEND"):
                with self.subTest(mode=mode, unlit=is_unlit):
                    left, right = self.render_pane(mode, is_unlit)
                    self.assertLess(left[0], ground - 50)
                    full.setdefault(is_unlit, left)
                    self.assertEqual(left, full[is_unlit])
                    if mode == "BLEND":
                        want = tuple(0.4 * c + 0.6 * ground for c in left)
                        self.assertLessEqual(max(abs(a - b) for a, b in zip(right, want)), 1.5)
                    else:
                        self.assertEqual(right, left if mode == "OPAQUE" else (ground,) * 3)

    def render_pane(self, mode, is_unlit):
        """The colours of the halves of a pane whose texture is opaque on the left, and of alpha 0.4 on the right."""
        document = json.loads(test_render.pane(textured=True))
        pixels = png([[(255, 255, 255, 255), (255, 255, 255, 102)]], alpha=True)
        document["images"][0]["uri"] = test_render.data_uri("image/png", pixels)
        document["samplers"] = [{"magFilter": 9728, "minFilter": 9728}]
        document["textures"][0]["sampler"] = 0
        material = document["materials"][0]
        material["alphaMode"] = mode
        material["pbrMetallicRoughness"]["baseColorFactor"] = [0.2, 0.4, 0.8, 1.0]
        if is_unlit:
            material["extensions"] = {"KHR_materials_unlit": {}}
        picture = self.folder / "picture.png"
        self.assert_done(
            run(
                *("render", self.write("pane.gltf", json.dumps(document).encode())),
                *("--size", "9x9", "--view", "0,0", "-o", picture),
            )
        )
        row = read_png(picture)[2][4]
        return tuple(row[6:9]), tuple(row[18:21])

    def test_buffers_in_files_of_their_own(self):
        (self.folder / "boxes.bin").write_bytes(scenes.gltf_binary())
        document = scenes.gltf_document(168, "boxes.bin")
        told = info(self.write("boxes.gltf", json.dumps(document).encode()))
        self.assertEqual(told["triangles"], 24)


if __name__ == "__main__":
    unittest.main()
