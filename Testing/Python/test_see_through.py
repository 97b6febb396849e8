"""vtkSeeThroughPass from Python: exact pictures, and no crash in whatever order things go."""

import itertools
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

from scenes import plate, plates_renderer, rendered, run_python
from vitrine import vtkSeeThroughPass

FRONT, FRONT_ALPHA = numpy.array([0.9, 0.2, 0.1]), 0.6
BACK, BACK_ALPHA = numpy.array([0.1, 0.3, 0.8]), 0.7
BACKGROUND = numpy.array([1.0, 1.0, 0.5])

# Porter and Duff's "over", front over back over background.
EXPECTED = FRONT_ALPHA * FRONT + (1 - FRONT_ALPHA) * (
    BACK_ALPHA * BACK + (1 - BACK_ALPHA) * BACKGROUND
)


def two_plates(front_first, opaque=False):
    plates = [
        plate(1.0, FRONT, 1.0 if opaque else FRONT_ALPHA),
        plate(-1.0, BACK, 1.0 if opaque else BACK_ALPHA),
    ]
    if not front_first:
        plates.reverse()
    renderer = plates_renderer(*plates, background=BACKGROUND)
    renderer.SetPass(vtkSeeThroughPass())
    return renderer


class Picture(unittest.TestCase):
    def test_equals_the_closed_form_in_either_order(self):
        for front_first in (True, False):
            for multisamples in (0, 4):
                with self.subTest(front_first=front_first, multisamples=multisamples):
                    picture = rendered(two_plates(front_first), multisamples=multisamples)
                    error = numpy.abs(picture[..., :3] / 255.0 - EXPECTED).max()
                    self.assertLessEqual(error, 1 / 255)

    def test_differs_from_the_opaque_one(self):
        opaque = rendered(two_plates(True, opaque=True))
        self.assertLessEqual(numpy.abs(opaque[..., :3] / 255.0 - FRONT).max(), 0.5 / 255 + 1e-6)
        translucent = rendered(two_plates(True))
        self.assertTrue((translucent[..., :3] != opaque[..., :3]).any(axis=-1).all())

    def test_stays_the_same_without_the_pass_for_opaque_plates(self):
        plain = plates_renderer(plate(1.0, FRONT, 1.0), background=BACKGROUND)
        through = plates_renderer(plate(1.0, FRONT, 1.0), background=BACKGROUND)
        through.SetPass(vtkSeeThroughPass())
        numpy.testing.assert_array_equal(rendered(through), rendered(plain))


class Lifetime(unittest.TestCase):
    """Each program draws, then lets go of what it holds; the interpreter has to end in peace."""

    SETUP = """
from scenes import cone_renderer, window_with
from vitrine import vtkSeeThroughPass
renderer = cone_renderer(opacity=0.5)
see_through = vtkSeeThroughPass()
renderer.SetPass(see_through)
window = window_with(renderer)
window.Render()
"""

    def assert_ends_in_peace(self, program):
        result = run_python(self.SETUP + program)
        self.assertEqual(result.returncode, 0, program + result.stderr)
        self.assertEqual(result.stderr, "", program)

    def test_ends_while_everything_is_alive(self):
        self.assert_ends_in_peace("")

    def test_lets_go_in_any_order(self):
        for order in itertools.permutations(("renderer", "see_through", "window")):
            with self.subTest(order=order):
                self.assert_ends_in_peace("".join(f"del {name}\n" for name in order))

    def test_changes_its_mind(self):
        self.assert_ends_in_peace(
            "renderer.SetPass(None)\nwindow.Render()\n"
            "renderer.SetPass(see_through)\nwindow.Render()\n"
            "window.Finalize()\nwindow.Render()\n"
            "see_through.ReleaseGraphicsResources(window)\nwindow.Render()\n"
            "window.RemoveRenderer(renderer)\nwindow.Render()\n"
        )

    def test_ends_after_the_window_was_finalized(self):
        self.assert_ends_in_peace("window.Finalize()\n")


class Example(unittest.TestCase):
    def test_writes_its_picture(self):
        example = pathlib.Path(os.environ["VITRINE_EXAMPLES"]) / "see_through.py"
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "picture.png"
            result = subprocess.run(
                [sys.executable, "-B", str(example), str(picture)],
                capture_output=True,
                text=True,
                check=False,
            )
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn(str(picture), result.stdout)
            self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
