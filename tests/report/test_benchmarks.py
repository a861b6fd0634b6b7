import cv2
import numpy as np
import pytest

import made_report
from placecat.drawing.style import png_of
from placecat.report.benchmarks import MISSED, TEXT, ratios_of, shown_speed, speed_chart, times
from placecat_bench.comparison import Comparison, Peer


def test_only_comparisons_have_ratios():
    ratios = ratios_of(made_report.benchmarks())
    assert list(ratios["piece"]) == ["HOG", "A tree", "A frame"]
    assert [(one.ratio, one.target, one.is_faster, one.met) for one in ratios.itertuples()] == [
        (1.7, 2.0, True, False),
        (500.0, 500.0, True, True),
        (5.3, 7.0, False, True),
    ]


def test_rows_are_formatted_for_the_page():
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


def test_targets_are_parsed_as_the_benchmarks_write_them():
    peer, nothing = Peer("pip", "pip"), lambda: None
    table = made_report.benchmarks()[:1]
    for targets, expected in (({"faster": 2.5}, (2.5, True)), ({"at_most": 4.5}, (4.5, False))):
        written = Comparison("", "", peer, nothing, nothing, **targets).target
        (one,) = ratios_of(table.assign(target=written)).itertuples()
        assert (one.target, one.is_faster) == expected


def test_all_text_columns_are_listed():
    table = made_report.benchmarks()
    assert {name for name in table.columns if table[name].dtype == np.float64} == set(table.columns) - set(
        TEXT
    )


@pytest.mark.parametrize(
    ("ratio", "text"), [(2.196, "2.2"), (46.58, "46.6"), (999.4, "999"), (1415.0, "1,415")]
)
def test_ratios_are_formatted(ratio: float, text: str):
    assert times(ratio) == text


def test_bars_show_ratios_and_marks_show_targets():
    figure = speed_chart(made_report.benchmarks())
    faster, at_most = figure.axes
    assert [bar.get_width() + bar.get_x() for bar in faster.patches] == [1.7, 500.0]
    assert [bar.get_width() for bar in at_most.patches] == [5.3]
    marks = {line.get_label(): list(line.get_xdata()) for line in faster.lines}
    assert marks["target"] == [2.0, 500.0]
    assert (faster.get_xscale(), at_most.get_xscale()) == ("log", "linear")
    assert [label.get_text() for label in faster.get_yticklabels()] == [
        "HOG, 25 regions",
        "A tree, 124 & more",
    ]


def test_a_missed_target_has_another_colour():
    colors = [bar.get_facecolor()[:3] for bar in speed_chart(made_report.benchmarks()).axes[0].patches]
    missed = tuple(int(MISSED[place : place + 2], 16) / 255 for place in (1, 3, 5))
    np.testing.assert_allclose(colors[0], missed)
    assert colors[1] != colors[0]


def test_there_is_no_chart_without_comparisons():
    table = made_report.benchmarks()
    assert png_of(speed_chart, table[table["ratio"].isna()]) is None


def test_the_chart_is_reproducible():
    once = png_of(speed_chart, made_report.benchmarks())
    assert once == png_of(speed_chart, made_report.benchmarks())
    assert cv2.imdecode(np.frombuffer(once, np.uint8), cv2.IMREAD_COLOR).shape[1] == 1300
