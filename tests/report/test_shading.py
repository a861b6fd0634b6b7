import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.report.grid import STEPS, legend, shade


@pytest.mark.parametrize(
    "difference, expected",
    [
        (None, ""),
        (0.0, ""),
        (1.99, ""),
        (-1.99, ""),
        (2.0, "above-1"),
        (-4.99, "below-1"),
        (5.0, "above-2"),
        (-10.0, "below-3"),
        (19.99, "above-3"),
        (80.0, "above-4"),
        (-80.0, "below-4"),
    ],
)
def test_shades(difference, expected):
    assert shade(difference) == expected


@given(st.floats(-100, 100))
def test_shades_are_symmetric(difference):
    assert shade(-difference) == shade(difference).replace("above", "x").replace("below", "above").replace(
        "x", "below"
    )


def test_the_legend_names_every_shade_once_in_order():
    names = [name for name, _ in legend()]
    middles = [*(-point - 0.5 for point in reversed(STEPS)), 0.0, *(point + 0.5 for point in STEPS)]
    assert names == [shade(middle) for middle in middles]
    assert [text for _, text in legend()][:2] == ["20 or more below", "10 to 20 below"]
