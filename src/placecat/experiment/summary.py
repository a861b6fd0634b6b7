"""Tabulate, print, write and log the results of a sweep or of a single experiment."""

import math
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files
from placecat.errors import PlacecatError
from placecat.experiment import output
from placecat.experiment.options import TEST_HOME
from placecat.paths import seed_name
from placecat.report import formats
from placecat.results.measured import DECIMALS

HOME = "test_home"
AVERAGE = "average"
_MOST_COLUMNS = 12
# Maximum width of a printed table, in characters.
_WIDTH = 100
_UNITS = {
    "accuracy": "Accuracy in percent",
    "log_loss": "Log-loss in nats",
    "calibration_error": "Calibration error in percent",
}
_DECIMALS = {"accuracy": 2} | DECIMALS


@dataclass(frozen=True)
class Ran:
    """An experiment in a sweep: its number, the values of the swept keys, its folder and its result.json."""

    number: int
    values: dict[str, str]
    folder: Path
    result: dict[str, Any]

    @property
    def has_failed(self) -> bool:
        """Whether the experiment failed or did not finish."""
        return output.FAILED in self.result

    @property
    def seconds(self) -> float | None:
        """The duration of the experiment in seconds, or None if it was not recorded."""
        path = self.folder / output.SECONDS
        return float(files.read_json(path)) if path.is_file() else None

    @property
    def spread(self) -> float:
        """The highest minus the lowest accuracy over seeds, as in the tables; NaN if nothing is random."""
        by_seed: dict[str, list[float]] = {}
        for home in self.result.get("homes", {}).values():
            for fold in home["folds"].values():
                for seed, own in fold.items():
                    by_seed.setdefault(seed, []).append(own["accuracy"])
        means = [float(np.mean(values)) for values in by_seed.values()]
        is_random = bool(means) and seed_name(None) not in by_seed
        return max(means) - min(means) if is_random else float("nan")


def read(folder: Path, combinations: Sequence[dict[str, str]]) -> list[Ran]:
    """Collect the results of a sweep; `combinations` contains the swept values of each experiment."""
    folders = [folder / str(number) for number in range(len(combinations))]
    return [
        Ran(number, dict(values), own, output.read(own))
        for number, (values, own) in enumerate(zip(combinations, folders, strict=True))
    ]


def as_frame(ran: Sequence[Ran]) -> pd.DataFrame:
    """Tabulate experiments, one per row.

    The columns are the number, the swept keys, the measures, the ``spread`` of the accuracy over seeds, and a
    ``note`` about any problem. ``log_loss`` is in nats; the other measures and ``spread`` are in percent. A
    missing value is NaN.
    """
    rows = []
    for one in ran:
        accuracy, *others = (round(_value(one, measure), _DECIMALS[measure]) for measure in output.MEASURES)
        rows.append(
            {
                "number": one.number,
                **one.values,
                "accuracy": accuracy,
                "spread": round(one.spread, 2),
                **dict(zip(output.MEASURES[1:], others, strict=True)),
                "note": one.result.get(output.FAILED) or one.result["reason"] or "",
            }
        )
    return pd.DataFrame(rows)


def _value(one: Ran, measure: str) -> float:
    """Return the unrounded value of a measure, or NaN if the experiment has none."""
    value = one.result.get(measure)
    return float("nan") if value is None else float(value)


def _values(ran: Sequence[Ran], measure: str) -> pd.DataFrame:
    """Tabulate the swept keys and the unrounded values of a measure; a missing value is NaN."""
    frame = pd.DataFrame([{**one.values, measure: _value(one, measure)} for one in ran])
    # A sweep may contain the same values twice.
    return frame.drop_duplicates(list(ran[0].values) or None)


def grid(ran: Sequence[Ran], measure: str = "accuracy") -> pd.DataFrame:
    """Tabulate a measure over the swept keys, as text.

    The columns are the values of the first numeric key or, if no key is numeric, of the last key. Test homes
    are always rows; if several were swept, their average follows. If some combinations of values were not
    run, as in a search, each experiment has a row instead.
    """
    swept, frame = list(ran[0].values), _values(ran, measure)
    others = [key for key in swept if key != HOME]
    if HOME in swept and frame[HOME].nunique() > 1:
        groups = frame.groupby(others, sort=False) if others else frame.groupby(lambda _: 0)
        means = groups[measure].mean().reset_index()
        frame = pd.concat([frame, means.assign(**{HOME: AVERAGE})])[[*swept, measure]]
    numbers = [key for key in others if pd.to_numeric(frame[key], errors="coerce").notna().all()]
    is_complete = len(frame) == math.prod(frame[swept].nunique())
    across = (numbers[:1] or others[-1:]) if len(swept) > 1 and is_complete else []
    across = [key for key in across if frame[key].nunique() <= _MOST_COLUMNS]
    # The homes come last, so that the rows to be averaged are adjacent.
    down = [key for key in others if key not in across] + [key for key in swept if key == HOME]
    for key in swept:
        # Keep the order of the sweep.
        frame[key] = pd.Categorical(frame[key], frame[key].unique())
    table = frame.set_index([*down, *across]) if swept else frame
    table = table[measure].unstack(across) if across else table.sort_index()
    table.columns = pd.Index(list(table.columns), name=across[0] if across else None)
    return table.map(lambda value: "-" if np.isnan(value) else f"{value:.{_DECIMALS[measure]}f}")


def highest(ran: Sequence[Ran]) -> tuple[dict[str, str], float] | None:
    """Return the settings with the highest accuracy, averaged over swept test homes, and that accuracy.

    Returns None if no settings have an accuracy in every home.
    """
    frame = _values(ran, "accuracy")
    others = [key for key in ran[0].values if key != HOME]
    # Settings cannot be compared if any home lacks an accuracy.
    means = [
        (float(own["accuracy"].mean(skipna=False)), {key: str(own[key].iloc[0]) for key in others})
        for _, own in (frame.groupby(others, sort=False) if others else [(None, frame)])
    ]
    means = [one for one in means if not np.isnan(one[0])]
    if not means:
        return None
    accuracy, settings = max(means, key=lambda one: one[0])
    return settings, accuracy


def text(ran: Sequence[Ran]) -> str:
    """Format the summary of a sweep for the terminal."""
    lines = [_tables(ran), ""]
    top = highest(ran)
    if top is not None and len(ran) > 1:
        homes = len({one.values.get(HOME) for one in ran})
        over = f", average of {homes} homes" if homes > 1 else ""
        lines.append(f"Highest: {label(top[0]) or 'all settings'}: {top[1]:.2f}%{over}")
    lines += [
        f"{label(one.values)}: {output.shown(one.result)}" for one in ran if one.result["accuracy"] is None
    ]
    return "\n".join(lines)


def _tables(ran: Sequence[Ran]) -> str:
    """Format one table per measure, side by side or, if that is too wide, one below the other."""
    found = {measure: grid(ran, measure) for measure in output.MEASURES}
    is_grid = found["accuracy"].columns.name is not None
    lines = pd.concat(list(found.values()), axis=1, keys=list(found) if is_grid else None).to_string()
    if max(map(len, lines.splitlines())) <= _WIDTH:
        return f"{', '.join(_UNITS.values()).capitalize()}\n\n{lines}"
    return "\n\n".join(
        f"{_UNITS[measure]}\n\n{table.to_string(line_width=_WIDTH)}" for measure, table in found.items()
    )


def markdown(ran: Sequence[Ran]) -> str:
    """Format the accuracies of a sweep as Markdown."""
    table = grid(ran)
    across = f" Columns: {formats.markdown(str(table.columns.name))}." if table.columns.name else ""
    shown = table.reset_index().map(lambda cell: formats.markdown(cell) if isinstance(cell, str) else cell)
    shown.columns = shown.columns.map(lambda name: formats.markdown(str(name)))
    rows = shown.to_markdown(index=False, disable_numparse=True)
    return f"Accuracy in percent.{across}\n\n{rows}"


def text_of_one(result: dict[str, Any]) -> str:
    """Format one experiment's result: accuracies by home and seed, other measures, confusion matrices."""
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
        lines.append(f"{home}: {of_home['accuracy']:.2f}% ({', '.join(parts)})")
    if len(lines) > 1:
        lines.append(f"{AVERAGE}: {result['accuracy']:.2f}%")
    lines.append(output.quality(result).capitalize())
    table = confusion(result)
    shares = 100 * table / np.maximum(table.sum(axis=1, keepdims=True), 1)
    frame = pd.DataFrame(shares, index=result["classes"], columns=result["classes"])
    title = "Decisions (columns) as percentages of the frames of each true place (rows)"
    return "\n".join([*lines, "", title, "", frame.to_string(float_format="{:.1f}".format)])


def confusion(result: dict[str, Any]) -> np.ndarray:
    """Sum the counts over all homes, folds and seeds: (classes, classes); rows are true places."""
    counts = [
        np.array(found["confusion"])
        for home in result["homes"].values()
        for fold in home["folds"].values()
        for found in fold.values()
    ]
    return np.sum(counts, axis=0)


def label(values: dict[str, str]) -> str:
    """Format keys and values on one line."""
    return " ".join(f"{key}={value}" for key, value in values.items())


def tell(folder: Path, combinations: Sequence[dict[str, str]], *, log: Sequence[str] | None) -> bool:
    """Print, write and log the results of a sweep; return whether all experiments and logging succeeded.

    `combinations` contains the swept keys and values of each experiment that was started. `log` contains the
    overrides of the sweep, for MLflow; None turns logging off.
    """
    ran = read(folder, combinations)
    if not ran:
        return True
    files.write_csv(folder / output.SUMMARY, as_frame(ran))
    print(f"\n{text(ran)}\n\nDetails: {folder / output.SUMMARY}")
    is_logged = log is None or _log(lambda tracking: tracking.log_sweep(ran, folder, log))
    return is_logged and not any(one.has_failed for one in ran)


def tell_one(folder: Path, result: dict[str, object], *, log: bool) -> bool:
    """Print and log the result of a single experiment; return whether logging succeeded."""
    print(f"\n{text_of_one(result)}\n\nDetails: {folder / output.RESULT}")
    return not log or _log(lambda tracking: tracking.log_one(result, folder))


def _log(write: Callable[[Any], str]) -> bool:
    """Log to MLflow; print where, or why it failed. The results are already on disk."""
    # Imported late: it imports MLflow.
    from placecat.experiment import tracking

    try:
        print(f"Logged: {write(tracking)}")
    except PlacecatError as error:
        print(
            f"placecat: nothing was logged to MLflow: {error}; set track=false to turn logging off",
            file=sys.stderr,
        )
        return False
    return True
