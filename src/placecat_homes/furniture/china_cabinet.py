"""China cabinets and Welsh dressers."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose, handle, legs
from placecat_homes.furniture.dishes import bottle, shelf_of_dishes, standing_plate, wine_glass
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import in_a_row
from placecat_homes.parts.outlines import frontal, textured
from placecat_homes.shapes import box
from placecat_homes.style import Style

PANE = Material(colour=(0.9, 0.95, 0.95), gloss=0.07, roughness=0.0, opacity=0.2)
SHADOW = Material(colour=(0.06, 0.05, 0.045))


def china_cabinet(rng: np.random.Generator, style: Style, *, width: float | None = None) -> Mesh:
    """Draw a tall cabinet with dishes and glasses behind glass doors or on open shelves.

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
        A cabinet 1.7 m to 2.1 m high.
    """
    w = width or between(rng, 0.8, 1.35)
    wood = style.any_wood(rng)
    kind = choose(rng, ("hutch", "dresser", "full"), (0.45, 0.2 + 0.2 * (1 - style.modern), 0.3))
    depth = between(rng, 0.4, 0.46)
    height = between(rng, 1.75, 2.08)
    china = palette.ceramic(rng)
    if kind == "full":
        lower = between(rng, 0.08, 0.14)
        upper_depth = depth
        shape = choose(rng, ("square", "tapered"))
        parts = [textured(legs(shape, w - 0.04, depth - 0.04, lower, wood, 0.05), quarter=True).moved(y=0.02)]
    else:
        lower = between(rng, 0.75, 0.9)
        upper_depth = depth - 0.1
        parts = [_base(style, wood, w, depth, lower)]
    inside = wood if chance(rng, 0.6) else palette.WHITE
    parts.append(
        _case(rng, style, wood, inside, china, w, upper_depth, lower, height, glazed=kind != "dresser")
    )
    if kind != "full" and chance(rng, 0.6):
        crown = box(w + 0.05, upper_depth + 0.03, 0.05, 0.015).moved(z=height - 0.01).of(wood)
        parts.append(crown)
        if style.modern < 0.4 and chance(rng, 0.5):
            points = [(-w / 2, 0), (w / 2, 0), (w / 2, 0.02), (0.2 * w, 0.05), (0, 0.11), (-0.2 * w, 0.05)]
            outline = [*points, (-w / 2, 0.02)]
            outline = [*outline[4:], *outline[:4]]
            parts.append(frontal(outline, 0.025).moved(0, upper_depth - 0.03, height + 0.035).of(wood))
    return join(parts)


def _base(style: Style, wood: Material, w: float, depth: float, height: float) -> Mesh:
    parts = [
        block(wood, (w - 0.03, depth - 0.04, 0.08)),
        box(w, depth - 0.02, height - 0.1, 0.003).moved(z=0.08).of(wood),
        box(w + 0.03, depth + 0.01, 0.03, 0.008).moved(z=height - 0.03).of(wood),
        block(SHADOW, (w - 0.05, 0.002, height - 0.14), (0, depth - 0.02, 0.1)),
    ]
    columns = 2 if w < 1.1 else 3
    each = (w - 0.04) / columns
    row = 0.15
    inner = height - 0.14
    face = depth - 0.02
    for k in range(columns):
        x = -w / 2 + 0.02 + each * (k + 0.5)
        drawer = box(each - 0.006, 0.018, row - 0.006, 0.003).of(wood)
        parts.append(drawer.moved(x, face, 0.1 + inner - row))
        parts.append(handle(style.handle, style.metal, 0.1).moved(x, face + 0.018, 0.1 + inner - row / 2))
        tall = inner - row - 0.004
        leaf = textured(box(each - 0.006, 0.018, tall, 0.003), quarter=True, v=0.2 * k).of(wood)
        panel = textured(box(each - 0.13, 0.028, tall - 0.13, 0.01), quarter=True, v=0.2 * k).of(wood)
        parts.append(join(leaf, panel.moved(z=0.065)).moved(x, face, 0.1))
        side = -1 if k % 2 else 1
        if style.handle != "none":
            grip = handle("knob", style.metal)
            parts.append(grip.moved(x - side * (each / 2 - 0.03), face + 0.018, 0.1 + tall * 0.6))
    return join(parts)


def _case(
    rng: np.random.Generator,
    style: Style,
    wood: Material,
    inside: Material,
    china: Material,
    w: float,
    depth: float,
    low: float,
    high: float,
    *,
    glazed: bool,
) -> Mesh:
    board = 0.022
    tall = high - low
    side = textured(box(board, depth, tall, 0.002), quarter=True).of(wood)
    parts = [
        side.moved(-(w - board) / 2, 0, low),
        side.moved((w - board) / 2, 0, low),
        block(inside, (w - 2 * board, 0.008, tall), (0, 0, low)),
        block(wood, (w, depth, board), (0, 0, high - board)),
        block(wood, (w - 2 * board, depth, board), (0, 0, low)),
    ]
    count = max(2, round(tall / between(rng, 0.3, 0.38)))
    pitch = (tall - board) / count
    for k in range(count):
        z = low + board + pitch * k
        if k:
            shelf = (
                Material((0.85, 0.92, 0.9), gloss=0.07, opacity=0.4) if glazed and chance(rng, 0.2) else wood
            )
            parts.append(block(shelf, (w - 2 * board, depth - 0.03, 0.012), (0, 0, z - 0.012)))
        parts.append(
            _row(rng, style, china, w - 2 * board - 0.03, depth - 0.05, pitch - 0.03).moved(0, 0.012, z)
        )
    if glazed:
        parts.append(_glass_doors(rng, style, wood, w, tall, low, depth))
    return join(parts)


def _row(
    rng: np.random.Generator, style: Style, china: Material, width: float, depth: float, height: float
) -> Mesh:
    kind = rng.random()
    if kind < 0.3 and height > 0.2:
        radius = min(0.13, height / 2.3)
        number = int(width / (2 * radius + 0.02))
        discs = [standing_plate(rng, style, radius=radius, china=china) for _ in range(number)]
        back = in_a_row(rng, discs, width)
        cups = shelf_of_dishes(rng, style, width=width, depth=depth * 0.45, height=height * 0.5, china=china)
        return join(back, cups.moved(y=depth * 0.5)) if chance(rng, 0.4) else back
    if kind < 0.5 and height > 0.24:
        number = int(width / 0.1)
        glasses = wine_glass(rng, style)
        return in_a_row(rng, [glasses] * number, width, depth=depth, gap=0.01)
    if kind < 0.58 and height > 0.36:
        return in_a_row(rng, [bottle(rng, style) for _ in range(int(width / 0.12))], width, depth=depth)
    return shelf_of_dishes(rng, style, width=width, depth=depth, height=height, china=china)


def _glass_doors(
    rng: np.random.Generator, style: Style, wood: Material, w: float, tall: float, low: float, depth: float
) -> Mesh:
    leaves = 2 if w < 1.15 else choose(rng, (2, 3))
    each = w / leaves
    rail = 0.05
    bars = choose(rng, (0, 1, 2)) if style.modern < 0.6 else 0
    parts = []
    for k in range(leaves):
        x = -w / 2 + each * (k + 0.5)
        stile = textured(box(rail, 0.02, tall - 0.006, 0.002), quarter=True).of(wood)
        beam = box(each - 0.006 - 2 * rail, 0.02, rail, 0.002).of(wood)
        leaf = [
            stile.moved(-(each - 0.006 - rail) / 2),
            stile.moved((each - 0.006 - rail) / 2),
            beam,
            beam.moved(z=tall - 0.006 - rail),
            block(PANE, (each - 0.006 - 2 * rail, 0.004, tall - 2 * rail), (0, 0.006, rail)),
        ]
        for bar in range(bars):
            z = rail + (tall - 2 * rail) * (bar + 1) / (bars + 1)
            leaf.append(block(wood, (each - 2 * rail, 0.014, 0.016), (0, 0.003, z)))
        if bars == 2:
            leaf.append(block(wood, (0.016, 0.014, tall - 2 * rail), (0, 0.003, rail)))
        side = -1 if k % 2 else 1
        kind = "knob" if style.handle != "bar" else "bar"
        grip = handle(kind, style.metal, 0.16)
        grip = grip.turned(90, "y") if kind == "bar" else grip
        leaf.append(grip.moved(-side * (each / 2 - 0.028), 0.02, tall * 0.45))
        parts.append(join(leaf).moved(x, depth, low + 0.003))
    return join(parts)
