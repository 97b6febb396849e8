"""load() and assemblies: names, trees, looks, picks, pictures beside plain actors, and hostile input."""

import doctest
import math
import unittest

import numpy
from machine import (
    BOXES,
    PATHS,
    SIZE,
    Files,
    box_bounds,
    cube,
    machine_view,
    plain_actor,
    plain_view,
    png,
    write_compressed_cube,
    write_glb,
    write_textured,
)
from scenes import Plotter, pixels, rendered, window_with
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkSelectionNode
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCellPicker,
    vtkHardwareSelector,
    vtkRenderer,
    vtkRenderWindow,
)

import vitrine
import vitrine._assembly


class Parts(Files):
    def test_are_those_of_the_file(self):
        parts = self.machine.parts
        self.assertEqual([part.number for part in parts], [0, 1, 2, 3, 4])
        self.assertEqual(tuple(part.path for part in parts), PATHS)
        self.assertEqual(
            [part.name for part in parts], ["lid", "window", "gear-1", "gear-2", "bolt"]
        )
        self.assertEqual([part.material for part in parts], [BOXES[path][0] for path in PATHS])
        self.assertEqual([part.triangles for part in parts], [12] * 5)
        for part in parts:
            self.assertEqual(part.bounds, box_bounds(part.path))
        self.assertEqual(list(self.machine), list(parts))
        self.assertEqual(len(self.machine), 5)
        self.assertEqual(self.machine.notes, ())
        self.assertEqual(repr(self.machine), "<Assembly of 5 parts, drawn by 3 actors>")

    def test_have_bounds_of_turned_boxes(self):
        turn = [0, 0, math.sin(math.pi / 8), math.cos(math.pi / 8)]  # 45 degrees around z
        nodes = [{"name": "box", "mesh": 0, "rotation": turn, "scale": [2, 2, 2]}]
        write_glb(self.file, nodes, [0], [(*cube(), None)])
        (part,) = vitrine.load(self.file)
        root = math.sqrt(2)
        numpy.testing.assert_allclose(part.bounds, (-root, root, -root, root, -1, 1), atol=1e-6)

    def test_have_bounds_of_their_points_where_their_box_is_wider(self):
        points = numpy.array([(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)], numpy.float32)
        normals = numpy.array([(0, 0, 1)] * 4, numpy.float32)
        diamond = points, normals, numpy.array([(0, 1, 2), (0, 2, 3)], numpy.uint32)
        turn = [0, 0, math.sin(math.pi / 8), math.cos(math.pi / 8)]  # 45 degrees around z
        nodes = [{"name": "diamond", "mesh": 0, "rotation": turn, "translation": [5, 0, 1]}]
        write_glb(self.file, nodes, [0], [(*diamond, None)])
        (part,) = vitrine.load(self.file)
        half = math.sqrt(0.5)
        expected = (5 - half, 5 + half, -half, half, 1, 1)
        numpy.testing.assert_allclose(part.bounds, expected, atol=1e-6)

    def test_of_compressed_geometry_are_whole(self):
        for extension in ("KHR_draco_mesh_compression", "EXT_meshopt_compression"):
            with self.subTest(extension):
                write_compressed_cube(self.file, extension)
                (part,) = vitrine.load(self.file)
                self.assertEqual((part.triangles, part.bounds), (12, (-0.5, 0.5) * 3))

    def test_are_chosen_by_patterns(self):
        for pattern, numbers in (
            ("lid", [0]),
            ("gear*", [2, 3, 4]),
            ("Gearbox", [2, 3, 4]),
            ("/Machine/Housing/*", [0, 1]),
            ("/Machine/**/bolt", [4]),
            ("/*", [0, 1, 2, 3, 4]),
            ("material:glass*", [1]),
            ("material:steel", [2, 3]),
            ("gear-?/bolt", [4]),
        ):
            with self.subTest(pattern):
                chosen = self.machine[pattern]
                self.assertEqual(chosen.numbers, numbers)
                self.assertEqual(list(chosen), [self.machine.parts[number] for number in numbers])
                self.assertEqual(chosen.parts, list(chosen))
                self.assertIn(pattern, self.machine)
        self.assertEqual(repr(self.machine["lid"]), "<Selection of 1 part>")
        self.assertNotIn("Lid", self.machine)
        self.assertNotIn(7, self.machine)

    def test_that_no_pattern_chooses_are_named_if_they_are_near(self):
        for pattern, message in (
            ("Lid", "'Lid' chooses no part; near are 'lid'"),
            ("bold", "'bold' chooses no part; near are 'bolt'"),
            ("material:Steel", "'material:Steel' chooses no part; near are 'steel'"),
            ("zzzzzzzz", "'zzzzzzzz' chooses no part"),
            ("", "the pattern '' is empty"),
            ("material:", "the pattern 'material:' is empty"),
        ):
            with self.subTest(pattern), self.assertRaises(KeyError) as raised:
                self.machine[pattern]
            self.assertEqual(raised.exception.args, (message,))


class Trees(Files):
    def test_show_names_parts_and_triangles(self):
        tree = self.machine.tree()
        self.assertEqual(
            str(tree),
            "Machine  (5 parts, 60 triangles)\n"
            "  Housing  (2 parts, 24 triangles)\n"
            "    lid  (12 triangles)\n"
            "    window  (12 triangles)\n"
            "  Gearbox  (3 parts, 36 triangles)\n"
            "    gear-1  (12 triangles)\n"
            "    gear-2  (2 parts, 24 triangles)\n"
            "      bolt  (12 triangles)",
        )
        self.assertEqual(repr(tree), str(tree))
        self.assertEqual([child.path for child in tree.children], ["/Machine/Housing", "/Machine/Gearbox"])
        gear = tree.children[1].children[1]
        self.assertEqual((gear.name, gear.part), ("gear-2", self.machine.parts[3]))
        self.assertEqual(gear.parts(), list(self.machine["gear-2"]))
        self.assertEqual(tree.parts(), list(self.machine))

    def test_of_several_roots_have_one_without_a_name(self):
        nodes = [{"name": name, "mesh": 0} for name in ("a", "b")]
        write_glb(self.file, nodes, [0, 1], [(*cube(), None)])
        self.assertEqual(
            str(vitrine.load(self.file).tree()),
            "/  (2 parts, 24 triangles)\n  a  (12 triangles)\n  b  (12 triangles)",
        )

    def test_of_many_parts_say_how_many_more_there_are(self):
        groups, each = 40, 25
        nodes = [{"name": "root", "children": list(range(1, groups + 1))}]
        for i in range(groups):
            first = 1 + groups + i * each
            nodes.append({"name": f"group{i}", "children": list(range(first, first + each))})
        nodes += [{"name": f"part{i}", "mesh": 0} for i in range(groups * each)]
        write_glb(self.file, nodes, [0], [(*cube(), None)])
        tree = vitrine.load(self.file).tree()
        lines = str(tree).splitlines()
        self.assertLessEqual(len(lines), 60)
        self.assertEqual(lines[0], "root  (1,000 parts, 12,000 triangles)")
        self.assertEqual(lines[1:3], ["  group0  (25 parts, 300 triangles)", "    part0  (12 triangles)"])
        self.assertRegex(lines[-1], r"^  \.\.\. \d+ more$")
        told = sum(int(line.split()[1]) for line in lines if "more" in line and line.startswith("  ..."))
        shown = sum(line.startswith("  group") for line in lines)
        self.assertEqual(shown + told, groups)
        self.assertEqual(len(tree.text(None).splitlines()), 1 + groups + groups * each)
        self.assertEqual(tree.text(1), lines[0])

    def test_of_great_depth_are_shown(self):
        depth = 900
        nodes = [{"name": "n", "children": [i + 1]} for i in range(depth)]
        nodes.append({"name": "leaf", "mesh": 0})
        write_glb(self.file, nodes, [0], [(*cube(), None)])
        tree = vitrine.load(self.file).tree()
        self.assertLessEqual(len(str(tree).splitlines()), 60)
        lines = tree.text(None).splitlines()
        self.assertEqual(lines[-1], "  " * depth + "leaf  (12 triangles)")
        self.assertEqual(len(lines), depth + 1)

    def test_refuse_other_numbers_of_lines(self):
        with self.assertRaises(ValueError):
            self.machine.tree().text(0)
        for lines in ("5", 5.0, True):
            with self.assertRaises(TypeError):
                self.machine.tree().text(lines)


class Pictures(Files):
    def assert_same(self, renderer, plain, see_through=True):
        if see_through:
            vitrine.see_through(renderer)
            vitrine.see_through(plain)
        picture = rendered(renderer, size=SIZE)
        numpy.testing.assert_array_equal(picture, rendered(plain, size=SIZE))
        return picture

    def test_are_those_of_plain_actors(self):
        for see_through in (False, True):
            picture = self.assert_same(self.view(), plain_view(), see_through)
            self.assertEqual(len(numpy.unique(picture.reshape(-1, 4), axis=0)) > 4, True)

    def test_of_glass_parts_are_those_of_plain_actors(self):
        looks = {path: {"opacity": 0.25} for path in PATHS if path.startswith("/Machine/Housing/")}
        solid = rendered(self.view(), size=SIZE)
        self.machine["/Machine/Housing/*"].opacity = 0.25
        glass = self.assert_same(self.view(), plain_view(looks))
        self.assertTrue((glass[60, 20] != solid[60, 20]).any())

    def test_of_colored_parts_are_those_of_plain_actors(self):
        self.machine["gear*"].color = "tomato"
        tomato = (255 / 255, 99 / 255, 71 / 255)
        looks = {path: {"color": tomato} for path in PATHS[2:]}
        self.assert_same(self.view(), plain_view(looks))

    def test_of_hidden_parts_are_those_of_plain_actors(self):
        self.machine["Housing"].visible = False
        self.assert_same(self.view(), plain_view(hidden=PATHS[:2]))

    def test_of_exploded_parts_are_those_of_moved_actors(self):
        # The machine's box has its centre at (-0.25, 0), the housing's at (-0.25, 2), the gearbox's at (0, -1.125), and
        # that of gear-2 with its bolt at (2, -1.125).
        gearbox = numpy.array((0.125, -0.5625))
        offsets = {
            PATHS[0]: (-0.875, 1.0),
            PATHS[1]: (1.125, 1.0),
            PATHS[2]: gearbox + (-1.0, -0.4375),
            PATHS[3]: gearbox + (1.0, 0.0),
            PATHS[4]: gearbox + (1.0, 0.0) + (0.0, 0.5625),
        }
        plain = machine_view()
        for path, offset in offsets.items():
            actor = plain_actor(path)
            actor.SetPosition(*offset, 0)
            plain.AddActor(actor)
        whole = rendered(self.view(), size=SIZE)
        bounds = self.view().ComputeVisiblePropBounds()
        self.machine.explode(0.5)
        self.assert_same(self.view(), plain)
        self.assertEqual(self.view().ComputeVisiblePropBounds(), plain.ComputeVisiblePropBounds())
        moved = [0.0, 0.0, 0.0]
        self.machine.actors.GetPartOffset(4, moved)
        self.assertEqual(moved, [1.125, 0.0, 0.0])
        self.machine.explode(0)
        numpy.testing.assert_array_equal(rendered(self.view(), size=SIZE), whole)
        self.assertEqual(self.view().ComputeVisiblePropBounds(), bounds)

    def test_of_exploded_actors_of_one_part_are_moved(self):
        write_textured(self.file, png(1, 1, [bytes((0, 255, 0))]))  # textured parts are actors of their own
        pair = vitrine.load(self.file)
        pair.explode(1.0)
        bounds = [pair.actors.GetPartActor(number).GetBounds()[:2] for number in (0, 1)]
        numpy.testing.assert_allclose(bounds, [(-1.4, -0.6), (0.6, 1.4)], atol=1e-6)

    def test_of_exploded_views_refuse_other_factors(self):
        for factor, error in ((-1, ValueError), (math.nan, ValueError), (1001, ValueError), ("2", TypeError)):
            with self.subTest(factor=factor), self.assertRaisesRegex(error, "factor is a number from 0 to 1000"):
                self.machine.explode(factor)

    def test_of_isolated_parts_are_those_of_plain_actors(self):
        self.assertEqual(self.machine.isolate("gear-1", 0.25).numbers, [2])
        looks = {path: {"opacity": 0.25} for path in PATHS if not path.endswith("gear-1")}
        looks[PATHS[1]]["opacity"] = 0.0625
        self.assert_same(self.view(), plain_view(looks))

    def test_after_changes_are_those_of_the_next_frame(self):
        renderer = self.view()
        vitrine.see_through(renderer)
        window = window_with(renderer, size=SIZE)
        pictures = []
        for change in (
            lambda: None,
            lambda: setattr(self.machine["lid"], "opacity", 0.5),
            lambda: setattr(self.machine["gear-2"], "color", (0, 1, 0)),
            lambda: setattr(self.machine["bolt"], "visible", False),
            lambda: self.machine.explode(0.5),
            lambda: (self.machine.reset(), self.machine.explode(0)),
        ):
            change()
            window.Render()
            pictures.append(pixels(window))
        for one, other in zip(pictures, pictures[1:]):
            self.assertTrue((one != other).any())
        numpy.testing.assert_array_equal(pictures[0], pictures[-1])

    def test_of_colored_parts_lose_their_textures(self):
        green = png(1, 1, [bytes((0, 255, 0))])
        for is_unlit in (False, True):
            with self.subTest(unlit=is_unlit):
                write_textured(self.file, green, is_unlit)
                pair = vitrine.load(self.file)
                pair["right"].color = "red"
                renderer = vtkRenderer()
                pair.add_to(renderer)
                renderer.ResetCamera()
                row = rendered(renderer, size=(40, 20))[10].astype(int)
                left, right = row[12], row[28]
                self.assertGreater(left[1], left[0] + 50)
                self.assertGreater(right[0], right[1] + 50)

    def test_with_the_culler_are_the_same(self):
        self.machine.isolate("gear*")
        plain = self.view()
        self.machine.explode(0.25)
        culled = self.view(self.machine)
        vitrine.see_through(plain)
        vitrine.see_through(culled, cull=True)
        numpy.testing.assert_array_equal(rendered(plain, size=SIZE), rendered(culled, size=SIZE))


class Looks(Files):
    def test_are_told_where_all_parts_have_the_same(self):
        lid, gears, all_parts = (self.machine[name] for name in ("lid", "gear*", "/*"))
        self.assertEqual((lid.opacity, lid.color, lid.visible), (None, None, None))
        gears.opacity = 1
        gears.color = "#ff8000"
        gears.visible = False
        self.assertEqual((gears.opacity, gears.visible), (1.0, False))
        numpy.testing.assert_allclose(gears.color, (1, 128 / 255, 0))
        self.assertEqual((all_parts.opacity, all_parts.color, all_parts.visible), (None, None, None))
        self.assertIsNone(lid.opacity)

    def test_take_numbers_of_numpy_and_sequences(self):
        lid = self.machine["lid"]
        lid.opacity = numpy.float32(0.5)
        lid.color = numpy.array([0.0, 0.5, 1.0])
        self.assertEqual((lid.opacity, lid.color), (0.5, (0.0, 0.5, 1.0)))
        lid.color = [1, 0, 0]
        self.assertEqual(lid.color, (1.0, 0.0, 0.0))

    def test_of_none_are_those_of_the_file(self):
        plain = rendered(self.view(), size=SIZE)
        lid = self.machine["lid"]
        lid.opacity, lid.color, lid.visible = 0.5, "red", False
        lid.visible = None
        lid.opacity = None
        self.assertEqual((lid.opacity, lid.color, lid.visible), (None, (1.0, 0.0, 0.0), None))
        picture = rendered(self.view(), size=SIZE)
        red = rendered(plain_view({PATHS[0]: {"color": (1, 0, 0)}}), size=SIZE)
        numpy.testing.assert_array_equal(picture, red)
        lid.color = None
        numpy.testing.assert_array_equal(rendered(self.view(), size=SIZE), plain)

    def test_of_an_earlier_isolate_are_undone(self):
        self.machine["lid"].opacity = 0.75
        self.machine.isolate("gear-1")
        self.assertEqual(self.machine["lid"].opacity, 0.75 * 0.1)
        self.machine.isolate("lid", 0.5)
        self.assertEqual(self.machine["lid"].opacity, 0.75)
        self.assertEqual(self.machine["gear-1"].opacity, 0.5)
        self.assertEqual(self.machine["window"].opacity, 0.125)
        self.machine["gear-1"].opacity = 0.875
        self.machine.isolate("lid")
        self.assertAlmostEqual(self.machine["gear-1"].opacity, 0.0875)
        self.machine.reset()
        self.assertIsNone(self.machine["lid"].opacity)

    def test_of_a_misspelt_name_are_refused(self):
        for target in (self.machine, self.machine["*"]):
            with self.assertRaises(AttributeError):
                target.opactiy = 0.5

    def test_refuse_other_values_and_change_nothing(self):
        lid = self.machine["lid"]
        for name, value, error in (
            ("opacity", 1.5, ValueError),
            ("opacity", -0.1, ValueError),
            ("opacity", math.nan, ValueError),
            ("opacity", "0.5", TypeError),
            ("opacity", True, TypeError),
            ("opacity", [0.5], TypeError),
            ("color", "no colour", ValueError),
            ("color", "", ValueError),
            ("color", "#12345", ValueError),
            ("color", (1, 0), ValueError),
            ("color", (255, 99, 71), ValueError),
            ("color", (math.nan, 0, 0), ValueError),
            ("color", 7, TypeError),
            ("color", ("a", "b", "c"), TypeError),
            ("visible", 1, TypeError),
            ("visible", "no", TypeError),
        ):
            with self.subTest(f"{name}={value!r}"), self.assertRaisesRegex(error, name):
                setattr(lid, name, value)
            self.assertIsNone(getattr(lid, name))
        for opacity, error in ((2, ValueError), ("much", TypeError)):
            with self.assertRaises(error):
                self.machine.isolate("lid", opacity)
        with self.assertRaises(KeyError):
            self.machine.isolate("lit")
        self.assertIsNone(self.machine["/*"].opacity)


class Picks(Files):
    # Pixels in the middle of each box, and one beside all.
    PIXELS = {PATHS[0]: (20, 60), PATHS[1]: (60, 60), PATHS[2]: (20, 20), PATHS[3]: (60, 20), PATHS[4]: (60, 40)}

    def test_by_cells_find_the_part(self):
        for renderer in (self.view(), self.view()):
            window = window_with(renderer, size=SIZE)
            window.Render()
            for path, (x, y) in self.PIXELS.items():
                picker = vtkCellPicker()
                self.assertTrue(picker.Pick(x, y, 0, renderer))
                found = self.machine.part_of(picker.GetActor(), picker.GetFlatBlockIndex())
                self.assertEqual(found.path, path)

    def test_by_hardware_find_the_part(self):
        renderer = self.view()
        window = window_with(renderer, size=SIZE)
        window.Render()
        for path, (x, y) in self.PIXELS.items():
            selector = vtkHardwareSelector()
            selector.SetRenderer(renderer)
            selector.SetArea(x, y, x, y)
            selector.SetFieldAssociation(vtkDataObject.FIELD_ASSOCIATION_CELLS)
            selection = selector.Select()
            self.assertEqual(selection.GetNumberOfNodes(), 1, path)
            told = selection.GetNode(0).GetProperties()
            block = told.Get(vtkSelectionNode.COMPOSITE_INDEX())
            found = self.machine.part_of(told.Get(vtkSelectionNode.PROP()), block)
            self.assertEqual(found.path, path)

    def test_of_each_part_lead_back_to_it(self):
        actors = self.machine.actors
        for part in self.machine:
            actor, block = actors.GetPartActor(part.number), actors.GetPartBlock(part.number)
            self.assertIs(self.machine.part_of(actor, block), part)

    def test_of_other_things_find_none(self):
        actor = self.machine.actors.GetActor(0)
        self.assertIsNone(self.machine.part_of(vtkActor(), 1))
        self.assertIsNone(self.machine.part_of(actor, 1000))
        self.assertIsNone(self.machine.part_of(actor))
        for block in ("1", 1.0, None):
            with self.assertRaises(TypeError):
                self.machine.part_of(actor, block)

    def test_of_shared_geometry_find_the_part_by_its_actor(self):
        steps = numpy.linspace(-0.5, 0.5, 52, dtype=numpy.float32)
        x, y = (axis.ravel() for axis in numpy.meshgrid(steps, steps))
        points = numpy.stack([x, y, numpy.zeros_like(x)], axis=1)
        corner = (numpy.arange(51)[:, None] * 52 + numpy.arange(51)).ravel()
        quads = numpy.stack([corner, corner + 1, corner + 53, corner, corner + 53, corner + 52], axis=1)
        normals = numpy.tile(numpy.array([0, 0, 1], numpy.float32), (len(points), 1))
        mesh = (points, normals, quads.reshape(-1, 3).astype(numpy.uint32), None)
        nodes = [{"name": f"plate{i}", "mesh": 0, "translation": [4 * i - 2, 0, 0]} for i in range(2)]
        write_glb(self.file, nodes, [0, 1], [mesh])
        plates = vitrine.load(self.file)
        self.assertEqual(plates.actors.GetNumberOfActors(), 2)
        plates["plate1"].color = (1, 0, 0)
        renderer = self.view(plates)
        window = window_with(renderer, size=SIZE)
        window.Render()
        picture = pixels(window)
        self.assertEqual(picture[40, 60, 1], 0)
        self.assertGreater(picture[40, 20, 1], 0)
        for x, name in ((20, "plate0"), (60, "plate1")):
            picker = vtkCellPicker()
            self.assertTrue(picker.Pick(x, 40, 0, renderer))
            found = plates.part_of(picker.GetActor(), picker.GetFlatBlockIndex())
            self.assertEqual(found.name, name)


class Renderers(Files):
    def test_have_the_parts_once_and_lose_them(self):
        renderer = machine_view()
        empty = rendered(renderer, size=SIZE)
        for _ in range(2):
            self.assertIs(self.machine.add_to(renderer), self.machine)
        self.assertEqual(renderer.GetViewProps().GetNumberOfItems(), 3)
        full = rendered(renderer, size=SIZE)
        for _ in range(2):
            self.machine.remove_from(renderer)
        self.assertEqual(renderer.GetViewProps().GetNumberOfItems(), 0)
        numpy.testing.assert_array_equal(rendered(renderer, size=SIZE), empty)
        self.machine.add_to(renderer)
        numpy.testing.assert_array_equal(rendered(renderer, size=SIZE), full)

    def test_of_another_window_are_refused(self):
        first, second = machine_view(), machine_view()
        windows = [window_with(renderer, size=SIZE) for renderer in (first, second)]
        self.machine.add_to(first)
        with self.assertRaisesRegex(RuntimeError, "load it again"):
            self.machine.add_to(second)
        del windows

    def test_share_an_assembly(self):
        window = window_with(self.view(), size=(2 * SIZE[0], SIZE[1]))
        (left,) = window.GetRenderers()
        left.SetViewport(0, 0, 0.5, 1)
        right = self.view()
        right.SetViewport(0.5, 0, 1, 1)
        window.AddRenderer(right)
        vitrine.see_through(window)
        self.machine["Housing"].opacity = 0.5
        window.Render()
        both = pixels(window)
        numpy.testing.assert_array_equal(both[:, : SIZE[0]], both[:, SIZE[0] :])
        self.machine.remove_from(right)
        window.Render()
        after = pixels(window)
        numpy.testing.assert_array_equal(after[:, : SIZE[0]], both[:, : SIZE[0]])
        self.assertTrue((after[:, SIZE[0] :] == after[0, -1]).all())

    def test_have_two_assemblies_side_by_side(self):
        other = vitrine.load(self.file)
        renderer = self.view()
        other.add_to(renderer)
        self.machine["/*"].visible = False
        other["lid"].color = (0, 1, 0)
        numpy.testing.assert_array_equal(
            rendered(renderer, size=SIZE),
            rendered(plain_view({PATHS[0]: {"color": (0, 1, 0)}}), size=SIZE),
        )
        actor, block = other.actors.GetPartActor(0), other.actors.GetPartBlock(0)
        self.assertIsNone(self.machine.part_of(actor, block))
        self.assertEqual(other.part_of(actor, block).name, "lid")
        other.remove_from(renderer)
        self.assertEqual(renderer.GetViewProps().GetNumberOfItems(), 3)

    def test_are_the_first_of_a_window_and_the_active_one_of_a_plotter(self):
        window = vtkRenderWindow()
        with self.assertRaisesRegex(ValueError, "no renderer"):
            self.machine.add_to(window)
        first, second = vtkRenderer(), vtkRenderer()
        window.AddRenderer(first)
        window.AddRenderer(second)
        self.machine.add_to(window)
        self.assertEqual(first.GetViewProps().GetNumberOfItems(), 3)
        plotter = Plotter(first, second)
        plotter.renderer = second
        self.machine.add_to(plotter)
        self.assertEqual(second.GetViewProps().GetNumberOfItems(), 3)
        plotter.close()
        with self.assertRaisesRegex(RuntimeError, "closed"):
            self.machine.add_to(plotter)
        for target in (None, "window", vtkActor()):
            with self.assertRaises(TypeError):
                self.machine.add_to(target)
            with self.assertRaises(TypeError):
                self.machine.remove_from(target)

    def test_keep_the_parts_when_the_assembly_is_gone(self):
        renderer = self.view()
        expected = rendered(plain_view(), size=SIZE)
        del self.machine
        numpy.testing.assert_array_equal(rendered(renderer, size=SIZE), expected)


class BadFiles(Files):
    def test_are_refused_in_one_line(self):
        whole = self.file.read_bytes()
        for name, data in (
            ("empty.glb", b""),
            ("short.glb", whole[: len(whole) // 2]),
            ("text.gltf", b"hello"),
            ("other.glb", b"PK\x03\x04" + whole[4:]),
            ("array.gltf", b"[]"),
            ("nodes.gltf", b'{"asset": {"version": "2.0"}, "nodes": [{"children": [0]}]}'),
        ):
            file = self.folder / name
            file.write_bytes(data)
            with self.subTest(name), self.assertRaises(ValueError) as raised:
                vitrine.load(file)
            message = str(raised.exception)
            self.assertTrue(message.startswith(f"{file}: "), message)
            self.assertNotIn("\n", message)
            self.assertEqual(message.endswith(": is empty"), not data)

    def test_of_huge_pictures_are_refused_before_they_are_decoded(self):
        write_textured(self.file, png(60000, 60000, [bytes(3)]))
        with self.assertRaisesRegex(ValueError, "pictures of more than"):
            vitrine.load(self.file)
        write_textured(self.file, png(2, 2, [bytes(6)]))
        self.assertIn("no PNG or JPEG, or not a whole one", vitrine.load(self.file).notes[0])

    def test_are_told_apart(self):
        with self.assertRaisesRegex(FileNotFoundError, "nowhere.glb: there is no such file"):
            vitrine.load(self.folder / "nowhere.glb")
        with self.assertRaisesRegex(IsADirectoryError, "is a folder"):
            vitrine.load(self.folder)
        folder = self.folder / "folder.glb"
        folder.mkdir()
        with self.assertRaisesRegex(IsADirectoryError, "folder.glb: is a folder"):
            vitrine.load(str(folder))
        text = self.folder / "notes.txt"
        text.write_text("hello")
        with self.assertRaisesRegex(ValueError, r"not of a kind that can be read: \.glb, \.gltf"):
            vitrine.load(text)
        for path in (None, 7, b"machine.glb", [b"machine.glb"], [["machine.glb"]]):
            with self.subTest(path), self.assertRaises(TypeError):
                vitrine.load(path)

    def test_take_upper_case_and_strings(self):
        file = self.folder / "Größe MACHINE.GLB"
        self.file.rename(file)
        self.assertEqual(len(vitrine.load(str(file))), 5)

    def test_refuse_other_keys(self):
        for pattern in (0, None, b"lid", ("lid",), slice(None)):
            with self.subTest(pattern), self.assertRaisesRegex(TypeError, "a pattern is a str"):
                self.machine[pattern]


class Documentation(unittest.TestCase):
    def test_examples_run(self):
        result = doctest.testmod(vitrine._assembly)
        self.assertGreater(result.attempted, 5)
        self.assertEqual(result.failed, 0)


if __name__ == "__main__":
    unittest.main()
