import numpy as np
import pandas as pd
import pytest
from made_accuracies import measured, results

from placecat.report.grid import make_grid
from placecat.thesis.decisions import decisions_of
from placecat.thesis.layouts import by_home, by_home_with_gains
from placecat.thesis.tables import fill_table

ROWS = [{"group": "g", "row": name.title(), "result": name} for name in ("gist", "hog", "fused")]
GAIN = {"group": "g", "row": "Gain", "result": "fused", "over": ["gist", "hog"]}
TABLE = {"name": "table_x", "number": None, "thesis_data": None, "layout": "by_home_with_gains"}
TABLE |= {"title": "x", "rows": ROWS, "gains": [GAIN]}
GIST, HOG = [40, 10, 30, 20, 20, 30], [[20, 20, 20, 20, 20, 20], [24, 24, 24, 24, 24, 24]]
FUSED = [[30, 20, 50, 20, 30, 30], [32, 22, 52, 22, 32, 32]]


def gains(table=TABLE, **named):
    named = {"gist": measured(GIST), "hog": measured(HOG), "fused": measured(FUSED)} | named
    made = results(**named)
    filled = list(by_home_with_gains(table, made).items())
    rows = list(by_home(table, made).items())
    assert repr(filled[: len(rows)]) == repr(rows)
    assert {(group, row) for (group, row, _), _ in filled[len(rows) :]} == {("g", "Gain")}
    return {column: number for (_, _, column), number in filled[len(rows) :]}


def numbers_of_gains(made):
    cells = by_home_with_gains(TABLE, made).items()
    return {column: number for (_, row, column), number in cells if row == "Gain"}


def test_a_gain_is_relative_to_the_best_result_on_average():
    found = gains()
    assert [cell.measured for cell in found.values()] == [-9.0, 11.0, 21.0, 1.0, 11.0, 1.0, 6.0]
    assert list(found)[-1] == "Average"
    assert {cell.notes for cell in found.values()} == {("minus Gist, the best on average",)}
    assert {(number.spread, number.seeds) for number in found.values()} == {(2.0, 2)}


def test_gains_are_computed_per_seed():
    found = gains(gist=measured([0] * 6))
    assert found["Home 1"].measured == pytest.approx(31 - 22)
    assert found["Home 1"].spread == pytest.approx(2.0)
    assert found["Average"].notes == ("minus Hog, the best on average",)


def test_a_gain_over_a_single_result_names_that_result():
    found = gains(TABLE | {"gains": [GAIN | {"over": ["other"]}]}, other=measured(GIST))
    assert {cell.notes for cell in found.values()} == {("minus other",)}


def test_a_home_without_a_number_has_a_reason_and_no_gain():
    made = results({("gist", "home_2"): "too few frames"}, hog=measured(HOG), fused=measured(FUSED))
    homes = [f"home_{number}" for number in (1, 3, 4, 5, 6)]
    made.measured["gist"] = measured([40, 30, 30, 30, 30], homes)
    found = numbers_of_gains(made)
    assert np.isnan(found["Home 2"].measured)
    assert found["Home 2"].notes == ("too few frames",)
    assert found["Home 1"].measured == -9.0


def test_missing_results_leave_reasons():
    lost = {(name, f"home_{number}"): "too few frames" for name in ("gist", "hog") for number in range(1, 7)}
    made = results(lost, fused=measured(FUSED))
    assert {number.notes for number in numbers_of_gains(made).values()} == {("too few frames",)}


def test_groups_stay_together():
    rows = [*ROWS, {"group": "other", "row": "Last", "result": "gist"}]
    made = results(gist=measured(GIST), hog=measured(HOG), fused=measured(FUSED))
    found = by_home_with_gains(TABLE | {"rows": rows}, made)
    assert list(dict.fromkeys((group, row) for group, row, _ in found))[-2:] == [
        ("g", "Gain"),
        ("other", "Last"),
    ]


def test_gains_stand_below_the_rows_of_their_group_and_have_no_decisions():
    made = results(gist=measured(GIST), hog=measured(HOG), fused=measured(FUSED))
    published = pd.DataFrame(columns=["table", "group", "row", "column", "value"])
    filled = fill_table(TABLE, made, published, {"title": "x", "homes": made.homes, "thesis_data": None}, {})
    (group,) = make_grid(filled).groups
    assert [row.name for row in group.rows] == ["Gist", "Hog", "Fused", "Gain"]
    assert group.rows[-1].cells[0].measured == "-9.00"
    assert list(decisions_of(TABLE, made)) == [("g", "Gist"), ("g", "Hog"), ("g", "Fused")]
