"""The inspector's page in a browser, of a real server. VITRINE_SCREENSHOTS names a folder for pictures of it."""

import asyncio
import base64
import contextlib
import io
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest
import urllib.error
import urllib.request

import numpy
from PIL import Image
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait
from trame.app.core import AVAILABLE_SERVERS

from vitrine.inspector import Inspection, inspect
from vitrine.inspector._session import Session

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing/Program"))

from browser import open_browser  # noqa: E402

MODEL = ROOT / "Examples/models/robot.glb"
REQUEST = """
const done = arguments[arguments.length - 1];
const text = (bytes) => btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
const told = (result) => (result && result.data ? { ...result, data: text(result.data) } : result);
const request = window.trame.utils.vitrine.request(...arguments[0]);
request.then((result) => done(told(result)), (error) => done(String(error)));
"""


class Process:
    """`vitrine inspect` as a process, and its address."""

    def __init__(self, *arguments):
        command = [sys.executable, "-m", "vitrine", "inspect", *map(str, arguments), "--no-browser"]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()
        self.base = self.address.split("?")[0]

    def end(self):
        """End it as a terminal does. Returns its status and what it wrote to stderr."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
        return self.wait()

    def wait(self):
        _, errors = self.process.communicate(timeout=20)
        return self.process.returncode, errors


def setUpModule():
    global SERVER
    SERVER = Process(MODEL)


def tearDownModule():
    status, errors = SERVER.end()
    assert (status, errors) == (0, ""), f"the server ended with {status}: {errors}"


class PageCase(unittest.TestCase):
    """A page that is opened once, and what Python says of the same state."""

    @classmethod
    def setUpClass(cls):
        cls.browser = open_browser(1280, 800)
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.set_script_timeout(30)
        cls.browser.get(SERVER.address)
        cls.wait_for(cls.is_exact)

    def tearDown(self):
        folder = os.environ.get("VITRINE_SCREENSHOTS")
        if folder:
            self.browser.save_screenshot(f"{folder}/inspector-{self._testMethodName}.png")
        errors = [line for line in self.browser.get_log("browser") if line["level"] not in ("INFO", "DEBUG")]
        self.assertEqual(errors, [])

    @classmethod
    def wait_for(cls, condition):
        return WebDriverWait(cls.browser, 30, 0.02).until(lambda _: condition())

    @classmethod
    def find(cls, name):
        return cls.browser.find_element(By.ID, f"vi-{name}")

    @classmethod
    def state(cls, name):
        return cls.browser.execute_script("return JSON.parse(JSON.stringify(trame.state.get(arguments[0])))", name)

    @classmethod
    def is_exact(cls):
        """Whether the picture is the exact one of the last change."""
        views = cls.browser.find_elements(By.ID, "vi-view")
        if not views:
            return False
        shown = views[0].get_attribute("data-exact"), views[0].get_attribute("data-revision")
        return shown == ("true", str(cls.state("revision")))

    def ask(self, name, **values):
        result = self.browser.execute_async_script(REQUEST, [name, values])
        self.wait_for(self.is_exact)
        return result

    def click(self, name):
        self.browser.execute_script("arguments[0].click()", self.find(name))

    def click_view(self, across, down, *keys):
        actions = ActionChains(self.browser)
        for key in keys:
            actions.key_down(key)
        actions.move_to_element_with_offset(self.find("view"), across, down).click()
        for key in keys:
            actions.key_up(key)
        self.browser.execute_script("trame.state.set('picked', null)")
        actions.perform()
        self.wait_for(lambda: self.state("picked") is not None)
        self.wait_for(self.is_exact)

    def drag(self, across, down, *keys):
        revision = self.state("revision")
        actions = ActionChains(self.browser, duration=0)
        for key in keys:
            actions.key_down(key)
        actions.move_to_element(self.find("view")).click_and_hold()
        for _ in range(5):
            actions.move_by_offset(across // 5, down // 5)
        actions.release()
        for key in keys:
            actions.key_up(key)
        actions.perform()
        self.wait_for(lambda: self.state("revision") > revision and self.is_exact())

    def python(self):
        """An Inspection of the page's state."""
        state = json.loads(base64.b64decode(self.ask("save_state")["data"]))
        inspection = Inspection(str(MODEL), size=state["size"])
        self.addCleanup(inspection.close)
        inspection.apply(state)
        return inspection

    def assert_shows(self, inspection):
        """The page shows the pixels of an inspection."""
        script = "return document.getElementById('vi-view').toDataURL('image/png')"
        data = base64.b64decode(self.browser.execute_script(script).split(",")[1])
        shown = numpy.asarray(Image.open(io.BytesIO(data)).convert("RGB"))
        numpy.testing.assert_array_equal(shown, inspection.picture())


class Page(PageCase):
    def setUp(self):
        self.ask("apply", state={"vitrine": 1, "camera": self.first_camera})

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.first_camera = cls.state("ins")["camera"]

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
        self.click_view(10, 10)
        picked, inspection = self.state("picked"), self.python()
        self.assertEqual(picked["layers"], inspection.layers(picked["x"], picked["y"]))
        self.assertEqual(picked["path"], inspection.pick(picked["x"], picked["y"]))
        self.assertEqual(self.state("selection")["path"], picked["path"])
        self.click_view(10, 10, Keys.ALT)
        paths = list(dict.fromkeys(layer["path"] for layer in picked["layers"]))
        deeper = paths[(paths.index(picked["path"]) + 1) % len(paths)]
        self.assertEqual(self.state("selection")["path"], deeper)
        self.click_view(10, 10, Keys.CONTROL)
        self.assertEqual(self.state("selection")["count"], 2)
        self.assert_shows(self.python())

    def test_picks_in_a_picture_of_another_size_than_the_view(self):
        size = self.state("ins")["size"]
        self.addCleanup(lambda: self.ask("resize", width=size[0], height=size[1]))
        self.ask("resize", width=40960, height=800)
        self.assertEqual(self.state("ins")["size"], [4096, 80])
        self.ask("resize", width=300, height=2 * size[1])
        self.click_view(10, 10)
        picked = self.state("picked")
        self.assertAlmostEqual(picked["x"], (size[0] / 2 + 10) * 300 / size[0], delta=1)
        self.assertAlmostEqual(picked["y"], (size[1] / 2 - 10) * 2, delta=2)

    def test_forgets_what_it_told_of_another_view(self):
        self.click_view(10, 10)
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
        self.click_view(10, 10)
        count = self.find("count")
        for name, expected in (("hide", " 1 hidden"), ("show", "parts · 1 selected"), ("isolate", " hidden")):
            self.click(name)
            self.wait_for(lambda expected=expected: expected in count.text)
        hidden = int(re.search(r"(\d+) hidden", count.text)[1])
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

    def test_finds_and_selects_in_the_tree(self):
        path = self.python().parts.paths[-1]
        name = path.rsplit("/", 1)[-1]
        self.find("search").send_keys(name)
        self.addCleanup(lambda: self.find("search").send_keys(Keys.CONTROL + "a" + Keys.NULL + Keys.DELETE))
        selector = f'.vi-row[data-path="{path}"]'
        row = self.wait_for(lambda: self.browser.find_elements(By.CSS_SELECTOR, selector))[0]
        row.click()
        self.wait_for(lambda: self.state("selection")["path"] == path)

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
        self.assertEqual(self.state("cut")["paths"], inspection.cut_parts())
        self.assertGreater(self.state("cut")["count"], 0)
        self.assert_shows(inspection)

    def test_measures_and_finds_clashes_as_python_does(self):
        self.click_view(10, 10)
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
        self.assertIn("<title>robot.glb", page)

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


class Revisions(unittest.TestCase):
    def test_of_the_tree_are_of_the_looks_that_it_tells(self):
        session = Session(str(MODEL), (64, 64), 0.0)
        self.addCleanup(session.close)
        path = session.inspection.parts.paths[0]
        session.inspection.hide([path])
        session.inspection.select([path])
        told = session.tree()
        self.assertEqual((told["revision"], told["looks"], told["selected"]), (1, [], []))
        session.note_change()
        told = session.tree(known=1)
        self.assertEqual((told["revision"], told["looks"], told["selected"]), (2, [[0, {"visible": False}]], [0]))


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


class Token(unittest.TestCase):
    def status(self, path, **headers):
        request = urllib.request.Request(SERVER.base + path, headers=headers)
        try:
            return urllib.request.urlopen(request, timeout=10).status
        except urllib.error.HTTPError as error:
            error.close()
            return error.code

    def test_is_needed_for_all(self):
        for path in ("", "index.html", "ws", "vitrine/tools.js", "?token=", "?token=guessed", "%2e%2e/etc/passwd"):
            with self.subTest(path):
                self.assertEqual(self.status(path), 401)
        self.assertEqual(self.status("index.html", Cookie="vitrine_1=x"), 401)

    def test_is_not_known_by_bytes_that_are_no_text(self):
        port = SERVER.base.rsplit(":", 1)[1].strip("/")
        self.assertEqual(self.status("index.html", Cookie=f"vitrine_{port}=\xff"), 401)
        self.assertEqual(self.status("?token=%ff"), 401)

    def test_opens_the_page_once_known(self):
        opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
        with opener.open(SERVER.address, timeout=10) as page:
            self.assertEqual(page.status, 200)
            self.assertNotIn("token", page.url)
        with opener.open(SERVER.base + "vitrine/tools.js", timeout=10) as script:
            self.assertEqual(script.headers["Referrer-Policy"], "no-referrer")

    def test_is_of_no_use_to_other_pages(self):
        path = SERVER.address[len(SERVER.base) :]
        self.assertEqual(self.status(path, Origin="http://example.com"), 403)


class End(unittest.TestCase):
    def test_comes_by_ctrl_c(self):
        server = Process(MODEL)
        self.assertRegex(server.address, r"^http://127\.0\.0\.1:\d+/\?token=[\w-]{40,}$")
        server.process.send_signal(signal.SIGINT)
        self.assertEqual(server.wait(), (0, ""))

    def test_comes_by_quit_in_the_page(self):
        server = Process(MODEL)
        self.addCleanup(server.end)
        browser = open_browser(1000, 700)
        self.addCleanup(browser.quit)
        browser.get(server.address)
        button = WebDriverWait(browser, 30, 0.02).until(lambda b: b.find_elements(By.ID, "vi-quit"))[0]
        browser.execute_script("arguments[0].click()", button)
        self.assertEqual(server.wait(), (0, ""))


class BadInput(unittest.TestCase):
    def test_is_told_in_one_line(self):
        for arguments, expected in (
            (["/nowhere.glb"], "there is no such file"),
            ([__file__], "is not of a kind that can be read"),
            ([MODEL, "--port", "70000"], "a port is a number from 0 to 65535"),
            ([MODEL, "--host", "198.51.100.1"], "address"),
        ):
            with self.subTest(expected):
                server = Process(*arguments)
                status, errors = server.wait()
                self.assertEqual((status, server.address), (2, ""))
                self.assertIn(expected, errors.strip().splitlines()[-1])


class Notebook(unittest.TestCase):
    def test_is_told_of_a_bad_file_and_leaves_no_server(self):
        async def opened():
            inspect("/nowhere.glb")
            while asyncio.all_tasks() - {asyncio.current_task()}:
                await asyncio.wait(asyncio.all_tasks() - {asyncio.current_task()})

        with contextlib.redirect_stderr(io.StringIO()) as told:
            asyncio.run(opened())
        self.assertIn("the inspector has ended: ", told.getvalue())
        self.assertIn("there is no such file", told.getvalue())
        self.assertEqual([name for name in AVAILABLE_SERVERS if name.startswith("vitrine-")], [])


if __name__ == "__main__":
    unittest.main()
