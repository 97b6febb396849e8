"""Packages of Debian's suites, fetched with the machine's own apt and unpacked into folders: nothing is installed.

apt checks the signatures. Its lists, caches and sources are kept in a folder of their own, so no root is needed and
the machine's own are left alone.
"""

import getpass
import pathlib
import re
import subprocess

KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"


class PackageError(Exception):
    """What apt could not do, in its own words."""


def _mirror():
    """The address of Debian's archive that this machine's apt uses."""
    folder = pathlib.Path("/etc/apt")
    for file in [
        folder / "sources.list",
        *sorted((folder / "sources.list.d").glob("*.list")),
        *sorted((folder / "sources.list.d").glob("*.sources")),
    ]:
        text = file.read_text() if file.is_file() else ""
        for address in re.findall(r"^(?:deb |URIs:)[^#\n]*?(\w+://\S+/debian)/?(?=\s|$)", text, re.M):
            return address
    raise PackageError("no archive of Debian is among the sources of this machine's apt")


class Suite:
    """A suite of Debian, such as "forky"; `folder` holds what apt knows of it."""

    def __init__(self, name, folder):
        self.name = name
        self.folder = pathlib.Path(folder)
        for part in ("state/lists/partial", "cache/archives/partial", "packages"):
            (self.folder / part).mkdir(parents=True, exist_ok=True)
        (self.folder / "status").touch()
        (self.folder / "sources.list").write_text(f"deb [signed-by={KEYRING}] {_mirror()} {name} main\n")
        self._apt("update")

    def _apt(self, *arguments):
        options = {
            "Dir::Etc::main": "/dev/null",
            "Dir::Etc::parts": "/dev/null",
            "Dir::Etc::sourcelist": self.folder / "sources.list",
            "Dir::Etc::sourceparts": "/dev/null",
            "Dir::Etc::preferences": "/dev/null",
            "Dir::Etc::preferencesparts": "/dev/null",
            "Dir::State": self.folder / "state",
            "Dir::State::status": self.folder / "status",
            "Dir::Cache": self.folder / "cache",
            "APT::Sandbox::User": getpass.getuser(),
            "APT::Update::Error-Mode": "any",
            "Acquire::Check-Valid-Until": "false",  # mirrors may lag; the caller checks versions
            "Acquire::Languages": "none",
            "Acquire::Retries": "3",
        }
        command = ["apt-get", "--quiet", "--quiet"]
        for name, value in options.items():
            command += ["-o", f"{name}={value}"]
        try:
            done = subprocess.run(
                command + list(arguments), cwd=self.folder / "packages", capture_output=True, text=True
            )
        except FileNotFoundError as error:
            raise PackageError("this machine has no apt-get") from error
        if done.returncode != 0:
            raise PackageError(f"apt-get {' '.join(arguments)}: {done.stderr.strip()}")

    def unpack(self, names, folder):
        """Fetch the packages `names` and unpack all of them into `folder`."""
        self._apt("download", *names)
        for name in names:
            (package,) = (self.folder / "packages").glob(f"{name}_*.deb")
            subprocess.run(["dpkg-deb", "--extract", package, folder], check=True)
