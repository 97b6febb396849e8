"""Outlines of parts over the picture: where they are, with what they agree, and what is refused."""

import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkActor2D, vtkRenderer, vtkVolume

import vitrine
from scenes import actor_of, pixels, plate, plates_renderer, run_interpreter, window_with

SIZE = 64  # pixels of two units
ORANGE = (255, 128, 0)
GREY = 91


def rectangle(x0, x1, y0, y1, z=0.0):
    """A plane with edges in the middle between rows of pixels, from pixel x0 to x1 - 1 and y0 to y1 - 1."""
    left, right, low, high = (2.0 * at / SIZE - 1.0 for at in (x0, x1, y0, y1))
    plane = vtkPlaneSource()
    plane.SetOrigin(left, low, z)
    plane.SetPoint1(right, low, z)
    plane.SetPoint2(left, high, z)
    return plane


def part(*arguments, opacity=1.0):
    actor = actor_of(rectangle(*arguments))
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetOpacity(opacity)
    return actor


def hidden(*parts):
    """A renderer whose opaque grey plate hides the parts, and its window."""
    renderer = plates_renderer(*parts, plate(1.0, (GREY / 255,) * 3, 1.0))
    return renderer, window_with(renderer, size=(SIZE, SIZE))


def border(x0, x1, y0, y1, width=1):
    """The pixels of the border of a rectangle."""
    mask = np.zeros((SIZE, SIZE), bool)
    mask[y0:y1, max(x0, 0) : x1] = True
    mask[y0 + width : y1 - width, max(x0 + width, 0) : x1 - width] = False
    return mask


def marked(window):
    """The pixels that are not of the grey plate."""
    window.Render()
    return (pixels(window)[..., :3] != GREY).any(axis=2)


class Outlines(unittest.TestCase):
    def test_are_the_border_of_a_hidden_rectangle(self):
        for multisamples in (0, 4):
            for width in (1, 2, 5):
                actor = part(16, 48, 10, 40)
                renderer, window = hidden(actor)
                window.SetMultiSamples(multisamples)
                self.assertFalse(marked(window).any())
                with vitrine.highlight(renderer, actor, width=width, fill=0.0):
                    np.testing.assert_array_equal(marked(window), border(16, 48, 10, 40, width))
                    self.assertEqual(tuple(pixels(window)[10, 16, :3]), ORANGE)
                self.assertFalse(marked(window).any())

    def test_have_a_tint_within(self):
        actor = part(16, 48, 10, 40)
        renderer, window = hidden(actor)
        vitrine.highlight(renderer, actor, color=(1, 1, 1), width=0, fill=0.5)
        expected = np.full((SIZE, SIZE), GREY)
        expected[10:40, 16:48] = (GREY + 255) // 2
        window.Render()
        np.testing.assert_array_equal(pixels(window)[..., 0], expected)

    def test_lie_on_both_sides_of_the_border_of_two_parts(self):
        left, right = part(10, 30, 10, 40), part(30, 50, 10, 40)
        renderer, window = hidden(left, right)
        vitrine.highlight(renderer, [left, right], width=1, fill=0.0)
        np.testing.assert_array_equal(marked(window), border(10, 30, 10, 40) | border(30, 50, 10, 40))

    def test_follow_the_nearer_of_two_translucent_parts(self):
        near, far = part(10, 30, 10, 40, 0.5, opacity=0.3), part(20, 50, 20, 30, 0.0, opacity=0.3)
        for order in ([near, far], [far, near]):
            renderer, window = hidden(*order)
            vitrine.see_through(window)
            vitrine.highlight(renderer, order, width=1, fill=0.0)
            behind = np.zeros((SIZE, SIZE), bool)
            behind[20:30, 30:50] = True
            expected = border(10, 30, 10, 40) | (border(30, 50, 20, 30) & behind)
            np.testing.assert_array_equal(marked(window), expected)

    def test_do_not_cross_the_edge_of_the_view(self):
        actor = part(-20, 30, 10, 40)
        renderer, window = hidden(actor)
        vitrine.highlight(renderer, actor, width=1, fill=0.0)
        np.testing.assert_array_equal(marked(window), border(-20, 30, 10, 40))

    def test_leave_excluded_parts_alone(self):
        actor, other = part(16, 48, 10, 40), part(30, 60, 5, 20, -1.0)
        renderer, window = hidden(actor, other)
        handle = vitrine.highlight(renderer, actor, width=1, fill=0.0)
        handle._shown[0].AddExcludedPart(other)
        expected = border(16, 48, 10, 40)
        expected[5:20, 30:60] = False
        np.testing.assert_array_equal(marked(window), expected)
        handle._shown[0].RemoveAllExcludedParts()
        np.testing.assert_array_equal(marked(window), border(16, 48, 10, 40))

    def test_agree_with_sections_clipping_planes_and_visibility(self):
        actor = part(16, 48, 10, 40)
        renderer, window = hidden(actor)
        vitrine.highlight(renderer, actor, width=1, fill=0.0)
        with vitrine.section(renderer, "-x", (0, 0, 0), parts=actor):
            np.testing.assert_array_equal(marked(window), border(16, 32, 10, 40))
        plane = vtkPlane()
        plane.SetNormal(0, 1, 0)
        plane.SetOrigin(0, 20 * 2 / SIZE - 1, 0)
        actor.GetMapper().AddClippingPlane(plane)
        np.testing.assert_array_equal(marked(window), border(16, 48, 20, 40))
        actor.SetPosition(4 * 2 / SIZE, 0, 0)
        np.testing.assert_array_equal(marked(window), border(20, 52, 20, 40))
        actor.VisibilityOff()
        self.assertFalse(marked(window).any())

    def test_are_of_blocks_by_pattern_and_by_pick(self):
        data = vtkMultiBlockDataSet()
        for i, place in enumerate([(5, 20, 5, 20), (30, 50, 30, 40)]):
            plane = rectangle(*place)
            plane.Update()
            data.SetBlock(i, plane.GetOutput())
            data.GetMetaData(i).Set(data.NAME(), f"plate_{i}")
        assembly = vitrine.from_multiblock(data)
        renderer, window = hidden()
        assembly.add_to(renderer)
        renderer.ResetCameraClippingRange()
        for what in ("plate_1", assembly["plate_1"], assembly.parts[1]):
            with vitrine.highlight(window, what, width=1, fill=0.0):
                np.testing.assert_array_equal(marked(window), border(30, 50, 30, 40))
        with vitrine.highlight(window, "plate_*", width=1, fill=0.0) as both:
            np.testing.assert_array_equal(marked(window), border(5, 20, 5, 20) | border(30, 50, 30, 40))
            self.assertEqual(repr(both), "<Highlight of 2 parts>")
        assembly["plate_0"].visible = False
        with vitrine.highlight(window, "plate_*", width=1, fill=0.0):
            np.testing.assert_array_equal(marked(window), border(30, 50, 30, 40))
        layers = vitrine.layers_at(window, 35, 35, all=True)
        with vitrine.highlight(window, layers[1], width=1, fill=0.0):
            np.testing.assert_array_equal(marked(window), border(30, 50, 30, 40))

    def test_are_of_the_viewport_of_their_renderer(self):
        actor = part(16, 48, 16, 48)
        renderer, window = hidden(actor)
        renderer.SetViewport(0.5, 0.25, 1.0, 0.75)
        other, _ = hidden(part(16, 48, 16, 48))
        other.SetViewport(0.0, 0.0, 0.5, 1.0)
        window.AddRenderer(other)
        vitrine.highlight(window, actor, width=1, fill=0.0)
        window.Render()
        orange = (pixels(window)[..., :3] == ORANGE).all(axis=2)
        np.testing.assert_array_equal(orange, border(40, 56, 24, 40))

    def test_do_not_change_what_is_drawn_with_the_culler_and_all_methods(self):
        ball = actor_of(vtkSphereSource())
        for method in vitrine.vtkTransparencyPass.GetExactMethods().split(","):
            renderer, window = hidden(ball, part(16, 48, 10, 40, 0.7, opacity=0.5))
            vitrine.see_through(window, method=method, cull=True)
            window.Render()
            before = pixels(window)
            outlines = vitrine.highlight(window, ball, width=1, fill=0.0)
            window.Render()
            after = pixels(window)
            changed = (after != before).any(axis=2)
            self.assertTrue((after[changed][:, :3] == ORANGE).all())
            self.assertGreater(changed.sum(), 80)
            outlines.remove()
            window.Render()
            np.testing.assert_array_equal(pixels(window), before)


class OlderDriver(unittest.TestCase):
    def test_has_outlines_and_x_rays(self):
        tests = ["test_highlight.Outlines.test_are_the_border_of_a_hidden_rectangle"]
        tests += ["test_x_ray.Formula.test_holds_for_faces_without_normals_in_both_projections"]
        older = {"MESA_GL_VERSION_OVERRIDE": "3.2", "MESA_GLSL_VERSION_OVERRIDE": "150"}
        result = run_interpreter("-m", "unittest", *tests, **older)
        self.assertEqual(result.returncode, 0, result.stderr)


class BadInput(unittest.TestCase):
    def test_is_refused(self):
        actor = part(16, 48, 10, 40)
        renderer, window = hidden(actor)
        stranger = vtkActor()
        for error, arguments, options in [
            (ValueError, (renderer, stranger), {}),
            (TypeError, (renderer, vtkVolume()), {}),
            (TypeError, (renderer, vtkActor2D()), {}),
            (TypeError, (renderer, 3), {}),
            (ValueError, (renderer, (actor, 99)), {}),
            (KeyError, (renderer, "no such part"), {}),
            (ValueError, (renderer, []), {}),
            (ValueError, (renderer, actor), {"width": 9}),
            (TypeError, (renderer, actor), {"width": float("nan")}),
            (ValueError, (renderer, actor), {"opacity": float("nan")}),
            (ValueError, (renderer, actor), {"fill": -0.1}),
            (ValueError, (renderer, actor), {"color": "no colour"}),
            (TypeError, ("renderer", actor), {}),
        ]:
            with self.assertRaises(error, msg=(arguments, options)):
                vitrine.highlight(*arguments, **options)
        self.assertFalse(marked(window).any())

    def test_of_props_and_renderers_that_go_is_no_error(self):
        actor, empty = part(16, 48, 10, 40), vtkActor()
        renderer, window = hidden(actor, empty)
        handle = vitrine.highlight(renderer, [actor, empty], width=1, fill=0.0)
        self.assertEqual(marked(window).sum(), border(16, 48, 10, 40).sum())
        renderer.RemoveActor(actor)
        del actor
        self.assertFalse(marked(window).any())
        window.RemoveRenderer(renderer)
        del renderer
        handle.remove()
        self.assertEqual(repr(handle), "<Highlight, removed>")


if __name__ == "__main__":
    unittest.main()
