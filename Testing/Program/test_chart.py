import base64
import json
import os
import pathlib
import shutil
import signal
import tempfile
import unittest

import scenes
from charts import (
    METHODS,
    chart,
    page_data,
    read_document,
    results_there,
    resumed_chart,
    start_chart,
    stop_when,
)
from program import FileTest, ProgramTest, read_png, run

COSTS = {
    "time": lambda row: row["ratio"],
    "memory": lambda row: row["bytes"],
    "passes": lambda row: row["geometry_passes"],
}
ERRORS = {
    "max": lambda row: row["error"]["max"],
    "rmse": lambda row: row["error"]["rmse"],
    "psnr": lambda row: -row["error"]["psnr"],
    "ssim": lambda row: -row["error"]["ssim"],
    "flip": lambda row: row["error"]["flip"],
    "wrong_pixels": lambda row: row["error"]["wrong_pixels"],
}
MARK = 123456.0  # milliseconds that no frame takes
OUTCOMES = ("exact", "wrong", "flickers", "order-dependent", "refused")


def beats(a, b):
    return a != b and a[0] <= b[0] and a[1] <= b[1]


class Chart(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.resumed = resumed_chart()
        cls.folder = cls.resumed.folder
        cls.before = cls.resumed.before
        cls.document = read_document(cls.folder)
        cls.rows = cls.document["results"]

    def test_a_stopped_run_leaves_whole_files_only(self):
        self.assertNotEqual(self.resumed.stopped, 0)
        self.assertEqual(self.resumed.files_before, ["chart.json", "pictures"])
        self.assertTrue(0 < len(self.before["results"]) < len(self.rows))

    def test_a_run_goes_on_where_it_was_stopped(self):
        said = self.resumed.result.stderr.decode()
        self.assertEqual(self.resumed.result.returncode, 0, said)
        count = len(self.before["results"]) + len(self.before.get("failures", []))
        self.assertIn(f"has {count} results already; going on", said)
        for row in self.before["results"]:
            self.assertIn(row, [{key: later.get(key) for key in row} for later in self.rows])
        places = [(row["part"], row["step"], row["method"]) for row in self.rows]
        self.assertEqual(len(places), len(set(places)))

    def test_a_complete_chart_is_not_measured_again(self):
        again = chart(self.folder)
        self.assertIn(b"results already", again.stderr)
        self.assertEqual(read_document(self.folder), self.document)

    def test_what_grows_is_of_one_run(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())) / "chart"
        shutil.copytree(self.folder, folder)
        document = read_document(folder)
        for row in document["results"]:
            row["frame_ms"]["median"] = MARK
        last = max(row["step"] for row in self.rows if row["part"] == "layers")
        document["results"] = [
            row
            for row in document["results"]
            if (row["part"], row["step"]) != ("layers", last)
        ]
        (folder / "chart.json").write_text(json.dumps(document))
        self.assertEqual(chart(folder).returncode, 0)
        rows = read_document(folder)["results"]
        self.assertEqual(len(rows), len(self.rows))
        for row in rows:
            self.assertEqual(row["frame_ms"]["median"] == MARK, row["part"] != "layers")

    def test_all_files_are_there(self):
        self.assertEqual(
            self.resumed.result.stdout.decode().strip(), str(self.folder / "index.html")
        )
        files = sorted(path.name for path in self.folder.iterdir())
        self.assertEqual(files, ["chart.json", "error.png", "growth.png", "index.html", "pictures"])
        self.assertEqual(read_png(self.folder / "error.png")[:2], (1920, 480))
        self.assertEqual(read_png(self.folder / "growth.png")[:2], (1280, 960))

    def test_json_says_what_was_measured_and_on_what(self):
        self.assertEqual(self.document["vitrine"], os.environ["VITRINE_VERSION"])
        self.assertTrue(all(self.document["device"].values()))
        self.assertEqual(self.document["settings"]["scene_methods"], list(METHODS))
        steps = self.document["settings"]["steps"]
        parts = [step["part"] for step in steps]
        for part in ("scenes", "layers", "fragments", "resolution"):
            self.assertGreaterEqual(parts.count(part), 1 if part == "resolution" else 3)
        self.assertEqual(len(self.rows), len(METHODS) * len(steps))

    def test_rows_are_those_of_compare_and_more(self):
        for row in self.rows:
            with self.subTest(part=row["part"], step=row["step"], method=row["method"]):
                for key in ("scene", "width", "height", "frame_ms", "fragments", "bytes", "error"):
                    self.assertIn(key, row)
                self.assertTrue(row["method"].startswith(row["family"]))
                self.assertEqual(row["ratio_to"], "vtk-oit")
                if row["method"] == "vtk-oit":
                    self.assertEqual(row["ratio"], 1.0)
                self.assertEqual("picture" in row, row["part"] == "scenes")

    def test_pictures_are_those_of_the_rows(self):
        for row in self.rows:
            for key in ("picture", "truth_picture"):
                if key in row:
                    width, height, _ = read_png(self.folder / row[key])
                    self.assertEqual((width, height), (row["width"], row["height"]))
        exact = next(row for row in self.rows if row["method"] == "linked-list")
        difference = self.largest_difference(exact["picture"], exact["truth_picture"])
        self.assertLessEqual(difference, 1)
        wrong = next(row for row in self.rows if row["method"] == "blend")
        difference = self.largest_difference(wrong["picture"], wrong["truth_picture"])
        # both pictures are rounded, by a half at most; the error is the worse of two frames
        self.assertLessEqual(difference, 255 * wrong["error"]["max"] + 1)
        self.assertGreater(difference, 5)

    def largest_difference(self, one, other):
        rows = [read_png(self.folder / path)[2] for path in (one, other)]
        return max(abs(a - b) for line in zip(*rows) for a, b in zip(*line))

    def test_fronts_are_what_nobody_beats(self):
        for scene in self.document["scenes"]:
            rows = [
                row for row in self.rows if row["part"] == "scenes" and row["step"] == scene["step"]
            ]
            for cost, read_cost in COSTS.items():
                for error, read_error in ERRORS.items():
                    with self.subTest(scene=scene["scene"], cost=cost, error=error):
                        told = [row for row in rows if read_cost(row) is not None]
                        places = [(read_cost(row), read_error(row)) for row in told]
                        front = {
                            row["method"]
                            for row, place in zip(told, places)
                            if not any(beats(other, place) for other in places)
                        }
                        self.assertEqual(set(scene["fronts"][cost][error]), front)

    def test_growth_is_measured_as_it_grows(self):
        titles = [growth["title"] for growth in self.document["growth"]]
        self.assertEqual(
            titles,
            [
                "Time against layers",
                "Memory against layers",
                "Time against fragments",
                "Time against resolution",
            ],
        )
        for growth in self.document["growth"]:
            for line in growth["lines"]:
                xs = [point[0] for point in line["points"]]
                self.assertEqual(xs, sorted(set(xs)), growth["title"])

    def test_memory_of_lists_grows_with_layers(self):
        growth = self.document["growth"][1]
        fits = {line["method"]: line["fit"] for line in growth["lines"]}
        self.assertIsNone(fits["blend"])  # holds nothing: zeros have no logarithm
        self.assertAlmostEqual(fits["vtk-oit"]["exponent"], 0.0)
        self.assertTrue(0.8 < fits["linked-list"]["exponent"] < 1.2, fits)
        self.assertEqual(fits["linked-list"]["to"], 256)
        self.assertEqual(fits["linked-list"]["from"], 16)

    def test_the_page_needs_nothing_else(self):
        page = (self.folder / "index.html").read_text()
        self.assertNotIn("http:", page.replace("http://www.w3.org/2000/svg", ""))
        self.assertNotIn("https:", page)
        self.assertNotIn("@import", page)
        rows = self.rows + self.document["failures"]
        named = {row[key] for row in rows for key in ("picture", "truth_picture") if key in row}
        self.assertEqual(page.count("data:image/png;base64,"), len(named))

    def test_every_cell_of_where_methods_fail_is_there(self):
        settings = self.document["settings"]["failures"]
        cells = {(cell["scene"], cell["method"]): cell for cell in self.document["failures"]}
        self.assertEqual(len(cells), len(self.document["failures"]))
        names = [scene["name"] for scene in settings["scenes"]]
        self.assertEqual(set(cells), {(name, method) for name in names for method in METHODS})
        self.assertIn("expected", settings["scenes"][0])
        self.assertIn("zoom_before", settings["scenes"][0])
        self.assertIn("heavy", settings["scenes"][0])
        for cell in cells.values():
            self.assertIn(cell["outcome"], OUTCOMES)
            if cell["outcome"] != "refused":
                self.assertTrue((self.folder / cell["truth_picture"]).exists())
                width, height, _ = read_png(self.folder / cell["picture"])
                self.assertEqual((width, height), (cell["width"], cell["height"]))
        outcomes = [cells[name, "linked-list"]["outcome"] for name in names]
        self.assertIn("exact", outcomes)
        self.assertIn("wrong", [cells[name, "vtk-oit"]["outcome"] for name in names])


class ChartOfFiles(FileTest):
    def test_a_file_is_read_before_anything_is_measured_and_not_again(self):
        path = self.write("plate.stl", scenes.binary_stl())
        folder = self.folder / "chart"
        process = start_chart(folder, path)

        def is_measured():
            rows = results_there(folder)
            if rows:
                path.unlink(missing_ok=True)
            return any(row["scene"] == str(path) for row in rows)

        stop_when(process, is_measured, signal.SIGTERM)

    def test_opacity_is_that_of_files_and_belongs_to_the_settings(self):
        path = self.write("plate.stl", scenes.binary_stl())
        folder = self.folder / "chart"
        told = []
        process = start_chart(folder, path, "--opacity", "0.5")

        def is_measured():
            told[:] = [row for row in results_there(folder) if row["scene"] == str(path)]
            return told

        stop_when(process, is_measured, signal.SIGTERM)
        self.assertTrue(all(row["fragments"] > 0 for row in told), told)
        self.assertEqual(read_document(folder)["settings"]["opacity"], 0.5)
        self.assertNotIn(b"translucent", process.said)
        before = (folder / "chart.json").read_bytes()
        result = chart(folder, path, "--opacity", "0.25")
        words = "with other settings (settings.opacity was 0.5 and is 0.25)"
        self.assert_refused(result, folder / "chart.json", words)
        os.utime(path, (0, 0))
        result = chart(folder, path, "--opacity", "0.5")
        self.assert_refused(result, f"with other settings ({path} has changed)")
        self.assertEqual((folder / "chart.json").read_bytes(), before)

    def test_an_opaque_file_is_told_before_anything_is_measured(self):
        path = self.write("plate.stl", scenes.binary_stl())
        self.write("chart.json", b"")  # ends the run
        result = chart(self.folder, path, "demo:crossing")
        self.assertEqual(result.returncode, 2)
        advice = f"{path}: Nothing in it is translucent; --opacity 0.3 makes it so."
        self.assertIn(advice, result.stderr.decode())
        self.assertEqual(result.stderr.count(b"translucent"), 1)

    def test_opacity_needs_an_input(self):
        self.assert_refused(chart(self.folder, "--opacity", "0.5"), "--opacity", "INPUT")


class ChartOfRefused(FileTest):
    def test_rows_tell_why_methods_are_skipped_and_stderr_does_not(self):
        folder = self.folder / "chart"
        small = ("--quick", "--size", "8x8", "--frames", "1", "--methods", "stencil-routed-32")
        self.assert_done(run("chart", *small, "--out", folder))
        document = read_document(folder)
        self.assertGreater(len(document["results"]), 0)
        for row in document["results"] + document["failures"]:
            self.assertIn("samples", row["skipped"])


class ChartOfOwnScene(FileTest):
    SCENE = ("demo:stack,layers=3", "--methods", "linked-list,stencil-routed-32,vtk-oit")

    def compare(self, *arguments):
        return run("compare", *self.SCENE, "--frames", "1", "--size", "8x8", *arguments)

    def test_compare_writes_a_chart(self):
        folder = self.folder / "chart"
        for _ in range(2):  # the second measures anew
            result = self.compare("--chart", folder, "--json", self.folder / "rows.json")
            self.assertEqual(result.returncode, 0, result.stderr.decode())
            rows = json.loads((self.folder / "rows.json").read_text())["results"]
            document = read_document(folder)
            now = [{key: row[key] for key in rows[0] if key in row} for row in document["results"]]
            self.assertEqual(
                now, [{key: row[key] for key in rows[0] if key in row} for row in rows]
            )
            self.assertEqual(document["growth"], [])
            self.assertTrue((folder / "index.html").exists())
            self.assertFalse((folder / "growth.png").exists())

    def test_large_pictures_are_scaled_down_for_the_page(self):
        folder = self.folder / "chart"
        command = ("compare", "demo:stack", "--methods", "blend", "--frames", "1")
        result = run(*command, "--size", "1100x3", "--chart", folder)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        row = read_document(folder)["results"][0]
        width, _, rows = read_png(folder / row["picture"])
        self.assertEqual(width, 1100)
        page = page_data(folder)
        self.assertEqual(page["shrunk"][row["picture"]], 2)
        encoded = page["pictures"][row["picture"]].removeprefix("data:image/png;base64,")
        small = self.write("small.png", base64.b64decode(encoded))
        width, height, shrunk = read_png(small)
        self.assertEqual((width, height), (550, 2))
        for x in (0, 100, 549):
            # rows of a PNG come from the top: the upper one is what is left of a square
            top = rows[0][6 * x : 6 * x + 6]
            self.assertAlmostEqual(shrunk[0][3 * x], (top[0] + top[3]) / 2, delta=0.5)
            square = [row[6 * x + 3 * i] for row in rows[1:] for i in (0, 1)]
            self.assertAlmostEqual(shrunk[1][3 * x], sum(square) / 4, delta=0.5)

    def test_pictures_are_files_of_the_chart(self):
        """What somebody put in the place of a picture is not taken into a page."""
        resumed = self.folder / "chart"
        shutil.copytree(resumed_chart().folder, resumed)
        picture = resumed / read_document(resumed)["results"][0]["picture"]
        content = picture.read_bytes()
        secret = self.write("secret", b"secret")
        aside = self.write("aside.png", content)
        for put in (
            lambda: picture.symlink_to(aside),
            lambda: picture.write_bytes(secret.read_bytes()),
            lambda: picture.write_bytes(content[: len(content) // 2]),
            lambda: None,
        ):
            picture.unlink(missing_ok=True)
            put()
            result = chart(resumed)
            self.assertEqual(result.returncode, 2)
            self.assertIn(f"{picture}: is missing, or no picture", result.stderr.decode())

    def test_a_name_that_is_hostile_to_pages_is_text(self):
        name = "</script><script>alert(1)<!--.stl"
        name = name.replace("/", "\u2215")
        triangle = b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        triangle += b"vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"
        path = self.write(name, triangle)
        folder = self.folder / "chart"
        result = run("compare", path, "--methods", "blend", "--size", "8x8", "--chart", folder)
        self.assert_done(result)
        page = (folder / "index.html").read_text()
        self.assertNotIn("<script>alert", page)
        self.assertIn("\\u003cscript>alert(1)\\u003c!--.stl", page)


if __name__ == "__main__":
    unittest.main()
