import json

import scenes
from charts import page_data, read_document
from program import FileTest, compare, read_png, run

SCENE = "demo:spheres,layers=6"
SMALL = ("--size", "48x40", "--frames", "2")
STEP = 1 / 255
PLAN = [
    "scene", "width", "height", "error_budget", "parts", "triangles", "fragments", "layers_max", "layers_mean",
    "wrong_guesses", "problem", "methods", "check",
]  # fmt: skip
CHECK = ["error_max", "bound_max", "pixels_beyond_bound", "tightness_median", "regret", "results"]
LISTS = {"prefix-sum-predicted", "prefix-sum-predicted-compact", "linked-list", "linked-list-compact"}
BAD = ("0", "-1", "nan", "inf", "10", "0.5/255", "2/0", "a", "2/", "/255", "1/2/3", "0.01,0.02")


def plan(scene, *arguments):
    """The JSON of `vitrine plan`."""
    result = run("plan", scene, *SMALL, *arguments, "--json", "-")
    if result.returncode != 0:
        raise AssertionError(result.stderr.decode(errors="replace"))
    return json.loads(result.stdout)


class Plan(FileTest):
    def test_json_is_as_agreed(self):
        told = plan(SCENE, "--error", "2/255")
        self.assertEqual(list(told), PLAN)
        self.assertEqual((told["scene"], told["width"], told["height"]), (SCENE, 48, 40))
        self.assertEqual((told["error_budget"], told["problem"], told["check"]), (2 * STEP, "", None))
        self.assertEqual(told["layers_max"], 6)
        self.assertGreater(told["triangles"], told["parts"])
        self.assertEqual({row["method"] for row in told["methods"]}, LISTS)
        for row in told["methods"]:
            with self.subTest(row["method"]):
                self.assertEqual(list(row), ["method", "error", "geometry_passes", "bytes", "reason"])
                self.assertTrue(0.5 * STEP < row["error"] < 2 * STEP)
                self.assertGreaterEqual(row["geometry_passes"], 1)
                self.assertGreaterEqual(row["bytes"], 16 * told["fragments"])
                self.assertTrue(row["reason"])

    def test_the_first_row_is_the_choice_and_follows_the_budget(self):
        for error, chosen in (("0.6/255", "prefix-sum-predicted"), ("8/255", "prefix-sum-predicted-compact")):
            self.assertEqual(plan(SCENE, "--error", error)["methods"][0]["method"], chosen)

    def test_verify_measures(self):
        told = plan(SCENE, "--error", "2/255", "--verify")
        check = told["check"]
        self.assertEqual(list(check), CHECK)
        self.assertTrue(0.25 * STEP < check["error_max"] <= check["bound_max"] <= 2 * STEP)
        self.assertEqual(check["pixels_beyond_bound"], 0)
        self.assertTrue(1 <= check["tightness_median"] <= 4)
        self.assertGreater(check["regret"], 0)
        self.assertEqual({row["method"] for row in check["results"]}, {"automatic"} | LISTS)
        for row in check["results"]:
            self.assertLessEqual(row["error"]["max"], 2 * STEP)

    def test_text(self):
        result = run("plan", SCENE, *SMALL, "--error", "2/255", "--verify")
        self.assert_done(result)
        for words in (
            b"budget 2.00/255: prefix-sum-predicted-compact, which keeps it", b"links take memory",
            b"0 pixels beyond their bound", b"automatic chose prefix-sum-predicted-compact",
        ):  # fmt: skip
            self.assertIn(words, result.stdout)

    def test_what_cannot_be_kept_is_told(self):
        told = plan(SCENE, "--error", "1/255", "--multisamples", "4")
        self.assertIn("the budget is 1/255", told["problem"])
        self.assertGreater(told["methods"][0]["error"], STEP)
        for command in (
            ("render", SCENE, "--size", "48x40", "-o", self.folder / "picture.png"),
            ("compare", SCENE, *SMALL, "--methods", "automatic", "--without-truth"),
        ):
            result = run(*command, "--error", "0.6/255", "--multisamples", "4")
            self.assertEqual(result.returncode, 0)
            self.assertIn(b"vitrine: note: the error budget is not promised: pictures", result.stderr)
            self.assertIn(b"errors of up to 1.05/255, and the budget is 0.6/255\n", result.stderr)

    def test_without_anything_translucent(self):
        opaque = self.write("opaque.stl", scenes.binary_stl())
        told = plan(opaque, "--verify")
        self.assertEqual((told["error_budget"], told["fragments"]), (STEP, 0))
        result = run("plan", opaque, *SMALL)
        self.assert_done(result)
        self.assertIn(b"0 fragments", result.stdout)


class Budgets(FileTest):
    def test_bad_ones_are_refused(self):
        for error in BAD:
            with self.subTest(error=error):
                self.assert_refused(run("plan", SCENE, f"--error={error}"), "--error", f"'{error}'")
        picture = self.folder / "picture.png"
        for command in (("render", "-o", picture), ("compare", "--methods", "automatic"), ("view",)):
            with self.subTest(command=command[0]):
                result = run(command[0], SCENE, *command[1:], "--error", "0.5/255")
                self.assert_refused(result, "--error", "0.6/255 to 1", "rounding to 8 bits")
        self.assertFalse(picture.exists())

    def test_other_methods_have_none(self):
        picture = self.folder / "picture.png"
        result = run("render", SCENE, "-o", picture, "--method", "linked-list", "--error", "2/255")
        self.assert_refused(result, "--error", "'linked-list'", "only the method automatic")
        result = run("compare", SCENE, "--methods", "linked-list", "--error", "2/255")
        self.assert_refused(result, "--error", "add automatic")

    def test_render_keeps_them(self):
        pictures = []
        for options in (("--method", "truth"), ("--error", "2/255"), ("--error", "0.6/255")):
            path = self.folder / "picture.png"
            self.assert_done(run("render", SCENE, "--size", "48x40", *options, "-o", path))
            pictures.append(b"".join(read_png(path)[2]))
        exact, *others = pictures
        for picture, steps in zip(others, (2, 1)):
            self.assertLessEqual(max(abs(a - b) for a, b in zip(exact, picture)), steps)

    def test_compare_tells_the_choice_and_its_regret(self):
        told = compare(SCENE, *SMALL, "--methods", "automatic,linked-list,vtk-oit", "--error", "2/255")
        self.assertEqual(told["settings"]["error_budget"], 2 * STEP)
        row, linked_list, _ = told["results"]
        self.assertEqual(row["chosen"], "prefix-sum-predicted-compact")
        self.assertTrue(row["error"]["max"] <= row["guaranteed_error"] <= 2 * STEP)
        # The weighted average is beyond the budget, however fast it is.
        ratio = row["frame_ms"]["median"] / linked_list["frame_ms"]["median"]
        self.assertAlmostEqual(row["regret"], ratio, delta=1e-9 * ratio)
        self.assertNotIn("chosen", linked_list)
        self.check_chart(row["chosen"])

    def check_chart(self, chosen):
        folder = self.folder / "chart"
        methods = ("--methods", "automatic,linked-list", "--error", "2/255")
        self.assert_done(run("compare", SCENE, *SMALL, *methods, "--chart", folder))
        row, linked_list = read_document(folder)["results"]
        self.assertEqual((row["family"], row["chosen"]), ("automatic", chosen))
        ratio = row["frame_ms"]["median"] / linked_list["frame_ms"]["median"]
        self.assertAlmostEqual(row["regret"], ratio, delta=1e-9 * ratio)
        self.assertEqual(page_data(folder)["families"]["automatic"]["color"], "#000000")

    def test_compare_without_another_method_has_no_regret(self):
        alone = compare(SCENE, *SMALL, "--methods", "automatic", "--error", "0.6/255")
        self.assertIsNone(alone["results"][0]["regret"])
