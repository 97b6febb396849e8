import json
import pathlib
import re
import unittest

from desktop import Desktop, View
from program import FileTest, run

KEYS_PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "reference" / "keys.md"
SCENE = ["demo:assembly,parts=60", "--opacity", "0.5"]
SIZE = (240, 180)
MIDDLE = (120, 89)
# Names of xdotool for keys of the list.
NAMES = {"[": "bracketleft", "]": "bracketright", "?": "question", "Ctrl+z": "ctrl+z", "Ctrl+y": "ctrl+y"}


class ViewCommand(FileTest):
    """Without a display."""

    def test_without_a_display_it_says_so(self):
        for display in (None, ""):
            result = run("view", "demo:stack,layers=2", DISPLAY=display)
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stderr.count(b"\n"), 1)
            self.assertIn(b"DISPLAY", result.stderr)

    def test_a_tolerance_is_read_as_in_render(self):
        result = run("view", "demo:mating", "--coincidence", "16,x")
        self.assert_refused(result, "--coincidence", "STEPS[,SLOPE]")
        self.assert_refused(run("view", "demo:mating", "--coincidence", "16,0.01"), "DISPLAY")


    def test_levels_are_pixels(self):
        for wrong in ("0", "65", "nan", "x"):
            self.assert_refused(run("view", "demo:mating", "--levels", wrong), "--levels")

    def test_times_are_milliseconds(self):
        for wrong in ("0", "-1", "nan", "1e6", "x"):
            self.assert_refused(run("view", "demo:mating", "--frame-ms", wrong), "--frame-ms")


class ViewWindow(FileTest):
    """In a window, each picture of which is that of `vitrine render` with the options that mean the same."""

    @classmethod
    def setUpClass(cls):
        cls.desktop = Desktop()
        cls.addClassCleanup(cls.desktop.close)
        cls.pressed, cls.ended = set(), []

    def setUp(self):
        super().setUp()
        self.view = self.open(*SCENE)

    def open(self, *arguments):
        view = View(self.desktop, *arguments, size=SIZE, folder=self.folder)
        self.addCleanup(view.kill)
        self.assertEqual(view.begin(), "? shows the keys")
        return view

    def press(self, key, said=None):
        self.pressed.add(key)
        told = self.view.press(NAMES.get(key, key))
        if said is not None:
            self.assertEqual(told, said)
        return told

    def picture(self):
        """The PNG of what the window shows, without its texts."""
        path = self.folder / "vitrine.png"
        path.unlink(missing_ok=True)
        self.press("O", "saved vitrine.png")
        return path.read_bytes()

    def assert_shows(self, picture):
        self.assertTrue(self.picture() == picture, "the pictures differ")

    def rendered(self, *options, scene=SCENE):
        path = self.folder / "rendered.png"
        self.assert_done(run("render", *scene, *options, "--size", "{}x{}".format(*SIZE), "-o", path))
        return path.read_bytes()

    def end(self):
        self.pressed.add("q")
        self.assertEqual(self.view.end(), (0, ""))
        self.ended.append(self)

    def test_levels_leave_what_stands_still_as_it_is(self):
        scene = ["demo:assembly,parts=600", "--opacity", "0.5"]
        self.view = self.open(*scene, "--levels", "8")
        self.assert_shows(self.rendered(scene=scene))

    def test_with_ease_a_time_has_the_least_error(self):
        self.view = self.open(*SCENE, "--frame-ms", "60000", "--error", "8/255")
        self.assert_shows(self.rendered("--error", "0.6/255"))

    def test_a_click_selects_what_layers_tells_and_goes_deeper(self):
        at = "{},{}".format(*MIDDLE)
        told = run("layers", *SCENE, "--size", "{}x{}".format(*SIZE), "--at", at, "--all", "--json", "-")
        shares = {}
        for layer in json.loads(told.stdout)["layers"]:
            shares[layer["part"]] = shares.get(layer["part"], 0) + layer["share"]
        parts = list(shares)
        seen = next(i for i, part in enumerate(parts) if shares[part] >= 0.5)
        self.assertGreater(len(parts), 2)
        for deeper in range(len(parts) + 1):
            part = parts[(seen + deeper) % len(parts)]
            self.assertEqual(self.view.click(*MIDDLE), f"selected {part}")
        self.press("Escape", "nothing is selected")
        self.assertEqual(self.view.click(*MIDDLE, key="alt"), f"selected {parts[(seen + 1) % len(parts)]}")
        self.assertEqual(self.view.click(5, 5), "nothing is selected")
        self.press("d")
        self.assertEqual(self.view.click(*MIDDLE), f"selected {parts[seen]}")
        self.assertEqual(self.view.click(*MIDDLE, key="ctrl"), "selected 2 parts")
        self.end()

    def test_looks_are_those_of_render(self):
        whole = self.picture()
        self.assert_shows(self.rendered())
        self.press("h", "select a part first: click on it")
        part = self.view.click(*MIDDLE).split()[1]
        self.assertTrue(self.picture() != whole)  # the outline
        self.press("h", f"hid {part}")
        self.assert_shows(self.rendered("--hide", part))
        self.press("u", "undone")
        self.press("Escape")
        self.assert_shows(whole)
        self.press("g", "made glass of 60 parts")
        self.assert_shows(self.rendered("--opacity", "*=0.15"))
        self.press("]", "more opacity of 60 parts")
        self.assert_shows(self.rendered("--opacity", "*=0.25"))
        self.press("[")
        self.press("r", "reset 60 parts")
        self.assert_shows(whole)
        part = self.view.click(*MIDDLE).split()[1]
        self.press("i", f"isolated {part}")
        self.press("Escape")
        alone = self.picture()
        self.press("H", "all parts are shown")
        self.assert_shows(whole)
        self.press("Ctrl+z", "undone")
        self.assert_shows(alone)
        self.press("Ctrl+y", "redone")
        self.press("U", "nothing is left to redo")
        self.assert_shows(whole)
        self.end()

    def test_cuts_are_those_of_render(self):
        whole = self.picture()
        self.press("Up", "there is no plane yet: x, y or z makes one")
        self.press("x", "section x")
        cut = self.picture()
        self.assert_shows(self.rendered("--section", "1,0,0,0"))
        self.press("X", "section -x")
        self.assert_shows(self.rendered("--section", "-1,0,0,0"))
        self.press("Up", "moved the plane")
        self.assertTrue(self.picture() != cut)
        self.press("Down")
        self.press("x")
        self.assert_shows(cut)
        self.press("c", "no caps")
        self.assertTrue(self.picture() != cut)
        self.press("c", "caps")
        self.assertEqual(self.view.drag((100, 100), (130, 100), key="ctrl"), "moved the plane")
        self.assertTrue(self.picture() != cut)
        self.press("u", "undone")
        self.assert_shows(cut)
        self.press("x", "no section x")
        self.assert_shows(whole)
        for key in "yzYZ":
            self.press(key)
        self.press("b", "box around the middle")
        self.press("Z", "no section -z")
        self.press("Y", "no section -y")
        self.assertTrue(self.picture() != whole)
        self.press("b", "no box")
        self.assert_shows(whole)
        self.end()

    def test_cameras_explosion_and_reveal_go_back(self):
        whole = self.picture()
        self.assertEqual(self.view.drag((100, 100), (140, 120)), "moved the camera")
        self.assertTrue(self.picture() != whole)
        self.press("u")
        self.assert_shows(whole)
        self.press("t", "trackball")
        self.assertEqual(self.view.drag((100, 100), (140, 120)), "moved the camera")
        self.assertEqual(self.view.drag((100, 100), (140, 120), key="shift"), "moved the camera")
        self.assertEqual(self.view.drag((100, 100), (140, 120), button=2), "moved the camera")
        self.assertEqual(self.view.drag((100, 100), (140, 120), button=3), "moved the camera")
        self.assertEqual(self.view.click(*MIDDLE, button=4), "moved the camera")  # the wheel
        seen = {self.picture()}
        for key in "1234567pf":
            self.press(key)
            seen.add(self.picture())
        self.assertGreaterEqual(len(seen), 9)
        for _ in range(14):
            self.press("u", "undone")
        self.assert_shows(whole)
        self.press("e", "exploded by 0.25")
        self.assertTrue(self.picture() != whole)
        self.press("E", "exploded by 0")
        self.assert_shows(whole)
        part = self.view.click(*MIDDLE).split()[1]
        self.press("v", f"revealed {part}")
        self.press("Escape")
        self.assertTrue(self.picture() != whole)
        self.press("v", "nothing is revealed")
        self.assert_shows(whole)
        self.view.click(*MIDDLE)
        self.press("F", f"fits {part}")
        self.end()

    def test_methods_lights_texts_and_a_distance(self):
        whole = self.picture()
        self.press("m", "method blend")
        self.assert_shows(self.rendered("--method", "blend"))
        self.press("M", "method linked-list")
        self.press("l", "lights: studio")
        self.assertTrue(self.picture() != whole)
        self.press("u")
        self.assert_shows(whole)
        self.press("?", "keys")
        self.press("o", "saved vitrine-2.png")
        self.assertTrue((self.folder / "vitrine-2.png").read_bytes() != whole)
        self.press("F1", "no keys")
        self.press("d", "click on two places first")
        self.view.click(*MIDDLE)
        self.view.click(70, 89)
        self.assertRegex(self.press("d"), r"^distance [0-9.]+$")
        self.end()

    def test_an_error_begins_with_the_method_that_keeps_it(self):
        self.view.kill()
        self.view = self.open(*SCENE, "--error", "0.6/255")
        self.assert_shows(self.rendered("--error", "0.6/255"))
        self.press("m", "method blend")
        self.press("M", "method automatic")
        self.assert_shows(self.rendered("--error", "0.6/255"))
        self.end()

    def test_parts_that_are_blocks_of_an_actor(self):
        tiles = []
        for i in range(600):
            x, y, corner = i % 30, i // 30, 4 * i + 1
            tiles.append(f"o tile{i}\n")
            tiles += [f"v {x + a} {y + b} {(i % 7) / 10}\n" for a, b in ((0, 0), (0.9, 0), (0.9, 0.9), (0, 0.9))]
            tiles.append("f " + " ".join(str(corner + j) for j in range(4)) + "\n")
        model = self.write("tiles.obj", "".join(tiles).encode())
        self.view.kill()
        self.view = self.open(model)
        whole = self.picture()
        self.assertTrue(whole == self.rendered(scene=[model]))
        part = self.view.click(*MIDDLE).split()[1]
        self.press("h", f"hid {part}")
        self.assert_shows(self.rendered("--hide", part, scene=[model]))
        self.press("u")
        self.press("[")
        self.press("Escape")
        self.assert_shows(self.rendered("--opacity", f"{part}=0.9", scene=[model]))
        self.press("r", "reset 600 parts")
        self.press("e")
        self.assertTrue(self.picture() != whole)
        self.press("E")
        self.assert_shows(whole)
        self.view.click(*MIDDLE)
        self.press("v", f"revealed {part}")
        self.end()

    def test_the_page_lists_the_same_keys(self):
        rows = [row for row in KEYS_PAGE.read_text(encoding="utf-8").splitlines() if row.startswith("| `")]
        named = {key for row in rows for key in re.findall(r"`([^`]+)`", row.split("|")[1])}
        self.assertEqual(named | set("123456"), listed_keys())
        self.end()

    @classmethod
    def tearDownClass(cls):
        """All tests together press each key."""
        left = listed_keys() - cls.pressed
        if left and len(cls.ended) == len(unittest.defaultTestLoader.getTestCaseNames(cls)):
            raise AssertionError(f"no test presses {left}")


def listed_keys():
    """The keys that --help lists."""
    told = run("view", "--help").stdout.decode()
    listed = re.findall(r"^  (\S+(?: \S+)*)  ", told[told.index("Keys and the mouse") :], re.M)
    return {key for line in listed[: listed.index("click")] for key in line.split()}


if __name__ == "__main__":
    unittest.main()
