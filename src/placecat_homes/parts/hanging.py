"""Hanging cloth."""

import math

import numpy as np

from placecat_homes.mesh import Mesh
from placecat_homes.shapes import extrude


def curtain(
    width: float, height: float, folds: int = 8, depth: float = 0.05, thickness: float = 0.004
) -> Mesh:
    """Draw a cloth hanging in folds, with its back near y = 0.

    Parameters
    ----------
    width, height, depth, thickness
        Dimensions in metres; `depth` is the depth of the folds.
    folds
        Number of folds across the width.

    Returns
    -------
    Mesh
        A cloth centred on x = 0, with its lower edge at z = 0.
    """
    steps = folds * 6
    x = np.linspace(-width / 2, width / 2, steps + 1)
    wave = depth / 2 * (1 + np.sin(np.linspace(0, 2 * math.pi * folds, steps + 1)))
    front = [(float(a), float(b) + thickness) for a, b in zip(x, wave, strict=True)]
    back = [(float(a), float(b)) for a, b in zip(x, wave, strict=True)]
    return extrude([*back, *front[::-1]], height, smooth=True, caps=False)
