import numpy as np
from scipy.spatial.distance import cdist

from placecat.learning import nearest
from placecat.learning.nearest import nearest_centers


def test_against_all_distances():
    rng = np.random.default_rng(0)
    points, centers = rng.normal(size=(300, 20)), rng.normal(size=(50, 20))
    expected = np.argsort(cdist(points.astype(np.float32), centers), axis=1)[:, :4]
    found = nearest_centers(points, centers, 4)
    assert found.dtype == np.int32
    np.testing.assert_array_equal(found, expected)


def test_far_from_the_origin():
    rng = np.random.default_rng(1)
    points, centers = rng.integers(0, 9, (200, 5)), rng.integers(0, 9, (30, 5))
    distances = cdist(points, centers)
    far = nearest_centers(points + 100_000, centers + 100_000.0)
    np.testing.assert_array_equal(np.take_along_axis(distances, far, 1)[:, 0], distances.min(axis=1))


def test_ties_go_to_the_lowest_index():
    centers = np.array([[5.0], [0.0], [2.0], [0.0]])
    assert nearest_centers([[0.0], [1.0]], centers, 3).tolist() == [[1, 3, 2], [1, 2, 3]]


def test_blocks_do_not_matter(monkeypatch):
    rng = np.random.default_rng(2)
    points, centers = rng.normal(size=(101, 7)), rng.normal(size=(13, 7))
    whole = nearest_centers(points, centers, 2)
    monkeypatch.setattr(nearest, "_BLOCK", 39)
    np.testing.assert_array_equal(nearest_centers(points, centers, 2), whole)


def test_no_points():
    assert nearest_centers(np.empty((0, 2)), np.zeros((3, 2))).shape == (0, 1)


def test_tied_points_do_not_depend_on_the_batch():
    rng = np.random.default_rng(0)
    centers = rng.normal(size=(91, 130)).astype(np.float32)
    pairs = rng.integers(0, 91, (400, 2))
    halfway = ((centers[pairs[:, 0]] + centers[pairs[:, 1]]) / 2).astype(np.float32)
    together = nearest_centers(halfway, centers, 2)
    for place in range(400):
        assert np.array_equal(nearest_centers(halfway[place : place + 1], centers, 2)[0], together[place])
