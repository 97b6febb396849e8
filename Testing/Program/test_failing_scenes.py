"""Scenes in which methods fail are what their names say: layers and fragments that are known."""

import unittest

from program import FileTest, read_png, run, info_at
from stability_figures import suite


class FailingScenes(FileTest):
    def layers(self, scene, size="64x64"):
        return info_at(size, f"demo:{scene}")["layers"]

    def picture(self, scene, *arguments):
        path = self.folder / "picture.png"
        self.assert_done(run("render", f"demo:{scene}", "-o", path, *arguments))
        return b"".join(map(bytes, read_png(path)[2]))

    def test_each_says_what_is_expected_and_is_drawn(self):
        help_text = run("--help").stdout.decode()
        harmless = ("demo:stack", "demo:spheres")
        demos = [demo for demo in suite().values() if not demo.startswith(harmless)]
        self.assertGreater(len(demos), 20)
        for demo in demos:
            with self.subTest(demo=demo):
                told = info_at("24x24", demo)
                self.assertGreater(len(told["expected"]), 20)
                self.assertIn(demo.split(",")[0], help_text)
                fragments = told["layers"]["fragments"]
                self.assertEqual(fragments == 0, demo == "demo:empty")

    def test_the_same_text_gives_the_same_picture(self):
        for scene in ("mating,seed=7", "slivers", "impostors", "non-finite"):
            with self.subTest(scene=scene):
                first = self.picture(scene, "--size", "48x48")
                self.assertEqual(first, self.picture(scene, "--size", "48x48"))
                self.assertGreater(len(set(first)), 8)

    def test_layers_are_those_of_the_scene(self):
        for scene, layers in (
            ("coincident", 4),
            ("coincident,plates=30", 30),
            ("coincident,plates=30,together=1", 30),
            ("gaps,plates=5", 5),
            ("at-face", 4),
            ("cyclic", 2),  # each lies over the next, and over no other
            ("opaque,layers=6", 6),
            ("near-far,plates=10", 10),
            ("empty,plates=2", 2),
            ("crossing,planes=1", 1),
            ("impostors,spheres=0", None),
        ):
            with self.subTest(scene=scene):
                if layers is None:
                    self.assert_refused(run("info", f"demo:{scene}"), "spheres=0")
                else:
                    self.assertEqual(self.layers(scene)["layers_max"], layers)

    def test_needles_are_4000_fragments_in_20_pixels(self):
        told = self.layers("needles")
        self.assertEqual(
            (told["fragments"], told["layers_max"], told["layers_mean"]), (4000, 200, 200.0)
        )

    def test_faces_in_one_part_or_several_are_as_many_fragments(self):
        for scene in ("coincident", "cyclic"):
            several, one = self.layers(scene), self.layers(f"{scene},together=1")
            self.assertEqual(several, one)

    def test_order_of_coincident_faces_shows_where_it_may(self):
        for method, is_seen in (("linked-list", False), ("prefix-sum", False), ("blend", True)):
            pictures = {
                self.picture(f"coincident,seed={seed}", "--size", "24x24", "--method", method)
                for seed in (1, 2, 3)
            }
            self.assertEqual(len(pictures) > 1, is_seen, method)

    def test_opaque_parts_hide_what_is_behind_and_not_what_is_in_their_plane(self):
        # at 50x50 the squares, of half side 0.22, are 11x11 pixels of a view from -1 to 1
        size, side, layers = "50x50", 45, 4
        told = self.layers(f"opaque,layers={layers}", size)
        in_front, between, coplanar = 0, 1, layers // 2 + 1
        hidden = (3 * layers - in_front - between - coplanar) * 11 * 11
        self.assertEqual(told["fragments"], layers * side * side - hidden)

    def test_clipping_planes_discard(self):
        whole = self.layers("spheres,layers=12,alpha=0.3,resolution=24")
        clipped = self.layers("clipped")
        self.assertLess(clipped["fragments"], 0.9 * whole["fragments"])
        self.assertGreater(clipped["fragments"], 0.2 * whole["fragments"])

    def test_gaps_are_a_part_of_a_depth_step(self):
        # nothing is behind what is nearer by no step, so colour orders, as in the plane of all
        pictures = {
            steps: self.picture(f"gaps,steps={steps}", "--size", "24x24") for steps in (0, 0.01, 4)
        }
        self.assertEqual(pictures[0], pictures[0.01])
        self.assertNotEqual(pictures[0], pictures[4])

    def test_a_face_at_a_millionth_is_seen(self):
        near, cut = self.layers("at-face")["layers_max"], self.layers("at-face,distance=1e-7")
        self.assertEqual((near, cut["layers_max"]), (4, 4))


if __name__ == "__main__":
    unittest.main()
