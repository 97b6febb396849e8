"""layers_at(), layers_in() and pick(): what lies under pixels, for each kind of target, and what they refuse."""

import gc
import itertools
import unittest

import numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkCompositePolyDataMapper, vtkRenderer, vtkRenderWindow

import vitrine
from scenes import actor_of, drawn, pixels, plate, plates_renderer, window_with

RED, GREEN, BLUE = (1, 0, 0), (0, 1, 0), (0, 0, 1)


def scene():
    """Plates from front to back: translucent, opaque, and translucent behind it."""
    return [plate(1, RED, 0.75), plate(0, GREEN, 1.0), plate(-1, BLUE, 0.5)]


def machine():
    """An assembly of two cubes, one of them within the other."""
    blocks = vtkMultiBlockDataSet()
    for number, (name, size) in enumerate((("housing", 1.0), ("bolt", 0.4))):
        cube = vtkCubeSource()
        cube.SetXLength(size)
        cube.SetYLength(size)
        cube.SetZLength(size)
        cube.Update()
        blocks.SetBlock(number, cube.GetOutput())
        blocks.GetMetaData(number).Set(blocks.NAME(), name)
    made = vitrine.from_multiblock(blocks)
    made["housing"].opacity = 0.2
    return made


class LayersAt(unittest.TestCase):
    def test_tells_layers_of_each_target_and_method(self):
        for method, numbers, samples in itertools.product(
            (None, "linked-list", "stencil-routed"), (False, True), (0, 4)
        ):
            if numbers and method != "linked-list" or samples and method == "stencil-routed":
                continue
            with self.subTest(method=method, numbers=numbers, samples=samples):
                plates = scene()
                renderer = plates_renderer(*plates)
                if method:
                    vitrine.see_through(renderer, method, part_numbers=numbers)
                window = drawn(renderer, multisamples=samples)
                for target in (renderer, window):
                    seen = vitrine.layers_at(target, 20, 30)
                    self.assertEqual([layer.actor for layer in seen], plates[:2])
                    numpy.testing.assert_allclose([layer.share for layer in seen], [0.75, 0.25], atol=1e-4)
                    every = vitrine.layers_at(target, 20, 30, all=True, cells=True)
                    self.assertEqual([layer.actor for layer in every], plates)
                    self.assertEqual([layer.cell for layer in every], [0, 0, 0])
                    numpy.testing.assert_allclose([layer.position[2] for layer in every], [1, 0, -1], atol=1e-5)
                    self.assertEqual([layer.opaque for layer in every], [False, True, False])
                    self.assertEqual(every[2].share, 0)
                    numpy.testing.assert_allclose(every[0].color, RED, atol=1e-3)

    def test_tells_parts_of_assemblies(self):
        made = machine()
        renderer = vtkRenderer()
        made.add_to(renderer)
        vitrine.see_through(renderer, part_numbers=True)
        renderer.ResetCamera()
        window = drawn(renderer)
        names = [layer.part.name for layer in vitrine.layers_at(window, 32, 24)]
        self.assertEqual(names, ["housing", "bolt"])
        self.assertEqual(vitrine.pick(window, 32, 24).part.name, "bolt")
        self.assertEqual(vitrine.pick(window, 32, 24, through=0.1).part.name, "housing")
        made["bolt"].visible = False
        layers = vitrine.layers_at(window, 32, 24, all=True)
        self.assertEqual([layer.part.name for layer in layers], ["housing", "housing"])
        self.assertEqual([layer.front for layer in layers], [True, False])
        self.assertIsNone(vitrine.pick(window, 32, 24))

    def test_agrees_with_clipping(self):
        plates = scene()
        plane = vtkPlane()
        plane.SetNormal(1, 0, 0)
        plates[1].GetMapper().AddClippingPlane(plane)
        window = drawn(plates_renderer(*plates))
        self.assertEqual([layer.actor for layer in vitrine.layers_at(window, 5, 5)], [plates[0], plates[2]])
        self.assertEqual([layer.actor for layer in vitrine.layers_at(window, 60, 5)], plates[:2])

    def test_takes_the_viewport_of_the_pixel(self):
        left, right = plates_renderer(plate(0, RED, 0.5)), plates_renderer(plate(0, BLUE, 0.5))
        left.SetViewport(0, 0, 0.5, 1)
        right.SetViewport(0.5, 0, 1, 1)
        window = window_with(left)
        window.AddRenderer(right)
        window.Render()
        self.assertEqual(vitrine.layers_at(window, 4, 4)[0].color, (1, 0, 0))
        self.assertEqual(vitrine.layers_at(window, 60, 4)[0].color, (0, 0, 1))
        with self.assertRaisesRegex(ValueError, "in no viewport"):
            vitrine.layers_at(left, 60, 4)

    def test_leaves_the_picture_and_forgets_what_is_gone(self):
        plates = scene()
        renderer = plates_renderer(*plates)
        window = drawn(renderer)
        layer = vitrine.layers_at(window, 20, 30)[0]
        renderer.RemoveActor(plates[0])
        del plates, layer
        gc.collect()
        self.assertEqual(len(vitrine.layers_at(window, 20, 30)), 1)

    def test_names_the_whole_prop_where_blocks_have_no_attributes(self):
        blocks = vtkMultiBlockDataSet()
        for number, x in enumerate((-0.6, 0.6)):
            cube = vtkCubeSource()
            cube.SetCenter(x, 0, 0)
            cube.Update()
            blocks.SetBlock(number, cube.GetOutput())
        mapper = vtkCompositePolyDataMapper()
        mapper.SetInputDataObject(blocks)
        actor = vtkActor()
        actor.SetMapper(mapper)
        window = drawn(plates_renderer(actor))
        has_blocks = vtkVersion().GetVTKMajorVersion() == 9 and vtkVersion().GetVTKMinorVersion() >= 3
        self.assertEqual([vitrine.pick(window, x, 24).block for x in (16, 48)], [1, 2] if has_blocks else [0, 0])
        before = pixels(window)
        vitrine.section(window, "y", (0, 0, 0), parts=(actor, 2))
        window.Render()
        changed = (pixels(window) != before).any(axis=(0, 2))
        self.assertEqual((changed[:32].any(), changed[32:].any()), (not has_blocks, True))

    def test_the_prop_drawn_last_is_in_front_of_others_at_its_depth(self):
        plates = [plate(0, color, 1.0) for color in (RED, GREEN, BLUE)]
        renderer = plates_renderer(*plates)
        window = drawn(renderer)
        self.assertEqual([layer.actor for layer in vitrine.layers_at(window, 20, 30, all=True)], plates[::-1])
        renderer.RemoveActor(plates[0])
        renderer.AddActor(plates[0])
        window.Render()
        self.assertEqual(tuple(pixels(window)[30, 20, :3]), (255, 0, 0))
        self.assertIs(vitrine.pick(window, 20, 30).actor, plates[0])

    def test_is_of_the_camera_as_it_is_now(self):
        plates = scene()
        renderer = plates_renderer(*plates)
        vitrine.see_through(renderer, part_numbers=True)
        window = drawn(renderer)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(0, 0, 12)
        for _ in range(2):
            layers = vitrine.layers_at(window, 20, 30)
            numpy.testing.assert_allclose([layer.position[2] for layer in layers], [1, 0], atol=1e-5)
            window.Render()
        camera.SetPosition(20, 0, 10)
        camera.SetFocalPoint(20, 0, 0)
        self.assertEqual(vitrine.layers_at(window, 20, 30), [])

    def test_releases_in_its_own_window_while_another_is_current(self):
        picker = vitrine.vtkLayerPicker()
        renderer = plates_renderer(*scene())
        own = drawn(renderer)
        picker.SetRenderer(renderer)
        self.assertTrue(picker.Pick())
        tiles = [actor_of(vtkCubeSource()) for _ in range(25)]  # so many that buffers have the names of the picker's
        for number, tile in enumerate(tiles):
            tile.SetScale(0.3)
            tile.SetPosition(number % 5 * 0.4 - 0.8, number // 5 * 0.4 - 0.8, 0)
        other = drawn(plates_renderer(*tiles))
        before = pixels(other)
        picker.ReleaseGraphicsResources()
        other.Render()
        numpy.testing.assert_array_equal(pixels(other), before)
        self.assertTrue(picker.Pick())
        self.assertEqual(own.GetRenderers().GetNumberOfItems(), 1)

    def test_tells_each_time_that_a_prop_cannot_be_captured(self):
        plates = scene()
        code = "//VTK::System::Dec\n//VTK::Output::Dec\nvoid main() { gl_FragData[0] = vec4(1); }\n"
        plates[0].GetShaderProperty().SetFragmentShaderCode(code)
        window = drawn(plates_renderer(*plates))
        for _ in range(2):
            with self.assertRaisesRegex(RuntimeError, "cannot be captured"):
                vitrine.layers_at(window, 20, 30)
        plates[0].GetShaderProperty().SetFragmentShaderCode(None)
        self.assertEqual(len(vitrine.layers_at(window, 20, 30)), 2)


class LayersIn(unittest.TestCase):
    def test_has_arrays_of_all_pixels(self):
        plates = scene()
        for numbers in (False, True):
            renderer = plates_renderer(*plates)
            vitrine.see_through(renderer, part_numbers=numbers)
            window = drawn(renderer)
            found = vitrine.layers_in(window, 0, 0, 63, 47)
            self.assertEqual(found.offsets.tolist(), list(range(0, 2 * 64 * 48 + 1, 2)))
            self.assertEqual({found.actor(n) for n in set(found.numbers.tolist())}, set(plates[:2]))
            numpy.testing.assert_allclose(found.shares[:2], [0.75, 0.25], atol=1e-4)
            self.assertTrue((numpy.diff(found.depths)[::2] > 0).all())
            glass = vitrine.layers_in(window, 3, 4, 5, 5, opaque=False)
            self.assertEqual((glass.width, glass.height, len(glass.numbers)), (3, 2, 6))
            self.assertEqual(len(vitrine.layers_in(window, 3, 4, 5, 5, all=True).numbers), 18)
            self.assertIsNone(glass.part(int(glass.numbers[0])))
            self.assertEqual((glass.actor(-1), glass.block(2**32)), (None, 0))
            with self.assertRaisesRegex(TypeError, "one of Layers.numbers"):
                glass.part("red")


class Refusals(unittest.TestCase):
    def test_say_what_to_do(self):
        window = drawn(plates_renderer(*scene()))
        nan = float("nan")
        for error, text, call in (
            (ValueError, "in no viewport", lambda: vitrine.layers_at(window, 64, 0)),
            (ValueError, "in no viewport", lambda: vitrine.layers_at(window, 0, -1)),
            (ValueError, "in no viewport", lambda: vitrine.layers_at(window, 2**80, 0)),
            (ValueError, "a whole number", lambda: vitrine.layers_at(window, 1.5, 0)),
            (ValueError, "a whole number", lambda: vitrine.layers_at(window, nan, 0)),
            (ValueError, "a whole number", lambda: vitrine.pick(window, 0, float("inf"))),
            (TypeError, "a whole number", lambda: vitrine.layers_at(window, "1", 0)),
            (TypeError, "a whole number", lambda: vitrine.layers_at(window, None, 0)),
            (TypeError, "True or False", lambda: vitrine.layers_at(window, 1, 0, all=1)),
            (TypeError, "is needed", lambda: vitrine.layers_at(None, 1, 0)),
            (ValueError, "not within", lambda: vitrine.layers_in(window, 0, 0, 64, 4)),
            (ValueError, "left of or below", lambda: vitrine.layers_in(window, 3, 3, 2, 4)),
            (ValueError, "through is a number", lambda: vitrine.pick(window, 1, 0, through=0)),
            (ValueError, "through is a number", lambda: vitrine.pick(window, 1, 0, through=nan)),
            (TypeError, "through is a number", lambda: vitrine.pick(window, 1, 0, through="a")),
            (RuntimeError, "no frame", lambda: vitrine.layers_at(window_with(plates_renderer()), 1, 0)),
            (ValueError, "no renderer", lambda: vitrine.layers_at(vtkRenderWindow(), 1, 0)),
            (RuntimeError, "no window", lambda: vitrine.layers_at(vtkRenderer(), 1, 0)),
            (ValueError, "no option", lambda: vitrine.see_through(window, "truth", part_numbers=True)),
            (TypeError, "part_numbers", lambda: vitrine.see_through(window, part_numbers=1)),
        ):
            with self.subTest(text=text), self.assertRaisesRegex(error, text):
                call()
        self.assertEqual(len(vitrine.layers_at(window, numpy.int64(3), 4.0)), 2)


if __name__ == "__main__":
    unittest.main()
