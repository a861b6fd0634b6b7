"""The information filter: views with little information do not decide (thesis 4.6)."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError


def threshold_of(share: float, information: NDArray[np.float32]) -> float:
    """The threshold that a share (between 0 and 1, rounded down to whole frames) of training frames is below.

    `information` is (frames,) measures, at least 1. The thesis gives its threshold in an undefined unit, and
    not the number of frames that it drops.
    """
    return float(np.sort(information)[int(share * len(information))])


def dropped(
    information: NDArray[np.float32], labels: NDArray[np.int16], threshold: float
) -> dict[str, float]:
    """Count frames: all, dropped, labelled, dropped_labelled; with the threshold."""
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
    """Let a frame with little information repeat the distribution of the last accepted one (thesis 4.6).

    A frame is accepted if its information reaches the threshold: 0.09766 in the thesis, and 0.13021 in a
    check; or from :func:`threshold_of`. Frames before the first accepted one of their sequence keep their own
    distribution, since there is none to repeat; the thesis does not say. Frame t uses frames up to t only.

    `proba` is (frames, classes) distributions, and the result its rows. `information` is the (frames,)
    measure of `placecat.vision.information.information`; another length raises PlacecatError. `sequences` are
    stretches of frames without a cut that cover all frames; the filter restarts at each.
    """
    if len(information) != len(proba):
        raise PlacecatError(f"{len(proba)} distributions have {len(information)} measures of information")
    said_by = np.arange(len(proba))
    for part in sequences:
        own = said_by[part]
        # The last accepted frame so far; -1 before the first one.
        last = np.maximum.accumulate(np.where(information[part] >= threshold, own, -1))
        said_by[part] = np.where(last >= 0, last, own)
    return proba[said_by]
