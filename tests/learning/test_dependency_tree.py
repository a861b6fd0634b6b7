import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.base import clone
from sklearn.exceptions import NotFittedError
from sklearn.metrics import mutual_info_score

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning import dependency_tree as module
from placecat.learning.dependency_tree import DependencyTree
from placecat.learning.naive_bayes import NaiveBayes


def linked_codes(n_samples: int, n_variables: int, n_values: int, seed: int) -> np.ndarray:
    """Return random codes. About half of the values of each variable are copied from an earlier variable."""
    rng = np.random.default_rng(seed)
    codes = rng.integers(0, n_values, (n_samples, n_variables))
    for variable in range(1, n_variables):
        copied = rng.random(n_samples) < 0.5
        codes[copied, variable] = codes[copied, rng.integers(variable)]
    return codes


def edges(parents: np.ndarray) -> frozenset[frozenset[int]]:
    return frozenset(frozenset((v, int(p))) for v, p in enumerate(parents) if p >= 0)


def all_trees(n_variables: int) -> list[frozenset[frozenset[int]]]:
    """Return every spanning tree of the complete graph as a set of edges."""
    pairs = list(itertools.combinations(range(n_variables), 2))
    trees = []
    for chosen in itertools.combinations(pairs, n_variables - 1):
        part = list(range(n_variables))
        for a, b in chosen:
            part = [part[a] if group == part[b] else group for group in part]
        if len(set(part)) == 1:
            trees.append(frozenset(map(frozenset, chosen)))
    return trees


def tree_log_likelihood(codes: np.ndarray, tree: frozenset[frozenset[int]]) -> float:
    """Return the log-likelihood of `codes` under a tree whose probabilities are relative frequencies."""

    def entropy_sum(columns: tuple[int, ...]) -> float:
        _, counts = np.unique(codes[:, columns], axis=0, return_counts=True)
        return float((counts * np.log(counts / len(codes))).sum())

    single = [entropy_sum((v,)) for v in range(codes.shape[1])]
    total = sum(single)
    for edge in tree:
        a, b = sorted(edge)
        total += entropy_sum((a, b)) - single[a] - single[b]
    return total


@pytest.mark.parametrize("n_values", [2, 5])
@pytest.mark.parametrize("seed", range(4))
def test_best_of_all_sixteen_trees(n_values, seed):
    codes = linked_codes(120, 4, n_values, seed)
    model = DependencyTree(alpha=1e-9, n_values=n_values).fit(codes, ["a"] * 120)
    trees = all_trees(4)
    assert len(trees) == 16
    best = max(trees, key=lambda tree: tree_log_likelihood(codes, tree))
    assert edges(model.parents_[0]) == best
    assert model.predict_joint_log_likelihood(codes).sum() == pytest.approx(
        tree_log_likelihood(codes, best), rel=1e-6
    )


@pytest.mark.parametrize(("n_values", "n_samples"), [(2, 300), (4, 400), (60, 300)])
def test_each_class_has_the_maximum_spanning_tree(n_values, n_samples):
    codes = np.concatenate([linked_codes(n_samples, 7, n_values, seed) for seed in (1, 2)])
    y = np.repeat(["b", "a"], n_samples)
    model = DependencyTree(n_values=n_values).fit(codes, y)
    for label, name in enumerate(["a", "b"]):
        part = codes[y == name]
        pairs = sorted(
            itertools.combinations(range(7), 2),
            key=lambda pair: -mutual_info_score(part[:, pair[0]], part[:, pair[1]]),
        )
        # The reference uses Kruskal's algorithm, unlike our code.
        group, tree = list(range(7)), []
        for a, b in pairs:
            if group[a] != group[b]:
                tree.append(frozenset((a, b)))
                group = [group[a] if g == group[b] else g for g in group]
        assert edges(model.parents_[label]) == frozenset(tree)


@pytest.mark.parametrize(("dense", "alpha", "root"), [(True, 1.0, 0), (True, 0.2, 3), (False, 0.7, 2)])
@pytest.mark.parametrize("n_values", [2, 3])
def test_against_a_loop(monkeypatch, dense, alpha, root, n_values):
    if not dense:
        monkeypatch.setattr(module, "_DENSE_CELLS", 0)
    monkeypatch.setattr(module, "_BLOCK", 12)
    codes, y = linked_codes(60, 4, n_values, 5), np.arange(60) % 3
    model = DependencyTree(alpha=alpha, n_values=n_values, root=root, prior="frequency").fit(codes, y)
    configurations = np.array(list(itertools.product(range(n_values), repeat=4)))
    expected = np.zeros((len(configurations), 3))
    for label in range(3):
        part = codes[y == label]
        for row, values in enumerate(configurations):
            probability = len(part) / 60
            for variable, parent in enumerate(model.parents_[label]):
                given_ = part if parent < 0 else part[part[:, parent] == values[parent]]
                count = (given_[:, variable] == values[variable]).sum()
                probability *= (count + alpha) / (len(given_) + alpha * n_values)
            expected[row, label] = np.log(probability)
    assert (model.parents_[:, root] == -1).all()
    np.testing.assert_allclose(model.predict_joint_log_likelihood(configurations), expected, rtol=1e-12)


def test_the_model_does_not_depend_on_the_storage_of_counts(monkeypatch):
    codes, others = (linked_codes(80, 4, 9, seed) for seed in (5, 6))
    y = np.arange(80) % 2
    every_cell = DependencyTree(n_values=9).fit(codes, y).predict_joint_log_likelihood(others)
    monkeypatch.setattr(module, "_DENSE_CELLS", 0)
    what_occurs = DependencyTree(n_values=9).fit(codes, y).predict_joint_log_likelihood(others)
    np.testing.assert_array_equal(every_cell, what_occurs)


@given(st.integers(0, 10_000), st.integers(2, 4), st.floats(0.01, 5), st.booleans())
@settings(max_examples=examples(40), deadline=None)
def test_the_joint_distribution_sums_to_one(seed, n_values, alpha, dense):
    codes = linked_codes(25, 4, n_values, seed)
    configurations = np.array(list(itertools.product(range(n_values), repeat=4)))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "_DENSE_CELLS", 10**6 if dense else 0)
        model = DependencyTree(alpha=alpha, n_values=n_values).fit(codes, np.arange(25) % 2)
    joint = np.exp(model.predict_joint_log_likelihood(configurations))
    np.testing.assert_allclose(joint.sum(axis=0), 0.5, rtol=1e-10)
    np.testing.assert_allclose(model.predict_proba(configurations).sum(axis=1), 1, rtol=1e-12)


def test_independent_variables_yield_naive_bayes():
    # Every combination occurs once per class, so no pair is informative, and only the smoothing differs.
    codes = np.array(list(itertools.product(range(3), repeat=3)) * 2)
    y = np.repeat([0, 1], 27)
    tree = DependencyTree(alpha=1e-9).fit(codes, y)
    bayes = NaiveBayes(alpha=1e-9).fit(codes, y)
    np.testing.assert_allclose(
        tree.predict_joint_log_likelihood(codes), bayes.predict_joint_log_likelihood(codes), rtol=1e-6
    )


def test_dependence_is_detected_unlike_by_naive_bayes():
    rng = np.random.default_rng(0)
    first = rng.integers(0, 2, 400)
    y = rng.integers(0, 2, 400)
    codes = np.stack([first, first ^ y], axis=1)
    assert DependencyTree().fit(codes, y).score(codes, y) == 1
    assert NaiveBayes().fit(codes, y).score(codes, y) < 0.65


def test_one_variable_is_naive_bayes():
    X, y = np.array([[0], [1], [2], [2]]), [0, 0, 1, 1]
    np.testing.assert_allclose(
        DependencyTree().fit(X, y).predict_proba(X), NaiveBayes().fit(X, y).predict_proba(X)
    )


def test_wide_codes_do_not_need_wide_tables():
    # A full table of each pair would take 16 x 70000^2 x 8 bytes.
    rng = np.random.default_rng(1)
    X = rng.integers(0, 70_000, (100, 16))
    X[:, 9] = X[:, 4]
    model = DependencyTree(n_values=70_000).fit(X, np.arange(100) % 2)
    assert model.parents_.shape == (2, 16)
    assert model.score(X, np.arange(100) % 2) == 1


@pytest.mark.parametrize(
    ("settings_", "message"),
    [
        ({"alpha": 0}, "alpha=0"),
        ({"root": 2}, "root=2 is not a variable: use 0 to 1"),
        ({"root": -1}, "root=-1"),
        ({"n_values": 3}, "code 4 of sample 1"),
        ({"prior": "none"}, "prior=none: it must be"),
    ],
)
def test_invalid_settings(settings_, message):
    with pytest.raises(PlacecatError, match=message):
        DependencyTree(**settings_).fit([[0, 1], [4, 0]], ["a", "b"])


def test_conventions():
    model = DependencyTree(root=1, alpha=0.5)
    assert clone(model).get_params() == {"alpha": 0.5, "n_values": None, "prior": "uniform", "root": 1}
    assert repr(model) == "DependencyTree(alpha=0.5, root=1)"
    with pytest.raises(NotFittedError):
        model.predict([[0, 0]])
    X = linked_codes(30, 3, 4, 0)
    assert model.fit(X, np.arange(30) % 2) is model
    assert model.classes_.tolist() == [0, 1]
    assert model.n_features_in_ == 3
