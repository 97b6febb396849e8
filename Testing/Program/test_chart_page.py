"""
The chart's page in a browser. Where VITRINE_SCREENSHOTS names a folder, pictures of the page are left there.
"""

import base64
import os
import pathlib
import socket
import tempfile
import unittest
import unittest.mock

from browser import open_browser, open_page, whole_page_png
from charts import METHODS, read_document, resumed_chart
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait


class Browser(unittest.TestCase):
    def test_opens_without_the_name_localhost(self):
        """This sees Selenium's look-ups of names. The driver's show only in a root without the name localhost."""
        find = socket.getaddrinfo

        def find_by_address(host, *arguments, **named):
            if host == "localhost":
                raise socket.gaierror(socket.EAI_NONAME, "Name or service not known")
            return find(host, *arguments, **named)

        with unittest.mock.patch("socket.getaddrinfo", find_by_address):
            browser = open_browser()
            self.addCleanup(browser.quit)
            page = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()), "page.html")
            page.write_text("<title>A page</title>", encoding="utf-8")
            open_page(browser, page)
            self.assertEqual(browser.title, "A page")


class ChartPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = resumed_chart().folder
        cls.document = read_document(cls.folder)
        cls.scene = cls.document["scenes"][1]
        cls.browser = open_browser()
        cls.addClassCleanup(cls.browser.quit)

    def setUp(self):
        self.browser.get_log("browser")
        open_page(self.browser, self.folder / "index.html")
        self.choose("scene", "1")

    def tearDown(self):
        self.assertEqual(self.browser.get_log("browser"), [])

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def find_all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def choose(self, name, value):
        Select(self.find(f"#{name}")).select_by_value(value)

    def places(self):
        """Of the marks, by method, in pixels: from the left, and from above."""
        return {
            mark.get_attribute("data-method"): (
                mark.find_element(By.TAG_NAME, "circle").rect["x"],
                mark.find_element(By.TAG_NAME, "circle").rect["y"],
            )
            for mark in self.find_all("#scatter .point")
        }

    def shown(self):
        return self.find("#detail h3").text

    def test_it_has_all_methods_and_sections(self):
        self.assertEqual(set(self.places()), set(METHODS))
        self.assertEqual(len(self.find_all("#growths article")), 4)
        self.assertIn(self.document["device"]["renderer"], self.find("#device").text)
        self.assertIn("Only their ratios mean anything", self.find("header").text)

    def test_marks_lie_as_their_values_for_every_choice(self):
        for cost in ("time", "memory", "passes"):
            for error in ("max", "rmse", "psnr", "ssim", "flip", "wrong_pixels"):
                with self.subTest(cost=cost, error=error):
                    self.choose("cost", cost)
                    self.choose("error", error)
                    self.check_places(cost, error)

    def check_places(self, cost, error):
        places = self.places()
        values = {point["method"]: point["values"] for point in self.scene["points"]}
        for one in METHODS:
            for other in METHODS:
                if values[one][cost] < values[other][cost]:
                    self.assertLess(places[one][0], places[other][0])
                if values[one][error] < values[other][error]:
                    self.assertGreater(places[one][1], places[other][1])

    def test_marks_move_with_the_choice(self):
        before = self.places()
        self.choose("cost", "memory")
        self.assertNotEqual(self.places(), before)

    def test_the_front_is_that_of_the_json(self):
        for cost, error in (("time", "max"), ("memory", "wrong_pixels"), ("passes", "flip")):
            with self.subTest(cost=cost, error=error):
                self.choose("cost", cost)
                self.choose("error", error)
                marked = {
                    mark.get_attribute("data-method")
                    for mark in self.find_all("#scatter .point.on-front")
                }
                front = self.scene["fronts"][cost][error]
                self.assertEqual(marked, set(front))
                path = self.find("#scatter .front").get_attribute("d")
                self.assertEqual(path.count("V"), len(front))

    def test_zero_has_a_lane_of_its_own(self):
        self.choose("error", "wrong_pixels")
        lane = self.find("#scatter .lane").rect["y"]
        places = self.places()
        for point in self.scene["points"]:
            is_zero = point["values"]["wrong_pixels"] == 0
            middle = places[point["method"]][1] + 12
            self.assertEqual(middle > lane, is_zero, point["method"])
        self.assertIn("0", [tick.text for tick in self.find_all("#scatter .tick")])

    def test_pointing_shows_figures_and_pictures(self):
        for method in METHODS:
            mark = self.find(f'#scatter .point[data-method="{method}"]')
            ActionChains(self.browser).move_to_element(mark).perform()
            self.assertEqual(self.shown(), method)
            row = next(
                row
                for row in self.document["results"]
                if row["part"] == "scenes" and row["step"] == 1 and row["method"] == method
            )
            self.assertIn(f"{row['fragments']:,}", self.find("#detail dl").text)
            self.check_difference(row)

    def check_difference(self, row):
        canvas = self.find("#detail canvas")
        WebDriverWait(self.browser, 60).until(lambda _: canvas.get_attribute("data-largest"))
        largest = int(canvas.get_attribute("data-largest"))
        self.assertLessEqual(largest, 255 * row["error"]["max"] + 1)
        if row["error"]["wrong_pixels"] == 0:
            self.assertLessEqual(largest, 1)
        else:
            self.assertGreater(largest, 1)
        natural = self.browser.execute_script(
            "return document.querySelector('#detail img').naturalWidth"
        )
        self.assertEqual(natural, row["width"])

    def test_keys_reach_every_mark(self):
        reached = []
        self.find("#cost").send_keys(Keys.TAB)
        for _ in METHODS:
            focused = self.browser.switch_to.active_element
            reached.append(focused.get_attribute("data-method"))
            self.assertEqual(self.shown(), reached[-1])
            focused.send_keys(Keys.TAB)
        self.assertEqual(set(reached), set(METHODS))

    def test_the_slider_uncovers_the_left_picture(self):
        self.assertEqual(Select(self.find("#left")).first_selected_option.text, "vtk-oit")
        self.assertEqual(Select(self.find("#right")).first_selected_option.text, "truth")
        Select(self.find("#left")).select_by_visible_text("linked-list")
        slider = self.find("#slider input")
        for key, clip in ((Keys.HOME, "100%"), (Keys.END, "0%")):
            slider.send_keys(key)
            style = self.find("#slider img:nth-child(2)").value_of_css_property("clip-path")
            self.assertEqual(style.split()[1], clip)
        self.assertIn("linked-list", self.find("#slider img:nth-child(2)").get_attribute("alt"))

    def test_growth_shows_the_fits_of_the_json(self):
        tables = self.find_all("#growths article table")
        for growth, table in zip(self.document["growth"], tables):
            for line in growth["lines"]:
                if line["fit"]:
                    self.assertIn(f"{line['fit']['exponent']:.2f}", table.text)

    def test_every_cell_shows_how_its_method_fails(self):
        cells = self.document["failures"]
        buttons = self.find_all("#cells button")
        self.assertEqual(len(buttons), len(cells))
        labels = {button.get_attribute("aria-label"): button for button in buttons}
        for cell in (cells[0], cells[-1]):
            name = f"{cell['method']} on {cell['scene']}"
            labels[f"{name}: {cell['verdict']}"].click()
            self.assertIn(name, self.find("#cell h3").text)
            self.assertIn(cell["verdict"], self.find("#cell dl").text)

    def focused(self):
        return self.browser.switch_to.active_element

    def test_the_tab_key_reaches_one_cell_and_arrows_the_others(self):
        buttons = self.find_all("#cells button")
        self.assertEqual([button.get_attribute("tabindex") for button in buttons].count("0"), 1)
        labels = [button.get_attribute("aria-label") for button in buttons]
        columns = len(METHODS)
        buttons[0].click()
        for key, index in (
            (Keys.ARROW_RIGHT, 1),
            (Keys.ARROW_DOWN, 1 + columns),
            (Keys.ARROW_LEFT, columns),
            (Keys.ARROW_LEFT, columns),
            (Keys.ARROW_UP, 0),
            (Keys.ARROW_UP, 0),
        ):
            self.focused().send_keys(key)
            self.assertEqual(self.focused().get_attribute("aria-label"), labels[index])
            cell = self.document["failures"][index]
            self.assertEqual(self.find("#cell h3").text, f"{cell['method']} on {cell['scene']}")
        self.assertEqual([button.get_attribute("tabindex") for button in buttons].count("0"), 1)

    def test_a_cell_says_how_it_is_drawn(self):
        scenes = {scene["name"]: scene for scene in self.document["settings"]["failures"]["scenes"]}
        for cell in self.document["failures"]:
            self.find(
                f'#cells [data-scene="{cell["scene"]}"][data-method="{cell["method"]}"]'
            ).click()
            text = self.find("#cell dl").text
            scene = scenes[cell["scene"]]
            self.assertIn(f"{scene['input']} --size {cell['width']}x{cell['height']}", text)
            self.assertEqual("times the zoom" in text, scene["zoom_before"] != 1)
            for fact in ("error of the picture", "drawn again", "in other orders", "turned by"):
                self.assertEqual(fact in text, "skipped" not in cell)
            if "skipped" not in cell:
                of_picture = "which is shown" in text
                self.assertEqual(of_picture, cell["worst_frames"] == "first")

    def test_cells_say_how_many_frames_they_are_judged_by(self):
        settings = self.document["settings"]["failures"]
        text = self.find("#frames").text
        for words in (
            f"the same {settings['repetitions']} times",
            f"{settings['orders']} orders",
            f"{settings['shifts']} steps of 1/100 pixel",
            f"{settings['turns']} of a degree",
            "no other window",
        ):
            self.assertIn(words, text)

    def test_a_mark_keeps_the_focus_when_the_window_changes(self):
        self.find("#cost").send_keys(Keys.TAB)
        method = self.focused().get_attribute("data-method")
        self.browser.execute_script("drawn = document.querySelector('#scatter svg')")
        width = self.browser.execute_script("return window.innerWidth")
        self.addCleanup(self.resize, width)
        self.resize(width - 100)
        WebDriverWait(self.browser, 60).until(
            lambda browser: browser.execute_script("return !drawn.isConnected")
        )
        self.assertEqual(self.focused().get_attribute("data-method"), method)

    def resize(self, width):
        self.browser.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": 1000, "deviceScaleFactor": 1, "mobile": False},
        )

    def test_the_last_choice_of_strength_is_seen(self):
        self.browser.execute_script("""
            const choice = document.querySelector("#detail select");
            for (const gain of [1, 64, 4]) {
              choice.value = gain;
              choice.dispatchEvent(new Event("change"));
            }
            """)
        canvas = self.find("#detail canvas")
        WebDriverWait(self.browser, 60).until(lambda _: canvas.get_attribute("data-largest"))
        WebDriverWait(self.browser, 60).until(lambda _: canvas.get_attribute("data-gain") == "4")


class ChartPageLooks(unittest.TestCase):
    """At other widths and in the dark."""

    def look(self, name, **window):
        browser = open_browser(**window)
        self.addCleanup(browser.quit)
        open_page(browser, resumed_chart().folder / "index.html")
        if "VITRINE_SCREENSHOTS" in os.environ:
            target = pathlib.Path(os.environ["VITRINE_SCREENSHOTS"]) / f"chart-{name}.png"
            target.write_bytes(base64.b64decode(whole_page_png(browser)))
        return browser

    def test_nothing_is_wider_than_the_window(self):
        for width in (1280, 390):
            browser = self.look(str(width), width=width, height=900)
            self.assertEqual(
                browser.execute_script("return document.documentElement.scrollWidth"), width
            )

    def test_the_dark_has_light_text(self):
        browser = self.look("dark", is_dark=True)
        color = browser.execute_script("return getComputedStyle(document.body).color")
        light = [int(part) for part in color.strip("rgb()").split(",")]
        self.assertGreater(min(light), 200)


if __name__ == "__main__":
    unittest.main()
