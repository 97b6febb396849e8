"""Parts that are coloured by an array of their data."""

import json
import unittest

import scenes
from program import FileTest, compare, info, read_png, run

PLATE = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)]
VIRIDIS = {0.0: (0x44, 0x01, 0x54), 0.5: (0x21, 0x91, 0x8C), 1.0: (0xFD, 0xE7, 0x25)}
MAGENTA = (255, 0, 255)
BACKGROUND = 255 * 0.95


def plates(count, point_arrays="", cell_arrays=""):
    """Plates side by side that face the viewer, a cell each."""
    points = [(x + i, y, z) for i in range(count) for x, y, z in PLATE]
    cells = [tuple(4 * i + corner for corner in range(4)) for i in range(count)]
    return scenes.vtu(points, cells, None, point_arrays, cell_arrays)


def array(name, values, components=1, kind="Float64"):
    return scenes.xml_array(kind, name, [*values, ""], components)  # VTK wants a space after "nan"


class ColorBy(FileTest):
    def render(self, path, *options):
        picture = self.folder / "picture.png"
        result = run("render", path, "-o", picture, "--view", "0,0", *options)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        return read_png(picture), result.stderr.decode()

    def colors(self, path, count, *options):
        """The colours in the middles of plates, and what was noted."""
        (width, height, rows), notes = self.render(path, "--size", f"{64 * count}x64", *options)
        row = rows[height // 2]
        # The plates fill a part of the picture: between the first and the last pixel that is not background.
        pixels = [tuple(row[3 * x : 3 * x + 3]) for x in range(width)]
        ground = pixels[0]
        inside = [x for x in range(width) if pixels[x] != ground]
        left, wide = inside[0], inside[-1] + 1 - inside[0]
        return [pixels[left + int((i + 0.5) * wide / count)] for i in range(count)], notes

    def assert_near(self, color, expected, tolerance=2):
        for value, wanted in zip(color, expected, strict=True):
            self.assertAlmostEqual(value, wanted, delta=tolerance)

    def test_cells_have_the_colours_of_the_map(self):
        path = self.write("plates.vtu", plates(3, cell_arrays=array("T", [10, 20, 30])))
        colors, notes = self.colors(path, 3, "--color-by", "T")
        self.assertEqual(notes, "")
        for color, share in zip(colors, (0.0, 0.5, 1.0)):
            self.assert_near(color, VIRIDIS[share])

    def test_a_range_clamps(self):
        path = self.write("plates.vtu", plates(3, cell_arrays=array("T", [10, 20, 30])))
        colors, _ = self.colors(path, 3, "--color-by", "T,20:22")
        for color, share in zip(colors, (0.0, 0.0, 1.0)):
            self.assert_near(color, VIRIDIS[share])

    def test_a_map_by_its_name(self):
        path = self.write("plates.vtu", plates(2, cell_arrays=array("T", [0, 1])))
        for text in ("T,coolwarm", "T,0:1,coolwarm", "T,coolwarm,0:1"):
            colors, _ = self.colors(path, 2, "--color-by", text)
            self.assert_near(colors[0], (59, 76, 192))
            self.assert_near(colors[1], (180, 4, 38))

    def test_vectors_by_magnitude_or_component(self):
        vectors = array("U", [3, 4, 0, 0, 0, 5, 0, 0, 0], components=3)
        path = self.write("plates.vtu", plates(3, cell_arrays=vectors))
        for text, shares in (("U", (1.0, 1.0, 0.0)), ("U:2", (0.0, 1.0, 0.0))):
            colors, _ = self.colors(path, 3, "--color-by", text)
            for color, share in zip(colors, shares):
                self.assert_near(color, VIRIDIS[share])

    def test_points_come_before_cells(self):
        both = {
            "point_arrays": array("T", [0.0] * 4 + [1.0] * 4),
            "cell_arrays": array("T", [1.0, 0.0]),
        }
        path = self.write("plates.vtu", plates(2, **both))
        colors, _ = self.colors(path, 2, "--color-by", "T")
        self.assert_near(colors[0], VIRIDIS[0.0])
        self.assert_near(colors[1], VIRIDIS[1.0])

    def test_what_is_not_a_number_has_its_colour_and_is_noted(self):
        path = self.write("plates.vtu", plates(3, cell_arrays=array("T", [0, "nan", 1])))
        colors, notes = self.colors(path, 3, "--color-by", "T")
        self.assert_near(colors[1], MAGENTA)
        self.assert_near(colors[2], VIRIDIS[1.0])
        self.assertIn("1 values of array 'T'", notes)
        self.assertIn("magenta", notes)

    def test_opacity_goes_over_the_colours(self):
        path = self.write("plates.vtu", plates(2, cell_arrays=array("T", [0, 1])))
        for method in ("linked-list", "truth"):
            options = ("--color-by", "T", "--opacity", "0.4", "--method", method)
            colors, _ = self.colors(path, 2, *options)
            for color, share in zip(colors, (0.0, 1.0)):
                expected = [0.4 * c + 0.6 * BACKGROUND for c in VIRIDIS[share]]
                self.assert_near(color, expected)

    def test_exact_methods_agree_with_truth(self):
        cells = scenes.cells_of_two_boxes([scenes.HEXAHEDRON])
        values = array("T", range(16))
        path = self.write("boxes.vtu", scenes.vtu(cells=cells, point_arrays=values))
        options = ("--color-by", "T", "--opacity", "0.3", "--methods", "exact")
        rows = compare(path, *options, "--frames", "1", "--size", "64x64")["results"]
        self.assertGreater(len(rows), 1)
        for row in rows:
            if "skipped" not in row:
                self.assertLessEqual(row["error"]["max"], 1.0 / 255.0)
                self.assertGreater(row["layers_max"], 1)

    def test_parts_share_the_range_and_others_keep_their_colours(self):
        self.write("low.vtu", plates(1, cell_arrays=array("T", [0])))
        self.write("high.vtu", plates(1, cell_arrays=array("T", [4])))
        self.write("none.vtp", scenes.vtp())
        path = self.write("all.vtm", scenes.vtm("low.vtu", "high.vtu", "none.vtp"))
        told = info(path, "--color-by", "T")
        self.assertEqual(told["notes"], ["1 of 3 parts have no array 'T' and keep their colours"])
        colors, _ = self.colors(path, 1, "--only", "block 0", "--color-by", "T")
        self.assert_near(colors[0], VIRIDIS[0.0])

    def test_many_parts_are_coloured_too(self):
        for arrays in ({"point_arrays": array("T", [1] * 4)}, {"cell_arrays": array("T", [1])}):
            self.write("plate.vtu", plates(1, **arrays))
            path = self.write("many.vtpd", scenes.vtpd(*["plate.vtu"] * 500))
            colors, _ = self.colors(path, 1, "--color-by", "T,0:1")
            self.assert_near(colors[0], VIRIDIS[1.0])

    def test_a_colour_by_name_goes_over_the_array(self):
        path = self.write("plates.vtu", plates(2, cell_arrays=array("T", [0, 1])))
        colors, _ = self.colors(path, 2, "--color-by", "T", "--color", "plates=#00ff00")
        self.assert_near(colors[0], (0, 255, 0))

    def test_a_scalar_bar_is_in_the_picture(self):
        path = self.write("plates.vtu", plates(1, cell_arrays=array("T", [0])))
        options = ("--size", "240x160", "--color-by", "T,0:1,viridis")
        (width, _, plain), _ = self.render(path, *options)
        (_, _, barred), _ = self.render(path, *options, "--scalar-bar")
        changed = {
            tuple(new[i : i + 3])
            for old, new in zip(plain, barred)
            for i in range(3 * (width * 3 // 4), 3 * width, 3)
            if old[i : i + 3] != new[i : i + 3]
        }
        self.assertGreater(len(changed), 20)
        for end in (VIRIDIS[0.0], VIRIDIS[1.0]):
            nearest = min(max(abs(a - b) for a, b in zip(end, color)) for color in changed)
            self.assertLessEqual(nearest, 12)

    def test_info_lists_arrays(self):
        content = plates(
            2,
            point_arrays=array("U", range(24), components=3),
            cell_arrays=array("T", [1, "nan"]) + array("none", ["nan", "nan"]),
        )
        path = self.write("plates.vtu", content)
        arrays = info(path)["arrays"]
        self.assertEqual(
            [(a["name"], a["at"], a["components"], a["parts"]) for a in arrays],
            [("T", "cells", 1, 1), ("U", "points", 3, 1), ("none", "cells", 1, 1)],
        )
        self.assertEqual(arrays[0]["range"], [1.0, 1.0])
        self.assertAlmostEqual(arrays[1]["range"][0], 5.0**0.5)
        self.assertIsNone(arrays[2]["range"])
        self.assertIn(b"array       T, at cells, 1 to 1", run("info", path).stdout)

    def refuse_coloring(self, path, text, *words):
        result = run("render", path, "-o", self.folder / "none.png", "--color-by", text)
        self.assert_refused(result, "--color-by", *words)
        self.assertFalse((self.folder / "none.png").exists())

    def test_what_cannot_be_done(self):
        content = plates(
            2,
            point_arrays=array("U", range(24), components=3),
            cell_arrays=array("none", ["nan", "nan"]),
        )
        path = self.write("plates.vtu", content)
        self.refuse_coloring(path, "X", "'X'", "'U' (points)", "'none' (cells)")
        self.refuse_coloring(path, "U,viridiss", "'viridiss' is neither", "turbo")
        self.refuse_coloring(path, "U:3", "no component 3")
        self.refuse_coloring(path, "U,2:1", "'2:1'")
        self.refuse_coloring(path, "U,1:1", "'1:1'")
        self.refuse_coloring(path, "U,0:inf", "'0:inf'")
        self.refuse_coloring(path, "none", "no finite number")
        self.refuse_coloring(self.write("plain.vtu", plates(1)), "T", "there are no arrays")
        result = run("render", path, "-o", self.folder / "none.png", "--scalar-bar")
        self.assert_refused(result, "--scalar-bar", "--color-by")


if __name__ == "__main__":
    unittest.main()
