"""Compute in advance how likely a verdict on a claim is with a given number of homes."""

import math

import numpy as np
from scipy import stats

from placecat.evaluation.verdict import Range

_DRAWS = 4000


def spread(low: float, high: float, homes: int, level: float = 0.95) -> float:
    """Estimate the standard deviation between homes (2 or more) from the interval of a mean difference."""
    half = (high - low) / 2.0
    return half * math.sqrt(homes) / float(stats.t.ppf((1.0 + level) / 2.0, homes - 1))


def power(
    effect: float, deviation: float, homes: int, claimed: Range, *, level: float = 0.95, wide: float = 0.95
) -> tuple[float, float]:
    """Compute the probability of each verdict, assuming independent, normally distributed differences.

    `effect` and `deviation` are the mean and standard deviation of the difference over homes, in points.
    `homes` is the number of homes, at least 2, and `claimed` is the range that the claim allows. For `holds`,
    the interval at `level` must lie inside the range. For `fails`, the interval at `wide`
    (`placecat.evaluation.verdict.corrected_level`) must lie outside. Returns the probabilities of `holds` and
    of `fails`, from 4,000 fixed draws of mean and deviation.
    """
    rng = np.random.default_rng(20210)
    means = effect + deviation / math.sqrt(homes) * rng.standard_normal(_DRAWS)
    errors = deviation / math.sqrt(homes) * np.sqrt(rng.chisquare(homes - 1, _DRAWS) / (homes - 1))
    inner, outer = (errors * stats.t.ppf((1.0 + one) / 2.0, homes - 1) for one in (level, wide))
    holds = (claimed.low < means - inner) & (means + inner < claimed.high)
    fails = (means + outer <= claimed.low) | (claimed.high <= means - outer)
    return float(holds.mean()), float((fails & ~holds).mean())
