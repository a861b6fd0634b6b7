"""Choose settings with Optuna, in batches whose size does not depend on the number of workers."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from placecat.errors import PlacecatError
from placecat.search.space import Space


@dataclass(frozen=True)
class Tried:
    """Settings that were tried: the number, overrides and accuracy (in percent, or None) of an experiment."""

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
    """Search for the settings with the highest accuracy, using Optuna's tree-structured Parzen estimator.

    The first trials are the starts, so the best settings are at least as good as each start. Repeated
    settings are not run again, since their accuracy would be the same. Returns all settings that were run, in
    order. Raises PlacecatError if `n_trials` or `batch_size` is too small, or if no experiment has an
    accuracy by the time the sampler starts to use results.

    Parameters
    ----------
    run
        Function that runs experiments, given their overrides and the number of the first one. It returns
        their accuracies in percent, or NaN for an experiment that has none.
    n_trials
        Number of trials, including starts and repeated settings.
    batch_size
        Number of settings to choose at once, before their results are known.
    n_startup_trials
        Number of trials before the sampler uses results. They are drawn at random, except for the starts.
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
                f"none of the first {len(known)} experiments in the search produced an accuracy: see "
                "their result.json for the reasons"
            )
        for trial, one in zip(batch, chosen, strict=True):
            found = known[one].accuracy
            if found is None:
                study.tell(trial, state=TrialState.FAIL)
            else:
                study.tell(trial, found)
    return list(known.values())


def best(tried: Sequence[Tried]) -> Tried:
    """Return the settings with the highest accuracy. Ties go to the earliest, so starts take precedence."""
    return max(tried, key=lambda one: -math.inf if one.accuracy is None else one.accuracy)
