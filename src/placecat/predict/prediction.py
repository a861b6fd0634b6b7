"""A prediction: a place and probabilities for each categorized frame of footage."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat.categorizer.visits import UNKNOWN, Visit, VisitLog
from placecat.sequences.labels import Segment


@dataclass(frozen=True, eq=False)
class Prediction:
    """The n categorized frames, in order.

    `classes` are the names of the K places. The footage has `fps` frames per second, and `length` is the
    number of the last frame that was read. `numbers`, (n,) int64, are the numbers of the categorized frames
    in the footage, counted from 1. `seconds`, (n,) float64, are their times since the first frame. `names`
    lists the names of their image files, or is empty if there are none.

    `proba`, (n, K) float64, are the smoothed probabilities, which determine the place. `integrated` are the
    probabilities from each frame alone. The last frame ends at `end` seconds or, if that is None, lasts as
    long as the median frame. `turned` lists the numbers of the frames that differ in size from the first
    frame. `cuts` lists the indices of the frames that follow a cut, such as a change of floor. Decisions with
    a confidence below `threshold` are unknown.
    """

    classes: tuple[str, ...]
    fps: float
    length: int
    numbers: NDArray[np.int64]
    seconds: NDArray[np.float64]
    names: Sequence[str]
    proba: NDArray[np.float64]
    integrated: NDArray[np.float64]
    end: float | None = None
    turned: Sequence[int] = ()
    threshold: float = 0.0
    cuts: Sequence[int] = ()

    @property
    def decision(self) -> NDArray[np.int64]:
        """The class index of each decision, (n,) int64."""
        return self.proba.argmax(axis=1)

    @property
    def frame_decision(self) -> NDArray[np.int64]:
        """The class index suggested by each frame alone, (n,) int64."""
        return self.integrated.argmax(axis=1)

    @property
    def confidence(self) -> NDArray[np.float64]:
        """The probability of each decision, (n,)."""
        return self.proba.max(axis=1)

    @property
    def is_known(self) -> NDArray[np.bool_]:
        """Whether the confidence of each decision reaches the threshold, (n,) bool."""
        return self.confidence >= self.threshold

    @property
    def place_names(self) -> list[str]:
        """The place of each frame, or ``unknown``."""
        pairs = zip(self.decision.tolist(), self.is_known.tolist(), strict=True)
        return [self.classes[place] if known else UNKNOWN for place, known in pairs]

    def visits(self) -> list[Visit]:
        """List the stays in order; the last stay ends with the footage.

        See :meth:`placecat.categorizer.Categorizer.visits`.
        """
        log = VisitLog()
        frames = zip(self.place_names, self.confidence.tolist(), self.seconds.tolist(), strict=True)
        for number, frame in enumerate(frames):
            log.add(*frame, begins=number in self.cuts)
        return log.until(float(self.ends[-1]))

    @property
    def ends(self) -> NDArray[np.float64]:
        """The time in seconds at which each frame ends, (n,) float64."""
        step = float(np.median(np.diff(self.seconds))) if len(self.seconds) > 1 else 1 / self.fps
        return np.append(self.seconds[1:], self.seconds[-1] + step if self.end is None else self.end)

    def segments(self) -> list[Segment]:
        """List the segments of the footage: runs of frames in the same place, with no gaps between them.

        The start and end of a segment are frame numbers in the footage. A frame that was not categorized
        belongs to the segment of the frame before it. `line` is the line number of the segment in
        segments.csv.
        """
        decision = self.decision
        firsts = np.flatnonzero(np.r_[True, decision[1:] != decision[:-1]])
        starts = self.numbers[firsts]
        ends = np.append(starts[1:] - 1, self.length)
        runs = zip(starts.tolist(), ends.tolist(), decision[firsts], strict=True)
        return [
            Segment(start, end, self.classes[place], line) for line, (start, end, place) in enumerate(runs, 2)
        ]
