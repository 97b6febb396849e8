"""Packages of Debian's suites, fetched with the machine's own apt and unpacked into folders: nothing is installed.

apt checks the signatures. Its lists, caches and configuration are kept in a folder of their own, so no root is needed.
Of the machine's own, only the addresses of Debian's archives and the way to reach them are taken.
"""

import os
import pathlib
import re
import subprocess

KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"

# Of the environment: the address of a mirror to take instead of apt's.
MIRROR = "VITRINE_DEBIAN_MIRROR"

# By the labels that they give themselves.
ARCHIVES = {
    "Debian": "https://deb.debian.org/debian",
    "Debian-Security": "https://deb.debian.org/debian-security",
}


class PackageError(Exception):
    """What apt or dpkg could not do, in its own words."""


def _run(*command, **settings):
    try:
        done = subprocess.run(command, capture_output=True, text=True, **settings)
    except FileNotFoundError as error:
        raise PackageError(f"this machine has no {command[0]}") from error
    if done.returncode != 0:
        raise PackageError(f"{' '.join(map(str, command))}: {done.stderr.strip()}")
    return done.stdout


def _archives():
    """The addresses of Debian's archives, those of this machine's apt if it has fetched their lists."""
    targets = _run(
        "apt-get",
        "indextargets",
        "--format",
        "$(REPO_URI) $(LABEL)",
        "Created-By: Packages",
        "Origin: Debian",
    )
    found = {}
    for target in targets.splitlines():
        address, label = target.split(" ", 1)
        found.setdefault(label, address)
    if os.environ.get(MIRROR):
        found["Debian"] = os.environ[MIRROR]
    return found or ARCHIVES


def _configuration(folder):
    """All that apt is told: its folders, and the proxies and certificates of this machine."""
    options = {
        "Dir::Etc::main": "/dev/null",
        "Dir::Etc::parts": "/dev/null",
        "Dir::Etc::sourcelist": folder / "sources.list",
        "Dir::Etc::sourceparts": "/dev/null",
        "Dir::Etc::preferences": "/dev/null",
        "Dir::Etc::preferencesparts": "/dev/null",
        "Dir::State": folder / "state",
        "Dir::State::status": folder / "status",
        "Dir::Cache": folder / "cache",
        "APT::Sandbox::User": "root",  # whoever builds: its usual user may not write to the folder
        "APT::Get::AllowUnauthenticated": "false",
        "APT::Update::Error-Mode": "any",
        "Acquire::AllowInsecureRepositories": "false",
        "Acquire::Check-Valid-Until": "false",  # mirrors may lag; the caller checks versions
        "Acquire::Languages": "none",
        "Acquire::Retries": "3",
    }
    reached_by = re.findall(r"^Acquire::(?:https?|tor)::.*\n", _run("apt-config", "dump"), re.M)
    return "".join([*(f'{name} "{value}";\n' for name, value in options.items()), *reached_by])


class Suite:
    """A suite of Debian, such as "forky", with or without its `security` updates. `folder` holds apt's data of it."""

    def __init__(self, name, folder, security=False):
        self.folder = pathlib.Path(folder)
        for part in ("state/lists/partial", "cache/archives/partial", "packages"):
            (self.folder / part).mkdir(parents=True)
        archives = _archives()
        sources = [f"{archives.get('Debian', ARCHIVES['Debian'])} {name}"]
        if security and "Debian-Security" in archives:
            sources.append(f"{archives['Debian-Security']} {name}-security")
        (self.folder / "sources.list").write_text(
            "".join(f"deb [arch=amd64 signed-by={KEYRING}] {source} main\n" for source in sources)
        )
        (self.folder / "status").touch()
        (self.folder / "apt.conf").write_text(_configuration(self.folder))
        self._apt("update")

    def _apt(self, *arguments):
        # The file that APT_CONFIG names is read before the machine's own, which it shuts out.
        _run(
            *("apt-get", "--quiet", "--quiet", *arguments),
            cwd=self.folder / "packages",
            env={**os.environ, "APT_CONFIG": str(self.folder / "apt.conf")},
        )

    def unpack(self, names, folder):
        """Fetch the packages `names`, such as "zlib1g-dev" or "zlib1g-dev=1.2*", and unpack them into `folder`."""
        self._apt("download", *names)
        for package in (self.folder / "packages").glob("*.deb"):
            _run("dpkg-deb", "--extract", package, folder)
            package.unlink()
