"""Rows of washbasins in lavatories."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.washbasin import RIM, hollow
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.fittings import tap
from placecat_homes.parts.lofts import loft, rounded
from placecat_homes.parts.toiletries import soap_dispenser
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style


def basin_row(
    rng: np.random.Generator,
    style: Style,
    *,
    count: int = 2,
    ceramic: Material | None = None,
    mirror: bool = True,
) -> Mesh:
    """Draw a row of washbasins, either set into a shared counter or mounted separately.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the building.
    count
        Number of basins.
    ceramic
        Material of the basins; chosen at random if None.
    mirror
        Whether to hang mirrors above the basins.

    Returns
    -------
    Mesh
        A row up to 2 m high.
    """
    ceramic = ceramic or palette.ceramic(rng)
    pitch, depth = rng.uniform(0.65, 0.8), rng.uniform(0.48, 0.55)
    total = count * pitch
    in_counter = rng.random() < 0.6
    top = palette.stone(rng)
    kind = str(rng.choice(("mixer", "tall", "square")))
    oval = rng.random() < 0.5
    parts = []
    for k in range(count):
        x = (k + 0.5) * pitch - total / 2
        width = pitch if in_counter else 0.52
        basin = 0.44
        rings = hollow(basin, depth - 0.19, (basin / 2, depth / 2) if oval else (0.06, 0.06), 0.13, RIM, 0.13)
        radius = 0.002 if in_counter else 0.08
        edge = rounded(width, depth, radius, 0.002)
        thick = 0.05 if in_counter else 0.16
        plate = [(edge, RIM - thick), (edge, RIM - 0.003), (edge * (0.996, 0.996), RIM), rings[0]]
        parts.append(loft(plate, bottom=False, top=False).of(top if in_counter else ceramic).moved(x))
        parts.append(loft(rings, bottom=False).of(ceramic).moved(x))
        parts.append(tap(rng, style.metal, kind).moved(x, 0.06, RIM))
        trap = [(x, 0.26, RIM - 0.14), (x, 0.26, 0.55), (x, 0.2, 0.5), (x, 0.14, 0.55), (x, 0.0, 0.55)]
        parts.append(tube(trap, 0.018, 8).of(style.metal))
        parts.append(cylinder(0.032, 0.09, 10).moved(x, 0.26, 0.56).of(style.metal))
        if not in_counter:
            parts.append(box(0.45, depth - 0.1, 0.1, bevel=0.03).moved(x, 0.0, RIM - 0.2).of(ceramic))
        if rng.random() < 0.6:
            parts.append(soap_dispenser(rng, style.metal).moved(x + basin / 2 - 0.04, 0.06, RIM))
    if in_counter:
        apron = box(total, 0.02, 0.14, bevel=0.0).moved(0, depth - 0.04, RIM - 0.19)
        parts.append(apron.of(top if rng.random() < 0.5 else style.fronts))
    if mirror:
        parts.append(_mirrors(rng, style, count, pitch, in_counter))
    if rng.random() < 0.6:
        tiles = palette.tiles(rng)
        parts.append(box(total, 0.008, 0.22, bevel=0.0).moved(z=RIM).of(tiles))
    return join(parts)


def _mirrors(rng: np.random.Generator, style: Style, count: int, pitch: float, joint: bool) -> Mesh:
    frame: Material = style.metal if rng.random() < 0.6 else style.any_wood(rng)
    height, total = rng.uniform(0.7, 0.95), count * pitch
    parts = []
    widths = (
        [(total - 0.04, 0.0)]
        if joint and rng.random() < 0.7
        else [(0.5, (k + 0.5) * pitch - total / 2) for k in range(count)]
    )
    for width, x in widths:
        parts.append(box(width + 0.03, 0.012, height + 0.03, bevel=0.002).moved(x, 0, 1.1).of(frame))
        parts.append(box(width, 0.004, height, bevel=0.0).moved(x, 0.012, 1.115).of(palette.MIRROR))
    return join(parts)
