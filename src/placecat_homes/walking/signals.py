"""Smoothing and slow random wandering of signals over time."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def smoothed(values: Floats, width: int) -> Floats:
    """Average over `width` neighbours, twice. Beyond the ends, the first and last values are repeated."""
    width |= 1
    kernel = np.full(width, 1.0 / width)
    for _ in range(2):
        values = np.convolve(np.pad(values, width // 2, mode="edge"), kernel, mode="valid")
    return values


def wander(rng: np.random.Generator, count: int, deviation: float, slowness: float) -> Floats:
    """Draw a smooth random signal with a correlation length of about `slowness` steps."""
    width = max(1, round(slowness)) | 1
    noise = rng.normal(size=count + 2 * (width - 1))
    kernel = np.convolve(np.ones(width), np.ones(width))
    kernel /= np.sqrt((kernel**2).sum())
    return deviation * np.convolve(noise, kernel, mode="valid")


def limited(values: Floats, most: float) -> Floats:
    """Follow a signal in steps no larger than `most`."""
    result = values.copy()
    for index in range(1, len(result)):
        result[index] = result[index - 1] + np.clip(values[index] - result[index - 1], -most, most)
    return result
