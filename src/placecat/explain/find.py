"""Look up cells by number, or by table and labels."""

import difflib
import re
from collections.abc import Mapping, Sequence
from typing import Any

from placecat import paths
from placecat.errors import PlacecatError
from placecat.provenance.lines import lines_of

# Maximum number of cells to explain. If more cells match, the error message lists a few of them.
MOST = 4
_NAMED = 8
_LABELS = ("group", "row", "column")


def find(words: Sequence[str], content: Mapping[str, Any]) -> list[str]:
    """Find the numbers of the cells that match the words.

    The words are either a cell's number, such as ``table_26.9.3``, or a table's name followed by labels of
    groups, rows or columns in any order, such as ``table_26 HMM home_3``. A word that is not a complete label
    may match part of one. `content` comes from :func:`placecat.provenance.text.explanations`. Raises
    PlacecatError if no cells or more than `MOST` cells match; the message suggests what to use instead.
    """
    name, *labels = words
    cells = content["cells"]
    if not labels and name in cells:
        return [name]
    tables = list(dict.fromkeys(number.partition(".")[0] for number in cells))
    if name not in tables:
        near = difflib.get_close_matches(name, cells if "." in name else tables, n=4)
        there = [number for number in cells if number.rpartition(".")[0] == name.rpartition(".")[0]]
        hint = (
            f"did you mean {' or '.join(near or there[:4])}?"
            if near or there
            else f"use one of {', '.join(tables)}"
        )
        raise PlacecatError(f"{paths.EXPLANATIONS} has no cell or table {name!r}; {hint}")
    found = {number: _labels(number, content) for number in cells if number.startswith(f"{name}.")}
    for label in labels:
        wanted = _plain(label)
        equal = {number: of for number, of in found.items() if wanted in of}
        part = {number: of for number, of in found.items() if any(wanted in one for one in of)}
        if not equal and not part:
            known = list(dict.fromkeys(one for of in found.values() for one in of))
            near = difflib.get_close_matches(wanted, known, n=4, cutoff=0.4) or known[:_NAMED]
            raise PlacecatError(
                f"{name} has no matching cell with the label {label!r}; "
                f"did you mean {' or '.join(map(repr, near))}?"
            )
        found = equal or part
    if len(found) > MOST:
        some = "; ".join(f"{number} is {', '.join(of)}" for number, of in list(found.items())[:_NAMED])
        more = f"; and {len(found) - _NAMED} more" if len(found) > _NAMED else ""
        raise PlacecatError(
            f"{' '.join(words)} matches {len(found)} cells: add a label or use a cell's number ({some}{more})"
        )
    return list(found)


def _labels(number: str, content: Mapping[str, Any]) -> list[str]:
    return [_plain(text) for label, text in lines_of(content, number) if label in _LABELS]


def _plain(label: str) -> str:
    """Normalize a label: "home_3" and "Home 3" both become "home 3"."""
    return re.sub(r"[\s_]+", " ", label).strip().casefold()
