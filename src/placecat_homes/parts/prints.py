"""Printed sheets of paper."""

import numpy as np

from placecat_homes.materials import Colour, Material, Texture
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import box, quad, slab

PAPERS: tuple[Colour, ...] = (
    (0.95, 0.95, 0.94),
    (0.93, 0.91, 0.85),
    (0.97, 0.97, 0.98),
    (0.95, 0.9, 0.55),
    (0.72, 0.85, 0.93),
    (0.94, 0.72, 0.75),
    (0.75, 0.9, 0.72),
    (0.95, 0.7, 0.4),
)


def ink(rng: np.random.Generator) -> Colour:
    """Choose a bold colour for headings, binders and pens."""
    hue, deep = rng.random(), rng.uniform(0.2, 0.9)
    wheel = np.clip(np.abs((hue * 6 + np.array([0, 4, 2])) % 6 - 3) - 1, 0, 1)
    r, g, b = (float(v) for v in deep * (1 - rng.beta(1.6, 1.3) * (1 - wheel)))
    return r, g, b


def leaf(rng: np.random.Generator, *, white: float = 0.8) -> Material:
    """Choose a plain paper material, which is white with probability `white`."""
    first = rng.random() < white
    return Material(PAPERS[int(rng.integers(3))] if first else PAPERS[int(rng.integers(3, len(PAPERS)))])


def page(rng: np.random.Generator, width: float, height: float, *, white: float = 0.8) -> Material:
    """Draw a page of text."""
    paper = leaf(rng, white=white).colour
    colours = (paper, (0.12, 0.12, 0.14), ink(rng), ink(rng))
    return Material(texture=Texture("page", colours, (width, height), int(rng.integers(12))))


def poster(rng: np.random.Generator, width: float, height: float) -> Material:
    """Draw a poster with columns, plots and pictures."""
    paper = PAPERS[int(rng.integers(3))] if rng.random() < 0.8 else ink(rng)
    colours = (paper, ink(rng), ink(rng), ink(rng))
    return Material(texture=Texture("poster", colours, (width, height), int(rng.integers(1000))))


def lying(rng: np.random.Generator, width: float = 0.21, height: float = 0.297) -> Mesh:
    """Draw a page lying on a table, readable from +y and centred on the origin."""
    return slab(width, height).of(page(rng, width, height)).moved(y=-height / 2).turned(180).moved(z=0.001)


def stack(rng: np.random.Generator, high: float, *, loose: float = 0.01) -> Mesh:
    """Draw a pile of slightly misaligned bundles of paper, centred on the origin."""
    parts = []
    z = 0.0
    bundles = max(1, min(4, round(high / 0.015)))
    for _ in range(bundles):
        thick = high / bundles
        turn = float(rng.normal(0, 4))
        shift = rng.normal(0, loose, 2)
        body = box(0.21, 0.297, thick, bevel=0).moved(y=-0.1485).of(leaf(rng, white=0.9))
        parts.append(body.turned(turn).moved(float(shift[0]), float(shift[1]), z))
        z += thick
    top = lying(rng).turned(turn).moved(float(shift[0]), float(shift[1]), z)
    return join(parts, top)


def pinned(rng: np.random.Generator, width: float, height: float, *, large: bool = False) -> Mesh:
    """Draw a sheet that hangs flat on a board or wall, with its back at y = 0 and its lower edge at z = 0."""
    material = poster(rng, width, height) if large else page(rng, width, height, white=0.65)
    return quad(width, height).of(material).moved(y=0.002)
