"""Look up cells by number, or by table and labels."""

import difflib
import re
from collections.abc import Mapping, Sequence
from typing import Any

from placecat import paths
from placecat.errors import PlacecatError
from placecat.provenance.lines import lines_of

LABELS = ("group", "row", "column")
# Maximum number of labels of each kind that a message lists.
_NAMED = 8


def find(words: Sequence[str], content: Mapping[str, Any]) -> list[str]:
    """Find the numbers of the cells that match the words.

    The words are either a cell's number, such as ``table_26.9.3``, or a table's name followed by labels of
    groups, rows or columns in any order, such as ``table_26 HMM home_3``. A word that is not a complete label
    may match part of one. `content` comes from :func:`placecat.provenance.text.explanations`. Raises
    PlacecatError if no cells match; the message suggests what to use instead.
    """
    name, *further = words
    cells = content["cells"]
    if not further and name in cells:
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
    found = {number: labels(number, content) for number in cells if number.startswith(f"{name}.")}
    for word in further:
        wanted = _plain(word)
        plain = {number: [_plain(label) for label in of.values()] for number, of in found.items()}
        equal = [number for number, of in plain.items() if wanted in of]
        part = [number for number, of in plain.items() if any(wanted in label for label in of)]
        if not equal and not part:
            raise PlacecatError(
                f"{name} has no matching cell with the label {word!r}; {_hint(wanted, found)}"
            )
        found = {number: found[number] for number in equal or part}
    return list(found)


def labels(number: str, content: Mapping[str, Any]) -> dict[str, str]:
    """Return the labels of a cell, keyed by "group" (if it has one), "row" and "column"."""
    return {kind: text for kind, text in lines_of(content, number) if kind in LABELS}


def _hint(wanted: str, found: Mapping[str, Mapping[str, str]]) -> str:
    """Suggest similar labels of one kind or, if none is similar, list the labels of each kind."""
    known = {kind: list(dict.fromkeys(of[kind] for of in found.values() if of.get(kind))) for kind in LABELS}
    kinds = {_plain(label): (kind, label) for kind, own in known.items() for label in own}
    near = [kinds[label] for label in difflib.get_close_matches(wanted, kinds, n=4, cutoff=0.5)]
    if near:
        return f"did you mean {' or '.join(repr(label) for kind, label in near if kind == near[0][0])}?"
    lists = {
        kind: ", ".join(map(repr, own[:_NAMED])) + ", ..." * (len(own) > _NAMED)
        for kind, own in known.items()
    }
    return "use " + "; or ".join(f"a {kind}: {text}" for kind, text in lists.items() if text)


def _plain(label: str) -> str:
    """Normalize a label: "home_3" and "Home 3" both become "home 3"."""
    return re.sub(r"[\s_]+", " ", label).strip().casefold()
