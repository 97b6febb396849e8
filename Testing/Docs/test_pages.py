"""Pages of docs: their style, their links, their pictures, and that each block of code runs.

A page's blocks run in one empty folder, in their order: first those of Python, as one program, then those of shells.
Those of CMake and C++ of a page are one project; pages without CMake share a project, with a program for each. A block
behind <!-- not run: reason --> is left out.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
PREFIX = os.environ.get("PREFIX")
IMAGES = DOCS / "images"
MOST_NOT_RUN = 12
MOST_BYTES = 300_000  # of a picture
BLOCK = re.compile(r"^(?:<!-- not run: ([^\n]+?) -->\n+)?```(\w+)\n(.*?)^```$", re.M | re.S)
IMAGE = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)")
SHELLS = ("sh", "console")

# Commands of consoles that other tests run, or that nothing may run here.
RUN_ELSEWHERE = {
    "python3 -m venv environment": "scripts/test-wheel begins with it",
    ". environment/bin/activate": "it comes after the line above",
    "pip install '.[pyvista]'": "scripts/test-wheel begins with it",
    "scripts/install-dependencies": "scripts/test begins with it",
    "scripts/install-dependencies --paraview": "scripts/test-paraview begins with it, in a root of its own",
    "cmake -S ParaView -B build/paraview -G Ninja": "scripts/test-paraview does so",
    "cmake --build build/paraview": "scripts/test-paraview does so",
    "cmake --preset release && cmake --build --preset release": "it makes the tree of this test",
    "cmake --install build/release --prefix ~/vitrine": "Build.InstalledPackage does so",
    "apt-get install openmpi-bin python3-mpi4py": "scripts/install-dependencies --test does so",
    "mpirun -np 4 python3 -m mpi4py script.py": "Testing/Ranks runs such scripts",
    "export PATH=~/vitrine/bin:$PATH": "the program of this tree is on PATH",
    "export CMAKE_PREFIX_PATH=~/vitrine": "Build.InstalledPackage does so",
    "export CMAKE_PREFIX_PATH=~/vitrine PYTHONPATH=~/vitrine/lib/python3/dist-packages": "see the line above",
    "cmake -S . -B build": "the page's C++ is built by this test",
    "cmake --build build": "the page's C++ is built by this test",
    "build/glass": "the page's C++ is built and run by this test",
    "cmake --preset fuzz && cmake --build --preset fuzz": "it takes minutes, and clang",
    "build/fuzz/Testing/Fuzz/FuzzCoverage -max_total_time=60 -seed=7": "it takes a minute",
}

PROJECT = """\
cmake_minimum_required(VERSION 3.16...3.25)
project(Pages LANGUAGES C CXX)
set(CMAKE_CXX_STANDARD 17)
find_package(Vitrine REQUIRED)
foreach (page IN ITEMS {pages})
  add_executable(${{page}} ${{page}}/main.cxx)
  target_link_libraries(${{page}} PRIVATE Vitrine::Rendering)
  vtk_module_autoinit(TARGETS ${{page}} MODULES Vitrine::Rendering)
endforeach ()
"""

MAIN = """\
#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
{includes}
int main()
{{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHeadlessRenderWindow> window;
  window->AddRenderer(renderer);
{statements}
  return 0;
}}
"""


def pages():
    return sorted(path for path in DOCS.rglob("*.md"))


def all_blocks(page):
    """(reason not to run, language, text) of each block."""
    return BLOCK.findall(page.read_text(encoding="utf-8"))


def blocks(page, *languages):
    return [text for reason, language, text in all_blocks(page) if language in languages and not reason]


def commands(block):
    """The lines of a shell's block. In one of a console they stand behind a prompt; the rest is output."""
    if not re.search(r"^[$#] ", block, re.M):
        return block
    prompted = (line[2:] for line in block.splitlines() if line.startswith("$ "))
    return "\n".join(line for line in prompted if line not in RUN_ELSEWHERE)


def main_of(texts):
    text = "".join(texts)
    if "int main(" in text:
        return text
    lines = text.splitlines()
    includes = [line for line in lines if line.startswith("#include")]
    statements = [line for line in lines if line not in includes]
    return MAIN.format(includes="\n".join(includes), statements="\n".join(statements))


def has_pyvista():
    return subprocess.run([sys.executable, "-c", "import pyvista"], capture_output=True, check=False).returncode == 0


class Style(unittest.TestCase):
    def test_is_kept_and_links_lead_somewhere(self):
        done = subprocess.run(
            [sys.executable, DOCS / "check_pages.py"], capture_output=True, text=True, check=False
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_few_blocks_are_not_run(self):
        reasons = [f"{page.name}: {reason}" for page in pages() for reason, _, _ in all_blocks(page) if reason]
        self.assertLessEqual(len(reasons), MOST_NOT_RUN, reasons)

    def test_commands_that_others_run_are_there(self):
        text = "\n".join(page.read_text(encoding="utf-8") for page in pages())
        self.assertEqual([command for command in RUN_ELSEWHERE if f"$ {command}\n" not in text], [])


class Pictures(unittest.TestCase):
    """Pictures of docs/images: pages show them, and docs/make-pictures makes them."""

    def make_pictures(self, *words):
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        command = [sys.executable, "-B", DOCS / "make-pictures", *words]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        return done.stdout

    def shown(self):
        """The files that pages show."""
        for page in [ROOT / "README.md", *pages()]:
            for address in IMAGE.findall(page.read_text(encoding="utf-8")):
                if "://" not in address:
                    yield (page.parent / address).resolve()

    def test_are_all_there_and_shown_and_made(self):
        shown = set(self.shown())
        self.assertEqual([str(path) for path in shown if not path.exists()], [])
        files = {path.name for path in IMAGES.iterdir()}
        self.assertEqual(files, {path.name for path in shown if path.parent == IMAGES})
        made = {line.split()[0] for line in self.make_pictures("--list").splitlines()}
        self.assertEqual(files, made)

    def test_are_small(self):
        self.assertEqual([path.name for path in IMAGES.iterdir() if path.stat().st_size > MOST_BYTES], [])

    def test_are_drawn_as_they_were(self):
        self.make_pictures("--check")


class Blocks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, str(ROOT / "Testing/Program"))
        import scenes

        cls.model = scenes.glb()
        cls.robot = (ROOT / "Examples/models/robot.glb").read_bytes()
        cls.has_pyvista = has_pyvista()
        program = os.environ["VITRINE_PROGRAM"]
        cls.environment = {**os.environ, "PATH": f"{pathlib.Path(program).parent}:{os.environ['PATH']}"}
        cls.environment["PYVISTA_OFF_SCREEN"] = "true"
        cls.environment.pop("DISPLAY", None)

    def run_command(self, folder, *command):
        done = subprocess.run(
            command, cwd=folder, env=self.environment, capture_output=True, text=True, check=False
        )
        self.assertEqual(done.returncode, 0, "\n".join([*map(str, command), done.stdout, done.stderr]))

    def run_python(self, folder, texts):
        text = "".join(texts)
        if ("pyvista" in text) and not self.has_pyvista:
            return
        (folder / "page.py").write_text(text, encoding="utf-8")
        self.run_command(folder, sys.executable, "page.py")

    def build(self, folder):
        places = [f"-DCMAKE_PREFIX_PATH={PREFIX}", f"-DVTK_DIR={os.environ['VTK_DIR']}"]
        self.run_command(folder, "cmake", "-S", ".", "-B", "build", "-G", os.environ["GENERATOR"], *places)
        self.run_command(folder, "cmake", "--build", "build")

    def run_program(self, folder, program, cpp):
        (folder / "assembly.glb").write_bytes(self.model)
        if "vtkRenderWindowInteractor" not in main_of(cpp):
            self.run_command(folder, program)

    def test_run(self):
        for page in pages():
            python, shell = blocks(page, "python"), blocks(page, *SHELLS)
            with self.subTest(str(page.relative_to(DOCS))), tempfile.TemporaryDirectory() as scratch:
                folder = pathlib.Path(scratch)
                (folder / "assembly.glb").write_bytes(self.model)
                (folder / "robot.glb").write_bytes(self.robot)
                if python:
                    self.run_python(folder, python)
                for text in shell if PREFIX else ():  # once; Wheel.program runs the wheel's program
                    self.run_command(folder, "bash", "-e", "-c", commands(text))

    @unittest.skipUnless(PREFIX, "there is no installed package")
    def test_build_and_run(self):
        programs = {page.stem: blocks(page, "cpp") for page in pages() if blocks(page, "cpp")}
        lists = {page.stem: "".join(blocks(page, "cmake")) for page in pages()}
        projects = {name: lists[name] for name in programs if "project(" in lists[name]}
        with tempfile.TemporaryDirectory() as scratch:
            shared = pathlib.Path(scratch)
            names = [name for name in programs if name not in projects]
            for name in names:
                (shared / name).mkdir()
                (shared / name / "main.cxx").write_text(main_of(programs[name]), encoding="utf-8")
            (shared / "CMakeLists.txt").write_text(PROJECT.format(pages=" ".join(names)), encoding="utf-8")
            self.build(shared)
            for name in names:
                with self.subTest(name):
                    self.run_program(shared / name, f"../build/{name}", programs[name])
        for name, cmake in projects.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as scratch:
                folder = pathlib.Path(scratch)
                target, source = re.search(r"add_executable\((\w+) (\S+)\)", cmake).groups()
                (folder / source).write_text(main_of(programs[name]), encoding="utf-8")
                (folder / "CMakeLists.txt").write_text(cmake, encoding="utf-8")
                self.build(folder)
                self.run_program(folder, f"build/{target}", programs[name])


if __name__ == "__main__":
    unittest.main()
