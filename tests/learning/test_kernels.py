import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.metrics.pairwise import rbf_kernel
from threadpoolctl import threadpool_info, threadpool_limits

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning import kernels
from placecat.learning.checks import check_samples
from placecat.learning.kernels import KernelExpansion, rbf_gram
from placecat.learning.single_thread import single_blas_thread


def naive(X, Y, gamma):
    return np.array(
        [[np.exp(-gamma * sum((a - b) ** 2 for a, b in zip(x, y, strict=True))) for y in Y] for x in X]
    )


def test_gram_of_literal_points():
    gram = rbf_gram([[0.0, 0.0], [3.0, 4.0], [0.0, 0.0]], gamma=np.log(2) / 25)
    assert gram.dtype == np.float32
    np.testing.assert_allclose(gram, [[1, 0.5, 1], [0.5, 1, 0.5], [1, 0.5, 1]], atol=1e-6)


@settings(max_examples=examples(25), deadline=None)
@given(n=st.integers(1, 40), m=st.integers(1, 30), d=st.integers(1, 6), seed=st.integers(0, 999))
def test_kernels_against_naive_loop(n, m, d, seed):
    rng = np.random.default_rng(seed)
    X, Y = rng.normal(3.0, 1.0, (n, d)), rng.normal(3.0, 1.0, (m, d))
    np.testing.assert_allclose(rbf_gram(X, 0.7), naive(X, X, 0.7), atol=5e-6)
    kernels_alone = KernelExpansion(Y.astype(np.float32), np.eye(m), np.zeros(m), 0.7)
    np.testing.assert_allclose(kernels_alone.decisions(X.astype(np.float32)), naive(X, Y, 0.7), atol=5e-6)


def test_gram_across_tiles_is_symmetric_and_independent_of_threads(monkeypatch):
    monkeypatch.setattr(kernels, "ROW_TILE", 16)
    monkeypatch.setattr(kernels, "COLUMN_TILE", 24)
    X = np.random.default_rng(0).normal(size=(101, 7)).astype(np.float32)
    one, three = rbf_gram(X, 0.3, n_jobs=1), rbf_gram(X, 0.3, n_jobs=3)
    assert one.tobytes() == three.tobytes()
    assert np.array_equal(one, one.T)
    assert np.array_equal(one.diagonal(), np.ones(101))
    np.testing.assert_allclose(one, rbf_kernel(X, gamma=0.3), atol=2e-6)


def test_float64_gram_has_the_float32_values():
    X = np.random.default_rng(1).normal(size=(20, 3))
    double = rbf_gram(X, 1.0, dtype=np.float64)
    assert double.dtype == np.float64
    assert np.array_equal(double, rbf_gram(X, 1.0).astype(np.float64))


def test_distant_origin_does_not_cancel():
    X = np.random.default_rng(2).integers(0, 3, (15, 4)).astype(np.float64)
    np.testing.assert_allclose(rbf_gram(X + 4096.0, 0.5), rbf_kernel(X, gamma=0.5), atol=1e-5)


def test_expansion_against_sum(monkeypatch):
    monkeypatch.setattr(kernels, "PREDICTION_ROWS", 5)
    monkeypatch.setattr(kernels, "PREDICTION_COLUMNS", 4)
    rng = np.random.default_rng(3)
    V, coef, X = (
        rng.normal(size=(11, 3)).astype(np.float32),
        rng.normal(size=(11, 2)),
        rng.normal(size=(13, 3)).astype(np.float32),
    )
    expansion = KernelExpansion(V, coef, np.array([0.5, -1.0]), 0.4)
    np.testing.assert_allclose(expansion.decisions(X), naive(X, V, 0.4) @ coef + [0.5, -1.0], atol=1e-5)


def test_expansion_without_vectors_is_its_intercept():
    empty = KernelExpansion(np.empty((0, 2), np.float32), np.empty((0, 1)), np.array([0.25]), 1.0)
    assert empty.decisions(np.ones((1, 2), np.float32)).tolist() == [[0.25]]


def test_blas_limit_is_restored_after_nested_use():
    def threads():
        return {info["num_threads"] for info in threadpool_info() if info["user_api"] == "blas"}

    with threadpool_limits(limits=2, user_api="blas"):
        # Some libraries never use more than one thread.
        before = threads()
        assert 2 in before
        with single_blas_thread(), single_blas_thread():
            assert threads() == {1}
        assert threads() == before


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: check_samples([1.0, 2.0]), "X: Expected 2D array, got 1D array"),
        (lambda: check_samples([[1.0], [np.nan]]), "first in row 1"),
        (lambda: check_samples(np.ones((2, 2), np.float32) / [[1], [0]]), "first in row 1"),
    ],
)
def test_messages(call, message):
    with pytest.raises(PlacecatError, match=message):
        call()
