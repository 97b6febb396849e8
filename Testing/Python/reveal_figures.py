"""Figures of reveal(): does the share hold in each pixel, how much context remains, and what does it take?

    python3 Testing/Python/reveal_figures.py FILE... [--parts 200] [--views 3] [--turn 20] [--size 640x480] [--seed 51]

Parts are chosen by a seed among those of which at least nine tenths of the pixels are hidden in a view. For each, the
shares are read from a capture after a frame. "Over one opacity" is the context beside that of one opacity for all parts
in front, the largest that keeps the share. Times are CPU times of all threads of the first reveal() of a part. Turning
is by a degree a frame, for the first parts.
"""

import argparse
import pathlib
import statistics
import time

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

import vitrine

SHARE = 0.7


def stacks_of(renderer, actor, block, region):
    """What passes the layers in front of a part, for each of its pixels, and how many these are."""
    layers = vitrine.layers_in(renderer, *region, all=True)
    wanted = {n for n in np.unique(layers.numbers) if layers.actor(n) is actor and layers.block(n) == block}
    shares, counts = [], []
    for pixel in range(len(layers.offsets) - 1):
        first, last = layers.offsets[pixel], layers.offsets[pixel + 1]
        at = next((i for i in range(first, last) if layers.numbers[i] in wanted), None)
        if at is not None:
            shares.append(float(np.prod(1.0 - layers.opacities[first:at].astype(float))))
            counts.append(at - first)
    return np.array(shares), np.array(counts)


def region_of(machine, renderer, number, size):
    """The pixels around the box of a part, or None if it is outside of the view."""
    bounds = machine.actors.GetPartGeometry(number).GetBounds()
    place = machine.actors.GetPartPlace(number)
    corners = []
    for corner in range(8):
        point = (bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)], 1)
        renderer.SetWorldPoint(*(place.MultiplyPoint(point) if place is not None else point))
        renderer.WorldToDisplay()
        corners.append(renderer.GetDisplayPoint()[:2])
    low = np.floor(np.min(corners, axis=0) - 1).astype(int).clip(0, np.array(size) - 1)
    high = np.ceil(np.max(corners, axis=0) + 1).astype(int).clip(0, np.array(size) - 1)
    return (*map(int, low), *map(int, high)) if (low < high).all() else None


def candidates(machine, renderer, window, size, random):
    """Parts in a random order of which nine tenths of the pixels are hidden, by the opaque frame."""
    window.Render()
    for number in random.permutation(len(machine)):
        number = int(number)
        region = region_of(machine, renderer, number, size)
        if region is None:
            continue
        actor, block = machine.actors.GetPartActor(number), machine.actors.GetPartBlock(number)
        shares, counts = stacks_of(renderer, actor, block, region)
        if len(counts) >= 4 and (counts > 0).mean() >= 0.9:
            yield number, actor, block, region, counts


def measure(path, options):
    size = tuple(int(n) for n in options.size.split("x"))
    machine = vitrine.load(path)
    renderer = vtkRenderer()
    window = vitrine.vtkHeadlessRenderWindow()
    window.SetSize(*size)
    window.SetMultiSamples(0)  # with samples, a pixel's layers are those of all of them
    window.AddRenderer(renderer)
    machine.add_to(renderer)
    vitrine.see_through(renderer)
    renderer.ResetCamera()
    pixels = below = 0
    proved, ratios, times, cut = [], [], [], 0
    turned = turned_below = dropped = 0
    random = np.random.default_rng(options.seed)
    for view in range(options.views):
        camera = renderer.GetActiveCamera()
        camera.Azimuth(360 / options.views)
        camera.Elevation(15)
        camera.OrthogonalizeViewUp()
        renderer.ResetCameraClippingRange()
        wanted = -(-options.parts // options.views)
        for place, found in enumerate(candidates(machine, renderer, window, size, random)):
            if place == wanted:
                break
            number, actor, block, region, counts = found
            start = time.process_time()
            handle = vitrine.reveal(renderer, machine.parts[number], SHARE, outlines=False)
            times.append(1e3 * (time.process_time() - start))
            window.Render()
            shares, _ = stacks_of(renderer, actor, block, region)
            pixels += len(shares)
            below += int((shares < SHARE).sum())
            proved.append(handle.proved)
            one = 1 - SHARE ** (1 / counts.max())
            ratios.append(handle.context / one)
            handle.remove()
            if place < options.turning:
                follow = vitrine.reveal(renderer, machine.parts[number], SHARE, outlines=False, follow=True)
                for _ in range(options.turn):
                    camera.Azimuth(1)
                    window.Render()
                    now = region_of(machine, renderer, number, size)
                    if now is not None:
                        shares, _ = stacks_of(renderer, actor, block, now)
                        turned += len(shares)
                        turned_below += int((shares < SHARE).sum())
                        dropped += follow._reveal.GetNumberOfDroppedParts()
                follow.remove()
                camera.Azimuth(-options.turn)
            window.Render()
    print(
        f"| {pathlib.Path(path).stem} | {len(times)} | {below} of {pixels} | {min(proved):.3f} "
        f"| {statistics.median(ratios):.1f} | {statistics.median(times):.0f}, {np.quantile(times, 0.9):.0f} "
        f"| {turned_below} of {turned} | {dropped} |",
        flush=True,
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--parts", type=int, default=200)
    parser.add_argument("--views", type=int, default=3)
    parser.add_argument("--turn", type=int, default=20, help="degrees")
    parser.add_argument("--turning", type=int, default=2, help="parts of each view around which the eye turns")
    parser.add_argument("--size", default="640x480")
    parser.add_argument("--seed", type=int, default=51)
    options = parser.parse_args()
    print("| model | parts | pixels below the share | context proved, least | over one opacity, median "
          "| ms, median, 90 % | pixels below while turning | parts that dropped |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for path in options.files:
        measure(path, options)


if __name__ == "__main__":
    main()
