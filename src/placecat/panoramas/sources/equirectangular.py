"""Equirectangular images from 360-degree cameras, and a table of their rooms.

The table is a CSV file with the columns home, file, room and, optionally, floor.
"""

import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from placecat.config import overrides
from placecat.errors import PlacecatError, did_you_mean
from placecat.footage.names import relative
from placecat.panoramas.panorama import FLOOR, Panorama, kind, labels_by_kind
from placecat.sequences.labels import read_rows, shown

_NEEDED, _OPTIONAL = ("home", "file", "room"), ("floor",)
_ONLY_FLOOR = "1"
# Label used as an example in a message.
_EXAMPLE = "living_room"


def read(root: Path, settings: Mapping[str, Any]) -> list[Panorama]:
    """List the panoramas in a folder; see `placecat.panoramas.sources.read`."""
    return read_table(root, settings, lambda file: [file])


def read_table(root: Path, settings: Mapping[str, Any], files: Callable[[str], list[str]]) -> list[Panorama]:
    """Read the table in a source folder; each row is a panorama.

    `settings` are those in conf/panoramas.yaml. `files` maps the value in the `file` column to the images
    of the panorama, relative to `root`. Raises PlacecatError if the table is missing or not a CSV file, or if
    a row has invalid cells, a path outside `root`, or a room without a label.
    """
    path = root / settings["table"]
    if not path.is_file():
        raise PlacecatError(
            f"{path}: the table of rooms is missing; write one with the columns {','.join(_NEEDED)}."
        )
    rows = read_rows(path)
    header = [cell.strip() for cell in rows[0][1]] if rows else []
    if len(set(header)) < len(header) or not set(_NEEDED) <= set(header) <= {*_NEEDED, *_OPTIONAL}:
        raise PlacecatError(
            f"{path} line {rows[0][0] if rows else 1}: the header is {shown(','.join(header))}; write "
            f"{','.join(_NEEDED)}, and {_OPTIONAL[0]} if there are several floors."
        )
    labels = labels_by_kind(settings["labels"])
    panoramas = []
    for line, row in rows[1:]:
        where = f"{path} line {line}"
        if len(row) != len(header):
            raise PlacecatError(f"{where} has {len(row)} columns; expected {','.join(header)}.")
        cells = dict(zip(header, (cell.strip() for cell in row), strict=True))
        for name in _NEEDED:
            if not cells[name]:
                raise PlacecatError(f"{where}: {name} is empty; fill it in.")
        floor = cells.get("floor", _ONLY_FLOOR)
        if not FLOOR.fullmatch(floor):
            raise PlacecatError(
                f"{where}: {shown(floor)} is not a valid floor; use letters, digits, _ and - (at most 50)."
            )
        label = labels.get(kind(cells["room"]))
        if label is None:
            question = did_you_mean(kind(cells["room"]), labels) or "."
            raise PlacecatError(
                f"{where}: unknown room {shown(cells['room'])}{question} Correct it, or add it to a label in "
                "conf/panoramas.yaml or on the command line, for example "
                f"{_adding(kind(cells['room']), settings)}"
            )
        pictures = tuple(str(relative(file, where)) for file in files(cells["file"]))
        room = "_".join(cells["room"].casefold().split())
        panoramas.append(Panorama(cells["home"], floor, room, label, pictures, where))
    return panoramas


def _adding(room: str, settings: Mapping[str, Any]) -> str:
    """Return the override that adds a room to a label."""
    labels = settings["labels"]
    label = _EXAMPLE if _EXAMPLE in labels else min(labels, default=_EXAMPLE)
    names = ",".join(map(overrides.text, [*labels.get(label, []), room]))
    override = f"labels.{label}=[{names}]"
    return override if re.fullmatch(r"[\w.=,-]+\[[\w,-]+\]", override) else overrides.for_shell(override)
