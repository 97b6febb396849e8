"""Levels of detail: what moves, what stays, and what is told; pictures beside those of the parts themselves."""

import os
import pathlib
import tempfile
import unittest
import unittest.mock

import numpy as np
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkFiltersCore import vtkMassProperties
from vtkmodules.vtkFiltersSources import vtkDiskSource
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer

import vitrine
from level_scenes import SIZE, Scene, ball, machine


def near_edges(picture):
    """Whether each pixel has another one with another colour around it."""
    padded = np.pad(picture, ((1, 1), (1, 1), (0, 0)), mode="edge")
    edge = np.zeros(picture.shape[:2], bool)
    for x in range(3):
        for y in range(3):
            edge |= (padded[x : x + SIZE, y : y + SIZE] != picture).any(axis=2)
    return edge


class Levels(unittest.TestCase):
    def assert_same(self, first, second):
        self.assertEqual(int((first != second).any(axis=2).sum()), 0)

    def assert_moved_by_less_than_a_pixel(self, moved, exact):
        """Flat colours change only where a pixel beside has another one."""
        changed = (moved != exact).any(axis=2)
        self.assertEqual(int((changed & ~near_edges(exact)).sum()), 0)

    def test_no_point_moves_by_more_than_half_a_pixel(self):
        for parallel in (False, True):
            scene = Scene(machine(), parallel=parallel)
            exact = scene.frame(10)
            shown = scene.levels(exact_while_still=False)
            moved = scene.frame()
            self.assertGreater(int((exact != exact[0, 0]).any(axis=2).sum()), 1000)
            self.assert_moved_by_less_than_a_pixel(moved, exact)
            told = shown.stats()
            self.assertTrue(told.drew_levels)
            self.assertGreater(told.whole_triangles, 2.5 * told.triangles)
            self.assertLessEqual(told.distance, 0.5)
            self.assertGreater(told.distance, 0)

    def test_a_cloud_of_tiny_parts_hides_what_it_should(self):
        """A convex part hides a quarter of its area in the mean (Cauchy). Each is far less than a pixel."""
        count, radius = 1500, 0.3  # of a pixel
        random = np.random.default_rng(53)
        blocks = vtkMultiBlockDataSet()
        for i in range(count):
            blocks.SetBlock(i, ball(*random.uniform(-SIZE / 3, SIZE / 3, 2), radius, 10))
        properties = vtkMassProperties()
        properties.SetInputData(blocks.GetBlock(0))
        hidden = count * properties.GetSurfaceArea() / 4
        for opacity in (1, 0.3):
            assembly = vitrine.from_multiblock(blocks)
            assembly["**"].color = (1, 1, 1)
            assembly["**"].opacity = opacity
            scene = Scene(assembly, parallel=True)
            scene.renderer.SetBackground(0, 0, 0)
            scene.camera.SetParallelScale(SIZE / 2)
            scene.camera.Elevation(25)
            shown = scene.levels(exact_while_still=False)
            for degrees in (15, 10, 10):
                light = scene.frame(degrees)[..., :3].sum() / (3 * 255)
                self.assertAlmostEqual(light / (hidden * (1 - (1 - opacity) ** 2)), 1, delta=0.25)
            self.assertEqual(shown.stats().triangles, 4 * count)

    def test_a_cloud_of_tiny_sheets_hides_what_it_should(self):
        """Rings far less than a pixel, seen from the front, hide their area."""
        count, radius = 500, 0.4  # of a pixel
        random = np.random.default_rng(53)
        blocks = vtkMultiBlockDataSet()
        for i in range(count):
            ring = vtkDiskSource()
            ring.SetInnerRadius(radius / 2)
            ring.SetOuterRadius(radius)
            ring.SetCircumferentialResolution(24)
            ring.Update()
            data = ring.GetOutput()
            vtk_to_numpy(data.GetPoints().GetData())[:, :2] += random.uniform(-SIZE / 3, SIZE / 3, 2)
            blocks.SetBlock(i, data)
        for opacity in (1, 0.3):
            assembly = vitrine.from_multiblock(blocks)
            assembly["**"].color = (1, 1, 1)
            assembly["**"].opacity = opacity
            scene = Scene(assembly, parallel=True)
            scene.renderer.SetBackground(0, 0, 0)
            scene.camera.SetParallelScale(SIZE / 2)
            shown = scene.levels(exact_while_still=False)
            light = scene.frame()[..., :3].sum() / (3 * 255)
            self.assertAlmostEqual(light / (count * opacity * 0.75 * np.pi * radius**2), 1, delta=0.15)
            self.assertEqual(shown.stats().triangles, 2 * count)

    def test_a_finer_setting_has_more_triangles(self):
        scene = Scene(machine())
        drawn = []
        for limit in (0.01, 0.5, 8):
            shown = scene.levels(pixels=limit, exact_while_still=False)
            scene.frame()
            self.assertLessEqual(shown.stats().distance, limit)
            drawn.append(shown.stats().triangles)
        self.assertEqual(drawn, sorted(drawn, reverse=True))
        self.assertGreater(drawn[0], 4 * drawn[2])

    def test_looks_are_kept_and_their_changes_are_seen(self):
        assembly = machine()
        scene = Scene(assembly)
        shown = scene.levels(exact_while_still=False)
        scene.frame(20)
        for change in (
            lambda: assembly["ball_*"]._set("color", (1, 0, 0)),
            lambda: assembly["rod_1"]._set("visible", False),
            lambda: assembly["rod_*"]._set("opacity", 0.4),
            lambda: assembly.explode(0.3),
            lambda: assembly.reset(),
        ):
            change()
            moved = scene.frame()
            self.assertTrue(shown.stats().drew_levels)
            shown.remove()
            exact = scene.frame()
            self.assert_moved_by_less_than_a_pixel(moved, exact)
            shown = scene.levels(exact_while_still=False)

    def test_looks_that_change_in_each_frame_are_drawn_without(self):
        assembly = machine()
        scene = Scene(assembly)
        shown = scene.levels(exact_while_still=False)
        drew = []
        for frame in range(16):
            assembly["ball_2"]._set("opacity", 0.1 + 0.05 * frame)
            scene.frame()
            drew.append(shown.stats().drew_levels)
        self.assertEqual([frame for frame in range(16) if drew[frame]], [0, 1, 3, 7, 15])
        for _ in range(16):
            moved = scene.frame()
        self.assertTrue(shown.stats().drew_levels)
        shown.remove()
        self.assert_moved_by_less_than_a_pixel(moved, scene.frame())

    def test_colours_of_points_keep_their_borders(self):
        data = ball(0, 0, 1)
        colors = vtkUnsignedCharArray()
        colors.SetNumberOfComponents(3)
        for point in range(data.GetNumberOfPoints()):
            colors.InsertNextTuple3(*((255, 0, 0) if data.GetPoint(point)[1] > 0.01 else (0, 0, 255)))
        data.GetPointData().SetScalars(colors)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, data)
        scene = Scene(vitrine.from_multiblock(blocks))
        exact = scene.frame(5)
        shown = scene.levels(pixels=8, exact_while_still=False)
        moved = scene.frame()
        self.assertGreater(shown.stats().whole_triangles, 2 * shown.stats().triangles)
        exact, moved = exact[..., :3], moved[..., :3]
        red, blue = (exact == (255, 0, 0)).all(axis=2), (exact == (0, 0, 255)).all(axis=2)
        self.assertGreater(min(red.sum(), blue.sum()), 1000)
        self.assertLess(int((moved != exact).any(axis=2)[red | blue].sum()), 0.05 * (red | blue).sum())
        self.assertFalse((moved[red] == (0, 0, 255)).all(axis=1).any())
        self.assertFalse((moved[blue] == (255, 0, 0)).all(axis=1).any())

    def test_actors_that_were_changed_are_drawn_as_they_are(self):
        scene = Scene(machine())
        shown = scene.levels(exact_while_still=False)
        scene.frame(10)
        whole = shown.stats().whole_triangles
        actor = scene.assembly.actors.GetActor(0)

        def clip(shown):
            if shown:
                actor.GetMapper().AddClippingPlane(vtkPlane())
            else:
                actor.GetMapper().RemoveAllClippingPlanes()

        for change in (
            lambda on: actor.SetPosition(0.3 * on, 0, 0),
            lambda on: actor.SetScale(1 + on),
            lambda on: actor.SetVisibility(not on),
            clip,
        ):
            change(True)
            changed = scene.frame()
            self.assertLess(shown.stats().whole_triangles, whole)
            shown.remove()
            self.assert_moved_by_less_than_a_pixel(changed, scene.frame())
            change(False)
            shown = scene.levels(exact_while_still=False)
            scene.frame()
            self.assertEqual(shown.stats().whole_triangles, whole)

    def test_all_is_as_it_is_between_frames(self):
        scene = Scene(machine())
        shown = scene.levels(exact_while_still=False)
        scene.frame(10)
        self.assertTrue(shown.stats().drew_levels)
        actors = scene.assembly.actors
        self.assertTrue(all(actors.GetActor(i).GetVisibility() for i in range(actors.GetNumberOfActors())))
        visible = [prop for prop in scene.renderer.GetViewProps() if prop.GetVisibility()]
        self.assertEqual(len(visible), actors.GetNumberOfActors())
        shown.remove()
        self.assertEqual(scene.renderer.GetViewProps().GetNumberOfItems(), actors.GetNumberOfActors())

    def both(self, scene):
        """A picture with levels, what was told of it, and one of the parts as they are."""
        exact = scene.frame()
        shown = scene.levels(exact_while_still=False)
        moved = scene.frame()
        told = shown.stats()
        shown.remove()
        return moved, told, exact

    def test_levels_are_cut_and_cut_parts_are_exact(self):
        scene = Scene(machine())
        scene.frame(10)
        for normal in ("x", "-y", (1, 2, 0)):
            with vitrine.section(scene.window, normal):
                moved, told, exact = self.both(scene)
                self.assertGreater(told.whole_triangles, 1.3 * told.triangles)
                self.assert_moved_by_less_than_a_pixel(moved, exact)
        with vitrine.section_box(scene.window, (-1.2, 1.2, -3, 1.6, -3, 3), inside=False):
            moved, told, exact = self.both(scene)
            self.assertGreater(told.whole_triangles, 1.3 * told.triangles)
            self.assert_moved_by_less_than_a_pixel(moved, exact)

    def test_parts_at_the_near_and_far_planes_are_exact(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, ball(0, 0, 1))
        blocks.SetBlock(1, ball(0, 0, 0.1))
        scene = Scene(vitrine.from_multiblock(blocks))
        scene.camera.SetFocalPoint(0, 0, 0)
        shown = scene.levels(pixels=64, exact_while_still=False)
        one = blocks.GetBlock(0).GetNumberOfPolys()
        for distance, near, far, exact in (
            (5, 1, 9, 0),
            (0.5, 0.01, 9, 1),  # within the large ball
            (-0.9, 0.01, 9, 1),  # nearly at its back
            (5, 4.95, 9, 2),
            (5, 1, 5.05, 2),
            (5, 1, 4.5, 1),
        ):
            scene.camera.SetPosition(0, 0, distance)
            scene.camera.SetClippingRange(near, far)
            scene.window.Render()
            told = shown.stats()
            self.assertEqual(told.whole_triangles, 2 * one)
            self.assertEqual(told.triangles // one, exact, (distance, near, far))

    def test_caps_are_those_of_parts_as_they_are(self):
        scene = Scene(machine(), lit=True)
        scene.camera.SetPosition(-9, 0, 0)
        scene.camera.SetFocalPoint(0, 0, 0)
        with vitrine.section(scene.window, "x", (0, 0, 0), caps=False) as cut:
            without = scene.frame()
            cut.look(caps=True, hatch="lines")
            exact = scene.frame()
            shown = scene.levels(exact_while_still=False, pixels=8)
            moved = scene.frame()
            self.assertGreater(shown.stats().whole_triangles, 2 * shown.stats().triangles)
        caps = (exact != without).any(axis=2)
        self.assertGreater(int(caps.sum()), 1000)
        self.assertEqual(int((moved != exact).any(axis=2)[caps].sum()), 0)

    def test_parts_chosen_by_a_plane_or_an_x_ray_are_exact(self):
        assembly = machine()
        assembly["dust_*"].opacity = 0.5
        scene = Scene(assembly)
        scene.frame(10)
        every = self.both(scene)[1]
        chosen = assembly["ball_*"]
        for choose in (
            lambda: vitrine.section(scene.window, "y", parts=chosen),
            lambda: vitrine.section(scene.window, "y", but=chosen),
            lambda: vitrine.x_ray(scene.window, chosen),
        ):
            with choose():
                moved, told, exact = self.both(scene)
                self.assertTrue(told.drew_levels)
                self.assertEqual(told.whole_triangles, every.whole_triangles)
                self.assertGreater(told.triangles, every.triangles)
                self.assert_moved_by_less_than_a_pixel(moved, exact)

    def test_the_culler_changes_nothing(self):
        scene = Scene(machine(), lit=True)
        scene.levels(exact_while_still=False)
        without = scene.frame(10)
        vitrine.see_through(scene.window, cull=True)
        self.assert_same(scene.frame(), without)

    def test_an_assembly_that_is_removed_is_not_drawn(self):
        scene = Scene(machine())
        shown = scene.levels(exact_while_still=False)
        scene.frame(10)
        scene.assembly.actors.RemoveFrom(scene.renderer)
        picture = scene.frame(10)
        self.assertFalse(shown.stats().drew_levels)
        self.assert_same(picture, np.broadcast_to(picture[0, 0], picture.shape))

    def test_levels_of_large_parts_are_kept(self):
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.dict(os.environ, XDG_CACHE_HOME=folder):
            blocks = vtkMultiBlockDataSet()
            blocks.SetBlock(0, ball(0, 0, 1, 230))
            assembly = vitrine.from_multiblock(blocks)
            scene = Scene(assembly, lit=True)
            entries = pathlib.Path(folder, "vitrine", "levels")

            def frame():
                shown = scene.levels(exact_while_still=False)
                picture = scene.frame()
                self.assertTrue(shown.stats().drew_levels)
                return picture

            vitrine.levels(scene.window, cache=False).remove()
            self.assertFalse(entries.exists())
            made = frame()
            (entry,) = entries.iterdir()
            whole = entry.read_bytes()
            for damaged in (whole[:-1], whole[:24] + bytes(4 * [255]) + whole[28:]):  # a wrong corner
                entry.write_bytes(damaged)
                self.assert_same(frame(), made)
                self.assertEqual(entry.read_bytes(), whole)
            stamp = entry.stat().st_mtime_ns
            self.assert_same(frame(), made)
            self.assertGreater(entry.stat().st_mtime_ns, stamp)

    def test_outlines_are_drawn_with_levels(self):
        scene = Scene(machine())
        shown = scene.levels(exact_while_still=False)
        without = scene.frame(10)
        with vitrine.highlight(scene.window, scene.assembly["rod_2"]):
            outlined = scene.frame()
        self.assertTrue(shown.stats().drew_levels)
        self.assertGreater(int((outlined != without).any(axis=2).sum()), 100)

    def test_damaged_points_are_drawn_as_they_are(self):
        data = ball(0, 0, 1)
        data.GetPoints().SetPoint(7, float("nan"), 0, 0)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, data)
        blocks.SetBlock(1, ball(2, 0, 0.5))
        scene = Scene(vitrine.from_multiblock(blocks))
        shown = scene.levels(exact_while_still=False)
        scene.frame(10)
        self.assertEqual(shown.stats().whole_triangles, 0)

    def test_wrong_arguments_say_so(self):
        scene = Scene(machine())
        for wrong in (0, -1, 65, float("nan"), float("inf")):
            with self.assertRaisesRegex(ValueError, "pixels is a number from 0.001 to 64"):
                vitrine.levels(scene.window, pixels=wrong)
        for wrong in ("1", None, True):
            with self.assertRaisesRegex(TypeError, "pixels is a number"):
                vitrine.levels(scene.window, pixels=wrong)
        with self.assertRaisesRegex(TypeError, "exact_while_still is True or False"):
            vitrine.levels(scene.window, exact_while_still=1)
        with self.assertRaisesRegex(ValueError, "the target shows no assembly"):
            vitrine.levels(vtkRenderer())

    def test_windows_and_handles_may_end_in_any_order(self):
        scene = Scene(machine())
        shown = vitrine.levels(scene.window)  # while levels are being made
        scene.frame(10)
        del scene
        shown.remove()
        scene = Scene(machine())
        vitrine.levels(scene.window)
        vitrine.levels(scene.window).wait()  # the first is removed
        scene.frame(10)


if __name__ == "__main__":
    unittest.main()
