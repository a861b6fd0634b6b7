"""Find the stretch of a film that best shows the effect of smoothing (Figure 11)."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray


def most_smoothed(
    before: NDArray[np.float64],
    after: NDArray[np.float64],
    truth: NDArray[np.int16],
    sequences: Sequence[slice],
    *,
    frames: int,
) -> tuple[int, slice]:
    """Find the window in which smoothing removes the most changes of the decision; the first one in a tie.

    Returns the number of changes before minus the number after, and the window. A change counts only between
    two labelled frames without a cut between them.

    Parameters
    ----------
    before, after
        (n, classes) distributions of the same frames; a decision is the most probable place.
    truth
        (n,) class indices, -1 for unlabelled.
    sequences, frames
        Stretches without a cut, and the length of a window within them; a shorter stretch is one window.
    """
    removed = changes(before, truth) - changes(after, truth)
    best: tuple[int, slice] | None = None
    for part in sequences:
        # `removed[i]` belongs to the step from frame i to frame i + 1.
        total = np.r_[0, np.cumsum(removed[part.start : part.stop - 1])]
        length = min(frames, part.stop - part.start)
        sums = total[length - 1 :] - total[: len(total) - length + 1]
        start = int(np.argmax(sums))
        if best is None or sums[start] > best[0]:
            best = int(sums[start]), slice(part.start + start, part.start + start + length)
    return best or (0, slice(0, 0))


def changes(proba: NDArray[np.float64], truth: NDArray[np.int16]) -> NDArray[np.int64]:
    """Return (n - 1,) numbers: 1 where the decision changes between successive labelled frames, else 0."""
    decision = proba.argmax(axis=1)
    labelled = truth >= 0
    return ((decision[1:] != decision[:-1]) & labelled[1:] & labelled[:-1]).astype(np.int64)


def stretches(places: NDArray[np.integer]) -> list[slice]:
    """Return the stretches of equal values in (n,) places, in order."""
    if not len(places):
        return []
    starts = np.flatnonzero(np.r_[True, places[1:] != places[:-1]]).tolist()
    return [slice(start, stop) for start, stop in zip(starts, [*starts[1:], len(places)], strict=True)]
