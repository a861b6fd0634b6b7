import numpy as np
import pandas as pd
import pytest

from placecat.errors import PlacecatError
from placecat.thesis.published import Published

CELLS = [
    (1, "", "Home 1", "46", 25.64),
    (1, "", "Average", "46", 30.08),
    (2, "", "20 weak", "Home 1", 26.73),
    (3, "gamma=1.0", "Average", "0.2", np.nan),
    (14, "", "HOG", "PCA 4", 21.38),
    (24, "", "HOG", "Home 1", 32.30),
    (24, "", "HOG", "Average", 36.11),
]
TEXT = [("toy", "parallel", "", 99.74), ("toy", "sequential", "", 99.56), ("short", "difference", "", np.nan)]
PUBLISHED = Published(
    pd.DataFrame(CELLS, columns=["table", "group", "row", "column", "value"]),
    pd.DataFrame(TEXT, columns=["name", "quantity", "home", "value"]),
)


def test_a_cell_is_found_by_its_labels():
    assert PUBLISHED.number({"table": 1, "row": "Home 1", "column": "46"}) == 25.64
    assert PUBLISHED.number({"table": "24", "row": "HOG", "column": "Average"}) == 36.11
    assert np.isnan(PUBLISHED.number({"table": 3, "group": "gamma=1.0", "row": "Average", "column": "0.2"}))


def test_a_number_in_the_text_is_found():
    assert PUBLISHED.number({"text": "toy", "quantity": "sequential"}) == 99.56
    assert np.isnan(PUBLISHED.number({"text": "short"}))


@pytest.mark.parametrize(
    ("result", "home", "value"),
    [
        ("trials/table_01/||46", "Average", 30.08),
        ("trials/table_01/||46", "Home 1", 25.64),
        ("trials/table_02/|20 weak|", "Average", 26.73),
        ("trials/table_14/|HOG|PCA 4", "Home 1", 21.38),
        ("trials/table_24/|HOG|", "Average", 36.11),
    ],
)
def test_a_trial_is_found_by_its_name(result, home, value):
    assert PUBLISHED.of_trial(result, home) == value


def test_results_that_are_not_cells_have_no_number():
    assert np.isnan(PUBLISHED.of_trial("cues/gist/5-5-1"))
    assert np.isnan(PUBLISHED.of_trial("trials/flat_kmeans/||46"))


@pytest.mark.parametrize(
    ("reference", "message"),
    [
        ({"table": 1, "row": "Home 2", "column": "46"}, "no numbers"),
        ({"text": "toy"}, "2 numbers"),
        ({"table": 1, "rows": "Home 1"}, "did you mean 'row'"),
        ({"text": "toy", "table": 1}, "no setting 'table'"),
    ],
)
def test_unknown_numbers_are_rejected(reference, message):
    with pytest.raises(PlacecatError, match=message):
        PUBLISHED.number(reference)


def test_a_trial_without_a_published_cell_is_an_error():
    with pytest.raises(PlacecatError, match="no numbers for trials/table_01/"):
        PUBLISHED.of_trial("trials/table_01/||47")
