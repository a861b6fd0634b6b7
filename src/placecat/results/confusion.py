"""Counts of decisions as tables: of one home, of all homes, as shares."""

import itertools
from collections.abc import Sequence

import numpy as np
import pandas as pd

from placecat.results.measured import Measured

ALL_HOMES = "all"


def in_home(one: Measured, home: str) -> Measured:
    """The part of a result that one home is.

    Parameters
    ----------
    home
        One of ``one.homes``.
    """
    number = one.homes.index(home)
    return Measured((home,), one.seeds, one.classes, one.confusion[:, number : number + 1])


def confusion_rows(one: Measured) -> pd.DataFrame:
    """Counts as a table: home, seed, truth, then a column for each place that was decided."""
    labels = list(itertools.product(one.homes, one.seeds, one.classes))
    counts = one.confusion.swapaxes(0, 1).reshape(-1, len(one.classes))
    return _labelled(["home", "seed", "truth"], labels, counts, one.classes)


def pooled_rows(one: Measured) -> pd.DataFrame:
    """Counts over all homes and seeds: truth, then a column for each place that was decided."""
    return _labelled(["truth"], [(truth,) for truth in one.classes], pooled_counts(one), one.classes)


def pooled_counts(one: Measured) -> np.ndarray:
    """(classes, classes) counts over all homes and seeds; row a true place, column a decided one."""
    return one.confusion.sum(axis=(0, 1))


def shares(counts: np.ndarray) -> np.ndarray:
    """(classes, classes) percent of the frames of each true place; NaN where there is no frame of it."""
    frames = counts.sum(axis=1, keepdims=True)
    return np.divide(100.0 * counts, frames, out=np.full(counts.shape, np.nan), where=frames > 0)


def _labelled(
    names: Sequence[str], labels: Sequence[tuple[str, ...]], counts: np.ndarray, classes: Sequence[str]
) -> pd.DataFrame:
    columns = dict(zip(names, zip(*labels, strict=True), strict=True))
    return pd.DataFrame(columns | dict(zip(classes, counts.T, strict=True)))
