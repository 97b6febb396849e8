"""What the wheel of Vitrine is built with, put together from packages of Debian and the wheel of VTK itself.

VTK's own SDK, the package vtk-sdk, is not on PyPI for Linux. Debian's forky has the same VTK: its headers, CMake files
and wrapping tools are taken from there, and the libraries from the wheel, which are those that users load.
"""

import contextlib
import fcntl
import pathlib
import re
import shutil
import sys
import zlib

from debian_packages import MIRROR, PackageError, Suite

VTK_SUITE = "forky"
LIBRARY_SUITE = "bookworm"  # the oldest supported: static libraries of it link everywhere
LIBRARY_PACKAGES = [
    *("libglm-dev", "libcli11-dev", "nlohmann-json3-dev", "libpng-dev", "zlib1g-dev"),
    *("libdraco-dev", "libmeshoptimizer-dev", "libmeshoptimizer2d"),
    *("libopenmesh-dev", "libopenmesh1"),
]
LIBRARIES = "lib/x86_64-linux-gnu"
SNAPSHOT = "https://snapshot.debian.org/archive/debian/20261101T000000Z"  # of the day with VTK 9.6.2 in forky


@contextlib.contextmanager
def sdk(version, vtkmodules, folder):
    """The prefix for CMake, in `folder`: VTK `version` with the libraries of the folder `vtkmodules`.

    Within the `with`, no other build has the folder.
    """
    recipe = zlib.crc32(pathlib.Path(__file__).read_bytes())
    complete = folder / f"{version}-cp3{sys.version_info.minor}-{recipe:08x}"
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not complete.exists():
            _put_together(version, folder / "incomplete").rename(complete)
        _link_libraries(complete / "root/usr", vtkmodules)
        yield complete / "root/usr"


def _put_together(version, folder):
    shutil.rmtree(folder, ignore_errors=True)  # what an interrupted build has left
    prefix = folder / "root/usr"
    _unpack(version, folder)
    _wrap_tools(prefix)
    _adapt_cmake_files(prefix, version)
    _adapt_headers(prefix, version)
    return folder


def _series(version):
    """The part of a version of VTK that Debian's names have, such as "9.6"."""
    return ".".join(version.split(".")[:2])


def _unpack(version, folder):
    apt = folder / "apt"
    packages = ["libvtk9-dev", f"libvtk{_series(version)}", "python3-vtk9", "vtk9"]
    vtk = Suite(VTK_SUITE, apt / VTK_SUITE)
    try:
        vtk.unpack([f"{package}={version}*" for package in packages], folder / "root")
    except PackageError as error:
        raise PackageError(
            f"{error}. Where {VTK_SUITE} has gone on to another VTK, set the environment variable {MIRROR} to a mirror "
            f"that still has this one: {SNAPSHOT}"
        ) from error
    vtk.unpack(["libc6"], folder / "loader")
    Suite(LIBRARY_SUITE, apt / LIBRARY_SUITE, security=True).unpack(
        LIBRARY_PACKAGES, folder / "root"
    )
    shutil.rmtree(apt)


def _wrap_tools(prefix):
    """Run VTK's wrapping tools with the C library of their own suite, which this machine's may be older than."""
    for tool in list((prefix / "bin").glob("vtkWrap*")):
        tool.rename(tool.with_name(f"{tool.name}.program"))
        tool.write_text(
            "#!/bin/sh\nprefix=${0%/*}/..\nloader=$prefix/../../loader/usr/"
            f'{LIBRARIES}\nexec "$loader/ld-linux-x86-64.so.2" '
            f'--library-path "$loader:$prefix/{LIBRARIES}" "$0.program" "$@"\n'
        )
        tool.chmod(0o755)


def _adapt_cmake_files(prefix, version):
    folder = prefix / LIBRARIES / f"cmake/vtk-{_series(version)}"
    versioned = rf"(lib(?:vtk|viskores)[\w.]*?)-{re.escape(_series(version))}\.so[\d.]*"
    for file in folder.glob("*.cmake"):
        text = file.read_text()
        text = re.sub(versioned, r"\1.so", text)
        if "vtk" in file.name.lower():
            text = re.sub(r"3\.1\d\b", f"3.{sys.version_info.minor}", text)
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


# Of the libraries that Debian's VTK takes from elsewhere: those that Vitrine uses too. Its wheel has a libpng and a
# zlib of its own, whose functions have a prefix, and no headers of them. All versions 1.6 and 1 have one interface.
_PNG_FUNCTIONS = ("begin_read_from_memory", "finish_read", "free")
_PREFIXED = ";".join(f"png_image_{name}=vtkpng_png_image_{name}" for name in _PNG_FUNCTIONS)
_ZLIB_FUNCTIONS = ("crc32", "inflate", "inflateEnd", "inflateInit2_")
_PREFIXED_ZLIB = ";".join(f"{name}=vtkzlib_{name}" for name in _ZLIB_FUNCTIONS)
_LIBRARIES_OF_ITS_OWN = f"""
get_filename_component(_prefix "${{CMAKE_CURRENT_LIST_DIR}}/../../../.." ABSOLUTE)
set_target_properties(VTK::nlohmannjson PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${{_prefix}}/include")
set_target_properties(VTK::png PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${{_prefix}}/include"
  INTERFACE_COMPILE_DEFINITIONS "{_PREFIXED}"
  INTERFACE_LINK_LIBRARIES "${{_prefix}}/{LIBRARIES}/libvtkpng.so")
set_target_properties(VTK::zlib PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${{_prefix}}/include"
  INTERFACE_COMPILE_DEFINITIONS "{_PREFIXED_ZLIB}"
  INTERFACE_LINK_LIBRARIES "${{_prefix}}/{LIBRARIES}/libvtkzlib.so")
"""


def _only_vtk(match):
    kept = [
        library
        for library in match.group(2).split(";")
        if library.startswith("VTK::") or library in ("Threads::Threads", "Python3::Module", "dl")
    ]
    return f'{match.group(1)} "{";".join(kept)}"'


def _adapt_headers(prefix, version):
    header = prefix / f"include/vtk-{_series(version)}/vtkSMP.h"
    text = header.read_text().replace("VTK_SMP_ENABLE_TBB 1", "VTK_SMP_ENABLE_TBB 0")
    header.write_text(text)


def _link_libraries(prefix, vtkmodules):
    for library in vtkmodules.glob("lib*.so"):
        link = prefix / LIBRARIES / library.name
        link.unlink(missing_ok=True)
        link.symlink_to(library)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(f"usage: {sys.argv[0]} VERSION VTKMODULES FOLDER: prints the prefix for CMake")
    try:
        with sdk(
            sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
        ) as prefix:
            print(prefix)
    except PackageError as error:
        sys.exit(str(error))
