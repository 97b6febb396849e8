"""Compares Vitrine's view and ParaView's own on the ranks of pvbatch: mpirun -np N pvbatch rank_times.py PLUGIN FOLDER.

By hand, with 1 rank first, which writes the pictures that those of several ranks are compared with. Prints for each
scene of ranks.py that is named here: pixels that differ from those of one rank, of those that are covered, by how many
levels of 255; and the wall time of a frame, in milliseconds, the least and the first.
"""

import pathlib
import sys
import time

from paraview.simple import CreateView, LoadPlugin, Render, ResetCamera

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.dont_write_bytecode = True

from pictures import delete_all, picture, read  # noqa: E402
from ranks import RANKS, SCENES  # noqa: E402

SIZE = [480, 400]
FRAMES = 15


def times_of(view):
    """The least time of a frame and that of the first, with a camera that moves there and back."""
    times = []
    for number in range(FRAMES):
        start = time.perf_counter()
        Render(view)
        times.append(1000 * (time.perf_counter() - start))
        view.GetActiveCamera().Azimuth(1 if number % 2 else -1)
    return min(times), times[0]


def main(plugin, folder):
    LoadPlugin(plugin, remote=False, ns=globals())
    for name in ("glass", "glass around opaque", "scalars bar and text", "blocks", "contours"):
        for kind in ("RenderView", "VitrineRenderView"):
            view = CreateView(kind)
            view.ViewSize, view.UseFXAA = SIZE, 0
            view.MaximumNumberOfPeels = 100
            SCENES[name](view)
            ResetCamera(view)
            least, first = times_of(view)
            file = pathlib.Path(folder, f"times-{name.replace(' ', '-')}-{kind}")
            drawn = picture(view, f"{file}-{RANKS}.png", ImageResolution=SIZE)
            one = read(f"{file}-1.png")
            off = abs(drawn - one).max(axis=2)
            covered = int((one != one[0, 0]).any(axis=2).sum())
            delete_all(view)
            print(f"{name} | {kind} | {(off > 0).sum()} of {covered}, by {off.max()} | {least:.1f} | {first:.1f}",
                  flush=True)


main(*sys.argv[1:])
