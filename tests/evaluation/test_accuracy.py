import numpy as np
import pytest

from placecat.evaluation.accuracy import class_accuracies, confusion_matrix, home_accuracy


def test_confusion_counts_scored_frames_only():
    confusion = confusion_matrix([0, 0, 1, -1, 1, 2], [0, 1, 1, 2, 1, 0], 3)
    assert confusion.tolist() == [[1, 1, 0], [0, 2, 0], [1, 0, 0]]


def test_accuracy_is_the_mean_over_classes_present():
    confusion = confusion_matrix([0] * 90 + [1] * 10, [0] * 90 + [0] * 5 + [1] * 5, 3)
    percent = class_accuracies(confusion)
    assert percent[:2].tolist() == [100.0, 50.0]
    assert np.isnan(percent[2])
    assert home_accuracy(confusion) == 75.0


def test_agrees_with_scikit_learn():
    from sklearn.metrics import balanced_accuracy_score

    rng = np.random.default_rng(0)
    truth, decision = rng.integers(0, 5, 300), rng.integers(0, 5, 300)
    expected = 100 * balanced_accuracy_score(truth, decision)
    assert home_accuracy(confusion_matrix(truth, decision, 5)) == pytest.approx(expected)


def test_accuracy_is_nan_without_scored_frames():
    assert np.isnan(home_accuracy(confusion_matrix([-1, -1], [0, 1], 2)))
