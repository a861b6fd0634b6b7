"""The modified nearest-neighbour classifier for regions or whole frames (thesis 3.3.1.1)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.cues import estimators
from placecat.cues.codebook import Codebook
from placecat.cues.descriptors import Descriptors
from placecat.errors import PlacecatError
from placecat.ranges import Count


@dataclass
class NearestNeighboursCue:
    """Cue that multiplies the class frequencies of the clusters nearest to a frame's regions."""

    estimator: Any
    facts: dict[str, Any] = field(default_factory=dict)

    def predict_proba(self, frames: Descriptors) -> NDArray[np.float64]:
        """Return (n, n_classes) distributions over places."""
        if frames.counts is None:
            return self.estimator.predict_proba(frames.x)
        return self.estimator.predict_proba_sets(frames.x, frames.counts)


def fit(
    train: Descriptors,
    labels: NDArray[np.int16],
    homes: NDArray[np.str_],
    codebook: Codebook | None,
    classes: Sequence[str],
    *,
    base: Mapping[str, Any],
    clusters: Count,
) -> NearestNeighboursCue:
    """Train the modified classifier on all regions or all frames. Each region takes its frame's label."""
    if codebook is None:
        raise PlacecatError("classifier.model 'knn' needs a codebook: set the cue's codebook and input")
    if len(codebook.trees) != 1:
        raise PlacecatError(
            "classifier.model 'knn' needs a codebook of whole descriptors: set the codebook's cells to 1"
        )
    estimator = estimators.build(base, "classifier.base", codebook=codebook.trees[0], n_clusters=clusters)
    estimator.fit(train.rows(), labels[train.frame_of_row()])
    return NearestNeighboursCue(estimator)
