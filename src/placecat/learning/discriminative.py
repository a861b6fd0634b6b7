"""The choice of codewords that tell classes apart."""

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.feature_selection import mutual_info_classif

from placecat.errors import PlacecatError


def discriminative_codewords(active: NDArray[np.uint8], y: ArrayLike, keep: float) -> NDArray[np.bool_]:
    """Mark the codewords whose presence in a frame is most informative about its class.

    Parameters
    ----------
    active
        (frames, N) uint8, 1 where a frame has a region of the codeword: see
        :func:`placecat.learning.activations.activations`.
    y
        (frames,) classes.
    keep
        Share of the codewords to mark, in (0, 1], at least one codeword. Lower numbers win ties. Raises
        PlacecatError out of this range.

    Returns
    -------
    (N,) bool, by the mutual information of presence and class.

    Examples
    --------
    >>> active = np.array([[1, 1, 0], [1, 1, 0], [1, 0, 0], [1, 0, 1]], np.uint8)
    >>> discriminative_codewords(active, [0, 0, 1, 1], keep=0.34).tolist()
    [False, True, False]
    """
    if not 0.0 < keep <= 1.0:
        raise PlacecatError(f"keep is {keep}: the share of codewords to keep lies above 0 and up to 1")
    information = mutual_info_classif(active, np.asarray(y), discrete_features=True)
    kept = np.zeros(len(information), bool)
    number = max(1, round(keep * len(information)))
    # Rounded: the last bits of sums must not decide.
    kept[np.argsort(-information.round(12), kind="stable")[:number]] = True
    return kept
