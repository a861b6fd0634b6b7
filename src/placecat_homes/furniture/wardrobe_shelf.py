"""Open shelves and rails for walk-in closets."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose, handle
from placecat_homes.furniture.box import cardboard, storage_box
from placecat_homes.furniture.clothes import bag, folded, hanging, hat, shoes
from placecat_homes.furniture.suitcase import suitcase
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import tube
from placecat_homes.style import Style


def on_shelf(rng: np.random.Generator, style: Style, width: float, height: float, depth: float) -> Mesh:
    """Draw the contents of one closet shelf: folded clothes, boxes, shoes, bags, hats or nothing.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, height, depth
        Free space in metres.

    Returns
    -------
    Mesh
        The contents, standing on z = 0 and centred on x = 0, with their back at y = 0.
    """
    kind = choose(rng, ("folded", "boxes", "shoes", "mixed"), (5, 1.5, 1.5, 2))
    parts: list[Mesh] = []
    x = -width / 2
    while x < width / 2 - 0.18:
        room = width / 2 - x
        use = kind if kind != "mixed" else choose(rng, ("folded", "boxes", "shoes", "bag", "hat"))
        if use == "folded":
            thing = folded(rng, style, min(between(rng, 0.24, 0.36), room), min(depth - 0.03, 0.38))
        elif use == "boxes":
            wide = min(between(rng, 0.22, 0.38), room - 0.01)
            maker = storage_box if chance(rng, 0.7) else cardboard
            thing = maker(
                rng, style, wide, min(0.36, depth - 0.02), min(height * 0.8, between(rng, 0.12, 0.28))
            )
        elif use == "shoes":
            thing = shoes(rng, style, choose(rng, ("shoe", "sneaker")) if height < 0.36 else None)
        else:
            thing = (bag if use == "bag" else hat)(rng, style)
        size = thing.size
        if float(size[0]) <= room and float(size[2]) < height and float(size[1]) < depth + 0.03:
            middle = float(thing.low[0] + thing.high[0]) / 2
            parts.append(
                thing.moved(x + float(size[0]) / 2 - middle, max(depth - float(size[1]) - 0.02, 0), 0)
            )
        x += float(size[0]) + between(rng, 0.01, 0.06)
    return join(parts)


def _shelves(
    rng: np.random.Generator, style: Style, wood: Material, width: float, height: float, depth: float
) -> Mesh:
    parts = []
    z = 0.08
    if chance(rng, 0.45):
        rows = int(rng.integers(2, 5))
        tall = 0.19
        front = style.fronts if chance(rng, 0.4) else wood
        parts.append(block(wood, (width, depth - 0.02, rows * tall), (0, 0, z)))
        for row in range(rows):
            parts.append(
                block(
                    front,
                    (width - 0.01, 0.018, tall - 0.008),
                    (0, depth - 0.02, z + 0.004 + row * tall),
                    0.003,
                )
            )
            parts.append(handle(style.handle, style.metal).moved(0, depth - 0.002, z + tall * (row + 0.6)))
        z += rows * tall
    count = max(int((height - z) / between(rng, 0.3, 0.4)), 1)
    pitch = (height - z) / count
    for _ in range(count):
        parts.append(block(wood, (width, depth, 0.018), (0, 0, z)))
        parts.append(on_shelf(rng, style, width - 0.02, pitch - 0.04, depth).moved(0, 0, z + 0.018))
        z += pitch
    return join(parts)


def _rails(
    rng: np.random.Generator, style: Style, wood: Material, width: float, height: float, depth: float
) -> Mesh:
    parts = []
    double = chance(rng, 0.45)
    levels = (height - 0.06, height / 2 + 0.02) if double else (height - 0.06,)
    for z in levels:
        long = height / 2 - 0.1 if double else height - 0.45
        parts.append(tube([(-width / 2, depth / 2, z), (width / 2, depth / 2, z)], 0.013, 8).of(style.metal))
        parts.append(hanging(rng, style, width, long, between(rng, 0.6, 1.0)).moved(0, depth / 2, z))
    parts.append(block(wood, (width, depth, 0.018), (0, 0, 0.06)))
    x = -width / 2 + 0.15
    if not double:
        while x < width / 2 - 0.15:
            if chance(rng, 0.75):
                thing = shoes(rng, style) if chance(rng, 0.8) else cardboard(rng, style, 0.22, 0.34, 0.13)
                parts.append(thing.moved(x, depth - float(thing.size[1]) - 0.05, 0.078))
            x += 0.25
    return join(parts)


def wardrobe_shelf(
    rng: np.random.Generator, style: Style, width: float | None = None, height: float | None = None
) -> Mesh:
    """Draw an open closet with bays of hanging clothes, bays of shelves, and boxes on top.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, height
        Size in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    width = between(rng, 1.0, 2.2) if width is None else width
    height = between(rng, 1.95, 2.15) if height is None else height
    depth, board = between(rng, 0.46, 0.54), 0.018
    wood = style.any_wood(rng)
    bays = max(1, round(width / between(rng, 0.65, 0.95)))
    shares = rng.uniform(0.75, 1.25, bays)
    shares = shares / shares.sum() * (width - board)
    top = height - 0.32
    parts = [block(wood, (width, 0.006, height - 0.3))] if chance(rng, 0.6) else []
    x = -width / 2
    use = chance(rng, 0.5)
    for k in range(bays + 1):
        parts.append(block(wood, (board, depth, top), (x + board / 2, 0, 0)))
        if k == bays:
            break
        inner = float(shares[k]) - board
        maker = _rails if use or (bays == 1 and chance(rng, 0.8)) else _shelves
        parts.append(maker(rng, style, wood, inner, top, depth).moved(x + board + inner / 2, 0, 0))
        use = not use if chance(rng, 0.85) else use
        x += float(shares[k])
    parts.append(block(wood, (width, depth, board), (0, 0, top)))
    x = -width / 2 + 0.03
    while x < width / 2 - 0.3:
        kind = choose(rng, ("box", "box", "suitcase", "hat", "folded", "none"))
        if kind == "none":
            x += 0.2
            continue
        if kind == "suitcase":
            thing = suitcase(rng, style, lying=True)
        elif kind == "hat":
            thing = hat(rng, style)
        elif kind == "folded":
            thing = folded(rng, style, 0.4, 0.4)
        else:
            maker_box = storage_box if chance(rng, 0.6) else cardboard
            thing = maker_box(rng, style, between(rng, 0.3, 0.45), 0.38, between(rng, 0.16, 0.28))
        if float(thing.size[0]) < width / 2 - x and float(thing.size[1]) < depth + 0.05:
            parts.append(thing.moved(x - float(thing.low[0]), 0.02, top + board))
        x += float(thing.size[0]) + 0.04
    return grounded(join(parts))


def low_shelf(
    rng: np.random.Generator, style: Style, width: float | None = None, height: float | None = None
) -> Mesh:
    """Draw a low open shelving unit holding folded clothes, shoes and boxes, or drawers.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, height
        Size in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    width = between(rng, 0.5, 1.0) if width is None else width
    height = between(rng, 0.65, 0.85) if height is None else height
    wood, depth = style.any_wood(rng), between(rng, 0.32, 0.42)
    parts = [block(wood, (width, depth, 0.02), (0, 0, height - 0.02), 0.003)]
    for side in (-1, 1):
        parts.append(block(wood, (0.018, depth, height - 0.02), (side * (width - 0.018) / 2, 0, 0)))
    parts.append(_shelves(rng, style, wood, width - 0.036, height - 0.02, depth))
    if chance(rng, 0.6):
        thing = (bag if chance(rng, 0.5) else hat)(rng, style)
        if float(thing.size[0]) < width:
            parts.append(thing.moved(0, 0.01, height))
    return grounded(join(parts))


def wall_board(rng: np.random.Generator, style: Style, width: float | None = None) -> Mesh:
    """Draw a high wall shelf holding boxes and folded clothes, with clothes on a rod below.

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
        A shelf with the hem of the longest garment at z = 0.
    """
    width = between(rng, 0.6, 1.0) if width is None else width
    wood, depth = style.any_wood(rng), 0.36
    parts = [
        block(wood, (width, depth, 0.02), (0, 0, 0), 0.003),
        on_shelf(rng, style, width - 0.02, 0.3, depth).moved(0, 0, 0.02),
    ]
    for side in (-1, 1):
        parts.append(block(style.metal, (0.02, depth - 0.04, 0.03), (side * (width / 2 - 0.05), 0, -0.03)))
    parts.append(
        tube([(-width / 2 + 0.02, 0.25, -0.07), (width / 2 - 0.02, 0.25, -0.07)], 0.013, 8).of(style.metal)
    )
    parts.append(hanging(rng, style, width - 0.06, between(rng, 0.85, 1.3), 0.8).moved(0, 0.25, -0.07))
    mesh = join(parts)
    return mesh.moved(0, -float(mesh.low[1]), -float(mesh.low[2]))


def shoe_rack(rng: np.random.Generator, style: Style, width: float | None = None) -> Mesh:
    """Draw a low rack with pairs of shoes.

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
        A mesh with its base at z = 0.
    """
    width = between(rng, 0.55, 0.9) if width is None else width
    wood, depth, rows = style.any_wood(rng), 0.32, int(rng.integers(2, 5))
    parts = []
    for side in (-1, 1):
        parts.append(block(wood, (0.02, depth, rows * 0.2 + 0.04), (side * (width / 2 - 0.01), 0, 0)))
    for row in range(rows):
        z = 0.06 + row * 0.2
        for k in range(5):
            parts.append(block(wood, (width - 0.04, 0.03, 0.012), (0, 0.02 + k * 0.06, z - 0.012)))
        x = -width / 2 + 0.16
        while x < width / 2 - 0.12:
            if chance(rng, 0.8):
                kind = choose(rng, ("shoe", "sneaker")) if row < rows - 1 else None
                parts.append(shoes(rng, style, kind).moved(x, 0.03, z))
            x += 0.25
    return grounded(join(parts))
