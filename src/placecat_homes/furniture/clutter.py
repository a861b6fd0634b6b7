"""Small objects on tables and shelves."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture import books
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.furniture.box import storage_box
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.vase import bowl, candle, figure, vase
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import lathe, tube
from placecat_homes.style import Style

BUTTON = Material((0.55, 0.55, 0.57))


def mug(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a mug or cup.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    r, h = between(rng, 0.036, 0.046), between(rng, 0.07, 0.1)
    skin = palette.ceramic(rng)
    body = lathe([(0, 0), (r * 0.85, 0), (r, h), (r * 0.9, h), (r * 0.8, 0.02), (0, 0.02)], 14)
    ear = tube(
        [(r * 0.9, 0, h * 0.8), (r * 1.6, 0, h * 0.7), (r * 1.6, 0, h * 0.35), (r * 0.9, 0, h * 0.2)],
        0.005,
        6,
    )
    tea = lathe([(r * 0.88, h * 0.8), (0, h * 0.8)], 12).of(Material((0.25, 0.14, 0.07), gloss=0.03))
    return grounded(join(body, ear).of(skin), tea)


def remote(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a remote control.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.

    Returns
    -------
    Mesh
        A remote control lying on z = 0, parallel to the y axis.
    """
    long = between(rng, 0.15, 0.22)
    parts = [block(palette.RUBBER, (0.045, long, 0.018), (0, 0, 0), 0.004)]
    for row in range(5):
        for x in (-0.012, 0.0, 0.012):
            parts.append(block(BUTTON, (0.008, 0.008, 0.003), (x, long * (0.25 + 0.13 * row), 0.0175)))
    return join(parts)


def small_thing(rng: np.random.Generator, style: Style, height: float = 0.4) -> Mesh:
    """Draw an ornament for a shelf, sill or sideboard.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    height
        Maximum height in metres.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    kind = choose(rng, (vase, figure, bowl, candle, "plant", "books"), (2, 3, 1.5, 1, 2, 1))
    if kind == "plant":
        thing = plant(rng, style, between(rng, 0.18, 0.38))
    elif kind == "books":
        thing = books.stack(rng)
    else:
        thing = kind(rng, style)  # type: ignore[operator]
    tall = float(thing.size[2])
    return thing if tall <= height else thing.scaled(height / tall)


def fill(
    rng: np.random.Generator,
    style: Style,
    width: float,
    height: float,
    depth: float,
    pool: list[Material],
    full: float = 0.8,
) -> Mesh:
    """Draw the contents of one shelf: books, boxes, ornaments or nothing.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, height, depth
        Free space in metres.
    pool
        Book covers to choose from.
    full
        How full the shelf is, from 0 (mostly empty) to 1 (full of books).

    Returns
    -------
    Mesh
        The contents, centred on x = 0, with their back at y = 0.
    """
    kind = choose(
        rng,
        ("books", "half", "things", "boxes", "piles", "empty"),
        (4 * full, 2, 1.6, 0.7, 0.7, 0.7 * (1 - full)),
    )
    if kind == "books":
        return books.row(rng, width, height, depth, pool)
    if kind == "half":
        share = between(rng, 0.35, 0.75)
        side = choose(rng, (-1, 1))
        standing = books.row(rng, width * share, height, depth, pool).moved(side * width * (1 - share) / 2)
        rest = width * (1 - share) - 0.03
        thing = small_thing(rng, style, height * 0.9)
        if float(thing.size[0]) > rest or float(thing.size[1]) > depth:
            return standing
        thing = thing.moved(-side * width * share / 2, (depth - float(thing.size[1])) / 2, 0)
        return join(standing, thing)
    parts: list[Mesh] = []
    if kind == "boxes":
        each = min(between(rng, 0.24, 0.34), width - 0.01)
        count = max(int(width / each), 1)
        tall = min(height * between(rng, 0.5, 0.85), 0.3)
        one = storage_box(rng, style, each - 0.015, depth * 0.92, tall)
        return join([one.moved((k + 0.5) * each - count * each / 2) for k in range(count)])
    if kind in ("things", "piles"):
        count = max(int(width / 0.28), 1)
        for k in range(count):
            x = (k + 0.5) * width / count - width / 2
            if kind == "piles" and chance(rng, 0.7):
                thing = books.stack(rng, int(rng.integers(2, 7)), pool)
            else:
                thing = small_thing(rng, style, height * 0.92)
            if (
                float(thing.size[2]) > height
                or float(thing.size[0]) > width / count
                or float(thing.size[1]) > depth
            ):
                continue
            parts.append(thing.moved(x, (depth - float(thing.size[1])) * rng.uniform(0.3, 1), 0))
    return join(parts)


def table_things(rng: np.random.Generator, style: Style, width: float, depth: float, count: int) -> Mesh:
    """Draw objects for a coffee table, such as magazines, remote controls, cups, a bowl or a vase.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, depth
        Width and depth of the table top in metres.
    count
        Maximum number of objects.

    Returns
    -------
    Mesh
        Objects standing on z = 0, around the middle of the table.
    """
    parts: list[Mesh] = []
    taken: list[tuple[float, float, float]] = []
    for _ in range(count):
        kind = int(rng.choice(8, p=[0.2, 0.17, 0.2, 0.08, 0.1, 0.05, 0.1, 0.1]))
        if kind == 0:
            thing = join(
                [
                    books.magazine(rng).turned(rng.normal(0, 12)).moved(0, 0, 0.009 * k)
                    for k in range(int(rng.integers(1, 4)))
                ]
            )
        else:
            makers = (remote, mug, bowl, vase, candle)
            thing = makers[kind - 1](rng, style) if kind < 6 else books.stack(rng, int(rng.integers(1, 4)))
            if kind == 7:
                thing = plant(rng, style, between(rng, 0.2, 0.35))
        thing = thing.turned(between(rng, -40, 40))
        low, high = thing.low, thing.high
        reach = float(max(high[:2] - low[:2])) / 2
        for _ in range(8):
            x = between(rng, -1, 1) * max(width / 2 - reach - 0.02, 0)
            y = between(rng, -1, 1) * max(depth / 2 - reach - 0.02, 0)
            if reach < min(width, depth) / 2 and all(
                (x - a) ** 2 + (y - b) ** 2 > (reach + r) ** 2 * 0.8 for a, b, r in taken
            ):
                taken.append((x, y, reach))
                parts.append(thing.moved(x - float(low[0] + high[0]) / 2, y - float(low[1] + high[1]) / 2, 0))
                break
    return join(parts)
