"""Bin features, and find the regression stumps that best fit weighted samples."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

# Number of features per block. The histograms of a few machines then fit in the level-2 cache.
BLOCK_FEATURES = 32
# Histograms with more columns than this are accumulated row by row.
_NARROW = 192


@dataclass(frozen=True)
class BinnedFeatures:
    """Binned features, with sparse matrices that sum samples by bin."""

    #: (D, n) uint8 or uint16, the bin of each sample in each feature. The bin is the number of thresholds
    #: below the sample's value.
    bins: NDArray[Any]
    #: D ascending arrays of at most max_bins - 1 values, where x > thresholds[d][b] means that the bin is
    #: above b.
    thresholds: list[NDArray[np.float32]]
    #: scipy CSR matrices of ones, one for every `BLOCK_FEATURES` features. A matrix for B features has the
    #: shape (width * B, n), and its first B rows are the first bins of the features. Multiplying it by (n, m)
    #: weights yields all weighted histograms of these features.
    blocks: list[Any]
    #: Number of bins per feature in `blocks`.
    width: int


class Stump(NamedTuple):
    """A function of one feature, whose value is `low` up to bin `cut` and `high` above it."""

    feature: int
    cut: int
    low: float
    high: float


def bin_features(X: NDArray[np.float32], max_bins: int) -> BinnedFeatures:
    """Bin each feature at the midpoints between its distinct values, or at quantiles if there are too many.

    `X` is (n, D), and `max_bins` is the maximum number of bins per feature, from 2 to 65536.
    """
    n, n_features = X.shape
    bins = np.empty((n_features, n), dtype=np.uint8 if max_bins <= 256 else np.uint16)
    thresholds = []
    for feature, column in enumerate(np.ascontiguousarray(X.T)):
        order = np.argsort(column)
        values = column[order]
        distinct = values[np.concatenate([[True], values[1:] != values[:-1]])]
        if len(distinct) <= max_bins:
            cuts = _midpoints(distinct[:-1], distinct[1:])
        else:
            # Use the midpoint next to each quantile, so that thresholds lie between training values.
            first = (np.arange(1, max_bins) * n) // max_bins
            place = np.unique(np.searchsorted(distinct, values[first]))
            place = place[place > 0]
            cuts = _midpoints(distinct[place - 1], distinct[place])
        thresholds.append(cuts)
        # Searching the values for the few thresholds is faster than searching the thresholds for each value.
        ends = np.searchsorted(values, cuts, side="right")
        sizes = np.diff(ends, prepend=0, append=n)
        bins[feature, order] = np.repeat(np.arange(len(sizes), dtype=bins.dtype), sizes)
    blocks = [
        _sums(bins[first : first + BLOCK_FEATURES], max_bins)
        for first in range(0, n_features, BLOCK_FEATURES)
    ]
    return BinnedFeatures(bins, thresholds, blocks, max_bins)


def _midpoints(below: NDArray[np.float32], above: NDArray[np.float32]) -> NDArray[np.float32]:
    middle = (below.astype(np.float64) + above) / 2.0
    # Rounding must not move a threshold onto the upper value.
    return np.where(middle.astype(np.float32) < above, middle.astype(np.float32), below)


def _sums(bins: NDArray[Any], width: int) -> Any:
    """Build the (width * B, n) matrix that sums n samples by the (B, n) bins of B features."""
    from scipy.sparse import csr_matrix

    n_features, n = bins.shape
    order = np.argsort(bins, axis=1, kind="stable").astype(np.int32)
    counts = np.stack([np.bincount(row, minlength=width) for row in bins], axis=1)
    pointers = np.concatenate([[0], np.cumsum(counts.ravel())])
    # The samples of row (bin, feature) are consecutive in `order`.
    starts = (np.cumsum(counts, axis=0) - counts) + n * np.arange(n_features)
    sizes = counts.ravel()
    places = np.repeat(starts.ravel() - pointers[:-1], sizes) + np.arange(order.size)
    return csr_matrix((np.ones(order.size), order.ravel()[places], pointers), shape=(width * n_features, n))


def best_stumps(
    binned: BinnedFeatures, weight: NDArray[np.float64], signed: NDArray[np.float64]
) -> list[Stump | None]:
    """Find the stump with the smallest weighted squared error for each of G weightings of the samples.

    `weight` and `signed` are C-contiguous (n, G) arrays. `weight` is non-negative, and `signed` is `weight`
    times the labels, which are -1 or 1. Returns the best stump for each weighting (the first in a tie), or
    None if no feature can be split.
    """
    machines = range(weight.shape[1])
    highest = np.full(len(machines), -np.inf)
    stumps: list[Stump | None] = [None for _ in machines]
    dust = None
    for number, sums in enumerate(binned.blocks):
        below, below_signed = (
            _cumulated(histogram, binned.width) for histogram in _histograms(sums, weight, signed)
        )
        total, total_signed = below[-1], below_signed[-1]
        if dust is None:
            # Differences between sums leave rounding errors in empty bins.
            dust = np.tile(1e-12 * total[: len(machines)], len(total) // len(machines))
        dust = dust[: len(total)]
        gain = _gain(below[:-1], below_signed[:-1], total, total_signed, dust)
        per_feature = gain.max(axis=0).reshape(-1, len(machines))
        for machine, feature in enumerate(per_feature.argmax(axis=0)):
            if not per_feature[feature, machine] > highest[machine]:
                continue
            highest[machine] = per_feature[feature, machine]
            column = feature * len(machines) + machine
            cut = int(gain[:, column].argmax())
            part, part_signed = below[cut, column], below_signed[cut, column]
            stumps[machine] = Stump(
                number * BLOCK_FEATURES + int(feature),
                cut,
                float(part_signed / part),
                float((total_signed[column] - part_signed) / (total[column] - part)),
            )
    return stumps


def _histograms(
    sums: Any, weight: NDArray[np.float64], signed: NDArray[np.float64]
) -> Iterable[NDArray[np.float64]]:
    """Multiply one of the `blocks` of `BinnedFeatures` by two (n, G) arrays, and return both products."""
    if weight.shape[1] == 1:
        # In SciPy, multiplying by a single column is more than twice as fast as multiplying by two.
        return sums @ weight, sums @ signed
    # A single product reads the matrix only once.
    return np.hsplit(sums @ np.hstack([weight, signed]), 2)


def _cumulated(histogram: NDArray[np.float64], width: int) -> NDArray[np.float64]:
    """Accumulate the bins of (width * B, G) histograms, and return the sums as (width, B * G)."""
    bins = histogram.reshape(width, -1)
    if bins.shape[1] <= _NARROW:
        return np.add.accumulate(bins, axis=0)
    # Adding row by row is several times faster than a cumulative sum along the first axis.
    for number in range(1, width):
        np.add(bins[number - 1], bins[number], out=bins[number])
    return bins


def _gain(
    below: NDArray[np.float64],
    below_signed: NDArray[np.float64],
    total: NDArray[np.float64],
    total_signed: NDArray[np.float64],
    dust: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Return how much each cut reduces the squared error, plus a constant, or -inf if one side is empty."""
    above = total - below
    impossible = np.minimum(below, above) <= dust
    above_signed = total_signed - below_signed
    with np.errstate(divide="ignore", invalid="ignore"):
        gain = np.square(below_signed)
        gain /= below
        np.square(above_signed, out=above_signed)
        above_signed /= above
        gain += above_signed
    gain[impossible] = -np.inf
    return gain
