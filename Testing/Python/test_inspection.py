"""Inspection: the state of an inspector, its changes and their undoing, its answers and its pictures; no page."""

import contextlib
import io
import json
import pathlib
import subprocess
import sys
import unittest
import unittest.mock

import numpy
from machine import PATHS, SIZE, Files, write_machine
from scenes import run_interpreter

import vitrine
from vitrine.inspector import Inspection, _output, _render, _state

LID, WINDOW, GEAR, GEAR_2, BOLT = PATHS
FRONT = {"position": [0, 0, 10], "focal_point": [0, 0, 0], "view_up": [0, 1, 0], "parallel": True, "parallel_scale": 4}

# Each gesture that is a step of undo().
CHANGES = {
    "hide": lambda shown: shown.hide("Housing"),
    "show": lambda shown: shown.show(LID),
    "isolate": lambda shown: shown.isolate("gear*", opacity=0.25),
    "ghost": lambda shown: shown.ghost(GEAR),
    "opacity": lambda shown: shown.look("/Machine/Gearbox", opacity=0.5),
    "color": lambda shown: shown.look(GEAR, color="#ff8000"),
    "reset": lambda shown: shown.reset(GEAR),
    "select": lambda shown: shown.select([LID, GEAR]),
    "highlight": lambda shown: shown.highlight("bolt"),
    "explode": lambda shown: shown.explode(0.2),
    "section": lambda shown: shown.add_section("z", (0, 0, 0)),
    "move": lambda shown: shown.move_section(0, origin=(0, 0, 0.25)),
    "caps": lambda shown: shown.set_caps(hatch="lines", edges=2),
    "box": lambda shown: shown.set_box((-3, 3, -3, 3, -0.4, 0.4)),
    "unbox": lambda shown: shown.set_box(None),
    "uncut": lambda shown: shown.remove_section(0),
    "x_ray": lambda shown: shown.x_ray(LID),
    "un-x_ray": lambda shown: shown.x_ray(None),
    "reveal": lambda shown: shown.reveal(GEAR_2, 0.5),
    "view of a reveal": lambda shown: shown.set_camera({**FRONT, "position": [8, 4, 40]}),
    "unreveal": lambda shown: shown.reveal(None),
    "view": lambda shown: shown.view("iso"),
    "perspective": lambda shown: shown.parallel(False),
    "fit": lambda shown: shown.fit(GEAR),
    "lights": lambda shown: shown.set_lights("studio"),
    "background": lambda shown: shown.set_background("#203040"),
    "method": lambda shown: shown.set_method("linked-list", (16, 0.01), cull=False),
    "error": lambda shown: shown.set_error(2 / 255),
    "levels": lambda shown: shown.set_levels(1.0),
}


class Machine(Files):
    """An inspection of the small machine, seen from its front. A unit of length has 10 pixels."""

    def setUp(self):
        super().setUp()
        write_machine(self.file)
        self.shown = self.opened()

    def opened(self):
        shown = Inspection(self.file, size=SIZE)
        self.addCleanup(shown.close)
        shown.set_camera(FRONT)
        shown.forget_changes()
        return shown

    def same(self, picture, other):
        numpy.testing.assert_array_equal(picture, other)


class Changes(Machine):
    def test_are_undone_and_made_again(self):
        pictures, states = [self.shown.picture()], [self.shown.state()]
        for change in CHANGES.values():
            change(self.shown)
            pictures.append(self.shown.picture())
            states.append(self.shown.state())
        for number in reversed(range(len(CHANGES))):
            with self.subTest(undone=list(CHANGES)[number]):
                self.assertTrue(self.shown.undo())
                self.assertEqual(self.shown.state(), states[number])
                self.same(self.shown.picture(), pictures[number])
        self.assertFalse(self.shown.undo())
        for number in range(len(CHANGES)):
            self.assertTrue(self.shown.redo())
        self.assertEqual(self.shown.state(), states[-1])
        self.same(self.shown.picture(), pictures[-1])
        self.assertFalse(self.shown.redo())

    def test_show_what_plain_calls_show(self):
        self.shown.hide(LID)
        self.shown.look(GEAR, color="#ff0000", opacity=0.5)
        self.shown.add_section("y", (0, -2, 0))
        picture = self.shown.picture()
        machine = vitrine.load(self.file)
        machine["lid"].visible = False
        machine["gear-1"].color = "#ff0000"
        machine["gear-1"].opacity = 0.5
        plain = Inspection(machine, size=SIZE)
        self.addCleanup(plain.close)
        plain.set_camera(FRONT)
        vitrine.section(plain.renderer, "y", (0, -2, 0))
        self.same(plain.picture(), picture)

    def test_of_one_slider_are_one_step(self):
        for factor in (0.1, 0.2, 0.3):
            self.shown.explode(factor)
        self.shown.undo()
        self.assertEqual(self.shown.state()["explode"], 0.0)

    def test_that_fail_leave_all_as_it_was(self):
        self.shown.add_section("x", (1, 0, 0))
        state, picture = self.shown.state(), self.shown.picture()
        for wrong, error in (
            (lambda: self.shown.hide("nowhere*"), KeyError),
            (lambda: self.shown.look(GEAR, opacity=2.0), ValueError),
            (lambda: self.shown.look(GEAR, color="red; x"), ValueError),
            (lambda: self.shown.add_section("w"), ValueError),
            (lambda: self.shown.add_section((0, 0, 0)), ValueError),
            (lambda: self.shown.move_section(1, "x"), ValueError),
            (lambda: self.shown.set_box((1, 0, 1, 0, 1, 0)), ValueError),
            (lambda: self.shown.set_caps(hatch="stars"), ValueError),
            (lambda: self.shown.explode(float("nan")), ValueError),
            (lambda: self.shown.reveal("gear*"), ValueError),
            (lambda: self.shown.set_method("nonsense"), ValueError),
            (lambda: self.shown.set_lights("moon"), ValueError),
            (lambda: self.shown.view("inside"), ValueError),
            (lambda: self.shown.go_to("nowhere"), KeyError),
            (lambda: self.shown.set_size(0, 10), ValueError),
            (lambda: self.shown.hide(7), TypeError),
        ):
            with self.assertRaises(error):
                wrong()
            self.assertEqual(self.shown.state(), state)
        self.shown.forget_frame()
        self.same(self.shown.picture(), picture)

    def test_of_the_selection_add_and_take_away(self):
        self.shown.select(LID)
        self.shown.select([GEAR, LID], add=True)
        self.assertEqual(self.shown.state()["selected"], [GEAR])
        self.shown.select(None)
        self.assertEqual(self.shown.state()["selected"], [])


    def test_begin_with_something_to_show(self):
        self.file.with_name("empty.gltf").write_text('{"asset": {"version": "2.0"}}')
        with self.assertRaisesRegex(ValueError, "empty.gltf: has no parts that can be shown"):
            Inspection(self.file.with_name("empty.gltf"))

    def test_that_isolate_leave_what_is_hidden(self):
        self.shown.hide(LID)
        self.shown.isolate(GEAR, opacity=0.25)
        looks = self.shown.state()["parts"]
        self.assertEqual((looks[LID]["visible"], looks[BOLT], GEAR in looks), (False, {"opacity": 0.25}, False))

    def test_are_refused_after_close(self):
        self.shown.close()
        self.shown.close()
        for call in (lambda: self.shown.hide(LID), self.shown.picture, self.shown.fit, lambda: self.shown.layers(0, 0)):
            with self.assertRaisesRegex(RuntimeError, "this Inspection is closed: make another one"):
                call()


class States(Machine):
    def make_view(self):
        self.shown.ghost("Housing")
        self.shown.look(GEAR, color="#ff8000")
        self.shown.hide(BOLT)
        self.shown.add_section("z", (0, 0, 0.25))
        self.shown.set_caps(hatch="cross")
        self.shown.explode(0.1)
        self.shown.set_lights("above")
        self.shown.view("iso")
        self.shown.save_view("mine")
        self.shown.select(GEAR_2)

    def test_draw_the_same_picture_without_a_page_and_as_a_script(self):
        self.make_view()
        picture = self.shown.picture()
        file, output = self.folder / "state.json", self.folder / "out.png"
        self.shown.save(file)
        self.assertEqual(json.loads(file.read_text())["files"], [{"path": self.file.name}])
        said = run_interpreter("-m", "vitrine", "render", str(file), "-o", str(output))
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        self.same(read_png(output), picture)
        script = self.folder / "script.py"
        script.write_text(self.shown.script())
        subprocess.run([sys.executable, "-B", script], check=True, cwd=self.folder)
        self.same(read_png(self.folder / "picture.png"), picture)

    def test_have_an_error_budget_that_pictures_keep(self):
        self.make_view()
        for steps in (0.6, 2):
            self.shown.set_error(steps / 255)
            self.assertLessEqual(self.shown.error()["max"], (steps + 0.5) / 255)  # truth is rounded, too
            told = self.shown.figures()
            self.assertEqual((told["method"], told["error_budget"]), ("automatic", steps / 255))
        self.assertIn("'automatic', error=2.0 / 255", self.shown.script())
        self.shown.set_method("linked-list")
        self.assertIsNone(self.shown.state()["error"])
        self.shown.apply({"vitrine": 1, "error": 0.01})
        self.assertEqual(self.shown.state()["method"], "automatic")
        self.shown.set_error(None)
        self.assertEqual(self.shown.state()["method"], _state.DEFAULTS["method"])

    def test_have_levels_of_moving_pictures_alone(self):
        picture = self.shown.picture()
        self.shown.set_levels(64)
        self.shown.shown._handles["levels"][0].wait()
        with self.shown.shown.moving():
            self.shown.window.Render()
        self.shown.forget_frame()
        self.assertTrue(self.shown.shown._handles["levels"][0].stats().drew_levels)
        self.assertIsNone(vitrine.vtkPartLevels.GetAttached(self.shown.renderer))
        self.same(self.shown.picture(), picture)
        self.assertTrue(self.shown.script().endswith("vitrine.levels(renderer, pixels=64)  # while the camera moves\n"))
        self.shown.undo()
        self.assertIsNone(self.shown.state()["levels"])

    def test_are_taken_by_another_inspection(self):
        self.make_view()
        other = self.opened()
        other.apply(self.shown.state())
        self.same(other.picture(), self.shown.picture())
        other.undo()
        self.shown.apply({"vitrine": 1, "camera": FRONT, "size": list(SIZE)})
        self.same(other.picture(), self.shown.picture())

    def test_have_hatches_that_do_not_depend_on_what_was_cut_before(self):
        self.shown.set_caps(hatch="lines")
        for path in reversed(PATHS):
            bounds = self.shown.parts.bounds([path])
            self.shown.set_box([0.8 * value + 0.2 * bounds[i ^ 1] for i, value in enumerate(bounds)])
            self.shown.draw()
        self.shown.set_box(None)
        self.shown.add_section("z")
        other = self.opened()
        other.apply(self.shown.state())
        self.same(other.picture(), self.shown.picture())

    def test_that_are_malformed_are_refused_and_change_nothing(self):
        self.make_view()
        state, picture = self.shown.state(), self.shown.picture()
        wrong = malformed_states()
        self.assertGreaterEqual(len(wrong), 50)
        for given in wrong:
            with self.subTest(given=str(given)[:80]):
                with self.assertRaises(ValueError) as raised:
                    self.shown.apply(given)
                self.assertNotIn("\n", str(raised.exception))
                self.assertEqual(self.shown.state(), state)
        self.shown.forget_frame()
        self.same(self.shown.picture(), picture)

    def test_whose_last_thing_is_wrong_leave_none_of_the_others(self):
        self.make_view()
        picture = self.shown.picture()
        box = {"bounds": [1, 0] * 3, "inside": True}
        parts = {LID: {"color": "#00ff00"}, GEAR_2: {"visible": False}}
        with self.assertRaises(ValueError):
            self.shown.apply({**self.shown.state(), "parts": parts, "explode": 0.5, "box": box})
        self.shown.forget_frame()
        self.same(self.shown.picture(), picture)

    def test_that_are_no_json_are_refused_by_one_line_and_status_2(self):
        file, output = self.folder / "state.json", self.folder / "out.png"
        for text in (
            b"", b"{", b"\xff\xfe", b"[1]", b'{"vitrine": NaN}', b'{"vitrine": 1, "vitrine": 1}', b"[" * 100000,
            b'{"vitrine": 1}', b'{"vitrine": 1, "files": [{"path": "../gone.glb"}]}',
            b'{"vitrine": 1, "files": [{"path": "state.json"}]}',
        ):  # fmt: skip
            file.write_bytes(text)
            with self.subTest(text=text[:40]), contextlib.redirect_stderr(io.StringIO()) as said:
                self.assertEqual(_render.main([str(file), "-o", str(output)]), 2)
                self.assertRegex(said.getvalue(), r"\Avitrine render: [^\n]+\n\Z")
                self.assertEqual(sorted(path.name for path in self.folder.glob("*out*")), [])

    def test_are_written_whole_or_not_at_all(self):
        with self.assertRaisesRegex(OSError, r"No such file or directory: '[^']*/nowhere/state\.json'"):
            self.shown.save(self.folder / "nowhere" / "state.json")
        with self.assertRaises(ValueError):
            self.shown.screenshot(self.folder / "picture.gif")
        self.assertEqual({path.name for path in self.folder.iterdir()}, {self.file.name})


def malformed_states():
    """States that are wrong in one thing each."""
    camera = {"position": [0, 0, 1], "focal_point": [0, 0, 0], "view_up": [0, 1, 0]}
    keys = {
        "vitrine": [0, 2, "1", None],
        "files": [7, {}, [7], [{}], [{"path": ""}], [{"path": "a", "tolerance": -1}], [{"path": "a", "more": 1}]],
        "size": [7, [], [100], [0, 100], [1, 1, 1], [1.5, 2], [1e9, 1], ["1", "1"]],
        "parts": [[], {LID: 7}, {LID: {"opacity": 1.5}}, {LID: {"opacity": "0.5"}}, {LID: {"color": "red"}},
                  {LID: {"color": "#12345"}}, {LID: {"visible": 1}}, {LID: {"size": 1}}, {"/nowhere": {}}],
        "selected": ["x", [7], ["/nowhere"], [""]],
        "highlight": [None, [[LID]]],
        "explode": [-1, 1e400, 1001, "1", None],
        "sections": [{}, [{}], [{"normal": [1, 0, 0]}], [{"normal": [1, 0], "origin": [0, 0, 0]}],
                     [{"normal": [0, 0, 0], "origin": [0, 0, 0]}], [{"normal": [1, 0, 0], "origin": [1e40, 0, 0]}],
                     [{"normal": [1, 0, 0], "origin": [0, 0, 0]}] * 7],
        "box": [{}, [0, 1, 0, 1, 0, 1], {"bounds": [0, 1], "inside": True}, {"bounds": [1, 0] * 3, "inside": True}],
        "caps": [[], {"hatch": "stars"}, {"edges": 9}, {"show": "yes"}],
        "reveal": [LID, {"part": "/nowhere"}, {"part": LID, "share": 0}],
        "x_ray": [[], {"parts": [LID], "floor": 2}, {"parts": ["/nowhere"]}],
        "camera": [{}, {**camera, "view_up": [0, 0, 1]}, {**camera, "position": [0, 0, 0]}, {**camera, "more": 1},
                   {**camera, "view_angle": 0}, {**camera, "parallel_scale": -1}],
        "views": [[], {"": camera}, {"a": {}}, {"__proto__": camera}, {"\ud800": camera}],
        "lights": ["moon", 1],
        "background": ["white", "#fff"],
        "method": ["", "nonsense", 1],
        "coincidence": [1, [1], [-1, 0], [1, 2, 3]],
        "error": [0, -1, 0.5 / 255, 1.5, "2/255", True],
        "cull": [0, "no"],
        "levels": [0, -1, 65, True, "fine"],
        "unknown": [1],
    }  # fmt: skip
    wrong = [{"vitrine": 1, key: value} for key, values in keys.items() for value in values]
    return [None, [], "state", {}, {"vitrine": 1, "method": "truth", "error": 0.1}, *wrong]


class Answers(Machine):
    def test_tell_layers_and_parts_under_the_cursor(self):
        layers = self.shown.layers(60, 60)
        self.assertEqual([layer["path"] for layer in layers], [WINDOW, WINDOW])
        self.assertAlmostEqual(layers[0]["share"], 0.25, places=3)
        self.assertAlmostEqual(layers[0]["position"][2], 0.5, places=5)
        self.assertEqual(self.shown.pick(20, 60), LID)
        self.assertEqual(self.shown.pick(60, 60), WINDOW)
        self.assertIsNone(self.shown.pick(40, 75))
        with self.assertRaises(ValueError):
            self.shown.layers(80, 0)

    def test_go_deeper_and_round(self):
        self.shown.set_camera({**FRONT, "position": [10, 0, 0]})  # the window is before the lid
        self.assertEqual([self.shown.pick(40, 60, deeper) for deeper in range(3)], [LID, WINDOW, LID])
        self.shown.look(WINDOW, opacity=1.0)
        self.assertEqual([self.shown.pick(40, 60, deeper) for deeper in range(3)], [WINDOW, LID, WINDOW])
        with self.assertRaises(ValueError):
            self.shown.pick(1, 1, -1)

    def test_measure_what_is_known(self):
        self.assertAlmostEqual(self.shown.measure("distance", a=(0, 0, 0), b=(3, 4, 0))["distance"], 5.0)
        self.assertAlmostEqual(self.shown.measure("thickness", x=20, y=60)["thickness"], 1.0, places=4)
        self.assertAlmostEqual(self.shown.measure("clearance", a=GEAR, b=GEAR_2)["distance"], 3.0, places=5)
        self.shown.explode(1.0)
        self.assertGreater(self.shown.measure("clearance", a=GEAR, b=GEAR_2)["distance"], 3.5)
        for wrong in (
            {"kind": "weight"},
            {"kind": "distance", "a": (0, 0), "b": (1, 1)},
            {"kind": "distance", "a": (0, 0, 0), "b": (float("inf"), 0, 0)},
            {"kind": "distance"},
            {"kind": "thickness", "x": 40, "y": 75},
            {"kind": "clearance", "a": GEAR, "b": GEAR},
            {"kind": "clearance", "a": "gear*", "b": LID},
        ):
            with self.assertRaises(ValueError):
                self.shown.measure(**wrong)

    def test_tell_clashes_by_paths(self):
        self.assertEqual(self.shown.clashes(), [])
        near = self.shown.clashes(1.25)
        self.assertIn({GEAR_2, BOLT}, [set(clash["parts"]) for clash in near])

    def test_tell_cut_parts(self):
        self.shown.add_section("x", (2, 0, 0))
        self.shown.draw()
        self.assertEqual(set(self.shown.cut_parts()), {WINDOW, GEAR_2, BOLT})

    def test_tell_errors_and_chart_all_methods(self):
        self.shown.look(GEAR, opacity=0.7, color="#ff0000")
        self.shown.look(GEAR_2, opacity=0.6, color="#0000ff")
        self.shown.set_camera({**FRONT, "position": [10, 0, 1]})
        picture = self.shown.picture()
        self.assertLessEqual(self.shown.error()["max"], 1 / 255)
        rows = {row["method"]: row for row in self.shown.chart(frames=1)}
        self.assertLessEqual({"truth", "automatic", "linked-list", "vtk-oit", "vtk-peeling"}, set(rows))
        for method in ("automatic", "linked-list"):
            self.assertLessEqual(rows[method]["error"]["max"], 1 / 255)
        self.assertGreater(rows["vtk-oit"]["error"]["max"], 1 / 255)
        self.same(self.shown.picture(), picture)
        self.assertEqual(self.shown.figures()["method"], "prefix-sum-predicted")

    def test_count_layers_as_heat(self):
        self.shown.ghost("/Machine")
        heat = self.shown.heat_map()
        self.assertEqual(heat.shape, (*reversed(SIZE), 3))
        self.same(heat[5, 40], (0, 0, 0))  # nothing
        self.same(heat[20, 20], (255, 255, 255))  # the most: two layers


class Pictures(Machine):
    def test_without_a_background_compose_to_those_with_one(self):
        self.shown.ghost("Housing", 0.5)
        self.shown.set_background("#204080")
        opaque = self.shown.picture().astype(float)
        clear = self.shown.picture(transparent=True).astype(float)
        alpha = clear[..., 3:] / 255
        composed = clear[..., :3] * alpha + numpy.array([0x20, 0x40, 0x80]) * (1 - alpha)
        self.assertLessEqual(numpy.abs(composed - opaque).max(), 2.0)
        self.assertEqual(clear[5, 40, 3], 0)
        self.assertEqual(clear[60, 20, 3], 255)
        self.same(self.shown.picture(), opaque)

    def test_have_any_size_in_tiles(self):
        self.shown.set_camera({"parallel_scale": 4.0})
        large = self.shown.picture((5000, 5000))
        self.assertEqual(large.shape, (5000, 5000, 3))
        lid = numpy.argwhere((large != large[0, 0]).any(axis=2))
        self.assertEqual(tuple(lid.min(axis=0) // 10 * 10), (930, 620))  # y 2.5 and x -3 of -4 to 4
        for wrong in ((0, 1), (1,), (1.5, 2), (70000, 1), "ab", (True, 5)):
            with self.assertRaises(ValueError):
                self.shown.picture(wrong)

    def test_in_tiles_are_those_of_one(self):
        self.shown.select(GEAR)
        for parallel, size, tile in ((True, (120, 90), 43), (False, (120, 90), 50), (False, (200, 7), 40)):
            self.shown.set_camera({"parallel": parallel, "position": [0, 0, 20]})
            whole = self.shown.picture(size).astype(int)
            with unittest.mock.patch.object(_output, "_TILE", tile):
                self.assertLessEqual(abs(self.shown.picture(size) - whole).max(), 1)

    def test_of_an_assembly_begin_and_end_with_its_looks(self):
        machine = vitrine.load(self.file)
        machine["lid"].visible = False
        machine["gear-1"].color = (1.0, 0.5, 0.0)
        shown = Inspection(machine, size=SIZE)
        self.assertEqual(shown.state()["parts"], {LID: {"visible": False}, GEAR: {"color": "#ff8000"}})
        shown.set_camera(FRONT)
        before = shown.picture()
        shown.show(LID)
        shown.add_section("x")
        shown.undo()
        shown.undo()
        self.same(shown.picture(), before)
        shown.reset()
        renderer = shown.renderer
        shown.close()
        self.assertIsNone(renderer.GetPass())
        self.assertEqual(machine["lid"].visible, False)

    def test_of_a_turn_leave_state_and_camera(self):
        self.shown.ghost(LID)
        state = self.shown.state()
        self.shown.picture()
        with contextlib.suppress(ImportError):  # of what writes videos
            steps = _output.turntable(self.shown, self.folder / "turn.gif", 3, (16, 16))
            next(steps)
            self.assertEqual(self.shown.state(), state)
            self.assertEqual(self.shown.renderer.GetActiveCamera().GetPosition(), (0, 0, 10))
            steps.close()
        self.assertEqual(list(self.folder.glob("*.gif")), [])

    def test_fit_parts_where_they_are(self):
        self.shown.explode(3.0)
        self.shown.fit(GEAR)
        self.assertEqual(self.shown.pick(40, 40), GEAR)


def read_png(file):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]


if __name__ == "__main__":
    unittest.main()
