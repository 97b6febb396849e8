import unittest

from program import ProgramTest, info


class Assembly(ProgramTest):
    def test_number_of_parts_is_exact(self):
        for parts in (1, 2, 17, 300, 301, 999):
            with self.subTest(parts=parts):
                told = info(f"demo:assembly,parts={parts}")
                self.assertEqual(told["parts"], parts)
                self.assertEqual(told["translucent_parts"], parts)
                self.assertEqual(told["skipped"], [])

    def test_more_parts_make_a_larger_plant(self):
        floors = []
        for parts in (300, 1000, 3000):
            low_x, high_x, _, _, low_z, high_z = info(f"demo:assembly,parts={parts}")["bounds"]
            floors.append((high_x - low_x) * (high_z - low_z))
        self.assertEqual(floors, sorted(floors))
        self.assertGreater(floors[2], 3.0 * floors[0])

    def test_triangles_are_within_the_budget(self):
        for parts in (300, 2000):
            triangles = info(f"demo:assembly,parts={parts}")["triangles"]
            self.assertTrue(100 <= triangles / parts <= 300, triangles / parts)

    def test_seed_changes_the_machines(self):
        first = info("demo:assembly,parts=300,seed=1")
        second = info("demo:assembly,parts=300,seed=2")
        self.assertNotEqual(first["triangles"], second["triangles"])  # gears have other teeth


if __name__ == "__main__":
    unittest.main()
