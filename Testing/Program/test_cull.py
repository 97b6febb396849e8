import itertools
import json
import pathlib
import unittest

from program import FileTest, read_png, run

ROOT = pathlib.Path(__file__).parents[2]
ROW = [
    "input", "parts", "opaque_parts", "drawn", "ideal", "culled_share", "ideal_share", "cull_ms",
    "frame_ms", "frame_ms_without", "frame_ms_ideal", "wrong_pixels", "props", "poses",
]  # fmt: skip
POSE = [
    "mode", "reason", "lines", "drawn", "ideal", "cull_ms",
    "frame_ms", "frame_ms_without", "frame_ms_ideal", "wrong_pixels",
]  # fmt: skip
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
             "method": "vtk-oit", "buffer_lines": 0, "turn_degrees": 0.0, "skipped_poses": 0,
             "projection": "both", "as": "actors", "opaque_from": 0.0, "samples": 1},
        )  # fmt: skip
        self.assertEqual(
            [row["input"] for row in told["results"]],
            ["demo:assembly,parts=300", "demo:spheres,layers=8"],
        )
        for row in told["results"]:
            self.assertEqual(list(row), ROW)
            self.assertEqual([list(pose) for pose in row["poses"]], 6 * [POSE])
            self.assertLess(0.0, row["frame_ms_ideal"])
            self.assertTrue(0.0 <= row["culled_share"] <= row["ideal_share"] <= 1.0)

    def test_culls_most_of_what_is_hidden_and_changes_no_pixel(self):
        for multisamples in ("0", "4"):
            with self.subTest(multisamples=multisamples):
                row = cull("demo:assembly,parts=300", "--multisamples", multisamples)["results"][0]
                self.assertEqual((row["parts"], row["opaque_parts"]), (300, 300))
                self.assertEqual(row["wrong_pixels"], 0)
                self.assertGreater(row["culled_share"], 0.5 * row["ideal_share"])

    def test_says_why_props_are_drawn(self):
        (row,) = cull("demo:assembly,parts=300")["results"]
        counts = {each["reason"]: each["per_frame"] for each in row["props"]}
        self.assertEqual(list(counts.values()), sorted(counts.values(), reverse=True))
        self.assertAlmostEqual(sum(counts.values()), 300)
        left_out = sum(count for reason, count in counts.items() if reason.startswith("left out: "))
        self.assertAlmostEqual(300 - left_out, row["drawn"])
        self.assertGreater(counts["left out: hidden by others"], 50)
        self.assertEqual({(pose["mode"], pose["reason"]) for pose in row["poses"]}, {("occlusion", "")})

    def test_text_says_why(self):
        told = run("cull", "demo:impostors", "--without-ideal", "--keep-opacity", *SMALL)
        self.assert_done(told)
        self.assertRegex(told.stdout.decode(), r"\n  6 frames: \w+")
        self.assertRegex(told.stdout.decode(), r"\n  \d+\.\d props a frame: \w+")

    def test_docs_have_all_limits(self):
        told = run("cull", "--limits")
        self.assert_done(told)
        docs = (ROOT / "docs" / "reference" / "culler-limits.md").read_text()
        begin, end = (f"<!-- vitrine cull --limits: {mark} -->\n" for mark in ("begin", "end"))
        self.assertEqual(docs.split(begin)[1].split(end)[0], told.stdout.decode())

    def test_poses_may_be_skipped(self):
        all_poses, last = (
            cull("demo:assembly,parts=300", *skipped)["results"][0]["poses"]
            for skipped in ((), ("--skip", "4"))
        )
        ideal = [pose["ideal"] for pose in all_poses]
        self.assertEqual([pose["ideal"] for pose in last[:2]], ideal[4:])
        self.assertNotEqual(ideal[:2], ideal[4:])

    def test_camera_may_turn_between_frames(self):
        still, turning = (
            cull("demo:assembly,parts=300", "--turn", degrees)["results"][0]
            for degrees in ("0", "2.5")
        )
        self.assertEqual((still["wrong_pixels"], turning["wrong_pixels"]), (0, 0))
        self.assertEqual(still["ideal"], turning["ideal"])

    def test_what_vtks_own_culler_loses_is_not_wrong(self):
        for scene in ("demo:at-face", "demo:impostors"):
            with self.subTest(scene=scene):
                row = cull(scene, "--without-ideal")["results"][0]
                self.assertEqual(row["wrong_pixels"], 0)

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

    def test_of_points_that_are_not_finite_no_ideal_is_known(self):
        row = cull("demo:non-finite")["results"][0]
        self.assertEqual((row["opaque_parts"], row["ideal"], row["ideal_share"]), (0, None, None))
        self.assertEqual(row["wrong_pixels"], 0)

    def test_some_are_opaque(self):
        counts = []
        for least in ("0", "0.3", "1"):
            row = cull("demo:assembly,parts=300", "--opaque-from", least, "--method", "linked-list")[
                "results"
            ][0]
            self.assertEqual(row["wrong_pixels"], 0)
            counts.append(row["opaque_parts"])
        self.assertEqual(counts[0], 300)
        self.assertTrue(50 < counts[1] < 300, counts)
        self.assertEqual(counts[2], 0)

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

    def buffer_picture(self, *arguments):
        """Rows of pixels of the last pose, 120x67, and of what the s-buffer holds of it."""
        path = self.folder / "buffer.png"
        self.assert_done(run("cull", *arguments, "--size", "120x67", "--buffer", path))
        self.assertEqual([entry.name for entry in self.folder.iterdir()], ["buffer.png"])
        width, height, rows = read_png(path)
        self.assertEqual((width, height), (240, 67))
        pixels = [[tuple(row[x : x + 3]) for x in range(0, 3 * width, 3)] for row in rows]
        return [row[:120] for row in pixels], [row[120:] for row in pixels]

    def test_buffer_is_a_picture_beside_the_last_pose(self):
        frame, buffer = self.buffer_picture("demo:assembly,parts=300", "--poses", "1")
        greys = [grey for row in buffer for grey, *_ in row]
        self.assertEqual([(grey, grey, grey) for grey in greys], sum(buffer, []))
        self.assertLessEqual(set(greys), {0, *range(50, 256)})
        self.assertEqual(max(greys), 255)
        drawn = [pixel != frame[0][0] for row in frame for pixel in row]
        covered = [grey > 0 for grey in greys]
        self.assertEqual(covered, [a and b for a, b in zip(covered, drawn, strict=True)])
        self.assertGreater(sum(covered), 0.7 * sum(drawn))

    def test_buffer_of_fewer_lines_is_as_large(self):
        _, buffer = self.buffer_picture("demo:assembly,parts=300", "--poses", "1", "--lines", "20")
        for x, y in itertools.product(range(0, 120, 4), range(0, 64, 4)):
            cell = {buffer[66 - y - j][x + i] for i in range(4) for j in range(4)}
            self.assertEqual(len(cell), 1, (x, y))

    def test_buffer_of_what_is_translucent_is_black(self):
        _, buffer = self.buffer_picture("demo:spheres,layers=2", "--keep-opacity", "--poses", "1")
        self.assertEqual(set(sum(buffer, [])), {(0, 0, 0)})

    def test_bad_input_is_told_in_one_line(self):
        for arguments in (
            ("nowhere.glb",),
            ("demo:assembly,parts=0",),
            ("demo:assembly", "--poses", "0"),
            ("demo:assembly", "--projection", "fisheye"),
            ("demo:assembly", "--size", "10"),
            ("demo:assembly", "--method", "magic"),
            ("demo:assembly", "--lines", "-1"),
            ("demo:assembly", "--as", "voxels"),
            ("demo:assembly", "--opaque-from", "nan"),
            ("demo:assembly", "--opaque-from", "1.1"),
            ("demo:assembly", "--opaque-from", "0.5", "--keep-opacity"),
            ("demo:assembly", "--opaque-from", "0.5", "--as", "mesh"),
            ("demo:assembly", "--keep-opacity", "--as", "blocks"),
            ("demo:assembly", "--multisamples", "3"),
            ("demo:assembly", "--poses", "1e9"),
            ("demo:assembly", "--seed", "-1"),
            ("demo:assembly", "--seed", "99999999999999999999"),
            ("demo:assembly", "--json", self.folder / "nowhere" / "cull.json"),
            ("demo:assembly", "--buffer", "picture.jpg"),
            ("demo:assembly", "--buffer", self.folder / "nowhere" / "picture.png"),
            ("demo:assembly", "demo:stack", "--buffer", self.folder / "picture.png"),
            ("demo:assembly", "--buffer", self.folder / "a.png", "--json", self.folder / "a.png"),
            (),
        ):
            with self.subTest(arguments=arguments):
                result = run("cull", *arguments)
                self.assertEqual((result.returncode, result.stdout), (2, b""))
                self.assertEqual(result.stderr.count(b"\n"), 1, result.stderr)

    def test_no_input_is_written_over(self):
        model = self.folder / "model.png"
        model.write_bytes(b"v 0 0 0\n")
        link = self.folder / "link.png"
        link.symlink_to(model)
        for arguments in (
            ("cull", model, "--json", model),
            ("cull", model, "--json", link),
            ("cull", model, "--buffer", model),
            ("compare", model, "--json", model),
            ("info", model, "--json", model),
            ("lights", model, "--json", model),
            ("lights", model, "--heat-map", model),
            ("render", model, "-o", model),
            ("stability", model, "--json", model),
        ):
            with self.subTest(arguments=arguments):
                result = run(*arguments)
                self.assertEqual(result.returncode, 2)
                self.assertIn(b"would be written, but is an INPUT", result.stderr)
                self.assertEqual(model.read_bytes(), b"v 0 0 0\n")

    def test_ideal_is_counted_far_from_the_origin_too(self):
        row = cull("demo:large-coordinates", "--seed", "3")["results"][0]
        self.assertLess(1, row["ideal"])

    def test_what_may_be_chosen_is_told(self):
        for option, choices in (
            ("--as", b"{actors,blocks,mesh}"),
            ("--projection", b"{perspective,parallel,both}"),
            ("--seed", b"0 to 9007199254740991\n"),
        ):
            self.assertIn(choices, run("cull", "demo:assembly", option, "other").stderr)


if __name__ == "__main__":
    unittest.main()
