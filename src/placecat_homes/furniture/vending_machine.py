"""Vending machines and water dispensers."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Lamp, Mesh, join
from placecat_homes.parts.prints import ink
from placecat_homes.shapes import box, cylinder, lathe, quad
from placecat_homes.style import Style

DARK = Material((0.05, 0.05, 0.055), gloss=0.04)


def vending_machine(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an illuminated vending machine with a coin panel and rows of snacks and bottles behind glass."""
    wide, deep, high = between(rng, 0.8, 0.95), between(rng, 0.7, 0.82), between(rng, 1.75, 1.9)
    skin = choose(rng, (DARK, Material(ink(rng), gloss=0.04), Material((0.85, 0.85, 0.84), gloss=0.04)))
    glass_wide, low = wide * 0.68, high * 0.26
    glass_high = high * 0.66
    x = wide / 2 - 0.05 - glass_wide / 2
    inside = deep - 0.3
    glow = Material((0.95, 0.97, 1.0), emission=0.5)
    left, right = wide / 2 - (x + glass_wide / 2), wide / 2 + (x - glass_wide / 2)
    parts = [
        block(skin, (wide, inside, high), (0, 0, 0.0), 0.0),
        block(glow, (glass_wide, 0.004, glass_high), (x, inside, low)),
        block(skin, (left, deep - inside, high), (wide / 2 - left / 2, inside, 0), 0.0),
        block(skin, (right, deep - inside, high), (-wide / 2 + right / 2, inside, 0), 0.0),
        block(skin, (glass_wide, deep - inside, low), (x, inside, 0)),
        block(skin, (glass_wide, deep - inside, high - low - glass_high), (x, inside, low + glass_high)),
        quad(glass_wide, glass_high).moved(x, deep - 0.02, low).of(palette.GLASS),
        block(DARK, (glass_wide * 0.8, 0.004, low * 0.35), (x, deep, low * 0.35)),
    ]
    rows = int(rng.integers(5, 7))
    step = glass_high / rows
    for row in range(rows):
        z = low + row * step
        parts.append(block(Material((0.7, 0.71, 0.73)), (glass_wide, 0.24, 0.012), (x, inside, z)))
        parts.append(
            block(Material((0.95, 0.95, 0.9)), (glass_wide, 0.004, 0.02), (x, inside + 0.24, z - 0.008))
        )
        bottles = row < rows // 2 and chance(rng, 0.7)
        count = 8 if bottles else 6
        for k in range(count):
            place = x - glass_wide / 2 + (k + 0.5) * glass_wide / count
            goods = Material(ink(rng), gloss=0.04)
            if bottles:
                tall = step * 0.8
                line = [
                    (0, 0),
                    (0.028, 0),
                    (0.028, tall * 0.65),
                    (0.01, tall * 0.85),
                    (0.01, tall),
                    (0, tall),
                ]
                parts.append(lathe(line, 8).moved(place, inside + 0.17, z + 0.012).of(goods))
            else:
                size = (glass_wide / count * 0.8, 0.05, step * between(rng, 0.5, 0.75))
                parts.append(block(goods, size, (place, inside + 0.15, z + 0.012)))
                band = (size[0] * 0.7, 0.002, size[2] * 0.3)
                other = Material(ink(rng))
                parts.append(block(other, band, (place, inside + 0.2, z + 0.012 + size[2] * 0.4)))
    px = -wide / 2 + right / 2
    parts.append(block(DARK, (right * 0.7, 0.006, 0.34), (px, deep, high * 0.55)))
    parts.append(
        block(
            Material((0.3, 0.9, 0.6), emission=0.6),
            (right * 0.5, 0.003, 0.04),
            (px, deep + 0.006, high * 0.7),
        )
    )
    for i in range(3):
        for j in range(4):
            key = box(0.022, 0.006, 0.022, 0).moved(
                px + (i - 1) * 0.032, deep + 0.006, high * 0.57 + 0.035 * j
            )
            parts.append(key.of(Material((0.8, 0.8, 0.8))))
    parts.append(block(Material((0.75, 0.76, 0.77), gloss=0.4), (0.06, 0.01, 0.1), (px, deep, high * 0.4)))
    return join(parts).lit(Lamp((x, deep + 0.12, low + glass_high * 0.6), (0.9, 0.95, 1.0), 0.15, 0.2))


def water_dispenser(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a water cooler with a large bottle on top and cups on the side."""
    wide, deep, high = 0.31, 0.33, between(rng, 0.92, 1.02)
    skin = choose(rng, (Material((0.9, 0.9, 0.89), gloss=0.04), DARK, palette.plastic(rng)), (3, 1, 1))
    water = Material((0.45, 0.68, 0.88), gloss=0.08, roughness=0.05, opacity=0.55)
    line = [(0.03, 0), (0.05, 0.05), (0.13, 0.1), (0.135, 0.2), (0.128, 0.21), (0.135, 0.22), (0.135, 0.36),
            (0.1, 0.4), (0, 0.4)]  # fmt: skip
    parts = [
        block(skin, (wide, deep, high), bevel=0.02),
        lathe(line, 20).moved(0, deep / 2, high).of(water),
        block(DARK, (wide * 0.7, 0.004, 0.25), (0, deep - 0.001, high * 0.62)),
        block(Material((0.6, 0.61, 0.62)), (wide * 0.6, 0.08, 0.015), (0, deep - 0.01, high * 0.6)),
    ]
    for side, colour in ((-1, (0.1, 0.25, 0.75)), (1, (0.75, 0.1, 0.1))):
        tap = box(0.03, 0.05, 0.04, 0.005).moved(side * 0.05, deep, high * 0.62 + 0.17)
        parts.append(tap.of(Material((0.9, 0.9, 0.9))))
        parts.append(
            box(0.025, 0.02, 0.012, 0)
            .moved(side * 0.05, deep + 0.03, high * 0.62 + 0.21)
            .of(Material(colour))
        )
    if chance(rng, 0.7):
        cups = cylinder(0.038, 0.35, 12).moved(wide / 2 + 0.045, deep * 0.6, high * 0.5)
        parts.append(cups.of(Material((0.93, 0.93, 0.93))))
    return join(parts)
