"""From a few units, estimate the share of all cases at or below a threshold."""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy import optimize, special

from placecat.evaluation.bootstrap import Interval

# Number of quadrature nodes over the scale of a t distribution.
_NODES = 200


def share_below(units: Sequence[NDArray[np.float64]], threshold: float, *, level: float = 0.95) -> Interval:
    """Estimate the share of cases at or below a threshold, over all units, including unseen ones.

    A unit, such as a home, has several cases, such as the gains from several methods. The estimate is in [0,
    1]. Cases are modelled as normally distributed. Their mean is the mean of the unit means, and their
    variance is the variance of the unit means plus the mean variance within units. Counting cases alone could
    never show that a share is small. Even if none of six homes had such a case, the upper limit would be 46%
    (Clopper and Pearson). The interval's limits come from the noncentral t distribution. They are exact if
    the cases within each unit are identical. Otherwise the interval is wide, because each unit still counts
    as only one case.

    `units` contains at least 2 arrays of (cases,) values. If all values are identical, the interval is a
    single point, 0 or 1. `level` is the interval level, between 0 and 1.

    References
    ----------
    D. B. Owen, A Survey of Properties and Applications of the Noncentral t-Distribution, Technometrics 10,
    1968.
    """
    n = len(units)
    if n < 2:
        raise ValueError(f"an interval needs at least 2 units, not {n}")
    means = np.array([unit.mean() for unit in units])
    variance = means.var(ddof=1) + np.mean([unit.var() for unit in units])
    distance = float(threshold - means.mean())
    if variance < 1e-12:
        share = float(distance >= 0.0)
        return Interval(share, share, share)
    scaled = distance / np.sqrt(variance)
    tail = (1.0 - level) / 2.0
    low, high = (_noncentrality(scaled * np.sqrt(n), n - 1, below) for below in (1.0 - tail, tail))
    return Interval(*(float(special.ndtr(one)) for one in (scaled, low / np.sqrt(n), high / np.sqrt(n))))


def _noncentrality(t: float, freedom: int, below: float) -> float:
    """Find the noncentrality for which a t variable is at most `t` with probability `below`."""
    # SciPy's distribution function breaks down far from 0, so average over the scale instead.
    scale, weights = _scales(freedom)
    reach = 10.0 + 5.0 * abs(t)
    return float(
        optimize.brentq(
            lambda center: float(weights @ special.ndtr(t * scale - center)) / 2.0 - below,
            t - reach,
            t + reach,
        )
    )


@lru_cache
def _scales(freedom: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return scales of a t distribution, whose root mean square is 1, and their weights, which sum to 2."""
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    return np.sqrt(2.0 * special.gammaincinv(freedom / 2.0, (nodes + 1.0) / 2.0) / freedom), weights
