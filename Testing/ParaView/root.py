"""A root of Debian with ParaView, in which the plugin is built and run. Debian 12's packages of ParaView and of VTK
exclude each other, so they are not installed on the machine itself.
"""

import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing/Drivers"))

from places import SetupError, as_root, debian_mirror, need, run_quietly  # noqa: E402

# For the tests, beside what scripts/install-dependencies installs.
TOOLS = ["ccache", "libgl1-mesa-dri", "openmpi-bin", "python3-numpy", "python3-pil", "xvfb"]
SOURCES = (
    "vtk.module", "CMakeLists.txt", "LICENSE", "Module", "cmake", "ParaView", "Testing/ParaView",
    "docs/howto/paraview.md", "scripts/install-dependencies")
SOURCE = "/opt/vitrine/source"
SUITES = {"5.11": "bookworm", "6.1": "forky"}  # of Debian, by ParaView's version
RESULTS = "/opt/vitrine/results"


class Root:
    """The root in a folder. Paths of commands are those within."""

    def __init__(self, folder, version):
        self.folder, self.version = folder, version
        self.plugin = f"/opt/vitrine/build/lib/paraview-{version}/plugins/Vitrine/Vitrine.so"

    def make(self):
        """Make the root, copy the sources, and install what it lacks."""
        need("debootstrap", "unshare")
        if not (self.folder / "usr/bin/apt-get").exists():
            self.folder.parent.mkdir(parents=True, exist_ok=True)
            scripts = pathlib.Path("/usr/share/debootstrap/scripts")
            suite = SUITES[self.version]
            known = [] if (scripts / suite).exists() else [str(scripts / "sid")]
            run_quietly(as_root(
                ["debootstrap", "--variant=minbase", suite, str(self.folder), debian_mirror(), *known]))
            # A snapshot of a suite under development may be older than apt takes.
            self.check(["sh", "-c", "echo 'Acquire::Check-Valid-Until \"false\";' > /etc/apt/apt.conf.d/99vitrine"], 60)
        self.copy_sources()
        self.check(["bash", f"{SOURCE}/scripts/install-dependencies", "--paraview"], 1800)
        self.check(
            ["apt-get", "install", "--yes", "--no-install-recommends", *TOOLS], 600, DEBIAN_FRONTEND="noninteractive")

    def build(self):
        """Build the plugin. Units of several sources are compiled in half the time."""
        unity = "-DCMAKE_UNITY_BUILD=ON"
        self.check(["cmake", "-S", f"{SOURCE}/ParaView", "-B", "/opt/vitrine/build", "-G", "Ninja", unity], 300)
        self.check(["cmake", "--build", "/opt/vitrine/build"], 3600)

    def copy_sources(self):
        """Copy what changed of the files that git has or would take."""
        names = run_quietly(
            ["git", "ls-files", "--cached", "--others", "--exclude-standard", *SOURCES], cwd=ROOT).splitlines()
        target = self.folder / SOURCE[1:]
        for name in names:
            source, copy = ROOT / name, target / name
            if source.is_file() and not (copy.is_file() and copy.read_bytes() == source.read_bytes()):
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(source, copy)
        for copy in target.rglob("*"):
            if copy.is_file() and str(copy.relative_to(target)) not in names:
                copy.unlink()

    def run(self, command, limit, **environment):
        """Run a command in the root; what it started ends with it. Returns its outcome."""
        settings = {"PATH": "/usr/bin:/bin:/usr/sbin:/sbin", "HOME": "/root", "LANG": "C.UTF-8"} | environment
        inside = ["chroot", str(self.folder), "/usr/bin/env", "-i", *(f"{k}={v}" for k, v in settings.items())]
        mounts = f'mount --rbind /dev "{self.folder}/dev" && exec "$@"'
        apart = ["unshare", "--mount", "--pid", "--fork", "--kill-child", f"--mount-proc={self.folder}/proc"]
        try:
            return subprocess.run(
                as_root([*apart, "sh", "-c", mounts, "sh", *inside, *map(str, command)]), stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace", timeout=limit,
                check=False)
        except subprocess.TimeoutExpired as error:
            raise SetupError(f"{' '.join(map(str, command))}: not done after {limit} s") from error

    def check(self, command, limit, **environment):
        """Run a command that must succeed."""
        done = self.run(command, limit, **environment)
        if done.returncode != 0:
            raise SetupError(f"{' '.join(map(str, command))}\n{(done.stdout + done.stderr)[-3000:]}")

    def draw(self, program, script, *arguments):
        """Run a script of Testing/ParaView by a program with arguments, under an X server of its own."""
        folder = f"{SOURCE}/Testing/ParaView"
        (self.folder / RESULTS[1:]).mkdir(parents=True, exist_ok=True)
        command = [*program, f"{folder}/{script}", self.plugin, RESULTS, *arguments]
        return self.run(["sh", f"{folder}/with-display.sh", *command], 900)
