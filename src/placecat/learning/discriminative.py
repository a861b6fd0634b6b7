"""Select the most discriminative codewords."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.learning.contingency import value_counts


def discriminative_codewords(active: NDArray[np.uint8], y: ArrayLike, keep: float) -> NDArray[np.bool_]:
    """Mark the codewords whose presence in a frame is most informative about the frame's class.

    Parameters
    ----------
    active
        (frames, N) uint8, with 1 where a frame has a region with the codeword. See
        :func:`placecat.learning.activations.activations`.
    y
        (frames,) classes.
    keep
        Share of codewords to mark, in (0, 1]. At least one codeword is marked. Ties go to the lower codeword
        numbers.

    Returns
    -------
    (N,) bool, true for the codewords whose presence has the greatest mutual information with the class,
    estimated from relative frequencies.

    Examples
    --------
    >>> active = np.array([[1, 1, 0], [1, 1, 0], [1, 0, 0], [1, 0, 1]], np.uint8)
    >>> discriminative_codewords(active, [0, 0, 1, 1], keep=0.34).tolist()
    [False, True, False]
    """
    classes, labels = np.unique(np.asarray(y), return_inverse=True)
    joint = value_counts(active, labels, len(classes), 2) / len(labels)
    independent = joint.sum(axis=0) * joint.sum(axis=2, keepdims=True)
    ratio = np.divide(joint, independent, out=np.ones_like(joint), where=joint > 0)
    information = (joint * np.log(ratio)).sum(axis=(0, 2))
    kept = np.zeros(len(information), bool)
    number = max(1, round(keep * len(information)))
    # Round, so that ties do not depend on the last bits of the sums.
    kept[np.argsort(-information.round(12), kind="stable")[:number]] = True
    return kept
