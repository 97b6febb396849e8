#!python
"""The program vitrine on PATH. It runs vitrine/__main__.py without the package, which would load all of VTK."""

import importlib.util
import runpy

folder = importlib.util.find_spec("vitrine").submodule_search_locations[0]
runpy.run_path(f"{folder}/__main__.py", run_name="__main__")
