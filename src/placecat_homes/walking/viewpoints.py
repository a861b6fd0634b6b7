"""Places in a room from which a camera can look around."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat_homes.walking.ground import Ground

_DIRECTIONS = 24
_FAR = 7.0
_TRIES = 40
_DOOR = 0.7


@dataclass(frozen=True)
class Viewpoint:
    """A place to stop.

    Attributes
    ----------
    room
        Index of the room.
    place
        x, y.
    outlook
        Yaw in radians towards the widest view or the furniture.
    focus
        Point x, y, z on the furniture or wall that the camera has approached, if any.
    """

    room: int
    place: tuple[float, float]
    outlook: float
    focus: tuple[float, float, float] | None = None


def sight(ground: Ground, room: int, places: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the (n, 24) distances from (n, 2) places to the walls of a room, in 24 directions."""
    angles = np.arange(_DIRECTIONS) * (2 * math.pi / _DIRECTIONS)
    steps = np.arange(1, round(_FAR / (2 * ground.cell)) + 1) * 2 * ground.cell
    rays = steps[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)[:, None, :]
    points = np.asarray(places)[:, None, None, :] + rays
    inside = ground.room_at(points.reshape(-1, 2)).reshape(points.shape[:-1]) == room
    return np.cumprod(inside, axis=2).sum(axis=2) * 2 * ground.cell


def choose(
    ground: Ground,
    rng: np.random.Generator,
    room: int,
    *,
    near: list[NDArray[np.float64]],
    reach: float,
    close: bool = False,
    amid: bool = False,
) -> Viewpoint:
    """Choose a place to look around from.

    Parameters
    ----------
    ground
        The building.
    rng
        Random number generator.
    room
        Index of the room.
    near
        Points, each (2,), to stay near, such as those where the walk enters and leaves the room.
    reach
        Maximum sum of the distances to these points in metres, if any place is that close.
    close
        Go up close to a piece of furniture or a wall.
    amid
        Go where there is space on all sides, rather than where the view in one direction is widest.
    """
    cells = np.argwhere(ground.free & (ground.room == room))
    if close:
        found = _close(ground, rng, room, cells, near, reach)
        if found is not None:
            return found
    places = ground.points(rng.permutation(cells)[: 8 * _TRIES])
    doors = [(x, y) for a, b, x, y in ground.doors if room in (a, b)]
    away = np.ones(len(places), dtype=bool)
    for door in doors:
        away &= np.hypot(*(places - door).T) > _DOOR
    if away.any():
        places = places[away]
    far = _far(places, near)
    within = np.flatnonzero(far <= reach)
    places = places[within[:_TRIES] if len(within) else np.argsort(far, kind="stable")[:5]]
    depth = sight(ground, room, places)
    wide = _window(depth)
    open_ = wide.min(axis=1) if amid or rng.random() < 0.3 else wide.max(axis=1)
    deep = 0.6 + 0.4 * np.minimum(1.0, _far(places, near) / reach)
    liking = open_ * deep * rng.uniform(0.6, 1.0, len(places))
    focus = _main(ground, room)
    if focus is None or amid:
        best = int(np.argmax(liking))
        return Viewpoint(room, _pair(places[best]), _outlook(wide[best]))
    # Prefer a place from which the furniture is in full view.
    away_ = np.hypot(*(places - focus).T)
    best = int(np.argmax(liking * np.minimum(away_, 3.0)))
    x, y = focus - places[best]
    return Viewpoint(room, _pair(places[best]), math.atan2(y, x))


def _main(ground: Ground, room: int) -> NDArray[np.float64] | None:
    # Objects that are typical of a room are placed first, so give those more weight.
    items = [(x, y) for index, x, y, _ in ground.items if index == room]
    if not items:
        return None
    weight = 1 / (1.0 + np.arange(len(items)))
    return np.asarray(np.average(np.array(items), axis=0, weights=weight))


def _close(
    ground: Ground,
    rng: np.random.Generator,
    room: int,
    cells: NDArray[np.int64],
    near: list[NDArray[np.float64]],
    reach: float,
) -> Viewpoint | None:
    places = ground.points(cells)
    x0, y0, x1, y1 = ground.rects[room]
    items = [(x, y, z) for index, x, y, z in ground.items if index == room]
    if items and rng.random() < 0.65:
        x, y, z = items[int(rng.integers(len(items)))]
        distance = np.hypot(*(places - (x, y)).T)
        fit = distance < distance.min() + 0.3
        focus = np.broadcast_to(np.array([x, y, 0.7 * z]), (len(places), 3))
    else:
        gaps = np.stack([places[:, 0] - x0, places[:, 1] - y0, x1 - places[:, 0], y1 - places[:, 1]], axis=1)
        side = gaps.argmin(axis=1)
        distance = gaps.min(axis=1)
        fit = (distance > 0.38) & (distance < 0.65)
        out = np.array([[-1, 0], [0, -1], [1, 0], [0, 1]])[side]
        focus = np.column_stack([places + out * distance[:, None], np.full(len(places), 1.2)])
    fit &= _far(places, near) <= reach
    for _, _, x, y in (door for door in ground.doors if room in door[:2]):
        fit &= np.hypot(*(places - (x, y)).T) > _DOOR
    if not fit.any():
        return None
    best = int(rng.choice(np.flatnonzero(fit)))
    x, y, z = map(float, focus[best])
    wide = _window(sight(ground, room, places[best : best + 1]))
    return Viewpoint(room, _pair(places[best]), _outlook(wide[0]), (x, y, z))


def _far(places: NDArray[np.float64], near: list[NDArray[np.float64]]) -> NDArray[np.float64]:
    far = np.zeros(len(places))
    for point in near:
        far += np.hypot(*(places - point).T)
    return far


def _window(depth: NDArray[np.float64]) -> NDArray[np.float64]:
    # Averaging over 90 degrees favours a wide view over a single long ray.
    reach = _DIRECTIONS // 8
    return np.mean([np.roll(depth, shift, axis=1) for shift in range(-reach, reach + 1)], axis=0)


def _outlook(wide: NDArray[np.float64]) -> float:
    return float(np.argmax(wide)) * 2 * math.pi / _DIRECTIONS


def _pair(point: NDArray[np.float64]) -> tuple[float, float]:
    return float(point[0]), float(point[1])
