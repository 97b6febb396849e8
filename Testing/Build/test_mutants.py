"""scripts/mutants: its table fits the code, and what it reads from tests is what they said."""

import importlib.machinery
import importlib.util
import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def load(path):
    """The script as a module, without a file of bytecode beside it."""
    loader = importlib.machinery.SourceFileLoader("mutants", str(path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutants", loader))
    sys.modules["mutants"] = module
    loader.exec_module(module)
    return module


mutants = load(ROOT / "scripts/mutants")

OUTPUT = """\
[ RUN      ] Methods/ExactStack.IsTheClosedForm/Truth
[       OK ] Methods/ExactStack.IsTheClosedForm/Truth (12 ms)
[ RUN      ] Methods/ExactStack.IsTheClosedForm/LinkedList
[  FAILED  ] Methods/ExactStack.IsTheClosedForm/LinkedList, where GetParam() = LinkedList (3 ms)
[ RUN      ] Samples/StencilRouted.IsTruthAtEdges/4
[  SKIPPED ] Samples/StencilRouted.IsTruthAtEdges/4 (0 ms)
[ RUN      ] ScreenBands.CutsRows
"""


def mutant(**changes):
    entry = {
        "name": "a",
        "broken": "all",
        "file": "file.txt",
        "old": "one",
        "new": "two",
        "noticed_by": ["core:Some.*"],
    }
    return mutants.Mutant(**{**entry, **changes})


class Table(unittest.TestCase):
    def test_fits_the_code(self):
        table = mutants.read_table((ROOT / mutants.TABLE).read_text(encoding="utf-8"))
        self.assertGreater(len(table), 20)
        for entry in table.values():
            with self.subTest(mutant=entry.name):
                entry.check(ROOT)

    def test_is_printed_with_a_row_for_each_mutant(self):
        """docs/develop/testing.md names the command, and has no rows of its own, which would grow old."""
        table = mutants.read_table((ROOT / mutants.TABLE).read_text(encoding="utf-8"))
        rows = mutants.markdown(table.values()).splitlines()[2:]
        self.assertEqual(len(rows), len(table))
        for row, entry in zip(rows, table.values()):
            cells = re.fullmatch(r"\| (.*) \| `(.*?)` \| (.*) \|", row).groups()
            tests = ", ".join(f"`{test}`" for test in entry.tests)
            self.assertEqual(cells, (entry.broken, entry.file, tests))
        text = (ROOT / "docs/develop/testing.md").read_text(encoding="utf-8")
        self.assertIn("scripts/mutants --table", text)
        self.assertEqual([row for row in rows if row in text], [])

    def test_is_refused_where_it_does_not_fit(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "file.txt").write_text("one and three and three")
            mutant().check(root)
            for changes, message in (
                ({"old": "three"}, "2 times"),
                ({"old": "four"}, "0 times"),
                ({"new": "one"}, "nothing is changed"),
                ({"file": "other.txt"}, "no file other.txt"),
                ({"noticed_by": []}, "no test is named"),
                ({"noticed_by": ["nonsense:Some.*"]}, "SUITE:FILTER"),
                ({"noticed_by": ["core:"]}, "SUITE:FILTER"),
            ):
                with self.subTest(message), self.assertRaisesRegex(mutants.TableError, message):
                    mutant(**changes).check(root)

    def test_is_refused_where_an_entry_is_not_whole_or_named_twice(self):
        entry = "[[mutant]]\nname='a'\nbroken=''\nfile=''\nold=''\nnew=''\nnoticed_by=[]\n"
        self.assertEqual(list(mutants.read_table(entry)), ["a"])
        with self.assertRaisesRegex(mutants.TableError, "two mutants have the name a"):
            mutants.read_table(entry * 2)
        with self.assertRaisesRegex(mutants.TableError, "missing .* 'file'"):
            mutants.read_table(entry.replace("file=''", ""))


class Tests(unittest.TestCase):
    def test_that_do_not_come_to_their_end_have_failed(self):
        self.assertEqual(
            mutants.tests_in(OUTPUT),
            {
                "Methods/ExactStack.IsTheClosedForm/Truth": True,
                "Methods/ExactStack.IsTheClosedForm/LinkedList": False,
                "ScreenBands.CutsRows": False,
            },
        )

    def test_survive_each_where_no_instance_failed(self):
        selected = {"ExactStack.IsTheClosedForm", "StencilRouted.IsTruthAtEdges", "ScreenBands.CutsRows"}
        self.assertEqual(
            mutants.survivors_of(selected | {"Other.HasNotRun"}, mutants.tests_in(OUTPUT)),
            ["Other.HasNotRun", "StencilRouted.IsTruthAtEdges"],
        )

    def test_are_named_once_with_how_many_failed(self):
        self.assertEqual(
            mutants.summary(mutants.tests_in(OUTPUT)),
            "ExactStack.IsTheClosedForm (1 of 2), ScreenBands.CutsRows",
        )


if __name__ == "__main__":
    unittest.main()
