"""Computers: screens, keyboards, mice, towers and laptops."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.furniture.desk import HEIGHT
from placecat_homes.materials import Material, Texture
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.forming import board
from placecat_homes.parts.outlines import frontal, loft, rectangle, ring, sideways
from placecat_homes.shapes import cylinder, lathe, quad, slab, superellipsoid, tube
from placecat_homes.style import Style

DARK = Material((0.03, 0.03, 0.035), gloss=0.03)
"""Black plastic."""


def monitor(rng: np.random.Generator, style: Style, *, case: Material | None = None) -> Mesh:
    """Draw a monitor on a stand, either a flat screen or an old CRT."""
    case = case or _case(rng)
    if chance(rng, 0.12 + 0.2 * (1 - style.modern)):
        return _tube_monitor(rng, case)
    return _flat_monitor(rng, case)


def keyboard(rng: np.random.Generator, style: Style, *, case: Material | None = None) -> Mesh:
    """Draw a keyboard, using a texture for the keys."""
    case = case or _case(rng)
    wide, deep = choose(rng, ((0.45, 0.155), (0.43, 0.14), (0.29, 0.125)))
    keys = palette.shade(case.colour, 0.95)
    wedge = sideways([(0, 0), (deep, 0), (deep, 0.012), (0, 0.026)], wide).of(case)
    texture = Texture("keys", (palette.shade(case.colour, 0.75), keys), (wide - 0.02, deep - 0.02), 1)
    top = slab(wide - 0.02, deep - 0.02).moved(y=-(deep - 0.02) / 2).turned(180)
    tilt = math.degrees(math.atan2(0.014, deep))
    return join(wedge, top.turned(-tilt, "x").moved(0, deep / 2, 0.0205).of(Material(texture=texture)))


def mouse(rng: np.random.Generator, style: Style, *, case: Material | None = None) -> Mesh:
    """Draw a mouse, often with a mouse pad and a cable running to the back of the desk."""
    case = case or _case(rng)
    parts = [superellipsoid(0.06, 0.105, 0.036, 0.8, 0.8, 12).moved(0, 0.12, 0.003).of(case)]
    if chance(rng, 0.6):
        pad = choose(rng, (Material((0.06, 0.07, 0.09)), palette.fabric(rng), palette.art(rng, 0.23, 0.19)))
        parts.append(board(0.23, 0.19, 0.004, 0.015, 3).moved(0, 0.02).of(pad))
    if chance(rng, 0.6):
        bend = between(rng, -0.05, 0.05)
        parts.append(tube([(0, 0.07, 0.012), (bend, 0.0, 0.006), (bend, -0.14, 0.004)], 0.0025, 4).of(DARK))
    return join(parts)


def tower(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw the case of a desktop computer."""
    case = _case(rng)
    wide, deep, high = between(rng, 0.17, 0.21), between(rng, 0.4, 0.48), between(rng, 0.36, 0.46)
    front = case if chance(rng, 0.5) else DARK
    parts = [
        block(case, (wide, deep - 0.02, high), bevel=0.004),
        block(front, (wide - 0.006, 0.02, high - 0.006), (0, deep - 0.02, 0.003), 0.004),
    ]
    trim = Material(palette.shade(front.colour, 0.7) if front is case else (0.2, 0.2, 0.21), gloss=0.03)
    for k in range(2):
        parts.append(block(trim, (0.15, 0.004, 0.04), (0, deep - 0.002, high - 0.07 - 0.05 * k)))
    parts.append(
        cylinder(0.012, 0.004, 10, 0)
        .turned(-90, "x")
        .moved(0, deep - 0.001, high * 0.55)
        .of(Material((0.2, 0.6, 1.0), emission=0.8))
    )
    for k in range(4):
        parts.append(block(DARK, (0.11, 0.003, 0.006), (0, deep - 0.001, 0.06 + 0.02 * k)))
    return join(parts)


def laptop(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an open laptop with a lit screen."""
    case = choose(rng, (Material((0.7, 0.71, 0.73), gloss=0.2, roughness=0.6), _case(rng), DARK))
    wide = between(rng, 0.31, 0.38)
    deep, high = wide * 0.68, wide * 0.64
    keys = palette.shade(case.colour, 0.5) if chance(rng, 0.4) else (0.06, 0.06, 0.06)
    texture = Texture("keys", (palette.shade(case.colour, 0.85), keys), (wide - 0.03, deep * 0.5), 2)
    top = slab(wide - 0.03, deep * 0.5).moved(y=-deep * 0.25).turned(180)
    open_at = between(rng, 12, 28)
    lid = join(
        frontal(rectangle(wide, high, 0.01, 2), 0.007).moved(0, -0.007, high / 2).of(case),
        block(DARK, (wide - 0.006, 0.001, high - 0.008), (0, 0, 0.004)),
        quad(wide - 0.025, high - 0.03).moved(0, 0.0015, 0.018).of(_desktop(rng, wide - 0.025, high - 0.03)),
    )
    return join(
        board(wide, deep, 0.018, 0.012, 3).moved(y=0.04).of(case),
        top.moved(0, 0.055 + deep * 0.25, 0.0185).of(Material(texture=texture)),
        slab(0.1, 0.06).moved(0, 0.05 + deep * 0.62, 0.0185).of(Material(palette.shade(case.colour, 0.8))),
        lid.turned(open_at, "x").moved(0, 0.045, 0.018),
    ).moved(y=max(0.0, high * math.sin(math.radians(open_at)) - 0.04))


def workstation(rng: np.random.Generator, style: Style, width: float = 1.4, depth: float = 0.7) -> Mesh:
    """Draw a computer on a desk, with monitors or a laptop, a keyboard, a mouse and cables.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width, depth
        Width and depth of the desk top in metres. Its surface is at z = 0.
    """
    case = _case(rng)
    alone = chance(rng, 0.18)
    parts: list[Mesh] = []
    middle = between(rng, -0.08, 0.08)
    if alone:
        turn = between(rng, -12, 12)
        parts.append(laptop(rng, style).turned(turn).moved(middle, depth * 0.3))
    else:
        screens = [monitor(rng, style, case=case)]
        wide = float(screens[0].size[0])
        if chance(rng, 0.35) and wide * 2 + 0.1 < width and float(screens[0].size[1]) < 0.3:
            screens.append(screens[0] if chance(rng, 0.6) else _flat_monitor(rng, case))
            second = float(screens[1].size[0])
            for screen, x, turn in (
                (screens[0], middle - wide / 2 - 0.005, 8.0),
                (screens[1], middle + second / 2 + 0.005, -8.0),
            ):
                parts.append(screen.turned(-turn).moved(x, 0.06))
        else:
            parts.append(screens[0].turned(between(rng, -10, 10)).moved(middle, 0.04))
            if chance(rng, 0.2) and width > 1.35:
                side = float(choose(rng, (-1, 1)))
                aside = laptop(rng, style).turned(25 * side)
                parts.append(aside.moved(middle + side * (wide / 2 + 0.2), 0.12))
    if not alone or chance(rng, 0.3):
        y = min(depth * 0.62, depth - 0.2)
        board_ = keyboard(rng, style, case=case if chance(rng, 0.7) else None)
        parts.append(board_.turned(between(rng, -5, 5)).moved(middle, y))
        right = -1 if chance(rng, 0.88) else 1
        x = middle + right * (float(board_.size[0]) / 2 + 0.13)
        parts.append(mouse(rng, style, case=case if chance(rng, 0.7) else None).moved(x, y - 0.04))
    parts.append(_cables(rng, middle))
    return join(parts)


def _case(rng: np.random.Generator) -> Material:
    kinds = (
        (0.05, 0.05, 0.055),
        (0.16, 0.17, 0.18),
        (0.6, 0.61, 0.63),
        (0.85, 0.85, 0.86),
        (0.78, 0.74, 0.64),
    )
    return Material(choose(rng, kinds, (4, 2, 2, 1.5, 1.5)), gloss=0.04, roughness=0.35)


def _desktop(rng: np.random.Generator, width: float, height: float) -> Material:
    if chance(rng, 0.1):
        return Material((0.02, 0.02, 0.025), gloss=0.05, roughness=0.1)
    colours = tuple(palette.colour(rng, 0.9, 0.2, 0.8) for _ in range(4))
    texture = Texture("desktop", colours, (width, height), int(rng.integers(1000)))
    return Material(texture=texture, gloss=0.03, roughness=0.15, emission=between(rng, 0.5, 1.0))


def _flat_monitor(rng: np.random.Generator, case: Material) -> Mesh:
    wide = between(rng, 0.4, 0.62)
    high = wide / choose(rng, (1.25, 1.6, 1.78), (1, 1, 2))
    rim = between(rng, 0.008, 0.025)
    low = between(rng, 0.09, 0.15)
    back = 0.11
    base = choose(rng, (0, 1))
    parts = [
        (
            cylinder(0.12, 0.014, 20).moved(0, 0.12) if base else board(0.24, 0.18, 0.014, 0.03).moved(y=0.03)
        ).of(case),
        block(case, (0.06, 0.03, low + high * 0.45), (0, back - 0.045, 0.01), 0.004),
    ]
    panel = join(
        frontal(rectangle(wide, high, 0.012, 2), 0.03).moved(0, 0, high / 2).of(case),
        block(case, (wide * 0.5, 0.03, high * 0.5), (0, -0.025, high * 0.25), 0.01),
        quad(wide - 2 * rim, high - 2 * rim - 0.01)
        .moved(0, 0.0312, rim + 0.01)
        .of(_desktop(rng, wide - 2 * rim, high - 2 * rim - 0.01)),
    )
    return join(*parts, panel.turned(between(rng, 0, 6), "x").moved(0, back, low))


def _tube_monitor(rng: np.random.Generator, case: Material) -> Mesh:
    wide = between(rng, 0.36, 0.44)
    high, deep = wide * 0.86, wide * 0.95
    rings = [
        ring(rectangle(wide * a, high * a, 0.02 + 0.04 * (1 - a), 3), deep * z)
        for a, z in ((0.01, 0.0), (0.5, 0.0), (0.62, 0.12), (0.93, 0.6), (1.0, 0.68), (1.0, 1.0))
    ]
    w, h = wide * 0.83, high * 0.75
    body = loft(rings).turned(-90, "x").moved(0, 0, high / 2).of(case)
    rim = block(case, (wide - 0.004, 0.01, high - 0.004), (0, deep - 0.011, 0.002), 0.004)
    glass = quad(w, h).moved(0, deep + 0.001, high * 0.14).of(_desktop(rng, w, h))
    foot = lathe([(0, 0), (0.13, 0), (0.12, 0.02), (0.06, 0.04), (0.06, 0.07), (0, 0.07)], 16)
    tilted = join(body, rim, glass).moved(0, -deep / 2).turned(3, "x").moved(0, deep / 2, 0.06)
    return join(foot.moved(0, deep * 0.55).of(case), tilted)


def _cables(rng: np.random.Generator, middle: float) -> Mesh:
    parts = []
    for _ in range(int(rng.integers(2, 5))):
        x = middle + between(rng, -0.1, 0.1)
        end = middle + between(rng, -0.35, 0.35)
        low = -HEIGHT + between(rng, 0.02, 0.25)
        line = [(x, 0.08, 0.12), (x, 0.02, 0.04), (x + (end - x) * 0.2, -0.005, -0.05)]
        sag = between(rng, 0.0, 0.15)
        line += [((x + end) / 2, 0.03, low / 2 - sag), (end, 0.06, low)]
        parts.append(tube(line, 0.003, 4))
    shade = between(rng, 0.03, 0.5) if chance(rng, 0.3) else 0.04
    return join(parts).of(Material((shade, shade, shade)))
