"""Judge candidates on training homes, using features and cues from the stages."""

import itertools
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.evaluation.probabilities import log_loss
from placecat.fusion.temperature import fit_temperature
from placecat.sequences import listing
from placecat.training import fold_file
from placecat.training import plan as plans
from placecat.training.cue import Cue, train
from placecat.training.integration import apply_smoothing, fit_smoothing, fuse, fused_parts
from placecat.training.saved import CueResults, smooth_home

# The home left out as the test home, the judged home, the accuracy in percent, and the log-loss in nats.
Judgement = tuple[str, str, float, float]


def judge(truth: NDArray[np.int16], proba: NDArray[np.float64], smallest: float) -> tuple[float, float]:
    """Return the accuracy (percent) and log-loss (nats) on the frames of one home, averaged over places."""
    confusion = confusion_matrix(truth, proba.argmax(axis=1), proba.shape[1])
    return home_accuracy(confusion), log_loss(truth, proba, smallest=smallest)


def left_out(homes: Sequence[str]) -> list[tuple[str, ...]]:
    """List the sets of homes to leave out together: all pairs of homes, and all single homes."""
    return [*itertools.combinations(homes, 2), *((home,) for home in homes)]


def predict_unseen(plan: plans.Plan, cue: Cue) -> dict[str, NDArray[np.float64]]:
    """Train a cue without clusters according to a plan, and apply it to all frames of each home it tests.

    Returns the distributions for each of these homes.
    """
    trained = train(plan, cue)
    return {part.home: trained.predict(part.home) for part in plan.tested}


def judge_cue(plan: plans.Plan, cue: Cue, smallest: float) -> list[Judgement]:
    """Train a cue without clusters according to a plan, and judge it on the homes that the plan leaves out.

    The plan tests one or two homes. If it tests two, each is judged as an unseen training home, with the
    other as the test home. `smallest` has the same meaning as in
    :func:`placecat.evaluation.probabilities.log_loss`.
    """
    unseen = predict_unseen(plan, cue)
    judged = {home: judge_home(home, proba, smallest) for home, proba in unseen.items()}
    return _both_ways(judged)


def judge_home(home: str, proba: NDArray[np.float64], smallest: float) -> tuple[float, float]:
    """Judge the distributions of a home on its labelled frames."""
    labels = listing.read_labels(home)
    rows = np.flatnonzero(labels >= 0)
    return judge(labels[rows], proba[rows], smallest)


def judge_system(system: Mapping[str, Any], plan: plans.Plan, seed: int, smallest: float) -> list[Judgement]:
    """Train an integration on the cues of a fold, and judge it on the homes that the cues have not seen.

    The ``scheme`` of `system` matches the plan. In 4-5-1, the integration trains only on the training
    homes of the cues, as in 5-5-1, and is judged on the test home and on the other home that the cues have
    not seen. In 5-5-1, it is judged on the test home.
    """
    read = CueResults(system, plan.test, seed)
    cue_homes, method = {part.home for part in plan.cues}, system["integrator"]["method"]
    parts = [part for part in fused_parts(plan, method=method, extra=False) if part.home in cue_homes]
    kept = [part for part in plan.integration if part.home not in cue_homes]
    temperatures = None
    if system["temperature"]:
        held_out = zip(*(read.arrays(name) for name in _HELD_OUT), strict=True)
        temperatures = [fit_temperature(proba, truth) for proba, truth in held_out]
    given = parts, read.training(plan, parts, method), plan.classes, system["integrator"]
    integrator = fuse(*given, temperatures=temperatures, cross_validated=False).integrator
    tested = integrator.predict_proba(np.stack(read.arrays("test"), axis=1))
    judged = {plan.test: judge(plan.tested[0].labels(), tested, smallest)}
    for part in kept:
        proba = np.stack([one[part.home] for one in read.outputs(plan, [part])], axis=1)
        judged[part.home] = judge(part.chosen()[1], integrator.predict_proba(proba), smallest)
    return _both_ways(judged)


_HELD_OUT = ("cross_validated", "cross_validated_truth")


def _both_ways(judged: Mapping[str, tuple[float, float]]) -> list[Judgement]:
    """Pair each judged home with its test home.

    With two homes, each is the test home for the other. A single home is its own test home.
    """
    homes = list(judged)
    return [(test, home, *judged[home]) for test, home in zip(homes, reversed(homes), strict=True)]


def judge_smoothing(
    smoothing: Mapping[str, Any],
    source: Path,
    plan: plans.Plan,
    unseen: Mapping[str, NDArray[np.float64]],
    smallest: float,
) -> list[Judgement]:
    """Smooth the homes in a fold of a single cue, and judge the result.

    Integrations cannot be judged this way: their training distributions look too good, since they come from
    cues that have seen other frames of the same home.

    `smoothing` contains the settings for :func:`placecat.fusion.smoothing.fit`. `source` is the fold's file
    from the `cues` stage; PlacecatError is raised if it lacks cross-validated distributions. `unseen` maps
    each training home to (frames, n_classes) distributions for all its frames. They come from a cue that has
    seen neither this home nor the test home. Each training home is smoothed with statistics from the other
    training homes, and the test home with statistics from all training homes.
    """
    if not fold_file.has(source, "cross_validated"):
        raise PlacecatError(
            f"{source} has no array cross_validated, but judging smoothing requires it: set "
            "cross_validate: true for this cue, and run `dvc repro`"
        )
    held_out, truth = (fold_file.read(source, name) for name in ("cross_validated", "cross_validated_truth"))
    homes = [part.home for part in plan.cues]
    home_of_frame = np.repeat(homes, [len(part.chosen()[0]) for part in plan.cues])
    judged = []
    for home in homes:
        others = [part for part in plan.cues if part.home != home]
        is_other = home_of_frame != home
        model = fit_smoothing(others, held_out[is_other], truth[is_other], smoothing)
        smoothed = apply_smoothing(model, home, unseen[home])["delayed"]
        judged.append((plan.test, home, *judge_home(home, smoothed, smallest)))
    tested = smooth_home(source, plan, smoothing)["delayed"]
    return [*judged, (plan.test, plan.test, *judge_home(plan.test, tested, smallest))]
