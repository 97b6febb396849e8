import base64
import json
import os
import struct
import subprocess
import unittest

import scenes
from program import FileTest, info, png, read_png, run

BACKGROUND = 242  # 0.95 of 255, as VTK rounds it


def white_pixel():
    """A PNG of one white, opaque pixel."""
    return png([[(255, 255, 255, 255)]], alpha=True)


def data_uri(kind, data):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


def pane(textured):
    """A glTF file: a pane of glass with a factor of 0.5 in its base colour's alpha."""
    corners = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    data = b"".join(struct.pack("<3f", *corner) for corner in corners)
    data += b"".join(struct.pack("<2f", (x + 1) / 2, (y + 1) / 2) for x, y, _ in corners)
    data += struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    color = {"baseColorFactor": [0.2, 0.4, 0.8, 0.5]}
    if textured:
        color["baseColorTexture"] = {"index": 0}
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [
            {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [
            {"alphaMode": "BLEND", "doubleSided": True, "pbrMetallicRoughness": color}],
        "buffers": [{"byteLength": 92, "uri": data_uri("application/octet-stream", data)}],
        "bufferViews": [
            {"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
            {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
             "min": [-1, -1, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    }  # fmt: skip
    if textured:
        document["images"] = [{"uri": data_uri("image/png", white_pixel())}]
        document["textures"] = [{"source": 0}]
    return json.dumps(document).encode()


class Render(FileTest):
    def render(self, *arguments, name="picture.png"):
        path = self.folder / name
        self.assert_done(run("render", *arguments, "-o", path))
        return read_png(path)

    def test_size(self):
        for width, height in ((1, 1), (7, 5), (301, 300)):
            with self.subTest(width=width, height=height):
                picture = self.render("demo:stack,layers=2", "--size", f"{width}x{height}")
                self.assertEqual(picture[:2], (width, height))

    def test_default_size(self):
        self.assertEqual(self.render("demo:stack,layers=2")[:2], (1024, 768))

    def test_the_plates_fill_any_window(self):
        for size in ("40x4", "4x40", "16x16"):
            width, height, rows = self.render("demo:stack,layers=1,alpha=1", "--size", size)
            self.assertEqual(
                len({bytes(row[3 * x : 3 * x + 3]) for row in rows for x in range(width)}), 1
            )

    def test_every_method_draws(self):
        for method in ("blend", "vtk-oit", "vtk-peeling-2", "vtk-peeling", "linked-list", "truth"):
            with self.subTest(method=method):
                _, _, rows = self.render(
                    "demo:spheres,layers=4", "--size", "32x32", "--method", method
                )
                self.assertEqual(rows[0][0], BACKGROUND)
                self.assertLess(rows[16][3 * 16], BACKGROUND)

    def test_a_colour_of_css_is_shown_on_a_physically_based_part(self):
        path = self.write("boxes.glb", scenes.glb())
        options = ("--color", "*=#ff8000", "--opacity", "*=1", "--size", "32x32")
        _, _, rows = self.render(path, *options, "--method", "linked-list")
        pixels = [tuple(row[i : i + 3]) for row in rows for i in range(0, len(row), 3)]
        red, green, blue = max(pixels, key=lambda pixel: pixel[0] - pixel[2])
        self.assertGreater(red, 50)
        # Light changes all channels by one factor, and the exponent of sRGB keeps their ratio.
        self.assertAlmostEqual(green / red, 128 / 255, delta=0.02)
        self.assertLess(blue, 3)

    def test_sections_take_a_quarter_away(self):
        """Of two boxes, seen from above, one plane takes half of one away, and another half of what is left."""
        path = self.write("boxes.glb", scenes.glb())
        counts = []
        for sections in ([], ["--section=1,0,0,0.5"], ["--section=1,0,0,0.5", "--section=0,0,1,0.5"]):
            picture = self.render(path, *sections, "--opacity", "*=1", "--size", "32x32", "--view", "0,90")
            counts.append(sum(row[i] != BACKGROUND for row in picture[2] for i in range(0, len(row), 3)))
        self.assertGreater(counts[0], counts[1])
        self.assertGreater(counts[1], counts[2])

    def test_a_box_is_what_six_planes_are(self):
        path = self.write("boxes.glb", scenes.glb())
        look = ("--opacity", "*=1", "--size", "32x32", "--view", "30,40")
        whole = self.render(path, *look)
        planes = ("1,0,0,-0.25", "-1,0,0,-0.5", "0,1,0,-1", "0,-1,0,-0.25", "0,0,1,-1", "0,0,-1,-0.5")
        cut = self.render(path, *(f"--section={plane}" for plane in planes), *look)
        self.assertEqual(self.render(path, "--section-box=-0.25,0.5,-1,0.25,-1,0.5", *look), cut)
        self.assertNotEqual(cut, whole)

    def test_parts_are_kept_whole(self):
        """A plane that keeps nothing leaves those parts alone, which are drawn as without it."""
        path = self.write("boxes.glb", scenes.glb())
        look = ("--opacity", "*=1", "--size", "32x32", "--view", "30,40")
        nothing = "--section=1,0,0,1000"
        self.assertEqual(self.render(path, nothing, "--keep-whole", "*", *look), self.render(path, *look))
        name = info(path, "--parts")["part_list"][0]["path"]
        kept = self.render(path, nothing, f"--keep-whole={name}", *look)
        self.assertNotIn(kept, (self.render(path, *look), self.render(path, nothing, *look)))

    def test_caps_have_hatches_and_edges(self):
        path = self.write("boxes.glb", scenes.glb())
        look = ("--section=0,0,1,0.5", "--opacity", "*=1", "--size", "64x64", "--view", "180,20")
        plain = self.render(path, "--cut-edges=0", *look)
        pictures = [plain]
        for name in ("lines", "pairs", "dashes", "cross", "level", "dots"):
            hatched = self.render(path, "--cut-edges=0", f"--hatch={name}", *look)
            self.assertNotIn(hatched, pictures)
            pictures.append(hatched)
        # A hatch of parts by name wins over that of all.
        self.assertEqual(self.render(path, "--cut-edges=0", "--hatch=*=none", "--hatch=lines", *look), plain)
        own = self.render(path, "--cut-edges=0", "--hatch=*=lines", *look)
        self.assertEqual(self.render(path, "--cut-edges=0", "--hatch=*=lines", "--hatch=dots", *look), own)
        self.assertNotEqual(own, plain)
        self.assertEqual(self.render(path, "--cut-edges=1", *look), self.render(path, *look))
        self.assertNotEqual(self.render(path, *look), plain)

    def test_nothing_but_the_picture_is_written(self):
        self.render("demo:stack,layers=2", "--size", "8x8")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["picture.png"])

    def test_a_picture_is_replaced(self):
        self.write("picture.png", b"what was there")
        self.assertEqual(self.render("demo:stack,layers=2", "--size", "8x8")[:2], (8, 8))

    def test_a_relative_name(self):
        result = run("render", "demo:stack,layers=2", "--size", "8x8", "-o", "")
        self.assert_refused(result, "PNG")

    def test_zoom_and_direction_change_the_picture(self):
        scene = "demo:assembly,parts=60"
        pictures = {
            view: self.render(scene, "--size", "40x40", *arguments)
            for view, arguments in {
                "own": [], "front": ["--view", "0,0"], "top": ["--view", "0,90"],
                "near": ["--view", "0,0,2"], "behind": ["--view", "180,0"],
            }.items()
        }  # fmt: skip
        rows = [b"".join(map(bytes, picture[2])) for picture in pictures.values()]
        self.assertEqual(len(set(rows)), len(rows))

    def test_a_white_texture_changes_no_opacity(self):
        for opacity in ("1", "0.3"):
            with self.subTest(opacity=opacity):
                colors = [
                    self.render(
                        self.write("pane.gltf", pane(textured)),
                        "--size", "9x9", "--view", "0,0", "--opacity", opacity,
                    )[2][4][12:15]
                    for textured in (True, False)
                ]  # fmt: skip
                self.assertLess(colors[0][0], BACKGROUND - 10)
                self.assertLessEqual(max(abs(a - b) for a, b in zip(*colors)), 1)

    def test_a_link_is_followed(self):
        target = self.write("target.png", b"what was there")
        (self.folder / "link.png").symlink_to(target)
        self.render("demo:stack,layers=2", "--size", "8x8", name="link.png")
        self.assertTrue((self.folder / "link.png").is_symlink())
        self.assertEqual(read_png(target)[:2], (8, 8))

    def test_a_pipe_is_written_to(self):
        pipe = self.folder / "pipe.json"
        os.mkfifo(pipe)
        with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE) as reader:
            self.assert_done(run("info", "demo:stack,layers=2", "--size", "8x8", "--json", pipe))
            self.assertEqual(json.loads(reader.communicate()[0])["parts"], 2)
        self.assertTrue(pipe.is_fifo())

    def test_coincidence_changes_what_coincides_alone(self):
        for scene, is_changed in (("demo:spheres,layers=8", True), ("demo:stack,layers=8", False)):
            for method in ("linked-list", "truth"):
                options = (scene, "--size", "24x24", "--method", method)
                without = self.render(*options)
                tolerant = self.render(*options, "--coincidence", "64,2")
                self.assertEqual(tolerant != without, is_changed, (scene, method))

    def test_multisamples_smooth_edges(self):
        scene = ["demo:spheres,layers=1,alpha=1,resolution=5", "--size", "24x24"]
        shades = [
            len({bytes(row[3 * x : 3 * x + 3]) for row in picture[2] for x in range(24)})
            for picture in (self.render(*scene), self.render(*scene, "--multisamples", "4"))
        ]
        self.assertGreater(shades[1], shades[0])


if __name__ == "__main__":
    unittest.main()
