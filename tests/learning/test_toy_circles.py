import numpy as np
import pytest

from placecat.learning.nu_svm import NuSVM
from placecat.learning.one_against_all import OneAgainstAll
from placecat.learning.sequential import Sequential
from placecat.learning.toy_circles import toy_circles


@pytest.mark.parametrize("radius", [0.5, 1.0])
def test_points_lie_where_their_label_says(radius):
    X, y = toy_circles(2000, seed=3, radius=radius)
    half = radius * np.sqrt(2 * np.pi)
    assert np.abs(X).max() <= half
    middles = half / 2 * np.array([(-1, -1), (-1, 1), (1, -1), (1, 1)])
    distances = np.hypot(*(X[:, None] - middles).transpose(2, 0, 1))
    assert np.array_equal(distances.min(axis=1) <= radius, y < 4)
    assert np.array_equal(distances.argmin(axis=1)[y < 4], y[y < 4])


def test_half_of_the_points_are_inside():
    _, y = toy_circles(100000, seed=1)
    np.testing.assert_allclose(np.bincount(y) / len(y), [0.125] * 4 + [0.5], atol=0.005)
    _, y = toy_circles(100000, seed=1, inside=0.3)
    assert np.mean(y < 4) == pytest.approx(0.3, abs=0.005)


def test_another_radius_scales_the_same_points():
    (X, y), (half, same) = toy_circles(300, 1), toy_circles(300, 1, radius=0.5)
    np.testing.assert_allclose(X, 2 * half)
    np.testing.assert_array_equal(y, same)


def test_points_depend_on_the_seed():
    assert np.array_equal(toy_circles(50, 1)[0], toy_circles(50, 1)[0])
    assert not np.array_equal(toy_circles(50, 1)[0], toy_circles(50, 2)[0])


def test_thesis_4_8():
    """Both schemes "solve this simple five-class problem very well"."""
    X, y = toy_circles(1000, seed=1)
    test, truth = toy_circles(4000, seed=2)
    base = NuSVM(gamma=2.0, nu=0.2)
    for model in (OneAgainstAll(base), Sequential(base, decision="probability")):
        assert np.mean(model.fit(X, y).predict(test) == truth) > 0.93
