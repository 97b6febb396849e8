"""Compiles recorded programs for null devices: by OpenGL drivers of Mesa, and by its Vulkan driver RADV."""

import os
import pathlib
import re
import tempfile
from concurrent.futures import ThreadPoolExecutor

from glsl import for_vulkan, run_glslang, spirv_bindings
from places import WORK, Place
from table import Compiled

UNCACHED = {"MESA_SHADER_CACHE_DISABLE": "true"}
LIMIT = 10  # seconds of the processor for one program, after which it is cut off
HANGS = 1800  # seconds of time for all programs of a device
RESULT = re.compile(r"^(\d+) (ok|failed|cut-off) [\d.]+ s ([\d.]+) s:")
INTEL = re.compile(r"(?:FS|CS) SIMD(\d+) shader: .*?(\d+):\d+ spills:fills")
NOUVEAU = re.compile(r"type: [45], local: (\d+).*?gpr: (\d+)")


def statistics_of(text):
    """Spills and registers in the messages for one program: None and nothing where the driver tells none."""
    widths = INTEL.findall(text)
    if widths:
        return max(int(spills) for _, spills in widths), "SIMD" + "/".join(width for width, _ in widths)
    nouveau = NOUVEAU.findall(text)
    if nouveau:
        return max(int(local) for local, _ in nouveau), f"{max(int(gpr) for _, gpr in nouveau)} registers"
    return None, ""


def read_results(output, device, programs):
    """What compile_shaders has printed of `programs`, from the first one that it names on."""
    results = []
    blocks = re.split(r"^(?=\d+ (?:ok|failed|cut-off) )", output, flags=re.M)
    for block in blocks:
        match = RESULT.match(block)
        if not match:
            continue
        number, state, seconds = match.groups()
        spills, registers = statistics_of(block)
        said = " ".join(line.strip() for line in block.splitlines()[1:])
        results.append(
            Compiled(
                device, programs[int(number)].name, float(seconds), spills, registers,
                error=f"does not compile: {said[:200]}" if state == "failed" else "", is_cut_off=state == "cut-off"))
    return results


def put_programs(place, folder, programs):
    """Put the folder of programs into the place, with a folder beside it for each list of those that fit devices."""
    place.put(folder, folder.name)
    for fetch in (False, True):
        lists = folder.parent / list_name(folder, fetch)
        lists.mkdir(exist_ok=True)
        lines = (
            " ".join(f"../{folder.name}/{file}" for file in program.files) for program in fitting(programs, fetch))
        (lists / "programs").write_text("\n".join(lines) + "\n", encoding="utf-8")
        place.put(lists, lists.name)


def list_name(folder, fetch):
    return f"{folder.name}-{'with' if fetch else 'without'}-fetch"


def fitting(programs, fetch):
    """The programs for devices with framebuffer fetch or without: those that need it are left out without."""
    return [program for program in programs if fetch or not program.fetch]


def compile_shaders(device, place, environment, folder, programs):
    """Compile the programs on the device's OpenGL driver. One that is cut off, or ends the process, is passed over."""
    listed = place.files / list_name(folder, device.fetch)
    results = []
    while len(results) < len(programs):
        command = [place.files / "bin/compile_shaders", listed, len(results), LIMIT]
        outcome = place.run(command, environment, HANGS)
        new = read_results(outcome.output, device.name, programs)
        results += new
        if outcome.status == 3 or len(results) == len(programs):
            continue
        if outcome.status == 2:
            return [*results, Compiled(device.name, "all", 0.0, error=outcome.messages.strip()[-200:])]
        name = programs[len(results)].name
        error = f"hangs for {HANGS} s" if outcome.hangs else f"the driver ends with status {outcome.status}"
        results.append(Compiled(device.name, name, 0.0, error=error))
    return results


def compile_pipeline(device, environment, folder, program):
    """Compile one program with RADV, through SPIR-V that glslang makes of it."""
    place = Place()
    with tempfile.TemporaryDirectory() as scratch:
        modules = []
        for file in program.files:
            source = pathlib.Path(scratch, file)
            source.write_text(for_vulkan((folder / file).read_text(encoding="utf-8")), encoding="utf-8")
            modules.append(pathlib.Path(scratch, f"{file}.spv"))
            said = run_glslang("-V", "-R", "--aml", "--amb", "--target-env", "vulkan1.2", "-o", modules[-1], source)
            if said:
                return Compiled(device.name, program.name, 0.0, error=f"glslang: {said[0]}")
        bindings = [f"{number}:{kind}" for number, kind in sorted(spirv_bindings(modules).items())]
        environment = environment | {"VK_ICD_FILENAMES": "/usr/share/vulkan/icd.d/radeon_icd.x86_64.json"}
        outcome = place.run([WORK / "bin/compile_pipelines", *modules, *bindings], environment, 4 * LIMIT)
    told = dict(re.findall(r"^  ([^:]+): (\d+)$", outcome.output, re.M))
    time = re.search(r"^ok [\d.]+ s ([\d.]+) s$", outcome.output, re.M)
    if outcome.hangs:
        return Compiled(device.name, program.name, 4 * LIMIT, is_cut_off=True)
    if not time:
        error = f"status {outcome.status} {outcome.messages.strip()[-200:]}"
        return Compiled(device.name, program.name, 0.0, error=error)
    spills = int(told.get("Spilled VGPRs", 0)) + int(told.get("Spilled SGPRs", 0))
    return Compiled(device.name, program.name, float(time[1]), spills, f"{told.get('VGPRs', '?')} VGPRs")


def compile_for(device, place, environment, folder, programs):
    """All results of a device, for which put_programs() has made its place ready."""
    environment = environment | UNCACHED
    programs = fitting(programs, device.fetch)
    if device.shim:
        return compile_shaders(device, place, environment, folder, programs)
    with ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        return list(pool.map(lambda program: compile_pipeline(device, environment, folder, program), programs))
