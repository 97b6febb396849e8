import json
import math
import os
import unittest

import scenes
from program import DEVICE, FEATURES, FileTest, compare, run

ROW = [
    "scene",
    "method",
    "width",
    "height",
    "first_frame_ms",
    "frame_ms",
    "fragments",
    "lost",
    "lost_is_least",
    "layers_max",
    "layers_mean",
    "geometry_passes",
    "bytes",
    "error",
    "deterministic",
]
OF_AUTOMATIC = ["chosen", "guaranteed_error", "regret"]
ERROR = ["max", "rmse", "psnr", "ssim", "flip", "wrong_pixels"]
SCENE = "demo:spheres,layers=6"


class Compare(FileTest):
    def test_json_is_as_agreed(self):
        told = compare(SCENE, "--methods", "all", "--frames", "3", "--size", "48x40")
        self.assertEqual(list(told), ["vitrine", "build", "device", "settings", "results"])
        self.assertEqual(list(told["build"]), ["vtk", "program", "library"])
        self.assertEqual(len(set(told["build"].values()) - {""}), 3)
        self.assertEqual(told["vitrine"], os.environ["VITRINE_VERSION"])
        self.assertEqual(list(told["device"]), DEVICE)
        self.assertTrue(all(told["device"].values()), told["device"])
        self.assertEqual(list(told["device"]["features"]), FEATURES)
        self.assertLessEqual({*told["device"]["features"].values()}, {True, False})
        methods = [row["method"] for row in told["results"]]
        for method in ("blend", "vtk-oit", "vtk-peeling-4", "vtk-peeling", "linked-list", "truth"):
            self.assertIn(method, methods)
        for row in told["results"]:
            with self.subTest(method=row["method"]):
                self.check_row(row)

    def check_row(self, row):
        told = [key for key in row if key not in OF_AUTOMATIC]
        self.assertEqual(told, ROW)
        self.assertEqual(len(told) < len(row), row["method"] == "automatic")
        self.assertEqual((row["scene"], row["width"], row["height"]), (SCENE, 48, 40))
        self.assertEqual(list(row["frame_ms"]), ["min", "median", "max", "frames"])
        times = row["frame_ms"]
        self.assertLess(0.0, row["first_frame_ms"])
        self.assertEqual(times["frames"], 3)
        self.assertTrue(0.0 < times["min"] <= times["median"] <= times["max"])
        self.assertEqual(row["layers_max"], 6)
        self.assertTrue(1.0 <= row["layers_mean"] <= 6.0)
        for key in ("fragments", "layers_max", "geometry_passes", "bytes"):
            self.assertIsInstance(row[key], int)
        self.assertEqual(list(row["error"]), ERROR)
        self.assertTrue(0.0 <= row["error"]["max"] <= 1.0)
        self.assertTrue(0.0 <= row["error"]["wrong_pixels"] <= 1.0)
        self.assertLessEqual(row["error"]["psnr"], 99.0)
        self.assertIs(row["deterministic"], True)

    def test_stages_add_up_to_the_frame(self):
        arguments = ("--methods", "vtk-oit,linked-list,stencil-routed,truth", "--stages")
        told = compare(SCENE, *arguments, "--frames", "3", "--size", "48x40")
        stages = {row["method"]: list(row["stages_ms"]) for row in told["results"]}
        self.assertEqual(
            stages,
            {
                "vtk-oit": ["opaque", "translucent"],
                "linked-list": ["opaque", "prepare", "fill", "classify", "resolve"],
                "stencil-routed": ["opaque", "fill", "resolve"],
                "truth": ["opaque"],
            },
        )
        for row in told["results"]:
            with self.subTest(method=row["method"]):
                self.assertEqual(list(row), [*ROW[:6], "stages_ms", *ROW[6:]])
                for times in row["stages_ms"].values():
                    self.assertEqual(list(times), ["min", "median", "max", "frames"])
                    self.assertEqual(times["frames"], 3)
                    self.assertTrue(0.0 <= times["min"] <= times["median"] <= times["max"])
                least = sum(times["min"] for times in row["stages_ms"].values())
                self.assertLessEqual(least, row["frame_ms"]["max"])
        result = run("compare", SCENE, *arguments, "--frames", "1", "--size", "8x8")
        self.assert_done(result)
        for word in (b"stages", b"fill", b"classify", b"sum"):
            self.assertIn(word, result.stdout)

    def test_without_truth_errors_are_unknown(self):
        told = compare(
            *(SCENE, "--methods", "vtk-oit,linked-list", "--frames", "1", "--size", "8x8"),
            "--without-truth",
        )
        self.assertTrue(all(told["device"].values()), told["device"])
        for row, layers in zip(told["results"], (None, 6)):
            self.assertEqual(list(row), ROW)
            self.assertEqual((row["error"], row["layers_max"]), (None, layers))

    def test_switches_choose_the_path_and_are_told(self):
        arguments = ("compare", SCENE, "--methods", "linked-list", "--frames", "1", "--size", "48x40")
        result = run(*arguments, "--json", "-", VITRINE_DEVICE="no-fetch")
        self.assert_done(result)
        told = json.loads(result.stdout)
        self.assertEqual(list(told["device"]), [*DEVICE, "switches"])
        self.assertEqual(told["device"]["switches"], "no-fetch")
        self.assertLessEqual(told["results"][0]["error"]["max"], 1.0 / 255.0)

    def test_opaque_files_are_told(self):
        path = self.write("plate.stl", scenes.binary_stl())
        advice = b"Nothing in it is translucent; --opacity 0.3 makes it so.\n"
        for arguments, is_told in (((path,), True), ((path, "--opacity", "0.3"), False)):
            result = run("compare", *arguments, "--frames", "1", "--size", "8x8")
            self.assert_done(result)
            self.assertEqual(result.stdout.endswith(advice), is_told, result.stdout)

    def test_rows_say_what_was_lost(self):
        told = compare(
            "demo:stack,layers=20",
            "--methods",
            "stencil-mask-4,stencil-mask-16-unfiltered,linked-list,blend",
            *("--frames", "1", "--size", "8x8"),
        )
        lost = [row["lost"] for row in told["results"]]
        self.assertEqual(lost, [16 * 64, 4 * 64, 0, None])
        self.assertFalse(any(row["lost_is_least"] for row in told["results"]))
        deep = compare(
            *("demo:stack,layers=300", "--methods", "stencil-mask-8", "--frames", "1"),
            *("--size", "8x8"),
        )
        self.assertTrue(deep["results"][0]["lost_is_least"])

    def test_stencil_routing_is_exact_or_says_why_not(self):
        told = compare(
            *("demo:spheres,layers=10", "--frames", "2", "--size", "40x30", "--methods"),
            ",".join(["stencil-routed", *(f"stencil-routed-{k}" for k in (1, 2, 4, 8, 16, 32))]),
        )
        automatic, one, *more = told["results"]
        for row in (automatic, one, *(row for row in more if "skipped" not in row)):
            self.assertLessEqual(row["error"]["max"], 1.0 / 255.0)
            self.assertEqual((row["lost"], row["layers_max"]), (0, 10))
        self.assertEqual(one["geometry_passes"], 10)
        for row in more:
            self.assertIn("samples", row.get("skipped", "samples"))

    def test_errors_tell_the_methods_apart(self):
        told = compare(
            "demo:stack,layers=6,alpha=0.5", "--methods", "all", "--frames", "2", "--size", "32x32"
        )
        rows = {row["method"]: row for row in told["results"]}
        for exact in ("linked-list", "truth"):
            self.assertLess(rows[exact]["error"]["max"], 1.0 / 255.0)
            self.assertEqual(rows[exact]["error"]["wrong_pixels"], 0.0)
        for approximate in ("blend", "vtk-oit"):
            self.assertGreater(rows[approximate]["error"]["max"], 8.0 / 255.0)
        passes = {method: row["geometry_passes"] for method, row in rows.items()}
        self.assertEqual((passes["blend"], passes["vtk-oit"], passes["linked-list"]), (1, 1, 1))
        self.assertGreaterEqual(passes["vtk-peeling"], 3)

    def test_passes_are_those_of_the_timed_frames(self):
        # What the frame before does not tell is counted first, each time that the camera jumps.
        for orbit, passes in (("0", 1), ("120", 2)):
            told = compare(
                *("demo:assembly,parts=5", "--methods", "prefix-sum-predicted"),
                *("--frames", "5", "--size", "64x64", "--orbit", orbit),
            )
            self.assertEqual(told["results"][0]["geometry_passes"], passes, orbit)

    def test_figures_are_what_their_names_say(self):
        told = compare(
            *("demo:stack,layers=6,alpha=0.5", "--methods", "blend", "--frames", "1"),
            *("--size", "16x16"),
        )
        error = told["results"][0]["error"]
        # All pixels are alike: the largest difference is that of one channel, RMSE the mean of three.
        self.assertLess(1.02 * error["rmse"], error["max"])
        self.assertLess(error["max"], 1.74 * error["rmse"])
        self.assertAlmostEqual(error["psnr"], -20.0 * math.log10(error["rmse"]), delta=0.01)
        self.assertEqual(error["wrong_pixels"], 1.0)
        self.assertLess(error["flip"], error["ssim"])

    def test_few_peels_leave_an_error(self):
        told = compare(
            "demo:stack,layers=12,alpha=0.5",
            "--methods",
            "vtk-peeling-1,vtk-peeling-9",
            "--frames",
            "1",
            "--size",
            "16x16",
        )
        few, many = told["results"]
        self.assertGreater(few["error"]["max"], 4.0 * many["error"]["max"])
        self.assertLess(few["geometry_passes"], many["geometry_passes"])

    def test_memory_of_vtks_methods(self):
        told = compare(
            "demo:stack,layers=2",
            "--methods",
            "blend,vtk-oit,vtk-peeling",
            "--frames",
            "1",
            "--size",
            "10x10",
        )
        self.assertEqual([row["bytes"] for row in told["results"]], [0, 1400, 3600])

    def test_groups_and_repeated_methods(self):
        told = compare(
            SCENE, "--methods", "linked-list,exact,linked-list", "--frames", "1", "--size", "8x8"
        )
        self.assertEqual([row["method"] for row in told["results"]].count("linked-list"), 1)

    def test_settings_are_told(self):
        told = compare(
            SCENE, "--methods", "linked-list", "--frames", "1", "--size", "8x8",
            "--opacity", "0.5", "--view", "10,20,2", "--orbit", "7", "--multisamples", "4",
        )  # fmt: skip
        self.assertEqual(
            told["settings"], {"opacity": 0.5, "view": [10, 20, 2], "orbit": 7, "multisamples": 4}
        )

    def test_coincidence_is_of_methods_and_truth_alike(self):
        told = compare(
            "demo:spheres,layers=8", "--methods", "linked-list,prefix-sum-compact,truth,blend",
            "--frames", "1", "--size", "40x40", "--coincidence", "4096,2",
        )  # fmt: skip
        self.assertEqual(told["settings"]["coincidence"], [4096, 2])
        for row in told["results"][:3]:
            self.assertLessEqual(row["error"]["max"], 1 / 255, row["method"])
        self.assertIn("no tolerance", told["results"][3]["skipped"])

    def test_with_a_coincidence_all_rows_can_be_skipped(self):
        told = compare(
            SCENE, "--methods", "stencil-routed,stencil-mask-4,vtk-oit,vtk-peeling",
            "--frames", "1", "--size", "8x8", "--coincidence", "0,1",
        )  # fmt: skip
        self.assertTrue(all(told["device"].values()), told["device"])
        for row in told["results"]:
            self.assertIn("no tolerance", row["skipped"], row["method"])

    def test_layers_of_alpha_1_hide_what_is_behind(self):
        row = compare(
            "demo:stack,layers=3,alpha=1", "--methods", "linked-list", "--frames", "1",
            "--size", "8x8",
        )["results"][0]  # fmt: skip
        self.assertEqual(row["fragments"], 3 * 64)
        self.assertLessEqual(row["error"]["max"], 1 / 255)

    def test_opaque_scene_has_no_error(self):
        told = compare(
            self.write("opaque.stl", scenes.binary_stl()),
            "--methods",
            "vtk-oit,linked-list",
            "--frames",
            "1",
            "--size",
            "8x8",
        )
        for row in told["results"]:
            self.assertEqual(list(row["error"].values()), [0, 0, 99, 1, 0, 0])
            self.assertEqual(row["fragments"], 0)

    def test_table_and_json(self):
        path = self.folder / "results.json"
        result = run(
            "compare",
            SCENE,
            "--methods",
            "blend,truth",
            "--frames",
            "1",
            "--size",
            "8x8",
            "--json",
            path,
        )
        self.assert_done(result)
        for word in (b"blend", b"truth", b"flip", SCENE.encode()):
            self.assertIn(word, result.stdout)
        self.assertEqual(len(json.loads(path.read_text())["results"]), 2)

    def test_a_method_that_cannot_run_is_a_row_that_says_why(self):
        result = run(
            "compare",
            SCENE,
            "--methods",
            "blend,linked-list",
            "--frames",
            "1",
            "--size",
            "8x8",
            "--json",
            "-",
            MESA_GL_VERSION_OVERRIDE="3.2",
        )
        told = json.loads(result.stdout)
        if "3.2" not in told["device"]["gl"]:
            self.skipTest("the driver is not Mesa's")
        blend, linked_list = told["results"]
        self.assertEqual(list(linked_list), ["scene", "method", "width", "height", "skipped"])
        self.assertIn("4.3", linked_list["skipped"])
        self.assertEqual(list(blend), ROW)
        self.assertIsNone(blend["error"])

    def test_a_method_that_gives_up_on_the_way_is_a_row_that_says_why(self):
        # seen from the side first, in few fragments, and end-on in the last frame, in 66,000 a pixel
        result = run(
            "compare", "demo:needles,needles=660000", "--methods", "prefix-sum,blend",
            "--frames", "2", "--size", "2x2", "--view", "30,0,32", "--orbit", "-30", "--json", "-",
        )  # fmt: skip
        self.assertEqual(result.returncode, 0)
        self.assertIn(b"65535", result.stderr)
        prefix_sum, blend = json.loads(result.stdout)["results"]
        self.assertEqual(list(prefix_sum), ["scene", "method", "width", "height", "skipped"])
        self.assertIn("65535", prefix_sum["skipped"])
        self.assertEqual(list(blend), ROW)
        self.assertEqual(blend["layers_max"], 66000)

    def test_depth_peeling_does_not_run_in_multisampled_windows(self):
        result = run(
            "compare", SCENE, "--methods", "vtk-oit,vtk-peeling,vtk-peeling-2", "--frames", "1",
            "--size", "8x8", "--multisamples", "4", "--json", "-",
        )  # fmt: skip
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr.count(b"\n"), 1)  # once for both
        self.assertIn(b"multisampling", result.stderr)
        oit, *peelings = json.loads(result.stdout)["results"]
        self.assertEqual(list(oit), ROW)
        for row in peelings:
            self.assertIn("multisampling", row["skipped"])


if __name__ == "__main__":
    unittest.main()
