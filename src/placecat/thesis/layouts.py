"""Table layouts, which determine the number measured for each cell. Each table names its ``layout``."""

import itertools
from collections.abc import Mapping
from typing import Any

import numpy as np

from placecat.evaluation.trials import AXES, HOMES, trial_name
from placecat.results.measured import MEASURES, Results
from placecat.thesis.number import (
    ALL_FRAMES,
    AVERAGE,
    Number,
    Origin,
    best_of,
    home_label,
    in_home,
    in_homes,
    mean,
    nothing,
    only_some,
    over_homes,
)

# A cell's group, row and column in the published tables, and a number for each cell.
Key = tuple[str, str, str]
Cells = dict[Key, Number]


def place_column(place: str) -> str:
    """Return a place's name in the published tables, e.g. "Living Room" for ``living_room``."""
    return place.replace("_", " ").title()


def by_class(table: Mapping[str, Any], results: Results) -> Cells:
    """One row per test home, one column per place, and averages over places and over homes (e.g. Table 6).

    All cells come from the result ``table["result"]``. A place is averaged over the homes that show it. The
    overall average is the mean of the homes' averages, as in every table.
    """
    name = table["result"]
    of_place = {
        place_column(place): [in_home(results, name, number, place) for number in results.numbers]
        for place in results.classes
    }
    averages = dict(in_homes(results, name, results.numbers))
    filled: Cells = {}
    for number in results.numbers:
        row = home_label(number)
        filled |= {("", row, column): numbers[number - 1] for column, numbers in of_place.items()}
        filled["", row, AVERAGE] = averages[row]
    filled |= {("", AVERAGE, column): mean(numbers) for column, numbers in of_place.items()}
    # A single home is its own average.
    filled["", AVERAGE, AVERAGE] = averages.get(AVERAGE, averages[home_label(1)])
    return filled


def by_home(table: Mapping[str, Any], results: Results) -> Cells:
    """One row per result, one column per test home, and the average over homes (e.g. Table 26).

    Each entry of ``table["rows"]`` has `group`, `row` and `result`. A filtered result has a note that says
    what share of the frames the information filter drops.
    """
    homes = {home_label(number): home for number, home in enumerate(results.homes, start=1)} | {AVERAGE: ""}
    return {
        (row["group"], row["row"], column): number.noted(results.drops(row["result"], homes[column]))
        for row in table["rows"]
        for column, number in in_homes(results, row["result"], results.numbers)
    }


def by_home_with_gains(table: Mapping[str, Any], results: Results) -> Cells:
    """Like `by_home`, but with additional rows that show how much a result gains over the best of several.

    Groups follow the order of the rows, with gains last. Each entry of ``table["gains"]`` has `group`, `row`,
    `result` and `over`, a list of results. A gain is `result` minus the result in `over` with the highest
    average over homes. The same result is subtracted in every home, and a note names it.
    """
    names = {row["result"]: row["row"] for row in table["rows"]}
    filled = by_home(table, results)
    for gain in table["gains"]:
        best = best_of(results, gain["over"])
        note = f"minus {names.get(best, best)}"
        if len(gain["over"]) > 1:
            note += ", the best on average"
        of_result, of_best = (in_homes(results, name, results.numbers) for name in (gain["result"], best))
        for (column, number), (_, other) in zip(of_result, of_best, strict=True):
            filled[gain["group"], gain["row"], column] = number.minus(other).noted(note)
    groups = list(dict.fromkeys(group for group, _, _ in filled))
    return dict(sorted(filled.items(), key=lambda item: groups.index(item[0][0])))


def grid(table: Mapping[str, Any], results: Results) -> Cells:
    """One trial per combination of axis labels; the test homes can be one of the axes (e.g. Table 12).

    ``table["axes"]`` defines the trials, which are tested on ``table["homes"]``. If the homes are an axis,
    its labels are "Home n" and, if there are several homes, "Average". Otherwise, each cell is the mean over
    the homes.
    """
    axes = [table["axes"].get(axis, {"": {}}) for axis in AXES]
    numbers = results.numbers if table["homes"] == "all" else [int(number) for number in table["homes"]]
    filled: Cells = {}
    for labels in itertools.product(*(("",) if axis == HOMES else axis for axis in axes)):
        name = trial_name(table["name"], *labels)
        whole = [] if HOMES in axes else [("", over_homes(results, name, numbers))]
        for home, number in whole or in_homes(results, name, numbers):
            # If the homes are an axis, its label is still empty here.
            pairs = zip(axes, labels, strict=True)
            group, row, column = (home if axis == HOMES else label for axis, label in pairs)
            filled[group, row, column] = number
    return filled


def pooled_by_class(table: Mapping[str, Any], results: Results) -> Cells:
    """One row per result and one column per place, with all test sequences pooled (Tables 30 and 31).

    Each entry of ``table["rows"]`` has `group`, `row` and `result`. If present, ``table["plain"]`` is the
    name of a column for the share of correct frames, regardless of place.
    """
    filled: Cells = {}
    for row in table["rows"]:
        name = row["result"]
        one = results.of(name).pooled()
        for place, values in zip(one.classes, one.by_class()[:, 0].T, strict=True):
            origins = (Origin(name, part=place),)
            filled[row["group"], row["row"], place_column(place)] = (
                Number(values, one.is_random, origins=origins)
                if np.isfinite(values).all()
                else nothing(f"no test sequence shows the place {place}", origins=origins)
            )
        if table.get("plain"):
            everything = Number(one.plain()[:, 0], one.is_random, origins=(Origin(name, part=ALL_FRAMES),))
            filled[row["group"], row["row"], str(table["plain"])] = everything
        average = Number(one.by_home()[:, 0], one.is_random, origins=(Origin(name),))
        filled[row["group"], row["row"], AVERAGE] = average
    return filled


def probabilities(table: Mapping[str, Any], results: Results) -> Cells:
    """One row per result: the quality of its distributions, averaged over test homes (our addition).

    Each entry of ``table["rows"]`` has `group`, `row` and `result`, a result on the main data set. The
    columns are log-loss (in nats), calibration error and stay accuracy (both in percent); see
    :class:`placecat.evaluation.quality.HomeQuality`.
    """
    return {
        (row["group"], row["row"], column): _quality(results, row["result"], measure)
        for row in table["rows"]
        for measure, column in MEASURES.items()
    }


def _quality(results: Results, name: str, measure: str) -> Number:
    one, origins = results.quality.get(name), (Origin(name, part=measure),)
    if one is None:
        # This raises an error if the name is unknown.
        results.find(name)
        return nothing(*(results.reasons(name) or ["nothing was measured"]), origins=origins)
    values = one.over_homes(measure)
    if not len(values):
        return nothing("no tested frame has a label", origins=origins)
    there = [number for number in results.numbers if results.homes[number - 1] in one.homes]
    return Number(values, one.is_random, origins=origins).noted(only_some(there, results.numbers))


# This must be a dict literal, because placecat.config.tables reads the names from the source code.
LAYOUTS = {
    "by_class": by_class,
    "by_home": by_home,
    "by_home_with_gains": by_home_with_gains,
    "grid": grid,
    "pooled_by_class": pooled_by_class,
    "probabilities": probabilities,
}
