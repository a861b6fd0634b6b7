import pandas as pd
import pytest

from placecat import settings
from placecat.choice.candidates import COLUMNS, choose, combinations, label
from placecat.errors import PlacecatError

TRIES = "conf/choice.yaml tries"


def table(rows):
    """Make two rows for each (data, candidate, accuracy, log-loss): test homes that differ by 2 points."""
    return pd.DataFrame(
        [
            (data, "cues", "gist", candidate, home, accuracy + shift, loss, 99.0, 0.0)
            for data, candidate, accuracy, loss in rows
            for home, shift in (("a", -1.0), ("b", 1.0))
        ],
        columns=COLUMNS,
    )


def test_the_log_loss_decides_among_similar_accuracies():
    rows = [("one", "sure", 40.0, 1.6), ("one", "calm", 39.5, 1.4), ("one", "weak", 38.0, 1.2)]
    chosen = choose(table(rows), margin=1.0)
    assert chosen[chosen["chosen"]]["candidate"].tolist() == ["calm"]
    assert chosen["accuracy"].tolist() == [40.0, 39.5, 38.0]
    assert choose(table(rows), margin=0.0).set_index("candidate")["chosen"].to_dict()["sure"]


def test_data_sets_have_equal_weight():
    rows = [
        ("one", "x", 50.0, 1.0),
        ("one", "y", 40.0, 1.0),
        ("two", "x", 20.0, 1.0),
        ("two", "y", 36.0, 1.0),
    ]
    chosen = choose(table(rows), margin=1.0).set_index("candidate")
    assert chosen["accuracy"].to_dict() == {"x": 35.0, "y": 38.0}
    assert chosen["chosen"].to_dict() == {"x": False, "y": True}


def test_results_in_test_homes_are_ignored():
    rows = table([("one", "x", 40.0, 1.0), ("one", "y", 30.0, 1.0)])
    rows.loc[rows["candidate"] == "y", "test_accuracy"] = 100.0
    assert choose(rows, margin=1.0).set_index("candidate")["chosen"].to_dict() == {"x": True, "y": False}


def test_candidates():
    grids = [
        {"classifier.scaling": ["standard", "distance"], "temperature": [False]},
        {"temperature": [True]},
    ]
    *candidates, last = combinations(grids)
    assert label(last) == "temperature=True"
    assert [label(one) for one in candidates] == [
        "scaling=standard, temperature=False",
        "scaling=distance, temperature=False",
    ]
    config = {"classifier": {"scaling": "unit"}, "temperature": True}
    assert settings.changed(config, candidates[1], TRIES, "it") == {
        "classifier": {"scaling": "distance"},
        "temperature": False,
    }
    assert config["classifier"]["scaling"] == "unit"
    with pytest.raises(PlacecatError, match=r"tries classifier.scale, but the cue gist has no such setting"):
        settings.changed(config, {"classifier.scale": 1}, TRIES, "the cue gist")
