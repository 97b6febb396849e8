"""What comes out of good files."""

import json
import unittest

import scenes
from program import FileTest, info, read_png, run


class GoodFiles(FileTest):
    def test_every_kind_is_read(self):
        parts = {"text.stl": 1, "boxes.stl": 1, "boxes.ply": 1, "text.ply": 1, "boxes.vtp": 1}
        triangles = {"boxes.stl": 24}
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

    def test_mask_is_blended_and_noted(self):
        document = scenes.gltf_document(168)
        document["materials"][0]["alphaMode"] = "MASK"
        told = info(self.write("mask.glb", scenes.pack_glb(document, scenes.gltf_binary())))
        self.assertEqual(told["translucent_parts"], 1)
        self.assertIn("glass", told["notes"][0])

    def test_buffers_in_files_of_their_own(self):
        (self.folder / "boxes.bin").write_bytes(scenes.gltf_binary())
        document = scenes.gltf_document(168, "boxes.bin")
        told = info(self.write("boxes.gltf", json.dumps(document).encode()))
        self.assertEqual(told["triangles"], 24)


if __name__ == "__main__":
    unittest.main()
