import numpy as np
import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from placecat.errors import PlacecatError
from placecat.results.measured import (
    MISSING_COLUMNS,
    NO_SEED,
    SCORE_COLUMNS,
    Measured,
    Results,
    from_scores,
    mean_and_spread,
    score_rows,
)

CLASSES = ("bedroom", "kitchen")
FIXED = Measured(("A", "B"), (NO_SEED,), CLASSES, np.array([[[[3, 1], [0, 4]], [[1, 1], [0, 0]]]]))
RANDOM = Measured(("A",), ("seed-0", "seed-1"), CLASSES, np.array([[[[3, 1], [0, 4]]], [[[1, 3], [4, 0]]]]))


def rebuilt(measured, others=()):
    rows = [row for name, one in measured.items() for row in score_rows(name, one)]
    scores = pd.DataFrame(rows, columns=SCORE_COLUMNS)
    return from_scores(scores, pd.DataFrame([], columns=MISSING_COLUMNS), ["A", "B"], CLASSES, others)


def test_accuracies_average_over_the_places_present():
    assert FIXED.by_home().tolist() == [[87.5, 50.0]]
    assert RANDOM.by_home().tolist() == [[87.5], [12.5]]
    percent = FIXED.by_class()
    assert percent[0, 0].tolist() == [75.0, 100.0]
    assert percent[0, 1, 0] == 50.0
    assert np.isnan(percent[0, 1, 1])
    assert not FIXED.is_random
    assert RANDOM.is_random


def test_pooled_frames_count_as_one_home():
    pooled = FIXED.pooled()
    assert pooled.confusion.tolist() == [[[[4, 2], [0, 4]]]]
    assert pooled.by_class().round(2).tolist() == [[[66.67, 100.0]]]


def test_the_spread_is_the_range_over_seeds():
    assert mean_and_spread(np.array([10.0, 12.5]), random=True) == (11.25, 2.5)
    mean, spread = mean_and_spread(np.array([10.0]), random=False)
    assert mean == 10.0
    assert np.isnan(spread)


def test_the_accuracy_table_has_one_row_per_place_and_per_home():
    table = Results(("A", "B"), CLASSES, {"x": FIXED, "y": RANDOM}, {}).accuracy_table()
    assert len(table) == 9
    of_homes = table[table["place"] == "all"]
    assert of_homes["accuracy"].tolist() == [87.5, 50.0, 50.0]
    assert of_homes["seeds"].tolist() == [0, 0, 2]
    assert of_homes["spread"].tolist()[2] == 75.0
    assert of_homes["spread"].isna().tolist() == [True, True, False]
    assert table["frames"].tolist() == [4, 4, 8, 2, 0, 2, 4, 4, 8]


@given(arrays(np.int64, (2, 3, 2, 2), elements=st.integers(0, 50)))
def test_results_survive_a_round_trip_through_scores(confusion):
    # A home without a scored frame looks like one that was not measured.
    confusion[:, :, 0, 0] += 1
    one = Measured(("B", "A", "C"), ("seed-0", "seed-1"), CLASSES, confusion)
    back = rebuilt({"x": one}).of("x")
    assert (back.homes, back.seeds, back.classes) == (one.homes, one.seeds, one.classes)
    np.testing.assert_array_equal(back.confusion, one.confusion)


def test_results_on_other_data_sets_have_their_own_places():
    other = Measured(("s",), (NO_SEED,), ("office", "kitchen", "lab"), np.arange(1, 10).reshape(1, 1, 3, 3))
    results = rebuilt({"x": FIXED, "s": other}, others=[("office", "kitchen", "lab")])
    assert results.of("x").classes == CLASSES
    assert results.of("s").classes == other.classes
    np.testing.assert_array_equal(results.of("s").confusion, other.confusion)


def test_an_unknown_result_suggests_similar_names():
    with pytest.raises(PlacecatError, match="result 'cues/gits' does not exist: did you mean cues/gist"):
        Results(("A",), CLASSES, {"cues/gist": FIXED}, {}).of("cues/gits")
