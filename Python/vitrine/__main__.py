"""The program vitrine: python -m vitrine, or vitrine on PATH where a wheel is installed."""

from __future__ import annotations

import importlib
import importlib.util
import os
import pathlib
import runpy
import sys
from typing import Any


def program() -> pathlib.Path:
    """The program's file: in this package, as in a wheel, or in bin of the prefix or build tree around the package.

    Raises FileNotFoundError where there is none.
    """
    package = pathlib.Path(__file__).resolve().parent
    places = [package / "bin/vitrine"]
    # Elsewhere bin may have the script that runs this file.
    if package.parts[-4:-1] == ("lib", "python3", "dist-packages"):
        places.append(package.parents[3] / "bin/vitrine")
    for place in places:
        if place.is_file():
            return place
    raise FileNotFoundError(
        f"this installation has the package without the program ({' or '.join(map(str, places))})"
    )


def environment() -> dict[str, str]:
    """The variables that the program needs: where VTK's libraries lie, and what converts STEP."""
    vtk = importlib.util.find_spec("vtkmodules")
    folders = list(vtk.submodule_search_locations or []) if vtk else []
    path = ":".join(filter(None, [*folders, os.environ.get("LD_LIBRARY_PATH")]))
    variables = {**os.environ, "LD_LIBRARY_PATH": path}
    # The package itself would load all of VTK.
    converter = runpy.run_path(str(pathlib.Path(__file__).with_name("_cad.py")))["command"]()
    if converter is not None:
        variables["VITRINE_CAD_CONVERTER"] = converter
    return variables


def command_of_package(arguments: list[str]) -> Any:
    """The main function of a command that the package itself does, which loads all of VTK, or None.

    Raises ModuleNotFoundError if a package is missing that the command needs.
    """
    name, states = (arguments or [""])[0], [text for text in arguments if text.endswith(".json") and text[0] != "-"]
    if name == "inspect":
        return importlib.import_module("vitrine.inspector.__main__").main
    if name == "explore":
        return importlib.import_module("vitrine.explore.__main__").main
    if name == "render" and states:
        return importlib.import_module("vitrine.inspector._render").main
    return None


def main() -> None:
    """Do a command of the package, or become the program, with this process's arguments."""
    try:
        command = command_of_package(sys.argv[1:])
    except ModuleNotFoundError as error:
        print(f"vitrine: this needs {error.name}: pip install 'vtk-vitrine[inspect]'", file=sys.stderr)
        sys.exit(2)
    if command is not None:
        sys.exit(command(sys.argv[2:]))
    try:
        file = program()
    except FileNotFoundError as error:
        sys.exit(f"vitrine: {error}")
    os.execve(file, ["vitrine", *sys.argv[1:]], environment())


if __name__ == "__main__":
    main()
