"""What a wheel holds, and the program that it puts on PATH."""

import importlib.metadata
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOHDF import vtkHDFWriter

import vitrine
from wheel import PROGRAM, run

SYSTEM = {
    "ld-linux-x86-64.so.2",
    "libc.so.6",
    "libdl.so.2",
    "libgcc_s.so.1",
    "libm.so.6",
    "libpthread.so.0",
    "libstdc++.so.6",
}


class Program(unittest.TestCase):
    def test_is_of_the_package(self):
        self.assertEqual(run(PROGRAM, "--version").stdout.strip(), vitrine.__version__)
        self.assertEqual(importlib.metadata.version("vtk-vitrine"), vitrine.__version__)

    def test_starts_without_loading_vtk_into_python(self):
        said = run(sys.executable, "-X", "importtime", PROGRAM, "--version")
        self.assertEqual(said.stdout.strip(), vitrine.__version__)
        self.assertIn("runpy", said.stderr)
        self.assertNotIn("vtkmodules", said.stderr)

    def test_runs_as_a_module_too(self):
        said = run(sys.executable, "-m", "vitrine", "info", "demo:stack,layers=3,alpha=0.5")
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertRegex(said.stdout, r"parts\s+3")

    def test_finds_vtk_in_another_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(pathlib.Path(vitrine.__file__).parent, f"{folder}/vitrine")
            said = run(sys.executable, "-m", "vitrine", "--version", cwd=folder)
        self.assertEqual(said.stdout.strip(), vitrine.__version__, said.stderr)

    @unittest.skipIf(importlib.util.find_spec("cascadio"), "cascadio is installed")
    def test_tells_what_reads_step(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "model.step")
            file.write_text("ISO-10303-21;\nEND-ISO-10303-21;\n")
            said = run(PROGRAM, "info", file)
            with self.assertRaisesRegex(ValueError, r"pip install 'vtk-vitrine\[step\]'"):
                vitrine.load(file)
        self.assertEqual(said.returncode, 2)
        self.assertIn("pip install 'vtk-vitrine[step]'", said.stderr)

    def test_reads_what_vtk_itself_writes_as_vtkhdf(self):
        """VTK's reader keeps the corners of such cells in arrays of other kinds than its readers of XML do."""
        cube, grid = vtkCubeSource(), vtkAppendFilter()
        grid.SetInputConnection(cube.GetOutputPort())
        for source in (cube, grid):
            source.Update()
            with tempfile.TemporaryDirectory() as folder:
                writer = vtkHDFWriter()
                writer.SetInputData(source.GetOutput())
                writer.SetFileName(f"{folder}/cube.vtkhdf")
                writer.Write()
                (part,) = vitrine.load(f"{folder}/cube.vtkhdf").parts
            self.assertEqual((part.path, part.triangles), ("/cube", 12))

    def test_refuses_bad_input_with_its_own_status(self):
        said = run(PROGRAM, "info", "nowhere.glb")
        self.assertEqual(said.returncode, 2)
        self.assertIn("nowhere.glb", said.stderr)


class Wheel(unittest.TestCase):
    def setUp(self):
        self.entries = importlib.metadata.distribution("vtk-vitrine").files
        self.files = [pathlib.Path(entry.locate()) for entry in self.entries]

    def test_lies_in_folders_of_its_own(self):
        for entry, file in zip(self.entries, self.files):
            if file.resolve() != PROGRAM.resolve():
                self.assertRegex(str(entry), r"^(vitrine|vtk_vitrine-[\d.]+\.dist-info)/")

    def test_holds_no_library_of_vtk(self):
        libraries = [file.name for file in self.files if ".so" in file.name]
        self.assertEqual(
            sorted(libraries),
            [
                *("libOpenMeshCore.so.9.0", "libOpenMeshTools.so.9.0", "libmeshoptimizer.so.2d"),
                *("libvtkVitrineRendering.so", "vtkVitrineRendering.so"),
            ],
        )

    def test_asks_for_nothing_but_vtk_and_the_c_library(self):
        program = [file for file in self.files if file.match("vitrine/bin/vitrine")]
        self.assertEqual(len(program), 1)
        own = {file.name for file in self.files}
        for file in [*program, *(file for file in self.files if file.suffix == ".so")]:
            needed = re.findall(r"NEEDED\s+(\S+)", objdump(file))
            others = [name for name in needed if not re.match(r"libvtk\w+(\.\d+)?\.so$", name)]
            self.assertLessEqual(set(others), SYSTEM | own, file)


def objdump(file):
    return subprocess.run(
        ["objdump", "-p", file], capture_output=True, text=True, check=True
    ).stdout


if __name__ == "__main__":
    unittest.main()
