"""Candidates judged on training homes, from the features and the cues that the stages left."""

import itertools
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import cue_training, files, listing, paths, store
from placecat.evaluation import protocol
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.evaluation.probabilities import log_loss
from placecat.fusion.integrate import fit
from placecat.fusion.temperature import fit_temperature

# (home that was left out as a test home, home that is judged, accuracy in percent, log-loss in nats).
Judgement = tuple[str, str, float, float]


def judge(truth: NDArray[np.int16], proba: NDArray[np.float64], smallest: float) -> tuple[float, float]:
    """Accuracy in percent (mean over the places) and log-loss (likewise, in nats) of one home's frames."""
    confusion = confusion_matrix(truth, proba.argmax(axis=1), proba.shape[1])
    return home_accuracy(confusion), log_loss(truth, proba, smallest=smallest)


def left_out(homes: Sequence[str]) -> list[tuple[str, ...]]:
    """Which homes are left out together: every pair, and every home by itself."""
    return [*itertools.combinations(homes, 2), *((home,) for home in homes)]


def predict_unseen(
    cue: Mapping[str, Any],
    homes: Sequence[str],
    without: tuple[str, ...],
    frames: Mapping[str, int],
    classes: Sequence[str],
) -> dict[str, NDArray[np.float64]]:
    """Train a cue without codebook on all homes but some; give its distributions for every frame of these."""
    trained = cue_training.train(
        tuple(home for home in homes if home not in without),
        cue["descriptor"],
        classifier=cue["classifier"],
        codebook=None,
        frames=frames,
        classes=classes,
    )
    described = {home: store.read_descriptors(home, cue["descriptor"]) for home in without}
    return {home: trained.model.predict_proba(frames) for home, frames in described.items()}


def judge_cue(
    cue: Mapping[str, Any],
    homes: Sequence[str],
    without: tuple[str, ...],
    frames: Mapping[str, int],
    classes: Sequence[str],
    smallest: float,
) -> list[Judgement]:
    """Train a cue without some homes and judge them.

    Parameters
    ----------
    cue
        Its settings; it has no codebook.
    without
        One home, which is then a test home, or two, of which each is a training home that was not seen when
        the other is tested.
    """
    unseen = predict_unseen(cue, homes, without, frames, classes)
    judged = {home: judge_home(home, proba, smallest) for home, proba in unseen.items()}
    return _both_ways(without, judged)


def judge_home(home: str, proba: NDArray[np.float64], smallest: float) -> tuple[float, float]:
    """Judge the distributions of a home's every frame by those that are labelled."""
    labels = listing.read_labels(home)
    rows = np.flatnonzero(labels >= 0)
    return judge(labels[rows], proba[rows], smallest)


def judge_system(
    system: Mapping[str, Any],
    fold: protocol.Fold,
    seed: int,
    frames: Mapping[str, int],
    classes: Sequence[str],
    smallest: float,
) -> list[Judgement]:
    """Train an integration on the cues of a fold and judge the homes that they have not seen.

    Parameters
    ----------
    system
        Its settings.
    fold
        Of 4-5-1: the integration trains on the homes of the cues, as in 5-5-1, and judges the home that is
        kept from them as well as the test home. Of 5-5-1: it judges the test home.
    """
    (*kept,) = (home for home in fold.integration_homes if home not in fold.cue_homes)
    labels = {home: listing.read_labels(home) for home in (*fold.cue_homes, *kept, fold.test)}
    chosen = protocol.select_training({home: labels[home] for home in fold.cue_homes}, **frames)
    places = [listing.seeded(paths.CUES / cue / fold.scheme / fold.test, seed) for cue in system["cues"]]

    def read(array: str) -> NDArray[np.float64]:
        parts = [files.read_array(place / f"{array}.npy", memory_map=False) for place in places]
        return np.stack(parts, axis=1)

    temperatures = None
    if system["temperature"]:
        arrays = [
            [files.read_array(place / f"{name}.npy", memory_map=False) for name in _HELD_OUT]
            for place in places
        ]
        temperatures = [fit_temperature(proba, truth) for proba, truth in arrays]
    trained = fit(
        {home: read(f"integration_{home}") for home in fold.cue_homes},
        {home: labels[home][chosen[home]] for home in fold.cue_homes},
        classes,
        temperatures=temperatures,
        cross_validated=False,
        **system["integrator"],
    )
    judged = {}
    for home, array in [(fold.test, "test"), *((home, f"integration_{home}") for home in kept)]:
        truth = labels[home]
        if array != "test":
            truth = truth[protocol.select_frames(truth, **frames)]
        judged[home] = judge(truth, trained.integrator.predict_proba(read(array)), smallest)
    return _both_ways((fold.test, *kept), judged)


_HELD_OUT = ("cross_validated", "cross_validated_truth")


def _both_ways(without: tuple[str, ...], judged: Mapping[str, tuple[float, float]]) -> list[Judgement]:
    """Each of two homes is judged for the other as the test home; a single one is the test home."""
    if len(without) == 1:
        return [(without[0], without[0], *judged[without[0]])]
    first, second = without
    return [(first, second, *judged[second]), (second, first, *judged[first])]
