"""The package itself: what it exports, and what it says where VTK is missing."""

import unittest

import vitrine
from scenes import run_python


def concrete_classes():
    classes = {}
    for name in vitrine.__all__:
        if not name.startswith("vtk"):
            continue
        try:
            classes[name] = getattr(vitrine, name)()
        except TypeError:  # an abstract class
            pass
    return classes


class Package(unittest.TestCase):
    def test_exports_the_classes_of_the_module(self):
        for name in (
            "vtkSeeThroughPass",
            "vtkLinkedListTransparencyPass",
            "vtkTruthTransparencyPass",
            "vtkHeadlessRenderWindow",
        ):
            self.assertIn(name, vitrine.__all__)
            self.assertTrue(getattr(vitrine, name)().IsA(name))

    def test_says_its_version(self):
        self.assertRegex(vitrine.__version__, r"^\d+\.\d+\.\d+$")

    def test_prints_every_class(self):
        for name, instance in concrete_classes().items():
            with self.subTest(name):
                text = str(instance)
                self.assertTrue(text.startswith(name), text)
                # The executive of an algorithm holds it too.
                self.assertRegex(text, r"Reference Count: [12]\n")

    def test_says_which_vtk_is_missing(self):
        result = run_python("import sys; sys.modules['vtkmodules'] = None; import vitrine")
        self.assertNotEqual(result.returncode, 0)
        message = result.stderr.strip().splitlines()[-1]
        self.assertRegex(message, r"^ImportError: vitrine needs .*VTK \d+\.\d+.*python3-vtk9")

    def test_refuses_another_vtk(self):
        result = run_python(
            "import sys, types\n"
            "import vtkmodules.vtkRenderingOpenGL2\n"
            "class vtkVersion:\n"
            "    GetVTKMajorVersion = staticmethod(lambda: 9)\n"
            "    GetVTKMinorVersion = staticmethod(lambda: 99)\n"
            "sys.modules['vtkmodules.vtkCommonCore'] = types.SimpleNamespace(vtkVersion=vtkVersion)\n"
            "import vitrine\n"
        )
        self.assertNotEqual(result.returncode, 0)
        message = result.stderr.strip().splitlines()[-1]
        self.assertRegex(message, r"^ImportError: .* found VTK 9\.99 at /")
