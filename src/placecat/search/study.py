"""Optuna's choice of the next settings, in batches that do not depend on the number of workers."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from placecat.errors import PlacecatError
from placecat.search.space import Space


@dataclass(frozen=True)
class Tried:
    """A tried setting: the number of its experiment, the choice, and the accuracy in percent, or None."""

    number: int
    overrides: tuple[str, ...]
    accuracy: float | None


def search(
    space: Space,
    run: Callable[[Sequence[tuple[str, ...]], int], Sequence[float]],
    *,
    n_trials: int,
    batch_size: int,
    seed: int,
    n_startup_trials: int,
) -> list[Tried]:
    """Search the settings of the highest accuracy with Optuna's tree-structured Parzen estimator.

    The first trials are the starts, so the best is at least as good as each of them. A repeated setting is
    not run again, since it would give the same number. Returns every setting that was run, in the order of
    trials, the starts first. Raises PlacecatError if a number is out of range, or no experiment gave an
    accuracy by the time the sampler needs some.

    Parameters
    ----------
    run
        Takes the overrides of some experiments and the number of the first; returns their accuracies in
        percent, NaN for none.
    n_trials
        Settings to try, including the starts and repeated ones.
    batch_size
        Settings chosen at a time, without each other's results.
    n_startup_trials
        Trials before the sampler uses results; until then it draws evenly.
    """
    for name, value, least in (("n_trials", n_trials, len(space.starts)), ("batch_size", batch_size, 1)):
        if value < least:
            raise PlacecatError(f"hydra.sweeper.{name}={value} must be at least {least}")
    import optuna
    from optuna.trial import TrialState

    optuna.logging.set_verbosity(optuna.logging.WARNING)
    sampler = optuna.samplers.TPESampler(seed=seed, n_startup_trials=n_startup_trials)
    study = optuna.create_study(sampler=sampler, direction="maximize")
    for start in space.starts.values():
        study.enqueue_trial(start)
    known: dict[tuple[str, ...], Tried] = {}
    for asked in range(0, n_trials, batch_size):
        batch = [study.ask(space.distributions) for _ in range(min(batch_size, n_trials - asked))]
        chosen = [space.overrides(trial.params) for trial in batch]
        new = [one for one in dict.fromkeys(chosen) if one not in known]
        if new:
            first = len(known)
            for number, (one, accuracy) in enumerate(zip(new, run(new, first), strict=True), first):
                known[one] = Tried(number, one, None if math.isnan(accuracy) else accuracy)
        done = asked + len(batch)
        if done >= min(n_startup_trials, n_trials) and all(one.accuracy is None for one in known.values()):
            raise PlacecatError(
                f"none of the first {len(known)} experiments of the search gave an accuracy: see what their "
                "result.json says"
            )
        for trial, one in zip(batch, chosen, strict=True):
            found = known[one].accuracy
            if found is None:
                study.tell(trial, state=TrialState.FAIL)
            else:
                study.tell(trial, found)
    return list(known.values())


def best(tried: Sequence[Tried]) -> Tried:
    """The one with the highest accuracy; the first of equal ones, so a start unless another is better."""
    return max(tried, key=lambda one: -math.inf if one.accuracy is None else one.accuracy)
