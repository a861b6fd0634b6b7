from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.evaluation.quality import home_quality
from placecat.evaluation.stays import Stay, find_stays, stay_accuracy, stays_by_class

CLASSES = 3
frames = st.lists(st.tuples(st.integers(-1, CLASSES - 1), st.integers(0, CLASSES - 1), st.booleans()))


def parts_of(cuts):
    """Return the slices between cuts."""
    starts = [i for i, cut in enumerate(cuts) if cut or not i]
    return [slice(start, stop) for start, stop in pairwise([*starts, len(cuts)])]


def by_hand(truth, decision, cuts):
    """Find and count the stays in a loop over frames."""
    stays, last = [], None
    for i, place in enumerate(truth):
        if place < 0:
            last = None
        elif last == place and not cuts[i]:
            stays[-1][1].append(i)
        else:
            stays.append((place, [i]))
            last = place
    counts = np.zeros((CLASSES, 2), int)
    for place, own in stays:
        votes = [[decision[i] for i in own].count(other) for other in range(CLASSES)]
        most = [other for other in range(CLASSES) if votes[other] == max(votes)]
        counts[place] += 1, most == [place]
    return [(place, own[0], own[-1] + 1) for place, own in stays], counts


@given(frames)
def test_stays_equal_a_loop_over_frames(rows):
    truth, decision, cuts = ([row[k] for row in rows] for k in range(3))
    stays, counts = by_hand(truth, decision, cuts)
    assert find_stays(truth, parts_of(cuts)) == stays
    np.testing.assert_array_equal(stays_by_class(truth, decision, parts_of(cuts), CLASSES), counts)


@given(frames)
def test_stays_cover_each_labelled_frame_once(rows):
    truth, _, cuts = ([row[k] for row in rows] for k in range(3))
    covered = [i for stay in find_stays(truth, parts_of(cuts)) for i in range(stay.start, stay.stop)]
    assert covered == [i for i, place in enumerate(truth) if place >= 0]


def test_unlabelled_frames_and_new_sequences_end_a_stay():
    truth = [0, 0, -1, 0, 0, 1, 1]
    assert find_stays(truth, [slice(0, 7)]) == [Stay(0, 0, 2), Stay(0, 3, 5), Stay(1, 5, 7)]
    assert find_stays(truth, [slice(0, 1), slice(1, 7)])[:2] == [Stay(0, 0, 1), Stay(0, 1, 2)]


@pytest.mark.parametrize(
    ("decision", "right"),
    [([0, 0, 1, 2], 1), ([0, 1, 1, 2], 0), ([0, 0, 1, 1], 0), ([1, 1, 1, 0], 0), ([0, 1, 2, 0], 1)],
)
def test_stays_are_named_by_plurality_and_ties_are_wrong(decision, right):
    counts = stays_by_class([0] * 4, decision, [slice(0, 4)], CLASSES)
    assert counts.tolist() == [[1, right], [0, 0], [0, 0]]


@given(frames, st.permutations(range(CLASSES)))
def test_the_order_of_the_classes_does_not_matter(rows, order):
    truth, decision, cuts = ([row[k] for row in rows] for k in range(3))
    renamed = [[order[place] if place >= 0 else -1 for place in own] for own in (truth, decision)]
    counts = stays_by_class(truth, decision, parts_of(cuts), CLASSES)
    np.testing.assert_array_equal(stays_by_class(*renamed, parts_of(cuts), CLASSES)[order], counts)


def test_places_have_equal_weight_in_the_stay_accuracy():
    assert stay_accuracy(np.array([[4, 1], [0, 0], [1, 1]])) == 62.5
    assert np.isnan(stay_accuracy(np.zeros((2, 2), int)))


def test_home_quality():
    proba = np.array([[0.8, 0.2]] * 3 + [[0.4, 0.6]] * 2)
    found = home_quality([0, 0, 1, 1, -1], proba, [slice(0, 5)], bins=10, smallest=1e-15)
    assert found.log_loss == pytest.approx(-(np.log(0.8) + (np.log(0.2) + np.log(0.6)) / 2) / 2)
    # The bin (0.7, 0.8] contains three of the four frames, and two are correct. The bin (0.5, 0.6] contains
    # one frame, which is correct.
    assert found.calibration_error == pytest.approx(100 * (0.75 * (0.8 - 2 / 3) + 0.25 * 0.4))
    # The second stay is a tie.
    assert (found.stays, found.stays_right, found.stay_accuracy) == (2, 1, 50.0)
