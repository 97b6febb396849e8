"""Whatever is wrong with a file: one line, exit status 2, no crash, nothing half-written."""

import os
import random
import struct
import unittest

import scenes
from program import FileTest, run

SEED = 20240607
KINDS = ("glb", "gltf", "obj", "stl", "ply", "vtp", "vtu", "vtm", "vtpd", "vtpc", "vtk", "vtkhdf", "3mf")


class BadFiles(FileTest):
    def render_or_refuse(self, path):
        """Damage that cannot be seen gives a whole picture; any other gives none."""
        picture = self.folder / "picture.png"
        before = {entry.name for entry in self.folder.iterdir()}
        result = run("render", path, "-o", picture, "--size", "8x8")
        if result.returncode == 0:
            self.assert_done(result)
            self.assertEqual(picture.read_bytes()[-8:-4], b"IEND")
            picture.unlink()
        else:
            self.assert_refused(result, path)
            self.assertNotIn(b"crashed", result.stderr)
        self.assertEqual({entry.name for entry in self.folder.iterdir()}, before)
        return result.returncode

    def test_missing_file(self):
        for kind in KINDS:
            path = self.folder / f"none.{kind}"
            self.assert_refused(run("info", path), path, "no such file")

    def test_folder(self):
        path = self.folder / "folder.glb"
        path.mkdir()
        self.assert_refused(run("info", path), path, "directory")

    @unittest.skipIf(os.geteuid() == 0, "root may read every file")
    def test_unreadable_file(self):
        path = self.write("secret.stl", scenes.binary_stl())
        path.chmod(0)
        self.assert_refused(run("info", path), path, "cannot be read")

    def test_device(self):
        path = self.folder / "null.stl"
        path.symlink_to("/dev/null")
        self.assert_refused(run("info", path), path, "regular file")

    def test_unknown_kind_lists_the_known_ones(self):
        self.refuse("picture.tiff", b"II*\0", ".glb", ".vtm")
        self.refuse("no_extension", b"ply", ".glb", ".vtm")

    def test_empty_file(self):
        for kind in KINDS:
            self.refuse(f"empty.{kind}", b"", "empty")

    def test_random_bytes(self):
        noise = random.Random(SEED).randbytes(3000)
        for kind in KINDS:
            self.refuse(f"noise.{kind}", noise)

    def test_renamed_files(self):
        contents = {path.suffix: path.read_bytes() for path in scenes.write_all(self.folder)}
        for kind in contents:
            for other, content in contents.items():
                if {kind, other} not in ({kind}, {".glb", ".gltf"}):
                    with self.subTest(kind=kind, content=other):
                        self.refuse(f"renamed{kind}", content)

    def test_glb_and_gltf_may_have_each_others_name(self):
        contents = {path.suffix: path.read_bytes() for path in scenes.write_all(self.folder)}
        for name, kind in (("renamed.glb", ".gltf"), ("renamed.gltf", ".glb")):
            self.assert_done(run("info", self.write(name, contents[kind]), "--size", "8x8"))

    def test_truncated_files(self):
        for path in scenes.write_all(self.folder):
            content = path.read_bytes()
            for step in range(8):
                length = 1 + step * (len(content) - 2) // 8
                cut = self.write(f"cut{path.suffix}", content[:length])
                with self.subTest(file=path.name, length=length):
                    status = self.render_or_refuse(cut)
                    # an OBJ file does not say where it ends
                    self.assertTrue(status == 2 or path.suffix == ".obj")

    def test_flipped_bits(self):
        for path in scenes.write_all(self.folder):
            content = path.read_bytes()
            dice = random.Random(f"{SEED} {path.name}")
            for i in range(4):
                flipped = bytearray(content)
                for _ in range(1 + i % 3):
                    place = dice.randrange(8 * len(content))
                    flipped[place // 8] ^= 1 << place % 8
                with self.subTest(file=path.name, seed=SEED, number=i):
                    self.render_or_refuse(self.write(f"flipped{path.suffix}", bytes(flipped)))

    def test_a_refused_file_leaves_the_former_picture(self):
        picture = self.write("picture.png", b"what was there")
        path = self.write("cut.stl", scenes.binary_stl()[:-7])
        self.assert_refused(run("render", path, "-o", picture), path)
        self.assertEqual(picture.read_bytes(), b"what was there")

    def test_extents_that_cannot_be_drawn(self):
        for scale, words in ((1e20, ("1e+20", "beyond")), (1e-20, ("1e-20", "below"))):
            corners = [tuple(scale * x for x in corner) for corner in scenes.CORNERS]
            self.refuse("bad.vtp", scenes.vtp(corners), *words)

    def test_coordinates_that_are_not_finite(self):
        for bad in (float("nan"), float("inf")):
            corners = [(bad, 0.0, 0.0), *scenes.CORNERS[1:]]
            binary = scenes.gltf_binary(corners)
            self.refuse(
                "bad.glb", scenes.pack_glb(scenes.gltf_document(len(binary)), binary), "finite"
            )
            self.refuse("bad.vtp", scenes.vtp(corners))
            self.refuse(
                "bad.obj", scenes.obj().replace(b"v 0.0", b"v %f" % bad, 1), "line 2", "finite"
            )
            self.refuse(
                "bad.stl",
                scenes.binary_stl()[:96] + struct.pack("<f", bad) + scenes.binary_stl()[100:],
                "finite",
            )
            ply = scenes.binary_ply()
            begin = ply.index(b"end_header\n") + len(b"end_header\n")
            self.refuse(
                "bad.ply", ply[:begin] + struct.pack("<f", bad) + ply[begin + 4 :], "finite"
            )

    def test_indices_out_of_range(self):
        triangles = [(0, 1, 8), *scenes.TRIANGLES[1:]]
        binary = scenes.gltf_binary(triangles=triangles)
        self.refuse(
            "bad.glb",
            scenes.pack_glb(scenes.gltf_document(len(binary)), binary),
            "index",
            "8 vertices",
        )
        self.refuse("bad.vtp", scenes.vtp(triangles=triangles), "8 points")
        self.refuse(
            "bad.vtp", scenes.vtp(triangles=[(0, 1, -1), *scenes.TRIANGLES[1:]]), "8 points"
        )
        self.refuse("bad.obj", scenes.obj().replace(b"f 1 2 4", b"f 1 2 17", 1), "not there")
        self.refuse("bad.obj", scenes.obj().replace(b"f 1 2 4", b"f 1 2 0", 1), "index")
        self.refuse("bad.ply", scenes.text_ply().replace(b"3 0 1 3", b"3 0 1 8", 1), "8 vertices")
        self.refuse("bad.ply", scenes.text_ply().replace(b"3 0 1 3", b"3 0 1 -3", 1), "8 vertices")

    def test_nothing_to_draw(self):
        self.refuse("none.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "nothing to draw")
        self.refuse("none.stl", b"none".ljust(84, b"\0"), "nothing to draw")
        self.refuse("none.stl", b"solid none\nendsolid none\n", "nothing to draw")
        self.refuse(
            "none.ply", scenes.text_ply().replace(b"element face 12", b"element face 0"), "no faces"
        )
        self.refuse("none.vtp", scenes.vtp(triangles=()), "nothing to draw")
        self.refuse("none.vtm", scenes.vtm(), "nothing to draw")
        document = scenes.gltf_document(168)
        document["nodes"][0]["children"] = []
        self.refuse("none.glb", scenes.pack_glb(document, scenes.gltf_binary()), "nothing to draw")

    def test_blocks_that_are_not_there(self):
        self.refuse("lonely.vtm", scenes.vtm("nowhere.vtp"))

    def test_texture_that_is_damaged(self):
        (self.folder / "wood.png").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(40))
        (self.folder / "boxes.mtl").write_bytes(scenes.mtl() + b"map_Kd wood.png\n")
        path = self.write("boxes.obj", scenes.obj())
        self.assert_refused(run("info", path), "wood.png", "damaged")

    def test_material_with_too_many_numbers(self):
        (self.folder / "boxes.mtl").write_bytes(b"newmtl left\nKd 1 1 1 1 1 1 1 1 1 1\n")
        self.assert_refused(
            run("info", self.write("boxes.obj", scenes.obj())), "boxes.mtl", "line 2"
        )

    def test_glb_with_wrong_lengths(self):
        good = scenes.glb()
        json_length = struct.unpack_from("<I", good, 12)[0]
        binary = 12 + 8 + json_length
        places = {"file": 8, "json": 12, "binary": binary}
        for name, place in places.items():
            actual = struct.unpack_from("<I", good, place)[0]
            for wrong in (0, 1, actual - 4, actual + 4, 2**31 - 1, 2**31, 2**32 - 1):
                with self.subTest(length=name, wrong=wrong):
                    bad = bytearray(good)
                    struct.pack_into("<I", bad, place, wrong)
                    self.refuse("wrong.glb", bytes(bad))
        self.refuse("wrong.glb", good + b"more")
        self.refuse("wrong.glb", good[:4] + struct.pack("<I", 1) + good[8:], "version 1")


if __name__ == "__main__":
    unittest.main()
