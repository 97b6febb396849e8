"""The error budget together with the rest: no frame differs from truth of the same set-up by more than its bounds."""

import unittest

import numpy
from scenes import actor_of, add_lights, plate, plates_renderer, window_with
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkWindowToImageFilter
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderPassCollection, vtkRenderStepsPass, vtkSequencePass

import vitrine

SIZE = (72, 54)
SINGLE = 1e-4 / 255  # truth holds the background in single precision
FAINT = 2**-23  # rounding of a faint alpha, which bounds before a frame leave out


def ball(random, opacity):
    source = vtkSphereSource()
    source.SetThetaResolution(16)
    source.SetPhiResolution(12)
    source.SetRadius(random.uniform(0.3, 0.9))
    actor = actor_of(source)
    actor.SetPosition(random.uniform(-1, 1, 3))
    actor.GetProperty().SetColor(random.uniform(0, 1, 3))
    actor.GetProperty().SetOpacity(opacity)
    return actor


def glass(seed=53):
    """Balls that cut each other before a deep stack of plates, and an opaque one. Something can hide in it."""
    random = numpy.random.default_rng(seed)
    renderer = vtkRenderer()
    renderer.SetBackground(0.2, 0.5, 0.8)
    for _ in range(12):
        renderer.AddActor(ball(random, random.uniform(0.1, 0.9)))
    opaque = ball(random, 1.0)
    opaque.GetProperty().LightingOff()
    renderer.AddActor(opaque)
    for z in numpy.linspace(-2.5, -1.5, 24):
        plane = vtkPlaneSource()
        plane.SetOrigin(-1, -1, z)
        plane.SetPoint1(1, -1, z)
        plane.SetPoint2(-1, 1, z + 0.1)
        actor = actor_of(plane)
        actor.GetProperty().SetColor(random.uniform(0, 1, 3))
        actor.GetProperty().SetOpacity(0.35)
        renderer.AddActor(actor)
    renderer.GetActiveCamera().SetPosition(0.5, 0.7, 6)
    renderer.ResetCamera()
    return renderer


def drawn_pixels(window):
    """What was drawn, rows from below. In multisampled windows VTK shows a mean of samples raised to the power 2.2."""
    width, height = window.GetSize()
    data = vtkUnsignedCharArray()
    window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, data)
    return vtk_to_numpy(data).reshape(height, width, 4) / 255.0


def in_tiles(window):
    """A picture of twice the width and height, in steps."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.SetScale(2)
    grab.Update()
    return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).astype(int)


def turn(renderer):
    """Views: three that are still, and one that has just moved."""
    camera = renderer.GetActiveCamera()
    start = camera.GetPosition()

    def look(view):
        camera.SetPosition(start)
        camera.Azimuth(1.5 * max(0, view - 2))
        renderer.ResetCameraClippingRange()

    return look


def light_by_all(renderer):
    """Have the lights of the pass that draws the renderer, if there are any, leave out none."""
    lights = vitrine.vtkSeeThroughPass.GetAttached(renderer).GetLightingPass()
    if lights is not None:
        lights.SetCutOff(0.0)


def truth_of(renderer):
    """The exact picture of the viewport, rows from below."""
    result = vitrine.vtkSeeThroughPass.GetAttached(renderer).GetTranslucentPass().GetResult()
    width, height, _ = result.GetDimensions()
    picture = vtk_to_numpy(result.GetPointData().GetScalars()).reshape(height, width, 4)
    return numpy.clip(picture, 0, 1).astype(float)


class Combinations(unittest.TestCase):
    def check(self, renderer, change=None, window=None, steps=(2, 8), **options):
        """Draw views by truth and within budgets, and compare all pixels with their bounds.

        change is called with the number of each view before it is drawn.
        """
        window = window or window_with(renderer, size=SIZE)
        change = change or turn(renderer)
        views = range(4)
        exact = []
        as_truth = {name: options[name] for name in options if name != "part_numbers"}
        with vitrine.see_through(renderer, "truth", **as_truth):
            light_by_all(renderer)
            for view in views:
                change(view)
                window.Render()
                exact.append(truth_of(renderer))
        for budget in steps:
            with self.subTest(steps=budget):
                asked = budget / 255
                with vitrine.see_through(renderer, error=asked, error_bounds=True, **options):
                    for view in views:
                        change(view)
                        window.Render()
                        self.judge(window, renderer, exact[view], asked)

    def judge(self, window, renderer, exact, asked):
        height, width, _ = exact.shape
        left, bottom = renderer.GetOrigin()
        part = (slice(bottom, bottom + height), slice(left, left + width))
        difference = abs(drawn_pixels(window)[part] - exact)
        bound = vitrine.error_bound(renderer)[::-1][part]
        told = vitrine.stats(renderer)
        self.assertEqual(told.fallback_reason, "")
        self.assertEqual(told.budget_problem, "")
        self.assertGreater(told.fragments, 0)
        self.assertLessEqual((difference[..., :3].max(axis=-1) - bound).max(), SINGLE)
        self.assertLessEqual(bound.max(), told.guaranteed_error + FAINT * told.layers_max)
        self.assertLessEqual(told.guaranteed_error, asked)
        self.assertLessEqual(difference.max(), asked + SINGLE)  # alpha, too

    def test_nothing_else(self):
        self.check(glass())

    def test_culler(self):
        self.check(glass(), cull=True)

    def test_part_numbers(self):
        self.check(glass(), part_numbers=True)

    def test_samples(self):
        renderer = glass()
        window = window_with(renderer, size=SIZE, multisamples=4)
        self.check(renderer, window=window, steps=(1.2, 8))

    def test_lights(self):
        for lights in ("clustered", "deferred"):
            with self.subTest(lights):
                renderer = glass()
                add_lights(renderer, 30)
                for actor in renderer.GetActors():
                    actor.GetProperty().LightingOn()
                self.check(renderer, lights=lights, steps=(1, 4))

    def test_depths_that_are_kept_as_one(self):
        """The depth test sees the depths of the red and the blue strip as two, and lists keep them as one."""
        strips = []
        depths = ("1.0 - exp2(-22.0)", "1.0 - exp2(-24.0)")
        for k, (color, opacity) in enumerate([((1, 0, 0), 0.9998), ((0, 0, 1), 0.998)] + 12 * [((0, 1, 0), 0.99995)]):
            strip = vtkPlaneSource()
            strip.SetOrigin(0, -2, 0)
            strip.SetPoint1(2, -2, 0)
            strip.SetPoint2(0, 2, 0)
            actor = actor_of(strip)
            actor.GetProperty().LightingOff()
            actor.GetProperty().SetColor(color)
            actor.GetProperty().SetOpacity(opacity)
            tag = "//VTK::PositionVC::Impl"
            actor.GetShaderProperty().AddVertexShaderReplacement(
                tag, True, f"{tag}\n  gl_Position.z = {depths[min(k, 1)]};\n", False
            )
            strips.append(actor)
        renderer = plates_renderer(*strips)
        renderer.GetActiveCamera().SetClippingRange(1, 20)
        self.check(renderer, change=lambda view: None, steps=(2, 4))

    def test_sections(self):
        renderer = glass()
        with vitrine.section(renderer, "z", (0, 0, 0.1), edges=2):
            self.check(renderer)

    def test_x_ray(self):
        renderer = glass()
        with vitrine.x_ray(renderer, list(renderer.GetActors())[:6]):
            self.check(renderer)

    def test_reveal(self):
        renderer = glass()
        window = window_with(renderer, size=SIZE)
        window.Render()
        vitrine.reveal(renderer, list(renderer.GetActors())[12], outlines=False)
        self.check(renderer, window=window)

    def test_passes_that_keep_pixels(self):
        renderer = glass()
        passes, chain = vtkRenderPassCollection(), vtkSequencePass()
        passes.AddItem(vtkRenderStepsPass())
        chain.SetPasses(passes)
        renderer.SetPass(chain)
        self.check(renderer)

    def test_viewports(self):
        left, right = glass(3), glass(4)
        left.SetViewport(0, 0, 0.5, 0.9)
        right.SetViewport(0.45, 0.2, 1, 1)
        window = window_with(left, size=SIZE)
        window.AddRenderer(right)
        with vitrine.see_through(left, error=4 / 255):
            self.check(right, window=window)

    def test_alpha_of_black_pictures(self):
        """Less light passes the first plate than may hide, and then more, which only the alpha channel shows."""
        front, *others = [plate(-0.1 * i, (0, 0, 0), 0.5) for i in range(12)]
        renderer = plates_renderer(front, *others)
        light = (0.05, 0.05, 0.05, 1.6)
        self.check(
            renderer, change=lambda view: front.GetProperty().SetOpacity(1 - light[view] / 255), steps=(1.9,)
        )

    def test_resize(self):
        renderer = glass()
        window = window_with(renderer, size=SIZE)
        sizes = (SIZE, (130, 40), (130, 40), (50, 70))
        self.check(renderer, window=window, change=lambda view: window.SetSize(sizes[view]))

    def test_tiles_of_large_screenshots(self):
        renderer = glass()
        window = window_with(renderer, size=SIZE)
        with vitrine.see_through(renderer, "truth"):
            exact = in_tiles(window)
        with vitrine.see_through(renderer, error=2 / 255):
            window.Render()
            for _ in range(2):
                self.assertLessEqual(abs(in_tiles(window) - exact).max(), 2)  # both are rounded

    def test_transparent_backgrounds(self):
        renderer = glass()
        renderer.SetBackgroundAlpha(0.0)
        renderer.GetActors().GetLastActor().GetProperty().SetOpacity(0.01)
        self.check(renderer)


if __name__ == "__main__":
    unittest.main()
