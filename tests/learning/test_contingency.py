import itertools

import numpy as np
import pytest
from scipy.sparse.csgraph import minimum_spanning_tree
from sklearn.metrics import mutual_info_score

from placecat.learning.contingency import maximum_spanning_tree, mutual_information, value_counts


def linked_codes(n_samples: int, n_variables: int, n_values: int, seed: int) -> np.ndarray:
    """Return random codes. About half of the values of each variable are copied from an earlier variable."""
    rng = np.random.default_rng(seed)
    codes = rng.integers(0, n_values, (n_samples, n_variables))
    for variable in range(1, n_variables):
        copied = rng.random(n_samples) < 0.5
        codes[copied, variable] = codes[copied, rng.integers(variable)]
    return codes


# Binary variables, small tables (bincount), and tables with more cells than samples (sorting).
@pytest.mark.parametrize(("n_samples", "n_values"), [(200, 2), (500, 5), (60, 200), (40, 70_000)])
def test_mutual_information_against_scikit_learn(n_samples, n_values):
    codes = linked_codes(n_samples, 6, n_values, 0)
    expected = np.zeros((6, 6))
    for first, second in itertools.permutations(range(6), 2):
        expected[first, second] = mutual_info_score(codes[:, first], codes[:, second])
    found = mutual_information(codes, n_values)
    np.testing.assert_allclose(found, expected, atol=1e-12)
    np.testing.assert_array_equal(found, found.T)


def test_binary_and_narrow_codes_may_be_bytes():
    for n_values in (2, 200):
        codes = linked_codes(300, 4, n_values, 1)
        np.testing.assert_array_equal(
            mutual_information(codes.astype(np.uint8), n_values), mutual_information(codes, n_values)
        )


def test_mutual_information_of_one_sample_is_zero():
    for n_values in (2, 9):
        assert not mutual_information(np.array([[0, 1, 1]]), n_values).any()


@pytest.mark.parametrize("n_values", [2, 7])
def test_value_counts_against_a_loop(n_values):
    rng = np.random.default_rng(2)
    codes, labels = rng.integers(0, n_values, (50, 3)), rng.integers(0, 4, 50)
    expected = np.zeros((5, 3, n_values), int)
    for row, label in zip(codes, labels, strict=True):
        for variable, value in enumerate(row):
            expected[label, variable, value] += 1
    np.testing.assert_array_equal(value_counts(codes.astype(np.uint8), labels, 5, n_values), expected)


@pytest.mark.parametrize("root", [0, 3, 8])
def test_spanning_tree_against_scipy(root):
    rng = np.random.default_rng(root)
    weights = rng.random((9, 9))
    weights += weights.T
    parents = maximum_spanning_tree(weights, root)
    assert parents.dtype == np.int32
    assert np.flatnonzero(parents < 0).tolist() == [root]
    children = np.flatnonzero(parents >= 0)
    assert weights[children, parents[children]].sum() == pytest.approx(-minimum_spanning_tree(-weights).sum())
    for child in children:
        path = [child]
        while parents[path[-1]] >= 0:
            path.append(parents[path[-1]])
            assert len(path) <= 9
        assert path[-1] == root


def test_spanning_tree_ties():
    assert maximum_spanning_tree(np.zeros((4, 4)), 2).tolist() == [2, 2, -1, 2]
    chain = np.array([[0.0, 1, 1], [1, 0, 1], [1, 1, 0]])
    assert maximum_spanning_tree(chain, 0).tolist() == [-1, 0, 0]
    assert maximum_spanning_tree(np.zeros((1, 1)), 0).tolist() == [-1]
