"""Figures of layers under pixels: are the parts and their order those of rays, and what does it take?

    python3 Testing/Python/layer_figures.py FILE... [--pixels 10000] [--size 640x480] [--opacity 0.5] [--seed 51]

Truth is float64: all triangles are projected, and those are taken that have the pixel's centre. A pixel is clear if its
centre is farther than 1/64 pixel from all edges of triangles there, and if depths of different parts in a row differ by
more than what vertices moved by 1/256 pixel, and rounding, can change. Only clear pixels are compared. Times are CPU
times of all threads, so that other programs count less. The first 20 pixels of a model come after a frame each.
"""

import argparse
import math
import pathlib
import statistics
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer

import vitrine

EDGE = 1 / 64  # pixels
SNAP = 1 / 256
FIRST = 20  # pixels that are asked for right after a frame each


class Truth:
    """All triangles of an assembly in a renderer's window, in float64."""

    def __init__(self, machine, renderer, size):
        to_clip = self._matrix(renderer, size)
        corners, numbers, culled = [], [], []
        for part in machine.parts:
            data = machine.actors.GetPartGeometry(part.number)
            place = machine.actors.GetPartPlace(part.number)
            points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
            if place is not None:
                matrix = np.array([[place.GetElement(i, j) for j in range(4)] for i in range(4)])
                points = points @ matrix[:3, :3].T + matrix[:3, 3]
            triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            homogeneous = np.c_[points, np.ones(len(points))] @ to_clip.T
            w = homogeneous[:, 3:]
            window = (homogeneous[:, :3] / w + 1) / 2 * [size[0], size[1], 1]
            corners.append(window[triangles])
            numbers.append(np.full(len(triangles), part.number))
            has_back = not machine.actors.GetPartProperty(part.number).GetBackfaceCulling()
            culled.append(np.full(len(triangles), not has_back))
        self.corners = np.concatenate(corners)
        self.numbers = np.concatenate(numbers)
        a, b, c = (self.corners[:, i] for i in range(3))
        seen = ~(np.concatenate(culled) & (self._cross(b - a, c - a) <= 0))
        self.corners, self.numbers = self.corners[seen], self.numbers[seen]
        self.low = self.corners[:, :, :2].min(1)
        self.high = self.corners[:, :, :2].max(1)

    @staticmethod
    def _matrix(renderer, size):
        camera = renderer.GetActiveCamera()
        matrix = camera.GetCompositeProjectionTransformMatrix(size[0] / size[1], -1, 1)
        return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])

    def layers(self, x, y):
        """Parts in order, or None if the pixel is not clear."""
        at = np.array([x + 0.5, y + 0.5])
        near = ((self.low <= at + EDGE) & (self.high >= at - EDGE)).all(1).nonzero()[0]
        a, b, c = (self.corners[near, i] for i in range(3))
        weights, distances = [], []
        area = self._cross(b - a, c - a)
        for first, second in ((b, c), (c, a), (a, b)):
            cross = self._cross(second - first, np.r_[at, 0] - first)
            length = np.hypot(*(second - first)[:, :2].T)
            with np.errstate(divide="ignore", invalid="ignore"):
                weights.append(cross / area)
                distances.append(cross * np.sign(area) / length)
        distance = np.min(distances, 0)
        if not np.isfinite(distance).all() or (np.abs(distance) < EDGE).any():
            return None
        inside = distance > 0
        weights = np.stack(weights)[:, inside]
        z = weights[0] * a[inside, 2] + weights[1] * b[inside, 2] + weights[2] * c[inside, 2]
        spread = np.max(np.abs([(b - a)[inside, 2], (c - a)[inside, 2]]), 0) if len(z) else z
        with np.errstate(divide="ignore"):
            reach = np.max(np.abs([(b - a)[inside, :2].T, (c - a)[inside, :2].T]), (0, 1))
            slope = spread * reach / np.abs(area[inside])
        slack = SNAP * slope + 2.0**-21
        order = np.argsort(z, kind="stable")
        numbers = self.numbers[near][inside][order]
        z, slack = z[order], slack[order]
        if ((z < 1e-6) | (z > 1 - 1e-6)).any():
            return None
        same = numbers[1:] == numbers[:-1]
        if ((np.diff(z) < slack[1:] + slack[:-1]) & ~same).any():
            return None
        return list(numbers)

    @staticmethod
    def _cross(u, v):
        return u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]


def window_of(path, size, opacity, numbers):
    window = vitrine.vtkHeadlessRenderWindow()
    window.SetSize(*size)
    window.SetMultiSamples(0)
    renderer = vtkRenderer()
    window.AddRenderer(renderer)
    machine = vitrine.load(path)
    machine["**"].opacity = opacity
    machine.add_to(renderer)
    vitrine.see_through(renderer, part_numbers=numbers)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(31)
    renderer.GetActiveCamera().Elevation(23)
    renderer.GetActiveCamera().Zoom(2.5)
    renderer.ResetCameraClippingRange()
    window.Render()
    window.Render()
    return window, renderer, machine


def compare(path, size, opacity, pixels, random):
    window, renderer, machine = window_of(path, size, opacity, True)
    truth = Truth(machine, renderer, size)
    picker = vitrine.vtkLayerPicker()
    picker.SetRenderer(renderer)
    clear = wrong = layers = listed = 0
    times, first = [], []
    for number in range(pixels):
        x, y = int(random.integers(size[0])), int(random.integers(size[1]))
        picker.SetArea(x, y, x, y)
        if number < FIRST:
            renderer.GetActiveCamera().Modified()
            window.Render()
            window.WaitForCompletion()
        begin = time.process_time()
        if not picker.Pick():
            raise SystemExit(picker.GetProblem())
        (first if number < FIRST else times).append(1e3 * (time.process_time() - begin))
        expected = truth.layers(x, y)
        if expected is None:
            continue
        clear += 1
        layers += len(expected)
        listed += picker.GetNumberOfListedLayers()
        found = [
            machine.actors.GetPart(picker.GetProp(i), picker.GetBlock(i))
            for i in range(picker.GetNumberOfLayers())
        ]
        if found != expected:
            wrong += 1
            if wrong <= 3:
                print(f"  {path.name} {x},{y}: {found} and not {expected}")
    return clear, wrong, layers, listed, times, first


def frames(path, size, opacity, count):
    """Medians of frames with part numbers, without, and without again, in turn."""
    windows = [window_of(path, size, opacity, numbers)[:2] for numbers in (True, False, False)]
    times = [[], [], []]
    for _ in range(count):
        for (window, renderer), spent in zip(windows, times):
            renderer.GetActiveCamera().Azimuth(1)
            begin = time.process_time()
            window.Render()
            window.WaitForCompletion()
            spent.append(time.process_time() - begin)
    stats = [vitrine.stats(renderer) for _, renderer in windows]
    return [statistics.median(spent) for spent in times], stats


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("--pixels", type=int, default=10000)
    parser.add_argument("--size", default="640x480")
    parser.add_argument("--opacity", type=float, default=0.5)
    parser.add_argument("--frames", type=int, default=0)
    parser.add_argument("--seed", type=int, default=51)
    args = parser.parse_args()
    size = tuple(map(int, args.size.split("x")))
    random = np.random.default_rng(args.seed)
    each = math.ceil(args.pixels / len(args.files))
    print(f"seed {args.seed}, {each} pixels a model, {args.size}")
    head = ["model", "clear", "wrong", "layers", "CPU ms after a frame: median, 90 %", "CPU ms of more"]
    print("| " + " | ".join([*head, "frames, on / off, off / off"]) + " |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    total = [0, 0, 0]
    for path in args.files:
        clear, wrong, layers, listed, times, first = compare(path, size, args.opacity, each, random)
        row = [path.stem, f"{clear} of {each}", str(wrong), f"{layers / max(clear, 1):.1f}"]
        for spent in (first, times):
            row.append(", ".join(f"{np.percentile(spent, share):.1f}" for share in (50, 90)))
        if args.frames:
            (on, off, again), _ = frames(path, size, args.opacity, args.frames)
            row.append(f"{on / off:.2f}, {again / off:.2f}")
        else:
            row.append("-")
        print("| " + " | ".join(row) + " |", flush=True)
        total = [total[0] + each, total[1] + clear, total[2] + wrong]
    print(f"{total[0]} pixels, {total[1]} of them clear, {total[2]} wrong")


if __name__ == "__main__":
    main()
