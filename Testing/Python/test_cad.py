"""STEP, IGES and BREP in Python: what load() and vtkAssemblyReader tell a converter, which is a script here."""

import json
import os
import pathlib
import signal
import struct
import tempfile
import unittest

import vitrine
from vitrine import _cad
from vitrine.vtkVitrineRendering import vtkAssemblyReader

CONVERTER = """#!/bin/sh
if [ "$1" = --version ]; then
  echo fake
  exit
fi
here=$(dirname "$0")
echo "$@" >> "$here/calls"
if [ -e "$here/hang" ]; then
  exec sleep 600
fi
echo "progress 0.25 reading" >&2
echo "progress 0.75 making triangles" >&2
cp "$here/made.glb" "$2"
"""


def glb(names=("part",), size=1.0):
    """A triangle for each name."""
    binary = struct.pack("<9f", 0, 0, 0, size, 0, 0, 0, size, 0)
    document = {
        "asset": {"version": "2.0", "extras": {"lengthUnit": "inch"}},
        "scenes": [{"nodes": list(range(len(names)))}],
        "nodes": [{"name": name, "mesh": 0} for name in names],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [size, size, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": len(binary)}],
        "buffers": [{"byteLength": len(binary)}],
    }  # fmt: skip
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    return (b"glTF" + struct.pack("<IIII", 2, 28 + len(text) + len(binary), len(text), 0x4E4F534A)
            + text + struct.pack("<II", len(binary), 0x4E4942) + binary)  # fmt: skip


def caught_signals():
    """The mask of the signals that the process has handlers for."""
    return next(line for line in pathlib.Path("/proc/self/status").read_text().splitlines() if "SigCgt" in line)


class Cad(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.cache = self.folder / "cache"
        self.converter = self.folder / "converter.sh"
        self.converter.write_text(CONVERTER)
        self.converter.chmod(0o755)
        (self.folder / "made.glb").write_bytes(glb())
        self.model = self.folder / "model.step"
        self.model.write_bytes(b"some STEP")
        kept = dict(os.environ)
        self.addCleanup(lambda: (os.environ.clear(), os.environ.update(kept)))
        os.environ["VITRINE_CAD_CONVERTER"] = str(self.converter)
        os.environ["XDG_CACHE_HOME"] = str(self.cache)

    def calls(self):
        calls = self.folder / "calls"
        return calls.read_text().splitlines() if calls.exists() else []

    def reader(self):
        reader = vtkAssemblyReader()
        reader.SetFileName(str(self.model))
        reader.SetCacheFolder(str(self.cache))
        return reader


class Load(Cad):
    def test_parts(self):
        model = vitrine.load(self.model)
        self.assertEqual([part.name for part in model.parts], ["part"])
        self.assertEqual(model.notes, ("lengths are in metres; in the file their unit is the inch",))

    def test_leaves_the_handlers_of_signals(self):
        handler = signal.signal(signal.SIGTERM, lambda *_: None)
        self.addCleanup(signal.signal, signal.SIGTERM, handler)
        before = caught_signals()
        vitrine.load(self.model)
        self.assertEqual(caught_signals(), before)

    def test_tolerance_and_cache(self):
        vitrine.load(self.model)
        vitrine.load(self.model)
        self.assertEqual(len(self.calls()), 1)
        vitrine.load(self.model, tolerance=0.5)
        self.assertIn("--tolerance 0.5", self.calls()[1])
        vitrine.load(self.model, cache=False)
        self.assertEqual(len(self.calls()), 3)
        self.assertEqual(len(list((self.cache / "vitrine/cad").iterdir())), 2)

    def test_bad_options(self):
        for tolerance in (-1, float("nan"), float("inf"), True):
            with self.assertRaisesRegex(ValueError, "tolerance is a number of metres"):
                vitrine.load(self.model, tolerance=tolerance)
        with self.assertRaisesRegex(TypeError, "cache is True or False"):
            vitrine.load(self.model, cache=1)

    def test_refusal(self):
        (self.folder / "made.glb").unlink()
        with self.assertRaisesRegex(ValueError, "model.step: cannot be converted|model.step: cp: "):
            vitrine.load(self.model)


class Reader(Cad):
    def test_limit_of_the_cache_removes_what_was_not_used_for_longest(self):
        reader, aged = self.reader(), []
        reader.SetCacheLimit(1)
        # Two entries are less than 1 MiB, and three are more.
        (self.folder / "made.glb").write_bytes(_with_last_chunk(glb(), (2 << 20) // 5))
        for i, tolerance in enumerate((1.0, 2.0)):
            reader.SetTolerance(tolerance)
            self.assertTrue(reader.Open(), reader.GetErrorMessage())
            (entry,) = set(self.cache.iterdir()) - {entry for entry, _ in aged}
            aged.append((entry, 1000 + i))
            os.utime(entry, (1000 + i, 1000 + i))
        reader.SetTolerance(1.0)
        self.assertTrue(reader.Open())  # The first is now the one that was used last.
        self.assertEqual(len(self.calls()), 2)
        reader.SetTolerance(3.0)
        self.assertTrue(reader.Open())
        left = set(self.cache.iterdir())
        self.assertEqual(len(left), 2)
        self.assertIn(aged[0][0], left)
        self.assertNotIn(aged[1][0], left)

    def test_what_is_larger_than_the_cache_is_not_kept(self):
        reader = self.reader()
        reader.SetCacheLimit(0)
        self.assertTrue(reader.Open())
        self.assertEqual(list(self.cache.iterdir()), [])

    def test_limit_of_time(self):
        (self.folder / "hang").touch()
        reader = self.reader()
        reader.SetConversionTimeLimit(0.25)
        self.assertFalse(reader.Open())
        self.assertEqual(
            reader.GetErrorMessage(), "cannot be converted: converter.sh did not end within 0.25 s"
        )
        self.assertEqual(list(self.cache.iterdir()), [])

    def test_progress(self):
        reader = self.reader()
        told = []
        reader.AddObserver(
            "ProgressEvent", lambda *_: told.append((reader.GetProgress(), reader.GetProgressText()))
        )
        self.assertTrue(reader.Open())
        self.assertEqual(told, [(0.25, "reading"), (0.75, "making triangles")])
        self.assertTrue(reader.Open())  # It is read already.
        self.assertEqual(len(told), 2)

    def test_a_conversion_can_be_ended(self):
        reader = self.reader()
        reader.AddObserver("ProgressEvent", lambda *_: reader.AbortExecuteOn())
        self.assertFalse(reader.Open())
        self.assertIn("was ended", reader.GetErrorMessage())
        self.assertEqual(list(self.cache.iterdir()), [])

    def test_converter_of_the_reader_goes_before_the_variable(self):
        os.environ["VITRINE_CAD_CONVERTER"] = "/nowhere"
        reader = self.reader()
        self.assertFalse(reader.Open())
        reader.SetConverter(str(self.converter))
        self.assertTrue(reader.Open(), reader.GetErrorMessage())

    def test_output_of_the_pipeline(self):
        reader = self.reader()
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfPartitionedDataSets(), 1)


def _with_last_chunk(made, size):
    """A GLB with a chunk of an unknown kind, by which it is of a size. Readers skip such chunks."""
    made += struct.pack("<II", size - len(made) - 8 & ~3, 0x58585858)
    made += b"\0" * (struct.unpack_from("<I", made, len(made) - 8)[0])
    return made[:8] + struct.pack("<I", len(made)) + made[12:]


class Names(unittest.TestCase):
    """What is mended of a GLB that cascadio makes."""

    STEP = b"""
#1=PRODUCT('machine','machine','',(#9));
#2=PRODUCT_DEFINITION_FORMATION('','',#1);
#3=PRODUCT_DEFINITION('design','',#2,#9);
#4 = PRODUCT ( 'id', 'it''s a \\X2\\00E4\\X0\\ bolt (#5)', '', ( #9 ) ) ;
#5 = PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE ( '', '', #4, .NOT_KNOWN. ) ;
#6 = PRODUCT_DEFINITION ( 'design', '', #5, #9 ) ;
#7=NEXT_ASSEMBLY_USAGE_OCCURRENCE('NAUO1',' ','',#3,#6,$);
#8=NEXT_ASSEMBLY_USAGE_OCCURRENCE('2','','the left one',#3,#6,$);
"""

    def made(self, *children):
        made = _cad.Glb(glb(("root",)))
        made.json["nodes"] = [{"name": "machine", "children": list(range(1, len(children) + 1))}]
        made.json["nodes"] += [{"name": name, "mesh": 0} for name in children]
        return made

    def test_nodes(self):
        made = self.made("NAUO1", "the left one", "7", "=>[0:1:1:2]")
        made.json["meshes"][0]["name"] = "mesh"
        _cad.mend_names(made, _cad.StepNames(self.STEP), "file")
        names = [node["name"] for node in made.json["nodes"]]
        self.assertEqual(names, ["machine", "it's a \u00e4 bolt (#5)", "the left one", "mesh", "mesh"])

    def test_size_is_that_of_vertices(self):
        text = b"""
#1=VERTEX_POINT('',#3);
#2 = VERTEX_POINT ( 'NONE', #4 ) ;
#3=CARTESIAN_POINT('',(0.,0.,1.));
#4 = CARTESIAN_POINT ( 'NONE', ( 3., 4.0, 1.3E+01 ) ) ;
#5=CARTESIAN_POINT('far point of a plane',(1.E6,0.,0.));
"""
        self.assertAlmostEqual(_cad._size_of_vertices(text, 0.001), 0.013)
        self.assertEqual(_cad._size_of_vertices(b"", 0.001), 0.0)

    def test_nodes_without_a_name(self):
        made = self.made("")
        _cad.mend_names(made, _cad.StepNames(b""), "file")
        self.assertEqual([node["name"] for node in made.json["nodes"]], ["machine", "file"])

    def test_size_and_axes(self):
        made = _cad.Glb(glb(size=3.0))
        made.json["nodes"][0].update({"scale": [1, 4 / 3, 1], "translation": [5, 6, 7],
                                      "rotation": [0, 0, 0.5**0.5, 0.5**0.5]})  # fmt: skip
        self.assertAlmostEqual(made.size(), 5.0)
        _cad.mend_axes(made)
        self.assertAlmostEqual(made.size(), 5.0)
        # x turns to y, which is moved by 6 and then points backwards
        matrix = made.json["nodes"][0]["matrix"]
        for found, expected in zip(matrix[:4] + matrix[12:], [0, 0, -1, 0, 5, 7, -6, 1]):
            self.assertAlmostEqual(found, expected)

    def test_bytes_are_a_glb(self):
        made = _cad.Glb(glb())
        made.json["nodes"][0]["name"] = "other"
        self.assertEqual(_cad.Glb(made.bytes()).json, made.json)
        self.assertEqual(len(made.bytes()), struct.unpack_from("<I", made.bytes(), 8)[0])
