"""Compare the power and errors of the verdict rule with known exact values."""

import math
from pathlib import Path

import numpy as np
import pytest

from placecat.evaluation.bootstrap import paired_bootstrap, stretch
from placecat.evaluation.verdict import Range
from placecat.replication import options
from placecat.replication.simulation import power, spread

LEVEL = options.read(Path(__file__).resolve().parents[2] / options.SETTINGS).level
BETTER, LITTLE = Range(0.0, math.inf), Range(-2.0, 2.0)
SIMULATIONS, RESAMPLES = 2000, 1000
# Distributions of the difference in a home. Each has mean 0 and variance 1.
SHAPES = {
    "normal": lambda rng, size: rng.standard_normal(size),
    "exponential": lambda rng, size: rng.standard_exponential(size) - 1.0,
    "student": lambda rng, size: rng.standard_t(3, size) / math.sqrt(3.0),
}


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
    """Simulate how often the verdict rule decides wrongly.

    Each simulation draws homes, computes the interval over them
    (:func:`placecat.evaluation.bootstrap.paired_bootstrap`) and judges it. All simulations use the same
    resamples, since the ledger also uses a fixed seed for each comparison.

    Parameters
    ----------
    truth
        True mean difference; homes have a standard deviation of 1.
    claimed
        Range of the claim. `holds` is wrong if the truth is outside; `does not hold` is wrong if it is
        inside.
    homes
        Number of homes, a multiple of `group`.
    shape
        A key of `SHAPES`. A leading minus sign, such as in "-exponential", mirrors the distribution.
    group, shared
        Group size, and the share of variance that homes in a group have in common.
    level
        Level of the interval.

    Returns
    -------
    float
        Share of wrong verdicts in 2,000 simulations with 1,000 resamples each.
    """
    rng = np.random.default_rng(0)
    sign, name = (-1.0, shape[1:]) if shape.startswith("-") else (1.0, shape)
    own = SHAPES[name](rng, (SIMULATIONS, homes))
    common = np.repeat(SHAPES[name](rng, (SIMULATIONS, homes // group)), group, axis=1)
    units = truth + sign * (math.sqrt(1.0 - shared) * own + math.sqrt(shared) * common)
    weights = np.random.default_rng(1).multinomial(homes, [1.0 / homes] * homes, size=RESAMPLES) / homes
    estimates = units.mean(axis=1)
    ends = np.quantile(units @ weights.T, [(1.0 - level) / 2.0, (1.0 + level) / 2.0], axis=1)
    low, high = estimates + stretch(homes, level) * (ends - estimates)
    if claimed.low < truth < claimed.high:
        wrong = (high <= claimed.low) | (claimed.high <= low)
    else:
        wrong = (claimed.low < low) & (high < claimed.high)
    return float(wrong.mean())


def test_the_spread_is_between_homes():
    values = np.random.default_rng(1).normal(3.0, 5.0, 6)
    interval = paired_bootstrap(lambda weights: weights @ values, 6, 0, resamples=20000)
    assert spread(interval.low, interval.high, 6) == pytest.approx(values.std(ddof=1), rel=0.08)


def test_power_equals_the_t_test():
    """At a one-sided level of 2.5%, one standard deviation needs 10 units for 80% power (Cohen 1988)."""
    assert power(1.0, 1.0, 10, BETTER)[0] == pytest.approx(0.803, abs=0.02)
    assert power(0.0, 1.0, 10, BETTER)[0] == pytest.approx(0.025, abs=0.008)
    assert power(-1.0, 1.0, 10, BETTER)[1] == pytest.approx(0.803, abs=0.02)


def test_a_wider_interval_fails_less_often():
    assert power(-1.0, 1.0, 10, BETTER, wide=0.99)[1] < power(-1.0, 1.0, 10, BETTER)[1] - 0.1


def test_no_difference_counts_as_little_if_homes_differ_too_much():
    assert power(0.0, 10.0, 6, LITTLE)[0] < 0.01
    assert power(0.0, 1.0, 6, LITTLE)[0] > 0.8


@pytest.mark.parametrize("shape", ["normal", "student", "exponential", "-exponential"])
def test_the_rule_of_the_plan_decides_wrongly_at_most_5_percent_of_the_time(shape):
    """This is tested for both verdicts at the limits of a claim, where errors are most frequent."""
    inside = 1e-9
    for truth, claimed in ((0.0, BETTER), (inside, BETTER), (2.0, LITTLE), (2.0 - inside, LITTLE)):
        assert error_rate(truth, claimed, homes=24, shape=shape, level=LEVEL) <= 0.05, (truth, claimed)


def test_intervals_of_95_percent_would_err_too_often_if_homes_are_skewed():
    assert error_rate(0.0, BETTER, homes=24, shape="-exponential") > 0.05


def test_homes_of_a_group_may_share_a_tenth_of_their_variance():
    assert error_rate(0.0, BETTER, homes=24, shared=0.1, level=LEVEL) <= 0.05
    assert error_rate(0.0, BETTER, homes=24, shared=0.1) > 0.04


def test_identical_homes_decide_wrongly_too_often():
    """The simulation detects errors: if the homes in a group are identical, each counts six times."""
    assert error_rate(0.0, BETTER, homes=24, shared=1.0) > 0.15
