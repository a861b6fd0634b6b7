"""Compare results: a variant, its baseline, and their difference."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from placecat import settings
from placecat.errors import PlacecatError
from placecat.evaluation.trials import AXES
from placecat.results.measured import Results
from placecat.thesis.layouts import place_column
from placecat.thesis.number import (
    ALL_FRAMES,
    AVERAGE,
    Number,
    Origin,
    best_of,
    home_label,
    in_home,
    mean,
    merged,
    nothing,
    only_some,
    over_homes,
)

DIFFERENCE = "difference"
SETTINGS = ["homes", "variant", "baseline", "pairs", "label", "places", "summary", "error_ratio", "plain"]
# In a trial's name, this stands for the best label on an axis.
BEST = "*"
_SPLIT = "splits/"


class Line(NamedTuple):
    """A number, with a description of it and its home ("Home 6", "Average" or "")."""

    quantity: str
    home: str
    number: Number


class Pair(NamedTuple):
    """The names of two results to compare, a note on each, and a label ("" if there is only one pair)."""

    label: str
    variant: str
    baseline: str
    variant_note: str = ""
    baseline_note: str = ""


def compare(entry: Mapping[str, Any], results: Results, where: str) -> list[Line]:
    """Compare a variant with a baseline, for one or more pairs of results.

    If the names of both results end in "/", each trial under the variant is compared with the same trial
    under the baseline. Returns both sides in percent, and the difference, variant minus baseline, in points.
    The average is over the homes in which both were measured. For a split, the frames of all sequences are
    pooled. Raises PlacecatError for an unknown setting or result.

    Parameters
    ----------
    entry
        ``variant`` and ``baseline`` each have a ``quantity`` (the display name) and a ``result``. Instead of
        these results, ``pairs`` can list a variant and a baseline for each label. In a trial's name, ``*``
        stands for the axis label that is best on average. ``homes`` lists the homes (numbered from 1) to show
        in addition to the average; it is None for results on other data sets. ``places`` lists places that
        are also compared separately, or is "all". ``label`` names each pair of trials by the labels on the
        axes, e.g. "{column} clusters". ``summary`` is one or more of "mean", "lowest" and "highest", computed
        over the differences for individual places or, without ``places``, over all differences.
        ``error_ratio`` has its own ``quantity``, and its ``variant`` and ``baseline`` name two other results.
        ``plain`` applies to results on other data sets, and says whether to use the share of correct frames,
        regardless of place.
    where
        The entry's name, for error messages.
    """
    settings.refuse_unknown(entry, SETTINGS, where)
    lines: list[Line] = []
    differences: dict[str, Number] = {}
    of_places: dict[str, Number] = {}
    for pair in _pairs(entry, results, where):
        for home, left, right in _in_homes(pair, entry, results):
            lines += _three(entry, pair.label, home, left, right)
            if home == AVERAGE:
                differences[pair.label] = lines[-1].number
        for place, left, right in _in_places(pair, entry.get("places", []), results):
            label = f"{pair.label}, {place}" if pair.label else place
            lines += _three(entry, label, AVERAGE, left, right)
            of_places[label] = lines[-1].number
    summary = entry.get("summary", [])
    for kind in [summary] if isinstance(summary, str) else summary:
        lines.append(_summary(str(kind), of_places or differences, where))
    if ratio := entry.get("error_ratio"):
        number = _error_ratio(results, ratio["variant"], ratio["baseline"])
        lines.append(Line(ratio["quantity"], "", number))
    return lines


def alone(entry: Mapping[str, Any], results: Results, where: str) -> list[Line]:
    """Show a single result; for ``quantity``, ``result`` and ``homes``, see :func:`compare`."""
    settings.refuse_unknown(entry, ["homes", "quantity", "result"], where)
    pair = Pair("", entry["result"], entry["result"])
    return [Line(entry["quantity"], home, number) for home, number, _ in _in_homes(pair, entry, results)]


def _three(entry: Mapping[str, Any], label: str, home: str, left: Number, right: Number) -> list[Line]:
    prefix = f"{label}: " if label else ""
    return [
        Line(prefix + entry["variant"]["quantity"], home, left),
        Line(prefix + entry["baseline"]["quantity"], home, right),
        Line(prefix + DIFFERENCE, home, left.minus(right)),
    ]


def _pairs(entry: Mapping[str, Any], results: Results, where: str) -> list[Pair]:
    if "pairs" in entry:
        pairs = entry["pairs"].items()
        return [_chosen(str(label), variant, baseline, results) for label, (variant, baseline) in pairs]
    variant, baseline = entry["variant"]["result"], entry["baseline"]["result"]
    if not variant.endswith("/"):
        return [_chosen("", variant, baseline, results)]
    rests = [result.removeprefix(variant) for result in _known(results) if result.startswith(variant)]
    if not rests:
        raise PlacecatError(f"{where}: no result's name begins with {variant}")
    labels = [entry["label"].format(**dict(zip(AXES, rest.split("|"), strict=True))) for rest in rests]
    return [Pair(label, variant + rest, baseline + rest) for label, rest in zip(labels, rests, strict=True)]


def _known(results: Results) -> list[str]:
    return list(dict.fromkeys([*results.measured, *(result for result, _ in results.missing)]))


def _chosen(label: str, variant: str, baseline: str, results: Results) -> Pair:
    """Return a pair of results, with each ``*`` replaced by the label of the best trial."""
    (left, left_note), (right, right_note) = (_best(one, results) for one in (variant, baseline))
    return Pair(label, left, right, left_note, right_note)


def _best(pattern: str, results: Results) -> tuple[str, str]:
    """Of the trials that match a pattern, return the one that is best on average over homes, and a note."""
    if BEST not in pattern:
        return pattern, ""
    wanted = re.compile(re.escape(pattern).replace(re.escape(BEST), "([^|]*)"))
    trials = {name: match for name in _known(results) if (match := wanted.fullmatch(name))}
    if not trials:
        raise PlacecatError(f"no result matches {pattern!r}")
    best = best_of(results, list(trials))
    return best, f"the best: {', '.join(filter(None, trials[best].groups()))}"


def _in_homes(pair: Pair, entry: Mapping[str, Any], results: Results) -> list[tuple[str, Number, Number]]:
    """List the label and the two numbers for each of the entry's homes, and for the average."""
    names = (pair.variant, pair.baseline)
    homes: Sequence[int] | None = entry["homes"]
    if homes is None:
        left, right = (_whole(results, one, bool(entry.get("plain"))) for one in names)
        return [("", left, right)]
    tried, both = _homes_of(names, results)
    lines = [
        (home_label(number), in_home(results, pair.variant, number), in_home(results, pair.baseline, number))
        for number in homes
    ]
    averages = [over_homes(results, one, both or tried) for one in names]
    if both and both != tried:
        averages = [replace(one, notes=(only_some(both, tried),)) for one in averages]
    return [
        (home, left.noted(pair.variant_note), right.noted(pair.baseline_note))
        for home, left, right in [*lines, (AVERAGE, averages[0], averages[1])]
    ]


def _homes_of(names: Sequence[str], results: Results) -> tuple[list[int], list[int]]:
    """List the homes (numbered from 1) where all results were attempted, and where all were measured."""
    tried = [n for n in results.numbers if all(_was_tried(results, one, n) for one in names)]
    return tried, [n for n in tried if all(len(in_home(results, one, n).values) for one in names)]


def _in_places(
    pair: Pair, places: str | Sequence[str], results: Results
) -> Iterator[tuple[str, Number, Number]]:
    """Yield each place's name and its two numbers, averaged over the homes that show the place."""
    names = (pair.variant, pair.baseline)
    _, both = _homes_of(names, results)
    for place in results.classes if places == "all" else places:
        left = right = nothing("the data set has no such place")
        if place in results.classes:
            left, right = (_in_place(results, one, both, place) for one in names)
        yield place_column(place), left, right


def _in_place(results: Results, name: str, numbers: Sequence[int], place: str) -> Number:
    one = results.measured.get(name)
    if one is None or not numbers:
        return over_homes(results, name, results.numbers)
    homes = [one.homes.index(results.homes[number - 1]) for number in numbers]
    values = one.by_class()[:, homes, one.classes.index(place)]
    origins = (Origin(name, tuple(results.homes[number - 1] for number in numbers), place),)
    shown = np.isfinite(values).all(axis=0)
    if not shown.any():
        return nothing(f"no tested frame shows the place {place}", origins=origins)
    return Number(values[:, shown].mean(axis=1), one.is_random, origins=origins)


def _was_tried(results: Results, name: str, number: int) -> bool:
    """Whether a result exists, or is missing for a known reason, in the n-th home (from 1)."""
    home, one = results.homes[number - 1], results.find(name)
    return (name, home) in results.missing or (one is not None and home in one.homes)


def _whole(results: Results, name: str, plain: bool) -> Number:
    """Average a result over all homes or, for a split, over all frames together, as in its table."""
    one = results.of(name)
    if name.startswith(_SPLIT):
        one = one.pooled()
    values = one.plain() if plain else one.by_home()
    origins = (Origin(name, part=ALL_FRAMES if plain else ""),)
    return Number(values.mean(axis=1), one.is_random, origins=origins)


def _summary(kind: str, differences: Mapping[str, Number], where: str) -> Line:
    extremes: dict[str, Callable[..., str]] = {"lowest": min, "highest": max}
    if kind not in ("mean", *extremes):
        raise PlacecatError(
            f"{where}.summary {kind!r} does not exist: use one of mean, {', '.join(extremes)}"
        )
    number = mean(list(differences.values()))
    measured = {label: one for label, one in differences.items() if len(one.values)}
    if kind != "mean" and measured:
        label = extremes[kind](measured, key=lambda one: float(measured[one].values.mean()))
        number = replace(measured[label], notes=merged([[f"for {label}"], measured[label].notes]))
    return Line(f"{DIFFERENCE}, {kind}", AVERAGE, number)


def _error_ratio(results: Results, variant: str, baseline: str) -> Number:
    origins = (Origin(variant), Origin(baseline))
    errors = [100.0 - results.of(name).by_home().mean(axis=1) for name in (variant, baseline)]
    if (errors[1] <= 0).any():
        return nothing(f"{baseline} makes no errors", origins=origins)
    return Number(errors[0] / errors[1], results.of(variant).is_random, origins=origins)
