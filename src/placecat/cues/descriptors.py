"""The input of a cue: descriptors of some frames."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Descriptors:
    """Descriptors of n frames: one vector (holistic) or a set of vectors (salient regions) per frame.

    `x` is float32, (n, d) holistic or (n, max_regions, d) of regions. `counts` are the (n,) numbers of
    regions of the frames, the other rows being padding; None for holistic ones.
    """

    x: NDArray[np.float32]
    counts: NDArray[np.int64] | None = None

    def __len__(self) -> int:
        return len(self.x)

    def take(self, frames: NDArray[np.intp]) -> "Descriptors":
        """The descriptors of some frames, by index and in this order."""
        return Descriptors(self.x[frames], None if self.counts is None else self.counts[frames])

    @property
    def is_set(self) -> bool:
        """Whether each frame has a set of vectors."""
        return self.counts is not None

    def valid(self) -> NDArray[np.bool_]:
        """(n, max_regions) mask of the rows that are not padding."""
        assert self.counts is not None
        return np.arange(self.x.shape[1])[None, :] < self.counts[:, None]

    def rows(self) -> NDArray[np.float32]:
        """All vectors, stacked: (n, d), or (sum of counts, d) in the order of frames and regions."""
        return self.x if self.counts is None else self.x[self.valid()]

    def frame_of_row(self) -> NDArray[np.int64]:
        """The frame of each row of :meth:`rows`."""
        if self.counts is None:
            return np.arange(len(self.x))
        return np.repeat(np.arange(len(self.x)), self.counts)
