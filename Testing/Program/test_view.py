import unittest

from program import ProgramTest, run


class ViewCommand(ProgramTest):
    def test_without_a_display_it_says_so(self):
        for display in (None, ""):
            result = run("view", "demo:stack,layers=2", DISPLAY=display)
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stderr.count(b"\n"), 1)
            self.assertIn(b"DISPLAY", result.stderr)

    def test_a_tolerance_is_read_as_in_render(self):
        result = run("view", "demo:mating", "--coincidence", "16,x")
        self.assert_refused(result, "--coincidence", "STEPS[,SLOPE]")
        self.assert_refused(run("view", "demo:mating", "--coincidence", "16,0.01"), "DISPLAY")


if __name__ == "__main__":
    unittest.main()
