"""Effects of VTK's beside each feature: every cell is right, and docs/reference/effects.md says what it is."""

import pathlib
import re
import unittest

import matrix
from effects import EFFECTS
from vtkmodules.vtkCommonCore import vtkVersion

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/reference/effects.md"
VERSION = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())
VERSION_OF_PAGE = (9, 1)
VERSIONS_OF_KINDS = ((9, 1), (9, 6))  # whose cells are of the page's kinds; reasons may differ


def rows_of_page():
    """Cells of the page's table by effect, with the reasons that their numbers stand for."""
    text = PAGE.read_text(encoding="utf-8")
    reasons = dict(re.findall(r"^(\d+)\. (.+)$", text, re.M))
    rows = {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == len(matrix.COLUMNS) + 1:
            rows[cells[0]] = [
                re.sub(r" \[(\d+)\]$", lambda mark: f": {reasons[mark[1]]}", cell)
                for cell in cells[1:]
            ]
    return rows


def kind_of(cell):
    return cell.partition(":")[0]


class Effects(unittest.TestCase):
    maxDiff = None


def check(effect):
    def test(self):
        row = matrix.Row(effect)
        self.addCleanup(row.end)
        cells = [str(cell) for cell in row.cells()]
        for column, cell in zip(matrix.COLUMNS, cells):
            self.assertFalse(cell.startswith("WRONG"), f"{column}: {cell}")
        if effect.changes:
            self.assertTrue(row.changes_the_picture(), "the effect has no effect here")
        expected = rows_of_page().get(effect.name, [])
        if VERSION in VERSIONS_OF_KINDS:
            self.assertEqual([*map(kind_of, cells)], [*map(kind_of, expected)])
        if VERSION == VERSION_OF_PAGE:
            self.assertEqual(cells, expected, "see matrix.py --update")

    return test


for each in EFFECTS:
    setattr(Effects, "test_" + re.sub(r"\W+", "_", each.name), check(each))
