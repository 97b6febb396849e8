"""Ends with 0 if two PNG pictures have the same size, and the same colours in pixels X,Y from the upper left."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Program"))
from program import read_png  # noqa: E402

FIRST, SECOND = (read_png(path) for path in sys.argv[1:3])
if FIRST[:2] != SECOND[:2]:
    sys.exit(f"the sizes differ: {FIRST[:2]}, {SECOND[:2]}")
for pixel in sys.argv[3:]:
    x, y = map(int, pixel.split(","))
    colors = [tuple(picture[2][y][3 * x : 3 * x + 3]) for picture in (FIRST, SECOND)]
    if colors[0] != colors[1]:
        sys.exit(f"the colours of {pixel} differ: {colors}")
