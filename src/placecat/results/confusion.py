"""Tables of decisions: counts in one home, counts in all homes, and shares."""

import itertools

import numpy as np
import pandas as pd

from placecat.results.measured import Measured

ALL_HOMES = "all"


def in_home(one: Measured, home: str) -> Measured:
    """The part of a result for one of its homes."""
    number = one.homes.index(home)
    return Measured((home,), one.seeds, one.classes, one.confusion[:, number : number + 1])


def confusion_rows(one: Measured) -> pd.DataFrame:
    """Counts as a table: home, seed, truth, then one column per decided place."""
    counts = one.confusion.swapaxes(0, 1).reshape(-1, len(one.classes))
    rows = pd.DataFrame(counts, columns=list(one.classes))
    # Faster than an index of all combinations that becomes columns.
    labels = list(itertools.product(one.homes, one.seeds, one.classes))
    for number, name in enumerate(("home", "seed", "truth")):
        rows.insert(number, name, [label[number] for label in labels])
    return rows


def pooled_rows(one: Measured) -> pd.DataFrame:
    """Counts over all homes and seeds: truth, then one column per decided place."""
    labels = pd.Index(one.classes, name="truth")
    return pd.DataFrame(pooled_counts(one), labels, list(one.classes)).reset_index()


def pooled_counts(one: Measured) -> np.ndarray:
    """(classes, classes) counts over all homes and seeds; rows are true places, columns decided ones."""
    return one.confusion.sum(axis=(0, 1))


def shares(counts: np.ndarray) -> np.ndarray:
    """(classes, classes) percentages of each true place's frames; NaN for a place without frames."""
    frames = counts.sum(axis=1, keepdims=True)
    return np.divide(100.0 * counts, frames, out=np.full(counts.shape, np.nan), where=frames > 0)
