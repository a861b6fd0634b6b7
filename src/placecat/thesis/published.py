"""The thesis's numbers, looked up by their place in it."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import pandas as pd

from placecat import settings
from placecat.errors import PlacecatError
from placecat.thesis.number import AVERAGE

_AXES = ("group", "row", "column")
_TRIAL = re.compile(r"trials/table_(\d+)/(.*)\|(.*)\|(.*)")


@dataclass(frozen=True)
class Published:
    """All numbers of the thesis: `tables` has the columns table (int), group, row, column (text) and value.

    NaN is an n/a. `text`, numbers outside the tables, has name, section, quantity, home (text) and value.
    """

    tables: pd.DataFrame
    text: pd.DataFrame

    def number(self, reference: Mapping[str, Any], home: str = AVERAGE) -> float:
        """Look up one number; NaN if the thesis has an n/a or no number.

        `reference` is ``{table, group, row, column}``, labels as published, without the axes that the table
        lacks; or ``{text, quantity, home}``, the name of a number in the text and, if the name has several,
        which one; or ``{result}``, as for :meth:`of_trial`, which also explains `home`. Raises PlacecatError
        if the thesis has no such number, or several.
        """
        if "result" in reference:
            return self.of_trial(reference["result"], home)
        if "text" in reference:
            settings.refuse_unknown(reference, ["text", "quantity", "home"], "a number in the text")
            found = self.text[self.text["name"] == reference["text"]]
            for column in {"quantity", "home"} & reference.keys():
                found = found[found[column] == reference[column]]
        else:
            settings.refuse_unknown(reference, ["table", *_AXES], "a published cell")
            found = self.tables[self.tables["table"] == int(reference["table"])]
            labels = [str(reference.get(axis, "")) for axis in _AXES]
            found = found[(found[list(_AXES)] == labels).all(axis=1)]
        return self._only(found, reference)

    def of_trial(self, result: str, home: str = AVERAGE) -> float:
        """The published number of a result that is a cell of a table, NaN for any other result.

        E.g. ``trials/table_12/HOG + y-Pos||196``; the empty label is the axis of homes. It is the number of
        that home, as published; a table of a single home has no other.
        """
        match = _TRIAL.fullmatch(result)
        if match is None:
            return float("nan")
        found = self.tables[self.tables["table"] == int(match[1])]
        empty = []
        for axis, label in zip(_AXES, match.groups()[1:], strict=True):
            if label:
                found = found[found[axis] == label]
            else:
                empty.append(axis)
        if len(found) > 1:
            found = found[(found[empty] == home).any(axis=1)]
        return self._only(found, result)

    @staticmethod
    def _only(found: pd.DataFrame, asked: object) -> float:
        if len(found) != 1:
            raise PlacecatError(f"the thesis has {len(found) or 'no'} numbers for {asked}, one is needed")
        return float(found["value"].iloc[0])
