from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from number_of_examples import examples
from placecat.fusion.hmm import (
    ForwardFilter,
    emission_matrix,
    likelihoods,
    transition_matrix,
)


def forward_filter(likelihood, transition):
    """Filter a complete sequence."""
    forwards = ForwardFilter(transition)
    return np.array([forwards.step(row) for row in likelihood]).reshape(likelihood.shape)


def random_rows(rng, shape):
    rows = rng.random(shape) + 0.05
    return rows / rows.sum(axis=-1, keepdims=True)


def sum_over_paths(likelihood, transition, initial):
    """Compute p(l_t | o_1..t) from its definition, as a sum over all paths of places."""
    frames, n = likelihood.shape
    result = np.zeros((frames, n))
    for t in range(frames):
        for path in product(range(n), repeat=t + 1):
            p = initial[path[0]] * likelihood[0, path[0]]
            for step in range(1, t + 1):
                p *= transition[path[step - 1], path[step]] * likelihood[step, path[step]]
            result[t, path[-1]] += p
    return result / result.sum(axis=1, keepdims=True)


@pytest.mark.parametrize("seed", range(3))
def test_filter_equals_the_sum_over_all_paths(seed):
    rng = np.random.default_rng(seed)
    likelihood, transition = rng.random((6, 3)) + 0.01, random_rows(rng, (3, 3))
    uniform = sum_over_paths(likelihood, transition, np.full(3, 1 / 3))
    np.testing.assert_allclose(forward_filter(likelihood, transition), uniform, rtol=1e-12)


@settings(max_examples=examples(30))
@given(st.integers(0, 10_000), st.integers(2, 30), st.integers(1, 29))
def test_filter_is_causal_and_normalised(seed, frames, cut):
    rng = np.random.default_rng(seed)
    likelihood, transition = rng.random((frames, 4)) + 1e-3, random_rows(rng, (4, 4))
    whole = forward_filter(likelihood, transition)
    np.testing.assert_allclose(whole.sum(axis=1), 1.0)
    np.testing.assert_array_equal(forward_filter(likelihood[:cut], transition), whole[:cut])


def test_frame_by_frame_equals_the_complete_sequence():
    """The results are bitwise identical to each other and to the plain recursion of equation (13)."""
    rng = np.random.default_rng(7)
    proba, transition = random_rows(rng, (200, 5)), random_rows(rng, (5, 5))
    emission = random_rows(rng, (5, 5))
    for evidence in ("hard", "soft"):
        likelihood = likelihoods(proba, emission, evidence=evidence)
        whole = forward_filter(likelihood, transition)
        forwards = ForwardFilter(transition)
        predicted = np.full(5, 1 / 5)
        for t in range(200):
            alone = likelihoods(proba[t : t + 1], emission, evidence=evidence)
            np.testing.assert_array_equal(alone[0], likelihood[t])
            np.testing.assert_array_equal(forwards.step(alone[0]), whole[t])
            joint = likelihood[t] * predicted
            np.testing.assert_array_equal(joint / joint.sum(), whole[t])
            predicted = whole[t] @ transition


def test_filter_without_frames():
    assert forward_filter(np.zeros((0, 3)), np.eye(3)).shape == (0, 3)


def test_filter_overrules_a_single_odd_frame():
    transition = np.array([[0.99, 0.01], [0.01, 0.99]])
    likelihood = np.tile([0.7, 0.3], (9, 1))
    likelihood[5] = [0.3, 0.7]
    assert (forward_filter(likelihood, transition)[:, 0] > 0.5).all()


def test_transitions_skip_unlabelled_frames():
    walk = np.array([0, 0, -1, -1, 1, 1, 1, -1, 0], dtype=np.int16)
    counts = np.array([[1, 1], [1, 2]]) + 1.0
    expected = counts / counts.sum(axis=1, keepdims=True)
    np.testing.assert_allclose(transition_matrix([walk], 2, smoothing=1.0), expected)


def test_transitions_do_not_join_sequences():
    parts = [np.array([0, 0], np.int16), np.array([1, 1], np.int16)]
    matrix = transition_matrix(parts, 2, smoothing=1e-9)
    assert matrix[0, 1] < 1e-6


def test_emission_counts_decisions_or_distributions():
    truth = np.array([0, 0, 1], np.int16)
    proba = np.array([[0.8, 0.2], [0.4, 0.6], [0.1, 0.9]])
    hard = emission_matrix(truth, proba, 2, reliability="hard", smoothing=1.0)
    np.testing.assert_allclose(hard, [[2 / 4, 2 / 4], [1 / 3, 2 / 3]])
    soft = emission_matrix(truth, proba, 2, reliability="soft", smoothing=1.0)
    np.testing.assert_allclose(soft, [[2.2 / 4, 1.8 / 4], [1.1 / 3, 1.9 / 3]])


def test_likelihoods_for_hard_and_soft_evidence():
    emission = np.array([[0.9, 0.1], [0.2, 0.8]])
    proba = np.array([[0.7, 0.3]])
    np.testing.assert_allclose(likelihoods(proba, emission, evidence="hard"), [[0.9, 0.2]])
    np.testing.assert_allclose(likelihoods(proba, emission, evidence="soft"), [[0.66, 0.38]])


def rarely_left(rng, n):
    """Draw an embeddable transition matrix, which is the exponential of a rate matrix."""
    rates = rng.random((n, n)) * 0.05 * (1 - np.eye(n))
    return expm(rates - np.diag(rates.sum(axis=1)))


def filtered(likelihood, transition, **options):
    forwards = ForwardFilter(transition)
    return np.array([forwards.step(row, **options) for row in likelihood])


@settings(max_examples=examples(30), deadline=None)
@given(st.integers(0, 10_000), st.integers(2, 10))
def test_several_steps_equal_single_steps_without_evidence(seed, times):
    """Skipped frames carry no information, so their likelihood is the same for every place."""
    rng = np.random.default_rng(seed)
    likelihood, transition = rng.random((8, 4)) + 1e-3, rarely_left(rng, 4)
    whole = np.ones(((len(likelihood) - 1) * times + 1, 4))
    whole[::times] = likelihood
    expected = forward_filter(whole, transition)[::times]
    np.testing.assert_allclose(filtered(likelihood, transition, steps=times), expected, atol=1e-9)


@settings(max_examples=examples(30), deadline=None)
@given(st.integers(0, 10_000), st.integers(2, 10))
def test_evidence_adds_up_at_higher_frame_rates(seed, times):
    """If places never change, `times` short frames of a view are as much evidence as one long frame."""
    rng = np.random.default_rng(seed)
    likelihood = rng.random((8, 4)) + 1e-3
    slow, repeated = forward_filter(likelihood, np.eye(4)), np.repeat(likelihood, times, axis=0)
    fast = filtered(repeated, np.eye(4), steps=1 / times, weight=1 / times)
    np.testing.assert_allclose(fast[times - 1 :: times], slow, atol=1e-12)
    np.testing.assert_allclose(
        filtered(likelihood, np.eye(4), steps=times, weight=times),
        forward_filter(repeated, np.eye(4))[times - 1 :: times],
        atol=1e-12,
    )


def test_a_very_large_weight_still_gives_a_distribution():
    likelihood = np.array([1e-3, 2e-3, 1e-4])
    result = ForwardFilter(np.eye(3)).step(likelihood, weight=1e4)
    np.testing.assert_allclose(result, [0, 1, 0], atol=1e-12)
