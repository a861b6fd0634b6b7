"""The quality of distributions, from homes to files and tables."""

import numpy as np
import pandas as pd
import pytest

from made_results import drawn_quality
from placecat.evaluation.quality import HomeQuality
from placecat.results.measured import NO_SEED
from placecat.results.quality import QUALITY_COLUMNS, from_rows, gather, quality_rows, quality_table

FIXED = gather(
    ["B", "A"],
    [NO_SEED],
    [[HomeQuality(1.0, 10.0, 4, 3, 50.0), HomeQuality(2.5, 30.0, 6, 2, 40.0)]],
)
RANDOM = gather(
    ["A"],
    ["seed-0", "seed-1"],
    [[HomeQuality(1.0, 10.0, 4, 1, 25.0)], [HomeQuality(1.2, 15.0, 4, 3, 75.0)]],
)
NAN = float("nan")
EMPTY = HomeQuality(NAN, NAN, 0, 0, NAN)


def same(one, other):
    assert (one.homes, one.seeds) == (other.homes, other.seeds)
    for field in HomeQuality._fields:
        np.testing.assert_array_equal(one.values[field], other.values[field])


def test_rows_restore_the_results():
    made = {"cues/gist/5-5-1": FIXED, "hmm/x": RANDOM, "empty": gather(["A"], [NO_SEED], [[EMPTY]])}
    made["drawn"] = drawn_quality(np.random.default_rng(0), ("C", "A", "B"), ("seed-0", "seed-1"))
    rows = [row for name, one in made.items() for row in quality_rows(name, one)]
    found = from_rows(pd.DataFrame(rows, columns=QUALITY_COLUMNS))
    assert list(found) == list(made)
    for name, one in made.items():
        same(found[name], one)


def test_counts_are_written_as_integers():
    (first, _), columns = quality_rows("x", FIXED), QUALITY_COLUMNS
    row = dict(zip(columns, first, strict=True))
    assert (row["stays"], row["stays_right"]) == (4, 3) and isinstance(row["stays"], int)
    assert (row["home"], row["seed"], row["log_loss"]) == ("B", NO_SEED, 1.0)


def test_averages_weight_homes_equally_and_the_share_weights_stays():
    assert FIXED.averages() == {"log_loss": 1.75, "calibration_error": 20.0, "stay_accuracy": 45.0}
    assert FIXED.stay_share().tolist() == [50.0]
    assert RANDOM.over_homes("stay_accuracy").tolist() == [25.0, 75.0]


def test_homes_without_labels_are_left_out():
    one = gather(["A", "B"], [NO_SEED], [[HomeQuality(1.0, 10.0, 4, 3, 50.0), EMPTY]])
    assert one.averages() == {"log_loss": 1.0, "calibration_error": 10.0, "stay_accuracy": 50.0}
    nothing = gather(["A"], [NO_SEED], [[EMPTY]])
    assert nothing.averages() == {} and len(nothing.stay_share()) == 0
    assert quality_table({"x": nothing})[["log_loss", "stay_share"]].isna().all(axis=None)


def test_the_table_has_means_and_spreads_over_seeds():
    table = quality_table({"fixed": FIXED, "random": RANDOM}).set_index("result")
    fixed, random = table.loc["fixed"], table.loc["random"]
    assert fixed[["homes", "seeds", "stays"]].tolist() == [2, 0, 10]
    assert fixed[["log_loss", "calibration_error", "stay_accuracy", "stay_share"]].tolist() == [
        1.75,
        20.0,
        45.0,
        50.0,
    ]
    assert fixed[[name for name in table if name.endswith("_spread")]].isna().all()
    assert random[["homes", "seeds", "stays"]].tolist() == [1, 2, 4]
    expected = {"log_loss": (1.1, 0.2), "calibration_error": (12.5, 5.0)}
    expected |= {"stay_accuracy": (50.0, 50.0), "stay_share": (50.0, 50.0)}
    for measure, pair in expected.items():
        assert random[[measure, f"{measure}_spread"]].tolist() == pytest.approx(list(pair))
