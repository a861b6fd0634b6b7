"""Value counts, pairwise mutual information and maximum spanning trees of discrete variables."""

import numpy as np
from numpy.typing import NDArray

# A pair's table is stored in full if it has at most this many cells per sample. Otherwise, its cells are
# counted by sorting the samples.
_CELLS_PER_SAMPLE = 16
# float32 represents every integer up to this value exactly.
_EXACT_FLOAT32 = 1 << 24


def value_counts(
    codes: NDArray[np.integer], labels: NDArray[np.integer], n_classes: int, n_values: int
) -> NDArray[np.int64]:
    """Return (n_classes, V, n_values) counts of how often each variable takes each value in each class.

    `codes` is an (n, V) array of integers in [0, n_values), and `labels` is an (n,) array of integers in
    [0, n_classes).

    Examples
    --------
    >>> value_counts(np.array([[0, 1], [1, 1]]), np.array([0, 0]), 1, 2).tolist()
    [[[1, 1], [0, 2]]]
    """
    n_variables = codes.shape[1]
    if n_values == 2:
        sizes = np.bincount(labels, minlength=n_classes)
        dtype = _exact_dtype(len(codes))
        members = (labels == np.arange(n_classes)[:, None]).astype(dtype)
        ones = (members @ codes.astype(dtype)).astype(np.int64)
        return np.stack([sizes[:, None] - ones, ones], axis=2)
    counts = np.empty((n_classes, n_variables, n_values), np.int64)
    for variable in range(n_variables):
        cells = labels.astype(np.int64) * n_values + codes[:, variable]
        counts[:, variable] = np.bincount(cells, minlength=n_classes * n_values).reshape(n_classes, n_values)
    return counts


def mutual_information(codes: NDArray[np.integer], n_values: int) -> NDArray[np.float64]:
    """Compute the mutual information of every pair of variables from relative frequencies.

    With n_ab denoting the counts of a pair, its mutual information I is given by
    n I = n log n + sum n_ab log n_ab - sum n_a log n_a - sum n_b log n_b. For binary variables, one matrix
    product counts all pairs. Larger tables are filled cell by cell. If a table would have far more cells than
    samples, the samples are sorted instead, so memory does not grow with the square of `n_values`.

    `codes` is an (n, V) array of integers in [0, n_values), with n >= 1. Returns a (V, V) float64 matrix in
    nats. It is symmetric and non-negative, with 0 on the diagonal.

    Examples
    --------
    >>> print(mutual_information(np.array([[0, 0, 0], [1, 1, 0]]), 2).round(3)[0])
    [0.    0.693 0.   ]
    """
    if n_values == 2:
        return binary_information(both_ones(codes), len(codes))
    weighted_log = _weighted_logs(len(codes))
    columns = np.ascontiguousarray(codes.T, dtype=np.int64)
    sum_joint = _joint_by_tables if n_values**2 <= _CELLS_PER_SAMPLE * len(codes) else _joint_by_sorting
    joint = sum_joint(columns, n_values, weighted_log)
    marginal = np.array([weighted_log[np.bincount(column)].sum() for column in columns])
    return _information(joint + joint.T, marginal, weighted_log)


def both_ones(codes: NDArray[np.integer]) -> NDArray[np.int64]:
    """Return (V, V) counts of the samples in which both variables of a pair are 1.

    `codes` is an (n, V) array of zeros and ones. The diagonal of the result is the number of ones in each
    variable.

    Examples
    --------
    >>> both_ones(np.array([[1, 0], [1, 1]])).tolist()
    [[2, 1], [1, 1]]
    """
    ones = codes.astype(_exact_dtype(len(codes)))
    # If a matrix is multiplied by its own transpose, NumPy computes only half of the product.
    return (ones.T @ ones).astype(np.int64)


def binary_information(both: NDArray[np.int64], n: int) -> NDArray[np.float64]:
    """Compute the `mutual_information` of binary variables from the `both_ones` counts of `n` samples."""
    weighted_log = _weighted_logs(n)
    ones = np.diagonal(both)
    first_only = ones[:, None] - both
    only_logs = weighted_log[first_only]
    # With this grouping, the sum does not depend on the order of the two variables.
    joint = (weighted_log[both] + weighted_log[n - ones - first_only]) + (only_logs + only_logs.T)
    return _information(joint, weighted_log[ones] + weighted_log[n - ones], weighted_log)


def _weighted_logs(n: int) -> NDArray[np.float64]:
    """Return m log m for each m from 0 to `n`."""
    number = np.arange(n + 1, dtype=np.float64)
    return number * np.log(np.maximum(number, 1))


def _information(
    joint: NDArray[np.float64], marginal: NDArray[np.float64], weighted_log: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Compute mutual information from the sums of m log m over the cells of each pair and each variable."""
    information = weighted_log[-1] + joint
    information -= marginal[:, None] + marginal
    information /= len(weighted_log) - 1
    np.maximum(information, 0, out=information)
    np.fill_diagonal(information, 0)
    return information


def maximum_spanning_tree(weights: NDArray[np.float64], root: int) -> NDArray[np.int32]:
    """Find the spanning tree with the greatest total weight, using Prim's algorithm.

    `weights` is a symmetric (V, V) matrix, and `root` is in [0, V). The tree is directed away from the root.
    If weights are equal, the variable with the lowest index joins first, and its parent is the one that
    joined earliest. Returns the parent of each variable, (V,) int32, with -1 for the root.

    Examples
    --------
    >>> maximum_spanning_tree(np.array([[0, 3.0, 1], [3, 0, 2], [1, 2, 0]]), 0).tolist()
    [-1, 0, 1]
    """
    n_variables = len(weights)
    parents = np.full(n_variables, root, np.int32)
    outside = np.ones(n_variables, bool)
    best = np.full(n_variables, -np.inf)
    joining = root
    for _ in range(n_variables - 1):
        outside[joining] = False
        best[joining] = -np.inf
        better = outside & (weights[joining] > best)
        best[better] = weights[joining, better]
        parents[better] = joining
        joining = int(best.argmax())
    parents[root] = -1
    return parents


def _joint_by_tables(
    columns: NDArray[np.int64], n_values: int, weighted_log: NDArray[np.float64]
) -> NDArray[np.float64]:
    n_variables, n = columns.shape
    joint = np.zeros((n_variables, n_variables))
    counts = np.empty(n_values * n_values, np.int32)
    cells = np.empty(n, np.int64)
    for first, rows in enumerate(columns * n_values):
        for second in range(first + 1, n_variables):
            # bincount would allocate a new table each time, which takes several times longer than counting.
            counts.fill(0)
            np.add.at(counts, np.add(rows, columns[second], out=cells), np.int32(1))
            # Counts of 0 and 1 can be left out, because m log m is 0 for them.
            joint[first, second] = weighted_log[counts[counts > 1]].sum()
    return joint


def _joint_by_sorting(
    columns: NDArray[np.int64], n_values: int, weighted_log: NDArray[np.float64]
) -> NDArray[np.float64]:
    n_variables, n = columns.shape
    joint = np.zeros((n_variables, n_variables))
    columns = columns.astype(np.int32 if n_values * n_values < 2**31 else np.int64, copy=False)
    for first in range(n_variables - 1):
        pairs = columns[first] * n_values + columns[first + 1 :]
        pairs.sort(axis=1)
        new = np.ones(pairs.shape, bool)
        np.not_equal(pairs[:, 1:], pairs[:, :-1], out=new[:, 1:])
        starts = np.flatnonzero(new)
        terms = weighted_log[np.diff(starts, append=new.size)]
        joint[first, first + 1 :] = np.add.reduceat(terms, np.searchsorted(starts, n * np.arange(len(pairs))))
    return joint


def _exact_dtype(n: int) -> type[np.floating]:
    """Return a dtype in which dot products of n zeros and ones are exact whatever the order of summation."""
    return np.float32 if n < _EXACT_FLOAT32 else np.float64
