"""Sideboards and the objects on them."""

from collections.abc import Callable

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose, handle, legs
from placecat_homes.furniture.books import stack
from placecat_homes.furniture.dishes import bottle, jug, plates, standing_plate, teapot
from placecat_homes.furniture.food import fruit_bowl
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.table_lamp import table_lamp
from placecat_homes.furniture.table_setting import candlestick
from placecat_homes.furniture.vase import figure, vase
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import in_a_row
from placecat_homes.parts.outlines import textured
from placecat_homes.shapes import box
from placecat_homes.style import Style

SHADOW = Material(colour=(0.06, 0.05, 0.045))


def sideboard(
    rng: np.random.Generator, style: Style, *, width: float | None = None, decorated: bool = True
) -> Mesh:
    """Draw a sideboard with doors, drawers, and objects on top.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres; chosen at random if None.
    decorated
        Whether to put objects on top.

    Returns
    -------
    Mesh
        A sideboard 0.75 m to 0.95 m high, not counting the objects on top.
    """
    w = width or between(rng, 1.1, 1.9)
    depth, height = between(rng, 0.4, 0.48), between(rng, 0.72, 0.92)
    wood = style.any_wood(rng)
    fronts = wood if chance(rng, 0.7) else style.any_wood(rng)
    foot = choose(rng, (0.06, 0.12, 0.2))
    body = height - foot
    frame = 0.02
    parts: list[Mesh] = []
    if foot < 0.1:
        parts.append(block(wood, (w - 0.04, depth - 0.04, foot), (0, 0.01, 0)))
    else:
        old, new = 1 - style.modern, style.modern
        kind = choose(rng, ("tapered", "square", "turned", "sled"), (0.4, 0.3, 0.4 * old, 0.4 * new))
        material = style.metal if kind == "sled" else wood
        shape = legs(kind, w - 0.06, depth - 0.04, foot, material, 0.05)
        parts.append(textured(shape, quarter=True).moved(y=0.02))
    parts.append(box(w, depth - 0.02, body, 0.003).moved(z=foot).of(wood))
    parts.append(box(w + 0.02, depth + 0.012, 0.025, 0.006).moved(z=height - 0.012).of(wood))
    columns = max(2, round(w / between(rng, 0.42, 0.55)))
    each = (w - 2 * frame) / columns
    inner = body - 2 * frame
    row = between(rng, 0.13, 0.17) if chance(rng, 0.6) else 0.0
    drawers_at = int(rng.integers(columns)) if row == 0 else -1
    face = depth - 0.02
    low = foot + frame
    parts.append(block(SHADOW, (w - 2 * frame, 0.002, inner), (0, face, low)))
    framed = style.modern < 0.5 and chance(rng, 0.7)
    for k in range(columns):
        x = -w / 2 + frame + each * (k + 0.5)
        if row:
            parts.append(_face(style, fronts, each, row, False).moved(x, face, low + inner - row))
        if k == drawers_at:
            for z in range(3):
                tall = (inner - row) / 3
                parts.append(_face(style, fronts, each, tall, False).moved(x, face, low + z * tall))
            continue
        side = -1 if k % 2 else 1
        leaf = _face(style, fronts, each, inner - row, True, side, framed)
        parts.append(leaf.moved(x, face, low))
    if decorated:
        parts.append(decoration(rng, style, width=w - 0.1, depth=depth - 0.06).moved(0, 0.03, height + 0.013))
    return join(parts)


def _face(
    style: Style,
    material: Material,
    width: float,
    height: float,
    door: bool,
    side: int = 1,
    framed: bool = False,
) -> Mesh:
    w, h = width - 0.004, height - 0.004
    leaf = textured(box(w, 0.018, h, 0.003), quarter=door, v=width).moved(z=0.002).of(material)
    parts = [leaf]
    if framed and min(w, h) > 0.2:
        parts.append(textured(box(w - 0.12, 0.03, h - 0.12, 0.012), quarter=True).moved(z=0.062).of(material))
    kind = "knob" if door and style.handle == "bar" else style.handle
    grip = handle(kind, style.metal, min(0.12, 0.5 * w))
    if kind != "none":
        place = (-side * (w / 2 - 0.03), 0.018, h * 0.55) if door else (0.0, 0.018, h / 2)
        parts.append(grip.moved(*place))
    return join(parts)


def decoration(rng: np.random.Generator, style: Style, *, width: float = 1.2, depth: float = 0.35) -> Mesh:
    """Draw a row of objects for the top of a sideboard whose back is at y = 0."""
    makers: tuple[Callable[[np.random.Generator, Style], Mesh], ...] = (
        vase,
        _lamp,
        candlestick,
        fruit_bowl,
        _small_plant,
        standing_plate,
        bottle,
        jug,
        teapot,
        plates,
        figure,
        _books,
    )
    weights = np.array([2, 1, 1.5, 1.2, 1, 1, 1.2, 0.8, 0.8, 0.7, 0.8, 0.7])
    things: list[Mesh] = []
    filled = 0.0
    aim = width * between(rng, 0.3, 0.75)
    for k in rng.choice(len(makers), 8, p=weights / weights.sum(), replace=False):
        thing = makers[int(k)](rng, style)
        if float(thing.size[1]) <= depth and filled < aim:
            things.append(thing)
            filled += float(thing.size[0]) + 0.04
    return in_a_row(rng, things, width, depth=depth, gap=0.03)


def _lamp(rng: np.random.Generator, style: Style) -> Mesh:
    return table_lamp(rng, style)


def _small_plant(rng: np.random.Generator, style: Style) -> Mesh:
    return plant(rng, style, between(rng, 0.25, 0.4))


def _books(rng: np.random.Generator, style: Style) -> Mesh:
    return stack(rng)
