"""The view of the inspector's page, its pictures, its long work and hostile requests."""

import base64
import io
import re
import unittest

import numpy
from inspector_page import MODEL, REQUEST, PageCase
from PIL import Image
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys


MOST_TOLD = 300  # rows of a list in the page


class Page(PageCase):
    def test_shows_the_exact_picture_after_turning(self):
        before = self.state("ins")["camera"]
        self.drag(100, 25)
        self.assertNotEqual(self.state("ins")["camera"]["position"], before["position"])
        self.assert_shows(self.python())
        self.drag(40, 40, Keys.SHIFT)
        self.assertNotEqual(self.state("ins")["camera"]["focal_point"], before["focal_point"])
        ActionChains(self.browser).key_down(Keys.CONTROL).send_keys("z").key_up(Keys.CONTROL).perform()
        self.wait_for(lambda: self.state("ins")["camera"]["focal_point"] == before["focal_point"])

    def test_tells_the_layers_of_a_click_and_goes_deeper(self):
        self.ask("ghost", parts="all")
        self.click_part()
        picked, inspection = self.state("picked"), self.python()
        self.assertEqual(picked["layers"], inspection.layers(picked["x"], picked["y"]))
        self.assertEqual(picked["path"], inspection.pick(picked["x"], picked["y"]))
        self.assertEqual(self.state("selection")["path"], picked["path"])
        self.click_part(Keys.ALT)
        paths = list(dict.fromkeys(layer["path"] for layer in picked["layers"]))
        deeper = paths[(paths.index(picked["path"]) + 1) % len(paths)]
        self.assertEqual(self.state("selection")["path"], deeper)
        self.click_part(Keys.CONTROL)
        self.assertEqual(self.state("selection")["count"], len({deeper} ^ {picked["path"]}))
        self.assert_shows(self.python())

    def test_picks_in_a_picture_of_another_size_than_the_view(self):
        size = self.state("ins")["size"]
        self.addCleanup(lambda: self.ask("resize", width=size[0], height=size[1]))
        self.ask("resize", width=40960, height=800)
        self.assertEqual(self.state("ins")["size"], [4096, 80])
        self.ask("resize", width=300, height=2 * size[1])
        self.click_part()
        picked = self.state("picked")
        across, down = self.spot
        self.assertAlmostEqual(picked["x"], (size[0] / 2 + across) * 300 / size[0], delta=1)
        self.assertAlmostEqual(picked["y"], (size[1] / 2 - down) * 2, delta=2)

    def test_forgets_what_it_told_of_another_view(self):
        self.click_part()
        self.find("layers")
        self.ask("figures")
        self.ask("measure", kind="distance", a=[0, 0, 0], b=[3, 4, 0])
        self.click("heat")
        self.wait_for(lambda: self.state("heat"))
        self.ask("select", parts=None)
        self.assertTrue(self.state("figures") and self.state("heat") and self.find("layers"))
        self.drag(25, 0)
        self.assertEqual([self.state(name) for name in ("figures", "heat")], [None, None])
        self.assertEqual(self.browser.find_elements(By.ID, "vi-layers"), [])
        self.assertEqual(self.state("measured")["distance"], 5.0)
        self.ask("explode", factor=1.0)
        self.wait_for(lambda: (self.state("measured"), self.state("picked")) == (None, None))

    def test_changes_parts_and_takes_it_back(self):
        self.click_part()
        count = self.find("count")
        for name, expected in (("hide", " 1 hidden"), ("show", "parts · 1 selected"), ("isolate", " hidden")):
            self.click(name)
            self.wait_for(lambda expected=expected: expected in count.text)
        hidden = int(re.search(r"([\d,]+) hidden", count.text)[1].replace(",", ""))
        self.assertEqual(hidden, len(self.python().parts.paths) - 1)
        self.wait_for(self.is_exact)
        self.assert_shows(self.python())
        for _ in range(3):
            self.ask("undo")
        self.wait_for(lambda: "hidden" not in count.text)

    def test_makes_each_of_many_quick_changes(self):
        paths, count = self.python().parts.paths[:5], self.find("count")
        script = "for (const change of arguments[0]) trame.utils.vitrine.act(...change)"
        changes = [["hide", {"parts": [path]}] for path in paths]
        self.browser.execute_script(script, [*changes, *[["explode", {"factor": i / 64}] for i in range(65)]])
        self.wait_for(lambda: " 5 hidden" in count.text and self.state("ins")["explode"] == 1.0)
        self.browser.execute_script(script, [["undo", {}]] * 5)
        self.wait_for(lambda: " 1 hidden" in count.text and self.state("ins")["explode"] == 0.0)
        self.browser.execute_script(script, [["select", {"parts": [path], "add": True}] for path in paths])
        self.wait_for(lambda: self.state("selection")["count"] == 5)

    def test_has_the_wheel_and_each_drag_as_steps_of_undo(self):
        before = self.state("ins")["camera"]
        self.drag(25, 0, Keys.SHIFT)
        dragged = self.state("ins")["camera"]
        turn = "const wheel = () => new WheelEvent('wheel', { deltaY: 120 }); arguments[0].dispatchEvent(wheel());"
        self.browser.execute_script(turn, self.find("view"))
        self.wait_for(lambda: self.state("ins")["camera"] != dragged and self.is_exact())
        for expected in (dragged, before):
            self.ask("undo")
            self.wait_for(lambda expected=expected: self.state("ins")["camera"] == expected)

    def test_moves_no_plane_by_the_arrows_of_a_slider(self):
        self.ask("add_section", normal="x")
        origin = self.state("ins")["sections"][0]["origin"]
        self.click("tab-cut")
        press = "arguments[0].dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowUp', bubbles: true }))"
        slider = self.browser.find_element(By.CSS_SELECTOR, ".vi-look [role=slider]")
        self.browser.execute_script(press, slider)
        self.ask("select", parts=None)
        self.assertEqual(self.state("ins")["sections"][0]["origin"], origin)
        self.browser.execute_script(press, self.find("view"))
        self.wait_for(lambda: self.state("ins")["sections"][0]["origin"] != origin)

    def test_cuts_and_drags_the_plane(self):
        self.click("tab-cut")
        self.click("section-x")
        self.wait_for(lambda: len(self.state("ins")["sections"]) == 1)
        self.wait_for(self.is_exact)
        before = self.state("ins")["sections"][0]["origin"]
        self.drag(25, 0, Keys.CONTROL)
        after = self.state("ins")["sections"][0]["origin"]
        self.assertNotEqual(after[0], before[0])
        self.assertEqual(after[1:], before[1:])
        inspection = self.python()
        cut = inspection.cut_parts()
        self.assertEqual((self.state("cut")["paths"], self.state("cut")["count"]), (cut[:MOST_TOLD], len(cut)))
        self.assertGreater(len(cut), 0)
        self.assert_shows(inspection)

    def test_measures_and_finds_clashes_as_python_does(self):
        self.click_part()
        self.click("tab-check")
        self.click("thickness")
        measured = self.wait_for(lambda: self.state("measured"))
        picked, inspection = self.state("picked"), self.python()
        self.assertEqual(measured, inspection.measure("thickness", x=picked["x"], y=picked["y"]))
        self.click("find-clashes")
        told = self.wait_for(lambda: self.state("clashes"))
        self.assertEqual(told["count"], len(inspection.clashes()))

    def test_tells_figures_and_the_chart(self):
        self.ask("figures")
        told, expected = self.state("figures"), self.python()
        expected.draw()
        same = ("method", "fragments", "layers_max", "parts", "size")
        self.assertEqual([told[key] for key in same], [expected.figures()[key] for key in same])
        self.ask("error")
        self.assertEqual(self.state("error_told")["wrong_pixels"], 0)
        self.ask("chart", frames=1)
        self.assertEqual([row["method"] for row in self.state("chart")][0], "truth")
        self.assertGreater(len(self.state("chart")), 4)

    def test_saves_pictures_and_states(self):
        told = self.ask("screenshot", width=200, height=100, transparent=True)
        picture = numpy.asarray(Image.open(io.BytesIO(base64.b64decode(told["data"]))))
        numpy.testing.assert_array_equal(picture, self.python().picture((200, 100), transparent=True))
        text = base64.b64decode(self.ask("save_state")["data"]).decode()
        self.ask("explode", factor=1.5)
        self.ask("apply_text", text=text)
        self.assertEqual(self.state("ins")["explode"], 0.0)
        self.assertIn("vitrine.load", self.ask("script"))
        page = base64.b64decode(self.ask("explorable")["data"]).decode()
        self.assertIn(f"<title>{MODEL.name}", page)

    def test_stops_the_chart_with_its_view(self):
        self.browser.execute_script("window.chart = trame.utils.vitrine.request('chart', { frames: 30 })")
        self.wait_for(lambda: self.state("chart"))
        self.drag(25, 0)
        script = "window.chart.then((told) => arguments[0]([told]))"
        self.assertEqual(self.browser.execute_async_script(script), [None])
        self.assertLess(len(self.state("chart")), 4)

    def test_refuses_changes_during_work_that_takes_all_time(self):
        script = """
            const done = arguments[arguments.length - 1], request = window.trame.utils.vitrine.request;
            const work = request("clashes", { clearance: 0.001 });
            request("hide", { parts: "all" }).then(() => work).then(done);
        """
        self.browser.execute_async_script(script)
        self.wait_for(lambda: self.state("message")["text"].startswith("Looking for clashes is not done yet"))
        self.assertNotIn("hidden", self.find("count").text)

    def test_stops_long_work(self):
        begin = "window.stopped = (utils) => utils.request('turntable', { frames: 1000 }).then((told) => [told]);"
        self.browser.execute_script(f"{begin} window.stopped = window.stopped(trame.utils.vitrine);")
        self.wait_for(lambda: (self.state("busy") or {}).get("share"))
        self.assertIsNone(self.ask("chart"))
        self.assertIn("is not done yet", self.state("message")["text"])
        self.click("stop")
        self.wait_for(lambda: self.state("busy") is None)
        self.assertEqual(self.state("message")["text"], "Stopped.")
        script = "window.stopped.then(arguments[arguments.length - 1])"
        self.assertEqual(self.browser.execute_async_script(script), [None])
        self.wait_for(self.is_exact)
        self.assert_shows(self.python())

    def test_answers_hostile_requests_with_a_message(self):
        state = self.ask("save_state")["data"]
        for name, values in HOSTILE:
            with self.subTest(name=name, values=str(values)[:60]):
                self.browser.execute_script("trame.state.set('message', {kind: '', text: ''})")
                self.assertIsNone(self.browser.execute_async_script(REQUEST, [name, values]))
                self.wait_for(lambda: self.state("message")["kind"] == "error" and self.state("message")["text"])
        self.assertEqual(self.ask("save_state")["data"], state)
        self.assert_shows(self.python())


HOSTILE = [
    ("../../etc/passwd", {}),
    ("__class__", {}),
    ("close", {}),
    ("save", {"path": "/tmp/written"}),
    ("screenshot", {"path": "../written.png"}),
    ("screenshot", {"width": 10**9, "height": 1}),
    ("screenshot", {"width": "4", "height": None}),
    ("turntable", {"frames": 10**12}),
    ("turntable", {"path": "/tmp/written.mp4"}),
    ("chart", {"frames": "many"}),
    ("clashes", {"clearance": -1}),
    ("clashes", {"clearance": "far"}),
    ("hide", {"parts": ["/nobody"]}),
    ("hide", {"parts": 7}),
    ("hide", {"parts": [None]}),
    ("hide", {"other": 1}),
    ("ghost", {"parts": "all", "opacity": 2}),
    ("look", {"parts": "all", "color": "red; background: url(x)"}),
    ("look", {"parts": "all", "opacity": "1"}),
    ("select", {"parts": {"a": 1}}),
    ("explode", {"factor": -1}),
    ("explode", {"factor": 1e308}),
    ("explode", {"factor": None}),
    ("add_section", {"normal": [0, 0, 0]}),
    ("add_section", {"normal": "w"}),
    ("move_section", {"index": 3, "origin": [0, 0, 0]}),
    ("move_section", {"index": "0", "origin": [0, 0, 0]}),
    ("remove_section", {"index": -1}),
    ("set_box", {"bounds": [1, 2, 3]}),
    ("set_caps", {"hatch": "bricks"}),
    ("set_caps", {"unknown": 1}),
    ("reveal", {"part": "*"}),
    ("view", {"name": "behind"}),
    ("save_view", {"name": "x" * 100000}),
    ("go_to", {"name": "nowhere"}),
    ("parallel", {"on": "yes"}),
    ("set_lights", {"preset": "disco"}),
    ("set_background", {"color": "#12"}),
    ("set_method", {"method": "magic"}),
    ("set_error", {"error": 0}),
    ("set_levels", {"pixels": "fine"}),
    ("apply", {"state": []}),
    ("apply", {"state": {"vitrine": 1, "camera": {"position": [0, 0, 0]}}}),
    ("apply", {"state": {"vitrine": 1, "selected": ["/nobody"]}}),
    ("apply_text", {"text": "{" * 100000}),
    ("apply_text", {"text": 5}),
    ("move", {"kind": "rotate", "across": "far", "down": 0}),
    ("move", {"kind": "fly", "across": 1, "down": 1}),
    ("move", {"kind": "plane", "across": 1, "down": 1, "plane": 9}),
    ("click", {"x": 10**6, "y": 0}),
    ("click", {"x": "1", "y": []}),
    ("resize", {"width": -5, "height": "all"}),
    ("measure", {"kind": "distance", "a": [1], "b": "x"}),
    ("measure", {"kind": "age"}),
    ("pick", {"x": [], "y": 1}),
    ("move", []),
]


if __name__ == "__main__":
    unittest.main()
