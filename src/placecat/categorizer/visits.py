"""Stays: runs of frames of one place."""

from dataclasses import dataclass, replace

UNKNOWN = "unknown"
"""Name of a decision that is not sure enough."""


@dataclass(frozen=True)
class Visit:
    """A stay.

    Attributes
    ----------
    place
        Its name; `UNKNOWN` if no decision was sure enough.
    start, end
        Seconds at which its first frame came, and the first one after it.
    confidence
        Mean of its frames.
    frames
        How many there were, at least 1.
    """

    place: str
    start: float
    end: float
    confidence: float
    frames: int


class VisitLog:
    """Collects stays frame by frame; it grows with the stays, not with the frames."""

    def __init__(self) -> None:
        self._visits: list[Visit] = []

    def add(self, place: str, confidence: float, seconds: float, *, begins: bool = False) -> None:
        """Take the next frame: its place's name, its confidence, its time, and whether a cut precedes it."""
        if begins or not self._visits or self._visits[-1].place != place:
            self._visits = [*self.until(seconds), Visit(place, seconds, seconds, confidence, 1)]
            return
        last = self._visits[-1]
        count = last.frames + 1
        mean = last.confidence + (confidence - last.confidence) / count
        self._visits[-1] = replace(last, confidence=mean, frames=count)

    def until(self, seconds: float | None) -> list[Visit]:
        """List the stays, the last of which ends at this time."""
        if not self._visits or seconds is None:
            return []
        return [*self._visits[:-1], replace(self._visits[-1], end=seconds)]
