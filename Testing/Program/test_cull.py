import json
import unittest

from program import FileTest, run

ROW = [
    "input", "parts", "opaque_parts", "drawn", "ideal", "culled_share", "ideal_share", "cull_ms",
    "frame_ms", "frame_ms_without", "wrong_pixels", "poses",
]  # fmt: skip
POSE = ["drawn", "ideal", "cull_ms", "frame_ms", "frame_ms_without", "wrong_pixels"]
SMALL = ("--size", "120x67", "--poses", "6")


def cull(*arguments):
    """The JSON of a run on few small frames."""
    result = run("cull", *arguments, *SMALL, "--json", "-")
    if result.returncode != 0:
        raise AssertionError(result.stderr.decode(errors="replace"))
    return json.loads(result.stdout)


class Cull(FileTest):
    def test_json_is_as_agreed(self):
        told = cull("demo:assembly,parts=300", "demo:spheres,layers=8")
        self.assertEqual(list(told), ["vitrine", "build", "device", "settings", "results"])
        self.assertEqual(
            told["settings"],
            {"width": 120, "height": 67, "multisamples": 0, "poses": 6, "seed": 1,
             "method": "vtk-oit", "buffer_lines": 270},
        )  # fmt: skip
        self.assertEqual(
            [row["input"] for row in told["results"]],
            ["demo:assembly,parts=300", "demo:spheres,layers=8"],
        )
        for row in told["results"]:
            self.assertEqual(list(row), ROW)
            self.assertEqual([list(pose) for pose in row["poses"]], 6 * [POSE])
            self.assertTrue(0.0 <= row["culled_share"] <= row["ideal_share"] <= 1.0)

    def test_culls_most_of_what_is_hidden_and_changes_no_pixel(self):
        for multisamples in ("0", "4"):
            with self.subTest(multisamples=multisamples):
                row = cull("demo:assembly,parts=300", "--multisamples", multisamples)["results"][0]
                self.assertEqual((row["parts"], row["opaque_parts"]), (300, 300))
                self.assertEqual(row["wrong_pixels"], 0)
                self.assertGreater(row["culled_share"], 0.5 * row["ideal_share"])

    def test_parts_may_be_blocks_and_runs_of_a_mesh(self):
        as_actors, as_blocks, as_mesh = (
            cull("demo:assembly,parts=300", "--as", form)["results"][0]
            for form in ("actors", "blocks", "mesh")
        )
        self.assertEqual(as_blocks["parts"], as_actors["parts"])
        self.assertEqual(as_blocks["ideal_share"], as_actors["ideal_share"])
        self.assertGreater(as_blocks["culled_share"], 0.9 * as_actors["culled_share"])
        self.assertGreater(as_mesh["parts"], 20)
        self.assertGreater(as_mesh["culled_share"], 0.2)
        self.assertEqual((as_mesh["ideal"], as_mesh["ideal_share"]), (None, None))
        for row in (as_blocks, as_mesh):
            self.assertEqual(row["wrong_pixels"], 0)

    def test_what_is_translucent_hides_nothing(self):
        row = cull("demo:assembly,parts=300", "--keep-opacity")["results"][0]
        self.assertEqual((row["opaque_parts"], row["ideal"], row["ideal_share"]), (0, None, None))
        self.assertEqual(row["wrong_pixels"], 0)

    def test_poses_are_those_of_the_seed(self):
        first, again, other = (
            [pose["drawn"] for pose in cull("demo:assembly,parts=300", "--seed", seed)["results"][0]["poses"]]
            for seed in "112"
        )
        self.assertEqual(first, again)
        self.assertNotEqual(first, other)

    def test_without_ideal(self):
        row = cull("demo:assembly,parts=300", "--without-ideal")["results"][0]
        self.assertEqual((row["ideal"], row["ideal_share"]), (None, None))

    def test_bad_input_is_told_in_one_line(self):
        for arguments in (
            ("nowhere.glb",),
            ("demo:assembly,parts=0",),
            ("demo:assembly", "--poses", "0"),
            ("demo:assembly", "--projection", "fisheye"),
            ("demo:assembly", "--size", "10"),
            ("demo:assembly", "--method", "magic"),
            ("demo:assembly", "--lines", "0"),
            ("demo:assembly", "--as", "voxels"),
            (),
        ):
            with self.subTest(arguments=arguments):
                result = run("cull", *arguments)
                self.assertEqual((result.returncode, result.stdout), (2, b""))
                self.assertEqual(result.stderr.count(b"\n"), 1, result.stderr)


if __name__ == "__main__":
    unittest.main()
