"""The path of a walk, divided into stays, transitions, and rooms that are passed through on the way."""

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from placecat_homes.walking import viewpoints
from placecat_homes.walking.carriage import Carriage
from placecat_homes.walking.ground import Ground
from placecat_homes.walking.itinerary import Stop, ways
from placecat_homes.walking.route import Router, lengths
from placecat_homes.walking.viewpoints import Viewpoint
from placecat_homes.walking.walk_statistics import Statistics

TRANSITION = "transition"

# Kind of room that may consist of several parts with no doorways between them.
_HALL = "corridor"

_WALKED = 0.5
_CLOSE = 0.15
_SECONDS_EACH = {False: 5.0, True: 9.0}
_MOST = 4


@dataclass(frozen=True)
class Piece:
    """A part of the path, or a pause.

    Attributes
    ----------
    start, end
        Distances in metres from the start of the path; equal for a pause.
    viewpoint
        Place to look around from during a pause; None for a part of the path or a pause on the way.
    """

    start: float
    end: float
    viewpoint: Viewpoint | None = None

    @property
    def length(self) -> float:
        """Length in metres."""
        return self.end - self.start


@dataclass
class Section:
    """A run of frames with the same label.

    Attributes
    ----------
    label
        Kind of the room, or `transition`.
    room
        Index of the room; -1 for a transition.
    weight
        Length relative to other sections of the same type; 0 for a room that is merely passed through.
    pieces
        The parts and pauses of the section.
    """

    label: str
    room: int
    weight: float
    pieces: list[Piece] = field(default_factory=list)

    @property
    def length(self) -> float:
        """Length in metres."""
        return sum(piece.length for piece in self.pieces)

    @property
    def stay(self) -> bool:
        """Whether the walk stays in the room."""
        return self.room >= 0 and self.weight > 0


@dataclass(frozen=True, eq=False)
class Journey:
    """A path and its sections.

    Attributes
    ----------
    path
        (n, 2), metres.
    along
        (n,), length of the path up to each point.
    sections
        The sections in order.
    """

    path: NDArray[np.float64]
    along: NDArray[np.float64]
    sections: list[Section]


def lay_out(
    router: Router,
    rng: np.random.Generator,
    statistics: Statistics,
    carriage: Carriage,
    stops: list[Stop],
    seconds: float,
    transition_share: float,
) -> Journey:
    """Choose places to look around from, and connect them.

    Parameters
    ----------
    router
        Finds paths.
    rng
        Random number generator.
    statistics
        Statistics of where transitions begin and end.
    carriage
        How fast the camera moves.
    stops
        The stays.
    seconds
        Length of the walk.
    transition_share
        Share of the time spent in transitions.
    """
    ground = router.ground
    way = ways(ground)
    total = sum(stop.weight for stop in stops)
    places: list[list[Viewpoint]] = []
    for index, stop in enumerate(stops):
        time = (1.0 - transition_share) * seconds * stop.weight / total
        before = stops[index - 1].room if index else stop.room
        after = stops[index + 1].room if index + 1 < len(stops) else stop.room
        gates = [
            np.array(gate)
            for gate in (
                way[before, stop.room].into if before != stop.room else None,
                way[stop.room, after].out if after != stop.room else None,
            )
            if gate is not None
        ]
        places.append(_look_outs(ground, rng, carriage, stop.room, gates, time))
    mean = transition_share * seconds / max(1, len(stops) - 1)
    return _Tour(router, rng, statistics, carriage, mean).through(stops, places)


def _look_outs(
    ground: Ground,
    rng: np.random.Generator,
    carriage: Carriage,
    room: int,
    gates: list[NDArray[np.float64]],
    time: float,
) -> list[Viewpoint]:
    each = _SECONDS_EACH[carriage.steers]
    count = int(np.clip(round(time / each + rng.uniform(-0.5, 0.5)), 1, _MOST))
    left = _WALKED * time * carriage.top_speed
    result: list[Viewpoint] = []
    near = gates
    for index in range(count):
        share = left / (count - index) if result else left * (0.5 if count > 1 else 1.0)
        close = bool(result) and not carriage.steers and rng.random() < _CLOSE
        found = viewpoints.choose(
            ground, rng, room, near=near, reach=max(share, 0.5), close=close, amid=carriage.steers
        )
        walked = min((math.dist(found.place, gate) for gate in near), default=0.0)
        left = max(0.0, left - walked)
        result.append(found)
        near = [np.array(found.place)] + (gates[-1:] if index == count - 2 else [])
    return result


class _Tour:
    def __init__(
        self,
        router: Router,
        rng: np.random.Generator,
        statistics: Statistics,
        carriage: Carriage,
        mean_transition: float,
    ) -> None:
        self.router, self.ground, self.rng = router, router.ground, rng
        self.statistics, self.carriage, self.mean = statistics, carriage, mean_transition
        self.parts: list[NDArray[np.float64]] = []
        self.sections: list[Section] = []
        self.walked = 0.0

    def through(self, stops: list[Stop], places: list[list[Viewpoint]]) -> Journey:
        for index, (stop, views) in enumerate(zip(stops, places, strict=True)):
            if index:
                self._leave(stops[index - 1], places[index - 1][-1], stop, views[0])
            else:
                self.parts.append(np.array([views[0].place]))
                self._open(stop)
            for number, view in enumerate(views):
                if number:
                    path = self.router.path(np.array(views[number - 1].place), np.array(view.place))
                    self._walk(self._add(path))
                self.sections[-1].pieces.append(Piece(self.walked, self.walked, view))
        path = np.concatenate(self.parts)
        return Journey(path, lengths(path), self.sections)

    def _open(self, stop: Stop) -> None:
        self.sections.append(Section(self.ground.kinds[stop.room], stop.room, stop.weight))

    def _add(self, path: NDArray[np.float64]) -> float:
        self.parts.append(path[1:])
        gap = float(np.hypot(*(path[0] - self.parts[-2][-1]))) if len(self.parts[-2]) else 0.0
        return gap + float(lengths(path)[-1])

    def _walk(self, length: float) -> None:
        if length > 0:
            self.sections[-1].pieces.append(Piece(self.walked, self.walked + length))
            self.walked += length

    def _leave(self, here: Stop, last: Viewpoint, there: Stop, first: Viewpoint) -> None:
        start, end = np.array(last.place), np.array(first.place)
        weight = self.statistics.transitions.draw(self.rng, 2.0)
        turning = None
        if here.room == there.room:
            via = self._outside(here.room)
            path = self.router.path(start, via, end)
            turning = float(lengths(path)[np.argmin(np.hypot(*(path - via).T))])
        else:
            path = self.router.path(start, end)
        along = lengths(path)
        cuts = self._cuts(path, along, here.room, there.room, weight)
        self._add(path)
        done = 0.0
        for number, (upto, room) in enumerate(cuts):
            if number == len(cuts) - 1:
                self._open(there)
            elif number and upto > done:
                label = TRANSITION if room < 0 else self.ground.kinds[room]
                self.sections.append(Section(label, room, weight if room < 0 else 0.0))
            if turning is not None and room < 0 and done < turning < upto:
                self._walk(turning - done)
                self.sections[-1].pieces.append(Piece(self.walked, self.walked))
                done = turning
            self._walk(upto - done)
            done = upto

    def _outside(self, room: int) -> NDArray[np.float64]:
        doors = [door for door in self.ground.doors if room in door[:2] and min(door[:2]) >= 0]
        a, b, x, y = doors[int(self.rng.integers(len(doors)))]
        other = b if a == room else a
        cells = np.argwhere(self.ground.free & (self.ground.room == other))
        places = self.ground.points(cells)
        distance = np.hypot(*(places - (x, y)).T)
        return places[np.argmin(np.abs(distance - self.rng.uniform(0.5, 0.9)))]

    def _cuts(
        self,
        path: NDArray[np.float64],
        along: NDArray[np.float64],
        here: int,
        there: int,
        weight: float,
    ) -> list[tuple[float, int]]:
        # Return the end and room of each part of the path, where the room is -1 for a transition. The first
        # part is in `here`, and the last is in `there`.
        rooms = self.ground.room_at(path)
        before, after = (value * self.rng.uniform(0.7, 1.3) for value in self.statistics.doorway)
        total = float(along[-1])
        if self.statistics.between == TRANSITION:
            if here == there:
                outside = np.flatnonzero(rooms != here)
                out = float(along[outside[0]]) if len(outside) else total / 2
                into = float(along[outside[-1]]) if len(outside) else total / 2
            else:
                last = int(np.flatnonzero(rooms == here)[-1])
                out = float(along[last])
                into = float(along[last + int(np.argmax(rooms[last:] == there))])
            slack = 0.5 * self.mean * weight - (into - out) - before - after
            more = 0.5 * float(np.clip(slack, 0.0, 1.5))
            start, end = max(0.0, out - before - more), min(total, into + after + more)
            return [(start, here), (end, -1), (total, there)]
        inside = np.flatnonzero(rooms >= 0)
        changes = np.flatnonzero(np.diff(rooms[inside]))
        cuts: list[tuple[float, int]] = []
        for change in changes:
            a, b = inside[change], inside[change + 1]
            door = 0.5 * float(along[a] + along[b])
            done = cuts[-1][0] if cuts else 0.0
            halls = self.ground.kinds[rooms[a]] == self.ground.kinds[rooms[b]] == _HALL
            if before + after <= 0 or halls:
                if door > done or not cuts:
                    cuts.append((door, int(rooms[a])))
            elif cuts and cuts[-1][1] < 0 and door - before <= done:
                cuts[-1] = (min(door + after, total), -1)
            else:
                cuts += [(max(done, door - before), int(rooms[a])), (min(door + after, total), -1)]
        return [*cuts, (total, there)]
