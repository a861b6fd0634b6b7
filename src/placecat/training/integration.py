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
    """Return the parts used to train an integration.

    If its method learns from held-out frames, these are the parts used to train the cues.
    """
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
    """Train an integration on `parts`.

    `outputs` has one dictionary per cue, which maps the name of each part to the distributions for its chosen
    frames. `classes` are the names of the places. The other parameters are as in
    :func:`placecat.fusion.integrate.fit`.
    """
    train = {part.home: np.stack([proba[part.home] for proba in outputs], axis=1) for part in parts}
    truth = {part.home: part.chosen()[1] for part in parts}
    return integrate.fit(
        train, truth, classes, temperatures=temperatures, cross_validated=cross_validated, **integrator
    )


def fit_smoothing(
    parts: Sequence[Part],
    proba: NDArray[np.float64],
    truth: NDArray[np.int16],
    options: Mapping[str, Any],
) -> smoothing.SmoothingModel:
    """Fit a smoothing model by estimating its statistics on the frames of `parts`.

    `proba` contains (n, n_classes) cross-validated distributions for the frames of the parts, and `truth`
    contains the (n,) classes of these frames. `options` are as in :func:`placecat.fusion.smoothing.fit`.
    """
    walks, rates = training_walks(parts)
    return smoothing.fit(walks, proba, truth, proba.shape[1], training_frame_rates=rates, **options)


def apply_smoothing(
    model: smoothing.SmoothingModel, home: str, proba: NDArray[np.float64]
) -> dict[str, NDArray[np.float64]]:
    """Smooth the (frames, n_classes) distributions of `home`.

    Returns ``hmm`` and ``delayed``, the distributions after the filter and the delay, respectively.
    """
    return smoothing.apply(
        model,
        proba,
        listing.sequence_slices(home),
        frame_rate=listing.frame_rate(home),
        times=listing.uneven_times(home),
    )


def training_walks(parts: Sequence[Part]) -> tuple[list[NDArray[np.int16]], list[float]]:
    """Return the labels and frame rate of each sequence, for counting transitions.

    If frames are unevenly spaced, they are resampled as if a camera had recorded them at this frame rate.
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
                # The margin allows for rounded times.
                shown = np.searchsorted(times[stretch], moments + 1e-6, side="right") - 1
                walk = walk[shown]
            walks.append(walk)
            rates.append(rate)
    return walks, rates
