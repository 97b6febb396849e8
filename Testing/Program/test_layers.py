import json
import unittest

import scenes
from program import FileTest, run


class Layers(FileTest):
    def layers(self, *arguments):
        result = run("layers", *arguments, "--size", "16x12", "--json", "-")
        self.assert_done(result)
        return json.loads(result.stdout)

    def test_json_has_all_layers_of_a_pixel(self):
        told = self.layers("demo:stack,layers=4,alpha=0.5", "--at", "7,5")
        self.assertEqual(list(told), ["scene", "size", "pixel", "background", "layers"])
        self.assertEqual((told["size"], told["pixel"]), ([16, 12], [7, 5]))
        self.assertEqual(
            list(told["layers"][0]),
            ["part", "depth", "distance", "position", "color", "opacity", "share", "front", "opaque"],
        )
        for share, layer in zip((0.5, 0.25, 0.125, 0.0625), told["layers"], strict=True):
            self.assertAlmostEqual(layer["share"], share, 3)
        self.assertAlmostEqual(told["background"], 0.0625, 3)
        distances = [layer["distance"] for layer in told["layers"]]
        self.assertEqual(distances, sorted(distances))
        self.assertEqual(len({layer["part"] for layer in told["layers"]}), 4)

    def test_all_goes_behind_opaque_layers(self):
        # Two boxes, one behind the other.
        scene = (self.write("boxes.stl", scenes.binary_stl()), "--view", "90,0", "--at", "9,5")
        seen = self.layers(*scene)["layers"]
        told = self.layers(*scene, "--all")["layers"]
        self.assertEqual([layer["opaque"] for layer in seen], [True])
        self.assertEqual([layer["share"] for layer in told], [1, 0, 0, 0])
        self.assertEqual(told[0], seen[0])

    def test_parts_have_one_name_in_all_commands(self):
        path = self.write("boxes.stl", scenes.binary_stl())
        told = self.layers(path, path, "--view", "90,0", "--at", "9,5", "--all")
        listed = json.loads(run("info", path, path, "--size", "16x12", "--parts", "--json", "-").stdout)
        clashes = json.loads(run("clash", path, path, "--json", "-").stdout)
        names = [part["path"] for part in listed["part_list"]]
        self.assertEqual(len(set(names)), 2)
        self.assertEqual({layer["part"] for layer in told["layers"]}, set(names))
        self.assertEqual(clashes["pairs"][0]["parts"], names)

    def test_text(self):
        result = run("layers", "demo:stack,layers=2", "--size", "16x12", "--at", "0,11")
        self.assert_done(result)
        for word in (b"pixel       0,11 of 16x12", b"layers      2", b"background", b"share", b"front"):
            self.assertIn(word, result.stdout)

    def test_refuses_other_pixels(self):
        for at, reason in (
            ("16,0", "outside of the picture"),
            ("0,12", "outside of the picture"),
            ("-1,0", "outside of the picture"),
            ("1", "not X,Y"),
            ("1,2,3", "not X,Y"),
            ("1.5,2", "not X,Y"),
            ("nan,2", "not X,Y"),
            ("99999999999,2", "not X,Y"),
        ):
            with self.subTest(at=at):
                result = run("layers", "demo:stack", "--size", "16x12", f"--at={at}")
                self.assertEqual(result.returncode, 2)
                self.assertIn(reason, result.stderr.decode())
                self.assertEqual(len(result.stderr.splitlines()), 1)


if __name__ == "__main__":
    unittest.main()
