"""Levels of detail: frames that show parts as they are."""

import unittest

from level_scenes import SIZE, Scene, ball, machine
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

import vitrine


class Still(unittest.TestCase):
    def assert_same(self, first, second):
        self.assertEqual(int((first != second).any(axis=2).sum()), 0)

    def test_a_still_camera_shows_parts_as_they_are(self):
        scene = Scene(machine(), lit=True)
        exact = scene.frame(10)
        shown = scene.levels()
        self.assert_same(scene.frame(), exact)  # the first one, before which the camera was nowhere
        scene.frame(10)
        self.assertTrue(shown.stats().drew_levels)
        scene.frame(-10)
        self.assertTrue(shown.stats().drew_levels)
        self.assert_same(scene.frame(), exact)
        told = shown.stats()
        self.assertFalse(told.drew_levels)
        self.assertEqual(told.triangles, told.whole_triangles)
        self.assertEqual(told.distance, 0)
        shown.remove()
        self.assert_same(scene.frame(), exact)
        self.assertEqual(repr(shown), "<Levels, removed>")

    def test_another_size_of_the_picture_is_no_motion(self):
        scene = Scene(machine())
        shown = scene.levels()
        scene.frame()
        scene.window.SetSize(SIZE // 2, SIZE)
        scene.window.Render()
        self.assertFalse(shown.stats().drew_levels)
        tiles = vtkWindowToImageFilter()
        tiles.SetInput(scene.window)
        tiles.SetScale(2)
        tiles.Update()
        self.assertFalse(shown.stats().drew_levels)
        scene.window.Render()
        self.assertFalse(shown.stats().drew_levels)
        scene.frame(10)
        self.assertTrue(shown.stats().drew_levels)

    def test_cameras_with_matrices_show_parts_as_they_are(self):
        scene = Scene(machine())
        shown = scene.levels(exact_while_still=False)
        large = vtkTransform()
        large.Scale(10, 10, 1)
        none = vtkTransform()
        for set_matrix in (
            scene.camera.SetUserTransform,
            scene.camera.SetUserViewTransform,
            lambda transform: scene.camera.SetModelTransformMatrix(transform.GetMatrix()),
        ):
            set_matrix(large)
            scene.window.Render()
            self.assertFalse(shown.stats().drew_levels)
            set_matrix(none)
            scene.window.Render()
            self.assertTrue(shown.stats().drew_levels)

    def test_parts_whose_data_change_are_drawn_as_they_are(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, ball(0, 0, 1))
        scene = Scene(vitrine.from_multiblock(blocks))
        shown = scene.levels(pixels=8, exact_while_still=False)
        scene.frame(10)
        before = shown.stats()
        self.assertGreater(before.whole_triangles, before.triangles)
        points = blocks.GetBlock(0).GetPoints().GetData()
        vtk_to_numpy(points)[:] *= 0.3
        points.Modified()
        for _ in range(3):
            drawn = scene.frame(10)
            self.assertEqual(shown.stats().whole_triangles, 0)
        shown.remove()
        self.assert_same(drawn, scene.frame())
        shown = scene.levels(pixels=8, exact_while_still=False)  # made of what is there now
        scene.frame(10)
        self.assertEqual(shown.stats().whole_triangles, before.whole_triangles)


if __name__ == "__main__":
    unittest.main()
