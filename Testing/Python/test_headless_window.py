"""vtkHeadlessRenderWindow: everything that a render window does, without a display."""

import gc
import resource
import unittest

import numpy
from vtkmodules import vtkRenderingOpenGL2
from vtkmodules.vtkCommonCore import VTK_ERROR, vtkFloatArray, vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import (
    vtkRenderWindow,
    vtkRenderWindowInteractor,
    vtkWindowToImageFilter,
)
from vtkmodules.util.numpy_support import vtk_to_numpy

from scenes import (
    cone_renderer,
    pixels,
    plate,
    plates_renderer,
    rendered,
    run_python,
    window_with,
)
from vitrine import vtkHeadlessRenderWindow

BACKGROUND = [0, 0, 255]
EGL_WINDOW = getattr(vtkRenderingOpenGL2, "vtkEGLRenderWindow", None)  # VTK's own by EGL
ORDINARY_WINDOW = type(vtkRenderWindow())  # before any override
ORDINARY_INTERACTOR = type(vtkRenderWindowInteractor())


class Override(unittest.TestCase):
    def tearDown(self):
        vtkHeadlessRenderWindow.RemoveOverride()

    def test_stands_in_for_the_render_window(self):
        vtkHeadlessRenderWindow.InstallOverride()
        self.assertIsInstance(vtkRenderWindow(), vtkHeadlessRenderWindow)

    def test_brings_an_interactor_that_needs_no_display(self):
        vtkHeadlessRenderWindow.InstallOverride()
        window = vtkRenderWindow()
        window.AddRenderer(cone_renderer())
        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(window)
        interactor.Initialize()
        interactor.Start()
        self.assertEqual(pixels(window).shape, (300, 300, 4))
        vtkHeadlessRenderWindow.RemoveOverride()
        self.assertIs(type(vtkRenderWindowInteractor()), ORDINARY_INTERACTOR)

    def test_is_removed_by_one_call_after_any_number_of_installs(self):
        for _ in range(3):
            vtkHeadlessRenderWindow.InstallOverride()
        vtkHeadlessRenderWindow.RemoveOverride()
        self.assertIs(type(vtkRenderWindow()), ORDINARY_WINDOW)
        vtkHeadlessRenderWindow.RemoveOverride()
        self.assertIs(type(vtkRenderWindow()), ORDINARY_WINDOW)

    def test_can_be_installed_again(self):
        for _ in range(3):
            vtkHeadlessRenderWindow.InstallOverride()
            self.assertIsInstance(vtkRenderWindow(), vtkHeadlessRenderWindow)
            vtkHeadlessRenderWindow.RemoveOverride()
            self.assertIs(type(vtkRenderWindow()), ORDINARY_WINDOW)


class Window(unittest.TestCase):
    def assert_cone(self, picture, size=(64, 48)):
        """The picture has its size, background at its corners and a cone, drawn in grey, in its middle."""
        width, height = size
        self.assertEqual(picture.shape, (height, width, 4))
        for corner in (picture[0, 0], picture[-1, 0], picture[0, -1], picture[-1, -1]):
            self.assertEqual(list(corner[:3]), BACKGROUND)
        red, green, blue, _ = picture[height // 2, width // 2]
        self.assertTrue(red == green == blue > 128, picture[height // 2, width // 2])

    def test_draws(self):
        self.assert_cone(rendered(cone_renderer()))

    def test_begins_in_the_state_that_vtk_expects(self):
        # Of coplanar faces the one drawn last is seen, by VTK's GL_LEQUAL; OpenGL itself begins with GL_LESS.
        renderer = plates_renderer(plate(0, (1, 0, 0), 1), plate(0, (0, 1, 0), 1))
        picture = rendered(renderer)
        self.assertTrue((picture[..., :3] == (0, 255, 0)).all())

    def test_has_a_default_size(self):
        window = vtkHeadlessRenderWindow()
        window.AddRenderer(cone_renderer())
        window.Render()
        self.assert_cone(pixels(window), (300, 300))

    def test_names_its_platform_while_it_has_a_context(self):
        window = window_with(cone_renderer())
        self.assertEqual(window.GetPlatform(), "")
        window.Render()
        self.assertRegex(window.GetPlatform(), r"^(device:\d+|surfaceless|default)$")
        self.assertIn("Platform: " + window.GetPlatform(), str(window))
        window.Finalize()
        self.assertEqual(window.GetPlatform(), "")

    def test_has_a_core_profile_that_storage_buffers_fit_in(self):
        window = window_with(cone_renderer())
        report = window.ReportCapabilities()
        self.assertIn("OpenGL version string:  4.", report)
        self.assertIn("GL_ARB_shader_storage_buffer_object", report)
        self.assertNotIn("GL_ARB_compatibility", report)

    def test_resizes_before_and_after_the_first_frame(self):
        window = window_with(cone_renderer(), size=(40, 30))
        for size in ((40, 30), (301, 77), (1, 1), (77, 301), (40, 30)):
            window.SetSize(size)
            window.Render()
            picture = pixels(window)
            if size == (1, 1):
                self.assertEqual(picture.shape, (1, 1, 4))
            else:
                self.assert_cone(picture, size)

    def test_draws_the_same_however_it_came_to_its_size(self):
        renderer = cone_renderer()
        expected = rendered(renderer, size=(64, 48))
        window = window_with(cone_renderer(), size=(500, 400))
        window.Render()
        window.SetSize(64, 48)
        window.GetRenderers().GetFirstRenderer().ResetCamera()
        window.Render()
        numpy.testing.assert_array_equal(pixels(window), expected)

    def test_smooths_edges_with_multisamples(self):
        jagged = rendered(cone_renderer(), multisamples=0)
        smooth = rendered(cone_renderer(), multisamples=4)
        self.assert_cone(smooth)
        self.assertGreater(
            len(numpy.unique(smooth.reshape(-1, 4), axis=0)),
            len(numpy.unique(jagged.reshape(-1, 4), axis=0)),
        )

    def test_draws_the_same_after_its_resources_were_released(self):
        window = window_with(cone_renderer())
        window.ReleaseGraphicsResources(window)  # before there are any
        window.Render()
        expected = pixels(window)
        self.assert_cone(expected)
        window.ReleaseGraphicsResources(window)
        window.Render()
        numpy.testing.assert_array_equal(pixels(window), expected)

    def test_draws_the_same_after_finalize(self):
        window = window_with(cone_renderer())
        window.Finalize()  # before there is a context
        window.Render()
        expected = pixels(window)
        window.Finalize()
        window.Finalize()
        window.Render()
        numpy.testing.assert_array_equal(pixels(window), expected)

    def test_draws_the_same_with_offscreen_rendering_off(self):
        window = window_with(cone_renderer())
        self.assertTrue(window.GetOffScreenRendering())
        window.Render()
        expected = pixels(window)
        for flag in (0, 1):
            window.SetOffScreenRendering(flag)
            window.Render()
            numpy.testing.assert_array_equal(pixels(window), expected)

    def test_several_windows_take_turns(self):
        sizes = [(64, 48), (33, 57), (128, 16)]
        windows = [window_with(cone_renderer(), size=size) for size in sizes]
        first = []
        for window, size in zip(windows, sizes):
            window.Render()
            first.append(pixels(window))
            self.assert_cone(first[-1], size)
        for _ in range(3):
            for window, expected in zip(reversed(windows), reversed(first)):
                window.Render()
            for window, expected in zip(windows, first):
                numpy.testing.assert_array_equal(pixels(window), expected)
        del windows[1]
        gc.collect()
        windows[0].Render()
        numpy.testing.assert_array_equal(pixels(windows[0]), first[0])

    def test_leaves_the_context_of_another_window_current(self):
        window, other = window_with(cone_renderer()), window_with(cone_renderer())
        other.Render()
        window.Render()
        other.ReleaseGraphicsResources(other)
        self.assertTrue(window.IsCurrent())
        other.PushContext()
        self.assertTrue(other.IsCurrent())
        window.PushContext()
        self.assertTrue(window.IsCurrent())
        window.PopContext()
        self.assertTrue(other.IsCurrent())
        other.PopContext()
        self.assertTrue(window.IsCurrent())
        other.Render()
        window.MakeCurrent()
        other.Finalize()
        self.assertTrue(window.IsCurrent())
        window.Finalize()
        self.assertFalse(window.IsCurrent())

    def test_one_renderer_moves_from_window_to_window(self):
        renderer = cone_renderer()
        before = window_with(renderer)
        before.Render()
        expected = pixels(before)
        before.RemoveRenderer(renderer)
        numpy.testing.assert_array_equal(rendered(renderer), expected)

    def test_feeds_the_image_filter(self):
        window = window_with(cone_renderer())
        picture = vtkWindowToImageFilter()
        picture.SetInput(window)
        picture.SetInputBufferTypeToRGBA()
        for from_front in (1, 0):
            picture.SetReadFrontBuffer(from_front)
            picture.Modified()
            picture.Update()
            array = vtk_to_numpy(picture.GetOutput().GetPointData().GetScalars())
            numpy.testing.assert_array_equal(array.reshape(48, 64, 4), pixels(window))

    def test_tiles_a_large_picture(self):
        window = window_with(cone_renderer())
        window.Render()
        picture = vtkWindowToImageFilter()
        picture.SetInput(window)
        picture.SetScale(3, 2)
        picture.Update()
        self.assertEqual(picture.GetOutput().GetDimensions(), (192, 96, 1))
        array = vtk_to_numpy(picture.GetOutput().GetPointData().GetScalars())
        self.assertEqual(list(array[0]), BACKGROUND)
        self.assertGreater(array.reshape(96, 192, 3)[48, 96].min(), 128)

    def test_reads_depth(self):
        window = window_with(cone_renderer())
        window.Render()
        self.assertLess(window.GetZbufferDataAtPoint(32, 24), 1.0)
        self.assertEqual(window.GetZbufferDataAtPoint(0, 0), 1.0)

    def test_refuses_to_read_before_the_first_frame(self):
        window = window_with(cone_renderer())
        window.SetGlobalWarningDisplay(0)
        try:
            data = vtkUnsignedCharArray()
            self.assertEqual(window.GetRGBACharPixelData(0, 0, 3, 3, 1, data), VTK_ERROR)
            self.assertEqual(window.GetZbufferData(0, 0, 3, 3, vtkFloatArray()), VTK_ERROR)
        finally:
            window.SetGlobalWarningDisplay(1)
        window.Render()
        self.assert_cone(pixels(window))

    def test_gives_back_what_a_window_took(self):
        def cycle(count):
            for i in range(count):
                rendered(cone_renderer(), size=(200, 150), multisamples=4 * (i % 2))
            return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

        settled = cycle(10)
        self.assertLess(cycle(40) - settled, 8 * 1024)  # KiB


@unittest.skipUnless(EGL_WINDOW, "VTK has no windows by EGL")
class BesideVTKsOwn(unittest.TestCase):
    """In interpreters of their own: what VTK's windows do to a display they do to all of a process."""

    PROGRAM = """
import gc
from scenes import cone_renderer, pixels, window_with
from vtkmodules.vtkRenderingCore import vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import vtkEGLRenderWindow
def vtks_own(cls=vtkEGLRenderWindow):
    window = cls()
    window.SetOffScreenRendering(1)
    window.SetSize(64, 48)
    window.AddRenderer(cone_renderer())
    window.Render()
    return window
def headless():
    window = window_with(cone_renderer())
    window.Render()
    return window
def expect_cone(window):
    picture = pixels(window)
    assert (picture[0, 0, :3] == [0, 0, 255]).all(), picture[0, 0]
    assert picture[24, 32, 0] > 128, picture[24, 32]
def expect_another(window):
    window.GetRenderers().GetFirstRenderer().SetBackground(0, 1, 0)
    window.Render()
    assert (pixels(window)[0, 0, :3] == [0, 255, 0]).all(), pixels(window)[0, 0]
%s
print("survived")
"""

    def assert_survives(self, program):
        result = run_python(self.PROGRAM % program)
        self.assertEqual((result.returncode, result.stdout), (0, "survived\n"), result.stderr)
        self.assertEqual([line for line in result.stderr.splitlines() if "ERR|" in line], [])

    def test_keeps_its_picture_and_draws_when_the_last_of_them_ends(self):
        self.assert_survives(
            "window = headless(); own = vtks_own(); own.Finalize(); del own; gc.collect()\n"
            "expect_cone(window); expect_another(window)"
        )

    def test_does_so_where_they_came_first(self):
        self.assert_survives(
            "own = vtks_own(); window = headless(); own.Finalize(); del own; gc.collect()\n"
            "expect_cone(window); expect_another(window)"
        )

    def test_does_so_while_vtk_looks_for_a_kind_of_window(self):
        self.assert_survives(
            "window = headless(); own = vtks_own(vtkRenderWindow)\n"
            "expect_cone(window); expect_cone(own); expect_another(window); expect_another(own)"
        )

    def test_does_so_when_all_come_and_go(self):
        self.assert_survives(
            "windows = [headless() for _ in range(3)]\n"
            "for _ in range(3):\n"
            "    own = [vtks_own(), vtks_own()]; expect_cone(own[1]); del own; gc.collect()\n"
            "    windows[0].Finalize()\n"
            "    for window in windows:\n"
            "        expect_another(window)"
        )


class WithoutEGL(unittest.TestCase):
    """Where libglvnd finds no driver, each call fails in order, and one error says why."""

    PROGRAM = """
from vtkmodules.vtkCommonCore import VTK_ERROR, vtkFloatArray, vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from scenes import cone_renderer, window_with
window = window_with(cone_renderer())
window.Render()
window.Render()
window.Start()
window.Frame()
window.MakeCurrent()
assert not window.IsCurrent()
assert window.GetPlatform() == ""
assert window.GetNumberOfDevices() == 0
assert "No OpenGL context" in window.ReportCapabilities()
assert window.GetZbufferData(0, 0, 3, 3, vtkFloatArray()) == VTK_ERROR
assert window.GetRGBACharPixelData(0, 0, 63, 47, 1, vtkUnsignedCharArray()) == VTK_ERROR
picture = vtkWindowToImageFilter()
picture.SetInput(window)
picture.Update()
window.ReleaseGraphicsResources(window)
%s
del picture, window
print("survived")
"""

    def run_without_egl(self, extra=""):
        result = run_python(self.PROGRAM % extra, __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, "survived\n")
        return [line for line in result.stderr.splitlines() if "ERR|" in line]

    def test_says_so_once(self):
        errors = self.run_without_egl()
        self.assertEqual(len(errors), 1, errors)
        self.assertIn("No EGL platform gives an OpenGL context (default: no display)", errors[0])

    def test_tries_again_after_finalize(self):
        self.assertEqual(len(self.run_without_egl("window.Finalize(); window.Render()")), 2)
