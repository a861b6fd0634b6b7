"""Measurements of a system in unseen homes. Each home is left out of training, then used for testing."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import paths, settings
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.evaluation.selection import choose_threshold, decided, select_unseen
from placecat.sequences.listing import read_labels
from placecat.training import fold_file, protocol
from placecat.training import plan as plans
from placecat.training import system as systems

# Maps each home to its (frames, n_classes) distributions after the delay.
HeldOut = Mapping[str, NDArray[np.float64]]


def of_stages(params: Mapping[str, Any], name: str, seed: int) -> HeldOut:
    """Read the output that the `smoothing` stage saved for a system in each test home."""
    homes = protocol.tested_homes(
        settings.get(params, "dataset.homes"), settings.get(params, "protocol.test_homes")
    )
    folder = paths.SMOOTHING / name
    return {home: fold_file.read(fold_file.seeded(folder, home, seed), "delayed") for home in homes}


def by_training(params: Mapping[str, Any], name: str, without: Sequence[str], seed: int) -> HeldOut:
    """For each home, train the system `name` without that home, then apply it to that home.

    Homes in `without` are always left out. If `without` is empty, the outputs are identical to those of the
    stages. If there are too few homes, the result is empty.
    """
    homes = [home for home in settings.get(params, "dataset.homes") if home not in without]
    scheme = settings.get(params, f"systems.{name}.scheme")
    if len(homes) < protocol.least_homes(scheme):
        return {}
    system = systems.System.of(params, name)
    outputs = {}
    for home in homes:
        plan = plans.of_release(params, scheme, [home, *without], extra=system.extra)
        outputs[home] = systems.train(plan, system, seed).test(home)["delayed"]
    return outputs


def accuracies(held_out: HeldOut) -> dict[str, float]:
    """Return the mean accuracy over the places of each home, in percent (thesis 4.2)."""
    return {
        home: round(
            home_accuracy(confusion_matrix(read_labels(home), proba.argmax(axis=1), proba.shape[1])), 2
        )
        for home, proba in held_out.items()
    }


def unknown(held_out: HeldOut, chosen: float, shown: Sequence[float]) -> dict[str, Any] | None:
    """Choose the confidence below which a decision is unknown.

    `chosen` is the accepted share of wrong decisions. The shares in `shown` are measured too. Returns a
    dictionary for the card, or None if there are fewer than two homes.

    In the dictionary, ``risk`` is `chosen`, and ``threshold`` is the chosen confidence, or None if no
    confidence is high enough. ``measured`` has one entry per share, with ``threshold``, ``coverage``,
    ``wrong`` and ``worst``. For the last three, each home's threshold is chosen on the other homes (see
    :class:`placecat.evaluation.selection.Selection`).
    """
    homes = {home: decided(read_labels(home), proba) for home, proba in held_out.items()}
    if len(homes) < 2:
        return None
    rows = []
    for risk in sorted({*shown, chosen}):
        unseen = select_unseen(homes, risk)
        rows.append(
            {
                "risk": risk,
                "threshold": _finite(choose_threshold(list(homes.values()), risk)),
                "coverage": _finite(round(unseen.coverage, 4)),
                "wrong": _finite(round(unseen.risk, 4)),
                "worst": _finite(round(unseen.worst, 4)),
            }
        )
    (threshold,) = (row["threshold"] for row in rows if row["risk"] == chosen)
    return {"risk": chosen, "threshold": threshold, "measured": rows}


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None
