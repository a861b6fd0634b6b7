"""Small synthetic frame maps and regions."""

import importlib.util
from types import ModuleType

import cv2
import numpy as np
import pytest

from placecat import lookup
from placecat.vision.discovery import load
from placecat.vision.maps import FrameMaps

SCALES = (2, 3, 4, 5)


def smooth(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    """Return a float32 image of random blobs, from 0 to 255."""
    image = cv2.GaussianBlur(rng.random((height, width), np.float32), (0, 0), 1.5)
    low, high = image.min(), image.max()
    return (image - low) / max(float(high - low), 1e-6) * np.float32(255)


def maps(width: int = 320, height: int = 240, seed: int = 0) -> FrameMaps:
    rng = np.random.default_rng(seed)
    sizes = {s: (-(-height >> s), -(-width >> s)) for s in SCALES}

    def fill(*channels: int, low: float = 0.0) -> dict[int, np.ndarray]:
        return {s: rng.uniform(low, 3, (*channels, *size)).astype(np.float32) for s, size in sizes.items()}

    return FrameMaps(
        width=width,
        height=height,
        scales=SCALES,
        grey={s: smooth(rng, *size) for s, size in sizes.items()},
        color=fill(4, low=-3),
        intensity_contrast=fill(2, 2),
        color_contrast=fill(2, 4),
        orientation=fill(4),
        residual=fill(),
    )


def regions(width: int = 320, height: int = 240, count: int = 25, seed: int = 1) -> np.ndarray:
    """Return random regions of all scales. The first four lie in the corners of the image."""
    rng = np.random.default_rng(seed)
    rows = np.stack(
        [
            rng.uniform(0, width - 1, count),
            rng.uniform(0, height - 1, count),
            rng.choice(SCALES, count),
            rng.random(count),
        ],
        axis=1,
    )
    corners = [(0, 0), (width - 1, 0), (0, height - 1), (width - 1, height - 1)]
    for row, corner in zip(rows, corners, strict=False):
        row[:2] = corner
    return rows.astype(np.float32)


def frame(width: int = 320, height: int = 240, seed: int = 2) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return np.stack([smooth(rng, height, width) for _ in range(3)], axis=2).astype(np.uint8)


def missing(module: ModuleType) -> str:
    """Return the first package in the ``PACKAGES`` of a descriptor that is not installed, or ""."""
    needed = getattr(module, "PACKAGES", ())
    return next((name for name in needed if importlib.util.find_spec(name) is None), "")


def names(kind: str) -> list[str]:
    """Return the names of the holistic or local descriptors."""
    return lookup.names(f"placecat.vision.{kind}", "describe")


def installed(kind: str) -> list[str]:
    """Return the names of the holistic or local descriptors whose packages are installed."""
    return [name for name in names(kind) if not missing(load(kind, name))]


def every(kind: str) -> list:
    """Return every descriptor as a test parameter, skipped if its packages are not installed."""
    return [
        pytest.param(name, marks=pytest.mark.skipif(bool(lacks), reason=f"{name} needs {lacks}"))
        for name in names(kind)
        for lacks in [missing(load(kind, name))]
    ]
