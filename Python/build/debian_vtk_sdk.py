"""What the wheel of Vitrine is built with, put together from packages of Debian and the wheel of VTK itself.

VTK's own SDK, the package vtk-sdk, is on PyPI for no Linux. Debian's forky has the same VTK: its headers, CMake files
and wrapping tools are taken from there, and the libraries from the wheel, which are those that users load.
"""

import pathlib
import re
import shutil
import sys

from debian_packages import PackageError, Suite

VTK_SUITE = "forky"
VTK_PACKAGES = ["libvtk9-dev", "libvtk9.6", "python3-vtk9", "vtk9"]
LIBRARY_SUITE = "bookworm"  # the oldest supported: static libraries of it link everywhere
LIBRARY_PACKAGES = ["libglm-dev", "libcli11-dev", "nlohmann-json3-dev", "libpng-dev", "zlib1g-dev"]
LIBRARIES = "lib/x86_64-linux-gnu"


def put_together(version, vtkmodules, folder):
    """Return the prefix for CMake, in `folder`: VTK `version` with the libraries of the folder `vtkmodules`."""
    folder = pathlib.Path(folder)
    prefix = folder / "root/usr"
    done = folder / f"done-{version}-{sys.version_info.minor}"
    if not done.exists():
        shutil.rmtree(folder, ignore_errors=True)  # what an interrupted build, or another version's, has left
        _unpack(folder)
        _check_version(prefix, version)
        _wrap_tools(prefix, folder / "loader/usr" / LIBRARIES)
        _adapt_cmake_files(prefix)
        _adapt_headers(prefix)
        done.touch()
    _link_libraries(prefix, pathlib.Path(vtkmodules))
    return prefix


def _unpack(folder):
    vtk = Suite(VTK_SUITE, folder / VTK_SUITE)
    vtk.unpack(VTK_PACKAGES, folder / "root")
    vtk.unpack(["libc6"], folder / "loader")
    Suite(LIBRARY_SUITE, folder / LIBRARY_SUITE).unpack(LIBRARY_PACKAGES, folder / "root")


def _cmake_folder(prefix):
    return prefix / LIBRARIES / "cmake/vtk-9.6"


def _check_version(prefix, version):
    text = (_cmake_folder(prefix) / "vtk-config-version.cmake").read_text()
    found = re.search(r'PACKAGE_VERSION "([\d.]+)"', text).group(1)
    if found != version:
        raise PackageError(f"Debian's {VTK_SUITE} has VTK {found} by now, and {version} is needed")


def _wrap_tools(prefix, loader):
    """Run VTK's wrapping tools with the C library of their own suite, which this machine's may be older than."""
    for tool in (prefix / "bin").glob("vtkWrap*"):
        program = tool.with_name(f"{tool.name}.program")
        tool.rename(program)
        tool.write_text(
            f'#!/bin/sh\nexec "{loader}/ld-linux-x86-64.so.2" '
            f'--library-path "{loader}:{prefix / LIBRARIES}" "{program}" "$@"\n'
        )
        tool.chmod(0o755)


def _adapt_cmake_files(prefix):
    folder = _cmake_folder(prefix)
    for file in folder.glob("*.cmake"):
        text = file.read_text()
        text = re.sub(r"(lib(?:vtk|viskores)[\w.]*?)-9\.6\.so[\d.]*", r"\1.so", text)
        text = re.sub(r"3\.1\d\b", f"3.{sys.version_info.minor}", text) if "vtk" in file.name.lower() else text
        text = re.sub(r"(INTERFACE_LINK_LIBRARIES) \"(.*)\"", _only_vtk, text)
        text = re.sub(r"list\(APPEND _cmake_import_check.*\n", "", text)
        text = re.sub(r"(foreach\(_target) \"[^)]*", r"\1", text)
        text = re.sub(r'(_HAS_(?:VISKORES|VTKm)") "ON"', r'\1 "OFF"', text)
        file.write_text(text)
    (folder / "VTK-vtk-module-find-packages.cmake").write_text(
        "find_package(Threads)\nfind_package(Python3 COMPONENTS Interpreter Development.Module)\n"
    )
    targets = folder / "VTK-targets.cmake"
    targets.write_text(targets.read_text() + _LIBRARIES_OF_ITS_OWN)


# Of the libraries that Debian's VTK takes from elsewhere: those that Vitrine uses too.
_LIBRARIES_OF_ITS_OWN = f"""
get_filename_component(_prefix "${{CMAKE_CURRENT_LIST_DIR}}/../../../.." ABSOLUTE)
set_target_properties(VTK::nlohmannjson PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${{_prefix}}/include")
set_target_properties(VTK::png PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${{_prefix}}/include"
  INTERFACE_LINK_LIBRARIES "${{_prefix}}/{LIBRARIES}/libpng16.a;${{_prefix}}/{LIBRARIES}/libz.a;m")
"""


def _only_vtk(match):
    kept = [
        library
        for library in match.group(2).split(";")
        if library.startswith("VTK::") or library in ("Threads::Threads", "Python3::Module", "dl")
    ]
    return f'{match.group(1)} "{";".join(kept)}"'


def _adapt_headers(prefix):
    header = prefix / "include/vtk-9.6/vtkSMP.h"
    text = header.read_text().replace("VTK_SMP_ENABLE_TBB 1", "VTK_SMP_ENABLE_TBB 0")
    header.write_text(text)


def _link_libraries(prefix, vtkmodules):
    folder = prefix / LIBRARIES
    for library in vtkmodules.glob("lib*.so"):
        link = folder / library.name
        link.unlink(missing_ok=True)
        link.symlink_to(library)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(f"usage: {sys.argv[0]} VERSION VTKMODULES FOLDER: prints the prefix for CMake")
    print(put_together(sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()))
