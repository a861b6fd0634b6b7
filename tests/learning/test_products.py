import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from number_of_examples import examples
from placecat.learning import products
from placecat.learning.products import RowProducts, row_products, squared_lengths, sum_products


def alone(function, rows):
    return np.concatenate([function(rows[place : place + 1]) for place in range(len(rows))])


@settings(max_examples=examples(60), deadline=None)
@given(
    n=st.one_of(st.integers(1, 60), st.sampled_from([239, 240, 241, 529])),
    m=st.one_of(st.integers(1, 33), st.sampled_from([303, 304, 305, 620])),
    k=st.one_of(st.integers(1, 40), st.sampled_from([255, 321, 641, 1026])),
    dtype=st.sampled_from([np.float32, np.float64]),
    seed=st.integers(0, 99),
)
def test_a_row_does_not_depend_on_other_rows(n, m, k, dtype, seed):
    rng = np.random.default_rng(seed)
    left, right = rng.normal(size=(n, k)).astype(dtype), rng.normal(size=(m, k)).astype(dtype)
    found = row_products(left, right)
    assert found.dtype == dtype
    exact = left.astype(np.float64) @ right.T.astype(np.float64)
    scale = np.abs(left) @ np.abs(right).T
    assert (np.abs(found - exact) <= 4 * np.sqrt(k) * np.finfo(dtype).eps * scale).all()
    some = rng.permutation(n)[:40]
    assert np.array_equal(row_products(left[some], right), found[some])
    assert np.array_equal(alone(RowProducts(right), left[some]), found[some])
    lengths = squared_lengths(left)
    np.testing.assert_allclose(lengths, (left.astype(np.float64) ** 2).sum(axis=1), rtol=1e-12)
    assert np.array_equal(alone(squared_lengths, left[some]), lengths[some])


@pytest.mark.parametrize("lost", [(), (48,), (240, 12)])
def test_kernels_that_depend_on_the_row_position_are_detected(monkeypatch, lost):
    """If products of some sizes have a wrong bit in row 5, these sizes are not used."""
    genuine = products._multiply

    def off(block, tile):
        product = genuine(block, tile)
        if not lost or len(block) in lost:
            product[5:6] = np.nextafter(product[5:6], np.inf, dtype=product.dtype)
        return product

    monkeypatch.setattr(products, "_multiply", off)
    products._numbers_of_rows.cache_clear()
    try:
        rng = np.random.default_rng(0)
        left, right = rng.normal(size=(300, 20)), rng.normal(size=(7, 20))
        found = row_products(left, right)
        assert np.array_equal(alone(RowProducts(right), left), found)
        np.testing.assert_allclose(found, left @ right.T, rtol=1e-12, atol=1e-12)
    finally:
        products._numbers_of_rows.cache_clear()


def test_a_matrix_times_itself():
    """NumPy has a special routine for a matrix times its transpose."""
    square = np.random.default_rng(0).normal(size=(240, 50))
    assert np.array_equal(alone(RowProducts(square), square), row_products(square, square))


@pytest.mark.parametrize(("n", "m"), [(0, 3), (3, 0)])
def test_empty_matrices(n, m):
    assert row_products(np.ones((n, 4)), np.ones((m, 4), np.float32)).shape == (n, m)


@pytest.mark.parametrize("k", [1, 2, 11])
def test_sum_products(k):
    rng = np.random.default_rng(k)
    left, right = rng.normal(size=(301, k)), rng.normal(size=(5, k))
    found = sum_products(left, right)
    np.testing.assert_allclose(found, left @ right.T, rtol=1e-12, atol=1e-14)
    assert np.array_equal(alone(lambda rows: sum_products(rows, right), left), found)
