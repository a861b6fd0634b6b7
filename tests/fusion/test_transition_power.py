import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from number_of_examples import examples
from placecat.fusion.transition_power import TransitionPower, generator


def rows_of(rng, n, stay):
    """Draw a stochastic matrix. A larger `stay` makes changes of place less likely."""
    rows = rng.random((n, n)) + stay * np.eye(n)
    return rows / rows.sum(axis=1, keepdims=True)


def rates_of(rng, n):
    """Draw a generator directly."""
    rates = rng.random((n, n)) * (1 - np.eye(n)) * rng.choice([0.01, 0.1, 1.0])
    return rates - np.diag(rates.sum(axis=1))


matrices = st.builds(
    lambda seed, n, stay: rows_of(np.random.default_rng(seed), n, stay),
    st.integers(0, 10_000),
    st.integers(1, 6),
    st.sampled_from([0.0, 0.5, 2.0, 50.0, 1000.0]),
)
exponents = st.floats(0.0, 50.0)


@given(matrices, exponents)
def test_rows_are_distributions_for_any_matrix(matrix, exponent):
    power = TransitionPower(matrix)(exponent)
    assert (power >= 0).all()
    np.testing.assert_allclose(power.sum(axis=1), 1.0, rtol=1e-12)


@given(matrices, exponents, exponents)
def test_chapman_kolmogorov(matrix, first, second):
    """A step of x and a step of y equal a step of x + y. An exponent of 1 is a special case."""
    power = TransitionPower(matrix)
    if 1.0 in (first, second, first + second):
        return
    np.testing.assert_allclose(power(first) @ power(second), power(first + second), atol=1e-9)


@given(matrices)
def test_exponent_of_1_returns_the_exact_matrix(matrix):
    power = TransitionPower(matrix)
    np.testing.assert_array_equal(power(1.0), matrix)
    power(0.5)
    np.testing.assert_array_equal(power(1.0), matrix)
    np.testing.assert_allclose(power(0.0), np.eye(len(matrix)), atol=1e-12)


@given(st.integers(0, 10_000), st.integers(2, 6), exponents)
def test_an_embeddable_matrix_has_exact_powers(seed, n, exponent):
    rates = rates_of(np.random.default_rng(seed), n)
    np.testing.assert_allclose(TransitionPower(expm(rates))(exponent), expm(exponent * rates), atol=1e-7)


@given(st.integers(0, 10_000), st.integers(2, 6), st.integers(2, 12))
def test_integer_powers_are_products(seed, n, times):
    matrix = expm(rates_of(np.random.default_rng(seed), n))
    power = TransitionPower(matrix)
    np.testing.assert_allclose(power(times), np.linalg.matrix_power(matrix, times), atol=1e-8)
    root = power(1 / times)
    np.testing.assert_allclose(np.linalg.matrix_power(root, times), matrix, atol=1e-8)


@given(st.floats(0.001, 0.49), st.floats(0.001, 0.49), exponents)
def test_two_places_in_closed_form(a, b, exponent):
    matrix = np.array([[1 - a, a], [b, 1 - b]])
    rest = np.array([[b, a], [b, a]]) / (a + b)
    expected = rest + (1 - a - b) ** exponent * (np.eye(2) - rest)
    np.testing.assert_allclose(TransitionPower(matrix)(exponent), expected, atol=1e-9)


def test_negative_rates_of_the_logarithm_become_zero():
    """Place 2 can be reached from 0 through 1, but not in one step. No continuous-time chain does that."""
    matrix = np.array([[0.8, 0.2, 0.0], [0.0, 0.8, 0.2], [0.2, 0.0, 0.8]])
    rates = generator(matrix)
    assert rates[0, 2] == 0.0
    np.testing.assert_allclose(rates.sum(axis=1), 0.0, atol=1e-15)
    # The logarithm of 0.8 I + 0.2 S, where S is a cyclic shift, is known from the Fourier transform.
    waves = np.exp(2j * np.pi * np.arange(3) / 3)
    spectrum = np.log(0.8 + 0.2 * waves)
    logarithm = [np.mean(spectrum * waves ** (-k)).real for k in range(3)]
    assert logarithm[2] < 0
    np.testing.assert_allclose(rates[0], [-logarithm[1], logarithm[1], 0.0], atol=1e-12)


@pytest.mark.parametrize(
    "matrix",
    [
        np.array([[0.1, 0.9], [0.9, 0.1]]),
        np.array([[0.5, 0.5], [0.5, 0.5]]),
        np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.5, 0.0]]),
    ],
    ids=["a negative eigenvalue", "an eigenvalue of 0", "complex ones"],
)
def test_matrices_that_are_not_embeddable(matrix):
    rates = generator(matrix)
    np.testing.assert_allclose(rates.sum(axis=1), 0.0, atol=1e-12)
    assert (rates[~np.eye(len(matrix), dtype=bool)] >= 0).all()
    if np.isreal(np.linalg.eigvals(matrix)).all():
        # The number of jumps follows a Poisson distribution, and each jump follows the matrix.
        jumps, weight, expected = np.eye(len(matrix)), np.exp(-0.7), np.zeros(matrix.shape)
        for number in range(30):
            expected += weight * jumps
            jumps, weight = jumps @ matrix, weight * 0.7 / (number + 1)
        np.testing.assert_allclose(TransitionPower(matrix)(0.7), expected, atol=1e-12)


@settings(max_examples=examples(30), deadline=None)
@given(matrices)
def test_large_powers_reach_the_stationary_distribution(matrix):
    power = TransitionPower(matrix)(1e7)
    np.testing.assert_allclose(power, np.broadcast_to(power[0], power.shape), atol=1e-6)
    np.testing.assert_allclose(power @ TransitionPower(matrix)(2.5), power, atol=1e-6)
