import numpy as np
import pytest
from sklearn.cluster import KMeans

from placecat.errors import NotComputable, PlacecatError
from placecat.learning.flat_kmeans import FlatKMeans


@pytest.fixture(scope="module")
def points():
    rng = np.random.default_rng(0)
    return (rng.normal(size=(400, 6)) + 4 * rng.integers(0, 5, (400, 1))).astype(np.float32)


def test_inertia_is_close_to_that_of_scikit_learn(points):
    model = FlatKMeans(numbers=(5, 16), seed=1).fit(points)
    for number in (5, 16):
        centers = model.centers(number)
        assert centers.shape == (number, 6)
        nearest = model.assign(points, number)
        inertia = ((points - centers[nearest]) ** 2).sum()
        best = KMeans(number, n_init=10, random_state=0).fit(points).inertia_
        assert best * 0.999 <= inertia < 1.3 * best
        np.testing.assert_array_equal(
            nearest, ((points[:, None] - centers[None]) ** 2).sum(axis=2).argmin(axis=1)
        )


def test_clusterings_depend_on_the_seed_but_not_on_each_other(points):
    alone = FlatKMeans(numbers=(16,), seed=1).fit(points).centers(16)
    np.testing.assert_array_equal(FlatKMeans(numbers=(5, 16), seed=1).fit(points).centers(16), alone)
    assert not np.array_equal(FlatKMeans(numbers=(16,), seed=2).fit(points).centers(16), alone)


def test_too_few_points_and_unknown_numbers():
    model = FlatKMeans(**FlatKMeans.settings_for([46, 3, 3])).fit(np.eye(4))
    assert model.numbers == (3, 46)
    with pytest.raises(
        NotComputable, match="46 clusters need at least that many points, but there are only 4"
    ):
        model.centers(46)
    with pytest.raises(PlacecatError, match="n_clusters=5 was not computed: use one of 3, 46"):
        model.assign(np.eye(4), 5)
    with pytest.raises(PlacecatError, match="max_iter"):
        FlatKMeans(max_iter=0).fit(np.eye(4))
