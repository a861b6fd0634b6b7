import numpy as np
import pytest

from placecat.errors import PlacecatError
from placecat.reporting.results import Results


@pytest.fixture
def results():
    confusion = np.array([[[3, 1], [0, 4]], [[1, 1], [0, 0]]])
    return Results(("A", "B"), ("bedroom", "kitchen"), {"cues/x/5-5-1": confusion})


def test_accuracy_by_home_is_over_places_present(results):
    assert results.by_home("cues/x/5-5-1").tolist() == [87.5, 50.0]


def test_accuracy_by_class_has_nan_where_nothing_is_scored(results):
    percent = results.by_class("cues/x/5-5-1")
    assert percent[0].tolist() == [75.0, 100.0]
    assert percent[1, 0] == 50.0
    assert np.isnan(percent[1, 1])


def test_long_table_has_a_row_a_place_and_a_row_a_home(results):
    table = results.long_table()
    assert len(table) == 6
    assert table[table["place"] == "all"]["accuracy"].tolist() == [87.5, 50.0]
    assert table["frames"].tolist() == [4, 4, 8, 2, 0, 2]


def test_unknown_result_names_those_there_are(results):
    with pytest.raises(PlacecatError, match="result 'cues/y', but there is cues/x/5-5-1"):
        results.by_home("cues/y")
