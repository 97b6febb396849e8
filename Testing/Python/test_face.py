"""see_through() and stats(): pictures, undoing, misuse, and the examples of their documentation."""

import doctest
import gc
import itertools
import math
import unittest
import warnings

import numpy
from scenes import (
    Plotter,
    cone_renderer,
    drawn,
    pixels,
    plate,
    plates,
    plates_renderer,
    rendered,
    run_python,
    window_with,
)
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkClearRGBPass,
    vtkGaussianBlurPass,
    vtkRenderStepsPass,
    vtkTranslucentPass,
)

import vitrine
import vitrine._options
import vitrine._see_through


def half_plate(z, opacity):
    """A white plate over the left half of the view, whose edge a blur can be seen at."""
    actor = plate(z, (1, 1, 1), opacity)
    actor.SetPosition(-2, 0, 0)
    return actor


class Pictures(unittest.TestCase):
    def test_plates_match_the_closed_form(self):
        for method in vitrine._options.METHODS:
            for count in (1, 5, 40):
                with self.subTest(method=method, count=count):
                    renderer = plates(count)
                    vitrine.see_through(renderer, method)
                    picture = pixels(drawn(renderer))[..., :3] / 255.0
                    self.assertLessEqual(abs(picture - 0.6**count).max(), 0.51 / 255)

    def test_memory_limit_leaves_the_picture_alone(self):
        pictures = []
        for limit in (None, 50000):
            renderer = plates(12)
            vitrine.see_through(renderer, memory_limit=limit)
            pictures.append(pixels(drawn(renderer)))
            bands = renderer.GetPass().GetTranslucentPass().GetNumberOfBands()
            self.assertEqual(bands > 1, limit is not None)
        numpy.testing.assert_array_equal(*pictures)

    def test_color_storage_is_set(self):
        passes = vitrine.vtkLinkedListTransparencyPass
        for name, storage in (
            (None, passes.HALF_FLOAT),
            ("half-float", passes.HALF_FLOAT),
            ("8-bit", passes.EIGHT_BIT),
            ("compact", passes.COMPACT),
        ):
            renderer = vtkRenderer()
            vitrine.see_through(renderer, color_storage=name)
            found = renderer.GetPass().GetTranslucentPass().GetColorStorage()
            self.assertEqual(found, storage, name)

    def test_coincidence_is_set(self):
        for method in ("linked-list", "prefix-sum", "truth"):
            for value, expected in ((None, (0, 0)), (3, (3, 0)), ((0.5, 0.25), (0.5, 0.25))):
                renderer = vtkRenderer()
                vitrine.see_through(renderer, method, coincidence=value)
                found = renderer.GetPass().GetTranslucentPass()
                self.assertEqual(
                    (found.GetCoincidenceSteps(), found.GetCoincidenceSlope()), expected
                )

    def test_coincidence_takes_the_order_from_plates_of_one_place(self):
        for method in ("linked-list", "prefix-sum", "truth"):
            pictures = []
            for nudge in (-1e-6, 1e-6):
                renderer = plates_renderer(
                    plate(0.0, (1, 0, 0), 0.5),
                    plate(nudge, (0, 0, 1), 0.5),
                    plate(-1, (0, 1, 0), 1.0),
                )
                vitrine.see_through(renderer, method, coincidence=256)
                pictures.append(rendered(renderer))
            numpy.testing.assert_array_equal(*pictures)
            # Either order gives one of the colours 0.5 and the other 0.25.
            numpy.testing.assert_allclose(
                pictures[0][4, 4, :3] / 255.0, (0.375, 0.25, 0.375), atol=0.004
            )

    def test_window_draws_all_its_renderers(self):
        left, right = plates(3), plates(2)
        left.SetViewport(0, 0, 0.5, 1)
        right.SetViewport(0.5, 0, 1, 1)
        window = window_with(left)
        window.AddRenderer(right)
        handle = vitrine.see_through(window, color_storage="8-bit")
        window.Render()
        picture = pixels(window)[24, :, 0] / 255.0
        self.assertLessEqual(abs(picture[:32] - 0.6**3).max(), 2 / 255)
        self.assertLessEqual(abs(picture[32:] - 0.6**2).max(), 2 / 255)
        self.assertEqual(handle.renderers, [left, right])


class Undoing(unittest.TestCase):
    def test_remove_puts_back_the_earlier_pass(self):
        for before in (None, vitrine.vtkSeeThroughPass()):
            renderer = vtkRenderer()
            renderer.SetPass(before)
            handle = vitrine.see_through(renderer)
            self.assertIsNot(renderer.GetPass(), before)
            handle.remove()
            self.assertIs(renderer.GetPass(), before)
            handle.remove()
            self.assertIs(renderer.GetPass(), before)

    def test_remove_keeps_a_pass_that_was_set_since(self):
        renderer, other = vtkRenderer(), vitrine.vtkSeeThroughPass()
        handle = vitrine.see_through(renderer)
        renderer.SetPass(other)
        handle.remove()
        self.assertIs(renderer.GetPass(), other)

    def test_nested_handles_are_undone_one_by_one(self):
        renderer = vtkRenderer()
        with vitrine.see_through(renderer):
            with vitrine.see_through(renderer, "truth"):
                self.assertEqual(vitrine.stats(renderer).method, "truth")
            self.assertEqual(vitrine.stats(renderer).method, "prefix-sum-predicted")
        self.assertIsNone(renderer.GetPass())

    def test_handles_are_removed_in_any_order(self):
        renderer, before = plates(2), vtkRenderStepsPass()
        renderer.SetPass(before)
        with warnings.catch_warnings(record=True):
            handles = [vitrine.see_through(renderer) for _ in range(3)]
        last = renderer.GetPass()
        handles[1].remove()
        handles[0].remove()
        self.assertIs(renderer.GetPass(), last)
        handles[2].remove()
        self.assertIs(renderer.GetPass(), before)

    def test_remove_leaves_no_pass_where_it_was_taken_away(self):
        renderer = plates(2)
        renderer.SetPass(vtkRenderStepsPass())
        with warnings.catch_warnings(record=True):
            handle = vitrine.see_through(renderer)
        renderer.SetPass(None)
        gc.collect()
        handle.remove()
        self.assertIsNone(renderer.GetPass())

    def test_exception_undoes(self):
        renderer = cone_renderer(0.5)
        window = drawn(renderer)
        before = pixels(window)
        with self.assertRaises(ZeroDivisionError):
            with vitrine.see_through(window):
                window.Render()
                raise ZeroDivisionError
        window.Render()
        self.assertIsNone(renderer.GetPass())
        numpy.testing.assert_array_equal(pixels(window), before)

    def test_remove_after_the_renderer_is_gone_does_nothing(self):
        renderer = vtkRenderer()
        handle = vitrine.see_through(renderer)
        del renderer
        gc.collect()
        self.assertEqual(handle.renderers, [])
        handle.remove()
        self.assertEqual(repr(handle), "<SeeThrough prefix-sum-predicted, removed>")

    def test_handle_keeps_no_pass_alive(self):
        renderer = vtkRenderer()
        handle = vitrine.see_through(renderer)
        ours = vitrine._see_through._weak(renderer.GetPass())
        handle.remove()
        gc.collect()
        self.assertIsNone(ours.Get())

    def test_exit_is_quiet(self):
        for tail in ("", "raise SystemExit(0)", "del window", "del renderer, handle"):
            done = run_python(
                "import vitrine, scenes\n"
                "renderer = scenes.cone_renderer(0.5)\n"
                "window = scenes.window_with(renderer)\n"
                "handle = vitrine.see_through(window)\n"
                "window.Render()\n" + tail
            )
            self.assertEqual((done.returncode, done.stderr), (0, ""), tail)


class Effects(unittest.TestCase):
    """Passes and flags of the renderer, switched on before or later."""

    def blurred(self, renderer):
        blur = vtkGaussianBlurPass()
        blur.SetDelegatePass(vtkRenderStepsPass())
        renderer.SetPass(blur)
        return blur

    def test_passes_that_are_there_stay(self):
        renderer = plates_renderer(half_plate(0.0, 0.5), background=(0.2, 0.4, 0.6))
        window = drawn(renderer)
        sharp = pixels(window)
        blur = self.blurred(renderer)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            handle = vitrine.see_through(renderer)
        window.Render()
        self.assertGreater(abs(pixels(window).astype(int) - sharp).max(), 10)
        self.assertEqual(vitrine.stats(renderer).fallback_reason, "")
        self.assertGreater(vitrine.stats(renderer).fragments, 0)
        handle.remove()
        self.assertIs(renderer.GetPass(), blur)
        blur.ReleaseGraphicsResources(window)

    def test_passes_that_are_set_later_stay(self):
        renderer = plates_renderer(half_plate(0.0, 0.5))
        window = window_with(renderer)
        handle = vitrine.see_through(window)
        window.Render()
        blur = self.blurred(renderer)
        self.assertEqual(vitrine.stats(renderer).method, "prefix-sum-predicted")
        window.Render()
        self.assertIs(renderer.GetPass().GetEffectsPass(), blur)
        self.assertGreater(vitrine.stats(window).fragments, 0)
        blur.ReleaseGraphicsResources(window)
        renderer.SetPass(None)
        window.Render()
        self.assertGreater(vitrine.stats(window).fragments, 0)
        handle.remove()
        self.assertIsNone(renderer.GetPass())

    def test_renderers_that_are_added_later_are_taken(self):
        window = window_with(plates(2))
        handle = vitrine.see_through(window)
        window.Render()
        later = plates(3)
        later.SetViewport(0.5, 0, 1, 1)
        window.AddRenderer(later)
        window.Render()
        self.assertEqual(len(handle.renderers), 2)
        self.assertEqual(vitrine.stats(later).layers_max, 3)
        handle.remove()
        self.assertIsNone(later.GetPass())

    def test_lights_of_ours_stay(self):
        renderer = plates(2)
        lights = vitrine.vtkClusteredLightsPass()
        lights.SetDelegatePass(vitrine.vtkSeeThroughPass())
        renderer.SetPass(lights)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            handle = vitrine.see_through(renderer, "prefix-sum")
        drawn(renderer)
        self.assertEqual(vitrine.stats(renderer).method, "prefix-sum")
        self.assertIs(renderer.GetPass().GetEffectsPass(), lights)
        handle.remove()
        self.assertIs(renderer.GetPass(), lights)
        self.assertEqual(vitrine.stats(renderer).method, "linked-list")

    def test_cull_replaces_the_cullers_until_remove(self):
        renderer = plates(2)
        before = list(renderer.GetCullers())
        handle = vitrine.see_through(renderer, cull=True)
        kinds = [type(culler).__name__ for culler in renderer.GetCullers()]
        self.assertEqual(kinds, ["vtkHierarchicalSBufferCuller"])
        drawn(renderer)
        self.assertEqual(vitrine.stats(renderer).drawn_parts, 2)
        handle.remove()
        self.assertEqual(list(renderer.GetCullers()), before)

    def test_cullers_of_handles_are_put_back_in_any_order(self):
        renderer = plates(2)
        before = list(renderer.GetCullers())
        for order in itertools.permutations(range(3)):
            handles = [vitrine.see_through(renderer, cull=True) for _ in range(3)]
            ours = list(renderer.GetCullers())
            self.assertEqual(len(ours), 1)
            for i in order:
                self.assertNotEqual(list(renderer.GetCullers()), before, "the others cull still")
                handles[i].remove()
                if handles[2]._frames.removed is False:
                    self.assertEqual(list(renderer.GetCullers()), ours)
            self.assertEqual(list(renderer.GetCullers()), before)

    def test_remove_keeps_cullers_that_were_set_since(self):
        renderer, another = plates(2), vitrine.vtkHierarchicalSBufferCuller()
        handle = vitrine.see_through(renderer, cull=True)
        renderer.GetCullers().RemoveAllItems()
        renderer.AddCuller(another)
        handle.remove()
        self.assertEqual(list(renderer.GetCullers()), [another])

    def test_remove_keeps_cullers_that_were_added_since(self):
        renderer, another = plates(2), vitrine.vtkHierarchicalSBufferCuller()
        before = list(renderer.GetCullers())
        handle = vitrine.see_through(renderer, cull=True)
        renderer.AddCuller(another)
        handle.remove()
        self.assertEqual(list(renderer.GetCullers()), [*before, another])

    def test_lights_are_counted(self):
        renderer = plates(2)
        for x in range(3):
            light = vtkLight()
            light.SetPositional(True)
            light.SetPosition(x, 0, 5)
            light.SetLightTypeToSceneLight()
            renderer.AddLight(light)
        for kind in (True, "clustered", "deferred"):
            with vitrine.see_through(renderer, lights=kind):
                drawn(renderer)
                told = vitrine.stats(renderer)
                self.assertEqual((told.lights, told.lights_reason), (3, ""))
        renderer.UseShadowsOn()
        with vitrine.see_through(renderer, lights=True):
            drawn(renderer)
            self.assertIn("shadow", vitrine.stats(renderer).lights_reason)


class Report(unittest.TestCase):
    def test_says_what_each_method_does_here(self):
        text = vitrine.report()
        for line in ("Vitrine: ", "VTK: ", "OpenGL: ", "method linked-list: works", "lights clustered: works"):
            self.assertIn(line, text)
        self.assertNotIn("last frame", text)

    def test_has_the_last_frame_of_a_target(self):
        renderer = plates(2)
        handle = vitrine.see_through(renderer)
        drawn(renderer)
        self.assertIn("last frame: method='prefix-sum-predicted'", vitrine.report(renderer))
        handle.remove()
        with self.assertRaisesRegex(ValueError, "see_through"):
            vitrine.report(renderer)

    def test_says_what_is_missing(self):
        done = run_python("import vitrine; print(vitrine.report())", MESA_GL_VERSION_OVERRIDE="3.3")
        self.assertIn("VTK's blending in its place: OpenGL 4.3 is needed", done.stdout, done.stderr)
        self.assertEqual(done.stderr, "")


class Figures(unittest.TestCase):
    def test_tell_of_the_last_frame(self):
        window = window_with(plates(7))
        handle = vitrine.see_through(window)
        self.assertEqual(vitrine.stats(window).fragments, 0)
        window.Render()
        told = vitrine.stats(window)
        self.assertEqual(told, handle.stats())
        self.assertEqual((told.method, told.fallback_reason), ("prefix-sum-predicted", ""))
        self.assertEqual((told.fragments, told.layers_max, told.layers_mean), (7 * 64 * 48, 7, 7.0))
        self.assertGreater(told.bytes, told.fragments * 12)
        self.assertIn(told.geometry_passes, (1, 2))

    def test_stages_are_told_once_they_are_measured(self):
        window = window_with(plates(3))
        vitrine.see_through(window)
        window.Render()
        self.assertEqual(vitrine.stats(window).stages, {})
        (renderer,) = window.GetRenderers()
        frame = vitrine.vtkSeeThroughPass.GetAttached(renderer)
        frame.GetTranslucentPass().MeasureStagesOn()
        window.Render()
        window.WaitForCompletion()
        stages = vitrine.stats(window).stages
        self.assertEqual(list(stages), ["prepare", "fill", "classify", "resolve"])
        self.assertGreater(min(stages.values()), 0.0)

    def test_several_renderers_are_put_together(self):
        deep, flat = plates(6), plates(2)
        deep.SetViewport(0, 0, 0.5, 1)
        flat.SetViewport(0.5, 0, 1, 1)
        window = window_with(deep)
        window.AddRenderer(flat)
        vitrine.see_through(flat)
        vitrine.see_through(deep, memory_limit=20000)  # in bands, so its geometry is drawn oftener
        window.Render()
        told = vitrine.stats(window)
        self.assertEqual((told.fragments, told.layers_max, told.layers_mean), (8 * 32 * 48, 6, 4.0))
        parts = vitrine.stats(flat), vitrine.stats(deep)
        self.assertEqual([part.layers_max for part in parts], [2, 6])
        self.assertGreater(min(part.bytes for part in parts), 0)
        self.assertEqual(told.bytes, sum(part.bytes for part in parts))
        self.assertLess(parts[0].geometry_passes, parts[1].geometry_passes)
        self.assertEqual(told.geometry_passes, parts[1].geometry_passes)

    def test_fallback_reason_says_what_the_driver_lacks(self):
        done = run_python(
            "import vitrine, scenes\n"
            "window = scenes.window_with(scenes.cone_renderer(0.5))\n"
            "window.AddRenderer(scenes.cone_renderer(0.5))\n"
            "vitrine.see_through(window)\n"
            "window.Render()\n"
            "print(vitrine.stats(window).fallback_reason)\n",
            MESA_GL_VERSION_OVERRIDE="3.3",
        )
        reason = "OpenGL 4.3 is needed, the context has 3.3; stencil-routed draws in its place"
        self.assertEqual(done.stdout, f"{reason}\n", done.stderr)


class Misuse(unittest.TestCase):
    def test_bad_arguments_raise(self):
        renderer = vtkRenderer()
        for error, words, call in (
            (TypeError, "not vtk.*Actor", lambda: vitrine.see_through(vtkActor())),
            (TypeError, "NoneType", lambda: vitrine.see_through(None)),
            (ValueError, "known are automatic, linked-list", lambda: vitrine.see_through(renderer, "magic")),
            (ValueError, "8-bit", lambda: vitrine.see_through(renderer, color_storage="16-bit")),
            (ValueError, "above 0", lambda: vitrine.see_through(renderer, memory_limit=0)),
            (ValueError, "above 0", lambda: vitrine.see_through(renderer, memory_limit=2**63)),
            (TypeError, "1.5", lambda: vitrine.see_through(renderer, memory_limit=1.5)),
            (TypeError, "not True", lambda: vitrine.see_through(renderer, memory_limit=True)),
            (
                ValueError,
                "color_storage is no option of truth",
                lambda: vitrine.see_through(renderer, "truth", color_storage="8-bit"),
            ),
            (
                ValueError,
                "memory_limit is no option of truth",
                lambda: vitrine.see_through(renderer, "truth", memory_limit=9),
            ),
            (TypeError, "pair", lambda: vitrine.see_through(renderer, coincidence="wide")),
            (TypeError, "pair", lambda: vitrine.see_through(renderer, coincidence=(1, 2, 3))),
            (TypeError, "not True", lambda: vitrine.see_through(renderer, coincidence=True)),
            (ValueError, "at least 0", lambda: vitrine.see_through(renderer, coincidence=-1)),
            (
                ValueError,
                "finite",
                lambda: vitrine.see_through(renderer, coincidence=(0, math.nan)),
            ),
            (
                ValueError,
                "coincidence is no option of stencil-routed",
                lambda: vitrine.see_through(renderer, "stencil-routed", coincidence=1),
            ),
            (ValueError, "known are clustered", lambda: vitrine.see_through(renderer, lights="many")),
            (TypeError, "cull is True or False", lambda: vitrine.see_through(renderer, cull=1)),
            (ValueError, "no renderer", lambda: vitrine.see_through(vtkRenderWindow())),
            (ValueError, "see_through", lambda: vitrine.stats(renderer)),
            (TypeError, "int", lambda: vitrine.stats(3)),
        ):
            with self.subTest(words=words), self.assertRaisesRegex(error, words):
                call()
        self.assertIsNone(renderer.GetPass())

    def test_warning_names_the_pass_and_the_line(self):
        renderer = plates(2)
        renderer.SetPass(vtkClearRGBPass())  # no step for translucent geometry is known in it
        with self.assertWarnsRegex(UserWarning, "vtkClearRGBPass is set aside") as caught:
            handle = vitrine.see_through(renderer)
        self.assertEqual(caught.filename, __file__)
        self.assertIn("vtkClearRGBPass", handle.stats().set_aside)

    def test_stats_of_other_passes_raise(self):
        renderer = plates(2)
        renderer.SetPass(vtkRenderStepsPass())
        with self.assertRaisesRegex(ValueError, "set is vtkRenderStepsPass"):
            vitrine.stats(renderer)
        whole = vitrine.vtkSeeThroughPass()
        whole.SetTranslucentPass(vtkTranslucentPass())
        renderer.SetPass(whole)
        with self.assertRaises(ValueError):
            vitrine.stats(renderer)

    def test_option_values_of_other_types_raise(self):
        for options in ({"method": ["truth"]}, {"method": {}}, {"color_storage": ["8-bit"]}):
            with self.subTest(options), self.assertRaises(ValueError):
                vitrine.see_through(plates(1), **options)
        vitrine.see_through(plates(1), memory_limit=numpy.int64(10**9))

    def test_closed_plotter_raises(self):
        plotter = Plotter(vtkRenderer())
        plotter.close()
        with self.assertRaisesRegex(RuntimeError, "closed"):
            vitrine.see_through(plotter)


class Documentation(unittest.TestCase):
    def test_examples_run(self):
        result = doctest.testmod(vitrine._see_through)
        self.assertGreater(result.attempted, 0)
        self.assertEqual(result.failed, 0)


if __name__ == "__main__":
    unittest.main()
