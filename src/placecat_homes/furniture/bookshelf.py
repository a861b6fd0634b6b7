"""Bookshelves, wall units and wall shelves."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose, handle, open_box
from placecat_homes.furniture.books import covers
from placecat_homes.furniture.clutter import fill, small_thing
from placecat_homes.furniture.television import television
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import tube
from placecat_homes.style import Style


def bookshelf(
    rng: np.random.Generator,
    style: Style,
    width: float | None = None,
    height: float | None = None,
    full: float | None = None,
) -> Mesh:
    """Draw a bookcase, a grid of cubes or a metal-framed shelf, with books and objects.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, height
        Size in metres; chosen at random if None.
    full
        How full the shelves are, from 0 (few books) to 1 (many); chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    width = between(rng, 0.6, 1.1) if width is None else width
    height = (
        (between(rng, 1.7, 2.1) if chance(rng, 0.75) else between(rng, 0.8, 1.3))
        if height is None
        else height
    )
    full = between(rng, 0.4, 1.0) if full is None else full
    kind = choose(rng, (_case, _cubes, _frame), (3, 1, 1))
    return grounded(kind(rng, style, width, height, full))


def _case(rng: np.random.Generator, style: Style, width: float, height: float, full: float) -> Mesh:
    wood, pool = style.any_wood(rng), covers(rng)
    columns = max(1, round(width / between(rng, 0.7, 1.0)))
    each = width / columns
    depth = between(rng, 0.24, 0.34)
    doors = chance(rng, 0.3) and height > 1.4
    parts = [
        _column(rng, style, wood, each, height, depth, full, pool, doors).moved(
            (k - (columns - 1) / 2) * each
        )
        for k in range(columns)
    ]
    if chance(rng, 0.3):
        parts.append(block(wood, (width + 0.04, depth + 0.03, 0.04), (0, 0, height), 0.006))
    elif height < 1.4 or chance(rng, 0.3):
        for k in range(int(rng.integers(1, 3))):
            thing = small_thing(rng, style, 0.4)
            if float(thing.size[1]) < depth + 0.05:
                parts.append(thing.moved((k - 0.5) * width * 0.5, 0.01, height))
    return join(parts)


def _column(
    rng: np.random.Generator,
    style: Style,
    wood: Material,
    width: float,
    height: float,
    depth: float,
    full: float,
    pool: list[Material],
    doors: bool,
) -> Mesh:
    board, plinth = 0.02, 0.06
    parts = [open_box(wood, (width, depth, height - plinth), board).moved(0, 0, plinth)]
    parts.append(block(wood, (width, depth - 0.02, plinth), (0, 0, 0)))
    z, inner = plinth + board, width - 2 * board
    if doors:
        tall = between(rng, 0.55, 0.8)
        parts.append(
            _doors(style, style.fronts if chance(rng, 0.3) else wood, width, tall).moved(0, depth, plinth)
        )
        z = plinth + tall
        parts.append(block(wood, (inner, depth, board), (0, 0, z - board)))
    count = max(1, round((height - z) / between(rng, 0.28, 0.38)))
    pitch = (height - board - z) / count
    for k in range(count):
        bottom = z + k * pitch
        if k:
            parts.append(block(wood, (inner, depth - 0.01, board), (0, 0, bottom - board)))
        parts.append(
            fill(rng, style, inner - 0.01, pitch - board - 0.01, depth - 0.02, pool, full).moved(
                0, 0.008, bottom
            )
        )
    return join(parts)


def _doors(style: Style, front: Material, width: float, height: float) -> Mesh:
    parts = []
    for side in (-1, 1):
        parts.append(
            block(front, (width / 2 - 0.004, 0.018, height - 0.006), (side * width / 4, 0, 0.003), 0.003)
        )
        knob = handle(style.handle, style.metal, 0.12)
        if style.handle == "bar":
            knob = knob.turned(90, "y")
        parts.append(knob.moved(side * 0.04, 0.018, height * 0.6))
    return join(parts)


def _cubes(rng: np.random.Generator, style: Style, width: float, height: float, full: float) -> Mesh:
    wood, pool = style.any_wood(rng), covers(rng)
    cube = between(rng, 0.33, 0.38)
    columns, rows = max(2, round(width / cube)), max(2, round(height / cube))
    depth, edge, board = 0.38, 0.035, 0.018
    w, h = columns * cube + 2 * edge, rows * cube + 2 * edge
    parts = [open_box(wood, (w, depth, h), edge, back=chance(rng, 0.5))]
    for k in range(1, columns):
        parts.append(block(wood, (board, depth, h - 2 * edge), (k * cube - columns * cube / 2, 0, edge)))
    for k in range(1, rows):
        parts.append(
            block(wood, (w - 2 * edge, depth - 0.002, board), (0, 0.001, edge + k * cube - board / 2))
        )
    for i in range(columns):
        for j in range(rows):
            x, z = (i + 0.5 - columns / 2) * cube, edge + j * cube + board / 2
            held = fill(rng, style, cube - 0.03, cube - 0.03, depth - 0.06, pool, full)
            parts.append(held.moved(x, 0.02, z))
    return join(parts)


def _frame(rng: np.random.Generator, style: Style, width: float, height: float, full: float) -> Mesh:
    wood, pool, steel = style.any_wood(rng), covers(rng), palette.metal(rng)
    depth, count = between(rng, 0.28, 0.36), max(2, round(height / between(rng, 0.34, 0.42)))
    parts = []
    for side in (-1, 1):
        for y in (0.015, depth - 0.015):
            x = side * (width / 2 - 0.012)
            parts.append(block(steel, (0.024, 0.024, height), (x, y - 0.012, 0)))
    pitch = (height - 0.12) / count
    for k in range(count + 1):
        z = 0.1 + k * pitch
        parts.append(block(wood, (width - 0.05, depth, 0.022), (0, 0, z - 0.022)))
        if k < count:
            parts.append(
                fill(rng, style, width - 0.1, pitch - 0.05, depth - 0.03, pool, full * 0.7).moved(0, 0.02, z)
            )
    if chance(rng, 0.5):
        ends = [(-width / 2 + 0.03, 0.006, 0.1), (width / 2 - 0.03, 0.006, height - 0.05)]
        parts.append(tube(ends, 0.004, 4).of(steel))
    thing = small_thing(rng, style, 0.4)
    if float(thing.size[1]) < depth:
        parts.append(thing.moved(0, 0.02, 0.1 + count * pitch))
    return join(parts)


def wall_unit(
    rng: np.random.Generator, style: Style, width: float | None = None, screen: bool | None = None
) -> Mesh:
    """Draw a wide wall unit with cupboards, shelves and glass doors, and often a television.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres; chosen at random if None.
    screen
        Whether it includes a television; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    width = between(rng, 2.0, 3.2) if width is None else width
    height, low, depth = between(rng, 1.8, 2.15), between(rng, 0.48, 0.62), between(rng, 0.38, 0.45)
    wood, pool = style.any_wood(rng), covers(rng)
    front = choose(rng, (wood, wood, palette.paint(rng)))
    screen = chance(rng, 0.6) if screen is None else screen
    parts = [block(wood, (width, depth - 0.03, 0.06), (0, 0, 0))]
    middle = min(max(1.05, width * 0.42), width - 0.9) if screen else 0.0
    sides = (width - middle) / 2
    count = max(1, round(sides / 0.6))
    cells = [(k, s) for s in (-1, 1) for k in range(count)]
    upper = depth * 0.75
    for k, side in cells:
        each = sides / count
        x = side * (width / 2 - (k + 0.5) * each)
        parts.append(block(wood, (each, depth - 0.02, low - 0.06), (x, 0, 0.06)))
        parts.append(_doors(style, front, each, low - 0.06).moved(x, depth - 0.02, 0.06))
        top = height - low
        if chance(rng, 0.25):
            parts.append(block(wood, (each, upper, top), (x, 0, low)))
            parts.append(_doors(style, front, each, top).moved(x, upper, low))
            continue
        parts.append(open_box(wood, (each, upper, top), 0.02).moved(x, 0, low))
        shelves = round(top / 0.36)
        pitch = (top - 0.02) / shelves
        for row in range(shelves):
            z = low + 0.02 + row * pitch
            if row:
                parts.append(block(wood, (each - 0.04, upper - 0.01, 0.018), (x, 0, z - 0.018)))
            parts.append(
                fill(rng, style, each - 0.06, pitch - 0.04, upper - 0.03, pool, 0.6).moved(x, 0.01, z)
            )
        if chance(rng, 0.3):
            parts.append(block(palette.GLASS, (each - 0.02, 0.006, top - 0.04), (x, upper, low + 0.02)))
    if screen:
        parts.append(block(wood, (middle, depth - 0.02, low - 0.06), (0, 0, 0.06)))
        for k in range(2):
            parts.append(
                _doors(style, front, middle / 2, low - 0.06).moved((k - 0.5) * middle / 2, depth - 0.02, 0.06)
            )
        wide = min(middle - 0.12, 1.3)
        parts.append(television(rng, style, wide).moved(0, depth * 0.3, low))
        bridge = low + wide * 9 / 16 + 0.2
        if bridge < height - 0.3:
            parts.append(open_box(wood, (middle, upper, height - bridge), 0.02).moved(0, 0, bridge))
            held = fill(rng, style, middle - 0.06, height - bridge - 0.06, upper - 0.03, pool, 0.7)
            parts.append(held.moved(0, 0.01, bridge + 0.02))
    parts.append(block(wood, (width + 0.03, depth, 0.025), (0, 0, low - 0.0251), 0.004))
    return grounded(join(parts))


def wall_shelf(rng: np.random.Generator, style: Style, width: float | None = None) -> Mesh:
    """Draw one or two wall shelves with objects on them.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh whose lowest point is at z = 0.
    """
    width = between(rng, 0.6, 1.2) if width is None else width
    wood, depth, pool = style.any_wood(rng), between(rng, 0.2, 0.26), covers(rng)
    parts = []
    for k in range(int(rng.integers(1, 3))):
        z = 0.12 + k * 0.36
        parts.append(block(wood, (width, depth, 0.03), (0, 0, z - 0.03), 0.004))
        for side in (-1, 1):
            parts.append(block(style.metal, (0.015, depth * 0.7, 0.1), (side * width * 0.4, 0, z - 0.13)))
        parts.append(fill(rng, style, width - 0.04, 0.3, depth, pool, 0.5).moved(0, 0, z))
    mesh = join(parts)
    return mesh.moved(0, 0, -float(mesh.low[2]))
