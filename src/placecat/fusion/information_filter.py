"""The information filter: views that show little do not decide (thesis 4.6)."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError


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
        0.09766 in the thesis, and 0.13021 in a check.
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
