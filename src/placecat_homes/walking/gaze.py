"""Where a person with a camera looks during a walk."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from placecat_homes.walking.carriage import Carriage
from placecat_homes.walking.ground import Ground
from placecat_homes.walking.signals import Floats
from placecat_homes.walking.timetable import Span
from placecat_homes.walking.viewpoints import Viewpoint

_GAIN = 3.0
_PITCH_RATE = math.radians(30.0)
_PITCH_LAG = 0.4
_LOW, _HIGH = math.radians(-32.0), math.radians(5.0)
_SWEEP = (math.radians(40.0), math.radians(120.0))
_SWEEP_RATE = (math.radians(16.0), math.radians(38.0))
_SHORTEST = 0.4


@dataclass(frozen=True)
class Act:
    """What the camera does for a period of time. With neither `turn` nor `point`, it looks ahead.

    Attributes
    ----------
    seconds
        Duration in seconds.
    turn
        Angle to turn by at a constant rate, in radians.
    point
        Coordinates x, y, z of the point to look at.
    aside
        Angle between the viewing direction and the way ahead, in radians.
    tilt
        Angle added to the usual pitch, in radians.
    """

    seconds: float
    turn: float | None = None
    point: tuple[float, float, float] | None = None
    aside: float = 0.0
    tilt: float = 0.0


class Gaze:
    """Decides what to look at and turns the camera towards it, no faster than a person would.

    Parameters
    ----------
    ground
        The building.
    rng
        Random number generator.
    carriage
        How fast the camera turns.
    height, pitch
        Height of the camera in metres, and its usual tilt in radians.
    """

    def __init__(
        self, ground: Ground, rng: np.random.Generator, carriage: Carriage, height: float, pitch: float
    ) -> None:
        self.ground, self.rng, self.height, self.usual = ground, rng, height, pitch
        self._most = math.radians(carriage.turn_rate)
        self._acceleration = math.radians(carriage.turn_acceleration)
        self._yaw, self._rate, self._pitch = 0.0, 0.0, pitch

    def follow(
        self, spans: Sequence[Span], places: Floats, ahead: Floats, tick: float
    ) -> tuple[Floats, Floats]:
        """Look around while following the path.

        Parameters
        ----------
        spans
            The timetable.
        places
            (n, 2), the camera's position at each tick.
        ahead
            (n,), direction of the path in radians.
        tick
            Duration of a tick in seconds.

        Returns
        -------
        tuple of arrays
            Yaw and pitch in radians, each (n,).
        """
        count = len(places)
        yaws, pitches = np.empty(count), np.empty(count)
        first = spans[0].piece.viewpoint
        self._yaw = first.outlook + self.rng.uniform(-1.0, 1.0) if first else float(ahead[0])
        index, seen = 0, -1
        for number, span in enumerate(spans):
            last = count if number == len(spans) - 1 else min(count, round(span.end / tick))
            fresh = span.section is not spans[seen].section if seen >= 0 else True
            if span.piece.viewpoint:
                seen = number
            for act in self._acts(span, fresh):
                upto = min(last, index + max(1, round(act.seconds / tick)))
                start = self._yaw
                for step in range(index, upto):
                    aim = start + (act.turn or 0.0) * (step - index + 1) / (upto - index)
                    self._move(act, places[step], aim, float(ahead[step]), tick)
                    yaws[step], pitches[step] = self._yaw, self._pitch
                index = max(index, upto)
                if index >= last:
                    break
        return yaws, pitches

    def _move(self, act: Act, place: Floats, aim: float, ahead: float, tick: float) -> None:
        tilt, forward = self.usual + act.tilt, 0.0
        if act.turn is not None:
            error, forward = aim - self._yaw, act.turn / act.seconds
        elif act.point is not None:
            x, y, z = act.point[0] - place[0], act.point[1] - place[1], act.point[2] - self.height
            error = _wrapped(math.atan2(y, x) - self._yaw)
            tilt = 0.5 * tilt + 0.5 * math.atan2(z, max(0.4, math.hypot(x, y)))
        else:
            error = _wrapped(ahead + act.aside - self._yaw)
        wanted = float(np.clip(forward + _GAIN * error, -self._most, self._most))
        change = self._acceleration * tick
        self._rate += float(np.clip(wanted - self._rate, -change, change))
        self._yaw += self._rate * tick
        lean = (min(max(tilt, _LOW), _HIGH) - self._pitch) / _PITCH_LAG
        self._pitch += float(np.clip(lean, -_PITCH_RATE, _PITCH_RATE)) * tick

    def _acts(self, span: Span, fresh: bool) -> Iterator[Act]:
        left = span.seconds
        view = span.piece.viewpoint
        if view is not None and view.focus is not None and left > _SHORTEST:
            act = Act(self._between(1.0, 2.5), point=view.focus)
            left -= act.seconds
            yield act
        while left > 0:
            if left < _SHORTEST:
                act = Act(left + 1.0, turn=0.0) if view else Act(left + 1.0)
            elif view is not None:
                act = self._sweep(view, left) if fresh else self._look(view, left)
                fresh = False
            elif span.piece.length == 0:
                act = Act(self._between(0.8, 2.0), aside=self._between(-1.4, 1.4), tilt=self._tilt())
            else:
                act = self._walk(span, left)
            left -= act.seconds
            yield act
        yield Act(span.seconds + 1.0, turn=0.0) if view else Act(span.seconds + 1.0)

    def _walk(self, span: Span, left: float) -> Act:
        if span.section.stay:
            items = self._items(span.section.room)
            if items and self.rng.random() < 0.7:
                return Act(self._between(1.0, 2.0), point=self._choice(items))
        elif left > 3.0 and self.rng.random() < 0.3:
            return Act(self._between(0.7, 1.3), aside=self._between(-0.8, 0.8), tilt=self._tilt())
        return Act(self._between(1.0, 2.5), tilt=self._tilt())

    def _look(self, view: Viewpoint, left: float) -> Act:
        items, windows = self._items(view.room), self._windows(view.room)
        full = left > 9.0
        odds = np.array([3.0, 8.0 * bool(items), 0.4 * bool(windows), 0.5, 0.3 * full, 1.5])
        kind = int(self.rng.choice(len(odds), p=odds / odds.sum()))
        if kind == 1:
            return Act(self._between(1.0, 2.2), point=self._choice(items))
        if kind == 2:
            return Act(self._between(1.5, 4.0), point=windows[int(self.rng.integers(len(windows)))])
        if kind == 3:
            return Act(self._between(1.5, 3.5), point=self._wall(view))
        if kind == 4:
            side = 1.0 if self.rng.random() < 0.5 else -1.0
            return Act(2 * math.pi / math.radians(44.0), turn=2 * math.pi * side, tilt=self._tilt())
        if kind == 5:
            return Act(self._between(0.5, 1.5), turn=0.0, tilt=self._tilt())
        return self._sweep(view, left)

    def _sweep(self, view: Viewpoint, left: float) -> Act:
        # Turn to the far end of an arc around the outlook, so that the camera sweeps across it.
        half = 0.5 * self._between(*_SWEEP)
        beside = _wrapped(view.outlook - self._yaw)
        turn = beside + half if beside >= 0 else beside - half
        turn = float(np.clip(turn, -_SWEEP[1], _SWEEP[1]))
        seconds = max(_SHORTEST, min(abs(turn) / self._between(*_SWEEP_RATE), left))
        turn = float(np.clip(turn, -_SWEEP_RATE[1] * seconds, _SWEEP_RATE[1] * seconds))
        return Act(seconds, turn=turn, tilt=self._tilt())

    def _wall(self, view: Viewpoint) -> tuple[float, float, float]:
        # Try a few points on the walls, and take the one farthest from furniture, windows and doors.
        x0, y0, x1, y1 = self.ground.rects[view.room]
        things = [item[:2] for item in self._items(view.room) + self._windows(view.room)]
        things += [(x, y) for a, b, x, y in self.ground.doors if view.room in (a, b)]
        found, best = (view.place[0], y0), -1.0
        for _ in range(8):
            u = self.rng.random()
            x, y = x0 + u * (x1 - x0), y0 + u * (y1 - y0)
            point = [(x, y0), (x, y1), (x0, y), (x1, y)][int(self.rng.integers(4))]
            bare = min((math.dist(point, thing) for thing in things), default=9.0)
            if bare > best:
                found, best = point, bare
        return (*found, self.height)

    def _items(self, room: int) -> list[tuple[float, float, float]]:
        return [(x, y, 0.8 * height) for index, x, y, height in self.ground.items if index == room]

    def _choice(self, items: list[tuple[float, float, float]]) -> tuple[float, float, float]:
        # Objects that are typical of a room are placed first, so prefer those.
        odds = (1.0 + np.arange(len(items))) ** -1.5
        return items[int(self.rng.choice(len(items), p=odds / odds.sum()))]

    def _windows(self, room: int) -> list[tuple[float, float, float]]:
        return [(x, y, 1.4) for index, x, y in self.ground.windows if index == room]

    def _tilt(self) -> float:
        # Occasionally look down at objects.
        return math.radians(-16.0 if self.rng.random() < 0.1 else self.rng.normal(0.0, 3.0))

    def _between(self, low: float, high: float) -> float:
        return float(self.rng.uniform(low, high))


def _wrapped(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi
