import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from number_of_examples import examples
from placecat import schema
from placecat.errors import PlacecatError
from placecat.fusion.information_filter import dropped, hold, threshold_of


def by_hand(proba, information, threshold, sequences):
    """Compute the same result in a loop over the frames."""
    held = proba.copy()
    for part in sequences:
        last = None
        for t in range(part.start, part.stop):
            if information[t] >= threshold:
                last = proba[t]
            elif last is not None:
                held[t] = last
    return held


@st.composite
def walks(draw):
    frames = draw(st.integers(0, 40))
    levels = st.sampled_from([0.0, 0.05, 0.09766, 0.1, 0.2, float("nan")])
    information = draw(hnp.arrays(np.float32, frames, elements=levels.map(lambda x: float(np.float32(x)))))
    cuts = sorted(draw(st.sets(st.integers(1, max(1, frames - 1)), max_size=4)) if frames > 1 else [])
    edges = [0, *cuts, frames]
    parts = [slice(a, b) for a, b in itertools.pairwise(edges) if b > a]
    return np.random.default_rng(frames).dirichlet(np.ones(5), frames), information, parts


@given(walks(), st.sampled_from([0.0, 0.09766, 0.13021, 9.0]))
@settings(max_examples=examples(150), deadline=None)
def test_equals_a_loop(walk, threshold):
    proba, information, parts = walk
    before = proba.copy()
    # Both compare the measures with the threshold in float32.
    held = hold(proba, information, threshold=threshold, sequences=parts)
    np.testing.assert_array_equal(held, by_hand(proba, information, threshold, parts))
    np.testing.assert_array_equal(proba, before)


@given(walks(), st.integers(0, 40))
@settings(max_examples=examples(80), deadline=None)
def test_is_causal(walk, end):
    proba, information, parts = walk
    end = min(end, len(proba))
    early = [slice(part.start, min(part.stop, end)) for part in parts if part.start < end]
    held = hold(proba, information, threshold=0.09766, sequences=parts)
    first = hold(proba[:end], information[:end], threshold=0.09766, sequences=early)
    np.testing.assert_array_equal(held[:end], first)


def test_a_frame_below_the_threshold_repeats_the_last_accepted_one_of_its_sequence():
    proba = np.eye(7)
    information = np.array([0.05, 0.2, 0.05, 0.0, 0.1, 0.0, 0.3])
    held = hold(proba, information, threshold=0.1, sequences=[slice(0, 5), slice(5, 7)])
    # Frames 0 and 5 have nothing to repeat, and frame 4 reaches the threshold exactly.
    assert np.argmax(held, axis=1).tolist() == [0, 1, 1, 1, 4, 5, 6]


def test_a_threshold_of_zero_changes_nothing():
    proba = np.random.default_rng(0).dirichlet(np.ones(3), 9)
    np.testing.assert_array_equal(hold(proba, np.zeros(9), threshold=0.0, sequences=[slice(0, 9)]), proba)


@given(hnp.arrays(np.float32, st.integers(1, 60), elements=st.floats(0, 1, width=32)), st.floats(0.01, 0.99))
def test_a_share_of_the_frames_lies_below_its_threshold(information, share):
    threshold = threshold_of(share, information)
    low = (information < np.float32(threshold)).mean()
    assert low <= share
    # This is the highest possible threshold. A higher one would drop more than the share.
    assert (information <= np.float32(threshold)).mean() > share - 1 / len(information)


def test_the_share_is_exact_without_ties():
    information = np.random.default_rng(0).permutation(200).astype(np.float32)
    kept = information >= threshold_of(0.1, information)
    assert kept.sum() == 180


def test_dropped_frames_are_counted_with_and_without_labels():
    information = np.array([0.05, 0.2, 0.05, 0.1, np.nan], np.float32)
    counted = dropped(information, np.array([0, 1, -1, 2, 0], np.int16), 0.1)
    assert counted == {"threshold": 0.1, "frames": 5, "dropped": 3, "labelled": 4, "dropped_labelled": 2}


@pytest.mark.parametrize(
    ("threshold", "share", "message"),
    [
        (None, None, "needs either a threshold or a share"),
        (0.1, 0.1, "needs either a threshold or a share"),
        (-0.1, None, "threshold=-0.1: it must be greater than or equal to 0"),
        (float("nan"), None, "threshold=nan: it must be a finite number"),
        (None, 0.0, "share=0.0: it must be greater than 0"),
        (None, 1.0, "share=1.0: it must be less than 1"),
        (None, "a tenth", "share=a tenth: it must be a valid number"),
        (True, None, "threshold=True: it must be a valid number"),
    ],
)
def test_a_filter_needs_either_a_threshold_or_a_share(threshold, share, message):
    def check(threshold, share):
        own = {"threshold": threshold, "share": share, "cues": [], "systems": []}
        schema.check({"filters": {"x": own}})

    with pytest.raises(PlacecatError, match=f"filters.x.*{message}"):
        check(threshold, share)
    check(0.0, None)
    check(None, 0.1)
