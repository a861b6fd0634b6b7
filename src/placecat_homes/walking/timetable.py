"""Timetables of walks, with the frames in each section and the timing of its pieces."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat_homes.walking.journey import Piece, Section

_PAUSE = 0.6
_MARGIN = 0.15
_SPARE_SHARE = 0.5
_SLOW = 0.35


@dataclass(frozen=True)
class Span:
    """A piece of a section and when it takes place.

    Attributes
    ----------
    begin, end
        Seconds from the start of the walk.
    piece
        The part of the path, or the pause.
    section
        The section that the piece belongs to.
    """

    begin: float
    end: float
    piece: Piece
    section: Section

    @property
    def seconds(self) -> float:
        """Duration in seconds."""
        return self.end - self.begin


def least_seconds(section: Section, top_speed: float) -> float:
    """Compute how long a section takes at full speed."""
    pauses = sum(piece.length == 0 for piece in section.pieces)
    return _MARGIN + section.length / top_speed + _PAUSE * pauses


def allot(
    sections: Sequence[Section],
    least: Sequence[float],
    usual: Sequence[float],
    frames: int,
    transition_share: float,
    most_transitions: float,
    floors: dict[str, float],
) -> list[int] | None:
    """Allot frames to sections in proportion to their weights.

    Parameters
    ----------
    sections
        The sections of a journey.
    least
        Minimum number of frames for each section.
    usual
        Number of frames for each section that merely passes through a room, if there is time.
    frames
        Total number of frames.
    transition_share, most_transitions
        Intended share of frames for transitions, and the maximum share if they need more.
    floors
        Minimum number of frames for each label.

    Returns
    -------
    list of int or None
        Number of frames for each section, or None if `frames` is too small.
    """
    weights = np.array([section.weight for section in sections])
    needed = np.array(least, dtype=np.float64)
    moving = np.array([section.room < 0 for section in sections])
    passed = np.array([section.room >= 0 and not section.stay for section in sections])
    stays = ~moving & ~passed
    result = np.where(passed, np.maximum(needed, usual), 0.0)
    if moving.any():
        share = max(transition_share, needed[moving].sum() / frames)
        if share > most_transitions + 1e-9:
            return None
        result[moving] = fill(weights[moving], needed[moving], share * frames)
    rest = frames - result.sum()
    if needed[stays].sum() > rest:
        result[passed] = needed[passed]
        rest = frames - result.sum()
    for _ in range(4):
        if needed[stays].sum() > rest:
            return None
        result[stays] = fill(weights[stays], needed[stays], rest)
        enough = True
        for label, floor in floors.items():
            own = np.array([section.label == label for section in sections])
            missing = floor - result[own].sum()
            if missing > 0:
                enough = False
                longest = int(np.argmax(np.where(own & stays, result, -1.0)))
                needed[longest] = result[longest] + missing
        if enough:
            break
    ends = np.round(np.cumsum(result)).astype(int)
    counts = np.diff(ends, prepend=0)
    return [int(count) for count in counts] if counts.min() > 0 else None


def fill(weights: NDArray[np.float64], least: NDArray[np.float64], total: float) -> NDArray[np.float64]:
    """Divide `total` in proportion to the weights, but into parts no smaller than `least`."""
    low, high = 0.0, (total + 1.0) / weights.min()
    for _ in range(60):
        middle = 0.5 * (low + high)
        if np.maximum(least, middle * weights).sum() > total:
            high = middle
        else:
            low = middle
    result = np.maximum(least, low * weights)
    return result * (total / result.sum())


def spans(
    sections: Sequence[Section],
    counts: Sequence[int],
    rng: np.random.Generator,
    fps: float,
    speed: float,
    top_speed: float,
) -> list[Span]:
    """Allot seconds to each piece. If possible, keep to the usual speed and spend the rest on pauses."""
    result: list[Span] = []
    frame = 0
    for section, count in zip(sections, counts, strict=True):
        clock, end, seconds = frame / fps, (frame + count) / fps, count / fps
        frame += count
        pieces = list(section.pieces)
        if not any(piece.length == 0 for piece in pieces) and section.length < _SLOW * seconds:
            pieces = _with_pause(pieces, rng)
        pauses = [piece.length == 0 for piece in pieces]
        walking = seconds
        if any(pauses):
            pace = np.clip(section.length / (_SPARE_SHARE * seconds), speed, top_speed)
            walking = min(section.length / pace, max(0.5 * seconds, seconds - 0.4 * sum(pauses)))
        shares = rng.uniform(0.6, 1.4, len(pieces)) * pauses
        resting = shares / max(shares.sum(), 1e-9) * (seconds - walking)
        for piece, rest in zip(pieces, resting, strict=True):
            longer = rest if piece.length == 0 else walking * piece.length / max(section.length, 1e-9)
            result.append(Span(clock, clock + float(longer), piece, section))
            clock += float(longer)
        if result and abs(result[-1].end - end) > 1e-6:
            last = result[-1]
            result[-1] = Span(last.begin, end, last.piece, last.section)
    return result


def _with_pause(pieces: list[Piece], rng: np.random.Generator) -> list[Piece]:
    if not pieces:
        return pieces
    index = int(np.argmax([piece.length for piece in pieces]))
    piece = pieces[index]
    middle = piece.start + piece.length * rng.uniform(0.3, 0.7)
    return [
        *pieces[:index],
        Piece(piece.start, middle),
        Piece(middle, middle),
        Piece(middle, piece.end),
        *pieces[index + 1 :],
    ]
