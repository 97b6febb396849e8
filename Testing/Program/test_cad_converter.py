"""STEP, IGES and BREP by OpenCASCADE: names, tree, colours, alpha, bounds and units, beside its own listing."""

import importlib.util
import itertools
import json
import os
import pathlib
import shlex
import subprocess
import sys
import unittest

import step_files
from program import PROGRAM, FileTest, environment_without_display, run

PROJECT = pathlib.Path(__file__).resolve().parents[2]
BESIDE = pathlib.Path(PROGRAM).parent
VITRINE_CAD = BESIDE / "vitrine-cad"
LISTING = BESIDE / "VitrineCadListing"
DATA = pathlib.Path(os.environ.get("VITRINE_SHARED_DATA", PROJECT.parent / "shared" / "data"))
MODELS = sorted(path for path in DATA.glob("*/*") if path.suffix.lower() in {".step", ".stp"})
CAD_PY = PROJECT / "Python/vitrine/_cad.py"
MILLIMETRE, INCH = 0.001, 0.0254
GREY = 0.6038  # linear; of what has no colour


def glb_of(path):
    data = path.read_bytes()
    length = int.from_bytes(data[12:16], "little")
    return json.loads(data[20 : 20 + length])


def name_of(part):
    return part["path"].rsplit("/", 1)[-1]


def tree_of(glb):
    """Names, each with the names below it."""

    def below(number):
        node = glb["nodes"][number]
        children = node.get("children", [])
        return [node["name"], [below(child) for child in children]] if children else node["name"]

    return [below(root) for root in glb["scenes"][glb.get("scene", 0)]["nodes"]]


def nodes_of(glb):
    """Each node with its depth, before its children."""
    nodes = []
    left = [(0, root) for root in reversed(glb["scenes"][0]["nodes"])]
    while left:
        depth, number = left.pop()
        nodes.append((depth, glb["nodes"][number]))
        left += [(depth + 1, child) for child in reversed(nodes[-1][1].get("children", []))]
    return nodes


def bounds_of_all(bounds):
    """The box around boxes."""
    return [(min, max)[axis % 2](values) for axis, values in enumerate(zip(*bounds))]


def upwards(bounds):
    """Bounds with Z upwards as bounds with Y upwards."""
    x0, x1, y0, y1, z0, z1 = bounds
    return [x0, x1, z0, z1, -y1, -y0]


class Converter(FileTest):
    """What both converters do alike."""

    command: list[str]

    def setUp(self):
        super().setUp()
        self.environment = {
            "VITRINE_CAD_CONVERTER": shlex.join(self.command),
            "XDG_CACHE_HOME": str(self.folder / "cache"),
        }

    def convert(self, path, *options):
        output = self.folder / "converted.glb"
        result = subprocess.run(
            [*self.command, path, output, *map(str, options)],
            capture_output=True,
            env=environment_without_display(),
            timeout=600,
            check=False,
        )
        self.assertEqual(result.stdout, b"")
        return result, output

    def glb(self, content, name="model.step", *options):
        result, output = self.convert(self.write(name, content), *options)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        return glb_of(output)

    def parts(self, path, *options):
        result = run(
            "info", path, "--parts", "--json", "-", "--size", "8x8", *options, **self.environment
        )
        self.assert_done(result)
        return json.loads(result.stdout)

    def refuse_bytes(self, name, content, *words):
        path = self.write(name, content)
        before = sorted(self.folder.iterdir())
        result, output = self.convert(path)
        said = result.stderr.decode()
        self.assertEqual(result.returncode, 2, said)
        self.assertEqual(said.count("\n"), 1, said)
        self.assertIn(f"{path}: ", said)
        for word in words:
            self.assertIn(word, said)
        self.assertEqual(sorted(self.folder.iterdir()), before)
        self.assert_refused(run("info", path, "--size", "8x8", **self.environment), path, *words)


class AnyConverter:
    def test_tree_and_names(self):
        self.assertEqual(
            tree_of(self.glb(step_files.machine())),
            [["machine", ["housing", "bolt", "safety bolt", ["base", ["left foot", "right foot"]]]]],
        )

    def test_bounds_in_metres_with_y_upwards(self):
        bounds = {name_of(part): part["bounds"] for part in self.told_parts(step_files.machine())}
        expected = {
            "housing": [0, 100, 0, 40, -60, 0],
            "bolt": [10, 12, 40, 50, -12, -10],
            "safety bolt": [80, 82, 40, 50, -12, -10],
            "left foot": [0, 10, -5, 0, -10, 0],
            "right foot": [90, 100, -5, 0, -10, 0],
        }
        self.assertEqual(set(bounds), set(expected))
        for name, numbers in expected.items():
            for found, number in zip(bounds[name], numbers):
                self.assertAlmostEqual(found, MILLIMETRE * number, delta=1e-8)

    def told_parts(self, content):
        return self.parts(self.write("model.step", content))["part_list"]

    def test_units(self):
        for unit, meters in (("millimetre", MILLIMETRE), ("inch", INCH), ("metre", 1.0)):
            with self.subTest(unit=unit):
                told = self.parts(self.write("box.step", step_files.box(unit, size=(1, 2, 3))))
                self.assertEqual(told["length_unit"], unit)
                for found, number in zip(told["bounds"], (0, 1, 0, 3, -2, 0)):
                    self.assertAlmostEqual(found, meters * number, delta=1e-7 * meters)

    def test_colors_and_alpha(self):
        glb = self.glb(step_files.machine())
        colors = {}
        for node in glb["nodes"]:
            if "mesh" in node:
                (primitive,) = glb["meshes"][node["mesh"]]["primitives"]
                colors[node["name"]] = glb["materials"][primitive["material"]]
        factors = {name: m["pbrMetallicRoughness"]["baseColorFactor"] for name, m in colors.items()}
        expected = {  # sRGB's curve of 0.5 and 0.25
            "housing": [0.21404, 0.050876, 1.0, 0.25],
            "bolt": [1.0, 0.0, 0.0, 1.0],
            "safety bolt": [1.0, 0.0, 0.0, 1.0],
            "left foot": [GREY, GREY, GREY, 1.0],
            "right foot": [GREY, GREY, GREY, 1.0],
        }
        for name, numbers in expected.items():
            for found, number in zip(factors[name], numbers):
                self.assertAlmostEqual(found, number, delta=1e-4)
        self.assertEqual(colors["housing"]["alphaMode"], "BLEND")
        self.assertEqual(colors["bolt"].get("alphaMode", "OPAQUE"), "OPAQUE")
        for material in colors.values():
            self.assertEqual(material["pbrMetallicRoughness"]["metallicFactor"], 0.0)

    def test_instances_share_their_geometry(self):
        glb = self.glb(step_files.machine())
        self.assertEqual(len({mesh["primitives"][0]["attributes"]["POSITION"] for mesh in glb["meshes"]}), 3)

    def test_tolerance_is_told(self):
        extras = self.glb(step_files.box(size=(3, 4, 12)), "box.step", "--tolerance", "0.002")["asset"]["extras"]
        self.assertEqual((extras["tolerance"], extras["lengthUnit"]), ("0.002", "millimetre"))

    def test_default_tolerance_is_by_size(self):
        extras = self.glb(step_files.box(size=(3, 4, 12)))["asset"]["extras"]
        diagonal = 13 * MILLIMETRE
        self.assertGreaterEqual(float(extras["tolerance"]), 0.5 * diagonal / 1000)
        self.assertLessEqual(float(extras["tolerance"]), 2 * diagonal / 1000)

    def test_too_fine_a_tolerance_is_refused(self):
        result, output = self.convert(self.write("box.step", step_files.box()), "--tolerance", "1e-11")
        self.assertEqual((result.returncode, result.stderr.count(b"\n")), (2, 1), result.stderr)
        self.assertIn(b"its tolerance must be 1e-10 metres at least", result.stderr)
        self.assertFalse(output.exists())

    def test_bad_files(self):
        whole = step_files.machine()
        self.refuse_bytes("text.step", b"This is a text.\n" * 20, "is not STEP")
        self.refuse_bytes("noise.STEP", bytes(range(256)) * 20, "is not STEP")
        for share in (0.1, 0.5, 0.9, 0.999):
            self.refuse_bytes("cut.step", whole[: int(share * len(whole))], "is cut off")
        self.refuse_bytes("garbled.step", whole.replace(b"=PRODUCT(", b"=(PRODUCT("), "is damaged: ")
        self.refuse_bytes("none.step", step_files.StepFile().bytes())
        self.refuse_bytes("text.igs", b"This is a text.\n" * 20)

    def test_unreadable_entities_are_told(self):
        step = step_files.StepFile()
        parts = [step.product(name, [step.box((0, 0, 0), (1, 1, 1))]) for name in ("good", "bad")]
        assembly = step.product("both")
        for part in parts:
            step.use(assembly, part, "")
        at = max(i for i, line in enumerate(step.lines) if line.startswith("PLANE"))
        step.lines[at] = step.lines[at].replace("PLANE", "PLAIN")
        told = self.parts(self.write("model.step", step.bytes()))
        self.assertEqual(sum(part["triangles"] for part in told["part_list"]), 22)
        if isinstance(self, ByOpenCascade):
            self.assertRegex(told["notes"][0], "could not read [0-9]+ of its entities")

    def test_unwritable_output(self):
        path = self.write("box.step", step_files.box())
        result = subprocess.run(
            [*self.command, path, self.folder / "nowhere/box.glb"], capture_output=True, check=False
        )
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr.count(b"\n"), 1)
        self.assertIn(b"cannot be written", result.stderr)

    def test_second_opening(self):
        path = self.write("model.step", step_files.machine())
        first, second = self.parts(path), self.parts(path)
        self.assertEqual(first, second)
        self.assertEqual(len(list((self.folder / "cache/vitrine/cad").iterdir())), 1)

    @unittest.skipUnless(LISTING.exists(), "OpenCASCADE's development files are missing")
    def test_listing_of_opencascade(self):
        self.compare_with_listing(self.write("model.step", step_files.machine("inch")))

    @unittest.skipUnless(LISTING.exists() and MODELS, f"no listing, or no STEP files in {DATA}")
    def test_listing_of_real_files(self):
        for path in MODELS:
            with self.subTest(model=path.name):
                self.compare_with_listing(path)

    def compare_with_listing(self, path):
        """Names, tree, and each leaf's colours and bounds."""
        listing = subprocess.run([LISTING, "list", path], capture_output=True, check=True).stdout
        expected = [json.loads(line) for line in listing.splitlines()]
        result, output = self.convert(path)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        glb = glb_of(output)
        found = nodes_of(glb)
        self.assertEqual([depth for depth, _ in found], [node["depth"] for node in expected])
        parts = iter(self.parts(output)["part_list"])
        for (_, node), told in zip(found, expected):
            with self.subTest(node=node["name"]):
                self.assertIn(node["name"], (told["instance"].strip(), told["product"].strip()))
                self.assertEqual("mesh" in node, told["leaf"])
                if told["leaf"]:
                    primitives = glb["meshes"][node["mesh"]]["primitives"]
                    self.assert_same_colors(primitives, glb["materials"], told["colors"])
                    bounds = bounds_of_all(part["bounds"] for part in itertools.islice(parts, len(primitives)))
                    tolerance = float(glb["asset"]["extras"]["tolerance"])
                    for value, number in zip(bounds, upwards(told["bounds"])):
                        self.assertAlmostEqual(value, MILLIMETRE * number, delta=tolerance)
        self.assertEqual(list(parts), [])

    def assert_same_colors(self, primitives, materials, colors):
        factors = sorted(materials[p["material"]]["pbrMetallicRoughness"]["baseColorFactor"] for p in primitives)
        self.assertEqual(len(factors), len(colors))
        for factor, color in zip(factors, sorted(color or [GREY, GREY, GREY, 1.0] for color in colors)):
            for found, number in zip(factor, color):
                self.assertAlmostEqual(found, number, delta=1e-4)


@unittest.skipUnless(VITRINE_CAD.exists(), "there is no OpenCASCADE")
class ByOpenCascade(AnyConverter, Converter):
    command = [str(VITRINE_CAD)]

    def write_files(self):
        subprocess.run([LISTING, "write", self.folder], check=True)

    @unittest.skipUnless(LISTING.exists(), "there is no OpenCASCADE")
    def test_iges_and_brep(self):
        self.write_files()
        for name, parts, unit in (("boxes.step", ["red box", "green box"], "millimetre"),
                                  ("boxes.iges", ["red box", "green box"], "inch"),
                                  ("box.brep", ["box"], "millimetre")):  # fmt: skip
            with self.subTest(name=name):
                told = self.parts(self.folder / name)
                self.assertEqual([name_of(part) for part in told["part_list"]], parts)
                self.assertEqual(told["length_unit"], unit)
                for found, number in zip(told["part_list"][0]["bounds"], (1, 11, 3, 33, -22, -2)):
                    self.assertAlmostEqual(found, MILLIMETRE * number, delta=1e-8)

    def test_it_is_found_beside_the_program(self):
        self.environment["VITRINE_CAD_CONVERTER"] = ""
        told = self.parts(self.write("box.step", step_files.box()))
        self.assertEqual(told["triangles"], 12)

    def test_bad_brep(self):
        self.refuse_bytes("text.brep", b"This is a text.\n" * 20)
        self.refuse_bytes("noise.brep", bytes(range(256)) * 20)

    def test_progress(self):
        result, _ = self.convert(self.write("box.step", step_files.box()), "--progress")
        lines = result.stderr.decode().splitlines()
        fractions = [float(line.split()[1]) for line in lines]
        self.assertTrue(all(line.startswith("progress ") for line in lines))
        self.assertEqual(fractions, sorted(fractions))
        self.assertIn("making triangles", lines[-1] + lines[-2] + "".join(lines))

    def test_bad_arguments(self):
        for arguments in ((), ("a.step",), ("a.step", "b.glb", "--tolerance", "wide")):
            result = subprocess.run([*self.command, *arguments], capture_output=True, check=False)
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stderr.count(b"\n"), 1)


@unittest.skipUnless(importlib.util.find_spec("cascadio"), "there is no cascadio")
class ByCascadio(AnyConverter, Converter):
    command = [sys.executable, str(CAD_PY)]


class WithoutCascadio(Converter):
    command = [sys.executable, "-S", "-E", str(CAD_PY)]  # without packages of the site

    def test_the_way_is_told(self):
        message = "needs OpenCASCADE to read STEP and IGES: pip install 'vtk-vitrine[step]'"
        self.refuse_bytes("box.step", step_files.box(), message)

    def test_the_message_has_nothing_before_it(self):
        said = subprocess.run([*self.command, "--version"], capture_output=True, text=True)
        self.assertRegex(said.stderr, r"\A_cad.py: needs OpenCASCADE [^:]+: pip install 'vtk-vitrine\[step\]'\n\Z")
