"""load() of the kinds that the program reads: its parts, pictures and messages are the program's."""

import importlib.util
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile
from unittest import mock

import numpy
from machine import Files
from scenes import plates_renderer, rendered
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkImagingCore import vtkImageCast
from vtkmodules.vtkImagingSources import vtkImageNoiseSource
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkTexture

import vitrine
import vitrine.__main__
from vitrine import _unpack
from vitrine.inspector import Inspection
from vitrine.inspector._render import opened


def program_scenes():
    """The module `scenes` of the program's tests, which writes a file of each kind."""
    file = pathlib.Path(__file__).parents[1] / "Program/scenes.py"
    spec = importlib.util.spec_from_file_location("program_scenes", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


SCENES = program_scenes()
SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
MODEL = (
    '<?xml version="1.0"?><model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">'
    '<resources><basematerials id="5"><base name="glass" displaycolor="#FF000040"/></basematerials>'
    '<object id="1" name="roof" pid="5" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/>'
    '<vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles>'
    '<triangle v1="0" v2="1" v3="2"/><triangle v1="0" v2="2" v3="3"/></triangles></mesh></object></resources><build>'
    '<item objectid="1"/><item objectid="1" transform="1 0 0 0 1 0 0 0 1 10 0 0"/></build></model>'
)
RELATIONSHIPS = (
    '<Relationships><Relationship Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel" '
    'Target="/3D/first.model" Id="r"/></Relationships>'
)


def program(*arguments):
    """What the program prints, and its one line of an error."""
    command = [sys.executable, "-B", "-m", "vitrine", *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.stdout, done.stderr.replace("\r", "\n").strip().split("\n")[-1]


def write_kinds(folder):
    """Write a file of each kind that the program reads for load(); their paths."""
    files = {file.suffix: file for file in SCENES.write_all(folder) if file.suffix in _unpack.KINDS}
    return files.values()


def square_renderer():
    return plates_renderer(background=(0.25, 0.5, 0.75))


class Kinds(Files):
    def test_are_those_of_the_program(self):
        text, _ = program("--help")
        listed = text[text.index("INPUT is a file (") + 17 :].split(")")[0].split(", ")
        self.assertEqual(sorted(listed), sorted(vitrine._assembly.KINDS))

    def test_have_the_parts_that_the_program_tells(self):
        for file in write_kinds(self.folder):
            with self.subTest(file.name):
                told = json.loads(program("info", file, "--size", "8x8", "--parts", "--json", "-")[0])
                parts = vitrine.load(file).parts
                self.assertEqual(
                    [(part.path, part.material, part.triangles) for part in parts],
                    [(part["path"], part["material"], part["triangles"]) for part in told["part_list"]],
                )
                for part, of_program in zip(parts, told["part_list"]):
                    numpy.testing.assert_array_equal(part.bounds, of_program["bounds"])

    def test_of_obj_have_materials(self):
        self.write("boxes.mtl", "newmtl glass\nKd 1 0.5 0\nd 0.25\nnewmtl unused\n")
        faces = "g Case\nusemtl glass\nf 1 2 3 4\nusemtl no\nf 1 2 3\n"
        machine = vitrine.load(self.write("boxes.obj", "mtllib boxes.mtl\n" + SQUARE + faces))
        self.assertEqual([part.path for part in machine], ["/Case/glass", "/Case/no"])
        self.assertEqual([part.path for part in machine["material:glass"]], ["/Case/glass"])
        self.assertEqual(machine._look(0), ((1.0, 0.5, 0.0), 0.25))
        self.assertEqual(machine.notes, ("there are no materials 'no': their parts are white",))

    def test_of_3mf_have_colours_and_places(self):
        file = self.folder / "roof.3mf"
        with zipfile.ZipFile(file, "w") as archive:
            archive.writestr("_rels/.rels", RELATIONSHIPS)
            archive.writestr("3D/first.model", MODEL)
        machine = vitrine.load(file)
        self.assertEqual([part.path for part in machine], ["/roof", "/roof (2)"])
        numpy.testing.assert_allclose(machine.parts[1].bounds, numpy.array([10, 11, 0, 1, 0, 1]) * 0.0254, rtol=1e-6)
        self.assertEqual(machine.actors.GetNumberOfActors(), 1)
        self.assertIs(machine.actors.GetPartGeometry(0), machine.actors.GetPartGeometry(1))
        self.assertEqual(machine._look(0), ((1.0, 0.0, 0.0), 64 / 255))

    def test_of_nested_blocks_have_their_tree_and_what_is_empty(self):
        self.write("leaf.vtp", SCENES.vtp().decode())
        self.write("none.vtp", SCENES.vtp((), ()).decode())
        machine = vitrine.load(self.write("boxes.vtm", SCENES.vtm("leaf.vtp", "none.vtp").decode()))
        self.assertEqual(len(machine), 1)
        self.assertRegex(machine.notes[-1], "has no triangles, lines or points$")

    def write(self, name, text):
        file = self.folder / name
        file.write_text(text)
        return file


class Pictures(Files):
    """A square that fills the view, drawn by load() and by VTK."""

    def texture(self):
        image = vtkImageNoiseSource()
        image.SetWholeExtent(0, 15, 0, 15, 0, 0)
        image.SetMaximum(255.0)
        bytes_of = vtkImageCast()
        bytes_of.SetInputConnection(image.GetOutputPort())
        bytes_of.SetOutputScalarTypeToUnsignedChar()
        writer = vtkPNGWriter()
        writer.SetInputConnection(bytes_of.GetOutputPort())
        writer.SetFileName(str(self.folder / "map.png"))
        writer.Write()
        reader = vtkPNGReader()
        reader.SetFileName(str(self.folder / "map.png"))
        texture = vtkTexture()
        texture.SetInputConnection(reader.GetOutputPort())
        half = vtkTransform()
        half.Scale(0.5, 0.5, 1.0)
        texture.SetTransform(half)
        return texture

    def drawn_by_vtk(self, texture, opacity):
        plane = vtkPlaneSource()
        plane.SetOrigin(-1, -1, 0)
        plane.SetPoint1(1, -1, 0)
        plane.SetPoint2(-1, 1, 0)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(plane.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.SetTexture(texture)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetColor(1.0, 0.75, 0.5)
        actor.GetProperty().SetOpacity(opacity)
        renderer = square_renderer()
        renderer.AddActor(actor)
        return renderer

    def test_of_textures_are_as_vtk_draws_them(self):
        texture = self.texture()
        (self.folder / "square.obj").write_text(
            "mtllib square.mtl\n" + SQUARE + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3 4/4\n"
        )
        for opacity in (1.0, 0.5):
            material = f"newmtl m\nKd 1 0.75 0.5\nillum 0\nd {opacity}\nmap_Kd -s 0.5 0.5 1 map.png\n"
            (self.folder / "square.mtl").write_text(material)
            loaded, expected = square_renderer(), self.drawn_by_vtk(texture, opacity)
            vitrine.load(self.folder / "square.obj").add_to(loaded)
            pictures = []
            for renderer in (loaded, expected):
                vitrine.see_through(renderer, "truth")
                pictures.append(rendered(renderer))
            numpy.testing.assert_array_equal(*pictures)
            self.assertGreater(len(numpy.unique(pictures[0].reshape(-1, 4), axis=0)), 50)

    def test_of_points_and_cells_show_their_colours(self):
        header = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        header += "".join(f"property uchar {name}\n" for name in ("red", "green", "blue"))
        header += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        corners = "".join(f"{x} {y} 0 255 128 0\n" for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
        (self.folder / "a.ply").write_text(header + corners + "4 0 1 2 3\n")
        colors = SCENES.xml_array("UInt8", "colors", [255, 128, 0], 3)
        square = SCENES.vtp([(-1.0, -1.0, 0.0), (1.0, -1.0, 0.0), (1.0, 1.0, 0.0)], [(0, 1, 2)]).decode()
        colored = square.replace("</Piece>", f'<CellData Scalars="colors">{colors}</CellData></Piece>')
        (self.folder / "b.vtp").write_text(colored)
        for name in ("a.ply", "b.vtp"):
            renderer = square_renderer()
            machine = vitrine.load(self.folder / name).add_to(renderer)
            machine.actors.GetPartProperty(0).LightingOff()
            numpy.testing.assert_array_equal(rendered(renderer)[20, 40, :3], [255, 128, 0], name)


class Several(Files):
    def test_are_one_assembly_with_names_that_differ(self):
        box = self.folder / "box.stl"
        box.write_bytes(SCENES.binary_stl())
        machine = vitrine.load(box, self.file, str(box))
        self.assertEqual(len(machine), 7)
        self.assertEqual([machine.parts[i].path for i in (0, 1, 6)], ["/box", "/Machine/Housing/lid", "/box (2)"])
        self.assertEqual(machine.parts[6].name, "box (2)")
        self.assertEqual([part.path for part in vitrine.load(iter([box, box]))], ["/box", "/box (2)"])
        twice = vitrine.load([self.file], self.file)
        self.assertEqual(len({part.name for part in twice}), 10)
        self.assertEqual(len({part.path for part in twice}), 10)

    def test_are_all_there_before_any_is_read(self):
        with mock.patch.object(_unpack, "add_parts") as add_parts:
            with self.assertRaisesRegex(FileNotFoundError, "nowhere.stl"):
                vitrine.load("demo:stack", self.folder / "nowhere.stl")
        add_parts.assert_not_called()
        with self.assertRaisesRegex(ValueError, "one file at least"):
            vitrine.load([])


class Demos(Files):
    def test_are_loaded_by_their_names(self):
        self.assertEqual(len(vitrine.load("demo:spheres,layers=6")), 3)
        self.assertEqual(vitrine.load("demo:hall").notes[-1], "its lights are left out")

    def test_that_only_the_program_draws_are_refused(self):
        with self.assertRaisesRegex(ValueError, "only this program has"):
            vitrine.load("demo:impostors")
        with self.assertRaisesRegex(ValueError, "^demo:none: no generated scene"):
            vitrine.load("demo:none")

    def test_are_kept_in_states_of_the_inspector(self):
        file, scene = self.folder / "state.json", "demo:spheres,layers=4"
        shown = Inspection(scene, size=(32, 32))
        shown.save(file)
        self.assertEqual(json.loads(file.read_text())["files"], [{"path": scene}])
        numpy.testing.assert_array_equal(opened(file).picture(), shown.picture())


class Refused(Files):
    def test_with_the_words_of_the_program(self):
        for file in write_kinds(self.folder):
            bad = self.folder / f"bad{file.suffix}"
            bad.write_bytes(file.read_bytes()[: file.stat().st_size // 3])
            _, line = program("info", bad, "--size", "8x8")
            with self.subTest(file.name), self.assertRaises(ValueError) as caught:
                vitrine.load(bad)
            self.assertEqual(f"vitrine: {caught.exception}", line)

    def test_without_the_program(self):
        missing = mock.patch("vitrine.__main__.program", side_effect=FileNotFoundError("without the program"))
        with missing, self.assertRaisesRegex(FileNotFoundError, "without the program"):
            vitrine.load("demo:stack")

    def test_leaving_no_file(self):
        (self.folder / "bad.stl").write_bytes(b"solid")
        with mock.patch.object(tempfile, "tempdir", str(self.folder)):
            before = set(self.folder.iterdir())
            with self.assertRaisesRegex(ValueError, "bad.stl"):
                vitrine.load(self.folder / "bad.stl")
            vitrine.load("demo:stack")
            self.assertEqual(set(self.folder.iterdir()), before)


if __name__ == "__main__":
    unittest.main()
