"""AssemblyIndex: what it tells of parts whose places are known, and how it refuses bad input."""

import doctest
import math
import os
import unittest
from unittest import mock

import numpy
from machine import Files
from scenes import window_with
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkAssembly, vtkPolyDataMapper, vtkRenderer

import vitrine
import vitrine._index


def cube(x, size=1.0):
    source = vtkCubeSource()
    source.SetCenter(x, 0, 0)
    source.SetXLength(size)
    source.SetYLength(size)
    source.SetZLength(size)
    source.Update()
    return source.GetOutput()


def machine(**centers):
    """An assembly of unit cubes along the x axis."""
    blocks = vtkMultiBlockDataSet()
    for i, (name, x) in enumerate(centers.items()):
        blocks.SetBlock(i, cube(x))
        blocks.GetMetaData(i).Set(blocks.NAME(), name)
    return vitrine.from_multiblock(blocks)


class Messages:
    """The errors of an object, which are not printed."""

    def __init__(self, teller):
        self.texts = []

        def note(_teller, _event, text):
            self.texts.append(text)

        note.CallDataType = VTK_STRING
        teller.AddObserver("ErrorEvent", note)


class Measures(unittest.TestCase):
    def setUp(self):
        self.machine = machine(left=0, middle=0.75, right=2.25, far=9)
        self.index = vitrine.AssemblyIndex(self.machine)

    def test_parts_are_those_of_the_assembly(self):
        self.assertEqual(self.index.parts, self.machine.parts)
        self.assertEqual((len(self.index), self.index.left_out), (4, 0))
        self.assertTrue(self.index.is_closed("left"))
        self.assertEqual(repr(self.index), "<AssemblyIndex of 4 parts>")

    def test_clashes(self):
        shares = []
        clashes = self.index.clashes(clearance=0.5, tolerance=0.01, progress=shares.append)
        told = [(c.parts[0].name, c.parts[1].name, c.kind, c.depth, c.distance) for c in clashes]
        self.assertEqual(
            told,
            [("left", "middle", "interfering", 0.25, 0.0), ("middle", "right", "near", 0.0, 0.5)],
        )
        self.assertIsNone(clashes[0].inside)
        self.assertAlmostEqual(clashes[1].point[0], 1.5)
        self.assertIsInstance(clashes[0].point, numpy.ndarray)
        self.assertEqual((shares[0], shares[-1]), (0.0, 1.0))
        self.assertEqual(self.index.clashes(tolerance=0.3)[0].kind, "touching")

    def test_default_tolerance_is_a_thousandth_of_the_diagonal(self):
        diagonal = math.dist((-0.5, -0.5, -0.5), (9.5, 0.5, 0.5))
        self.assertAlmostEqual(self.index.index.GetDefaultTolerance(), diagonal / 1000)

    def test_clashes_stop_as_progress_says(self):
        with self.assertRaisesRegex(InterruptedError, "returned False"):
            self.index.clashes(progress=lambda share: False)
        with self.assertRaises(ZeroDivisionError):
            self.index.clashes(progress=lambda share: 1 / 0)
        self.assertEqual(len(self.index.clashes()), 1)

    def test_rays(self):
        crossings = self.index.ray((-3, 0.1, 0.2), (2, 0, 0), length=5)
        told = [(c.part.name, round(c.distance, 9), c.entering) for c in crossings]
        self.assertEqual(
            told,
            [
                ("left", 2.5, True),
                ("middle", 3.25, True),
                ("left", 3.5, False),
                ("middle", 4.25, False),
                ("right", 4.75, True),
            ],
        )
        numpy.testing.assert_allclose(crossings[0].point, (-0.5, 0.1, 0.2))
        geometry = self.machine.actors.GetPartGeometry(0)
        self.assertEqual(geometry.GetCell(crossings[0].cell).GetBounds()[:2], (-0.5, -0.5))

    def test_walls_and_gaps(self):
        walls = self.index.thickness((-3, 0.1, 0.2), (1, 0, 0))
        told = [(wall.part.name, wall.thickness, wall.gap) for wall in walls]
        wanted = [("left", 1, 2.5), ("middle", 1, 0), ("right", 1, 0.5), ("far", 1, 5.75)]
        self.assertEqual([row[0] for row in told], [row[0] for row in wanted])
        numpy.testing.assert_allclose([row[1:] for row in told], [row[1:] for row in wanted])
        numpy.testing.assert_allclose(walls[3].end_point, (9.5, 0.1, 0.2))

    def test_what_is_near(self):
        near = self.index.nearest((4, 0, 0))
        self.assertEqual((near.part.name, near.distance), ("right", 1.25))
        numpy.testing.assert_allclose(near.point, (2.75, 0, 0))
        names = lambda parts: [part.name for part in parts]  # noqa: E731
        self.assertEqual(names(self.index.within_sphere((2.25, 0, 0), 1.01)), ["middle", "right"])
        self.assertEqual(names(self.index.within_sphere((2.25, 0, 0), 0.9, wholly=True)), ["right"])
        box = (-0.6, 1.6, -1, 1, -1, 1)
        self.assertEqual(names(self.index.within_box(box)), ["left", "middle"])
        self.assertEqual(names(self.index.within_box(box[:1] + (0.6, *box[2:]), wholly=True)), ["left"])

    def test_distances(self):
        gap = self.index.distance("left", self.machine.parts[2])
        self.assertEqual(gap.distance, 1.25)
        self.assertEqual((gap.points[0][0], gap.points[1][0]), (0.5, 1.75))
        self.assertEqual(self.index.distance(0, 1).distance, 0)

    def test_memory_limit_changes_no_answer(self):
        limited = vitrine.AssemblyIndex(self.machine, memory_limit=1)
        self.assertEqual(limited.index.GetMemoryLimit(), 1)
        for index in (self.index, limited):
            clashes = index.clashes(clearance=0.5, tolerance=0.01)
            told = [(clash.kind, clash.depth, clash.distance) for clash in clashes]
            self.assertEqual(told, [("interfering", 0.25, 0), ("near", 0, 0.5)])
            self.assertEqual(len(index.thickness((-3, 0.1, 0.2), (1, 0, 0))), 4)
            self.assertEqual([c.cell for c in index.ray((-3, 0.1, 0.2), (1, 0, 0))][:2], [0, 0])
            self.assertEqual(index.distance(0, 2).distance, 1.25)
        with mock.patch.dict(os.environ, TMPDIR="/there/is/no/such/folder"):
            with self.assertRaisesRegex(OSError, "cannot be written to a temporary file"):
                vitrine.AssemblyIndex(self.machine, memory_limit=1)

    def test_sight(self):
        blocks = vtkMultiBlockDataSet()
        for i, data in enumerate((cube(0), cube(9), cube(50, 80))):
            blocks.SetBlock(i, data)
        walled = vitrine.from_multiblock(blocks)
        self.assertTrue(vitrine.AssemblyIndex(walled).sees(0, 1))
        for through in ("*", [2], walled["*"], [walled.parts[2], walled["*"]]):
            self.assertTrue(vitrine.AssemblyIndex(walled).sees(0, 1, through=through))
        for through in (["middle", "right"], "middle", "?i*"):
            self.assertTrue(self.index.sees("left", "far", through=through))

    def test_bad_input(self):
        index = self.index
        other = machine(left=0)
        nan = float("nan")
        for error, text, call in (
            (TypeError, "a pyvista.Plotter is needed", lambda: vitrine.AssemblyIndex("robot.glb")),
            (ValueError, "no parts to measure", lambda: vitrine.AssemblyIndex(vtkRenderer())),
            (ValueError, "direction may not be 0", lambda: index.ray((0, 0, 0), (0, 0, 0))),
            (ValueError, "3 finite numbers", lambda: index.ray((nan, 0, 0), (1, 0, 0))),
            (ValueError, "3 finite numbers", lambda: index.thickness((0, 0, 0), (1, 0))),
            (ValueError, "at least 0", lambda: index.ray((0, 0, 0), (1, 0, 0), length=-1)),
            (ValueError, "3 finite numbers", lambda: index.nearest((0, math.inf, 0))),
            (TypeError, "3 finite numbers", lambda: index.nearest(7)),
            (ValueError, "xmin, xmax", lambda: index.within_box((1, 0, 0, 1, 0, 1))),
            (ValueError, "radius is a finite", lambda: index.within_sphere((0, 0, 0), -1)),
            (TypeError, "wholly is True", lambda: index.within_sphere((0, 0, 0), 1, wholly=1)),
            (ValueError, "tolerance is a finite", lambda: index.clashes(tolerance=nan)),
            (TypeError, "clearance is a number", lambda: index.clashes("1")),
            (IndexError, "no part 4: there are 4", lambda: index.distance(0, 4)),
            (KeyError, "chooses no part", lambda: index.distance("left", "lift")),
            (ValueError, "name one", lambda: index.distance("left", "*")),
            (KeyError, "is no part of", lambda: index.distance("left", vtkActor())),
            (KeyError, "is no part of", lambda: index.is_closed(other.parts[0])),
            (ValueError, "is gone", lambda: index.is_closed(machine(left=0).parts[0])),
            (TypeError, "part is an actor, a pair", lambda: index.is_closed(1.5)),
            (TypeError, "through is an actor, a pair", lambda: index.sees(0, 1, through=[None])),
            (TypeError, "is a number of bytes", lambda: vitrine.AssemblyIndex(other, memory_limit="1 GB")),
            (ValueError, "bytes above 0", lambda: vitrine.AssemblyIndex(other, memory_limit=0)),
            (TypeError, "it is a function", lambda: index.clashes(progress="x")),
        ):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                call()

    def test_null_is_refused(self):
        index = self.index.index
        errors = Messages(index)
        box, ray = (0, 1, 0, 1, 0, 1), ((-3, 0, 0), (1, 0, 0), 5.0)
        told = [
            index.AddActors(None),
            index.CastRay(*ray, None),
            index.FindWalls(*ray, None),
            index.FindClashes(0, 0, None),
            index.FindPartsInBox(box, False, None),
            index.FindPartsInSphere((0, 0, 0), 1.0, False, None),
        ]
        self.assertEqual(told, [0, False, False, False, False, False])
        self.assertEqual(len(errors.texts), 6)
        self.assertIn("The renderer, the table or the list is null.", errors.texts[0])
        self.assertEqual(index.GetNumberOfParts(), 4)

    def test_examples_of_the_help(self):
        self.assertEqual(doctest.testmod(vitrine._index).failed, 0)


class Shown(Files):
    def test_parts_of_a_file_have_its_places(self):
        index = vitrine.AssemblyIndex(self.machine)
        for part in self.machine.parts:
            self.assertIn(part, index.within_box(part.bounds))

    def test_actors_and_blocks_at_their_places(self):
        first = vtkActor()
        first.SetMapper(vtkPolyDataMapper())
        first.GetMapper().SetInputDataObject(cube(0))
        first.SetPosition(5, 0, 0)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, cube(0))
        blocks.SetBlock(2, cube(2))
        second = vtkActor()
        second.SetMapper(vitrine.vtkCulledCompositePolyDataMapper())
        second.GetMapper().SetInputDataObject(blocks)
        hidden = vtkActor()
        hidden.SetMapper(vtkPolyDataMapper())
        hidden.VisibilityOff()
        renderer = vtkRenderer()
        for actor in (first, second, hidden):
            renderer.AddActor(actor)
        window = window_with(renderer)
        index = vitrine.AssemblyIndex(window)
        self.assertEqual(index.parts, (first, (second, 1), (second, 3)))
        self.assertIs(index.nearest((4, 0, 0)).part, first)
        self.assertEqual(index.distance(first, (second, 3)).distance, 2)

    def test_parts_of_assemblies_are_named_by_them(self):
        """An actor of several parts names all of them, a block or a pattern one."""
        shown = machine(left=0, middle=3, right=6)
        other = vtkActor()
        other.SetMapper(vtkPolyDataMapper())
        other.GetMapper().SetInputDataObject(cube(9))
        renderer = vtkRenderer()
        shown.add_to(renderer)
        renderer.AddActor(other)
        window = window_with(renderer)
        index = vitrine.AssemblyIndex(window)
        self.assertEqual(index.parts, (*shown.parts, other))
        actor = shown.actors.GetPartActor(1)
        pair = (actor, shown.actors.GetPartBlock(1))
        for middle in ("midd*", shown.parts[1], shown["middle"], pair, [shown.parts[1]]):
            self.assertEqual(index.distance(middle, other).distance, 5)
        self.assertEqual(vitrine.AssemblyIndex(shown).distance(pair, 2).distance, 2)
        with self.assertRaisesRegex(ValueError, "chooses 3 parts"):
            index.is_closed(actor)
        with self.assertRaisesRegex(KeyError, "near are 'left'"):
            index.is_closed("lefd")
        window.RemoveRenderer(renderer)

    def test_hidden_parts_and_caps_are_left_out(self):
        """A vtkAssembly's actors are parts by themselves. Actors without points or without input are none."""
        cut, hidden, empty, within = (vtkActor() for _ in range(4))
        for actor, data in ((cut, cube(0)), (hidden, cube(3)), (empty, vtkPolyData()), (within, cube(6))):
            actor.SetMapper(vtkPolyDataMapper())
            actor.GetMapper().SetInputDataObject(data)
        hidden.VisibilityOff()
        without_input = vtkActor()
        without_input.SetMapper(vtkPolyDataMapper())
        group = vtkAssembly()
        group.AddPart(within)
        machine_of_blocks = machine(left=9, middle=12, right=15)
        machine_of_blocks["middle"].visible = False
        renderer = vtkRenderer()
        for prop in (cut, hidden, empty, without_input, group):
            renderer.AddViewProp(prop)
        machine_of_blocks.add_to(renderer)
        window = window_with(renderer)
        with vitrine.section(renderer, "-z", (0, 0, 0)):
            window.Render()
            index = vitrine.AssemblyIndex(window)
            self.assertGreater(renderer.GetViewProps().GetNumberOfItems(), 6)  # with caps
        self.assertEqual(index.parts[:2], (cut, within))
        self.assertEqual((len(index), index.left_out), (4, 4))
        self.assertEqual([clash.kind for clash in index.clashes()], [])


if __name__ == "__main__":
    unittest.main()
