"""The summary of a sweep."""

import pandas as pd
import pytest

from placecat import files
from placecat.experiment import output, summary

SWEPT = ("descriptor", "classifier.clusters", "test_home")


def result(home, *accuracies, **measures):
    folds = {home: {f"seed-{n}": {"accuracy": one, "confusion": [[1]]} for n, one in enumerate(accuracies)}}
    mean = sum(accuracies) / len(accuracies)
    return {
        "settings": {"test_home": [home]},
        "accuracy": mean,
        "reason": None,
        "homes": {home: {"accuracy": mean, "reason": None, "folds": folds}},
        **measures,
    }


def made(tmp_path):
    """Make a sweep over two descriptors, cluster numbers and homes; three experiments have no accuracy."""
    numbers = iter(range(1, 9))
    combinations = [
        dict(zip(SWEPT, (descriptor, clusters, home), strict=True))
        for descriptor in ("hog", "sift")
        for clusters in ("4", "16")
        for home in ("h1", "h2")
    ]
    for number, one in enumerate(combinations):
        value = 10.0 * next(numbers)
        content = result(f"H{one['test_home'][1]}", value, value + 1)
        if number == 1:
            content |= {"accuracy": None, "reason": "too few"}
        if number == 2:
            content = output.failure("no memory")
        if number != 7:
            files.write_json(tmp_path / str(number) / output.RESULT, content)
    return summary.read(tmp_path, [one | {"test_home": one["test_home"].upper()} for one in combinations])


def test_a_sweep_is_shown_as_a_table(tmp_path):
    ran = made(tmp_path)
    expected = pd.DataFrame(
        {
            "4": ["10.50", "-", "10.50", "50.50", "60.50", "55.50"],
            "16": ["-", "40.50", "40.50", "70.50", "-", "70.50"],
        },
        index=pd.MultiIndex.from_product([["hog", "sift"], ["H1", "H2", "average"]]),
    )
    found = summary.grid(ran)
    assert found.index.tolist() == expected.index.tolist()
    assert found.to_dict("list") == expected.to_dict("list")
    assert found.index.names == ["descriptor", "test_home"]
    assert found.columns.name == "classifier.clusters"
    assert "| hog " in summary.markdown(ran)
    text = summary.text(ran)
    assert "Highest: descriptor=sift classifier.clusters=4: 55.50%, average of 2 homes" in text
    assert "test_home=H2: no number: too few" in text
    assert "failed: no memory" in text
    assert "failed: the experiment left no result" in text


def test_a_search_is_shown_as_a_list_of_experiments(tmp_path):
    """A table over both keys would be empty outside its diagonal."""
    combinations = [{"gamma": gamma, "scaling": scaling} for gamma, scaling in (("2", "unit"), ("1", "none"))]
    for number, value in enumerate((40.0, 60.0)):
        files.write_json(tmp_path / str(number) / output.RESULT, result("H1", value))
    found = summary.grid(summary.read(tmp_path, combinations))
    assert found["accuracy"].to_dict() == {("2", "unit"): "40.00", ("1", "none"): "60.00"}
    assert found.index.names == ["gamma", "scaling"]


def test_spread_is_the_range_over_seeds(tmp_path):
    frame = summary.as_frame(made(tmp_path))
    assert frame["spread"].tolist()[0] == 1.0
    assert frame["note"].tolist()[:3] == ["", "too few", "no memory"]


def test_the_average_of_swept_homes_comes_last(tmp_path):
    for number, value in enumerate((40.0, 60.0)):
        files.write_json(tmp_path / str(number) / output.RESULT, result(f"H{number}", value))
    ran = summary.read(tmp_path, [{"test_home": "H0"}, {"test_home": "H1"}])
    assert summary.grid(ran)["accuracy"].to_dict() == {"H0": "40.00", "H1": "60.00", "average": "50.00"}
    assert summary.highest(ran) == ({}, 50.0)


def of_values(tmp_path, *results):
    """Make a sweep over ``value`` with these accuracies, log-losses and calibration errors."""
    for number, (accuracy, log_loss, error) in enumerate(results):
        content = result("H1", accuracy, log_loss=log_loss, calibration_error=error)
        files.write_json(tmp_path / str(number) / output.RESULT, content)
    return summary.read(tmp_path, [{"value": f"v{number}"} for number in range(len(results))])


def test_all_measures_are_shown_side_by_side(tmp_path):
    ran = of_values(tmp_path, (40.0, 1.23456, 12.345678), (60.0, 0.5, 1.0))
    files.write_csv(tmp_path / output.SUMMARY, summary.as_frame(ran))
    assert (tmp_path / output.SUMMARY).read_text().splitlines() == [
        "number,value,accuracy,spread,log_loss,calibration_error,note",
        "0,v0,40.0,0.0,1.235,12.35,",
        "1,v1,60.0,0.0,0.5,1.0,",
    ]
    lines = [line.split() for line in summary.text(ran).splitlines()]
    assert " ".join(lines[0]) == "Accuracy in percent, log-loss in nats, calibration error in percent"
    assert lines[2:6] == [
        ["accuracy", "log_loss", "calibration_error"],
        ["value"],
        ["v0", "40.00", "1.235", "12.35"],
        ["v1", "60.00", "0.500", "1.00"],
    ]
    assert output.shown(ran[0].result) == "40.00%, log-loss 1.235 nats, calibration error 12.35%"


@pytest.mark.parametrize("count", [2, 6, 12])
def test_the_printed_tables_are_at_most_100_columns_wide(tmp_path, count):
    """Tables are side by side if there is room, and otherwise one below the other."""
    combinations = [
        {"descriptor": descriptor, "classifier.clusters": str(196 + clusters), "test_home": home}
        for descriptor in ("holistic_spatial_pact", "hog")
        for clusters in range(count)
        for home in ("home_1", "home_6")
    ]
    for number in range(len(combinations)):
        content = result("H1", 40.0 + number, log_loss=1.0 + number, calibration_error=10.0 + number)
        files.write_json(tmp_path / str(number) / output.RESULT, content)
    text = summary.text(summary.read(tmp_path, combinations))
    *table, highest = text.splitlines()
    assert highest.startswith("Highest: descriptor=hog")
    assert max(map(len, table)) <= 100
    # Check the last experiment and the average of the last setting.
    for number in (len(combinations) - 1, len(combinations) - 1.5):
        for value in (f"{40 + number:.2f}", f"{1 + number:.3f}", f"{10 + number:.2f}"):
            assert value in text.split()
    is_beside = text.count("holistic_spatial_pact") == 1
    assert is_beside == (count == 2)
