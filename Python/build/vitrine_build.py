"""The build backend of Vitrine's wheel (PEP 517): scikit-build-core, given a VTK to build against.

Where the package vtk-sdk is installed (pip install --no-build-isolation), that is the one; else debian_vtk_sdk puts one
together in build/vtk-sdk.
"""

import contextlib
import importlib.metadata
import importlib.util
import pathlib
import platform
import re
import sys

from scikit_build_core import build as scikit
from scikit_build_core.build import (  # noqa: F401, hooks that need no VTK
    build_sdist,
    get_requires_for_build_sdist,
    prepare_metadata_for_build_wheel,
)

PROJECT = pathlib.Path(__file__).resolve().parents[2] / "pyproject.toml"
VTK_VERSION = re.search(r'"vtk==([\d.]+)"', PROJECT.read_text()).group(1)


def get_requires_for_build_wheel(config_settings=None):
    _check_machine()
    return [*scikit.get_requires_for_build_wheel(config_settings), f"vtk=={VTK_VERSION}"]


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with _vtk(config_settings or {}) as settings:
        return scikit.build_wheel(wheel_directory, settings, metadata_directory)


def build_editable(*_arguments, **_settings):
    sys.exit(
        "Vitrine cannot be installed as editable. CONTRIBUTING.md says how to build it in place."
    )


get_requires_for_build_editable = build_editable


def _check_machine():
    if (sys.platform, platform.machine()) != ("linux", "x86_64"):
        sys.exit("Vitrine's wheel is for Linux on x86-64 only.")


@contextlib.contextmanager
def _vtk(settings):
    """The settings, with a VTK for CMake to find."""
    if "cmake.define.CMAKE_PREFIX_PATH" in settings:
        yield settings
    elif importlib.util.find_spec("vtk_sdk"):
        _check_version("vtk-sdk")
        yield settings
    else:
        _check_machine()
        _check_version("vtk")
        with _debian_sdk() as prefix:
            yield {**settings, "cmake.define.CMAKE_PREFIX_PATH": str(prefix)}


@contextlib.contextmanager
def _debian_sdk():
    from debian_vtk_sdk import PackageError, sdk  # which only Linux can import

    vtkmodules = importlib.util.find_spec("vtkmodules").submodule_search_locations[0]
    try:
        with sdk(
            VTK_VERSION, pathlib.Path(vtkmodules), pathlib.Path("build/vtk-sdk").resolve()
        ) as prefix:
            yield prefix
    except PackageError as error:
        sys.exit(
            f"Vitrine needs the SDK of VTK {VTK_VERSION}, and it cannot be put together from Debian's packages: "
            f"{error}"
        )


def _check_version(package):
    try:
        found = importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        found = "none"
    if found != VTK_VERSION:
        sys.exit(
            f"Vitrine is built with {package} {VTK_VERSION}, and this environment has {found}: "
            f"pip install {package}=={VTK_VERSION}"
        )
