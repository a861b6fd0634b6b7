"""Two-class classifiers, one per place, combined into a distribution (thesis 3.3.1.2, Figure 8)."""

import json
from collections.abc import Mapping, Sequence
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from placecat.cues import estimators
from placecat.cues.codebook import Codebook
from placecat.cues.descriptors import Descriptors
from placecat.learning.memory import remembered
from placecat.learning.scaling import KINDS, KernelScaling
from placecat.learning.spatial_pca import SpatialPCA
from placecat.ranges import OneOf, Positive, Two


class OneAgainstAllCue:
    """Cue that reduces the dimension of its descriptor, scales it, and applies the multi-class scheme."""

    def __init__(self, steps: list[Any], scheme: Any) -> None:
        self.steps = steps
        self.scheme = scheme
        self.facts: dict[str, Any] = {}

    def predict_proba(self, frames: Descriptors) -> NDArray[np.float64]:
        """Return (n, n_classes) distributions over places, each a product over the regions of the frame."""
        _, rows = remembered("rows", (frames, None), lambda: _rows(frames, None))
        if len(rows) == 0:
            # With no frames or regions, the matrix is empty, which estimators reject.
            proba = np.empty((0, len(self.scheme.classes_)))
        else:
            for step in self.steps:
                rows = _transformed(step, rows)
            proba = self.scheme.predict_proba(rows)
        if not frames.is_set:
            return proba
        log_proba = np.log(np.maximum(proba, np.finfo(np.float64).tiny))
        return product_of_rows(log_proba, frames.frame_of_row(), len(frames))


def product_of_rows(
    log_proba: NDArray[np.float64], frame_of_row: NDArray[np.int64], n_frames: int
) -> NDArray[np.float64]:
    """Multiply and normalise the distributions of each frame's regions (thesis 3.3.1 and 4.4.1).

    `log_proba` contains the (rows, n_classes) log-probabilities of the regions, and `frame_of_row` contains
    the (rows,) frame index of each region. Returns (n_frames, n_classes) distributions. A frame without
    regions gets a uniform distribution.
    """
    total = np.zeros((n_frames, log_proba.shape[1]))
    np.add.at(total, frame_of_row, log_proba)
    # Subtract the maximum to avoid underflow.
    proba = np.exp(total - total.max(axis=1, keepdims=True))
    normalised: NDArray[np.float64] = proba / proba.sum(axis=1, keepdims=True)
    return normalised


def _rows(frames: Descriptors, most: int | None) -> tuple[NDArray[np.intp], NDArray[np.float32]]:
    """Return the indices and vectors of all rows, or of at most `most` evenly spaced rows."""
    x = frames.rows()
    if most is None or most >= len(x):
        return np.arange(len(x)), x
    kept = np.linspace(0, len(x) - 1, most).round().astype(np.intp)
    return kept, x[kept]


def _transformed(step: Any, x: NDArray[np.float32]) -> NDArray[np.float32]:
    transformed: NDArray[np.float32] = remembered("transformed", (step, x), lambda: step.transform(x))
    return transformed


def fit(
    train: Descriptors,
    labels: NDArray[np.int16],
    homes: NDArray[np.str_],
    codebook: Codebook | None,
    classes: Sequence[str],
    *,
    base: Mapping[str, Any],
    scheme: Mapping[str, Any],
    scaling: Annotated[str, OneOf(KINDS)],
    gamma_scale: Positive = 1.0,
    reduction: Mapping[str, Any] | None = None,
    max_rows: Two | None = None,
) -> OneAgainstAllCue:
    """Train one two-class classifier per place and the scheme that combines them.

    `base` is a two-class estimator of `placecat.learning`: `nu_svm`, `rvm` or `gentle_adaboost`. `scheme` is
    a multi-class estimator: `one_against_all` (parallel) or `sequential`. `scaling` is the kind of
    :class:`~placecat.learning.scaling.KernelScaling`, and `gamma_scale` is its factor for squared distances.
    `reduction` contains the settings of :class:`~placecat.learning.spatial_pca.SpatialPCA`, such as 16 cells
    of 64 components each for spatial PACT. `max_rows` limits slow classifiers to that many evenly spaced
    training rows (not in the thesis).
    """
    kept, x = remembered("rows", (train, max_rows), lambda: _rows(train, max_rows))
    frame = train.frame_of_row()[kept]
    steps: list[Any] = []
    if reduction is not None:
        options = json.dumps(reduction, sort_keys=True)
        pca = remembered("reduction", (x, options), lambda: SpatialPCA(**reduction).fit(x))
        steps.append(pca)
        x = _transformed(pca, x)
    kernel_scaling = remembered(
        "scaling", (x, scaling, gamma_scale), lambda: KernelScaling(scaling, gamma_scale).fit(x)
    )
    steps.append(kernel_scaling)
    x = _transformed(kernel_scaling, x)
    binary = estimators.build(base, "classifier.base")
    multi = estimators.build(scheme, "classifier.scheme", base=binary)
    multi.fit(x, labels[frame], groups=homes[frame], class_names=classes)
    cue = OneAgainstAllCue(steps, multi)
    cue.facts["flat_sigmoids"] = [int(count) for count in multi.flat_]
    if np.isfinite(multi.nu_).all():
        cue.facts["nu"] = [round(float(nu), 6) for nu in multi.nu_]
    if getattr(multi, "reliability_", None) is not None:
        cue.facts["reliability"] = np.round(multi.reliability_, 6).tolist()
    return cue
