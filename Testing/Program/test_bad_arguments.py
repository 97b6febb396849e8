import os
import unittest

from program import ProgramTest, run, scratch_folder


class BadArguments(ProgramTest):
    def test_help_is_everywhere(self):
        for arguments in (
            ["--help"],
            *([name, "--help"] for name in ("render", "compare", "chart", "diff", "info", "paper", "plan")),
            *([name, "--help"] for name in ("sorts", "stability", "view")),
        ):
            result = run(*arguments)
            self.assert_done(result)
            self.assertIn(b"Usage", result.stdout)

    def test_version(self):
        result = run("--version")
        self.assert_done(result)
        self.assertEqual(result.stdout.decode().strip(), os.environ["VITRINE_VERSION"])

    def test_no_command(self):
        self.assert_refused(run())

    def test_unknown_command(self):
        self.assert_refused(run("rendr", "demo:stack"), "rendr")

    def test_unknown_option(self):
        self.assert_refused(run("info", "demo:stack", "--colour"), "--colour")

    def test_unknown_switch_of_the_device_lists_the_known_ones(self):
        result = run("info", "demo:spheres", VITRINE_DEVICE="no-fetch,fast")
        self.assert_refused(result, "VITRINE_DEVICE", "'fast'", "no-fetch", "no-software")

    def test_no_input(self):
        self.assert_refused(run("info"), "INPUT")

    def test_unknown_method_lists_the_known_ones(self):
        for methods in (
            "depth",
            "linked-list,depth",
            "vtk-peeling-",
            "vtk-peeling-0",
            "vtk-peeling-x",
        ):
            with self.subTest(methods=methods):
                result = run("compare", "demo:stack,layers=2", "--methods", methods)
                self.assert_refused(
                    result, methods.split(",")[-1], "linked-list", "vtk-oit", "truth"
                )

    def test_no_method(self):
        self.assert_refused(run("compare", "demo:stack", "--methods", ","), "linked-list")

    def test_size(self):
        for size in ("0x8", "8x0", "8", "8x", "x8", "-8x8", "8x8x8", "8.5x8", "20000x8", "axb"):
            with self.subTest(size=size):
                self.assert_refused(run("info", "demo:stack", f"--size={size}"), "--size", size)
        self.assert_refused(run("stability", "demo:stack", "--size", "8x8193"), "--size", "8192")

    def test_section(self):
        for section in ("", "0,0,0,1", "1,0,0", "1,0,0,x", "nan,0,0,1", "1,0,0,0,0"):
            with self.subTest(section=section):
                self.assert_refused(run("info", "demo:stack", f"--section={section}"), "--section", section)
        seven = ["--section=1,0,0,0"] * 7
        self.assert_refused(run("info", "demo:stack", *seven), "--section", "six planes")
        for box in ("", "0,1,0,1,0", "0,1,0,1,0,1,0", "1,0,0,1,0,1", "0,1,0,1,1,1", "0,1,0,inf,0,1", "0,1,0,x,0,1"):
            with self.subTest(box=box):
                self.assert_refused(run("info", "demo:stack", f"--section-box={box}"), "--section-box", box)

    def test_looks_of_sections(self):
        for option, value, *of in (
            ("--hatch", "", "NAME"), ("--hatch", "wood", "'wood'"), ("--hatch", "*=wood", "dots"),
            ("--hatch", "missing*=dots", "missing*"), ("--keep-whole", "missing*", "missing*"),
            ("--cut-edges", "5", "0 to 4"), ("--cut-edges", "1.5", "0 to 4"),
        ):  # fmt: skip
            with self.subTest(option=option, value=value):
                self.assert_refused(run("info", "demo:stack", "--section=1,0,0,0", f"{option}={value}"), option, *of)
        for option in ("--hatch=dots", "--keep-whole=*", "--cut-edges=2"):
            with self.subTest(option=option):
                self.assert_refused(run("info", "demo:stack", option), option.split("=")[0], "needs --section")
        box = run("info", "demo:stack", "--section-box=0,1,0,1,0,1", "--keep-whole=*")
        self.assert_refused(box, "--keep-whole", "needs --section")

    def test_view(self):
        for view in (
            "1",
            "1,2,3,4",
            "0,91",
            "0,-91",
            "0,0,0",
            "0,0,-1",
            "a,b",
            "nan,0",
            "1,",
            ",1",
            "1e999,0",
        ):
            with self.subTest(view=view):
                self.assert_refused(run("info", "demo:stack", f"--view={view}"), "--view", view)

    def test_opacity(self):
        for opacity in ("-0.1", "1.1", "much", "nan", "inf"):
            with self.subTest(opacity=opacity):
                self.assert_refused(run("info", "demo:stack", f"--opacity={opacity}"), "opacity")

    def test_orbit(self):
        for orbit in ("nan", "inf", "3601", "far"):
            with self.subTest(orbit=orbit):
                self.assert_refused(run("compare", "demo:stack", f"--orbit={orbit}"), "--orbit")

    def test_multisamples(self):
        for samples in ("-1", "1", "3", "64", "many"):
            with self.subTest(samples=samples):
                self.assert_refused(
                    run("info", "demo:stack", f"--multisamples={samples}"), "--multisamples"
                )

    def test_coincidence(self):
        for coincidence in ("-1", "1,-1", "1,2,3", "1,", ",1", "nan", "inf", "near", ""):
            with self.subTest(coincidence=coincidence):
                self.assert_refused(
                    run("compare", "demo:stack", f"--coincidence={coincidence}"), "--coincidence"
                )

    def test_coincidence_of_a_method_that_has_none(self):
        with scratch_folder() as folder:
            path = folder / "picture.png"
            for method in ("stencil-routed", "stencil-mask-8", "blend"):
                self.assert_refused(
                    run(
                        *("render", "demo:stack", "-o", path, "--method", method),
                        *("--coincidence", "16"),
                    ),
                    *("--coincidence", method),
                )
            self.assertFalse(path.exists())

    def test_empty_names(self):
        self.assert_refused(run("info", "demo:stack", "--json", ""), "empty")
        self.assert_refused(run("info", ""), "empty")

    def test_stdout_that_is_full(self):
        with open("/dev/full", "wb") as full:
            result = run("info", "demo:stack,layers=2", "--size", "8x8", stdout=full)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr, b"vitrine: stdout cannot be written\n")

    def test_frames(self):
        self.assert_refused(run("compare", "demo:stack", "--frames", "0"), "frames")

    def test_unknown_scene_lists_the_known_ones(self):
        for scene in ("demo:", "demo:cube", "demo:Stack"):
            with self.subTest(scene=scene):
                self.assert_refused(run("info", scene), scene, "stack", "spheres", "assembly")

    def test_unknown_key_lists_the_known_ones(self):
        for setting in ("depth=3", "layers", "", "=3", "Layers=3"):
            with self.subTest(setting=setting):
                self.assert_refused(run("info", f"demo:stack,{setting}"), "layers", "alpha", "seed")
        self.assert_refused(run("info", "demo:assembly,layers=3"), "parts", "seed")

    def test_bad_values(self):
        for scene in (
            "demo:stack,layers=0", "demo:stack,layers=-1", "demo:stack,layers=1.5",
            "demo:stack,layers=", "demo:stack,layers=many", "demo:stack,layers=1e9",
            "demo:stack,alpha=1.01", "demo:stack,alpha=-0.1", "demo:stack,alpha=nan",
            "demo:stack,seed=-1", "demo:spheres,resolution=2", "demo:assembly,parts=-1",
            "demo:assembly,parts=abc", "demo:assembly,parts=1e9", "demo:assembly,parts=0x10",
            "demo:paper-masks,layers=65", "demo:paper-lists,layers=-1",
        ):  # fmt: skip
            with self.subTest(scene=scene):
                self.assert_refused(run("info", scene), scene, " from ", " to ")

    def test_a_key_is_set_once(self):
        for setting in ("layers=3,layers=3", "layers=3,seed=2,layers=4"):
            with self.subTest(setting=setting):
                self.assert_refused(run("info", f"demo:stack,{setting}"), "layers is set twice")

    def test_output_that_cannot_be_written(self):
        with scratch_folder() as folder:
            (folder / "folder.png").mkdir()
            for output in ("none/picture.png", "folder.png", "picture.jpg", "picture"):
                with self.subTest(output=output):
                    result = run("render", "demo:stack,layers=2", "-o", folder / output)
                    self.assert_refused(result, folder / output)
            result = run("info", "demo:stack,layers=2", "--json", folder / "none" / "info.json")
            self.assert_refused(result, folder / "none")
            self.assertEqual([path.name for path in folder.iterdir()], ["folder.png"])


if __name__ == "__main__":
    unittest.main()
