"""Where drivers run: the machine's own Debian, or a root of Debian 13 with a newer Mesa; and how they get there.

All that is built or fetched goes to build/drivers and is kept. It comes from Debian's packages: the null devices are
`drm-shim` of Mesa's source package, which Debian builds but does not ship.
"""

import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import threading
import time
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = pathlib.Path(__file__).resolve().parent
WORK = ROOT / "build/drivers"
SHIMS = {
    "intel": "src/intel/tools/libintel_noop_drm_shim.so",
    "nouveau": "src/nouveau/drm-shim/libnouveau_noop_drm_shim.so",
}
MIRROR = "http://deb.debian.org/debian"
KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"
# What a root of Debian 13 needs for itself; the program's libraries that it lacks are copied into it.
ROOT_PACKAGES = "libgl1-mesa-dri,libegl1,libgl1,libopengl0,mesa-vulkan-drivers"
SYSTEM_LIBRARIES = "usr/lib/x86_64-linux-gnu"
# Variables that choose a driver, of which the caller's are not taken over.
CHOOSING = ("MESA_", "GALLIUM_", "LIBGL_", "VK_", "EGL_", "GL_RECORD_", "DISPLAY", "WAYLAND_DISPLAY", "LD_PRELOAD")


class SetupError(Exception):
    """Something that the drivers need could not be fetched or built."""


def run_quietly(command, **options):
    """Run a command; raise SetupError with the end of its output where it fails."""
    done = subprocess.run(
        [str(word) for word in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, errors="replace", **options)
    if done.returncode != 0:
        raise SetupError(f"{' '.join(map(str, command))}\n{done.stdout[-3000:]}")
    return done.stdout


def need(*commands):
    """Raise SetupError where one of the commands is not there."""
    for command in commands:
        if not shutil.which(command):
            raise SetupError(f"{command} is not installed")


def as_root(command):
    return command if os.geteuid() == 0 else ["sudo", "--non-interactive", *command]


def debian_mirror():
    """Where this machine gets its packages from."""
    known = subprocess.run(
        ["apt-get", "indextargets", "--format", "$(ORIGIN) $(CODENAME) $(REPO_URI)", "Created-By: Packages"],
        capture_output=True, text=True, check=False)
    found = re.search(r"^Debian bookworm (\S+)$", known.stdout, re.M)
    return found[1].rstrip("/") if found else MIRROR


@dataclass
class Outcome:
    """A process that has ended, or was ended because it took too long: then its status is None."""

    status: int | None
    output: str
    messages: str

    @property
    def hangs(self):
        return self.status is None


def text_of(data):
    return data.decode(errors="replace") if isinstance(data, bytes) else data or ""


class Place:
    """A file system to run in. Paths of `files` are those that processes in it see."""

    def __init__(self, root=None):
        self.root = root
        self.files = pathlib.Path("/opt/vitrine") if root else WORK
        self.seen_here = (root / "opt/vitrine") if root else WORK

    def environment(self, changes):
        kept = {key: value for key, value in os.environ.items() if not key.startswith(CHOOSING)}
        kept |= {"XDG_RUNTIME_DIR": str(self.files / "runtime"), "MESA_SHADER_CACHE_DIR": str(self.files / "cache")}
        if self.root:
            kept |= {"LD_LIBRARY_PATH": str(self.files / "lib"), "PATH": "/usr/bin:/bin"}
        return kept | changes

    def run(self, command, changes, limit):
        """Run a command with changes to the environment for at most `limit` seconds of time."""
        environment = self.environment(changes)
        command = [str(word) for word in command]
        if self.root:
            # What chooses a driver must not act on chroot itself.
            settings = [f"{key}={value}" for key, value in environment.items()]
            command = as_root(["chroot", str(self.root), "/usr/bin/env", "-i", *settings, *command])
            environment = None
        process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment,
            start_new_session=True)
        try:
            output, messages = process.communicate(timeout=limit)
            return Outcome(process.returncode, text_of(output), text_of(messages))
        except subprocess.TimeoutExpired:
            # All of the group: what still runs would hold the pipes open.
            kill = ["kill", "-KILL", "--", f"-{process.pid}"]
            subprocess.run(as_root(kill) if self.root else kill, check=False)
            output, messages = process.communicate()
            return Outcome(None, text_of(output), text_of(messages))

    def put(self, path, name):
        """Copy a file or folder of this machine to `name` in this place; returns the path that processes see."""
        target = self.seen_here / name
        if target != path:
            target.parent.mkdir(parents=True, exist_ok=True)
            if path.is_dir():
                shutil.rmtree(target, ignore_errors=True)
                shutil.copytree(path, target)
            else:
                # Processes may have the old file loaded, so it is replaced rather than written to.
                new = target.with_name(f"{target.name}.{threading.get_ident()}")
                shutil.copy2(path, new)
                new.replace(target)
        return self.files / name


TOOLS = {
    "gl_recorder.so": ["-shared", "-fPIC", "-ldl"],
    "compile_shaders": ["-lEGL", "-lGL"],
    "compile_pipelines": ["-lvulkan"],
}


def build_tool(name):
    """Compile one of the C programs of this folder into build/drivers/bin."""
    folder = WORK / "bin"
    folder.mkdir(parents=True, exist_ok=True)
    (WORK / "runtime").mkdir(mode=0o700, exist_ok=True)
    source = SOURCES / f"{pathlib.Path(name).stem}.c"
    if not is_newer(folder / name, source):
        run_quietly(
            ["cc", "-std=gnu11", "-O2", "-Wall", "-Wextra", "-o", folder / name, source, *TOOLS[name]])


def is_newer(made, source):
    return made.is_file() and made.stat().st_mtime >= source.stat().st_mtime


def mesa_source():
    """The folder of Mesa's source package of this Debian, fetched with a list of sources of our own."""
    folder = WORK / "mesa"
    found = [path for path in folder.glob("mesa-*") if path.is_dir()]
    if found:
        return found[0]
    lists = folder / "apt"
    (lists / "state/partial").mkdir(parents=True, exist_ok=True)
    (lists / "parts").mkdir(exist_ok=True)
    sources = f"deb-src [signed-by={KEYRING}] {debian_mirror()} bookworm main\n"
    (lists / "sources.list").write_text(sources, encoding="utf-8")
    options = [
        "-o", f"Dir::Etc::SourceList={lists / 'sources.list'}", "-o", f"Dir::Etc::SourceParts={lists / 'parts'}",
        "-o", f"Dir::State::Lists={lists / 'state'}", "-o", "APT::Sandbox::User="]
    run_quietly(["apt-get", *options, "update"])
    run_quietly(["apt-get", *options, "source", "mesa"], cwd=folder)
    return next(path for path in folder.glob("mesa-*") if path.is_dir())


def build_shim(name):
    """Build the null device of this name; returns its library."""
    build = WORK / "mesa/build"
    library = WORK / "lib" / pathlib.Path(SHIMS[name]).name
    if library.is_file():
        return library
    source = mesa_source()
    # Meson looks for modules of Python in the first interpreter of PATH, which has to be Debian's.
    environment = {**os.environ, "PATH": "/usr/sbin:/usr/bin:/sbin:/bin"}
    if not (build / "build.ninja").is_file():
        off = ("glx", "egl", "gbm", "llvm", "gles1", "gles2", "shared-glapi", "zstd", "libunwind", "valgrind")
        run_quietly(
            ["meson", "setup", build, "-Dbuildtype=plain", "-Db_ndebug=true", "-Dtools=drm-shim,intel",
             "-Dvulkan-drivers=", "-Dgallium-drivers=iris,nouveau,swrast", "-Dplatforms=",
             *(f"-D{option}=disabled" for option in off)],
            cwd=source, env=environment)
    run_quietly(["ninja", "-C", build, SHIMS[name]], env=environment)
    library.parent.mkdir(exist_ok=True)
    shutil.copy2(build / SHIMS[name], library)
    return library


def fingerprint(files):
    """A hash of the files, and of the libraries of this build that a program among them loads."""
    files = [pathlib.Path(file) for file in files]
    own = [path for file in files if os.access(file, os.X_OK) for path in libraries_of(file) if ROOT in path.parents]
    state = hashlib.sha256()
    for path in (*files, *own):
        state.update(path.read_bytes())
    return state.hexdigest()


def libraries_of(program):
    """The files of the shared libraries that the program loads."""
    output = run_quietly(["ldd", program])
    words = (line.split() for line in output.splitlines())
    return [pathlib.Path(line[2]) for line in words if len(line) > 2 and line[1] == "=>" and line[2].startswith("/")]


def make_root(root, program):
    """Make a root of Debian 13 where there is none, and put the program and what it lacks there into it."""
    if os.geteuid() != 0:
        need("sudo")
        run_quietly(as_root(["true"]))
    if not (root / "usr/share/vulkan/icd.d/lvp_icd.json").exists():
        root.parent.mkdir(parents=True, exist_ok=True)
        packages = f"--include={ROOT_PACKAGES}"
        run_quietly(as_root(["debootstrap", "--variant=minbase", packages, "trixie", str(root), debian_mirror()]))
    run_quietly(as_root(["chroot", str(root), "/usr/bin/true"]))
    folder = root / "opt/vitrine"
    if os.geteuid() != 0:
        run_quietly(as_root(["install", "-d", "-o", str(os.geteuid()), str(folder)]))
    for name in ("bin", "lib", "runtime"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    for library in libraries_of(program):
        if ROOT in library.parents or not (root / SYSTEM_LIBRARIES / library.name).exists():
            shutil.copy2(library, folder / "lib" / library.name)
    place = Place(root)
    place.put(program, "bin/vitrine")
    for name in ("bin/gl_recorder.so", "bin/compile_shaders"):
        place.put(WORK / name, name)
    return place


class Clock:
    """Tells what is done and how long it took."""

    def __init__(self):
        self.start = time.monotonic()

    def say(self, text):
        print(f"[{time.monotonic() - self.start:5.0f} s] {text}", flush=True)
