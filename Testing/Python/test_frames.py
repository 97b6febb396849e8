"""Frames of see_through() within each other, and what becomes of a window afterwards: stats() and warnings."""

import contextlib
import gc
import io
import unittest
import warnings
import weakref

import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401, a factory
from scenes import Plotter, drawn, plates, run_python, window_with
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkVolume
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkClearRGBPass,
    vtkRenderPassCollection,
    vtkSequencePass,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

import vitrine


class Lifetimes(unittest.TestCase):
    def test_end_in_any_order_in_memory_that_is_overwritten_when_it_is_freed(self):
        program = """
import vitrine
from vtkmodules.vtkRenderingCore import vtkRenderer
import vtkmodules.vtkRenderingOpenGL2

def draw(is_removed):
    renderer = vtkRenderer()
    window = vitrine.vtkHeadlessRenderWindow()
    window.SetSize(60, 40)
    window.AddRenderer(renderer)
    handle = vitrine.see_through(window)
    window.Render()
    if is_removed:
        handle.remove()

for i in range(4):
    draw(i % 2 == 0)
"""
        done = run_python(program, MALLOC_PERTURB_="165")
        self.assertEqual(done.returncode, 0, done.stderr)


class Nested(unittest.TestCase):
    """stats() tells of the frame that draws, where several stand within each other."""

    def setUp(self):
        self.renderer = plates(2)
        for x in range(3):
            light = vtkLight()
            light.SetPositional(True)
            light.SetPosition(x, 0, 5)
            light.SetLightTypeToSceneLight()
            self.renderer.AddLight(light)

    def stats(self):
        drawn(self.renderer)
        return vitrine.stats(self.renderer)

    def test_lights_of_the_inner_frame(self):
        with vitrine.see_through(self.renderer, lights=True):
            with vitrine.see_through(self.renderer, "prefix-sum"):
                told = self.stats()
                self.assertEqual((told.method, told.lights), ("prefix-sum", 3))
                self.renderer.UseShadowsOn()
                self.assertIn("shadow", self.stats().lights_reason)

    def test_lights_of_both_frames_count_once(self):
        with vitrine.see_through(self.renderer, lights=True):
            with vitrine.see_through(self.renderer, lights="deferred"):
                self.assertEqual(self.stats().lights, 3)

    def test_lights_around_a_frame(self):
        lights = vitrine.vtkClusteredLightsPass()
        lights.SetDelegatePass(vitrine.vtkSeeThroughPass())
        self.renderer.SetPass(lights)
        self.assertEqual(self.stats().lights, 3)
        self.assertEqual(self.stats().layers_max, 2)

    def test_frame_in_a_sequence(self):
        passes = vtkRenderPassCollection()
        passes.AddItem(vitrine.vtkSeeThroughPass())
        sequence = vtkSequencePass()
        sequence.SetPasses(passes)
        self.renderer.SetPass(sequence)
        self.assertEqual(self.stats().layers_max, 2)

    def test_chain_that_the_inner_frame_sets_aside(self):
        inner = vitrine.vtkSeeThroughPass()
        inner.SetEffectsPass(vtkClearRGBPass())
        self.renderer.SetPass(inner)
        with self.assertWarnsRegex(UserWarning, "vtkClearRGBPass is set aside"):
            handle = vitrine.see_through(self.renderer)
        self.assertIn("vtkClearRGBPass", self.stats().set_aside)
        handle.remove()

    def test_volumes_that_the_inner_frame_peels(self):
        self.renderer.UseDepthPeelingOn()
        self.renderer.UseDepthPeelingForVolumesOn()
        cube = vtkImageData()
        cube.SetDimensions(2, 2, 2)
        cube.AllocateScalars(3, 1)  # VTK_UNSIGNED_CHAR
        volume = vtkVolume()
        volume.SetMapper(vtkGPUVolumeRayCastMapper())
        volume.GetMapper().SetInputData(cube)
        self.renderer.AddVolume(volume)
        with vitrine.see_through(self.renderer):
            self.assertIn("UseDepthPeelingForVolumes", self.stats().fallback_reason)
            with vitrine.see_through(self.renderer):
                self.assertIn("UseDepthPeelingForVolumes", self.stats().fallback_reason)
            self.renderer.UseDepthPeelingForVolumesOff()
            with vitrine.see_through(self.renderer):
                self.assertEqual(self.stats().fallback_reason, "")


class Plotters(unittest.TestCase):
    def test_plotter_is_seen_through_in_all_its_renderers(self):
        renderers = [vtkRenderer() for _ in range(3)]
        handle = vitrine.see_through(Plotter(*renderers))
        self.assertEqual(handle.renderers, renderers)
        for renderer in renderers:
            self.assertIs(type(renderer.GetPass()), vitrine.vtkSeeThroughPass)

    def test_plotter_is_drawn_unless_closed(self):
        plotter = Plotter(vtkRenderer())
        handle = vitrine.see_through(plotter)
        self.assertEqual(plotter.frames, 1)
        handle.remove()
        self.assertEqual(plotter.frames, 2)
        handle = vitrine.see_through(plotter)
        plotter.close()
        handle.remove()
        self.assertEqual(plotter.frames, 3)

    def test_handle_keeps_no_plotter_alive(self):
        plotter = Plotter(vtkRenderer())
        reference = weakref.ref(plotter)
        handle = vitrine.see_through(plotter)
        del plotter
        gc.collect()
        self.assertIsNone(reference())
        handle.remove()


class Later(unittest.TestCase):
    """What becomes of the target after see_through()."""

    def test_window_may_lose_its_last_renderer(self):
        renderer = plates(2)
        window = window_with(renderer)
        handle = vitrine.see_through(window)
        window.Render()
        with contextlib.redirect_stderr(io.StringIO()) as said:
            window.RemoveRenderer(renderer)
            window.Render()
        self.assertEqual(said.getvalue(), "")
        later = plates(3)
        window.AddRenderer(later)
        window.Render()
        self.assertEqual(vitrine.stats(later).layers_max, 3)
        handle.remove()

    def test_window_of_a_closed_plotter_may_draw(self):
        plotter = Plotter(plates(2))
        plotter.render_window = window = window_with(plotter.renderers[0])
        vitrine.see_through(plotter)
        plotter.close()
        with contextlib.redirect_stderr(io.StringIO()) as said:
            window.Render()
        self.assertEqual(said.getvalue(), "")

    def test_pass_that_is_set_later_and_set_aside_warns_once(self):
        for target_of in (lambda window: window, lambda window: window.GetRenderers().GetFirstRenderer()):
            renderer = plates(2)
            window = window_with(renderer)
            with vitrine.see_through(target_of(window)), vitrine.see_through(target_of(window)):
                window.Render()
                renderer.SetPass(vtkClearRGBPass())
                with warnings.catch_warnings(record=True) as caught:
                    warnings.simplefilter("always")
                    window.Render()
                    window.Render()
                self.assertEqual(len(caught), 1)
                self.assertIn("vtkClearRGBPass is set aside", str(caught[0].message))
                self.assertEqual(caught[0].filename, __file__)
                self.assertIn("vtkClearRGBPass", vitrine.stats(renderer).set_aside)

    def test_renderer_that_is_added_later_with_a_pass_set_aside_warns(self):
        window = window_with(plates(2))
        handle = vitrine.see_through(window)
        window.Render()
        later = plates(3)
        later.SetPass(vtkClearRGBPass())
        window.AddRenderer(later)
        with self.assertWarnsRegex(UserWarning, "vtkClearRGBPass is set aside"):
            window.Render()
        handle.remove()

    def test_removed_handle_says_nothing(self):
        renderer = plates(2)
        window = window_with(renderer)
        vitrine.see_through(window).remove()
        renderer.SetPass(vtkClearRGBPass())
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            window.Render()
        self.assertFalse(renderer.HasObserver("EndEvent"))


if __name__ == "__main__":
    unittest.main()
