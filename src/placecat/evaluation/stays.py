"""Find stays, which are visits to a place, and count those named correctly (not in the thesis)."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray


class Stay(NamedTuple):
    """A visit to a place: its class index, its first frame, and the frame after its last."""

    place: int
    start: int
    stop: int


def find_stays(truth: ArrayLike, sequences: Sequence[slice]) -> list[Stay]:
    """Find the maximal runs of frames with the same label, in temporal order.

    `truth` contains (frames,) class indices in temporal order, with -1 for unlabelled frames and transitions,
    which end a stay. `sequences` contains one slice of frames per sequence, and the slices together cover all
    frames. The end of a sequence also ends a stay.
    """
    truth = np.asarray(truth, dtype=np.int64)
    if not len(truth):
        return []
    begins = np.r_[True, truth[1:] != truth[:-1]]
    begins[[part.start for part in sequences if part.start < len(truth)]] = True
    starts = np.flatnonzero(begins)
    stops = np.r_[starts[1:], len(truth)]
    return [
        Stay(int(truth[start]), int(start), int(stop))
        for start, stop in zip(starts, stops, strict=True)
        if truth[start] >= 0
    ]


def stays_by_class(
    truth: ArrayLike, decision: ArrayLike, sequences: Sequence[slice], n_classes: int
) -> NDArray[np.int64]:
    """Count the stays of each class and how many are named correctly, as an (n_classes, 2) array.

    A stay is named correctly if more of its frames are assigned to the correct place than to any other place.
    A tie counts as wrong, so the order of the classes does not matter. `truth` and `sequences` are as in
    :func:`find_stays`. `decision` contains (frames,) integers in [0, n_classes).
    """
    decision = np.asarray(decision, dtype=np.int64)
    counts = np.zeros((n_classes, 2), np.int64)
    for stay in find_stays(truth, sequences):
        votes = np.bincount(decision[stay.start : stay.stop], minlength=n_classes)
        others = np.delete(votes, stay.place)
        counts[stay.place] += 1, int(votes[stay.place] > others.max(initial=0))
    return counts


def stay_accuracy(counts: NDArray[np.int64]) -> float:
    """Average the percentage of stays named correctly over the classes present; NaN if there are no stays.

    As with frame accuracy (thesis 4.2), a frequently visited place does not outweigh the others. `counts`
    comes from :func:`stays_by_class`.
    """
    there = counts[counts[:, 0] > 0]
    return float((100.0 * there[:, 1] / there[:, 0]).mean()) if len(there) else float("nan")
