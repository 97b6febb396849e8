"""Print the figures that TestImageError.cxx expects, as rows of its table.

    pip install flip-evaluator==1.7 scikit-image==0.26.0 && python3 image_error_figures.py

The pictures are the ones that the test makes: 8-bit values from integer formulas and a hash.
"""

import flip_evaluator
import numpy
from scipy.ndimage import gaussian_filter
from skimage.metrics import structural_similarity


def mix(value):
    """lowbias32 by C. Wellons."""
    value &= 0xFFFFFFFF
    value = ((value ^ (value >> 16)) * 0x7FEB352D) & 0xFFFFFFFF
    value = ((value ^ (value >> 15)) * 0x846CA68B) & 0xFFFFFFFF
    return value ^ (value >> 16)


def noise(seed, x, y, c):
    return mix(mix(mix(seed) + x) + 4 * y + c)


def clamped(value):
    return min(max(value, 0), 255)


def plates(x, y, c):
    return (x // 8 + y // 8) % 2 * 150 + 20 + 30 * c


# name: (reference, test)
PICTURES = {
    "noise": (
        lambda x, y, c: noise(1, x, y, c) % 256,
        lambda x, y, c: clamped(noise(1, x, y, c) % 256 + noise(2, x, y, c) % 21 - 10),
    ),
    "ramps": (
        lambda x, y, c: clamped(3 * x + 2 * y * c),
        lambda x, y, c: clamped(3 * x + 2 * y * c + noise(3, x, y, c) % 3 - 1),
    ),
    "plates": (plates, lambda x, y, c: plates(x + 1, y, c)),
    "primaries": (
        lambda x, y, c: 255 if (x // 4 + y // 5) % 3 == c else 0,
        lambda x, y, c: 255 if (x // 4 + y // 5 + 1) % 3 == c else 0,
    ),
    "extremes": (lambda x, y, c: 0, lambda x, y, c: 255),
}


def picture(formula, width, height):
    values = [[[formula(x, y, c) for c in range(3)] for x in range(width)] for y in range(height)]
    return (numpy.array(values) / 255).astype(numpy.float32)


def ssim(a, b):
    a, b = a.astype(numpy.float64), b.astype(numpy.float64)
    if min(a.shape[:2]) >= 11:
        return structural_similarity(
            a,
            b,
            gaussian_weights=True,
            sigma=1.5,
            use_sample_covariance=False,
            data_range=1,
            channel_axis=2,
        )
    # scikit-image refuses pictures smaller than its window: the same formula, with nothing cropped
    # along the short axes.
    window = lambda plane: gaussian_filter(plane, 1.5, truncate=3.5, mode="reflect", axes=(0, 1))
    mean_a, mean_b = window(a), window(b)
    variance_a = window(a * a) - mean_a**2
    variance_b = window(b * b) - mean_b**2
    covariance = window(a * b) - mean_a * mean_b
    similarity = (
        (2 * mean_a * mean_b + 0.01**2)
        * (2 * covariance + 0.03**2)
        / ((mean_a**2 + mean_b**2 + 0.01**2) * (variance_a + variance_b + 0.03**2))
    )
    crop = [slice(5, -5) if size >= 11 else slice(None) for size in a.shape[:2]]
    return similarity[crop[0], crop[1]].mean()


def main():
    for name, width, height in [
        ("noise", 40, 30),
        ("ramps", 64, 48),
        ("plates", 51, 37),
        ("primaries", 33, 47),
        ("extremes", 24, 24),
        ("noise", 11, 11),
        ("noise", 5, 7),
        ("plates", 200, 9),
        ("noise", 1, 1),
    ]:
        reference, test = (picture(formula, width, height) for formula in PICTURES[name])
        _, flip, _ = flip_evaluator.evaluate(
            reference, test, "LDR", inputsRGB=True, applyMagma=False, computeMeanError=True
        )
        difference = numpy.abs(test.astype(numpy.float64) - reference)
        rmse = numpy.sqrt((difference**2).mean())
        wrong = (difference.max(axis=2) > 1 / 255 + 1e-6).mean()
        print(
            f'{{ "{name}", {width}, {height}, {difference.max():.8f}, {rmse:.8f}, '
            f"{-20 * numpy.log10(rmse):.6f}, {ssim(test, reference):.8f}, {flip:.6f}, {wrong:.8f} }},"
        )


if __name__ == "__main__":
    main()
