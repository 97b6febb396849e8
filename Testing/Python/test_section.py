"""Sections with caps: methods, several planes, picks, and the face in Python."""

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane, vtkPolyData, vtkSelectionNode
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkGlyph3DMapper,
    vtkHardwareSelector,
    vtkPolyDataMapper,
)
from vtkmodules.util.numpy_support import numpy_to_vtk

import vitrine
from section_scenes import SIZE, SectionCase, ball


class Frames(SectionCase):
    def test_methods_draw_translucent_caps_alike(self):
        self.add(ball(0.5, opacity=0.4), ball(0.3, (0.3, 0.4, 0), (0.9, 0.3, 0.1), 0.6), ball(0.2, (-0.5, 0, 0)))
        with vitrine.section(self.renderer, "y", (0, 0.05, 0)):
            with vitrine.see_through(self.renderer, "truth"):
                truth = self.scene.picture()
            for method in ("linked-list", "prefix-sum", "prefix-sum-predicted", "stencil-routed"):
                with self.subTest(method), vitrine.see_through(self.renderer, method):
                    self.assertLessEqual(np.abs(self.scene.picture() - truth).max(), 1)
            whole = truth
        with vitrine.see_through(self.renderer, "truth"):
            self.assertGreater(np.abs(self.scene.picture() - whole).max(), 50)

    def test_cap_of_glass_is_one_layer(self):
        """Before the section a ball has two layers, and so has it with a cap in place of its front."""
        (glass,) = self.add(ball(0.5, color=(1, 0, 0), opacity=0.5))
        glass.GetProperty().SetAmbient(1)
        glass.GetProperty().SetDiffuse(0)
        with vitrine.see_through(self.renderer), vitrine.section(self.renderer, "y", (0, 0, 0)) as cut:
            self.assertEqual(self.at_center(), (255, 64, 64))
            self.assertEqual(vitrine.stats(self.renderer).layers_max, 2)
            cut.move("-y")  # the eye is on the side that is kept
            self.assertEqual(self.at_center(), (255, 64, 64))

    def test_caps_have_the_samples_of_the_window(self):
        """Beside the mean of 64 pixels each, outlines of caps are as good as VTK's own with four samples are."""
        (red,) = self.add(ball(color=(1, 0, 0)))
        red.GetProperty().SetAmbient(1)
        red.GetProperty().SetDiffuse(0)
        red.GetMapper().AddClippingPlane(self.scene.nothing)
        window = self.scene.window
        with vitrine.section(self.renderer, "y", (0, 0, 0), edges=0):
            window.SetSize(8 * SIZE, 8 * SIZE)
            mean = self.scene.picture()[:, 1].reshape(SIZE, 8, SIZE, 8).mean(axis=(1, 3)).ravel()
            window.SetSize(SIZE, SIZE)
            outline = (mean > 0) & (mean < 255)
            sharp = self.scene.picture()[:, 1]
            window.SetMultiSamples(4)
            smooth = self.scene.picture()[:, 1]
            errors = [np.abs(picture - mean)[outline].mean() for picture in (sharp, smooth)]
            self.assertLess(errors[1], 0.4 * errors[0])
            for method in ("linked-list", "prefix-sum"):
                with self.subTest(method), vitrine.see_through(self.renderer, method):
                    self.assertLessEqual(np.abs(self.scene.picture()[:, 1] - smooth).max(), 1)
            red.GetProperty().SetOpacity(0.5)
            with vitrine.see_through(self.renderer):
                self.assertLessEqual(np.abs(self.scene.picture()[:, 1] - (smooth + 255) / 2).max(), 2)

    def test_the_culler_changes_no_pixel(self):
        """The wall would hide all others, but a section takes most of it away."""
        wall = ball(2.0)
        others = [ball(0.1, (x, 1.0, z), (0.9, 0.5, 0.1)) for x in (-0.8, 0.0, 0.8) for z in (-0.8, 0.0, 0.8)]
        self.add(wall, ball(0.3, (0, 5, 0)), *others)
        self.renderer.GetActiveCamera().SetPosition(0, -9, 0)
        self.renderer.ResetCameraClippingRange()
        with vitrine.section(self.renderer, "y", (0, 0.3, 0), but=others):
            plain = self.scene.picture()
            with vitrine.see_through(self.renderer, cull=True) as handle:
                self.assertEqual(np.abs(self.scene.picture() - plain).max(), 0)
                self.assertEqual(handle.stats().culled_parts, 0)
        with vitrine.see_through(self.renderer, cull=True) as handle:
            self.scene.picture()
            self.assertGreater(handle.stats().culled_parts, 5)
        # Parts that are kept as a whole go on hiding.
        with vitrine.section(self.renderer, "y", (0, -4, 0)), vitrine.see_through(self.renderer, cull=True) as handle:
            self.scene.picture()
            self.assertGreater(handle.stats().culled_parts, 5)

    def add_two_balls(self):
        """Add an assembly of two balls, left and right, which are blocks of one actor, and a part beside it."""
        blocks = vtkMultiBlockDataSet()
        for i, x in enumerate((-0.6, 0.6)):
            source = vtkSphereSource()
            source.SetCenter(x, 0, 0)
            source.Update()
            blocks.SetBlock(i, source.GetOutput())
            blocks.GetMetaData(i).Set(blocks.NAME(), ("left", "right")[i])
        machine = vitrine.from_multiblock(blocks)
        machine.add_to(self.renderer)
        self.add()
        return machine

    def test_blocks_are_chosen_one_by_one(self):
        machine = self.add_two_balls()
        actors = [actor for actor in self.renderer.GetViewProps() if machine.part_of(actor, 1)]
        whole = self.scene.picture().reshape(SIZE, SIZE, 3)
        with vitrine.section(self.renderer, "y", (0, 0.2, 0), parts=machine.parts[0]) as cut:
            half = self.scene.picture().reshape(SIZE, SIZE, 3)
            self.assertEqual(len(cut.cut_parts), 1)
        self.assertTrue((half[:, SIZE // 2 + 3 :] == whole[:, SIZE // 2 + 3 :]).all())
        self.assertFalse((half[:, : SIZE // 2 - 3] == whole[:, : SIZE // 2 - 3]).all())
        with vitrine.section(self.renderer, "y", (0, 0.2, 0), parts="le*") as cut:
            self.assertTrue((self.scene.picture().reshape(SIZE, SIZE, 3) == half).all())
            cut.remove()
            with self.assertRaisesRegex(RuntimeError, "was removed"):
                cut.move(origin=(0, 0, 0))
        self.assertTrue(actors)

    def test_an_inner_node_stands_for_the_blocks_below_it(self):
        root, inner = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
        root.SetBlock(0, inner)
        for tree, place, x in ((inner, 0, -0.6), (inner, 1, 0.0), (root, 1, 0.6)):
            mapper = ball(0.25, (x, 0, 0)).GetMapper()
            mapper.Update()
            tree.SetBlock(place, mapper.GetInput())
        composite = vitrine.vtkCulledCompositePolyDataMapper()
        composite.SetInputDataObject(root)
        actor = vtkActor()
        actor.SetMapper(composite)
        self.add(actor)
        for block, wanted, outlined in ((0, [2, 3, 4], 1), (1, [2, 3], 2), (4, [4], 1)):
            with self.subTest(block), vitrine.section(self.renderer, "y", (0, 0, 0), parts=(actor, block)) as cut:
                self.scene.picture()
                self.assertEqual(cut.cut_parts, [(actor, leaf) for leaf in wanted])
            with vitrine.highlight(self.renderer, (actor, block)) as shown:
                self.assertIn(f" {outlined} part", str(shown))

    def test_masks_of_blocks_follow_the_context(self):
        """A window that is finalized and drawn again has another context, in which names of buffers are others'."""
        machine = self.add_two_balls()
        with vitrine.section(self.renderer, "y", (0, 0.2, 0), parts=machine.parts[0], caps=False):
            before = self.scene.picture()
            for _ in range(2):
                self.scene.window.Finalize()
                self.assertTrue((self.scene.picture() == before).all())

    def test_a_pick_within_a_frame_leaves_it_cut(self):
        self.add(ball())
        with vitrine.section(self.renderer, "y", (0, 0, 0)):
            before = self.scene.picture()
            picked = []
            tag = self.renderer.AddObserver(
                "StartEvent", lambda *_: picked.append(vitrine.pick(self.scene.window, SIZE // 2, SIZE // 2)), -1.0
            )
            self.assertTrue((self.scene.picture() == before).all())
            self.renderer.RemoveObserver(tag)
            self.assertTrue(picked)

    def test_far_props_and_far_planes(self):
        """A prop far away along the normal does not move the cut. A plane at the end of numbers removes all."""
        self.add(ball())
        with vitrine.section(self.renderer, "y", (0, 0, 0)) as cut:
            near = self.scene.picture()
            far = ball(0.5, (0, 1e6, 0))
            self.renderer.AddActor(far)
            self.assertTrue((self.scene.picture() == near).all())
            self.renderer.RemoveActor(far)
            cut.move(origin=(0, 1e300, 0))
            self.assertTrue((self.scene.picture() == 255).all())

    def test_a_prop_that_is_gone_is_not_chosen(self):
        """The address of the prop that was chosen is given to a new one sooner or later."""
        section, plane = vitrine.vtkSection(), vtkPlane()
        section.AddPlane(plane)
        section.SetParts(plane, vitrine.vtkSection.ONLY_CHOSEN)
        section.Attach(self.renderer)
        for _ in range(64):
            old = ball()
            section.ChoosePart(plane, old)
            address = old.__this__
            del old
            new = ball()
            self.renderer.AddActor(new)
            self.assertEqual(section.GetNumberOfCutParts(), 0)
            if new.__this__ == address:
                break

    def test_interference_of_many_parts(self):
        """Five balls in each other make ten pairs, as the last frame shows them, also when one has moved since."""
        balls = self.add(*(ball(0.3 + 0.05 * i) for i in range(5)))
        with vitrine.section(self.renderer, "y", (0, 0, 0)) as cut:
            self.scene.picture()
            self.assertEqual(len(cut.interfering), 10)
            balls[0].SetPosition(1e-6, 0, 0)
            self.assertEqual(len(cut.cut_parts), 5)
            self.assertEqual(len(cut.interfering), 10)

    def test_what_has_no_cap_is_named(self):
        solid, wires = self.add(ball(), ball(0.3))
        wires.GetProperty().SetRepresentationToWireframe()
        points = vtkPolyData()
        points.SetPoints(vtkPoints())
        points.GetPoints().InsertNextPoint(0, 0, 0)
        source = vtkSphereSource()
        glyphs = vtkGlyph3DMapper()
        glyphs.SetInputData(points)
        glyphs.SetSourceConnection(source.GetOutputPort())
        copies = vtkActor()
        copies.SetMapper(glyphs)
        self.renderer.AddActor(copies)
        with vitrine.section(self.renderer, "y", (0, 0, 0)) as cut:
            self.scene.picture()
            self.assertEqual(cut.cut_parts, [solid, wires, copies])
            self.assertEqual(cut.open_parts, [wires, copies])

    def test_caps_have_the_colour_of_scalars_in_textures(self):
        (actor,) = self.add(ball())
        mapper = actor.GetMapper()
        mapper.Update()
        data = vtkPolyData()
        data.DeepCopy(mapper.GetInput())
        data.GetPointData().SetScalars(numpy_to_vtk(np.zeros(data.GetNumberOfPoints()), deep=True))
        mapper.SetInputData(data)
        with vitrine.section(self.renderer, "y", (0, 0, 0)):
            plain = self.at_center()
            mapper.InterpolateScalarsBeforeMappingOn()
            self.assertEqual(self.at_center(), plain)

    def test_a_box_is_cut_and_moved(self):
        """Of a cube around the origin, a box keeps its own share, or all but that."""
        mapper = vtkPolyDataMapper()
        cube = vtkCubeSource()
        mapper.SetInputConnection(cube.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        self.add(actor)
        whole = self.scene.picture()
        small, half = (-0.25, 0.25) * 3, (-1, 0, -1, 1, -1, 1)

        def by_hand(*box):
            section = vitrine.vtkSection()
            section.SetBox(*box)
            section.Attach(self.renderer)
            picture = self.scene.picture()
            section.Detach()
            return picture

        wanted = [by_hand(*small, True), by_hand(*half, True), by_hand(*half, False)]
        self.assertFalse((wanted[0] == wanted[1]).all() or (wanted[1] == wanted[2]).all())
        with vitrine.section_box(self.renderer, small) as cut:
            self.assertTrue((self.scene.picture() == wanted[0]).all())
            self.assertEqual((cut.cut_parts, cut.open_parts), ([actor], []))
            cut.move(half)
            self.assertTrue((self.scene.picture() == wanted[1]).all())
            cut.move(inside=False)
            self.assertTrue((self.scene.picture() == wanted[2]).all())
            self.assertEqual((cut.bounds, cut.inside), (half, False))
            with vitrine.section(self.renderer, "x", (0.25, 0, 0)):
                self.assertFalse((self.scene.picture() == wanted[2]).all())
            self.assertTrue((self.scene.picture() == wanted[2]).all())
            with self.assertRaisesRegex(ValueError, "one box"):
                vitrine.section_box(self.renderer, small)
            with self.assertRaisesRegex(ValueError, "xmin < xmax"):
                cut.move((1, 0, 0, 1, 0, 1))
            self.assertEqual(cut.bounds, half)
        self.assertTrue((self.scene.picture() == whole).all())
        self.assertIsNone(vitrine.vtkSection.GetAttached(self.renderer))
        for error, bounds, more in (
            (ValueError, (0, 1), {}),
            (ValueError, (0, 1, 0, 1, 0, float("inf")), {}),
            (ValueError, small, {"hatch": "checks"}),
            (TypeError, small, {"inside": 1}),
        ):
            with self.subTest(bounds=bounds, **more), self.assertRaises(error):
                vitrine.section_box(self.renderer, bounds, **more)
        self.assertIsNone(vitrine.vtkSection.GetAttached(self.renderer))

    def test_picks_find_what_is_kept(self):
        front, behind = self.add(ball(0.4, (0, -1, 0)), ball(0.4, (0, 1, 0)))
        with vitrine.section(self.renderer, "y", (0, 0.5, 0)):
            self.scene.picture()
            selector = vtkHardwareSelector()
            selector.SetRenderer(self.renderer)
            middle = SIZE // 2
            selector.SetArea(middle, middle, middle, middle)
            found = selector.Select()
            self.assertEqual(found.GetNumberOfNodes(), 1)
            self.assertIsNot(found.GetNode(0).GetProperties().Get(vtkSelectionNode.PROP()), front)

    def test_layers_name_the_part_of_a_cap(self):
        glass, behind = self.add(ball(opacity=0.5), ball(0.3, (0, 0.9, 0)))
        with vitrine.see_through(self.scene.window), vitrine.section(self.renderer, "y", (0, 0, 0)):
            self.scene.picture()
            layers = list(vitrine.layers_at(self.scene.window, SIZE // 2, SIZE // 2))
            self.assertEqual([layer.actor for layer in layers], [glass, glass, behind])
            self.assertAlmostEqual(layers[0].position[1], 0.0, delta=1e-3)

    def test_picks_between_frames_see_what_has_changed(self):
        solid, behind = self.add(ball(), ball(0.3, (0, 0.9, 0)))
        other = ball(0.2, (0, 0.4, 0)).GetMapper()
        with vitrine.section(self.renderer, "y", (0, 0, 0)):
            self.scene.picture()
            for change, parts in (
                (lambda: None, [solid]),
                (lambda: solid.SetPosition(5, 0, 0), [behind]),
                (lambda: solid.SetPosition(0, 0, 0), [solid]),
                (lambda: solid.GetMapper().SetInputConnection(other.GetInputConnection(0, 0)), [solid]),
            ):
                change()
                layers = vitrine.layers_at(self.scene.window, SIZE // 2, SIZE // 2)
                self.assertEqual([layer.actor for layer in layers[:1]], parts)
            self.assertGreater(layers[0].position[1], 0.1)

    def test_wrong_input_says_what_to_do(self):
        (actor,) = self.add(ball())
        for error, arguments in (
            (ValueError, {"normal": (0, 0, 0)}),
            (ValueError, {"normal": (0, float("nan"), 1)}),
            (ValueError, {"normal": "w"}),
            (ValueError, {"origin": (1, 2)}),
            (ValueError, {"hatch": "checks"}),
            (ValueError, {"edges": 7}),
            (ValueError, {"parts": actor, "but": actor}),
            (KeyError, {"parts": "actor"}),
            (TypeError, {"parts": (actor, 1.5)}),
            (ValueError, {"parts": (actor, -1)}),
            (TypeError, {"normal": None}),
            (TypeError, {"origin": 3}),
            (TypeError, {"edges": "2"}),
            (ValueError, {"parts": []}),
            (ValueError, {"parts": ball()}),
            (ValueError, {"parts": (actor, 3)}),
            (ValueError, {"parts": (actor, 2**40)}),
            (TypeError, {"parts": vtkAssembly()}),
            (ValueError, {"edges": 1.5}),
            (TypeError, {"caps": 1}),
        ):
            with self.subTest(arguments), self.assertRaises(error):
                vitrine.section(self.renderer, **arguments)
        self.assertIsNone(vitrine.vtkSection.GetAttached(self.renderer))
        cuts = [vitrine.section(self.renderer, "x") for _ in range(6)]
        with self.assertRaisesRegex(ValueError, "six planes|6 planes"):
            vitrine.section(self.renderer, "x")
        self.assertEqual(len(cuts), 6)
