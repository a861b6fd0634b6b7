"""Compute, before a run, how many homes a verdict on a claim needs and how often the rule errs."""

import math

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from placecat.evaluation.bootstrap import stretch
from placecat.evaluation.verdict import Range

# Distributions of the difference in a home; `exponential` is skewed, `student` has 3 degrees of freedom.
SHAPES = ("normal", "exponential", "student")
_DRAWS = 4000
_SIMULATIONS, _RESAMPLES = 2000, 1000


def spread(low: float, high: float, homes: int, level: float = 0.95) -> float:
    """Estimate the standard deviation between homes (2 or more) from the interval of a mean difference."""
    half = (high - low) / 2.0
    return half * math.sqrt(homes) / float(stats.t.ppf((1.0 + level) / 2.0, homes - 1))


def power(
    effect: float, deviation: float, homes: int, claimed: Range, *, level: float = 0.95, wide: float = 0.95
) -> tuple[float, float]:
    """Compute the probability of each verdict if the differences in homes are normal and independent.

    `effect` and `deviation` are the mean and standard deviation of the compared difference over homes, in
    points; `homes` is their number, at least 2; `claimed` is the range that the claim allows. The interval at
    `level` must lie inside the range for `holds`, and the one at `wide`
    (`placecat.evaluation.verdict.corrected_level`) must lie outside for `fails`. Returns the probabilities of
    `holds` and of `fails`, from 4,000 fixed draws of mean and deviation.
    """
    rng = np.random.default_rng(20210)
    means = effect + deviation / math.sqrt(homes) * rng.standard_normal(_DRAWS)
    errors = deviation / math.sqrt(homes) * np.sqrt(rng.chisquare(homes - 1, _DRAWS) / (homes - 1))
    inner, outer = (errors * stats.t.ppf((1.0 + one) / 2.0, homes - 1) for one in (level, wide))
    holds = (claimed.low < means - inner) & (means + inner < claimed.high)
    fails = (means + outer <= claimed.low) | (claimed.high <= means - outer)
    return float(holds.mean()), float((fails & ~holds).mean())


def error_rate(
    truth: float,
    claimed: Range,
    *,
    homes: int,
    shape: str = "normal",
    group: int = 6,
    shared: float = 0.0,
    level: float = 0.95,
) -> float:
    """Simulate how often the ledger's rule decides wrongly.

    Each simulation draws homes, computes the interval over them
    (:func:`placecat.evaluation.bootstrap.paired_bootstrap`) and judges it. All simulations use the same
    resamples, since the ledger also uses a fixed seed for each comparison.

    Parameters
    ----------
    truth
        True mean difference; homes have a standard deviation of 1.
    claimed
        The claim's range. `holds` is wrong if the truth is outside, `does not hold` if it is inside.
    homes
        Number of homes, a multiple of `group`.
    shape
        One of `SHAPES`; a leading minus sign, as in "-exponential", turns the tail to the other side.
    group, shared
        Group size, and the share of variance that a group's homes have in common since each is training data
        for the others.
    level
        Level of the interval.

    Returns
    -------
    float
        Share of 2,000 simulations, each with 1,000 resamples, with a wrong verdict.
    """
    rng = np.random.default_rng(0)
    sign, name = (-1.0, shape[1:]) if shape.startswith("-") else (1.0, shape)
    own = _drawn(rng, name, (_SIMULATIONS, homes))
    common = np.repeat(_drawn(rng, name, (_SIMULATIONS, homes // group)), group, axis=1)
    units = truth + sign * (math.sqrt(1.0 - shared) * own + math.sqrt(shared) * common)
    weights = np.random.default_rng(1).multinomial(homes, [1.0 / homes] * homes, size=_RESAMPLES) / homes
    estimates = units.mean(axis=1)
    ends = np.quantile(units @ weights.T, [(1.0 - level) / 2.0, (1.0 + level) / 2.0], axis=1)
    low, high = estimates + stretch(homes, level) * (ends - estimates)
    if claimed.low < truth < claimed.high:
        wrong = (high <= claimed.low) | (claimed.high <= low)
    else:
        wrong = (claimed.low < low) & (high < claimed.high)
    return float(wrong.mean())


def _drawn(rng: np.random.Generator, shape: str, size: tuple[int, int]) -> NDArray[np.float64]:
    """Draw numbers with mean 0 and variance 1."""
    if shape == "normal":
        return rng.standard_normal(size)
    if shape == "exponential":
        return rng.standard_exponential(size) - 1.0
    if shape == "student":
        return rng.standard_t(3, size) / math.sqrt(3.0)
    raise ValueError(f"unknown shape {shape!r}: choose one of {', '.join(SHAPES)}")
