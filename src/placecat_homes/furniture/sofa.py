"""Sofas."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose, legs
from placecat_homes.furniture.cushions import scatter, seat, thrown, upright
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import box, sheet, superellipsoid, tube
from placecat_homes.style import Style


def cover(rng: np.random.Generator, style: Style) -> Material:
    """Choose an upholstery material."""
    kind = rng.random()
    if kind < 0.5:
        return palette.plain_fabric(rng)
    if kind < 0.72:
        return palette.leather(rng)
    return style.any_fabric(rng)


def sofa(rng: np.random.Generator, style: Style, seats: int | None = None) -> Mesh:
    """Draw a straight sofa in a boxy, rolled-arm, buttoned or framed design.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    seats
        Number of seats, 1 to 4; 2 or 3 if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    seats = int(choose(rng, (2, 3, 3))) if seats is None else seats
    modern = style.modern
    design = choose(rng, (boxy, rolled, buttoned, framed), (2 + modern, 2.4 - 1.5 * modern, 0.8, 1.2))
    return grounded(design(rng, style, seats))


def _dressed(
    rng: np.random.Generator, style: Style, width: float, seats: int, at: tuple[float, float]
) -> Mesh:
    """Draw loose pillows. The seat meets the back at `at` (y, z)."""
    parts = []
    if seats > 1 or chance(rng, 0.5):
        parts.append(scatter(rng, style, width, None if seats > 1 else 1).moved(0, at[0], at[1]))
    return join(parts)


def _feet(rng: np.random.Generator, style: Style, width: float, depth: float, height: float) -> Mesh:
    kind = choose(rng, ("square", "tapered", "round", "splayed", "sled"))
    skin = style.metal if kind == "sled" or chance(rng, 0.25) else style.any_wood(rng)
    return legs(kind, width - 0.06, depth - 0.06, height, skin, between(rng, 0.035, 0.06)).moved(0, 0.03, 0)


def boxy(rng: np.random.Generator, style: Style, seats: int) -> Mesh:
    """Draw a sofa with straight arms and loose cushions."""
    skin = cover(rng, style)
    each, arm = between(rng, 0.58, 0.76), between(rng, 0.1, 0.26)
    inner, depth = each * seats, between(rng, 0.85, 1.0)
    width, foot = inner + 2 * arm, between(rng, 0.04, 0.16)
    top, arms, tall = between(rng, 0.41, 0.46), between(rng, 0.54, 0.68), between(rng, 0.68, 0.86)
    back, soft = between(rng, 0.12, 0.2), between(rng, 0.15, 0.35)
    thick = between(rng, 0.13, 0.18)
    parts = [
        _feet(rng, style, width, depth, foot + 0.01),
        box(inner, depth - 0.02, top - thick - foot, 0.02).moved(0, 0, foot).of(skin),
        box(inner + 0.02, back, tall - foot, 0.035).moved(0, 0, foot).of(skin),
    ]
    for side in (-1, 1):
        x = side * (inner + arm) / 2
        parts.append(box(arm, depth, arms - foot, min(0.04, arm * 0.3)).moved(x, 0, foot).of(skin))
    rise = between(rng, 0.38, 0.48)
    one = chance(rng, 0.2)
    for k in range(1 if one else seats):
        wide = inner if one else each
        x = 0.0 if one else (k - (seats - 1) / 2) * each
        parts.append(
            seat(wide - 0.005, depth - back + 0.01, thick + 0.01, soft).moved(x, back, top - thick).of(skin)
        )
        cushion = upright(wide - 0.01, between(rng, 0.16, 0.22), rise, soft + 0.1).turned(10, "x")
        parts.append(cushion.moved(x, back + 0.04, top - 0.02).of(skin))
    parts.append(_dressed(rng, style, inner, seats, (back + 0.2, top)))
    if chance(rng, 0.3):
        over = [
            (depth * 0.5, top + 0.01),
            (back + 0.24, top + 0.01),
            (back + 0.1, top + rise),
            (0.0, max(tall, top + rise) + 0.01),
            (-0.01, tall - 0.2),
        ]
        off = choose(rng, (-1, 1)) * inner / 4
        parts.append(thrown(over[::-1], 0.55, style.any_fabric(rng)).moved(off))
    return join(parts)


def rolled(rng: np.random.Generator, style: Style, seats: int) -> Mesh:
    """Draw an old-fashioned sofa with rolled arms and a rounded back."""
    skin = cover(rng, style)
    each, arm = between(rng, 0.55, 0.68), between(rng, 0.16, 0.22)
    inner, depth = each * seats, between(rng, 0.85, 0.95)
    width = inner + 2 * arm
    top, arms, tall, back = 0.45, between(rng, 0.58, 0.66), between(rng, 0.85, 0.98), 0.2
    skirt = chance(rng, 0.4)
    foot = 0.01 if skirt else 0.1
    parts = [box(width - 0.06, depth - 0.04, top - 0.15 - foot, 0.02).moved(0, 0.01, foot).of(skin)]
    if not skirt:
        parts.append(_feet(rng, style, width, depth, foot + 0.01))
    hump = between(rng, 0.04, 0.14)
    n = 12
    for k in range(n):
        x = (k + 0.5 - n / 2) * inner / n
        rise = tall - top + 0.1 - hump * (2 * x / inner) ** 2
        parts.append(box(inner / n + 0.002, back, rise, 0).moved(x, 0, top - 0.1).of(skin))
    ridge = [
        (x, back / 2 - 0.01, tall - hump * (2 * x / inner) ** 2 - 0.01)
        for x in np.linspace(-inner / 2, inner / 2, 13)
    ]
    parts.append(tube([(float(x), y, float(z)) for x, y, z in ridge], back / 2 + 0.012, 12).of(skin))
    for side in (-1, 1):
        x = side * (inner / 2 + arm / 2 - 0.01)
        parts.append(box(arm - 0.04, depth - 0.06, arms - foot - 0.06, 0.02).moved(x, 0.02, foot).of(skin))
        roll = tube(
            [(x + side * 0.02, 0.02, arms - arm * 0.4), (x + side * 0.02, depth - 0.01, arms - arm * 0.4)],
            arm * 0.56,
            14,
        )
        parts.append(roll.of(skin))
        button = superellipsoid(arm * 0.7, 0.03, arm * 0.7, 1, 1, 10)
        parts.append(button.moved(x + side * 0.02, depth - 0.01, arms - arm * 0.75).of(skin))
    for k in range(seats):
        x = (k - (seats - 1) / 2) * each
        parts.append(seat(each - 0.004, depth - back, 0.19, 0.4).moved(x, back - 0.01, top - 0.16).of(skin))
        if hump < 0.09:
            cushion = upright(each - 0.02, 0.2, tall - top - 0.02, 0.5).turned(9, "x")
            parts.append(cushion.moved(x, back + 0.02, top).of(skin))
    away = 0.2 if hump < 0.09 else 0.0
    parts.append(_dressed(rng, style, inner, seats, (back + away, top + 0.01)))
    if chance(rng, 0.3):
        white = Material((0.92, 0.9, 0.85))
        cloth = [
            (-0.012, tall - 0.2),
            (-0.012, tall + 0.02),
            (back + 0.02, tall + 0.02),
            (back + 0.05 + away * 0.8, tall - 0.2),
        ]
        for k in range(seats):
            parts.append(thrown(cloth, 0.4, white, 0.016).moved((k - (seats - 1) / 2) * each))
    return join(parts)


def buttoned(rng: np.random.Generator, style: Style, seats: int) -> Mesh:
    """Draw a chesterfield with rolled arms as high as the buttoned back."""
    skin = palette.leather(rng) if chance(rng, 0.65) else palette.plain_fabric(rng)
    each, arm = between(rng, 0.55, 0.66), 0.2
    inner, depth, top, tall, back = (
        each * seats,
        between(rng, 0.88, 0.96),
        0.44,
        between(rng, 0.7, 0.78),
        0.24,
    )
    width, foot = inner + 2 * arm, 0.09
    parts = [
        legs("turned", width - 0.1, depth - 0.1, foot + 0.01, style.any_wood(rng), 0.08).moved(0, 0.05, 0),
        box(width - 0.05, depth - 0.03, top - 0.14 - foot, 0.02).moved(0, 0, foot).of(skin),
        box(width - 0.1, back - 0.05, tall - foot - 0.06, 0.03).moved(0, 0.03, foot).of(skin),
        tube([(-width / 2 + 0.08, 0.1, tall - 0.08), (width / 2 - 0.08, 0.1, tall - 0.08)], 0.1, 14).of(skin),
    ]
    for side in (-1, 1):
        x = side * (inner + arm) / 2
        parts.append(box(arm - 0.05, depth - 0.05, tall - foot - 0.08, 0.03).moved(x, 0.02, foot).of(skin))
        roll = [(x, 0.05, tall - 0.08), (x, depth - 0.02, tall - 0.08)]
        parts.append(tube(roll, 0.1, 14).of(skin))
        disc = superellipsoid(0.15, 0.03, 0.15, 1, 1, 12).moved(x, depth - 0.02, tall - 0.155)
        parts.append(disc.of(skin))
    for k in range(seats):
        x = (k - (seats - 1) / 2) * each
        parts.append(
            seat(each - 0.004, depth - back + 0.02, 0.16, 0.25).moved(x, back - 0.02, top - 0.14).of(skin)
        )
    # The buttons pull the padding in, so the back is drawn as a wavy sheet with small knobs.
    columns, pitch = round(inner / 0.14), inner / round(inner / 0.14)

    def padding(s: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, ...]:
        # t runs from right to left and s runs upwards, so the surface faces forwards.
        x = (0.5 - t) * inner
        z = top + s * (tall - top - 0.06)
        wave = np.abs(np.sin(math.pi * (x / pitch + s * 2))) * np.abs(np.sin(math.pi * (x / pitch - s * 2)))
        return x, back - 0.04 + 0.03 * wave, z

    parts.append(sheet(padding, 12, columns * 4, (tall - top, inner)).of(skin))
    knob = superellipsoid(0.022, 0.012, 0.022, 1, 1, 6).of(skin)
    for row in range(3):
        z = top + (row + 0.5) / 3 * (tall - top - 0.06) - 0.011
        for k in range(columns):
            x = (k + 0.5 - columns / 2) * pitch + (pitch / 2 if row % 2 else 0)
            if abs(x) < inner / 2 - 0.03:
                parts.append(knob.moved(x, back - 0.018, z))
    parts.append(_dressed(rng, style, inner, seats, (back, top + 0.01)))
    return join(parts)


def framed(rng: np.random.Generator, style: Style, seats: int) -> Mesh:
    """Draw a lightweight sofa on a wooden or metal frame with splayed legs."""
    skin, frame = cover(rng, style), style.any_wood(rng)
    each, depth = between(rng, 0.56, 0.66), between(rng, 0.76, 0.86)
    inner = each * seats
    rail, top, tall, thick = (
        0.045,
        between(rng, 0.42, 0.45),
        between(rng, 0.74, 0.86),
        between(rng, 0.11, 0.15),
    )
    bench, width = top - thick, inner + 0.1
    parts = [
        legs("splayed", width, depth - 0.06, bench, frame, 0.05).moved(0, 0.04, 0),
        block(frame, (width, depth - 0.04, rail), (0, 0.02, bench - rail + 0.005), 0.01),
    ]
    arms = between(rng, 0.56, 0.62)
    for side in (-1, 1):
        x = side * (width / 2 - 0.025)
        parts.append(block(frame, (0.06, depth * 0.78, 0.03), (x, 0.05, arms), 0.012))
        for y in (0.08, depth * 0.72):
            parts.append(block(frame, (0.035, 0.04, arms - bench + 0.01), (x, y, bench), 0.006))
    for z in np.linspace(bench + 0.15, tall - 0.1, 3):
        parts.append(block(frame, (width - 0.04, 0.02, 0.05), (0, 0.03, float(z)), 0.006))
    for k in range(seats):
        x = (k - (seats - 1) / 2) * each
        parts.append(seat(each - 0.006, depth - 0.16, thick, 0.2).moved(x, 0.12, bench + 0.003).of(skin))
        cushion = upright(each - 0.01, between(rng, 0.12, 0.15), tall - top + 0.04, 0.3).turned(8, "x")
        parts.append(cushion.moved(x, 0.11, top - 0.03).of(skin))
    parts.append(_dressed(rng, style, inner, seats, (0.26, top)))
    return join(parts)


def corner_sofa(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a corner sofa with a chaise longue at one end.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.

    Returns
    -------
    Mesh
        An L-shaped sofa standing on z = 0.
    """
    skin = cover(rng, style)
    seats, each, arm = int(rng.integers(2, 4)), between(rng, 0.66, 0.8), between(rng, 0.12, 0.24)
    long, depth, back = between(rng, 1.45, 1.75), between(rng, 0.88, 0.98), 0.18
    lounge = between(rng, 0.75, 0.9)
    top, tall, thick, foot = between(rng, 0.41, 0.45), between(rng, 0.7, 0.84), 0.16, between(rng, 0.05, 0.13)
    soft, rise = between(rng, 0.15, 0.35), between(rng, 0.36, 0.46)
    inner = seats * each + lounge
    width = inner + 2 * arm
    right = inner / 2
    parts = [
        legs("square", width - 0.1, depth - 0.1, foot + 0.01, style.any_wood(rng), 0.05).moved(0, 0.05, 0),
        legs("square", lounge - 0.08, 0.4, foot + 0.01, style.any_wood(rng), 0.05).moved(
            right - lounge / 2, long - 0.45, 0
        ),
        box(inner, depth - 0.02, top - thick - foot, 0.02).moved(0, 0, foot).of(skin),
        box(lounge, long - 0.01, top - thick - foot, 0.02).moved(right - lounge / 2, 0, foot).of(skin),
        box(inner + 2 * arm, back, tall - foot, 0.035).moved(0, 0, foot).of(skin),
        box(arm, depth, between(rng, 0.54, 0.66) - foot, 0.035).moved(-right - arm / 2, 0, foot).of(skin),
    ]
    both = chance(rng, 0.5)
    reach = long if both else depth
    parts.append(
        box(arm, reach, (tall if both else 0.6) - foot, 0.035).moved(right + arm / 2, 0, foot).of(skin)
    )
    for k in range(seats):
        x = -right + (k + 0.5) * each
        parts.append(
            seat(each - 0.005, depth - back + 0.01, thick + 0.01, soft).moved(x, back, top - thick).of(skin)
        )
        cushion = upright(each - 0.01, 0.19, rise, soft + 0.1).turned(10, "x")
        parts.append(cushion.moved(x, back + 0.04, top - 0.02).of(skin))
    x = right - lounge / 2
    parts.append(seat(lounge - 0.005, long - back, thick + 0.01, soft).moved(x, back, top - thick).of(skin))
    parts.append(
        upright(lounge - 0.01, 0.19, rise, soft + 0.1)
        .turned(10, "x")
        .moved(x, back + 0.04, top - 0.02)
        .of(skin)
    )
    if both:
        cushion = upright((long - depth) * 1.1, 0.18, rise * 0.9, soft + 0.1).turned(10, "x").turned(90)
        parts.append(cushion.moved(right - 0.02, depth + 0.1, top - 0.02).of(skin))
    parts.append(scatter(rng, style, inner - 0.1).moved(0, back + 0.2, top))
    if chance(rng, 0.4):
        y = between(rng, long - 0.6, long - 0.3)
        over = thrown([(-0.3, 0.0), (0.3, 0.0)], lounge, style.any_fabric(rng)).moved(x, y, top + 0.005)
        parts.append(over)
    mesh = join(parts)
    return mesh if chance(rng, 0.5) else mesh.mirrored()


def footstool(rng: np.random.Generator, style: Style, skin: Material | None = None) -> Mesh:
    """Draw a padded footstool.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    skin
        Material of the cover; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    skin = cover(rng, style) if skin is None else skin
    width, depth, height = between(rng, 0.45, 0.8), between(rng, 0.42, 0.6), between(rng, 0.36, 0.44)
    if chance(rng, 0.3):
        ball = superellipsoid(width, width, height, 0.5, 1, 18).moved(0, width / 2)
        return ball.of(skin)
    foot = between(rng, 0.06, 0.2)
    return join(
        _feet(rng, style, width, depth, foot + 0.01),
        box(width, depth, height - foot - 0.08, 0.015).moved(0, 0, foot).of(skin),
        seat(width, depth, 0.12, 0.25).moved(0, 0, height - 0.12).of(skin),
    )
