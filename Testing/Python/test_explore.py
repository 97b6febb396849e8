"""Explorable pictures in a browser: what the page decodes, composes, tells and does, against Vitrine's frames."""

import base64
import contextlib
import io
import pathlib
import sys
import unittest

import numpy
from machine import PATHS, SIZE, Files
from scenes import actor_of, drawn, pixels, plate, plates_renderer
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer

import vitrine
from vitrine.explore import _fragments, export_explorable
from vitrine.explore.__main__ import main

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "Program"))
try:
    from browser import open_browser, open_page
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select, WebDriverWait
except ImportError:
    open_browser = None

LID, _, GEAR, _, _ = PATHS
RED, GREEN, BLUE = (1, 0, 0), (0, 1, 0), (0, 0, 1)
HOSTILE = """</script><script>document.title="broken"</script> & "quotes' <!-- Gehäuse ✓ {{data}}"""
PICTURE = """
const { width, height } = page.composer.view;
const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
copy.drawImage(byId("picture"), 0, 0);
return btoa(String.fromCharCode(...copy.getImageData(0, 0, width, height).data));
"""
LOOKS = """
page.looks = page.own.map((own, part) => {
  const { visible, opacity, color } = { ...own, ...arguments[0][page.data.parts[part][0]] };
  return { visible, opacity, color: typeof color === "string" ? rgbOf(color) : color };
});
page.draw();
"""
VIEW = """
const view = page.composer.view, list = (values) => (values ? Array.from(values) : null);
return { black: view.black.map(list), white: view.white.map(list), middle: view.middle && view.middle.map(list),
  offsets: list(view.offsets), shades: list(view.shades), tied: list(view.tied), depths: list(view.depths) };
"""


@unittest.skipIf(open_browser is None, "selenium is not installed")
class Explore(Files):
    @classmethod
    def setUpClass(cls):
        cls.browser = open_browser()
        cls.addClassCleanup(cls.browser.quit)

    def setUp(self):
        super().setUp()
        self.browser.get_log("browser")

    def tearDown(self):
        self.assertEqual(self.browser.get_log("browser"), [])

    def drawn(self, renderer):
        vitrine.see_through(renderer)
        self.window = drawn(renderer, size=SIZE)  # renderers do not keep theirs
        return renderer

    def open(self, renderer, **options):
        """Write a page of a renderer and open it, with the network off."""
        path = self.folder / "page.html"
        export_explorable(renderer, path, **options)
        open_page(self.browser, path)
        WebDriverWait(self.browser, 30).until(lambda _: self.run_script("return document.body.dataset.ready"))

    def run_script(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def shown(self):
        """The picture of the page, RGB, rows from the top."""
        data = base64.b64decode(self.run_script(PICTURE))
        return numpy.frombuffer(data, numpy.uint8).reshape(*SIZE[::-1], 4)[..., :3].astype(int)

    def frame(self):
        """Vitrine's picture, likewise."""
        self.window.Render()
        return pixels(self.window)[::-1, :, :3].astype(int)

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def click(self, x, y, key=None):
        """Click a pixel of the picture, counted from its upper left corner."""
        picture = self.find("#picture")
        box = picture.rect
        place = [
            round(((at + 0.5) / side - 0.5) * box[name]) for at, side, name in zip((x, y), SIZE, ("width", "height"))
        ]
        actions = ActionChains(self.browser).move_to_element_with_offset(picture, *place)
        (actions.key_down(key).click().key_up(key) if key else actions.click()).perform()

    def selected(self):
        return set(self.run_script("return [...page.selected].map((part) => page.data.parts[part][0])"))

    def layers(self):
        return [each.text.split("\n")[0] for each in self.browser.find_elements(By.CSS_SELECTOR, "#list li")]

    def assert_shows_frames_of_random_looks(self, renderer, count):
        """The page's pictures are within 1/255 of frames with the same looks."""
        random = numpy.random.default_rng(52)
        table = _fragments.table_of(renderer)
        for number in range(count):
            looks = {
                path: {
                    "visible": bool(random.random() < 0.8),
                    "opacity": 1.0 if random.random() < 0.25 else round(float(random.random()), 2),
                    "color": "#" + random.bytes(3).hex(),
                }
                for path in table.paths
            }
            self.run_script(LOOKS, looks)
            for path, look in looks.items():
                table.set_look(path, table.given_look(path), look)
            with self.subTest(number=number):
                numpy.testing.assert_allclose(self.shown(), self.frame(), atol=1)

    def test_shows_what_a_pen_would_compute(self):
        renderer = self.drawn(plates_renderer(plate(1, RED, 0.5), plate(0, GREEN, 1.0), plate(-1, BLUE, 0.5)))
        self.open(renderer)
        for looks, color in (
            ({}, (127.5, 127.5, 0)),
            ({"/actor 0": {"visible": False}}, (0, 255, 0)),
            ({"/actor 1": {"opacity": 0.5}}, (127.5, 63.75, 31.875)),
            ({"/actor 1": {"visible": False}, "/actor 2": {"opacity": 1.0, "color": "#00ffff"}}, (127.5, 127.5, 127.5)),
            ({f"/actor {number}": {"visible": False} for number in range(3)}, (0, 0, 0)),
        ):
            self.run_script(LOOKS, looks)
            numpy.testing.assert_allclose(self.shown(), numpy.broadcast_to(color, (*SIZE, 3)), atol=0.51)

    def test_random_looks_are_within_a_step_of_frames(self):
        renderer = self.view()
        renderer.GetActiveCamera().Azimuth(35)
        renderer.GetActiveCamera().Elevation(20)
        renderer.GetActiveCamera().ParallelProjectionOff()
        renderer.ResetCamera()
        self.open(self.drawn(renderer))
        self.assert_shows_frames_of_random_looks(renderer, 10)

    def test_actors_and_equal_depths_too(self):
        colors = (RED, GREEN, BLUE, RED)
        renderer = self.drawn(plates_renderer(*(plate(0, color, 0.5) for color in colors)))
        self.open(renderer)
        numpy.testing.assert_allclose(self.shown(), self.frame(), atol=1)
        self.assert_shows_frames_of_random_looks(renderer, 10)

    def test_metal_and_highlights_too(self):
        """Light of metal is no straight line in the part's colour, and highlights are brighter than pictures can be."""
        balls = []
        for x in (-0.5, 0.5):
            ball = vtkSphereSource()
            ball.SetRadius(0.45)
            ball.SetCenter(x, 0, 0)
            balls.append(actor_of(ball))
        metal, paint = (ball.GetProperty() for ball in balls)
        metal.SetInterpolationToPBR()
        metal.SetMetallic(0.8)
        metal.SetRoughness(0.3)
        paint.SetSpecular(0.7)
        paint.SetSpecularPower(5)
        renderer = self.drawn(plates_renderer(plate(-1, BLUE, 1.0), *balls))
        taken = _fragments.take(renderer)
        self.assertEqual([shade.model for shade in taken.shades], [1, 4, 1])
        self.assertGreater(taken.white.max(), _fragments.STEPS)
        self.open(renderer)
        self.assert_shows_frames_of_random_looks(renderer, 8)

    def test_decodes_what_was_packed(self):
        renderer = self.drawn(self.view())
        self.open(renderer, depths=True)
        fragments = _fragments.take(renderer)
        view = self.run_script(VIEW)
        self.assertEqual(view["offsets"], [0, *numpy.cumsum(fragments.counts).tolist()])
        self.assertEqual(view["shades"], fragments.shade.tolist())
        self.assertEqual(view["tied"], fragments.is_tied.astype(int).tolist())
        self.assertEqual(view["depths"], fragments.depth.tolist())
        for name in ("black", "white", "middle"):
            light = getattr(fragments, name)
            self.assertEqual(light is None, view[name] is None)
            for channel, values in enumerate(view[name] or ()):
                self.assertEqual(values, light[:, channel].tolist())

    def test_clicks_pick_and_tell_all_layers(self):
        self.machine["lid"].opacity = 0.25
        renderer = self.drawn(self.view())
        self.open(renderer)
        self.click(20, 20)
        self.assertEqual(self.selected(), {LID})
        expected = [layer.name for layer in vitrine.layers_at(renderer, 20, SIZE[1] - 1 - 20)]
        self.assertEqual(self.layers(), expected)
        self.click(20, 60, Keys.CONTROL)
        self.assertEqual(self.selected(), {LID, GEAR})
        self.click(1, 1)
        self.assertEqual(self.selected(), set())

    def test_gestures_change_parts_and_are_undone(self):
        self.open(self.drawn(self.view()))
        states = [self.shown()]
        self.click(20, 20)
        for name, looks in (("hide", {"visible": False}), ("show", {"visible": True}), ("ghost", {"opacity": 0.15})):
            self.find(f"[data-act={name}]").click()
            now = dict(self.run_script("return page.looks[[...page.selected][0]]"))
            self.assertEqual({key: round(now[key], 4) for key in looks}, looks)
            states.append(self.shown())
        self.find("[data-act=isolate]").click()
        self.assertEqual(self.run_script("return page.looks.filter((look) => look.visible).length"), 1)
        for state in reversed(states):
            self.find("#undo").click()
            numpy.testing.assert_array_equal(self.shown(), state)
        self.assertFalse(self.find("#undo").is_enabled())
        self.find("#redo").click()
        numpy.testing.assert_array_equal(self.shown(), states[1])

    def test_tree_is_searched(self):
        self.open(self.drawn(self.view()))
        self.find("#search").send_keys("GEAR-")
        names = [each.text for each in self.browser.find_elements(By.CSS_SELECTOR, "#rows .name")]
        self.assertEqual(sorted(names), ["gear-1", "gear-2"])

    def test_has_several_views(self):
        renderer = self.drawn(self.view())
        cameras = {}
        for name, degrees in (("front", 0), ("side", 60)):
            cameras[name] = vtkRenderer().MakeCamera()
            cameras[name].DeepCopy(renderer.GetActiveCamera())
            cameras[name].Azimuth(degrees)
        self.open(renderer, views=cameras)
        Select(self.find("#views")).select_by_visible_text("side")
        WebDriverWait(self.browser, 30).until(lambda _: self.run_script("return page.composers.size") == 2)
        renderer.SetActiveCamera(cameras["side"])
        renderer.ResetCameraClippingRange()
        numpy.testing.assert_allclose(self.shown(), self.frame(), atol=1)

    def test_names_and_titles_cannot_leave_their_place(self):
        renderer = plates_renderer(plate(0, RED, 0.5))
        actor = renderer.GetViewProps().GetLastProp()
        actor.name = HOSTILE  # as PyVista does
        self.open(self.drawn(renderer), title=HOSTILE)
        self.assertEqual(self.browser.title, HOSTILE)
        self.assertEqual(self.find("#title").text, HOSTILE)
        self.click(40, 40)
        self.assertEqual(self.find("#chosen").text, "/" + HOSTILE.replace("/", "_"))

    def test_refuses(self):
        renderer = self.drawn(self.view())
        path = self.folder / "page.html"
        with self.assertRaisesRegex(TypeError, "vtkRenderer"):
            export_explorable("machine.glb", path)
        with self.assertRaisesRegex(ValueError, "views is empty"):
            export_explorable(renderer, path, views={})
        with self.assertRaises(FileNotFoundError):
            export_explorable(renderer, self.folder / "none" / "page.html")
        self.machine["*"].visible = False
        with self.assertRaisesRegex(ValueError, "no part is visible"):
            export_explorable(renderer, path)
        self.assertFalse(path.exists())


class Command(Files):
    def told(self, *arguments):
        """The status of `vitrine explore`, and what it tells on stderr."""
        with contextlib.redirect_stderr(io.StringIO()) as told:
            try:
                status = main([str(argument) for argument in arguments])
            except SystemExit as left:  # argparse
                status = left.code
        return status, told.getvalue()

    def test_writes_one_file(self):
        page = self.folder / "page.html"
        status, told = self.told(self.file, "-o", page, "--size", "80x60", "--views", "turntable,2")
        self.assertEqual((status, told), (0, ""))
        self.assertEqual({file.name for file in self.folder.iterdir()}, {"page.html", self.file.name})
        text = page.read_text(encoding="utf-8")
        self.assertNotRegex(text, "https?://(?!www.w3.org)")
        self.assertLess(len(text), 60000)

    def test_refuses_with_one_line_and_writes_nothing(self):
        page = self.folder / "page.html"
        broken = self.folder / "broken.json"
        broken.write_text("{", encoding="utf-8")
        before = set(self.folder.iterdir())
        for arguments in (
            (self.file, "-o", self.folder / "page.png"),
            (self.folder / "none.glb", "-o", page),
            (broken, "-o", page),
            (broken, self.file, "-o", page),
            (self.file, "-o", self.folder / "none" / "page.html"),
            (self.file, "-o", page, "--size", "0x10"),
            (self.file, "-o", page, "--size", "huge"),
            (self.file, "-o", page, "--views", "turntable,1"),
            (self.file, "-o", page, "--views", "all"),
            (self.file, "-o", page, "--exr", self.folder / "deep.png"),
            (self.file, "-o", page, "--exr", self.folder / "deep.exr", "--views", "standard"),
            (self.file,),
        ):
            with self.subTest(arguments=arguments[1:]):
                status, told = self.told(*arguments)
                self.assertEqual(status, 2)
                self.assertIn("vitrine explore: ", told)
                self.assertNotIn("Traceback", told)
                self.assertEqual(set(self.folder.iterdir()), before)


if __name__ == "__main__":
    unittest.main()
