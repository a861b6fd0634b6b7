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

    The K places are `classes`. The footage has `fps` frames per second; `length` is the number, from 1, of
    the last frame that was read. Each frame has a number in the footage, `numbers` (n,) int64 from 1, a time
    since the first frame, `seconds` (n,) float64, and an image file in `names`, which is empty if there are
    none. The smoothed probabilities `proba` (n, K) float64 decide the place; `integrated` are those of each
    frame alone. The last frame ends at `end` seconds; None if it lasts as long as the median frame. `turned`
    are the numbers of the frames whose size differs from that of the first, and `cuts` the indices of the
    frames that follow a cut, such as a new floor. Decisions with a confidence below `threshold` are unknown.
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
        """(n,) int64, class index of each decision."""
        return self.proba.argmax(axis=1)

    @property
    def frame_decision(self) -> NDArray[np.int64]:
        """(n,) int64, class index that each frame alone suggests."""
        return self.integrated.argmax(axis=1)

    @property
    def confidence(self) -> NDArray[np.float64]:
        """(n,) probability of the decision."""
        return self.proba.max(axis=1)

    @property
    def is_known(self) -> NDArray[np.bool_]:
        """(n,) bool, whether the confidence reaches the threshold."""
        return self.confidence >= self.threshold

    @property
    def place_names(self) -> list[str]:
        """Place of each frame, or ``unknown``."""
        pairs = zip(self.decision.tolist(), self.is_known.tolist(), strict=True)
        return [self.classes[place] if known else UNKNOWN for place, known in pairs]

    def visits(self) -> list[Visit]:
        """List stays like :meth:`placecat.categorizer.Categorizer.visits`; the last ends with the footage."""
        log = VisitLog()
        frames = zip(self.place_names, self.confidence.tolist(), self.seconds.tolist(), strict=True)
        for number, frame in enumerate(frames):
            log.add(*frame, begins=number in self.cuts)
        return log.until(float(self.ends[-1]))

    @property
    def ends(self) -> NDArray[np.float64]:
        """(n,) float64, time in seconds at which each frame ends."""
        step = float(np.median(np.diff(self.seconds))) if len(self.seconds) > 1 else 1 / self.fps
        return np.append(self.seconds[1:], self.seconds[-1] + step if self.end is None else self.end)

    def segments(self) -> list[Segment]:
        """List the runs of frames in one place, without gaps, by frame numbers of the footage.

        A frame that was not categorized joins the previous frame. `line` is a segment's line in segments.csv.
        """
        decision = self.decision
        firsts = np.flatnonzero(np.r_[True, decision[1:] != decision[:-1]])
        starts = self.numbers[firsts]
        ends = np.append(starts[1:] - 1, self.length)
        runs = zip(starts.tolist(), ends.tolist(), decision[firsts], strict=True)
        return [
            Segment(start, end, self.classes[place], line) for line, (start, end, place) in enumerate(runs, 2)
        ]
