"""How a robot drives. It faces the direction of travel, and turns on the spot where it stops."""

import itertools
import math
from collections.abc import Sequence

import numpy as np

from placecat_homes.walking.carriage import Carriage
from placecat_homes.walking.journey import Journey, Piece
from placecat_homes.walking.signals import Floats, smoothed
from placecat_homes.walking.timetable import Span

_LOOK = 0.15
_BRISK = 0.85


class Steering:
    """Headings along a journey, and turns during its pauses.

    Parameters
    ----------
    journey
        The path.
    carriage
        How the robot moves.
    """

    def __init__(self, journey: Journey, carriage: Carriage) -> None:
        self.carriage = carriage
        self.along = journey.along
        self.rate = math.radians(carriage.turn_rate) * _BRISK
        stops = sorted(
            {p.start for section in journey.sections for p in section.pieces if p.length == 0}
            | {0.0, float(self.along[-1])}
        )
        self.runs: list[tuple[float, float, Floats, Floats]] = []
        for low, high in itertools.pairwise(stops):
            if high - low < 0.02:
                continue
            where = np.linspace(low, high, max(3, round((high - low) / 0.05)))
            ends = np.clip(where[:, None] + np.array([-_LOOK, _LOOK]), low, high)
            u, v = (np.interp(ends, self.along, journey.path[:, axis]) for axis in (0, 1))
            heading = np.unwrap(np.arctan2(v[:, 1] - v[:, 0], u[:, 1] - u[:, 0]))
            self.runs.append((low, high, where, smoothed(heading, 5)))

    def heading(self, along: float, *, before: bool) -> float | None:
        """Return the heading just before or after a place on the path, or None beyond the path's ends."""
        for low, high, where, headings in self.runs:
            if (low < along <= high + 1e-9) if before else (low - 1e-9 <= along < high):
                return float(np.interp(along, where, headings))
        return None

    def least_seconds(self, pieces: Sequence[Piece]) -> float:
        """Compute how long a section takes at full speed, including any turns that the path requires."""
        total = 0.3
        for piece in pieces:
            if piece.length:
                total += float(self._drive(piece, self.carriage.top_speed)[0][-1])
            else:
                total += abs(self._needed(piece)) / self.rate
        return total

    def timed(self, spans: Sequence[Span], rng: np.random.Generator) -> tuple[Floats, Floats, Floats]:
        """Return times, path lengths and yaws along a timetable. Its section times are left unchanged."""
        times, way, yaws = [0.0], [spans[0].piece.start], [0.0]
        begin = 0
        first = True
        while begin < len(spans):
            end = begin
            while end < len(spans) and spans[end].section is spans[begin].section:
                end += 1
            pieces = [span.piece for span in spans[begin:end]]
            start, seconds = spans[begin].begin, spans[end - 1].end - spans[begin].begin
            if first:
                initial = self.heading(pieces[0].start, before=False)
                yaws[0] = initial or 0.0
                first = False
            t, s, a = self._section(pieces, seconds, yaws[-1], rng)
            times += list(start + t)
            way += list(s)
            yaws += list(a)
            begin = end
        return np.array(times), np.array(way), np.array(yaws)

    def _section(
        self, pieces: Sequence[Piece], seconds: float, yaw: float, rng: np.random.Generator
    ) -> tuple[Floats, Floats, Floats]:
        drives = [self._drive(piece, self.carriage.speed) if piece.length else None for piece in pieces]
        needed = [0.0 if piece.length else self._needed(piece) for piece in pieces]
        stops = [k for k, piece in enumerate(pieces) if piece.viewpoint is not None]
        spare = seconds - sum(float(d[0][-1]) for d in drives if d) - sum(map(abs, needed)) / self.rate
        turns = {k: self._turns(needed[k], 0.8 * spare / len(stops) * self.rate, rng) for k in stops}
        t, s, a = [0.0], [pieces[0].start], [yaw]
        for k, (piece, drive) in enumerate(zip(pieces, drives, strict=True)):
            if drive:
                clock, where, headings = drive
                shift = 2 * math.pi * round((a[-1] - headings[0]) / (2 * math.pi))
                t += list(t[-1] + clock)
                s += list(where)
                a += list(headings + shift)
            for turn in turns.get(k, [needed[k]] if not piece.length else []):
                t.append(t[-1] + abs(turn) / self.rate + 0.15)
                s.append(piece.start)
                a.append(a[-1] + turn)
        clock = np.array(t)
        return clock * (seconds / max(clock[-1], 1e-9)), np.array(s), np.array(a)

    def _turns(self, needed: float, spare: float, rng: np.random.Generator) -> list[float]:
        # Turn a full circle if there is time; otherwise, turn to one side and then to the other.
        side = 1.0 if rng.random() < 0.5 else -1.0
        if spare >= 2 * math.pi:
            around = math.copysign(2 * math.pi, -needed if abs(needed) > 1.5 else side)
            turns = [needed + around]
            extra = min(0.25 * (spare - 2 * math.pi), 1.5)
            return [side * extra, -2 * side * extra, side * extra, *turns] if extra > 0.3 else turns
        sweep = min(spare / 4, 1.6)
        return [side * sweep, -2 * side * sweep, side * sweep + needed] if sweep > 0.2 else [needed]

    def _needed(self, piece: Piece) -> float:
        before, after = self.heading(piece.start, before=True), self.heading(piece.start, before=False)
        if before is None or after is None:
            return 0.0
        return (after - before + math.pi) % (2 * math.pi) - math.pi

    def _drive(self, piece: Piece, speed: float) -> tuple[Floats, Floats, Floats]:
        for low, high, where, headings in self.runs:
            if low - 1e-6 <= piece.start and piece.end <= high + 1e-6:
                inside = where[(where > piece.start) & (where < piece.end)]
                points = np.concatenate([[piece.start], inside, [piece.end]])
                angles = np.interp(points, where, headings)
                steps = np.maximum(np.diff(points) / speed, np.abs(np.diff(angles)) / self.rate)
                return np.concatenate([[0.0], np.cumsum(steps)]), points, angles
        points = np.array([piece.start, piece.end])
        return np.array([0.0, piece.length / speed]), points, np.zeros(2)
