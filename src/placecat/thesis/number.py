"""A number in the report: its value for each seed, or the reason why it is missing."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from placecat.evaluation.accuracy import home_accuracy
from placecat.results.measured import Results, mean_and_spread

AVERAGE = "Average"
# Part of an origin: frames of all places count.
ALL_FRAMES = "all frames"


class Origin(NamedTuple):
    """The source of a number: a result in some homes.

    `part` is a place, a measure of probabilities or `ALL_FRAMES` (the share of all frames), unless the number
    is the accuracy over all places. Without homes it covers all test homes or sequences.
    """

    result: str
    homes: tuple[str, ...] = ()
    part: str = ""


@dataclass(frozen=True)
class Number:
    """One number, measured with each seed.

    Attributes
    ----------
    values
        (seeds,) percent or points; (1,) if nothing is random, (0,) if there is no number.
    is_random
        Whether it depends on a seed.
    notes
        The reasons for a missing number, or remarks on the number.
    digits
        Digits after the point.
    origins
        Its sources; a missing number has them too.
    """

    values: NDArray[np.float64]
    is_random: bool
    notes: tuple[str, ...] = ()
    digits: int = 2
    origins: tuple[Origin, ...] = ()

    @property
    def measured(self) -> float:
        """Mean over the seeds, rounded; NaN if there is no number."""
        return round(float(self.values.mean()), self.digits) if len(self.values) else float("nan")

    @property
    def spread(self) -> float:
        """Largest minus smallest over the seeds, 2 decimals; NaN without a number or if nothing is random."""
        return mean_and_spread(self.values, random=self.is_random)[1] if len(self.values) else float("nan")

    @property
    def seeds(self) -> int:
        """Number of seeds, 0 if nothing is random or there is no number."""
        return len(self.values) if self.is_random else 0

    def noted(self, *notes: str) -> Number:
        """The number with further non-empty notes; unchanged if it has no value."""
        return replace(self, notes=merged([self.notes, notes])) if len(self.values) else self

    def minus(self, other: Number) -> Number:
        """The difference for each seed; non-random values are the same with every seed."""
        origins = united((self, other))
        if not len(self.values) or not len(other.values):
            reasons = merged(one.notes for one in (self, other) if not len(one.values))
            return nothing(*reasons, origins=origins)
        notes = merged([self.notes, other.notes])
        is_random = self.is_random or other.is_random
        return Number(self.values - other.values, is_random, notes, origins=origins)


def nothing(*reasons: str, origins: tuple[Origin, ...] = ()) -> Number:
    """A missing number and the reasons."""
    return Number(np.empty(0), False, reasons, origins=origins)


def united(numbers: Iterable[Number]) -> tuple[Origin, ...]:
    """Origins of several numbers; each result and part appears once, with all its homes."""
    homes: dict[tuple[str, str], tuple[str, ...]] = {}
    for origin in (origin for one in numbers for origin in one.origins):
        key = (origin.result, origin.part)
        homes[key] = tuple(dict.fromkeys((*homes.get(key, ()), *origin.homes)))
    return tuple(Origin(result, of, part) for (result, part), of in homes.items())


def merged(notes: Iterable[Iterable[str]]) -> tuple[str, ...]:
    """Non-empty notes of several numbers, without duplicates."""
    return tuple(dict.fromkeys(note for of_one in notes for note in of_one if note))


def mean(numbers: Sequence[Number]) -> Number:
    """The mean of some numbers for each seed, without those that have no value."""
    there = [one for one in numbers if len(one.values)]
    if not there:
        return nothing(*merged(one.notes for one in numbers), origins=united(numbers))
    # Adding keeps the seeds apart and broadcasts non-random values.
    total = sum((one.values for one in there[1:]), there[0].values)
    is_random = any(one.is_random for one in there)
    return Number(total / len(there), is_random, origins=united(there))


def home_label(number: int) -> str:
    """Name of the n-th home (from 1) in the published tables."""
    return f"Home {number}"


def in_home(results: Results, name: str, number: int, place: str = "") -> Number:
    """Accuracy of a result in the n-th home (from 1) of the main data set, in percent; see `Results.find`.

    With a `place` it is the percentage of that place's frames that were decided correctly.
    """
    if number > len(results.homes):
        return nothing(f"the data set has only {len(results.homes)} homes")
    home = results.homes[number - 1]
    one, origins = results.find(name), (Origin(name, (home,)),)
    if one is None or home not in one.homes:
        return nothing(results.missing.get((name, home), f"nothing was measured in {home}"), origins=origins)
    index = one.homes.index(home)
    if not place:
        accuracies = [home_accuracy(of_home) for of_home in one.confusion[:, index]]
        return Number(np.array(accuracies), one.is_random, origins=origins)
    values = one.by_class()[:, index, one.classes.index(place)]
    origins = (Origin(name, (home,), place),)
    if not np.isfinite(values).all():
        return nothing(f"{home} has no frame of {place}", origins=origins)
    return Number(values, one.is_random, origins=origins)


def over_homes(results: Results, name: str, numbers: Sequence[int]) -> Number:
    """Accuracy of a result averaged over homes given by their numbers (from 1), in percent.

    Homes without a number are left out, with a note.
    """
    parts = [in_home(results, name, number) for number in numbers]
    there = [number for number, part in zip(numbers, parts, strict=True) if len(part.values)]
    return mean(parts).noted(only_some(there, numbers))


def only_some(there: Sequence[int], numbers: Sequence[int]) -> str:
    """Note on a mean over only some of the homes, given by their numbers (from 1); "" if it is over all."""
    return "" if len(there) == len(numbers) else f"mean over only {', '.join(map(home_label, there))}"


def best_of(results: Results, names: Sequence[str]) -> str:
    """The result with the largest average over homes; the first one in a tie or if none was measured."""
    averages = [over_homes(results, name, results.numbers).measured for name in names]
    return names[int(np.nanargmax(averages))] if np.isfinite(averages).any() else names[0]


def in_homes(results: Results, name: str, numbers: Sequence[int]) -> list[tuple[str, Number]]:
    """Accuracies in some homes and, for two or more, their average, with their published names."""
    found = [(home_label(number), in_home(results, name, number)) for number in numbers]
    if len(numbers) > 1:
        found.append((AVERAGE, over_homes(results, name, numbers)))
    return found
