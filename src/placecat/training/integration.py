"""Integrate and smooth the cues' distributions according to a plan."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import settings
from placecat.fusion import integrate, smoothing
from placecat.sequences import listing
from placecat.training.plan import Part, Plan

Probabilities = Mapping[str, NDArray[np.float64]]


def smoothing_settings(params: Mapping[str, Any]) -> dict[str, Any]:
    """Read the settings in params.yaml for :func:`placecat.fusion.smoothing.fit`."""
    section = settings.get(params, "smoothing")
    return {name: value for name, value in section.items() if name not in ("cues", "filtered")}


def fused_parts(plan: Plan, *, method: str, extra: bool) -> tuple[Part, ...]:
    """Return an integration's training parts: the cues' parts if the method learns from held-out frames."""
    if integrate.learns_from_held_out(method):
        return plan.cues
    return (*plan.integration, *(plan.extra if extra else ()))


def fuse(
    parts: Sequence[Part],
    outputs: Sequence[Probabilities],
    classes: Sequence[str],
    integrator: Mapping[str, Any],
    *,
    temperatures: Sequence[float] | None = None,
    cross_validated: bool = True,
) -> integrate.Trained:
    """Train an integration.

    Parameters
    ----------
    parts
        Parts that train the integration.
    outputs
        One dictionary per cue, which maps each part's name to the distributions for its chosen frames.
    classes
        Names of the places.
    integrator, temperatures, cross_validated
        As in :func:`placecat.fusion.integrate.fit`.
    """
    train = {part.home: np.stack([proba[part.home] for proba in outputs], axis=1) for part in parts}
    truth = {part.home: part.chosen()[1] for part in parts}
    return integrate.fit(
        train, truth, classes, temperatures=temperatures, cross_validated=cross_validated, **integrator
    )


def training_walks(parts: Sequence[Part]) -> tuple[list[NDArray[np.int16]], list[float]]:
    """Return each uncut stretch's labels and frame rate, for counting transitions.

    Unevenly timed frames are resampled as a camera with this frame rate would have shown them.
    """
    walks: list[NDArray[np.int16]] = []
    rates: list[float] = []
    for part in parts:
        labels, rate = part.labels(), listing.frame_rate(part.home)
        times = listing.uneven_times(part.home)
        for stretch in listing.sequence_slices(part.home):
            walk = labels[stretch]
            if times is not None:
                moments = np.arange(0.0, times[stretch][-1] + 0.5 / rate, 1.0 / rate)
                # Times are rounded.
                shown = np.searchsorted(times[stretch], moments + 1e-6, side="right") - 1
                walk = walk[shown]
            walks.append(walk)
            rates.append(rate)
    return walks, rates


def smooth(
    home: str,
    proba: NDArray[np.float64],
    parts: Sequence[Part],
    training_proba: NDArray[np.float64],
    training_truth: NDArray[np.int16],
    options: Mapping[str, Any],
) -> dict[str, NDArray[np.float64]]:
    """Smooth one sequence's distributions using statistics from other sequences.

    Parameters
    ----------
    proba
        (frames, n_classes) for every frame of `home`.
    parts
        Parts that provide the statistics.
    training_proba, training_truth
        (n, n_classes) cross-validated distributions for these parts' frames, and their (n,) classes.
    options
        As in :func:`placecat.fusion.smoothing.fit`.

    Returns
    -------
    dict
        ``hmm`` and ``delayed``, each (frames, n_classes).
    """
    walks, frame_rates = training_walks(parts)
    model = smoothing.fit(
        walks,
        training_proba,
        training_truth,
        proba.shape[1],
        training_frame_rates=frame_rates,
        **options,
    )
    return smoothing.apply(
        model,
        proba,
        listing.sequence_slices(home),
        frame_rate=listing.frame_rate(home),
        times=listing.uneven_times(home),
    )
