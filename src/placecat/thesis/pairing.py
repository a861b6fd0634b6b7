"""Pair the measurements of a comparison's sides by home."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.errors import NotComputable
from placecat.evaluation.bootstrap import Interval, paired_bootstrap
from placecat.results.measured import Measured, Results
from placecat.thesis.claims import Side

Statistic = Callable[[Sequence[NDArray[np.float64]]], NDArray[np.float64]]


@dataclass(frozen=True)
class Paired:
    """The sides' values in the homes where all results were measured.

    Attributes
    ----------
    sides
        The sides, each with only the results that are used.
    values
        One (results, homes, seeds) array of percentages per side; there is one seed if nothing is random.
    homes
        Names of the homes.
    seeds
        Number of seeds that all random results have in common; 0 if nothing is random.
    by_seed
        Whether each seed of a home is a unit. Otherwise, each home is a unit, with its mean over seeds.
    note
        The results and homes that were left out, with the reasons, or "".
    """

    sides: tuple[Side, ...]
    values: tuple[NDArray[np.float64], ...]
    homes: tuple[str, ...]
    seeds: int
    by_seed: bool
    note: str

    @property
    def units(self) -> str:
        """The units as text, e.g. ``6 homes`` or ``2 homes x 2 seeds``."""
        homes = counted(len(self.homes), "home")
        return f"{homes} x {counted(self.seeds, 'seed')}" if self.by_seed else homes

    def by_unit(self) -> tuple[NDArray[np.float64], ...]:
        """Return one (results, units) array per side; `by_seed` determines the units."""
        if self.by_seed:
            return tuple(values.reshape(len(values), -1) for values in self.values)
        return tuple(values.mean(axis=2) for values in self.values)

    @property
    def n_units(self) -> int:
        """Number of units."""
        return self.by_unit()[0].shape[1]

    @property
    def at_hand(self) -> bool:
        """Whether intervals apply only to these homes."""
        return self.by_seed

    def too_few(self, minimum: int) -> str:
        """Return a reason if there are too few units for a verdict, and "" otherwise."""
        return too_few(self.units) if self.n_units < minimum else ""

    def overall(self) -> tuple[NDArray[np.float64], ...]:
        """Return one (results, 1) array of percentages per side, in which all units have equal weight."""
        return tuple(values.mean(axis=1, keepdims=True) for values in self.by_unit())

    def interval(self, statistic: Statistic, seed: int, level: float, resamples: int) -> Interval:
        """Compute a statistic's interval; `statistic` maps one (results, n) array per side to (n,) values."""
        by_unit = self.by_unit()
        return paired_bootstrap(
            lambda weights: statistic([values @ weights.T for values in by_unit]),
            self.n_units,
            seed,
            level=level,
            resamples=resamples,
        )


def pair(results: Results, sides: Sequence[Side], few_homes: int) -> Paired:
    """Pair the sides by home.

    If results are random and there are at most `few_homes` homes, each seed of a home is a unit. Raises
    NotComputable, giving the reasons, if a result was not measured or no home has all results.
    """
    used = computable(results, sides)
    names = list(dict.fromkeys(name for side in used for name in side.results))
    measured = {name: look_up(results, name) for name in names}
    everywhere = list(dict.fromkeys(home for one in measured.values() for home in one.homes))
    common = [home for home in everywhere if all(home in one.homes for one in measured.values())]
    seeds = common_seeds(measured.values())
    values = [
        np.stack([_values(measured[name], side, common, seeds) for name in side.results]) for side in used
    ]
    scored = np.all([np.isfinite(value).all(axis=(0, 2)) for value in values], axis=0)
    homes = tuple(home for home, is_scored in zip(common, scored, strict=True) if is_scored)
    if not homes:
        raise NotComputable(f"no home has all of {', '.join(names)}")
    return Paired(
        used,
        tuple(value[:, scored] for value in values),
        homes,
        len(seeds),
        by_seed=len(seeds) > 0 and len(homes) <= few_homes,
        note="; ".join(filter(None, [*left_out(sides, used), _note(results, names, everywhere)])),
    )


def computable(results: Results, sides: Sequence[Side]) -> tuple[Side, ...]:
    """From each side that has several results, drop those that cannot be computed on this data set.

    ``best`` and ``last`` choose from the remaining results. For means, all sides keep only the positions
    whose results can be computed on every side, so that the results remain paired. A side that would lose all
    its results keeps them (with ``last``, only the last one). The reasons are reported later. Each remaining
    result keeps its published number.
    """
    impossible = {name for name, _ in results.missing} - set(results.measured)
    together = len({len(side.results) for side in sides}) == 1
    places = [
        place
        for place in range(len(sides[0].results))
        if together and not any(side.results[place] in impossible for side in sides)
    ]
    used = []
    for side in sides:
        if side.combine == "mean":
            kept = tuple(side.results[place] for place in places)
        elif side.combine == "last":
            kept = tuple(name for name in side.results if name in results.measured)[-1:]
        else:
            kept = tuple(name for name in side.results if name not in impossible)
        last = side.results[-1:] if side.combine == "last" else side.results
        used.append(side.only(kept or last))
    return tuple(used)


def look_up(results: Results, name: str) -> Measured:
    """Look up a result; if it is missing, raise NotComputable, giving the reasons."""
    if name not in results.measured:
        if reasons := results.reasons(name):
            raise NotComputable(f"{name}: {', '.join(sorted(reasons))}")
        raise NotComputable(f"this run has no result {name}")
    return results.measured[name]


def common_seeds(measured: Iterable[Measured]) -> tuple[str, ...]:
    """Return the names of the seeds that all random results have in common; empty if nothing is random."""
    random = [one for one in measured if one.is_random]
    if not random:
        return ()
    return tuple(seed for seed in random[0].seeds if all(seed in one.seeds for one in random))


def _values(one: Measured, side: Side, homes: Sequence[str], seeds: Sequence[str]) -> NDArray[np.float64]:
    if side.plain:
        percent = one.plain()
    elif side.place is None:
        percent = one.by_home()
    elif side.place in one.classes:
        percent = one.by_class()[:, :, one.classes.index(side.place)]
    else:
        raise NotComputable(f"the data set has no place {side.place}")
    percent = percent[:, [one.homes.index(home) for home in homes]]
    if side.error:
        percent = 100.0 - percent
    return with_seeds(one, percent, seeds).T


def with_seeds(one: Measured, values: NDArray[Any], seeds: Sequence[str]) -> NDArray[Any]:
    """From a result's (seeds, n) values, select the rows of the common seeds."""
    if one.is_random and seeds:
        return values[[one.seeds.index(seed) for seed in seeds]]
    # If nothing is random, or the results have no seeds in common, only the means can be paired.
    return np.broadcast_to(values.mean(axis=0), (max(len(seeds), 1), values.shape[1]))


def left_out(sides: Sequence[Side], used: Sequence[Side]) -> list[str]:
    """Say which results each side leaves out; for ``last``, name only those after the one that is used."""
    texts = []
    for side, kept in zip(sides, used, strict=True):
        asked = side.results
        if side.combine == "last":
            asked = asked[asked.index(kept.results[-1]) :]
        gone = [name.rpartition("|")[2] or name for name in asked if name not in kept.results]
        if gone:
            texts.append(f"{side.label} without {', '.join(gone)}, which this data does not allow")
    return texts


def _note(results: Results, names: Sequence[str], homes: Sequence[str]) -> str:
    reasons = {
        f"without {home}: {results.missing[name, home]}"
        for name in names
        for home in homes
        if (name, home) in results.missing
    }
    return "; ".join(sorted(reasons))


def counted(number: int, noun: str) -> str:
    """Return a number and a noun, singular or plural, e.g. "1 home" or "2 homes"."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def too_few(units: str) -> str:
    """Return the reason why there is no verdict, such as "1 home is too few for a verdict"."""
    return f"{units} {'is' if units in ('1 home', '1 stay') else 'are'} too few for a verdict"
