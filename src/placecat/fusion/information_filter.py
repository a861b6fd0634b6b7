"""The information filter, which ignores views with little information (thesis 4.6)."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray


def threshold_of(share: float, information: NDArray[np.float32]) -> float:
    """Return the threshold below which a given share of the training frames lies.

    `share` is between 0 and 1. The number of frames below the threshold is rounded down. `information`
    contains one value per frame, and must not be empty. The thesis does not define the unit of its threshold,
    or say how many frames are dropped.
    """
    return float(np.sort(information)[int(share * len(information))])


def dropped(
    information: NDArray[np.float32], labels: NDArray[np.int16], threshold: float
) -> dict[str, float]:
    """Return the threshold, and count the frames: all, dropped, labelled, and both dropped and labelled."""
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
    """Give each frame with too little information the distribution of the last accepted frame.

    This follows thesis 4.6. A frame is accepted if its information reaches the threshold. The thesis uses a
    threshold of 0.09766, and tries 0.13021 for comparison. :func:`threshold_of` computes a threshold from the
    share of frames to drop. Frames before the first accepted frame of a sequence keep their distributions.
    The thesis does not mention this case. The result for frame t uses only frames up to t.

    `proba` contains (frames, classes) distributions, and the result has the same shape. `information`
    contains the (frames,) measures from `placecat.vision.information.information`. `sequences` contains one
    slice of frames per sequence, and the slices together cover all frames. The filter restarts with each
    slice.
    """
    said_by = np.arange(len(proba))
    for part in sequences:
        own = said_by[part]
        # The last accepted frame so far, or -1 before the first.
        last = np.maximum.accumulate(np.where(information[part] >= threshold, own, -1))
        said_by[part] = np.where(last >= 0, last, own)
    return proba[said_by]
