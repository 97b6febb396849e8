"""How the wheel's build asks apt for packages of Debian, without asking for any."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Python/build"))
import debian_packages

MACHINE = """
Acquire::http::Proxy "http://proxy.example:8080";
Acquire::AllowInsecureRepositories "true";
APT::Get::AllowUnauthenticated "true";
APT::Update::Post-Invoke { "false"; };
"""


class Packages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def on_machine(self, configuration):
        file = self.folder / "machine.conf"
        file.write_text(configuration)
        return mock.patch.dict(os.environ, {"APT_CONFIG": str(file), debian_packages.MIRROR: ""})

    def test_take_only_the_way_to_the_archives_from_the_machine(self):
        file = self.folder / "apt.conf"
        with self.on_machine(MACHINE):
            file.write_text(debian_packages._configuration(self.folder))
        with mock.patch.dict(os.environ, APT_CONFIG=str(file)):
            told = subprocess.check_output(["apt-config", "dump"], text=True)
        self.assertIn('Acquire::http::Proxy "http://proxy.example:8080";', told)
        self.assertIn('Acquire::AllowInsecureRepositories "false";', told)
        self.assertIn('APT::Get::AllowUnauthenticated "false";', told)
        self.assertNotIn("Invoke", told)

    def test_come_from_debian_itself_where_apt_knows_no_archive(self):
        with self.on_machine(f'Dir::State::lists "{self.folder}";'):
            self.assertEqual(debian_packages._archives(), debian_packages.ARCHIVES)

    def test_come_from_the_mirror_that_the_environment_names(self):
        mirror = "https://mirror.example/debian"
        with mock.patch.dict(os.environ, {debian_packages.MIRROR: mirror}):
            self.assertEqual(debian_packages._archives()["Debian"], mirror)

    def test_are_refused_with_the_words_of_apt(self):
        with self.assertRaisesRegex(debian_packages.PackageError, "Invalid operation nonsense"):
            debian_packages._run("apt-get", "nonsense")
        with self.assertRaisesRegex(
            debian_packages.PackageError, "this machine has no apt-nothing"
        ):
            debian_packages._run("apt-nothing")


if __name__ == "__main__":
    unittest.main()
