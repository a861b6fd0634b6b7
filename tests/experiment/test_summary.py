"""The summary of a sweep."""

from types import SimpleNamespace

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
    return summary.read(tmp_path, combinations, SWEPT)


def test_a_sweep_reads_as_a_table_does(tmp_path):
    text = summary.text(made(tmp_path), SWEPT)
    assert text.splitlines()[2:12] == [
        "                       classifier.clusters",
        "descriptor  test_home      4      16",
        "----------  ---------  -----  ------",
        "hog         H1         10.50  failed",
        "            H2             -   40.50",
        "            average    10.50   40.50",
        "sift        H1         50.50   70.50",
        "            H2         60.50  failed",
        "            average    55.50   70.50",
        "",
    ]
    assert "Highest: descriptor=sift classifier.clusters=4: 55.50 %, average of 2 homes" in text
    assert "test_home=H2: no number: too few" in text
    assert "failed: no memory" in text
    assert "failed: it left no result" in text


def test_spread_is_the_range_of_the_seeds(tmp_path):
    frame = summary.as_frame(made(tmp_path), SWEPT)
    assert frame["spread"].tolist()[0] == 1.0
    assert frame["note"].tolist()[:3] == ["", "too few", "no memory"]


def test_an_earlier_sweep_in_the_same_folder_is_no_result(tmp_path):
    made(tmp_path)
    config = SimpleNamespace(hydra=SimpleNamespace(sweep=SimpleNamespace(dir=str(tmp_path))))
    output.Remember().on_multirun_start(config)
    assert not list(tmp_path.glob("*/result.json"))
