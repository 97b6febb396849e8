import json
import unittest

from program import FileTest, read_png, run

ROW = [
    "input", "mode", "lights", "frame_ms", "first_frame_ms", "assignment_ms", "lights_per_cluster",
    "clusters", "clusters_used", "bytes", "error", "reference",
]  # fmt: skip
SMALL = ("--size", "60x40", "--frames", "2")


def lights(*arguments):
    """The JSON of a run on few small frames."""
    result = run("lights", *arguments, *SMALL, "--json", "-")
    if result.returncode != 0:
        raise AssertionError(result.stderr.decode(errors="replace"))
    return json.loads(result.stdout)


class Lights(FileTest):
    def test_json_is_as_agreed(self):
        told = lights("demo:stack,layers=1", "--lights", "2", "--modes", "vtk,vtk")
        self.assertEqual(list(told), ["vitrine", "build", "device", "settings", "results"])
        self.assertEqual(
            told["settings"],
            {"width": 60, "height": 40, "frames": 2, "orbit": 30.0, "tile": 64, "slices": 16,
             "slice_law": "exponential",
             "cutoff": 0.5 / 255},
        )  # fmt: skip
        (drawn,) = told["results"]
        self.assertEqual(list(drawn), ROW)
        self.assertEqual((drawn["mode"], drawn["lights"], drawn["reference"]), ("vtk", 2, "vtk"))
        self.assertEqual(drawn["error"], {"max": 0.0})
        self.assertEqual(drawn["frame_ms"]["frames"], 2)
        self.assertLess(0.0, drawn["frame_ms"]["min"])
        self.assertLess(0.0, drawn["first_frame_ms"])

    def test_what_a_mode_cannot_draw_is_a_row_with_a_reason(self):
        (row,) = lights("demo:stack,layers=1", "--lights", "65")["results"]
        self.assertEqual(list(row), ["input", "mode", "lights", "skipped"])
        self.assertIn("65 lights", row["skipped"])

    def test_lights_are_those_asked_for_or_the_scene_s_own(self):
        for arguments, expected in (
            (("demo:hall,lights=65",), 65),
            (("demo:hall,lights=65", "--lights", "66"), 66),
        ):
            with self.subTest(arguments=arguments):
                self.assertEqual(lights(*arguments)["results"][0]["lights"], expected)

    def test_a_g_buffer_shows_the_scene_as_vtk_does(self):
        modes = ["deferred", "tiled-deferred", "clustered-deferred"]
        told = lights("demo:hall,lights=8", "--modes", ",".join(modes), "--cutoff", "0")["results"]
        self.assertEqual([row["mode"] for row in told], modes)
        for row in told:
            with self.subTest(mode=row["mode"]):
                self.assertEqual((row["error"], row["reference"]), ({"max": 0.0}, "vtk"))
                self.assertGreater(row["bytes"], 60 * 40 * 32)
        used = [(row["clusters_used"], row["clusters"]) for row in told]
        self.assertEqual(used[0], (1, 1))
        self.assertLess(used[2][0], used[2][1])

    def test_cubes_of_the_world_show_the_scene_as_vtk_does(self):
        (row,) = lights("demo:hall,lights=8", "--modes", "world", "--cutoff", "0")["results"]
        self.assertEqual((row["mode"], row["error"]), ("world", {"max": 0.0}))
        self.assertGreater(row["clusters_used"], 1)

    def test_heat_map_shows_that_vtk_looks_at_all_lights(self):
        path = self.folder / "heat.png"
        scene = ("demo:stack,layers=1", "--lights", "2")
        self.assert_done(run("lights", *scene, *SMALL, "--heat-map", path))
        width, height, rows = read_png(path)
        self.assertEqual((width, height), (60, 40))
        self.assertEqual(set(b"".join(map(bytes, rows))), {255})

    def test_text_has_a_row_for_each_mode(self):
        told = run("lights", "demo:stack,layers=1", "--lights", "65", *SMALL)
        self.assert_done(told)
        self.assertIn(b"demo:stack,layers=1 vtk  skipped: 65 lights", told.stdout)

    def test_bad_input_is_told_in_one_line(self):
        for arguments in (
            ("nowhere.glb",),
            ("demo:hall,lights=-1",),
            ("demo:non-finite",),
            ("demo:hall", "--lights", "0"),
            ("demo:hall", "--lights", "1048577"),
            ("demo:hall", "--modes", "magic"),
            ("demo:hall", "--modes", ""),
            ("demo:hall", "--tile", "48"),
            ("demo:hall", "--slices", "0"),
            ("demo:hall", "--slice-law", "cubic"),
            ("demo:hall", "--cutoff", "nan"),
            ("demo:hall", "--cutoff", "-1"),
            ("demo:hall", "--size", "10"),
            ("demo:hall", "--frames", "0"),
            ("demo:hall", "--json", self.folder / "nowhere" / "lights.json"),
            ("demo:hall", "--heat-map", "picture.jpg"),
            ("demo:hall", "demo:stack", "--heat-map", self.folder / "picture.png"),
            ("demo:stack,layers=1", "--lights", "65", "--heat-map", self.folder / "picture.png"),
            (),
        ):
            with self.subTest(arguments=arguments):
                self.assert_refused(run("lights", *arguments))
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
