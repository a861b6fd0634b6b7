import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.evaluation.probabilities import (
    balanced_weights,
    calibration_error,
    log_loss,
    pooled,
    reliability,
)

SMALLEST = 1e-15


def drawn(seed, frames=60, classes=4):
    """Draw labels, some of them -1, and distributions."""
    rng = np.random.default_rng(seed)
    truth = rng.integers(-1, classes, frames)
    truth[0] = 0
    return truth, rng.dirichlet(np.full(classes, 0.4), frames)


def error(truth, proba, bins=10):
    return calibration_error(reliability(truth, proba, bins=bins))


@pytest.mark.parametrize("seed", range(5))
def test_log_loss_agrees_with_scikit_learn(seed):
    from sklearn.metrics import log_loss as expected
    from sklearn.utils.class_weight import compute_sample_weight

    truth, proba = drawn(seed)
    scored = truth >= 0
    weights = compute_sample_weight("balanced", truth[scored])
    reference = expected(truth[scored], proba[scored], sample_weight=weights, labels=range(4))
    assert log_loss(truth, proba, smallest=np.finfo(float).eps) == pytest.approx(reference, rel=1e-12)


@given(st.integers(2, 9), st.lists(st.integers(-1, 1), min_size=1).filter(lambda one: max(one) >= 0))
def test_uniform_log_loss_is_the_log_of_the_number_of_places(classes, truth):
    proba = np.full((len(truth), classes), 1.0 / classes)
    assert log_loss(truth, proba, smallest=SMALLEST) == pytest.approx(np.log(classes))


def test_places_have_equal_weight_in_the_log_loss():
    proba = np.array([[0.5, 0.5]] * 9 + [[0.75, 0.25]])
    expected = (-np.log(0.5) - np.log(0.25)) / 2
    assert log_loss([0] * 9 + [1], proba, smallest=SMALLEST) == pytest.approx(expected)


def test_zero_is_replaced_by_the_smallest_probability():
    proba = np.array([[1.0, 0.0], [1.0, 0.0]])
    assert log_loss([0, 1], proba, smallest=1e-4) == pytest.approx(-np.log(1e-4) / 2)
    assert log_loss([0, 0], proba, smallest=1e-4) == 0.0


@given(st.integers(0, 1000), st.integers(1, 20))
def test_unlabelled_frames_and_frame_order_do_not_matter(seed, bins):
    truth, proba = drawn(seed)
    scored = truth >= 0
    shuffled = np.random.default_rng(seed).permutation(len(truth))
    for own in (scored, shuffled):
        assert log_loss(truth[own], proba[own], smallest=SMALLEST) == pytest.approx(
            log_loss(truth, proba, smallest=SMALLEST)
        )
        assert error(truth[own], proba[own], bins) == pytest.approx(error(truth, proba, bins))


@given(st.integers(0, 1000))
def test_repeating_the_frames_of_a_place_changes_nothing(seed):
    """All places have equal weight, regardless of their number of frames."""
    truth, proba = drawn(seed)
    own = np.concatenate([np.arange(len(truth)), np.flatnonzero(truth == 0)])
    assert log_loss(truth[own], proba[own], smallest=SMALLEST) == pytest.approx(
        log_loss(truth, proba, smallest=SMALLEST)
    )
    assert error(truth[own], proba[own]) == pytest.approx(error(truth, proba))


@given(st.lists(st.integers(-1, 3), max_size=40))
def test_balanced_weights_are_equal_for_all_places(truth):
    weights = balanced_weights(truth)
    there = {place for place in truth if place >= 0}
    for place in there:
        assert weights[np.array(truth) == place].sum() == pytest.approx(1 / len(there))
    assert weights[np.array(truth, int) < 0].sum() == 0.0


def test_calibration_error_computed_by_hand():
    """Kitchen has four frames with weight 1/8, and bedroom has one with weight 1/2."""
    proba = np.array([[0.7, 0.3], [0.7, 0.3], [0.3, 0.7], [0.9, 0.1], [0.9, 0.1]])
    truth = [0, 0, 0, 0, 1]
    diagram = reliability(truth, proba, bins=5)
    np.testing.assert_allclose(diagram.weight, [0, 0, 0, 3 / 8, 5 / 8])
    np.testing.assert_allclose(diagram.confidence[3:], [0.7, 0.9])
    # In the bin (0.6, 0.8], two of three decisions are correct. In (0.8, 1], a weight of 1/8 out of 5/8 is
    # correct.
    np.testing.assert_allclose(diagram.accuracy[3:], [2 / 3, 1 / 5])
    assert np.isnan(diagram.confidence[:3]).all() and np.isnan(diagram.accuracy[:3]).all()
    assert calibration_error(diagram) == pytest.approx(3 / 8 * (0.7 - 2 / 3) + 5 / 8 * (0.9 - 0.2))


@pytest.mark.parametrize("seed", range(5))
def test_calibration_error_agrees_with_a_loop_over_bins(seed):
    truth, proba = drawn(seed, frames=200)
    weights, total, bins = balanced_weights(truth), 0.0, 7
    for number in range(bins):
        inside = [
            frame
            for frame in range(len(truth))
            if truth[frame] >= 0 and number / bins < max(proba[frame]) <= (number + 1) / bins
        ]
        total += abs(
            sum(weights[f] * (float(np.argmax(proba[f]) == truth[f]) - max(proba[f])) for f in inside)
        )
    assert error(truth, proba, bins) == pytest.approx(total)


@given(st.integers(0, 1000), st.integers(1, 30))
def test_calibration_error_is_lowest_with_a_single_bin(seed, bins):
    truth, proba = drawn(seed)
    weights, right = balanced_weights(truth), proba.argmax(axis=1) == truth
    assert error(truth, proba, 1) == pytest.approx(abs(weights @ (right - proba.max(axis=1))))
    assert error(truth, proba, 1) - 1e-12 <= error(truth, proba, bins) <= 1


@given(st.integers(0, 1000))
def test_mean_confidence_lies_within_its_bin(seed):
    """Each confidence lies within its bin, which includes its upper end."""
    truth, proba = drawn(seed)
    diagram = reliability(truth, proba, bins=10)
    there = np.flatnonzero(diagram.weight)
    assert (diagram.confidence[there] > there / 10 - 1e-9).all()
    assert (diagram.confidence[there] <= (there + 1) / 10 + 1e-9).all()


def test_confidence_rounded_above_1_is_in_the_last_bin():
    proba = np.array([[1.0 + 1e-12, 0.0], [0.5, 0.5]])
    np.testing.assert_allclose(reliability([0, 0], proba, bins=10).weight[[4, 9]], [0.5, 0.5])


def test_homes_have_equal_weight_in_a_pooled_diagram():
    one = reliability([0], np.array([[0.9, 0.1]]), bins=2)
    other = reliability([1, 1, 0, 0], np.array([[0.7, 0.3]] * 4), bins=2)
    both = pooled([one, other])
    np.testing.assert_allclose(both.weight, [0, 1])
    np.testing.assert_allclose([both.confidence[1], both.accuracy[1]], [0.8, 0.75])
    assert np.isnan(both.confidence[0])
    # One home is overconfident and the other is underconfident, so the joint error is below the mean error.
    errors = [calibration_error(diagram) for diagram in (one, other)]
    assert errors == pytest.approx([0.1, 0.2])
    assert calibration_error(both) == pytest.approx(0.05)


@given(st.lists(st.integers(0, 1000), min_size=1, max_size=4))
def test_pooled_error_is_at_most_the_mean_error(seeds):
    diagrams = [reliability(*drawn(seed), bins=8) for seed in seeds]
    mean = np.mean([calibration_error(one) for one in diagrams])
    assert calibration_error(pooled(diagrams)) <= mean + 1e-12
    assert pooled(diagrams).weight.sum() == pytest.approx(1)


def test_results_are_nan_without_labelled_frames():
    proba = np.array([[0.5, 0.5]])
    assert np.isnan(log_loss([-1], proba, smallest=SMALLEST))
    diagram = reliability([-1], proba, bins=3)
    assert diagram.weight.tolist() == [0, 0, 0] and np.isnan(calibration_error(diagram))
