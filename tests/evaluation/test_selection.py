import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.evaluation.selection import choose_threshold, decided, select, select_unseen

CLASSES = 3
# There are only a few different confidences, so many are equal.
frames = st.lists(
    st.tuples(st.integers(-1, CLASSES - 1), st.integers(0, CLASSES - 1), st.integers(4, 9)), min_size=1
).filter(lambda home: any(truth >= 0 for truth, _, _ in home))
homes = st.lists(frames, min_size=2, max_size=4)


def made(home):
    """Make the decisions in a home from true classes, decided classes and confidences in tenths."""
    truth, places, tenths = map(np.array, zip(*home, strict=True))
    confidence = tenths / 10
    proba = np.repeat((1 - confidence)[:, None] / 2, CLASSES, axis=1)
    proba[np.arange(len(places)), places] = confidence
    return decided(truth, proba), truth, places


def by_hand(home, threshold):
    """Sum the weights of the remaining decisions, and of the wrong ones among them, in a loop over frames."""
    scored = [one for one in home if one[0] >= 0]
    counts = {place: sum(truth == place for truth, _, _ in scored) for place, _, _ in scored}
    left = wrong = 0.0
    for truth, place, tenths in scored:
        if tenths / 10 >= threshold:
            left += 1 / counts[truth] / len(counts)
            wrong += (place != truth) / counts[truth] / len(counts)
    return left, wrong


def risk_by_hand(all_homes, threshold):
    left, wrong = np.sum([by_hand(home, threshold) for home in all_homes], axis=0)
    return wrong / left if left else math.nan


@given(homes, st.sampled_from([0.01, 0.1, 0.3, 0.5, 0.9]))
def test_threshold_is_the_lowest_with_an_acceptable_risk(all_homes, risk):
    threshold = choose_threshold([made(home)[0] for home in all_homes], risk)
    there = {tenths / 10 for home in all_homes for truth, _, tenths in home if truth >= 0}
    good = [one for one in there if risk_by_hand(all_homes, one) <= risk + 1e-9]
    assert threshold == min(good, default=math.inf)


@given(homes, st.sampled_from([0.0, 0.45, 0.6, 0.8, math.inf]))
def test_coverage_and_risk_equal_a_loop_over_frames(all_homes, threshold):
    found = select([made(home)[0] for home in all_homes], [threshold] * len(all_homes))
    left, wrong = np.transpose([by_hand(home, threshold) for home in all_homes])
    assert found.coverage == pytest.approx(left.mean())
    if not left.any():
        assert math.isnan(found.risk) and math.isnan(found.worst)
        return
    assert found.risk == pytest.approx(wrong.sum() / left.sum())
    assert found.worst == pytest.approx(max(wrong[left > 0] / left[left > 0]))


@given(homes)
def test_risk_and_accuracy_sum_to_1_at_full_coverage(all_homes):
    judged = [made(home) for home in all_homes]
    found = select([one for one, _, _ in judged], [0.0] * len(judged))
    missing = [100 - home_accuracy(confusion_matrix(truth, places, CLASSES)) for _, truth, places in judged]
    assert found.coverage == pytest.approx(1)
    assert 100 * found.risk == pytest.approx(np.mean(missing))


def test_a_home_does_not_influence_its_own_threshold():
    sure = [(0, 0, 9)] * 4
    # In `odd`, the confident decisions are wrong. A threshold chosen on `odd` itself would exclude them.
    odd = [(0, 1, 8)] * 3 + [(0, 0, 5)]
    found = select_unseen({"sure": made(sure)[0], "odd": made(odd)[0]}, 0.3)
    # The threshold chosen on `odd` is infinite, because three of its four decisions are wrong. The threshold
    # chosen on `sure` is 0.9, and no decision in `odd` reaches it.
    assert found.coverage == 0 and math.isnan(found.risk)
    both = [(0, 0, 8)] * 3 + [(0, 1, 7)]
    found = select_unseen({"both": made(both)[0], "odd": made(odd)[0]}, 0.0)
    assert (found.coverage, found.risk, found.worst) == (0.375, 1.0, 1.0)
