"""The number of homes that each finding needs, from the spread between six homes."""

import numpy as np
import pandas as pd
import pytest

from placecat.errors import PlacecatError
from placecat.replication.needed import markdown, power_table
from placecat.replication.options import Options

PLAN = Options(group=6, level=0.98, shared=0.1)


def row(finding=1, **changes):
    return {
        "finding": finding,
        "reading": "",
        "range": "above 0",
        "units": "6 homes",
        "published": 5.0,
        "measured": 5.0,
        "low": -0.25,
        "high": 10.25,
    } | changes


def table(*rows, homes=24):
    return power_table(pd.DataFrame(rows), homes, PLAN).set_index("number")


def test_the_spread_and_the_number_of_homes_needed():
    """Half of the interval is 5.25 points, so the standard deviation is 5.0 and equals the effect."""
    made = table(row()).loc[1]
    assert made["spread"] == 5.0
    assert made["units"] == 24
    assert made["power_published"] == made["power_measured"] >= 0.95
    # At a level of 1%, a one-sided t-test needs 13 units to detect one standard deviation with 80% power.
    assert made["needed_published"] == 18


def test_power_depends_on_the_true_difference():
    made = table(row(1, published=1.0), row(2, published=np.nan), row(3, measured=-5.0)).sort_index()
    assert made.loc[1, "power_published"] < 0.2 < made.loc[1, "power_measured"]
    assert np.isnan(made.loc[2, "power_published"]) and made.loc[2, "power_measured"] > 0.9
    # At -5 points, the claim is as likely to fail as it is to hold at 5 points.
    assert made.loc[3, "power_measured"] > 0.9


def test_a_table_on_two_homes_per_group_counts_eight_homes():
    made = table(row(1, units="2 homes x 2 seeds"), row(2)).sort_index()
    assert made.loc[1, "units"] == 8
    assert made.loc[1, "needed_measured"] > made.loc[2, "needed_measured"]


def test_all_comparisons_must_hold_but_one_failure_is_enough():
    one, all_ = table(row()).loc[1], table(*[row(published=3.0) for _ in range(6)]).loc[1]
    assert all_["comparisons"] == 6
    assert all_["power_published"] < one["power_published"] - 0.4
    failing = table(*[row() for _ in range(5)], row(measured=-6.0)).loc[1]
    assert failing["power_measured"] > 0.9


@pytest.mark.parametrize(
    "changes", [{"units": "1 home x 2 seeds"}, {"units": "18 stays"}, {"range": "both signs"}]
)
def test_unknown_comparisons_have_no_numbers(changes):
    made = table(row(), row(**changes)).loc[1]
    assert np.isnan(made[["spread", "power_published", "needed_measured"]].astype(float)).all()


def test_other_readings_are_not_findings():
    made = table(row(), row(reading="as_printed", units="18 stays"))
    assert len(made) == 1 and made.loc[1, "spread"] == 5.0
    # An empty cell in the file may be read as NaN.
    assert table(row(reading=np.nan), row(reading="as_printed", units="18 stays")).equals(made)


def test_an_unknown_range_is_rejected():
    with pytest.raises(PlacecatError, match="unknown range 'near 0'"):
        table(row(range="near 0"))


def test_unknown_cells_stay_empty_and_too_many_homes_have_no_number():
    lines = markdown(table(row(1, units="18 stays"), row(2, measured=0.01)).reset_index()).splitlines()
    assert lines[2] == "| 1 | 1 |  |  |  |  |"
    assert lines[3].startswith("| 2 | 1 | 24 | 5.0 | ") and lines[3].endswith("over 240 |")
