"""SVM-DAS, the discriminative accumulation scheme (thesis 3.3.3; Nilsback and Caputo, Pronobis et al.)."""

import numpy as np
from numpy.typing import NDArray

from placecat.cues import Descriptors


def frames_of(proba: NDArray[np.float64]) -> Descriptors:
    """Join the cues' distributions into the descriptors of the integrating classifier.

    From (frames, cues, n_classes) to (frames, cues * n_classes) float32.
    """
    return Descriptors(np.ascontiguousarray(proba.reshape(len(proba), -1), dtype=np.float32))
