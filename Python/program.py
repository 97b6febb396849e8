#!python
"""The program vitrine on PATH: vitrine/__main__.py, without importing the package, which would load all of VTK first."""

import importlib.util
import runpy

folder = importlib.util.find_spec("vitrine").submodule_search_locations[0]
runpy.run_path(f"{folder}/__main__.py", run_name="__main__")
