"""Tests cmake/ComposeShader.cmake: text that strict compilers of GLSL 1.50 take, with the author's line numbers."""

import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def compose(folder, name):
    """Return the text of a shader as the build composes it."""
    with tempfile.TemporaryDirectory() as scratch:
        output = Path(scratch) / "shader.cxx"
        subprocess.run(
            ["cmake", f"-DINPUT={name}", f"-DOUTPUT={output}", "-DSYMBOL=shader", f"-DFOLDERS={folder}"]
            + ["-P", ROOT / "cmake/ComposeShader.cmake"],
            check=True,
        )
        return re.search(r'R"glsl\((.*)\)glsl"', output.read_text(encoding="utf-8"), re.S)[1]


class ComposedShaders(unittest.TestCase):
    def test_have_no_continued_lines(self):
        for name in ["CoincidentGroup.glsl", "FragmentCapture.glsl", "ListResolve.glsl", "Registers.glsl"]:
            source = (ROOT / "Module/Shaders" / name).read_text(encoding="utf-8")
            self.assertIn("\\\n", source, name)
            self.assertNotIn("\\", compose(ROOT / "Module/Shaders", name), name)

    def test_keep_line_numbers(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "a.glsl").write_text("#define A(x) \\\n  x; \\\n  x[0]\nint fourth;\n", encoding="utf-8")
            lines = compose(folder, "a.glsl").split("\n")
        self.assertEqual(lines[1], "#line 1 1")
        self.assertEqual(lines[2], "#define A(x)   x;   x[0]")
        self.assertEqual(lines[2 + 3], "int fourth;")


if __name__ == "__main__":
    unittest.main()
