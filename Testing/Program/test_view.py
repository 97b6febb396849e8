import unittest

from program import ProgramTest, run


class ViewCommand(ProgramTest):
    def test_without_a_display_it_says_so(self):
        for display in (None, ""):
            result = run("view", "demo:stack,layers=2", DISPLAY=display)
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stderr.count(b"\n"), 1)
            self.assertIn(b"DISPLAY", result.stderr)


if __name__ == "__main__":
    unittest.main()
