"""The build backend of Vitrine's wheel (PEP 517): scikit-build-core, given a VTK to build against.

Where the package vtk-sdk is installed (pip install --no-build-isolation), that is the one; else debian_vtk_sdk puts one
together in build/vtk-sdk.
"""

import importlib.util
import pathlib
import re
import sys

from scikit_build_core import build as scikit
from scikit_build_core.build import (  # noqa: F401, hooks that need no VTK
    build_sdist,
    get_requires_for_build_sdist,
    prepare_metadata_for_build_wheel,
)

from debian_packages import PackageError
from debian_vtk_sdk import put_together

PROJECT = pathlib.Path(__file__).resolve().parents[2] / "pyproject.toml"
VTK_VERSION = re.search(r'"vtk==([\d.]+)"', PROJECT.read_text()).group(1)


def get_requires_for_build_wheel(config_settings=None):
    return [*scikit.get_requires_for_build_wheel(config_settings), f"vtk=={VTK_VERSION}"]


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    return scikit.build_wheel(wheel_directory, _with_vtk(config_settings), metadata_directory)


def _with_vtk(config_settings):
    settings = dict(config_settings or {})
    if importlib.util.find_spec("vtk_sdk") is None and "cmake.define.CMAKE_PREFIX_PATH" not in settings:
        settings["cmake.define.CMAKE_PREFIX_PATH"] = str(_sdk())
    return settings


def _sdk():
    vtkmodules = importlib.util.find_spec("vtkmodules").submodule_search_locations[0]
    try:
        return put_together(VTK_VERSION, vtkmodules, pathlib.Path("build/vtk-sdk").resolve())
    except PackageError as error:
        sys.exit(
            f"Vitrine needs the SDK of VTK {VTK_VERSION}, and it cannot be put together from Debian's packages: "
            f"{error}. With the package vtk-sdk {VTK_VERSION} of VTK installed, use pip install --no-build-isolation."
        )
