"""vitrine_add_image_test() of the installed package, as a project that is not Vitrine's has it."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from program import png, read_png

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = (16, 12)

PROJECT = """\
cmake_minimum_required(VERSION 3.18)
project(Pictures LANGUAGES C CXX)
enable_testing()
find_package(Vitrine REQUIRED)
add_executable(draw draw.c)
set(copy "${CMAKE_COMMAND}" -E copy)
"""

# A program that copies a picture, if its other arguments came as they were written.
DRAW = r"""
#include <stdio.h>
#include <string.h>
int main(int count, char** arguments)
{
  FILE* from = count == 4 ? fopen(arguments[1], "rb") : NULL;
  FILE* to = count == 4 ? fopen(arguments[2], "wb") : NULL;
  if (!from || !to || strcmp(arguments[3], "a;b [c] \"d\" $e"))
    return 3;
  for (int byte = fgetc(from); byte != EOF; byte = fgetc(from))
    fputc(byte, to);
  return 0;
}
"""


def plain(color, size=SIZE):
    return [[(color, color, color)] * size[0] for _ in range(size[1])]


class ImageTests(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.build = self.folder / "build"

    def write(self, name, rows):
        (self.folder / name).write_bytes(png(rows))

    def configure(self, project):
        (self.folder / "CMakeLists.txt").write_text(project)
        return subprocess.run(
            ["cmake", "-S", self.folder, "-B", self.build, "-G", os.environ["GENERATOR"],
             f"-DCMAKE_PREFIX_PATH={os.environ['PREFIX']}", f"-DVTK_DIR={os.environ['VTK_DIR']}"],
            capture_output=True, text=True, check=False,
        )  # fmt: skip

    def make(self, project):
        done = self.configure(project)
        self.assertEqual(done.returncode, 0, done.stderr)
        subprocess.run(["cmake", "--build", self.build], capture_output=True, check=True)

    def ctest(self, *arguments, **environment):
        """What CTest prints, and which tests passed."""
        done = subprocess.run(
            ["ctest", "--test-dir", self.build, "--verbose", *arguments],
            env={**os.environ, **environment},
            capture_output=True,
            text=True,
            check=False,
        )
        verdicts = re.findall(r"Test +#\d+: (\S+) \.+ *(Passed|\*\*\*Failed)", done.stdout)
        return done.stdout, {name: verdict == "Passed" for name, verdict in verdicts}

    def test_pass_and_fail(self):
        self.write("grey.png", plain(100))
        self.write("lighter.png", plain(101))
        self.write("black.png", plain(0))
        one_step, one_pixel = plain(100), plain(100)
        one_step[1][2] = (100, 101, 100)
        one_pixel[3][4] = (255, 0, 0)
        self.write("one-step.png", one_step)
        self.write("one-pixel.png", one_pixel)
        (self.folder / "draw.c").write_text(DRAW)
        source = "${CMAKE_SOURCE_DIR}"
        tests = {
            "same": ("${copy} %s/grey.png {output} BASELINE grey.png", True),
            "step": ("${copy} %s/one-step.png {output} BASELINE grey.png", False),
            "step.tolerated": ("${copy} %s/one-step.png {output} BASELINE grey.png TOLERANCE 1", True),
            "uniform": ("${copy} %s/lighter.png {output} BASELINE grey.png", False),
            "uniform.tolerated": ("${copy} %s/lighter.png {output} BASELINE grey.png TOLERANCE 1", True),
            "pixel": ("${copy} %s/one-pixel.png {output} BASELINE grey.png TOLERANCE 99", False),
            "pixel.share": ("${copy} %s/one-pixel.png {output} BASELINE grey.png SHARE 0.006", True),
            "flip": ("${copy} %s/black.png {output} BASELINE grey.png TOLERANCE 100 FLIP 0.1", False),
            "flip.tolerated": ("${copy} %s/black.png {output} BASELINE grey.png TOLERANCE 100 FLIP 1", True),
            "several": ("${copy} %s/grey.png {output} BASELINE none.png black.png grey.png", True),
            "several.none": ("${copy} %s/grey.png {output} BASELINE none.png black.png lighter.png", False),
            "missing": ("${copy} %s/grey.png {output} BASELINE none.png", False),
            "output": ("${copy} %s/grey.png ${CMAKE_BINARY_DIR}/shot.png BASELINE grey.png OUTPUT shot.png", True),
            "target": ('draw %s/grey.png {output} "a\\;b [c] \\"d\\" \\$e" BASELINE grey.png', True),
            "no-picture": ("${CMAKE_COMMAND} -E true BASELINE grey.png", False),
            "broken": ("${CMAKE_COMMAND} -E false BASELINE grey.png", False),
            "unreadable": ("${copy} %s/draw.c {output} BASELINE grey.png", False),
        }  # fmt: skip
        self.make(
            PROJECT
            + "".join(
                f"vitrine_add_image_test(NAME {name} COMMAND {words.replace('%s', source)})\n"
                for name, (words, _) in tests.items()
            )
        )
        said, passed = self.ctest()
        self.assertEqual(passed, {name: passes for name, (_, passes) in tests.items()}, said)
        for words in (
            "pixel 2, 1 from the top left: picture 100 101 100 255, baseline 100 100 100 255",
            "image-tests/step/difference.png",
            "image-tests/step/flip.png",
            "black.png is not closer: 192 pixels differ",
            "none.png is not closer: no such file",
            "VITRINE_UPDATE_BASELINES=1",
            "has not written",
            "the command that draws the picture failed",
            "unreadable: `vitrine diff` could not compare",
        ):
            self.assertIn(words, re.sub(r"\s+", " ", said))
        self.assertNotIn("unreadable/picture.png matches no baseline", re.sub(r"\s+", " ", said))
        left = {path.name for path in (self.build / "image-tests/step").iterdir()}
        self.assertEqual(left, {"picture.png", "difference.png", "flip.png"})
        left = {path.name for path in (self.build / "image-tests/same").iterdir()}
        self.assertEqual(left, {"picture.png"})

        elsewhere = self.folder / "elsewhere"
        self.ctest("-R", "^step$", VITRINE_TEST_OUTPUT=str(elsewhere))
        left = {path.name for path in (elsewhere / "step").iterdir()}
        self.assertEqual(left, {"picture.png", "difference.png", "flip.png"})

    def test_one_step_of_a_baseline_of_this_project(self):
        """One grey level in one pixel of a picture of a scene fails."""
        width, height, rows = read_png(ROOT / "Testing/Baselines/stack.png")
        rows = [list(zip(row[0::3], row[1::3], row[2::3])) for row in rows]
        rows[height // 2][width // 2] = tuple(value - 1 for value in rows[height // 2][width // 2])
        self.write("changed.png", rows)
        shutil.copy(ROOT / "Testing/Baselines/stack.png", self.folder / "stack.png")
        test = "COMMAND ${copy} ${CMAKE_SOURCE_DIR}/changed.png {output} BASELINE stack.png"
        self.make(
            PROJECT.replace("add_executable(draw draw.c)\n", "")
            + f"vitrine_add_image_test(NAME exact {test})\n"
            + f"vitrine_add_image_test(NAME tolerant {test} TOLERANCE 1)\n"
        )
        said, passed = self.ctest()
        self.assertEqual(passed, {"exact": False, "tolerant": True}, said)
        self.assertIn(f"1 of {width * height} pixels differ, and the largest difference is 1/255", said)

    def test_what_is_documented(self):
        """The project of docs/reference/image-tests.md: its baseline is made, and then compared with."""
        text = (ROOT / "docs/reference/image-tests.md").read_text()
        (project,) = re.findall(r"^```cmake\n(.*?)^```", text, re.M | re.S)
        self.make(project)
        said, passed = self.ctest()
        self.assertEqual(passed, {"stack": False}, said)
        said, passed = self.ctest(VITRINE_UPDATE_BASELINES="1")
        self.assertEqual(passed, {"stack": True}, said)
        self.assertEqual(read_png(self.folder / "baselines/stack.png")[:2], (120, 90))
        said, passed = self.ctest()
        self.assertEqual(passed, {"stack": True}, said)

    def test_wrong_calls_are_refused(self):
        head = PROJECT.replace("add_executable(draw draw.c)\n", "")
        for call, words in (
            ("NAME a BASELINE b.png", "COMMAND is missing"),
            ("NAME a COMMAND b", "BASELINE is missing"),
            ("COMMAND b BASELINE c.png", "NAME is missing"),
            ("NAME a COMMAND b BASELINE c.png TOLERANCE 1 2", "unknown arguments: 2"),
        ):
            with self.subTest(call):
                done = self.configure(f"{head}vitrine_add_image_test({call})\n")
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(words, re.sub(r"\s+", " ", done.stderr))


if __name__ == "__main__":
    unittest.main()
