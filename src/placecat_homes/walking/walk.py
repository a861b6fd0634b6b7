"""A camera's walk through a building."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat_homes.walking import itinerary, journey, timetable
from placecat_homes.walking.carriage import Carriage
from placecat_homes.walking.gaze import Gaze
from placecat_homes.walking.ground import Ground
from placecat_homes.walking.journey import Journey
from placecat_homes.walking.route import Router
from placecat_homes.walking.signals import Floats, limited, smoothed, wander
from placecat_homes.walking.steering import Steering
from placecat_homes.walking.timetable import Span
from placecat_homes.walking.walk_statistics import Statistics

_TICK = 0.05
_TRIES = 80
_PATIENCE = 0.005
_AHEAD = 0.5
_STEPS_A_SECOND = 1.8


@dataclass(frozen=True, eq=False)
class Walk:
    """The camera's pose and the label in each frame.

    Attributes
    ----------
    position
        (n, 3), metres.
    yaw
        (n,), in radians; 0 along +x, and counter-clockwise.
    pitch
        (n,), in radians, positive upwards.
    roll
        (n,), radians.
    label
        n labels, each the kind of a room or `transition`.
    """

    position: NDArray[np.float64]
    yaw: NDArray[np.float64]
    pitch: NDArray[np.float64]
    roll: NDArray[np.float64]
    label: list[str]


def walk(
    ground: Ground,
    rng: np.random.Generator,
    statistics: Statistics,
    carriage: Carriage,
    frames: int,
    fps: float,
    *,
    rooms: Sequence[str] | None = None,
) -> Walk:
    """Walk through a building.

    Parameters
    ----------
    ground
        The building.
    rng
        Random number generator. A different one gives a different walk through the same rooms.
    statistics
        Statistics of the order of rooms and the length of stays.
    carriage
        What carries the camera.
    frames
        Number of frames.
    fps
        Frames per second.
    rooms
        Names of the rooms to stay in, each at least once; by default, the walk may stay in any room.

    Raises
    ------
    PlacecatError
        If there are too few frames for a walk that visits all required rooms.
    """
    router = Router(ground)
    for attempt in range(_TRIES):
        stops = itinerary.draw(ground, rng, statistics, rooms=rooms, shorter=0.97**attempt)
        share = statistics.draw_transition_share(rng)
        tour = journey.lay_out(router, rng, statistics, carriage, stops, frames / fps, share)
        steering = Steering(tour, carriage) if carriage.steers else None
        most = min(share + attempt * _PATIENCE, statistics.transition_share[3])
        counts = _frames(tour, statistics, carriage, steering, frames, fps, share, most)
        if counts is not None:
            return _film(ground, rng, carriage, tour, steering, counts, fps)
    raise PlacecatError(f"no walk of {frames} frames visits every place: use more frames")


def _frames(
    tour: Journey,
    statistics: Statistics,
    carriage: Carriage,
    steering: Steering | None,
    frames: int,
    fps: float,
    share: float,
    most: float,
) -> list[int] | None:
    least = [
        fps
        * (
            steering.least_seconds(section.pieces)
            if steering
            else timetable.least_seconds(section, carriage.top_speed)
        )
        for section in tour.sections
    ]
    usual = [fps * section.length / carriage.speed for section in tour.sections]
    floor = math.ceil(statistics.least_share * frames) + 1
    staying = {section.label for section in tour.sections if section.stay}
    floors = {kind: float(floor) for kind in statistics.classes if kind in staying}
    return timetable.allot(tour.sections, least, usual, frames, share, most, floors)


def _film(
    ground: Ground,
    rng: np.random.Generator,
    carriage: Carriage,
    tour: Journey,
    steering: Steering | None,
    counts: list[int],
    fps: float,
) -> Walk:
    spans = timetable.spans(tour.sections, counts, rng, fps, carriage.speed, carriage.top_speed)
    frames = sum(counts)
    ticks = np.arange(math.ceil(frames / fps / _TICK)) * _TICK
    height = carriage.height + carriage.height_spread * float(np.clip(rng.normal(), -2, 2))
    pitch = math.radians(carriage.pitch + carriage.pitch_spread * float(np.clip(rng.normal(), -2, 2)))
    if steering:
        times, nodes, headings = steering.timed(spans, rng)
        way = smoothed(np.interp(ticks, times, nodes), 5)
        yaws, pitches = smoothed(np.interp(ticks, times, headings), 9), np.full(len(ticks), pitch)
        places = _along(tour, way)
    else:
        way = smoothed(np.interp(ticks, *_nodes(spans)), 11)
        places = _along(tour, way)
        gaze = Gaze(ground, rng, carriage, height, pitch)
        yaws, pitches = gaze.follow(spans, places, _ahead(tour, way, places), _TICK)
    shots = (np.arange(frames) + 0.5) / fps
    shaken = _shaken(rng, carriage, way)
    yaw = np.interp(shots, ticks, yaws + shaken[0])
    most = math.radians(carriage.turn_rate * 1.15) / fps
    flat = np.column_stack([np.interp(shots, ticks, places[:, axis]) for axis in (0, 1)])
    sway, rise = np.interp(shots, ticks, shaken[3]), np.interp(shots, ticks, shaken[4])
    swayed = flat + sway[:, None] * np.column_stack([-np.sin(yaw), np.cos(yaw)])
    flat = np.where(ground.is_free(swayed)[:, None], swayed, ground.nearest_free(flat))
    return Walk(
        position=np.column_stack([flat, height + rise]),
        yaw=limited(yaw, most),
        pitch=np.interp(shots, ticks, pitches + shaken[1]),
        roll=np.interp(shots, ticks, shaken[2]),
        label=[s.label for s, count in zip(tour.sections, counts, strict=True) for _ in range(count)],
    )


def _nodes(spans: Sequence[Span]) -> tuple[Floats, Floats]:
    times = [spans[0].begin] + [span.end for span in spans]
    return np.array(times), np.array([spans[0].piece.start] + [span.piece.end for span in spans])


def _along(tour: Journey, way: Floats) -> Floats:
    return np.column_stack([np.interp(way, tour.along, tour.path[:, axis]) for axis in (0, 1)])


def _ahead(tour: Journey, way: Floats, places: Floats) -> Floats:
    """Return the direction half a metre ahead on the path. It is constant while the camera stands still."""
    offsets = _along(tour, np.minimum(way + _AHEAD, tour.along[-1])) - places
    far = np.hypot(*offsets.T) > 0.15
    if not far.any():
        return np.zeros(len(way))
    known = np.maximum.accumulate(np.where(far, np.arange(len(way)), 0))
    known[: int(np.argmax(far))] = int(np.argmax(far))
    directions: Floats = np.arctan2(offsets[:, 1], offsets[:, 0])[known]
    return directions


def _shaken(rng: np.random.Generator, carriage: Carriage, way: Floats) -> list[Floats]:
    """Draw random offsets for yaw, pitch and roll, as well as the sway and rise caused by steps."""
    count = len(way)
    slow = 2.0 / _TICK
    angles = []
    for deviation in (carriage.yaw_wander, carriage.pitch_wander, carriage.roll_wander):
        drift = wander(rng, count, deviation, slow)
        angles.append(np.radians(drift + wander(rng, count, carriage.shake, 0.1 / _TICK)))
    moving = np.clip(np.gradient(way, _TICK) / 0.6, 0.0, 1.5)
    phase = 2 * math.pi * _STEPS_A_SECOND * np.cumsum(np.minimum(moving, 1.0)) * _TICK
    sway = 1.5 * carriage.step * moving * np.sin(0.5 * phase)
    return [*angles, sway, carriage.step * moving * np.sin(phase)]
