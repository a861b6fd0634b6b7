from dataclasses import replace

import numpy as np
import pytest

from made_results import PARAMS, ROOT, made
from placecat.errors import PlacecatError
from placecat.results.measured import Quality
from placecat.thesis.layouts import probabilities
from placecat.thesis.tables import tables_of

TABLE = tables_of(PARAMS, ROOT)["addition_probabilities"]
RESULTS = made()


def rows(*results):
    return TABLE | {"rows": [{"group": "g", "row": name, "result": name} for name in results]}


def test_cells_are_means_over_homes_and_seeds():
    found = probabilities(TABLE, RESULTS)
    assert len(found) == 3 * len(TABLE["rows"])
    names = {(row["group"], row["row"]): row["result"] for row in TABLE["rows"]}
    columns = {"Log loss": "log_loss", "Calibration error": "calibration_error"}
    columns["Stay accuracy"] = "stay_accuracy"
    for (group, row, column), cell in found.items():
        values = RESULTS.quality[names[group, row]].values[columns[column]]
        assert cell.measured == pytest.approx(values.mean(), abs=0.0051)
        means = values.mean(axis=1)
        if len(means) == 1:
            assert np.isnan(cell.spread) and cell.seeds == 0
        else:
            assert cell.spread == pytest.approx(abs(means[0] - means[1]), abs=0.0051)
            assert cell.seeds == 2


def test_a_mean_over_fewer_homes_has_a_note():
    name = "cues/gist/5-5-1"
    one = RESULTS.quality[name]
    part = Quality(one.homes[1:3], one.seeds, {key: value[:, 1:3] for key, value in one.values.items()})
    found = probabilities(rows(name), replace(RESULTS, quality={name: part}))
    assert {cell.notes for cell in found.values()} == {("mean over only Home 2, Home 3",)}
    assert found["g", name, "Log loss"].measured == pytest.approx(
        one.values["log_loss"][:, 1:3].mean(), abs=0.0051
    )


def test_missing_numbers_have_a_reason_and_unknown_results_raise():
    name = "cues/gist/5-5-1"
    one = RESULTS.quality[name]
    empty = Quality(one.homes, one.seeds, {key: value * np.nan for key, value in one.values.items()})
    found = probabilities(rows(name), replace(RESULTS, quality={name: empty}))
    assert {cell.notes for cell in found.values()} == {("no tested frame has a label",)}
    lost = replace(RESULTS, quality={}, missing={("cues/new", "home_1"): "too few frames"})
    first = probabilities(rows("cues/new"), lost)["g", "cues/new", "Log loss"]
    assert np.isnan(first.measured) and first.notes == ("too few frames",)
    with pytest.raises(PlacecatError, match="result 'cues/gits/5-5-1' does not exist: did you mean"):
        probabilities(rows("cues/gits/5-5-1"), RESULTS)
