"""Curtains and blinds for any kind of room."""

import numpy as np

from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.furniture.clutter import small_thing
from placecat_homes.furniture.curtain import blind, curtains, net
from placecat_homes.mesh import Mesh
from placecat_homes.placing.opening import Opening
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room

_SILL = 0.14


def dress_windows(room: Room, bare: float = 0.15, cloth: float = 0.65) -> None:
    """Hang matching curtains, blinds or net curtains in front of a room's windows.

    Parameters
    ----------
    room
        The room.
    bare
        Probability that the windows are left bare.
    cloth
        Probability that windows not left bare have curtains rather than blinds or net curtains.
    """
    rng = room.rng
    for window in room.windows:
        if window.sill > 0.5 and chance(rng, 0.4):
            _on_sill(room, window)
    if not room.windows or chance(rng, bare):
        return
    kind = "curtains" if chance(rng, cloth) else choose(rng, ("blind", "blind", "net"))
    seed = int(rng.integers(1 << 30))
    extra = 0.0 if chance(rng, 0.5) else between(rng, 0.0, 0.1)
    for window in room.windows:
        model = _dressing(kind, seed, room, window, extra)
        if kind == "curtains":
            if room.dress(window, model, bottom=window.top + 0.09 - _rod(window, extra)) is None:
                room.dress(window, _dressing("blind", seed, room, window, extra), bottom=window.sill)
        else:
            room.dress(window, model, bottom=window.sill)


def _on_sill(room: Room, window: Opening) -> None:
    """Put plants and ornaments on a window sill, within the depth of the wall."""
    rng = room.rng
    count = int(rng.integers(1, 4))
    for k in range(count):
        thing = small_thing(rng, room.style, 0.35)
        deep = float(thing.size[1])
        if deep > _SILL:
            thing = thing.scaled(_SILL / deep)
        along = window.start + (k + between(rng, 0.3, 0.7)) * window.width / count
        x, y = room.point(window.wall, along, -_SILL)
        room.placed.append(Placed(thing, x, y, window.sill + 0.007, 90.0 * window.wall))


def _rod(window: Opening, extra: float) -> float:
    """Return the distance in metres from the bottom of the curtains to the rod."""
    low = 0.03 if window.sill < 0.5 or extra > 0.03 else window.sill - 0.12
    return window.top + 0.09 - low


def _dressing(kind: str, seed: int, room: Room, window: Opening, extra: float) -> Mesh:
    rng = np.random.default_rng(seed)
    if kind == "curtains":
        return curtains(rng, room.style, window.width, _rod(window, extra))
    height = window.top - window.sill
    return (blind if kind == "blind" else net)(rng, room.style, window.width + 0.06, height + 0.04)
