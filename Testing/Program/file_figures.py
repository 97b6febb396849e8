"""Figures of opening files beside f3d: whole processes, from the file to a picture of 512x512, in turn.

    VITRINE_PROGRAM=build/release/bin/vitrine python3 Testing/Program/file_figures.py FILE... [--f3d PYTHON]

PYTHON is that of an environment with f3d (`pip install f3d==4.0.0`); without it, Vitrine is measured alone. f3d blends
without sorting, as `--method blend` does. Times are the least of the runs, since other programs only add to them.
Memory is the largest process's peak. STEP is read without Vitrine's cache, and then with it.
"""

import argparse
import os
import pathlib
import subprocess
import tempfile
import time

from program import PROGRAM

SIZE = 512
CAD = {".step", ".stp", ".iges", ".igs", ".brep"}
F3D = f"""
import sys, f3d
f3d.Log.set_verbose_level(f3d.Log.QUIET)
f3d.Engine.autoload_plugins()
engine = f3d.Engine.create(True)
engine.window.size = {SIZE}, {SIZE}
engine.scene.add(sys.argv[1])
engine.window.render_to_image().save(sys.argv[2])
"""


class Opening:
    """Seconds on the clock, seconds of CPU, and MB of a command. The best of several runs is kept."""

    def __init__(self, *command):
        self.command = [str(word) for word in command]
        self.seconds = self.cpu = self.memory = float("inf")

    def run(self, environment):
        began = time.perf_counter()
        with subprocess.Popen(self.command, env=environment, stdout=subprocess.DEVNULL) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            raise SystemExit(f"{' '.join(self.command)}: ended with {process.returncode}")
        self.seconds = min(self.seconds, time.perf_counter() - began)
        self.cpu = min(self.cpu, usage.ru_utime + usage.ru_stime)
        self.memory = min(self.memory, usage.ru_maxrss / 1000)

    def cells(self):
        return f"{self.seconds:.2f} s, {self.cpu:.2f} s | {self.memory:.0f} MB"


def measure(file, arguments, folder):
    """The openings of a file by name: by f3d, by Vitrine, and by Vitrine's cache."""
    picture = folder / "picture.png"
    render = [PROGRAM, "render", file, "--size", f"{SIZE}x{SIZE}", "--method", arguments.method, "-o", picture]
    is_cad = file.suffix.lower() in CAD
    openings = {"Vitrine": Opening(*render, *["--no-cache"] * is_cad)}
    if is_cad:
        openings["Vitrine, again"] = Opening(*render)
    if arguments.f3d:
        openings["f3d"] = Opening(arguments.f3d, "-c", F3D, file, picture)
    environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
    environment["XDG_CACHE_HOME"] = str(folder)
    for turn in range(arguments.runs + 1):
        for opening in openings.values():
            opening.run(environment)
        if turn == 0:  # The first turn fills the caches of the system and of Vitrine.
            openings = {name: Opening(*opening.command) for name, opening in openings.items()}
    return openings


def rows(file, openings):
    f3d = openings.pop("f3d", None)
    for name, opening in openings.items():
        row = f"| {file.name} | {name} | {opening.cells()} |"
        if f3d:
            ratios = [getattr(f3d, key) / getattr(opening, key) for key in ("seconds", "cpu", "memory")]
            row += f" {f3d.cells()} | {ratios[0]:.1f}, {ratios[1]:.1f} | {ratios[2]:.1f} |"
        yield row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--f3d", metavar="PYTHON", help="of an environment with f3d")
    parser.add_argument("--method", default="linked-list", help="of Vitrine")
    parser.add_argument("--runs", type=int, default=5)
    arguments = parser.parse_args()
    print("| file | by | time, CPU | memory |" + " f3d | memory | ratios | of memory |" * bool(arguments.f3d))
    print("| --- | --- | --- | --- |" + " --- | --- | --- | --- |" * bool(arguments.f3d))
    with tempfile.TemporaryDirectory() as folder:
        for file in arguments.files:
            for row in rows(file, measure(file, arguments, pathlib.Path(folder))):
                print(row, flush=True)


if __name__ == "__main__":
    main()
