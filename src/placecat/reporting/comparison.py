"""Two results beside each other: a variant, what it is compared with, and their difference."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from placecat import settings
from placecat.errors import PlacecatError
from placecat.evaluation.trials import AXES
from placecat.reporting.number import (
    AVERAGE,
    Number,
    has_reasons,
    home_label,
    in_home,
    joined,
    mean,
    nothing,
    over_homes,
)
from placecat.reporting.results import Results

DIFFERENCE = "difference"
SETTINGS = ["homes", "variant", "baseline", "label", "summary", "error_ratio", "plain"]


class Line(NamedTuple):
    """One number: what it is, in which home ("Home 6", "Average", or "" for neither), and its value."""

    quantity: str
    home: str
    number: Number


def compare(entry: Mapping[str, Any], results: Results, where: str) -> list[Line]:
    """Compare two results, or all trials below two names that end in "/", pair by pair.

    Parameters
    ----------
    entry
        ``variant`` and ``baseline``, each with ``quantity`` (what to call it) and ``result``; ``homes``, the
        numbers from 1 of homes to show besides the average, or None for results that are not of the main data
        set; of pairs of trials ``label``, what to call each by the labels of its axes, e.g. "{column}
        clusters", and ``summary`` of their differences, "mean" or "lowest"; ``error_ratio``, with
        ``quantity``, ``variant`` and ``baseline``, two more results; ``plain``, whether the share of all
        frames counts, of results that are not of the main data set.
    where
        What messages call the entry.

    Returns
    -------
    list of Line
        Both sides in percent and the difference, variant minus baseline, in points. The average is over the
        homes in which both were measured.

    Raises
    ------
    PlacecatError
        An unknown setting, or a result that does not exist.
    """
    settings.refuse_unknown(entry, SETTINGS, where)
    variant, baseline = entry["variant"], entry["baseline"]
    lines: list[Line] = []
    differences: dict[str, Number] = {}
    for label, left, right in _pairs(entry, results, where):
        prefix = f"{label}: " if label else ""
        for home, of_variant, of_baseline in _in_homes(left, right, entry, results):
            difference = of_variant.minus(of_baseline)
            lines += [
                Line(prefix + variant["quantity"], home, of_variant),
                Line(prefix + baseline["quantity"], home, of_baseline),
                Line(prefix + DIFFERENCE, home, difference),
            ]
            if home == AVERAGE:
                differences[label] = difference
    if entry.get("summary"):
        lines.append(_summary(str(entry["summary"]), differences, where))
    if entry.get("error_ratio"):
        ratio = entry["error_ratio"]
        number = _error_ratio(results, ratio["variant"], ratio["baseline"])
        lines.append(Line(ratio["quantity"], "", number))
    return lines


def _pairs(entry: Mapping[str, Any], results: Results, where: str) -> list[tuple[str, str, str]]:
    """Label, variant and baseline of each comparison."""
    variant, baseline = entry["variant"]["result"], entry["baseline"]["result"]
    if not variant.endswith("/"):
        return [("", variant, baseline)]
    there = dict.fromkeys([*results.measured, *(result for result, _ in results.missing)])
    rests = [result.removeprefix(variant) for result in there if result.startswith(variant)]
    if not rests:
        raise PlacecatError(f"{where}: there is no result below {variant}")
    labels = [entry["label"].format(**dict(zip(AXES, rest.split("|"), strict=True))) for rest in rests]
    return [(label, variant + rest, baseline + rest) for label, rest in zip(labels, rests, strict=True)]


def _in_homes(
    variant: str, baseline: str, entry: Mapping[str, Any], results: Results
) -> list[tuple[str, Number, Number]]:
    """Label of a home and both numbers: in each of the entry's homes, and on average."""
    homes: Sequence[int] | None = entry["homes"]
    if homes is None:
        plain = bool(entry.get("plain"))
        return [("", _whole(results, variant, plain), _whole(results, baseline, plain))]
    pair = (variant, baseline)
    tried = [n for n in range(1, len(results.homes) + 1) if all(_was_tried(results, one, n) for one in pair)]
    both = [n for n in tried if all(len(in_home(results, one, n).values) for one in pair)]
    found = [
        (home_label(number), in_home(results, variant, number), in_home(results, baseline, number))
        for number in homes
    ]
    left, right = (over_homes(results, one, both or tried) for one in pair)
    if both and both != tried:
        note = f"mean over {', '.join(map(home_label, both))} only"
        left, right = replace(left, note=note), replace(right, note=note)
    return [*found, (AVERAGE, left, right)]


def _was_tried(results: Results, name: str, number: int) -> bool:
    """Whether a result is, or has a reason not to be, in the n-th home (from 1)."""
    if name not in results.measured and not has_reasons(results, name):
        results.of(name)
    home = results.homes[number - 1]
    one = results.measured.get(name)
    return (name, home) in results.missing or (one is not None and home in one.homes)


def _whole(results: Results, name: str, plain: bool) -> Number:
    """Mean over all homes of a result that is not of the main data set."""
    one = results.of(name)
    return Number((one.plain() if plain else one.by_home()).mean(axis=1), one.is_random)


def _summary(kind: str, differences: Mapping[str, Number], where: str) -> Line:
    """One number for all differences."""
    kinds: dict[str, Callable[[Mapping[str, Number]], Number]] = {
        "mean": lambda found: mean(list(found.values())),
        "lowest": _lowest,
    }
    if kind not in kinds:
        raise PlacecatError(f"{where}.summary {kind!r} does not exist: use one of {', '.join(kinds)}")
    return Line(f"{DIFFERENCE}, {kind}", AVERAGE, kinds[kind](differences))


def _lowest(differences: Mapping[str, Number]) -> Number:
    there = {label: one for label, one in differences.items() if len(one.values)}
    if not there:
        return mean(list(differences.values()))
    label = min(there, key=lambda one: float(there[one].values.mean()))
    return replace(there[label], note=joined([f"that of {label}", there[label].note]))


def _error_ratio(results: Results, variant: str, baseline: str) -> Number:
    """How many times larger the share of frames is that one result decides wrongly."""
    errors = [100.0 - results.of(name).by_home().mean(axis=1) for name in (variant, baseline)]
    if (errors[1] <= 0).any():
        return nothing(f"{baseline} makes no error")
    return Number(errors[0] / errors[1], results.of(variant).is_random)
