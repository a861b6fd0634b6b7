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
# The `part` of an origin that counts frames regardless of place.
ALL_FRAMES = "all frames"


class Origin(NamedTuple):
    """The source of a number: a result, and the homes that the number covers.

    `part` is a place, a measure of probabilities or `ALL_FRAMES` (the share of correct frames, regardless of
    place); it is "" if the number is the accuracy over all places. If `homes` is empty, the number covers all
    test homes or sequences.
    """

    result: str
    homes: tuple[str, ...] = ()
    part: str = ""


@dataclass(frozen=True)
class Number:
    """A number, measured with each seed.

    Attributes
    ----------
    values
        (seeds,) values, usually in percent or points. The shape is (1,) if nothing is random, and (0,) if the
        number is missing.
    is_random
        Whether the number depends on a seed.
    notes
        Remarks on the number, or the reasons why it is missing.
    digits
        The number of digits after the decimal point.
    origins
        The number's sources, even if it is missing.
    """

    values: NDArray[np.float64]
    is_random: bool
    notes: tuple[str, ...] = ()
    digits: int = 2
    origins: tuple[Origin, ...] = ()

    @property
    def measured(self) -> float:
        """Rounded mean over the seeds; NaN if the number is missing."""
        return round(float(self.values.mean()), self.digits) if len(self.values) else float("nan")

    @property
    def spread(self) -> float:
        """Largest minus smallest value over seeds, to two decimals; NaN if missing or nothing is random."""
        return mean_and_spread(self.values, random=self.is_random)[1] if len(self.values) else float("nan")

    @property
    def seeds(self) -> int:
        """Number of seeds; 0 if nothing is random or the number is missing."""
        return len(self.values) if self.is_random else 0

    def noted(self, *notes: str) -> Number:
        """Return the number with any non-empty `notes` added; a missing number is returned unchanged."""
        return replace(self, notes=merged([self.notes, notes])) if len(self.values) else self

    def minus(self, other: Number) -> Number:
        """Subtract another number seed by seed; a number that is not random has one value for all seeds."""
        origins = united((self, other))
        if not len(self.values) or not len(other.values):
            reasons = merged(one.notes for one in (self, other) if not len(one.values))
            return nothing(*reasons, origins=origins)
        notes = merged([self.notes, other.notes])
        is_random = self.is_random or other.is_random
        return Number(self.values - other.values, is_random, notes, origins=origins)


def nothing(*reasons: str, origins: tuple[Origin, ...] = ()) -> Number:
    """Return a missing number, along with the reasons why it is missing."""
    return Number(np.empty(0), False, reasons, origins=origins)


def united(numbers: Iterable[Number]) -> tuple[Origin, ...]:
    """Merge the origins of several numbers.

    Each combination of a result and a part appears once, with all its homes.
    """
    homes: dict[tuple[str, str], tuple[str, ...]] = {}
    for origin in (origin for one in numbers for origin in one.origins):
        key = (origin.result, origin.part)
        homes[key] = tuple(dict.fromkeys((*homes.get(key, ()), *origin.homes)))
    return tuple(Origin(result, of, part) for (result, part), of in homes.items())


def merged(notes: Iterable[Iterable[str]]) -> tuple[str, ...]:
    """Merge the non-empty notes of several numbers, without duplicates."""
    return tuple(dict.fromkeys(note for of_one in notes for note in of_one if note))


def mean(numbers: Sequence[Number]) -> Number:
    """Average numbers seed by seed, ignoring missing ones."""
    there = [one for one in numbers if len(one.values)]
    if not there:
        return nothing(*merged(one.notes for one in numbers), origins=united(numbers))
    # The sum keeps seeds separate, and numbers that are not random are broadcast.
    total = sum((one.values for one in there[1:]), there[0].values)
    is_random = any(one.is_random for one in there)
    return Number(total / len(there), is_random, origins=united(there))


def home_label(number: int) -> str:
    """Return the n-th home's name in the published tables, counting from 1."""
    return f"Home {number}"


def in_home(results: Results, name: str, number: int, place: str = "") -> Number:
    """Return a result's accuracy in the n-th home (from 1) of the main data set, in percent.

    If `place` is given, return the percentage of that place's frames that are classified correctly. Raises
    the same errors as `Results.find`.
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
    """Average a result's accuracy, in percent, over the homes with the given `numbers` (from 1).

    Homes for which the result is missing are left out, and a note says so.
    """
    parts = [in_home(results, name, number) for number in numbers]
    there = [number for number, part in zip(numbers, parts, strict=True) if len(part.values)]
    return mean(parts).noted(only_some(there, numbers))


def only_some(there: Sequence[int], numbers: Sequence[int]) -> str:
    """Return a note saying that a mean covers only some homes, or "" if it covers all.

    `numbers` lists all the homes (from 1), and `there` those that the mean covers.
    """
    return "" if len(there) == len(numbers) else f"mean over only {', '.join(map(home_label, there))}"


def best_of(results: Results, names: Sequence[str]) -> str:
    """Return the result with the highest average over homes.

    If there is a tie, or nothing was measured, this is the first result.
    """
    averages = [over_homes(results, name, results.numbers).measured for name in names]
    return names[int(np.nanargmax(averages))] if np.isfinite(averages).any() else names[0]


def in_homes(results: Results, name: str, numbers: Sequence[int]) -> list[tuple[str, Number]]:
    """Return the accuracy in each home and, if there are several, the average, with the thesis's labels."""
    found = [(home_label(number), in_home(results, name, number)) for number in numbers]
    if len(numbers) > 1:
        found.append((AVERAGE, over_homes(results, name, numbers)))
    return found
