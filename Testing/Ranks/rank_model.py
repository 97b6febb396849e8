"""A model of frames of many ranks: fitted on runs of a few, and carried on to a thousand.

    python3 Testing/Ranks/rank_model.py RUNS.json    (of rank_figures.py --json)

The model of bytes: a rank with F fragments in a picture of P pixels sends F (N - 1) / N nodes to owners, and a part of
the picture, 4 P / N bytes, to the rank that shows it. The model of time: what a frame takes together beyond the frame
alone is a T + b B + c P, with T the messages of a rank, B the bytes of its nodes sent and received, and P the pixels.
It is fitted by least squares to runs of 2 to 8 ranks, and judged by leaving out one number of ranks after the other.

The simulation draws fragments as a dozen smooth heaps with noise, and gives tiles to ranks in turn, or by load: the
fullest tile first, each to the rank that has the least.
"""

import itertools
import json
import pathlib
import sys

import numpy as np

CORES = 2  # of the machine that was measured
NODE = 12
TILE = 32
FABRIC = 10e9  # bytes a second that a rank sends or receives on a cluster's network
LATENCY = 2e-6  # seconds a message


def rows_of(path):
    rows = [json.loads(line) for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines()]
    return [row for row in rows if row["ranks"] > 1 and not row["ghosts"]]


def terms(row):
    """Messages, bytes of nodes, and pixels, of the core with the most of them."""
    ranks, told = row["ranks"], row["told"]
    width, height = map(int, row["size"].split("x"))
    on_a_core = -(-ranks // CORES)
    sent = max(each["bytes"] for each in told)
    received = sum(each["bytes"] for each in told) / ranks
    return [on_a_core * 12 * (ranks - 1), on_a_core * (sent + received), on_a_core * width * height]


def beyond(row):
    """Seconds that a frame takes together beyond alone, the least of the frames."""
    times = [min(map(max, zip(*(each[way] for each in row["told"])))) for way in ("together", "alone")]
    return times[0] - times[1]


def fit(rows):
    """The coefficients of the least squares, none of which is negative."""
    matrix = np.array([terms(row) for row in rows], dtype=float)
    scale = matrix.max(axis=0)
    times = np.array([beyond(row) for row in rows])
    best, least = np.zeros(len(scale)), np.inf
    for used in itertools.product((False, True), repeat=len(scale)):
        solution = np.zeros(len(scale))
        if any(used):
            solution[list(used)] = np.linalg.lstsq((matrix / scale)[:, used], times, rcond=None)[0]
        error = np.square(matrix / scale @ solution - times).sum()
        if error < least and (solution >= 0).all():
            best, least = solution, error
    return best / scale


def bytes_off(row):
    """How far the model of bytes is off, as a share of the nodes' bytes that all ranks sent."""
    ranks, told = row["ranks"], row["told"]
    nodes = told[0]["fragments"] * NODE * (ranks - 1) / ranks
    return sum(each["bytes"] for each in told) / nodes - 1


def report(rows):
    coefficients = fit(rows)
    print("| scene | ranks | bytes, off by | time beyond alone, ms | by the model, ms | left out, ms |")
    print("| --- | --- | --- | --- | --- | --- |")
    for row in rows:
        others = fit([other for other in rows if other["ranks"] != row["ranks"]])
        print(
            f"| {row['scene']}, {row['partition']} | {row['ranks']} | {100 * bytes_off(row):+.1f} % | "
            f"{1e3 * beyond(row):.0f} | {1e3 * np.dot(terms(row), coefficients):.0f} | "
            f"{1e3 * np.dot(terms(row), others):.0f} |"
        )
    names = ("a message", "a byte", "a pixel")
    print(", ".join(f"{1e9 * value:.2f} ns {name}" for name, value in zip(names, coefficients)))
    return coefficients


def loads(ranks, columns, rows, random):
    """The fragments of the fullest rank over the mean, by turns and by load."""
    x, y = np.meshgrid(np.linspace(-1, 1, columns), np.linspace(-1, 1, rows))
    smooth = sum(
        weight * np.exp(-((x - cx) ** 2 + (y - cy) ** 2) / width**2)
        for weight, cx, cy, width in random.uniform([0.2, -0.7, -0.7, 0.1], [1, 0.7, 0.7, 0.5], (12, 4))
    )
    fragments = smooth * random.uniform(0.5, 1.5, smooth.shape)
    step = max(1, round(0.618 * ranks))
    while np.gcd(step, ranks) != 1:
        step += 1
    column, row = np.meshgrid(np.arange(columns), np.arange(rows))
    in_turn = np.bincount(((column + step * row) % ranks).ravel(), fragments.ravel(), ranks)
    by_load = np.zeros(ranks)
    for load in np.sort(fragments.ravel())[::-1]:
        by_load[np.argmin(by_load)] += load
    return in_turn.max() / in_turn.mean(), by_load.max() / by_load.mean()


def extrapolate(coefficients):
    """Frames of a cluster: each rank has a core as fast as the measured ones, and a link of its own."""
    _, a_byte, a_pixel = coefficients
    random = np.random.default_rng(54)
    print("\n| picture | ranks | fragments a rank | sent by a rank | nodes, ms | pixels, ms | direct send, ms | "
          "radix-8, ms | fullest in turn | by load |")
    print("|" + 10 * " --- |")
    for width, height, layers in ((1920, 1080, 8), (7680, 4320, 8)):
        for ranks in (8, 64, 256, 1000):
            pixels = width * height
            fragments = pixels * layers / ranks
            sent = fragments * NODE * (ranks - 1) / ranks
            in_turn, by_load = loads(ranks, width // TILE, height // TILE, random)
            # Direct send: each rank has a message for each other, twice for opaque pixels, once for nodes. Radix-k
            # sends all in log_k steps, and the nodes again in each.
            steps = int(np.ceil(np.log(ranks) / np.log(8)))
            direct = 3 * (ranks - 1) * LATENCY + 2 * sent / FABRIC
            radix = 3 * steps * 7 * LATENCY + 2 * steps * sent / FABRIC
            print(
                f"| {width} x {height} | {ranks} | {fragments / 1e6:.2f} M | {sent / 1e6:.1f} MB | "
                f"{1e3 * a_byte * 2 * sent:.1f} | {1e3 * a_pixel * pixels:.1f} | {1e3 * direct:.1f} | "
                f"{1e3 * radix:.1f} | {in_turn:.2f} | {by_load:.2f} |"
            )


if __name__ == "__main__":
    extrapolate(report(rows_of(sys.argv[1])))
