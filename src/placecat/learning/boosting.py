"""Gentle AdaBoost for several two-class problems at once."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.learning.stumps import BinnedFeatures, Stump, best_stumps

# Number of machines whose histograms are computed in one pass over the binned samples.
_TOGETHER = 8

# A two-class problem: (n,) bool labels, indices of the training samples (None for all), and a name to show
# in messages.
Task = tuple[NDArray[np.bool_], NDArray[np.intp] | None, str]


class Boosting:
    """Boosted machines for several two-class problems on the same samples.

    Each machine is identical to one fitted alone. More rounds can be added later without changing the
    existing stumps.

    `binned` contains the n samples, and `tasks` lists the two-class problems. `weight_trim` is the parameter
    of :class:`~placecat.learning.gentle_adaboost.GentleAdaBoost`. Raises PlacecatError if all training
    samples of a problem belong to the same class.
    """

    def __init__(self, binned: BinnedFeatures, tasks: Sequence[Task], weight_trim: float) -> None:
        self._binned = binned
        n_groups = -(-len(tasks) // _TOGETHER)
        self._machines = [_Machine(binned.bins.shape[1], *task, weight_trim) for task in tasks]
        self._groups = [self._machines[start::n_groups] for start in range(n_groups)]

    def stumps(self, n_rounds: int) -> list[list[Stump]]:
        """Return the first stumps of each machine, at least one and at most `n_rounds`."""
        for group in self._groups:
            while boosted := [m for m in group if not m.ended and len(m.stumps) < n_rounds]:
                self._boost(boosted)
        return [machine.first(n_rounds) for machine in self._machines]

    def _boost(self, machines: list["_Machine"]) -> None:
        """Add a stump to each of these machines."""
        weight = np.stack([machine.trimmed() for machine in machines], axis=1)
        signed = weight * np.stack([machine.target for machine in machines], axis=1)
        for machine, stump in zip(machines, best_stumps(self._binned, weight, signed), strict=True):
            if stump is None:
                machine.ended = True
            else:
                machine.add(stump, self._binned)


class _Machine:
    """Labels, weights and stumps of one two-class problem."""

    def __init__(
        self,
        n: int,
        positive: NDArray[np.bool_],
        rows: NDArray[np.intp] | None,
        context: str,
        weight_trim: float,
    ) -> None:
        used = np.ones(n, dtype=bool) if rows is None else np.zeros(n, dtype=bool)
        if rows is not None:
            used[rows] = True
        if len(np.unique(positive[used])) < 2:
            raise PlacecatError(
                f"{context}: boosting needs samples of both classes; add samples or drop the class"
            )
        self.target = np.where(positive, 1.0, -1.0)
        self.stumps: list[Stump] = []
        self.ended = False
        self._weight = used / np.count_nonzero(used)
        self._trim = weight_trim
        rate = float(self.target[used].mean())
        self._base_rate = Stump(0, -1, rate, rate)

    def trimmed(self) -> NDArray[np.float64]:
        """Return the (n,) weights, with the smallest set to 0."""
        weight = self._weight
        if self._trim >= 1:
            return weight
        ordered = np.sort(weight)
        light = int(np.searchsorted(np.cumsum(ordered), (1.0 - self._trim) * ordered.sum()))
        return np.where(weight >= ordered[min(light, len(ordered) - 1)], weight, 0.0)

    def add(self, stump: Stump, binned: BinnedFeatures) -> None:
        """Add a stump and update the weights."""
        self.stumps.append(stump)
        f = np.where(binned.bins[stump.feature] > stump.cut, stump.high, stump.low)
        self._weight *= np.exp(-self.target * f)
        total = self._weight.sum()
        # All weights are 0 if exp underflows for every sample.
        if total > 0:
            self._weight /= total
        else:
            self.ended = True

    def first(self, n_rounds: int) -> list[Stump]:
        """Return the first stumps, or a constant stump if no feature can be split."""
        return self.stumps[:n_rounds] or [self._base_rate]
