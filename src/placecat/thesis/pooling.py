"""Pool the measurements of a comparison's sides over the frames of all test sequences."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat.errors import NotComputable
from placecat.evaluation.bootstrap import Interval, stratified_bootstrap
from placecat.results.measured import Measured, Results
from placecat.thesis.claims import Side
from placecat.thesis.pairing import (
    Statistic,
    common_seeds,
    computable,
    counted,
    left_out,
    look_up,
    too_few,
    with_seeds,
)


@dataclass(frozen=True)
class Pooled:
    """The sides' decisions during the stays (visits to a place) in all test sequences.

    The frames of a stay are near-duplicates, so each stay is one unit. Each place is a stratum, because the
    number of stays in it is fixed.

    Attributes
    ----------
    sides
        The sides, each with only the results that are used.
    right
        One (results, seeds, stays) array per side, with the numbers of correctly classified frames. There is
        one seed if nothing is random.
    frames
        (stays,) number of frames in each stay.
    places
        (stays,) index of each stay's place in `names`.
    names
        Names of the places with at least one stay.
    note
        The parts that were left out, with the reasons, or "".
    """

    sides: tuple[Side, ...]
    right: tuple[NDArray[np.int64], ...]
    frames: NDArray[np.int64]
    places: NDArray[np.int64]
    names: tuple[str, ...]
    note: str

    #: Intervals apply only to these sequences.
    at_hand = True

    @property
    def units(self) -> str:
        """The units as text, e.g. ``12 stays``."""
        return counted(len(self.frames), "stay")

    @property
    def n_units(self) -> int:
        """Number of stays, or 1 if no place has two stays, since there is no interval in that case."""
        return len(self.frames) if len(self.frames) > len(self.names) else 1

    @property
    def values(self) -> tuple[NDArray[np.float64], ...]:
        """One (results, 1, seeds) array of percentages per side; all sequences count as one home."""
        everything: NDArray[np.float64] = 1.0 / np.bincount(self.places)[self.places][None]
        return tuple(
            np.stack([self._accuracy(side, of_seed, everything) for of_seed in right.swapaxes(0, 1)], axis=2)
            for side, right in zip(self.sides, self.right, strict=True)
        )

    def too_few(self, minimum: int) -> str:
        """Return a reason if there are too few stays for a verdict, and "" otherwise."""
        once = [self.names[place] for place in np.flatnonzero(np.bincount(self.places) == 1)]
        if len(self.frames) < minimum:
            return too_few(self.units)
        return f"only one stay shows {' and '.join(once)}: too few for a verdict" if once else ""

    def overall(self) -> tuple[NDArray[np.float64], ...]:
        """Return one (results, 1) array of percentages per side, averaged over seeds."""
        return tuple(values.mean(axis=2) for values in self.values)

    def interval(self, statistic: Statistic, seed: int, level: float, resamples: int) -> Interval:
        """Like :meth:`placecat.thesis.pairing.Paired.interval`, but with a bootstrap over the stays."""
        means = [right.mean(axis=1) for right in self.right]
        return stratified_bootstrap(
            lambda weights: statistic(
                [self._accuracy(side, mean, weights) for side, mean in zip(self.sides, means, strict=True)]
            ),
            self.places,
            seed,
            level=level,
            resamples=resamples,
        )

    def _accuracy(
        self, side: Side, right: NDArray[np.float64], weights: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Compute (results, n) accuracies in percent.

        `right` contains the (results, stays) numbers of correct frames, and `weights` the (n, stays) weights
        of the stays.
        """
        kind = np.eye(len(self.names))[self.places]
        if side.plain:
            # Weight each place by its number of stays.
            kind = np.bincount(self.places)[self.places][:, None] * np.ones((1, 1))
        elif side.place is not None:
            kind = kind[:, [self.names.index(side.place)]]
        named = (right[:, None] * weights) @ kind
        percent = 100.0 * (named / ((self.frames * weights) @ kind)).mean(axis=2)
        return 100.0 - percent if side.error else percent


def pool(results: Results, sides: Sequence[Side]) -> Pooled:
    """Pool the sides over the stays in all test sequences.

    Raises NotComputable, giving the reasons, if a result was not measured or has no stays, or if no stay
    shows a side's place.
    """
    used = computable(results, sides)
    names = list(dict.fromkeys(name for side in used for name in side.results))
    by_stay = {name: _by_stay(results, name) for name in names}
    seeds = common_seeds(by_stay.values())
    first = by_stay[names[0]]
    shown = first.confusion[0].sum(axis=2)
    there = np.flatnonzero(shown.any(axis=0))
    places = tuple(first.classes[place] for place in there)
    for side in used:
        if side.place is not None and side.place not in places:
            raise NotComputable(f"no test sequence shows the place {side.place}")
    return Pooled(
        used,
        tuple(
            np.stack([_right(by_stay[name], first.homes, seeds) for name in side.results]) for side in used
        ),
        shown.sum(axis=1),
        np.searchsorted(there, shown.argmax(axis=1)),
        places,
        "; ".join(left_out(sides, used)),
    )


def _by_stay(results: Results, name: str) -> Measured:
    look_up(results, name)
    if name not in results.stays:
        raise NotComputable(f"this run has no stays of {name}")
    return results.stays[name]


def _right(one: Measured, stays: Sequence[str], seeds: Sequence[str]) -> NDArray[np.int64]:
    """Return the (seeds, stays) numbers of correctly classified frames."""
    right = np.diagonal(one.confusion, axis1=2, axis2=3).sum(axis=2)
    right = right[:, [one.homes.index(stay) for stay in stays]]
    return with_seeds(one, right, seeds)
