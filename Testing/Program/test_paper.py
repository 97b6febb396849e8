"""The papers' scenes, and `vitrine paper`, which measures them."""

import json
import unittest

from program import FileTest, compare, info, read_png, run
from test_compare import ROW

SIZE = ["--size", "32x20"]
TRIANGLES = {"masks": 384 + 871000 + 2256, "lists": 2048 + 261000 + 2256}
MOST_LAYERS = {"masks": 15, "lists": 57}


def layers_of(scene, view="0,0"):
    return info(scene, "--view", view)["layers"]["layers_max"]


class PaperScenes(FileTest):
    def render(self, scene, method="linked-list"):
        path = self.folder / "picture.png"
        self.assert_done(run("render", scene, "-o", path, "--method", method, *SIZE))
        return read_png(path)

    def test_triangles_and_layers_are_the_papers(self):
        for name, triangles in TRIANGLES.items():
            told = info(f"demo:paper-{name}")
            with self.subTest(scene=name):
                self.assertEqual(told["triangles"], triangles)
                self.assertEqual(told["layers"]["layers_max"], MOST_LAYERS[name])
                self.assertEqual(told["parts"] - told["translucent_parts"], 1)
                self.assertEqual(told["skipped"], [])

    def test_there_are_as_many_layers_as_are_asked_for(self):
        for seed, layers in enumerate((0, 1, 3, 4, 5, 8, 32, 64)):
            scene = f"demo:paper-lists,layers={layers},seed={seed}"
            with self.subTest(scene=scene):
                self.assertEqual(layers_of(scene), layers)

    def test_layers_stay_along_the_way_of_the_camera(self):
        for view in ("3,0", "6,0"):
            with self.subTest(view=view):
                self.assertEqual(layers_of("demo:paper-lists", view), MOST_LAYERS["lists"])

    def test_no_view_has_more_layers(self):
        for view in ("40,10", "90,0", "130,-35", "0,90", "180,0"):
            with self.subTest(view=view):
                result = run(
                    "info", "demo:paper-lists,layers=9", "--view", view,
                    "--size", "320x200", "--json", "-",
                )  # fmt: skip
                self.assertLessEqual(json.loads(result.stdout)["layers"]["layers_max"], 9)

    def test_all_textured_triangles_are_there_with_any_number_of_sheets(self):
        for name, textured in (("masks", 384), ("lists", 2048)):
            for layers in (1, 3, 64):
                model = TRIANGLES[name] - textured if layers > 4 else 2256
                with self.subTest(scene=name, layers=layers):
                    told = info(f"demo:paper-{name},layers={layers}")
                    self.assertEqual(told["triangles"] - model, textured)

    def test_layers_become_fewer_outwards(self):
        for name, most in MOST_LAYERS.items():
            layers = info(f"demo:paper-{name}")["layers"]
            with self.subTest(scene=name):
                self.assertLess(layers["layers_mean"], 0.6 * most)
                self.assertLess(layers["fragments"], 0.6 * most * 16 * 16)

    def test_textures_are_drawn_with_their_opacity(self):
        _, _, rows = self.render("demo:paper-lists,layers=1")
        background = (242, 242, 242)
        pixels = {tuple(row[i : i + 3]) for row in rows for i in range(0, len(row), 3)}
        self.assertIn(background, pixels)
        self.assertGreater(len(pixels), 100)  # clouds, not one colour

    def test_the_same_twice_and_another_with_another_seed(self):
        for name in TRIANGLES:
            pictures = [
                self.render(f"demo:paper-{name}{more}") for more in ("", ",seed=1", ",seed=2")
            ]
            with self.subTest(scene=name):
                self.assertEqual(pictures[0], pictures[1])
                self.assertNotEqual(pictures[0], pictures[2])

    def test_exact_methods_are_exact_and_depth_peeling_is_almost(self):
        methods = "linked-list,vtk-peeling"
        rows = compare("demo:paper-lists,layers=12", "--methods", methods, "--frames", "1", *SIZE)[
            "results"
        ]
        self.assertLessEqual(rows[0]["error"]["max"], 1 / 255)
        self.assertLessEqual(rows[1]["error"]["max"], 8 / 255)  # rounds at each of 12 layers


class Paper(FileTest):
    def paper(self, *arguments):
        result = run("paper", *arguments, *SIZE, "--frames", "2", "--json", "-")
        self.assert_done(result)
        return json.loads(result.stdout)

    def test_json_has_compares_rows_and_shares(self):
        told = self.paper("lists", "--layers", "2,9")
        self.assertEqual(list(told), ["vitrine", "build", "device", "settings", "results"])
        scenes = [row["scene"] for row in told["results"]]
        self.assertEqual(
            list(dict.fromkeys(scenes)),
            ["demo:paper-lists,layers=2", "demo:paper-lists,layers=9"],
        )
        for row in told["results"]:
            with self.subTest(scene=row["scene"], method=row["method"]):
                self.check_row(row, told["results"])

    def check_row(self, row, rows):
        self.assertEqual(list(row), ROW + ["fps", "mpixel_s", "share_of_blend", "paper_share"])
        layers = int(row["scene"].split("=")[1])
        self.assertEqual((row["width"], row["height"]), (32, 20))
        self.assertEqual(row["layers_max"], layers)
        time = row["frame_ms"]["median"]
        self.assertAlmostEqual(row["fps"] * time, 1000.0)
        self.assertAlmostEqual(row["mpixel_s"], row["fps"] * 32 * 20 / 1e6)
        blend = next(
            other["frame_ms"]["median"]
            for other in rows
            if (other["scene"], other["method"]) == (row["scene"], "blend")
        )
        self.assertAlmostEqual(row["share_of_blend"], blend / time)
        is_peer = row["method"] in ("blend", "vtk-oit")
        self.assertEqual(row["paper_share"], None if is_peer else {2: 0.12, 9: 0.1}[layers])

    def test_shares_of_the_papers(self):
        for table, shares in (
            ("masks", {8: 0.27, 16: 0.12, 17: None}),
            ("lists", {32: 0.06, 64: 0.033}),  # test_json_has_compares_rows_and_shares has fewer layers
        ):
            layers = ",".join(map(str, shares))
            rows = self.paper(table, "--layers", layers, "--methods", "blend,linked-list")
            told = [row["paper_share"] for row in rows["results"] if row["method"] != "blend"]
            with self.subTest(table=table):
                self.assertEqual(told, list(shares.values()))

    def faces(self, *arguments):
        result = run("paper", "faces", "--size", "960x540", *arguments, "--json", "-")
        self.assert_done(result)
        return json.loads(result.stdout)

    def test_statements_save_comparisons_of_faces(self):
        told = self.faces("--frames", "2")
        self.assertEqual(list(told), ["vitrine", "build", "device", "faces"])
        self.assertEqual(
            list(dict.fromkeys((row["faces"], row["sequence"], row["count"]) for row in told["faces"])),
            [
                ("boxes", "as-stored", 11886),
                ("boxes", "front-to-back", 11886),
                ("spheres", "as-stored", 8972),
                ("spheres", "front-to-back", 8972),
            ],
        )
        ways = ["compared", "none", "1", "2", "3", "all"]
        for first in range(0, 24, 6):
            rows = dict(zip(ways, told["faces"][first : first + 6]))
            with self.subTest(faces=rows["all"]["faces"], sequence=rows["all"]["sequence"]):
                self.check_statements(rows)

    def check_statements(self, rows):
        self.assertEqual([row["statements"] for row in rows.values()], list(rows))
        compared = rows["compared"]["comparisons"]
        for row in rows.values():
            self.assertEqual((row["width"], row["height"]), (960, 540))
            self.assertAlmostEqual(row["saved"], 1 - row["comparisons"] / compared)
            self.assertEqual(row["insert_ms"]["rounds"], 2)
        for name in ("compared", "none"):
            self.assertEqual((rows[name]["saved"], rows[name]["lookups"]), (0, 0))
        for name in ("1", "2", "3"):
            self.assertGreater(rows[name]["saved"], 0.05)
            self.assertLess(rows[name]["saved"], rows["all"]["saved"])
        self.assertEqual(rows["1"]["end_checks"], 0)
        self.assertEqual(rows["2"]["lookups"], 0)
        self.assertGreater(rows["2"]["end_checks"], 0)
        self.assertGreater(rows["3"]["lookups"], 0)
        self.assertTrue(0.8 < rows["all"]["saved"] < 0.98)

    def test_faces_know_neither_methods_nor_layers(self):
        for arguments in (["--methods", "blend"], ["--layers", "8"]):
            self.assert_refused(run("paper", "faces", *arguments), arguments[0])

    def test_all_tables_in_text(self):
        path = self.folder / "paper.json"
        result = run(
            "paper", "--layers", "1", "--methods", "blend", "--frames", "1", *SIZE, "--json", path
        )
        self.assert_done(result)
        for word in (b"demo:paper-masks", b"demo:paper-lists", b"Mpixel/s", b"share of blend", b"Order of faces"):
            self.assertIn(word, result.stdout)
        told = json.loads(path.read_text())
        self.assertEqual((len(told["results"]), len(told["faces"])), (2, 24))

    def test_a_method_that_cannot_run_is_a_row_that_says_why(self):
        result = run(
            "paper", "lists", "--layers", "2", "--methods", "blend,linked-list", "--frames", "1",
            *SIZE, "--json", "-", MESA_GL_VERSION_OVERRIDE="3.2",
        )  # fmt: skip
        told = json.loads(result.stdout)
        if "3.2" not in told["device"]["gl"]:
            self.skipTest("the driver is not Mesa's")
        blend, linked_list = told["results"]
        self.assertEqual(list(linked_list), ["scene", "method", "width", "height", "skipped"])
        self.assertEqual(blend["share_of_blend"], 1.0)

    def test_bad_arguments(self):
        path = self.folder / "paper.json"
        for arguments, word in (
            (["tables"], "tables"),
            (["masks", "lists"], "lists"),
            (["--layers", "0"], "--layers"),
            (["--layers", "8,65"], "--layers"),
            (["--layers", "many"], "--layers"),
            (["--methods", "linked-list"], "blend"),
            (["--methods", "blend,depth"], "depth"),
            (["--methods", ""], "--methods"),
            (["--size", "0x8"], "--size"),
            (["--frames", "0"], "--frames"),
            (["--opacity=0.5"], "--opacity"),
        ):
            with self.subTest(arguments=arguments):
                self.assert_refused(run("paper", *arguments, "--json", path), word)
        self.assert_refused(run("paper", "--json", self.folder / "none" / "x"), "none")
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
