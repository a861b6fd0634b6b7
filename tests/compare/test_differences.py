"""Finding, counting, judging and describing the differences between tables."""

import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.compare.differences import (
    NONE,
    Comparison,
    TableDifference,
    Turned,
    compare,
    sentences,
)

# The title must not be split at its semicolon.
DATA = "made homes; second floor"


def filled(*numbers, data=DATA, spreads=None):
    """Make a table with one row per number; None becomes a row with a reason."""
    spreads = spreads or [""] * len(numbers)
    rows = [
        (
            "12",
            "",
            "HOG + y-Pos",
            f"Home {place + 1}",
            "30.0",
            "" if number is None else str(number),
            str(spread),
            "0",
            "too few homes" if number is None else f"measured on {data}",
            data,
        )
        for place, (number, spread) in enumerate(zip(numbers, spreads, strict=True))
    ]
    columns = ["table", "group", "row", "column", "published", "measured", "spread", "seeds", "note", "data"]
    return pd.DataFrame(rows, columns=columns)


def of_one(now, kept):
    (table,) = compare({"table_12": now}, {"table_12": kept}).tables
    return table


def test_identical_tables_do_not_differ():
    tables = {"table_12": filled(31.2, None, 20.0)}
    found = compare(tables, tables)
    assert (found.cells, found.differing, found.largest) == (2, 0, None)
    assert not found.exceeds(0.0)


def test_the_largest_difference_is_located():
    found = of_one(filled(31.2, 20.1, 7.0), filled(31.2, 20.0, 7.3))
    assert (found.cells, found.differing, found.largest) == (3, 2, 0.3)
    assert found.where == "HOG + y-Pos, Home 3"
    assert found.label == "Table 12"


@pytest.mark.parametrize(
    ("moved", "exceeds"), [(0.0, False), (0.01, False), (2.0, False), (2.01, True), (-2.01, True)]
)
def test_a_difference_equal_to_the_tolerance_is_accepted(moved, exceeds):
    # 0.1 + 2.0 - 0.1 is not 2.0 in floating point.
    now, kept = filled(round(20.1 + moved, 2), 5.0), filled(20.1, 5.0)
    assert compare({"table_12": now}, {"table_12": kept}).exceeds(2.0) == exceeds


@pytest.mark.parametrize(
    ("now", "kept", "appeared", "disappeared"),
    [
        (filled(1.0, 2.0), filled(1.0, None), 1, 0),
        (filled(1.0, None), filled(1.0, 2.0), 0, 1),
        (filled(1.0, 2.0), filled(1.0), 1, 0),
        (filled(1.0), None, 1, 0),
        (None, filled(1.0, None, 3.0), 0, 2),
        (filled(1.0, None), filled(1.0), 0, 0),
    ],
    ids=["filled", "emptied", "new cell", "new table", "no such table any more", "new reason"],
)
def test_appearing_and_disappearing_numbers_exceed_any_tolerance(now, kept, appeared, disappeared):
    sides = [{} if table is None else {"table_12": table} for table in (now, kept)]
    found = compare(*sides)
    (table,) = found.tables
    assert (table.appeared, table.disappeared, table.differing) == (
        appeared,
        disappeared,
        appeared + disappeared,
    )
    assert found.exceeds(100.0) == bool(appeared or disappeared)


def test_a_changed_spread_is_a_difference():
    found = of_one(filled(31.2, spreads=[1.5]), filled(31.2, spreads=[1.4]))
    assert (found.differing, found.largest) == (1, 0.0)


def test_tables_without_spreads_can_be_compared():
    table = filled(31.2, None).drop(columns=["spread", "seeds"])
    assert compare({"table_12": table}, {"table_12": table}).differing == 0


def test_numbers_in_memory_equal_their_text_on_disk():
    """The content of a table is the same in memory and in its file."""
    text = filled(31.2, None, 20.0)
    numbers = text.assign(measured=pd.to_numeric(text["measured"]), spread=pd.to_numeric(text["spread"]))
    assert compare({"table_12": numbers}, {"table_12": text}).differing == 0


def test_tables_on_different_data_are_not_compared():
    findings = pd.DataFrame({"number": [1], "verdict": ["holds"]})
    found = compare(
        {"table_12": filled(1.0, None, data="my homes")},
        {"table_12": filled(2.0, 3.0), "table_13": filled(3.0)},
        findings,
        findings,
    )
    assert found.data == (DATA, "my homes")
    assert (found.cells, found.findings) == (0, 0)
    assert not found.exceeds(2.0)


def test_cells_of_the_same_data_are_still_compared():
    """A user's data set does not change the tables of other data sets."""
    now = {"table_12": filled(1.0, data="my homes"), "table_30": filled(9.0, data="university")}
    kept = {"table_12": filled(2.0), "table_30": filled(9.5, data="university")}
    found = compare(now, kept)
    assert found.cells == 1
    assert found.largest.name == "table_30"


def test_changed_verdicts_are_listed_but_never_exceed_the_tolerance():
    kept = pd.DataFrame({"number": ["1", "2", "3"], "verdict": ["holds", "undecided", "holds"]})
    now = pd.DataFrame({"number": [1, 2, 4], "verdict": ["holds", "holds", "undecided"]})
    tables = {"table_12": filled(31.2)}
    found = compare(tables, tables, now, kept)
    assert found.findings == 4
    assert found.turned == (
        Turned("2", "undecided", "holds"),
        Turned("4", NONE, "undecided"),
        Turned("3", "holds", NONE),
    )
    assert not found.exceeds(0.0)


def test_numbers_in_the_text_are_identified_by_their_own_labels():
    kept = pd.DataFrame(
        {
            "name": ["gist"] * 2,
            "section": ["4.2"] * 2,
            "quantity": ["without colour", "with colour"],
            "home": ["Home 6"] * 2,
            "published": ["35.41", "38.67"],
            "measured": ["30.0", "31.0"],
            "data": [DATA] * 2,
        }
    )
    (table,) = compare({"in_text": kept.assign(measured=["30.0", "30.2"])}, {"in_text": kept}).tables
    assert (table.cells, table.differing, table.largest) == (2, 1, 0.8)
    assert table.where == "gist, 4.2, with colour, Home 6"
    assert table.label == "in text"


percent = st.one_of(st.none(), st.decimals(0, 100, places=2).map(float))


@given(st.lists(st.tuples(percent, percent), min_size=1, max_size=8))
def test_comparison_is_symmetric(pairs):
    now, kept = (filled(*numbers) for numbers in zip(*pairs, strict=True))
    there, back = of_one(now, kept), of_one(kept, now)
    assert (there.cells, there.differing, there.largest) == (back.cells, back.differing, back.largest)
    assert (there.appeared, there.disappeared) == (back.disappeared, back.appeared)
    assert there.differing == sum(one != other for one, other in pairs)
    moved = [abs(one - other) for one, other in pairs if one is not None and other is not None]
    assert there.largest == pytest.approx(max(moved, default=0.0), abs=0.005)


def table(name="table_12", cells=84, differing=0, largest=0.0, where="", appeared=0, disappeared=0):
    return TableDifference(name, cells, differing, largest, where, appeared, disappeared)


def said(*tables, data=None, findings=0, turned=(), settings=()):
    return sentences(Comparison(tables, data, findings, turned), 2.0, "git HEAD", settings)


def test_equal_tables_take_one_line():
    assert said(table(), table("table_13", 16)) == ["Tables: 100 of 100 cells match the old ones (git HEAD)."]


def test_small_differences_are_reported_with_their_location():
    lines = said(table(differing=3, largest=0.31, where="HOG + y-Pos, Home 6, 196"), table("table_13", 16))
    assert lines == [
        "Tables: 97 of 100 cells match the old ones (git HEAD); largest difference 0.31 points in "
        "Table 12 (HOG + y-Pos, Home 6, 196), within the tolerance of 2 points (reproducibility.tolerance).",
        "  Table 12: 3 of 84 cells differ, by at most 0.31 points",
    ]


def test_large_differences_come_with_advice():
    lines = said(table(differing=1, largest=2.5, where="HOG"), table("table_13", differing=1, appeared=1))
    assert "beyond the tolerance of 2 points" in lines[0]
    assert "; 1 gained a number." in lines[0]
    assert lines[-1].startswith("A different processor does not explain these differences.")
    assert "commit reports/" in lines[-1]


def test_changed_settings_explain_differences():
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
def test_different_data_sets_are_named(tables, line):
    assert said(*tables, data=("A", "B"))[0] == line


def test_empty_tables_are_not_called_equal():
    assert said(table(cells=0)) == [
        "Tables are not compared: neither the new nor the old ones (git HEAD) have a number."
    ]


def test_verdicts_are_counted_and_changed_ones_named():
    assert said(table(), findings=34)[-1] == "Findings: 34 of 34 verdicts match the old ones."
    lines = said(table(), findings=34, turned=(Turned("12", "holds", "undecided"),))
    assert lines[-1] == (
        "Findings: 33 of 34 verdicts match the old ones; finding 12 was 'holds' and is now 'undecided'."
    )


def test_long_lists_are_truncated():
    tables = [table(f"table_{n:02d}", differing=1, largest=n / 100, where="x") for n in range(1, 16)]
    lines = said(*tables)
    assert lines[1] == "  Table 15: 1 of 84 cells differ, by at most 0.15 points"
    assert lines[-1] == "  and 5 more tables, with smaller differences"
    assert len(lines) == 12
