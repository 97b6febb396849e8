"""vitrine.testing.assert_image(): what it takes, what it lets pass, and what it leaves."""

import contextlib
import os
import pathlib
import re
import tempfile
import unittest
import unittest.mock

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

import vitrine.testing
from scenes import plate, plates_renderer, window_with
from vitrine.testing import assert_image

DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / "docs/reference/image-tests.md"


def grey(value=100, shape=(30, 40, 3)):
    return numpy.full(shape, value, dtype=numpy.uint8)


def with_one_step():
    picture = grey()
    picture[2, 3, 1] += 1
    return picture


def read_png(file):
    """Rows from the top."""
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


class AssertImage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.baseline = self.folder / "grey.png"
        self.output = self.folder / "output"
        self.enterContext(self.environment(VITRINE_TEST_OUTPUT=str(self.output)))
        with self.environment(VITRINE_UPDATE_BASELINES="1"):
            assert_image(grey(), self.baseline)

    @contextlib.contextmanager
    def environment(self, **changes):
        before = {name: os.environ.get(name) for name in changes}
        os.environ.update(changes)
        try:
            yield
        finally:
            for name, value in before.items():
                os.environ.pop(name) if value is None else os.environ.update({name: value})

    def files(self):
        return sorted(str(file.relative_to(self.output)) for file in self.output.rglob("*.png"))

    def test_the_same_picture_passes_and_leaves_nothing(self):
        assert_image(grey(), self.baseline)
        self.assertFalse(self.output.exists())

    def test_one_step_in_one_pixel_fails_and_leaves_pictures(self):
        with self.assertRaisesRegex(AssertionError, "1 of 1200 pixels differ") as raised:
            assert_image(with_one_step(), self.baseline)
        self.assertIn("pixel 3, 2 from the top left: picture 100 101 100 255", str(raised.exception))
        self.assertEqual(
            self.files(), [f"grey/{name}.png" for name in ("difference", "flip", "picture")]
        )
        for name in self.files():
            self.assertIn(str(self.output / name), str(raised.exception))
        numpy.testing.assert_array_equal(read_png(self.output / "grey/picture.png"), with_one_step())

    def test_tolerances(self):
        assert_image(grey(101), self.baseline, tolerance=1)
        with self.assertRaises(AssertionError):
            assert_image(grey(102), self.baseline, tolerance=1)
        assert_image(with_one_step(), self.baseline, share=1 / 1200)
        assert_image(grey(101), self.baseline, tolerance=1, flip=0.5)
        with self.assertRaisesRegex(AssertionError, "FLIP"):
            assert_image(grey(130), self.baseline, tolerance=30, flip=1e-4)

    def test_any_of_several_baselines_does(self):
        other = self.folder / "other.png"
        with self.environment(VITRINE_UPDATE_BASELINES="1"):
            assert_image(grey(7), other)
        assert_image(grey(), [other, self.baseline])
        with self.assertRaisesRegex(AssertionError, "is not closer"):
            assert_image(grey(50), [other, self.baseline])

    def test_updates_the_first_baseline_where_none_matches(self):
        new = self.folder / "new/one.png"
        with self.assertRaisesRegex(AssertionError, "VITRINE_UPDATE_BASELINES=1"):
            assert_image(grey(3), new)
        self.assertEqual(self.files(), ["one/picture.png"])
        with self.environment(VITRINE_UPDATE_BASELINES="1"):
            assert_image(grey(), [new, self.baseline])
            self.assertFalse(new.exists(), "one of them matches")
            assert_image(grey(3), [new, self.baseline])
        assert_image(grey(3), new)
        assert_image(grey(), self.baseline)

    def test_updates_where_cmake_would(self):
        for value in ("1", "ON", "yes", "True", "y", "2"):
            with self.subTest(value), self.environment(VITRINE_UPDATE_BASELINES=value):
                assert_image(grey(len(value)), self.folder / f"{value}.png")
        for value in ("", "0", "OFF", "no", "False", "n", "IGNORE", "NOTFOUND", "0.0", "other"):
            with self.subTest(value), self.environment(VITRINE_UPDATE_BASELINES=value):
                with self.assertRaises(AssertionError):
                    assert_image(grey(3), self.baseline)
        assert_image(grey(), self.baseline)

    def test_raises_where_the_program_does_not_end_as_it_should(self):
        program = self.folder / "vitrine"
        for last_words, said in (
            ("kill -SEGV $$", "status -11"),
            ("kill -9 $$", "status -9"),
            ("echo no such library >&2; exit 127", "status 127: no such library"),
        ):
            program.write_text(f"#!/bin/sh\n{last_words}\n")
            program.chmod(0o755)
            with self.subTest(last_words), unittest.mock.patch.object(
                vitrine.testing._main, "program", lambda: program
            ):
                with self.assertRaisesRegex(RuntimeError, said):
                    assert_image(grey(), self.baseline)

    def test_takes_arrays_of_any_strides_and_channels(self):
        picture = numpy.random.default_rng(7).integers(0, 256, (20, 30, 4), dtype=numpy.uint8)
        for name, view in (
            ("rgba", picture), ("rgb", picture[..., :3]), ("grey", picture[..., 0]),
            ("turned", picture[::-1, ::2, :3]),
        ):  # fmt: skip
            with self.subTest(name), self.environment(VITRINE_UPDATE_BASELINES="1"):
                file = self.folder / f"{name}.png"
                assert_image(view, file)
                numpy.testing.assert_array_equal(numpy.squeeze(read_png(file)), view)

    def test_takes_windows_images_and_files(self):
        window = window_with(plates_renderer(plate(0, (1, 0, 0), 1.0)), size=(40, 30))
        red = self.folder / "red.png"
        with self.environment(VITRINE_UPDATE_BASELINES="1"):
            assert_image(window, red)
        numpy.testing.assert_array_equal(read_png(red)[5, 5], (255, 0, 0))
        assert_image(window, red)
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(window)
        grabber.Update()
        assert_image(grabber.GetOutput(), red)
        assert_image(red, red)
        with self.assertRaises(AssertionError):
            assert_image(str(red), self.baseline)

    def test_refuses_what_is_no_picture(self):
        for bad in (None, 3, "", [1, 2], grey().astype(float), grey(shape=(3, 4, 2)), b"bytes"):
            with self.subTest(repr(bad)[:20]), self.assertRaises((TypeError, ValueError)):
                assert_image(bad, self.baseline)
        with self.assertRaisesRegex(ValueError, "without pixels"):
            assert_image(grey(shape=(0, 4, 3)), self.baseline)
        for option in ({"tolerance": 256}, {"tolerance": -1}, {"share": 1.5}, {"flip": -1.0}):
            with self.subTest(option), self.assertRaisesRegex(ValueError, f"--{list(option)[0]}"):
                assert_image(grey(), self.baseline, **option)
        with self.assertRaises(ValueError):
            assert_image(grey(), [])
        with self.assertRaisesRegex(ValueError, "no whole PNG"):
            self.baseline.write_bytes(b"no picture")
            assert_image(grey(), self.baseline)

    def test_pytests_tests_have_folders_of_their_own(self):
        with self.environment(PYTEST_CURRENT_TEST="tests/test_a.py::test_b[1/2] (call)"):
            with self.assertRaises(AssertionError):
                assert_image(grey(3), self.baseline)
        self.assertIn("test_a.py-test_b-1-2-grey/picture.png", self.files())

    def test_what_is_documented(self):
        """The code of docs/reference/image-tests.md, in an empty folder: it makes its baseline first."""
        blocks = re.findall(r"^```python\n(.*?)^```", DOCUMENT.read_text(), re.M | re.S)
        self.assertGreater(len(blocks), 0)
        with contextlib.chdir(self.folder):
            for value in ("1", "0"):
                with self.environment(VITRINE_UPDATE_BASELINES=value):
                    names = {}
                    exec("\n".join(blocks), names)  # noqa: S102
                    for name, test in names.items():
                        if name.startswith("test_"):
                            test()
        self.assertGreater(len(list(self.folder.glob("baselines/*.png"))), 0)


class Program(unittest.TestCase):
    def test_is_found(self):
        self.assertTrue(os.access(vitrine.testing._main.program(), os.X_OK))


if __name__ == "__main__":
    unittest.main()
