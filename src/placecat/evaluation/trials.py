"""List the trials of a table. A trial trains and tests one cue with some settings changed."""

import itertools
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from placecat import settings
from placecat.errors import PlacecatError

AXES = ("group", "row", "column")
HOMES = "homes"


@dataclass(frozen=True)
class Trial:
    """A cue to train, and the homes to test it on.

    `name` consists of the name of the table and one label per axis, such as ``trials/table_12/HOG +
    y-Pos||196``. The label of the homes axis is empty. `settings` contains ``descriptor``, ``classifier``
    and, for classifiers that use clusters, ``codebook``. `homes` are the test homes.
    """

    name: str
    settings: dict[str, Any]
    homes: tuple[str, ...]

    def key(self) -> str:
        """Return a string that identifies the computation, so a trial in several tables runs only once."""
        return json.dumps(self.settings, sort_keys=True)


def trial_name(table: str, group: str, row: str, column: str) -> str:
    """Return the name of a trial's result."""
    return f"trials/{table}/{group}|{row}|{column}"


def homes_of(table: Mapping[str, Any], homes: list[str]) -> list[tuple[int, str]]:
    """Return the number and name of each home that a table uses for testing.

    Numbers start at 1. ``homes`` in the table is either a list of such numbers or ``all``. `homes` are the
    names of the homes in the data set. Numbers beyond the last home are skipped.
    """
    numbers = range(1, len(homes) + 1) if table["homes"] == "all" else table["homes"]
    return [(int(number), homes[number - 1]) for number in numbers if 1 <= number <= len(homes)]


def expand(name: str, table: Mapping[str, Any], homes: list[str]) -> list[Trial]:
    """List the trials of a table for the homes in the data set.

    `name` is the table's name, such as ``table_12``. `table` is its configuration, with the keys ``trial``,
    ``homes`` and ``axes`` (see data/thesis/tables). Raises PlacecatError if an axis is unknown, or if an axis
    overrides a setting that the trial does not have.
    """
    unknown = set(table["axes"]) - set(AXES)
    if unknown:
        raise PlacecatError(
            f"{name} has the unknown axis {sorted(unknown)[0]!r}: use one of {', '.join(AXES)}"
        )
    choices: list[list[tuple[str, Mapping[str, Any]]]] = []
    for axis in AXES:
        labels = table["axes"].get(axis)
        choices.append([("", {})] if labels in (None, HOMES) else list(labels.items()))
    tested = tuple(home for _, home in homes_of(table, homes))
    trials = []
    for combination in itertools.product(*choices):
        own = dict(table["trial"])
        for _, overrides in combination:
            own = settings.changed(own, overrides, f"{name} changes", "its trial")
        trials.append(Trial(trial_name(name, *(label for label, _ in combination)), own, tested))
    return trials
