"""How caps look: light, hatches, stripes where parts interfere, and what is told of them."""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer

import vitrine
from section_scenes import SIZE, SectionCase, ball

MIDDLE = SIZE // 2


class Looks(SectionCase):
    def test_caps_without_light_have_the_colour(self):
        (red,) = self.add(ball(color=(0.2, 0.4, 0.6)))
        with vitrine.section(self.renderer, "y", (0, 0, 0)):
            red.GetProperty().LightingOff()
            self.assertEqual(self.at_center(), (51, 102, 153))
            red.GetProperty().LightingOn()
            red.GetProperty().SetAmbient(1)
            red.GetProperty().SetDiffuse(0)
            red.GetProperty().SetAmbientColor(0.6, 0.2, 0.4)
            self.assertEqual(self.at_center(), (153, 51, 102))
            self.renderer.SetAmbient(0, 0, 0)
            light = vtkLight()
            light.SetColor(0, 0, 0)
            self.renderer.AddLight(light)
            self.assertEqual(self.at_center(), (153, 51, 102))

    def test_looks_stay_until_they_are_changed(self):
        self.add(ball())
        first = vitrine.section(self.renderer, "y", (0, 0, 0), caps=False, edges=0, hatch="lines")
        section = vitrine.vtkSection.GetAttached(self.renderer)
        second = vitrine.section(self.renderer, "x", (-9, 0, 0))
        self.assertEqual((section.GetCaps(), section.GetEdgeWidth(), section.GetHatch()), (False, 0, section.LINES))
        second.look(caps=True, hatch="none", stripes=False)
        self.assertEqual((section.GetCaps(), section.GetEdgeWidth(), section.GetHatch()), (True, 0, section.NO_HATCH))
        self.assertFalse(section.GetInterferenceStripes())
        for error, looks in ((TypeError, {"caps": 1}), (ValueError, {"hatch": "x"}), (TypeError, {"stripes": "no"})):
            with self.subTest(looks), self.assertRaises(error):
                first.look(**looks)

    def test_level_hatches_are_level(self):
        """The view is upright in z. So each row of a cap's pixels has one colour, and columns have several."""
        self.add(ball())
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, -3, 0)
        camera.ParallelProjectionOn()
        for up in ((0, 0, 1), (1, 0, 0)):
            camera.SetViewUp(up)
            with vitrine.section(self.renderer, "y", (0, 0, 0), hatch="level", edges=0):
                image = self.scene.picture().reshape(SIZE, SIZE, 3)[MIDDLE - 6 : MIDDLE + 6, MIDDLE - 6 : MIDDLE + 6]
            self.assertLessEqual(np.ptp(image, axis=1).max(), 1)
            self.assertGreater(np.ptp(image, axis=0).max(), 20)

    def test_parts_may_have_hatches_of_their_own(self):
        left, right = self.add(ball(0.4, (-0.5, 0, 0)), ball(0.4, (0.5, 0, 0)))

        def spread(**looks):
            with vitrine.section(self.renderer, "y", (0, 0, 0), edges=0, **looks):
                image = self.scene.picture().reshape(SIZE, SIZE, 3)
            return [np.ptp(image[MIDDLE - 4 : MIDDLE + 4, x - 4 : x + 4], axis=(0, 1)).max() > 20 for x in (14, 34)]

        self.assertEqual(spread(), [False, False])
        self.assertEqual(spread(hatch="lines"), [True, True])
        self.assertEqual(spread(hatch={left: "cross"}), [True, False])
        with self.assertRaisesRegex(ValueError, "no hatch"):
            spread(hatch={left: "checks"})
        with self.assertRaisesRegex(KeyError, "no assembly"):
            spread(hatch={"left": "lines"})

    def test_blocks_may_have_hatches_of_their_own(self):
        blocks = vtkMultiBlockDataSet()
        for i, x in enumerate((-0.5, 0.5)):
            mapper = ball(0.4, (x, 0, 0)).GetMapper()
            mapper.Update()
            blocks.SetBlock(i, mapper.GetInput())
        composite = vitrine.vtkCulledCompositePolyDataMapper()
        composite.SetInputDataObject(blocks)
        both = vtkActor()
        both.SetMapper(composite)
        self.add(both)
        with vitrine.section(self.renderer, "y", (0, 0, 0), edges=0, hatch={(both, 2): "cross"}):
            image = self.scene.picture().reshape(SIZE, SIZE, 3)
        spread = [np.ptp(image[MIDDLE - 4 : MIDDLE + 4, x - 4 : x + 4], axis=(0, 1)).max() for x in (14, 34)]
        self.assertLess(spread[0], 20)
        self.assertGreater(spread[1], 20)

    def test_stripes_name_a_part_and_can_be_switched_off(self):
        small, large = self.add(ball(0.3, color=(1, 0, 0)), ball(0.5, color=(0, 1, 0)))
        for actor in (small, large):
            actor.GetProperty().LightingOff()
        with vitrine.section(self.renderer, "y", (0, 0, 0), edges=0) as cut:
            middle = self.scene.picture().reshape(SIZE, SIZE, 3)[MIDDLE - 2 : MIDDLE + 2, MIDDLE - 2 : MIDDLE + 2]
            self.assertNotIn((255, 0, 0), map(tuple, middle.reshape(-1, 3)))
            self.assertIs(vitrine.layers_at(self.renderer, MIDDLE, MIDDLE)[0].actor, small)
            self.assertEqual(cut.interfering, [(small, large)])
            cut.look(stripes=False)
            self.assertEqual(self.at_center(), (255, 0, 0))
            self.assertEqual(cut.interfering, [(small, large)])

    def test_caps_have_no_cell(self):
        solid, behind = self.add(ball(), ball(0.3, (0, 0.9, 0)))
        with vitrine.see_through(self.renderer), vitrine.section(self.renderer, "y", (0, 0, 0)):
            self.scene.picture()
            layers = vitrine.layers_at(self.renderer, MIDDLE, MIDDLE, all=True, cells=True)
        self.assertEqual([layer.actor for layer in layers], [solid, solid, behind, behind])
        self.assertIsNone(layers[0].cell)
        self.assertTrue(all(layer.cell is not None for layer in layers[1:]))

    def test_planes_that_cut_nothing_take_no_memory(self):
        self.add(ball())
        section = vitrine.vtkSection()
        section.Attach(self.renderer)
        planes = [vtkPlane() for _ in range(6)]
        for plane in planes:
            plane.SetOrigin(0, 0, -9)
            section.AddPlane(plane)
        self.scene.picture()
        self.assertEqual(section.GetBytes(), 0)
        planes[3].SetOrigin(0, 0, 0)
        before = self.scene.picture()
        bytes_of_one = section.GetBytes()
        self.assertGreaterEqual(bytes_of_one, 8 * SIZE * SIZE)
        self.assertLess(bytes_of_one, 12 * SIZE * SIZE + 100_000)
        for plane in planes[:3]:
            section.RemovePlane(plane)
        self.assertTrue((self.scene.picture() == before).all())
        section.Detach()

    def test_a_refused_box_leaves_other_renderers_alone(self):
        other = vtkRenderer()
        self.scene.window.AddRenderer(other)
        with vitrine.section_box(self.renderer, (0, 1, 0, 1, 0, 1)):
            with self.assertRaisesRegex(ValueError, "one box"):
                vitrine.section_box(self.scene.window, (0, 1, 0, 1, 0, 1))
            self.assertIsNone(vitrine.vtkSection.GetAttached(other))
