import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.base import clone
from sklearn.exceptions import NotFittedError

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning import knn as module
from placecat.learning.hierarchical_kmeans import HierarchicalKMeans
from placecat.learning.knn import ModifiedKNN

NAMES = np.array(["bathroom", "bedroom", "kitchen"])


def training_data(seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    labels = rng.choice(3, 300, p=[0.6, 0.3, 0.1])
    X = rng.normal(size=(300, 4)) + labels[:, None]
    return X.astype(np.float32), NAMES[labels]


def thesis_probability(
    model: ModifiedKNN, points: np.ndarray, n_neighbors: int, smoothing: float, once: bool
) -> np.ndarray:
    """Compute equations (4) and (5) with loops, or equation (2) for one neighbour."""
    classes = range(len(model.classes_))
    f = model.frequencies_ + smoothing
    probability = np.ones(len(classes))
    for point in points:
        distances = np.sqrt(((model.centers_ - point) ** 2).sum(axis=1))
        nearest = sorted(range(len(f)), key=lambda j: distances[j])[:n_neighbors]
        for i in classes:
            if n_neighbors == 1:
                probability[i] *= f[nearest[0], i]
            else:
                probability[i] *= sum(f[j, i] * (1 / distances[j]) for j in nearest)
    for i in classes:
        total = sum(f[j, i] for j in range(len(f)))
        probability[i] /= total if once else total ** len(points)
    return probability / probability.sum()


def test_frequencies_and_centres():
    X, y = training_data()
    model = ModifiedKNN(n_clusters=16).fit(X, y)
    codes = ((X[:, None] - model.centers_) ** 2).sum(axis=2).argmin(axis=1)
    for cluster in range(16):
        for label, name in enumerate(NAMES):
            assert model.frequencies_[cluster, label] == ((codes == cluster) & (y == name)).sum()
    tree = HierarchicalKMeans(max_clusters=16, seed=0).fit(X)
    np.testing.assert_array_equal(model.centers_, tree.centers(16))


@pytest.mark.parametrize("n_neighbors", [1, 2, 3])
@pytest.mark.parametrize("weighting", ["once", "per_region"])
@pytest.mark.parametrize("smoothing", [0.5, 1.0])
def test_against_the_equations(monkeypatch, n_neighbors, weighting, smoothing):
    monkeypatch.setattr(module, "_BLOCK", 30)
    X, y = training_data()
    model = ModifiedKNN(16, n_neighbors, smoothing, weighting).fit(X, y)
    rng = np.random.default_rng(1)
    sets = rng.normal(1, 1, size=(12, 5, 4)).astype(np.float32)
    counts = np.array([0, 1, 2, 3, 4, 5] * 2)
    sets[np.arange(5) >= counts[:, None]] = np.nan
    found = model.predict_proba_sets(sets, counts)
    for frame, count in enumerate(counts):
        if count == 0:
            expected = np.full(3, 1 / 3)
        else:
            expected = thesis_probability(
                model, sets[frame, :count], n_neighbors, smoothing, weighting == "once"
            )
        np.testing.assert_allclose(found[frame], expected, rtol=1e-6)
    single = model.predict_proba(sets[1::6, 0])
    np.testing.assert_allclose(single, found[1::6], rtol=1e-12)
    np.testing.assert_array_equal(model.predict(sets[1::6, 0]), NAMES[found[1::6].argmax(axis=1)])


def test_once_favours_frequent_classes():
    # The clusters are uninformative: each contains 9 points of one class and 1 of the other.
    X = np.repeat([[0.0], [10.0]], 10, axis=0)
    y = ["common"] * 9 + ["rare"] + ["common"] * 9 + ["rare"]
    codebook = HierarchicalKMeans(branching=2, max_clusters=3).fit(X)
    frame, counts = np.zeros((1, 3, 1)), [3]
    once = ModifiedKNN(2, smoothing=0, class_weighting="once", codebook=codebook).fit(X, y)
    each = ModifiedKNN(2, smoothing=0, codebook=codebook).fit(X, y)
    np.testing.assert_allclose(each.predict_proba_sets(frame, counts), [[0.5, 0.5]])
    np.testing.assert_allclose(once.predict_proba_sets(frame, counts), [[81 / 82, 1 / 82]])


def test_a_given_codebook_is_not_modified():
    X, y = training_data()
    codebook = HierarchicalKMeans(max_clusters=46, seed=8).fit(X)
    before = codebook.centers(31)
    model = ModifiedKNN(31, codebook=codebook).fit(X, y)
    np.testing.assert_array_equal(model.centers_, before)
    for point, label in zip(X[:20] + 9, y, strict=False):
        model.update(point, label)
    assert not np.array_equal(model.centers_, before)
    np.testing.assert_array_equal(codebook.centers(31), before)


def test_a_centre_at_distance_zero_takes_all_the_weight():
    X = np.array([[0.0], [0.0], [8.0], [8.0]])
    codebook = HierarchicalKMeans(branching=2, max_clusters=3).fit(X)
    model = ModifiedKNN(2, 2, smoothing=0.0, codebook=codebook).fit(X, ["a", "b", "b", "b"])
    # At 0, only the first centre counts, and f = (1, 1) is divided by f(a) = 1 and f(b) = 3.
    np.testing.assert_allclose(model.predict_proba([[0.0]]), [[3 / 4, 1 / 4]])
    # At 2, the weights are 1/2 and 1/6, so f(a) = 1/2 and f(b) = 1/2 + 2/6.
    np.testing.assert_allclose(model.predict_proba([[2.0]]), [[9 / 14, 5 / 14]])


def test_without_smoothing_zero_counts_veto():
    X = np.array([[0.0], [0.0], [8.0], [8.0]])
    codebook = HierarchicalKMeans(branching=2, max_clusters=3).fit(X)
    once = {"smoothing": 0.0, "class_weighting": "once", "codebook": codebook}
    model = ModifiedKNN(2, **once).fit(X, ["a", "a", "a", "b"])
    sets = np.array([[[0.0], [8.0]], [[8.0], [8.0]]])
    np.testing.assert_allclose(model.predict_proba_sets(sets, [2, 2]), [[1, 0], [1 / 4, 3 / 4]])
    model = ModifiedKNN(2, **once).fit(X, ["a", "a", "b", "b"])
    np.testing.assert_allclose(model.predict_proba_sets(sets, [2, 2]), [[0.5, 0.5], [0, 1]])


def test_many_regions_do_not_underflow():
    X, y = training_data()
    model = ModifiedKNN(16).fit(X, y)
    found = model.predict_proba_sets(np.tile(X[:1], (2, 3000, 1)), [3000, 2999])
    assert np.isfinite(found).all()
    np.testing.assert_allclose(found.sum(axis=1), 1)


@given(st.integers(0, 500), st.integers(1, 4), st.sampled_from(["once", "per_region"]))
@settings(max_examples=examples(20), deadline=None)
def test_rows_sum_to_one_and_the_order_of_regions_does_not_matter(seed, n_neighbors, weighting):
    rng = np.random.default_rng(seed)
    X, y = training_data(seed)
    model = ModifiedKNN(16, n_neighbors, class_weighting=weighting).fit(X, y)
    sets = rng.normal(size=(6, 4, 4))
    found = model.predict_proba_sets(sets, [4] * 6)
    np.testing.assert_allclose(found.sum(axis=1), 1, rtol=1e-12)
    np.testing.assert_allclose(model.predict_proba_sets(sets[:, ::-1], [4] * 6), found, rtol=1e-9)


def line_model() -> ModifiedKNN:
    X = np.array([[0.0], [0.0], [2.0], [2.0], [2.0], [9.0]])
    codebook = HierarchicalKMeans(branching=2, max_clusters=3).fit(X)
    model = ModifiedKNN(3, codebook=codebook).fit(X, ["a", "a", "a", "b", "b", "b"])
    order = model.centers_[:, 0].argsort()
    model.centers_, model.frequencies_ = model.centers_[order], model.frequencies_[order]
    return model


def test_update_adds_a_close_point():
    model = line_model().update([3.0], "a")
    np.testing.assert_allclose(model.centers_[:, 0], [0, 2.25, 9])
    assert model.frequencies_.tolist() == [[2, 0], [2, 2], [0, 1]]


def test_update_at_the_limit_adds():
    # The distance from the point to its cluster equals that between the two closest clusters (2).
    model = line_model().update([11.0], "b")
    np.testing.assert_allclose(model.centers_[:, 0], [0, 2, 10])


def test_update_merges_for_a_far_point():
    model = line_model().update([12.0], "a")
    np.testing.assert_allclose(model.centers_[:, 0], [6 / 5, 12, 9])
    assert model.frequencies_.tolist() == [[3, 2], [1, 0], [0, 1]]


def test_updates_against_recomputation():
    X, y = training_data()
    model = ModifiedKNN(16, n_neighbors=2).fit(X[:100], y[:100])
    sizes = model.frequencies_.sum(axis=1)
    # Represent each cluster by its mass, its weighted sum and its class counts.
    clusters = [
        [float(n), n * c, f.copy()] for n, c, f in zip(sizes, model.centers_, model.frequencies_, strict=True)
    ]
    rng = np.random.default_rng(2)
    merged = 0
    for step in range(200):
        point = (X[100 + step] + rng.choice([0, 0, 6]) * rng.normal(size=4)).astype(np.float32)
        model.update(point, y[100 + step])
        label = NAMES.tolist().index(y[100 + step])
        centers = np.array([total / mass for mass, total, _ in clusters])
        between = np.linalg.norm(centers[:, None] - centers, axis=2)
        np.fill_diagonal(between, np.inf)
        to_point = np.linalg.norm(centers - point, axis=1)
        if to_point.min() > between.min():
            merged += 1
            a, b = np.unravel_index(between.argmin(), between.shape)
            clusters[a] = [first + second for first, second in zip(clusters[a], clusters[b], strict=True)]
            clusters[b] = [1.0, point.astype(float), np.eye(3, dtype=int)[label]]
        else:
            near = clusters[to_point.argmin()]
            near[0] += 1
            near[1] = near[1] + point
            near[2] = near[2] + np.eye(3, dtype=int)[label]
        np.testing.assert_allclose(model.centers_, [t / m for m, t, _ in clusters], rtol=1e-9, atol=1e-9)
        np.testing.assert_array_equal(model.frequencies_, [f for _, _, f in clusters])
    assert 5 < merged < 195
    assert model.frequencies_.sum() == 300
    found = model._pair_distances
    expected = np.linalg.norm(model.centers_[:, None] - model.centers_, axis=2)
    np.fill_diagonal(expected, np.inf)
    np.testing.assert_allclose(found, expected, rtol=1e-9)
    np.testing.assert_allclose(model.predict_proba(X).sum(axis=1), 1)


def test_update_of_a_single_cluster():
    model = ModifiedKNN(1).fit([[0.0], [2.0]], ["a", "b"]).update([4.0], "b")
    np.testing.assert_allclose(model.centers_, [[2.0]])
    assert model.frequencies_.tolist() == [[1, 2]]


def test_wrong_updates():
    model = line_model()
    with pytest.raises(PlacecatError, match="class 'c' is unknown: use one of a, b"):
        model.update([0.0], "c")
    with pytest.raises(PlacecatError, match="X has 2 features"):
        model.update([0.0, 1.0], "a")


@pytest.mark.parametrize(
    ("settings_", "message"),
    [
        ({"n_neighbors": 0}, "n_neighbors=0"),
        ({"n_neighbors": 17, "n_clusters": 16}, "n_neighbors=17 exceeds n_clusters=16"),
        ({"smoothing": -0.1}, "smoothing=-0.1"),
        ({"class_weighting": "twice"}, "class_weighting=twice: it must be 'once' or 'per_region'"),
        ({"n_clusters": 100}, "91 or 106"),
        ({"n_clusters": 496}, "496 clusters cannot be formed"),
    ],
)
def test_invalid_settings(settings_, message):
    X, y = training_data()
    with pytest.raises(PlacecatError, match=message):
        ModifiedKNN(**settings_).fit(X, y)


def test_wrong_data():
    X, y = training_data()
    model = ModifiedKNN(16).fit(X, y)
    with pytest.raises(PlacecatError, match="X has 3 features, but ModifiedKNN is expecting 4"):
        model.predict(X[:, :3])
    with pytest.raises(PlacecatError, match=r"y has shape \(2,\) for 300 samples"):
        ModifiedKNN(16).fit(X, y[:2])
    assert model.predict_proba_sets(np.zeros((2, 0, 4)), [0, 0]).tolist() == [[1 / 3] * 3] * 2


def test_conventions():
    model = ModifiedKNN(46, smoothing=0.5)
    assert clone(model).get_params() == {
        "n_clusters": 46,
        "n_neighbors": 1,
        "smoothing": 0.5,
        "class_weighting": "per_region",
        "codebook": None,
        "seed": 0,
    }
    assert repr(model) == "ModifiedKNN(n_clusters=46, smoothing=0.5)"
    for call in (lambda: model.predict([[0.0]]), lambda: model.update([0.0], "a")):
        with pytest.raises(NotFittedError):
            call()
    X, y = training_data()
    assert model.fit(X, y) is model
    assert model.classes_.tolist() == NAMES.tolist()
    assert model.n_features_in_ == 4
    assert model.score(X, y) > 0.5
