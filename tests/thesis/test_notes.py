"""Notes of each kind, as text and on disk."""

import pandas as pd

from placecat import files
from placecat.thesis.notes import COLUMNS, Kind, Note, joined, to_rows, with_notes, without_empty

TITLE = Note(Kind.DATA, 'measured on my homes; second floor, "left"')
WHY = Note(Kind.MEASURED, "too few frames")


def cells(*notes):
    rows = [("", f"{number}", "2.50", one) for number, one in enumerate(notes)]
    return pd.DataFrame(rows, columns=["group", "row", "column", "notes"])


def test_notes_survive_a_round_trip_to_disk(tmp_path):
    first, second = cells((TITLE, WHY), (), (WHY,)), cells((TITLE,))
    files.write_csv(tmp_path / "notes.csv", pd.concat([to_rows("one", first), to_rows("two", second)]))
    rows = files.read_table(tmp_path / "notes.csv", COLUMNS)
    for name, table in (("one", first), ("two", second)):
        found = with_notes(name, table.drop(columns="notes"), rows)
        assert found["notes"].tolist() == table["notes"].tolist()


def test_a_table_without_notes_has_none():
    assert with_notes("one", cells(()).drop(columns="notes"), to_rows("two", cells((WHY,))))[
        "notes"
    ].tolist() == [()]


def test_duplicate_texts_are_removed():
    assert joined([WHY, TITLE, WHY._replace(kind=Kind.PUBLISHED)]) == f"{WHY.text}; {TITLE.text}"
    assert without_empty([WHY, Note(Kind.PUBLISHED, ""), WHY]) == (WHY,)
