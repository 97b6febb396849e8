"""Runs that are cut off leave what they measured: their JSON is whole at each moment."""

import json
import subprocess
import unittest

from program import PROGRAM, FileTest, environment_without_display

ENDLESS = "100000"  # frames, or poses
# Arguments, and what a row has as soon as it was measured once.
COMMANDS = (
    (
        ("compare", "demo:spheres,layers=4", "--methods", "vtk-oit,linked-list", "--frames", ENDLESS,
         "--stages"),
        "frame_ms",
    ),
    (("lights", "demo:hall,lights=8", "--modes", "loop,clustered", "--frames", ENDLESS), "frame_ms"),
    (("cull", "demo:assembly,parts=20", "--poses", ENDLESS, "--without-ideal"), "poses"),
)  # fmt: skip


class CutOff(FileTest):
    def documents(self, path, process):
        """What the file holds, again and again while the program runs. Each time it has to be JSON."""
        while process.poll() is None:
            if path.exists():
                yield json.loads(path.read_text())

    def measure_once(self, path, process, key):
        for document in self.documents(path, process):
            if document["results"] and all(key in row for row in document["results"]):
                return document
        raise AssertionError(f"the program ended: {process.stderr.read()}")

    def test_leaves_what_was_measured(self):
        for arguments, key in COMMANDS:
            with self.subTest(command=arguments[0]):
                path = self.folder / f"{arguments[0]}.json"
                with subprocess.Popen(
                    [PROGRAM, *arguments, "--size", "40x30", "--json", str(path)],
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.PIPE,
                    env=environment_without_display(),
                ) as process:
                    try:
                        before = self.measure_once(path, process, key)
                    finally:
                        process.kill()
                left = json.loads(path.read_text())
                self.assertTrue(left["unfinished"])
                self.assertTrue(left["device"]["renderer"])
                self.assertEqual(left["settings"], before["settings"])
                self.assertEqual(len(left["results"]), len(before["results"]))
                for row in left["results"]:
                    self.assertIn(key, row)


if __name__ == "__main__":
    unittest.main()
