import pytest

from placecat.errors import PlacecatError
from placecat.evaluation.trials import expand, homes_of, trial_name

HOMES = ["a", "b", "c"]
TABLE = {
    "homes": [1, 3, 6],
    "trial": {"descriptor": {"name": "hog"}, "classifier": {"clusters": 1, "base": {"k": 1}}},
    "axes": {
        "group": {
            "HOG": {},
            "SIFT": {"descriptor.name": "sift", "classifier": {"clusters": 2, "base": {"k": 3}}},
        },
        "row": "homes",
        "column": {"46": {"classifier.clusters": 46}, "91": {"classifier.clusters": 91}},
    },
}


def test_expand_lists_one_trial_per_combination_of_labels():
    trials = {trial.name: trial for trial in expand("table_12", TABLE, HOMES)}
    assert list(trials) == [
        "trials/table_12/HOG||46",
        "trials/table_12/HOG||91",
        "trials/table_12/SIFT||46",
        "trials/table_12/SIFT||91",
    ]
    assert trials["trials/table_12/HOG||91"].settings == {
        "descriptor": {"name": "hog"},
        "classifier": {"clusters": 91, "base": {"k": 1}},
    }
    # The column changes part of the setting from the group, but only in this trial.
    assert trials["trials/table_12/SIFT||46"].settings["classifier"] == {"clusters": 46, "base": {"k": 3}}
    assert trials["trials/table_12/SIFT||91"].settings["classifier"] == {"clusters": 91, "base": {"k": 3}}
    assert TABLE["axes"]["group"]["SIFT"]["classifier"]["clusters"] == 2


def test_missing_home_numbers_are_skipped():
    assert homes_of(TABLE, HOMES) == [(1, "a"), (3, "c")]
    assert homes_of({"homes": "all"}, HOMES) == [(1, "a"), (2, "b"), (3, "c")]
    assert {trial.homes for trial in expand("t", TABLE, HOMES)} == {("a", "c")}


def test_equal_trials_have_equal_keys():
    first, again = expand("t", TABLE, HOMES), expand("other", TABLE, HOMES)
    assert [one.key() for one in first] == [one.key() for one in again]
    assert len({one.key() for one in first}) == 4


def test_without_axes_there_is_one_trial():
    (trial,) = expand("text", TABLE | {"axes": {}}, HOMES)
    assert trial.name == trial_name("text", "", "", "") == "trials/text/||"


@pytest.mark.parametrize(
    ("axes", "message"),
    [
        ({"line": {}}, "'line'"),
        ({"row": {"x": {"classifier.cluster": 3}}}, "classifier.cluster,"),
        ({"row": {"x": {"codebook.cells": 3}}}, "codebook.cells,"),
    ],
)
def test_unknown_trial_settings_are_rejected(axes, message):
    with pytest.raises(PlacecatError, match=message):
        expand("table_12", TABLE | {"axes": axes}, HOMES)
