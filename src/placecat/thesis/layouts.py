"""Layouts of tables: the measured number of each cell."""

import itertools
from collections.abc import Mapping
from typing import Any, NamedTuple

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


class Cell(NamedTuple):
    """One cell of a table: its key in the published tables, and its measurement.

    `measured` is a percentage, the mean over the seeds, or NaN with `notes` that say why. `spread` is the
    largest minus the smallest of the seeds, NaN if nothing is random; `seeds` is their number, then 0.
    `number` has its seeds and origins.
    """

    group: str
    row: str
    column: str
    measured: float
    spread: float
    seeds: int
    notes: tuple[str, ...]
    number: Number


def cell(key: tuple[str, str, str], number: Number) -> Cell:
    """Put a number into the cell of a group, row and column."""
    return Cell(*key, number.measured, number.spread, number.seeds, number.notes, number)


def place_column(place: str) -> str:
    """Name of a place in the published tables, e.g. ``living_room`` is "Living Room"."""
    return place.replace("_", " ").title()


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Fill the cells of one table by its ``layout``, the name of one of the functions below.

    A result that the run does not have raises PlacecatError.
    """
    return LAYOUTS[table["layout"]](table, results)


def by_class(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """One row per test home, one column per place, and averages over places and homes (e.g. Table 6).

    The only result is ``table["result"]``. An average over homes is over those that show the place; that of
    the averages is the mean over homes, as everywhere.
    """
    name = table["result"]
    of_place = {
        place: [_in_place(results, name, number, place) for number in results.numbers]
        for place in results.classes
    }
    averages = dict(in_homes(results, name, results.numbers))
    filled = []
    for number in results.numbers:
        row = home_label(number)
        filled += [cell(("", row, place_column(place)), some[number - 1]) for place, some in of_place.items()]
        filled.append(cell(("", row, AVERAGE), averages[row]))
    filled += [cell(("", AVERAGE, place_column(place)), mean(some)) for place, some in of_place.items()]
    # A single home is its own average.
    return [*filled, cell(("", AVERAGE, AVERAGE), averages.get(AVERAGE, averages[home_label(1)]))]


def _in_place(results: Results, name: str, number: int, place: str) -> Number:
    """Percentage of one home's frames of a place that were decided right."""
    whole = in_home(results, name, number)
    if not len(whole.values):
        return whole
    one, home = results.of(name), results.homes[number - 1]
    values = one.by_class()[:, one.homes.index(home), one.classes.index(place)]
    origins = (Origin(name, (home,), place),)
    if not np.isfinite(values).all():
        return nothing(f"{home} has no frame of {place}", origins=origins)
    return Number(values, one.is_random, origins=origins)


def by_home(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """One row per result, one column per test home, and the average over homes (e.g. Table 26).

    Each of ``table["rows"]`` has `group`, `row` and `result`. The note of a filtered result states the frames
    that the information filter drops.
    """
    homes = {home_label(number): home for number, home in enumerate(results.homes, start=1)} | {AVERAGE: ""}
    return [
        cell((row["group"], row["row"], column), number.noted(results.drops(row["result"], homes[column])))
        for row in table["rows"]
        for column, number in in_homes(results, row["result"], results.numbers)
    ]


def by_home_with_gains(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Like `by_home`, with the gains of some results over the best of others, in points.

    Groups are in the order of the rows, with gains last. Each of ``table["gains"]`` has `group`, `row`,
    `result` and `over`, a list of results. A gain is the difference to the one of them with the largest
    average over homes, the same in every home; its note names it.
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
            filled.append(cell((gain["group"], gain["row"], column), number.minus(other).noted(note)))
    groups = list(dict.fromkeys(one.group for one in filled))
    return sorted(filled, key=lambda one: groups.index(one.group))


def grid(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Any axes, one of them perhaps the test homes: cells that are trials of their own (e.g. Table 12).

    The trials are those that ``table["axes"]`` spans, in the homes of ``table["homes"]``. An axis of homes
    has the labels "Home n" and, for two or more homes, "Average"; otherwise every cell is the mean over the
    homes.
    """
    axes = [table["axes"].get(axis, {"": {}}) for axis in AXES]
    numbers = results.numbers if table["homes"] == "all" else [int(number) for number in table["homes"]]
    groups, rows, columns = (("",) if axis == HOMES else tuple(axis) for axis in axes)
    filled = []
    for group, row, column in itertools.product(groups, rows, columns):
        name = trial_name(table["name"], group, row, column)
        if HOMES not in axes:
            filled.append(cell((group, row, column), over_homes(results, name, numbers)))
            continue
        # The label of the axis of homes is still empty.
        for home, number in in_homes(results, name, numbers):
            labels = [
                home if axis == HOMES else label
                for axis, label in zip(axes, (group, row, column), strict=True)
            ]
            filled.append(cell((labels[0], labels[1], labels[2]), number))
    return filled


def pooled_by_class(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """One row per result, one column per place, all test sequences counted together (Tables 30 and 31).

    Each of ``table["rows"]`` has `group`, `row` and `result`. ``table["plain"]``, if present, names a column
    for the share of all frames, of any place.
    """
    filled = []
    for row in table["rows"]:
        name = row["result"]
        one = results.of(name).pooled()
        numbers = {
            place_column(place): Number(values, one.is_random, origins=(Origin(name, part=place),))
            if np.isfinite(values).all()
            else nothing(f"no test sequence shows the place {place}", origins=(Origin(name, part=place),))
            for place, values in zip(one.classes, one.by_class()[:, 0].T, strict=True)
        }
        if table.get("plain"):
            everything = (Origin(name, part=ALL_FRAMES),)
            numbers[str(table["plain"])] = Number(one.plain()[:, 0], one.is_random, origins=everything)
        numbers[AVERAGE] = Number(one.by_home()[:, 0], one.is_random, origins=(Origin(name),))
        filled += [cell((row["group"], row["row"], column), number) for column, number in numbers.items()]
    return filled


def probabilities(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """One row per result: quality of its distributions, averaged over test homes (an addition to the thesis).

    Each of ``table["rows"]`` has `group`, `row` and `result` of the main data set. Columns are log-loss
    (nats), calibration error and accuracy of stays (both in percent), see
    :class:`placecat.evaluation.quality.HomeQuality`.
    """
    return [
        cell((row["group"], row["row"], column), _quality(results, row["result"], measure))
        for row in table["rows"]
        for measure, column in MEASURES.items()
    ]


def _quality(results: Results, name: str, measure: str) -> Number:
    one, origins = results.quality.get(name), (Origin(name, part=measure),)
    if one is None:
        reasons = results.reasons(name)
        if not reasons:
            # Refuses an unknown name.
            results.of(name)
        return nothing(*(reasons or ["nothing was measured"]), origins=origins)
    values = one.over_homes(measure)
    if not len(values):
        return nothing("no tested frame has a label", origins=origins)
    there = [number for number in results.numbers if results.homes[number - 1] in one.homes]
    return Number(values, one.is_random, origins=origins).noted(only_some(there, results.numbers))


# A literal, so that the names can be read from the source (placecat.thesis.checks).
LAYOUTS = {
    "by_class": by_class,
    "by_home": by_home,
    "by_home_with_gains": by_home_with_gains,
    "grid": grid,
    "pooled_by_class": pooled_by_class,
    "probabilities": probabilities,
}
