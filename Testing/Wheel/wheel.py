"""The program of this interpreter's environment."""

import pathlib
import subprocess
import sys

PROGRAM = pathlib.Path(sys.executable).parent / "vitrine"


def run(program, *arguments, **settings):
    return subprocess.run([program, *arguments], capture_output=True, text=True, **settings)
