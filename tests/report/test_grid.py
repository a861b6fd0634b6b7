import numpy as np
import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st

from made_report import CLASSES, HOMES, addition, cells
from placecat.report.grid import (
    NUMBERS,
    STEPS,
    homes_sentence,
    legend,
    make_cell,
    make_grid,
    number_text,
    seeds_sentence,
    shade,
)
from placecat.thesis.notes import Kind, Note

COLUMNS = ["table", "group", "row", "column", "published", "measured", "spread", "seeds", "notes"]


def made(*rows):
    return pd.DataFrame([(1, *row) for row in rows], columns=COLUMNS)


def test_every_cell_is_in_its_row_and_column():
    table = cells(26, np.random.default_rng(0))
    grid = make_grid(table)
    assert grid.columns == (*(f"Home {number}" for number in range(1, 7)), "Average")
    assert [(group.name, len(group.rows)) for group in grid.groups] == [
        ("4-5-1, all cues", 9),
        ("5-5-1, all cues", 9),
        ("5-5-1, HOG+SIFT+Centrist+Gist+holistic Centrist", 2),
    ]
    shown = {
        (group.name, row.name, column): cell
        for group in grid.groups
        for row in group.rows
        for column, cell in zip(grid.columns, row.cells, strict=True)
    }
    assert len(shown) == len(table)
    for cell in table.itertuples():
        one = shown[cell.group, cell.row, cell.column]
        assert (one.measured, one.published) == (f"{cell.measured:.2f}", f"{cell.published:.2f}")
        assert one.difference == pytest.approx(cell.measured - cell.published, abs=0.006)
        assert (one.spread, one.seeds) == (cell.spread, 2)
    assert grid.footnotes == {}


def test_additional_cells_precede_the_average():
    table = made(
        ("", "a", "Home 1", 1.0, 1.0, np.nan, 0, ()),
        ("", "a", "Average", 1.0, 1.0, np.nan, 0, ()),
        ("", "Average", "Home 1", 1.0, 1.0, np.nan, 0, ()),
        ("", "a", "Home 7", np.nan, 2.0, np.nan, 0, ()),
        ("", "b", "Home 7", np.nan, 3.0, np.nan, 0, ()),
    )
    grid = make_grid(table)
    assert grid.columns == ("Home 1", "Home 7", "Average")
    assert [row.name for row in grid.groups[0].rows] == ["a", "b", "Average"]
    assert [cell.measured for cell in grid.groups[0].rows[1].cells] == ["", "3.00", ""]


def test_notes_become_footnotes_on_their_numbers():
    contradiction = Note(Kind.PUBLISHED, "row and average differ")
    # The kind of a note is independent of its text, and a semicolon does not split a note.
    title = Note(Kind.DATA, "measured on my homes; second floor")
    no_home = Note(Kind.MEASURED, "no such home")
    not_available = Note(Kind.NOT_AVAILABLE, "the published cell is n/a")
    other = Note(Kind.NOT_COMPARABLE, "the published number is from the v")
    of_one = Note(Kind.MEASURED, "measured on one home; the published number is from two")
    table = made(
        ("", "a", "x", 1.0, np.nan, np.nan, 0, (no_home,)),
        ("", "a", "y", 1.0, 2.0, np.nan, 0, (title, contradiction)),
        ("", "b", "x", np.nan, np.nan, np.nan, 0, (no_home, not_available)),
        ("", "b", "y", 1.0, 2.0, np.nan, 0, (title, other, of_one)),
    )
    grid = make_grid(table)
    assert grid.footnotes == {"a": "no such home", "b": contradiction.text, "c": of_one.text}
    (first, second), (third, fourth) = (row.cells for row in grid.groups[0].rows)
    assert (first.mark, first.published_mark, first.difference) == ("a", "", None)
    assert (second.mark, second.published_mark) == ("", "b")
    assert (third.mark, third.published, third.published_mark) == ("a", "n/a", "")
    assert fourth.mark == "c"


def test_an_addition_has_no_published_numbers():
    grid = make_grid(addition().cells)
    assert not grid.has_published
    assert not any(row.has_published for row in grid.groups[0].rows)
    assert make_grid(cells(5)).has_published


def made_cell(*numbers):
    return make_cell(dict(zip(NUMBERS, numbers, strict=True)))


def test_numbers_have_two_decimals_or_are_empty():
    assert number_text(3) == "3.00"
    assert number_text(float("nan")) == number_text(None) == ""
    assert made_cell(np.nan, 3.0, np.nan, 0).difference is None
    assert made_cell(2.5, 3.0, float("nan"), 0).difference == -0.5
    assert made_cell(2.5, np.nan, 1.25, 2).spread == 1.25


def test_the_sentence_on_seeds_names_the_widest_cell():
    table = made(
        ("g", "a", "x", 1.0, 2.0, 0.5, 2, ""),
        ("g", "a", "y", 1.0, 2.0, 1.5, 2, ""),
        ("g", "b", "y", 1.0, 2.0, np.nan, 0, ()),
    )
    assert seeds_sentence(table) == (
        "Numbers that depend on the seed are means over 2 seeds. The seeds differ by 1.00 points in the "
        "median cell and by at most 1.50 points (g, a, y)."
    )
    assert seeds_sentence(table[:2]).startswith("Numbers are means over 2 seeds. ")
    assert seeds_sentence(table[2:]) == ""


def test_homes_with_other_names_are_listed():
    table = cells(12)
    assert homes_sentence(table, ["flat", *HOMES[1:5], "house"]) == "Home 1 is flat, Home 6 is house."
    assert homes_sentence(table, HOMES) == ""
    assert homes_sentence(cells(30), ["north_1"]) == ""
    assert homes_sentence(cells(6), CLASSES[:1]) == "Home 1 is bedroom."


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
