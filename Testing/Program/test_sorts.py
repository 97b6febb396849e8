import json
import os
import unittest

from program import DEVICE, FileTest, read_png, run

METHODS = ["insertion", "shell", "bitonic", "odd-even-merge", "network"]
ROW = [
    "method", "size", "longest", "elements", "repeats", "ms", "floor_ms", "net_ms",
    "elements_per_second", "over_network", "comparisons",
]  # fmt: skip
SMALL = {"--sizes": "4", "--storage": "4", "--lists": "300", "--rounds": "2"}


def run_small(*arguments, **environment):
    """Run `vitrine sorts` with few lists; options among the arguments take the place of SMALL's."""
    options = [
        text for name, value in SMALL.items() if name not in arguments for text in (name, value)
    ]
    return run("sorts", *options, *arguments, **environment)


def sorts(*arguments):
    """The JSON of such a run."""
    result = run_small(*arguments, "--json", "-")
    if result.returncode != 0:
        raise AssertionError(result.stderr.decode(errors="replace"))
    return json.loads(result.stdout)


class Sorts(FileTest):
    def test_json_is_as_agreed(self):
        told = sorts("--sizes", "2,4,2")
        self.assertEqual(list(told), ["vitrine", "build", "device", "settings", "results", "lengths"])
        self.assertEqual(told["vitrine"], os.environ["VITRINE_VERSION"])
        self.assertEqual(list(told["device"]), DEVICE)
        self.assertEqual(told["settings"], {"lists": 300, "rounds": 2, "seed": 1, "storage": 4})
        rows = told["results"]
        self.assertEqual(
            [(row["size"], row["method"]) for row in rows],
            [(n, m) for n in (2, 4) for m in METHODS],
        )
        for row in rows + told["lengths"]:
            with self.subTest(method=row["method"], size=row["size"], longest=row["longest"]):
                self.check_row(row)

    def check_row(self, row):
        self.assertEqual(list(row), ROW)
        for times in (row["ms"], row["floor_ms"]):
            self.assertEqual(list(times), ["min", "median", "max", "rounds"])
            self.assertTrue(0.0 < times["min"] <= times["median"] <= times["max"])
            self.assertEqual(times["rounds"], 2)
        self.assertTrue(0 < row["elements"] <= 300 * row["longest"])
        self.assertEqual(list(row["elements_per_second"]), ["whole", "net"])
        self.assertAlmostEqual(
            row["elements_per_second"]["whole"] * row["ms"]["median"] / 1000.0,
            row["elements"],
            delta=1e-6 * row["elements"],
        )
        self.assertEqual(list(row["over_network"]), ["whole", "net", "paper"])
        self.assertGreater(row["over_network"]["whole"], 0.0)
        is_papers = row["method"] == "insertion" and row["size"] == 4
        self.assertEqual(row["over_network"]["paper"], 3.0 if is_papers else None)
        self.assertLessEqual(row["comparisons"]["mean"], row["comparisons"]["most"])

    def test_lengths_go_up_to_the_storage(self):
        rows = sorts("--methods", "network", "--storage", "8")["lengths"]
        self.assertEqual([row["longest"] for row in rows], list(range(1, 9)))
        self.assertEqual({row["size"] for row in rows}, {8})
        elements = [row["elements"] for row in rows]
        self.assertEqual(elements, sorted(elements))

    def test_comparisons_are_counted(self):
        rows = {row["method"]: row["comparisons"] for row in sorts()["results"]}
        self.assertEqual({m: rows[m]["most"] for m in METHODS}, dict(zip(METHODS, [6, 6, 6, 5, 5])))
        self.assertEqual(rows["network"]["mean"], 5.0)
        for method in METHODS[:-1]:
            self.assertTrue(1.0 < rows[method]["mean"] < 3.0, rows)

    def test_same_seed_same_lists(self):
        elements = [
            sorts("--methods", "network", "--seed", seed)["results"][0]["elements"]
            for seed in (1, 1, 2)
        ]
        self.assertEqual(elements[0], elements[1])
        self.assertNotEqual(elements[0], elements[2])

    def test_without_the_network_there_is_no_ratio(self):
        told = sorts("--methods", "shell,insertion,shell")
        self.assertEqual([row["method"] for row in told["results"]], ["shell", "insertion"])
        for row in told["results"]:
            self.assertIsNone(row["over_network"]["whole"])
            self.assertIsNone(row["over_network"]["net"])

    def test_tables_and_plot(self):
        picture = self.folder / "sorts.png"
        report = self.folder / "sorts.json"
        result = run_small("--plot", picture, "--json", report)
        self.assert_done(result)
        lines = result.stdout.decode().splitlines()
        self.assertTrue(lines[0].startswith("300 lists of random length, "), lines[0])
        for method in METHODS:
            self.assertEqual(sum(line.startswith(method + " ") for line in lines), 5, method)
        self.assertEqual(len(json.loads(report.read_bytes())["results"]), len(METHODS))
        width, height, rows = read_png(picture)
        self.assertEqual((width, height), (1280, 560))
        colors = {bytes(row[i : i + 3]) for row in rows for i in range(0, len(row), 3)}
        for method, color in zip(
            METHODS, [(213, 94, 0), (230, 159, 0), (204, 121, 167), (0, 158, 115), (0, 114, 178)]
        ):
            self.assertIn(bytes(color), colors, method)

    def test_bad_arguments(self):
        for arguments, words in (
            (["--sizes", "3"], ["--sizes", "3"]),
            (["--sizes", "4,128"], ["--sizes", "128"]),
            (["--sizes", "four"], ["--sizes", "four"]),
            (["--storage", "0"], ["--storage", "0"]),
            (["--methods", "quick"], ["quick", *METHODS]),
            (["--lists", "0"], ["--lists"]),
            (["--lists", "1e3"], ["--lists"]),
            (["--rounds", "0"], ["--rounds"]),
            (["--seed", "-1"], ["--seed"]),
            (["--plot", "plot.jpg"], ["plot.jpg", ".png"]),
            (["--plot", ""], [".png"]),
            (["demo:stack"], ["demo:stack"]),
        ):
            with self.subTest(arguments=arguments):
                self.assert_refused(run_small(*arguments), *words)

    def test_nothing_is_written_where_something_cannot_be(self):
        missing = self.folder / "none" / "sorts.json"
        picture = self.folder / "sorts.png"
        self.assert_refused(run_small("--plot", picture, "--json", missing), missing)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_driver_without_storage_buffers_is_refused(self):
        result = run_small(MESA_GL_VERSION_OVERRIDE="3.3")
        self.assert_refused(result, "OpenGL 4.3")


if __name__ == "__main__":
    unittest.main()
