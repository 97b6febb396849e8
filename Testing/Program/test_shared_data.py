"""Real models, where they are: VITRINE_SHARED_DATA, or ../shared/data beside the project."""

import json
import os
import pathlib
import unittest

from program import FileTest, compare, info, read_png, run

PROJECT = pathlib.Path(__file__).resolve().parents[2]
DATA = pathlib.Path(os.environ.get("VITRINE_SHARED_DATA", PROJECT.parent / "shared" / "data"))
KINDS = {".3mf", ".glb", ".obj", ".stl", ".ply"}
MODELS = sorted(path for path in DATA.glob("*/*") if path.suffix in KINDS)
COMPARED = (
    "VertexColorTest.glb",
    "glass-table_blend.glb",
    "ldraw_car.glb",
    "moveo_Top_Plate.stl",
    "cycloidal.ply",
)

# of SOURCES.md: parts and triangles
COUNTS = {
    "atlas_detector.glb": (15321, 858758),
    "cms_detector.glb": (4561, 192984),
    "ldraw_car.glb": (62, 25677),
    "robot_franka_panda.glb": (58, 134854),
    "AlphaBlendModeTest.glb": (9, 61),
    "TransmissionTest_blend.glb": (22, 128775),
    "moveo_Idol_Gear.stl": (1, 58876),
    "cycloidal.ply": (1, 43368),
    "robot_franka_panda.obj": (58, 134854),
    "muon-1.obj": (3649, 61548),
    "two_objects_mixed_case_names.stl": (2, 24),
    "horse_big_endian.ply": (1, 96966),
    "cube_gears_prod.3mf": (17, 25692),
}


@unittest.skipUnless(MODELS, f"there are no models in {DATA}")
class SharedData(FileTest):
    def test_every_model_is_read(self):
        for path in MODELS:
            with self.subTest(model=path.name):
                told = info(path)
                counts = (told["parts"], told["triangles"])
                self.assertEqual(counts, COUNTS.get(path.name, counts))
                self.assertGreater(told["triangles"], 0)

    def test_models_are_seen_through_exactly(self):
        for path in MODELS:
            if path.name in COMPARED:
                with self.subTest(model=path.name):
                    row = compare(
                        path,
                        "--opacity",
                        "0.3",
                        "--methods",
                        "linked-list",
                        "--frames",
                        "1",
                        "--size",
                        "160x160",
                    )["results"][0]
                    self.assertLessEqual(row["error"]["max"], 1.0 / 255.0)
                    self.assertIs(row["deterministic"], True)
                    self.assertGreater(row["layers_max"], 1)

    def test_a_tolerance_ends_the_flicker_of_mating_faces(self):
        model = DATA / "assemblies" / "ldraw_car.glb"
        moved = {}
        for tolerance in ((), ("--coincidence", "16,0.01")):
            result = run(
                *("stability", model, "--opacity", "0.3", "--size", "160x160", "--quick"),
                *("--methods", "linked-list", "--json", "-", *tolerance),
            )
            self.assert_done(result)
            row = json.loads(result.stdout)["results"][0]
            self.assertEqual(row["outcome"], "exact")
            moved[tolerance] = row["shift"]
        without, within = moved.values()
        for figure in ("changed_pixels", "truth_changed_pixels"):
            self.assertGreater(without[figure], 0.02)
            self.assertLess(within[figure], 0.25 * without[figure])

    def test_a_tolerance_changes_nothing_but_what_coincides(self):
        model = DATA / "assemblies" / "ldraw_car.glb"
        truth, changes = (self.changes_by_a_tolerance(model, m) for m in ("truth", "linked-list"))
        self.assertLess(sum(map(bool, truth)), 0.15 * len(truth))
        self.assertGreater(sum(map(bool, truth)), 0)
        # What truth changes by less than a step may be a step when it is rounded.
        self.assertLessEqual(max(map(int.__sub__, changes, truth)), 1)

    def changes_by_a_tolerance(self, model, method):
        """The change of each value of the picture, in steps of 1/255."""
        values = []
        for tolerance in ((), ("--coincidence", "16,0.01")):
            path = self.folder / "picture.png"
            self.assert_done(
                run(
                    *("render", model, "--opacity", "0.3", "--size", "160x160"),
                    *("--method", method, "-o", path, *tolerance),
                )
            )
            values.append(b"".join(map(bytes, read_png(path)[2])))
        return [abs(a - b) for a, b in zip(*values)]


if __name__ == "__main__":
    unittest.main()
