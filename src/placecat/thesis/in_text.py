"""The numbers that appear only in the thesis's text, as measured and as published."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import pandas as pd

from placecat import files, paths, settings
from placecat.errors import PlacecatError
from placecat.results.measured import Results
from placecat.thesis import definitions
from placecat.thesis.comparison import Line, alone, compare
from placecat.thesis.notes import Kind, Note
from placecat.thesis.number import nothing
from placecat.thesis.records import read_off, read_records
from placecat.thesis.tables import number_columns

COLUMNS = ["name", "section", "quantity", "home", "published", "measured", "spread", "seeds", "note"]
# The table's name, and the columns that identify a number.
NAME = "in_text"
KEY = ["name", "quantity", "home"]
_OF_THE_DATA = ("thesis_data", "data", "split")


class _Said(NamedTuple):
    """What the thesis says about a quantity: a number (NaN if only in words), the words, and a note."""

    value: float = np.nan
    quote: str = ""
    note: str = ""


def fill(results: Results, params: Mapping[str, Any]) -> pd.DataFrame:
    """Compute the numbers in the thesis's text (see :func:`in_text`), using the files in data/thesis.

    Raises PlacecatError if one of these files is damaged, or if a stage's record is missing.
    """
    columns = ["name", "section", "quantity", "home", "quote", "note"]
    return in_text(
        definitions.in_text(),
        results,
        files.read_table(paths.PUBLISHED_TEXT, columns),
        settings.get(params, "dataset"),
        {name: split["dataset"] for name, split in settings.get(params, "splits").items()},
        read_records(params),
    )


def in_text(
    entries: Mapping[str, Mapping[str, Any]],
    results: Results,
    published: pd.DataFrame,
    dataset: Mapping[str, Any],
    splits: Mapping[str, Mapping[str, Any]],
    records: Mapping[str, pd.DataFrame],
) -> pd.DataFrame:
    """Compare the measured numbers with those in the thesis's text.

    Returns a table with the columns name, section, quantity and home ("Home 6", "Average", or "" for
    neither), followed by the columns of :func:`~placecat.thesis.tables.fill_table` from ``published`` on. A
    comparison has one row for each side, and one for the difference (variant minus baseline, in points).
    Raises PlacecatError for an unknown setting or result, an entry without a published row, or a published
    row without an entry.

    Parameters
    ----------
    entries
        Maps the name of each entry to its settings (see data/thesis/in_text.yaml). These are the settings of
        :func:`~placecat.thesis.comparison.alone` if they include ``result``, of
        :func:`~placecat.thesis.records.read_off` if they include ``record``, and otherwise of
        :func:`~placecat.thesis.comparison.compare`. Each entry also has ``thesis_data``. If it was not
        measured on the main data set, ``split`` names its data set, or ``data`` describes it in words. An
        entry that was not measured has only a ``reference``, which gives the reason.
    published
        Table with the columns name, section, quantity, home, value (NaN if the thesis gives no number), quote
        and note. The note lists passages in the thesis that contradict the value.
    dataset, splits
        ``title`` and ``thesis_data`` of the main data set, and of each split's data set.
    records
        The tables from :func:`~placecat.thesis.records.read_records`, by name.
    """
    sections = dict(zip(published["name"], published["section"], strict=True))
    if more := [name for name in entries if name not in sections]:
        raise PlacecatError(f"in_text has an entry {more[0]!r} that is not among the published numbers")
    if more := [name for name in sections if name not in entries]:
        raise PlacecatError(f"the published number {more[0]!r} has no entry in in_text")
    columns = published[["name", "quantity", "home", "value", "quote", "note"]]
    said = {
        (name, quantity, home): _Said(float(value), quote, note)
        for name, quantity, home, value, quote, note in columns.itertuples(index=False, name=None)
    }
    rows = []
    for name, entry in entries.items():
        known = [(quantity, home) for of_entry, quantity, home in said if of_entry == name]
        measured_on = splits[entry["split"]] if "split" in entry else dataset
        for quantity, home, number in _lines(name, entry, results, records, known):
            words = said.get((name, quantity, home), _Said())
            quoted = f'the thesis says "{words.quote}"' if words.quote else ""
            notes = [Note(Kind.PUBLISHED, text) for text in (words.note, quoted)]
            measured = number_columns(number, words.value, notes, entry, measured_on)
            rows.append((name, str(sections[name]), quantity, home, *measured))
    return pd.DataFrame(rows, columns=[*COLUMNS, "notes", "number"])


def _lines(
    name: str,
    entry: Mapping[str, Any],
    results: Results,
    records: Mapping[str, pd.DataFrame],
    known: Sequence[tuple[str, str]],
) -> list[Line]:
    where = f"in_text.{name}"
    rest = {key: value for key, value in entry.items() if key not in _OF_THE_DATA}
    if "reference" in entry:
        settings.refuse_unknown(entry, ["reference"], where)
        return [Line(quantity, home, nothing(str(entry["reference"]))) for quantity, home in known]
    if "record" in entry:
        return read_off(rest, records, where)
    return (alone if "result" in entry else compare)(rest, results, where)
