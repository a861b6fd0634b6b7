"""The summary of a sweep."""

import pandas as pd

from placecat import files
from placecat.experiment import output, summary

SWEPT = ("descriptor", "classifier.clusters", "test_home")


def result(home, *accuracies):
    folds = {home: {f"seed-{n}": {"accuracy": one, "confusion": [[1]]} for n, one in enumerate(accuracies)}}
    mean = sum(accuracies) / len(accuracies)
    return {
        "settings": {"test_home": [home]},
        "accuracy": mean,
        "reason": None,
        "homes": {home: {"accuracy": mean, "reason": None, "folds": folds}},
    }


def made(tmp_path):
    """Two descriptors, cluster numbers and homes; one has no number, one failed, one left nothing."""
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


def test_a_sweep_reads_as_a_table_does(tmp_path):
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
    assert "Highest: descriptor=sift classifier.clusters=4: 55.50 %, average of 2 homes" in text
    assert "test_home=H2: no number: too few" in text
    assert "failed: no memory" in text
    assert "failed: it left no result" in text


def test_spread_is_the_range_of_the_seeds(tmp_path):
    frame = summary.as_frame(made(tmp_path))
    assert frame["spread"].tolist()[0] == 1.0
    assert frame["note"].tolist()[:3] == ["", "too few", "no memory"]


def test_homes_alone_are_averaged_below(tmp_path):
    for number, value in enumerate((40.0, 60.0)):
        files.write_json(tmp_path / str(number) / output.RESULT, result(f"H{number}", value))
    ran = summary.read(tmp_path, [{"test_home": "H0"}, {"test_home": "H1"}])
    assert summary.grid(ran)["accuracy"].to_dict() == {"H0": "40.00", "H1": "60.00", "average": "50.00"}
    assert summary.highest(ran) == ({}, 50.0)
