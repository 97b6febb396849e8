"""Generated scenes are what their names say, on every machine."""

import unittest

from program import FileTest, compare, info, read_png, run

MASK = 2**64 - 1


class SplitMix64:
    """Written from the paper (Steele, Lea, Flood 2014), to check the program's."""

    def __init__(self, seed):
        self.state = seed

    def next(self):
        self.state = (self.state + 0x9E3779B97F4A7C15) & MASK
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        return z ^ (z >> 31)

    def unit(self):
        return (self.next() >> 11) * 2.0**-53


def stack_color(layers, alpha, seed=1, background=0.95):
    """The closed form of demo:stack."""
    dice = SplitMix64(seed)
    color, transmission = [0.0] * 3, 1.0
    for _ in range(layers):
        plate = [int(dice.unit() * 256) / 255 for _ in range(3)]
        color = [c + transmission * alpha * p for c, p in zip(color, plate)]
        transmission *= 1.0 - alpha
    return [c + transmission * background for c in color]


class DemoScenes(FileTest):
    def render(self, scene, *arguments):
        path = self.folder / "picture.png"
        self.assert_done(run("render", scene, "-o", path, *arguments))
        return path.read_bytes(), read_png(path)[2]

    def test_stack_has_the_colour_of_its_closed_form(self):
        for layers, alpha, seed in (
            (1, 0.5, 1),
            (2, 0.2, 1),
            (9, 0.2, 2),
            (65, 0.05, 3),
            (300, 0.004, 1),
            (4, 0.9, 7),
        ):
            expected = stack_color(layers, alpha, seed)
            # half a step for the picture's own rounding; the linked list's half floats add to it
            for method, delta in (("linked-list", 0.75), ("truth", 0.501)):
                with self.subTest(layers=layers, alpha=alpha, seed=seed, method=method):
                    _, rows = self.render(
                        f"demo:stack,layers={layers},alpha={alpha},seed={seed}",
                        "--size",
                        "6x4",
                        "--method",
                        method,
                    )
                    for row in rows:
                        for i, value in enumerate(row):
                            self.assertAlmostEqual(value, 255 * expected[i % 3], delta=delta)

    def test_a_stack_of_few_actors_is_the_same_stack(self):
        own, _ = self.render("demo:stack,layers=9,alpha=0.3", "--size", "6x4")
        for actors in (1, 2, 9, 12):
            scene = f"demo:stack,layers=9,alpha=0.3,actors={actors}"
            self.assertEqual(info(scene)["parts"], min(actors, 9))
            dealt, _ = self.render(scene, "--size", "6x4")
            self.assertEqual(dealt, own)

    def test_stack_of_4000_plates(self):
        layers = info("demo:stack,layers=4000,alpha=0.01")["layers"]
        self.assertEqual((layers["layers_max"], layers["layers_mean"]), (4000, 4000.0))

    def test_stack_fills_the_view_all_along_the_orbit(self):
        row = compare(
            "demo:stack,layers=5",
            "--methods",
            "blend",
            "--frames",
            "1",
            "--size",
            "16x16",
            "--view",
            "30,0",
        )["results"][0]
        self.assertEqual(row["fragments"], 5 * 256)

    def test_stack_of_invisible_and_of_opaque_plates(self):
        _, rows = self.render("demo:stack,layers=3,alpha=0", "--size", "4x4")
        self.assertEqual(set(b"".join(map(bytes, rows))), {242})
        _, rows = self.render("demo:stack,layers=3,alpha=1", "--size", "4x4")
        nearest = stack_color(1, 1.0)
        self.assertEqual([round(255 * c) for c in nearest], list(rows[0][:3]))

    def test_spheres_have_the_layers_that_are_asked_for(self):
        for layers in (1, 2, 3, 8, 15, 64):
            with self.subTest(layers=layers):
                scene = f"demo:spheres,layers={layers}"
                self.assertEqual(info(scene)["layers"]["layers_max"], layers)

    def test_the_hall_is_the_same_for_any_number_of_lights(self):
        dark, crowded = (info(f"demo:hall,lights={lights}") for lights in (0, 1048576))
        self.assertEqual((dark["lights"], crowded["lights"]), (0, 1048576))
        self.assertTrue(255_000 <= dark["triangles"] <= 270_000, dark["triangles"])
        self.assertTrue(0 < dark["translucent_parts"] < dark["parts"])
        for key in ("parts", "translucent_parts", "triangles", "bounds", "layers"):
            self.assertEqual(dark[key], crowded[key])

    def test_the_hall_is_lit_by_its_own_lights(self):
        one, other = (
            self.render(f"demo:hall,lights=3,seed={seed}", "--size", "32x24")[0] for seed in "12"
        )
        self.assertNotEqual(one, other)

    def test_more_lights_than_vtk_takes_are_refused(self):
        path = self.folder / "picture.png"
        refused = run("render", "demo:hall,lights=65", "-o", path)
        self.assert_refused(refused, "demo:hall,lights=65", "65 lights", "64")
        self.assertFalse(path.exists())
        for setting in ("lights=-1", "lights=1048577", "lights=1.5", "lamps=1"):
            self.assert_refused(run("info", f"demo:hall,{setting}"), setting)

    def test_alpha_resolution_and_seed_matter(self):
        pictures = {
            self.render(f"demo:spheres,layers=4{more}", "--size", "32x32")[0]
            for more in ("", ",alpha=0.7", ",resolution=5", ",seed=2")
        }
        self.assertEqual(len(pictures), 4)

    def test_the_same_name_gives_the_same_picture(self):
        for scene in (
            "demo:stack,layers=20",
            "demo:spheres,layers=9",
            "demo:assembly,parts=50,seed=4",
        ):
            with self.subTest(scene=scene):
                first, _ = self.render(scene, "--size", "48x48")
                second, _ = self.render(scene, "--size", "48x48")
                self.assertEqual(first, second)


if __name__ == "__main__":
    unittest.main()
