"""Records the programs that a run of `vitrine` links, on llvmpipe posing as a device, and keeps each once."""

import dataclasses
import hashlib
import json
import os
import re
import shutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from drivers import AS_A_DEVICE, WITHOUT_FETCH
from frames import LIGHT_MODES
from places import WORK, Place, fingerprint

SECONDS = 300  # for one run
# Lengths of lists, of which each takes another program: networks by their sizes, sorted runs, and long sorted runs.
LENGTHS = (4, 8, 12, 16, 24, 32, 48, 64, 100, 300, 1100, 3000)
LISTS = (
    "linked-list", "linked-list-compact", "linked-list-8bit", "prefix-sum", "prefix-sum-compact", "prefix-sum-8bit",
    "prefix-sum-predicted", "prefix-sum-predicted-compact")
# Fragments with samples or a tolerance have a word more, so some of their lists take other programs.
VARIED = ("linked-list", "linked-list-compact", "prefix-sum", "prefix-sum-compact")
VARIED_LENGTHS = (16, 32, 64, 100)
STENCILS = ("stencil-mask-4", "stencil-mask-8", "stencil-mask-16", "stencil-routed", "stencil-routed-8bit")
SMALL = ("--size", "32x32", "--frames", "2")
LIST = (*SMALL, "--without-truth", "--methods")


@dataclass
class Program:
    """A program by the files of its shaders. `name` tells the method, the list's length, and what it is composed of."""

    name: str
    files: tuple
    fetch: bool


def runs(fast):
    """Names of what is drawn, with the arguments that draw it. Lengths ascend: a program is named by its first use."""
    lengths = (16, 32, 64, 100) if fast else LENGTHS
    methods = ("linked-list", "prefix-sum-predicted-compact") if fast else LISTS
    for length in lengths:
        for method in methods:
            yield f"{method}, {length}", ("compare", f"demo:stack,layers={length}", *LIST, method)
    if fast:
        return
    spheres = ("compare", "demo:spheres,layers=8")
    for method in LISTS:
        yield f"{method}, 4 samples", (*spheres, "--multisamples", "4", *LIST, method)
        yield f"{method}, coincidence", (*spheres, "--coincidence", "2", *LIST, method)
        yield f"{method}, impostors", ("compare", "demo:impostors", *LIST, method)
    for length in VARIED_LENGTHS:
        stack = ("compare", f"demo:stack,layers={length}")
        for method in VARIED:
            yield f"{method}, 4 samples, {length}", (*stack, "--multisamples", "4", *LIST, method)
            yield f"{method}, coincidence, {length}", (*stack, "--coincidence", "2", *LIST, method)
    for method in STENCILS:
        yield method, (*spheres, *LIST, method)
    for mode in LIGHT_MODES.split(","):
        yield f"lights, {mode}", ("lights", "demo:hall,lights=16", *SMALL, "--modes", mode)
    yield "truth", (*spheres, *SMALL, "--methods", "truth")


def composed_of(text):
    """The main file of a composed shader: the last legend's first file. VTK's own shaders have none."""
    files = re.findall(r"// composed from: 1=(\w+)", text)
    return files[-1].removesuffix("Impl") if files else ""


def is_ours(text):
    return "composed from:" in text or "vitrine" in text


class Recorder:
    """Runs the program and gathers what it links into one folder, in which compile_shaders finds it."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.found = {}  # Program by the hash of its shaders
        self.place = Place()

    def run(self, number, name, arguments, fetch):
        """Run it with or without framebuffer fetch. Returns its folder, and an error in words or nothing."""
        scratch = WORK / "recording" / str(number)
        shutil.rmtree(scratch, ignore_errors=True)
        scratch.mkdir(parents=True)
        changes = AS_A_DEVICE | ({} if fetch else WITHOUT_FETCH) | {
            "GL_RECORD_PROGRAMS": str(scratch), "LD_PRELOAD": str(WORK / "bin/gl_recorder.so")}
        outcome = self.place.run((self.program, *arguments), changes, SECONDS)
        if outcome.status != 0:
            return scratch, f"{name}: status {outcome.status} {outcome.messages.strip()[-200:]}"
        return scratch, ""

    def record(self, chosen):
        """Do runs of name, arguments and fetch, as many at once as there are processors. Returns their errors."""
        with ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
            done = list(pool.map(lambda entry: self.run(entry[0], *entry[1]), enumerate(chosen)))
        # Programs are kept in the order of runs, in which each gets its name.
        for (name, _, fetch), (scratch, _) in zip(chosen, done):
            linked = scratch / "programs"
            for line in linked.read_text(encoding="utf-8").splitlines() if linked.is_file() else ():
                self.keep(name, scratch, line.split(), fetch)
        shutil.rmtree(WORK / "recording", ignore_errors=True)
        return [error for _, error in done if error]

    def keep(self, name, scratch, files, fetch):
        texts = {file: (scratch / file).read_text(encoding="utf-8", errors="replace") for file in files}
        if not any(is_ours(text) for text in texts.values()):
            return
        key = hashlib.sha256("\0".join(texts.values()).encode()).hexdigest()
        if key in self.found:
            return
        number = len(self.found)
        names = tuple(f"{number:04d}-{i}.{file.rpartition('.')[2]}" for i, file in enumerate(files))
        for new, text in zip(names, texts.values()):
            (self.folder / new).write_text(text, encoding="utf-8")
        part = composed_of(texts[files[-1]]) or composed_of("".join(texts.values())) or "?"
        needs_fetch = any("GL_EXT_shader_framebuffer_fetch : require" in text for text in texts.values())
        self.found[key] = Program(f"{part} of {name}{'' if fetch else ', no fetch'}", names, needs_fetch)


def record_programs(program, fast, say):
    """All programs of all runs, and the errors of runs. With `fast`, only those of some, with fetch.

    What was recorded of the same build is taken again.
    """
    folder = WORK / ("programs-fast" if fast else "programs")
    record = folder / "record.json"
    made_of = fingerprint([program, WORK / "bin/gl_recorder.so", __file__])
    if record.is_file():
        last = json.loads(record.read_text(encoding="utf-8"))
        if last["made_of"] == made_of:
            found = [Program(**entry | {"files": tuple(entry["files"])}) for entry in last["programs"]]
            say(f"{len(found)} programs of this build were recorded before")
            return folder, found, []
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    recorder = Recorder(program, folder)
    errors = recorder.record(
        [(name, arguments, fetch) for fetch in ((True,) if fast else (True, False)) for name, arguments in runs(fast)])
    found = list(recorder.found.values())
    if not errors:
        text = json.dumps({"made_of": made_of, "programs": [dataclasses.asdict(entry) for entry in found]})
        record.write_text(text, encoding="utf-8")
    say(f"{len(found)} programs recorded")
    return folder, found, errors
