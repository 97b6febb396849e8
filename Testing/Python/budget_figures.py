"""Figures of error budgets: are they kept, are bounds true and tight, and what does the choice cost over the best one?

    python3 Testing/Python/budget_figures.py FILE|demo... [--views 20] [--path jumps|turn] [--budgets 0.6,1,2,4,8]
        [--size 256x256] [--opacity 0.3] [--frames 3] [--rounds 2] [--seed 53] [--methods M,...]

With --path jumps each view looks from a random direction at a random place, near or far. With --path turn only the
first one does, and the camera turns on from there. Truth is the float picture of vtkTruthTransparencyPass. A time is
that of --frames frames of a turn that ends at the view. With jumps the first of them is a jump of the camera.
Statistics and wrong guesses count. Times are CPU times of all threads, the least of the rounds, in which all
contestants take turns. The best one is the fastest of --methods whose error in the view is within the budget. Parts of
files get the opacity; demo scenes keep their own. The result is a table in Markdown. A scene that cannot be loaded has
a row that says why.
"""

import argparse
import collections
import math
import pathlib
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

import vitrine

METHODS = (
    "linked-list,linked-list-compact,prefix-sum-predicted,prefix-sum-predicted-compact,prefix-sum,prefix-sum-compact"
)
REFERENCE = "linked-list"
TURN = 2.0  # degrees a frame
SINGLE = 1e-6  # truth holds the background in single precision
HEAD = (
    "| scene | budget | views | exceeded | beyond bound | of pixels | tightness | wrong guesses | chosen | over best: "
    "median | within 10 % | worst | over linked-list: median | worst |"
)


class Contestant:
    """A way of drawing the scene, and what it took and how far it was off in the view at hand."""

    def __init__(self, method, budget=None):
        self.budget = budget
        self.frame = vitrine.vtkSeeThroughPass()
        if budget is None:
            self.method = vitrine.vtkTransparencyPass.NewMethod(method.removesuffix("-compact"))
            if method.endswith("-compact"):
                self.method.SetColorStorageToCompact()
            self.frame.SetTranslucentPass(self.method)
        else:
            self.frame.SetErrorBudget(budget)
            self.method = self.frame.GetTranslucentPass()
        self.forget()

    def forget(self):
        self.seconds, self.error, self.chosen = math.inf, math.nan, ""


class Stage:
    """A window with a scene, and views of it."""

    def __init__(self, source, size, opacity):
        self.window = vitrine.vtkHeadlessRenderWindow()
        self.window.SetSize(*size)
        self.window.SetMultiSamples(0)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.2, 0.3, 0.4)
        self.window.AddRenderer(self.renderer)
        machine = vitrine.load(source)
        if not source.startswith("demo:"):
            machine["**"].opacity = opacity
        machine.add_to(self.renderer)
        self.renderer.ResetCamera()
        self.home = vtkCamera()
        self.home.DeepCopy(self.renderer.GetActiveCamera())
        self.truth = Contestant("truth")

    def look(self, random):
        """Take a random view."""
        camera = self.renderer.GetActiveCamera()
        camera.DeepCopy(self.home)
        distance = camera.GetDistance()
        direction, up, aside = (random.normal(size=3) for _ in range(3))
        zoom = 10 ** random.uniform(-0.1, 0.6)
        centre = np.array(camera.GetFocalPoint()) + 0.1 * distance * (1 - 1 / zoom) * aside
        camera.SetFocalPoint(*centre)
        camera.SetPosition(*(centre + distance / zoom * direction / np.linalg.norm(direction)))
        camera.SetViewUp(*np.cross(direction, up))
        self.renderer.ResetCameraClippingRange()

    def draw(self, contestant):
        """Draw a frame, and tell its CPU time."""
        self.renderer.SetPass(contestant.frame)
        begin = time.process_time()
        self.window.Render()
        self.window.WaitForCompletion()
        return time.process_time() - begin

    def arrive(self, contestant, frames):
        """Turn to the view, and tell the CPU time of all frames.

        The last frame has the very camera that truth has. To turn there and back would round its position, and where
        coordinates are large, that moves edges to other pixels.
        """
        camera = self.renderer.GetActiveCamera()
        view = vtkCamera()
        view.DeepCopy(camera)
        seconds = 0.0
        for left in reversed(range(frames)):
            camera.DeepCopy(view)
            if left:
                camera.Azimuth(-TURN * left)
            seconds += self.draw(contestant)
        return seconds

    def picture(self):
        width, height = self.window.GetSize()
        data = vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, data)
        return vtk_to_numpy(data).reshape(height, width, 4)[..., :3] / 255.0

    def exact(self):
        """Truth of the view. Where nothing translucent is in view, that is the opaque picture as it is."""
        self.draw(self.truth)
        image = self.truth.method.GetResult()
        if image is None:
            return self.picture()
        width, height, _ = image.GetDimensions()
        pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
        return np.clip(pixels[..., :3].astype(float), 0.0, 1.0)


class Row:
    """What was found with a budget on a scene."""

    def __init__(self):
        self.views = self.exceeded = self.beyond = self.pixels = 0
        self.tightness, self.over_best, self.over_reference = [], [], []
        self.chosen = collections.Counter()

    def add(self, contestant, rivals, errors, bounds):
        self.views += 1
        self.exceeded += errors.max() > contestant.budget + SINGLE
        self.beyond += int((errors > bounds + SINGLE).sum())
        self.pixels += errors.size
        wrong = errors > 0.25 / 255
        self.tightness += list(bounds[wrong] / errors[wrong])
        self.chosen[contestant.chosen or "with nothing translucent"] += 1
        best = min((rival.seconds for rival in rivals.values() if rival.error <= contestant.budget), default=math.nan)
        self.over_best.append(contestant.seconds / best)
        self.over_reference.append(contestant.seconds / rivals[REFERENCE].seconds)

    def text(self, scene, budget, wrong_guesses):
        chosen = ", ".join(f"{count} {name}" for name, count in self.chosen.most_common())
        best = np.array(self.over_best)
        cells = [
            scene, f"{255 * budget:g}/255", self.views, self.exceeded, self.beyond, f"{self.pixels:,}",
            f"{np.median(self.tightness):.2f}" if self.tightness else "-", wrong_guesses, chosen,
            f"{np.nanmedian(best):.2f}", f"{100 * np.mean(best <= 1.1):.0f} %", f"{np.nanmax(best):.2f}",
            f"{np.median(self.over_reference):.2f}", f"{max(self.over_reference):.2f}",
        ]  # fmt: skip
        return "| " + " | ".join(map(str, cells)) + " |"


def judge_view(stage, rivals, automatic, rows, asked, random):
    exact = stage.exact()
    contestants = [*rivals.values(), *automatic]
    for contestant in contestants:
        contestant.forget()
    for _ in range(asked.rounds):
        for index in random.permutation(len(contestants)):
            contestant = contestants[index]
            contestant.seconds = min(contestant.seconds, stage.arrive(contestant, asked.frames))
            contestant.error = abs(stage.picture() - exact).max()
            if contestant.budget:
                contestant.chosen = contestant.method.GetChosenMethod()
    for contestant, row in zip(automatic, rows):
        contestant.method.KeepErrorBoundsOn()
        stage.draw(contestant)
        errors = abs(stage.picture() - exact).max(axis=-1)
        bounds = vitrine.error_bound(stage.renderer)[::-1]
        contestant.method.KeepErrorBoundsOff()
        row.add(contestant, rivals, errors, bounds)


def judge_scene(stage, source, asked):
    random = np.random.default_rng(asked.seed)
    rivals = {name: Contestant(name) for name in asked.methods}
    automatic = [Contestant("automatic", budget) for budget in asked.budgets]
    for contestant in [*rivals.values(), *automatic]:
        stage.draw(contestant)  # which builds shaders
    rows = [Row() for _ in automatic]
    for view in range(asked.views):
        if view == 0 or asked.path == "jumps":
            stage.look(random)
        else:
            stage.renderer.GetActiveCamera().Azimuth(TURN * asked.frames)
            stage.renderer.ResetCameraClippingRange()
        judge_view(stage, rivals, automatic, rows, asked, random)
    name = source if source.startswith("demo:") else pathlib.Path(source).stem
    for contestant, row in zip(automatic, rows):
        print(row.text(name, contestant.budget, contestant.method.GetNumberOfWrongGuesses()), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sources", nargs="+", metavar="FILE|demo")
    parser.add_argument("--views", type=int, default=20)
    parser.add_argument("--path", choices=("jumps", "turn"), default="jumps")
    parser.add_argument("--budgets", default="0.6,1,2,4,8", help="in steps of 1/255")
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--opacity", type=float, default=0.3)
    parser.add_argument("--frames", type=int, default=3)
    parser.add_argument("--rounds", type=int, default=2)
    parser.add_argument("--seed", type=int, default=53)
    parser.add_argument("--methods", default=METHODS)
    asked = parser.parse_args()
    asked.budgets = [float(budget) / 255 for budget in asked.budgets.split(",")]
    asked.size = tuple(int(side) for side in asked.size.split("x"))
    asked.methods = asked.methods.split(",")
    print(HEAD + "\n" + "| --- " * HEAD.count(" | ") + "| --- |")
    for source in asked.sources:
        try:
            stage = Stage(source, asked.size, asked.opacity)
        except ValueError as problem:
            print(f"| {source} | not loaded: {problem} |", flush=True)
            continue
        judge_scene(stage, source, asked)


if __name__ == "__main__":
    main()
