"""Bedside tables and the objects on them."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.books import stack
from placecat_homes.furniture.table_lamp import table_lamp
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.parts.fittings import FRONTS, fronts
from placecat_homes.parts.lofts import plate, rounded
from placecat_homes.parts.toiletries import GLASS, jar
from placecat_homes.shapes import box, cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style


def alarm_clock(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an alarm clock with two bells or glowing digits."""
    body = palette.plastic(rng)
    if rng.random() < 0.5:
        digits = Material((0.95, 0.15, 0.1) if rng.random() < 0.6 else (0.2, 0.9, 0.5), emission=0.8)
        bars = [
            box(0.012, 0.001, 0.028, bevel=0.0).moved(x, 0.071, 0.02).of(digits)
            for x in (-0.035, -0.012, 0.014, 0.037)
        ]
        return join(
            box(0.14, 0.07, 0.07, bevel=0.01).of(body),
            box(0.12, 0.002, 0.045, bevel=0.0).moved(0, 0.069, 0.012).of(palette.BLACK_GLASS),
            bars,
        )
    case = cylinder(0.05, 0.045, 18).turned(-90, "x").moved(0, 0.01, 0.065)
    return join(
        case.of(body),
        cylinder(0.043, 0.002, 18, bevel=0.0).turned(-90, "x").moved(0, 0.055, 0.065).of(palette.WHITE),
        box(0.004, 0.001, 0.03, bevel=0.0).moved(0, 0.057, 0.065).of(palette.RUBBER),
        box(0.024, 0.001, 0.004, bevel=0.0).moved(-0.012, 0.057, 0.063).of(palette.RUBBER),
        [
            superellipsoid(0.035, 0.035, 0.03, 1, 1, 8).moved(x, 0.03, 0.112).of(style.metal)
            for x in (-0.025, 0.025)
        ],
        [tube([(x, 0.03, 0.03), (x * 1.5, 0.03, 0)], 0.005, 5).of(style.metal) for x in (-0.025, 0.025)],
    )


def _glass(rng: np.random.Generator) -> Mesh:
    profile = [(0, 0), (0.028, 0), (0.034, 0.12), (0.031, 0.12), (0.026, 0.008), (0, 0.008)]
    return lathe(profile, 12).of(GLASS)


def _tops(rng: np.random.Generator, style: Style, width: float, depth: float, height: float) -> Mesh:
    """Arrange a lamp, books, a clock and a glass on a table top without letting them overlap."""
    parts = []
    side = float(rng.choice((-1, 1)))
    if rng.random() < 0.85:
        lamp = table_lamp(rng, style)
        lamp = lamp.scaled(min(1.0, 0.27 / float(max(lamp.size[0], lamp.size[1])), 0.5 / float(lamp.size[2])))
        middle = (lamp.low + lamp.high) / 2
        x = side * max(0.0, min(width * 0.2, width / 2 - 0.14))
        parts.append(lamp.moved(x - float(middle[0]), 0.14 - float(middle[1]), height))
    free = -side * (width / 2 - 0.09)
    choice = rng.random()
    if choice < 0.55:
        pile = stack(rng, int(rng.integers(1, 4)))
        pile = pile.scaled(0.85).turned(rng.uniform(-20, 20))
        middle = (pile.low + pile.high) / 2
        parts.append(pile.moved(free * 0.75 - float(middle[0]), depth - 0.13 - float(middle[1]), height))
        if rng.random() < 0.4:
            parts.append(
                alarm_clock(rng, style).scaled(0.9).moved(side * (width / 2 - 0.1), depth - 0.13, height)
            )
    else:
        parts.append(alarm_clock(rng, style).turned(rng.uniform(-20, 20)).moved(free, depth - 0.16, height))
        if rng.random() < 0.6:
            parts.append(_glass(rng).moved(side * (width / 2 - 0.07), depth - 0.07, height))
        elif rng.random() < 0.5:
            parts.append(jar(rng).moved(side * (width / 2 - 0.07), depth - 0.07, height))
    return join(parts)


def nightstand(rng: np.random.Generator, style: Style, *, seed: int | None = None) -> Mesh:
    """Draw a bedside table with a lamp, books and an alarm clock.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    seed
        Seed for the design, so that the tables on either side of a bed can match; random if None.

    Returns
    -------
    Mesh
        A table 0.4 to 0.65 m high.
    """
    plan = rng if seed is None else np.random.default_rng(seed)
    width, depth, height = plan.uniform(0.38, 0.55), plan.uniform(0.34, 0.42), plan.uniform(0.42, 0.62)
    material = (style.wood, style.second_wood, style.fronts, style.any_wood(plan))[int(plan.integers(4))]
    design = "flat" if style.modern > 0.5 else str(plan.choice(FRONTS[:3]))
    kind = str(plan.choice(("chest", "legs", "round", "cube"), p=(0.35, 0.35, 0.15, 0.15)))
    parts: list[Mesh] = []
    if kind == "chest":
        parts += [
            box(width, depth, height - 0.07, bevel=0.003).moved(z=0.05).of(material),
            box(width + 0.02, depth + 0.03, 0.02, bevel=0.004).moved(z=height - 0.02).of(material),
            box(width - 0.04, depth - 0.03, 0.05, bevel=0.0).of(material),
            fronts(
                width,
                height - 0.07,
                material,
                style.metal,
                rows=int(plan.integers(2, 4)),
                design=design,
                grip=style.handle,
            ).moved(0, depth, 0.05),
        ]
    elif kind == "legs":
        drawer = 0.16
        parts += [
            box(width, depth, drawer, bevel=0.003).moved(z=height - drawer).of(material),
            fronts(width, drawer - 0.02, material, style.metal, design="flat", grip=style.handle).moved(
                0, depth, height - drawer + 0.005
            ),
        ]
        slant = plan.uniform(0, 0.05)
        for x in (-width / 2 + 0.03, width / 2 - 0.03):
            for y in (0.03, depth - 0.03):
                out = slant if x > 0 else -slant
                parts.append(tube([(x + out * 0.4, y, 0), (x, y, height - drawer)], 0.016, 8).of(material))
        if plan.random() < 0.5:
            parts.append(box(width - 0.06, depth - 0.06, 0.018, bevel=0.0).moved(0, 0.03, 0.14).of(material))
    elif kind == "round":
        radius = plan.uniform(0.2, 0.25)
        width, depth = radius * 1.8, radius * 1.8
        disc = rounded(2 * radius, 2 * radius, (radius, radius), points=8)
        top = palette.stone(plan) if plan.random() < 0.4 else material
        parts += [
            plate(disc, 0.022).moved(z=height - 0.022).of(top),
            plate(disc * 0.6, 0.02).moved(0, radius * 0.4, 0).of(style.metal),
            cylinder(0.018, height - 0.03, 10).moved(0, radius, 0.01).of(style.metal),
        ]
    else:
        thick = 0.02
        parts += [
            box(width, depth, thick, bevel=0.002).moved(z=z).of(material)
            for z in (0.0, height / 2, height - thick)
        ]
        parts += [
            box(thick, depth, height, bevel=0.0).moved(x).of(material)
            for x in (-width / 2 + 0.01, width / 2 - 0.01)
        ]
        parts.append(box(width, 0.01, height, bevel=0.0).of(material))
        pile = stack(rng, 3).scaled(0.9)
        middle = (pile.low + pile.high) / 2
        parts.append(pile.moved(-float(middle[0]), depth / 2 - float(middle[1]), thick))
    parts.append(_tops(rng, style, width, depth, height))
    return grounded(parts)
