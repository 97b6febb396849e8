"""The culler from Python: what the documentation shows, and what windows of applications have."""

import unittest

import numpy
from scenes import actor_of, pixels, plate, plates_renderer, window_with
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkAssembly, vtkRenderWindow, vtkWindowToImageFilter

from vitrine import vtkHierarchicalSBufferCuller

RED = (1.0, 0.0, 0.0)


def cull(renderer):
    """As README.md has it."""
    culler = vtkHierarchicalSBufferCuller()
    renderer.GetCullers().RemoveAllItems()
    renderer.AddCuller(culler)
    return culler


def hidden_scene(cones=5):
    """A red plate, and cones behind it."""
    renderer = plates_renderer(plate(1.0, RED, 1.0))
    for i in range(cones):
        cone = actor_of(vtkConeSource())
        cone.SetPosition(0.2 * i - 0.5, 0.0, -1.0)
        cone.SetScale(0.3)
        renderer.AddActor(cone)
    renderer.ResetCameraClippingRange()
    return renderer


def screenshot(window, scale):
    reader = vtkWindowToImageFilter()
    reader.SetInput(window)
    reader.SetScale(scale)
    reader.ReadFrontBufferOff()
    reader.Update()
    image = reader.GetOutput()
    return image.GetDimensions(), vtk_to_numpy(image.GetPointData().GetScalars()).copy()


class Culler(unittest.TestCase):
    def test_leaves_out_what_is_hidden(self):
        renderer = hidden_scene()
        culler = cull(renderer)
        window = window_with(renderer)
        window.Render()
        self.assertEqual((culler.GetNumberOfCulledParts(), culler.GetNumberOfDrawnProps()), (5, 1))
        culled = pixels(window)
        culler.CullingOff()
        window.Render()
        self.assertEqual(culler.GetNumberOfCulledParts(), 0)
        numpy.testing.assert_array_equal(culled, pixels(window))

    def test_buffer_is_an_image_of_depths(self):
        renderer = hidden_scene()
        culler = cull(renderer)
        self.assertIsNone(culler.GetBufferImage(renderer))
        self.assertIsNone(culler.GetBufferImage(None))
        window = window_with(renderer)
        window.Render()
        image = culler.GetBufferImage(renderer)
        self.assertEqual(image.GetDimensions(), (*window.GetSize(), 1))
        depths = vtk_to_numpy(image.GetPointData().GetScalars())
        near, far = renderer.GetActiveCamera().GetClippingRange()
        self.assertLess(abs(depths - (far - 9.0) / (far - near)).max(), 1e-4)

    def test_marked_parts_hide_nothing(self):
        renderer = hidden_scene()
        culler = cull(renderer)
        window = window_with(renderer)
        keys = vtkInformation()
        renderer.GetActors().GetItemAsObject(0).SetPropertyKeys(keys)
        for mark, culled in ((0, 5), (1, 0), (0, 5)):
            keys.Set(vtkHierarchicalSBufferCuller.NON_OCCLUDING(), mark)
            window.Render()
            self.assertEqual(culler.GetNumberOfCulledParts(), culled)

    def test_parts_that_come_and_go_and_are_shared_by_renderers(self):
        left, right = hidden_scene(), hidden_scene(0)
        for i in range(left.GetActors().GetNumberOfItems()):
            right.AddActor(left.GetActors().GetItemAsObject(i))
        culler = cull(left)
        right.GetCullers().RemoveAllItems()
        right.AddCuller(culler)
        window = window_with(left)
        left.SetViewport(0.0, 0.0, 0.5, 1.0)
        right.SetViewport(0.5, 0.0, 1.0, 1.0)
        window.AddRenderer(right)
        rng = numpy.random.default_rng(320)
        for frame in range(12):
            with self.subTest(frame=frame, seed=320):
                renderer = (left, right)[frame % 2]
                count = renderer.GetActors().GetNumberOfItems()
                if frame % 3 == 0:
                    gone = renderer.GetActors().GetItemAsObject(int(rng.integers(count)))
                    renderer.RemoveActor(gone)
                else:
                    renderer.AddActor(plate(rng.uniform(-3.0, 3.0), rng.uniform(size=3), 1.0))
                pictures = []
                for culling in (True, False):
                    culler.SetCulling(culling)
                    window.Render()
                    pictures.append(pixels(window))
                numpy.testing.assert_array_equal(*pictures)

    def test_large_screenshots(self):
        renderer = hidden_scene()
        cone = actor_of(vtkConeSource())
        cone.SetPosition(0.4, 0.5, 2.0)
        assembly = vtkAssembly()
        assembly.AddPart(cone)
        renderer.AddActor(assembly)
        renderer.ResetCameraClippingRange()
        culler = cull(renderer)
        window = window_with(renderer)
        size, culled = screenshot(window, 3)
        self.assertEqual(culler.GetNumberOfCulledParts(), 5)
        self.assertEqual(size[:2], tuple(3 * side for side in window.GetSize()))
        culler.CullingOff()
        numpy.testing.assert_array_equal(culled, screenshot(window, 3)[1])

    def test_culler_outlives_renderers_and_windows(self):
        culler = vtkHierarchicalSBufferCuller()
        for frame in range(3):
            renderer = hidden_scene()
            renderer.GetCullers().RemoveAllItems()
            renderer.AddCuller(culler)
            window = window_with(renderer)
            window.Render()
            self.assertEqual(culler.GetNumberOfCulledParts(), 5, frame)
            window.Finalize()

    def test_misuse(self):
        culler = vtkHierarchicalSBufferCuller()
        errors = []
        culler.AddObserver("ErrorEvent", lambda *_: errors.append(culler.GetBufferLines()))
        for lines, kept in ((4096, 4096), (-5, 4096), (4097, 4096), (100000, 4096)):
            culler.SetBufferLines(lines)
            self.assertEqual(culler.GetBufferLines(), kept)
        self.assertEqual(errors, [4096] * 3)
        for wrong in (1, "renderer", vtkRenderWindow()):
            with self.assertRaises(TypeError):
                culler.GetBufferImage(wrong)
        self.assertIn("BufferLines: 4096", str(culler))


if __name__ == "__main__":
    unittest.main()
