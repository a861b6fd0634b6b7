"""Notice boards, posters and calendars."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material, Texture
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.prints import ink, pinned
from placecat_homes.shapes import box
from placecat_homes.style import Style


def notice_board(
    rng: np.random.Generator, style: Style, width: float | None = None, height: float | None = None
) -> Mesh:
    """Draw a cork or felt pinboard with papers, cards and a poster. It should hang about 1 m above the floor.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width, height
        Size in metres; 0.6 to 1.6 by 0.5 to 1.1 if None.
    """
    width = width or between(rng, 0.6, 1.6)
    height = height or between(rng, 0.5, 1.1)
    ground = choose(rng, (_cork(rng), palette.plain_fabric(rng)))
    frame = choose(rng, (style.metal, style.wood, Material((0.75, 0.76, 0.77), gloss=0.2, roughness=0.5)))
    parts = [block(ground, (width, 0.015, height))]
    for z in (0.0, height - 0.025):
        parts.append(block(frame, (width, 0.025, 0.025), (0, 0, z)))
    for side in (-1, 1):
        parts.append(block(frame, (0.025, 0.025, height), (side * (width / 2 - 0.0125), 0, 0)))
    count = round(width * height * between(rng, 9, 18))
    parts.append(_papers(rng, width - 0.08, height - 0.08, count).moved(0, 0.016, 0.04))
    return join(parts)


def papers_on_wall(rng: np.random.Generator, style: Style, width: float = 0.9, height: float = 0.7) -> Mesh:
    """Draw sheets of paper stuck directly to a wall or door."""
    return _papers(rng, width, height, round(width * height * between(rng, 6, 12)) + 2)


def wall_poster(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a portrait or landscape poster, sometimes framed. It should hang about 1 m above the floor."""
    short, long = choose(rng, ((0.59, 0.84), (0.84, 1.19), (0.42, 0.59)))
    width, height = (short, long) if chance(rng, 0.7) else (long, short)
    sheet = pinned(rng, width, height, large=True)
    if chance(rng, 0.6):
        return sheet
    frame = choose(rng, (style.metal, style.wood, Material((0.1, 0.1, 0.1))))
    rim = [block(frame, (width + 0.03, 0.018, 0.018), (0, 0, z)) for z in (-0.015, height - 0.003)]
    rim += [block(frame, (0.018, 0.018, height), (side * (width / 2 + 0.006), 0, 0)) for side in (-1, 1)]
    return join(sheet, rim).moved(z=0.015)


def calendar(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a calendar with a picture above a grid of days. It should hang about 1.3 m above the floor."""
    width = between(rng, 0.25, 0.42)
    picture = width * between(rng, 0.6, 0.9)
    days = width * 0.75
    rows = []
    for i in range(7):
        for j in range(5):
            cell = (width * 0.11, 0.001, days * 0.13)
            tone = Material((0.85, 0.3, 0.3)) if i == 0 else Material((0.75, 0.76, 0.78))
            rows.append(block(tone, cell, ((i - 3) * width * 0.135, 0.004, days * (0.06 + 0.16 * j))))
    return join(
        block(Material((0.95, 0.95, 0.94)), (width, 0.004, days + picture + 0.02)),
        pinned(rng, width - 0.02, picture, large=False)
        .of(palette.art(rng, width - 0.02, picture))
        .moved(0, 0.003, days + 0.01),
        rows,
    )


def _cork(rng: np.random.Generator) -> Material:
    base = (0.68, 0.5, 0.33)
    return Material(
        texture=Texture("granules", (base, (0.5, 0.35, 0.22)), (0.15, 0.15), int(rng.integers(99)))
    )


def _papers(rng: np.random.Generator, width: float, height: float, count: int) -> Mesh:
    sizes = ((0.21, 0.297), (0.297, 0.21), (0.148, 0.21), (0.105, 0.148), (0.3, 0.42), (0.076, 0.076))
    weights = (3, 1.5, 1.5, 1.5, 0.8, 1)
    parts: list[Mesh] = []
    for k in range(count):
        w, h = choose(rng, sizes, weights)
        if w > width or h > height:
            continue
        x = between(rng, -(width - w) / 2, (width - w) / 2)
        z = between(rng, 0, height - h)
        tilt = float(rng.normal(0, 2.0))
        sheet = pinned(rng, w, h).moved(z=-h).turned(tilt, "y").moved(x, 0.0004 * k, z + h)
        parts.append(sheet)
        parts.append(
            box(0.012, 0.008, 0.012, 0).of(Material(ink(rng))).moved(x, 0.0004 * k + 0.002, z + h - 0.02)
        )
    return join(parts)
