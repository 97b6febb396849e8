"""Figures of explorable pictures: bytes of a page, time of a toggle, and how far random looks are from frames.

    python3 Testing/Python/explore_figures.py FILE... [--sets 20] [--size 1280x720] [--seed 52]

Each model is written as a page, which headless Chromium opens from disk. A set gives each part at random another
visibility, opacity and colour. The page composes it, its canvas is read back, and compared with a frame that Vitrine
draws with the same looks. "Toggle" hides a part and shows it again, as the page measures itself. Needs selenium. Where
OpenEXR and oiiotool are installed, the view is also written as a deep picture, flattened, and compared with a frame.
"""

import argparse
import base64
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

try:
    import OpenEXR
except ImportError:
    OpenEXR = None

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Program"))
sys.path.append("/usr/lib/python3/dist-packages")  # Debian's selenium beside PyPI's VTK
from browser import open_browser, open_page  # noqa: E402
from vitrine.explore import _fragments, export_explorable  # noqa: E402
from vitrine.explore._exr import write_exr  # noqa: E402
from vitrine.inspector import Inspection, _output  # noqa: E402

COMPOSE = """
const looks = arguments[0];
page.looks = page.own.map((own, part) => {
  const [visible, opacity, color] = looks[page.data.parts[part][0]];
  return { visible, opacity, color: rgbOf(color) };
});
page.draw();
const { width, height } = page.composer.view;
const pixels = byId("picture").getContext("2d").getImageData(0, 0, width, height).data;
let text = "";
for (let at = 0; at < pixels.length; at += 32768) {
  text += String.fromCharCode(...pixels.subarray(at, at + 32768));
}
return btoa(text);
"""
TOGGLE = """
const times = [];
page.act("reset");
for (let part = 0; part < page.own.length && times.length < 20; part += Math.ceil(page.own.length / 10)) {
  for (const visible of [false, true]) {
    page.change([part], { visible });
    times.push(page.milliseconds);
  }
}
return times;
"""


def random_looks(own, random):
    """For each part whether it is visible, its opacity, and its colour; a fifth is opaque, half keep their colours."""
    looks = {}
    for path in own:
        opacity = 1.0 if random.random() < 0.2 else round(float(random.random()), 2)
        color = own[path]["color"] if random.random() < 0.5 else "#" + random.bytes(3).hex()
        looks[path] = [bool(random.random() < 0.8), opacity, color]
    return looks


def deep_figures(renderer, path):
    """The bytes of a deep picture, and by how much it flattens to another picture than a frame, of 255."""
    if OpenEXR is None or shutil.which("oiiotool") is None:
        return "-", "-"
    renderer.SetBackground(0, 0, 0)
    window = renderer.GetRenderWindow()
    window.Render()
    frame = _output.read_pixels(window).astype(float)
    write_exr(path, _fragments.take(renderer), renderer)
    flat = path.with_name("flat.exr")
    subprocess.run(["oiiotool", str(path), "--flatten", "-o", str(flat)], check=True)
    channels = OpenEXR.File(str(flat), separate_channels=True).channels()
    colors = 255 * np.stack([channels[name].pixels for name in "RGB"], axis=-1)
    return f"{path.stat().st_size / 1e6:.1f}", f"{np.abs(colors.clip(0, 255) - frame).max():.2f}"


class Model:
    """A model in an inspector without a page, whose parts take looks."""

    def __init__(self, path, size):
        self.inspection = Inspection([path], size=size)
        self.inspection.draw()
        self.table = _fragments.table_of(self.inspection.renderer)
        self.own = {path: self.table.shown_look(path) for path in self.table.paths}

    def frame(self, looks):
        """RGB of Vitrine with these looks, rows from the top."""
        for path, (visible, opacity, color) in looks.items():
            look = {"visible": visible, "opacity": opacity}
            if color != self.own[path]["color"]:
                look["color"] = color
            self.table.set_look(path, self.table.given_look(path), look)
        # Without its draw(), which fits the near and the far plane to the visible parts: depths round otherwise then.
        self.inspection.window.Render()
        return _output.read_pixels(self.inspection.window)


def measure(path, options, browser):
    width, height = (int(side) for side in options.size.split("x"))
    model = Model(path, (width, height))
    random = np.random.default_rng(options.seed)
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "page.html"
        start = time.process_time()
        export_explorable(model.inspection.renderer, page)
        seconds = time.process_time() - start
        size = page.stat().st_size
        fragments = len(_fragments.take(model.inspection.renderer))
        start = time.perf_counter()
        open_page(browser, page)
        while browser.execute_script("return document.body.dataset.ready") is None:
            time.sleep(0.05)
        opened = time.perf_counter() - start
        toggles = browser.execute_script(TOGGLE)
        worst, beyond = 0, 0
        for _ in range(options.sets):
            looks = random_looks(model.own, random)
            pixels = np.frombuffer(base64.b64decode(browser.execute_script(COMPOSE, looks)), np.uint8)
            shown = pixels.reshape(height, width, 4)[..., :3].astype(int)
            off = np.abs(shown - model.frame(looks)).max(axis=2)
            worst, beyond = max(worst, int(off.max())), beyond + int((off > 1).sum())
            if off.max() > 1 and options.tell:
                tell(model, looks, off)
        model.frame({path: [True, own["opacity"], own["color"]] for path, own in model.own.items()})
        deep = deep_figures(model.inspection.renderer, pathlib.Path(folder) / "deep.exr")
    print(
        f"| {pathlib.Path(path).stem} | {len(model.own)} | {fragments} | {size / 1e6:.2f} "
        f"| {8 * size / fragments:.1f} | {seconds:.1f} | {opened:.1f} "
        f"| {statistics.median(toggles):.0f}, {max(toggles):.0f} | {worst} | {beyond} | {' | '.join(deep)} |",
        flush=True,
    )


def tell(model, looks, off):
    """What lies under the pixel that is most off."""
    y, x = np.unravel_index(off.argmax(), off.shape)
    print(f"pixel {x}, {y} from the top is off by {off[y, x]}; {int((off > 1).sum())} pixels are by more than 1")
    for layer in model.inspection.layers(int(x), int(off.shape[0] - 1 - y)):
        print("   ", {key: layer[key] for key in ("path", "opacity", "color", "distance")}, looks.get(layer["path"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--sets", type=int, default=20)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--seed", type=int, default=52)
    parser.add_argument("--tell", action="store_true", help="tell the layers of pixels that are off by more than 1/255")
    options = parser.parse_args()
    print("| model | parts | fragments | MB | bits a fragment | s of CPU to write | s to open "
          "| toggle ms, median, most | most off, of 255 | pixels off by more than 1 "
          "| MB of deep EXR | flattened, most off |")
    print("|" + " --- |" * 12)
    browser = open_browser()
    try:
        for path in options.files:
            measure(path, options, browser)
    finally:
        browser.quit()


if __name__ == "__main__":
    main()
