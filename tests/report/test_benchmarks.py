import numpy as np
import pytest

import made_report
from placecat.report.benchmarks import TEXT, ratios_of, shown_speed, times
from placecat_bench.comparison import Comparison, Peer


def test_ratios_and_targets_of_comparisons_only():
    ratios = ratios_of(made_report.benchmarks())
    assert list(ratios["piece"]) == ["HOG", "A tree", "A frame"]
    assert [(one.ratio, one.target, one.is_faster, one.met) for one in ratios.itertuples()] == [
        (1.7, 2.0, True, False),
        (500.0, 500.0, True, True),
        (5.3, 7.0, False, True),
    ]


def test_rows_as_a_page_shows_them():
    rows = shown_speed(made_report.benchmarks(), {})["rows"]
    assert rows[0] == {
        "piece": "HOG",
        "input": "25 regions",
        "ours": "1 ms",
        "peer": "OpenCV: compute 4.14.0",
        "theirs": "1.7 ms",
        "ratio": "1.7 (1.6 to 1.9)",
        "target": "at least 2x faster",
        "met": "no",
        "spent": "spent on: resizing 61%",
    }
    assert (rows[1]["piece"], rows[1]["ours"], rows[1]["ratio"]) == ("HOG: difference", "0", "")
    assert (rows[2]["ours"], rows[2]["theirs"]) == ("1.5 s", "750 s")
    assert (rows[4]["piece"], rows[4]["ours"], rows[4]["peer"]) == ("A frame: frames/s", "47.2", "")


def test_the_words_of_a_target_match_the_benchmarks():
    peer, nothing = Peer("pip", "pip"), lambda: None
    table = made_report.benchmarks()[:1]
    for targets, expected in (({"faster": 2.5}, (2.5, True)), ({"at_most": 4.5}, (4.5, False))):
        written = Comparison("", "", peer, nothing, nothing, **targets).target
        (one,) = ratios_of(table.assign(target=written)).itertuples()
        assert (one.target, one.is_faster) == expected


def test_text_columns_are_text():
    table = made_report.benchmarks()
    assert {name for name in table.columns if table[name].dtype == np.float64} == set(table.columns) - set(
        TEXT
    )


@pytest.mark.parametrize(
    ("ratio", "text"), [(2.196, "2.2"), (46.58, "46.6"), (999.4, "999"), (1415.0, "1,415")]
)
def test_ratios_in_words(ratio: float, text: str):
    assert times(ratio) == text
