"""The error of see_through(): what it chooses, the bounds that it keeps, and what it refuses."""

import argparse
import doctest
import fractions
import math
import unittest

import budget_figures
import numpy
from scenes import Plotter, add_lights, drawn, pixels, plate, plates, plates_renderer, window_with
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer

import vitrine
import vitrine._stats

STEP = 1 / 255


def glass():
    """Plates of several colours in the upper left of a view."""
    renderer = plates_renderer(
        *(plate(0.2 * i, (0.9 - 0.1 * i, 0.1 + 0.15 * i, 0.4), 0.15 + 0.1 * i) for i in range(6)),
        background=(0.2, 0.5, 0.8),
    )
    for actor in renderer.GetActors():
        actor.SetPosition(-1.5, 1.5, 0)
    return renderer


def truth_of(renderer):
    """The exact picture as floats, rows from the top."""
    with vitrine.see_through(renderer, "truth"):
        window = drawn(renderer)
        image = vitrine.vtkSeeThroughPass.GetAttached(renderer).GetTranslucentPass().GetResult()
        width, height, _ = image.GetDimensions()
        exact = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1].copy()
    window.RemoveRenderer(renderer)
    return exact[..., :3]


class Budgets(unittest.TestCase):
    def test_are_kept_and_bounds_are_not_exceeded(self):
        exact = truth_of(glass())
        for steps, chosen in (
            (0.6, "prefix-sum-predicted"),
            (1, "prefix-sum-predicted"),
            (2, "prefix-sum-predicted-compact"),
            (8, "prefix-sum-predicted-compact"),
        ):
            with self.subTest(steps=steps):
                renderer = glass()
                vitrine.see_through(renderer, error=steps / 255, error_bounds=True)
                window = drawn(renderer)
                window.Render()  # the first frame chooses without knowledge
                error = abs(pixels(window)[::-1, :, :3] / 255.0 - exact).max(axis=-1)
                bound = vitrine.error_bound(renderer)
                self.assertEqual((bound.dtype, bound.shape), (numpy.float32, (48, 64)))
                self.assertLessEqual((error - bound).max(), 1e-6)
                self.assertLessEqual(bound.max(), steps / 255 + 1e-9)
                self.assertGreater(bound[:30, :30].min(), 0)
                for empty in (bound[-4:], bound[:, -4:]):
                    self.assertEqual(empty.max(), 0)
                told = vitrine.stats(window)
                self.assertEqual((told.method, told.chosen, told.budget_problem), ("automatic", chosen, ""))
                self.assertTrue(bound.max() <= told.guaranteed_error + 1e-9 <= steps / 255 + 2e-9)

    def test_have_a_default(self):
        for options in ({"method": "automatic"}, {"error": STEP}, {"error_bounds": True}):
            renderer = vtkRenderer()
            handle = vitrine.see_through(renderer, **options)
            self.assertEqual(handle.method, "automatic")
            self.assertEqual(renderer.GetPass().GetErrorBudget(), STEP)

    def test_take_numbers_of_all_kinds(self):
        for error in (fractions.Fraction(2, 255), numpy.float32(0.6 / 255), numpy.float64(0.01), 0.6 / 255, 1):
            with self.subTest(error=error):
                renderer = vtkRenderer()
                vitrine.see_through(renderer, error=error)
                self.assertAlmostEqual(renderer.GetPass().GetErrorBudget(), float(error), 9)

    def test_that_cannot_be_kept_are_told(self):
        window = window_with(glass(), multisamples=4)
        vitrine.see_through(window, error=STEP)
        self.assertEqual(vitrine.stats(window).budget_problem, "no frame was drawn by this pass")
        window.Render()
        told = vitrine.stats(window)
        self.assertIn("the budget is 1/255", told.budget_problem)
        self.assertGreater(told.guaranteed_error, STEP)

    def test_others_have_none(self):
        window = window_with(plates(2))
        vitrine.see_through(window)
        window.Render()
        told = vitrine.stats(window)
        self.assertEqual((told.chosen, told.guaranteed_error, told.budget_problem), ("", None, ""))

    def test_renderers_are_put_together(self):
        left, right = glass(), glass()
        left.SetViewport(0, 0, 0.5, 1)
        right.SetViewport(0.5, 0, 1, 1)
        window = window_with(left)
        window.AddRenderer(right)
        vitrine.see_through(left, error=2 * STEP, error_bounds=True)
        vitrine.see_through(right, error=STEP, error_bounds=True)
        window.Render()
        window.Render()
        bound = vitrine.error_bound(window)
        for half in (bound[:30, :10], bound[:30, 32:42]):
            self.assertGreater(half.min(), 0)
        self.assertLessEqual(bound[:, 32:].max(), STEP)
        told = vitrine.stats(window)
        self.assertEqual(told.chosen, "prefix-sum-predicted, prefix-sum-predicted-compact")
        guaranteed = [vitrine.stats(renderer).guaranteed_error for renderer in (left, right)]
        self.assertEqual(told.guaranteed_error, max(guaranteed))

    def test_views_without_glass_have_no_error(self):
        opaque, empty = glass(), vtkRenderer()
        for actor in opaque.GetActors():
            actor.GetProperty().SetOpacity(1)
        empty.SetViewport(0.5, 0, 1, 1)
        window = window_with(opaque)
        window.AddRenderer(empty)
        vitrine.see_through(window, error=STEP, error_bounds=True)
        window.Render()
        told = vitrine.stats(window)
        self.assertEqual((told.guaranteed_error, told.budget_problem), (0, ""))
        self.assertEqual(vitrine.error_bound(window).max(), 0)

    def test_views_that_are_off_are_left_out(self):
        left, right = glass(), glass()
        window = window_with(left)
        window.AddRenderer(right)
        vitrine.see_through(window, error=STEP, error_bounds=True)
        window.Render()
        one, two = vitrine.error_bound(left), vitrine.error_bound(window)
        self.assertLess(abs(two - 2 * one).max(), 1e-8)
        right.DrawOff()
        self.assertEqual(abs(vitrine.error_bound(window) - one).max(), 0)
        window.SetSize(80, 60)
        self.assertEqual(vitrine.error_bound(window).shape, (48, 64))  # of the last frame
        window.Render()
        self.assertEqual(vitrine.error_bound(window).shape, (60, 80))
        right.DrawOn()
        with self.assertRaisesRegex(ValueError, "draw the window again"):
            vitrine.error_bound(window)

    def test_layers_are_added(self):
        behind, front = glass(), glass()
        front.SetLayer(1)
        window = window_with(behind)
        window.AddRenderer(front)
        window.SetNumberOfLayers(2)
        vitrine.see_through(behind, error=2 * STEP, error_bounds=True)
        vitrine.see_through(front, error=STEP, error_bounds=True)
        window.Render()
        bounds = [vitrine.error_bound(each) for each in (behind, front)]
        self.assertGreater(min(bound.max() for bound in bounds), 0)
        self.assertLess(abs(vitrine.error_bound(window) - bounds[0] - bounds[1]).max(), 1e-8)
        guaranteed = [vitrine.stats(each).guaranteed_error for each in (behind, front)]
        self.assertEqual(vitrine.stats(window).guaranteed_error, sum(guaranteed))


class Figures(unittest.TestCase):
    """budget_figures.py compares with truth of the very same view."""

    def test_turns_at_large_coordinates_end_where_they_began(self):
        """To turn by 2 degrees there and back moves the camera by 2e-9, and so edges to other pixels."""
        budget, random = 0.6 / 255, numpy.random.default_rng(53)
        stage = budget_figures.Stage("demo:large-coordinates", (256, 256), 0.3)
        contestant = budget_figures.Contestant("automatic", budget)
        for view in range(2):
            stage.look(random)
            place = stage.renderer.GetActiveCamera().GetPosition()
            exact = stage.exact()
            stage.arrive(contestant, 2)
            self.assertEqual(stage.renderer.GetActiveCamera().GetPosition(), place)
            self.assertLessEqual(abs(stage.picture() - exact).max(), budget)

    def test_views_of_nothing_are_judged(self):
        stage = budget_figures.Stage("demo:coincident", (16, 16), 0.3)
        contestant, row = budget_figures.Contestant("automatic", STEP), budget_figures.Row()
        stage.draw(contestant)
        stage.renderer.GetActiveCamera().Yaw(180)
        rivals = {"linked-list": budget_figures.Contestant("linked-list")}
        asked = argparse.Namespace(rounds=1, frames=1)
        budget_figures.judge_view(stage, rivals, [contestant], [row], asked, numpy.random.default_rng(1))
        self.assertEqual((row.views, row.exceeded, row.beyond), (1, 0, 0))
        self.assertEqual(row.chosen, {"with nothing translucent": 1})


class Lights(unittest.TestCase):
    def test_that_are_left_out_have_a_share(self):
        """Pixels without fragments are off by what lights may lack."""
        default = vitrine.vtkClusteredLightsPass.GetDefaultCutOff()
        for steps, own, share in (
            (8, default * 255, 4),
            (4, default * 255, 2),
            (2, default * 255, 0),
            (0.6, default * 255, 0),
            (8, 2, 3),
            (8, 0, 0),
            (3, 5, 1.5),
        ):
            with self.subTest(steps=steps, own=own):
                renderer = glass()
                add_lights(renderer, 9)
                vitrine.see_through(renderer, error=steps / 255, error_bounds=True, lights=True)
                frame = vitrine.vtkSeeThroughPass.GetAttached(renderer)
                frame.GetLightingPass().SetCutOff(own / 255)
                window = drawn(renderer)
                window.Render()
                bound = 255 * vitrine.error_bound(renderer)
                self.assertAlmostEqual(bound[-4:].min(), share, 4)
                self.assertAlmostEqual(bound[-4:].max(), share, 4)
                told = vitrine.stats(renderer)
                self.assertEqual((told.lights, told.budget_problem), (9, ""))
                self.assertLessEqual(bound.max(), 255 * told.guaranteed_error + 1e-3)
                self.assertLessEqual(told.guaranteed_error, steps / 255 + 1e-9)
                self.assertAlmostEqual(255 * frame.GetLightingPass().GetCutOff(), own)
                self.assertEqual(frame.GetTranslucentPass().GetColorError(), 0)

    def test_of_other_pictures_leave_what_fragments_need(self):
        window = window_with(glass(), multisamples=4)
        add_lights(window.GetRenderers().GetFirstRenderer(), 9)
        vitrine.see_through(window, error=2.05 / 255, lights=True)
        window.Render()  # before it is known that samples are rounded, too
        self.assertIn("errors of up to 2.0", vitrine.stats(window).budget_problem)
        window.Render()
        self.assertEqual(vitrine.stats(window).budget_problem, "")


class FrameTimes(unittest.TestCase):
    def test_with_ease_have_the_least_error(self):
        renderer = glass()
        vitrine.see_through(renderer, frame_ms=60000)
        window = drawn(renderer)
        for _ in range(20):
            window.Render()
        told = vitrine.stats(renderer)
        self.assertEqual((told.method, told.time_problem, told.error_budget), ("automatic", "", 0.6 / 255))
        self.assertTrue(0 < told.frame_ms < 60000)

    def test_that_are_impossible_are_told(self):
        """All budgets are tried, and none is larger than the error that is allowed."""
        for options, largest in (({"error": 2 * STEP}, 2), ({}, 32)):
            renderer = glass()
            vitrine.see_through(renderer, frame_ms=0.001, **options)
            window = drawn(renderer)
            seen = set()
            for _ in range(100):
                window.Render()
                told = vitrine.stats(renderer)
                seen.add(round(255 * told.error_budget, 6))
                self.assertLessEqual(told.guaranteed_error, told.error_budget)
            self.assertEqual(seen, {each for each in (0.6, 1, 2, 4, 8, 16, 32) if each <= largest})
            said = f"frames take .* ms, not 0.001 ms, with any error of up to {largest}/255"
            self.assertRegex(told.time_problem, said)

    def test_come_and_go_with_the_budget_that_was_set(self):
        frame = vitrine.vtkSeeThroughPass()
        before = frame.GetTranslucentPass()
        for budget in (0, 2 * STEP):
            frame.SetErrorBudget(budget)
            frame.SetFrameTime(33)
            self.assertAlmostEqual(255 * frame.GetErrorBudget(), 2 if budget else 32)
            frame.SetErrorBudget(4 * STEP)
            self.assertEqual((frame.GetErrorBudget(), frame.GetFrameTime()), (4 * STEP, 33))
            frame.SetFrameTime(0)
            self.assertEqual(frame.GetErrorBudget(), 4 * STEP)
            frame.SetErrorBudget(0)
        frame.SetFrameTime(33)
        frame.SetFrameTime(0)
        self.assertIs(frame.GetTranslucentPass(), before)
        frame.SetFrameTime(33)
        frame.SetErrorBudget(0)
        self.assertEqual((frame.GetFrameTime(), frame.GetErrorBudget()), (0, 0))
        self.assertIs(frame.GetTranslucentPass(), before)

    def test_outlive_windows(self):
        renderer = glass()
        vitrine.see_through(renderer, frame_ms=60000)
        for _ in range(2):
            window = drawn(renderer)
            window.Render()
            window.RemoveRenderer(renderer)
            del window
        self.assertEqual(vitrine.stats(renderer).time_problem, "")


class Misuse(unittest.TestCase):
    def test_bad_times_raise_one_clear_exception(self):
        renderer = vtkRenderer()
        for time in (0, -1, math.nan, math.inf):
            with self.subTest(time=time), self.assertRaisesRegex(ValueError, "milliseconds above 0, not"):
                vitrine.see_through(renderer, frame_ms=time)
        for time in (True, "33", [33]):
            with self.subTest(time=time), self.assertRaisesRegex(TypeError, "milliseconds such as 33, not"):
                vitrine.see_through(renderer, frame_ms=time)
        with self.assertRaisesRegex(ValueError, "frame_ms is no option of linked-list: it is one of automatic"):
            vitrine.see_through(renderer, "linked-list", frame_ms=33)
        self.assertIsNone(renderer.GetPass())

    def test_bad_errors_raise_one_clear_exception(self):
        renderer = vtkRenderer()
        for error in (0, -1, math.nan, math.inf, 10, 0.5 / 255):
            with self.subTest(error=error), self.assertRaisesRegex(ValueError, "error is from 0.6/255 to 1, not"):
                vitrine.see_through(renderer, error=error)
        for error in (True, "2/255", [0.01], 1j):
            with self.subTest(error=error), self.assertRaisesRegex(TypeError, "error is a number such as 2 / 255"):
                vitrine.see_through(renderer, error=error)
        for options in ({"error": STEP}, {"error_bounds": True}):
            with self.assertRaisesRegex(ValueError, "is no option of linked-list: it is one of automatic"):
                vitrine.see_through(renderer, "linked-list", **options)
        with self.assertRaisesRegex(ValueError, "which chooses it by the error"):
            vitrine.see_through(renderer, error=STEP, color_storage="compact")
        with self.assertRaisesRegex(TypeError, "error_bounds is True or False"):
            vitrine.see_through(renderer, error=STEP, error_bounds=1)
        self.assertIsNone(renderer.GetPass())

    def test_bounds_that_were_not_kept_raise(self):
        renderer = plates(1)
        with self.assertRaisesRegex(ValueError, "call vitrine.see_through"):
            vitrine.error_bound(renderer)
        for options in ({}, {"error": STEP}):
            with vitrine.see_through(renderer, **options):
                window = drawn(renderer)
                with self.assertRaisesRegex(ValueError, "error_bounds=True"):
                    vitrine.error_bound(renderer)
                window.RemoveRenderer(renderer)
        plotter = Plotter(renderer)
        vitrine.see_through(plotter, error=STEP, error_bounds=True)  # and not drawn yet
        with self.assertRaisesRegex(ValueError, "and draw"):
            vitrine.error_bound(plotter)


class Documentation(unittest.TestCase):
    def test_examples_run(self):
        result = doctest.testmod(vitrine._stats)
        self.assertGreater(result.attempted, 0)
        self.assertEqual(result.failed, 0)
