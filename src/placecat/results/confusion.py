"""Confusion matrices: counts for each home, counts over all homes, and percentages."""

import itertools

import numpy as np
import pandas as pd

from placecat.results.measured import Measured

ALL_HOMES = "all"


def in_home(one: Measured, home: str) -> Measured:
    """Return the part of a result that covers one of its homes."""
    number = one.homes.index(home)
    return Measured((home,), one.seeds, one.classes, one.confusion[:, number : number + 1])


def confusion_rows(one: Measured) -> pd.DataFrame:
    """Return the counts as a table: home, seed, truth, and one column per predicted place."""
    counts = one.confusion.swapaxes(0, 1).reshape(-1, len(one.classes))
    rows = pd.DataFrame(counts, columns=list(one.classes))
    # This is faster than building a MultiIndex of all combinations and resetting it.
    labels = list(itertools.product(one.homes, one.seeds, one.classes))
    for number, name in enumerate(("home", "seed", "truth")):
        rows.insert(number, name, [label[number] for label in labels])
    return rows


def pooled_rows(one: Measured) -> pd.DataFrame:
    """Return the counts over all homes and seeds: the column truth, and one column per predicted place."""
    labels = pd.Index(one.classes, name="truth")
    return pd.DataFrame(pooled_counts(one), labels, list(one.classes)).reset_index()


def pooled_counts(one: Measured) -> np.ndarray:
    """Return (classes, classes) counts over all homes and seeds.

    Rows are true places, and columns are predicted places.
    """
    return one.confusion.sum(axis=(0, 1))


def shares(counts: np.ndarray) -> np.ndarray:
    """Convert (classes, classes) counts to percentages of the row totals; NaN for a place without frames."""
    frames = counts.sum(axis=1, keepdims=True)
    return np.divide(100.0 * counts, frames, out=np.full(counts.shape, np.nan), where=frames > 0)
