"""Charts of small windows, for tests."""

import functools
import json
import pathlib
import re
import signal
import subprocess
import tempfile
import types

from program import PROGRAM, TIMEOUT, environment_without_display, run

METHODS = ("vtk-oit", "blend", "linked-list")
SMALL = ("--quick", "--size", "24x24", "--frames", "1", "--methods", ",".join(METHODS))


def chart(folder, *arguments):
    """Run `vitrine chart` with small windows."""
    return run("chart", *SMALL, "--out", folder, *arguments)


def read_document(folder):
    return json.loads((folder / "chart.json").read_text())


def page_data(folder):
    """What the page of a chart holds."""
    page = (folder / "index.html").read_text()
    return json.loads(re.search(r'id="data">(.*?)</script>', page, re.DOTALL)[1])


def results_there(folder):
    """Rows of results that are there while a chart may be in the making."""
    return read_document(folder)["results"] if (folder / "chart.json").exists() else []


def stop_when(process, is_enough, signal):
    """Send a signal to a program as soon as is_enough(). It must still run then. process.said has its output."""
    while not is_enough():
        try:
            process.wait(timeout=0.02)
        except subprocess.TimeoutExpired:
            continue
        raise AssertionError("the program ended before it could be stopped")
    process.send_signal(signal)
    _, process.said = process.communicate(timeout=TIMEOUT)


def start_chart(folder, *arguments):
    """Start `vitrine chart` with small windows."""
    return subprocess.Popen(
        [PROGRAM, "chart", *SMALL, "--out", str(folder), *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment_without_display(),
    )


@functools.cache
def resumed_chart():
    """
    A chart that was stopped and continued, one for all tests of a process. It has the folder, its contents when the
    run was stopped (files, document), and how both runs ended.
    """
    scratch = tempfile.TemporaryDirectory()
    folder = pathlib.Path(scratch.name) / "chart"
    process = start_chart(folder)
    stop_when(process, lambda: results_there(folder), signal.SIGTERM)
    return types.SimpleNamespace(
        scratch=scratch,  # is removed when nobody has it any more
        folder=folder,
        stopped=process.returncode,
        before=read_document(folder),
        files_before=sorted(path.name for path in folder.iterdir()),
        result=chart(folder),
    )
