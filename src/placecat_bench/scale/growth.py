"""Fit growth with the number of frames by a power law."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Growth:
    """A power law fitted to measurements.

    The exponent is 1 if the values are proportional to the number of frames. `r2`, at most 1, is the share of
    the logarithms' variance that the fit explains. `last` is the exponent between the two largest sizes,
    where constant costs, e.g. imports, matter little.
    """

    exponent: float
    r2: float
    last: float


def fit(frames: Sequence[float], values: Sequence[float]) -> Growth:
    """Fit values = factor * frames ** exponent by least squares on logarithms.

    `frames` and `values` are positive, (n,), n >= 2, with at least two different numbers of frames.

    >>> fit([100, 200, 400], [3.0, 12.0, 48.0]).exponent
    2.0
    """
    order = np.argsort(frames)
    x, y = np.log(np.asarray(frames, float)[order]), np.log(np.asarray(values, float)[order])
    if len(x) < 2 or x[0] == x[-1]:
        raise ValueError("an exponent needs two different numbers of frames or more")
    exponent, constant = np.polyfit(x, y, 1)
    rest = y - (exponent * x + constant)
    total = float(((y - y.mean()) ** 2).sum())
    r2 = 1.0 if total == 0.0 else 1.0 - float((rest**2).sum()) / total
    last = (y[-1] - y[-2]) / (x[-1] - x[-2]) if x[-1] > x[-2] else exponent
    return Growth(round(float(exponent), 6), r2, round(float(last), 6))
