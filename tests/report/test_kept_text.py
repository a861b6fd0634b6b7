"""The text about a comparison, with remedies."""

import pytest

from placecat.report.kept import Comparison, TableDifference, Turned
from placecat.report.kept_text import sentences


def table(name="table_12", cells=84, differing=0, largest=0.0, where="", appeared=0, disappeared=0):
    return TableDifference(name, cells, differing, largest, where, appeared, disappeared)


def said(*tables, data=None, findings=0, turned=(), settings=()):
    return sentences(Comparison(tables, data, findings, turned), 2.0, "git HEAD", settings)


def test_equal_tables_take_one_line():
    assert said(table(), table("table_13", 16)) == ["Tables: 100 of 100 cells equal the old ones (git HEAD)."]


def test_small_differences_are_named_with_their_place():
    lines = said(table(differing=3, largest=0.31, where="HOG + y-Pos, Home 6, 196"), table("table_13", 16))
    assert lines == [
        "Tables: 97 of 100 cells equal the old ones (git HEAD); largest difference 0.31 points in "
        "Table 12 (HOG + y-Pos, Home 6, 196), within the tolerance of 2 points (reproducibility.tolerance).",
        "  Table 12: 3 of 84 cells differ, by at most 0.31 points",
    ]


def test_large_differences_have_a_remedy():
    lines = said(table(differing=1, largest=2.5, where="HOG"), table("table_13", differing=1, appeared=1))
    assert "beyond the tolerance of 2 points" in lines[0]
    assert "; 1 gained a number." in lines[0]
    assert lines[-1].startswith("A different kind of processor does not explain this.")
    assert "commit reports/" in lines[-1]


def test_after_other_settings_nothing_is_wrong():
    lines = said(table(differing=1, largest=9.5, where="HOG"), settings=["a.b", "a.c", "d", "e", "f"])
    assert lines[-1] == "Settings differ: a.b, a.c, d, and 2 more. Expect differences."
    assert "Settings differ" not in " ".join(said(table(), settings=["a.b"]))


@pytest.mark.parametrize(
    ("tables", "line"),
    [
        (
            [table(cells=0)],
            "Tables are not compared: the old ones (git HEAD) were measured on A, the new ones on B.",
        ),
        (
            [table()],
            "Some cells of the tables are not compared: the old ones (git HEAD) were measured on A, "
            "the new ones on B.",
        ),
    ],
)
def test_other_data_are_named(tables, line):
    assert said(*tables, data=("A", "B"))[0] == line


def test_tables_without_any_number_are_not_called_equal():
    assert said(table(cells=0)) == [
        "Tables are not compared: neither the new nor the old ones (git HEAD) have a number."
    ]


def test_verdicts_are_counted_and_turned_ones_named():
    assert said(table(), findings=34)[-1] == "Findings: 34 of 34 verdicts equal the old ones."
    lines = said(table(), findings=34, turned=(Turned("12", "holds", "undecided"),))
    assert lines[-1] == (
        "Findings: 33 of 34 verdicts equal the old ones; finding 12 was 'holds' and is now 'undecided'."
    )


def test_a_long_list_is_cut():
    tables = [table(f"table_{n:02d}", differing=1, largest=n / 100, where="x") for n in range(1, 16)]
    lines = said(*tables)
    assert lines[1] == "  Table 15: 1 of 84 cells differ, by at most 0.15 points"
    assert lines[-1] == "  and 5 more tables by less"
    assert len(lines) == 12
