"""Single empty rooms that tests can furnish."""

import numpy as np

from placecat.seeds import derive
from placecat_homes.placing.lattice import CELL
from placecat_homes.placing.opening import Opening
from placecat_homes.placing.room import Room
from placecat_homes.style import Style

_SIZES = {
    "bedroom": ((2.9, 4.2), (3.4, 4.8)),
    "bathroom": ((1.8, 2.6), (2.2, 3.3)),
    "kitchen": ((2.3, 3.6), (3.0, 4.2)),
    "living_room": ((3.6, 5.2), (4.4, 6.0)),
    "dining_room": ((2.8, 3.9), (3.2, 4.5)),
    "corridor": ((1.2, 1.9), (3.5, 8.0)),
    "office": ((2.8, 4.2), (3.8, 5.5)),
    "printer_area": ((2.2, 3.6), (2.6, 4.2)),
    "closet": ((1.6, 2.2), (1.9, 2.6)),
    "lavatory": ((1.9, 3.0), (2.8, 4.2)),
    "kitchenette": ((2.2, 3.2), (2.8, 4.2)),
    "hallway": ((1.8, 2.4), (10.0, 16.0)),
}


def example(kind: str, seed: int, width: float | None = None, depth: float | None = None) -> Room:
    """Make a single empty room with a door and one or two windows, ready for a furnishing function.

    Parameters
    ----------
    kind
        Kind of room, such as "bedroom".
    seed
        Seed for the size, the openings and the style.
    width, depth
        Metres; if None, a usual size for the kind is drawn.

    Returns
    -------
    Room
        The empty room.
    """
    rng = np.random.default_rng(derive("example room", kind, seed))
    short, long = (float(rng.uniform(*limits)) for limits in _SIZES.get(kind, ((3.0, 4.0), (3.5, 5.0))))
    if rng.random() < 0.5:
        short, long = long, short
    size = (
        round((short if width is None else width) / CELL) * CELL,
        round((long if depth is None else depth) / CELL) * CELL,
        float(rng.uniform(2.4, 2.8)),
    )
    walls = [int(k) for k in rng.permutation(4)]
    openings = [_door(rng, walls[0], size[walls[0] % 2])]
    if kind in ("corridor", "hallway"):
        openings.append(_door(rng, (walls[0] + 2) % 4, size[walls[0] % 2]))
        walls.remove((walls[0] + 2) % 4)
    for wall in walls[1 : 2 + int(rng.random() < 0.4)]:
        length = size[wall % 2]
        wide = float(min(rng.uniform(0.6, 0.9) if "bath" in kind else rng.uniform(0.9, 1.8), length - 0.8))
        if wide < 0.5:
            continue
        start = (length - wide) / 2 + float(rng.uniform(-1, 1)) * (length - wide - 0.6) / 4
        sill = 1.2 if kind in ("bathroom", "lavatory") else (1.05 if kind == "kitchen" else 0.85)
        openings.append(Opening(wall, start, start + wide, sill, min(2.15, size[2] - 0.2)))
    style = Style.draw(np.random.default_rng(derive("example style", kind, seed)))
    return Room(kind, f"{kind}_1", size, openings, style, rng)


def _door(rng: np.random.Generator, wall: int, length: float) -> Opening:
    side, near = bool(rng.random() < 0.5), 0.25 + float(rng.uniform(0, max(length / 2 - 0.7, 0.0)))
    start = near if side else length - near - 0.85
    hinge = "left" if start + 0.42 < length / 2 else "right"
    return Opening(wall, start, start + 0.85, 0.0, 2.05, "door", bool(rng.random() < 0.6), hinge, True)
