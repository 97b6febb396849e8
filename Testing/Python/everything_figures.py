"""Figures of all that makes frames cheaper, at once: what do the culler, levels of detail and an error budget bring?

    python3 Testing/Python/everything_figures.py [SCENE] [--opacity 0.3] [--size 1280x720] [--moving 8] [--still 2]
        [--rounds 1] [--distance 1] [--pixels 0.5] [--error 1] [--contestants "NAME;..."] [--no-memory]

All contestants draw the same scene in the same window, in turns. The camera turns by 2 degrees a frame, and then stands
still. A frame is what an interactor does: the camera's clipping range, and a render. Times are medians over all rounds:
while moving, of the second half of the frames, as the first ones choose methods and build shaders; of a still camera,
of all but the first frame. CPU times are those of all threads. Ratios are to "see_through()", today's default.

Memory is the most that a process of its own had for a contestant, on top of that with the scene before the first frame.
The result is a table in Markdown.
"""

import argparse
import dataclasses
import re
import statistics
import subprocess
import sys
import time

from vtkmodules.vtkRenderingCore import vtkRenderer

import vitrine

TURN = 2.0  # degrees a frame
HEAD = (
    "| contestant | moving: CPU ms | wall ms | CPU ratio | wall ratio | still: CPU ms | wall ms | CPU ratio | "
    "wall ratio | triangles | MiB more |"
)


@dataclasses.dataclass
class Contestant:
    """A way of drawing the scene. Without options of see_through(), VTK draws by itself."""

    options: dict | None
    has_levels: bool = False
    exact_while_still: bool = True
    peels: int = 0

    def __post_init__(self):
        self.times = {"moving": [], "still": []}
        self.triangles = 0


def contestants(error):
    budget = {"error": error / 255}
    return {
        "see_through()": Contestant({}),
        "linked-list": Contestant({"method": "linked-list"}),
        "culler": Contestant({"cull": True}),
        "budget": Contestant(budget),
        "levels": Contestant({}, True),
        "levels, budget": Contestant(budget, True),
        "everything": Contestant({"cull": True, **budget}, True),
        "everything, levels while still": Contestant({"cull": True, **budget}, True, False),
        "VTK's OIT": Contestant(None),
        "VTK's OIT, levels": Contestant(None, True),
        "VTK's peeling, 4 peels": Contestant(None, peels=4),
    }


class Stage:
    """A window with the scene, drawn by one contestant at a time."""

    def __init__(self, asked):
        self.asked = asked
        self.window = vitrine.vtkHeadlessRenderWindow()
        self.window.SetSize(*(int(side) for side in asked.size.split("x")))
        self.window.SetMultiSamples(0)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.2, 0.3, 0.4)
        self.window.AddRenderer(self.renderer)
        self.machine = vitrine.load(asked.scene)
        self.machine["**"].opacity = asked.opacity
        self.machine.add_to(self.renderer)
        self.home()
        self.levels = vitrine.vtkPartLevels()  # made once for all contestants

    def home(self):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, 0, 1)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 1, 0)
        camera.Azimuth(32)
        camera.Elevation(24)
        self.renderer.ResetCamera()
        camera.SetPosition(
            *(f + self.asked.distance * (p - f) for p, f in zip(camera.GetPosition(), camera.GetFocalPoint()))
        )

    def draw(self):
        """Draw a frame, and tell its times, of the CPU and of the clock, in seconds."""
        begin = time.process_time(), time.perf_counter()
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        self.window.WaitForCompletion()
        return time.process_time() - begin[0], time.perf_counter() - begin[1]

    def begin(self, contestant):
        """Have the renderer draw by a contestant, and return what see_through() returned."""
        renderer, handle = self.renderer, None
        if contestant.options is None:
            renderer.SetUseDepthPeeling(contestant.peels > 0)
            renderer.SetMaximumNumberOfPeels(contestant.peels)
            renderer.SetOcclusionRatio(0.0)
        else:
            handle = vitrine.see_through(renderer, **contestant.options)
        if contestant.has_levels:
            self.levels.AddAssembly(self.machine.actors)
            self.levels.WaitUntilMade()
            self.levels.SetPixels(self.asked.pixels)
            self.levels.SetExactWhileStill(contestant.exact_while_still)
            self.levels.Attach(renderer)
        return handle

    def play(self, contestant):
        """Draw frames by a contestant, and add their times."""
        handle = self.begin(contestant)
        self.home()
        self.draw()
        moving = min(2 if contestant.peels else 99, self.asked.moving)  # peeling is slow, and chooses nothing
        for frame in range(moving):
            self.renderer.GetActiveCamera().Azimuth(TURN)
            seconds = self.draw()
            if frame >= moving // 2:
                contestant.times["moving"].append(seconds)
        contestant.triangles = self.levels.GetNumberOfTriangles() if contestant.has_levels else 0
        self.draw()
        for _ in range(self.asked.still):
            contestant.times["still"].append(self.draw())
        self.levels.Detach()
        if handle:
            handle.remove()
        self.renderer.SetUseDepthPeeling(False)


def peak():
    """The most memory that this process has had, in MiB."""
    with open("/proc/self/status") as status:
        return int(re.search(r"VmHWM:\s+(\d+) kB", status.read())[1]) >> 10


def memory_of(name):
    """What a process of its own tells of a contestant."""
    told = subprocess.run([sys.executable, *sys.argv, "--only", name], check=True, capture_output=True, text=True)
    return told.stdout.split()[-1]


def medians(contestant, kind):
    return [1000 * statistics.median(times) for times in zip(*contestant.times[kind])]


def row(name, contestant, reference, memory):
    cells = [name]
    for kind in ("moving", "still"):
        own, other = medians(contestant, kind), medians(reference, kind)
        cells += [f"{value:.0f}" for value in own] + [f"{a / b:.2f}" for a, b in zip(own, other)]
    cells += [f"{contestant.triangles:,}" if contestant.triangles else "all", memory]
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="?", default="demo:assembly,parts=100000")
    parser.add_argument("--opacity", type=float, default=0.3)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--moving", type=int, default=8, help="frames of a camera that moves")
    parser.add_argument("--still", type=int, default=2, help="frames of a camera that stands still")
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--distance", type=float, default=1.0, help="of that at which all is in view")
    parser.add_argument("--pixels", type=float, default=0.5)
    parser.add_argument("--error", type=float, default=1.0, help="in steps of 1/255")
    parser.add_argument("--contestants", help="some of them, separated by semicolons")
    parser.add_argument("--no-memory", action="store_true")
    parser.add_argument("--only", help=argparse.SUPPRESS)
    asked = parser.parse_args()
    named = contestants(asked.error)
    if asked.contestants:
        named = {name: named[name] for name in asked.contestants.split(";")}
    stage = Stage(asked)
    if asked.only:
        asked.moving = asked.still = 1
        before = peak()
        stage.play(named[asked.only])
        print(peak() - before)
        return
    for _ in range(asked.rounds):
        for contestant in named.values():
            stage.play(contestant)
    del stage
    print(HEAD + "\n" + "| --- " * HEAD.count(" | ") + "| --- |")
    reference = next(iter(named.values()))
    for name, contestant in named.items():
        print(row(name, contestant, reference, "" if asked.no_memory else memory_of(name)), flush=True)


if __name__ == "__main__":
    main()
