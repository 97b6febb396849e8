"""README.md: what stands in its blocks of code runs, but for the lines that are named here with the reason."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = os.environ.get("VITRINE_BUILD")
GENERATOR = os.environ.get("VITRINE_GENERATOR")

# Of shells, without their comments. test_pyvista.py runs the blocks of Python, in the world that has PyVista.
NOT_RUN = {
    "pip install '.[pyvista]'": "it asks for packages of PyPI; scripts/test-wheel begins with it",
    "scripts/demo": "it asks for packages of Debian; test_demo_scenes.py runs what it draws",
    "scripts/test": "it is what runs this test",
    "cmake --preset release && cmake --build --preset release": "it makes the tree of this test",
    "vitrine diff got.png baseline.png": "it takes two pictures; test_diff.py runs it",
    "vitrine view assembly.glb": "it takes a display; test_view.py runs what does not",
    "vitrine chart assembly.glb --opacity 0.3 --out chart": "it takes long; test_chart.py runs less",
    "vitrine stability": "it takes long; test_stability.py runs it in parts",
    "vitrine sorts": "it takes long; test_sorts.py runs it with shorter lists",
    "vitrine paper": "it takes long; test_paper.py runs it in parts",
}

PROGRAM = """\
{includes}
#include <vtkActor.h>
#include <vtkInteractorStyle.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextRenderer.h>
#include <vtkTransparencyPass.h>

#include <iostream>

void AddSphere(vtkRenderer* renderer, double radius, double opacity)
{{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
}}

int main()
{{
{before_windows}
  vtkNew<vtkRenderer> renderer;
  AddSphere(renderer, 0.2, 1.0);
  AddSphere(renderer, 0.4, 1.0);
  AddSphere(renderer, 0.6, 0.5);
{statements}
  vtkNew<vtkRenderWindow> window;
  window->SetSize(60, 40);
  window->AddRenderer(renderer);
  window->Render();
  auto* pass = vtkTransparencyPass::SafeDownCast(seeThrough->GetTranslucentPass());
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkInteractorObserver* style = interactor->GetInteractorStyle();
  std::cout << pass->GetNumberOfFragments() << " " << culler->GetNumberOfCulledParts() << " "
            << (vtkTextRenderer::GetInstance() ? "text" : "no text") << " "
            << (style ? style->GetClassName() : "no style") << std::endl;
  return 0;
}}
"""

PROJECT = """\
cmake_minimum_required(VERSION 3.16...3.25)
project(Readme LANGUAGES C CXX)
set(CMAKE_CXX_STANDARD 17)
add_executable(app main.cxx)
{statements}
"""


def all_blocks():
    """The blocks of README.md: language, which is empty for shells, and text."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def blocks(language):
    return [text for other, text in all_blocks() if other == language]


def commands(block):
    """The lines of a block for a shell, without comments and columns."""
    lines = (" ".join(re.sub(r"\s#.*", "", line).split()) for line in block.splitlines())
    return [line for line in lines if line]


def program():
    """One program of all blocks. The one that must come before the first window says so by its class."""
    lines = [line for block in blocks("cpp") for line in block.splitlines()]
    before = [line for line in lines if line.startswith("vtkHeadlessRenderWindow::")]
    includes = [line for line in lines if line.startswith("#include")]
    rest = [line for line in lines if line not in before + includes]
    return PROGRAM.format(
        includes="\n".join(includes), before_windows="\n".join(before), statements="\n".join(rest)
    )


class Lists(unittest.TestCase):
    def test_name_lines_of_readme(self):
        there = [command for block in blocks("") for command in commands(block)]
        self.assertEqual([line for line in NOT_RUN if line not in there], [])

    def test_leave_out_no_language(self):
        self.assertEqual({language for language, _ in all_blocks()}, {"", "cmake", "cpp", "python"})


@unittest.skipUnless(BUILD, "VITRINE_BUILD names no build tree")
class Blocks(unittest.TestCase):
    """In a new home, where build/release is the tree that is tested and assembly.glb a small scene."""

    @classmethod
    def setUpClass(cls):
        cls.home = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        (cls.home / "build").mkdir()
        (cls.home / "build/release").symlink_to(BUILD)
        sys.path.insert(0, str(ROOT / "Testing/Program"))
        import scenes

        (cls.home / "assembly.glb").write_bytes(scenes.glb())
        path = f"{cls.home}/vitrine/bin:{os.environ['PATH']}"
        cls.environment = {**os.environ, "HOME": str(cls.home), "PATH": path}
        cls.environment.pop("DISPLAY", None)
        for block in blocks(""):
            cls.run_shell(block)

    @classmethod
    def run_shell(cls, block):
        """Run a block. What it exports is there for those that follow."""
        lines = [command for command in commands(block) if command not in NOT_RUN]
        cls.run_command("bash", "-c", "\n".join(["set -e", *lines, "env -0 > exported"]))
        exported = (cls.home / "exported").read_text(encoding="utf-8").split("\0")
        cls.environment = dict(entry.split("=", 1) for entry in exported if entry)

    @classmethod
    def run_command(cls, *command):
        done = subprocess.run(
            command, cwd=cls.home, env=cls.environment, capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            raise AssertionError("\n".join([*command, done.stdout, done.stderr]))
        return done.stdout

    def test_of_shells_leave_what_they_say(self):
        signature = (self.home / "picture.png").read_bytes()[:8]
        self.assertEqual(signature, b"\x89PNG\r\n\x1a\n")
        self.assertTrue((self.home / "vitrine/include/vitrine/vtkSeeThroughPass.h").exists())

    def test_of_cpp_and_cmake_are_a_program(self):
        project = self.home / "app"
        project.mkdir()
        (project / "main.cxx").write_text(program(), encoding="utf-8")
        (project / "CMakeLists.txt").write_text(
            PROJECT.format(statements="\n".join(blocks("cmake"))), encoding="utf-8"
        )
        self.run_command("cmake", "-S", "app", "-B", "app/build", "-G", GENERATOR)
        self.run_command("cmake", "--build", "app/build")
        said = self.run_command("app/build/app")
        self.assertRegex(said, r"^[1-9]\d* 1 text vtkInteractorStyleSwitch$")


if __name__ == "__main__":
    unittest.main()
