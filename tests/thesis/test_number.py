import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.errors import PlacecatError
from placecat.results.measured import Measured, Results
from placecat.thesis.number import Number, in_home, in_homes, mean, nothing, over_homes

percent = st.floats(0, 100)
seeded = st.lists(percent, min_size=2, max_size=2).map(lambda values: Number(np.array(values), True))
fixed = percent.map(lambda value: Number(np.array([value]), False))


def results(**missing):
    confusion = np.array([[[[3, 1], [0, 4]], [[1, 1], [0, 2]]], [[[1, 3], [0, 4]], [[2, 0], [1, 1]]]])
    one = Measured(("A", "B"), ("seed-0", "seed-1"), ("bedroom", "kitchen"), confusion)
    reasons = {("one", home): reason for home, reason in missing.items()}
    return Results(("A", "B", "C"), ("bedroom", "kitchen"), {"one": one}, reasons)


def test_homes_are_numbered_from_one():
    number = in_home(results(), "one", 1)
    assert number.values.tolist() == [87.5, 62.5]
    assert (number.measured, number.spread, number.seeds) == (75.0, 25.0, 2)


def test_the_average_over_homes_is_computed_per_seed():
    found = dict(in_homes(results(), "one", [1, 2]))
    assert list(found) == ["Home 1", "Home 2", "Average"]
    assert found["Average"].values.tolist() == [(87.5 + 75) / 2, (62.5 + 75) / 2]
    assert found["Average"].notes == ()
    assert [label for label, _ in in_homes(results(), "one", [2])] == ["Home 2"]


def test_a_home_without_a_number_has_a_reason_and_the_average_leaves_it_out():
    found = dict(in_homes(results(C="no frames"), "one", [1, 3, 4]))
    assert found["Home 3"].notes == ("no frames",)
    assert found["Home 4"].notes == ("the data set has only 3 homes",)
    assert np.isnan(found["Home 3"].measured)
    assert found["Average"].values.tolist() == [87.5, 62.5]
    assert found["Average"].notes == ("mean over only Home 1",)
    nowhere = over_homes(results(C="no frames"), "one", [3, 4])
    assert nowhere.notes == ("no frames", "the data set has only 3 homes")
    assert (nowhere.seeds, len(nowhere.values)) == (0, 0)


def test_an_unknown_result_is_an_error_unless_there_is_a_reason():
    with pytest.raises(PlacecatError, match="result 'two' does not exist"):
        in_home(results(), "two", 1)
    known = Results(("A",), ("x",), {}, {("two", "A"): "why; and so"})
    assert in_home(known, "two", 1).notes == ("why; and so",)


@given(seeded)
def test_the_mean_lies_within_the_range_of_the_seeds(number):
    assert number.values.min() - 0.005 <= number.measured <= number.values.max() + 0.005
    assert number.spread == pytest.approx(np.ptp(number.values), abs=0.006)


@given(st.one_of(seeded, fixed), st.one_of(seeded, fixed))
def test_differences_are_computed_per_seed(left, right):
    difference = left.minus(right)
    assert difference.is_random == (left.is_random or right.is_random)
    assert difference.values.mean() == pytest.approx(left.values.mean() - right.values.mean())
    assert right.minus(left).spread == pytest.approx(difference.spread, nan_ok=True)
    if not right.is_random and left.is_random:
        assert difference.spread == pytest.approx(left.spread, abs=0.011)


@given(st.lists(st.one_of(seeded, fixed, st.just(nothing("why"))), min_size=1))
def test_a_mean_leaves_out_missing_numbers(numbers):
    there = [one.values.mean() for one in numbers if len(one.values)]
    found = mean(numbers)
    if there:
        assert found.values.mean() == pytest.approx(np.mean(there))
        assert found.notes == ()
    else:
        assert found.notes == ("why",)
        assert np.isnan(found.measured)
        assert np.isnan(found.minus(nothing("too")).measured)


def test_subtracting_a_missing_number_keeps_its_reason():
    one = Number(np.array([1.0]), False)
    assert one.minus(nothing("why")).notes == ("why",)
    assert nothing("why").minus(nothing("why")).notes == ("why",)
