"""reveal(): transmittances from fresh frames, analytic opacities, looks that are put back, and a turning camera."""

import gc
import math
import unittest

import numpy
from scenes import actor_of, plate, plates_renderer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkProperty, vtkRenderer

import vitrine

SHARE = 0.7
SIZE = 64


def window_of(renderer, samples=0):
    window = vitrine.vtkHeadlessRenderWindow()
    window.SetSize(SIZE, SIZE)
    window.SetMultiSamples(samples)
    window.AddRenderer(renderer)
    vitrine.see_through(renderer)
    window.Render()
    return window


def pixels(window):
    values = vtkUnsignedCharArray()
    window.GetRGBACharPixelData(0, 0, SIZE - 1, SIZE - 1, 1, values)
    return vtk_to_numpy(values).reshape(SIZE, SIZE, 4).copy()


def half_plate(z, colour, opacity):
    actor = plate(z, colour, opacity)
    actor.SetScale(0.5, 1, 1)
    actor.SetPosition(-1, 0, 0)  # x from -2 to 0
    return actor


def box(x, y, z, size=1.0):
    source = vtkCubeSource()
    source.SetCenter(x, y, z)
    source.SetXLength(size)
    source.SetYLength(size)
    source.SetZLength(size)
    source.Update()
    return source.GetOutput()


def shares_of(renderer, actor, block=0):
    """What passes the layers in front of a part, for each of its pixels, in a frame as it is drawn."""
    layers = vitrine.layers_in(renderer, 0, 0, SIZE - 1, SIZE - 1, all=True)
    shares = []
    for pixel in range(SIZE * SIZE):
        through = 1.0
        for i in range(layers.offsets[pixel], layers.offsets[pixel + 1]):
            number = layers.numbers[i]
            if layers.actor(number) is actor and layers.block(number) == block:
                shares.append(through)
                break
            through *= 1.0 - float(layers.opacities[i])
    return numpy.array(shares)


class PlatesCase(unittest.TestCase):
    """A red plate behind a black one that covers the view, and another that covers the left half of it."""

    def setUp(self):
        self.red = plate(0, (1, 0, 0), 1.0)
        self.half = half_plate(1, (0, 0, 0), 1.0)
        self.whole = plate(2, (0, 0, 0), 1.0)
        self.renderer = plates_renderer(self.red, self.half, self.whole)
        self.window = window_of(self.renderer)
        self.before = pixels(self.window)


class Plates(PlatesCase):
    def test_the_larger_part_keeps_what_may_remain(self):
        self.assertEqual(self.before[..., 0].max(), 0)
        handle = vitrine.reveal(self.window, self.red, SHARE)
        self.window.Render()
        faded = {part.actor: part for part in handle.faded}
        self.assertEqual(set(faded), {self.half, self.whole})
        self.assertEqual(faded[self.half].opacity, 0.0)  # 4096 pixels gain more than 2048
        self.assertAlmostEqual(faded[self.whole].opacity, 1 - SHARE, delta=0.004)
        self.assertEqual(faded[self.whole].original, 1.0)
        self.assertEqual(handle.hidden, 1)
        self.assertEqual((handle.pixels, handle.layers), (SIZE * SIZE, 2))
        # The box of the half plate may end within a pixel.
        self.assertAlmostEqual(handle.context, faded[self.whole].opacity * 2 / 3, delta=0.004)
        self.assertGreaterEqual(handle.proved, 0.99)
        self.assertGreaterEqual(handle.share, SHARE)
        self.assertGreaterEqual(shares_of(self.renderer, self.red).min(), SHARE)
        red = pixels(self.window)[..., 0]
        self.assertGreaterEqual(red.min(), math.floor(255 * SHARE))
        self.assertLessEqual(red.max(), math.ceil(255 * SHARE) + 2)

    def test_holds_in_multisampled_windows_and_in_viewports(self):
        for samples, left in ((4, 0.0), (0, 0.5), (4, 0.25)):
            with self.subTest(samples=samples, left=left):
                red, half, whole = plate(0, (1, 0, 0), 1.0), half_plate(1, (0, 0, 0), 1.0), plate(2, (0, 0, 0), 0.9)
                half.RotateZ(10)
                renderer = plates_renderer(red, half, whole)
                renderer.SetViewport(left, 0, 1, 1)
                window = window_of(renderer, samples)
                handle = vitrine.reveal(window, red, SHARE, least_opacity=0)
                window.Render()
                first = int(SIZE * left)
                self.assertEqual((handle.pixels, handle.layers), (SIZE * (SIZE - first), 2))
                self.assertGreaterEqual(pixels(window)[:, first:, 0].min(), math.floor(255 * SHARE))
                self.assertEqual(len(handle.faded), 2)

    def test_outlines_show_faded_and_hidden_parts_but_spare_the_part(self):
        small = plate(0, (1, 0, 0), 1.0)
        small.SetScale(0.25, 0.25, 1)  # the middle half of the view
        renderer = plates_renderer(small, half_plate(3, (0, 0, 0), 1.0), self.whole)
        window = window_of(renderer)
        plain = vitrine.reveal(window, small, SHARE, outlines=False)
        window.Render()
        without = pixels(window)
        self.assertEqual(plain.hidden, 1)
        self.assertIsNone(plain.outlines)
        opacities = [part.opacity for part in plain.faded]
        plain.remove()
        lined = vitrine.reveal(window, small, SHARE)
        lined.outlines.SetColor(0, 1, 0)
        lined.outlines.SetOpacity(1)
        window.Render()
        self.assertEqual([part.opacity for part in lined.faded], opacities)
        changed = (pixels(window) != without).any(axis=2)
        hidden_edge = numpy.zeros((SIZE, SIZE), bool)
        hidden_edge[:, SIZE // 2 - 1] = True  # of the half plate
        covered = slice(SIZE // 4, SIZE - SIZE // 4)
        self.assertFalse(changed[covered, covered].any())
        hidden_edge[covered, covered] = False
        self.assertTrue(changed[hidden_edge].all())
        lined.remove()
        window.Render()
        numpy.testing.assert_array_equal(pixels(window), pixels(window_of(renderer)))

    def test_looks_are_put_back(self):
        properties = [actor.GetProperty() for actor in (self.half, self.whole)]
        handle = vitrine.reveal(self.window, self.red, SHARE)
        self.window.Render()
        self.assertTrue((pixels(self.window) != self.before).any())
        handle.remove()
        self.window.Render()
        self.assertTrue((pixels(self.window) == self.before).all())
        self.assertEqual([actor.GetProperty() for actor in (self.half, self.whole)], properties)
        self.assertEqual([p.GetOpacity() for p in properties], [1.0, 1.0])
        self.assertTrue(self.half.GetVisibility())
        self.assertEqual(handle.faded, [])

    def test_hidden_blocks_are_found_again(self):
        self.renderer.RemoveActor(self.half)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, box(-0.5, -0.4, 1, 0.6))
        blocks.SetBlock(1, box(-0.5, 0.4, 1, 0.6))
        assembly = vitrine.from_multiblock(blocks).add_to(self.renderer)
        self.window.Render()
        handle = vitrine.reveal(self.window, self.red, SHARE, least_opacity=0)
        self.assertEqual((handle.hidden, handle.layers), (0, 3))
        handle._reveal.SetLeastOpacity(1 / 255)
        handle.update()
        for _ in range(2):
            self.window.Render()
            vitrine.layers_at(self.window, 16, 19, all=True)  # asks the actor whether it has translucent blocks now
            handle.update()
            self.assertEqual((handle.hidden, handle.layers), (2, 3))
        handle.remove()
        self.window.Render()
        self.assertEqual(pixels(self.window)[..., 0].max(), 0)
        self.assertEqual(assembly.actors.GetNumberOfActors(), 1)

    def test_another_reveal_takes_the_place_of_the_first(self):
        first = vitrine.reveal(self.window, self.red, SHARE)
        second = vitrine.reveal(self.window, self.half, 0.5)
        self.assertEqual(first.faded, [])
        self.assertEqual([part.actor for part in second.faded], [self.whole])
        self.assertTrue(self.half.GetVisibility())
        self.assertEqual(self.half.GetProperty().GetOpacity(), 1.0)
        self.assertAlmostEqual(self.whole.GetProperty().GetOpacity(), 0.5, delta=0.01)

    def test_actors_of_one_property_are_faded_apart(self):
        shared = vtkProperty()
        for actor in (self.red, self.whole):
            actor.SetProperty(shared)
        handle = vitrine.reveal(self.window, self.red, SHARE)
        self.assertEqual(shared.GetOpacity(), 1.0)
        self.assertIs(self.red.GetProperty(), shared)
        self.assertAlmostEqual(self.whole.GetProperty().GetOpacity(), 1 - SHARE, delta=0.004)
        handle.remove()
        self.assertIs(self.whole.GetProperty(), shared)

    def test_properties_of_other_renderers_are_not_faded(self):
        elsewhere = plate(0, (0, 0, 0), 1.0)
        elsewhere.SetProperty(self.whole.GetProperty())
        vitrine.reveal(self.window, self.red, SHARE)
        self.assertEqual(elsewhere.GetProperty().GetOpacity(), 1.0)

    def test_two_renderers_fade_the_same_actor(self):
        other = plates_renderer(self.red, self.whole)
        self.renderer.RemoveActor(self.half)
        self.renderer.SetViewport(0, 0, 0.5, 1)
        other.SetViewport(0.5, 0, 1, 1)
        self.window.AddRenderer(other)
        self.window.Render()
        own = self.whole.GetProperty()
        for order in (0, 1):
            first, second = vitrine.reveal(self.renderer, self.red, 0.5), vitrine.reveal(other, self.red, SHARE)
            self.assertAlmostEqual(self.whole.GetProperty().GetOpacity(), 1 - SHARE, delta=0.004)
            self.assertEqual(first.faded[0].original, 1.0)
            self.assertEqual(second.faded[0].original, 1.0)
            (first, second)[order].remove()
            left = (SHARE, 0.5)[order]
            self.assertAlmostEqual(self.whole.GetProperty().GetOpacity(), 1 - left, delta=0.01)
            (second, first)[order].remove()
            self.assertIs(self.whole.GetProperty(), own)
            self.assertEqual(own.GetOpacity(), 1.0)

    def test_the_end_of_the_renderer_puts_looks_back(self):
        outlined, hidden = self.whole, self.half
        own = outlined.GetProperty()
        vitrine.reveal(self.window, self.red, SHARE, outlines=False)
        self.assertFalse(hidden.GetVisibility())
        vitrine.reveal(self.window, self.red, SHARE)
        self.assertIsNot(outlined.GetProperty(), own)
        self.window.RemoveRenderer(self.renderer)
        del self.renderer
        gc.collect()
        self.assertTrue(hidden.GetVisibility())
        self.assertIs(outlined.GetProperty(), own)
        self.assertEqual(self.whole.GetProperty().GetOpacity(), 1.0)

    def test_what_the_user_sets_meanwhile_stays(self):
        own = self.whole.GetProperty()
        handle = vitrine.reveal(self.window, self.red, SHARE)
        self.whole.GetProperty().SetColor(0, 0, 1)
        handle.update()
        self.whole.GetProperty().SetOpacity(0.9)
        handle.update()
        self.assertAlmostEqual({part.actor: part for part in handle.faded}[self.whole].original, 0.9)
        self.assertAlmostEqual(self.whole.GetProperty().GetOpacity(), 1 - SHARE, delta=0.004)
        self.half.SetVisibility(True)
        handle.remove()
        self.assertIs(self.whole.GetProperty(), own)
        self.assertEqual((own.GetOpacity(), own.GetColor()), (0.9, (0, 0, 1)))
        self.assertTrue(self.half.GetVisibility())
        handle = vitrine.reveal(self.window, self.red, SHARE)
        other = vtkProperty()
        self.whole.SetProperty(other)
        handle.remove()
        self.assertIs(self.whole.GetProperty(), other)
        self.assertEqual(other.GetOpacity(), 1.0)

    def test_translucent_parts_keep_what_they_have(self):
        self.whole.GetProperty().SetOpacity(0.1)
        self.half.GetProperty().SetOpacity(0.1)
        handle = vitrine.reveal(self.window, self.red, SHARE)
        self.assertGreaterEqual(handle.share, 0.81 - 1e-9)
        for actor in (self.whole, self.half):
            self.assertAlmostEqual(actor.GetProperty().GetOpacity(), 0.1, delta=1e-3)

    def test_opaque_by_force_is_faded_too(self):
        self.whole.ForceOpaqueOn()
        handle = vitrine.reveal(self.window, self.red, SHARE)
        self.assertGreaterEqual(shares_of(self.renderer, self.red).min(), SHARE)
        handle.remove()
        self.assertTrue(self.whole.GetForceOpaque())

    def test_bad_input(self):
        gone = plate(3, (0, 0, 0), 1.0)
        for error, part, options in (
            (TypeError, 7, {}),
            (TypeError, self.red, {"share": "much"}),
            (ValueError, self.red, {"share": 0.0}),
            (ValueError, self.red, {"share": math.nan}),
            (ValueError, self.red, {"share": 1.5}),
            (ValueError, self.red, {"least_opacity": -1}),
            (TypeError, self.red, {"follow": 1}),
            (ValueError, (self.red, -1), {}),
            (ValueError, gone, {}),
            (ValueError, [], {}),
            (KeyError, "gear*", {}),
        ):
            with self.subTest(part=part, **options), self.assertRaises(error):
                vitrine.reveal(self.window, part, **options)
        self.red.SetVisibility(False)
        with self.assertRaisesRegex(ValueError, "no pixel of the part"):
            vitrine.reveal(self.window, self.red)
        self.assertEqual(self.whole.GetProperty().GetOpacity(), 1.0)
        unseen = vitrine.vtkHeadlessRenderWindow()
        renderer = plates_renderer(gone)
        unseen.AddRenderer(renderer)
        with self.assertRaisesRegex(RuntimeError, "no frame"):
            vitrine.reveal(unseen, gone)
        self.assertEqual(vitrine.vtkReveal().GetNumberOfFadedParts(), 0)

    def test_settings_out_of_range_are_refused(self):
        made = vitrine.vtkReveal()
        errors = []
        made.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        for name in ("Share", "LeastOpacity", "ChangePerDegree"):
            before = getattr(made, f"Get{name}")()
            for value in (math.nan, -0.1, 1.1):
                getattr(made, f"Set{name}")(value)
                self.assertEqual(getattr(made, f"Get{name}")(), before)
        self.assertEqual(len(errors), 9)


def boxes():
    """27 boxes as blocks of an assembly, the middle of which is wholly hidden."""
    blocks = vtkMultiBlockDataSet()
    for i in range(27):
        blocks.SetBlock(i, box(i % 3, i // 3 % 3, i // 9, 1.02))
        blocks.GetMetaData(i).Set(blocks.NAME(), "core" if i == 13 else f"box{i}")
    return vitrine.from_multiblock(blocks)


class Cutaways(unittest.TestCase):
    """A small red plate behind forty opaque black ones that cover the view."""

    def setUp(self):
        self.small = plate(0, (1, 0, 0), 1.0)
        self.small.SetScale(0.25, 0.25, 1)  # the middle half of the view
        self.others = [plate(0.02 + 0.01 * i, (0, 0, 0), 1.0) for i in range(40)]
        self.renderer = plates_renderer(self.small, *self.others, background=(1, 1, 1))
        self.window = window_of(self.renderer)
        self.before = pixels(self.window)

    def test_cuts_what_would_vanish_and_leaves_the_rest_as_it_is(self):
        faded = vitrine.reveal(self.window, self.small, SHARE, outlines=False)
        self.assertEqual((len(faded.faded), faded.layers, faded.cut), (40, 40, []))
        handle = vitrine.reveal(self.window, self.small, SHARE, cutaway=True)
        self.assertEqual((len(handle.cut), handle.faded, handle.layers), (40, [], 40))
        self.assertEqual(set(handle.cut), set(self.others))
        self.assertEqual((handle.share, handle.context), (1.0, 1.0))
        self.window.Render()
        self.assertEqual(shares_of(self.renderer, self.small).tolist(), [1.0] * (SIZE * SIZE // 4))
        after = pixels(self.window)
        quarter = SIZE // 4
        middle = after[quarter:-quarter, quarter:-quarter]
        numpy.testing.assert_array_equal(middle[..., :3], numpy.broadcast_to((255, 0, 0), middle[..., :3].shape))
        opened = math.ceil(0.41 * math.tan(math.radians(15)) * SIZE / 2) + 3  # pixels beside the part, and a margin
        rim = quarter - opened
        after[rim:-rim, rim:-rim] = self.before[rim:-rim, rim:-rim]
        numpy.testing.assert_array_equal(after, self.before)
        handle.remove()
        self.window.Render()
        numpy.testing.assert_array_equal(pixels(self.window), self.before)
        self.assertIsNone(vitrine.vtkSection.GetAttached(self.renderer))

    def test_has_caps_in_the_first_frame_of_a_turn(self):
        for other in self.others:
            self.renderer.RemoveActor(other)
        for z in (0.3, 0.8):
            actor = actor_of(vtkCubeSource())
            actor.SetScale(3, 3, 0.3)
            actor.SetPosition(0, 0, z)
            self.renderer.AddActor(actor)
        self.window.Render()
        handle = vitrine.reveal(self.window, self.small, SHARE, cutaway=1.0, follow=True, outlines=False)
        self.window.Render()
        self.assertEqual(len(handle.cut), 2)
        self.renderer.GetActiveCamera().Azimuth(5)
        self.window.Render()
        first = pixels(self.window)
        self.window.Render()
        numpy.testing.assert_array_equal(pixels(self.window), first)

    def test_fades_what_keeps_enough(self):
        for other in self.others[2:]:
            self.renderer.RemoveActor(other)
        self.window.Render()
        self.assertEqual(vitrine.reveal(self.window, self.small, SHARE, cutaway=True).cut, [])
        handle = vitrine.reveal(self.window, self.small, SHARE, cutaway=0.5)
        self.assertEqual((len(handle.cut), len(handle.faded)), (2, 0))

    def test_needs_the_section_of_the_renderer(self):
        with vitrine.section(self.renderer, "z", (0, 0, -1)):
            with self.assertRaisesRegex(RuntimeError, "section of the renderer"):
                vitrine.reveal(self.window, self.small, SHARE, cutaway=True)
            vitrine.reveal(self.window, self.small, SHARE).remove()
        handle = vitrine.reveal(self.window, self.small, SHARE, cutaway=True)
        with self.assertRaisesRegex(ValueError, "cuts parts of the target away"):
            vitrine.section(self.renderer, "z", (0, 0, -1))
        handle.remove()
        vitrine.section(self.renderer, "z", (0, 0, -1)).remove()


    def test_the_end_of_the_renderer_ends_all_that_shows_there(self):
        looks = [vitrine.highlight(self.window, self.small), vitrine.x_ray(self.window, self.others[0])]
        handle = vitrine.reveal(self.window, self.small, SHARE, cutaway=True)
        self.window.Render()
        self.assertGreater(len(handle.cut), 0)
        del self.renderer, self.window
        gc.collect()
        self.assertEqual(handle.cut, [])
        for each in (*looks, handle):
            each.remove()


class Changes(PlatesCase):
    def test_what_changes_is_followed(self):
        handle = vitrine.reveal(self.window, self.red, SHARE, follow=True, outlines=False)

        def least_after(change):
            change()
            self.window.Render()
            return shares_of(self.renderer, self.red).min(), len(handle.faded)

        wanted = (
            (lambda: self.renderer.AddActor(half_plate(3, (0, 0, 0), 1.0)), 3),
            (lambda: self.half.SetPosition(0, 0, 0), 3),
            (lambda: self.whole.VisibilityOff(), 2),
        )
        for change, count in wanted:
            with self.subTest(count):
                least, faded = least_after(change)
                self.assertGreaterEqual(least, SHARE)
                self.assertEqual(faded, count)
        self.renderer.SetViewport(0, 0, 0.5, 1)
        self.window.Render()
        self.assertEqual(handle.pixels, SIZE * SIZE // 2)
        times = [actor.GetMTime() for actor in (self.red, self.half)]
        self.window.Render()
        self.assertEqual(times, [actor.GetMTime() for actor in (self.red, self.half)])  # nothing was done

    def test_a_part_that_comes_back_is_followed(self):
        handle = vitrine.reveal(self.window, self.red, SHARE, follow=True)
        self.renderer.RemoveActor(self.red)
        self.window.Render()
        self.assertEqual((handle.faded, self.whole.GetProperty().GetOpacity()), ([], 1.0))
        self.renderer.AddActor(self.red)
        self.window.Render()
        self.assertGreaterEqual(shares_of(self.renderer, self.red).min(), SHARE)
        handle._reveal.SetOutlines(None)
        self.assertFalse(self.half.GetVisibility())  # it is hidden in another way
        self.assertEqual(len(handle.faded), 2)
        self.renderer.RemoveActor(self.half)
        self.window.Render()
        self.assertEqual(len(handle.faded), 1)

    def test_a_failure_leaves_the_former_reveal(self):
        first = vitrine.reveal(self.window, self.red, SHARE)
        away = plate(0, (0, 1, 0), 1.0)
        away.SetPosition(50, 0, 0)
        self.renderer.AddActor(away)
        with self.assertRaisesRegex(ValueError, "no pixel"):
            vitrine.reveal(self.window, away, SHARE)
        self.window.Render()
        self.assertGreaterEqual(shares_of(self.renderer, self.red).min(), SHARE)
        self.assertEqual(len(first.faded), 2)
        self.renderer.RemoveActor(self.red)
        with self.assertRaisesRegex(RuntimeError, "not in the renderer"):
            first.update()
        self.assertEqual(self.whole.GetProperty().GetOpacity(), 1.0)
        first.remove()
        with self.assertRaisesRegex(RuntimeError, "removed"):
            first.update()

    def test_parts_may_count_alike(self):
        handle = vitrine.reveal(self.window, self.red, SHARE, weights="equal")
        for part in handle.faded:
            self.assertAlmostEqual(part.opacity, 1 - math.sqrt(SHARE), delta=0.01)
        bad = (ValueError, {"weights": "x"}), (TypeError, {"cutaway": "x"}), (ValueError, {"cutaway": 2})
        for error, more in bad:
            with self.subTest(more), self.assertRaises(error):
                vitrine.reveal(self.window, self.red, SHARE, **more)


class Blocks(unittest.TestCase):
    def setUp(self):
        self.assembly = boxes()
        self.renderer = vtkRenderer()
        self.assembly.add_to(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(1, 1, 1)
        camera.SetPosition(6, 5, 9)
        self.renderer.ResetCameraClippingRange()
        self.window = window_of(self.renderer)
        number = self.assembly["core"].numbers[0]
        self.core = self.assembly.actors.GetPartActor(number), self.assembly.actors.GetPartBlock(number)

    def test_parts_of_an_assembly(self):
        before = pixels(self.window)
        self.assertEqual(shares_of(self.renderer, *self.core).max(), 0.0)
        handle = vitrine.reveal(self.renderer, "core", SHARE)
        self.window.Render()
        shares = shares_of(self.renderer, *self.core)
        self.assertEqual(len(shares), handle.pixels)
        self.assertGreaterEqual(shares.min(), SHARE)
        self.assertLessEqual(shares.min(), SHARE + 0.01)
        self.assertTrue(all(part.part.name.startswith("box") for part in handle.faded))
        for same in (self.core, self.assembly.parts[13], self.assembly["core"]):
            self.assertEqual(vitrine.reveal(self.renderer, same, SHARE).pixels, len(shares))
        vitrine.reveal(self.renderer, "core", SHARE).remove()
        self.window.Render()
        self.assertTrue((pixels(self.window) == before).all())

    def test_opacities_follow_the_camera(self):
        mapper = self.core[0].GetMapper()
        self.renderer.AddObserver("EndEvent", lambda *_: mapper.Modified())  # as frames change mappers of many blocks
        handle = vitrine.reveal(self.renderer, "core", SHARE, follow=True)
        state = vitrine._reveal._reveals[self.renderer.__this__]._reveal
        jumps = 0
        for _ in range(12):
            before = {(part.actor, part.block): part.opacity for part in handle.faded}
            self.renderer.GetActiveCamera().Azimuth(2)
            self.window.Render()
            self.assertEqual(state.GetProblem(), "")
            self.assertGreaterEqual(shares_of(self.renderer, *self.core).min(), SHARE)
            self.assertLessEqual(state.GetLargestChange(), 0.05 * 2 + 1e-6)
            changes = [abs(before.get((p.actor, p.block), p.original) - p.opacity) for p in handle.faded]
            jumped = sum(change > 0.05 * 2 + 1 / 255 for change in changes)
            self.assertLessEqual(jumped, state.GetNumberOfDroppedParts() + state.GetNumberOfForcedParts())
            jumps += jumped
        self.assertGreater(jumps, 0)  # parts come in front
        frames = [pixels(self.window)]
        self.window.Render()
        self.assertTrue((pixels(self.window) == frames[0]).all())  # nothing changes at rest
        handle.remove()
        self.renderer.GetActiveCamera().Azimuth(2)
        self.window.Render()
        self.assertEqual(shares_of(self.renderer, *self.core).max(), 0.0)


if __name__ == "__main__":
    unittest.main()
