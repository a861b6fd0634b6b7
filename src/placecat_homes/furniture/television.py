"""Televisions, television cabinets and audio equipment."""

from dataclasses import replace

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture import books
from placecat_homes.furniture.blocks import between, block, chance, choose, handle, legs, open_box
from placecat_homes.furniture.clutter import small_thing
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import box, cylinder, lathe, quad, tube
from placecat_homes.style import Style

CASE = Material((0.04, 0.04, 0.045), gloss=0.04, roughness=0.3)
LIGHT = Material((0.2, 0.9, 0.4), emission=1.5)


def _picture(rng: np.random.Generator, width: float, height: float) -> Material:
    return replace(palette.art(rng, width, height), gloss=0.04, emission=between(rng, 0.4, 0.9))


def _panel(rng: np.random.Generator, width: float, lit: bool) -> Mesh:
    """Draw a flat screen with its lower edge at z = 0."""
    height = width * 9 / 16
    rim = between(rng, 0.008, 0.025)
    screen = _picture(rng, width - 2 * rim, height - 2 * rim) if lit else palette.BLACK_GLASS
    case = CASE if chance(rng, 0.8) else Material((0.6, 0.6, 0.62), gloss=0.2)
    return join(
        block(case, (width, 0.035, height), (0, 0, 0), 0.006),
        block(case, (width * 0.6, 0.03, height * 0.5), (0, -0.02, height * 0.12)),
        quad(width - 2 * rim, height - 2 * rim).moved(0, 0.036, rim).of(screen),
    )


def television(
    rng: np.random.Generator, style: Style, width: float | None = None, lit: bool | None = None
) -> Mesh:
    """Draw a flat-screen television on its own stand, to be placed on a piece of furniture.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres; chosen at random if None.
    lit
        Whether it is on; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    width = between(rng, 0.75, 1.35) if width is None else width
    on = chance(rng, 0.3) if lit is None else lit
    parts = [_panel(rng, width, on).moved(0, 0.08, 0.07)]
    if chance(rng, 0.5):
        parts.append(block(CASE, (width * 0.4, 0.22, 0.015), (0, 0, 0), 0.004))
        parts.append(block(CASE, (0.08, 0.03, 0.1), (0, 0.085, 0.01)))
    else:
        for side in (-1, 1):
            x = side * width * 0.36
            parts.append(tube([(x, 0.0, 0.008), (x, 0.1, 0.09), (x, 0.22, 0.008)], 0.008, 6).of(CASE))
    return grounded(join(parts))


def wall_television(
    rng: np.random.Generator, style: Style, width: float | None = None, lit: bool | None = None
) -> Mesh:
    """Draw a wall-mounted flat-screen television.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres; chosen at random if None.
    lit
        Whether it is on; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh whose lowest point is at z = 0.
    """
    width = between(rng, 0.9, 1.5) if width is None else width
    return _panel(rng, width, chance(rng, 0.3) if lit is None else lit).moved(0, 0.03, 0)


def crt(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an old CRT television.

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
    width = between(rng, 0.5, 0.72)
    height, depth = width * 0.78, width * 0.72
    case = choose(rng, (CASE, Material((0.5, 0.5, 0.5)), palette.wood(rng)))
    w, h = width * 0.82, width * 0.6
    front = depth
    screen = (
        Material((0.09, 0.1, 0.1), gloss=0.07, roughness=0.1) if chance(rng, 0.7) else _picture(rng, w, h)
    )
    parts = [
        box(width, depth * 0.4, height, 0.02).moved(0, depth * 0.6, 0).of(case),
        box(width * 0.8, depth * 0.45, height * 0.8, 0.04).moved(0, depth * 0.2, height * 0.1).of(case),
        box(width * 0.5, depth * 0.3, height * 0.5, 0.04).moved(0, 0, height * 0.2).of(case),
        quad(w, h).moved(0, front + 0.003, height - h - width * 0.06).of(screen),
    ]
    for x in (-0.3, -0.2, 0.2, 0.3):
        parts.append(block(palette.METALS[1], (0.02, 0.006, 0.012), (x * width, front, 0.03)))
    if chance(rng, 0.35):
        for side in (-1, 1):
            tip = (side * 0.25, depth * 0.6, height + 0.45)
            parts.append(tube([(side * 0.02, depth * 0.6, height), tip], 0.003, 4).of(palette.METALS[0]))
    return join(parts)


def speaker(rng: np.random.Generator, style: Style, height: float | None = None) -> Mesh:
    """Draw a loudspeaker.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    height
        Height in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    height = between(rng, 0.25, 1.05) if height is None else height
    width = between(rng, 0.14, 0.2) if height < 0.5 else between(rng, 0.18, 0.24)
    depth = width * between(rng, 1.1, 1.5)
    case = choose(rng, (CASE, palette.wood(rng), palette.WHITE))
    cone = Material((0.12, 0.12, 0.13))
    parts = [box(width, depth, height, 0.004).of(case)]
    count = 2 if height < 0.6 else 3
    z = height - width * 0.35
    for k in range(count):
        r = width * (0.2 if k == 0 else 0.38)
        rim = lathe([(r, 0), (r, 0.008), (r * 0.85, 0.008), (r * 0.3, -0.004), (0, 0.006)], 16)
        parts.append(rim.turned(-90, "x").moved(0, depth, z).of(cone))
        z -= width * (0.75 if k == 0 else 0.9)
    return join(parts)


def stereo(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a low rack of hi-fi components, often with a turntable on top.

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
    wood = style.any_wood(rng)
    height, width, depth = between(rng, 0.55, 0.75), 0.52, 0.42
    parts = [open_box(wood, (width, depth, height), 0.02)]
    z = 0.02
    while z < height - 0.16:
        tall = between(rng, 0.08, 0.14)
        parts.append(_player(rng, 0.43, 0.34, tall).moved(0, 0.04, z))
        z += tall + 0.015
        parts.append(block(wood, (width - 0.04, depth, 0.012), (0, 0, z - 0.013)))
    if chance(rng, 0.7):
        base = block(choose(rng, (CASE, wood)), (0.44, 0.36, 0.09), (0, 0.03, height), 0.006)
        disc = cylinder(0.15, 0.01, 24, 0.002).moved(-0.04, 0.21, height + 0.09).of(palette.BLACK_GLASS)
        label = cylinder(0.05, 0.0115, 16, 0).moved(-0.04, 0.21, height + 0.09).of(palette.paint(rng))
        arm = tube(
            [(0.17, 0.08, height + 0.11), (0.15, 0.25, height + 0.11), (0.06, 0.29, height + 0.105)], 0.006, 6
        )
        parts += [base, disc, label, arm.of(palette.METALS[0])]
    return join(parts)


def _player(rng: np.random.Generator, width: float, depth: float, height: float) -> Mesh:
    case = CASE if chance(rng, 0.6) else palette.METALS[1]
    parts = [block(case, (width, depth, height), (0, 0, 0.01), 0.003)]
    parts.append(block(palette.BLACK_GLASS, (width * 0.4, 0.003, height * 0.4), (0, depth, height * 0.45)))
    parts.append(block(LIGHT, (width * 0.14, 0.003, height * 0.12), (0.03, depth + 0.002, height * 0.6)))
    knob = cylinder(min(height * 0.25, 0.025), 0.015, 12, 0.002).turned(-90, "x")
    for x in (-0.38, 0.38):
        parts.append(knob.moved(x * width, depth, height * 0.5 + 0.01).of(palette.METALS[1]))
    return join(parts)


def bench(rng: np.random.Generator, style: Style, width: float | None = None) -> Mesh:
    """Draw a low cabinet for a television, with open compartments, drawers and doors.

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
        A cabinet with its base at z = 0 and nothing above its top.
    """
    width = between(rng, 1.2, 2.0) if width is None else width
    depth, height, foot = between(rng, 0.38, 0.46), between(rng, 0.4, 0.56), between(rng, 0.04, 0.16)
    wood = style.any_wood(rng)
    front = choose(rng, (wood, wood, palette.paint(rng), palette.WHITE))
    inner = height - foot
    parts = [open_box(wood, (width, depth, inner), 0.022).moved(0, 0, foot)]
    kind = choose(rng, ("square", "tapered", "splayed", "sled"))
    parts.append(
        legs(kind, width - 0.1, depth - 0.06, foot, style.metal if kind == "sled" else wood, 0.045).moved(
            0, 0.03, 0
        )
    )
    cells = 3 if width > 1.4 else int(rng.integers(2, 4))
    each = (width - 0.044) / cells
    for k in range(cells):
        x = (k - (cells - 1) / 2) * each
        if k:
            parts.append(block(wood, (0.02, depth - 0.01, inner - 0.04), (x - each / 2, 0, foot + 0.02)))
        use = choose(rng, ("open", "drawers", "door"), (3 if k == cells // 2 else 1, 1, 1))
        if use == "open":
            middle = inner / 2 + foot
            parts.append(block(wood, (each - 0.02, depth - 0.02, 0.016), (x, 0, middle)))
            for z in (foot + 0.022, middle + 0.016):
                w, h = min(each - 0.06, 0.43), inner / 2 - 0.07
                if chance(rng, 0.65):
                    parts.append(
                        _player(rng, w, depth * 0.7, min(h, between(rng, 0.05, 0.1))).moved(
                            x, 0.05, z - 0.008
                        )
                    )
                elif chance(rng, 0.7):
                    parts.append(books.row(rng, w, h + 0.03, depth - 0.1).moved(x, 0, z))
            continue
        rows = 2 if use == "drawers" else 1
        tall = (inner - 0.044) / rows
        for row in range(rows):
            z = foot + 0.022 + row * tall
            parts.append(
                block(front, (each - 0.008, 0.018, tall - 0.006), (x, depth - 0.016, z + 0.003), 0.003)
            )
            parts.append(handle(style.handle, style.metal).moved(x, depth + 0.002, z + tall * 0.65))
    return grounded(join(parts))


def tv_bench(rng: np.random.Generator, style: Style, width: float | None = None, hung: bool = False) -> Mesh:
    """Draw a low cabinet with a television and other objects on and around it.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width of the cabinet in metres; chosen at random if None.
    hung
        Whether the television is on the wall above, in which case it is not drawn.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    old = style.modern < 0.35 and not hung and chance(rng, 0.45)
    low = bench(rng, style, width)
    top, broad, depth = float(low.high[2]), float(low.size[0]), float(low.size[1])
    parts = [low]
    if old:
        box_ = crt(rng, style)
        parts.append(box_.moved(0, max(0.0, depth - float(box_.size[1])) * 0.4, top))
        wide = float(box_.size[0])
    else:
        wide = min(broad * between(rng, 0.55, 0.8), 1.4)
        if hung:
            parts.append(block(CASE, (wide * 0.7, 0.09, 0.07), (0, depth * 0.4, top), 0.01))
        else:
            parts.append(television(rng, style, wide).moved(0, depth * 0.15, top))
    room = (broad - wide) / 2
    both = chance(rng, 0.35) and room > 0.18
    twin = speaker(rng, style, between(rng, 0.24, 0.36))
    for side in (-1, 1):
        x = side * (wide / 2 + room * 0.5)
        thing = twin if both else small_thing(rng, style, 0.4)
        if float(thing.size[0]) < room and (both or chance(rng, 0.7)):
            parts.append(thing.moved(x, max(depth - float(thing.size[1]), 0) * 0.4, top))
    return join(parts)
