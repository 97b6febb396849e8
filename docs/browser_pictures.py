"""Pictures of pages in headless Chromium: the inspector, and an explorable picture. make-pictures calls these."""

import json
import pathlib
import subprocess
import sys

from selenium.webdriver.support.ui import WebDriverWait

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "Testing/Program"))

from browser import open_browser  # noqa: E402

ROBOT = ROOT / "Examples/models/robot.glb"
SHELLS = ("body_front", "body_back", "body_middle_bottom", "body_middle_top", "trunk_bottom", "trunk_top")
PATH = "/open_duck_mini_v2/trunk_assembly/"
STATE = {
    "vitrine": 1,
    "files": [{"path": str(ROBOT)}],
    "parts": {
        **{PATH + name: {"opacity": 0.15} for name in SHELLS},
        PATH + "board": {"color": "#2e8b57"},
    },
    "background": "#f4f4f6",
    "lights": "studio",
}
IS_EXACT = """
const view = document.getElementById("vi-view");
return view && view.dataset.exact === "true" && view.dataset.revision === String(trame.state.get("revision"));
"""
CLICK = """
const view = document.querySelector(arguments[0]).getBoundingClientRect();
const at = { clientX: view.left + arguments[1] * view.width, clientY: view.top + arguments[2] * view.height };
"""


def explorable(maker, path):
    page, state = maker.folder / "robot.html", maker.folder / "state.json"
    state.write_text(json.dumps({**STATE, "size": [720, 560]}))
    maker.run_pyvista("-m", "vitrine", "explore", state, "-o", page)
    browser = open_browser(1280, 660)
    try:
        browser.get(page.as_uri())
        wait_for(browser, "return document.body.dataset.ready === 'yes'")
        browser.execute_script(CLICK + "page.pick(at);", "#picture", 0.42, 0.6)
        browser.save_screenshot(str(path))
    finally:
        browser.quit()


def inspector(maker, path):
    state = maker.folder / "state.json"
    state.write_text(json.dumps({**STATE, "sections": [{"normal": [0, 0, -1], "origin": [0, 0, 0.02]}]}))
    command = [maker.pyvista, "-m", "vitrine", "inspect", state, "--no-browser"]
    environment = {name: value for name, value in maker.environment.items() if name != "PYTHONPATH"}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as server:
        browser = open_browser(1280, 760)
        try:
            browser.get(server.stdout.readline().strip())
            wait_for(browser, IS_EXACT)
            events = "for (const kind of ['pointerdown', 'pointerup', 'click']) document.querySelector(arguments[0])"
            options = "{ ...at, bubbles: true, pointerId: 1, button: 0, isPrimary: true }"
            script = f"{CLICK}{events}.dispatchEvent(new PointerEvent(kind, {options}));"
            browser.execute_script(script, "#vi-view", 0.46, 0.58)
            wait_for(browser, "return trame.state.get('picked') !== null")
            wait_for(browser, IS_EXACT)
            browser.save_screenshot(str(path))
        finally:
            browser.quit()
            server.terminate()


def wait_for(browser, script):
    WebDriverWait(browser, 60).until(lambda _: browser.execute_script(script))
