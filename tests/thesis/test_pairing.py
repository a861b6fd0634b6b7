import numpy as np
import pytest
from made_accuracies import measured, results

from placecat.errors import NotComputable
from placecat.thesis.claims import Side
from placecat.thesis.pairing import pair

FIXED = measured([10, 20, 30, 40, 50, 60])
RANDOM = measured([[11, 22, 33, 44, 55, 66], [13, 24, 35, 46, 57, 68]])
TWO_HOMES = measured([[20, 30], [22, 32]], ["home_6", "home_1"])


def side(*names, **options):
    return Side("side", names, **options)


def test_homes_are_units_and_seeds_are_averaged():
    paired = pair(results(a=FIXED, b=RANDOM), [side("a"), side("b")], few_homes=2)
    left, right = paired.by_unit()
    assert paired.units == "6 homes"
    assert left.tolist() == [[10, 20, 30, 40, 50, 60]]
    assert right.tolist() == [[12, 23, 34, 45, 56, 67]]


def test_a_few_homes_are_split_by_seed():
    paired = pair(results(a=RANDOM, b=TWO_HOMES, c=FIXED), [side("a", "c"), side("b")], few_homes=2)
    left, right = paired.by_unit()
    assert paired.units == "2 homes x 2 seeds"
    assert paired.homes == ("home_1", "home_6")
    assert left.tolist() == [[11, 13, 66, 68], [10, 10, 60, 60]]
    assert right.tolist() == [[30, 32, 20, 22]]


def test_without_seeds_two_homes_are_two_units():
    paired = pair(results(a=measured([10, 20])), [side("a")], few_homes=2)
    assert paired.units == "2 homes"
    assert paired.by_unit()[0].tolist() == [[10, 20]]


def test_single_units_have_singular_names():
    paired = pair(results(a=measured([[10]])), [side("a")], few_homes=2)
    assert paired.units == "1 home x 1 seed"


def test_a_home_without_frames_is_left_out():
    paired = pair(results(a=measured([10, np.nan, 30]), b=measured([1, 2, 3])), [side("a"), side("b")], 1)
    assert paired.homes == ("home_1", "home_3")
    assert paired.by_unit()[1].tolist() == [[1, 3]]


def test_the_error_of_one_place_is_computed():
    one = measured([90])
    one.confusion[0, 0] = [[900, 100], [300, 700]]
    paired = pair(results(a=one), [side("a", place="kitchen", error=True), side("a", place="bedroom")], 2)
    assert [values.tolist() for values in paired.by_unit()] == [[[30.0]], [[90.0]]]


def test_last_selects_the_last_measured_result():
    last = side("a", "b", "c", combine="last")
    paired = pair(results(a=FIXED, b=RANDOM), [last], few_homes=2)
    assert paired.sides[0].results == ("b",)
    assert paired.note == "side without c, which this data does not allow"
    with pytest.raises(NotComputable, match="this run has no result c"):
        pair(results(), [last], few_homes=2)


def test_best_ignores_missing_results_and_notes_them():
    found = results({("b", "home_1"): "too few frames"}, a=FIXED, c=RANDOM)
    paired = pair(found, [side("a", "b", combine="best"), side("c")], few_homes=2)
    assert paired.sides[0].results == ("a",)
    assert paired.note == "side without b, which this data does not allow"
    with pytest.raises(NotComputable, match="this run has no result d"):
        pair(found, [side("a", "d", combine="best")], few_homes=2)
    with pytest.raises(NotComputable, match=r"^b: too few frames$"):
        pair(found, [side("b", combine="best")], few_homes=2)


def test_means_use_only_results_available_on_both_sides():
    found = results({("b", "home_1"): "too few frames"}, a=FIXED, c=RANDOM, d=RANDOM)
    paired = pair(found, [side("a", "b"), side("c", "d")], few_homes=2)
    assert [one.results for one in paired.sides] == [("a",), ("c",)]
    assert paired.note == (
        "side without b, which this data does not allow; side without d, which this data does not allow"
    )


def test_missing_results_raise_with_the_reason():
    found = results({("b", "home_1"): "too few frames", ("b", "home_2"): "too few frames"}, a=FIXED)
    with pytest.raises(NotComputable, match=r"^b: too few frames$"):
        pair(found, [side("a"), side("b")], few_homes=2)
    with pytest.raises(NotComputable, match="no place attic"):
        pair(found, [side("a", place="attic")], few_homes=2)
    found = results(a=measured([1], ["home_1"]), b=measured([1], ["home_2"]))
    with pytest.raises(NotComputable, match="no home has all of a, b"):
        pair(found, [side("a"), side("b")], few_homes=2)


def test_a_home_that_one_result_lacks_is_noted():
    found = results({("b", "home_3"): "too few frames"}, a=FIXED, b=measured([1, 2], ["home_1", "home_2"]))
    paired = pair(found, [side("a"), side("b")], few_homes=2)
    assert paired.homes == ("home_1", "home_2")
    assert paired.note == "without home_3: too few frames"


def test_seeds_with_different_names_are_averaged():
    other = measured([[10, 20], [20, 30], [30, 40]])
    other = type(other)(other.homes, ("x", "y", "z"), other.classes, other.confusion)
    paired = pair(results(a=other, b=measured([[1, 2], [3, 4]])), [side("a"), side("b")], few_homes=2)
    assert paired.units == "2 homes"
    assert [values.tolist() for values in paired.by_unit()] == [[[20, 30]], [[2, 3]]]
