"""Tableware and centrepieces for laid tables."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.furniture.dishes import (
    bottle,
    bowl,
    cup,
    glass,
    jug,
    plate,
    tea_cup,
    teapot,
    wine_glass,
)
from placecat_homes.furniture.food import bread, fruit_bowl
from placecat_homes.furniture.vase import candle, vase
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import centred, scattered
from placecat_homes.parts.outlines import oval, rectangle
from placecat_homes.shapes import box, cylinder, extrude, lathe, tube
from placecat_homes.style import Style

WAX = Material(colour=(0.95, 0.92, 0.83), gloss=0.02)
FLAME = Material(colour=(1.0, 0.8, 0.4), emission=3.0)


@dataclass(frozen=True)
class Tableware:
    """Tableware shared by all place settings at one table.

    Attributes
    ----------
    china
        Material of plates and cups.
    metal
        Material of the cutlery.
    cloth
        Material of the napkins.
    mat
        Material of the place mats; None for no mats.
    round_mat
        Whether the mats are round.
    drink
        ``glass``, ``wine``, ``both`` or ``tea``.
    soup
        Whether there is a bowl on the plate.
    """

    china: Material
    metal: Material
    cloth: Material
    mat: Material | None
    round_mat: bool
    drink: str
    soup: bool

    @classmethod
    def draw(cls, rng: np.random.Generator, style: Style) -> "Tableware":
        """Choose the tableware for one table."""
        return cls(
            china=palette.ceramic(rng),
            metal=palette.METALS[int(rng.integers(2))],
            cloth=palette.plain_fabric(rng) if chance(rng, 0.6) else style.any_fabric(rng),
            mat=style.any_fabric(rng) if chance(rng, 0.5) else None,
            round_mat=chance(rng, 0.3),
            drink=choose(rng, ("glass", "wine", "both", "tea"), (0.35, 0.25, 0.25, 0.15)),
            soup=chance(rng, 0.3),
        )


def place_setting(rng: np.random.Generator, style: Style, *, ware: Tableware | None = None) -> Mesh:
    """Draw a plate, cutlery, a glass and a napkin. The diner sits at y < 0 and faces +y.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    ware
        Tableware shared by all place settings at the table; chosen at random if None.

    Returns
    -------
    Mesh
        A setting about 0.45 m wide and 0.35 m deep. The edge of the table is at y = 0.
    """
    kit = ware or Tableware.draw(rng, style)
    parts: list[Mesh] = []
    level = 0.0
    if kit.mat is not None:
        shape = oval(0.38, 0.38, 24) if kit.round_mat else rectangle(0.42, 0.31, 0.01)
        parts.append(extrude(shape, 0.003).moved(y=0.19).of(kit.mat))
        level = 0.003
    dish = centred(plate(rng, style, radius=0.13, china=kit.china)).moved(0, 0.18, level)
    parts.append(dish)
    if kit.soup:
        parts.append(centred(bowl(rng, style, radius=0.08, china=kit.china)).moved(0, 0.18, level + 0.008))
    for x, kind in ((-0.165, "fork"), (0.16, "knife"), (0.185, "spoon")):
        if kind == "spoon" and not kit.soup:
            continue
        parts.append(_cutlery(kind).moved(x, 0.09, level).of(kit.metal))
    if chance(rng, 0.7):
        lying = box(0.07, 0.16, 0.008, 0.002).moved(-0.215, 0.1, 0)
        folded = lathe([(0.045, 0), (0.03, 0.05), (0, 0.12)], 4).moved(0, 0.18, level + 0.015)
        parts.append((lying if kit.soup or chance(rng, 0.7) else folded).of(kit.cloth))
    if kit.drink in ("glass", "both"):
        parts.append(centred(glass(rng, style)).moved(0.15, 0.33))
    if kit.drink in ("wine", "both"):
        parts.append(centred(wine_glass(rng, style)).moved(0.08, 0.36))
    if kit.drink == "tea":
        parts.append(centred(tea_cup(rng, style, china=kit.china)).moved(0.16, 0.34))
    return join(parts)


def _cutlery(kind: str) -> Mesh:
    grip = box(0.011, 0.11, 0.004, 0.001)
    if kind == "knife":
        return join(grip, box(0.016, 0.1, 0.002, 0).moved(0.002, 0.108, 0.001))
    if kind == "spoon":
        head = lathe([(0, 0), (0.018, 0.003), (0.016, 0.006)], 10).scaled(1, 1.5, 1).moved(y=0.15)
        return join(grip, box(0.006, 0.03, 0.003, 0).moved(y=0.105), head)
    neck = box(0.007, 0.03, 0.003, 0).moved(y=0.108)
    tines = [box(0.003, 0.055, 0.002, 0).moved(x, 0.138, 0.002) for x in (-0.009, -0.003, 0.003, 0.009)]
    return join(grip, neck, box(0.021, 0.012, 0.003, 0).moved(y=0.13), tines)


def candlestick(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a candlestick with one or three candles, sometimes lit."""
    metal = style.metal
    arms = choose(rng, (1, 1, 3))
    height = between(rng, 0.1, 0.22)
    lit = chance(rng, 0.3)
    profile = [(0, 0), (0.05, 0), (0.045, 0.012), (0.012, 0.025), (0.018, 0.5 * height), (0.01, 0.6 * height)]
    parts = [lathe([*profile, (0.022, height), (0, height)], 12).of(metal)]
    places = [(0.0, height)] if arms == 1 else [(-0.09, height + 0.03), (0.0, height), (0.09, height + 0.03)]
    for x, z in places:
        if x:
            path = [(0, 0, 0.6 * height), (0.7 * x, 0, 0.55 * height), (x, 0, z - 0.03), (x, 0, z)]
            parts.append(tube(path, 0.006, 6).of(metal))
            parts.append(lathe([(0, z - 0.008), (0.02, z), (0, z)], 10).moved(x).of(metal))
        long = between(rng, 0.1, 0.22)
        parts.append(cylinder(0.011, long, 8, 0.002).moved(x, 0, z).of(WAX))
        if lit:
            parts.append(lathe([(0, 0), (0.007, 0.012), (0, 0.035)], 6).moved(x, 0, z + long).of(FLAME))
    return join(parts).moved(y=0.05)


def runner(rng: np.random.Generator, style: Style, *, length: float = 1.2, width: float = 0.35) -> Mesh:
    """Draw a cloth runner along the middle of a table."""
    return block(style.any_fabric(rng), (length, width, 0.003))


def centrepiece(
    rng: np.random.Generator, style: Style, *, width: float = 0.8, depth: float = 0.3, festive: bool = True
) -> Mesh:
    """Draw a centrepiece for a table: flowers, fruit, candles, a jug or bread.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, depth
        Available space in metres.
    festive
        Whether to add more objects, as on a table laid for a meal.

    Returns
    -------
    Mesh
        A centrepiece on z = 0, centred on the origin.
    """
    first: Mesh
    kind = rng.random()
    if kind < 0.4:
        first = vase(rng, style, True)
    elif kind < 0.75:
        first = fruit_bowl(rng, style)
    else:
        first = candlestick(rng, style)
    others: tuple[Callable[[np.random.Generator, Style], Mesh], ...]
    others = (candlestick, candle, jug, bottle, bowl, bread, teapot, cup, glass)
    count = int(rng.integers(1, 5)) if festive else int(rng.choice([0, 0, 1, 2]))
    things = [others[int(rng.integers(len(others)))](rng, style) for _ in range(count)]
    middle = centred(first)
    half = float(middle.size[0]) / 2 + 0.03
    side = width / 2 - half
    parts = [middle]
    for direction in (-1, 1):
        if side > 0.12 and things:
            part = things[: (len(things) + 1) // 2] if direction < 0 else things[(len(things) + 1) // 2 :]
            parts.append(scattered(rng, part, side, depth).moved(direction * (half + side / 2)))
    return join(parts)
