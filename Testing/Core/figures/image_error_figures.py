"""Ask flip-evaluator and scikit-image for the errors of the pairs of pictures that a program writes.

    image_error_figures.py PROGRAM          is ImageErrorFigures.inc what they say? exit status 1 if not
    image_error_figures.py PROGRAM --write  write ImageErrorFigures.inc

PROGRAM is VitrineWriteImagePairs of a build tree. requirements.txt names the packages.
"""

import argparse
import ast
import pathlib
import subprocess
import sys
import tempfile

import flip_evaluator
import numpy
from scipy.ndimage import gaussian_filter
from skimage.metrics import mean_squared_error, peak_signal_noise_ratio, structural_similarity

FILE = pathlib.Path(__file__).with_name("ImageErrorFigures.inc")
WINDOW = 11  # of SSIM, in pixels

# How far figures may be from those of the file. flip-evaluator computes in 32 bits, and the last of them may depend on
# the processor: TestImageErrorFigures.cxx says what that makes.
TOLERANCES = [
    ("max", 1e-8),
    ("RMSE", 1e-8),
    ("PSNR", 1e-6),
    ("SSIM", 1e-8),
    ("FLIP", 3e-5),
    ("wrong pixels", 1e-8),
]


def read_picture(file):
    """8-bit values of shape (height, width, 3)."""
    kind, size, largest, values = file.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    assert (kind, largest) == (b"P6", b"255"), file
    return numpy.frombuffer(values, numpy.uint8).reshape(height, width, 3)


def similarity(a, b):
    """SSIM by scikit-image, of pictures that are at least as large as its window."""
    return structural_similarity(
        a,
        b,
        gaussian_weights=True,
        sigma=1.5,
        use_sample_covariance=False,
        data_range=1,
        channel_axis=2,
    )


def similarity_of_small(a, b):
    """The same formula, which scikit-image refuses here: nothing is cropped along the axes that are too short."""

    def mean(values):
        return gaussian_filter(values, 1.5, truncate=3.5, mode="reflect", axes=(0, 1))

    mean_a, mean_b = mean(a), mean(b)
    variance_a, variance_b = mean(a * a) - mean_a**2, mean(b * b) - mean_b**2
    covariance = mean(a * b) - mean_a * mean_b
    values = (2 * mean_a * mean_b + 0.01**2) * (2 * covariance + 0.03**2)
    values /= (mean_a**2 + mean_b**2 + 0.01**2) * (variance_a + variance_b + 0.03**2)
    border = WINDOW // 2
    rows, columns = (slice(border, -border) if n >= WINDOW else slice(None) for n in a.shape[:2])
    return values[rows, columns].mean()


def flip(reference, test):
    """The mean of flip-evaluator's map of errors, summed up in 64 bits."""
    errors, _, _ = flip_evaluator.evaluate(
        reference.astype(numpy.float32),
        test.astype(numpy.float32),
        "LDR",
        inputsRGB=True,
        applyMagma=False,
        computeMeanError=True,
    )
    return errors.astype(numpy.float64).mean()


def figures(reference, test):
    """What the program calls max, rmse, psnr, ssim, flip and wrong_pixels."""
    steps = numpy.abs(test.astype(int) - reference).max(axis=2)
    a, b = test / 255, reference / 255
    is_small = min(a.shape[:2]) < WINDOW
    return (
        steps.max() / 255,
        numpy.sqrt(mean_squared_error(b, a)),
        peak_signal_noise_ratio(b, a, data_range=1),
        similarity_of_small(a, b) if is_small else similarity(a, b),
        flip(b, a),
        (steps > 1).mean(),
    )


def measured(program):
    """(name, width, height, figures) of every pair."""
    with tempfile.TemporaryDirectory() as folder:
        names = subprocess.run(
            [program, folder], check=True, capture_output=True, text=True
        ).stdout.split()
        for name in names:
            reference, test = (
                read_picture(pathlib.Path(folder) / f"{name}.{kind}.ppm")
                for kind in ("reference", "test")
            )
            height, width = reference.shape[:2]
            yield name, width, height, figures(reference, test)


def write(rows):
    lines = ["// max, RMSE, PSNR, SSIM, FLIP, wrong pixels. Written by image_error_figures.py.\n"]
    for name, width, height, values in rows:
        numbers = ", ".join(f"{value:.10f}" for value in values)
        lines.append(f'{{ "{name}", {width}, {height}, {numbers} }},\n')
    FILE.write_text("".join(lines))


def read():
    for line in FILE.read_text().splitlines()[1:]:
        name, width, height, *values = ast.literal_eval(
            line.strip(",").translate({123: "(", 125: ")"})
        )
        yield name, width, height, values


def differences(rows):
    """In words, where the file is not what is measured."""
    expected = {(name, width, height): values for name, width, height, values in read()}
    for name, width, height, values in rows:
        picture = f"{name} {width} x {height}"
        in_file = expected.pop((name, width, height), None)
        if in_file is None:
            yield f"{picture} is not in the file"
            continue
        for (figure, tolerance), value, other in zip(TOLERANCES, values, in_file):
            if not abs(value - other) <= tolerance:
                yield f"{picture}: {figure} is {value:.10f}, in the file {other:.10f}"
    for name, width, height in expected:
        yield f"{name} {width} x {height} is in the file, but no pair has this name and size"


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("program")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    rows = list(measured(options.program))
    if options.write:
        write(rows)
        return 0
    found = list(differences(rows))
    print("\n".join(found) or f"{FILE.name}: {len(rows)} pairs, as measured")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
