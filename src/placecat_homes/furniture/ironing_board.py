"""Ironing boards."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, chance
from placecat_homes.furniture.clothes import folded
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import extrude, superellipsoid, tube
from placecat_homes.style import Style


def iron(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an iron resting on its soleplate."""
    skin = palette.plastic(rng)
    outline = [(-0.055, 0), (0.055, 0), (0.055, 0.1), (0.035, 0.19), (0, 0.24), (-0.035, 0.19), (-0.055, 0.1)]
    sole = extrude(outline, 0.012).of(palette.METALS[0])
    body = (
        extrude([(x * 0.9, y * 0.94 + 0.005) for x, y in outline], 0.06, smooth=True)
        .moved(0, 0, 0.012)
        .of(skin)
    )
    grip = tube([(0, 0.02, 0.06), (0, 0.02, 0.12), (0, 0.14, 0.12), (0, 0.18, 0.06)], 0.014, 8).of(skin)
    return join(sole, body, grip)


def ironing_board(rng: np.random.Generator, style: Style, folded_up: bool | None = None) -> Mesh:
    """Draw an ironing board, either set up with an iron on it or folded and leaning against the wall.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    folded_up
        Whether the board is folded; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    away = chance(rng, 0.5) if folded_up is None else folded_up
    long, wide = between(rng, 1.1, 1.3), between(rng, 0.34, 0.42)
    height = between(rng, 0.84, 0.92)
    cover, steel = palette.fabric(rng), _steel(rng)
    half = [(-long / 2, -wide / 2), (long * 0.12, -wide / 2)]
    tip = [
        (long * 0.12 + long * 0.38 * math.sin(a), -wide / 2 * math.cos(a) ** 0.8)
        for a in np.linspace(0.15, math.pi / 2 - 0.05, 7)
    ]
    outline = [
        *half,
        *tip,
        (long / 2, 0.0),
        *[(x, -y) for x, y in tip[::-1]],
        (long * 0.12, wide / 2),
        (-long / 2, wide / 2),
    ]
    top = extrude(outline, 0.03).of(cover)
    if away:
        legs = [
            tube([(-long * 0.45, s * 0.1, -0.02), (long * 0.35, s * 0.06, -0.025)], 0.011, 6) for s in (-1, 1)
        ]
        legs.append(tube([(-long * 0.45, -0.16, -0.02), (-long * 0.45, 0.16, -0.02)], 0.011, 6))
        board = join(top, join(legs).of(steel))
        # The board stands upright with its underside facing the wall.
        return grounded(board.turned(-90, "y").turned(90).turned(180).turned(7, "x"))
    parts = [top.moved(0, 0, height - 0.03)]
    for s, (a, b) in ((-1, (-0.38, 0.3)), (1, (0.38, -0.34))):
        y = s * 0.03
        parts.append(
            tube([(a * long, y - 0.04, 0.012), (b * long, y - 0.04, height - 0.04)], 0.012, 8).of(steel)
        )
        parts.append(
            tube([(a * long, y + 0.04, 0.012), (b * long, y + 0.04, height - 0.04)], 0.012, 8).of(steel)
        )
        parts.append(tube([(a * long, -0.2, 0.012), (a * long, 0.2, 0.012)], 0.012, 8).of(steel))
    parts.append(
        tube(
            [
                (-long / 2, -0.12, height - 0.02),
                (-long * 0.62, 0.0, height - 0.02),
                (-long / 2, 0.12, height - 0.02),
            ],
            0.006,
            6,
        ).of(steel)
    )
    if chance(rng, 0.7):
        parts.append(iron(rng, style).turned(between(rng, 60, 120)).moved(-long * 0.3, 0, height))
    if chance(rng, 0.6):
        parts.append(folded(rng, style, 0.28, 0.3).moved(long * 0.05, -0.15, height))
    elif chance(rng, 0.5):
        parts.append(
            superellipsoid(0.5, wide * 0.8, 0.03, 0.5, 0.3, 12)
            .moved(long * 0.1, 0, height)
            .of(palette.fabric(rng))
        )
    return grounded(join(parts))


def _steel(rng: np.random.Generator) -> Material:
    return palette.WHITE if chance(rng, 0.4) else palette.metal(rng)
