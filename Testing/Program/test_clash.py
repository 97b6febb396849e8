import json
import unittest

import scenes
from program import FileTest, run


def tool(*arguments):
    """The JSON of a command."""
    result = run(*arguments, "--json", "-")
    if result.returncode != 0:
        raise AssertionError(result.stderr.decode(errors="replace"))
    return json.loads(result.stdout)


class Clash(FileTest):
    def test_json(self):
        told = tool("clash", "demo:assembly,parts=60", "--clearance", "0.02", "--tolerance", "0.01")
        self.assertEqual(
            list(told),
            ["scene", "parts", "open_parts", "tolerance", "clearance", "interfering", "touching", "near", "pairs"],
        )
        self.assertEqual((told["parts"], told["open_parts"]), (60, 0))
        self.assertEqual((told["tolerance"], told["clearance"]), (0.01, 0.02))
        kinds = [pair["kind"] for pair in told["pairs"]]
        for kind in ("interfering", "touching", "near"):
            self.assertEqual(kinds.count(kind), told[kind])
        self.assertGreater(told["interfering"], 0)
        depths = [pair["depth"] for pair in told["pairs"][: told["interfering"]]]
        self.assertEqual(depths, sorted(depths, reverse=True))
        self.assertGreater(depths[-1], 0.01)
        for pair in told["pairs"]:
            if pair["kind"] == "near":
                self.assertTrue(0.01 < pair["distance"] <= 0.02)

    def test_table_says_what_json_does(self):
        path = self.folder / "clashes.json"
        result = run("clash", "demo:assembly,parts=60", "--json", path)
        self.assert_done(result)
        text = result.stdout.decode()
        told = json.loads(path.read_text())
        deepest = told["pairs"][0]
        names = [path.rsplit("/", 1)[1] for path in deepest["parts"]]
        self.assertRegex(text, f"{names[0]} - .*{names[1]} ")
        self.assertIn(f"touching     {told['touching']} pairs", text)
        self.assertEqual(text.count(" touching "), 1)  # the count alone
        listed = run("clash", "demo:assembly,parts=60", "--touching").stdout.decode()
        self.assertEqual(listed.count(" touching "), 1 + told["touching"])

    def test_parts_that_are_left_out(self):
        told = tool("clash", "demo:assembly,parts=60", "--hide", "*shaft*")
        self.assertLess(told["parts"], 60)
        self.assertFalse(any("shaft" in name for pair in told["pairs"] for name in pair["parts"]))

    def test_equal_files_interfere(self):
        path = self.write("closed.stl", scenes.binary_stl())
        told = tool("clash", path, path)
        self.assertEqual(told["parts"], 2)


class Query(FileTest):
    SCENE = "demo:assembly,parts=60"

    def test_names_with_commas(self):
        document = scenes.gltf_document(168)
        document["nodes"][1]["name"] = "box, left"
        path = self.write("boxes.glb", scenes.pack_glb(document, scenes.gltf_binary()))
        told = tool("query", path, "--distance", r"box\, left,right box")["distance"]
        self.assertEqual([part.split("/")[-1] for part in told["parts"]], ["box, left", "right box"])

    def test_all_at_once(self):
        bounds = tool("info", self.SCENE, "--size", "16x16")["bounds"]
        middle = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
        before = [bounds[0] - 1, middle[1], middle[2]]
        box = ",".join(map(str, bounds))
        a, b = [pair["parts"] for pair in tool("clash", self.SCENE)["pairs"]][0]
        told = tool(
            "query", self.SCENE,
            "--ray", ",".join(map(str, [*before, 1, 0, 0])),
            "--nearest", ",".join(map(str, before)),
            "--box", box, "--wholly",
            "--sphere", f"{before[0]},0,0,0.5",
            "--distance", f"{a},{b}",
            "--sees", f"{a},{b}",
        )  # fmt: skip
        self.assertEqual(list(told), ["scene", "ray", "nearest", "box", "sphere", "distance", "sees"])
        self.assertEqual(len(told["box"]), 60)
        self.assertEqual(told["sphere"], [])
        self.assertEqual(told["distance"]["distance"], 0)
        self.assertTrue(told["sees"]["may_see"])
        self.assertGreaterEqual(told["nearest"]["distance"], 1 - 1e-6)
        crossings, walls = told["ray"]["crossings"], told["ray"]["walls"]
        self.assertEqual(len(crossings), 2 * len(walls))
        self.assertEqual([wall["thickness"] > 0 for wall in walls], [True] * len(walls))
        self.assertEqual(walls[0]["start"], crossings[0]["distance"])

    def test_text(self):
        result = run("query", self.SCENE, "--nearest", "0,0,0", "--ray", "-9,1,0,1,0,0")
        self.assertEqual(result.returncode, 0)
        for word in (b"nearest part: /", b"thickness", b"gap before"):
            self.assertIn(word, result.stdout)

    def test_bad_questions(self):
        for arguments, words in (
            ((), b"asks nothing"),
            (("--ray", "1,2,3"), b"'1,2,3' is not X,Y,Z,DX,DY,DZ"),
            (("--ray", "1,2,3,0,0,0"), b"direction of 0"),
            (("--nearest", "nan,0,0"), b"is not X,Y,Z"),
            (("--box", "1,0,0,1,0,1"), b"a MIN is above its MAX"),
            (("--sphere", "0,0,0,-1"), b"a radius of at least 0"),
            (("--distance", "one"), b"is not A,B"),
            (("--distance", "nonesuch,bolt"), b"chooses no part"),
            (("--sees", "*,*"), b"chooses 60 parts"),
        ):
            with self.subTest(arguments):
                result = run("query", self.SCENE, *arguments)
                self.assertEqual(result.returncode, 2)
                self.assertIn(words, result.stderr)
                self.assertEqual(result.stderr.count(b"\n"), 1)
        result = run("clash", self.SCENE, "--clearance", "-1")
        self.assertEqual(result.returncode, 2)
