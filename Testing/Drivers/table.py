"""What the drivers did: cells of the table, known failures, and the table as Markdown."""

import dataclasses
import fnmatch
import json
import re
import tomllib
from dataclasses import dataclass, field

BEGIN = "<!-- Written by scripts/test-drivers. -->"
END = "<!-- End of what scripts/test-drivers wrote. -->"
GOOD = ("exact", "same", "refused", "ok")
BY_LENGTH = "List"  # programs of which each length of lists takes its own
SECONDS = 2.0  # that compiling a program may take


@dataclass
class Cell:
    """How one subject (a method, a program, an error) did on a driver. `verdict` is one of GOOD, or names a fault."""

    driver: str
    subject: str
    verdict: str
    detail: str = ""

    @property
    def is_good(self):
        return self.verdict in GOOD

    def __str__(self):
        return f"{self.driver}: {self.subject}: {self.verdict}" + (f" ({self.detail})" if self.detail else "")


@dataclass
class Compiled:
    """What a device's compiler made of one program. Seconds are of the processor, on all threads."""

    device: str
    program: str
    seconds: float
    spills: int | None = None  # registers or bytes, as the driver counts; None where it does not tell
    registers: str = ""
    error: str = ""
    is_cut_off: bool = False  # it took longer than anybody waits, and `seconds` is when it was ended

    @property
    def verdict(self):
        if self.error:
            return "fails"
        if self.is_cut_off or self.seconds > SECONDS:
            return "slow"
        return "spills" if self.spills else "ok"

    @property
    def time(self):
        return f"> {self.seconds:.0f}" if self.is_cut_off else f"{self.seconds:.2f}"

    def cell(self):
        told = [f"{self.time} s"]
        if self.spills is not None:
            told.append(f"{self.spills} spills")
        if self.registers:
            told.append(self.registers)
        return Cell(self.device, self.program, self.verdict, self.error or ", ".join(told))


@dataclass
class Run:
    """What runs of scripts/test-drivers found. `made` tells of each driver and device when, and at which commit."""

    made: dict = field(default_factory=dict)  # name: [time as of ISO 8601, commit]
    frames: list = field(default_factory=list)
    compiled: list = field(default_factory=list)
    front_end: list = field(default_factory=list)
    figures: dict = field(default_factory=dict)  # of the first driver: error by scene and subject

    def cells(self):
        return [*self.frames, *(result.cell() for result in self.compiled), *self.front_end]

    def with_rows(self, new, order):
        """This run with the rows of a newer one in place of its own. `order` has the names of all rows."""

        def merged(mine, others, name_of):
            together = [entry for entry in mine if name_of(entry) not in new.made] + others
            return sorted(together, key=lambda entry: order.index(name_of(entry)))

        made = self.made | new.made
        return Run(
            {name: made[name] for name in order if name in made},
            merged(self.frames, new.frames, lambda cell: cell.driver),
            merged(self.compiled, new.compiled, lambda result: result.device),
            merged(self.front_end, new.front_end, lambda cell: cell.driver), self.figures | new.figures)


def text_of_run(run):
    return json.dumps(dataclasses.asdict(run), indent=1)


def read_run(text):
    entries = json.loads(text)
    kinds = {"frames": Cell, "compiled": Compiled, "front_end": Cell}
    return Run(**entries | {name: [kind(**entry) for entry in entries[name]] for name, kind in kinds.items()})


@dataclass
class KnownFailure:
    """A failure that is expected, by patterns of shells. Where it is `sometimes` only, it may also be absent."""

    driver: str
    subject: str
    reason: str
    verdict: str = "*"
    sometimes: bool = False
    met: list = field(default_factory=list)

    def fits(self, cell):
        return all(
            fnmatch.fnmatchcase(value, pattern)
            for value, pattern in (
                (cell.driver, self.driver), (cell.subject, self.subject), (cell.verdict, self.verdict)))


class TableError(Exception):
    """The file of known failures cannot be used."""


def read_known_failures(text):
    entries = []
    for entry in tomllib.loads(text).get("failure", []):
        try:
            entries.append(KnownFailure(**entry))
        except TypeError as error:
            raise TableError(f"known failures: {error}") from error
        if not entries[-1].reason:
            raise TableError("known failures: each needs its reason")
    return entries


def judge(cells, known):
    """Share out the cells that are not good: those that no entry knows of, and notes of each entry's own in `met`."""
    unknown = []
    for cell in cells:
        if cell.is_good:
            continue
        entries = [entry for entry in known if entry.fits(cell)]
        for entry in entries:
            entry.met.append(cell)
        if not entries:
            unknown.append(cell)
    return unknown


def no_longer_failing(known):
    return [entry for entry in known if not entry.met and not entry.sometimes]


def rows(header, lines):
    yield "| " + " | ".join(header) + " |"
    yield "| " + " | ".join("---" for _ in header) + " |"
    for line in lines:
        yield "| " + " | ".join(str(word).replace("|", "/") for word in line) + " |"


def in_order(values):
    return list(dict.fromkeys(values))


def frames_section(cells):
    """A row for each driver and a column for each method; reasons of refusals and faults stand below."""
    by_place = {(cell.driver, cell.subject): cell for cell in cells}
    drivers, subjects = in_order(c.driver for c in cells), in_order(c.subject for c in cells)
    notes = in_order(cell.detail for cell in cells if cell.detail and cell.verdict not in ("exact", "same", "ok"))

    def word(cell):
        if cell is None:
            return "not run"
        if cell.verdict in ("exact", "same"):
            return f"{cell.verdict} {cell.detail}".strip()
        verdict = cell.verdict if cell.is_good else f"**{cell.verdict}**"
        return f"{verdict} [{notes.index(cell.detail) + 1}]" if cell.detail in notes else verdict

    yield from rows(
        ["driver", *(f"`{subject}`" for subject in subjects)],
        ([driver, *(word(by_place.get((driver, subject))) for subject in subjects)] for driver in drivers))
    if notes:
        yield ""
        yield from (f"{number}. {note}" for number, note in enumerate(notes, 1))


def devices_section(compiled):
    """A row for each device, the worst of each program by the length of its list, and what is too slow or spills."""
    lines = []
    devices = in_order(result.device for result in compiled)
    for device in devices:
        results = [result for result in compiled if result.device == device]
        slowest = max(results, key=lambda result: result.seconds)
        lines.append(
            [device, len(results), sum(bool(result.error) for result in results), f"{slowest.time} s",
             sum(result.verdict == "slow" for result in results), sum(bool(result.spills) for result in results)])
    yield from rows(["device", "programs", "errors", "slowest", "above 2 s", "with spills"], lines)
    yield ""
    yield "The worst of all methods. A length is that of the shortest list recorded that takes the program. Bold are"
    yield "more than 2 s, and spills. VGPRs and registers are those of a thread. SIMD tells the widths that Intel's"
    yield "compiler made."
    yield ""
    yield from rows(["program, length of lists", *devices], lengths_section(compiled, devices))
    worse = [result for result in compiled if result.verdict != "ok"]
    if worse:
        yield ""
        yield from rows(
            ["device", "program", "seconds", "spills", "registers or width"],
            ([r.device, r.program, r.time, "unknown" if r.spills is None else r.spills, r.registers] for r in worse))


def lengths_section(compiled, devices):
    """For each part and length of list: seconds, registers and spills on each device, of the worst method."""
    of_name = {}
    for result in compiled:
        of_name.setdefault((row_of(result.program), result.device), []).append(result)
    for row in sorted({name for name, _ in of_name}, key=lambda name: (name[0], name[1] or 0)):
        cells = []
        for device in devices:
            results = of_name.get((row, device), [])
            worst = max(
                results, key=lambda result: (bool(result.error), result.spills or 0, result.seconds), default=None)
            if worst is None:
                cells.append("")
                continue
            seconds = max(results, key=lambda result: result.seconds).time
            told = [f"{seconds} s", worst.registers, f"{worst.spills} spills" if worst.spills else ""]
            text = "fails" if worst.error else ", ".join(filter(None, told))
            cells.append(text if all(result.verdict == "ok" for result in results) else f"**{text}**")
        yield [row[0] if row[1] is None else f"{row[0]}, {row[1]}", *cells]


def row_of(program):
    """The part of a program and, where lists of other lengths take another program, the length it was recorded for."""
    part, _, use = program.partition(" of ")
    length = re.search(r", (\d+)(?:, no fetch)?$", use)
    return (part, int(length[1]) if length and part.startswith(BY_LENGTH) else None)


def commits_section(made):
    """When the oldest row was made, and which ones were made later."""
    oldest = min(made.values())
    yield f"Run on {oldest[0][:10]} at commit {oldest[1]}."
    later = {}
    for name, entry in made.items():
        if entry[1] != oldest[1]:
            later.setdefault((entry[0][:10], entry[1]), []).append(name)
    for (date, commit), names in sorted(later.items()):
        yield ""
        yield f"Of commit {commit}, {date}: {'; '.join(names)}."


def section(run, known):
    """The generated part of the page."""
    yield BEGIN
    yield ""
    yield from commits_section(run.made)
    yield ""
    yield "## Frames"
    yield ""
    yield "zink on lavapipe is also run under Vulkan's validation layers, with their checks of synchronisation. K is"
    yield "the number of samples that `stencil-routed` routes a pass into: above 1 only where the driver routes."
    yield ""
    yield from frames_section(run.frames)
    yield ""
    yield "## Compilers"
    yield ""
    yield from devices_section(run.compiled)
    yield ""
    yield "## Front end"
    yield ""
    yield from rows(
        ["shaders", "error", "result"], ([cell.driver, cell.subject, cell.detail] for cell in run.front_end))
    met = [entry for entry in known if entry.met]
    if met:
        yield ""
        yield "## Known failures"
        yield ""
        yield from rows(
            ["where", "subject", "reason"], ([entry.driver, entry.subject, entry.reason] for entry in met))
    yield ""
    yield END


def replaced(page, lines):
    """The page with the lines in place of its generated part."""
    begin, end = page.find(BEGIN), page.find(END)
    if begin < 0 or end < begin:
        raise TableError("the page has no generated part")
    return page[:begin] + "\n".join(lines) + page[end + len(END):]


def written_of(page):
    """The date and the commit of the page's oldest row, or two times None."""
    for line in page.splitlines():
        words = line.rstrip(".").split()
        if line.startswith("Run on ") and words[-2] == "commit":
            return words[2], words[-1]
    return None, None


def commits_of(page, names):
    """The commit of each row of the page, by name. It is empty if the page was never written."""
    _, oldest = written_of(page)
    if oldest is None:
        return {}
    commits = {name: oldest for name in names}
    for line in page.splitlines():
        if line.startswith("Of commit "):
            made, _, listed = line.rstrip(".").partition(": ")
            commits.update({name: made.split()[2].rstrip(",") for name in listed.split("; ")})
    return commits
