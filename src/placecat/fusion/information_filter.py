"""The information filter: views that show little do not decide (thesis 4.6)."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError


def check(threshold: float | None, share: float | None, where: str) -> None:
    """Refuse a filter that has not exactly one of `threshold` and `share`, or one out of its range.

    Parameters
    ----------
    threshold
        At least 0.
    share
        Between 0 and 1, without both ends.
    where
        What the message calls the filter.
    """
    if (threshold is None) == (share is None):
        raise PlacecatError(f"{where} needs either a threshold or a share; set the other one to null")
    for name, value in (("threshold", threshold), ("share", share)):
        if value is not None and (isinstance(value, bool) or not isinstance(value, int | float)):
            raise PlacecatError(f"{where}: {name} is {value!r}, but a number is needed")
    if threshold is not None and not threshold >= 0:
        raise PlacecatError(f"{where}: threshold is {threshold}, but must be 0 or more")
    if share is not None and not 0 < share < 1:
        raise PlacecatError(f"{where}: share is {share}, but must be between 0 and 1")


def threshold_of(share: float, information: NDArray[np.float32]) -> float:
    """The threshold below which a share of training frames lies.

    The thesis gives its threshold in a unit that it does not define, and not how many frames that drops.

    Parameters
    ----------
    share
        Between 0 and 1; rounded down to whole frames.
    information
        (frames,) measures of the training frames, at least 1.
    """
    return float(np.sort(information)[int(share * len(information))])


def dropped(
    information: NDArray[np.float32], labels: NDArray[np.int16], threshold: float
) -> dict[str, float]:
    """Count what a threshold drops: frames, dropped, labelled, dropped_labelled, and the threshold."""
    low = ~(information >= threshold)
    return {
        "threshold": threshold,
        "frames": len(low),
        "dropped": int(low.sum()),
        "labelled": int((labels >= 0).sum()),
        "dropped_labelled": int((low & (labels >= 0)).sum()),
    }


def hold(
    proba: NDArray[np.float64],
    information: NDArray[np.float32],
    *,
    threshold: float,
    sequences: Sequence[slice],
) -> NDArray[np.float64]:
    """Let a frame with little information repeat what was said of the last accepted one (thesis 4.6).

    A frame is accepted if its information reaches the threshold. Frames before the first accepted one of
    their sequence keep their own distribution: there is none to repeat, and the thesis does not say. Frame t
    uses frames up to t only.

    Parameters
    ----------
    proba
        (frames, classes) distributions.
    information
        (frames,) measure of each frame, see `placecat.vision.information.information`.
    threshold
        0.09766 in the thesis, and 0.13021 in a check; or from :func:`threshold_of`.
    sequences
        Stretches of frames without a cut that cover all frames; the filter starts anew at each.

    Returns
    -------
    (frames, classes), rows of `proba`.

    Raises
    ------
    PlacecatError
        Another number of measures than of distributions.
    """
    if len(information) != len(proba):
        raise PlacecatError(f"{len(proba)} distributions have {len(information)} measures of information")
    said_by = np.arange(len(proba))
    for part in sequences:
        own = said_by[part]
        # The last accepted frame so far; before the first one the running maximum is still -1.
        last = np.maximum.accumulate(np.where(information[part] >= threshold, own, -1))
        said_by[part] = np.where(last >= 0, last, own)
    return proba[said_by]
