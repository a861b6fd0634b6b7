"""SVM-DAS, the discriminative accumulation scheme (thesis 3.3.3; Nilsback and Caputo, Pronobis et al.)."""

import numpy as np
from numpy.typing import NDArray

from placecat.cues import Descriptors


def frames_of(proba: NDArray[np.float64]) -> Descriptors:
    """Lay the cues' distributions side by side, as the descriptors that the integrating classifier sees.

    Parameters
    ----------
    proba
        (frames, cues, n_classes).

    Returns
    -------
    (frames, cues * n_classes) float32.
    """
    return Descriptors(np.ascontiguousarray(proba.reshape(len(proba), -1), dtype=np.float32))
