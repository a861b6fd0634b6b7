"""The accuracy of decisions in a home (thesis 4.2)."""

import numpy as np
from numpy.typing import ArrayLike, NDArray


def confusion_matrix(truth: ArrayLike, decision: ArrayLike, n_classes: int) -> NDArray[np.int64]:
    """Return an (n_classes, n_classes) matrix that counts scored frames by true and decided class.

    Rows are true classes, and columns are decided classes. `truth` contains (n,) integers, with -1 for frames
    that are not scored. `decision` contains (n,) integers in [0, n_classes).
    """
    truth = np.asarray(truth, dtype=np.int64)
    decision = np.asarray(decision, dtype=np.int64)
    scored = truth >= 0
    pairs = truth[scored] * n_classes + decision[scored]
    return np.bincount(pairs, minlength=n_classes * n_classes).reshape(n_classes, n_classes)


def class_accuracies(confusion: NDArray[np.int64]) -> NDArray[np.float64]:
    """Return the percentage of correct decisions for each class, or NaN for a class with no frames.

    As in the thesis, the accuracy of a home is the mean of these percentages over the classes present (see
    :func:`home_accuracy`). This keeps frequent classes from outweighing rare ones.
    """
    totals = confusion.sum(axis=1)
    with np.errstate(invalid="ignore"):
        return 100.0 * np.diagonal(confusion) / np.where(totals > 0, totals, np.nan)


def home_accuracy(confusion: NDArray[np.int64]) -> float:
    """Return the mean accuracy of the classes present, in percent, or NaN if no frame is scored."""
    accuracies = class_accuracies(confusion)
    return float(np.nanmean(accuracies)) if np.isfinite(accuracies).any() else float("nan")
