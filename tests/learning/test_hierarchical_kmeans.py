import io

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.distance import cdist
from sklearn.base import clone
from sklearn.cluster import KMeans
from sklearn.exceptions import NotFittedError
from sklearn.utils.estimator_checks import check_estimator
from threadpoolctl import threadpool_limits

from number_of_examples import examples
from placecat.errors import NotComputable, PlacecatError
from placecat.learning import hierarchical_kmeans as module
from placecat.learning import kmeans_split
from placecat.learning.hierarchical_kmeans import HierarchicalKMeans, check_cluster_number


def blobs() -> tuple[np.ndarray, np.ndarray]:
    """Return three distant clusters of three nearby groups of 20 points each, and the group of each point."""
    rng = np.random.default_rng(0)
    far = np.array([[0, 0], [1000, 0], [0, 1000]])
    near = np.array([[0, 0], [30, 0], [0, 30]])
    groups = np.repeat(np.arange(9), 20)
    points = far[groups // 3] + near[groups % 3] + rng.normal(0, 0.5, (180, 2))
    order = rng.permutation(180)
    return points[order].astype(np.float32), groups[order]


def same_partition(first: np.ndarray, second: np.ndarray) -> bool:
    return len(set(zip(first.tolist(), second.tolist(), strict=True))) == len(set(first)) == len(set(second))


def grown(X: np.ndarray, **settings: int) -> HierarchicalKMeans:
    return HierarchicalKMeans(**settings).fit(X)


@pytest.mark.parametrize("seed", range(5))
def test_cuts_recover_the_blobs(seed):
    X, groups = blobs()
    tree = grown(X, branching=3, max_clusters=9, seed=seed)
    for codes in (tree.labels(3), tree.assign(X, 3)):
        assert same_partition(codes, groups // 3)
    for codes in (tree.labels(9), tree.assign(X, 9)):
        assert same_partition(codes, groups)
    means = np.array([X[groups == group].mean(axis=0) for group in range(9)])
    distances = cdist(tree.centers(9), means)
    np.testing.assert_allclose(distances.min(axis=1), 0, atol=1e-3)


def test_the_widest_group_is_split_first():
    X, groups = blobs()
    X[groups // 3 == 1] = [1000, 0] + 8 * (X[groups // 3 == 1] - [1000, 0])
    tree = grown(X, branching=3, max_clusters=5)
    codes = tree.labels(5)
    assert len(set(codes[groups // 3 == 1])) == 3
    assert len(set(codes[groups // 3 == 0])) == len(set(codes[groups // 3 == 2])) == 1


def test_splits_match_scikit_learn():
    X = np.random.default_rng(3).gamma(1.0, size=(500, 6)).astype(np.float32)
    tree = grown(X, branching=8, max_clusters=8, max_iter=200, seed=4)
    labels = tree.labels(8)
    # A converged clustering is a fixed point of any k-means implementation.
    means = np.array([X[labels == label].mean(axis=0) for label in range(8)])
    other = KMeans(8, init=means, n_init=1, max_iter=1, tol=0).fit(X)
    np.testing.assert_array_equal(other.labels_, labels)
    np.testing.assert_allclose(tree.centers(8), means, rtol=1e-5)
    np.testing.assert_allclose(tree.node_sse_[1:].sum(), other.inertia_, rtol=1e-5)


def test_lloyd_follows_scikit_learn_step_by_step():
    X = np.random.default_rng(5).normal(size=(400, 5)).astype(np.float32)
    start = X[:6].astype(np.float64)
    for steps in (1, 2, 5, 9):
        found = kmeans_split.lloyd(X, kmeans_split.nearest(X, start), 6, steps)
        other = KMeans(6, init=start, n_init=1, max_iter=steps, tol=0).fit(X.astype(np.float64))
        np.testing.assert_array_equal(found, other.labels_)


@pytest.mark.parametrize("kind", ["normal", "heavy", "duplicates"])
def test_lazy_growth_equals_the_definition(kind):
    rng = np.random.default_rng(6)
    X = {
        "normal": rng.normal(size=(300, 4)),
        "heavy": rng.gamma(0.2, size=(300, 4)) ** 2,
        "duplicates": rng.integers(0, 4, (300, 3)),
    }[kind].astype(np.float32)
    tree = grown(X, branching=3, max_clusters=41, seed=7)

    # Split all nodes in advance, then search all open nodes for the greatest gain, as the definition says.
    def split_all(node: kmeans_split.Node) -> None:
        seeds = np.random.SeedSequence(7, spawn_key=node.path)
        node.children = kmeans_split.split_node(node, 3, 11, np.random.default_rng(seeds))
        for child in node.children:
            split_all(child)

    nodes = [kmeans_split.make_root(X)]
    split_all(nodes[0])
    cut, steps = {0}, []
    while len(cut) < 41:
        gains = {
            i: nodes[i].sse - sum(child.sse for child in nodes[i].children) for i in cut if nodes[i].children
        }
        if not gains:
            break
        steps.append(max(gains, key=lambda i: (gains[i], -i)))
        cut.remove(steps[-1])
        cut.update(range(len(nodes), len(nodes) + 3))
        nodes.extend(nodes[steps[-1]].children)
    assert tree.split_nodes_.tolist() == steps
    assert tree.max_clusters_ == len(cut)
    np.testing.assert_array_equal(tree.node_centers_, np.array([n.center for n in nodes], np.float32))


def test_growth_is_lazy(monkeypatch):
    rng = np.random.default_rng(8)
    X = np.concatenate([rng.normal(0, 0.01, (200, 2)) + 100 * rng.normal(size=2) for _ in range(16)])
    X[:200] += 1000 * rng.normal(size=(200, 2))
    splits = []
    split = module.split_node
    monkeypatch.setattr(
        module, "split_node", lambda node, *rest: splits.append(node.path) or split(node, *rest)
    )
    tree = grown(X, max_clusters=31)
    assert tree.max_clusters_ == 31
    assert len(splits) < 17


def test_nodes_describe_their_points():
    X = np.random.default_rng(9).gamma(0.5, size=(700, 5)).astype(np.float32) + 50
    tree = grown(X, branching=4, max_clusters=22)
    for n_clusters in (1, 4, 13, 22):
        labels, cut = tree.labels(n_clusters), tree._cut(n_clusters)
        assert np.bincount(labels).tolist() == tree.node_sizes_[cut].tolist()
        for label, node in enumerate(cut):
            part = X[labels == label].astype(np.float64)
            np.testing.assert_allclose(tree.node_centers_[node], part.mean(axis=0), rtol=1e-6)
            np.testing.assert_allclose(
                tree.node_sse_[node], ((part - part.mean(axis=0)) ** 2).sum(), rtol=1e-3
            )


def test_smaller_cuts_do_not_depend_on_the_largest():
    X = np.random.default_rng(10).normal(size=(400, 3))
    large, small = grown(X, branching=4, max_clusters=40), grown(X, branching=4, max_clusters=13)
    for n_clusters in (1, 4, 7, 10, 13):
        assert large.centers(n_clusters).tobytes() == small.centers(n_clusters).tobytes()
        np.testing.assert_array_equal(large.labels(n_clusters), small.labels(n_clusters))


def test_assign_is_the_nearest_centre():
    rng = np.random.default_rng(11)
    X, other = rng.normal(size=(600, 8)), rng.normal(size=(200, 8)).astype(np.float32)
    tree = grown(X, max_clusters=46)
    codes = tree.assign(other, 46)
    assert codes.dtype == np.int32
    np.testing.assert_array_equal(codes, cdist(other, tree.centers(46)).argmin(axis=1))
    assert tree.assign(np.empty((0, 8)), 46).shape == (0,)


def test_a_seed_determines_the_tree_for_any_number_of_threads():
    X = np.random.default_rng(12).normal(size=(3000, 40)).astype(np.float32)
    trees = []
    for threads in (1, 2):
        with threadpool_limits(limits=threads):
            trees.append(grown(X, max_clusters=61, seed=3))
    first, second = (tree.to_arrays() for tree in trees)
    assert {k: v.tobytes() for k, v in first.items()} == {k: v.tobytes() for k, v in second.items()}
    assert trees[0].training_nodes_.tobytes() == trees[1].training_nodes_.tobytes()
    assert trees[0].assign(X, 61).tobytes() == trees[1].assign(X, 61).tobytes()
    assert grown(X, max_clusters=61, seed=4).centers(61).tobytes() != trees[0].centers(61).tobytes()


def test_the_global_generator_is_not_used():
    before = np.random.get_state()[1].copy()  # noqa: NPY002
    grown(np.random.default_rng(0).normal(size=(50, 2)), max_clusters=16)
    np.testing.assert_array_equal(before, np.random.get_state()[1])  # noqa: NPY002


def test_seeds_are_drawn_by_squared_distance():
    # The distances from the first seed are 1 and 3, so the probabilities are in the ratio 1 : 9.
    X = np.array([[0.0], [1.0], [3.0]], np.float32)
    counts = np.zeros(3)
    for seed in range(4000):
        labels = kmeans_split.seed_clusters(X, 2, np.random.default_rng(seed))
        if labels[0] == 0 and np.random.default_rng(seed).integers(3) == 0:
            counts[1 if labels[1] == 1 and labels[2] == 1 else 2] += 1
    # A second seed at 1 attracts both other points, and a second seed at 3 attracts only itself.
    assert counts.sum() > 1000
    assert counts[1] / counts.sum() == pytest.approx(0.1, abs=0.03)


@given(st.integers(1, 12), st.integers(1, 40), st.integers(2, 5), st.integers(0, 3))
@settings(max_examples=examples(60), deadline=None)
def test_duplicates_and_small_data(n_distinct, copies, branching, seed):
    rng = np.random.default_rng(seed)
    distinct = rng.permutation(64)[:n_distinct, None].astype(np.float32) * [1.0, 1e4]
    X = rng.permutation(np.repeat(distinct, copies, axis=0))
    tree = grown(X, branching=branching, max_clusters=1 + 10 * (branching - 1), seed=seed)
    assert tree.max_clusters_ <= n_distinct
    assert tree.max_clusters_ > 1 or n_distinct < branching
    labels = tree.labels(tree.max_clusters_)
    assert set(labels) == set(range(tree.max_clusters_))
    # Duplicates are never separated.
    assert len(set(zip(X[:, 0].tolist(), labels.tolist(), strict=True))) == n_distinct


def test_near_duplicates_far_from_the_mean_are_separated():
    X = np.float32(1000) + np.array([[0], [0], [2], [2], [-2000]], np.float32)
    tree = grown(X, branching=3, max_clusters=3)
    assert same_partition(tree.labels(3), np.array([0, 0, 1, 1, 2]))


def test_empty_clusters_take_the_farthest_points():
    X = np.array([[0.0], [1.0], [10.0], [11.0]], np.float32)
    labels = np.array([0, 0, 0, 3], np.uint16)
    kmeans_split.fill_empty(X, labels, np.array([[0.0], [99.0], [99.0], [11.0]]))
    assert labels.tolist() == [0, 2, 1, 3]


def test_too_many_clusters_raise_an_error_with_the_maximum():
    tree = grown(np.repeat(np.arange(40.0), 3)[:, None], max_clusters=196)
    largest = tree.max_clusters_
    assert 16 <= largest <= 40
    assert tree.centers(largest).shape == (largest, 1)
    with pytest.raises(NotComputable, match=f"split into at most {largest}"):
        tree.centers(196)


def test_beyond_the_grown_tree():
    tree = grown(np.random.default_rng(0).normal(size=(500, 2)), max_clusters=31)
    with pytest.raises(PlacecatError, match="max_clusters=31"):
        tree.centers(46)


@pytest.mark.parametrize(
    ("number", "branching", "message"),
    [(100, 16, "91 or 106"), (0, 16, "1 or 16"), (-5, 16, "1 or 16"), (15, 16, "1 or 16"), (6, 3, "5 or 7")],
)
def test_invalid_cluster_numbers_are_rejected(number, branching, message):
    with pytest.raises(PlacecatError, match=f"use {message}$"):
        check_cluster_number(number, branching)


def test_the_thesis_cluster_numbers_are_valid():
    for number in (31, 46, 91, 196, 496, 991):
        check_cluster_number(number)


@pytest.mark.parametrize(
    ("settings_", "message"),
    [
        ({"branching": 1}, "branching=1"),
        ({"max_clusters": 200}, "196 or 211"),
        ({"max_iter": 0}, "max_iter=0"),
        ({"seed": -1}, "seed=-1"),
    ],
)
def test_invalid_settings(settings_, message):
    with pytest.raises(PlacecatError, match=message):
        HierarchicalKMeans(**settings_).fit(np.zeros((5, 2)))


def test_wrong_data():
    with pytest.raises(ValueError, match="NaN"):
        HierarchicalKMeans().fit([[np.nan, 0.0]])
    tree = grown(np.arange(40.0).reshape(20, 2), max_clusters=16)
    with pytest.raises(PlacecatError, match="X has 3 features, but HierarchicalKMeans is expecting 2"):
        tree.assign(np.zeros((1, 3)), 16)


def test_saved_and_loaded():
    X = np.random.default_rng(13).normal(size=(400, 3))
    tree = grown(X, max_clusters=46, seed=5, max_iter=9)
    file = io.BytesIO()
    np.savez(file, **tree.to_arrays())
    file.seek(0)
    with np.load(file, allow_pickle=False) as arrays:
        loaded = HierarchicalKMeans.from_arrays(arrays)
    assert loaded.get_params() == tree.get_params()
    assert loaded.max_clusters_ == tree.max_clusters_
    for n_clusters in (1, 16, 46):
        np.testing.assert_array_equal(loaded.centers(n_clusters), tree.centers(n_clusters))
        np.testing.assert_array_equal(loaded.assign(X, n_clusters), tree.assign(X, n_clusters))
    with pytest.raises(PlacecatError, match="use assign"):
        loaded.labels(16)


def test_centers_are_a_copy():
    tree = grown(np.arange(40.0)[:, None], max_clusters=16)
    tree.centers(16)[:] = 0
    assert tree.centers(16).any()


def test_conventions():
    tree = HierarchicalKMeans(branching=4, seed=9)
    copy = clone(tree)
    assert copy.get_params() == {"branching": 4, "max_clusters": 991, "max_iter": 11, "seed": 9}
    assert copy.set_params(seed=1).seed == 1
    assert repr(tree) == "HierarchicalKMeans(branching=4, seed=9)"
    for method in (tree.centers, tree.labels):
        with pytest.raises(NotFittedError):
            method(4)
    X = np.random.default_rng(0).normal(size=(30, 2))
    before = X.copy()
    assert tree.fit(X) is tree
    assert tree.n_features_in_ == 2
    np.testing.assert_array_equal(X, before)


@pytest.mark.filterwarnings("ignore")
def test_scikit_learn_checks():
    check_estimator(HierarchicalKMeans(branching=2, max_clusters=4), on_skip=None)
