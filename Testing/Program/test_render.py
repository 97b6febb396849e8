import unittest

from program import FileTest, read_png, run

BACKGROUND = 242  # 0.95 of 255, as VTK rounds it


class Render(FileTest):
    def render(self, *arguments, name="picture.png"):
        path = self.folder / name
        self.assert_done(run("render", *arguments, "-o", path))
        return read_png(path)

    def test_size(self):
        for width, height in ((1, 1), (7, 5), (301, 300)):
            with self.subTest(width=width, height=height):
                picture = self.render("demo:stack,layers=2", "--size", f"{width}x{height}")
                self.assertEqual(picture[:2], (width, height))

    def test_default_size(self):
        self.assertEqual(self.render("demo:stack,layers=2")[:2], (1024, 768))

    def test_the_plates_fill_any_window(self):
        for size in ("40x4", "4x40", "16x16"):
            width, height, rows = self.render("demo:stack,layers=1,alpha=1", "--size", size)
            self.assertEqual(
                len({bytes(row[3 * x : 3 * x + 3]) for row in rows for x in range(width)}), 1
            )

    def test_every_method_draws(self):
        for method in ("blend", "vtk-oit", "vtk-peeling-2", "vtk-peeling", "linked-list", "truth"):
            with self.subTest(method=method):
                _, _, rows = self.render(
                    "demo:spheres,layers=4", "--size", "32x32", "--method", method
                )
                self.assertEqual(rows[0][0], BACKGROUND)
                self.assertLess(rows[16][3 * 16], BACKGROUND)

    def test_nothing_but_the_picture_is_written(self):
        self.render("demo:stack,layers=2", "--size", "8x8")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["picture.png"])

    def test_a_picture_is_replaced(self):
        self.write("picture.png", b"what was there")
        self.assertEqual(self.render("demo:stack,layers=2", "--size", "8x8")[:2], (8, 8))

    def test_a_relative_name(self):
        result = run("render", "demo:stack,layers=2", "--size", "8x8", "-o", "")
        self.assert_refused(result, "PNG")

    def test_zoom_and_direction_change_the_picture(self):
        scene = "demo:assembly,parts=60"
        pictures = {
            view: self.render(scene, "--size", "40x40", *arguments)
            for view, arguments in {
                "own": [], "front": ["--view", "0,0"], "top": ["--view", "0,90"],
                "near": ["--view", "0,0,2"], "behind": ["--view", "180,0"],
            }.items()
        }  # fmt: skip
        rows = [b"".join(map(bytes, picture[2])) for picture in pictures.values()]
        self.assertEqual(len(set(rows)), len(rows))

    def test_multisamples_smooth_edges(self):
        scene = ["demo:spheres,layers=1,alpha=1,resolution=5", "--size", "24x24"]
        shades = [
            len({bytes(row[3 * x : 3 * x + 3]) for row in picture[2] for x in range(24)})
            for picture in (self.render(*scene), self.render(*scene, "--multisamples", "4"))
        ]
        self.assertGreater(shades[1], shades[0])


if __name__ == "__main__":
    unittest.main()
