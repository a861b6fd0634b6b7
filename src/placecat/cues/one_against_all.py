"""Two-class classifiers, one per place, combined into a distribution (thesis 3.3.1.2, Figure 8)."""

from collections.abc import Mapping, Sequence
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from placecat.cues import estimators
from placecat.cues.codebook import Codebook
from placecat.cues.descriptors import Descriptors
from placecat.cues.model import product_of_rows
from placecat.learning.scaling import KINDS, KernelScaling
from placecat.learning.spatial_pca import SpatialPCA
from placecat.ranges import Count, OneOf, Positive


class OneAgainstAllCue:
    """Reduction and scaling of the descriptor, then the multi-class scheme."""

    def __init__(self, steps: list[Any], scheme: Any) -> None:
        self.steps = steps
        self.scheme = scheme
        self.facts: dict[str, Any] = {}

    def transform(self, x: NDArray[np.float32]) -> NDArray[np.float32]:
        """Apply reduction and scaling."""
        for step in self.steps:
            x = step.transform(x)
        return x

    def predict_proba(self, frames: Descriptors) -> NDArray[np.float64]:
        """(n, n_classes) distributions over places; for regions the product over a frame's regions."""
        rows = frames.rows()
        if len(rows) == 0:
            # No frames, or none with regions: estimators refuse an empty matrix.
            proba = np.empty((0, len(self.scheme.classes_)))
        else:
            proba = self.scheme.predict_proba(self.transform(rows))
        if not frames.is_set:
            return proba
        log_proba = np.log(np.maximum(proba, np.finfo(np.float64).tiny))
        return product_of_rows(log_proba, frames.frame_of_row(), len(frames))


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
    max_rows: Count | None = None,
) -> OneAgainstAllCue:
    """Train one two-class classifier per place and the scheme that combines them.

    `base` is a two-class estimator of `placecat.learning`: `nu_svm`, `rvm` or `gentle_adaboost`; `scheme` is
    a multi-class one: `one_against_all` (parallel) or `sequential`. `scaling` and `gamma_scale` are the kind
    of :class:`~placecat.learning.scaling.KernelScaling`, and its factor of squared distances. `reduction` has
    settings of :class:`~placecat.learning.spatial_pca.SpatialPCA`, e.g. 16 cells of 64 components for spatial
    PACT. `max_rows` is the most training rows, taken evenly, for slow classifiers; the thesis does not give
    it.
    """
    steps: list[Any] = []
    x = train.rows()
    rows = train.frame_of_row()
    if max_rows is not None and max_rows < len(x):
        kept = np.linspace(0, len(x) - 1, max_rows).round().astype(np.intp)
        x, rows = x[kept], rows[kept]
    if reduction is not None:
        steps.append(SpatialPCA(**reduction).fit(x))
        x = steps[-1].transform(x)
    steps.append(KernelScaling(scaling, gamma_scale).fit(x))
    x = steps[-1].transform(x)
    binary = estimators.build(base, "classifier.base")
    multi = estimators.build(scheme, "classifier.scheme", base=binary)
    multi.fit(x, labels[rows], groups=homes[rows], class_names=classes)
    cue = OneAgainstAllCue(steps, multi)
    cue.facts = facts_of(multi)
    return cue


def facts_of(scheme: Any) -> dict[str, Any]:
    """Facts of a fitted multi-class scheme: nu in force, flat sigmoids of each class, reliabilities."""
    facts: dict[str, Any] = {"flat_sigmoids": [int(count) for count in scheme.flat_]}
    if np.isfinite(scheme.nu_).all():
        facts["nu"] = [round(float(nu), 6) for nu in scheme.nu_]
    if getattr(scheme, "reliability_", None) is not None:
        facts["reliability"] = np.round(scheme.reliability_, 6).tolist()
    return facts
