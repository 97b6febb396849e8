"""Methods fail where they are known to fail, in the known way, and nowhere else."""

import json
import pathlib
import re
import signal
import subprocess
import unittest

import stability_figures
from charts import stop_when
from program import PROGRAM, FileTest, environment_without_display, run
from scenes import binary_stl, glb, obj

STEP = 1.0 / 255.0 + 1e-6
# Each sample is rounded to 8 bits, and their mean again; what nodes round comes on top.
STEP_OF_SAMPLES = 1.2 / 255.0
# Rounding to 8 bits adds less than a step to a change; what nodes round may take a quarter of one in either picture.
EXCESS = 1.5 / 255.0 + 1e-6
# Approximate methods' figures are the same to the bit on one machine; compilers and drivers round otherwise.
FIGURES = {"error": 1.0, "worst": 1.0, "wrong": 1.0, "shift": 1.5, "turn": 1.5}
FIGURES |= {"shift_excess": 1.5, "turn_excess": 1.5}
ROW = ["scene", "method", "width", "height", "outcome", "verdict", "error", "worst_error"]
ROW += ["worst_frames", "repetition_difference", "order_difference", "redrawn_error"]
ROW += ["shift", "turn", "others", "messages"]

FAILURES = pathlib.Path(__file__).parents[2] / "docs" / "bench" / "failures.md"


def documented_worst_cases():
    """The error in steps of 1/255 by method, of the table in docs/bench/failures.md."""
    section = FAILURES.read_text(encoding="utf-8").split("## Worst cases")[1].split("\n## ")[0]
    worst = {}
    for names, error in re.findall(r"^\| (`.*?) \| ([0-9.]+) \|", section, re.MULTILINE):
        worst.update({name: float(error) for name in re.findall(r"`(\S+?)`", names)})
    return worst


class KnownFailures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.told = stability_figures.measure()
        cls.rows = {(row["scene"], row["method"]): row for row in cls.told["results"]}

    def for_each(self, methods, check):
        for (scene, method), row in self.rows.items():
            if method in methods:
                with self.subTest(scene=scene, method=method):
                    check(row)

    def test_every_cell_is_there(self):
        scenes, methods = stability_figures.SCENES, stability_figures.EXACT
        methods = methods + stability_figures.APPROXIMATE
        self.assertEqual(set(self.rows), {(s, m) for s in scenes for m in methods})
        self.assertEqual([scene["name"] for scene in self.told["scenes"]], scenes)
        self.for_each(
            methods,
            lambda row: self.assertEqual(
                list(row), ROW[:6] + ["skipped"] if "skipped" in row else ROW
            ),
        )

    def test_exact_methods_are_exact_everywhere(self):
        def check(row):
            self.assertEqual(row["verdict"], "exact")
            self.assertLessEqual(row["error"]["max"], STEP)
            self.assertLessEqual(row["worst_error"], STEP_OF_SAMPLES)
            for frames in (row["shift"], row["turn"]):
                self.assertLessEqual(frames["error"], STEP)
                self.assertLessEqual(frames["excess"], EXCESS)
            self.assertAlmostEqual(row["redrawn_error"], row["error"]["max"], delta=1e-6)
            self.assertEqual(row["repetition_difference"], 0)
            self.assertEqual(row["order_difference"], 0)
            for motion in (row["shift"], row["turn"]):
                self.assertLessEqual(motion["largest"], motion["truth_largest"] + STEP)
                self.assertLessEqual(motion["typical"], motion["truth_typical"] + STEP)
                self.assertLessEqual(
                    motion["changed_pixels"], motion["truth_changed_pixels"] + 0.01
                )
            self.assertEqual(row["messages"], [])

        self.for_each(stability_figures.EXACT, check)

    def test_exact_methods_are_exact_in_windows_of_other_sizes_and_samples(self):
        def check(row):
            names = [other["name"] for other in row["others"]]
            self.assertEqual(names, ["half", "double", "third", "4-samples"])
            for other in row["others"]:
                if "skipped" in other:
                    self.assertEqual(
                        (row["method"], other["name"]), ("stencil-routed", "4-samples")
                    )
                else:
                    bound = STEP_OF_SAMPLES if other["multisamples"] else STEP
                    self.assertLessEqual(other["error"]["max"], bound, other)

        self.for_each(stability_figures.EXACT, check)

    def test_truth_changes_wherever_there_are_edges(self):
        """A method that flickers could not be seen where nothing changes."""
        invisible = {"empty", "stack-17-alpha-0"}
        without_edges = {scene for scene, _ in self.rows if scene.startswith("stack-")}
        still = {"shift": invisible | without_edges, "turn": invisible}

        def check(row):
            for motion, scenes in still.items():
                changes = row[motion]["truth_largest"] > 0.0
                self.assertEqual(changes, row["scene"] not in scenes, motion)

        self.for_each(["linked-list"], check)

    def test_what_fails_fails_in_the_known_way(self):
        expected = stability_figures.read()
        self.assertEqual(set(expected), set(self.rows))

        def check(row):
            known = expected[row["scene"], row["method"]]
            now = stability_figures.figures(row)
            self.assertEqual(now["outcome"], known["outcome"], now)
            if "skipped" in row:
                return
            for figure, tolerance in FIGURES.items():
                self.assertAlmostEqual(
                    float(now[figure]), float(known[figure]), delta=tolerance, msg=figure
                )
            for figure in ("repeated", "shuffled"):
                self.assertEqual(now[figure] == "0", known[figure] == "0", (figure, now))

        self.for_each(stability_figures.EXACT + stability_figures.APPROXIMATE, check)

    def test_the_documented_worst_cases_are_the_worst(self):
        told = documented_worst_cases()
        self.assertEqual(set(stability_figures.APPROXIMATE) - set(told), set())

        def check(row):
            if "skipped" not in row:
                self.assertLessEqual(255 * row["worst_error"], told[row["method"]] + 1.0)

        self.for_each(stability_figures.APPROXIMATE, check)


class Tolerance(unittest.TestCase):
    """Mating faces flicker, truth's too, until a tolerance has them coincide."""

    def measure(self, *arguments):
        result = run(
            *("stability", "--quick", "--scenes", "mating,mating-everywhere"),
            *("--methods", "linked-list,prefix-sum", "--json", "-", *arguments),
        )
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        return {(row["scene"], row["method"]): row for row in json.loads(result.stdout)["results"]}

    def test_mating_faces_stop_flickering(self):
        without, within = self.measure(), self.measure("--coincidence", "16,0.01")
        for cell, row in within.items():
            with self.subTest(cell=cell):
                self.assertEqual((row["outcome"], without[cell]["outcome"]), ("exact", "exact"))
                before, after = without[cell]["shift"], row["shift"]
                self.assertGreater(before["changed_pixels"], 0.01)
                self.assertLess(after["changed_pixels"], 0.1 * before["changed_pixels"])
                if (
                    cell[0] == "mating-everywhere"
                ):  # no outlines, which flicker with a tolerance too
                    for largest in ("largest", "truth_largest"):
                        self.assertGreaterEqual(before[largest], 10 / 255)
                        self.assertLessEqual(after[largest], STEP)
                    self.assertEqual(after["changed_pixels"], 0.0)
                    self.assertEqual(after["truth_changed_pixels"], 0.0)

    def test_methods_without_one_are_not_judged_by_it(self):
        result = run(
            *("stability", "--quick", "--scenes", "mating", "--coincidence", "16,0.01"),
            *("--methods", "linked-list,stencil-routed,stencil-mask-4,blend", "--json", "-"),
        )
        lists, *others = json.loads(result.stdout)["results"]
        self.assertEqual(lists["outcome"], "exact")
        for row in others:
            self.assertEqual(row["outcome"], "refused", row["method"])
            self.assertIn("no tolerance", row["skipped"])


class Given(FileTest):
    """What is given is drawn in place of the suite."""

    def stability(self, *arguments):
        return run("stability", "--quick", "--methods", "linked-list", *arguments)

    def test_files_and_generated_scenes_are_drawn(self):
        path = self.folder / "boxes.glb"
        path.write_bytes(glb())
        result = self.stability(path, "demo:crossing", "--size", "24x16", "--json", "-")
        self.assert_done(result)
        told = json.loads(result.stdout)
        self.assertEqual([scene["input"] for scene in told["scenes"]], [str(path), "demo:crossing"])
        self.assertEqual([row["scene"] for row in told["results"]], [str(path), "demo:crossing"])
        for row in told["results"]:
            self.assertEqual((row["width"], row["height"]), (24, 16))
            self.assertEqual(row["outcome"], "exact")
            self.assertGreater(row["turn"]["truth_largest"], 0.0)

    def test_opacity_is_multiplied_in(self):
        def changes(opacity):
            result = self.stability(
                *("demo:crossing", "--opacity", opacity, "--size", "24x24", "--json", "-")
            )
            self.assert_done(result)
            told = json.loads(result.stdout)
            self.assertEqual(told["scenes"][0]["opacity"], opacity)
            return told["results"][0]["turn"]["truth_largest"]

        self.assertLess(changes(0.1), 0.5 * changes(1.0))

    def test_opaque_files_are_told(self):
        path = self.folder / "plate.stl"
        path.write_bytes(binary_stl())
        advice = f"{path}: Nothing in it is translucent; --opacity 0.3 makes it so.\n"
        result = self.stability(path, "demo:crossing", "demo:empty", "--size", "8x8")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr.decode(), "vitrine: note: " + advice)
        self.assert_done(self.stability(path, "--opacity", "0.3", "--size", "8x8"))

    def test_what_is_not_drawn_is_told_once(self):
        path = self.folder / "boxes.obj"
        path.write_bytes(obj())
        result = self.stability(path, "--size", "8x8")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr.count(b"'left'"), 1, result.stderr)

    def test_what_cannot_be_drawn_is_refused_before_anything_is_measured(self):
        bad = self.folder / "bad.stl"
        bad.write_bytes(b"solid nothing")
        report = self.folder / "told.json"
        for arguments, words in (
            (["demo:crossing", bad], [bad]),
            (["demo:crossing", self.folder / "none.glb"], ["none.glb"]),
            (["demo:nowhere"], ["nowhere", "crossing"]),
            (["demo:crossing", "demo:empty", "demo:crossing"], ["demo:crossing", "twice"]),
            (["demo:crossing", "--scenes", "empty"], ["--scenes", "INPUT"]),
            (["--opacity", "0.5"], ["--opacity", "INPUT"]),
            (["demo:crossing", "--opacity", "2"], ["--opacity"]),
            (["demo:crossing", "--size", "8"], ["--size"]),
        ):
            with self.subTest(arguments=arguments):
                self.assert_refused(self.stability(*arguments, "--json", report), *words)
                self.assertFalse(report.exists())


class Stability(FileTest):
    def test_what_is_not_there_is_refused(self):
        self.assert_refused(run("stability", "--scenes", "nowhere"), "nowhere", "--help")
        self.assert_refused(run("stability", "--methods", "nohow"), "nohow", "linked-list")
        for twice in ("empty,empty", "crossing,empty,crossing"):
            self.assert_refused(run("stability", "--scenes", twice), twice[-5:], "twice")
        self.assert_refused(run("stability", "--json", self.folder), self.folder)

    def test_table_tells_verdicts_and_the_worst_scene(self):
        path = self.folder / "told.json"
        result = run(
            *("stability", "--quick", "--scenes", "empty,crossing", "--json", path),
            *("--methods", "blend,linked-list,blend"),  # groups overlap; each method is drawn once
        )
        self.assert_done(result)
        for word in (b"Expected: ", b"exact", b"wrong by", b"Worst scene of each method"):
            self.assertIn(word, result.stdout)
        told = json.loads(path.read_text())
        self.assertEqual([row["method"] for row in told["results"]], ["blend", "linked-list"] * 2)
        self.assertEqual(list(told), ["vitrine", "build", "device", "settings", "scenes", "results"])
        self.assertTrue(all(told["device"].values()), told["device"])

    def test_a_run_that_is_stopped_leaves_the_scenes_that_it_finished(self):
        path, tables = self.folder / "told.json", self.folder / "tables.txt"
        path.write_text("{}")
        # the second scene takes far longer than the first
        arguments = ["--quick", "--scenes", "empty,window-4k", "--methods", "blend,linked-list"]
        with tables.open("wb") as stdout:
            process = subprocess.Popen(
                [PROGRAM, "stability", *arguments, "--json", str(path)],
                stdout=stdout,
                stderr=subprocess.PIPE,
                env=environment_without_display(),
            )
        stop_when(process, lambda: path.read_text() != "{}", signal.SIGTERM)
        told = json.loads(path.read_text())
        self.assertEqual([scene["name"] for scene in told["scenes"]][0], "empty")
        self.assertEqual(len(told["scenes"]), 2)
        rows = [(row["scene"], row["method"]) for row in told["results"]]
        self.assertEqual(rows, [("empty", "blend"), ("empty", "linked-list")])
        text = tables.read_text()
        self.assertTrue(text.startswith(told["device"]["renderer"]), text)
        self.assertIn("\nempty, demo:empty\n", text)
        self.assertEqual(sum(line.startswith("linked-list") for line in text.split("\n")), 1)
        self.assertNotIn("Worst", text)
        self.assertEqual(sorted(self.folder.iterdir()), [tables, path])

    def test_a_pipe_is_written_to_once(self):
        arguments = ("--scenes", "empty,crossing", "--methods", "blend", "--size", "8x8")
        result = run("stability", "--quick", *arguments, "--json", "/dev/stdout")
        self.assert_done(result)
        self.assertEqual(result.stdout.count(b'"vitrine"'), 1)

    def test_where_truth_cannot_run_rows_say_why(self):
        result = run(
            *("stability", "--quick", "--scenes", "crossing", "--methods", "linked-list,blend"),
            *("--json", "-"),
            MESA_GL_VERSION_OVERRIDE="3.2",
        )
        told = json.loads(result.stdout)
        if "3.2" not in told["device"]["gl"]:
            self.skipTest("the driver is not Mesa's")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr, b"")
        self.assertEqual([row["outcome"] for row in told["results"]], ["refused"] * 2)
        for row in told["results"]:
            self.assertIn("OpenGL", row["skipped"])


if __name__ == "__main__":
    unittest.main()
