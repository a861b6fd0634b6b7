"""Plan a walk through the rooms of a floor: the order of rooms and panoramas, and the time spent in each."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import cycle
from typing import NamedTuple

import numpy as np


class Room(NamedTuple):
    """A room's label and the indices of its panoramas."""

    label: str
    panoramas: tuple[int, ...]


class Part(NamedTuple):
    """Consecutive frames of a stay that show one panorama.

    `stay`, `room` and `panorama` are zero-based indices, and `frames` is the number of frames.
    """

    stay: int
    room: int
    panorama: int
    frames: int


def walk(
    rooms: Sequence[Room],
    *,
    fps: float,
    visits: Sequence[int],
    ways: Sequence[str],
    stays: Mapping[str, Mapping[str, float]],
    other_stays: Mapping[str, float],
    shortest_stay: float,
    longest_look: float,
    rng: np.random.Generator,
) -> list[Part]:
    """Plan a walk through the rooms of a floor.

    The first round enters every room, and later rounds enter the rooms that have visits left. No room is
    entered twice in a row. Rooms with a label in `ways` are only passed through: the walk passes through one
    of them between any two other rooms. If there are more such rooms than it can pass through, it enters the
    rest like any other room.

    Parameters
    ----------
    rooms
        The rooms of the floor: at least one, each with at least one panorama.
    fps
        Frames per second.
    visits
        Smallest and largest number of visits to a room.
    ways
        Labels of rooms that people only pass through.
    stays, other_stays
        Mean and standard deviation of the duration of a stay, in seconds. `stays` sets them for some labels,
        and `other_stays` for all other labels. Durations are gamma-distributed.
    shortest_stay, longest_look
        Limits in seconds. A stay longer than `longest_look` is split among the room's panoramas.
    rng
        Source of all random choices.
    """
    is_way = [room.label in ways for room in rooms]
    ways_first = sorted(range(len(rooms)), key=lambda number: not is_way[number])
    # A walk that enters n rooms once passes through n - 1 ways, and enters the surplus ways like any other
    # room.
    surplus = max(0, -(-(2 * sum(is_way) - len(rooms) + 1) // 2))
    entered = sorted(ways_first[:surplus] + ways_first[sum(is_way) :])
    passed = ways_first[surplus : sum(is_way)]
    turns = [cycle(room.panoramas) for room in rooms]
    parts = []
    for stay, number in enumerate(_with_ways(_order(entered, visits, rng), passed, rng)):
        room, length = rooms[number], stays.get(rooms[number].label, other_stays)
        mean, deviation = length["mean"], length["deviation"]
        seconds = max(shortest_stay, float(rng.gamma((mean / deviation) ** 2, deviation**2 / mean)))
        frames = max(1, round(seconds * fps))
        looks = min(max(1, round(seconds / longest_look)), len(room.panoramas), frames)
        for share in np.array_split(np.arange(frames), looks):
            parts.append(Part(stay, number, next(turns[number]), len(share)))
    return parts


def _order(entered: Sequence[int], visits: Sequence[int], rng: np.random.Generator) -> list[int]:
    """Return the room numbers in the order in which the rooms are visited."""
    times = {number: int(rng.integers(visits[0], visits[1], endpoint=True)) for number in entered}
    order: list[int] = []
    for visit in range(1, visits[1] + 1):
        left = [number for number in entered if times[number] >= visit]
        now = [left[place] for place in rng.permutation(len(left))]
        if order and now and now[0] == order[-1]:
            now.append(now.pop(0))
        # Only the current room is left.
        if order and now and now[0] == order[-1]:
            break
        order += now
    return order


def _with_ways(order: Sequence[int], passed: Sequence[int], rng: np.random.Generator) -> Iterator[int]:
    ways = cycle(rng.permutation(passed).tolist()) if passed else None
    for place, number in enumerate(order):
        if place and ways is not None:
            yield int(next(ways))
        yield number
