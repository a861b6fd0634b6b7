"""Clothes on hangers, folded clothes, and pairs of shoes."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import box, lathe, sheet, superellipsoid, tube
from placecat_homes.style import Style

HANGER = (
    Material((0.62, 0.45, 0.27)),
    Material((0.1, 0.1, 0.1)),
    Material((0.85, 0.85, 0.85)),
    palette.METALS[0],
)


def cloth(rng: np.random.Generator) -> Material:
    """Choose a material for a piece of clothing."""
    kind = rng.random()
    if kind < 0.3:
        v = between(rng, 0.06, 0.3) if chance(rng, 0.6) else between(rng, 0.75, 0.95)
        return Material((v, v, v * between(rng, 0.95, 1.15)))
    if kind < 0.45:
        return Material((0.16, 0.22, between(rng, 0.3, 0.45)))
    if kind < 0.75:
        return palette.plain_fabric(rng)
    return palette.fabric(rng)


def garment(rng: np.random.Generator, kind: str | None = None, hanger: Material = HANGER[0]) -> Mesh:
    """Draw a piece of clothing on a hanger.

    Parameters
    ----------
    rng
        Random number generator.
    kind
        "shirt", "jacket", "coat", "dress", "trousers" or "skirt"; chosen at random if None.
    hanger
        Material of the hanger.

    Returns
    -------
    Mesh
        A garment hanging from a rod along x through the origin, with its shoulders along y.
    """
    kind = (
        choose(rng, ("shirt", "jacket", "coat", "dress", "trousers", "skirt"), (5, 2, 1, 2, 2, 0.7))
        if kind is None
        else kind
    )
    skin = cloth(rng)
    top = -0.07
    hook = tube([(0, 0.03, 0.005), (0, 0.0, 0.02), (0, -0.025, 0.0), (0, 0, -0.03), (0, 0, top)], 0.003, 4)
    arms = tube([(0, -0.2, top - 0.07), (0, 0, top), (0, 0.2, top - 0.07)], 0.007, 5)
    parts = [join(hook, arms).of(hanger)]
    if kind == "trousers":
        long = between(rng, 0.55, 0.7)
        parts.append(tube([(0, -0.2, top - 0.07), (0, 0.2, top - 0.07)], 0.005, 5).of(hanger))
        parts.append(_body(0.3, 0.34, 0.045, long, 0.1, 0.005).moved(0, 0, top - 0.05).of(skin))
        return join(parts)
    if kind == "skirt":
        long = between(rng, 0.45, 0.75)
        parts.append(tube([(0, -0.2, top - 0.07), (0, 0.2, top - 0.07)], 0.005, 5).of(hanger))
        parts.append(
            _body(0.34, between(rng, 0.4, 0.6), 0.05, long, 0.02, 0.02).moved(0, 0, top - 0.07).of(skin)
        )
        return join(parts)
    long = {
        "shirt": between(rng, 0.62, 0.78),
        "jacket": between(rng, 0.65, 0.82),
        "coat": between(rng, 0.95, 1.2),
        "dress": between(rng, 0.9, 1.25),
    }[kind]
    thick = {"shirt": 0.035, "jacket": 0.075, "coat": 0.085, "dress": 0.04}[kind] * between(rng, 0.8, 1.2)
    shoulders = between(rng, 0.4, 0.48) if kind != "dress" else between(rng, 0.34, 0.4)
    hem = shoulders * (between(rng, 1.0, 1.1) if kind != "dress" else between(rng, 1.15, 1.6))
    parts.append(_body(shoulders, hem, thick, long, 0.16, 0.014).moved(0, 0, top + 0.015).of(skin))
    if kind != "dress" or chance(rng, 0.3):
        reach = long * between(rng, 0.72, 0.85) if kind != "shirt" or chance(rng, 0.6) else 0.26
        wide = thick * 0.55 + 0.012
        for side in (-1, 1):
            y = side * shoulders * 0.49
            path = [
                (0.0, y * 0.86, top - 0.05),
                (0.0, y + side * 0.02, top - 0.16),
                (0.01, y + side * 0.035, top - reach),
            ]
            parts.append(tube(path, wide, 7).scaled(0.8, 1, 1).of(skin))
    return join(parts)


def _body(top: float, hem: float, thick: float, long: float, slope: float, fold: float) -> Mesh:
    """Draw the hollow body of a hanging garment, thin along x.

    `top` and `hem` are its widths along y in metres.
    """

    def surface(s: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, ...]:
        a = s * 2 * math.pi
        wide = np.interp(
            t, [0, 0.12, 0.5, 1], [top * 0.3 if slope > 0.05 else top, top, (top + hem) * 0.49, hem]
        )
        deep = np.interp(t, [0, 0.1, 0.5, 1], [0.4 * thick, thick, 1.05 * thick, 1.15 * thick])
        x = deep / 2 * np.sign(np.cos(a)) * np.abs(np.cos(a)) ** 0.6
        y = wide / 2 * np.sign(np.sin(a)) * np.abs(np.sin(a)) ** 0.8
        x = x + fold * t * np.sin(y * 55)
        drop = np.interp(t, [0, 0.12, 1], [0, 0.08 if slope > 0.05 else 0.02, long])
        return x, y, -drop

    # t runs downwards, so s is reversed to make the surface face outwards.
    return sheet(lambda s, t: surface(1 - s, t), 14, 6, (2 * top, long))


def hanging(
    rng: np.random.Generator, style: Style, width: float, long: float = 1.3, full: float = 0.8
) -> Mesh:
    """Draw clothes hanging side by side on a rod.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Length of the rod in metres.
    long
        Clearance below the rod in metres.
    full
        How full the rod is, from 0 (nearly empty) to 1 (crowded).

    Returns
    -------
    Mesh
        The clothes without the rod. They hang below the x axis and extend about 0.25 m to either side of it.
    """
    hanger = choose(rng, HANGER)
    kinds = ["shirt", "shirt", "shirt", "jacket", "trousers", "skirt"]
    if long > 1.15:
        kinds += ["coat", "dress", "dress", "jacket"]
    parts: list[Mesh] = []
    x = -width / 2 + 0.05
    kind = choose(rng, kinds)
    while x < width / 2 - 0.04:
        if chance(rng, 0.35):
            kind = choose(rng, kinds)
        piece = garment(rng, kind, hanger)
        low = -float(piece.low[2])
        if low < long:
            swing = rng.normal(0, 7)
            parts.append(piece.turned(swing).moved(x))
            x += between(rng, 0.035, 0.06) + (0.03 if kind in ("jacket", "coat") else 0.0)
        if chance(rng, 0.12 + 0.5 * (1 - full)):
            x += between(rng, 0.03, 0.2)
        if low >= long:
            kind = "shirt"
            if long < 0.85:
                kind = "trousers"
            if long < 0.7:
                break
    return join(parts)


def folded(
    rng: np.random.Generator, style: Style, width: float = 0.3, depth: float = 0.34, count: int | None = None
) -> Mesh:
    """Draw a pile of folded clothes.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, depth
        Size in metres.
    count
        Number of pieces; 2 to 6 if None.

    Returns
    -------
    Mesh
        A pile on z = 0, with its back at y = 0 and the folds facing forwards.
    """
    count = int(rng.integers(2, 7)) if count is None else count
    parts, z = [], 0.0
    for _ in range(count):
        h = between(rng, 0.022, 0.06)
        w, d = width * between(rng, 0.85, 1.0), depth * between(rng, 0.85, 1.0)
        piece = superellipsoid(w, d, h + 0.006, 0.45, 0.15, 10)
        parts.append(piece.moved(rng.normal(0, 0.008), d / 2, z).of(cloth(rng)))
        z += h
    return join(parts)


def shoes(rng: np.random.Generator, style: Style, kind: str | None = None) -> Mesh:
    """Draw a pair of shoes.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    kind
        "shoe", "sneaker" or "boot"; chosen at random if None.

    Returns
    -------
    Mesh
        Shoes standing on z = 0, with their heels at y = 0.
    """
    kind = choose(rng, ("shoe", "sneaker", "boot")) if kind is None else kind
    skin = (
        palette.leather(rng)
        if kind != "sneaker" or chance(rng, 0.3)
        else Material(palette.colour(rng, 0.9, 0.15, 0.95))
    )
    sole = Material((0.9, 0.9, 0.9)) if kind == "sneaker" else palette.RUBBER
    long = between(rng, 0.24, 0.29)
    pair = []
    for side in (-1, 1):
        one = [
            superellipsoid(0.095, long, 0.032, 0.3, 0.8, 8).moved(0, long / 2, 0).of(sole),
            superellipsoid(0.086, long * 0.95, 0.085, 0.8, 0.9, 10).moved(0, long / 2, 0.012).of(skin),
        ]
        top = between(rng, 0.2, 0.35) if kind == "boot" else 0.1
        shaft = lathe([(0.04, 0.03), (0.037, 0.08), (0.042, top), (0.037, top), (0.03, 0.05), (0, 0.05)], 8)
        one.append(shaft.scaled(1, 1.25, 1).moved(0, 0.06, 0).of(skin))
        pair.append(join(one).turned(rng.normal(0, 6)).moved(side * 0.06, rng.normal(0, 0.008)))
    return grounded(join(pair))


def hat(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a hat with a brim."""
    r, brim, h = 0.085, between(rng, 0.13, 0.2), between(rng, 0.1, 0.14)
    felt = choose(rng, (palette.plain_fabric(rng), Material((0.8, 0.68, 0.46)), palette.RUBBER))
    profile = [
        (0, 0.002),
        (brim, 0.006),
        (brim, 0.01),
        (r * 1.08, 0.012),
        (r, h * 0.9),
        (r * 0.8, h),
        (0, h * 0.93),
    ]
    band = lathe([(r * 1.085, 0.012), (r * 1.075, 0.04)], 18).of(cloth(rng))
    return grounded(join(lathe(profile, 20).scaled(1, 1.15, 1).of(felt), band.scaled(1, 1.15, 1)))


def bag(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a handbag."""
    w, d, h = between(rng, 0.24, 0.4), between(rng, 0.09, 0.15), between(rng, 0.18, 0.28)
    skin = palette.leather(rng) if chance(rng, 0.7) else palette.fabric(rng)
    body = box(w, d, h, 0.03).of(skin)
    rise = between(rng, 0.08, 0.16)
    path = [(w * 0.3 * math.cos(a), d / 2, h - 0.02 + rise * math.sin(a)) for a in np.linspace(0, math.pi, 9)]
    return grounded(join(body, tube(path, 0.007, 6).of(skin)))
