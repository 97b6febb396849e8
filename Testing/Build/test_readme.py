"""README.md and the C++ tutorial: what stands in their blocks of code runs, but for the lines that are named here."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = os.environ.get("VITRINE_BUILD")
GENERATOR = os.environ.get("VITRINE_GENERATOR")
TUTORIAL = "docs/tutorial/first-window-cpp.md"

# Of shells, without their comments. test_pyvista.py runs the blocks of Python, in the world that has PyVista.
NOT_RUN = {
    "scripts/demo": "it asks for packages of Debian; test_demo_scenes.py runs what it draws",
    "scripts/test": "it is what runs this test",
}


def all_blocks(page):
    """The blocks of a page: language and text."""
    text = (ROOT / page).read_text(encoding="utf-8")
    return re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def joined(page, language):
    return "".join(text for other, text in all_blocks(page) if other == language)


def commands(text):
    """The lines for a shell, without comments and columns."""
    lines = (" ".join(re.sub(r"\s#.*", "", line).split()) for line in text.splitlines())
    return [line for line in lines if line]


class Readme(unittest.TestCase):
    def test_has_no_commands_but_those_that_are_named(self):
        self.assertEqual(commands(joined("README.md", "sh")), list(NOT_RUN))

    def test_has_no_other_languages(self):
        languages = {language for language, _ in all_blocks("README.md")}
        self.assertEqual(languages, {"console", "python", "sh"})


@unittest.skipUnless(BUILD, "VITRINE_BUILD names no build tree")
class Tutorial(unittest.TestCase):
    """In a folder of its own, with a package that is installed as the tutorial says."""

    def test_is_a_program(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "CMakeLists.txt").write_text(joined(TUTORIAL, "cmake"), encoding="utf-8")
            (folder / "main.cxx").write_text(joined(TUTORIAL, "cpp"), encoding="utf-8")
            prefix = folder / "vitrine"
            self.run_command(folder, "cmake", "--install", BUILD, "--prefix", prefix)
            self.assertTrue((prefix / "include/vitrine/vtkSeeThroughPass.h").exists())
            self.run_command(
                folder, "cmake", "-S", ".", "-B", "build", "-G", GENERATOR, f"-DCMAKE_PREFIX_PATH={prefix}"
            )
            self.run_command(folder, "cmake", "--build", "build")
            self.assertEqual(self.run_command(folder, "build/glass").strip(), "drawn exactly")
            signature = (folder / "glass.png").read_bytes()[:8]
            self.assertEqual(signature, b"\x89PNG\r\n\x1a\n")

    def run_command(self, folder, *command):
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        done = subprocess.run(
            command, cwd=folder, env=environment, capture_output=True, text=True, check=False
        )
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}\n{done.stderr}")
        return done.stdout


if __name__ == "__main__":
    unittest.main()
