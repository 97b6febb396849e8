"""Assemblies of data in blocks, in and out: from_multiblock() and Assembly.to_multiblock()."""

import unittest

import numpy
from machine import (
    GAMMA,
    MATERIALS,
    PATHS,
    SIZE,
    Files,
    box_bounds,
    box_data,
    cube,
    machine_view,
    plain_view,
    write_glb,
)
from scenes import rendered
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    vtkDataAssembly,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkMultiPieceDataSet,
    vtkPartitionedDataSetCollection,
    vtkPolyData,
    vtkTable,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersSources import vtkCubeSource

import vitrine


def box(x=0.0):
    """A cube of 6 quadrilaterals around a point of the x axis."""
    source = vtkCubeSource()
    source.SetCenter(x, 0, 0)
    source.Update()
    return source.GetOutput()


def grid(dimensions=(3, 3, 3)):
    image = vtkImageData()
    image.SetDimensions(dimensions)
    return image


def hexahedron():
    made = vtkUnstructuredGrid()
    made.SetPoints(box().GetPoints())
    made.Allocate(1)
    # The first eight points of vtkCubeSource are those of the faces at the ends of the x axis.
    made.InsertNextCell(VTK_HEXAHEDRON, 8, [0, 1, 3, 2, 4, 5, 7, 6])
    return made


def blocks(**children):
    made = vtkMultiBlockDataSet()
    for i, (name, child) in enumerate(children.items()):
        made.SetBlock(i, child)
        made.GetMetaData(i).Set(made.NAME(), name)
    return made


def leaves(multiblock, path=""):
    """Paths and blocks."""
    for i in range(multiblock.GetNumberOfBlocks()):
        name = f"{path}/{multiblock.GetMetaData(i).Get(multiblock.NAME())}"
        block = multiblock.GetBlock(i)
        if isinstance(block, vtkMultiBlockDataSet):
            yield from leaves(block, name)
        else:
            yield name, block


def field(block, name):
    return tuple(vtk_to_numpy(block.GetFieldData().GetArray(name)).ravel())


def paths_of(assembly):
    return [part.path for part in assembly]


class Blocks(unittest.TestCase):
    def test_have_their_names_and_nesting(self):
        machine = vitrine.from_multiblock(
            blocks(Housing=blocks(lid=box(), window=box(2)), gear=box(4))
        )
        self.assertEqual(paths_of(machine), ["/Housing/lid", "/Housing/window", "/gear"])
        self.assertEqual([part.name for part in machine], ["lid", "window", "gear"])
        self.assertEqual([part.triangles for part in machine], [12, 12, 12])
        self.assertEqual(machine.parts[1].bounds, (1.5, 2.5, -0.5, 0.5, -0.5, 0.5))
        self.assertEqual(machine["/Housing/*"].numbers, [0, 1])
        self.assertEqual(machine.notes, ())
        self.assertEqual(machine.actors.GetNumberOfActors(), 1)
        with self.assertRaisesRegex(KeyError, "near are 'gear'"):
            machine["Gear"]

    def test_without_names_and_of_equal_names_are_told_apart(self):
        group = vtkMultiBlockDataSet()
        for i in range(4):
            group.SetBlock(i, box(i))
        for i in (1, 2, 3):
            group.GetMetaData(i).Set(group.NAME(), "a/b")
        machine = vitrine.from_multiblock(group)
        self.assertEqual(paths_of(machine), ["/block-0", "/a_b", "/a_b (2)", "/a_b (3)"])
        self.assertEqual(machine["a_b"].numbers, [1, 2, 3])

    def test_of_cells_are_drawn_by_their_surface(self):
        machine = vitrine.from_multiblock(blocks(image=grid(), solid=hexahedron()))
        self.assertEqual([part.triangles for part in machine], [6 * 4 * 2, 12])
        self.assertEqual(machine.parts[0].bounds, (0, 2, 0, 2, 0, 2))

    def test_that_cannot_be_drawn_are_left_out_and_noted(self):
        machine = vitrine.from_multiblock(
            blocks(nothing=None, empty=vtkPolyData(), table=vtkTable(), box=box())
        )
        self.assertEqual(paths_of(machine), ["/box"])
        self.assertEqual(machine.notes, ("/empty has no cells", "/table is no data set"))

    def test_of_nothing_are_no_parts(self):
        machine = vitrine.from_multiblock(vtkMultiBlockDataSet())
        self.assertEqual((len(machine), machine.parts), (0, ()))
        self.assertEqual(str(machine.tree()), "/  (0 parts, 0 triangles)")
        with self.assertRaises(KeyError):
            machine["*"]
        machine.add_to(machine_view()).reset()
        self.assertEqual(machine.to_multiblock().GetNumberOfBlocks(), 0)

    def test_within_themselves_are_refused(self):
        group = blocks(box=box(), below=vtkMultiBlockDataSet())
        group.GetBlock(1).SetBlock(0, group)
        try:
            with self.assertRaisesRegex(ValueError, "/below/block-0: the group contains itself"):
                vitrine.from_multiblock(group)
        finally:
            group.GetBlock(1).SetBlock(0, None)

    def test_in_deep_groups_are_found(self):
        root = group = vtkMultiBlockDataSet()
        for _ in range(1500):
            below = vtkMultiBlockDataSet()
            group.SetBlock(0, below)
            group = below
        group.SetBlock(0, box())
        machine = vitrine.from_multiblock(root)
        self.assertEqual(machine.parts[0].path, "/block-0" * 1501)

    def test_of_another_kind_are_refused(self):
        for data in (None, box(), "blocks", [box()]):
            with self.assertRaisesRegex(TypeError, "a pyvista.MultiBlock, a vtkMultiBlockDataSet"):
                vitrine.from_multiblock(data)


class Colors(unittest.TestCase):
    def view(self, data):
        renderer = machine_view()
        vitrine.from_multiblock(blocks(box=data)).add_to(renderer)
        return rendered(renderer, size=SIZE)

    def scalars(self, values):
        data = box()
        array = numpy_to_vtk(numpy.tile(values, (data.GetNumberOfPoints(), 1)), deep=True)
        array.SetName("values")
        data.GetPointData().SetScalars(array)
        return data

    def test_of_bytes_are_shown(self):
        plain = self.view(box())
        red = self.view(self.scalars(numpy.array([255, 0, 0], numpy.uint8)))
        self.assertEqual(red[40, 40, :3].tolist(), [plain[40, 40, 0], 0, 0])
        glass = self.view(self.scalars(numpy.array([255, 0, 0, 128], numpy.uint8)))
        # Two faces, each of an opacity of 128 / 255, before a background of 128.
        self.assertAlmostEqual(glass[40, 40, 2], 128 * (127 / 255) ** 2, delta=1)
        self.assertGreater(glass[40, 40, 0], 150)
        self.assertLess(glass[40, 40, 0], red[40, 40, 0])

    def test_of_other_scalars_are_not(self):
        plain = self.view(box())
        for values in ([0.5], [1.0, 0.0, 0.0], [0.1, 0.2, 0.3, 0.4]):
            numpy.testing.assert_array_equal(self.view(self.scalars(numpy.array(values))), plain)

    def test_of_field_data_are_those_of_the_part(self):
        data = box()
        for name, values in (("color", (1.0, 0.0, 0.0)), ("opacity", (0.5,))):
            array = numpy_to_vtk(numpy.array([values]), deep=True)
            array.SetName(name)
            data.GetFieldData().AddArray(array)
        picture = self.view(data)
        self.assertEqual(picture[40, 40, 1], 0)
        self.assertAlmostEqual(picture[40, 40, 2], 128 * 0.5**2, delta=1)  # behind two faces
        machine = vitrine.from_multiblock(blocks(box=data))
        made = machine.actors.GetPartProperty(0)
        self.assertEqual((made.GetColor(), made.GetOpacity()), ((1, 0, 0), 0.5))

    def test_of_translucent_blocks_may_become_opaque(self):
        pictures = []
        for opacity in (0.3, 1.0):
            data = [box(-0.6), box(0.6)]
            for part in data:
                array = numpy_to_vtk(numpy.array([opacity]), deep=True)
                array.SetName("opacity")
                part.GetFieldData().AddArray(array)
            machine = vitrine.from_multiblock(blocks(a=data[0], b=data[1]))
            machine["a"].opacity = 1.0
            machine["b"].opacity = 1.0
            renderer = machine_view()
            machine.add_to(renderer)
            pictures.append(rendered(renderer, size=SIZE)[..., :3].astype(int))
        # VTK blends the first and not the second, which rounds otherwise.
        numpy.testing.assert_allclose(*pictures, rtol=0, atol=1)

    def test_of_points_give_way_to_those_of_parts(self):
        pictures = []
        for has_colors in (True, False):
            data = [box(-0.6), box(0.6)]
            for part in data if has_colors else ():
                colors = numpy.full((part.GetNumberOfPoints(), 3), (0, 255, 0), numpy.uint8)
                part.GetPointData().SetScalars(numpy_to_vtk(colors, deep=True))
            machine = vitrine.from_multiblock(blocks(a=data[0], b=data[1]))
            machine["*"].color = "red"
            renderer = machine_view()
            machine.add_to(renderer)
            pictures.append(rendered(renderer, size=SIZE))
        numpy.testing.assert_array_equal(*pictures)

    def test_of_field_data_that_are_none_do_not_count(self):
        plain = self.view(box())
        for name, values in (
            ("color", (1.0, 0.0)),
            ("color", (2.0, 0.0, 0.0)),
            ("color", (numpy.nan, 0.0, 0.0)),
            ("opacity", (0.5, 0.5)),
            ("opacity", (-1.0,)),
            ("material", (1.0,)),
        ):
            data = box()
            array = numpy_to_vtk(numpy.array(values), deep=True)
            array.SetName(name)
            data.GetFieldData().AddArray(array)
            numpy.testing.assert_array_equal(self.view(data), plain)


class Collections(unittest.TestCase):
    def collection(self, *names):
        made = vtkPartitionedDataSetCollection()
        for i, name in enumerate(names):
            made.SetPartition(i, 0, box(i))
            made.GetMetaData(i).Set(made.NAME(), name)
        return made

    def test_without_a_tree_have_their_names(self):
        machine = vitrine.from_multiblock(self.collection("lid", "gear"))
        self.assertEqual(paths_of(machine), ["/lid", "/gear"])

    def test_have_the_names_of_their_tree(self):
        data = self.collection("a", "b", "c", "d")
        tree = vtkDataAssembly()
        housing = tree.AddNode("Housing")
        lid = tree.AddNode("lid", housing)
        tree.SetAttribute(lid, "label", "the lid / cover")
        tree.AddDataSetIndex(lid, 2)
        gears = tree.AddNode("gears")
        for number in (1, 0, 2):  # the last is in the tree already
            tree.AddDataSetIndex(gears, number)
        data.SetDataAssembly(tree)
        machine = vitrine.from_multiblock(data)
        self.assertEqual(
            paths_of(machine), ["/Housing/the lid _ cover", "/gears/b", "/gears/a", "/d"]
        )
        self.assertEqual([part.bounds[0] for part in machine], [1.5, 0.5, -0.5, 2.5])

    def test_of_several_partitions_have_a_part_for_each(self):
        data = self.collection("lid")
        data.SetPartition(0, 1, box(5))
        self.assertEqual(paths_of(vitrine.from_multiblock(data)), ["/lid/0", "/lid/1"])
        pieces = vtkMultiPieceDataSet()
        pieces.SetPiece(0, box())
        pieces.SetPiece(1, box(1))
        self.assertEqual(
            paths_of(vitrine.from_multiblock(blocks(lid=pieces))), ["/lid/0", "/lid/1"]
        )


class Machines(Files):
    def test_of_the_reader_s_output_are_the_same(self):
        reader = vitrine.vtkAssemblyReader()
        reader.SetFileName(str(self.file))
        reader.Update()
        machine = vitrine.from_multiblock(reader.GetOutput())
        self.assertEqual(paths_of(machine), list(PATHS))
        self.assertEqual([part.bounds for part in machine], [box_bounds(path) for path in PATHS])

    def test_of_the_reader_s_output_have_names_where_the_file_has_none(self):
        nodes = [{"children": [1, 2]}, {"mesh": 0}, {"name": "a/b", "mesh": 0}]
        write_glb(self.file, nodes, [0], [(*cube(), None)])
        reader = vitrine.vtkAssemblyReader()
        reader.SetFileName(str(self.file))
        reader.Update()
        expected = ["/node-0/node-1", "/node-0/a_b"]
        self.assertEqual(paths_of(vitrine.load(self.file)), expected)
        self.assertEqual(paths_of(vitrine.from_multiblock(reader.GetOutput())), expected)

    def test_become_blocks_in_world_coordinates(self):
        made = self.machine.to_multiblock()
        found = dict(leaves(made))
        # gear-2 has a node below, so it is a group, in which its own geometry has its name.
        expected = [f"{path}/gear-2" if path.endswith("gear-2") else path for path in PATHS]
        self.assertEqual(sorted(found), sorted(expected))
        for path, name in zip(PATHS, expected):
            points = vtk_to_numpy(found[name].GetPoints().GetData())
            wanted = vtk_to_numpy(box_data(path).GetPoints().GetData())
            numpy.testing.assert_array_equal(points, wanted)

    def test_far_from_the_origin_keep_their_shape(self):
        points, normals, triangles = cube()
        screw = {"name": "screw", "mesh": 0, "translation": [500000.0, 0.0, 0.0]}
        write_glb(self.file, [screw], [0], [(numpy.float32(0.01) * points, normals, triangles, None)])
        ((_, block),) = leaves(vitrine.load(self.file).to_multiblock())
        xmin, xmax = block.GetBounds()[:2]
        self.assertAlmostEqual(xmax - xmin, 0.01, places=7)

    def test_become_blocks_that_say_how_they_look(self):
        self.machine["gear-1"].color = (0, 0.5, 1)
        self.machine["gear-1"].opacity = 0.25
        found = dict(leaves(self.machine.to_multiblock()))
        window, gear = found[PATHS[1]], found[PATHS[2]]
        glass = MATERIALS["glass, clear"][0]
        self.assertEqual(field(window, "opacity"), (0.25,))
        shown = [value ** (1 / GAMMA) for value in glass[:3]]
        numpy.testing.assert_allclose(field(window, "color"), shown)
        self.assertEqual((field(gear, "color"), field(gear, "opacity")), ((0, 0.5, 1), (0.25,)))
        text = gear.GetFieldData().GetAbstractArray("material")
        self.assertEqual(text.GetValue(0), "steel")
        geometry = self.machine.actors.GetPartGeometry(2)
        self.assertEqual(geometry.GetFieldData().GetNumberOfArrays(), 0)

    def test_come_back_from_blocks(self):
        back = vitrine.from_multiblock(self.machine.to_multiblock())
        self.assertEqual({part.bounds for part in back}, {box_bounds(path) for path in PATHS})
        self.assertEqual(len(back["material:steel"]), 2)
        self.assertEqual(len(back["/Machine/Gearbox/gear-2"]), 2)
        again = vitrine.from_multiblock(back.to_multiblock())
        self.assertEqual(paths_of(again), paths_of(back))

    def test_of_blocks_are_drawn_as_plain_actors(self):
        renderer, plain = machine_view(), plain_view(looks={PATHS[0]: {"opacity": 0.5}})
        for actor in plain.GetActors():
            made = actor.GetProperty()
            made.SetInterpolationToGouraud()
            made.SetColor([value ** (1 / GAMMA) for value in made.GetColor()])
        machine = vitrine.from_multiblock(self.machine.to_multiblock())
        machine["lid"].opacity = 0.5
        machine.add_to(renderer)
        for each in (renderer, plain):
            vitrine.see_through(each)
        numpy.testing.assert_array_equal(
            rendered(renderer, size=SIZE), rendered(plain, size=SIZE)
        )


if __name__ == "__main__":
    unittest.main()
