"""What each rank of mpirun does for rank_figures.py: a turn of a model whose cells are divided among the ranks.

    mpirun -np N python3 -m mpi4py rank_turn.py SOURCE OPACITY PARTITION GHOSTS SIZE STORAGE SAMPLES FRAMES

Each rank keeps to one core, and the ranks take the cores in turn. Rank 0 writes one line of JSON with a row for each
rank. Times are in seconds.
"""

import json
import os
import sys
import time

import numpy as np
from mpi4py import MPI  # which initializes MPI
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkParallelMPI import vtkMPIController
from vtkmodules.vtkRenderingCore import vtkRenderer

import vitrine
from pieces import actor_of, piece_of, scene_of

SEED = 54
TURN = 3.0  # degrees a frame

comm = MPI.COMM_WORLD
controller = vtkMPIController()
controller.Initialize()
rank, ranks = comm.Get_rank(), comm.Get_size()
os.sched_setaffinity(0, {rank % os.cpu_count()})


def window_of(data, size, samples):
    window = vitrine.vtkHeadlessRenderWindow()
    window.SetSize(*size)
    window.SetMultiSamples(samples)
    renderer = vtkRenderer()
    renderer.SetBackground(0.2, 0.3, 0.4)
    window.AddRenderer(renderer)
    renderer.AddActor(actor_of(data))
    return window, renderer


def pass_with(method, storage):
    getattr(method, f"SetColorStorageTo{storage}")()
    frame = vitrine.vtkSeeThroughPass()
    frame.SetTranslucentPass(method)
    return frame


def picture(window):
    window.Render()
    width, height = window.GetSize()
    pixels = vtkUnsignedCharArray()
    window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
    return vtk_to_numpy(pixels).copy()


def turn(window, renderer, frames, synchronize):
    """The times of the frames of a turn, after the first."""
    times = []
    for _ in range(frames + 1):
        renderer.GetActiveCamera().Azimuth(TURN)
        synchronize()
        begin = time.perf_counter()
        window.Render()
        times.append(time.perf_counter() - begin)
    return times[1:]


def wait_for_all():
    """A barrier that leaves the cores to others."""
    request = comm.Ibarrier()
    while not request.Test():
        time.sleep(0.005)


def main():
    source, opacity, partition, ghosts, size, storage, samples, frames = sys.argv[1:]
    size = tuple(map(int, size.split("x")))
    samples, frames = int(samples), int(frames)
    scene = scene_of(vitrine.load(source), float(opacity) if float(opacity) < 1 else None)
    random = np.random.default_rng(SEED)
    window, renderer = window_of(piece_of(scene, rank, ranks, partition, ghosts == "1", random), size, samples)
    method = vitrine.vtkDistributedTransparencyPass()
    method.SetController(controller)
    together = pass_with(method, storage)
    alone = pass_with(vitrine.vtkPrefixSumTransparencyPass(), storage)
    renderer.SetPass(together)
    method.ResetCamera(renderer)

    def synchronize():
        method.SynchronizeCamera(renderer)
        wait_for_all()

    took = turn(window, renderer, frames, synchronize)
    told = {
        "together": took,
        "fragments": method.GetNumberOfFragments(),
        "sent": method.GetSentFragments(),
        "bytes": method.GetSentFragmentBytes(),
        "other": method.GetSentOtherBytes(),
        "node": method.GetNodeBytes(),
        "reason": method.GetFallbackReason(),
    }
    renderer.GetActiveCamera().Azimuth(-TURN * (frames + 1))
    renderer.SetPass(alone)
    told["alone"] = turn(window, renderer, frames, wait_for_all)
    renderer.SetPass(together)
    method.SynchronizeCamera(renderer)
    shown = picture(window)
    if rank == 0:
        whole, one = window_of(scene.piece(np.arange(len(scene.triangles))), size, samples)
        one.SetPass(pass_with(vitrine.vtkLinkedListTransparencyPass(), storage))
        one.SetActiveCamera(renderer.GetActiveCamera())
        told["differing"] = int((picture(whole) != shown).sum())
    rows = comm.gather(told)
    if rank == 0:
        print(json.dumps(rows), flush=True)


main()
