"""Classify places by the joint probability of a frame's codewords (thesis 3.3.2 and 4.2, Figure 10)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.cues import estimators
from placecat.cues.codebook import Codebook
from placecat.cues.descriptors import Descriptors
from placecat.errors import PlacecatError
from placecat.learning.activations import activations
from placecat.ranges import Count


@dataclass
class JointProbabilityCue:
    """Joint model of a frame's 16 cell codewords (holistic), or of its N binary activations (regions)."""

    codebook: Codebook
    clusters: int
    estimator: Any
    facts: dict[str, Any] = field(default_factory=dict)

    def codes(self, frames: Descriptors) -> NDArray[Any]:
        """Return the (n, variables) values of the random variables c_1 .. c_N in equation (10)."""
        words = self.codebook.words(frames, self.clusters)
        return activations(words, self.clusters) if frames.is_set else words

    def predict_proba(self, frames: Descriptors) -> NDArray[np.float64]:
        """Return (n, n_classes) distributions over places."""
        return self.estimator.predict_proba(self.codes(frames))


def fit(
    train: Descriptors,
    labels: NDArray[np.int16],
    homes: NDArray[np.str_],
    codebook: Codebook | None,
    classes: Sequence[str],
    *,
    base: Mapping[str, Any],
    clusters: Count,
) -> JointProbabilityCue:
    """Train a joint model.

    `base` is an estimator of `placecat.learning` that takes integer codes: `naive_bayes` (equation 12) or
    `dependency_tree` (equation 11). `clusters` is the number of clusters per tree, which is (16-1) k + 1
    after k splits in a hierarchy.
    """
    if codebook is None:
        raise PlacecatError(
            "classifier.model 'joint_probability' needs a codebook: set the cue's codebook and input"
        )
    n_values = 2 if train.is_set else clusters
    cue = JointProbabilityCue(
        codebook, clusters, estimators.build(base, "classifier.base", n_values=n_values)
    )
    cue.estimator.fit(cue.codes(train), labels)
    return cue
