"""PyVista's plugin `plotter.vitrine`, and the names that PyVista gave to actors."""

import inspect
import pathlib
import tempfile
import unittest

import numpy
import pyvista
from scenes import run_python
from vtkmodules.vtkRenderingCore import vtkActor

import vitrine
import vitrine.explore
from vitrine.inspector import Inspection

SIZE = (120, 90)
MIDDLE = (SIZE[0] // 2, SIZE[1] // 2)


def gear_in_case():
    """A plotter that looks at a case, and at a gear in it; beside it stands a cube without a name of its own."""
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
    plotter.add_mesh(pyvista.Sphere(radius=0.3), color="tomato", name="gear_17")
    plotter.add_mesh(pyvista.Sphere(), opacity=0.4, name="case/lid")
    plotter.add_mesh(pyvista.Cube(center=(3.0, 0.0, 0.0)))
    plotter.camera_position = [(0.0, 0.0, 6.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
    return plotter


def picture_of(plotter):
    return plotter.screenshot(None, return_img=True).astype(int)


class Methods(unittest.TestCase):
    def tearDown(self):
        pyvista.close_all()

    def test_are_there_without_an_import(self):
        done = run_python(
            "import pyvista, sys\n"
            "assert 'vitrine' not in sys.modules\n"
            "plotter = pyvista.Plotter(off_screen=True)\n"
            "assert 'vitrine' in dir(plotter)\n"
            "print(plotter.vitrine.see_through())"
        )
        self.assertEqual((done.returncode, done.stdout), (0, "<SeeThrough prefix-sum-predicted, 1 renderer>\n"))

    def test_are_the_functions(self):
        plotter = gear_in_case()
        plotter.show(auto_close=False)
        plain = picture_of(plotter)
        with vitrine.see_through(plotter, "truth"), vitrine.section(plotter, "y", parts="gear_17"):
            by_functions = picture_of(plotter)
        with plotter.vitrine.see_through("truth"), plotter.vitrine.section("y", parts="gear_17"):
            numpy.testing.assert_array_equal(picture_of(plotter), by_functions)
            self.assertEqual(plotter.vitrine.stats(), vitrine.stats(plotter))
        numpy.testing.assert_array_equal(picture_of(plotter), plain)
        self.assertGreater(abs(by_functions - plain).max(), 3)

    def test_have_the_help_and_the_signatures_of_the_functions(self):
        tools = gear_in_case().vitrine
        names = [name for name in dir(tools) if not name.startswith("_")]
        self.assertIn("inspect", names)
        for name in names:
            place = vitrine if hasattr(vitrine, name) else vitrine.explore
            method, function = getattr(tools, name), getattr(place, name)
            self.assertEqual(method.__doc__, function.__doc__)
            ours, *rest = inspect.signature(function).parameters.values()
            self.assertEqual((ours.name, rest), ("target", list(inspect.signature(method).parameters.values())))

    def test_export_what_the_plotter_shows(self):
        plotter = gear_in_case()
        plotter.show(auto_close=False)
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder, "page.html")
            plotter.vitrine.export_explorable(page)
            self.assertTrue(page.read_text(encoding="utf-8").startswith("<!DOCTYPE html>"))

    def test_inspect_the_active_subplot_and_say_so(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE, shape=(1, 2))
        plotter.subplot(0, 1)
        plotter.add_mesh(pyvista.Sphere(), name="ball")
        with self.assertWarnsRegex(UserWarning, r"subplot \(0, 1\) of the plotter is inspected"):
            shown = Inspection(plotter)
        self.addCleanup(shown.close)
        self.assertEqual(shown.parts.paths, ["/ball"])

    def test_of_closed_plotters_say_so(self):
        plotter = gear_in_case()
        tools = plotter.vitrine
        plotter.close()
        with self.assertRaisesRegex(RuntimeError, "closed"):
            tools.see_through()


class Names(unittest.TestCase):
    def setUp(self):
        self.plotter = gear_in_case()
        self.tools = self.plotter.vitrine
        self.tools.see_through(part_numbers=True)
        self.plotter.show(auto_close=False)

    def tearDown(self):
        pyvista.close_all()

    def test_are_told_by_picks(self):
        self.assertEqual(self.tools.pick(*MIDDLE).name, "gear_17")
        self.assertEqual(self.tools.layers_at(*MIDDLE)[0].name, "case/lid")

    def test_choose_actors(self):
        gear = self.plotter.actors["gear_17"]
        self.tools.reveal("gear_17", 0.9)
        self.assertIs(self.tools.pick(*MIDDLE).actor, gear)
        self.assertIn("1 parts", repr(self.tools.reveal("gear*")))
        self.assertEqual(repr(self.tools.highlight(["case_lid", "gear_??"])), "<Highlight of 2 parts>")
        self.assertEqual(repr(self.tools.x_ray("PolyData(*")), "<XRay of 1 part>")
        index = vitrine.AssemblyIndex(self.plotter)
        self.assertTrue(index.is_closed("gear_17"))
        self.assertGreater(index.distance("gear_17", "PolyData*").distance, 2.1)

    def test_that_are_none_tell_those_that_are_near(self):
        with self.assertRaisesRegex(KeyError, "gaer_17.*near.*gear_17"):
            self.tools.highlight("gaer_17")

    def test_stand_beside_those_of_assemblies(self):
        case = pyvista.MultiBlock({"gear_18": pyvista.Sphere(radius=0.1)})
        machine = vitrine.from_multiblock(case).add_to(self.plotter)
        self.assertEqual(repr(self.tools.highlight("gear_*")), "<Highlight of 2 parts>")
        self.assertEqual(repr(self.tools.highlight("gear_17")), "<Highlight of 1 part>")
        self.assertEqual(repr(self.tools.levels(2)), "<Levels of 2 pixels>")
        with self.assertRaisesRegex(KeyError, "gear_19.*near.*gear_18"):
            self.tools.highlight("gear_19")
        del machine

    def test_of_blocks_choose_them_and_are_told(self):
        group = pyvista.MultiBlock({"gear_18": pyvista.Sphere(radius=0.3, center=(0.0, 0.0, 1.0))})
        group["bolt"] = pyvista.Sphere(radius=0.1, center=(-0.5, 0.0, 1.0))
        group["rim"] = pyvista.Sphere(radius=0.1, center=(0.5, 0.0, 1.0))
        actor, _ = self.plotter.add_composite(pyvista.MultiBlock({"drive": group}), name="train")
        self.plotter.render()
        self.assertEqual(self.tools.pick(*MIDDLE).name, "gear_18")
        self.assertEqual(self.tools.pick(*MIDDLE).block, 2)
        self.assertEqual(repr(self.tools.highlight("gear_*")), "<Highlight of 2 parts>")
        for pattern in ("train", "drive", "/train/drive"):
            self.assertEqual(repr(self.tools.highlight(pattern)), "<Highlight of 3 parts>", pattern)
        index = vitrine.AssemblyIndex(self.plotter)
        self.assertAlmostEqual(index.distance("/train/drive/gear_18", "rim").distance, 0.1, delta=0.01)
        self.assertEqual(index.nearest((0.5, 0.0, 1.0)).part, (actor, 4))

    def test_of_actors_without_any_are_empty(self):
        cube = vtkActor()
        cube.SetMapper(self.plotter.actors["gear_17"].GetMapper())
        self.plotter.renderer.RemoveAllViewProps()
        self.plotter.renderer.AddActor(cube)
        self.plotter.render()
        self.assertEqual(self.tools.layers_at(*MIDDLE)[0].name, "")
        with self.assertRaisesRegex(KeyError, "no assembly"):
            self.tools.highlight("gear_17")


if __name__ == "__main__":
    unittest.main()
