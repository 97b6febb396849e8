"""What `vitrine stability --quick` is expected to tell: the cells that CTest checks, and their file of figures.

    VITRINE_PROGRAM=build/release/bin/vitrine python3 -B stability_figures.py

measures the cells again and writes stability_figures.csv. A change of the file is a change of how a method fails: look
at each line of its difference before it is kept.
"""

import csv
import json
import pathlib
import re

from program import run

FILE = pathlib.Path(__file__).with_name("stability_figures.csv")
# Without a prediction, prefix sums are as in the first frame with one.
EXACT = ["linked-list", "prefix-sum-predicted"]
EXACT += [f"{method}-compact" for method in EXACT] + ["stencil-routed"]
APPROXIMATE = ["blend", "vtk-oit", "vtk-peeling", "linked-list-8bit", "stencil-mask-8"]
SCENES = [
    "coincident",
    "mating-everywhere",
    "crossing",
    "gaps",
    "near-far",
    "large-coordinates",
    "inside",
    "at-face",
    "parallel",
    "needles-few",
    "slivers",
    "opaque",
    "clipped",
    "alpha-texture",
    "impostors",
    "non-finite",
    "empty",
    "zoom",
    "window-1x1",
    "stack-17-alpha-0",
    "stack-17-alpha-0.01",
    "stack-17-alpha-0.5",
    "stack-17-alpha-1",
]
COLUMNS = ["scene", "method", "outcome", "error", "worst", "wrong", "repeated", "shuffled"]
COLUMNS += ["shift", "shift_excess", "turn", "turn_excess"]


def suite():
    """What each scene of `vitrine stability` draws, by its name."""
    told = run("stability", "--help").stdout.decode()
    return dict(re.findall(r"^  (\S+)  (demo:\S+?)(?:, quick)?$", told, re.MULTILINE))


def measure():
    """The JSON of the run that the figures come from."""
    result = run(
        *("stability", "--quick", "--json", "-"),
        *("--scenes", ",".join(SCENES), "--methods", ",".join(EXACT + APPROXIMATE)),
    )
    if result.returncode != 0 or result.stderr:
        raise AssertionError(result.stderr.decode(errors="replace"))
    return json.loads(result.stdout)


def figures(row):
    """A cell as a line of the file: steps of 1/255, wrong pixels in percent, differing values."""
    line = {"scene": row["scene"], "method": row["method"], "outcome": row["outcome"]}
    if "skipped" in row:
        return line
    line["error"] = f"{255 * row['error']['max']:.2f}"
    line["worst"] = f"{255 * row['worst_error']:.2f}"
    line["wrong"] = f"{100 * row['error']['wrong_pixels']:.2f}"
    line["repeated"] = str(row["repetition_difference"])
    line["shuffled"] = str(row["order_difference"])
    for motion in ("shift", "turn"):
        line[motion] = f"{255 * row[motion]['largest']:.2f}"
        line[f"{motion}_excess"] = f"{255 * row[motion]['excess']:.2f}"
    return line


def read():
    """The lines of the file by scene and method."""
    with FILE.open(newline="", encoding="utf-8") as file:
        return {(line["scene"], line["method"]): line for line in csv.DictReader(file)}


def write(rows):
    with FILE.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(map(figures, rows))


if __name__ == "__main__":
    write(measure()["results"])
