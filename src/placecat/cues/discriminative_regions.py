"""Model that uses only regions with discriminative codewords (an addition to the thesis)."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.cues.codebook import Codebook
from placecat.cues.descriptors import CueModel, Descriptors
from placecat.errors import PlacecatError
from placecat.learning.activations import activations
from placecat.learning.discriminative import discriminative_codewords
from placecat.ranges import Count, PositiveShare

#: Whether the model accepts only sets of regions, never whole frames.
OF_REGIONS_ONLY = True


class DiscriminativeRegionsCue:
    """Cue that ignores every region whose codeword was not chosen."""

    def __init__(self, codebook: Codebook, kept: NDArray[np.bool_], cue: CueModel) -> None:
        self.codebook = codebook
        self.kept = kept
        self.cue = cue
        self.facts: dict[str, Any] = cue.facts | {"kept_codewords": int(kept.sum())}

    def predict_proba(self, frames: Descriptors) -> NDArray[np.float64]:
        """Return (n, n_classes) distributions over places."""
        return self.cue.predict_proba(only(frames, self.codebook.words(frames, len(self.kept)), self.kept))


def only(frames: Descriptors, words: NDArray[np.int32], kept: NDArray[np.bool_]) -> Descriptors:
    """Keep the regions whose codeword the mask `kept` selects.

    `words` is (n, max_regions), padded with -1, and `kept` is (N,).
    """
    taken = (words >= 0) & kept[words]
    counts = taken.sum(axis=1)
    x = np.zeros_like(frames.x)
    x[np.arange(x.shape[1]) < counts[:, None]] = frames.x[taken]
    return Descriptors(x, counts.astype(np.int64))


def fit(
    train: Descriptors,
    labels: NDArray[np.int16],
    homes: NDArray[np.str_],
    codebook: Codebook | None,
    classes: Sequence[str],
    *,
    cue: Mapping[str, Any],
    clusters: Count,
    keep: PositiveShare,
) -> DiscriminativeRegionsCue:
    """Choose codewords using the training frames, then train a cue on the regions that have these codewords.

    `cue` contains the settings of this cue's classifier, which uses the same number of `clusters`. `keep` is
    the share of clusters to choose; see :func:`placecat.learning.discriminative.discriminative_codewords`.
    """
    from placecat import cues

    if codebook is None or not train.is_set:
        raise PlacecatError(
            "classifier.model 'discriminative_regions' needs a codebook of salient regions: set the cue's "
            "codebook and input"
        )
    words = codebook.words(train, clusters)
    kept = discriminative_codewords(activations(words, clusters), labels, keep)
    regions, own = only(train, words, kept), {**cue, "clusters": clusters}
    inner = cues.fit(regions, labels, homes, classifier=own, classes=classes, codebook=codebook)
    return DiscriminativeRegionsCue(codebook, kept, inner)
