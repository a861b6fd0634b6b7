import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.errors import PlacecatError
from placecat.training import protocol
from placecat.training.protocol import select_frames, training_homes

HOMES = ["A", "B", "C", "D", "E", "F"]


def folds(homes, scheme):
    return [training_homes(homes, scheme, [home]) for home in homes]


def test_551_trains_cues_and_integration_on_the_same_five_homes():
    assert folds(HOMES, "5-5-1")[2] == (("A", "B", "D", "E", "F"),) * 2


def test_451_withholds_one_home_from_the_cues_in_rotation():
    kept = [set(integration) - set(cues) for cues, integration in folds(HOMES, "4-5-1")]
    assert kept == [{"B"}, {"C"}, {"D"}, {"E"}, {"F"}, {"A"}]


@given(st.integers(4, 9), st.sampled_from(["5-5-1", "4-5-1"]))
def test_the_test_home_is_never_a_training_home(count, scheme):
    names = [f"h{number}" for number in range(count)]
    for name, (cues, integration) in zip(names, folds(names, scheme), strict=True):
        assert name not in {*cues, *integration}


@pytest.mark.parametrize(("tested", "numbers"), [("C", [2]), (["F", "A"], [0, 5]), ("all", range(6))])
def test_tested_homes_keep_their_order(tested, numbers):
    assert protocol.tested_homes(HOMES, tested) == tuple(HOMES[number] for number in numbers)


def test_an_unknown_test_home_is_rejected():
    message = "there is no home 'Home1' in dataset.homes .available: A, B, C, D, E, F; or all"
    with pytest.raises(PlacecatError, match=message):
        protocol.tested_homes(HOMES, ["A", "Home1"])


@pytest.mark.parametrize(
    ("homes", "scheme", "message"),
    [
        (["A", "B"], "5-5-1", "needs at least 3 homes, but dataset.homes has 2"),
        (["A", "B", "C"], "4-5-1", "needs at least 4 homes"),
        (HOMES, "6-6-6", "scheme '6-6-6' is unknown"),
    ],
)
def test_invalid_protocols_are_rejected(homes, scheme, message):
    with pytest.raises(PlacecatError, match=message):
        folds(homes, scheme)


@pytest.mark.parametrize("scheme", ["5-5-1", "4-5-1"])
def test_left_out_homes_train_nothing(scheme):
    cues, integration = training_homes(HOMES, scheme, ["F", "A"])
    assert integration == ("B", "C", "D", "E")
    assert set(integration) - set(cues) == ({"B"} if scheme == "4-5-1" else set())
    assert training_homes(HOMES, scheme)[1] == tuple(HOMES)


def test_leaving_out_too_many_homes_is_rejected():
    with pytest.raises(PlacecatError, match="at least 7 homes to leave 5 out"):
        training_homes(HOMES, "5-5-1", HOMES[:5])
    with pytest.raises(PlacecatError, match="no home 'G' to leave out: use one of A, B, C, D, E, F"):
        training_homes(HOMES, "5-5-1", ["G"])


def test_the_step_counts_unlabelled_frames_but_does_not_select_them():
    labels = np.array([0, 1, 1, -1, 1, 1, 2, 2], dtype=np.int16)
    assert select_frames(labels, offset=0, step=3).tolist() == [0, 6]
    assert select_frames(labels, offset=1, step=3).tolist() == [1, 4, 7]


@given(st.lists(st.integers(-1, 4), max_size=60), st.integers(2, 5))
def test_selections_with_different_offsets_never_share_a_frame(labels, step):
    array = np.array(labels, dtype=np.int16)
    parts = [select_frames(array, offset=offset, step=step) for offset in range(step)]
    together = np.concatenate(parts)
    assert sorted(together.tolist()) == np.flatnonzero(array >= 0).tolist()


def test_offset_must_be_below_step():
    with pytest.raises(PlacecatError, match="offset is 3 and step is 3"):
        select_frames(np.zeros(4, np.int16), offset=3, step=3)
