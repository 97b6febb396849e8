"""`vitrine diff`: what matches, what does not, and what is left to look at."""

import json
import pathlib
import unittest

from program import FileTest, png, read_png, run

WIDTH, HEIGHT = 40, 30
GREY = (100, 110, 120)


def plain(color=GREY, size=(WIDTH, HEIGHT)):
    return [[color] * size[0] for _ in range(size[1])]


def with_pixels(*changes):
    """A plain picture but for pixels of other colours: (x, y, colour)."""
    rows = plain()
    for x, y, color in changes:
        rows[y][x] = color
    return rows


ONE_STEP = with_pixels((3, 2, (100, 111, 120)))


class Diff(FileTest):
    def picture(self, name, rows, **options):
        return self.write(name, png(rows, **options))

    def diff(self, picture, *baselines_and_options):
        return run("diff", picture, *baselines_and_options)

    def told(self, *arguments):
        result = self.diff(*arguments, "--json", "-")
        return result.returncode, json.loads(result.stdout)

    def assert_differs(self, result, *words):
        said = result.stdout.decode()
        self.assertEqual(result.returncode, 1, said + result.stderr.decode())
        self.assertEqual(result.stderr.count(b"\n"), 1)
        for word in words:
            self.assertIn(str(word), said)

    def test_the_same_picture_matches(self):
        a, b = self.picture("a.png", plain()), self.picture("b.png", plain())
        result = self.diff(a, b)
        self.assert_done(result)
        self.assertIn(f"{a} matches {b}", result.stdout.decode())

    def test_one_step_in_one_pixel_differs_and_is_named(self):
        a, b = self.picture("a.png", ONE_STEP), self.picture("b.png", plain())
        self.assert_differs(
            self.diff(a, b),
            "1 of 1200 pixels differ, and the largest difference is 1/255",
            "pixel 3, 2 from the top left: picture 100 111 120 255, baseline 100 110 120 255",
        )

    def test_tolerance_is_inclusive(self):
        a, b = self.picture("a.png", plain((101, 109, 121))), self.picture("b.png", plain())
        self.assert_differs(self.diff(a, b), "1200 of 1200 pixels differ")
        self.assert_done(self.diff(a, b, "--tolerance", "1"))
        c = self.picture("c.png", plain((102, 110, 120)))
        self.assert_differs(self.diff(c, b, "--tolerance", "1"), "differ by more than 1/255")

    def test_share_lets_some_pixels_differ_by_any(self):
        changes = [(x, 4, (255, 0, 0)) for x in range(3)]
        a, b = self.picture("a.png", with_pixels(*changes)), self.picture("b.png", plain())
        self.assert_done(self.diff(a, b, "--share", 3 / 1200))
        self.assert_differs(self.diff(a, b, "--share", 2.9 / 1200), "pixels that may differ: 2")

    def test_alpha_counts(self):
        rows = [[(100, 110, 120, 255)] * WIDTH for _ in range(HEIGHT)]
        b = self.picture("b.png", rows, alpha=True)
        self.assert_done(self.diff(self.picture("a.png", plain()), b))
        rows[0][0] = (100, 110, 120, 254)
        a = self.picture("a.png", rows, alpha=True)
        self.assert_differs(self.diff(a, b), "picture 100 110 120 254, baseline 100 110 120 255")

    def test_flip_is_asked_for_where_it_is_given(self):
        """FLIP sees what a tolerance lets through, if the eye would."""
        a, b = self.picture("a.png", plain((110, 120, 130))), self.picture("b.png", plain())
        status, told = self.told(a, b, "--tolerance", "10")
        self.assertEqual(status, 0)
        flip = told["baselines"][0]["error"]["flip"]
        self.assertGreater(flip, 0.01)
        self.assert_done(self.diff(a, b, "--tolerance", "10", "--flip", flip + 1e-9))
        self.assert_differs(
            self.diff(a, b, "--tolerance", "10", "--flip", flip - 1e-3), f"FLIP {flip:.6f}"
        )

    def test_any_of_several_baselines_does_and_the_closest_is_told(self):
        a = self.picture("a.png", ONE_STEP)
        far = self.picture("far.png", plain((0, 0, 0)))
        near = self.picture("near.png", plain())
        small = self.picture("small.png", plain(size=(8, 8)))
        none = self.folder / "none.png"
        self.assert_differs(
            self.diff(a, far, small, near, none),
            f"{a} and {near}: 1 of 1200 pixels differ",
            f"{far} is not closer: 1200 pixels differ",
            f"{small} is not closer: the baseline has 8x8 pixels, and the picture 40x30",
            f"{none} is not closer: no such file",
        )
        same = self.picture("same.png", ONE_STEP)
        status, told = self.told(a, none, far, same, near)
        self.assertEqual((status, told["matches"], told["closest"]), (0, True, str(same)))

    def test_json_is_as_agreed(self):
        a, b = self.picture("a.png", ONE_STEP), self.picture("b.png", plain())
        status, told = self.told(a, b, "--share", "0.5", "--flip", "0.25", "--tolerance", "3")
        self.assertEqual(status, 0)
        error = told["baselines"][0].pop("error")
        self.assertEqual(list(error), ["max", "rmse", "psnr", "ssim", "flip", "wrong_pixels"])
        self.assertAlmostEqual(error["max"], 1 / 255, delta=1e-6)
        del told["vitrine"]
        row = {"file": str(b), "matches": True, "largest_difference": 1, "different_pixels": 0,
               "pixels": 1200, "first": []}  # fmt: skip
        self.assertEqual(
            told,
            {"picture": str(a), "settings": {"tolerance": 3, "share": 0.5, "flip": 0.25},
             "matches": True, "closest": str(b), "baselines": [row]},
        )  # fmt: skip
        status, told = self.told(a, b)
        self.assertEqual((status, told["matches"]), (1, False))
        pixel = {"x": 3, "y": 2, "picture": [100, 111, 120, 255], "baseline": [100, 110, 120, 255]}
        self.assertEqual(told["baselines"][0]["first"], [pixel])

    def test_pictures_are_left_where_it_differs(self):
        a, b = self.picture("a.png", ONE_STEP), self.picture("b.png", plain())
        out = self.folder / "out"
        self.assert_done(self.diff(a, a, "--out", out))
        self.assertFalse(out.exists(), "nothing is left where it matches")
        self.assert_differs(self.diff(a, b, "--out", out), out / "difference.png", out / "flip.png")
        width, height, rows = read_png(out / "difference.png")
        self.assertEqual((width, height), (WIDTH, HEIGHT))
        self.assertEqual(bytes(rows[2][9:12]), b"\xff\x01\x00")
        self.assertEqual(set(bytes(rows[20])), {27})
        width, height, rows = read_png(out / "flip.png")
        self.assertEqual((width, height), (WIDTH, HEIGHT))
        self.assertNotEqual(bytes(rows[2][9:12]), b"\0\0\0")
        self.assertEqual(bytes(rows[29]), bytes(3 * WIDTH))

    def test_update_writes_the_first_baseline_where_none_matches(self):
        a, b = self.picture("a.png", ONE_STEP), self.picture("b.png", plain())
        new, before = self.folder / "new.png", b.read_bytes()
        self.assert_done(self.diff(a, new, "--update"))
        self.assertEqual(new.read_bytes(), a.read_bytes())
        new.unlink()
        self.assert_done(self.diff(a, new, b, "--update", "--tolerance", "1"))
        self.assertFalse(new.exists(), "one of them matches")
        result = self.diff(a, new, b, "--update")
        self.assert_done(result)
        self.assertIn(f"{new} is now what {a} is", result.stdout.decode())
        self.assertEqual((new.read_bytes(), b.read_bytes()), (a.read_bytes(), before))

    def test_bad_input(self):
        a, none = self.picture("a.png", plain()), self.folder / "none.png"
        cut = self.write("cut.png", png(plain())[:60])
        self.assert_refused(self.diff(a), "BASELINE")
        self.assert_refused(self.diff(none, a), none, "no such file")
        self.assert_refused(self.diff(a, none), none, "no such file", "--update")
        self.assert_refused(self.diff(cut, a), cut, "no whole PNG")
        self.assert_refused(self.diff(a, cut), cut, "no whole PNG")
        self.assert_refused(self.diff(cut, none, "--update"), cut, "no whole PNG")
        self.assertFalse(none.exists())
        for option, bad in (("--tolerance", "256"), ("--tolerance", "0.5"), ("--share", "1.1"),
                            ("--share", "nan"), ("--flip", "-1")):  # fmt: skip
            self.assert_refused(self.diff(a, a, option, bad), option)
        self.assert_refused(self.diff(a, a, "--json", a), a)

    def test_a_folder_that_cannot_be_made(self):
        a, b = self.picture("a.png", ONE_STEP), self.picture("b.png", plain())
        result = self.diff(a, b, "--out", pathlib.Path(b, "out"))
        self.assertEqual(result.returncode, 2, result.stderr)


if __name__ == "__main__":
    unittest.main()
