"""Look up numbers by their location in the thesis."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import pandas as pd

from placecat import files, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation.trials import AXES
from placecat.thesis.number import AVERAGE

_TRIAL = re.compile(r"trials/table_(\d+)/(.*)\|(.*)\|(.*)")


@dataclass(frozen=True)
class Published:
    """All numbers in the thesis.

    `tables` has the columns table (int), group, row, column (all strings) and value, which is NaN for "n/a".
    `text` contains the numbers outside the tables. Its columns are name, section, quantity, home (all
    strings) and value.
    """

    tables: pd.DataFrame
    text: pd.DataFrame

    def number(self, reference: Mapping[str, Any], home: str = AVERAGE) -> float:
        """Look up one number, which is NaN where the thesis says "n/a" or gives no figure.

        `reference` takes one of three forms. ``{table, group, row, column}`` contains the published labels,
        without the axes that the table lacks. ``{text, quantity, home}`` names a number in the text;
        quantity and home are needed only if there are several numbers of that name. For ``{result}``, see
        :meth:`of_trial`, which also explains `home`. Raises PlacecatError if the thesis has no such number,
        or more than one.
        """
        if "result" in reference:
            return self.of_trial(reference["result"], home)
        if "text" in reference:
            settings.refuse_unknown(reference, ["text", "quantity", "home"], "a number in the text")
            asked = {axis: reference[axis] for axis in ("quantity", "home") if axis in reference}
            rows = self._of_text.get(reference["text"], [])
            found = [value for own, value in rows if all(own[axis] == label for axis, label in asked.items())]
        else:
            settings.refuse_unknown(reference, ["table", *AXES], "a published cell")
            labels = tuple(str(reference.get(axis, "")) for axis in AXES)
            cells = self._cells.get(int(reference["table"]), [])
            found = [value for own, value in cells if own == labels]
        return self._only(found, reference)

    def of_trial(self, result: str, home: str = AVERAGE) -> float:
        """Return the published number of a result that is a table cell, or NaN for any other result.

        An example is ``trials/table_12/HOG + y-Pos||196``, in which the empty label stands for the axis of
        homes. `home` is a home's published label on this axis. It is ignored if the table has a single home.
        """
        match = _TRIAL.fullmatch(result)
        if match is None:
            return float("nan")
        asked = match.groups()[1:]
        found = [
            (own, value)
            for own, value in self._cells.get(int(match[1]), [])
            if all(label in ("", one) for label, one in zip(asked, own, strict=True))
        ]
        if len(found) > 1:
            empty = [axis for axis, label in enumerate(asked) if not label]
            found = [(own, value) for own, value in found if home in [own[axis] for axis in empty]]
        return self._only([value for _, value in found], result)

    # These are plain containers, because searching with pandas takes a hundred times as long.
    @cached_property
    def _cells(self) -> dict[int, list[tuple[tuple[str, ...], float]]]:
        """Each cell's labels and value, by table number."""
        cells: dict[int, list[tuple[tuple[str, ...], float]]] = {}
        columns = self.tables[["table", *AXES, "value"]]
        for table, *labels, value in columns.itertuples(index=False, name=None):
            cells.setdefault(int(table), []).append((tuple(labels), float(value)))
        return cells

    @cached_property
    def _of_text(self) -> dict[str, list[tuple[dict[str, str], float]]]:
        """The quantity, home and value of each number in the text, by name."""
        rows: dict[str, list[tuple[dict[str, str], float]]] = {}
        columns = self.text[["name", "quantity", "home", "value"]]
        for name, quantity, home, value in columns.itertuples(index=False, name=None):
            rows.setdefault(name, []).append(({"quantity": quantity, "home": home}, float(value)))
        return rows

    @staticmethod
    def _only(found: list[float], asked: object) -> float:
        if len(found) != 1:
            raise PlacecatError(
                f"the thesis has {len(found) or 'no'} numbers for {asked}: expected exactly one"
            )
        return found[0]


def read_published() -> Published:
    """Read all of the thesis's numbers from data/thesis; raise PlacecatError if a file is damaged."""
    return Published(
        files.read_table(paths.PUBLISHED, AXES),
        files.read_table(paths.PUBLISHED_TEXT, ["name", "section", "quantity", "home", "quote"]),
    )
