"""Pictures in tests, for pytest, unittest and others: assert_image() compares a picture with a baseline.

    import vitrine.testing

    def test_scene():
        vitrine.testing.assert_image(draw_scene(), "baselines/scene.png", tolerance=1, share=0.001)

The comparison is the program's: `vitrine diff --help`.
"""

from __future__ import annotations

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
from typing import Any, Iterable

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from . import __main__ as _main

__all__ = ["assert_image"]

_BYTE = "B"  # the format of a buffer of unsigned bytes

# Exit statuses of `vitrine diff`.
_MATCHES = 0
_DIFFERS = 1
_CANNOT_COMPARE = 2


def assert_image(
    image: Any,
    baseline: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    *,
    tolerance: int = 0,
    share: float = 0.0,
    flip: float | None = None,
) -> None:
    """Raise AssertionError unless a picture matches a baseline.

    Args:
        image: a vtkRenderWindow or a pyvista.Plotter, which are drawn; a vtkImageData of bytes; an array of bytes, as
            NumPy's, rows from the top, with one value, RGB or RGBA for each pixel; or the name of a PNG file.
        baseline: the name of a PNG file, or several names. The picture has to match one of them; there may be one for
            each driver or version of VTK. Those that are not there are passed over, if one is there.
        tolerance: the largest difference of any channel that counts as none, in steps of 1/255, from 0 to 255.
        share: of the pixels, from 0 to 1, which may differ by more.
        flip: the largest mean of FLIP, from 0 to 1. None does not ask for it.

    Where it raises, it leaves the picture, the difference and a heat map of FLIP in a folder, and the message names
    them and the first pixels. The folder is named after the test and the baseline. It lies below the folder of the
    environment variable VITRINE_TEST_OUTPUT, or else below vitrine-test-output of the current folder.

    With VITRINE_UPDATE_BASELINES=1 in the environment, a picture that matches no baseline is written over the first
    one instead, whose folder is made. ON, YES, TRUE and Y mean the same as 1, as in CMake.

    Raises:
        AssertionError: the picture matches no baseline.
        TypeError: the image is no picture.
        ValueError: a tolerance is out of range, or a file is no PNG.
        RuntimeError: the program that compares crashed.
        FileNotFoundError: the program was not installed with the package.
    """
    baselines = [pathlib.Path(file) for file in _as_list(baseline)]
    if not baselines:
        raise ValueError("assert_image() needs one baseline at least")
    with tempfile.TemporaryDirectory() as scratch:
        picture = _picture_file(image, pathlib.Path(scratch, "picture.png"))
        failure = _compare(picture, baselines, _options(tolerance, share, flip), scratch)
        if failure is not None:
            folder = _output_folder(baselines[0])
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(scratch, folder)
            raise AssertionError(failure.replace(scratch, str(folder)))


def _compare(
    picture: pathlib.Path, baselines: list[pathlib.Path], options: list[str], folder: str
) -> str | None:
    """Why the picture matches none of the baselines, after pictures of that were written; None if it matches one."""
    if _is_true(os.environ.get("VITRINE_UPDATE_BASELINES", "")):
        options = [*options, "--update"]
    elif not any(file.exists() for file in baselines):
        return f"{baselines[0]} is not there. VITRINE_UPDATE_BASELINES=1 in the environment makes it from {picture}"
    done = subprocess.run(
        [_main.program(), "diff", picture, *baselines, *options, "--out", folder],
        env=_main.environment(),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode == _MATCHES:
        return None
    if done.returncode == _DIFFERS:
        return f"{done.stdout}picture: {picture}"
    if done.returncode == _CANNOT_COMPARE:
        raise ValueError(done.stderr.strip().removeprefix("vitrine: "))
    raise RuntimeError(f"`vitrine diff` ended with status {done.returncode}: {done.stderr.strip()}")


def _is_true(value: str) -> bool:
    """Whether CMake's if() takes the text for true, as CTest's tests do (VitrineImageTestRun.cmake)."""
    if value.upper() in ("ON", "YES", "TRUE", "Y"):
        return True
    try:
        return float(value) != 0
    except ValueError:
        return False


def _as_list(baseline: Any) -> list[Any]:
    return [baseline] if isinstance(baseline, (str, os.PathLike)) else list(baseline)


def _options(tolerance: int, share: float, flip: float | None) -> list[str]:
    options = ["--tolerance", str(tolerance), "--share", repr(float(share))]
    return options if flip is None else [*options, "--flip", repr(float(flip))]


def _output_folder(baseline: pathlib.Path) -> pathlib.Path:
    """Of its own for each test of pytest, which may run several at a time."""
    output = os.environ.get("VITRINE_TEST_OUTPUT") or "vitrine-test-output"
    file, _, test = os.environ.get("PYTEST_CURRENT_TEST", "").rpartition(" ")[0].partition("::")
    parts = filter(None, (pathlib.PurePath(file).name, test, baseline.stem))
    name = re.sub(r"[^A-Za-z0-9._]+", "-", "-".join(parts))
    return pathlib.Path(output).absolute() / name


def _picture_file(image: Any, file: pathlib.Path) -> pathlib.Path:
    """The picture as a PNG: the file that it is already, or `file`, which is written."""
    if isinstance(image, (str, os.PathLike)):
        return pathlib.Path(image)
    if isinstance(image, vtkRenderWindow):
        _write(_grab(image), file)
    elif isinstance(image, vtkImageData):
        _write(image, file)
    elif hasattr(image, "screenshot") and hasattr(image, "render_window"):
        _write(_from_array(image.screenshot(None, return_img=True)), file)
    else:
        _write(_from_array(image), file)
    return file


def _grab(window: vtkRenderWindow) -> vtkImageData:
    """What the window shows, drawn anew, without alpha."""
    from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    grabber.Update()
    return grabber.GetOutput()


def _from_array(array: Any) -> vtkImageData:
    """An image of what has a buffer of bytes: (rows, columns) or (rows, columns, channels), rows from the top."""
    from vtkmodules.vtkIOImage import vtkImageImport

    try:
        view = memoryview(array)
    except TypeError as error:
        raise TypeError(f"assert_image() takes no {type(array).__name__} for a picture") from error
    channels = view.shape[2] if view.ndim == 3 else 1
    if view.format != _BYTE or view.ndim not in (2, 3) or channels not in (1, 3, 4):
        raise TypeError(
            "assert_image() takes arrays of unsigned bytes, (rows, columns) or (rows, columns, 3 or 4), "
            f"not of {view.format!r} and shape {view.shape}"
        )
    rows, columns = view.shape[:2]
    if rows == 0 or columns == 0:
        raise ValueError(f"assert_image() takes no picture without pixels: its shape is {view.shape}")
    data, length = view.tobytes(), columns * channels
    upwards = b"".join(data[row * length : (row + 1) * length] for row in reversed(range(rows)))
    importer = vtkImageImport()
    importer.CopyImportVoidPointer(upwards, len(upwards))
    importer.SetDataScalarTypeToUnsignedChar()
    importer.SetNumberOfScalarComponents(channels)
    importer.SetWholeExtent(0, columns - 1, 0, rows - 1, 0, 0)
    importer.SetDataExtentToWholeExtent()
    importer.Update()
    image = vtkImageData()
    image.DeepCopy(importer.GetOutput())  # whose bytes go with the importer
    return image


def _write(image: vtkImageData, file: pathlib.Path) -> None:
    from vtkmodules.vtkIOImage import vtkPNGWriter

    if image.GetScalarTypeAsString() != "unsigned char":
        raise TypeError(
            f"assert_image() takes a vtkImageData of unsigned char, not of {image.GetScalarTypeAsString()}"
        )
    writer = vtkPNGWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(image)
    writer.Write()
