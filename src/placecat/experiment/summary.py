"""What a sweep or an experiment gave, as a table to read."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files
from placecat.experiment import output
from placecat.experiment.options import ALL, TEST_HOME
from placecat.paths import seed_folder

HOME = "test_home"
AVERAGE = "average"
_NO_NUMBER, _FAILED = "-", "failed"
_MOST_COLUMNS = 12


@dataclass(frozen=True)
class Ran:
    """One experiment of a sweep.

    Attributes
    ----------
    number
        Its number in the sweep, which its folder is named by.
    values
        Values of the swept keys.
    folder
        Its output folder.
    result
        Content of result.json.
    """

    number: int
    values: dict[str, str]
    folder: Path
    result: dict[str, Any]

    @property
    def has_failed(self) -> bool:
        """Whether it ended with an error, or not at all."""
        return output.FAILED in self.result

    @property
    def seconds(self) -> float | None:
        """How long it took."""
        path = self.folder / output.SECONDS
        return float(files.read_json(path)) if path.is_file() else None

    @property
    def spread(self) -> float:
        """The largest minus the smallest accuracy of the seeds, as in a table; NaN if nothing is random."""
        by_seed: dict[str, list[float]] = {}
        for home in self.result.get("homes", {}).values():
            for fold in home["folds"].values():
                for seed, own in fold.items():
                    by_seed.setdefault(seed, []).append(own["accuracy"])
        means = [float(np.mean(values)) for values in by_seed.values()]
        is_random = bool(means) and seed_folder(None) not in by_seed
        return max(means) - min(means) if is_random else float("nan")


def read(folder: Path, combinations: Sequence[dict[str, str]] | None, swept: Sequence[str]) -> list[Ran]:
    """Gather the results of a sweep.

    Parameters
    ----------
    folder
        Of the sweep.
    combinations
        Values of the swept keys of each experiment; None: as the folders tell.
    """
    from placecat.experiment.command_line import values_in

    if combinations is None:
        started = [
            path for path in folder.iterdir() if path.name.isdigit() and (path / output.OVERRIDES).is_file()
        ]
        numbers = sorted(int(path.name) for path in started)
        own = {number: values_in(folder / str(number)) for number in numbers}
        by_number = {number: {key: own[number].get(key, "") for key in swept} for number in numbers}
    else:
        by_number = dict(enumerate(combinations))
    found = []
    for number, values in by_number.items():
        path = folder / str(number) / output.RESULT
        missing = output.failure(f"it left no result in {path.parent}")
        result = files.read_json(path) if path.is_file() else missing
        found.append(Ran(number, values, folder / str(number), result))
    return _with_names_of_homes(found) if HOME in swept else found


def _with_names_of_homes(ran: Sequence[Ran]) -> list[Ran]:
    """The homes by their names, however they were spelled; failed experiments know theirs from others."""
    names = {
        one.values[HOME]: "+".join(one.result["settings"][HOME])
        for one in ran
        if "settings" in one.result and one.values[HOME] != ALL
    }
    return [
        replace(one, values=one.values | {HOME: names.get(one.values[HOME], one.values[HOME])}) for one in ran
    ]


def as_frame(ran: Sequence[Ran], swept: Sequence[str]) -> pd.DataFrame:
    """One row an experiment: number, swept keys, accuracy and spread in percent, and what is amiss."""
    rows = [
        {
            "number": one.number,
            **one.values,
            "accuracy": np.nan if one.result["accuracy"] is None else round(one.result["accuracy"], 2),
            "spread": round(one.spread, 2),
            "note": one.result.get(output.FAILED) or one.result["reason"] or "",
        }
        for one in ran
    ]
    return pd.DataFrame(rows, columns=["number", *swept, "accuracy", "spread", "note"])


def grid(ran: Sequence[Ran], swept: Sequence[str]) -> pd.DataFrame:
    """The accuracies as a table over the swept keys, as text.

    Columns are the values of the first key whose values are numbers, else of the last one that is not the
    test home; below the test homes is their average, if they were swept.
    """
    if not swept:
        return pd.DataFrame({"accuracy": [_cell(one) for one in ran]})
    others = [key for key in swept if key != HOME]
    across = next((key for key in others if all(_is_number(one.values[key]) for one in ran)), "")
    across = across or (others[-1] if others else "")
    if len(swept) == 1 or len({one.values[across] for one in ran}) > _MOST_COLUMNS:
        across = ""
    down = [key for key in swept if key != across]
    # The homes last, so that what they are averaged over stands together.
    down = [key for key in down if key != HOME] + [key for key in down if key == HOME]
    cells: dict[tuple[str, ...], dict[str, str]] = {}
    groups: dict[tuple[str, ...], dict[str, list[Ran]]] = {}
    for one in ran:
        row = tuple(one.values[key] for key in down)
        column = one.values[across] if across else "accuracy"
        cells.setdefault(row, {})[column] = _cell(one)
        groups.setdefault(row[:-1], {}).setdefault(column, []).append(one)
    if down[-1:] == [HOME] and len({one.values[HOME] for one in ran}) > 1:
        ordered: dict[tuple[str, ...], dict[str, str]] = {}
        for group, columns in groups.items():
            ordered |= {row: own for row, own in cells.items() if row[:-1] == group}
            ordered[*group, AVERAGE] = {column: _average(own) for column, own in columns.items()}
        cells = ordered
    index = pd.MultiIndex.from_tuples(list(cells), names=down)
    columns_found = list(dict.fromkeys(column for own in cells.values() for column in own))
    table = pd.DataFrame([[own.get(name, "") for name in columns_found] for own in cells.values()], index)
    table.columns = pd.Index(columns_found, name=across or None)
    return table


def _cell(one: Ran) -> str:
    if one.has_failed:
        return _FAILED
    return _NO_NUMBER if one.result["accuracy"] is None else f"{one.result['accuracy']:.2f}"


def _average(ran: Sequence[Ran]) -> str:
    """Mean over the homes that have a number, as in a table."""
    values = [one.result["accuracy"] for one in ran if one.result["accuracy"] is not None]
    return f"{np.mean(values):.2f}" if values else _NO_NUMBER


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def highest(ran: Sequence[Ran]) -> tuple[dict[str, str], float] | None:
    """The settings with the highest accuracy, on average over the test homes if they were swept."""
    groups: dict[tuple[tuple[str, str], ...], list[float | None]] = {}
    for one in ran:
        own = tuple((key, value) for key, value in one.values.items() if key != HOME)
        groups.setdefault(own, []).append(one.result["accuracy"])
    # Settings that gave no number for one of the homes do not compare.
    means = {own: float(np.mean(found)) for own, found in groups.items() if None not in found}  # type: ignore[arg-type]
    top = max(means, key=lambda own: means[own], default=None)
    return None if top is None else (dict(top), means[top])


def text(ran: Sequence[Ran], swept: Sequence[str]) -> str:
    """The summary of a sweep, to print."""
    lines = ["Accuracy in percent", "", _plain(grid(ran, swept)), ""]
    top = highest(ran)
    if top is not None and len(ran) > 1:
        homes = len({one.values[HOME] for one in ran}) if HOME in swept else 1
        over = f", average of {homes} homes" if homes > 1 else ""
        lines.append(f"Highest: {_label(top[0]) or 'all settings'}: {top[1]:.2f} %{over}")
    lines += [
        f"{_label(one.values)}: {output.shown(one.result)}" for one in ran if one.result["accuracy"] is None
    ]
    return "\n".join(lines)


def _plain(table: pd.DataFrame) -> str:
    """A table with its index, each name of a row once and each column as wide as it needs."""
    names = [str(name) for name in table.index.names] if table.index.names[0] is not None else []
    header = [*names, *map(str, table.columns)]
    rows: list[list[str]] = []
    before: tuple[str, ...] = ()
    for key, own in zip(table.index, table.to_numpy().tolist(), strict=True):
        labels = tuple(map(str, key if isinstance(key, tuple) else (key,))) if names else ()
        same = True
        shown = []
        for place, label in enumerate(labels):
            same = same and before[place : place + 1] == (label,) and place < len(labels) - 1
            shown.append("" if same else label)
        rows.append([*shown, *map(str, own)])
        before = labels
    widths = [max(len(row[place]) for row in [header, *rows]) for place in range(len(header))]

    def line(row: Sequence[str]) -> str:
        cells = [
            cell.ljust(width) if place < len(names) else cell.rjust(width)
            for place, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        return "  ".join(cells).rstrip()

    across = table.columns.name
    top = ["  ".join([*(" " * width for width in widths[: len(names)]), str(across)])] if across else []
    return "\n".join([*top, line(header), "  ".join("-" * width for width in widths), *map(line, rows)])


def markdown(ran: Sequence[Ran], swept: Sequence[str]) -> str:
    """The summary of a sweep as Markdown."""
    table = grid(ran, swept)
    names = [str(name) for name in table.index.names] if table.index.names[0] is not None else []
    rows = [[*names, *map(str, table.columns)], ["---"] * (len(names) + len(table.columns))]
    for key, own in zip(table.index, table.to_numpy().tolist(), strict=True):
        labels = (key if isinstance(key, tuple) else (key,)) if names else ()
        rows.append([*map(str, labels), *map(str, own)])
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    across = f" Columns: {table.columns.name}." if table.columns.name else ""
    return "\n".join([f"Accuracy in percent.{across}", "", *lines])


def text_of_one(result: dict[str, Any]) -> str:
    """What a single experiment gave: accuracy by home and seed, and what was taken for what."""
    if result["accuracy"] is None:
        return output.shown(result)
    own = result["settings"]
    lines = []
    for home, of_home in result["homes"].items():
        if of_home["accuracy"] is None:
            lines.append(f"{home}: no number: {of_home['reason']}")
            continue
        parts = [
            f"{(fold + ' ') if own['judge'] != TEST_HOME else ''}{seed} {found['accuracy']:.2f}"
            for fold, of_fold in of_home["folds"].items()
            for seed, found in of_fold.items()
        ]
        lines.append(f"{home}: {of_home['accuracy']:.2f} % ({', '.join(parts)})")
    if len(lines) > 1:
        lines.append(f"{AVERAGE}: {result['accuracy']:.2f} %")
    table = confusion(result)
    shares = 100 * table / np.maximum(table.sum(axis=1, keepdims=True), 1)
    frame = pd.DataFrame(
        [[f"{share:.1f}" for share in row] for row in shares],
        pd.MultiIndex.from_arrays([result["classes"]], names=["true place"]),
        columns=pd.Index(result["classes"], name="decided, in percent of the true place's frames"),
    )
    return "\n".join([*lines, "", _plain(frame)])


def confusion(result: dict[str, Any]) -> np.ndarray:
    """(classes, classes) counts over all homes, folds and seeds; rows are true places."""
    counts = [
        np.array(found["confusion"])
        for home in result["homes"].values()
        for fold in home["folds"].values()
        for found in fold.values()
    ]
    return np.sum(counts, axis=0)


def _label(values: dict[str, str]) -> str:
    return " ".join(f"{key}={value}" for key, value in values.items())
