import json
import unittest

import scenes
from program import FileTest, info, run


class Info(FileTest):
    def test_json_has_all_keys(self):
        told = info("demo:spheres,layers=4,alpha=0.5")
        self.assertEqual(
            list(told),
            [
                "scene",
                "parts",
                "translucent_parts",
                "triangles",
                "lines",
                "points",
                "lights",
                "materials",
                "bounds",
                "length_unit",
                "layers",
                "expected",
                "arrays",
                "skipped",
                "notes",
            ],
        )
        self.assertEqual(
            list(told["layers"]), ["width", "height", "fragments", "layers_max", "layers_mean"]
        )

    def test_layers_of_the_stack(self):
        layers = info("demo:stack,layers=7")["layers"]
        self.assertEqual(
            layers,
            {"width": 16, "height": 16, "fragments": 7 * 256, "layers_max": 7, "layers_mean": 7.0},
        )

    def test_layers_are_those_of_the_view(self):
        front = info("demo:stack,layers=3", "--view", "0,0")["layers"]["fragments"]
        edge = info("demo:stack,layers=3", "--view", "90,0")["layers"]["fragments"]
        self.assertEqual(front, 3 * 256)
        self.assertLess(edge, front)

    def test_layers_are_those_that_a_section_leaves(self):
        half = info("demo:stack,layers=3", "--section", "1,0,0,0")["layers"]["fragments"]
        self.assertEqual(half, 3 * 128)
        layers = info("demo:stack,layers=3", "--section", "0,0,1,0")["layers"]
        self.assertEqual((layers["layers_max"], layers["layers_mean"]), (2, 2.0))

    def test_opaque_scene_has_no_layers(self):
        layers = info(self.write("opaque.stl", scenes.binary_stl()))["layers"]
        self.assertEqual((layers["fragments"], layers["layers_max"]), (0, 0))

    def test_text(self):
        result = run("info", "demo:stack,layers=3", "--size", "16x16")
        self.assert_done(result)
        for word in (b"parts", b"triangles", b"materials", b"bounds", b"layers"):
            self.assertIn(word, result.stdout)

    def test_text_and_json(self):
        path = self.folder / "info.json"
        result = run("info", "demo:stack,layers=3", "--size", "16x16", "--json", path)
        self.assert_done(result)
        self.assertIn(b"parts", result.stdout)
        self.assertEqual(json.loads(path.read_text())["parts"], 3)

    def test_without_what_truth_needs_it_says_so(self):
        result = run(
            "info",
            "demo:stack,layers=3",
            "--size",
            "16x16",
            "--json",
            "-",
            MESA_GL_VERSION_OVERRIDE="3.2",
        )
        layers = json.loads(result.stdout)["layers"]
        if "skipped" not in layers:
            self.skipTest("the driver is not Mesa's")
        self.assertIn("4.3", layers["skipped"])
        self.assertEqual(result.stderr.count(b"\n"), 1)


if __name__ == "__main__":
    unittest.main()
