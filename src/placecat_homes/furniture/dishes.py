"""Plates, cups, glasses and bottles."""

from dataclasses import replace

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Colour, Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded, in_a_row
from placecat_homes.shapes import box, cylinder, lathe, tube
from placecat_homes.style import Style

CLEAR = Material(colour=(0.93, 0.96, 0.96), gloss=0.08, roughness=0.05, opacity=0.22)
KINDS = ("plates", "cup", "glass", "bowls", "tea_cup", "wine_glass", "bowl", "cup", "jug", "teapot")
BOTTLES: tuple[Colour, ...] = (
    (0.1, 0.25, 0.12),
    (0.3, 0.16, 0.06),
    (0.75, 0.85, 0.85),
    (0.55, 0.1, 0.08),
    (0.85, 0.65, 0.15),
    (0.12, 0.14, 0.3),
)


def _china(rng: np.random.Generator) -> Material:
    return palette.ceramic(rng) if rng.random() < 0.75 else replace(palette.plastic(rng), gloss=0.05)


def _plate(radius: float, china: Material, segments: int = 16) -> Mesh:
    rise = 0.1 * radius + 0.008
    return lathe(
        [
            (0, 0),
            (0.55 * radius, 0),
            (0.7 * radius, 0.004),
            (radius, rise),
            (0.99 * radius, rise + 0.003),
            (0.68 * radius, 0.008),
            (0, 0.006),
        ],
        segments,
    ).of(china)


def plate(
    rng: np.random.Generator, style: Style, *, radius: float | None = None, china: Material | None = None
) -> Mesh:
    """Draw a flat plate."""
    return grounded(_plate(radius or float(rng.uniform(0.1, 0.14)), china or _china(rng)))


def plates(
    rng: np.random.Generator,
    style: Style,
    *,
    count: int | None = None,
    radius: float | None = None,
    china: Material | None = None,
) -> Mesh:
    """Draw a stack of plates."""
    material = china or _china(rng)
    size = radius or float(rng.uniform(0.09, 0.135))
    number = count or int(rng.integers(3, 8))
    step, rise = 0.007 + 0.03 * size, 0.1 * size + 0.008
    profile = [(0.0, 0.0), (0.55 * size, 0.0)]
    for k in range(number):
        profile += [(0.8 * size, k * step + 0.4 * rise), (size, k * step + rise)]
    top = (number - 1) * step
    profile += [(0.99 * size, top + rise + 0.003), (0.68 * size, top + 0.008), (0.0, top + 0.006)]
    return grounded(lathe(profile, 14).of(material))


def standing_plate(
    rng: np.random.Generator, style: Style, *, radius: float | None = None, china: Material | None = None
) -> Mesh:
    """Draw an upright plate leaning against the back of a shelf."""
    disc = _plate(radius or float(rng.uniform(0.1, 0.14)), china or _china(rng), 18)
    return grounded(disc.turned(-78, "x"))


def bowl(
    rng: np.random.Generator, style: Style, *, radius: float | None = None, china: Material | None = None
) -> Mesh:
    """Draw a bowl."""
    r = radius or float(rng.uniform(0.07, 0.13))
    height = r * float(rng.uniform(0.5, 0.85))
    return grounded(
        lathe(
            [
                (0, 0),
                (0.45 * r, 0),
                (0.48 * r, 0.1 * height),
                (0.8 * r, 0.45 * height),
                (r, height),
                (0.95 * r, height),
                (0.75 * r, 0.48 * height),
                (0.4 * r, 0.16 * height),
                (0, 0.13 * height),
            ],
            16,
        ).of(china or _china(rng))
    )


def bowls(rng: np.random.Generator, style: Style, *, china: Material | None = None) -> Mesh:
    """Draw a stack of bowls."""
    material = china or _china(rng)
    r = float(rng.uniform(0.06, 0.09))
    one = bowl(rng, style, radius=r, china=material)
    return grounded(one.moved(z=k * 0.02) for k in range(int(rng.integers(2, 5))))


def cup(rng: np.random.Generator, style: Style, *, china: Material | None = None) -> Mesh:
    """Draw a cup or mug with a handle."""
    material = china or _china(rng)
    r, height = float(rng.uniform(0.036, 0.045)), float(rng.uniform(0.07, 0.105))
    foot = r * float(rng.choice([0.6, 0.95]))
    body = lathe(
        [
            (0, 0),
            (foot, 0),
            (0.5 * (r + foot) + 0.003, 0.4 * height),
            (r, height),
            (r - 0.004, height),
            (foot - 0.004, 0.02),
            (0, 0.015),
        ],
        12,
    )
    ear = tube(
        [
            (r - 0.006, 0, 0.82 * height),
            (r + 0.022, 0, 0.8 * height),
            (r + 0.026, 0, 0.5 * height),
            (0.5 * (r + foot), 0, 0.25 * height),
        ],
        0.0045,
        6,
    )
    return grounded(join(body, ear).of(material).turned(float(rng.uniform(0, 360))))


def tea_cup(rng: np.random.Generator, style: Style, *, china: Material | None = None) -> Mesh:
    """Draw a cup on a saucer."""
    material = china or _china(rng)
    saucer = _plate(0.075, material, 14)
    return grounded(join(saucer, _middle(cup(rng, style, china=material)).moved(z=0.008)))


def _middle(mesh: Mesh) -> Mesh:
    low, high = mesh.low, mesh.high
    return mesh.moved(-float(low[0] + high[0]) / 2, -float(low[1] + high[1]) / 2)


def glass(rng: np.random.Generator, style: Style, *, tint: Material | None = None) -> Mesh:
    """Draw a tumbler."""
    r, height = float(rng.uniform(0.03, 0.042)), float(rng.uniform(0.08, 0.15))
    foot = r * float(rng.uniform(0.75, 1.0))
    return grounded(
        lathe([(0, 0), (foot, 0), (r, height), (r - 0.003, height), (foot - 0.003, 0.012), (0, 0.01)], 12).of(
            tint or CLEAR
        )
    )


def wine_glass(rng: np.random.Generator, style: Style, *, tint: Material | None = None) -> Mesh:
    """Draw a glass with a stem."""
    r, height = float(rng.uniform(0.032, 0.042)), float(rng.uniform(0.17, 0.22))
    stem = height * 0.48
    return grounded(
        lathe(
            [
                (0, 0),
                (0.033, 0),
                (0.033, 0.003),
                (0.006, 0.008),
                (0.0045, 0.5 * stem),
                (0.006, stem),
                (0.8 * r, stem + 0.025),
                (r, stem + 0.055),
                (0.78 * r, height),
            ],
            12,
        ).of(tint or CLEAR)
    )


def bottle(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a bottle with a label and a cap."""
    colour = BOTTLES[int(rng.integers(len(BOTTLES)))]
    r, height = float(rng.uniform(0.03, 0.042)), float(rng.uniform(0.22, 0.33))
    shoulder = height * float(rng.uniform(0.5, 0.68))
    neck = float(rng.uniform(0.012, 0.016))
    body = lathe(
        [
            (0, 0),
            (r, 0),
            (r, shoulder),
            (0.75 * r, shoulder + 0.03),
            (neck + 0.002, shoulder + 0.065),
            (neck, height),
            (0, height),
        ],
        12,
    ).of(Material(colour=colour, gloss=0.07, roughness=0.1))
    low = shoulder * float(rng.uniform(0.15, 0.3))
    label = lathe([(r + 0.001, low), (r + 0.001, low + shoulder * 0.5)], 12).of(palette.paper(rng))
    cap = cylinder(neck + 0.002, 0.03, 8).moved(z=height - 0.022).of(palette.plastic(rng))
    return grounded(join(body, label, cap))


def teapot(rng: np.random.Generator, style: Style, *, china: Material | None = None) -> Mesh:
    """Draw a teapot with a spout, a handle and a lid."""
    r = float(rng.uniform(0.065, 0.085))
    body = lathe(
        [
            (0, 0),
            (0.6 * r, 0),
            (0.95 * r, 0.5 * r),
            (r, 0.85 * r),
            (0.75 * r, 1.4 * r),
            (0.45 * r, 1.6 * r),
            (0.15 * r, 1.68 * r),
            (0.2 * r, 1.85 * r),
            (0, 1.95 * r),
        ],
        16,
    )
    spout = tube([(0.9 * r, 0, 0.6 * r), (1.35 * r, 0, 0.9 * r), (1.65 * r, 0, 1.5 * r)], 0.17 * r, 8)
    ear = tube(
        [
            (-0.75 * r, 0, 1.35 * r),
            (-1.35 * r, 0, 1.35 * r),
            (-1.5 * r, 0, 0.9 * r),
            (-0.95 * r, 0, 0.45 * r),
        ],
        0.1 * r,
        8,
    )
    pot = join(body, spout, ear).of(china or _china(rng))
    return grounded(pot.turned(float(rng.uniform(0, 360))))


def jug(rng: np.random.Generator, style: Style, *, china: Material | None = None) -> Mesh:
    """Draw a glass or china jug with a handle."""
    r, height = float(rng.uniform(0.05, 0.065)), float(rng.uniform(0.17, 0.24))
    body = lathe(
        [
            (0, 0),
            (0.8 * r, 0),
            (r, 0.3 * height),
            (0.7 * r, 0.75 * height),
            (0.8 * r, height),
            (0.75 * r, height),
            (0.64 * r, 0.75 * height),
            (0.9 * r, 0.3 * height),
            (0, 0.02),
        ],
        14,
    )
    ear = tube(
        [
            (0.72 * r, 0, 0.92 * height),
            (1.5 * r, 0, 0.85 * height),
            (1.5 * r, 0, 0.5 * height),
            (0.9 * r, 0, 0.3 * height),
        ],
        0.007,
        6,
    )
    material = china or (CLEAR if rng.random() < 0.4 else _china(rng))
    return grounded(join(body, ear).of(material).turned(float(rng.uniform(0, 360))))


def dish_rack(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a draining rack holding plates, cups and cutlery."""
    width, depth = float(rng.uniform(0.36, 0.46)), 0.3
    wire = style.metal if rng.random() < 0.6 else palette.plastic(rng)
    parts = [box(width, depth, 0.012, bevel=0.004).of(palette.plastic(rng))]
    for y in (0.02, depth - 0.02):
        rail = tube([(-width / 2 + 0.01, y, 0.11), (width / 2 - 0.01, y, 0.11)], 0.004, 6)
        parts.append(rail.of(wire))
        for x in (-width / 2 + 0.01, width / 2 - 0.01):
            parts.append(tube([(x, y, 0), (x, y, 0.11)], 0.004, 6).of(wire))
    for x in (-width / 2 + 0.01, width / 2 - 0.01):
        parts.append(tube([(x, 0.02, 0.11), (x, depth - 0.02, 0.11)], 0.004, 6).of(wire))
    china = _china(rng)
    x = -width / 2 + 0.04
    for _ in range(int(rng.integers(3, 7))):
        disc = _plate(float(rng.uniform(0.09, 0.12)), china, 14).turned(78, "y")
        parts.append(disc.moved(x, 0.14 + float(rng.uniform(-0.01, 0.01)), 0.015 - float(disc.low[2])))
        x += 0.035
    for k in range(2):
        if x + 0.1 < width / 2:
            mug = _middle(cup(rng, style)).turned(180, "x")
            parts.append(mug.moved(x + 0.05, 0.09 + 0.12 * k, 0.015 - float(mug.low[2])))
    holder = box(0.08, 0.1, 0.12, bevel=0.004).of(wire)
    parts.append(holder.moved(width / 2 - 0.06, 0.1, 0.012))
    for _ in range(4):
        x, y = width / 2 - 0.06 + float(rng.uniform(-0.03, 0.03)), 0.15 + float(rng.uniform(-0.04, 0.04))
        tip = (x + float(rng.uniform(-0.02, 0.02)), y + float(rng.uniform(-0.02, 0.02)), 0.22)
        parts.append(tube([(x, y, 0.1), tip], 0.005, 5).of(style.metal))
    return grounded(parts)


def shelf_of_dishes(
    rng: np.random.Generator,
    style: Style,
    *,
    width: float = 0.8,
    depth: float = 0.3,
    height: float = 0.3,
    china: Material | None = None,
) -> Mesh:
    """Draw a row of dishes for a shelf of the given width, depth and clear height."""
    material = china or _china(rng)
    things: list[Mesh] = []
    filled = 0.0
    while filled < width * 0.92:
        name = KINDS[int(rng.integers(len(KINDS)))]
        for _ in range(int(rng.integers(1, 5)) if name in ("cup", "glass", "wine_glass", "tea_cup") else 1):
            thing = _one(rng, style, name, material)
            filled += float(thing.size[0]) + 0.015
            if float(thing.size[1]) <= depth and float(thing.size[2]) < height - 0.02:
                things.append(thing)
    return in_a_row(rng, things, width, depth=depth, gap=0.012)


def _one(rng: np.random.Generator, style: Style, name: str, china: Material) -> Mesh:
    if name == "glass":
        return glass(rng, style)
    if name == "wine_glass":
        return wine_glass(rng, style)
    makers = {"plates": plates, "cup": cup, "bowls": bowls, "tea_cup": tea_cup, "bowl": bowl, "jug": jug}
    return makers.get(name, teapot)(rng, style, china=china)
