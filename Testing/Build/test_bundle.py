"""scripts/bundle-gpu: the archive runs its suite within a limit, and results become rows of tables."""

import json
import os
import pathlib
import subprocess
import tarfile
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUNDLE = ROOT / "scripts" / "bundle-gpu"
BUILD = pathlib.Path(os.environ["VITRINE_BUILD"])
LIMIT = 30  # seconds of the suite: for its first steps alone


def bundle(*arguments):
    return subprocess.run(
        [BUNDLE, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def words_of(line):
    return [cell.strip() for cell in line.strip("|").split("|")]


class Bundle(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        manager = tempfile.TemporaryDirectory()
        folder = pathlib.Path(manager.__enter__())
        cls.addClassCleanup(manager.__exit__, None, None, None)
        packed = bundle("--quick", BUILD, folder / "gpu.tar.xz")
        if packed.returncode != 0:
            raise AssertionError(packed.stderr)
        with tarfile.open(folder / "gpu.tar.xz") as archive:
            archive.extractall(folder)
        cls.unpacked = folder / "vitrine-gpu"
        cls.results = folder / "results"
        cls.suite = subprocess.run(
            [cls.unpacked / "run-suite.sh", cls.results, str(LIMIT)],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=20 * LIMIT,
        )

    def test_brings_libraries_but_neither_glibc_nor_drivers(self):
        names = {path.name for path in self.unpacked.rglob("*")}
        for needed in ("libvtkVitrineRendering.so.1", "libEGL.so.1", "libstdc++.so.6"):
            self.assertIn(needed, names)
        for name in names:
            self.assertNotRegex(name, r"^libc\.so|^ld-linux|_dri\.so|^libEGL_")
        programs = (self.unpacked / "shaders" / "programs").read_text().splitlines()
        self.assertEqual(len(programs), len({*programs}))
        for line in programs:
            for name in line.split():
                self.assertTrue((self.unpacked / "shaders" / name).stat().st_size)

    def test_suite_ends_and_says_what_it_did(self):
        self.assertEqual(self.suite.returncode, 0, self.suite.stdout)
        log = (self.results / "log.txt").read_text()
        self.assertEqual(log, self.suite.stdout)
        self.assertIn("device: status 0", log)
        self.assertIn("left out, no time", log)
        self.assertIn("GL_RENDERER", (self.results / "device.txt").read_text())
        for path in self.results.glob("*.json"):
            json.loads(path.read_text())

    def test_results_become_rows(self):
        told = bundle("--table", self.results)
        self.assertEqual(told.returncode, 0, told.stderr)
        lines = told.stdout.splitlines()
        place = lines.index("Devices")
        head, row = words_of(lines[place + 2]), words_of(lines[place + 4])
        self.assertEqual(len(head), len(row))
        exact = [json.loads(path.read_text()) for path in self.results.glob("exact*.json")]
        renderer = exact[0]["device"]["renderer"]
        self.assertEqual(row[0], renderer)
        # A slow machine is cut off before the first error is known.
        is_measured = any(row.get("error") for document in exact for row in document["results"])
        self.assertEqual(f"Errors on {renderer}" in lines, is_measured)

    def test_refuses_what_it_cannot_do(self):
        for arguments, word in (
            ((), "bundle-gpu"),
            (("--table", self.unpacked / "lib"), "no results"),
            ((self.unpacked / "lib", "x.tar.xz"), "no "),
            (("x.zip",), "OUT.tar.xz"),
        ):
            refused = bundle(*arguments)
            self.assertEqual(refused.returncode, 2)
            self.assertIn(word, refused.stderr)
            self.assertNotIn("Traceback", refused.stderr)


if __name__ == "__main__":
    unittest.main()
