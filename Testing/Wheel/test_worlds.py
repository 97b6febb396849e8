"""The same scenes in both worlds: PyPI's VTK of this environment, and the VTK of VITRINE_OTHER_PROGRAM."""

import json
import os
import pathlib
import tempfile
import unittest

import numpy
from PIL import Image
from wheel import PROGRAM, run

OTHER = os.environ["VITRINE_OTHER_PROGRAM"]
SIZE = ["--size", "200x150"]
# What both VTKs shade alike: ambient light, which the assembly has, is brighter in VTK 9.6.
SCENES = ["demo:stack,layers=16,alpha=0.2", "demo:spheres,layers=16"]


def render(program, scene, method):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "picture.png")
        said = run(program, "render", scene, "--method", method, *SIZE, "-o", file)
        assert said.returncode == 0, said.stderr
        return numpy.asarray(Image.open(file)).astype(int)


def errors(program, scene):
    said = run(
        program,
        "compare",
        scene,
        "--methods",
        "linked-list,linked-list-8bit",
        *SIZE,
        "--frames",
        "2",
        "--json",
        "-",
    )
    assert said.returncode == 0, said.stderr
    return {row["method"]: row for row in json.loads(said.stdout)["results"]}


class Worlds(unittest.TestCase):
    def test_draw_the_same_pictures(self):
        for scene in SCENES:
            for method in ("truth", "linked-list", "vtk-peeling"):
                with self.subTest(scene=scene, method=method):
                    difference = abs(render(PROGRAM, scene, method) - render(OTHER, scene, method))
                    self.assertLessEqual(difference.max(), 1)

    def test_are_exact_by_their_own_truth(self):
        for scene in [*SCENES, "demo:assembly,parts=300"]:
            for program in (PROGRAM, OTHER):
                with self.subTest(scene=scene, program=program):
                    row = errors(program, scene)["linked-list"]
                    self.assertLessEqual(row["error"]["max"], 1 / 255)
                    self.assertTrue(row["deterministic"])
                    self.assertGreater(row["fragments"], 0)


if __name__ == "__main__":
    unittest.main()
