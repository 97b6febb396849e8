"""scripts/test-drivers: what it reads from compilers and front ends, what it takes for a failure, and its table."""

import json
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "Testing/Drivers"))

import compilers  # noqa: E402
import glsl  # noqa: E402
import table  # noqa: E402
from drivers import DEVICES, DRIVERS, Driver  # noqa: E402
from frames import Frames, Run, Scene  # noqa: E402
from places import Outcome, Place  # noqa: E402
from programs import Program  # noqa: E402
from table import Cell, Compiled  # noqa: E402

OUTPUT = """\
Mesa Intel(R) Xe Graphics (TGL GT2), OpenGL 4.6 (Core Profile) Mesa 22.3.6
3 ok 0.300 s 0.250 s: 3.vert 3.frag
  VS SIMD8 shader: 14 inst, 0 loops, 52 cycles, 7:9 spills:fills, 1 sends
  FS SIMD8 shader: 92 inst, 0 loops, 2438 cycles, 2:5 spills:fills, 7 sends
  FS SIMD16 shader: 98 inst, 0 loops, 3394 cycles, 0:0 spills:fills, 7 sends
4 failed 0.001 s 0.001 s: 4.vert 4.frag
  0:1(2): error: no such thing
5 ok 0.001 s 0.001 s: 5.comp
  type: 5, local: 32, shared: 0, gpr: 255, inst: 12, bytes: 112, cached: 0
6 cut-off 31.000 s 30.000 s:
"""
PROGRAMS = [Program(f"program {number}", (), False) for number in range(8)]
ROWS = ("llvmpipe", "old", "older", "broken", "Xe")
KNOWN = """\
[[failure]]
driver = "Intel *"
subject = "Resolve*, 64"
verdict = "slow"
reason = "its registers do not suffice"

[[failure]]
driver = "zink"
subject = "stencil-routed"
reason = "its thread spins"
sometimes = true
"""


class Compilers(unittest.TestCase):
    def test_results_are_read(self):
        results = compilers.read_results(OUTPUT, "device", PROGRAMS)
        self.assertEqual([result.program for result in results], [f"program {number}" for number in range(3, 7)])
        self.assertEqual([result.verdict for result in results], ["spills", "fails", "spills", "slow"])
        self.assertEqual((results[0].seconds, results[0].spills, results[0].registers), (0.25, 2, "SIMD8/16"))
        self.assertIn("no such thing", results[1].error)
        self.assertEqual((results[2].spills, results[2].registers), (32, "255 registers"))
        self.assertEqual(results[3].time, "> 30")

    def test_two_seconds_are_the_limit(self):
        self.assertEqual(Compiled("device", "program", 2.0, 0).verdict, "ok")
        self.assertEqual(Compiled("device", "program", 2.001, 0).verdict, "slow")

    def test_statistics_may_be_missing(self):
        self.assertEqual(compilers.statistics_of("nothing that anybody knows"), (None, ""))


class FakePlace(Place):
    """Answers `vitrine compare` from a table of what each method does there: a result, or None for a hang."""

    def __init__(self, methods):
        super().__init__()
        self.methods = methods

    def run(self, command, changes, limit):
        chosen = [self.methods[name] for name in command[-1].split(",")]
        if None in chosen:
            return Outcome(None, "", "")
        return Outcome(0, json.dumps({"results": chosen}), "")


def result(method, error=0.5, deterministic=True):
    """What `vitrine compare` tells of a method; the error is in 1/255."""
    return {"method": method, "error": {"max": error / 255}, "deterministic": deterministic}


class FramesOfADriver(unittest.TestCase):
    def verdicts(self, methods, frames=None, null=""):
        scene = Scene("demo:stack", methods=tuple(methods))
        run = Run(frames or Frames("vitrine", True, {}), Driver("a", null=null), FakePlace(methods), {})
        run.compare(scene)
        return {cell.subject: cell.verdict for cell in run.cells()}

    def test_exact_refused_and_wrong(self):
        methods = {
            "linked-list": result("linked-list"),
            "linked-list-compact": result("linked-list-compact", 1.01),
            "prefix-sum": result("prefix-sum", deterministic=False),
            "stencil-routed": {"method": "stencil-routed", "skipped": "no stencil"},
        }
        self.assertEqual(
            self.verdicts(methods),
            {"linked-list": "exact", "linked-list-compact": "wrong", "prefix-sum": "wrong",
             "stencil-routed": "refused"})

    def test_the_method_that_hangs_is_found(self):
        methods = {"linked-list": result("linked-list"), "prefix-sum": None}
        self.assertEqual(self.verdicts(methods), {"linked-list": "exact", "prefix-sum": "hangs"})

    def test_inexact_methods_are_held_to_the_first_driver(self):
        frames = Frames("vitrine", True, {})
        for error, verdict in ((64.0, "same"), (65.0, "same"), (65.1, "wrong")):
            methods = {"stencil-mask-8": result("stencil-mask-8", error)}
            self.assertEqual(self.verdicts(methods, frames), {"stencil-mask-8": verdict})

    def test_samples_that_routing_takes_are_told(self):
        for passes, samples in ((8, 1), (3, 3), (2, 4)):
            told = result("stencil-routed") | {"layers_max": 8, "geometry_passes": passes}
            run = Run(Frames("vitrine", True, {}), Driver("a"), FakePlace({"stencil-routed": told}), {})
            run.compare(Scene("demo:stack", methods=("stencil-routed",)))
            self.assertEqual(run.cells()[0].detail, f"0.50, K={samples}")

    def test_pictures_of_null_devices_say_nothing(self):
        methods = {"linked-list": result("linked-list", 255.0, deterministic=False)}
        self.assertEqual(self.verdicts(methods, null="intel"), {"linked-list": "ok"})


class FrontEnd(unittest.TestCase):
    def test_shaders_become_glsl_450(self):
        text = (
            "#version 150\n#extension GL_ARB_shader_storage_buffer_object : require\n"
            "#extension GL_EXT_shader_framebuffer_fetch : require\n"
            "layout(location = 1) inout uvec2 head;\n#define A \\\n  1\nvoid f(inout int i) { precise int k = A; }\n")
        self.assertEqual(
            glsl.as_450(text),
            "#version 450\n\n\nlayout(location = 1) out uvec2 head;\n#define A    1\n"
            "void f(inout int i) { int k = A; }\n")


class Verdicts(unittest.TestCase):
    def setUp(self):
        self.known = table.read_known_failures(KNOWN)

    def test_unknown_failures_are_told(self):
        slow = Cell("Intel Xe", "Resolve of linked-list, 64", "slow")
        others = [Cell("Intel Xe", "Resolve of linked-list, 64", "fails"), Cell("nouveau", "Resolve, 64", "slow")]
        fine = [Cell("a", "b", verdict) for verdict in table.GOOD]
        self.assertEqual(table.judge([slow, *others, *fine], self.known), others)
        self.assertEqual(self.known[0].met, [slow])

    def test_entries_that_no_longer_fail_are_told(self):
        table.judge([], self.known)
        self.assertEqual(table.no_longer_failing(self.known), [self.known[0]])

    def test_entries_need_a_reason(self):
        for wrong in ('reason = ""', "reason = 'x'\nreasons = 'y'", ""):
            with self.assertRaises(table.TableError):
                table.read_known_failures(f'[[failure]]\ndriver = "a"\nsubject = "b"\n{wrong}\n')

    def test_the_file_of_known_failures_is_read(self):
        known = table.read_known_failures((ROOT / "Testing/Drivers/known_failures.toml").read_text(encoding="utf-8"))
        for entry in known:
            self.assertLessEqual(len(entry.reason.split()), 25, "a cell of the table has at most 25 words")


class Page(unittest.TestCase):
    def lines(self):
        frames = [
            Cell("llvmpipe", "linked-list", "exact", "0.51"), Cell("llvmpipe", "lights", "same", "1.00"),
            Cell("old", "linked-list", "refused", "OpenGL 4.3 is needed"),
            Cell("older", "linked-list", "refused", "OpenGL 4.3 is needed"), Cell("broken", "lights", "wrong", "a|b")]
        compiled = [
            Compiled("Xe", "short", 0.5, 0, "SIMD8/16"), Compiled("Xe", "long", 30, None, is_cut_off=True),
            Compiled("Xe", "wide", 1.0, 343, "SIMD8"),
            Compiled("Xe", "ListResolve of linked-list, 16", 0.5, 0, "SIMD16"),
            Compiled("Xe", "ListResolve of prefix-sum, 16, no fetch", 0.25, 2, "SIMD8"),
            Compiled("Xe", "ListResolve of linked-list, 32", 0.75, 0, "SIMD8"),
            Compiled("Xe", "LinkedListFill of linked-list, 16", 0.1, 0, "SIMD8/16"),
            Compiled("Xe", "LinkedListFill of linked-list, 32", 0.2, 0, "SIMD8/16")]
        known = table.read_known_failures(KNOWN)
        made = {name: ["2026-11-27T12:30", "0123456789"] for name in ROWS} | {
            "Xe": ["2026-11-28T12:30", "9876543210"]}
        run = table.Run(made, frames, compiled)
        return list(table.section(table.read_run(table.text_of_run(run)), known))

    def test_frames(self):
        lines = self.lines()
        self.assertIn("| llvmpipe | exact 0.51 | same 1.00 |", lines)
        self.assertIn("| old | refused [1] | not run |", lines)
        self.assertIn("| older | refused [1] | not run |", lines)
        self.assertIn("| broken | not run | **wrong** [2] |", lines)
        self.assertIn("1. OpenGL 4.3 is needed", lines)

    def test_compilers(self):
        lines = self.lines()
        self.assertIn("| Xe | 8 | 0 | > 30 s | 1 | 2 |", lines)
        self.assertIn("| Xe | long | > 30 | unknown |  |", lines)
        self.assertIn("| Xe | wide | 1.00 | 343 | SIMD8 |", lines)

    def test_compilers_by_length(self):
        lines = self.lines()
        self.assertIn("| ListResolve, 16 | **0.50 s, SIMD8, 2 spills** |", lines)
        self.assertIn("| ListResolve, 32 | 0.75 s, SIMD8 |", lines)
        self.assertIn("| LinkedListFill | 0.20 s, SIMD8/16 |", lines)

    def test_rows_of_later_commits_are_told(self):
        lines = self.lines()
        self.assertIn("Run on 2026-11-27 at commit 0123456789.", lines)
        self.assertIn("Of commit 9876543210, 2026-11-28: Xe.", lines)

    def test_new_rows_replace_old_ones(self):
        order = ["llvmpipe", "Xe", "glslang, as they are"]
        old = table.Run(
            {"Xe": ["2026-11-27T12:30", "0"], "llvmpipe": ["2026-11-27T12:00", "0"]},
            [Cell("llvmpipe", "linked-list", "exact")], [Compiled("Xe", "a", 1.0), Compiled("Xe", "b", 1.0)])
        new = table.Run({"Xe": ["2026-11-28T12:30", "1"]}, [], [Compiled("Xe", "a", 0.5)], figures={"a: b": 1.0})
        merged = old.with_rows(new, order)
        self.assertEqual(list(merged.made), ["llvmpipe", "Xe"])
        self.assertEqual(merged.made["Xe"], ["2026-11-28T12:30", "1"])
        self.assertEqual((merged.frames, merged.compiled), (old.frames, new.compiled))
        self.assertEqual(merged.figures, {"a: b": 1.0})

    def test_it_is_put_into_the_page_and_its_commit_read(self):
        page = f"# Drivers\n\n{table.BEGIN}\nold\n{table.END}\n\nThe rest.\n"
        new = table.replaced(page, self.lines())
        self.assertTrue(new.startswith("# Drivers\n\n") and new.endswith("\n\nThe rest.\n"))
        self.assertNotIn("old\n", new.replace("| old", ""))
        self.assertEqual(table.written_of(new), ("2026-11-27", "0123456789"))
        self.assertEqual(table.written_of(page), (None, None))
        commits = table.commits_of(new, ["llvmpipe", "Xe"])
        self.assertEqual(commits, {"llvmpipe": "0123456789", "Xe": "9876543210"})
        self.assertEqual(table.commits_of(page, ["llvmpipe"]), {})
        with self.assertRaises(table.TableError):
            table.replaced("# Drivers\n", [])


class Rows(unittest.TestCase):
    def test_names_are_different(self):
        for entries in (DRIVERS, DEVICES):
            names = [entry.name for entry in entries]
            self.assertEqual(len(names), len(set(names)))

    def test_the_fast_part_has_drivers_and_a_device(self):
        self.assertTrue([driver for driver in DRIVERS if driver.fast and not driver.in_root])
        self.assertTrue([device for device in DEVICES if device.fast and not device.in_root])


if __name__ == "__main__":
    unittest.main()
