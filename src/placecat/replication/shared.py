"""The variance shared by the homes in a group, since each serves as training data for the others."""

import numpy as np
from numpy.typing import ArrayLike


def shared_variance(values: ArrayLike, groups: ArrayLike) -> float:
    """Estimate the share of variance that members of a group have in common.

    `values` and `groups` are (members,): the value of each member and the number of its group. The share is
    the intraclass correlation (B - W) / (B + (n - 1) W) of a one-way analysis of variance with random groups.
    B and W are the mean squares between and within groups, and n is the number of members per group (an
    effective number if group sizes differ). The share is at most 1. It is below 0 if groups differ less than
    expected by chance. It is NaN if there are fewer than two groups, if every group has only one member, or
    if all values are equal.

    References
    ----------
    P. E. Shrout and J. L. Fleiss, Intraclass Correlations, Psychological Bulletin 86, 1979: ICC(1, 1).

    Examples
    --------
    >>> shared_variance([1.0, 1.0, 5.0, 5.0], [0, 0, 1, 1])
    1.0
    >>> round(shared_variance([1.0, 3.0, 2.0, 4.0], [0, 0, 1, 1]), 2)
    -0.33
    """
    numbers = np.asarray(values, dtype=np.float64)
    _, index, sizes = np.unique(np.asarray(groups), return_inverse=True, return_counts=True)
    k, n = len(sizes), len(numbers)
    if k < 2 or n == k:
        return float("nan")
    means = np.bincount(index, numbers) / sizes
    between = float((sizes * (means - numbers.mean()) ** 2).sum()) / (k - 1)
    within = float(((numbers - means[index]) ** 2).sum()) / (n - k)
    effective = (n - float((sizes**2).sum()) / n) / (k - 1)
    total = between + (effective - 1.0) * within
    return (between - within) / total if total > 0.0 else float("nan")
