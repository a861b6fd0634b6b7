import cv2
import numpy as np

import made_report
from placecat.drawing.style import png_of
from placecat.report.benchmarks import MISSED, speed_chart


def test_bars_are_the_ratios_and_marks_the_targets():
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


def test_nothing_compared_is_no_chart():
    table = made_report.benchmarks()
    assert png_of(speed_chart, table[table["ratio"].isna()]) is None


def test_the_picture_has_the_same_bytes_every_time():
    once = png_of(speed_chart, made_report.benchmarks())
    assert once == png_of(speed_chart, made_report.benchmarks())
    assert cv2.imdecode(np.frombuffer(once, np.uint8), cv2.IMREAD_COLOR).shape[1] == 1300
