"""A walk through the rooms of a floor: the order of rooms and panoramas, and the time in each."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import cycle
from typing import NamedTuple

import numpy as np


class Room(NamedTuple):
    """The label of a room and the numbers of its panoramas."""

    label: str
    panoramas: tuple[int, ...]


class Part(NamedTuple):
    """A number of frames, at least one, in one panorama; the others are numbers, stays from 0."""

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
    """Walk through the rooms of a floor.

    The first round enters every room, the next ones those that are visited again. No room follows itself.
    Rooms of a label in `ways` are only passed through: one of them lies between any two others. If there are
    too many ways for the walk to pass, it enters the rest like other rooms.

    Parameters
    ----------
    rooms
        At least one, each with a panorama or more.
    fps
        Frames a second.
    visits
        Fewest and most visits of a room.
    ways
        Labels of rooms that a person passes.
    stays, other_stays
        Mean and standard deviation, in seconds, of a stay, which has a gamma distribution: by label, and for
        all other labels.
    shortest_stay, longest_look
        In seconds. The panoramas of a room share a stay that is longer than `longest_look`, if there are
        several.
    rng
        Source of every choice.

    Returns
    -------
    list of Part
        At least one.
    """
    is_way = [room.label in ways for room in rooms]
    ways_first = sorted(range(len(rooms)), key=lambda number: not is_way[number])
    # A walk that enters every room once passes one way fewer: the ways beyond that are entered, too.
    surplus = max(0, -(-(2 * sum(is_way) - len(rooms) + 1) // 2))
    entered = sorted(ways_first[:surplus] + ways_first[sum(is_way) :])
    passed = ways_first[surplus : sum(is_way)]
    turns = [cycle(room.panoramas) for room in rooms]
    parts = []
    for stay, number in enumerate(_with_ways(_order(entered, visits, rng), passed, rng)):
        room, length = rooms[number], stays.get(rooms[number].label, other_stays)
        seconds = max(shortest_stay, _gamma(length["mean"], length["deviation"], rng))
        frames = max(1, round(seconds * fps))
        looks = min(max(1, round(seconds / longest_look)), len(room.panoramas), frames)
        for share in np.array_split(np.arange(frames), looks):
            parts.append(Part(stay, number, next(turns[number]), len(share)))
    return parts


def _order(entered: Sequence[int], visits: Sequence[int], rng: np.random.Generator) -> list[int]:
    """Rooms in the order of visits."""
    times = {number: int(rng.integers(visits[0], visits[1], endpoint=True)) for number in entered}
    order: list[int] = []
    for visit in range(1, visits[1] + 1):
        left = [number for number in entered if times[number] >= visit]
        now = [left[place] for place in rng.permutation(len(left))]
        if order and now and now[0] == order[-1]:
            now.append(now.pop(0))
        # The last of all rooms is not visited twice in a row.
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


def _gamma(mean: float, deviation: float, rng: np.random.Generator) -> float:
    return float(rng.gamma((mean / deviation) ** 2, deviation**2 / mean))
