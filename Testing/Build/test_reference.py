"""docs/reference: it has an entry for each public class, each command and each message."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

# How code says something to a user. A message is the arguments up to the end of the call.
CALLS = {
    "Module/**/*.cxx": [
        r"vtk(?:Error|Warning|GenericWarning)Macro\((.*?)\);",
        r"throw (?:Assembly|Pattern)Error\((.*?)\);",
    ],
    "Examples/vitrine/**/*.cxx": [r"throw (?:program::)?(?:Input|Runtime)Error\((.*?)\);"],
    "Python/**/*.py": [
        r"raise (?:Type|Value|Runtime|Import|FileNotFound|IsADirectory)Error\((.*?)\)(?: from \w+)?\n",
        r"sys\.exit\((.*?)\)\n",
        r"warnings\.warn\((.*?)\)\n",
    ],
}
FEWEST_WORDS = 4  # Shorter pieces are joints between names and numbers.
NOT_OF_USERS = {
    "and found VTK  at",  # a name stands among any three words of it
    "usage:  VERSION VTKMODULES FOLDER: prints the prefix for CMake",
}


def page(name):
    text = (ROOT / "docs/reference" / name).read_text(encoding="utf-8")
    return " ".join(text.replace("`", "").split())


def messages():
    """The texts of messages, without names and numbers, with the file that has them."""
    for files, patterns in CALLS.items():
        for file in sorted(ROOT.glob(files)):
            code = re.sub(r'"\s*\n\s*f?"', "", file.read_text(encoding="utf-8"))
            for call in (found[1] for pattern in patterns for found in re.finditer(pattern, code, re.S)):
                for text in re.findall(r'"((?:[^"\\\n]|\\.)*)"', call):
                    yield file.relative_to(ROOT), re.sub(r"\{[^}]*\}", "", text).strip(" .,:;()'")


def is_told(text, told):
    """Whether some words of a text stand on the page in its order."""
    words = text.split()
    runs = [" ".join(words[i : i + 3]) for i in range(len(words) - 2)]
    return any(run in told for run in runs)


class Reference(unittest.TestCase):
    def test_has_each_public_class(self):
        told = page("cpp.md")
        classes = [
            name
            for header in sorted(ROOT.glob("Module/**/vtk*.h"))
            for name in re.findall(r"^class VTKVITRINERENDERING_EXPORT (\w+)", header.read_text(), re.M)
        ]
        self.assertGreater(len(classes), 10)
        self.assertEqual([name for name in classes if name not in told], [])

    def test_has_each_command(self):
        told = page("program.md")
        commands = [
            name
            for file in sorted(ROOT.glob("Examples/vitrine/commands/*.cxx"))
            for name in re.findall(r'add_subcommand\(\s*"(\w+)"', file.read_text(encoding="utf-8"))
        ]
        self.assertGreater(len(commands), 10)
        self.assertEqual([name for name in commands if not re.search(rf"\b{name}\b", told)], [])

    def test_has_each_message(self):
        told = page("messages.md")
        all_messages = list(messages())
        self.assertGreater(len(all_messages), 100)
        missing = [
            f"{file}: {text}"
            for file, text in all_messages
            if len(text.split()) >= FEWEST_WORDS and text not in NOT_OF_USERS and not is_told(text, told)
        ]
        self.assertEqual(missing, [])


if __name__ == "__main__":
    unittest.main()
