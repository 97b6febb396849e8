"""The program vitrine, as a wheel holds it: python -m vitrine, or vitrine on PATH."""

import importlib.util
import os
import pathlib
import sys


def _library_path() -> str:
    """The folder of VTK's libraries, which need not lie beside this package, before those of the environment."""
    vtk = importlib.util.find_spec("vtkmodules")
    folders = list(vtk.submodule_search_locations or []) if vtk else []
    return ":".join(filter(None, [*folders, os.environ.get("LD_LIBRARY_PATH")]))


def main() -> None:
    """Become the program, with this process's arguments."""
    program = pathlib.Path(__file__).parent / "bin" / "vitrine"
    if not program.is_file():
        sys.exit(f"vitrine: this installation has the package without the program ({program})")
    environment = {**os.environ, "LD_LIBRARY_PATH": _library_path()}
    os.execve(program, ["vitrine", *sys.argv[1:]], environment)


if __name__ == "__main__":
    main()
