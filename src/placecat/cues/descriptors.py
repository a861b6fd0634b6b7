"""Frame descriptors, which are the input to cues, and the interface of a trained cue."""

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Descriptors:
    """Descriptors of n frames: one vector (holistic) or a set of vectors (salient regions) per frame.

    `x` is float32: (n, d) for holistic descriptors, and (n, max_regions, d) for regions. `counts` (n,) is the
    number of regions in each frame, and the remaining rows of `x` are padding. `counts` is None for holistic
    descriptors.
    """

    x: NDArray[np.float32]
    counts: NDArray[np.int64] | None = None

    def __len__(self) -> int:
        return len(self.x)

    def take(self, frames: NDArray[np.intp]) -> "Descriptors":
        """Return the descriptors of the frames at these indices, in the given order."""
        return Descriptors(self.x[frames], None if self.counts is None else self.counts[frames])

    @property
    def is_set(self) -> bool:
        """Whether each frame has a set of vectors."""
        return self.counts is not None

    def valid(self) -> NDArray[np.bool_]:
        """Return the (n, max_regions) mask of the rows that are not padding."""
        assert self.counts is not None
        return np.arange(self.x.shape[1])[None, :] < self.counts[:, None]

    def rows(self) -> NDArray[np.float32]:
        """Return all vectors as one matrix.

        It is (n, d) for holistic descriptors. For regions, it is (sum of counts, d), ordered by frame and
        then by region.
        """
        return self.x if self.counts is None else self.x[self.valid()]

    def frame_of_row(self) -> NDArray[np.int64]:
        """Return the frame index of each row of :meth:`rows`."""
        if self.counts is None:
            return np.arange(len(self.x))
        return np.repeat(np.arange(len(self.x)), self.counts)


class CueModel(Protocol):
    """A trained cue. `facts` describes its training, such as the nu used, in JSON types only."""

    facts: dict[str, Any]

    def predict_proba(self, frames: Descriptors) -> NDArray[np.float64]:
        """Return (n, n_classes) distributions over places; rows sum to 1."""
        ...
