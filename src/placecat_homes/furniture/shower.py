"""Showers."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.fittings import hand_shower, wall_mixer
from placecat_homes.parts.hanging import curtain
from placecat_homes.parts.lofts import loft, rounded
from placecat_homes.parts.toiletries import bottle
from placecat_homes.shapes import box, cylinder, lathe, tube
from placecat_homes.style import Style


def shower(
    rng: np.random.Generator,
    style: Style,
    *,
    ceramic: Material | None = None,
    tiles: Material | None = None,
    width: float | None = None,
    kind: str | None = None,
) -> Mesh:
    """Draw a shower with a tray, a tiled back wall, a shower head, and glass walls or a curtain.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    ceramic
        Material of the tray; chosen at random if None.
    tiles
        Tiles on the back wall; chosen at random if None.
    width
        Width in metres; chosen at random if None.
    kind
        "cabin" (glass on three sides, with doors), "walk-in" (one pane) or "curtain"; random if None.

    Returns
    -------
    Mesh
        A shower 2 to 2.1 m high.
    """
    ceramic = ceramic or palette.ceramic(rng)
    tiles = tiles or palette.tiles(rng)
    kind = kind or str(rng.choice(("cabin", "walk-in", "curtain"), p=(0.6, 0.2, 0.2)))
    width = width or float(rng.choice((0.8, 0.9, 1.0, 1.2)))
    depth = rng.uniform(0.8, 0.95)
    height = 2.05
    rim = 0.04 if kind == "walk-in" else rng.uniform(0.08, 0.17)
    parts = [_tray(ceramic, style.metal, width, depth, rim)]
    parts.append(box(width, 0.015, height - rim, bevel=0.0).moved(z=rim).of(tiles))
    parts.append(_fittings(rng, style, width).moved(0, 0.015))
    if kind == "cabin":
        parts.append(_glass_walls(rng, style, width, depth, rim, height))
    elif kind == "walk-in":
        pane_width = width * rng.uniform(0.5, 0.7)
        x = (width - pane_width) / 2 * float(rng.choice((-1, 1)))
        parts.append(_pane(pane_width, height - rim, style.metal).moved(x, depth - 0.04, rim))
        side = 1 if x > 0 else -1
        parts.append(
            tube(
                [
                    (x - side * pane_width / 2, depth - 0.03, height - 0.02),
                    (x - side * pane_width / 2, 0, height - 0.02),
                ],
                0.01,
                6,
            ).of(style.metal)
        )
    else:
        parts.append(_curtained(rng, style, width, depth, height))
    return join(parts)


def _tray(ceramic: Material, metal: Material, width: float, depth: float, rim: float) -> Mesh:
    edge = rounded(width, depth, 0.02, 0.004)
    inner = rounded(width - 0.1, depth - 0.1, 0.06, y=0.05)
    floor = rounded(width - 0.16, depth - 0.16, 0.06, y=0.08)
    rings = [
        (edge, 0.0),
        (edge, rim - 0.004),
        (edge * 0.99 + (0, 0.005), rim),
        (inner, rim),
        (floor, rim * 0.5),
    ]
    return join(
        loft(rings).of(ceramic),
        cylinder(0.05, 0.006, 14).moved(0, depth / 2, rim * 0.5).of(metal),
    )


def _fittings(rng: np.random.Generator, style: Style, width: float) -> Mesh:
    """Draw the mixer, the shower head, the hose and a shelf of bottles on the back wall."""
    metal = style.metal
    parts = [wall_mixer(metal, spout=False).moved(0, 0, 1.05)]
    if rng.random() < 0.5:
        neck = [(0.0, 0.05, 1.1), (0.0, 0.05, 1.95), (0.0, 0.1, 2.02), (0.0, 0.38, 2.02), (0.0, 0.4, 1.99)]
        head = cylinder(rng.uniform(0.09, 0.14), 0.015, 16).moved(0, 0.4, 1.965)
        parts += [tube(neck, 0.011, 8).of(metal), head.of(metal)]
        turn = np.linspace(0, math.pi, 9)
        hose = [(0.06 + 0.06 * math.cos(a), 0.07, 1.1 - 0.45 * math.sin(a)) for a in turn]
        hose.append((0.0, 0.07, 1.25))
        parts.append(tube(hose[::-1], 0.007, 6).of(metal))
    else:
        parts.append(hand_shower(metal, metal, 0.75).moved(0.02, 0, 1.2))
    shelf_x = (width / 2 - 0.16) * float(rng.choice((-1, 1)))
    shelf = lathe([(0, 0), (0.11, 0), (0.11, 0.012), (0, 0.012)], 12).of(palette.WHITE)
    parts.append(shelf.moved(shelf_x, 0.11, 1.15))
    parts.extend(
        bottle(rng).moved(shelf_x + rng.uniform(-0.01, 0.01) + 0.075 * (k - 1), 0.11, 1.162)
        for k in range(int(rng.integers(1, 4)))
    )
    return join(parts)


def _pane(width: float, height: float, metal: Material) -> Mesh:
    """Draw a pane of glass in a thin frame."""
    bar = 0.022
    post = box(bar, bar, height, bevel=0.0)
    rail = box(width, bar, bar, bevel=0.0)
    x = (width - bar) / 2
    return join(
        box(width, 0.008, height, bevel=0.0).moved(0, 0.007).of(palette.GLASS),
        join(post.moved(x), post.moved(-x), rail, rail.moved(z=height - bar)).of(metal),
    )


def _glass_walls(
    rng: np.random.Generator, style: Style, width: float, depth: float, rim: float, height: float
) -> Mesh:
    """Draw glass walls on three sides. The front has one or two doors, and a single door may be ajar."""
    frame = style.metal if rng.random() < 0.6 else Material((0.9, 0.9, 0.9), gloss=0.05)
    tall = height - rim
    side = _pane(depth - 0.03, tall, frame).turned(90)
    parts = [
        side.moved(width / 2, (depth - 0.03) / 2, rim),
        side.moved(-width / 2 + 0.022, (depth - 0.03) / 2, rim),
    ]
    ajar = rng.uniform(15, 70) if rng.random() < 0.3 else 0.0
    doors = 2 if width >= 0.95 or rng.random() < 0.4 else 1
    share = (width - 0.03) / doors
    for k in range(doors):
        hinge = -1 if k == 0 else 1
        door = _pane(share - 0.004, tall, frame)
        grip = tube([(0, 0, 0.9), (0, 0.05, 0.92), (0, 0.05, 1.18), (0, 0, 1.2)], 0.01, 6).of(frame)
        door = join(door, grip.moved(-hinge * (share / 2 - 0.05), 0.02, -rim))
        if k == 0 and ajar and doors == 1:
            door = door.moved(share / 2).turned(ajar / 2).moved(-share / 2)
        parts.append(door.moved((k - (doors - 1) / 2) * share, depth - 0.035, rim))
    return join(parts)


def _curtained(rng: np.random.Generator, style: Style, width: float, depth: float, height: float) -> Mesh:
    """Draw a rail around the tray with a curtain pulled aside."""
    wide = width * rng.uniform(0.3, 0.8)
    cloth = curtain(wide, height - 0.2, max(3, int(wide / 0.1)), 0.06).of(style.any_fabric(rng))
    x, y = width / 2 - 0.015, depth - 0.03
    rail = tube([(-x, 0, height), (-x, y, height), (x, y, height), (x, 0, height)], 0.012, 8).of(style.metal)
    return join(rail, cloth.moved((width - wide) / 2 * float(rng.choice((-1, 1))) * 0.95, y - 0.03, 0.17))
