"""The state of an inspector: one JSON object that a picture depends on, its defaults, reading, checking and writing."""

from __future__ import annotations

import contextlib
import copy
import functools
import json
import os
import pathlib
import tempfile
from typing import Any, Iterator, Mapping

from .._unpack import is_demo

State = dict[str, Any]
FORMAT = 1
LARGEST_FILE = 64 << 20  # bytes; a state of 100,000 parts has some 10 MB
_SCHEMA = pathlib.Path(__file__).with_name("state.schema.json")

DEFAULTS: State = {
    "vitrine": FORMAT,
    "files": [],
    "size": [1024, 640],
    "parts": {},
    "selected": [],
    "highlight": [],
    "explode": 0.0,
    "sections": [],
    "box": None,
    "caps": {"show": True, "hatch": "none", "edges": 1, "stripes": True},
    "reveal": None,
    "x_ray": None,
    "views": {},
    "lights": "headlight",
    "background": "#ffffff",
    "method": "prefix-sum-predicted",
    "error": None,
    "coincidence": None,
    "cull": True,
    "levels": None,
}
REVEAL_DEFAULTS = {"share": 0.7, "cutaway": False}
X_RAY_DEFAULTS = {"falloff": 2.0, "floor": 0.05}
CAMERA_DEFAULTS = {"view_angle": 30.0, "parallel_scale": 1.0, "parallel": False}


def complete(given: Any) -> State:
    """A state that has all keys but perhaps "camera": those that were given, and defaults for others.

    Raises ValueError with the first thing that is not as state.schema.json says, and ImportError if jsonschema is not
    installed.
    """
    check(given)
    return with_defaults(given)


def with_defaults(given: Mapping[str, Any]) -> State:
    """A complete state of one that is valid."""
    state = {**copy.deepcopy(DEFAULTS), **copy.deepcopy(dict(given))}
    state["caps"] = {**DEFAULTS["caps"], **state["caps"]}
    state["size"] = [int(side) for side in state["size"]]
    if state["error"] is not None and "method" not in given:
        state["method"] = "automatic"
    for key, defaults in (("reveal", REVEAL_DEFAULTS), ("x_ray", X_RAY_DEFAULTS)):
        if state[key] is not None:
            state[key] = {**defaults, **state[key]}
    for camera in [*state["views"].values(), *([state["camera"]] if "camera" in state else [])]:
        camera.update({**CAMERA_DEFAULTS, **camera})
    return state


def check(given: Any) -> None:
    """Raise ValueError with the first thing in a state that is not as state.schema.json says."""
    try:
        json.dumps(given, ensure_ascii=False).encode()
    except UnicodeEncodeError:
        raise ValueError("the state is not valid: it has a text with half of a surrogate pair") from None
    except (TypeError, ValueError):
        pass  # which the schema tells better
    validator, best_match = _validator()
    error = best_match(validator.iter_errors(given))
    if error is not None:
        place = "".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in error.absolute_path)
        raise ValueError(f"the state is not valid at {place.lstrip('.') or 'its top'}: {_short(error.message)}")
    for camera in [*given.get("views", {}).values(), *([given["camera"]] if "camera" in given else [])]:
        _check_camera(camera)


def _check_camera(camera: Mapping[str, Any]) -> None:
    """Raise ValueError for a camera that looks nowhere."""
    direction = [a - b for a, b in zip(camera["focal_point"], camera["position"])]
    up = camera["view_up"]
    across = [up[i - 2] * direction[i - 1] - up[i - 1] * direction[i - 2] for i in range(3)]
    if not any(across):
        raise ValueError("the state is not valid at camera: position, focal_point and view_up give no direction")


@functools.lru_cache(maxsize=None)
def _validator() -> tuple[Any, Any]:
    try:
        import jsonschema
    except ImportError:
        raise ImportError(
            "states are checked by jsonschema, which is not installed: "
            "pip install 'vtk-vitrine[inspect]', or apt install python3-jsonschema"
        ) from None
    schema = json.loads(_SCHEMA.read_text())
    return jsonschema.Draft202012Validator(schema), jsonschema.exceptions.best_match


def _short(text: str, most: int = 200) -> str:
    return text if len(text) <= most else f"{text[: most - 3]}..."


def read(path: str | os.PathLike[str]) -> State:
    """The complete state of a file. Paths of files in it become absolute.

    Raises FileNotFoundError, IsADirectoryError, or ValueError if it is no state.
    """
    file = pathlib.Path(path)
    if file.is_dir():
        raise IsADirectoryError(f"{file}: is a folder, not a file")
    if not file.is_file():
        raise FileNotFoundError(f"{file}: there is no such file")
    if file.stat().st_size > LARGEST_FILE:
        raise ValueError(f"{file}: is no state of the inspector: it has more than {LARGEST_FILE >> 20} MiB")
    try:
        state = complete(parse(file.read_bytes()))
    except ValueError as error:
        raise ValueError(f"{file}: {error}") from None
    for entry in state["files"]:
        if not is_demo(entry["path"]):
            entry["path"] = os.path.normpath(file.absolute().parent / entry["path"])
    return state


def parse(text: str | bytes) -> Any:
    """The value of a JSON text, in which numbers are finite and keys differ. Raises ValueError."""

    def refuse(constant: str) -> Any:
        raise ValueError(f"the text has {constant}, which JSON has not")

    def differing(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        keys = dict(pairs)
        if len(keys) < len(pairs):
            raise ValueError("the text has a key twice in one object")
        return keys

    try:
        return json.loads(text, parse_constant=refuse, object_pairs_hook=differing)
    except UnicodeDecodeError:
        raise ValueError("the text is no JSON: it is not UTF-8") from None
    except json.JSONDecodeError as error:
        raise ValueError(f"the text is no JSON: {error}") from None
    except RecursionError:
        raise ValueError("the text is nested too deeply") from None


def write(state: State, path: str | os.PathLike[str]) -> None:
    """Write a state. Paths of files that lie in its folder, or below it, become relative. Raises OSError."""
    file = pathlib.Path(path)
    stored = copy.deepcopy(state)
    folder = file.absolute().parent
    for entry in stored["files"]:
        entry["path"] = _relative(entry["path"], folder)
    write_whole(file, text_of(stored))


def text_of(state: State) -> bytes:
    """A state as a JSON file."""
    return (json.dumps(state, indent=1, ensure_ascii=False) + "\n").encode()


def _relative(path: str, folder: pathlib.Path) -> str:
    if is_demo(path):
        return path
    try:
        return pathlib.Path(path).absolute().relative_to(folder).as_posix()
    except ValueError:
        return path


def write_whole(path: str | os.PathLike[str], data: bytes) -> None:
    """Write a file at once, so that nobody sees a half of it. Raises OSError."""
    with unfinished(path) as file:
        file.write_bytes(data)


@contextlib.contextmanager
def unfinished(path: str | os.PathLike[str]) -> Iterator[pathlib.Path]:
    """A file that is to be written, and takes the place of `path` at the end. After an error none is left.

    Raises OSError with the name that the user gave.
    """
    file = pathlib.Path(path)
    try:
        descriptor, name = tempfile.mkstemp(dir=file.absolute().parent, prefix=f".{file.stem}.", suffix=file.suffix)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(file)) from None
    os.close(descriptor)
    try:
        yield pathlib.Path(name)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(name, 0o666 & ~mask)
        os.replace(name, file)
    except BaseException:
        pathlib.Path(name).unlink(missing_ok=True)
        raise
