"""The tables as nested metrics, and the data for DVC's plots."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml

from placecat.errors import PlacecatError
from placecat.results.measured import Measured, Quality, Results
from placecat.settings import read_yaml
from placecat.thesis.metrics import chosen_averages, nested_metrics, plot_data

ROOT = Path(__file__).resolve().parents[2]
PLACES = ("kitchen", "bedroom")


def filled(*rows):
    return pd.DataFrame(rows, columns=["group", "row", "column", "measured"])


def test_tables_nest_by_group_row_and_column():
    table = filled(
        ("5-5-1", "Gist", "Home 1", 31.2),
        ("5-5-1", "Gist", "Average", 30.004),
        ("4-5-1", "Gist", "Home 1", 12.0),
    )
    assert nested_metrics({"table_26": table}) == {
        "table_26": {
            "5-5-1": {"Gist": {"Home 1": 31.2, "Average": 30.0}},
            "4-5-1": {"Gist": {"Home 1": 12.0}},
        }
    }


def test_empty_labels_add_no_level():
    tables = {
        "table_05": filled(("", "SVM", "Home 1", 31.2)),
        "table_03": filled(("", "0.2", "", 31.2), ("", "0.1", "", 28.0)),
        "single": filled(("", "", "", 50.0)),
        "some": filled(("a", "x", "", 1.0), ("", "x", "", 2.0)),
    }
    assert nested_metrics(tables) == {
        "table_05": {"SVM": {"Home 1": 31.2}},
        "table_03": {"0.2": 31.2, "0.1": 28.0},
        "single": {"-": 50.0},
        "some": {"a": {"x": 1.0}, "-": {"x": 2.0}},
    }


def test_cells_without_a_number_are_left_out():
    tables = {
        "table_05": filled(
            ("", "SVM", "Home 1", 31.2), ("", "SVM", "Home 6", np.nan), ("", "KNN", "Home 6", np.nan)
        ),
        "table_06": filled(("", "SVM", "Home 1", np.nan)),
    }
    assert nested_metrics(tables) == {"table_05": {"SVM": {"Home 1": 31.2}}}


@pytest.fixture
def results():
    # There are two seeds and two homes; the decisions of the second seed differ.
    confusion = np.array(
        [[[[3, 1], [0, 4]], [[1, 1], [0, 0]]], [[[4, 0], [4, 0]], [[2, 0], [0, 0]]]],
    )
    measured = Measured(("A", "B"), ("seed-0", "seed-1"), PLACES, confusion)
    values = {"calibration_error": np.ones((2, 2)), "stay_accuracy": np.ones((2, 2))}
    values["log_loss"] = np.array([[1.0, 2.0], [1.5, 1.0004]])
    quality = {"integration/x": Quality(("A", "B"), measured.seeds, values)}
    reasons = {("integration/y", "A"): "too few homes"}
    return Results(("A", "B"), PLACES, {"integration/x": measured}, reasons, quality=quality)


def test_decisions_have_one_row_per_frame_of_the_first_seed(results):
    rows = plot_data(results, {"confusion": {"after": "integration/x"}})["confusion/after.csv"]
    assert list(rows.columns) == ["truth", "decision"]
    assert rows.value_counts().to_dict() == {
        ("kitchen", "kitchen"): 4,
        ("kitchen", "bedroom"): 2,
        ("bedroom", "bedroom"): 4,
    }
    assert rows["truth"].tolist() == ["kitchen"] * 6 + ["bedroom"] * 4


def test_accuracies_have_one_row_per_home(results):
    rows = plot_data(results, {"accuracy_by_home": {"after": "integration/x"}})["accuracy_by_home/after.csv"]
    # Home A has 87.5 and 50 percent. Home B has 50 and 100 percent, because it has no frame of the bedroom.
    assert rows.to_dict("list") == {"home": ["A", "B"], "accuracy": [68.75, 75.0]}


def test_missing_results_have_no_rows(results):
    data = plot_data(results, {kind: {"y": "integration/y"} for kind in ("confusion", "accuracy_by_home")})
    assert {name: list(rows.columns) for name, rows in data.items()} == {
        "confusion/y.csv": ["truth", "decision"],
        "accuracy_by_home/y.csv": ["home", "accuracy"],
    }
    assert all(rows.empty for rows in data.values())


@pytest.mark.parametrize(
    ("plots", "message"),
    [
        (
            {"confusion": {"z": "integration/z"}},
            r"plots\.confusion\.z: result 'integration/z' does not",
        ),
        ({"confusions": {}}, r"plots has no setting 'confusions'; did you mean 'confusion'\?"),
    ],
)
def test_unknown_plots_are_rejected(results, plots, message):
    with pytest.raises(PlacecatError, match=message):
        plot_data(results, plots)


def test_selected_averages_are_metrics(results):
    columns = {"after": "integration/x", "lost": "integration/y"}
    averages = chosen_averages(results, {"accuracy": columns, "log_loss": columns})
    # The homes have 87.5, 50, 50 and 100 percent.
    assert averages == {"after": 71.88, "log_loss": {"after": 1.375}}
    for kind in ("accuracy", "log_loss"):
        with pytest.raises(PlacecatError, match=rf"metrics\.{kind}\.z: result 'integration/z' does not"):
            chosen_averages(results, {kind: {"z": "integration/z"}})
    with pytest.raises(PlacecatError, match="metrics has no setting 'log_los'; did you mean 'log_loss'"):
        chosen_averages(results, {"log_los": columns})


def test_dvc_draws_the_chosen_panels():
    """The plots in dvc.yaml use the files and columns from the settings."""
    chosen = yaml.safe_load((ROOT / "data/thesis/plots.yaml").read_text())
    drawn = {}
    for plot in read_yaml(ROOT / "dvc.yaml")["plots"]:
        for options in plot.values():
            for file, column in options["y"].items():
                drawn.setdefault(file, set()).add((column, options["x"]))
    axes = {"confusion": ("truth", "decision"), "accuracy_by_home": ("home", "accuracy")}
    assert drawn == {
        f"reports/plots/{kind}/{panel}.csv": {axes[kind]}
        for kind, panels in chosen.items()
        for panel in panels
    }
