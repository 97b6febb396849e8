"""vtkDistributedTransparencyPass on several ranks of mpirun: each picture is to the bit that of one rank.

VITRINE_RANKS_PICTURES names a folder for the pictures that differ. VITRINE_RANKS has other numbers of ranks, as "2,5".
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PARTITIONS = ("kd-tree", "round-robin", "random")
EXACT = (
    *(f"{partition}{ghosts}" for partition in PARTITIONS for ghosts in ("", "-ghosts")),
    *("compact", "eight-bit", "bands", "moving", "empty", "nothing", "viewport", "floats", "all-ranks", "splats"),
    *("splats-expected", "drift", "forced", "features", "tiles", "samples-4-ghosts"),
)
OF_THREE = (  # those that depend on the number of ranks
    *("kd-tree-ghosts", "round-robin-ghosts", "random", "bands", "moving", "empty", "viewport", "all-ranks", "drift"),
    *("features", "tiles", "samples-4-ghosts"),
)
SAMPLED = (  # on two ranks alone, for time
    *("samples-2", "samples-4", "samples-8", "samples-viewport", "samples-parallel", "samples-bands"),
    "samples-features",
)
REFUSED = {
    "sizes": "draws 100 x 80 pixels and rank 0 160 x 120 pixels; give all windows one size",
    "cameras": "has another camera than rank 0; call SynchronizeCamera() on all ranks before they render",
    "storages": "has another color storage, coincidence tolerance or picture rank than rank 0",
    "backgrounds": "has other lights or another background than rank 0; give all renderers the same",
    "grids": "data of a vtkDataSetMapper have ghost cells, which several ranks would draw",
    "memory": "one pixel alone has",
    "occlusion": "ambient occlusion and shadows see the geometry of one rank alone",
    "samples": "draws 4 samples a pixel and rank 0 0; call SetMultiSamples() alike",
}
MOST_BYTES = 1.1  # for each byte of the nodes that are sent


def run(ranks, *words, script="rank_cases.py", timeout=120):
    """Run a script of this folder on so many ranks, one thread of the rasteriser each."""
    environment = {
        **os.environ,
        "LP_NUM_THREADS": "1",
        "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_btl_vader_single_copy_mechanism": "none",  # which containers may forbid
        "OMPI_MCA_mpi_yield_when_idle": "1",
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    command = [sys.executable, "-m", "mpi4py", str(HERE / script), *words]
    return subprocess.run(
        ["mpirun", "--oversubscribe", "-np", str(ranks), *command],
        env=environment,
        capture_output=True,
        text=True,
        timeout=timeout,
        check=False,
    )


def told_by(result):
    """What the ranks told, by cases."""
    lines = [json.loads(line) for line in result.stdout.splitlines() if line.startswith("[{")]
    return {rows[0]["case"]: rows for rows in lines}


class Ranks(unittest.TestCase):
    def assert_exact(self, case, rows, ranks):
        self.assertEqual(len(rows), ranks)
        self.assertEqual([row["reason"] for row in rows], ranks * [""])
        self.assertEqual(rows[0]["differing"], 0)
        self.assertGreater(rows[0]["covered"], 500)
        self.assertGreater(rows[0].get("smoothed", 501), 500)
        self.assertEqual(len({row["fragments"] for row in rows}), 1)
        self.assertEqual(rows[0]["bands"] > 1, case in ("bands", "samples-bands"))
        for row in rows:
            self.assertLessEqual(row["bytes"], MOST_BYTES * row["sent"] * row["node"] + 8 * ranks * row["bands"])
        if case not in ("empty", "nothing"):
            self.assertTrue(all(row["sent"] > 0 for row in rows))

    def test_pictures_are_those_of_one_rank(self):
        every = EXACT + SAMPLED + tuple(REFUSED)
        cases = {2: every, 3: OF_THREE, 8: ("random-ghosts", "kd-tree", "bands")}
        if "VITRINE_RANKS" in os.environ:
            cases = dict.fromkeys(map(int, os.environ["VITRINE_RANKS"].split(",")), every)
        for ranks, names in cases.items():
            result = run(ranks, *names)
            told = told_by(result)
            self.assertEqual(result.returncode, 0, result.stderr)
            for case in names:
                with self.subTest(case=case, ranks=ranks):
                    self.assert_exact(case, told[case], ranks)
                    self.assertTrue(all(all(row.get("same", [True])) for row in told[case]))
                    for row in told[case]:
                        self.assertIn(REFUSED.get(case, ""), row.get("refused", ""))

    def test_the_script_of_the_page_runs(self):
        page = (HERE.parents[1] / "docs/howto/several-ranks.md").read_text(encoding="utf-8")
        script = "\n".join(re.findall(r"^```python\n(.*?)^```$", page, re.M | re.S))
        script = script.replace("640, 360", "320, 180").replace("1280, 720", "640, 360")
        tell = (
            "if rank == 0: print([ranks.GetFallbackReason(), ranks.GetNumberOfFragments() > 100_000, "
            "picker.GetNumberOfLayers() > 5, picker.GetProblem()])\n"
        )
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "script.py")
            path.write_text(script + tell, encoding="utf-8")
            result = run(2, script=path)
        self.assertIn("['', True, True, '']", result.stdout, result.stderr)

    def test_a_rank_without_the_features_is_told_to_all(self):
        result = run(2, "lacking")
        reasons = [row["reason"] for row in told_by(result)["lacking"]]
        self.assertEqual(reasons, 2 * ["rank 1: OpenGL 4.3 is needed, the context has 4.2"])

    def test_ranks_do_not_wait_for_one_that_has_ended(self):
        for case, reason in (("killed", "signal 9"), ("raising", "this rank raises")):
            with self.subTest(case=case):
                result = run(3, case, timeout=30)
                self.assertNotEqual(result.returncode, 0)
                self.assertIn(reason, result.stderr + result.stdout)


if __name__ == "__main__":
    unittest.main()
