"""The inspector's page of a real server, as tests drive it in a browser.

VITRINE_INSPECT_MODEL names another model than the robot, and VITRINE_SCREENSHOTS a folder for pictures of the page.
"""

import base64
import io
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import unittest

import numpy
from PIL import Image
from selenium.common.exceptions import StaleElementReferenceException
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

from vitrine.inspector import Inspection

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing/Program"))

from browser import open_browser  # noqa: E402

MODEL = pathlib.Path(os.environ.get("VITRINE_INSPECT_MODEL", ROOT / "Examples/models/robot.glb"))
PATIENCE = 300 if "VITRINE_INSPECT_MODEL" in os.environ else 30  # seconds
# The view, while its picture is the exact one of the last change. A script that draws on goes by one answer, because
# a smaller picture may follow before the next script runs.
EXACT_VIEW = """[document.getElementById("vi-view")].find((view) =>
    view?.dataset.exact === "true" && view.dataset.revision === String(trame.state.get("revision")))"""
REQUEST = """
const done = arguments[arguments.length - 1];
const text = (bytes) => btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
const told = (result) => (result && result.data ? { ...result, data: text(result.data) } : result);
const request = window.trame.utils.vitrine.request(...arguments[0]);
request.then((result) => done(told(result)), (error) => done(String(error)));
"""


def is_closed(inspection, x, y):
    """Whether what a pixel shows has a thickness."""
    try:
        return inspection.measure("thickness", x=x, y=y)["thickness"] > 0
    except ValueError:
        return False


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


def started(test, *arguments):
    """A server that is ended with a test's class, and must end well."""

    def end():
        status, errors = server.end()
        assert (status, errors) == (0, ""), f"the server ended with {status}: {errors}"

    server = Process(*arguments)
    test.addClassCleanup(end)
    return server


class PageCase(unittest.TestCase):
    """A page that is opened once, and what Python says of the same state. Each test begins with the first view.

    Attributes:
        spot: where a part is in the first view, in pixels of the page to the right of the middle and below it.
        part: the path of that part.
    """

    @classmethod
    def setUpClass(cls):
        cls.server = started(cls, MODEL)
        cls.browser = open_browser(1280, 800)
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.set_script_timeout(PATIENCE)
        cls.browser.get(cls.server.address)
        cls.wait_for(cls.is_exact)
        cls.first_camera = cls.state("ins")["camera"]
        cls.spot, cls.part = cls.place_of_a_part()

    def setUp(self):
        self.ask("apply", state={"vitrine": 1, "camera": self.first_camera})

    def tearDown(self):
        folder = os.environ.get("VITRINE_SCREENSHOTS")
        if folder:
            self.browser.save_screenshot(f"{folder}/inspector-{MODEL.stem}-{self._testMethodName}.png")
        errors = [line for line in self.browser.get_log("browser") if line["level"] not in ("INFO", "DEBUG")]
        self.assertEqual(errors, [])

    @classmethod
    def wait_for(cls, condition):
        """Wait until a condition holds. It does not while the page replaces an element that it asks about."""
        wait = WebDriverWait(cls.browser, PATIENCE, 0.02, ignored_exceptions=[StaleElementReferenceException])
        return wait.until(lambda _: condition())

    @classmethod
    def find(cls, name):
        return cls.browser.find_element(By.ID, f"vi-{name}")

    @classmethod
    def state(cls, name):
        return cls.browser.execute_script("return JSON.parse(JSON.stringify(trame.state.get(arguments[0])))", name)

    @classmethod
    def place_of_a_part(cls):
        """A place near the middle where a part shows, and not only at its edge, and the path of the part."""
        width, height = size = cls.state("ins")["size"]
        inspection = Inspection(str(MODEL), size=size)
        cls.addClassCleanup(inspection.close)
        inspection.set_camera(cls.first_camera)
        steps = range(-height // 3, height // 3, 8)
        for across, down in sorted(((x, y) for x in steps for y in steps), key=lambda place: math.hypot(*place)):
            x, y = width // 2 + across, height - 1 - (height // 2 + down)
            paths = {inspection.pick(x + dx, y + dy) for dx, dy in ((0, 0), (2, 2), (-2, -2), (2, -2), (-2, 2))}
            if len(paths) == 1 and None not in paths and is_closed(inspection, x, y):
                return (across, down), paths.pop()
        raise AssertionError(f"{MODEL} shows no part near the middle")

    @classmethod
    def is_exact(cls):
        """Whether the picture is the exact one of the last change."""
        return cls.browser.execute_script(f"return Boolean({EXACT_VIEW})")

    def ask(self, name, **values):
        result = self.browser.execute_async_script(REQUEST, [name, values])
        self.wait_for(self.is_exact)
        return result

    def click(self, name):
        self.browser.execute_script("arguments[0].click()", self.find(name))

    def click_part(self, *keys):
        """Click where self.part shows in the first view."""
        across, down = self.spot
        actions = ActionChains(self.browser)
        for key in keys:
            actions.key_down(key)
        actions.move_to_element_with_offset(self.find("view"), across, down).click()
        for key in keys:
            actions.key_up(key)
        self.browser.execute_script("window.pickedBefore = trame.state.get('picked')")
        actions.perform()
        is_told = "return trame.state.get('picked') !== window.pickedBefore"
        self.wait_for(lambda: self.browser.execute_script(is_told))
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

    def saved(self):
        """The page's state, with the absolute paths that Inspection.state() has."""
        state = json.loads(base64.b64decode(self.ask("save_state")["data"]))
        return {**state, "files": [{"path": str(MODEL)}]}

    def python(self):
        """An Inspection of the page's state."""
        state = self.saved()
        inspection = Inspection(str(MODEL), size=state["size"])
        self.addCleanup(inspection.close)
        inspection.apply(state)
        return inspection

    def assert_shows(self, inspection):
        """The page shows the pixels of an inspection."""
        script = f"return {EXACT_VIEW}?.toDataURL('image/png')"
        data = base64.b64decode(self.wait_for(lambda: self.browser.execute_script(script)).split(",")[1])
        shown = numpy.asarray(Image.open(io.BytesIO(data)).convert("RGB"))
        numpy.testing.assert_array_equal(shown, inspection.picture())
