"""PyVista's plotters, drawn through the package's face; their examples."""

import base64
import gc
import io
import os
import pathlib
import re
import sys
import tempfile
import time
import unittest
import warnings
import weakref

import numpy
import pyvista
from machine import PATHS, Files, box_bounds, plain_actor
from PIL import Image
from scenes import run_interpreter, run_python
from vtkmodules.vtkRenderingOpenGL2 import vtkSSAOPass
from vtkmodules.vtkWebCore import vtkWebApplication

import vitrine
from vitrine._target import _weak

SIZE = (120, 90)
EXAMPLES = pathlib.Path(os.environ["VITRINE_EXAMPLES"])


def shells(**arguments):
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE, **arguments)
    add_shells(plotter)
    return plotter


def add_shells(plotter):
    for radius, colour in ((1.0, "steelblue"), (0.8, "gold"), (0.6, "tomato"), (0.4, "seagreen")):
        plotter.add_mesh(pyvista.Sphere(radius=radius), color=colour, opacity=0.35)


def picture_of(plotter):
    return plotter.screenshot(None, return_img=True).astype(int)


def pictures(plotter):
    result = []
    for method in ("truth", "linked-list"):
        with vitrine.see_through(plotter, method):
            result.append(picture_of(plotter))
    return result


def quadrants(picture):
    return [part for half in numpy.split(picture, 2) for part in numpy.split(half, 2, axis=1)]


def writable_resident_bytes():
    """
    Count resident bytes of writable pages. Mesa leaves 4 KiB of executable pages for each vertex layout that a context
    has drawn, with any pass.
    """
    total, counts = 0, False
    for line in pathlib.Path("/proc/self/smaps").read_text().splitlines():
        if re.match("[0-9a-f]+-[0-9a-f]+ ", line):
            counts = line.split()[1].startswith("rw-")
        elif counts and line.startswith("Rss:"):
            total += int(line.split()[1]) * 1024
    return total


def sent_by(application, window):
    """
    Return the JPEG of the window as it is now. An application encodes in threads, and sends older pictures until it is
    done.
    """
    application.InvalidateCache(window)
    jpeg = application.StillRender(window, 95)
    patience = time.monotonic() + 60
    while application.GetHasImagesBeingProcessed(window):
        assert time.monotonic() < patience, "the application still encodes after a minute"
        jpeg = application.StillRender(window, 95)
    return bytes(memoryview(jpeg))


class Plotters(unittest.TestCase):
    def tearDown(self):
        pyvista.close_all()

    def assert_exact(self, plotter):
        truth, ours = pictures(plotter)
        self.assertLessEqual(abs(truth - ours).max(), 1)
        self.assertGreater(vitrine_layers(plotter), 2)
        return ours

    def test_are_exact(self):
        by_vtk = picture_of(shells())
        self.assertGreater(abs(self.assert_exact(shells()) - by_vtk).max(), 3)

    def test_with_subplots_are_exact(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE, shape=(2, 2))
        for row in range(2):
            for column in range(2):
                plotter.subplot(row, column)
                add_shells(plotter)
        plotter.link_views()
        for camera in ("xy", "yz"):
            plotter.camera_position = camera
            by_vtk = picture_of(plotter)
            ours = self.assert_exact(plotter)
            for one, other in zip(quadrants(ours), quadrants(by_vtk)):
                self.assertGreater(abs(one - other).max(), 3)
        with vitrine.see_through(plotter):
            passes = [renderer.GetPass() for renderer in plotter.renderers]
        self.assertEqual([type(found) for found in passes], [vitrine.vtkSeeThroughPass] * 4)

    def test_with_multisampling_are_exact(self):
        plotter = shells()
        plotter.enable_anti_aliasing("msaa")
        self.assert_exact(plotter)

    def test_with_transparent_background_are_exact(self):
        plotter = shells()
        vitrine.see_through(plotter)
        picture = plotter.screenshot(None, return_img=True, transparent_background=True)
        self.assertEqual(picture.shape[2], 4)
        self.assertEqual(picture[0, 0, 3], 0)
        middle = picture[SIZE[1] // 2, SIZE[0] // 2, 3] / 255
        self.assertAlmostEqual(middle, 1 - 0.65**8, delta=2 / 255)

    def test_with_depth_peeling_on_are_exact(self):
        plotter = shells()
        plotter.enable_depth_peeling()
        self.assert_exact(plotter)

    def test_are_shown_and_closed(self):
        plotter = shells()
        handle = vitrine.see_through(plotter)
        plotter.show(auto_close=False)
        self.assertGreater(handle.stats().fragments, 0)
        plotter.close()
        with self.assertRaises(RuntimeError):
            vitrine.see_through(plotter)
        handle.remove()

    def test_on_show_are_drawn_at_once(self):
        plotter = shells()
        plotter.show(auto_close=False)
        plain = picture_of(plotter)
        with vitrine.see_through(plotter):
            inside = picture_of(plotter)
        after = picture_of(plotter)
        self.assertGreater(abs(inside - plain).max(), 3)
        self.assertEqual(abs(after - plain).max(), 0)

    def test_are_served_to_browsers(self):
        """What trame's remote rendering and vtk.js' remote views send: JPEGs of the window."""
        plotter = shells()
        plotter.show(auto_close=False)
        application = vtkWebApplication()
        sent = {}
        for method in (None, "truth", "linked-list"):
            handle = method and vitrine.see_through(plotter, method)
            jpeg = sent_by(application, plotter.render_window)
            sent[method] = numpy.asarray(Image.open(io.BytesIO(base64.b64decode(jpeg)))).astype(int)
            if handle:
                handle.remove()
        self.assertLessEqual(abs(sent["linked-list"] - sent["truth"]).max(), 8)
        self.assertGreater(abs(sent["linked-list"] - sent[None]).max(), 30)

    def test_with_another_pass_keep_it(self):
        plotter = shells()
        plotter.enable_ssao()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            handle = vitrine.see_through(plotter)
        plotter.screenshot(None, return_img=True)
        self.assertIs(type(plotter.renderer.GetPass()), vitrine.vtkSeeThroughPass)
        self.assertIs(type(plotter.renderer.GetPass().GetEffectsPass()), vtkSSAOPass)
        self.assertGreater(vitrine.stats(plotter).fragments, 0)
        self.assertEqual(vitrine.stats(plotter).fallback_reason, "")
        handle.remove()
        self.assertIs(type(plotter.renderer.GetPass()), vtkSSAOPass)

    def test_stay_see_through_where_another_is_switched_on_or_off(self):
        plotter = shells()
        handle = vitrine.see_through(plotter)
        plotter.enable_ssao()
        plotter.screenshot(None, return_img=True)
        self.assertIs(type(plotter.renderer.GetPass().GetEffectsPass()), vtkSSAOPass)
        self.assertGreater(vitrine.stats(plotter).fragments, 0)
        plotter.disable_ssao()
        plotter.render()
        self.assertIsNone(plotter.renderer.GetPass().GetEffectsPass())
        self.assertGreater(vitrine.stats(plotter).fragments, 0)
        handle.remove()
        self.assertIsNone(plotter.renderer.GetPass())
        self.assert_exact(plotter)

    def test_two_at_a_time_draw_the_same(self):
        first, second = shells(), shells()
        vitrine.see_through(first)
        vitrine.see_through(second, color_storage="8-bit")
        for _ in range(3):
            pair = [picture_of(plotter) for plotter in (first, second)]
            self.assertLessEqual(abs(pair[0] - pair[1]).max(), 2)

    def test_a_hundred_in_turn_leave_nothing(self):
        passes, plotters, sizes = [], [], []
        for i in range(100):
            plotter = shells()
            handle = vitrine.see_through(plotter)
            plotter.show(auto_close=False)
            passes.append(_weak(plotter.renderer.GetPass()))
            plotters.append(weakref.ref(plotter))
            plotter.close()
            del plotter
            if i % 10 == 9:
                gc.collect()
                sizes.append(writable_resident_bytes())
        self.assertEqual(handle.renderers, [])
        self.assertTrue(all(found.Get() is None for found in passes))
        self.assertTrue(all(found() is None for found in plotters))
        # The C library takes arenas of megabytes at times; what leaks grows in every interval.
        growth = min(b - a for a, b in zip(sizes, sizes[1:])) / 10
        self.assertLess(growth, 8192, "bytes a plotter")


def vitrine_layers(plotter):
    with vitrine.see_through(plotter):
        plotter.render()
        return vitrine.stats(plotter).layers_max


class Processes(unittest.TestCase):
    def test_end_quietly_while_see_through(self):
        for tail in ("", "plotter.close()", "raise SystemExit(0)", "pyvista.close_all()"):
            with self.subTest(tail):
                done = run_python(
                    "import pyvista, vitrine\n"
                    "plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))\n"
                    "plotter.add_mesh(pyvista.Sphere(), opacity=0.5)\n"
                    "handle = vitrine.see_through(plotter)\n"
                    "plotter.show(auto_close=False)\n" + tail,
                )
                errors = [line for line in done.stderr.splitlines() if "X server" not in line]
                self.assertEqual((done.returncode, errors), (0, []))


class Documentation(unittest.TestCase):
    def test_of_readme_runs(self):
        text = pathlib.Path(EXAMPLES.parents[1], "README.md").read_text()
        program = "".join(re.findall("```python\n(.*?)```", text, re.DOTALL))
        before = f"import os\nos.chdir({str(EXAMPLES.parents[1])!r})\n"
        before += "import pyvista\npyvista.global_theme.auto_close = False\n"
        after = "print(vitrine.stats(plotter).layers_max)"
        done = run_python(before + program + after, PYVISTA_OFF_SCREEN="true")  # with the tree as its folder
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreaterEqual(int(done.stdout), 4)


class Assemblies(Files):
    def tearDown(self):
        pyvista.close_all()

    def test_are_added_and_removed(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE, shape=(1, 2))
        plotter.subplot(0, 1)
        self.machine.add_to(plotter)
        self.assertEqual([len(renderer.actors) for renderer in plotter.renderers], [0, 3])
        self.assertEqual(tuple(plotter.renderer.bounds), (-3, 2.5, -2.5, 2.5, -0.5, 0.5))
        self.machine.remove_from(plotter)
        self.assertEqual(len(plotter.renderer.actors), 0)

    def test_are_drawn_as_meshes_are(self):
        pictures = []
        for add in (self.machine.add_to, self.add_meshes):
            plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
            self.machine["Housing"].opacity = 0.25
            add(plotter)
            vitrine.see_through(plotter)
            pictures.append(picture_of(plotter))
        numpy.testing.assert_array_equal(*pictures)
        self.assertGreater(len(numpy.unique(pictures[0].reshape(-1, 3), axis=0)), 20)

    def add_meshes(self, plotter):
        for path in PATHS:
            is_glass = path.startswith("/Machine/Housing/")
            plotter.renderer.AddActor(plain_actor(path, **({"opacity": 0.25} if is_glass else {})))

    def test_become_multiblocks_and_come_back(self):
        made = self.machine.to_multiblock()
        self.assertIs(type(made), pyvista.MultiBlock)
        self.assertEqual(made["Machine"].keys(), ["Housing", "Gearbox"])
        lid = made["Machine"]["Housing"]["lid"]
        self.assertIs(type(lid), pyvista.PolyData)
        self.assertEqual(tuple(lid.bounds), box_bounds(PATHS[0]))
        numpy.testing.assert_allclose(lid.field_data["color"], [[0.5 ** (1 / 2.2)] * 3])
        back = vitrine.from_multiblock(made)
        self.assertEqual({part.bounds for part in back}, {box_bounds(path) for path in PATHS})
        self.assertEqual([part.name for part in back["material:Grey paint"]], ["lid", "bolt"])

    def test_of_multiblocks_have_surfaces(self):
        solid = pyvista.ImageData(dimensions=(3, 3, 3)).cast_to_unstructured_grid()
        solid.field_data["color"] = [1.0, 0.0, 0.0]
        solid.field_data["material"] = "steel"
        data = pyvista.MultiBlock({"ball": pyvista.Sphere(), "nothing": None})
        data["group"] = pyvista.MultiBlock({"solid": solid, "table": pyvista.Table([[1.0, 2.0]])})
        machine = vitrine.from_multiblock(data)
        self.assertEqual([part.path for part in machine], ["/ball", "/group/solid"])
        self.assertEqual(machine["material:steel"].parts[0].triangles, 48)
        self.assertEqual(machine.notes, ("/group/table is no data set",))
        machine["ball"].color = pyvista.Color("green")
        self.assertEqual(machine["ball"].color, tuple(pyvista.Color("green").float_rgb))


class Examples(unittest.TestCase):
    def test_draw_their_pictures(self):
        for name in ("pyvista_assembly", "pyvista_isosurfaces"):
            with self.subTest(name), tempfile.TemporaryDirectory() as out:
                picture = pathlib.Path(out, "picture.png")
                done = run_interpreter(EXAMPLES / f"{name}.py", picture)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertGreater(picture.stat().st_size, 1000)
                self.assertRegex(done.stdout, r"linked-list\s.* [01]\.0")


    def test_a_window_of_qt_shows_what_a_plotter_draws(self):
        desktop = EXAMPLES.parents[1] / "Testing" / "Program" / "desktop.py"
        with tempfile.TemporaryDirectory() as out:
            picture = pathlib.Path(out, "picture.png")
            command = [desktop, sys.executable, EXAMPLES / "qt_assembly.py", picture]
            done = run_interpreter(*command, QT_QPA_PLATFORM="xcb", XDG_RUNTIME_DIR=out)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            shown = numpy.asarray(Image.open(picture).convert("RGB"))
        sys.path.insert(0, str(EXAMPLES))
        self.addCleanup(sys.path.remove, str(EXAMPLES))
        from pyvista_assembly import gearbox

        plotter = pyvista.Plotter(off_screen=True, window_size=shown.shape[1::-1])
        self.addCleanup(plotter.close)
        blocks, looks = gearbox()
        for name, (color, opacity) in looks.items():
            plotter.add_mesh(blocks[name], color=color, opacity=opacity, smooth_shading=False)
        vitrine.see_through(plotter)
        numpy.testing.assert_array_equal(shown, plotter.screenshot(return_img=True)[:, :, :3])
        self.assertGreater(len(numpy.unique(shown.reshape(-1, 3), axis=0)), 100)


class Culler(unittest.TestCase):
    def tearDown(self):
        pyvista.close_all()

    def test_leaves_out_meshes_and_grids_behind_others(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
        plotter.add_mesh(pyvista.Cube(x_length=4.0, y_length=4.0, z_length=4.0))
        for x in (-0.5, 0.0, 0.5):
            plotter.add_mesh(pyvista.Sphere(radius=0.2, center=(x, 0.0, 0.0)), color="tomato")
        plotter.add_mesh(pyvista.ImageData(dimensions=(3, 3, 3), spacing=(0.5, 0.5, 0.5)))
        culler = vitrine.vtkHierarchicalSBufferCuller()
        plotter.renderer.GetCullers().RemoveAllItems()
        plotter.renderer.AddCuller(culler)
        picture_of(plotter)
        plotter.render()  # a mapper has nothing that draws before the first frame, and a screenshot draws but once
        culled = picture_of(plotter)
        self.assertEqual(culler.GetNumberOfCulledParts(), 4)
        culler.CullingOff()
        plotter.render()
        numpy.testing.assert_array_equal(culled, picture_of(plotter))


if __name__ == "__main__":
    unittest.main()
