"""Deep pictures: fragments of known scenes as OpenEXR has them, and what OpenImageIO flattens them to."""

import shutil
import subprocess
import sys
import unittest
from unittest import mock

import numpy
import OpenEXR
from machine import SIZE, Files
from scenes import drawn, pixels, plate, plates_renderer

import vitrine.explore
from vitrine.explore import _exr, _fragments
from vitrine.inspector import Inspection

RED, GREEN, BLUE = (1, 0, 0), (0, 1, 0), (0, 0, 1)
CHANNELS = ("R", "G", "B", "A", "Z", "id")


class Deep(Files):
    def drawn(self, *plates):
        """A renderer of plates, or else of the machine, which is drawn exactly and seen through."""
        renderer = plates_renderer(*plates) if plates else self.view()
        vitrine.see_through(renderer)
        self.window = drawn(renderer, size=SIZE)  # renderers do not keep theirs
        return renderer

    def written(self, renderer):
        """A file of what a renderer shows, and its channels by name: rows from the top of columns of arrays."""
        path = self.folder / "deep.exr"
        fragments = _fragments.take(renderer)
        _exr.write_exr(path, fragments, renderer)
        file = OpenEXR.File(str(path), separate_channels=True)
        return path, {name: file.channels()[name].pixels for name in CHANNELS}

    def test_has_all_fragments_with_their_parts(self):
        plates = [plate(1, RED, 0.75), plate(0, GREEN, 1.0), plate(-3, BLUE, 0.5)]
        renderer = self.drawn(*plates)
        _, channels = self.written(renderer)
        for row, column in ((0, 0), (79, 79), (20, 30)):
            found = {name: channels[name][row, column].tolist() for name in CHANNELS}
            numpy.testing.assert_allclose(found.pop("Z"), [9, 10, 13], rtol=1e-6)
            expected = {"R": [0.75, 0, 0], "G": [0, 1, 0], "B": [0, 0, 0.5], "A": [0.75, 1, 0.5], "id": [0, 1, 2]}
            self.assertEqual(found, expected)
        self.assertEqual([channels[name].dtype for name in CHANNELS], [object] * 6)
        self.assertEqual(channels["A"][0, 0].dtype, numpy.float16)
        self.assertEqual(channels["Z"][0, 0].dtype, numpy.float32)
        self.assertEqual(channels["id"][0, 0].dtype, numpy.uint32)

    def test_rows_go_from_the_top_and_pixels_may_be_empty(self):
        renderer = self.drawn()
        _, channels = self.written(renderer)
        ids = {path: place for place, path in enumerate(_fragments.table_of(renderer).paths)}
        # Boxes have a front and a back: the lid at x = -2, y = 2 is above gear-1, which is below.
        self.assertEqual(set(channels["id"][20, 20]), {ids["/Machine/Housing/lid"]})
        self.assertEqual(set(channels["id"][60, 20]), {ids["/Machine/Gearbox/gear-1"]})
        self.assertFalse(channels["id"][40, 40])
        self.assertEqual(channels["Z"][20, 20].tolist(), sorted(channels["Z"][20, 20]))

    def test_tells_distances_along_the_view_in_perspective(self):
        renderer = self.drawn(plate(1, RED, 0.5), plate(-3, BLUE, 0.5))
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOff()
        camera.SetViewAngle(8)
        camera.SetClippingRange(1, 100)
        _, channels = self.written(renderer)
        for row, column in ((0, 0), (40, 32)):
            numpy.testing.assert_allclose(channels["Z"][row, column], [9, 13], rtol=1e-5)

    def test_equal_depths_keep_the_order_of_the_picture(self):
        """Translucent ones go by their packed colours, red before blue; an opaque one lets them be seen."""
        for colors, ids in (((BLUE, RED), [1, 0]), ((RED, BLUE), [0, 1]), ((GREEN, BLUE, RED), [2, 1, 0])):
            renderer = self.drawn(*(plate(0, color, 1.0 if color == GREEN else 0.5) for color in colors))
            picture = pixels(self.window)
            path, channels = self.written(renderer)
            self.assertEqual(channels["id"][5, 5].tolist(), ids)
            distances = channels["Z"][5, 5]
            self.assertTrue((numpy.diff(distances) > 0).all())
            numpy.testing.assert_allclose(distances, 10, rtol=1e-6)
            self.assert_flattens_to(picture, path)

    def test_flattens_to_the_picture(self):
        renderer = self.drawn()
        for part, opacity in zip(self.machine.parts, (0.3, 0.25, 0.6, 1.0, 0.9)):
            self.machine[part.path].opacity = opacity
        renderer.GetActiveCamera().Azimuth(35)
        renderer.GetActiveCamera().Elevation(20)
        renderer.ResetCameraClippingRange()
        renderer.SetBackground(0, 0, 0)
        self.window.Render()
        picture = pixels(self.window)
        path, _ = self.written(renderer)
        self.assert_flattens_to(picture, path)

    def assert_flattens_to(self, picture, path):
        """Compare colours before black. Vitrine's frames have the colours and opacities of fragments in 255 steps."""
        if shutil.which("oiiotool") is None:
            self.skipTest("openimageio-tools is not installed")
        flat = self.folder / "flat.exr"
        subprocess.run(["oiiotool", str(path), "--flatten", "-o", str(flat)], check=True, capture_output=True)
        channels = OpenEXR.File(str(flat), separate_channels=True).channels()
        colors = numpy.stack([channels[name].pixels for name in "RGB"], axis=-1)
        numpy.testing.assert_allclose(255 * colors, picture[::-1, :, :3], atol=1.25)

    def test_caps_of_sections_and_x_rays_are_as_in_the_picture(self):
        for change in (lambda shown: shown.add_section("z", (0, 0, 0)), lambda shown: shown.x_ray("gear*")):
            shown = Inspection(self.file, size=SIZE)
            change(shown)
            shown.view("iso")
            shown.set_background("#000000")
            picture = shown.picture()
            path, _ = self.written(shown.renderer)
            self.assert_flattens_to(picture[::-1], path)

    def test_names_parts_in_the_manifest(self):
        names = ['</script> "quoted"', "Gehäuse ✓", "", "a/b"]
        plates = [plate(-i, RED, 0.5) for i in range(len(names))]
        renderer = self.drawn(*plates)
        fragments = _fragments.take(renderer)
        for part, name in zip(fragments.parts, names):
            part.path = "/" + name
        path = self.folder / "names.exr"
        _exr.write_exr(path, fragments, renderer)
        data = path.read_bytes()
        self.assertIn(b"idmanifest\0idmanifest\0", data)
        manifest = OpenEXR.File(str(path)).header()["idmanifest"]
        self.assertEqual(manifest.size(), 1)
        self.assertEqual(manifest.find("id"), 0)

    def test_is_written_beside_the_page(self):
        renderer = self.drawn()
        page, deep = self.folder / "page.html", self.folder / "deep.exr"
        vitrine.explore.export_explorable(renderer, page, exr=deep)
        self.assertTrue(page.exists())
        fragments = _fragments.take(renderer)
        counts = [len(ids) if ids is not None else 0 for ids in OpenEXR.File(str(deep)).channels()["id"].pixels.flat]
        self.assertEqual(counts, fragments.counts.tolist())
        page.unlink()
        deep.unlink()
        with self.assertRaisesRegex(ValueError, "a deep picture has one view"):
            vitrine.explore.export_explorable(renderer, page, exr=deep, views={"now": renderer.GetActiveCamera()})
        self.assertFalse(page.exists() or deep.exists())

    def test_refuses(self):
        renderer = self.drawn(plate(0, RED, 0.5))
        fragments = _fragments.take(renderer)
        with self.assertRaisesRegex(ValueError, "deep pictures are written as .exr"):
            _exr.write_exr(self.folder / "deep.png", fragments, renderer)
        with self.assertRaises(FileNotFoundError):
            _exr.write_exr(self.folder / "none" / "deep.exr", fragments, renderer)
        for library in (None, mock.Mock(spec=["InputFile"])):
            with mock.patch.dict(sys.modules, OpenEXR=library):
                with self.assertRaisesRegex(ImportError, r"pip install 'vtk-vitrine\[exr\]'"):
                    _exr.write_exr(self.folder / "deep.exr", fragments, renderer)
        self.assertEqual([file.name for file in self.folder.iterdir()], [self.file.name])


class Growing(unittest.TestCase):
    def test_changes_only_what_does_not_grow(self):
        after = numpy.nextafter(numpy.float32(1), numpy.float32(2))
        further = numpy.nextafter(after, numpy.float32(2))
        for given, counts, expected in (
            ([1, 2, 3], [3], [1, 2, 3]),
            ([1, 1, 1, 5], [4], [1, after, further, 5]),
            ([1, 1, 1], [1, 0, 2], [1, 1, after]),
            ([5, 1], [1, 1], [5, 1]),
            ([-1, -1, 0, 0], [4], [-1, numpy.nextafter(numpy.float32(-1), numpy.float32(0)), 0, 1.4e-45]),
            ([], [0, 0], []),
        ):
            found = _exr._growing(numpy.array(given, float), numpy.array(counts))
            self.assertEqual(found.tolist(), numpy.array(expected, numpy.float32).tolist())


if __name__ == "__main__":
    unittest.main()
