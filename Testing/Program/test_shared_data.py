"""Real models, where they are: VITRINE_SHARED_DATA, or ../shared/data beside the project."""

import os
import pathlib
import unittest

from program import ProgramTest, compare, info

PROJECT = pathlib.Path(__file__).resolve().parents[2]
DATA = pathlib.Path(os.environ.get("VITRINE_SHARED_DATA", PROJECT.parent / "shared" / "data"))
KINDS = {".glb", ".obj", ".stl", ".ply"}
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
}


@unittest.skipUnless(MODELS, f"there are no models in {DATA}")
class SharedData(ProgramTest):
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


if __name__ == "__main__":
    unittest.main()
