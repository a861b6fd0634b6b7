"""Soap and paper dispensers, hand dryers and waste bins for lavatories."""

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.parts.lofts import loft, rounded
from placecat_homes.parts.toiletries import PAPER
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style


def _shell(rng: np.random.Generator, style: Style) -> Material:
    choice = rng.random()
    if choice < 0.45:
        return Material((0.9, 0.9, 0.9), gloss=0.04)
    return style.metal if choice < 0.75 else palette.plastic(rng)


def soap_box(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a soap dispenser. It should be mounted 1.05 m above the floor."""
    shell = _shell(rng, style)
    outline = rounded(0.11, 0.1, 0.03, 0.003)
    return join(
        loft([(outline * 0.9, 0.03), (outline, 0.05), (outline, 0.23), (outline * 0.9, 0.25)]).of(shell),
        box(0.05, 0.02, 0.1, bevel=0.004).moved(0, 0.092, 0.05).of(palette.RUBBER),
        cylinder(0.008, 0.035, 8).moved(0, 0.06, 0).of(palette.RUBBER),
    )


def towel_dispenser(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a paper-towel dispenser with one towel hanging out. It should hang about 1.1 m above the floor."""
    shell = _shell(rng, style)
    width, height = rng.uniform(0.27, 0.32), rng.uniform(0.3, 0.42)
    outline = rounded(width, 0.14, 0.04, 0.003)
    drop = rng.uniform(0.06, 0.12)
    return join(
        loft([(outline, drop), (outline, drop + height - 0.02), (outline * 0.93, drop + height)]).of(shell),
        box(width * 0.75, 0.02, 0.01, bevel=0.0).moved(0, 0.06, drop - 0.008).of(palette.RUBBER),
        box(width * 0.7, 0.002, drop + 0.01, bevel=0.0).turned(8, "x").moved(0, 0.08).of(PAPER),
        box(0.02, 0.004, height * 0.4, bevel=0.0)
        .moved(0, 0.139, drop + height * 0.3)
        .of(palette.BLACK_GLASS),
    )


def hand_dryer(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a warm-air hand dryer. It should be mounted 1.1 m above the floor."""
    shell = _shell(rng, style)
    if rng.random() < 0.4:
        slot = rounded(0.3, 0.22, 0.04, 0.003)
        return grounded(
            loft([(slot * 0.9, 0.0), (slot, 0.1), (slot, 0.62), (slot * 0.95, 0.65)]).of(shell),
            box(0.26, 0.05, 0.012, bevel=0.0).moved(0, 0.1, 0.645).of(palette.RUBBER),
            box(0.24, 0.006, 0.2, bevel=0.0).moved(0, 0.218, 0.36).of(palette.BLACK_GLASS),
        )
    outline = rounded(0.27, 0.2, (0.12, 0.1), 0.003)
    return grounded(
        loft([(outline * 0.94, 0.05), (outline, 0.08), (outline, 0.26), (outline * 0.8, 0.3)]).of(shell),
        tube([(0, 0.12, 0.07), (0, 0.15, 0.0)], 0.03, 10).of(style.metal),
        cylinder(0.02, 0.01, 10).turned(-90, "x").moved(0, 0.197, 0.15).of(palette.METALS[1]),
    )


def paper_dispenser(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a round dispenser for large toilet rolls. It should be mounted 0.75 m above the floor."""
    shell = _shell(rng, style)
    body = cylinder(0.13, 0.11, 20, bevel=0.012).turned(-90, "x").moved(0, 0, 0.17)
    return grounded(
        body.of(shell),
        box(0.06, 0.002, 0.08, bevel=0.0).moved(0.03, 0.09, 0.1).of(palette.BLACK_GLASS),
        box(0.09, 0.002, 0.1, bevel=0.0).moved(0, 0.06, -0.03).of(PAPER),
    )


def towel_bin(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a waste bin with paper towels on top."""
    width, height = rng.uniform(0.28, 0.36), rng.uniform(0.45, 0.65)
    outline = rounded(width, width * 0.8, width * rng.uniform(0.05, 0.4), points=5)
    inner = outline * 0.93 + (0, width * 0.028)
    parts = [
        loft(
            [
                (outline * 0.9 + (0, width * 0.04), 0.0),
                (outline, height),
                (inner, height),
                (inner, height - 0.1),
            ]
        ).of(_shell(rng, style))
    ]
    for _ in range(int(rng.integers(2, 7))):
        lump = box(rng.uniform(0.06, 0.12), rng.uniform(0.06, 0.1), 0.03, bevel=0.012)
        lump = lump.turned(rng.uniform(-40, 40), "x").turned(rng.uniform(0, 180))
        x, y = rng.uniform(-0.06, 0.06, 2)
        parts.append(
            lump.moved(float(x), width * 0.4 + float(y), height - 0.04 + rng.uniform(0, 0.05)).of(PAPER)
        )
    return grounded(parts)
