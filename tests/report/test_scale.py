import pytest

import made_report
from placecat.report.scale import growth_chart


def test_slow_stages_have_a_line_on_logarithmic_axes():
    axes = growth_chart(made_report.scale_measured()).axes[0]
    lines = {line.get_label(): list(line.get_ydata()) for line in axes.lines}
    assert lines == {
        "all stages": [21.5, 61.5, 201.5],
        "trials": [10.0, 40.0, 160.0],
        "codebooks": [10.0, 20.0, 40.0],
        "linear growth": pytest.approx([21.5, 43.0, 86.0]),
    }
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "log")
    assert [label.get_text() for label in axes.get_xticklabels()] == ["1,000", "2,000", "4,000"]


def test_there_is_no_chart_for_a_single_size():
    measured = made_report.scale_measured()
    assert growth_chart(measured[measured["size"] == 1.0]) is None
