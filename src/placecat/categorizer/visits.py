"""Stays: runs of frames with the same decision."""

from dataclasses import dataclass, replace

UNKNOWN = "unknown"
"""Name given to a decision whose confidence is too low."""


@dataclass(frozen=True)
class Visit:
    """A stay in a place, which may be `UNKNOWN`.

    `start` is the time of its first frame, and `end` is the time of the first frame after it, both in
    seconds. A stay has at least one frame, and `confidence` is the mean over its frames.
    """

    place: str
    start: float
    end: float
    confidence: float
    frames: int


class VisitLog:
    """Collects stays frame by frame. Memory use grows with the number of stays, not the number of frames."""

    def __init__(self) -> None:
        self._visits: list[Visit] = []

    def add(self, place: str, confidence: float, seconds: float, *, begins: bool = False) -> None:
        """Add a frame: its place, confidence and time in seconds, and whether a cut precedes it."""
        if begins or not self._visits or self._visits[-1].place != place:
            self._visits = [*self.until(seconds), Visit(place, seconds, seconds, confidence, 1)]
            return
        last = self._visits[-1]
        count = last.frames + 1
        mean = last.confidence + (confidence - last.confidence) / count
        self._visits[-1] = replace(last, confidence=mean, frames=count)

    def until(self, seconds: float | None) -> list[Visit]:
        """List the stays, with the last one ending at `seconds`. If `seconds` is None, the list is empty."""
        if not self._visits or seconds is None:
            return []
        return [*self._visits[:-1], replace(self._visits[-1], end=seconds)]
