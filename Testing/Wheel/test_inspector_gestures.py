"""Each gesture of the inspector's page does what Python's call does: in the tree, in lists, in panels, and by keys."""

import base64
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
from inspector_page import MODEL, PageCase, Process, open_browser
from PIL import Image
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

VIEWS = "front", "back", "left", "right", "top", "bottom", "iso"
PANEL = "//div[contains(@class, 'vi-panel')]"
# Keys, and the calls of an Inspection that do the same. A part is selected, and told as `part`.
KEYS = [
    ("[", lambda shown, part: shown.look([part], opacity=0.9)),
    ("g", lambda shown, part: shown.ghost([part])),
    ("]", lambda shown, part: shown.look([part], opacity=0.25)),
    ("r", lambda shown, part: shown.reset([part])),
    ("h", lambda shown, part: shown.hide([part])),
    ("u", lambda shown, part: shown.undo()),
    ("U", lambda shown, part: shown.redo()),
    ("H", lambda shown, part: shown.show(shown.parts.paths)),
    ("i", lambda shown, part: shown.isolate([part])),
    ("H", lambda shown, part: shown.show(shown.parts.paths)),
    ("e", lambda shown, part: shown.explode(0.25)),
    ("E", lambda shown, part: shown.explode(0.0)),
    ("v", lambda shown, part: shown.reveal(part)),
    ("v", lambda shown, part: shown.reveal(None)),
    ("y", lambda shown, part: shown.add_section([0, 1, 0])),
    ("Z", lambda shown, part: shown.add_section([0, 0, -1])),
    ("y", lambda shown, part: shown.remove_section(0)),
    ("c", lambda shown, part: shown.set_caps(show=False)),
    ("Z", lambda shown, part: shown.remove_section(0)),
    ("F", lambda shown, part: shown.fit([part])),
    *((str(at), lambda shown, part, name=name: shown.view(name)) for at, name in enumerate(VIEWS, 1)),
    ("f", lambda shown, part: shown.fit()),
    ("p", lambda shown, part: shown.parallel(True)),
    ("l", lambda shown, part: shown.set_lights("studio")),
    ("m", lambda shown, part: shown.set_method("stencil-routed")),
    (Keys.ESCAPE, lambda shown, part: shown.select(None)),
]
PICTURED = ("g", "i", "e", "v", "Z", "p", "m")  # keys after which pixels are compared, too


class Gestures(PageCase):
    def press(self, *keys):
        self.press_on(self.find("view"), *keys)

    def press_on(self, element, *keys):
        """Press keys where the page has them, as on the thumb of a slider."""
        self.browser.execute_script("arguments[0].focus()", element)
        ActionChains(self.browser).send_keys(*keys).perform()

    def all_of(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def one_of(self, selector):
        return self.wait_for(lambda: self.all_of(selector))[0]

    def click_on(self, element):
        self.browser.execute_script("arguments[0].click()", element)

    def slider(self, label):
        """The thumb of the slider that stands beside a label."""
        return self.browser.find_element(
            By.XPATH, f"//div[@class='vi-line'][div[normalize-space()='{label}']]//div[@role='slider']"
        )

    def button(self, text):
        return self.browser.find_element(By.XPATH, f"{PANEL}//button[normalize-space()='{text}']")

    def type_into(self, element, value):
        """Give an input a value, as its change tells it."""
        script = "arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('change', {bubbles: true}))"
        self.browser.execute_script(script, element, value)

    def choose(self, label, text):
        """Choose from a menu of the panels."""
        line = f"{PANEL}//div[@class='vi-line'][div[normalize-space()='{label}']]"
        self.browser.find_element(By.XPATH, f"{line}//div[@role='combobox']").click()
        menu = "//div[contains(@class, 'v-overlay--active')]//div[contains(@class, 'v-list-item')]"
        item = f"{menu}[normalize-space()='{text}']"
        self.click_on(self.wait_for(lambda: self.browser.find_elements(By.XPATH, item))[0])

    def agrees(self, inspection):
        """Whether the page has the state of an inspection."""
        return self.saved() == inspection.state()

    def assert_agrees(self, inspection):
        """The page comes to have the state of an inspection, and then shows its picture."""
        self.assert_has_state_of(inspection)
        self.wait_for(self.is_exact)
        self.assert_shows(inspection)

    def assert_has_state_of(self, inspection):
        try:
            self.wait_for(lambda: self.agrees(inspection))
        except Exception:
            saved, state = self.saved(), inspection.state()
            self.assertEqual({key: saved[key] for key in state if saved[key] != state[key]}, {})
            raise

    def row(self, path):
        return self.wait_for(lambda: self.all_of(f'.vi-row[data-path={json.dumps(path)}]'))[0]

    def rarest(self, paths):
        """The part whose name is in the fewest other names, and its name."""
        names = [path.rsplit("/", 1)[-1].lower() for path in paths[-200:]]
        text = "\n".join(path.lower() for path in paths)
        at = min(range(len(names)), key=lambda at: text.count(names[at]))
        path = paths[-200:][at]
        return path, path.rsplit("/", 1)[-1]

    def search(self, text):
        field = self.find("search")
        field.send_keys(text)
        self.addCleanup(lambda: field.send_keys(Keys.CONTROL + "a" + Keys.NULL + Keys.DELETE))

    # The tree

    def test_in_the_tree_find_a_part_and_change_its_look(self):
        expected = self.python()
        path, name = self.rarest(expected.parts.paths)
        self.search(name)
        row = self.row(path)
        row.click()
        expected.select([path])
        self.assert_agrees(expected)
        for tool, call in (("Ghost", expected.ghost), ("Hide", expected.hide), ("Show", expected.show)):
            self.click_on(self.row(path).find_element(By.CSS_SELECTOR, f"[title={tool}]"))
            call([path])
            self.assert_agrees(expected)
        self.click_on(self.row(path).find_element(By.CSS_SELECTOR, "[title=Isolate]"))
        expected.isolate([path])
        self.assert_agrees(expected)
        for key, step in (("z", expected.undo), ("y", expected.redo), ("z", expected.undo)):
            ActionChains(self.browser).key_down(Keys.CONTROL).send_keys(key).key_up(Keys.CONTROL).perform()
            step()
            self.assert_agrees(expected)

    def test_in_the_tree_find_parts_by_patterns(self):
        parts = self.python().parts
        _, name = self.rarest(parts.paths)
        for pattern in ("?" + name[1:], "/**/*" + name[-2:]):
            self.search(pattern)
            told = f"{len(parts.find(pattern)):,} found of"
            self.wait_for(lambda told=told: self.find("count").text.startswith(told))
            self.doCleanups()

    def test_in_the_tree_select_several_rows_and_colour_them(self):
        expected = self.python()
        self.wait_for(lambda: len(self.all_of(".vi-row")) > 2)
        rows = self.all_of(".vi-row")[-3:]
        paths = [row.get_attribute("data-path") for row in rows]
        ActionChains(self.browser).click(rows[0]).key_down(Keys.SHIFT).click(rows[2]).key_up(Keys.SHIFT).perform()
        expected.select(paths)
        self.assert_agrees(expected)
        rows = [self.row(path) for path in paths]
        ActionChains(self.browser).key_down(Keys.CONTROL).click(rows[1]).key_up(Keys.CONTROL).perform()
        expected.select([paths[1]], add=True)
        self.assert_agrees(expected)
        selected = expected.state_now["selected"]
        self.type_into(self.one_of(".vi-look input[type=color]"), "#c81e5a")
        expected.look(selected, color="#c81e5a")
        self.assert_agrees(expected)
        self.press_on(self.one_of(".vi-look [role=slider]"), Keys.HOME)
        expected.look(selected, opacity=0.0)
        self.assert_agrees(expected)

    # The list of layers

    def test_in_the_list_of_layers_highlight_ghost_and_isolate(self):
        self.ask("ghost", parts="all")
        self.click_part()
        expected = self.python()
        for at, layer in enumerate(self.state("picked")["layers"][:3]):
            for title, call in (("Highlight", expected.highlight), ("Make glass", expected.ghost)):
                row = self.all_of("#vi-layers tr")[at + 1]
                self.click_on(row.find_element(By.CSS_SELECTOR, f"[title='{title}']"))
                call([layer["path"]])
                self.assert_agrees(expected)
        self.click_part()
        self.wait_for(lambda: self.all_of("#vi-layers"))
        expected.select([self.state("picked")["path"]])
        row = self.all_of("#vi-layers tr")[-1]
        self.click_on(row.find_element(By.CSS_SELECTOR, "[title=Isolate]"))
        expected.isolate([self.state("picked")["layers"][-1]["path"]])
        self.assert_agrees(expected)

    # Keys

    def test_by_keys_do_what_calls_do(self):
        self.ask("select", parts=[self.part])
        expected = self.python()
        for key, call in KEYS:
            self.press(key)
            call(expected, self.part)
            self.assert_has_state_of(expected)
            if key in PICTURED:
                self.assert_agrees(expected)
        self.press("t")
        self.wait_for(lambda: self.state("trackball"))
        self.drag(40, 40)
        self.assert_shows(self.python())
        self.press("t", "?")
        self.wait_for(lambda: self.find("keys").is_displayed())
        self.press("?")
        self.wait_for(lambda: not self.all_of("#vi-keys") or not self.find("keys").is_displayed())

    # Cuts

    def test_in_the_cuts_give_numbers_hatches_and_a_box(self):
        expected = self.python()
        self.click("tab-cut")
        self.click("section-x")
        expected.add_section("x")
        self.assert_agrees(expected)
        self.type_into(self.all_of("#vi-plane input[type=number]")[1], "1")
        expected.move_section(0, normal=[1, 1, 0])
        self.assert_agrees(expected)
        self.press_on(self.slider("Offset"), Keys.ARROW_RIGHT)
        self.wait_for(lambda: self.state("ins")["sections"] != expected.state_now["sections"])
        expected.move_section(0, origin=self.state("ins")["sections"][0]["origin"])
        self.assert_agrees(expected)
        self.assertEqual(self.state("cut")["count"], len(expected.cut_parts()))
        self.click("box")
        self.wait_for(lambda: self.state("ins")["box"])
        expected.set_box(self.state("ins")["box"]["bounds"])
        self.assert_agrees(expected)
        self.choose("Hatch", "lines")
        expected.set_caps(hatch="lines")
        self.assert_agrees(expected)
        self.assertEqual(self.state("cut")["count"], len(expected.cut_parts()))

    def test_in_the_cuts_explode_and_reveal_a_part_with_a_share(self):
        self.ask("select", parts=[self.part])
        expected = self.python()
        self.click("tab-cut")
        self.press_on(self.slider("Factor"), Keys.END)
        expected.explode(3.0)
        self.assert_agrees(expected)
        self.press_on(self.slider("Factor"), Keys.HOME)
        expected.explode(0.0)
        self.click("reveal")
        expected.reveal(self.part)
        self.assert_agrees(expected)
        self.press_on(self.slider("Share"), Keys.END)
        expected.reveal(self.part, share=1.0)
        self.assert_agrees(expected)

    # Checks

    def test_in_the_checks_measure_and_fly_to_clashes(self):
        expected = self.python()
        self.click("tab-check")
        self.click_part()
        before = self.state("picked")
        self.press("4")
        expected.select([self.part])
        expected.view("right")
        self.assert_agrees(expected)
        self.click_part()
        after = self.state("picked")
        met = [next(each for each in told["layers"] if each["path"] == told["path"]) for told in (before, after)]
        self.click_on(self.button("Distance"))
        places = {"a": met[0]["position"], "b": met[1]["position"]}
        self.wait_for(lambda: self.state("measured"))
        self.assertEqual(self.state("measured"), expected.measure("distance", **places))
        pair = [self.part, next(path for path in expected.parts.paths if path != self.part)]
        self.ask("select", parts=pair)
        self.click_on(self.button("Clearance"))
        told = expected.measure("clearance", a=pair[0], b=pair[1])
        self.wait_for(lambda: self.state("measured") == told)
        self.click("find-clashes")
        clashes = self.wait_for(lambda: self.state("clashes"))
        expected.select(pair)
        for at in range(min(2, clashes["count"])):
            self.click_on(self.all_of("#vi-clashes tr")[at])
            expected.select(clashes["rows"][at]["parts"])
            expected.fit(clashes["rows"][at]["parts"])
            self.assert_agrees(expected)

    # Figures

    def test_in_the_figures_choose_the_method_and_see_what_it_takes(self):
        expected = self.python()
        self.click("tab-figures")
        self.choose("Method", "linked-list")
        expected.set_method("linked-list")
        self.assert_agrees(expected)
        self.type_into(self.one_of("input[title^='Steps of depth']"), "4")
        expected.set_method("linked-list", [4, 0])
        self.assert_agrees(expected)
        self.click_on(self.browser.find_element(By.XPATH, "//label[normalize-space()='Leave out what is hidden']"))
        expected.set_method("linked-list", [4, 0], cull=False)
        self.assert_agrees(expected)
        self.press("u")
        expected.undo()
        self.assert_agrees(expected)
        self.type_into(self.one_of("input[title^='The largest error']"), "2")
        expected.set_error(2 / 255)
        self.assert_has_state_of(expected)
        self.click_on(self.browser.find_element(By.XPATH, "//label[normalize-space()='Coarser parts while moving']"))
        expected.set_levels(0.5)
        self.assert_has_state_of(expected)
        self.type_into(self.one_of("input[title^='The largest error']"), "")
        self.choose("Method", "linked-list")
        expected.set_error(None)
        expected.set_method("linked-list", [4, 0])
        self.assert_agrees(expected)
        self.click("figures")
        told = self.wait_for(lambda: self.state("figures"))
        rows = {row.find_element(By.TAG_NAME, "td").text: row.text for row in self.all_of("#vi-figures-table tr")}
        self.assertIn(f"{told['fragments']:,}", rows["fragments"])
        told = self.wait_for(lambda: self.state("culled"))
        self.assertEqual(sum(row["parts"] for row in told), len(expected.parts.paths))
        self.click("heat")
        self.one_of(".vi-heat")
        shown = self.ask("heat_map")["data"]
        self.assertEqual(base64.b64decode(shown)[:4], b"\x89PNG")

    # Views and pictures

    def test_in_the_views_save_forget_and_go(self):
        expected = self.python()
        self.click("tab-view")
        self.browser.find_element(By.XPATH, "//div[@class='vi-line'][.//button[@id='vi-save-view']]//input").send_keys(
            "mine"
        )
        self.wait_for(lambda: self.find("save-view").is_enabled())
        self.click("save-view")
        expected.save_view("mine")
        self.assert_agrees(expected)
        self.press("1")
        expected.view("front")
        self.assert_agrees(expected)
        self.click_on(self.button("mine"))
        expected.go_to("mine")
        self.assert_agrees(expected)
        self.choose("Lights", "above")
        expected.set_lights("above")
        self.assert_agrees(expected)
        self.click_on(self.one_of(".vi-panel [title=Forget]"))
        expected.remove_view("mine")
        self.assert_agrees(expected)
        theme, other = self.state("theme"), {"light": "dark", "dark": "light"}
        self.click_on(self.one_of("[title='Dark or light']"))
        self.wait_for(lambda: self.state("theme") == other[theme])
        expected.set_background({"light": "#16181c", "dark": "#ffffff"}[theme])
        self.assert_agrees(expected)
        self.click_on(self.one_of("[title='Dark or light']"))
        expected.set_background("#ffffff")
        self.assert_agrees(expected)

    def test_of_pictures_make_tiles_a_video_and_a_script(self):
        self.ask("add_section", normal="x")
        self.ask("select", parts=[self.part])
        expected = self.python()
        told = self.ask("screenshot", width=4100, height=60)
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            written = folder / "picture.png"
            written.write_bytes(base64.b64decode(told["data"]))
            numpy.testing.assert_array_equal(numpy.asarray(Image.open(written)), expected.picture((4100, 60)))
            video = self.ask("turntable", frames=3, width=64, height=48)
            self.assertEqual(base64.b64decode(video["data"])[4:8], b"ftyp")
            written.unlink()
            (folder / "script.py").write_text(self.ask("script"))
            subprocess.run([sys.executable, "-B", "script.py"], check=True, cwd=folder)
            numpy.testing.assert_array_equal(numpy.asarray(Image.open(written)), expected.picture())


class Nested(unittest.TestCase):
    def test_part_with_parts_below_is_hidden_and_shown_with_them(self):
        with tempfile.TemporaryDirectory() as folder:
            server = Process(write_nested(pathlib.Path(folder) / "nested.gltf"))
            self.addCleanup(server.end)
            browser = open_browser(1000, 700)
            self.addCleanup(browser.quit)
            browser.get(server.address)
            wait = WebDriverWait(browser, 30, 0.02)
            for expected in ("3 hidden", "3 parts", "3 hidden"):
                eye = wait.until(lambda b: b.find_elements(By.CSS_SELECTOR, '[data-path="/outer"] .vi-eye'))[0]
                browser.execute_script("arguments[0].click()", eye)
                wait.until(lambda b, text=expected: text in b.find_element(By.ID, "vi-count").text.split(" · ")[-1])


def write_nested(path):
    """Write a part with two parts below it, each a triangle, as glTF. Returns the path."""
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], numpy.float32).tobytes()
    uri = "data:application/octet-stream;base64," + base64.b64encode(corners).decode()
    accessor = {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0] * 3, "max": [1, 1, 0]}
    nodes = [{"name": name, "mesh": 0, "translation": [0, 0, z]} for z, name in enumerate(("outer", "inner", "other"))]
    nodes[0]["children"] = [1, 2]
    model = {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": len(corners), "uri": uri}],
        "bufferViews": [{"buffer": 0, "byteLength": len(corners)}],
        "accessors": [accessor],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": nodes,
        "scenes": [{"nodes": [0]}],
        "scene": 0,
    }
    path.write_text(json.dumps(model))
    return path


if __name__ == "__main__":
    unittest.main()
