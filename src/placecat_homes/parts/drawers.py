"""Chests of drawers, drawer handles and desk surfaces."""

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style


def pull(style: Style, width: float, *, kind: str | None = None) -> Mesh:
    """Draw a handle, centred on the origin and facing +y, for a front `width` metres wide."""
    kind = kind or style.handle
    if kind == "knob":
        return cylinder(0.013, 0.025, 10).turned(-90, "x").of(style.metal)
    if kind == "bar":
        x = min(0.3 * width, 0.08)
        return tube([(-x, 0, 0), (-x, 0.025, 0), (x, 0.025, 0), (x, 0, 0)], 0.005, 6).of(style.metal)
    return box(min(0.4 * width, 0.1), 0.004, 0.02, bevel=0).moved(z=-0.01).of(Material((0.08, 0.08, 0.08)))


def chest(
    style: Style,
    width: float,
    depth: float,
    height: float,
    shares: tuple[float, ...],
    case: Material,
    front: Material,
    *,
    plinth: float = 0.04,
    handle: str | None = None,
) -> Mesh:
    """Draw a chest of drawers.

    Parameters
    ----------
    style
        Style of the home.
    width, depth, height
        Size in metres.
    shares
        Relative heights of the drawers from the top down.
    case, front
        Materials of the case and drawer fronts.
    plinth
        Height of the base in metres.
    handle
        Kind of handle; taken from the style if None.
    """
    parts = [
        box(width, depth - 0.02, height - plinth, 0.003).moved(z=plinth).of(case),
        box(width - 0.03, depth - 0.06, plinth, 0).of(Material((0.1, 0.1, 0.1))),
    ]
    unit = (height - plinth - 0.01) / sum(shares)
    z = height - 0.008
    for share in shares:
        z -= share * unit
        tall = share * unit - 0.006
        parts.append(box(width - 0.008, 0.018, tall, 0.003).moved(y=depth - 0.019, z=z).of(front))
        up = tall * 0.5 if tall < 0.2 else tall - 0.07
        parts.append(pull(style, width, kind=handle).moved(y=depth - 0.001, z=z + up))
    return join(parts)


def surface(rng: np.random.Generator, style: Style) -> Material:
    """Choose a surface material for office desks and shelves."""
    kind = rng.random()
    if kind < 0.35:
        return style.wood
    if kind < 0.6:
        return palette.wood(rng)
    if kind < 0.8:
        grey = float(rng.uniform(0.6, 0.92))
        return Material((grey, grey, grey * float(rng.uniform(0.9, 1.0))), gloss=0.03)
    return palette.paint(rng)
