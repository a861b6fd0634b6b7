"""The rooms that a walk stays in, in order."""

import heapq
import math
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from placecat.errors import PlacecatError
from placecat_homes.walking.ground import Ground
from placecat_homes.walking.walk_statistics import Statistics

_DRAWS = 300
_FRESH = 4.0
_NEAR = 4.0


@dataclass(frozen=True)
class Stop:
    """A stay in a room.

    Attributes
    ----------
    room
        Index of the room.
    weight
        Length of the stay as a multiple of the mean stay.
    """

    room: int
    weight: float


@dataclass(frozen=True)
class Way:
    """Route from one room to another.

    Attributes
    ----------
    length
        Distance in metres from the door out of the first room to the door into the second; 0 for adjacent
        rooms.
    out, into
        Coordinates x, y of these doors.
    """

    length: float
    out: tuple[float, float]
    into: tuple[float, float]


def ways(ground: Ground) -> dict[tuple[int, int], Way]:
    """Find the shortest route from each room to every other room."""
    doors = [door for door in ground.doors if min(door[:2]) >= 0]
    result: dict[tuple[int, int], Way] = {}
    for room in range(len(ground.names)):
        reached = {index: 0.0 for index, door in enumerate(doors) if room in door[:2]}
        out = {index: doors[index][2:] for index in reached}
        queue = [(0.0, index) for index in reached]
        while queue:
            far, index = heapq.heappop(queue)
            if far > reached[index]:
                continue
            a, b, x, y = doors[index]
            for other, (c, d, u, v) in enumerate(doors):
                if ({a, b} & {c, d}) - {room}:
                    length = far + math.hypot(x - u, y - v)
                    if length < reached.get(other, math.inf):
                        reached[other], out[other] = length, out[index]
                        heapq.heappush(queue, (length, other))
        for index, far in reached.items():
            for other in doors[index][:2]:
                if other != room and ((room, other) not in result or far < result[room, other].length):
                    result[room, other] = Way(far, out[index], doors[index][2:])
    return result


def draw(
    ground: Ground,
    rng: np.random.Generator,
    statistics: Statistics,
    *,
    rooms: Sequence[str] | None = None,
    shorter: float = 1.0,
) -> list[Stop]:
    """Draw the stays that make up a walk.

    Parameters
    ----------
    ground
        The building.
    rng
        Random number generator.
    statistics
        Statistics on how often one room follows another.
    rooms
        Names of the rooms to stay in, each at least once; by default, the walk may stay in any room.
    shorter
        Factor by which to multiply the number of stays.

    Raises
    ------
    PlacecatError
        If no room is of a known kind, or no order of stays visits all required rooms.
    """
    allowed = [
        room
        for room, (name, kind) in enumerate(zip(ground.names, ground.kinds, strict=True))
        if kind in statistics.kinds and (rooms is None or name in rooms)
    ]
    if not allowed:
        raise PlacecatError("the building has no room for the walk to stay in")
    must = set(allowed) if rooms is not None else set()
    must_kinds = {ground.kinds[room] for room in allowed} & set(statistics.classes)
    way = ways(ground)
    count = max(len(must), len(must_kinds), round(statistics.count.draw(rng, 1.2) * shorter))
    for attempt in range(_DRAWS):
        # Later attempts make the walk longer and more reluctant to return to a room.
        boost, longer = 1.0 + attempt / 10, count + attempt // 30
        order = _chain(ground, rng, statistics, allowed, way, longer, boost)
        if must_kinds <= {ground.kinds[room] for room in order} and must <= set(order):
            return [Stop(room, statistics.stays[ground.kinds[room]].draw(rng, 2.0)) for room in order]
    raise PlacecatError("no order of stays visits every place: connect the rooms by doors")


def _chain(
    ground: Ground,
    rng: np.random.Generator,
    statistics: Statistics,
    allowed: list[int],
    way: dict[tuple[int, int], Way],
    count: int,
    boost: float,
) -> list[int]:
    visits: Counter[int] = Counter()
    order: list[int] = []
    while len(order) < count:
        here = order[-1] if order else None
        odds = statistics.starts if here is None else statistics.follows.get(ground.kinds[here], {})
        rooms, weights = [], []
        for room in allowed:
            again = room == here
            if again and (statistics.between == "rooms" or len(_of_kind(ground, allowed, room)) > 1):
                continue
            if here is not None and not again and (here, room) not in way:
                continue
            kind = ground.kinds[room]
            fresh = _FRESH if not visits[room] else 1.0 / visits[room]
            near = 1.0 if here is None or again else math.exp(-way[here, room].length / _NEAR)
            rooms.append((kind, room, fresh * near))
            weights.append(odds.get(kind, 0.0))
        # The odds apply to kinds of room. Within a kind, nearby and unvisited rooms are preferred.
        sums: defaultdict[str, float] = defaultdict(float)
        for kind, _, liking in rooms:
            sums[kind] += liking
        shares = np.array(
            [
                (odd + 0.01) * liking / sums[kind] * (boost if not visits[room] else 1.0)
                for (kind, room, liking), odd in zip(rooms, weights, strict=True)
            ]
        )
        if not len(shares):
            break
        chosen = rooms[int(rng.choice(len(rooms), p=shares / shares.sum()))][1]
        visits[chosen] += 1
        order.append(chosen)
    return order


def _of_kind(ground: Ground, allowed: list[int], room: int) -> list[int]:
    return [other for other in allowed if ground.kinds[other] == ground.kinds[room]]
