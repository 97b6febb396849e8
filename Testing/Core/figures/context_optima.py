"""Ask HiGHS, by scipy, for the largest context of the reveals that TestMostContext.cxx generates.

    context_optima.py          is ContextOptima.inc what HiGHS says? exit status 1 if not
    context_optima.py --write  write ContextOptima.inc

The context is concave in optical depths. Tangents bound it from above, so a linear programme gives a bound; the context
of its solution is reached. The optimum is between both.
"""

import pathlib
import sys

import numpy
from scipy.optimize import linprog
from scipy.sparse import diags, hstack, identity, lil_matrix, vstack

FILE = pathlib.Path(__file__).with_name("ContextOptima.inc")
REVEALS = [(1, 4, 6, 0.7), (2, 30, 60, 0.7), (3, 80, 50, 0.5), (4, 150, 400, 0.9), (5, 60, 300, 0.05)]
TANGENTS = 150
TOLERANCE = 1e-6


def numbers(seed):
    """The same numbers as those of TestMostContext.cxx: a linear congruential generator of 64 bits."""
    state = seed
    while True:
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        yield state >> 33


def reveal(seed, parts, stacks):
    """Layers of each part in each stack, weights, and the present opacities."""
    random = numbers(seed)
    layers = lil_matrix((stacks, parts))
    for stack in range(stacks):
        for _ in range(2 + next(random) % 12):
            layers[stack, next(random) % parts] += 1
    weights = numpy.array([1.0 + next(random) % 1000 for _ in range(parts)])
    opacities = numpy.array([(1 + next(random) % 10) / 10 for _ in range(parts)])
    return layers.tocsr(), weights, opacities


def optimum(seed, parts, stacks, share):
    layers, weights, opacities = reveal(seed, parts, stacks)
    used = layers.max(axis=0).toarray().ravel() > 0
    layers, weights, opacities = layers[:, used], weights[used], opacities[used]
    deepest = -numpy.log(share)
    with numpy.errstate(divide="ignore"):
        most = numpy.minimum(-numpy.log1p(-opacities), deepest)
    count = len(weights)
    rows = [hstack([layers, lil_matrix(layers.shape)])]
    limits = [numpy.full(stacks, deepest)]
    for place in numpy.linspace(0, 1, TANGENTS):
        at = most * place
        slope = numpy.exp(-at)
        rows.append(hstack([diags(-slope), identity(count)]))
        limits.append(1 - slope - slope * at)
    solution = linprog(
        numpy.concatenate([numpy.zeros(count), -weights]),
        A_ub=vstack(rows).tocsr(),
        b_ub=numpy.concatenate(limits),
        bounds=[(0, m) for m in most] + [(0, 1)] * count,
        method="highs",
    )
    depths = solution.x[:count]
    fits = min(1.0, deepest / (layers @ depths).max())
    return float(-weights @ numpy.expm1(-fits * depths)), float(-solution.fun)


def main():
    found = [(*made, *optimum(*made)) for made in REVEALS]
    if "--write" in sys.argv:
        lines = [f"{{ {s}, {p}, {n}, {share}, {low:.9f}, {high:.9f} }},\n" for s, p, n, share, low, high in found]
        text = "// seed, parts, stacks, share, context reached, bound. Written by context_optima.py.\n"
        FILE.write_text(text + "".join(lines), encoding="utf-8")
        return 0
    stored = [eval(line.strip(" {},\n")) for line in FILE.read_text(encoding="utf-8").splitlines()[1:]]
    bad = [f"{old} in the file, {new} by HiGHS" for old, new in zip(stored, found, strict=True)
           if not numpy.allclose(old, new, rtol=TOLERANCE)]
    print("\n".join(bad) or f"{len(found)} optima agree")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
