import numpy as np

from placecat.learning.nu_svm import NuSVM
from placecat.learning.one_against_all import OneAgainstAll
from placecat.learning.sequential import Sequential
from placecat.learning.toy_circles import CENTRES, toy_circles


def test_points_lie_where_their_label_says():
    X, y = toy_circles(1000, seed=3)
    inside = np.stack([np.hypot(*(X - np.array(c)).T) <= 0.5 for c in CENTRES], axis=1)
    assert np.array_equal(inside.any(axis=1), y < 4)
    assert np.array_equal(inside.argmax(axis=1)[y < 4], y[y < 4])
    assert np.abs(X).max() <= 4.0
    assert np.bincount(y).tolist() == [125, 125, 125, 125, 500]


def test_seed_decides():
    assert np.array_equal(toy_circles(50, 1)[0], toy_circles(50, 1)[0])
    assert not np.array_equal(toy_circles(50, 1)[0], toy_circles(50, 2)[0])


def test_thesis_4_8():
    """Parallel at least 99.5 %, and about a third of the sequential scheme's error on its last class."""
    X, y = toy_circles(2000, seed=1)
    test, truth = toy_circles(8000, seed=2)
    base = NuSVM(gamma=2.0, nu=0.2)
    gram = base.prepare(X.astype(np.float32))

    def errors(model):
        answer = model.fit(X, y, gram=gram).predict(test)
        return np.array([100 * (answer[truth == k] != k).mean() for k in range(5)])

    sequence = Sequential(base)
    parallel, sequential = errors(OneAgainstAll(base)), errors(sequence)
    last = sequence.order_[-1]
    assert 100 - parallel.mean() >= 99.5
    assert sequential.argmax() == last
    assert 2.0 < sequential[last] / parallel[last] < 4.0
