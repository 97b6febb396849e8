"""The x-ray look beside its formula: spheres, plates without normals, blocks, and looks that are put back."""

import gc
import math
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkActor2D, vtkRenderer

import vitrine
from scenes import actor_of, pixels, plate, plates_renderer, window_with

SIZE = 64  # pixels of two units


def black(source, lighting=True):
    actor = actor_of(source)
    actor.GetProperty().SetColor(0, 0, 0)
    actor.GetProperty().SetLighting(lighting)
    return actor


def ball(radius=0.9):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(180)
    source.SetPhiResolution(180)
    return black(source)


def tilted(degrees, lighting=False):
    """A plate that is turned about the y axis, wider than the view."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-40, -40, 0)
    plane.SetPoint1(40, -40, 0)
    plane.SetPoint2(-40, 40, 0)
    actor = black(plane, lighting)
    actor.RotateY(degrees)
    return actor


def alone(actor, method="linked-list"):
    """A white view of an actor, in parallel projection, drawn exactly."""
    renderer = plates_renderer(actor, background=(1, 1, 1))
    window = window_with(renderer, size=(SIZE, SIZE))
    vitrine.see_through(window, method=method)
    return renderer, window


def light(window):
    """The share of white that passes, for each pixel."""
    window.Render()
    return pixels(window)[..., 0] / 255.0


def opacity(facing, floor, falloff):
    return floor + (1.0 - floor) * (1.0 - facing) ** falloff


class Formula(unittest.TestCase):
    def test_holds_in_each_pixel_of_a_ball(self):
        actor = ball()
        renderer, window = alone(actor)
        self.assertEqual(light(window)[SIZE // 2, SIZE // 2], 0.0)
        places = (np.arange(SIZE) + 0.5) * 2 / SIZE - 1.0
        distance = np.hypot(*np.meshgrid(places, places)) / 0.9
        inside = distance < 0.97
        facing = np.sqrt(1.0 - distance[inside] ** 2)
        for floor, falloff in ((0.05, 2.0), (0.0, 1.0), (0.3, 5.0), (1.0, 2.0), (0.2, 0.0)):
            with vitrine.x_ray(renderer, actor, falloff=falloff, floor=floor):
                expected = (1.0 - opacity(facing, floor, falloff)) ** 2  # both sides of the ball
                np.testing.assert_allclose(light(window)[inside], expected, atol=0.012)
        self.assertEqual(light(window)[SIZE // 2, SIZE // 2], 0.0)

    def test_holds_for_faces_without_normals_in_both_projections(self):
        for degrees in (0, 35, 60):
            for lighting in (False, True):
                renderer, window = alone(tilted(degrees, lighting))
                vitrine.x_ray(window, floor=0.1, falloff=1.5)
                middle = 1.0 - opacity(math.cos(math.radians(degrees)), 0.1, 1.5)
                np.testing.assert_allclose(light(window), middle, atol=1.5 / 255)
                camera = renderer.GetActiveCamera()
                camera.ParallelProjectionOff()
                renderer.ResetCameraClippingRange()
                places = (np.arange(SIZE) + 0.5) * 2 / SIZE - 1.0
                slope = places * math.tan(math.radians(camera.GetViewAngle() / 2))
                x, y = np.meshgrid(slope, slope)
                turn = math.radians(degrees)
                facing = np.abs(math.cos(turn) - x * math.sin(turn)) / np.sqrt(1.0 + x * x + y * y)
                np.testing.assert_allclose(light(window), 1.0 - opacity(facing, 0.1, 1.5), atol=2 / 255)

    def test_holds_for_own_opacities_and_all_methods(self):
        for method in vitrine.vtkTransparencyPass.GetExactMethods().split(","):
            actor = tilted(60)
            actor.GetProperty().SetOpacity(0.5)
            renderer, window = alone(actor, method)
            vitrine.x_ray(window, floor=0.2, falloff=1.0)
            np.testing.assert_allclose(light(window), 1.0 - 0.5 * opacity(0.5, 0.2, 1.0), atol=1.5 / 255)
            layer = vitrine.layers_at(window, 20, 20)[0]
            self.assertAlmostEqual(layer.opacity, 0.5 * opacity(0.5, 0.2, 1.0), delta=0.005)

    def test_is_in_the_order_of_depth(self):
        near = plate(0.5, (0, 0, 0), 0.25)
        renderer, window = alone(tilted(60))
        renderer.AddActor(near)
        behind = plate(-20.0, (0, 1, 0), 1.0)
        renderer.AddActor(behind)
        renderer.ResetCameraClippingRange()
        vitrine.x_ray(window, [renderer.GetActors().GetItemAsObject(0)], floor=0.2, falloff=1.0)
        window.Render()
        green = pixels(window)[20, 20]
        self.assertAlmostEqual(green[1] / 255.0, 0.75 * (1.0 - opacity(0.5, 0.2, 1.0)), delta=1.5 / 255)
        self.assertEqual((green[0], green[2]), (0, 0))


class Parts(unittest.TestCase):
    def test_are_blocks_and_get_their_looks_back(self):
        data = vtkMultiBlockDataSet()
        for i in range(2):
            plane = vtkPlaneSource()
            plane.SetOrigin(i - 1, -1, 0)
            plane.SetPoint1(i, -1, 0)
            plane.SetPoint2(i - 1, 1, 0)
            plane.Update()
            data.SetBlock(i, plane.GetOutput())
            data.GetMetaData(i).Set(data.NAME(), f"plate_{i}")
        assembly = vitrine.from_multiblock(data)
        assembly["*"].color = "black"
        renderer = plates_renderer(background=(1, 1, 1))
        window = window_with(renderer, size=(SIZE, SIZE))
        vitrine.see_through(window)
        assembly.add_to(renderer)
        renderer.ResetCameraClippingRange()
        before = light(window)
        handle = vitrine.x_ray(window, "plate_1", floor=0.25)
        now = light(window)
        np.testing.assert_array_equal(now[:, : SIZE // 2], before[:, : SIZE // 2])
        np.testing.assert_allclose(now[:, SIZE // 2 :], 0.75, atol=1.5 / 255)
        assembly["plate_1"].opacity = 0.4
        np.testing.assert_allclose(light(window)[:, SIZE // 2 :], 0.9, atol=1.5 / 255)
        handle.remove()
        np.testing.assert_allclose(light(window)[:, SIZE // 2 :], 0.6, atol=1.5 / 255)
        assembly["plate_1"].opacity = None
        np.testing.assert_array_equal(light(window), before)

    def test_get_their_looks_back_to_the_bit(self):
        actor = ball()
        shared = actor.GetProperty()
        renderer, window = alone(actor)
        before = light(window)
        first = vitrine.x_ray(window, actor, floor=0.5)
        second = vitrine.x_ray(window, actor, floor=0.1)
        self.assertIsNone(first._shown[0].GetRenderer())
        self.assertAlmostEqual(light(window)[SIZE // 2, SIZE // 2], 0.81, delta=0.012)
        first.remove()
        self.assertAlmostEqual(light(window)[SIZE // 2, SIZE // 2], 0.81, delta=0.012)
        second.remove()
        np.testing.assert_array_equal(light(window), before)
        self.assertIs(actor.GetProperty(), shared)
        self.assertEqual(shared.GetOpacity(), 1.0)

    def test_with_outlines_and_sections(self):
        actor = tilted(0)
        renderer, window = alone(actor)
        vitrine.x_ray(window, actor, floor=0.25)
        vitrine.highlight(window, actor, color="black", width=0, fill=0.5)
        vitrine.section(window, "x", (0, 0, 0))
        now = light(window)
        np.testing.assert_allclose(now[:, SIZE // 2 :], 0.375, atol=1.5 / 255)
        np.testing.assert_array_equal(now[:, : SIZE // 2], 1.0)


class Changes(unittest.TestCase):
    def test_actors_that_come_late_and_leave(self):
        late = tilted(0)
        renderer, window = alone(late)
        vitrine.section(renderer, "x", (-100, 0, 0)).remove()  # the actor has keys from here on
        own = late.GetProperty()
        xray = vitrine.vtkPartXRay()
        xray.AddPart(late)
        xray.SetFloor(0.25)
        xray.Attach(renderer)
        light(window)
        for _ in range(2):
            renderer.RemoveActor(late)
            np.testing.assert_array_equal(light(window), 1.0)
            self.assertIs(late.GetProperty(), own)
            renderer.AddActor(late)
            np.testing.assert_allclose(light(window), 0.75, atol=1.5 / 255)

    def test_blocks_that_are_added(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetNumberOfBlocks(2)
        near, far = (tilted(0).GetMapper() for _ in range(2))
        for mapper in (near, far):
            mapper.Update()
        blocks.SetBlock(0, near.GetInput())
        mapper = vitrine.vtkCulledCompositePolyDataMapper()
        mapper.SetInputDataObject(blocks)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0, 0, 0)
        actor.GetProperty().LightingOff()
        renderer, window = alone(actor)
        vitrine.x_ray(window, actor, floor=0.25)
        np.testing.assert_allclose(light(window), 0.75, atol=1.5 / 255)
        blocks.SetBlock(1, far.GetInput())
        np.testing.assert_allclose(light(window), 0.75 * 0.75, atol=1.5 / 255)

    def test_looks_come_back_when_the_renderer_goes(self):
        actor = tilted(0)
        own = actor.GetProperty()
        renderer, window = alone(actor)
        handle = vitrine.x_ray(window, actor)
        light(window)
        self.assertIsNot(actor.GetProperty(), own)
        window.RemoveRenderer(renderer)
        del renderer
        gc.collect()
        self.assertIs(actor.GetProperty(), own)
        handle.remove()


class BadInput(unittest.TestCase):
    def test_is_refused(self):
        actor = ball()
        renderer, window = alone(actor)
        for error, arguments, options in [
            (ValueError, (renderer, vtkActor()), {}),
            (TypeError, (renderer, vtkActor2D()), {}),
            (KeyError, (renderer, "no such part"), {}),
            (ValueError, (vtkRenderer(),), {}),
            (ValueError, (renderer,), {"falloff": 17}),
            (ValueError, (renderer,), {"falloff": float("nan")}),
            (TypeError, (renderer,), {"falloff": "steep"}),
            (ValueError, (renderer,), {"floor": -0.1}),
        ]:
            with self.assertRaises(error, msg=(arguments, options)):
                vitrine.x_ray(*arguments, **options)

    def test_of_props_and_renderers_that_go_is_no_error(self):
        actor, empty = ball(), vtkActor()
        renderer, window = alone(actor)
        renderer.AddActor(empty)
        handle = vitrine.x_ray(window)
        light(window)
        renderer.RemoveActor(actor)
        del actor
        np.testing.assert_array_equal(light(window), 1.0)
        window.RemoveRenderer(renderer)
        del renderer
        handle.remove()


if __name__ == "__main__":
    unittest.main()
