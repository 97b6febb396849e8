"""Recorded shaders through glslang, a front end that is strict: as they are, and as GLSL 4.50 for any driver."""

import os
import pathlib
import re
import resource
import subprocess
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

from table import Cell

# What GLSL 4.50 has without them.
IN_CORE = r"GL_ARB_(?:explicit|gpu_shader5|shader_bit|shader_image|shader_storage|shading|compute|enhanced)\w*"
SECONDS = 5  # of the processor, for one shader
MEMORY = 1 << 30  # bytes, for one shader
FETCHED = re.compile(r"^(layout\(location *= *\d+\)) *inout\b", re.M)


def limit_glslang():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def run_glslang(*arguments):
    """Lines that tell errors, without the places where those are."""
    done = subprocess.run(
        ["glslangValidator", *map(str, arguments)], capture_output=True, text=True, errors="replace", check=False,
        preexec_fn=limit_glslang)
    if done.returncode < 0:
        return [f"takes more than {SECONDS} s or {MEMORY >> 30} GiB"]
    if done.returncode == 0:
        return []
    lines = (re.sub(r"^ERROR: (?:\S+?:)?\d*:?\s*", "", line) for line in done.stdout.splitlines() if "ERROR:" in line)
    return [line for line in lines if "compilation errors" not in line] or ["glslang ends without a reason"]


def mended(text):
    """The text without continued lines, which GLSL 1.50 does not have, and without `precise`.

    glslang 12 follows `precise` backwards through the fields of structures, which has no end for merges of many runs.
    """
    return re.sub(r"\bprecise ", "", re.sub(r"\\\n", " ", text))


def as_450(text):
    """The text as GLSL 4.50. Framebuffer fetch, which glslang knows for OpenGL ES only, becomes a plain output."""
    text = mended(text)
    if not re.search(r"#version (?:150|4\d\d)", text):
        return text
    text = re.sub(r"#version \d+[^\n]*", "#version 450", text, count=1)
    text = re.sub(rf"#extension {IN_CORE}[^\n]*\n", "\n", text)
    if "GL_EXT_shader_framebuffer_fetch" in text:
        text = re.sub(r"#extension GL_EXT_shader_framebuffer_fetch[^\n]*", "", text)
        text = FETCHED.sub(r"\1 out", text)
    return text


def for_vulkan(text):
    text = re.sub(r"#version \d+[^\n]*", "#version 450", mended(text), count=1)
    return text.replace("gl_VertexID", "gl_VertexIndex").replace("gl_InstanceID", "gl_InstanceIndex")


def spirv_bindings(modules):
    """Kinds of the resources of SPIR-V modules, as compile_pipelines names them, by their bindings."""
    kinds = {}
    for module in modules:
        text = subprocess.run(["spirv-dis", str(module)], capture_output=True, text=True, check=True).stdout
        bindings = dict(re.findall(r"OpDecorate (%\w+) Binding (\d+)", text))
        variables = dict(re.findall(r"(%\w+) = OpVariable (%\w+)", text))
        pointers = {name: (kind, to) for name, kind, to in re.findall(r"(%\w+) = OpTypePointer (\w+) (%\w+)", text)}
        types = dict(re.findall(r"(%\w+) = (OpType\w+[^\n]*)", text))
        for variable, number in bindings.items():
            storage, kind = pointers[variables[variable]]
            kinds[int(number)] = binding_kind(storage, kind, types)
    return kinds


def binding_kind(storage, kind, types):
    if storage in ("StorageBuffer", "Uniform"):
        return "ssbo" if storage == "StorageBuffer" else "ubo"
    words = types.get(kind, "").split()
    is_sampled = words[0] == "OpTypeSampledImage"
    if is_sampled:
        words = types[words[1]].split()
    if "Buffer" in words:
        return "buffer-texture" if is_sampled else "buffer-image"
    return "texture" if is_sampled else "image"


WAYS = {"as they are": lambda text: text, "as GLSL 4.50": as_450}


def check_front_end(folder, programs, way):
    """Cells of all shaders in one of WAYS: one that is good, and one for each different error."""
    shaders = {}  # a file by its kind and text, as programs share vertex shaders
    for file in sorted({file for program in programs for file in program.files}):
        text = (folder / file).read_text(encoding="utf-8")
        shaders.setdefault((pathlib.Path(file).suffix, text), file)
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        for (_, text), file in shaders.items():
            pathlib.Path(scratch, file).write_text(WAYS[way](text), encoding="utf-8")
        said = list(pool.map(run_glslang, (pathlib.Path(scratch, file) for file in shaders.values())))
    good = sum(not lines for lines in said)
    errors = Counter(lines[0].strip()[:120] for lines in said if lines)
    return [
        Cell(f"glslang, {way}", "none", "ok", f"{good} of {len(shaders)} shaders"),
        *(Cell(f"glslang, {way}", error, "fails", f"{count} shaders") for error, count in errors.most_common())]
