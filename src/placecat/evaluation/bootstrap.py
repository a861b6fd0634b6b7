"""Bootstrap intervals for a small number of units."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

# Quantiles of the normal and Student's t distributions. Importing scipy.stats instead would take half a
# second.
from scipy.special import ndtri, stdtrit


@dataclass(frozen=True)
class Interval:
    """An estimate and the ends of its interval, all in the same unit."""

    estimate: float
    low: float
    high: float

    def rounded(self, decimals: int = 2) -> "Interval":
        """Return the interval with rounded numbers, and with 0 instead of -0."""
        # Round twice, so that differences in the last few bits cannot turn rounding up into rounding down.
        return Interval(
            *(round(round(x, decimals + 6), decimals) + 0.0 for x in (self.estimate, self.low, self.high))
        )


def paired_bootstrap(
    statistic: Callable[[NDArray[np.float64]], NDArray[np.float64]],
    n_units: int,
    seed: int,
    *,
    level: float = 0.95,
    resamples: int = 10000,
) -> Interval:
    """Compute an interval for a statistic over units, such as the mean difference over homes.

    Units are drawn with replacement. All measurements of a unit are drawn together, so effects common to both
    sides of a difference cancel out.

    With six units, the plain percentile interval is far too narrow for two reasons. The bootstrap variance
    divides by n instead of n - 1, and the interval uses a normal quantile instead of Student's t quantile
    with n - 1 degrees of freedom. For a mean, both effects are known exactly. So this function stretches both
    arms of the percentile interval about the estimate by sqrt(n / (n - 1)) t / z. Hesterberg corrects for
    both effects with more extreme quantiles (the expanded percentile interval). With four or six units, such
    quantiles are out of reach, because the resampled means always lie between the smallest and largest unit.
    BCa corrects for skewness, but not for small n. The bootstrap-t interval divides by standard errors. If
    these are 0, which happens when units are identical (such as two seeds for one home), the interval is
    infinite.

    This table shows the coverage of intervals for the mean of 4 and 6 units, from 4000 simulations with a
    `level` of 0.95:

    ============= ============= ============= =================
    method        normal units  exponential   Student, 3 df
    ============= ============= ============= =================
    stretched     0.95, 0.95    0.88, 0.90    0.95, 0.95
    percentile    0.81, 0.85    0.75, 0.81    0.79, 0.84
    expanded      0.88, 0.93    0.83, 0.89    0.87, 0.93
    BCa           0.81, 0.86    0.76, 0.83    0.78, 0.83
    bootstrap-t   0.95, 0.95    0.93, 0.93    0.95, 0.93
    ============= ============= ============= =================

    The median length of the stretched interval is 0.54 times that of the bootstrap-t interval for n = 4, and
    0.85 times for n = 6.

    Two homes with two seeds each are four dependent units. In simulations where homes and seeds vary equally,
    the interval covers the mean over these two homes with probability 0.96, and more often if seeds matter
    less. It covers the mean over all possible homes with a probability of only 0.89, or 0.70 if seeds do not
    matter. So the interval is valid only for these homes.

    Parameters
    ----------
    statistic
        Function that takes (resamples, n) unit weights, whose rows sum to 1, and returns (resamples,) values.
    n_units
        n, at least 2.
    seed, level, resamples
        Seed in [0, 2**32), interval level between 0 and 1, and number of resamples.

    Returns
    -------
    The interval. Its `estimate` weights all units equally, and lies within the interval unless the statistic
    is heavily biased. If all units are identical, the interval is a single point.

    References
    ----------
    T. Hesterberg, What Teachers Should Know About the Bootstrap, The American Statistician 69, 2015.
    """
    if n_units < 2:
        raise ValueError(f"an interval needs at least 2 units, not {n_units}")
    drawn = np.random.default_rng(seed).multinomial(n_units, [1.0 / n_units] * n_units, size=resamples)
    estimate = float(statistic(np.full((1, n_units), 1.0 / n_units))[0])
    return _stretched(estimate, statistic(drawn / n_units), level, stretch(n_units, level))


def stratified_bootstrap(
    statistic: Callable[[NDArray[np.float64]], NDArray[np.float64]],
    strata: NDArray[np.int64],
    seed: int,
    *,
    level: float = 0.95,
    resamples: int = 10000,
) -> Interval:
    """Compute an interval for a statistic over blocks, such as stays, that are grouped into strata.

    For a mean over places, each place is a stratum. From the n blocks of a stratum, n - 1 are drawn with
    replacement (Rao and Wu). The variance of the stratum mean then divides by n - 1. This matters most for
    strata with only two blocks. A stratum with one block contributes no variance. Both arms of the interval
    are stretched by t / z. The degrees of freedom of t are the number of blocks minus the number of strata.

    This table shows the coverage of intervals for the mean of five stratum means, from 2000 simulations with
    a `level` of 0.95:

    ================================ ====== ===========
    blocks per stratum               normal exponential
    ================================ ====== ===========
    2, 2, 2, 2, 2                    0.94   0.89
    8, 5, 3, 2, 2                    0.92   0.86
    8, 8, 8, 8, 8                    0.95   0.93
    ================================ ====== ===========

    Parameters
    ----------
    statistic
        Function that takes (resamples, n) block weights, which sum to 1 in each stratum, and returns
        (resamples,) values.
    strata
        (n,) stratum number of each block, counted from 0.
    seed, level, resamples
        As in :func:`paired_bootstrap`.

    References
    ----------
    J. N. K. Rao and C. F. J. Wu, Resampling Inference With Complex Survey Data, JASA 83, 1988.
    """
    sizes = np.bincount(strata)
    free = int((sizes - 1).sum())
    if free < 1:
        raise ValueError("at least one stratum needs two or more blocks")
    rng = np.random.default_rng(seed)
    weights = np.empty((resamples, len(strata)))
    for stratum, size in enumerate(sizes):
        drawn = rng.multinomial(max(size - 1, 1), [1.0 / size] * size, size=resamples)
        weights[:, strata == stratum] = drawn / max(size - 1, 1)
    estimate = float(statistic((1.0 / sizes)[strata][None])[0])
    upper = (1.0 + level) / 2.0
    return _stretched(estimate, statistic(weights), level, float(stdtrit(free, upper) / ndtri(upper)))


def _stretched(estimate: float, values: NDArray[np.float64], level: float, factor: float) -> Interval:
    """Compute the percentile interval of resampled values, with both arms multiplied by a factor."""
    arms = np.quantile(values, [(1.0 - level) / 2.0, (1.0 + level) / 2.0]) - estimate
    low, high = estimate + factor * arms
    return Interval(estimate, float(low), float(high))


def stretch(n_units: int, level: float) -> float:
    """Return the factor that stretches a percentile interval, sqrt(n / (n - 1)) t / z. It is at least 1."""
    upper = (1.0 + level) / 2.0
    return float(np.sqrt(n_units / (n_units - 1.0)) * stdtrit(n_units - 1, upper) / ndtri(upper))
