"""Draws scenes by each method on a driver, and says whether they are exact, refused or wrong."""

import json
import re
import threading
from dataclasses import dataclass

from drivers import VALIDATION as LAYERS
from places import WORK, Place
from table import Cell

SECONDS = 300  # of time, after which a process hangs: on two idle processors none takes more than 30

METHODS = [
    "linked-list", "linked-list-compact", "linked-list-8bit", "prefix-sum", "prefix-sum-compact",
    "prefix-sum-predicted", "prefix-sum-predicted-compact", "stencil-routed", "stencil-mask-8",
]
LISTS = [method for method in METHODS if not method.startswith("stencil")]
# Those whose error depends on the scene: they are held to their own error on the first driver.
INEXACT = ("linked-list-8bit", "stencil-mask-8", "lights")
LIGHT_MODES = "vtk,loop,tiled,clustered,world,deferred,tiled-deferred,clustered-deferred"
# Numbers of the Vulkan specification's rules, and of hazards. The same rule has a name for each command that draws.
SAID_BY_LAYERS = re.compile(r"\b(?:VUID[-_](?:vkCmdDraw\w+-)?([-\w]+)|(SYNC-HAZARD[-\w]*|UNASSIGNED-[-\w]+))")


@dataclass(frozen=True)
class Scene:
    input: str
    options: tuple = ()
    methods: tuple = tuple(METHODS)
    fast: bool = False
    limit: float = 1.0  # the largest error of an exact method, in 1/255: a step of a display

    @property
    def name(self):
        return " ".join((self.input, *self.options))


def lists(name, **options):
    """A scene that is too deep for stencil methods, or takes them minutes."""
    return Scene(name, methods=tuple(LISTS), **options)


SCENES = [
    Scene("demo:spheres,layers=8", fast=True),
    Scene("demo:coincident", fast=True),
    lists("demo:stack,layers=70", fast=True),
    Scene("demo:spheres,layers=32"),
    Scene("demo:stack,layers=33"),
    Scene("demo:stack,layers=64"),
    lists("demo:stack,layers=300"),
    lists("demo:stack,layers=1100"),
    Scene("demo:crossing"),
    Scene("demo:gaps"),
    Scene("demo:opaque"),
    Scene("demo:clipped"),
    Scene("demo:alpha-texture"),
    Scene("demo:impostors"),
    Scene("demo:needles,needles=200"),
    Scene("demo:empty"),
    Scene("demo:assembly,parts=60", ("--opacity", "0.3")),
    # Each sample is rounded to 8 bits, and so is their mean.
    Scene("demo:spheres,layers=8", ("--multisamples", "4"), tuple(LISTS), limit=1.5),
]


class Frames:
    """Draws on one driver after the other. `figures` of the first driver are those that inexact methods are held to."""

    def __init__(self, program, fast, figures):
        self.program, self.fast = program, fast
        self.scenes = [scene for scene in SCENES if scene.fast or not fast]
        self.reference = WORK / "reference"
        self.drawn, self.lock = set(), threading.Lock()  # pictures of truth
        self.figures = figures  # of the first driver: error by scene and subject

    def truth_of(self, scene):
        """The picture of truth by this machine's own driver, for drivers that cannot draw truth."""
        name = re.sub(r"\W+", "-", scene.name)
        truth = self.reference / f"{name}.png"
        with self.lock:
            if truth not in self.drawn:
                self.drawn.add(truth)
                self.reference.mkdir(parents=True, exist_ok=True)
                truth.unlink(missing_ok=True)
                here = ("render", scene.input, "--size", "64x64", *scene.options, "--method", "truth", "-o", truth)
                Place().run((self.program, *here), {}, SECONDS)
        return truth

    def draw(self, driver, place, environment):
        """The cells of a driver, one for each method, and those of the lights and the culler."""
        run = Run(self, driver, place, environment)
        errors = place.seen_here / "drawn" / run.folder / "errors"
        errors.parent.mkdir(parents=True, exist_ok=True)
        errors.unlink(missing_ok=True)
        for scene in self.scenes:
            run.compare(scene)
        if driver.effects or not self.fast:
            run.lights()
            run.cull()
        if driver.validated:
            run.validate()
        if errors.is_file():
            run.fail("OpenGL errors", "wrong", errors.read_text(encoding="utf-8").strip().splitlines()[0][:200])
        return run.cells()


class Run:
    """What has been seen of one driver: the worst of each method."""

    def __init__(self, frames, driver, place, environment):
        self.frames, self.driver, self.place = frames, driver, place
        self.folder = re.sub(r"\W+", "-", driver.name)  # below `drawn`, for this driver alone
        self.environment = environment | {"GL_RECORD_ERRORS": str(place.files / "drawn" / self.folder / "errors")}
        self.program = place.files / "bin/vitrine" if place.root else frames.program
        self.worst = {}  # error in 1/255 by subject
        self.routed = 0  # the largest K of stencil routing: layers by passes over the geometry
        self.refusals = {}
        self.faults = {}

    def fail(self, subject, verdict, detail):
        self.faults.setdefault(subject, (verdict, detail))

    def cells(self):
        """A fault, or else a refusal, or else the largest error."""
        cells = []
        for subject in dict.fromkeys([*METHODS, "lights", "culler", *self.faults]):
            if subject in self.faults:
                cells.append(Cell(self.driver.name, subject, *self.faults[subject]))
            elif subject in self.refusals:
                cells.append(Cell(self.driver.name, subject, "refused", self.refusals[subject]))
            elif subject in self.worst:
                exact = "ok" if self.driver.null else "same" if subject in INEXACT else "exact"
                detail = "" if self.driver.null else f"{self.worst[subject]:.2f}"
                if subject == "stencil-routed" and self.routed and not self.driver.null:
                    detail += f", K={self.routed}"
                cells.append(Cell(self.driver.name, subject, exact, detail))
        return cells

    def start(self, *arguments):
        command = [self.program, *arguments]
        recorder = str(self.place.files / "bin/gl_recorder.so")
        loaded = " ".join(filter(None, [self.environment.get("LD_PRELOAD", ""), recorder]))
        return self.place.run(command, self.environment | {"LD_PRELOAD": loaded}, SECONDS)

    def json_of(self, subjects, scene, outcome):
        """What a run printed; where it ended otherwise, that is the subjects' fault, and None."""
        if outcome.hangs:
            verdict, detail = "hangs", f"{scene}: not done after {SECONDS} s"
        elif outcome.status != 0:
            said = (outcome.messages.strip().splitlines() or [""])[-1][:200]
            verdict, detail = "wrong", f"{scene}: status {outcome.status} {said}"
        else:
            return json.loads(outcome.output)
        for subject in subjects:
            self.fail(subject, verdict, detail)
        return None

    def compare(self, scene):
        """All methods in one process; where that does not end well, each by itself, to see which one it was."""
        options = ("--size", "64x64", "--frames", "2", "--orbit", "0", *scene.options, "--json", "-", "--methods")
        outcome = self.start("compare", scene.input, *options, ",".join(scene.methods))
        if outcome.status == 0:
            results = json.loads(outcome.output)["results"]
        else:
            results = []
            for method in scene.methods:
                if method not in self.faults:
                    alone = self.start("compare", scene.input, *options, method)
                    results += (self.json_of([method], scene.name, alone) or {"results": []})["results"]
        for result in results:
            self.look_at(scene, result)

    def look_at(self, scene, result):
        method = result["method"]
        if "skipped" in result:
            self.refusals[method] = result["skipped"]
            return
        if method == "stencil-routed" and result.get("layers_max") and result.get("geometry_passes"):
            self.routed = max(self.routed, -(-result["layers_max"] // result["geometry_passes"]))
        error = 255 * result["error"]["max"] if result["error"] else self.error_of_picture(scene, method)
        if error is None:
            return
        if not result["deterministic"] and not self.driver.null:
            self.fail(method, "wrong", f"{scene.name}: its frames differ")
        self.hold(scene.name, method, error, scene.limit)

    def hold(self, scene, subject, error, limit):
        """Note the error, which may be `limit` for an exact subject. A null device's pictures are empty."""
        if self.driver.null:
            error = 0.0
        elif subject in INEXACT:
            limit = max(limit, self.frames.figures.setdefault(f"{scene}: {subject}", error) + 1.0)
        if error > limit:
            self.fail(subject, "wrong", f"{scene}: off by {error:.2f}/255, at most {limit:.2f} expected")
        self.worst[subject] = max(self.worst.get(subject, 0.0), error)

    def error_of_picture(self, scene, method):
        """The largest difference to truth as the first driver drew it, where this one cannot draw truth."""
        truth, picture = self.frames.truth_of(scene), self.place.files / "drawn" / self.folder / "picture.png"
        options = ("--size", "64x64", *scene.options)
        outcome = self.start("render", scene.input, *options, "--method", method, "-o", picture)
        if outcome.status != 0 or not truth.is_file():
            self.fail(method, "hangs" if outcome.hangs else "wrong", f"{scene.name}: no picture")
            return None
        drawn = self.place.seen_here / "drawn" / self.folder / "picture.png"
        told = Place().run((self.frames.program, "diff", drawn, truth, "--json", "-"), {}, SECONDS)
        return json.loads(told.output)["baselines"][0]["largest_difference"]

    def lights(self):
        scene = "demo:hall,lights=16"
        outcome = self.start(
            "lights", scene, "--size", "64x64", "--frames", "1", "--modes", LIGHT_MODES, "--json", "-")
        for result in (self.json_of(["lights"], scene, outcome) or {"results": []})["results"]:
            if result.get("skipped"):
                self.refusals["lights"] = result["skipped"]
            elif result["error"]:
                self.hold(f"{scene} {result['mode']}", "lights", 255 * result["error"]["max"], 1.0)

    def cull(self):
        scene = "demo:assembly,parts=100"
        outcome = self.start("cull", scene, "--size", "64x64", "--poses", "4", "--without-ideal", "--json", "-")
        for result in (self.json_of(["culler"], scene, outcome) or {"results": []})["results"]:
            self.hold(scene, "culler", result["wrong_pixels"], 0)

    def validate(self):
        """No method may give the validation layers something to say that VTK's own method and truth do not."""
        options = ("compare", "demo:spheres,layers=8", "--size", "64x64", "--frames", "3", "--methods")
        environment, self.environment = self.environment, self.environment | LAYERS

        def told(*arguments):
            outcome = self.start(*arguments)
            return {rule or hazard for rule, hazard in SAID_BY_LAYERS.findall(outcome.output + outcome.messages)}

        vtk = told(*options, "vtk-oit")
        if not vtk:
            self.fail("validation", "wrong", "the layers say nothing, so that they may not be there")
        for method in METHODS:
            more = told(*options, method) - vtk
            if more:
                self.fail(method, "wrong", f"validation: {', '.join(sorted(more))}")
        self.environment = environment
